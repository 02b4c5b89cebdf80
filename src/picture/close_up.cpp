#include "picture/close_up.hpp"

#include "outlines/polygon.hpp"

namespace gjkscope {
namespace {

using Shape = decltype(Mark::shape);

constexpr double kMargin = 24.0;  // hides where lines are cut off

/// The part of a mark's shape in a box: none, or several where a line leaves and comes back.
struct Cut {
  Eigen::AlignedBox2d box;

  std::vector<Shape> operator()(const Polyline& line) const {
    std::vector<Point> points = line.points;
    if (line.closed) points.push_back(points.front());
    std::vector<Polyline> parts;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto part = clip(points[i - 1], points[i], box);
      if (!part) continue;
      if (parts.empty() || parts.back().points.back() != (*part)[0])
        parts.push_back({{(*part)[0]}});
      parts.back().points.push_back((*part)[1]);
    }
    return {parts.begin(), parts.end()};
  }
  std::vector<Shape> operator()(const Polygon& polygon) const {
    std::vector<Point> rest = clip_to_box(polygon.points, box);
    if (rest.size() < 3) return {};
    return {Polygon{std::move(rest)}};
  }
  std::vector<Shape> operator()(const Arrow& arrow) const {
    const auto part = clip(arrow.from, arrow.to, box);
    if (!part) return {};
    if (box.contains(arrow.to)) return {Arrow{(*part)[0], arrow.to}};
    return {Polyline{{(*part)[0], (*part)[1]}}};
  }
  std::vector<Shape> operator()(const Disk& disk) const { return of(disk, disk.center); }
  std::vector<Shape> operator()(const Cross& cross) const { return of(cross, cross.center); }
  std::vector<Shape> operator()(const Box& rect) const { return of(rect, rect.rect.center()); }
  std::vector<Shape> operator()(const Text& text) const { return of(text, text.at); }
  std::vector<Shape> of(const Shape& shape, const Point& at) const {
    if (!box.contains(at)) return {};
    return {shape};
  }
};

}  // namespace

Rect close_up_in(const Rect& card, CardCorner corner) {
  constexpr double kShare = 0.43;  // of the card's sides
  constexpr double kInside = 10.0;
  constexpr double kTitle = 44.0;  // above which a view has its title
  const Point size = kShare * card.size();
  const bool right = corner == CardCorner::top_right || corner == CardCorner::bottom_right;
  const bool low = corner == CardCorner::bottom_left || corner == CardCorner::bottom_right;
  const Point at(right ? card.max.x() - kInside - size.x() : card.min.x() + kInside,
                 low ? card.max.y() - kInside - size.y() : card.min.y() + kTitle);
  return {at, at + size};
}

std::vector<Mark> cut(const std::vector<Mark>& marks, const Rect& card) {
  const Cut to{{card.min - Point(kMargin, kMargin), card.max + Point(kMargin, kMargin)}};
  std::vector<Mark> out;
  for (const Mark& mark : marks) {
    for (Shape& shape : std::visit(to, mark.shape)) {
      out.push_back(mark);
      out.back().shape = std::move(shape);
      out.back().subject = {};
    }
  }
  return out;
}

}  // namespace gjkscope
