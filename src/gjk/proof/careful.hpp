#pragma once
// Vertices, distances and weights with about twice the digits of the run, or exact, for cases where
// its own digits are too few.

#include <array>
#include <type_traits>

#include "gjk/proof/prepare.hpp"
#include "gjk/simplex.hpp"

namespace gjk {

namespace detail {
template <class R, class S, int D>
[[nodiscard]] Simplex<DoubleWord<R>, D> in_words(const Simplex<R, D>& simplex,
                                                 const Query<S, D>& query,
                                                 const Prepared<R, D>& prepared) {
  const auto turned = [&](const Shape<S, D>& shape, int i) {
    return careful_point<R, S, D>(shape, converted<R, S, D>(shape.vertices()[i]), prepared);
  };
  const Vec<DoubleWord<R>, D> offset = offset_of_origins<R, S, D>(query, prepared);
  Simplex<DoubleWord<R>, D> out;
  out.count = simplex.count;
  for (int i = 0; i < simplex.count; ++i) {
    const VertexPair pair = simplex.vertices[i].pair;
    out.vertices[i] = {(turned(query.y, pair.y) - turned(query.x, pair.x)) + offset, pair};
  }
  return out;
}
/// With all calls inlined, so that compilers split each number into halves once.
template <class R, class S, int D>
[[nodiscard, gnu::noinline, gnu::flatten]] Simplex<DoubleWord<R>, D> in_words_in_one(
    const Simplex<R, D>& simplex, const Query<S, D>& query, const Prepared<R, D>& prepared) {
  return in_words(simplex, query, prepared);
}
}  // namespace detail

/// The simplex with its vertices of Z computed anew from the given ones, in the run's unit.
template <class R, class S, int D>
[[nodiscard]] Simplex<DoubleWord<R>, D> careful_simplex(const Simplex<R, D>& simplex,
                                                        const Query<S, D>& query,
                                                        const Prepared<R, D>& prepared) {
  if constexpr (std::is_floating_point_v<R>)
    return detail::in_words_in_one(simplex, query, prepared);
  else
    return detail::in_words(simplex, query, prepared);
}

/// How often a bound of Foot::distance rounds to R, at worst, apart from the vertices: twice in a
/// coordinate of the normal, in the product, the length of the normal, the quotient, the bound.
inline constexpr int kCarefulRoundings = 6;

/// The foot of the perpendicular from O to the line or plane through a face, or a lone vertex.
template <class R, int D>
struct Foot {
  R distance = R(0);
  Vec<R, D> d = Vec<R, D>::Zero();  ///< From the foot to O, of any length; see search_direction.
  R longest = R(0);                 ///< The longer of two edges; the one edge; 0 for a vertex.
  /// Height of the triangle over its longest edge. For an edge: its length. For a vertex: its
  /// distance from O. When vertices move by e, the foot moves within the face by at most e, and d
  /// turns by at most 2 e / height.
  R height = R(0);
};

/// The foot on a simplex of 1 to D vertices in N, which is R or has more digits. Products are made
/// with the vertex `nearest`: they round least when it is the nearest to O.
template <class R, class N, int D>
[[nodiscard]] Foot<R, D> foot_of(const Simplex<N, D>& simplex, int nearest = 0) {
  Foot<R, D> out;
  const Vec<N, D>& a = simplex.vertices[nearest].w;
  if (simplex.count == 1) {
    out.d = converted<R, N, D>(-a);
    out.distance = careful_length(out.d);
    out.height = out.distance;
    return out;
  }
  const Vec<N, D> edge = simplex.vertices[1].w - simplex.vertices[0].w;
  out.longest = careful_length(converted<R, N, D>(edge));
  out.height = out.longest;
  if constexpr (D == 3) {
    if (simplex.count == 2) {
      const Vec<N, D> moment = cross(edge, a);
      out.d = converted<R, N, D>(cross(edge, moment));
      out.distance = careful_length(converted<R, N, D>(moment)) / out.longest;
      return out;
    }
  }
  const Vec<N, D> normal = normal_of(simplex, simplex.all());
  const R side = ScalarTraits<R>::from(dot(normal, a));
  const R size = careful_length(converted<R, N, D>(normal));
  out.d = converted<R, N, D>(side < R(0) ? normal : Vec<N, D>(-normal));
  out.distance = magnitude(side) / size;
  if constexpr (D == 3) {
    const Vec<N, D> other = simplex.vertices[2].w - simplex.vertices[0].w;
    out.longest = larger(out.longest, careful_length(converted<R, N, D>(other)));
    out.height = size / out.longest;
  }
  return out;
}

/// Weights of O's projection in a simplex in N, negative ones set to 0 so that they make a point of
/// the simplex. They add up to 1; for a degenerate simplex they are NaNs.
template <class R, class N, int D>
[[nodiscard, gnu::noinline]] std::array<R, D + 1> weights_of(const Simplex<N, D>& simplex) {
  const Barycentric<N, D> coordinates = barycentric(simplex, simplex.all());
  std::array<R, D + 1> weights{};
  R sum(0);
  for (int i = 0; i < simplex.count; ++i) {
    weights[i] = larger(ScalarTraits<R>::from(coordinates.numerator[i]), R(0));
    sum = sum + weights[i];
  }
  for (R& weight : weights) weight = weight / sum;
  return weights;
}

/// The same in a triangle whose plane holds O, up to rounding. The triangles of O and two vertices
/// have areas, as vectors, along its normal: these have all digits once they are rounded.
template <class R>
[[nodiscard, gnu::noinline]] std::array<R, 4> weights_in_plane(
    const Simplex<DoubleWord<R>, 3>& triangle) {
  using Word = DoubleWord<R>;
  Vec<Word, 3> normal = Vec<Word, 3>::Zero();
  std::array<Vec<R, 3>, 3> areas;
  for (int i = 0; i < 3; ++i) {
    const Vec<Word, 3> area =
        cross(triangle.vertices[(i + 1) % 3].w, triangle.vertices[(i + 2) % 3].w);
    normal = normal + area;
    areas[i] = converted<R, Word, 3>(area);
  }
  std::array<R, 4> weights{};
  R sum(0);
  for (int i = 0; i < 3; ++i) {
    weights[i] = larger(dot(converted<R, Word, 3>(normal), areas[i]), R(0));
    sum = sum + weights[i];
  }
  for (R& weight : weights) weight = weight / sum;
  return weights;
}

}  // namespace gjk
