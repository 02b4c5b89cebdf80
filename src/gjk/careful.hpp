#pragma once
// Vertices and distances with about twice the digits of the run, for where its own are too few.

#include <array>

#include "gjk/expansion.hpp"
#include "gjk/prepare.hpp"
#include "gjk/simplex.hpp"

template <class R>
struct Eigen::NumTraits<gjk::DoubleWord<R>> : Eigen::GenericNumTraits<R> {};

namespace gjk::detail {

template <class R>
[[nodiscard]] R rounded(const Expansion& value) {
  return value.estimate<R>();
}
template <class R>
[[nodiscard]] R rounded(const DoubleWord<R>& value) {
  return value.hi;
}

/// Adds up numbers and products of two, with what rounding loses kept beside them.
template <class R>
class CarefulSum {
 public:
  explicit CarefulSum(const R& first) : sum_{first, R(0)} {}
  void add(const R& a) {
    const DoubleWord<R> next = exact_sum(sum_.hi, a);
    sum_ = {next.hi, R(sum_.lo + next.lo)};
  }
  void add_product(const R& a, const R& b) {
    const DoubleWord<R> product = exact_product(a, b);
    add(product.hi);
    sum_.lo = sum_.lo + product.lo;
  }
  /// Not normalised.
  [[nodiscard]] const DoubleWord<R>& sum() const { return sum_; }

 private:
  DoubleWord<R> sum_;
};

/// A vertex of Z, and the way from there to another one.
template <class N>
struct Edge {
  Vec<N, 2> from;
  Vec<N, 2> way;
};

/// The edge from a to b, from the vertices themselves, in the run's unit, with about twice the
/// digits. Nearly always a and b have the vertex of one shape in common: that comes first, and the
/// way is the other shape's.
template <class R, class S>
[[nodiscard, gnu::noinline]] Edge<DoubleWord<R>> careful_edge(const Query<S, 2>& query,
                                                              const Prepared<R, 2>& prepared,
                                                              VertexPair a, VertexPair b) {
  const auto in_unit = [&](const S& value) {
    return R(ScalarTraits<R>::from(value) * prepared.unit);
  };
  const auto add = [&](CarefulSum<R>& sum, int row, bool of_x, VertexPair pair, R sign) {
    const Shape<S, 2>& shape = of_x ? query.x : query.y;
    const Vec<S, 2>& local = shape.vertices()[of_x ? pair.x : pair.y];
    if (of_x) sign = -sign;
    if (!shape.pose.rotation.turns()) return sum.add(sign * in_unit(local[row]));
    for (int k = 0; k < 2; ++k) {
      sum.add_product(ScalarTraits<R>::from(shape.pose.rotation(row, k)), sign * in_unit(local[k]));
    }
  };
  const bool x_moves = a.y == b.y;
  Edge<DoubleWord<R>> edge;
  for (int row = 0; row < 2; ++row) {
    CarefulSum<R> from(in_unit(query.y.pose.translation[row]));
    from.add(-in_unit(query.x.pose.translation[row]));
    add(from, row, !x_moves, a, R(1));
    add(from, row, x_moves, a, R(1));
    CarefulSum<R> way(R(0));
    if (a.x != b.x && a.y != b.y) {
      add(way, row, !x_moves, b, R(1));
      add(way, row, !x_moves, a, R(-1));
    }
    add(way, row, x_moves, b, R(1));
    add(way, row, x_moves, a, R(-1));
    edge.from[row] = from.sum();
    edge.way[row] = normalised(way.sum());
  }
  return edge;
}
template <class R, class S>
[[nodiscard]] Vec<DoubleWord<R>, 2> careful_vertex(const Query<S, 2>& query,
                                                   const Prepared<R, 2>& prepared,
                                                   VertexPair pair) {
  Vec<DoubleWord<R>, 2> vertex = careful_edge(query, prepared, pair, pair).from;
  for (int row = 0; row < 2; ++row) vertex[row] = normalised(vertex[row]);
  return vertex;
}

/// cross(a, b), rounded.
template <class R>
[[nodiscard]] R rounded_cross(const Vec<Expansion, 2>& a, const Vec<Expansion, 2>& b) {
  return rounded<R>(cross(a, b));
}
/// The same within some 10 u^2 |a| |b| before the last rounding.
template <class R>
[[nodiscard]] R rounded_cross(const Vec<DoubleWord<R>, 2>& a, const Vec<DoubleWord<R>, 2>& b) {
  const DoubleWord<R> left = exact_product(a[0].hi, b[1].hi);
  const DoubleWord<R> right = exact_product(a[1].hi, b[0].hi);
  const R left_rest = left.lo + R(R(a[0].hi * b[1].lo) + R(a[0].lo * b[1].hi));
  const R right_rest = right.lo + R(R(a[1].hi * b[0].lo) + R(a[1].lo * b[0].hi));
  const DoubleWord<R> difference = exact_sum(left.hi, R(-right.hi));
  return difference.hi + R(difference.lo + R(left_rest - right_rest));
}

/// How often `careful_distance` rounds, and its bounds do, at worst: both coordinates of the edge,
/// the determinant, three times in the length, the quotient, and the bound.
inline constexpr int kCarefulRoundings = 6;

/// Distance of O from a vertex of Z, or from the line through an edge, in the run's unit: nothing
/// rounds before the last few operations when N is exact, and little when it is a DoubleWord. The
/// latter is negative when O lies on that side of the edge to which perpendicular(way) points.
template <class R, class N>
[[nodiscard]] R careful_distance(const Vec<N, 2>& vertex) {
  return careful_length(Vec<R, 2>(rounded<R>(vertex[0]), rounded<R>(vertex[1])));
}
template <class R, class N>
[[nodiscard]] R careful_distance(const Edge<N>& edge) {
  return R(rounded_cross<R>(edge.from, edge.way) / careful_distance<R>(edge.way));
}

/// Weights of the vertices of a triangle around O: the areas across from them, as shares of all.
template <class R, class N>
[[nodiscard]] std::array<R, 3> shares_of_area(const std::array<Vec<N, 2>, 3>& w) {
  std::array<R, 3> weights{};
  R sum(0);
  for (int i = 0; i < 3; ++i) {
    weights[i] = magnitude(rounded_cross<R>(w[(i + 1) % 3], w[(i + 2) % 3]));
    sum = sum + weights[i];
  }
  for (R& weight : weights) weight = weight / sum;
  return weights;
}

/// Weights of a simplex around O, with about twice the digits: in a thin one the run's own put P
/// visibly beside O.
template <class R, class S>
void set_careful_weights(Simplex<R, 2>& simplex, const Query<S, 2>& query,
                         const Prepared<R, 2>& prepared) {
  std::array<Vec<DoubleWord<R>, 2>, 3> w;
  for (int i = 0; i < 3; ++i) w[i] = careful_vertex(query, prepared, simplex.vertices[i].pair);
  const std::array<R, 3> weights = shares_of_area<R>(w);
  std::copy(weights.begin(), weights.end(), simplex.weights.begin());
}

}  // namespace gjk::detail
