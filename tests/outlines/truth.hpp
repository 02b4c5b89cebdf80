#pragma once
// The truth about two models, by other means than src/outlines: all pairs of segments in GMP's
// rational numbers, and an even simpler point in polygon.

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "outlines/nearest.hpp"

namespace test {

using models::Model;
using models::Point;
using models::Segment;

struct ExactPoint {
  mpq_class x;
  mpq_class y;
  explicit ExactPoint(const Point& p) : x(p.x()), y(p.y()) {}
  ExactPoint(mpq_class to_x, mpq_class to_y) : x(std::move(to_x)), y(std::move(to_y)) {}
  friend ExactPoint operator-(const ExactPoint& a, const ExactPoint& b) {
    return {mpq_class(a.x - b.x), mpq_class(a.y - b.y)};
  }
};
inline mpq_class cross(const ExactPoint& a, const ExactPoint& b) { return a.x * b.y - a.y * b.x; }
inline mpq_class dot(const ExactPoint& a, const ExactPoint& b) { return a.x * b.x + a.y * b.y; }

/// Squared distance of a point from a segment: at the parameter of its foot, kept within 0 and 1.
inline mpq_class distance_sq(const Point& point, const Segment& s) {
  const ExactPoint difference = ExactPoint(s.b) - ExactPoint(s.a);
  const ExactPoint to = ExactPoint(point) - ExactPoint(s.a);
  const mpq_class length = dot(difference, difference);
  mpq_class t = length == 0 ? mpq_class(0) : mpq_class(dot(to, difference) / length);
  t = std::min(std::max(t, mpq_class(0)), mpq_class(1));
  const ExactPoint gap = {mpq_class(to.x - t * difference.x), mpq_class(to.y - t * difference.y)};
  return dot(gap, gap);
}

/// Segments that cross do so with both ends of each on different sides of the other.
inline bool cross_each_other(const Segment& s, const Segment& t) {
  const auto side = [](const Segment& of, const Point& p) {
    return sgn(cross(ExactPoint(of.b) - ExactPoint(of.a), ExactPoint(p) - ExactPoint(of.a)));
  };
  return side(s, t.a) * side(s, t.b) < 0 && side(t, s.a) * side(t, s.b) < 0;
}

inline mpq_class distance_sq(const Segment& s, const Segment& t) {
  if (cross_each_other(s, t)) return 0;
  return std::min(
      {distance_sq(s.a, t), distance_sq(s.b, t), distance_sq(t.a, s), distance_sq(t.b, s)});
}

/// A distance of two segments, somewhat rounded.
inline double rounded_distance(const Segment& s, const Segment& t) {
  const auto from = [](const Point& p, const Segment& of) {
    const Point difference = of.b - of.a;
    const double length = difference.squaredNorm();
    const double share =
        length > 0.0 ? std::clamp((p - of.a).dot(difference) / length, 0.0, 1.0) : 0.0;
    return (p - of.a - share * difference).norm();
  };
  const auto side = [](const Segment& of, const Point& p) {
    const Point difference = of.b - of.a;
    const Point to = p - of.a;
    return difference.x() * to.y() - difference.y() * to.x();
  };
  if (side(s, t.a) * side(s, t.b) < 0.0 && side(t, s.a) * side(t, s.b) < 0.0) return 0.0;
  return std::min(std::min(from(s.a, t), from(s.b, t)), std::min(from(t.a, s), from(t.b, s)));
}

/// How often closed outlines wind around p, by crossings of the ray to the right, exactly.
inline int exact_winding(const Point& p, const Model& model) {
  int around = 0;
  for (const Segment& s : model.segments) {
    if (!model.outlines[static_cast<std::size_t>(s.outline)].closed) continue;
    if ((s.a.y() > p.y()) == (s.b.y() > p.y())) continue;
    const ExactPoint a(s.a);
    const ExactPoint b(s.b);
    const mpq_class share = (mpq_class(p.y()) - a.y) / (b.y - a.y);
    const mpq_class at = a.x + share * (b.x - a.x);
    if (at > mpq_class(p.x())) around += s.b.y() > s.a.y() ? 1 : -1;
  }
  return around;
}

struct Truth {
  bool overlap = false;
  mpq_class distance_sq;
  double scale = 0.0;  ///< The largest coordinate.
};

inline Truth truth_of(const Model& a, const Model& b) {
  Truth truth;
  for (const Model* model : {&a, &b}) {
    for (const Segment& s : model->segments) {
      truth.scale = std::max({truth.scale, s.a.cwiseAbs().maxCoeff(), s.b.cwiseAbs().maxCoeff()});
    }
  }
  // Rounding keeps no pair from being looked at exactly that could be the closest.
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : a.segments) {
    for (const Segment& t : b.segments) least = std::min(least, rounded_distance(s, t));
  }
  bool found = false;
  for (const Segment& s : a.segments) {
    for (const Segment& t : b.segments) {
      if (rounded_distance(s, t) > least + 1e-6 * truth.scale * 1e-6 + 1e-9 * least) continue;
      const mpq_class square = distance_sq(s, t);
      if (!found || square < truth.distance_sq) truth.distance_sq = square;
      found = true;
      if (truth.distance_sq == 0) break;
    }
    if (found && truth.distance_sq == 0) break;
  }
  truth.overlap = truth.distance_sq == 0;
  if (truth.overlap) return truth;
  for (const auto& [inner, outer] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const models::Outline& outline : inner->outlines) {
      truth.overlap = truth.overlap || exact_winding(outline.points.front(), *outer) != 0;
    }
  }
  if (truth.overlap) truth.distance_sq = 0;
  return truth;
}

}  // namespace test
