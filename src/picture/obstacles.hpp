#pragma once
// Marks that labels must not cover, in a grid: a label asks about those near it alone.

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "picture/picture.hpp"

namespace gjkscope {

/// Marks that labels must not cover.
struct Obstacles {
  struct Segment {
    Point a;
    Point b;
    [[nodiscard]] Rect box() const { return {a.cwiseMin(b), a.cwiseMax(b)}; }
    friend bool operator==(const Segment&, const Segment&) = default;
  };
  struct Circle {
    Point center;
    double radius = 0.0;
    [[nodiscard]] Rect box() const {
      return {center - Point::Constant(radius), center + Point::Constant(radius)};
    }
    friend bool operator==(const Circle&, const Circle&) = default;
  };
  std::vector<Segment> segments;
  /// Lines that cross the whole view for a while. Labels avoid them, but not by moving far away
  /// from what they name.
  std::vector<Segment> passing;
  std::vector<Circle> circles;
  /// Areas whose marks are too small and too many to keep off: labels stand on them, with a halo.
  std::vector<Rect> grounds;
};

/// Obstacles of one kind, by cells of a grid. Equal ones are one, and counted: the same outlines
/// stand in all frames of a lesson.
template <class Shape>
class Field {
 public:
  struct Item {
    Shape shape;
    int count = 0;
  };

  /// Cells lie within `bounds`; what is outside is in those at the border.
  explicit Field(const Rect& bounds)
      : bounds_(bounds),
        columns_(cells_along(bounds.size().x())),
        rows_(cells_along(bounds.size().y())),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  void clear() {
    items_.clear();
    known_.clear();
    last_batch_.clear();
    for (std::vector<int>& cell : cells_) cell.clear();
  }

  void add(std::span<const Shape> shapes) {
    // Most frames have what the one before had, in the same order.
    std::vector<int> batch;
    batch.reserve(shapes.size());
    for (const Shape& shape : shapes) {
      const std::size_t i = batch.size();
      const bool is_known = i < last_batch_.size() && item(last_batch_[i]).shape == shape;
      batch.push_back(is_known ? last_batch_[i] : index_of(shape));
      ++item(batch.back()).count;
    }
    last_batch_ = std::move(batch);
  }

  void add(const Shape& shape) { ++item(index_of(shape)).count; }

  /// True if `meets` is true for one of the obstacles in the cells of the box.
  template <class Meets>
  [[nodiscard]] bool any_near(const Rect& box, const Meets& meets) const {
    // As many marks as items, so that each item is asked once, whatever cells it is in.
    asked_.resize(items_.size(), 0);
    ++round_;
    for (int row = row_of(box.min.y()); row <= row_of(box.max.y()); ++row) {
      for (int column = column_of(box.min.x()); column <= column_of(box.max.x()); ++column) {
        for (const int index : cell(row, column)) {
          const auto i = static_cast<std::size_t>(index);
          if (std::exchange(asked_[i], round_) != round_ && meets(items_[i])) return true;
        }
      }
    }
    return false;
  }

 private:
  static constexpr double kCell = 32.0;  // pixels, about the size of a label

  struct Hash {
    std::size_t operator()(const Obstacles::Circle& circle) const {
      return of({circle.center.x(), circle.center.y(), circle.radius});
    }
    std::size_t operator()(const Obstacles::Segment& segment) const {
      return of({segment.a.x(), segment.a.y(), segment.b.x(), segment.b.y()});
    }
    static std::size_t of(std::initializer_list<double> values) {
      std::size_t hash = 0;
      for (const double value : values)
        hash = 31 * (hash ^ (hash >> 29)) + std::hash<double>{}(value);
      return hash;
    }
  };

  [[nodiscard]] Item& item(int index) { return items_[index]; }
  /// The index of a shape, which is added if it is new.
  [[nodiscard]] int index_of(const Shape& shape) {
    const auto [known, is_new] = known_.try_emplace(shape, static_cast<int>(items_.size()));
    if (!is_new) return known->second;
    items_.push_back({shape, 0});
    const Rect box = shape.box();
    for (int row = row_of(box.min.y()); row <= row_of(box.max.y()); ++row) {
      const auto [left, right] = reach(shape, row);
      for (int column = column_of(left); column <= column_of(right); ++column)
        cell(row, column).push_back(known->second);
    }
    return known->second;
  }

  static int cells_along(double length) {
    return std::max(1, static_cast<int>(std::ceil(length / kCell)));
  }
  static int cell_along(double place, int count) {
    // In this order what is no number counts as beyond the last.
    return static_cast<int>(std::max(0.0, std::min(count - 1.0, std::floor(place / kCell))));
  }
  [[nodiscard]] int row_of(double y) const { return cell_along(y - bounds_.min.y(), rows_); }
  [[nodiscard]] int column_of(double x) const { return cell_along(x - bounds_.min.x(), columns_); }
  [[nodiscard]] std::vector<int>& cell(int row, int column) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }
  [[nodiscard]] const std::vector<int>& cell(int row, int column) const {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  /// From where to where it may be found in a row.
  [[nodiscard]] std::pair<double, double> reach(const Obstacles::Circle& circle, int) const {
    return {circle.box().min.x(), circle.box().max.x()};
  }
  [[nodiscard]] std::pair<double, double> reach(const Obstacles::Segment& segment, int row) const {
    const Rect box = segment.box();
    const double height = segment.b.y() - segment.a.y();
    if (std::abs(height) < 1.0) return {box.min.x(), box.max.x()};
    const auto at = [&](double y) {
      const double part = std::clamp((y - segment.a.y()) / height, 0.0, 1.0);
      return segment.a.x() + part * (segment.b.x() - segment.a.x());
    };
    const double top = bounds_.min.y() + kCell * row;
    const double enters = at(row == 0 ? box.min.y() : top);
    const double leaves = at(row == rows_ - 1 ? box.max.y() : top + kCell);
    constexpr double kRoundoff = 1e-3;  // pixels: more than it is, far less than a cell
    return {std::min(enters, leaves) - kRoundoff, std::max(enters, leaves) + kRoundoff};
  }

  Rect bounds_;
  int columns_;
  int rows_;
  std::vector<std::vector<int>> cells_;
  std::vector<Item> items_;
  std::unordered_map<Shape, int, Hash> known_;
  std::vector<int> last_batch_;
  mutable std::vector<int> asked_;
  mutable int round_ = 0;
};

}  // namespace gjkscope
