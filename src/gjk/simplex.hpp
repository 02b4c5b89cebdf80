#pragma once
// The simplex that GJK walks with, and the barycentric coordinates of the origin in it.

#include <array>
#include <cstdint>

#include "gjk/query.hpp"

namespace gjk {

/// A vertex of the Minkowski difference, kept together with the two vertices that made it.
template <class S, int D>
struct SupportPoint {
  Vec<S, D> w = Vec<S, D>::Zero();  ///< y - x
  VertexPair pair = {};
};

/// A set of simplex vertices: bit i stands for vertex i. It names a face of the simplex, and that
/// face's Voronoi region.
using Face = std::uint8_t;

[[nodiscard]] constexpr bool contains(Face face, int vertex) { return ((face >> vertex) & 1) != 0; }
[[nodiscard]] constexpr int vertex_count(Face face) {
  return (face & 1) + ((face >> 1) & 1) + ((face >> 2) & 1) + ((face >> 3) & 1);
}
[[nodiscard]] constexpr Face face_of(int vertex) { return static_cast<Face>(1u << vertex); }

template <class S, int D>
struct Simplex {
  std::array<SupportPoint<S, D>, D + 1> vertices = {};
  std::array<S, D + 1> weights =
      {};  ///< Barycentric coordinates of P; 0 for vertices outside P's face.
  int count = 0;

  [[nodiscard]] Face all() const { return static_cast<Face>((1u << count) - 1); }
};

/// For the next query of the same shapes, somewhat moved.
template <class S, int D>
[[nodiscard]] WarmStart warm_start(const Simplex<S, D>& simplex) {
  WarmStart out;
  out.count = simplex.count;
  for (int i = 0; i < simplex.count; ++i) out.pairs[i] = simplex.vertices[i].pair;
  return out;
}

/// Barycentric coordinates of O's projection onto the affine hull of a face, not yet divided:
/// coordinate i is numerator[i] / denominator, and denominator >= 0. A degenerate face (repeated
/// points, collinear triangle) has denominator 0 and is in no point's favour: all its coordinates
/// count as "not positive".
template <class S, int D>
struct Barycentric {
  std::array<S, D + 1> numerator = {};
  S denominator = S(0);
};

namespace detail {

// Segment: fractional lengths. u = dot(B-Q, B-A) / |B-A|^2, v = dot(Q-A, B-A) / |B-A|^2, with Q = O
// (Catto 2010, slide "(u,v) from Q").
template <class S, int D>
void segment_coordinates(const Simplex<S, D>& simplex, int a, int b, Barycentric<S, D>& out) {
  const Vec<S, D>& point_a = simplex.vertices[a].w;
  const Vec<S, D>& point_b = simplex.vertices[b].w;
  const Vec<S, D> edge = point_b - point_a;
  out.denominator = dot(edge, edge);
  const bool degenerate = !(S(0) < out.denominator);
  out.numerator[a] = degenerate ? S(0) : dot(point_b, edge);
  out.numerator[b] = degenerate ? S(0) : S(-dot(point_a, edge));
}

// Full simplex: fractional volumes (in the plane, areas). u = area(QBC) / area(ABC) and so on, with
// Q = O (Catto 2010, slide "Barycentric coordinates"); area(QBC) = cross(B-Q, C-Q) / 2.
template <class S, int D>
void volume_coordinates(const Simplex<S, D>& simplex, Barycentric<S, D>& out) {
  std::array<Vec<S, D>, D> columns;
  for (int i = 0; i < D; ++i) columns[i] = simplex.vertices[i + 1].w - simplex.vertices[0].w;
  const S volume = determinant<S, D>(columns);
  const bool positive = S(0) < volume;
  const bool negative = volume < S(0);
  out.denominator = negative ? S(-volume) : volume;
  for (int i = 0; i <= D; ++i) {
    for (int j = 0, k = 0; j <= D; ++j) {
      if (j != i) columns[k++] = simplex.vertices[j].w;
    }
    const S part = determinant<S, D>(columns);
    const bool flip = (i % 2 == 1) != negative;
    if (!positive && !negative) {
      out.numerator[i] = S(0);
    } else {
      out.numerator[i] = flip ? S(-part) : part;
    }
  }
}

}  // namespace detail

/// Coordinates of O in `face`, which has at least one vertex.
template <class S, int D>
[[nodiscard]] Barycentric<S, D> barycentric(const Simplex<S, D>& simplex, Face face) {
  Barycentric<S, D> out;
  const int size = vertex_count(face);
  int first = 0;
  while (!contains(face, first)) ++first;
  if (size == 1) {
    out.numerator[first] = S(1);
    out.denominator = S(1);
  } else if (size == 2) {
    int second = first + 1;
    while (!contains(face, second)) ++second;
    detail::segment_coordinates(simplex, first, second, out);
  } else if (size == D + 1) {
    detail::volume_coordinates(simplex, out);
  } else {
    // Between a segment and a full simplex: Johnson's recursion (Gilbert, Johnson, Keerthi 1988),
    // which gives the coordinate of vertex j from those of the face without j.
    for (int j = 0; j < simplex.count; ++j) {
      if (!contains(face, j)) continue;
      const Face rest = static_cast<Face>(face & ~face_of(j));
      const Barycentric<S, D> part = barycentric(simplex, rest);
      int k = 0;
      while (!contains(rest, k)) ++k;
      const Vec<S, D> difference = simplex.vertices[k].w - simplex.vertices[j].w;
      for (int i = 0; i < simplex.count; ++i) {
        if (!contains(rest, i)) continue;
        const S term = part.numerator[i] * dot(simplex.vertices[i].w, difference);
        out.numerator[j] = out.numerator[j] + term;
      }
      out.denominator = out.denominator + out.numerator[j];
    }
  }
  return out;
}

/// The point of `face` with the simplex's weights.
template <class S, int D>
[[nodiscard]] Vec<S, D> weighted_point(const Simplex<S, D>& simplex, Face face) {
  Vec<S, D> point = Vec<S, D>::Zero();
  for (int i = 0; i <= D; ++i) {
    if (!contains(face, i)) continue;
    if (vertex_count(face) == 1) return simplex.vertices[i].w;
    for (int k = 0; k < D; ++k) {
      point[k] = point[k] + S(simplex.weights[i] * simplex.vertices[i].w[k]);
    }
  }
  return point;
}

}  // namespace gjk
