#include "study/truth.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "exact/integer.hpp"

// Floating-point numbers are integers times a power of two, and so are vertices moved by poses.
// Nothing divides and nothing rounds when X and Y stand on such a common grid. The simplex that was
// guessed is improved until a proof holds:
//
//   apart:   all of Z = Y - X lies beyond the plane through P, normal to P, where P is the nearest
//            point to O of the hull of some vertices of Z;
//   overlap: O lies in the hull of some vertices of Z.

namespace gjkscope::study {
namespace {

/// a * 2^exponent, cut off after 64 digits. If any were dropped, the last one is set to 1, so that
/// rounding to double gives the same as rounding the whole number.
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
/// One coordinate of rotation * vertex + translation, or of a point in quadruple precision.
template <int D>
using Sum = std::array<Term, D + 1>;
/// The points of a shape.
template <int D>
using Sums = std::vector<std::array<Sum<D>, D>>;

template <int D>
Sums<D> sums_of(const std::vector<gjk::Vec<double, D>>& vertices,
                const gjk::Pose<double, D>& pose) {
  Sums<D> out;
  for (const auto& vertex : vertices) {
    out.emplace_back();
    for (int row = 0; row < D; ++row) {
      Sum<D>& sum = out.back()[row];
      for (int k = 0; k < D; ++k) sum[k] = {dyadic(pose.rotation(row, k)), dyadic(vertex[k])};
      sum[D] = {dyadic(1.0), dyadic(pose.translation[row])};
    }
  }
  return out;
}
template <int D>
Sums<D> sums_of(const std::array<Quad, D>& point) {
  Sums<D> out(1);
  for (int i = 0; i < D; ++i) {
    Quad rest = point[i];
    for (Term& term : out[0][i]) {  // 53 bits each, of 113
      const auto high = static_cast<double>(rest);
      rest -= Quad(high);
      term = {dyadic(1.0), dyadic(high)};
    }
  }
  return out;
}

template <int D>
Integer on_grid(const Sum<D>& sum, long exponent) {
  Integer total;
  for (const Term& term : sum) {
    if (term.is_zero()) continue;
    Integer product = term.a.mantissa;
    product *= term.b.mantissa;
    total += product << (term.exponent() - exponent);
  }
  return total;
}

template <int D>
using Point = std::array<Integer, D>;

template <int D>
Integer dot(const Point<D>& a, const Point<D>& b) {
  Integer sum = a[0] * b[0];
  for (int i = 1; i < D; ++i) sum += a[i] * b[i];
  return sum;
}
template <int D>
Point<D> minus(const Point<D>& a, const Point<D>& b) {
  Point<D> out;
  for (int i = 0; i < D; ++i) out[i] = a[i] - b[i];
  return out;
}
Point<2> perpendicular(const Point<2>& a) { return {Integer(-a[1]), a[0]}; }
Point<3> cross(const Point<3>& a, const Point<3>& b) {
  return {Integer(a[1] * b[2] - a[2] * b[1]), Integer(a[2] * b[0] - a[0] * b[2]),
          Integer(a[0] * b[1] - a[1] * b[0])};
}
template <int D>
bool is_zero(const Point<D>& a) {
  return std::all_of(a.begin(), a.end(), [](const Integer& x) { return x == 0; });
}

/// Two shapes, moved by their poses, on a common grid.
template <int D>
struct OnGrid {
  long exponent = 0;  ///< A point stands at its coordinates times 2^exponent.
  std::vector<Point<D>> x;
  std::vector<Point<D>> y;

  OnGrid(const Sums<D>& x_sums, const Sums<D>& y_sums) {
    std::optional<int> least;
    for (const auto* shape : {&x_sums, &y_sums}) {
      for (const auto& point : *shape) {
        for (const Sum<D>& sum : point) {
          for (const Term& term : sum) {
            if (!term.is_zero()) least = std::min(least.value_or(term.exponent()), term.exponent());
          }
        }
      }
    }
    exponent = least.value_or(0);
    const auto place = [&](const std::array<Sum<D>, D>& point) {
      Point<D> out;
      for (int i = 0; i < D; ++i) out[i] = on_grid<D>(point[i], exponent);
      return out;
    };
    std::transform(x_sums.begin(), x_sums.end(), std::back_inserter(x), place);
    std::transform(y_sums.begin(), y_sums.end(), std::back_inserter(y), place);
  }

  [[nodiscard]] Point<D> difference(const gjk::VertexPair& pair) const {
    return minus<D>(y[pair.y], x[pair.x]);
  }
  /// The vertex of Z with the least dot product with `normal`.
  [[nodiscard]] gjk::VertexPair least_along(const Point<D>& normal) const {
    const auto extreme = [&](const std::vector<Point<D>>& points, int sign) {
      int best = 0;
      Integer best_value;
      for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        Integer value = dot<D>(normal, points[i]);
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

/// The nearest point P to O of the hull of up to D + 1 points.
template <int D>
struct Nearest {
  bool is_origin = false;
  std::vector<int> face;  ///< Its vertices: P lies between all of them.
  Point<D> normal;        ///< Along P, where P is not O.
  Integer reach;          ///< dot(normal, P)
  Integer length_sq;      ///< |normal|^2, so |P| = reach / |normal|.

  /// The point of the plane through `point` normal to `along` that is nearest to O: it lies between
  /// the vertices `other`.
  void offer(const std::vector<int>& other, Point<D> along, const Point<D>& point) {
    if (is_origin) return;
    Integer other_reach = dot<D>(along, point);
    if (other_reach == 0) {
      is_origin = true;
      face = other;
      return;
    }
    if (other_reach < 0) {
      other_reach = -other_reach;
      for (Integer& a : along) a = -a;
    }
    Integer other_length_sq = dot<D>(along, along);
    if (!face.empty() && Integer(reach * reach * other_length_sq) <=
                             Integer(other_reach * other_reach * length_sq)) {
      return;
    }
    face = other;
    normal = std::move(along);
    reach = std::move(other_reach);
    length_sq = std::move(other_length_sq);
  }
};

/// The line through two points of Z: where the point nearest to O lies between them, it is offered.
template <int D>
void offer_edge(Nearest<D>& out, const std::vector<Point<D>>& z, int i, int j) {
  const Point<D> edge = minus<D>(z[j], z[i]);
  if (dot<D>(edge, z[i]) >= 0 || dot<D>(edge, z[j]) <= 0) return;
  if constexpr (D == 2) {
    out.offer({i, j}, perpendicular(edge), z[i]);
  } else {
    out.offer({i, j}, cross(edge, cross(edge, z[i])), z[i]);
  }
}

void offer_triangle(Nearest<3>& out, const std::vector<Point<3>>& z, const std::array<int, 3>& v) {
  const Point<3> normal = cross(minus<3>(z[v[1]], z[v[0]]), minus<3>(z[v[2]], z[v[0]]));
  for (int i = 0; i < 3; ++i) {
    if (dot<3>(normal, cross(z[v[i]], z[v[(i + 1) % 3]])) <= 0) return;
  }
  out.offer({v[0], v[1], v[2]}, normal, z[v[0]]);
}

/// O is an inner point of the hull of D + 1 points: from it, all facets turn the same way.
template <int D>
bool is_inside(const std::vector<Point<D>>& z) {
  int side = 0;
  for (int apex = 0; apex <= D; ++apex) {
    std::array<const Point<D>*, D> facet = {};
    for (int i = 0; i < D; ++i) facet[i] = &z[i < apex ? i : i + 1];
    int turn = 0;
    if constexpr (D == 2) {
      turn = (dot<2>(perpendicular(*facet[0]), *facet[1])).sign();
    } else {
      turn = (dot<3>(cross(*facet[0], *facet[1]), *facet[2])).sign();
    }
    if (apex % 2 == 1) turn = -turn;
    if (turn == 0 || turn == -side) return false;
    side = turn;
  }
  return true;
}

template <int D>
Nearest<D> nearest(const std::vector<Point<D>>& z) {
  Nearest<D> out;
  const int count = static_cast<int>(z.size());
  for (int i = 0; i < count; ++i) out.offer({i}, z[i], z[i]);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      offer_edge<D>(out, z, i, j);
      if constexpr (D == 3) {
        for (int k = 0; k < j; ++k) offer_triangle(out, z, {i, j, k});
      }
    }
  }
  if (!out.is_origin && count == D + 1 && is_inside<D>(z)) {
    out.is_origin = true;
    out.face.resize(D + 1);
    std::iota(out.face.begin(), out.face.end(), 0);
  }
  return out;
}

/// Calls `visit` with a vector normal to D - 1 of the vectors `along`, for each choice of them of
/// which the first `fixed` are part.
template <int D, class Visit>
void for_each_normal(const std::vector<Point<D>>& along, std::size_t fixed, const Visit& visit) {
  const std::size_t last = along.size();
  if constexpr (D == 2) {
    for (std::size_t i = 0; i < (fixed > 0 ? 1 : last); ++i) visit(perpendicular(along[i]));
  } else {
    for (std::size_t i = 0; i < (fixed > 0 ? 1 : last); ++i) {
      for (std::size_t k = i + 1; k < (fixed > 1 ? 2 : last); ++k) visit(cross(along[i], along[k]));
    }
  }
}

/// O lies between the vertices `pairs` of Z. True when some plane (in the plane, line) through O
/// has all of Z on one side.
template <int D>
bool touches(const OnGrid<D>& shapes, const std::vector<gjk::VertexPair>& pairs) {
  if (pairs.size() == D + 1) return false;
  // Such a plane holds all of `pairs`, and can be turned until it runs along D - 1 of the edges
  // from one of them, or Z is flat.
  std::vector<Point<D>> along;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    along.push_back(minus<D>(shapes.difference(pairs[i]), shapes.difference(pairs[0])));
  }
  for (const Point<D>& p : shapes.x) along.push_back(minus<D>(shapes.x[pairs[0].x], p));
  for (const Point<D>& p : shapes.y) along.push_back(minus<D>(p, shapes.y[pairs[0].y]));
  bool is_flat = true;
  bool found = false;
  for_each_normal<D>(along, pairs.size() - 1, [&](const Point<D>& normal) {
    if (found || is_zero<D>(normal)) return;
    is_flat = false;
    int side = 0;
    for (const Point<D>& edge : along) {
      const int other = (dot<D>(normal, edge)).sign();
      if (other != 0 && other == -side) return;
      if (other != 0) side = other;
    }
    found = true;
  });
  return is_flat || found;
}

/// The nearest point of Z to O.
template <int D>
struct Solved {
  Nearest<D> p;
  std::vector<gjk::VertexPair> face;  ///< It lies between these vertices.
};
template <int D>
Solved<D> solve(const OnGrid<D>& shapes, std::vector<gjk::VertexPair> pairs) {
  if (pairs.empty()) pairs.emplace_back();
  for (;;) {
    std::vector<Point<D>> z;
    for (const gjk::VertexPair& pair : pairs) z.push_back(shapes.difference(pair));
    Solved<D> out{nearest<D>(z), {}};
    for (const int i : out.p.face) out.face.push_back(pairs[i]);
    if (out.p.is_origin) return out;
    const gjk::VertexPair farther = shapes.least_along(out.p.normal);
    if (dot<D>(out.p.normal, shapes.difference(farther)) >= out.p.reach) return out;
    pairs = std::move(out.face);
    pairs.push_back(farther);
  }
}

/// The distance reach / root(length_sq), on the grid.
template <int D>
void set_distance(Truth<D>& out, const Nearest<D>& p, long exponent) {
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

/// Rounded only when it is small: 2^-63 of itself.
template <int D>
long double scale_of(const OnGrid<D>& shapes) {
  const auto near = [&](const std::vector<Point<D>>& points) {
    std::vector<std::array<long double, D>> out;
    for (const Point<D>& p : points) {
      out.emplace_back();
      for (int i = 0; i < D; ++i) {
        out.back()[i] = rounded(p[i] - shapes.x[0][i], shapes.exponent);
      }
    }
    return out;
  };
  long double largest_sq = 0;
  const auto x_near = near(shapes.x);
  for (const auto& b : near(shapes.y)) {
    for (const auto& a : x_near) {
      long double sum = 0;
      for (int i = 0; i < D; ++i) sum += (b[i] - a[i]) * (b[i] - a[i]);
      largest_sq = std::max(largest_sq, sum);
    }
  }
  return std::sqrt(largest_sq);
}

/// How far `point` lies outside of the shape, of which the vertices `near` may be close.
template <int D>
long double outside(const std::array<Quad, D>& point, const Sums<D>& shape,
                    const std::vector<int>& near) {
  const OnGrid<D> both(sums_of<D>(point), shape);
  std::vector<gjk::VertexPair> guess;
  for (const int i : near) guess.push_back({0, i});
  const Solved<D> found = solve(both, guess);
  if (found.p.is_origin) return 0;
  return std::ldexp(rounded(found.p.reach, 0) / std::sqrt(rounded(found.p.length_sq, 0)),
                    static_cast<int>(both.exponent));
}

template <int D>
bool is_finite(const Claim<D>& claim) {
  const auto all = [](const auto& numbers) {
    return std::all_of(std::begin(numbers), std::end(numbers),
                       [](const Quad& a) { return gjk::ScalarTraits<Quad>::is_finite(a); });
  };
  return all(std::array{claim.distance, claim.lower, claim.upper}) && all(claim.x) && all(claim.y);
}

/// value - distance
template <int D>
Quad beyond(const Quad& value, const Truth<D>& truth) {
  return value - Quad(truth.distance) - truth.rest;
}

template <int D>
long double length(const std::array<Quad, D>& a) {
  long double largest = 0;
  for (const Quad& value : a)
    largest = std::max(largest, std::abs(static_cast<long double>(value)));
  if (largest == 0) return 0;
  long double sum = 0;
  for (const Quad& value : a) {
    const long double share = static_cast<long double>(value) / largest;
    sum += share * share;
  }
  return largest * std::sqrt(sum);
}

template <int D>
double witness_error(const Claim<D>& claim, const Truth<D>& truth) {
  const auto forgiven = [&](const std::array<Quad, D>& point) {
    return claim.unit_roundoff * std::max(0.0L, length<D>(point) - truth.scale);
  };
  const long double x_forgiven = forgiven(claim.x);
  const long double y_forgiven = forgiven(claim.y);
  std::array<Quad, D> apart;
  for (int i = 0; i < D; ++i) apart[i] = claim.y[i] - claim.x[i];
  const long double beside =
      std::abs(length<D>(apart) - truth.distance - static_cast<long double>(truth.rest));
  std::vector<int> x_near;
  std::vector<int> y_near;
  for (int i = 0; i < claim.near.count; ++i) {
    x_near.push_back(claim.near.pairs[i].x);
    y_near.push_back(claim.near.pairs[i].y);
  }
  const families::Pair<double, D>& pair = truth.pair;
  return static_cast<double>(
      std::max({0.0L, outside<D>(claim.x, sums_of<D>(pair.x, pair.x_pose), x_near) - x_forgiven,
                outside<D>(claim.y, sums_of<D>(pair.y, pair.y_pose), y_near) - y_forgiven,
                beside - x_forgiven - y_forgiven}));
}

}  // namespace

template <int D>
Truth<D> truth_of(const families::Pair<double, D>& pair, const gjk::WarmStart& guess) {
  const OnGrid<D> shapes(sums_of<D>(pair.x, pair.x_pose), sums_of<D>(pair.y, pair.y_pose));
  Truth<D> out;
  out.pair = pair;
  out.scale = scale_of(shapes);
  const Solved<D> found = solve(shapes, {guess.pairs.begin(), guess.pairs.begin() + guess.count});
  out.overlap = found.p.is_origin;
  if (out.overlap) {
    out.touching = touches(shapes, found.face);
  } else {
    set_distance(out, found.p, shapes.exponent);
  }
  return out;
}

template <int D>
double difference(const Quad& value, const Truth<D>& truth) {
  return static_cast<double>(beyond(value, truth));
}

template <int D>
Judgement judge(const Claim<D>& claim, const Judged<D>& judged) {
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

template Truth<2> truth_of(const families::Pair<double, 2>&, const gjk::WarmStart&);
template Truth<3> truth_of(const families::Pair<double, 3>&, const gjk::WarmStart&);
template double difference(const Quad&, const Truth<2>&);
template double difference(const Quad&, const Truth<3>&);
template Judgement judge(const Claim<2>&, const Judged<2>&);
template Judgement judge(const Claim<3>&, const Judged<3>&);

}  // namespace gjkscope::study
