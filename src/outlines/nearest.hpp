#pragma once
// The closest points of two segments. Everything that is decided is decided exactly: signs by
// floating point where its error bound allows (Shewchuk 1997, "Adaptive precision floating-point
// arithmetic and fast robust geometric predicates"), else by rational numbers. So an answer does
// not depend on the method that found it.

#include <compare>
#include <optional>

#include "exact/rational.hpp"
#include "outlines/outline.hpp"

namespace models {

/// The turn from a over b to c: 1 to the left, -1 to the right, 0 straight on.
[[nodiscard]] int turn(const Point& a, const Point& b, const Point& c);
/// The sign of dot(b - a, p - a): 1 where p lies on b's side of the normal through a.
[[nodiscard]] int along(const Point& a, const Point& b, const Point& p);
/// The sign of dot(b - a, d - c).
[[nodiscard]] int dot_sign(const Point& a, const Point& b, const Point& c, const Point& d);
/// Whether two closed segments have a point in common.
[[nodiscard]] bool meet(const Segment& a, const Segment& b);
/// A segment's share in the winding number of the outlines around `point`: 1 where it crosses the
/// ray to the right from there upward, -1 downward, else 0.
[[nodiscard]] int winding(const Point& point, const Segment& segment);
/// How often the closed outlines go around `point`, which lies on none of them.
[[nodiscard]] int winding(const Point& point, const Model& model);

/// A place on a segment.
enum class Spot : std::uint8_t { start, end, between };

/// The closest features of two segments. Of several one, always the same.
struct Nearest {
  Segment a;
  Segment b;
  Spot on_a = Spot::start;  ///< At least one of the two is an end, but where segments cross.
  Spot on_b = Spot::start;
  bool meet = false;
  double low = 0.0;  ///< low <= exact distance <= high
  double high = 0.0;
};
[[nodiscard]] Nearest nearest(const Segment& a, const Segment& b);
/// Compares distances exactly; equal ones by which pair of segments comes first in the models.
[[nodiscard]] std::strong_ordering operator<=>(const Nearest& p, const Nearest& q);
[[nodiscard]] inline bool operator==(const Nearest& p, const Nearest& q) { return (p <=> q) == 0; }
/// By distance alone.
[[nodiscard]] std::strong_ordering compare_distances(const Nearest& p, const Nearest& q);
[[nodiscard]] gjkscope::Rational distance_sq(const Nearest& pair);

/// A vertex or a segment of a model, by outline and index.
struct Feature {
  bool is_vertex = false;
  int outline = -1;  ///< -1: none; the point lies in matter.
  int index = -1;
  friend bool operator==(const Feature&, const Feature&) = default;
};
[[nodiscard]] Feature feature_of(const Segment& segment, Spot spot, const Model& model);

/// The answer to a query about two models.
struct Answer {
  double distance = 0.0;  ///< The exact distance, rounded to nearest; 0 exactly where they overlap.
  bool overlap = false;   ///< Boundaries meet, or one lies in the other's matter. Exact.
  Point a = Point::Zero();  ///< Closest points, rounded to nearest; of an overlap a common point.
  Point b = Point::Zero();
  Feature on_a;
  Feature on_b;
};
[[nodiscard]] Answer answer_of(const Nearest& pair, const Model& a, const Model& b);

namespace detail {

/// A vertex of `inner` that `around` says lies in the other model's matter.
template <class Around>
[[nodiscard]] std::optional<Answer> inside(const Model& inner, const Around& around) {
  for (std::size_t i = 0; i < inner.outlines.size(); ++i) {
    const Point& p = inner.outlines[i].points.front();
    if (around(p) != 0) return Answer{0.0, true, p, p, {true, static_cast<int>(i), 0}, {}};
  }
  return std::nullopt;
}

}  // namespace detail

/// For models whose boundaries do not meet: a vertex of one that lies in the other's matter.
/// `around_a` and `around_b` give the winding numbers of the models around a point.
template <class AroundA, class AroundB>
[[nodiscard]] std::optional<Answer> contained(const Model& a, const Model& b,
                                              const AroundA& around_a, const AroundB& around_b) {
  if (auto answer = detail::inside(a, around_b)) return answer;
  auto answer = detail::inside(b, around_a);
  if (answer) std::swap(answer->on_a, answer->on_b);
  return answer;
}

}  // namespace models
