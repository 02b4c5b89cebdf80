#pragma once
// A tree of bounding volumes over the segments of a model (Larsen 1998, "Hierarchical Collision
// Detection"): each node has a volume that bounds its share of the segments, its two children each
// bound half of that share, a leaf has one. Bounds include what rounding can do.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "outlines/outline.hpp"

namespace models {

/// The content of a leaf: all points within `radius` of the segment from a to b, which is a segment
/// of the model or a part of one.
struct Item {
  Point a;
  Point b;
  double radius = 0.0;
  int segment = 0;  ///< Counts within Model::segments.
};
/// One for each segment.
[[nodiscard]] inline std::vector<Item> items_of(const Model& model) {
  std::vector<Item> items;
  items.reserve(model.segments.size());
  for (const Segment& s : model.segments) {
    items.push_back({s.a, s.b, 0.0, static_cast<int>(items.size())});
  }
  return items;
}

namespace detail {

inline constexpr double kRoundoff = 0x1p-53;
/// The square of a smaller length loses digits. It counts as this, or as nothing: whichever is
/// safe.
inline constexpr double kLeast = 0x1p-450;

[[nodiscard]] inline double length_above(const Point& difference) {
  return std::max(kLeast, difference.norm() * (1.0 + 4.0 * kRoundoff));
}
[[nodiscard]] inline double length_below(const Point& difference) {
  const double length = difference.norm();
  return length < kLeast ? 0.0 : length * (1.0 - 4.0 * kRoundoff);
}

}  // namespace detail

/// With sides along the axes.
struct Box {
  Point low = Point::Zero();
  Point high = Point::Zero();
  /// For choosing which of two to take apart.
  [[nodiscard]] double size() const { return (high - low).sum(); }
};
[[nodiscard]] inline Box box_around(const Item& item) {
  assert(item.radius == 0.0);
  return {item.a.cwiseMin(item.b), item.a.cwiseMax(item.b)};
}
[[nodiscard]] inline Box box_around(const Box& a, const Box& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}
/// Not more than the distance of the volumes; 0 where they meet.
[[nodiscard]] inline double distance_below(const Box& a, const Box& b) {
  return detail::length_below((a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Point::Zero()));
}

struct Circle {
  Point center = Point::Zero();
  double radius = 0.0;
  [[nodiscard]] double size() const { return radius; }
};
/// Around the middle of the items' box.
[[nodiscard]] inline Circle circle_around(std::span<const Item> items) {
  Box box = {items[0].a, items[0].a};
  for (const Item& item : items) box = box_around(box, box_around({item.a, item.b}));
  Circle circle = {0.5 * box.low + 0.5 * box.high};
  for (const Item& item : items) {
    const double reach = std::max(detail::length_above(item.a - circle.center),
                                  detail::length_above(item.b - circle.center));
    circle.radius = std::max(circle.radius, (reach + item.radius) * (1.0 + detail::kRoundoff));
  }
  return circle;
}
[[nodiscard]] inline double distance_below(const Circle& a, const Circle& b) {
  const double between = detail::length_below(a.center - b.center);
  const double radii = (a.radius + b.radius) * (1.0 + 2.0 * detail::kRoundoff);
  return std::max(0.0, (between - radii) * (1.0 - 2.0 * detail::kRoundoff));
}

template <class Volume>
struct Node {
  Volume volume;
  int parent = -1;
  int left = -1;  ///< -1 in a leaf, and so is `right`.
  int right = -1;
  int first = 0;  ///< Its share: Hierarchy::items [first, first + count).
  int count = 0;
  [[nodiscard]] bool is_leaf() const { return left < 0; }
};

template <class Volume>
struct Hierarchy {
  std::vector<Node<Volume>> nodes;  ///< The root first, each node before its children.
  std::vector<Item> items;
};

namespace detail {

/// The middle of an item, and which item.
struct Middle {
  Point at;
  int item = 0;
};

/// Halves along the axis in which the middles lie farther apart; of equal ones the item decides, so
/// that every library gives the same halves.
inline void halve(std::span<Middle> middles) {
  Box box = {middles[0].at, middles[0].at};
  for (const Middle& m : middles) box = box_around(box, {m.at, m.at});
  const Point sides = box.high - box.low;
  const int axis = sides.y() > sides.x() ? 1 : 0;
  std::nth_element(middles.begin(),
                   middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2), middles.end(),
                   [axis](const Middle& a, const Middle& b) {
                     return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.item < b.item;
                   });
}

template <class Volume>
class Builder {
 public:
  explicit Builder(std::vector<Item> items) : items_(std::move(items)) {
    middles_.reserve(items_.size());
    for (const Item& item : items_) {
      middles_.push_back({0.5 * item.a + 0.5 * item.b, static_cast<int>(middles_.size())});
    }
    tree_.items.resize(items_.size());
    tree_.nodes.reserve(2 * items_.size() - 1);
  }
  Hierarchy<Volume> build() {
    grow(-1, 0, static_cast<int>(items_.size()));
    return std::move(tree_);
  }

 private:
  int grow(int parent, int first, int count) {
    const int index = static_cast<int>(tree_.nodes.size());
    tree_.nodes.push_back({{}, parent, -1, -1, first, count});
    if (count == 1) {
      tree_.items[first] = items_[middles_[first].item];
    } else {
      halve(std::span(middles_).subspan(first, count));
      const int left = grow(index, first, count / 2);
      const int right = grow(index, first + count / 2, count - count / 2);
      tree_.nodes[index].left = left;
      tree_.nodes[index].right = right;
    }
    tree_.nodes[index].volume = volume_of(tree_.nodes[index]);
    return index;
  }
  /// Needs the node's items in their final places.
  [[nodiscard]] Volume volume_of(const Node<Volume>& node) const {
    if constexpr (std::is_same_v<Volume, Box>) {
      return node.is_leaf()
                 ? box_around(tree_.items[node.first])
                 : box_around(tree_.nodes[node.left].volume, tree_.nodes[node.right].volume);
    } else {
      return circle_around(std::span(tree_.items).subspan(node.first, node.count));
    }
  }

  std::vector<Item> items_;
  std::vector<Middle> middles_;
  Hierarchy<Volume> tree_;
};

/// Whether the ray to the right from a point may meet a volume.
[[nodiscard]] inline bool ray_meets(const Point& from, const Box& box) {
  return from.x() <= box.high.x() && box.low.y() <= from.y() && from.y() <= box.high.y();
}
[[nodiscard]] inline bool ray_meets(const Point& from, const Circle& circle) {
  const Point difference = (1.0 - 4.0 * kRoundoff) * (from - circle.center);
  return difference.x() <= circle.radius && std::abs(difference.y()) <= circle.radius;
}

}  // namespace detail

/// Needs at least one item. O(n log n).
template <class Volume>
[[nodiscard]] Hierarchy<Volume> build_hierarchy(std::vector<Item> items) {
  return detail::Builder<Volume>(std::move(items)).build();
}

}  // namespace models
