#pragma once
// Witness points: the points of X and Y nearest to each other (Catto 2010, slide "Witness points").

#include <algorithm>

#include "gjk/proof/careful.hpp"
#include "gjk/proof/result.hpp"

namespace gjk {

/// True when the weights put P at O, up to about one rounding.
template <class R, int D>
[[nodiscard]] bool is_at_origin(const Simplex<R, D>& simplex) {
  const R rounding = R(2) * ScalarTraits<R>::unit_roundoff() * largest_coordinate(simplex);
  return !(rounding < norm_max(weighted_point(simplex, simplex.all(), simplex.weights)));
}

/// The point from + beyond of a shape's frame in the world, computed with about twice the digits:
/// far from the frame's origin a rotation can round by more than the size of Z.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Vec<R, D> careful_world_point(const Pose<S, D>& pose,
                                                           const Vec<R, D>& from,
                                                           const Vec<R, D>& beyond, int exponent) {
  using Word = DoubleWord<R>;
  const R unit = ScalarTraits<R>::scaled(R(1), std::min(-exponent, 0));  // 1 if small
  Vec<Word, D> local;
  for (int k = 0; k < D; ++k) local[k] = exact_sum(R(from[k] * unit), R(beyond[k] * unit));
  const Vec<Word, D> turned = pose.template rotated<Word>(local);
  Vec<R, D> world;
  for (int row = 0; row < D; ++row) {
    const Word place = ScalarTraits<R>::from(pose.translation[row]) * unit;
    world[row] = ScalarTraits<R>::scaled((turned[row] + place).hi, std::max(exponent, 0));
  }
  return world;
}

/// True when all pairs of the simplex have the same vertex of `shape`.
template <class R, int D>
[[nodiscard]] bool has_one_vertex_of(int VertexPair::*shape, const Simplex<R, D>& simplex) {
  return std::all_of(simplex.vertices.begin() + 1, simplex.vertices.begin() + simplex.count,
                     [&](const SupportPoint<R, D>& vertex) {
                       return vertex.pair.*shape == simplex.vertices[0].pair.*shape;
                     });
}

/// The weighted point of one shape, in the world. It is the vertex of the largest weight plus a
/// weighted sum of differences, so that little rounds but the last addition.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> witness_point(const Simplex<R, D>& simplex, const Shape<S, D>& shape,
                                      int VertexPair::*index, const Prepared<R, D>& prepared) {
  using W = RunScalar<Default, R>;
  int base = 0;
  for (int i = 1; i < simplex.count; ++i) {
    if (simplex.weights[base] < simplex.weights[i]) base = i;
  }
  const auto vertex = [&](int i) -> decltype(auto) {
    return converted<W, S, D>(shape.vertices()[simplex.vertices[i].pair.*index]);
  };
  const auto& from = vertex(base);
  Vec<W, D> beyond = Vec<W, D>::Zero();
  for (int i = 0; i < simplex.count; ++i) {
    if (i == base) continue;
    const W weight = ScalarTraits<W>::from(simplex.weights[i]);
    beyond = beyond + Vec<W, D>((vertex(i) - from) * weight);
  }
  if constexpr (std::is_same_v<W, R> && !ScalarTraits<R>::kExact) {
    if (shape.pose.rotation.turns() && prepared.centred) {
      return careful_world_point<R>(shape.pose, from, beyond, prepared.exponent);
    }
  }
  const Vec<W, D> local = from + beyond;
  const Vec<W, D> world =
      shape.pose.template rotated<W>(local) + converted<W, S, D>(shape.pose.translation);
  return converted<R, W, D>(world);
}

/// Sets both witness points, in the world. When shapes meet, both are one point, and rounding must
/// not set them apart: it is their midpoint, or the one that is a vertex.
template <class R, class S, int D>
void set_witness_points(Result<R, D>& out, const Query<S, D>& query,
                        const Prepared<R, D>& prepared) {
  const Simplex<R, D>& simplex = out.simplex;
  out.x = witness_point(simplex, query.x, &VertexPair::x, prepared);
  out.y = witness_point(simplex, query.y, &VertexPair::y, prepared);
  if constexpr (!ScalarTraits<R>::kExact) {
    if (out.verdict != Verdict::overlapping && out.verdict != Verdict::touching) return;
    if (has_one_vertex_of(&VertexPair::y, simplex)) {
      out.x = out.y;
    } else if (!has_one_vertex_of(&VertexPair::x, simplex)) {
      out.x = out.x + Vec<R, D>((out.y - out.x) * ScalarTraits<R>::from(0.5));
    }
    out.y = out.x;
  }
}

}  // namespace gjk
