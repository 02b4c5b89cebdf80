#pragma once
// The simplex that GJK walks with, and the barycentric coordinates of the origin in it.

#include <array>
#include <cstdint>

#include "gjk/query.hpp"

namespace gjk {

/// A vertex of the Minkowski difference Z, with the two vertices that made it.
template <class R, int D>
struct SupportPoint {
  Vec<R, D> w = Vec<R, D>::Zero();  ///< y - x, in world axes and the run's unit of length.
  VertexPair pair = {};
};

/// A face of the simplex, and its Voronoi region: bit i is set when vertex i belongs to the face.
using Face = std::uint8_t;

[[nodiscard]] constexpr bool contains(Face face, int vertex) { return ((face >> vertex) & 1) != 0; }
[[nodiscard]] constexpr Face face_of(int vertex) { return static_cast<Face>(1u << vertex); }

/// A list of at most so many vertices, by index, or faces.
template <int kMost>
struct ShortList {
  std::array<std::uint8_t, kMost> entries = {};
  int count = 0;
  [[nodiscard]] constexpr const std::uint8_t* begin() const { return entries.data(); }
  [[nodiscard]] constexpr const std::uint8_t* end() const { return entries.data() + count; }
  [[nodiscard]] constexpr std::uint8_t operator[](int i) const { return entries[i]; }
  constexpr void add(std::uint8_t entry) { entries[count++] = entry; }
};
using FaceVertices = ShortList<kMaxDimension + 1>;  ///< Ascending.
using FaceList = ShortList<(1 << (kMaxDimension + 1)) - 1>;

inline constexpr auto kFaceVertices = [] {
  std::array<FaceVertices, 1 << (kMaxDimension + 1)> out = {};
  for (unsigned face = 0; face < out.size(); ++face) {
    for (std::uint8_t i = 0; i <= kMaxDimension; ++i) {
      if (contains(static_cast<Face>(face), i)) out[face].add(i);
    }
  }
  return out;
}();
[[nodiscard]] constexpr const FaceVertices& vertices_of(Face face) { return kFaceVertices[face]; }
[[nodiscard]] constexpr int vertex_count(Face face) { return vertices_of(face).count; }

template <class R, int D>
struct Simplex {
  static_assert(D == 2 || D == 3, "written out for the plane and for space");
  std::array<SupportPoint<R, D>, D + 1> vertices = {};
  std::array<R, D + 1> weights = {};  ///< Barycentric coordinates of P; 0 outside P's face.
  int count = 0;

  [[nodiscard]] Face all() const { return static_cast<Face>((1u << count) - 1); }

  /// A start from these vertices.
  [[nodiscard]] WarmStart as_start() const {
    WarmStart out;
    out.count = count;
    for (int i = 0; i < count; ++i) out.pairs[i] = vertices[i].pair;
    return out;
  }

  /// Copies the vertices in use, each by itself: processors wait where one wide read follows
  /// several narrow writes.
  void take(const Simplex& other) {
    count = other.count;
    for (int i = 0; i < count; ++i) {
      vertices[i] = other.vertices[i];
      weights[i] = other.weights[i];
    }
  }
};

/// Barycentric coordinates of O's projection onto the affine hull of a face, before the division:
/// coordinate i is numerator[i] / denominator, and denominator >= 0. A degenerate face (repeated
/// points, collinear triangle) has only zeros, so no coordinate counts as positive.
template <class R, int D>
struct Barycentric {
  std::array<R, D + 1> numerator;  ///< 0 for vertices outside the face.
  R denominator;
};

// Segment AB: fractional lengths, with n = B - A and Q = O (Catto 2010, slide "(u,v) from Q"):
//   u = dot(B - Q, n) / dot(n, n)      v = dot(Q - A, n) / dot(n, n)
template <class R, int D>
[[nodiscard]] Barycentric<R, D> segment_coordinates(const Simplex<R, D>& simplex, int a, int b) {
  Barycentric<R, D> out{};
  const Vec<R, D>& point_a = simplex.vertices[a].w;
  const Vec<R, D>& point_b = simplex.vertices[b].w;
  const Vec<R, D> edge = point_b - point_a;
  out.denominator = dot(edge, edge);
  const bool degenerate = !(R(0) < out.denominator);
  out.numerator[a] = degenerate ? R(0) : dot(point_b, edge);
  out.numerator[b] = degenerate ? R(0) : R(-dot(point_a, edge));
  return out;
}

// A full simplex. Triangle ABC in the plane: fractions of signed areas, with Q = O (Catto 2010,
// slide "Barycentric coordinates"); tetrahedron in space: fractions of signed volumes.
//   u = area(Q, B, C) / area(A, B, C)      v = area(Q, C, A) / area(A, B, C)
//   w = area(Q, A, B) / area(A, B, C)      area(Q, B, C) = cross(B - Q, C - Q) / 2
template <class R, int D>
[[nodiscard]] Barycentric<R, D> volume_coordinates(const Simplex<R, D>& simplex) {
  const auto volume_without = [&](int left_out) {  // signed, of O and all vertices but one
    std::array<Vec<R, D>, D> facet;
    for (int j = 0, k = 0; j <= D; ++j) {
      if (j != left_out) facet[k++] = simplex.vertices[j].w;
    }
    const R volume = determinant<R, D>(facet);
    return left_out % 2 == 1 ? R(-volume) : volume;
  };
  std::array<Vec<R, D>, D> edges;
  for (int i = 0; i < D; ++i) edges[i] = simplex.vertices[i + 1].w - simplex.vertices[0].w;
  const R volume = determinant<R, D>(edges);
  Barycentric<R, D> out{};
  if (volume == R(0)) return out;
  out.denominator = magnitude(volume);
  for (int i = 0; i <= D; ++i) {
    const R part = volume_without(i);
    out.numerator[i] = volume < R(0) ? R(-part) : part;
  }
  return out;
}

// Triangle ABC in space: the same areas, with Q = O's projection onto the triangle's plane, signed
// along the normal n = (B - A) x (C - A) (Ericson 2005, "Real-Time Collision Detection", 3.4).
template <class R>
[[nodiscard]] Barycentric<R, 3> triangle_coordinates(const Simplex<R, 3>& simplex, int a, int b,
                                                     int c) {
  const Vec<R, 3>& point_a = simplex.vertices[a].w;
  const Vec<R, 3>& point_b = simplex.vertices[b].w;
  const Vec<R, 3>& point_c = simplex.vertices[c].w;
  const Vec<R, 3> edge_ab = point_b - point_a;
  const Vec<R, 3> edge_ca = point_a - point_c;
  const Vec<R, 3> normal = cross(edge_ca, edge_ab);
  Barycentric<R, 3> out{};
  if (is_zero(normal)) return out;
  out.denominator = dot(normal, normal);
  out.numerator[a] = dot(normal, cross(point_b, Vec<R, 3>(point_c - point_b)));
  out.numerator[b] = dot(normal, cross(point_c, edge_ca));
  out.numerator[c] = dot(normal, cross(point_a, edge_ab));
  return out;
}

/// Coordinates of O in `face`, which must have a vertex.
template <class R, int D>
[[nodiscard]] Barycentric<R, D> barycentric(const Simplex<R, D>& simplex, Face face) {
  const FaceVertices& vertex = vertices_of(face);
  if (vertex.count == 2) return segment_coordinates(simplex, vertex[0], vertex[1]);
  if (vertex.count == D + 1) return volume_coordinates(simplex);
  if constexpr (D == 3) {
    if (vertex.count == 3) return triangle_coordinates(simplex, vertex[0], vertex[1], vertex[2]);
  }
  Barycentric<R, D> point{};
  point.numerator[vertex[0]] = R(1);
  point.denominator = R(1);
  return point;
}

/// A normal of a facet (an edge in the plane, a triangle in space), as `perpendicular` makes it.
template <class R, int D>
[[nodiscard]] Vec<R, D> normal_of(const Simplex<R, D>& simplex, Face facet) {
  const FaceVertices& vertex = vertices_of(facet);
  std::array<Vec<R, D>, D - 1> edges;
  for (int i = 1; i < D; ++i) {
    edges[i - 1] = simplex.vertices[vertex[i]].w - simplex.vertices[vertex[0]].w;
  }
  return perpendicular<R, D>(edges);
}

/// Sets the weights of P in `face` from its coordinates. A segment divides by its squared length,
/// as the slides do; a larger face by the sum of the numerators, so that the weights add up to 1.
template <class R, int D>
void set_weights(std::array<R, D + 1>& weights, Face face, const Barycentric<R, D>& coordinates) {
  const FaceVertices& in_face = vertices_of(face);
  weights.fill(R(0));
  if (in_face.count == 1) {
    weights[in_face[0]] = R(1);
    return;
  }
  R divisor = coordinates.denominator;
  if (in_face.count > 2) {
    divisor = R(0);
    for (const int i : in_face) divisor = divisor + coordinates.numerator[i];
  }
  for (const int i : in_face) weights[i] = coordinates.numerator[i] / divisor;
}

/// The sum of the vertices of `face`, each times its weight.
template <class R, int D>
[[nodiscard]] Vec<R, D> weighted_point(const Simplex<R, D>& simplex, Face face,
                                       const std::array<R, D + 1>& weights) {
  const FaceVertices& in_face = vertices_of(face);
  if (in_face.count == 1) return simplex.vertices[in_face[0]].w;
  Vec<R, D> point = Vec<R, D>::Zero();
  for (const int i : in_face) {
    for (int k = 0; k < D; ++k) point[k] = point[k] + R(weights[i] * simplex.vertices[i].w[k]);
  }
  return point;
}

}  // namespace gjk
