#include "oracle.hpp"

namespace gjkscope {
namespace {

Rational cross(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[1] - a[1] * b[0]; }

bool is_zero(const RationalPoint& a) { return a[0] == 0 && a[1] == 0; }

/// Where O stands to the hull of `z`. Outside: all points lie within less than half a turn
/// counter-clockwise of one of them. On the boundary: some line through O and a point has all of
/// them on one side.
struct Standing {
  bool outside = false;
  bool boundary = false;
};
Standing standing_of_origin(const std::vector<RationalPoint>& z) {
  Standing out;
  bool any_away = false;
  for (const RationalPoint& a : z) {
    if (is_zero(a)) continue;
    any_away = true;
    bool all_ahead = true;
    bool all_left = true;
    for (const RationalPoint& b : z) {
      const int side = sgn(cross(a, b));
      if (side < 0) all_left = false;
      if (side < 0 || (side == 0 && gjk::dot(a, b) <= 0)) all_ahead = false;
      if (!all_left) break;
    }
    out.outside = out.outside || all_ahead;
    out.boundary = out.boundary || all_left;
  }
  if (!any_away) out.boundary = true;
  return out;
}

/// Nearest pair of a point and the segments of the other set, kept while it is the nearest so far.
struct Nearest {
  ExactAnswer answer;
  bool any = false;

  void offer(const RationalPoint& x, const RationalPoint& y) {
    const RationalPoint difference = y - x;
    const Rational distance_sq = gjk::dot(difference, difference);
    if (any && answer.distance_sq <= distance_sq) return;
    any = true;
    answer.distance_sq = distance_sq;
    answer.x = x;
    answer.y = y;
  }
};

/// The foot of `q` on the segment ab, if it lies between the ends.
bool foot(const RationalPoint& q, const RationalPoint& a, const RationalPoint& b,
          RationalPoint& out) {
  const RationalPoint edge = b - a;
  const RationalPoint from_a = q - a;
  const Rational along = gjk::dot(from_a, edge);
  const Rational length_sq = gjk::dot(edge, edge);
  if (along <= 0 || along >= length_sq) return false;
  const Rational t = along / length_sq;
  out = a + edge * t;
  return true;
}

}  // namespace

RationalPoint rational(double x, double y) { return {Rational(x), Rational(y)}; }

ExactAnswer exact_answer(std::span<const RationalPoint> x, std::span<const RationalPoint> y) {
  std::vector<RationalPoint> z;
  for (const RationalPoint& a : x) {
    for (const RationalPoint& b : y) z.push_back(b - a);
  }
  const Standing standing = standing_of_origin(z);
  Nearest nearest;
  if (!standing.outside) {
    nearest.answer.overlap = true;
    nearest.answer.touching = standing.boundary;
    return nearest.answer;
  }
  // Disjoint hulls have a nearest pair of vertex and vertex, or vertex and edge; edges of the hulls
  // are among the segments of all pairs of points.
  RationalPoint at;
  for (const RationalPoint& a : x) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      nearest.offer(a, y[j]);
      for (std::size_t k = 0; k < j; ++k) {
        if (foot(a, y[k], y[j], at)) nearest.offer(a, at);
      }
    }
  }
  for (const RationalPoint& b : y) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        if (foot(b, x[k], x[j], at)) nearest.offer(at, b);
      }
    }
  }
  return nearest.answer;
}

bool is_nearest_pair(std::span<const RationalPoint> x, std::span<const RationalPoint> y,
                     const RationalPoint& at_x, const RationalPoint& at_y) {
  const RationalPoint normal = at_y - at_x;
  const Rational reach_x = gjk::dot(normal, at_x);
  const Rational reach_y = gjk::dot(normal, at_y);
  for (const RationalPoint& a : x) {
    if (gjk::dot(normal, a) > reach_x) return false;
  }
  for (const RationalPoint& b : y) {
    if (gjk::dot(normal, b) < reach_y) return false;
  }
  return true;
}

}  // namespace gjkscope
