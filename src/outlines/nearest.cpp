#include "outlines/nearest.hpp"

#include <algorithm>
#include <cmath>

#include "gjk/proof/error_free.hpp"
#include "gjk/proof/measures.hpp"
#include "gjk/vector.hpp"

namespace models {
namespace {

using gjkscope::Rational;
using Exact = gjk::Vec<Rational, 2>;

constexpr double kRoundoff = 0x1p-53;

Exact exact(const Point& p) { return gjk::converted<Rational>(p); }
Exact exact_difference(const Point& from, const Point& to) { return exact(to) - exact(from); }

/// Squares and products of such numbers keep their digits.
bool is_safe(double size) { return 0x1p-900 < size && size < 0x1p+900; }

/// A difference of two coordinates.
struct Difference {
  double to;
  double from;
  [[nodiscard]] double value() const { return to - from; }
  /// Nothing was rounded, and a product of two has room.
  [[nodiscard]] bool is_exact() const {
    const double size = std::abs(value());
    return gjk::exact_sum(to, -from).lo == 0.0 &&
           (size == 0.0 || (0x1p-400 < size && size < 0x1p+400));
  }
};

int sign_of(double value) { return (value > 0.0) - (value < 0.0); }

/// The sign of p q + `sign` * r s. The rounded sum is off by at most (3 + 16 u) u (|pq| + |rs|)
/// (Shewchuk 1997, ccwerrboundA).
template <class Settle>
int sign_of_products(const Difference& p, const Difference& q, int sign, const Difference& r,
                     const Difference& s, const Settle& settle) {
  const double first = p.value() * q.value();
  const double second = sign * (r.value() * s.value());
  const double sum = first + second;
  const double size = std::abs(first) + std::abs(second);
  const double error = (3.0 + 16.0 * kRoundoff) * kRoundoff * size;
  if (is_safe(size) && std::abs(sum) > error) [[likely]]
    return sign_of(sum);
  if (p.is_exact() && q.is_exact() && r.is_exact() && s.is_exact()) {
    const auto left = gjk::exact_product(p.value(), q.value());
    const auto right = gjk::exact_product(-sign * r.value(), s.value());
    return left.hi != right.hi ? sign_of(left.hi - right.hi) : sign_of(left.lo - right.lo);
  }
  return settle().sign();
}

struct Bounds {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
};

/// Bounds of the distance of two points. Differences and squares are right to a unit roundoff each.
Bounds point_bounds(const Point& p, const Point& q) {
  const double square = (p - q).squaredNorm();
  if (!is_safe(square)) return {};
  const double length = std::sqrt(square);
  return {length * (1.0 - 4.0 * kRoundoff), length * (1.0 + 4.0 * kRoundoff)};
}

/// Bounds of a point's distance from the line through two others: |cross(b - a, p - a)| / |b - a|.
Bounds line_bounds(const Point& p, const Segment& s) {
  const Point difference = s.b - s.a;
  const Point to = p - s.a;
  const double first = difference.x() * to.y();
  const double second = difference.y() * to.x();
  const double size = std::abs(first) + std::abs(second);
  const double square = difference.squaredNorm();
  if (!is_safe(size) || !is_safe(square)) return {};
  const double area = std::abs(first - second);
  const double error = 4.0 * kRoundoff * size;
  const double length = std::sqrt(square);
  return {std::max(0.0, area - error) / length * (1.0 - 8.0 * kRoundoff),
          (area + error) / length * (1.0 + 8.0 * kRoundoff)};
}

Spot nearest_spot(const Point& p, const Segment& s) {
  if (along(s.a, s.b, p) <= 0) return Spot::start;
  if (along(s.b, s.a, p) <= 0) return Spot::end;
  return Spot::between;
}

const Point& end_of(const Segment& s, Spot spot) { return spot == Spot::end ? s.b : s.a; }

Bounds bounds_of(const Point& p, const Segment& s, Spot spot) {
  return spot == Spot::between ? line_bounds(p, s) : point_bounds(p, end_of(s, spot));
}

/// The ends of a distance: p and the point q, or p and the line from q to r.
struct Measured {
  Point p;
  Point q;
  Point r;  ///< q for a point.
  friend bool operator==(const Measured& a, const Measured& b) = default;
};

Measured measured(const Nearest& pair) {
  const bool from_a = pair.on_a != Spot::between;
  const Point& p = from_a ? end_of(pair.a, pair.on_a) : end_of(pair.b, pair.on_b);
  const Segment& s = from_a ? pair.b : pair.a;
  const Spot spot = from_a ? pair.on_b : pair.on_a;
  if (spot == Spot::between) return {p, s.a, s.b};
  return {p, end_of(s, spot), end_of(s, spot)};
}

/// A squared distance as a fraction that is not reduced.
struct Square {
  Rational top;
  Rational bottom = 1;
};

Square square_of(const Measured& m) {
  const Exact difference = exact_difference(m.q, m.r);
  const Exact to = exact_difference(m.q, m.p);
  if (m.q == m.r) return {gjk::dot(to, to)};
  const Rational area = gjk::cross(difference, to);
  return {area * area, gjk::dot(difference, difference)};
}

bool in_box(const Point& p, const Segment& s) {
  return (p.array() >= s.a.cwiseMin(s.b).array()).all() &&
         (p.array() <= s.a.cwiseMax(s.b).array()).all();
}

bool lies_on(const Point& p, const Segment& s) { return in_box(p, s) && turn(s.a, s.b, p) == 0; }

/// Sets the common point of two segments that meet: an end of one of them if it is common.
void set_meeting_spots(Nearest& pair) {
  const auto spot_on = [](const Point& p, const Segment& s) {
    return p == s.a ? Spot::start : p == s.b ? Spot::end : Spot::between;
  };
  pair.meet = true;
  pair.low = pair.high = 0.0;
  pair.on_a = pair.on_b = Spot::between;
  for (const Spot spot : {Spot::start, Spot::end}) {
    if (const Point& p = end_of(pair.a, spot); lies_on(p, pair.b)) {
      pair.on_a = spot;
      pair.on_b = spot_on(p, pair.b);
      return;
    }
    if (lies_on(end_of(pair.b, spot), pair.a)) pair.on_b = spot;
  }
}

Point rounded(const Exact& p) { return {to_double(p[0]), to_double(p[1])}; }

/// The point of the line through s that is nearest to p.
Point foot(const Point& p, const Segment& s) {
  const Exact difference = exact_difference(s.a, s.b);
  const Rational share =
      gjk::dot(difference, exact_difference(s.a, p)) / gjk::dot(difference, difference);
  return rounded(exact(s.a) + Exact(share * difference[0], share * difference[1]));
}

Point crossing(const Segment& s, const Segment& t) {
  const Exact difference = exact_difference(s.a, s.b);
  const Exact other = exact_difference(t.a, t.b);
  const Rational share =
      gjk::cross(exact_difference(s.a, t.a), other) / gjk::cross(difference, other);
  return rounded(exact(s.a) + Exact(share * difference[0], share * difference[1]));
}

}  // namespace

int turn(const Point& a, const Point& b, const Point& c) {
  return sign_of_products({b.x(), a.x()}, {c.y(), a.y()}, -1, {b.y(), a.y()}, {c.x(), a.x()}, [&] {
    return gjk::cross(exact_difference(a, b), exact_difference(a, c));
  });
}

int dot_sign(const Point& a, const Point& b, const Point& c, const Point& d) {
  return sign_of_products({b.x(), a.x()}, {d.x(), c.x()}, 1, {b.y(), a.y()}, {d.y(), c.y()},
                          [&] { return gjk::dot(exact_difference(a, b), exact_difference(c, d)); });
}

int along(const Point& a, const Point& b, const Point& p) { return dot_sign(a, b, a, p); }

bool meet(const Segment& a, const Segment& b) {
  const bool boxes_meet = (a.a.cwiseMin(a.b).array() <= b.a.cwiseMax(b.b).array()).all() &&
                          (b.a.cwiseMin(b.b).array() <= a.a.cwiseMax(a.b).array()).all();
  return boxes_meet && turn(a.a, a.b, b.a) * turn(a.a, a.b, b.b) <= 0 &&
         turn(b.a, b.b, a.a) * turn(b.a, b.b, a.b) <= 0;
}

int winding(const Point& point, const Segment& s) {
  const bool from_below = s.a.y() <= point.y();
  const bool to_below = s.b.y() <= point.y();
  if (from_below == to_below) return 0;
  const int side = turn(s.a, s.b, point);
  return from_below ? (side > 0 ? 1 : 0) : (side < 0 ? -1 : 0);
}

int winding(const Point& point, const Model& model) {
  int around = 0;
  for (const Segment& s : model.segments) {
    if (model.outlines[s.outline].closed) around += winding(point, s);
  }
  return around;
}

Nearest nearest(const Segment& a, const Segment& b) {
  Nearest best{a, b};
  if (meet(a, b)) {
    set_meeting_spots(best);
    return best;
  }
  bool first = true;
  const auto try_pair = [&](Spot on_a, Spot on_b, const Bounds& bounds) {
    if (!first && on_a == best.on_a && on_b == best.on_b) return;
    const Nearest pair{a, b, on_a, on_b, false, bounds.low, bounds.high};
    if (first || compare_distances(pair, best) < 0) best = pair;
    first = false;
  };
  for (const Spot spot : {Spot::start, Spot::end}) {
    const Point& from_a = end_of(a, spot);
    const Spot on_b = nearest_spot(from_a, b);
    try_pair(spot, on_b, bounds_of(from_a, b, on_b));
    const Point& from_b = end_of(b, spot);
    const Spot on_a = nearest_spot(from_b, a);
    try_pair(on_a, spot, bounds_of(from_b, a, on_a));
  }
  return best;
}

std::strong_ordering compare_distances(const Nearest& p, const Nearest& q) {
  if (p.high < q.low) return std::strong_ordering::less;
  if (q.high < p.low) return std::strong_ordering::greater;
  if (p.meet || q.meet) return q.meet <=> p.meet;
  const Measured of_p = measured(p);
  const Measured of_q = measured(q);
  if (of_p == of_q) return std::strong_ordering::equal;
  const Square left = square_of(of_p);
  const Square right = square_of(of_q);
  return left.top * right.bottom <=> right.top * left.bottom;
}

std::strong_ordering operator<=>(const Nearest& p, const Nearest& q) {
  if (const auto order = compare_distances(p, q); order != 0) return order;
  const auto place = [](const Nearest& pair) {
    return std::array{pair.a.outline, pair.a.index, pair.b.outline, pair.b.index};
  };
  // Not every library compares arrays three ways.
  const auto at_p = place(p);
  const auto at_q = place(q);
  if (at_p == at_q) return std::strong_ordering::equal;
  return at_p < at_q ? std::strong_ordering::less : std::strong_ordering::greater;
}

Rational distance_sq(const Nearest& pair) {
  if (pair.meet) return 0;
  const Square square = square_of(measured(pair));
  return square.top / square.bottom;
}

Feature feature_of(const Segment& segment, Spot spot, const Model& model) {
  if (spot == Spot::between) return {false, segment.outline, segment.index};
  const auto points = model.outlines[segment.outline].points.size();
  const int index = segment.index + (spot == Spot::end ? 1 : 0);
  return {true, segment.outline, index == static_cast<int>(points) ? 0 : index};
}

Answer answer_of(const Nearest& pair, const Model& a, const Model& b) {
  Answer answer;
  answer.on_a = feature_of(pair.a, pair.on_a, a);
  answer.on_b = feature_of(pair.b, pair.on_b, b);
  answer.overlap = pair.meet;
  if (pair.meet) {
    answer.a = answer.on_a.is_vertex   ? end_of(pair.a, pair.on_a)
               : answer.on_b.is_vertex ? end_of(pair.b, pair.on_b)
                                       : crossing(pair.a, pair.b);
    answer.b = answer.a;
    return answer;
  }
  answer.distance = gjkscope::root_nearest(distance_sq(pair));
  answer.a =
      answer.on_a.is_vertex ? end_of(pair.a, pair.on_a) : foot(end_of(pair.b, pair.on_b), pair.a);
  answer.b =
      answer.on_b.is_vertex ? end_of(pair.b, pair.on_b) : foot(end_of(pair.a, pair.on_a), pair.b);
  return answer;
}

}  // namespace models
