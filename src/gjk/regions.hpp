#pragma once
// Phases "closest" and "drop": find the closest point P of the simplex to O, and keep P's face.
//
// P lies in the face whose Voronoi region holds O. The sign of O's coordinate i in a face tells
// whether O lies on the same side of the other vertices as vertex i, so the signs tell the region
// (Catto 2010, slides "Voronoi regions" to "Closest point on a triangle"; in any dimension this is
// Johnson's condition, Gilbert, Johnson, Keerthi 1988):
//
//   O is in the region of face F when all its coordinates in F are positive and, for each vertex i
//   outside F, coordinate i in F + {i} is not positive.
//
// Written out, with u, v, w for the coordinates of the first, second, third vertex of a face:
//
//   segment AB     B: u <= 0        A: v <= 0        AB: u > 0 and v > 0
//
//   triangle ABC   A:  vAB <= 0 and uCA <= 0
//                  B:  uAB <= 0 and vBC <= 0
//                  C:  uBC <= 0 and vCA <= 0
//                  AB: uAB > 0 and vAB > 0 and wABC <= 0
//                  BC: uBC > 0 and vBC > 0 and uABC <= 0
//                  CA: uCA > 0 and vCA > 0 and vABC <= 0
//                  ABC: uABC > 0 and vABC > 0 and wABC > 0
//
// The code has no order CA: that face is vertices 0 and 2, and uCA is the coordinate of vertex 2.

#include "gjk/proof/nearest_face.hpp"
#include "gjk/record.hpp"

namespace gjk {

/// The order of the tests for simplices of 1 to 4 vertices. The slides test a segment's B first.
inline constexpr std::array<FaceList, kMaxDimension + 1> kVerticesFirst = {
    {{{0b1}, 1},
     {{0b10, 0b01, 0b11}, 3},
     {{0b001, 0b010, 0b100, 0b011, 0b110, 0b101, 0b111}, 7},
     {{0b0001, 0b0010, 0b0100, 0b1000, 0b0011, 0b0101, 0b0110, 0b1001, 0b1010, 0b1100, 0b0111,
       0b1011, 0b1101, 0b1110, 0b1111},
      15}}};
[[nodiscard]] constexpr FaceList tested_faces(int vertices, RegionOrder order) {
  const FaceList& vertices_first = kVerticesFirst[vertices - 1];
  if (order != RegionOrder::edges_first) return vertices_first;
  FaceList edges_first;
  for (const bool edges : {true, false}) {
    for (const Face face : vertices_first) {
      if ((vertex_count(face) == 2) == edges) edges_first.add(face);
    }
  }
  return edges_first;
}

/// The coordinates of O in every face of a simplex of kCount vertices.
template <class R, int D, int kCount>
struct Coordinates {
  static constexpr Face kAll = (1 << kCount) - 1;
  std::array<Barycentric<R, D>, kAll + 1> of_face;

  explicit Coordinates(const Simplex<R, D>& simplex)
      : of_face([&]<std::size_t... before>(std::index_sequence<before...>) {
          return std::array{Barycentric<R, D>{}, barycentric(simplex, Face{before + 1})...};
        }(std::make_index_sequence<kAll>())) {}

  /// Coordinate i in F + {i} for a region F: in F itself when i is one of its vertices.
  [[nodiscard]] const R& numerator(Face region, int i) const {
    return of_face[region | face_of(i)].numerator[i];
  }
  /// Johnson's condition.
  [[nodiscard]] bool holds(Face region) const {
    for (int i = 0; i < kCount; ++i) {
      if ((R(0) < numerator(region, i)) != contains(region, i)) return false;
    }
    return true;
  }
};

/// The record of one region's test: what must be positive, then what must not.
template <class R, int D, int kCount>
[[nodiscard]] RegionTest<R> region_test(Face region, const Coordinates<R, D, kCount>& coordinates) {
  RegionTest<R> note{region, {}, coordinates.holds(region)};
  for (const bool wants_positive : {true, false}) {
    for (int i = 0; i < kCount; ++i) {
      const Face face = static_cast<Face>(region | face_of(i));
      const bool is_vertex = face == face_of(i);  // its own coordinate is 1
      if (is_vertex || contains(region, i) != wants_positive) continue;
      const R& numerator = coordinates.numerator(region, i);
      note.terms.push_back({face, i, wants_positive, numerator,
                            coordinates.of_face[face].denominator,
                            (R(0) < numerator) == wants_positive});
    }
  }
  return note;
}

/// The squared distance of O from the line or plane through `face`, which has 2 to D vertices.
/// Unlike |P|^2 it needs no weights. In the plane it is exactly 0 when O lies on the line.
template <class R, int D>
[[nodiscard]] R distance_sq(const Simplex<R, D>& simplex, Face face) {
  const FaceVertices& in_face = vertices_of(face);
  const Vec<R, D>& a = simplex.vertices[in_face[0]].w;
  const Vec<R, D>& b = simplex.vertices[in_face[1]].w;
  if constexpr (D == 3) {
    if (in_face.count == 2) {
      const Vec<R, D> edge = b - a;
      const Vec<R, D> moment = cross(edge, a);
      return dot(moment, moment) / dot(edge, edge);
    }
  }
  const Vec<R, D> normal = normal_of(simplex, face);
  R side(0);  // dot(normal, a); in the plane without the rounding of the edge
  if constexpr (D == 2)
    side = cross(a, b);
  else
    side = dot(normal, a);
  return side * R(side / dot(normal, normal));
}

/// Sets P, its weights and its squared length from O's coordinates in `face`. When O lies in the
/// face, P is O itself, because the weighted sum would round. With DirectionRule::perpendicular the
/// squared length is `distance_sq`, which rounds less.
template <class R, int D>
void take_region(State<R, D>& state, Face face, const Barycentric<R, D>& coordinates,
                 DirectionRule rule) {
  const int size = vertex_count(face);
  state.region = face;
  set_weights(state.simplex.weights, face, coordinates);
  const bool has_line = 1 < size && size <= D && R(0) < coordinates.denominator;
  const R from_line_sq = has_line ? distance_sq(state.simplex, face) : R(1);
  const bool at_origin = size == D + 1 || from_line_sq == R(0);
  state.p = at_origin ? Vec<R, D>(Vec<R, D>::Zero())
                      : weighted_point(state.simplex, face, state.simplex.weights);
  state.p_sq = dot(state.p, state.p);
  if (has_line && !ScalarTraits<R>::kExact && rule == DirectionRule::perpendicular) {
    state.p_sq = from_line_sq;
  }
}

/// Takes the first region whose condition holds. If none does, or if only rounding may put O inside
/// a full simplex, takes `nearest_face`; RegionOrder::unchecked takes the whole simplex instead.
template <int kCount, RegionOrder order, class R, int D, class Rec>
void find_region(State<R, D>& state, DirectionRule rule, Rec& record) {
  static constexpr FaceList kFaces = tested_faces(kCount, order);
  const Coordinates<R, D, kCount> coordinates(state.simplex);
  Face found = 0;
  Barycentric<R, D> of_found{};
  const auto test = [&](Face face) {
    if constexpr (Rec::kOn) record.region_tests.push_back(region_test(face, coordinates));
    if (!coordinates.holds(face)) return false;
    found = face;
    of_found = coordinates.of_face[face];
    return true;
  };
  // One by one and not in a loop, so that compilers see which coordinates each test asks for.
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    static_cast<void>((test(kFaces.entries[i]) || ...));
  }
  (std::make_index_sequence<kFaces.count>());
  constexpr bool kChecked = order != RegionOrder::unchecked;
  if (kChecked && kCount == D + 1 && found == state.simplex.all() &&
      !weights_reach_origin(state.simplex, of_found)) {
    found = 0;
  }
  if (found == 0) [[unlikely]] {
    found = kChecked ? nearest_face(state.simplex) : state.simplex.all();
    of_found = barycentric(state.simplex, found);
    if constexpr (Rec::kOn) record.no_region_held = kChecked && vertex_count(found) != D + 1;
  }
  take_region(state, found, of_found, rule);
}

template <RegionOrder order, class R, int D, class Rec>
void find_region(State<R, D>& state, DirectionRule rule, Rec& record) {
  const int count = state.simplex.count;
  if (count == 1) return find_region<1, order>(state, rule, record);
  if (count == 2) return find_region<2, order>(state, rule, record);
  if (count == 3) return find_region<3, order>(state, rule, record);
  if constexpr (D == 3) find_region<4, order>(state, rule, record);
}
/// The two other orders; out of line, so that the usual one is short.
template <class R, int D, class Rec>
[[gnu::noinline]] void find_region_otherwise(State<R, D>& state, const Options& options,
                                             Rec& record) {
  if (options.region_order == RegionOrder::edges_first)
    find_region<RegionOrder::edges_first>(state, options.direction_rule, record);
  else
    find_region<RegionOrder::unchecked>(state, options.direction_rule, record);
}

template <class R, int D, class Rec>
void find_closest_point(State<R, D>& state, const Options& options, Rec& record) {
  if (options.region_order == RegionOrder::vertices_first) [[likely]]
    find_region<RegionOrder::vertices_first>(state, options.direction_rule, record);
  else
    find_region_otherwise(state, options, record);
  state.previous = Phase::closest;
  state.phase = Phase::drop;
}

template <class R, int D, class Rec>
void drop(State<R, D>& state, const Options& options, Rec& record) {
  Simplex<R, D>& simplex = state.simplex;
  if constexpr (Rec::kOn) {
    for (int i = 0; i < simplex.count; ++i) {
      if (!contains(state.region, i)) record.dropped.push_back(simplex.vertices[i]);
    }
  }
  int kept = 0;
  for (const int i : vertices_of(state.region)) {
    simplex.vertices[kept] = simplex.vertices[i];
    simplex.weights[kept] = simplex.weights[i];
    ++kept;
  }
  simplex.count = kept;
  state.region = simplex.all();

  const bool nearer = state.evidence.is_nearer(state.p_sq);
  if (nearer) {
    state.evidence.best.take(simplex);
    state.evidence.best_sq = state.p_sq;
  }
  const bool answered = kept == D + 1 || (!nearer && options.stop_on_no_progress);
  state.previous = Phase::drop;
  state.phase = answered ? Phase::stop : Phase::direction;
}

}  // namespace gjk
