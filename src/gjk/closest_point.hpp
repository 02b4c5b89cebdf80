#pragma once
// Phases "closest" and "cull": the closest point P of a simplex to O by ordered region tests, and
// what it leaves over.

#include <algorithm>

#include "gjk/support.hpp"

namespace gjk::detail {

inline constexpr int kMaxRegions = (1 << (kMaxDimension + 1)) - 1;

/// The faces of a simplex of `count` vertices in the order in which their regions are tested.
struct RegionList {
  std::array<Face, kMaxRegions> regions = {};
  int count = 0;
};
[[nodiscard]] constexpr RegionList regions_in_order(int vertices, RegionOrder order) {
  // Segment: the slides test u <= 0 (region B) before v <= 0 (region A). Triangle: A, B, C, AB, BC,
  // CA, ABC.
  constexpr std::array<Face, 3> kSegment = {0b10, 0b01, 0b11};
  constexpr std::array<Face, 7> kTriangle = {0b001, 0b010, 0b100, 0b011, 0b110, 0b101, 0b111};
  RegionList sorted;
  if (vertices == 2) {
    for (const Face face : kSegment) sorted.regions[sorted.count++] = face;
  } else if (vertices == 3) {
    for (const Face face : kTriangle) sorted.regions[sorted.count++] = face;
  } else {
    for (int size = 1; size <= vertices; ++size) {
      for (int face = 1; face < (1 << vertices); ++face) {
        if (vertex_count(static_cast<Face>(face)) == size) {
          sorted.regions[sorted.count++] = static_cast<Face>(face);
        }
      }
    }
  }
  if (order == RegionOrder::vertices_first) return sorted;
  RegionList reordered;
  for (const bool edges : {true, false}) {
    for (int i = 0; i < sorted.count; ++i) {
      if ((vertex_count(sorted.regions[i]) == 2) == edges) {
        reordered.regions[reordered.count++] = sorted.regions[i];
      }
    }
  }
  return reordered;
}

/// Barycentric coordinates of every face, computed once each, when first asked for.
template <class S, int D>
class CoordinateTable {
 public:
  explicit CoordinateTable(const Simplex<S, D>& simplex) : simplex_(simplex) {}
  const Barycentric<S, D>& operator[](Face face) {
    if (!known_[face]) {
      table_[face] = barycentric(simplex_, face);
      known_[face] = true;
    }
    return table_[face];
  }

 private:
  const Simplex<S, D>& simplex_;
  std::array<Barycentric<S, D>, (1u << (D + 1))> table_;
  std::array<bool, (1u << (D + 1))> known_ = {};
};

/// O lies in the Voronoi region of `face` when its coordinates within the face are positive, and
/// the coordinate of every other vertex, in the face grown by that vertex, is not (Johnson's
/// condition). For a triangle these are the slides' tests: region A if vAB <= 0 and uCA <= 0;
/// region AB if uAB > 0, vAB > 0 and wABC <= 0; else ABC.
template <class S, int D, class Rec>
[[nodiscard]] bool region_holds(const Simplex<S, D>& simplex, CoordinateTable<S, D>& table,
                                Face face, Rec& record) {
  bool holds = true;
  RegionTest<S>* note = nullptr;
  if constexpr (Rec::kOn) {
    record.region_tests.push_back({face, {}, false});
    note = &record.region_tests.back();
  }
  for (const bool inside : {true, false}) {
    for (int i = 0; i < simplex.count; ++i) {
      if (contains(face, i) != inside) continue;
      if (inside && vertex_count(face) == 1) continue;  // a point's own coordinate is 1
      const Face grown = static_cast<Face>(face | face_of(i));
      const Barycentric<S, D>& coordinates = table[grown];
      const bool positive = S(0) < coordinates.numerator[i];
      if (positive != inside) holds = false;
      if constexpr (Rec::kOn) {
        note->terms.push_back({grown, i, inside, coordinates.numerator[i], coordinates.denominator,
                               positive == inside});
      } else {
        if (!holds) return false;
      }
    }
  }
  if constexpr (Rec::kOn) note->holds = holds;
  return holds;
}

/// Weights of `face` from its coordinates: segments divide by the squared length as the slides do,
/// larger faces by the sum, so that weights add up to 1.
template <class S, int D>
void set_weights(Simplex<S, D>& simplex, Face face, const Barycentric<S, D>& coordinates) {
  S divisor = coordinates.denominator;
  if (vertex_count(face) > 2) {
    divisor = S(0);
    for (int i = 0; i < simplex.count; ++i) {
      if (contains(face, i)) divisor = divisor + coordinates.numerator[i];
    }
  }
  for (int i = 0; i < simplex.count; ++i) {
    simplex.weights[i] = contains(face, i) ? S(coordinates.numerator[i] / divisor) : S(0);
  }
}

/// When rounding left no test to believe: the nearest point over all faces whose coordinates are
/// positive. Vertices always qualify, so there is one.
template <class S, int D>
[[nodiscard]] Face nearest_face(Simplex<S, D> simplex, CoordinateTable<S, D>& table) {
  Face best = 0;
  S best_sq(0);
  for (Face face = 1; face <= simplex.all(); ++face) {
    const Barycentric<S, D>& coordinates = table[face];
    bool inside = S(0) < coordinates.denominator;
    for (int i = 0; i < simplex.count; ++i) {
      if (contains(face, i) && !(S(0) < coordinates.numerator[i])) inside = false;
    }
    if (!inside) continue;
    set_weights(simplex, face, coordinates);
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
  set_weights(simplex, simplex.all(), coordinates);
  S size(0);
  for (int i = 0; i < simplex.count; ++i) size = std::max(size, norm_max(simplex.vertices[i].w));
  const S rounding = S(kRoundings<D>) * ScalarTraits<S>::unit_roundoff() * size;
  return !(rounding < norm_max(weighted_point(simplex, simplex.all())));
}

template <class S, int D, class Rec>
void find_closest_point(State<S, D>& state, const Options& options, Rec& record) {
  Simplex<S, D>& simplex = state.simplex;
  CoordinateTable<S, D> table(simplex);
  const RegionList order = regions_in_order(simplex.count, options.region_order);
  state.region = 0;
  for (int i = 0; i < order.count && state.region == 0; ++i) {
    if (region_holds(simplex, table, order.regions[i], record)) state.region = order.regions[i];
  }
  const bool full = vertex_count(state.region) == D + 1;
  if (state.region == 0 || (full && !weights_reach_origin(simplex, table[state.region]))) {
    state.region = nearest_face(simplex, table);
    if constexpr (Rec::kOn) record.no_region_held = !full || state.region != simplex.all();
  }
  set_weights(simplex, state.region, table[state.region]);
  // Inside a full simplex P is O itself; the weighted sum would only say so up to rounding.
  state.p = vertex_count(state.region) == D + 1 ? Vec<S, D>(Vec<S, D>::Zero())
                                                : weighted_point(simplex, state.region);
  state.p_sq = dot(state.p, state.p);
  bool finite = ScalarTraits<S>::is_finite(state.p_sq);
  for (int i = 0; i < simplex.count; ++i) {
    finite = finite && ScalarTraits<S>::is_finite(simplex.weights[i]);
  }
  if (!finite) state.error = Error::overflow;
  state.previous = Phase::closest;
  state.phase = Phase::cull;
}

template <class S, int D, class Rec>
void cull(State<S, D>& state, const Options& options, Rec& record) {
  Simplex<S, D>& simplex = state.simplex;
  int kept = 0;
  for (int i = 0; i < simplex.count; ++i) {
    if (contains(state.region, i)) {
      simplex.vertices[kept] = simplex.vertices[i];
      simplex.weights[kept] = simplex.weights[i];
      ++kept;
    } else if constexpr (Rec::kOn) {
      record.dropped.push_back(simplex.vertices[i]);
    }
  }
  for (int i = kept; i < simplex.count; ++i) {
    simplex.vertices[i] = {};
    simplex.weights[i] = S(0);
  }
  simplex.count = kept;
  state.region = simplex.all();

  const bool nearer = state.best.count == 0 || state.p_sq < state.best_sq;
  if (nearer) {
    state.best = simplex;
    state.best_sq = state.p_sq;
  }
  const bool answered = kept == D + 1 || (!nearer && options.stop_on_no_progress);
  state.previous = Phase::cull;
  state.phase = answered ? Phase::stop : Phase::direction;
}

}  // namespace gjk::detail
