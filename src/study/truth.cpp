#include "study/truth.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>

#include "geometry/integer.hpp"

// Floating-point numbers are integers times a power of two, and so are vertices moved by poses.
// Where X and Y stand on such a common grid nothing divides and nothing rounds. The simplex that
// was guessed is improved until a proof holds:
//
//   apart:   all of Z = Y - X lies beyond the plane through P, normal to P, where P is the nearest
//            point to O of the hull of some vertices of Z;
//   overlap: O lies in the hull of some vertices of Z.

namespace gjkscope::study {
namespace {

/// a * 2^exponent, of which 64 digits are left. Where that drops any the last one is odd, so that a
/// double comes of it as from the whole.
long double rounded(const Integer& a, long exponent) {
  static_assert(std::numeric_limits<long double>::digits >= 64);
  if (a.is_zero()) return 0;
  const long drop = std::max(0L, digit_count(a) - 64);
  const bool is_exact = trailing_zeros(a) >= drop;
  const auto digits = static_cast<std::uint64_t>(abs(a) >> drop);
  const auto size = static_cast<long double>(digits | (is_exact ? 0 : 1));
  return std::ldexp(a.sign() < 0 ? -size : size, static_cast<int>(drop + exponent));
}

/// mantissa * 2^exponent, the mantissa odd or 0.
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};
Dyadic dyadic(double value) {
  if (value == 0) return {};
  Dyadic out;
  out.mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &out.exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(out.mantissa));
  out.mantissa >>= zeros;
  out.exponent += zeros - 53;
  return out;
}
/// On the grid of multiples of 2^exponent.
Integer on_grid(const Dyadic& value, long exponent) {
  return value.mantissa == 0 ? Integer(0) : Integer(value.mantissa) << (value.exponent - exponent);
}

/// A product of two numbers that is to be added to others of its kind.
struct Term {
  Dyadic a;
  Dyadic b;
  [[nodiscard]] bool is_zero() const { return a.mantissa == 0 || b.mantissa == 0; }
  [[nodiscard]] int exponent() const { return a.exponent + b.exponent; }
};
/// One coordinate of rotation * vertex + translation.
using Sum = std::array<Term, 3>;

Sum coordinate(const gjk::Pose<double, 2>& pose, const Eigen::Vector2d& vertex, int row) {
  return {Term{dyadic(pose.rotation(row, 0)), dyadic(vertex[0])},
          Term{dyadic(pose.rotation(row, 1)), dyadic(vertex[1])},
          Term{dyadic(1.0), dyadic(pose.translation[row])}};
}
Integer on_grid(const Sum& sum, long exponent) {
  Integer total;
  for (const Term& term : sum) {
    if (term.is_zero()) continue;
    Integer product = term.a.mantissa;
    product *= term.b.mantissa;
    total += product << (term.exponent() - exponent);
  }
  return total;
}

struct Point {
  Integer x;
  Integer y;
};
Integer dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
Integer cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Point perpendicular(const Point& a) { return {-a.y, a.x}; }
Point opposite(const Point& a) { return {-a.x, -a.y}; }

/// Two shapes, moved by their poses, on a common grid.
struct OnGrid {
  long exponent = 0;  ///< A point stands at (x, y) * 2^exponent.
  std::vector<Point> x;
  std::vector<Point> y;

  [[nodiscard]] Point difference(const gjk::VertexPair& pair) const {
    return minus(y[static_cast<std::size_t>(pair.y)], x[static_cast<std::size_t>(pair.x)]);
  }
  /// The vertex of Z with the least dot product with `normal`.
  [[nodiscard]] gjk::VertexPair least_along(const Point& normal) const {
    const auto extreme = [&](const std::vector<Point>& points, int sign) {
      int best = 0;
      Integer best_value;
      for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        Integer value = dot(normal, points[static_cast<std::size_t>(i)]);
        if (i == 0 || value.compare(best_value) * sign > 0) {
          best = i;
          best_value = std::move(value);
        }
      }
      return best;
    };
    return {extreme(x, 1), extreme(y, -1)};
  }
};

OnGrid on_grid(const families::Pair<double>& pair) {
  const auto sums_of = [](const std::vector<Eigen::Vector2d>& vertices, const auto& pose) {
    std::vector<std::array<Sum, 2>> out;
    for (const Eigen::Vector2d& v : vertices) {
      out.push_back({coordinate(pose, v, 0), coordinate(pose, v, 1)});
    }
    return out;
  };
  const auto x = sums_of(pair.x, pair.x_pose);
  const auto y = sums_of(pair.y, pair.y_pose);
  std::optional<int> least;
  for (const auto* points : {&x, &y}) {
    for (const std::array<Sum, 2>& point : *points) {
      for (const Sum& sum : point) {
        for (const Term& term : sum) {
          if (!term.is_zero()) least = std::min(least.value_or(term.exponent()), term.exponent());
        }
      }
    }
  }
  OnGrid out;
  out.exponent = least.value_or(0);
  const auto place = [&](const std::array<Sum, 2>& point) -> Point {
    return {on_grid(point[0], out.exponent), on_grid(point[1], out.exponent)};
  };
  std::transform(x.begin(), x.end(), std::back_inserter(out.x), place);
  std::transform(y.begin(), y.end(), std::back_inserter(out.y), place);
  return out;
}

/// The nearest point P to O of the hull of up to three points.
struct Nearest {
  bool is_origin = false;
  std::vector<int> face;  ///< Its vertices: P lies between all of them.
  Point normal;           ///< Along P, where P is not O.
  Integer reach;          ///< dot(normal, P)
  Integer length_sq;      ///< |normal|^2, so |P| = reach / |normal|.

  void offer(std::vector<int> other, const Point& along, const Integer& other_reach) {
    const Integer other_length_sq = dot(along, along);
    const Integer mine = reach * reach * other_length_sq;
    if (!face.empty() && mine <= other_reach * other_reach * length_sq) return;
    face = std::move(other);
    normal = along;
    reach = other_reach;
    length_sq = other_length_sq;
  }
  void found_origin(std::vector<int> around) {
    is_origin = true;
    face = std::move(around);
  }
};

Nearest nearest(const std::vector<Point>& z) {
  Nearest out;
  const int count = static_cast<int>(z.size());
  for (int i = 0; i < count; ++i) {
    const Integer length_sq = dot(z[i], z[i]);
    if (length_sq == 0) {
      out.found_origin({i});
      return out;
    }
    out.offer({i}, z[i], length_sq);
  }
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      const Point edge = minus(z[i], z[j]);
      if (dot(edge, z[i]) <= 0 || dot(edge, z[j]) >= 0) continue;  // the foot is not inside
      const Point normal = perpendicular(edge);
      const Integer reach = dot(normal, z[i]);
      if (reach == 0) {
        out.found_origin({i, j});
        return out;
      }
      out.offer({i, j}, reach < 0 ? opposite(normal) : normal, abs(reach));
    }
  }
  if (count == 3) {
    const int side = cross(z[0], z[1]).sign();
    if (side != 0 && side == cross(z[1], z[2]).sign() && side == cross(z[2], z[0]).sign()) {
      out.found_origin({0, 1, 2});
    }
  }
  return out;
}

/// O lies in the face of Z between the vertices `pairs`. True when some line through O has all of Z
/// on one side.
bool touches(const OnGrid& shapes, const std::vector<gjk::VertexPair>& pairs) {
  if (pairs.size() == 3) return false;
  // Such a line can be turned until it runs along the edge, or from a vertex at O to a neighbour.
  std::vector<Point> along;
  if (pairs.size() == 2) {
    along.push_back(minus(shapes.difference(pairs[0]), shapes.difference(pairs[1])));
  } else {
    for (const Point& p : shapes.x) along.push_back(minus(shapes.x[pairs[0].x], p));
    for (const Point& p : shapes.y) along.push_back(minus(p, shapes.y[pairs[0].y]));
  }
  bool is_point = true;
  for (const Point& line : along) {
    if (line.x == 0 && line.y == 0) continue;
    is_point = false;
    for (const Point& normal : {perpendicular(line), opposite(perpendicular(line))}) {
      if (dot(normal, shapes.difference(shapes.least_along(normal))) == 0) return true;
    }
  }
  return is_point;
}

/// The distance reach / root(length_sq), on the grid.
void set_distance(Truth& out, const Nearest& p, long exponent) {
  constexpr long kDigits = 192;
  const Integer above = p.reach * p.reach;
  const long shift = std::max(0L, kDigits + (digit_count(p.length_sq) - digit_count(above)) / 2);
  Integer rest = root_down((above << (2 * shift)) / p.length_sq);
  const long unit = exponent - shift;
  out.distance = static_cast<double>(rounded(rest, unit));
  if (!std::isfinite(out.distance)) return;  // no double holds it, nor what it leaves out
  rest -= on_grid(dyadic(out.distance), unit);
  const long drop = std::max(0L, digit_count(rest) - 64);
  const Integer high = (rest >> drop) << drop;
  out.rest = Quad(rounded(high, unit)) + Quad(rounded(rest - high, unit));
}

/// The distance, or that there is none.
void solve(Truth& out, const OnGrid& shapes, const gjk::WarmStart& guess) {
  std::vector<gjk::VertexPair> pairs(guess.pairs.begin(), guess.pairs.begin() + guess.count);
  if (pairs.empty()) pairs.emplace_back();
  for (;;) {
    std::vector<Point> z;
    for (const gjk::VertexPair& pair : pairs) z.push_back(shapes.difference(pair));
    const Nearest p = nearest(z);
    std::vector<gjk::VertexPair> face;
    for (const int i : p.face) face.push_back(pairs[static_cast<std::size_t>(i)]);
    if (p.is_origin) {
      out.overlap = true;
      out.touching = touches(shapes, face);
      return;
    }
    const gjk::VertexPair farther = shapes.least_along(p.normal);
    if (dot(p.normal, shapes.difference(farther)) >= p.reach) {
      set_distance(out, p, shapes.exponent);
      return;
    }
    face.push_back(farther);
    pairs = std::move(face);
  }
}

NearPoint minus(const NearPoint& a, const NearPoint& b) { return {a[0] - b[0], a[1] - b[1]}; }
long double dot(const NearPoint& a, const NearPoint& b) { return a[0] * b[0] + a[1] * b[1]; }
long double cross(const NearPoint& a, const NearPoint& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<NearPoint> hull_of(std::vector<NearPoint> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<NearPoint> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const NearPoint& p : points) {
      while (hull.size() >= begin + 2 &&
             cross(minus(hull.back(), hull[hull.size() - 2]), minus(p, hull.back())) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Sets the scale and the hulls.
void set_near(Truth& out, const OnGrid& shapes) {
  const auto coordinate = [&](const Integer& a) {
    return static_cast<double>(rounded(a, shapes.exponent));
  };
  // Rounded to a double it has no more digits than the grid.
  out.origin = {coordinate(shapes.x[0].x), coordinate(shapes.x[0].y)};
  const Point origin{on_grid(dyadic(out.origin[0]), shapes.exponent),
                     on_grid(dyadic(out.origin[1]), shapes.exponent)};
  const auto near = [&](const std::vector<Point>& points) {
    std::vector<NearPoint> relative;
    for (const Point& p : points) {
      relative.push_back({rounded(p.x - origin.x, shapes.exponent),  //
                          rounded(p.y - origin.y, shapes.exponent)});
    }
    return hull_of(std::move(relative));
  };
  out.x = near(shapes.x);
  out.y = near(shapes.y);
  for (const NearPoint& a : out.x) {
    for (const NearPoint& b : out.y) out.scale = std::max(out.scale, dot(minus(b, a), minus(b, a)));
  }
  out.scale = std::sqrt(out.scale);
}

long double distance_sq_from_segment(const NearPoint& q, const NearPoint& a, const NearPoint& b) {
  const NearPoint edge = minus(b, a);
  const NearPoint from_a = minus(q, a);
  const NearPoint from_b = minus(q, b);
  if (dot(from_a, edge) <= 0) return dot(from_a, from_a);
  if (dot(from_b, edge) >= 0) return dot(from_b, from_b);
  const long double area = cross(edge, from_a);
  return area * area / dot(edge, edge);
}

/// How far `point` lies outside of the hull.
long double outside(const std::array<Quad, 2>& point, const std::vector<NearPoint>& hull,
                    const Eigen::Vector2d& origin) {
  const NearPoint q = {static_cast<long double>(point[0] - Quad(origin[0])),
                       static_cast<long double>(point[1] - Quad(origin[1]))};
  bool inside = hull.size() > 2;
  long double best_sq = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const NearPoint& a = hull[i];
    const NearPoint& b = hull[i + 1 < hull.size() ? i + 1 : 0];
    inside = inside && cross(minus(b, a), minus(q, a)) >= 0;
    best_sq = std::min(best_sq, distance_sq_from_segment(q, a, b));
  }
  return inside ? 0 : std::sqrt(best_sq);
}

bool is_finite(const Claim& claim) {
  const Quad numbers[] = {claim.distance, claim.lower, claim.upper, claim.x[0],
                          claim.x[1],     claim.y[0],  claim.y[1]};
  return std::all_of(std::begin(numbers), std::end(numbers),
                     [](const Quad& a) { return gjk::ScalarTraits<Quad>::is_finite(a); });
}

/// value - distance
Quad beyond(const Quad& value, const Truth& truth) {
  return value - Quad(truth.distance) - truth.rest;
}

double witness_error(const Claim& claim, const Truth& truth) {
  const auto forgiven = [&](const std::array<Quad, 2>& point) {
    const long double away =
        std::hypot(static_cast<long double>(point[0]), static_cast<long double>(point[1]));
    return claim.unit_roundoff * std::max(0.0L, away - truth.scale);
  };
  const long double x_forgiven = forgiven(claim.x);
  const long double y_forgiven = forgiven(claim.y);
  const long double apart = std::hypot(static_cast<long double>(claim.y[0] - claim.x[0]),
                                       static_cast<long double>(claim.y[1] - claim.x[1]));
  const long double beside =
      std::abs(apart - truth.distance - static_cast<long double>(truth.rest));
  return static_cast<double>(std::max({0.0L, outside(claim.x, truth.x, truth.origin) - x_forgiven,
                                       outside(claim.y, truth.y, truth.origin) - y_forgiven,
                                       beside - x_forgiven - y_forgiven}));
}

}  // namespace

Truth truth_of(const families::Pair<double>& pair, const gjk::WarmStart& guess) {
  const OnGrid shapes = on_grid(pair);
  Truth out;
  solve(out, shapes, guess);
  set_near(out, shapes);
  return out;
}

double difference(const Quad& value, const Truth& truth) {
  return static_cast<double>(beyond(value, truth));
}

Judgement judge(const Claim& claim, const Judged& judged) {
  using gjk::Verdict;
  Judgement out;
  out.failed = claim.refused || claim.verdict == Verdict::none || !is_finite(claim);
  if (out.failed) return out;
  out.undecided = claim.verdict == Verdict::undecided;
  const bool overlap = claim.verdict != Verdict::separated;
  out.wrong = !out.undecided && overlap != judged.given.overlap;
  out.wrong_as_kept = !out.undecided && overlap != judged.as_kept.overlap;
  out.wrong_contact = overlap && !out.undecided && judged.as_kept.overlap &&
                      (claim.verdict == Verdict::touching) != judged.as_kept.touching;
  out.error = std::abs(difference(claim.distance, judged.given));
  out.error_as_kept = std::abs(difference(claim.distance, judged.as_kept));
  out.width = std::numeric_limits<double>::quiet_NaN();
  if (claim.has_bounds) {
    out.broken_bounds = claim.lower < Quad(0) || claim.distance < claim.lower ||
                        claim.upper < claim.distance ||
                        beyond(claim.lower, judged.as_kept) > Quad(0) ||
                        beyond(claim.upper, judged.as_kept) < Quad(0);
    out.width = static_cast<double>(claim.upper - claim.lower);
  }
  out.witness = witness_error(claim, judged.as_kept);
  return out;
}

}  // namespace gjkscope::study
