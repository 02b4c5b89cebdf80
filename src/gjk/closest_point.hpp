#pragma once
// Phases "closest" and "cull": the closest point P of a simplex to O by ordered region tests, and
// what it leaves over.

#include <algorithm>
#include <utility>

#include "gjk/support.hpp"

namespace gjk::detail {

inline constexpr int kMaxRegions = (1 << (kMaxDimension + 1)) - 1;

/// A set of barycentric coordinates: bit 4 * face + vertex stands for that of `vertex` in `face`.
using CoordinateSet = std::uint64_t;
[[nodiscard]] constexpr CoordinateSet coordinate_bit(Face face, int vertex) {
  return CoordinateSet{1} << (4 * face + vertex);
}

/// What puts O into the Voronoi region of `face`: its coordinates within the face are positive, and
/// the coordinate of every other vertex, in the face grown by that vertex, is not (Johnson's
/// condition). For a triangle these are the slides' tests: region A if vAB <= 0 and uCA <= 0;
/// region AB if uAB > 0, vAB > 0 and wABC <= 0; else ABC.
struct RegionCondition {
  Face face = 0;
  CoordinateSet positive = 0;
  CoordinateSet not_positive = 0;

  [[nodiscard]] constexpr bool holds(CoordinateSet positive_ones) const {
    return (positive_ones & (positive | not_positive)) == positive;
  }
};

/// The faces of a simplex of `count` vertices in the order in which their regions are tested.
struct RegionList {
  std::array<RegionCondition, kMaxRegions> conditions = {};
  int count = 0;

  constexpr void add(Face face, int vertices) {
    RegionCondition& condition = conditions[count++];
    condition.face = face;
    for (int i = 0; i < vertices; ++i) {
      const Face grown = static_cast<Face>(face | face_of(i));
      if (!contains(face, i)) {
        condition.not_positive |= coordinate_bit(grown, i);
      } else if (vertex_count(face) > 1) {  // a point's own coordinate is 1
        condition.positive |= coordinate_bit(face, i);
      }
    }
  }
};
[[nodiscard]] constexpr RegionList list_regions(int vertices, RegionOrder order) {
  // Segment: the slides test u <= 0 (region B) before v <= 0 (region A). Triangle: A, B, C, AB, BC,
  // CA, ABC.
  constexpr std::array<Face, 3> kSegment = {0b10, 0b01, 0b11};
  constexpr std::array<Face, 7> kTriangle = {0b001, 0b010, 0b100, 0b011, 0b110, 0b101, 0b111};
  RegionList sorted;
  if (vertices == 2) {
    for (const Face face : kSegment) sorted.add(face, vertices);
  } else if (vertices == 3) {
    for (const Face face : kTriangle) sorted.add(face, vertices);
  } else {
    for (int size = 1; size <= vertices; ++size) {
      for (int face = 1; face < (1 << vertices); ++face) {
        if (vertex_count(static_cast<Face>(face)) == size)
          sorted.add(static_cast<Face>(face), vertices);
      }
    }
  }
  if (order != RegionOrder::edges_first) return sorted;
  RegionList reordered;
  for (const bool edges : {true, false}) {
    for (int i = 0; i < sorted.count; ++i) {
      const Face face = sorted.conditions[i].face;
      if ((vertex_count(face) == 2) == edges) reordered.add(face, vertices);
    }
  }
  return reordered;
}

/// Barycentric coordinates of every face of more than one vertex, of a simplex of kCount vertices.
template <class S, int D, int kCount>
class CoordinateTable {
 public:
  explicit CoordinateTable(const Simplex<S, D>& simplex) {
    for (int b = 1; b < kCount; ++b) {
      for (int a = 0; a < b; ++a) {
        const Face face = static_cast<Face>(face_of(a) | face_of(b));
        segment_coordinates(simplex, a, b, of_face_[face]);
        note_signs(face);
      }
    }
    if constexpr (D > 2 && kCount > 2) {
      for (Face face = 0; face <= simplex.all(); ++face) {
        if (vertex_count(face) > 2 && vertex_count(face) <= D) {
          of_face_[face] = barycentric(simplex, face);
          note_signs(face);
        }
      }
    }
    if constexpr (kCount == D + 1) {
      volume_coordinates(simplex, of_face_[kAll]);
      note_signs(kAll);
    }
  }

  [[nodiscard]] const Barycentric<S, D>& operator[](Face face) const { return of_face_[face]; }
  [[nodiscard]] CoordinateSet positive() const { return positive_; }

 private:
  static constexpr Face kAll = static_cast<Face>((1u << kCount) - 1);

  void note_signs(Face face) {
    for (int i = 0; i < kCount; ++i) {
      if (!contains(face, i)) continue;
      const bool positive = S(0) < of_face_[face].numerator[i];
      positive_ |= CoordinateSet{positive} << (4 * face + i);
    }
  }

  std::array<Barycentric<S, D>, (1u << kCount)> of_face_;
  CoordinateSet positive_ = 0;
};

template <class S, int D, int kCount>
[[nodiscard]] RegionTest<S> noted(const RegionCondition& condition,
                                  const CoordinateTable<S, D, kCount>& table) {
  RegionTest<S> note{condition.face, {}, condition.holds(table.positive())};
  for (const bool wants_positive : {true, false}) {
    const CoordinateSet wanted = wants_positive ? condition.positive : condition.not_positive;
    for (int i = 0; i < kCount; ++i) {
      const Face face = static_cast<Face>(condition.face | face_of(i));
      if ((wanted & coordinate_bit(face, i)) == 0) continue;
      const Barycentric<S, D>& coordinates = table[face];
      const bool positive = S(0) < coordinates.numerator[i];
      note.terms.push_back({face, i, wants_positive, coordinates.numerator[i],
                            coordinates.denominator, positive == wants_positive});
    }
  }
  return note;
}

/// Weights of `face` from its coordinates: segments divide by the squared length as the slides do,
/// larger faces by the sum, so that weights add up to 1.
template <class S, int D>
void set_weights(Simplex<S, D>& simplex, Face face, const Barycentric<S, D>& coordinates) {
  S divisor = coordinates.denominator;
  if (vertex_count(face) > 2) {
    divisor = S(0);
    for (int i = 0; i <= D; ++i) {
      if (contains(face, i)) divisor = divisor + coordinates.numerator[i];
    }
  }
  for (int i = 0; i <= D; ++i) {
    if (!contains(face, i)) {
      simplex.weights[i] = S(0);
    } else if (vertex_count(face) == 1) {
      simplex.weights[i] = S(1);
    } else {
      simplex.weights[i] = coordinates.numerator[i] / divisor;
    }
  }
}

/// When rounding left no test to believe: the nearest point over all faces whose coordinates are
/// positive. Vertices always qualify, so there is one.
template <class S, int D, int kCount>
[[nodiscard]] Face nearest_face(Simplex<S, D> simplex, const CoordinateTable<S, D, kCount>& table) {
  Face best = 0;
  S best_sq(0);
  for (Face face = 1; face <= simplex.all(); ++face) {
    bool inside = vertex_count(face) == 1 || S(0) < table[face].denominator;
    for (int i = 0; i < kCount; ++i) {
      if (contains(face, i) && vertex_count(face) > 1 && !(S(0) < table[face].numerator[i]))
        inside = false;
    }
    if (!inside) continue;
    set_weights(simplex, face, table[face]);
    const Vec<S, D> point = weighted_point(simplex, face);
    const S point_sq = dot(point, point);
    if (best == 0 || point_sq < best_sq) {
      best = face;
      best_sq = point_sq;
    }
  }
  return best;
}

/// The weights of a full simplex around O put P at O up to rounding. Where they do not, the simplex
/// is so thin that its volumes, and their signs, may be rounding errors.
template <class S, int D>
[[nodiscard]] bool weights_reach_origin(Simplex<S, D> simplex,
                                        const Barycentric<S, D>& coordinates) {
  if constexpr (ScalarTraits<S>::kExact) {
    return true;
  } else {
    set_weights(simplex, simplex.all(), coordinates);
    S size(0);
    for (int i = 0; i <= D; ++i) size = std::max(size, norm_max(simplex.vertices[i].w));
    const S rounding = S(4 * D + 4) * ScalarTraits<S>::unit_roundoff() * size;
    return !(rounding < norm_max(weighted_point(simplex, simplex.all())));
  }
}

template <class S, int D>
[[nodiscard]] std::array<Vec<S, D>, D> vertices_of(const Simplex<S, D>& simplex, Face facet) {
  std::array<Vec<S, D>, D> vertices;
  for (int i = 0, k = 0; i <= D && k < D; ++i) {
    if (contains(facet, i)) vertices[k++] = simplex.vertices[i].w;
  }
  return vertices;
}

/// |P|^2 of P on a facet that O does not lie on: from the facet's plane, for which, as for its
/// normal, nobody needs P.
template <class S, int D>
[[nodiscard]] S facet_distance_sq(const Simplex<S, D>& simplex, Face facet, const S& volume) {
  const std::array<Vec<S, D>, D> vertices = vertices_of(simplex, facet);
  std::array<Vec<S, D>, D - 1> edges;
  for (int i = 0; i < D - 1; ++i) edges[i] = vertices[i + 1] - vertices[0];
  const Vec<S, D> normal = perpendicular<S, D>(edges);
  return volume * S(volume / dot(normal, normal));
}

/// P on `face`, by its coordinates.
template <class S, int D>
void take_region(State<S, D>& state, Face face, const Barycentric<S, D>& coordinates,
                 DirectionRule rule) {
  const int size = vertex_count(face);
  state.region = face;
  set_weights(state.simplex, face, coordinates);
  // Where O lies in the face P is O itself; the weighted sum would only say so up to rounding.
  S volume(0);  // that O spans with a facet
  if (size == D) volume = determinant<S, D>(vertices_of(state.simplex, face));
  const bool at_origin = size == D + 1 || (size == D && volume == S(0));
  state.p = at_origin ? Vec<S, D>(Vec<S, D>::Zero()) : weighted_point(state.simplex, face);
  state.p_sq = dot(state.p, state.p);
  if constexpr (!ScalarTraits<S>::kExact) {
    if (size == D && !at_origin && rule == DirectionRule::perpendicular) {
      state.p_sq = facet_distance_sq(state.simplex, face, volume);
    }
  }
}

/// Takes the first region whose condition holds. The compiler makes the list of conditions, and
/// straight code from it.
template <int kCount, RegionOrder kOrder, class S, int D, class Rec>
void find_region(State<S, D>& state, DirectionRule rule, Rec& record) {
  const Simplex<S, D>& simplex = state.simplex;
  const CoordinateTable<S, D, kCount> table(simplex);
  static constexpr RegionList kList = list_regions(kCount, kOrder);
  constexpr bool kChecked = kOrder != RegionOrder::unchecked;
  const auto taken = [&](const RegionCondition& condition) {
    if constexpr (Rec::kOn) record.region_tests.push_back(noted(condition, table));
    if (!condition.holds(table.positive())) return false;
    const bool doubtful = kChecked && vertex_count(condition.face) == D + 1;
    if (doubtful && !weights_reach_origin(simplex, table[condition.face])) return false;
    take_region(state, condition.face, table[condition.face], rule);
    return true;
  };
  const bool found = [&]<int... I>(std::integer_sequence<int, I...>) {
    return (... || taken(std::integral_constant<RegionCondition, kList.conditions[I]>::value));
  }
  (std::make_integer_sequence<int, kList.count>{});
  if (found) return;
  const Face nearest = kChecked ? nearest_face(simplex, table) : simplex.all();
  if constexpr (Rec::kOn) {
    const bool full_is_nearest = nearest == simplex.all() && vertex_count(nearest) == D + 1;
    record.no_region_held = kChecked && !full_is_nearest;
  }
  take_region(state, nearest, table[nearest], rule);
}

template <int kCount, class S, int D, class Rec>
void find_closest_point_of(State<S, D>& state, const Options& options, Rec& record) {
  switch (options.region_order) {
    case RegionOrder::vertices_first:
      return find_region<kCount, RegionOrder::vertices_first>(state, options.direction_rule,
                                                              record);
    case RegionOrder::edges_first:
      return find_region<kCount, RegionOrder::edges_first>(state, options.direction_rule, record);
    case RegionOrder::unchecked:
      return find_region<kCount, RegionOrder::unchecked>(state, options.direction_rule, record);
  }
}

template <class S, int D, class Rec>
void find_closest_point(State<S, D>& state, const Options& options, Rec& record) {
  switch (state.simplex.count) {
    case 1:
      find_closest_point_of<1>(state, options, record);
      break;
    case 2:
      find_closest_point_of<2>(state, options, record);
      break;
    case 3:
      find_closest_point_of<3>(state, options, record);
      break;
    default:
      if constexpr (D > 2) find_closest_point_of<4>(state, options, record);
      break;
  }
  state.previous = Phase::closest;
  state.phase = Phase::cull;
}

/// Has P come nearer to O than ever before? In exact arithmetic it always does, until it is there.
template <class S, int D>
[[nodiscard]] bool came_nearer(const State<S, D>& state) {
  if (state.best.count == 0) return true;
  if constexpr (ScalarTraits<S>::kExact) return S(0) < state.best_sq;
  return state.p_sq < state.best_sq;
}

template <class S, int D, class Rec>
void cull(State<S, D>& state, const Options& options, Rec& record) {
  Simplex<S, D>& simplex = state.simplex;
  if constexpr (Rec::kOn) {
    for (int i = 0; i < simplex.count; ++i) {
      if (!contains(state.region, i)) record.dropped.push_back(simplex.vertices[i]);
    }
  }
  int kept = 0;
  for (int i = 0; i <= D; ++i) {
    if (!contains(state.region, i)) continue;
    simplex.vertices[kept] = simplex.vertices[i];
    simplex.weights[kept] = simplex.weights[i];
    ++kept;
  }
  simplex.count = kept;
  state.region = simplex.all();

  const bool nearer = came_nearer(state);
  if (nearer) {
    state.best = simplex;
    state.best_sq = state.p_sq;
  }
  const bool answered = kept == D + 1 || (!nearer && options.stop_on_no_progress);
  state.previous = Phase::cull;
  state.phase = answered ? Phase::stop : Phase::direction;
}

}  // namespace gjk::detail
