#include "session/hit.hpp"

#include <algorithm>
#include <cmath>

#include "outlines/polygon.hpp"
#include "picture/text_box.hpp"

namespace gjkscope {
namespace {

using Kind = Subject::Kind;

/// The score of a mark that is not hit; lower scores are better.
constexpr double kMiss = HUGE_VAL;
constexpr double kLine = 1e3;
constexpr double kArea = 1e6;

struct Aim {
  const Fonts& fonts;
  Point p;
  double slack;

  double operator()(const Disk& disk) const {
    const double off = (p - disk.center).norm();
    return off <= disk.radius + slack ? off : kMiss;
  }
  double operator()(const Text& text) const {
    return is_in(box_of(fonts, text), p, 5.0) ? kLine : kMiss;
  }
  double operator()(const Box& box) const { return is_in(box.rect, p, 3.0) ? kLine : kMiss; }
  double operator()(const Polyline& line) const {
    double nearest = kMiss;
    for (std::size_t i = 1; i < line.points.size(); ++i)
      nearest = std::min(nearest, segment_distance(p, line.points[i - 1], line.points[i]));
    if (line.closed && line.points.size() > 2) {
      nearest = std::min(nearest, segment_distance(p, line.points.back(), line.points.front()));
      // An outline that is not convex has no fill, but an inside.
      if (is_inside(line.points, p)) return kArea;
    }
    return nearest <= slack ? kLine + nearest : kMiss;
  }
  double operator()(const Polygon& polygon) const {
    // A small one marks a point.
    constexpr double kPoint = 12.0;
    Point middle = Point::Zero();
    for (const Point& corner : polygon.points)
      middle += corner / static_cast<double>(polygon.points.size());
    const auto is_near = [&](const Point& corner) { return (corner - middle).norm() <= kPoint; };
    if (std::all_of(polygon.points.begin(), polygon.points.end(), is_near))
      return operator()(Disk{middle, kPoint});
    return is_inside(polygon.points, p) ? kArea : kMiss;
  }
  double operator()(const Arrow&) const { return kMiss; }
  double operator()(const Cross& cross) const {
    return operator()(Disk{cross.center, cross.radius});
  }
};

}  // namespace

bool is_in(const Rect& rect, const Point& p, double slack) {
  return (p.array() >= rect.min.array() - slack).all() &&
         (p.array() <= rect.max.array() + slack).all();
}

Subject subject_at(const Picture& picture, const Fonts& fonts, const Point& p, double slack) {
  Subject best;
  double best_score = kMiss;
  int view = static_cast<int>(picture.clips.size()) - 1;  // the topmost under p
  while (view >= 0 && !is_in(picture.clips[view], p)) --view;
  for (const Mark& mark : picture.marks) {
    if (mark.subject.kind == Kind::none) continue;
    if (mark.clip >= 0 && mark.clip != view) continue;
    const double score = std::visit(Aim{fonts, p, slack}, mark.shape);
    if (score < kMiss && score <= best_score) {
      best_score = score;
      best = mark.subject;
    }
  }
  return best;
}

gjk::Face face_at(const std::vector<Eigen::Vector2d>& simplex, const VoronoiRegions::Value& regions,
                  const Eigen::Vector2d& p, double reach) {
  const int count = static_cast<int>(simplex.size());
  const auto vertex = [&](int i) { return simplex[i]; };
  const auto nearest = std::min_element(
      simplex.begin(), simplex.end(),
      [&](const auto& a, const auto& b) { return (p - a).norm() < (p - b).norm(); });
  if ((p - *nearest).norm() <= reach)
    return gjk::face_of(static_cast<int>(nearest - simplex.begin()));
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      if (segment_distance(p, vertex(i), vertex(j)) <= reach)
        return static_cast<gjk::Face>(gjk::face_of(i) | gjk::face_of(j));
    }
  }
  const auto around =
      std::find_if(regions.begin(), regions.end(), [&](const VoronoiRegions::Region& region) {
        return std::all_of(
            region.half_planes.begin(), region.half_planes.end(),
            [&](const HalfPlane& half) { return half.normal.dot(p - half.point) <= 0.0; });
      });
  return around == regions.end() ? gjk::Face{0} : around->face;
}

namespace {

bool overlaps(const Rect& rect, const std::vector<Point>& points, bool closed) {
  if (closed && is_inside(points, rect.center())) return true;
  if (points.size() == 1) return is_in(rect, points.front());
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    if (clip(points[i == 0 ? points.size() - 1 : i - 1], points[i], {rect.min, rect.max}))
      return true;
  }
  return false;
}

bool is_of_shapes(const Subject& subject) {
  return is_vertex(subject) || is_shape(subject) || is_of_difference(subject);
}

}  // namespace

bool is_in_sight(const Picture& picture, const Rect& card) {
  // Marks of this card, not what the panel says of the same subjects.
  const auto is_of_card = [&](const Mark& mark) {
    return is_of_shapes(mark.subject) && mark.clip >= 0 &&
           !std::holds_alternative<Text>(mark.shape) && overlap(picture.clips[mark.clip], card);
  };
  bool has_any = false;
  for (const Mark& mark : picture.marks) {
    if (!is_of_card(mark)) continue;
    has_any = true;
    const Disk* const disk = std::get_if<Disk>(&mark.shape);
    const Cross* const cross = std::get_if<Cross>(&mark.shape);
    const Polygon* const polygon = std::get_if<Polygon>(&mark.shape);
    const Polyline* const line = std::get_if<Polyline>(&mark.shape);
    if ((disk && is_in(card, disk->center)) || (cross && is_in(card, cross->center)) ||
        (polygon && overlaps(card, polygon->points, true)) ||
        (line && overlaps(card, line->points, line->closed)))
      return true;
  }
  return !has_any;
}

Subject held(const Subject& subject) {
  if (subject.kind != Kind::tree_node) return subject;
  return {subject.x >= 0 ? Kind::shape_x : Kind::shape_y};
}

bool is_linked(const Subject& a, const Subject& b) {
  if (a == b) return a.kind != Kind::none;
  const auto made_of = [](const Subject& pair, const Subject& vertex) {
    if (pair.kind != Kind::difference_vertex) return false;
    return (vertex.kind == Kind::vertex_of_x && vertex.x == pair.x) ||
           (vertex.kind == Kind::vertex_of_y && vertex.y == pair.y);
  };
  return made_of(a, b) || made_of(b, a);
}

}  // namespace gjkscope
