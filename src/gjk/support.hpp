#pragma once
// Phase "support": the farthest point of the Minkowski difference along d.
//
// Sign convention of the whole project, the slides': Z = Y - X, and the query point is the origin
// O. For a point query X = {Q}, so that d, drawn in the world, points from P to Q.

#include "gjk/prepare.hpp"
#include "gjk/state.hpp"

namespace gjk {
namespace detail {

/// A vertex in its shape's own frame, seen from the shape's centre, in the run's unit.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> from_centre(const Shape<S, D>& shape, const Prepared<R, D>& prepared,
                                    const Vec<R, D>& centre, std::size_t i) {
  const auto& vertex = converted<R, S, D>(shape.vertices[i]);
  return prepared.in_unit(prepared.centred ? Vec<R, D>(vertex - centre) : Vec<R, D>(vertex));
}
/// The same as its shape's pose turns it.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> placed(const Shape<S, D>& shape, const Prepared<R, D>& prepared,
                               const Vec<R, D>& centre, std::size_t i) {
  return shape.pose.template rotated<R>(from_centre(shape, prepared, centre, i));
}

/// The vertices of a shape along a direction: dot(d, vertex - centre). Those of a small shape are
/// turned into the world; for a large one the direction is turned into its frame, which exact
/// scalars always do: it takes fewer products.
template <class R, class S, int D>
struct Along {
  const Shape<S, D>& shape;
  const Points<S, D>& vertices;
  const Prepared<R, D>& prepared;
  const Vec<R, D>& centre;
  bool turns_vertices;
  Vec<R, D> d;

  Along(const Shape<S, D>& query_shape, const Prepared<R, D>& query_prepared,
        const Vec<R, D>& shape_centre, const Vec<R, D>& world)
      : shape(query_shape),
        vertices(shape.vertices),
        prepared(query_prepared),
        centre(shape_centre),
        turns_vertices(!ScalarTraits<R>::kExact && vertices.is_small()),
        d(turns_vertices ? world : shape.pose.template direction_to_local<R>(world)) {}

  [[nodiscard]] R operator()(std::size_t i) const {
    const Vec<R, D> local = from_centre(shape, prepared, centre, i);
    return turns_vertices ? dot(d, shape.pose.template rotated<R>(local)) : dot(d, local);
  }
};

/// The vertices of X along -d, and of Y along d.
template <class R, class S, int D>
[[nodiscard]] Along<R, S, D> along_x(const Query<S, D>& query, const Prepared<R, D>& prepared,
                                     const Vec<R, D>& d) {
  return {query.x, prepared, prepared.x_centre, -d};
}
template <class R, class S, int D>
[[nodiscard]] Along<R, S, D> along_y(const Query<S, D>& query, const Prepared<R, D>& prepared,
                                     const Vec<R, D>& d) {
  return {query.y, prepared, prepared.y_centre, d};
}

/// `yes` or `no`, without a branch: nobody foresees how vertices compare.
[[nodiscard]] constexpr int chosen(bool condition, int yes, int no) {
  return no ^ ((yes ^ no) & -static_cast<int>(condition));
}

/// The vertex that lies farthest so far; of equal ones that with the lowest index.
template <class R>
struct Farthest {
  int index = 0;
  R value = R(0);

  /// The same answer for any order of calls.
  bool offer(int i, const R& offered) {
    const bool improves = value < offered || (value == offered && i < index);
    index = chosen(improves, i, index);
    value = improves ? offered : value;
    return improves;
  }
  /// For calls in the order of indices.
  void offer_next(int i, const R& offered) {
    const bool improves = value < offered;
    index = chosen(improves, i, index);
    value = improves ? offered : value;
  }
};

/// Of `count` vertices the first with the largest `along(i)` (Catto 2010, slide "Support point
/// code"). Vertices with even and with odd indices are scanned side by side, because each step of a
/// scan waits for the one before it.
template <class R, class Along>
[[nodiscard]] int scan(int count, const Along& along) {
  Farthest<R> even{0, along(0)};
  Farthest<R> odd = even;
  int i = 1;
  for (; i + 1 < count; i += 2) {
    odd.offer_next(i, along(i));
    even.offer_next(i + 1, along(i + 1));
  }
  if (i < count) odd.offer_next(i, along(i));
  even.offer(odd.index, odd.value);
  return even.index;
}
template <class R, class S, int D>
[[nodiscard]] int scan(const Along<R, S, D>& along) {
  return scan<R>(static_cast<int>(along.vertices.size()), along);
}

/// The vertex that `scan` would find, without looking at all of them. Along a direction the
/// vertices of a convex ring rise to one summit and fall to one valley. From the best of some
/// samples both ways down are followed until the fall is beyond rounding: by then everything that
/// is as high as that sample has been seen.
template <class R, class S, int D, class Visit>
[[nodiscard]] int climb(const Along<R, S, D>& along, const Visit& visit) {
  const int count = static_cast<int>(along.vertices.size());
  int stride = 1;
  while (stride * stride < count) stride *= 2;
  Farthest<R> farthest{0, along(0)};
  visit(0);
  for (int i = stride; i < count; i += stride) {
    farthest.offer(i, along(i));
    visit(i);
  }
  R rounding(0);  // of two dot products of centred vertices
  if constexpr (!ScalarTraits<R>::kExact) {
    rounding = R(R(4 * (D + 1)) * ScalarTraits<R>::unit_roundoff()) * norm_1(along.d) *
               ScalarTraits<R>::from(along.vertices.radius()) * along.prepared.unit;
  }
  const int summit = farthest.index;
  for (const int towards : {1, count - 1}) {
    for (int i = (summit + towards) % count; i != summit; i = (i + towards) % count) {
      const R value = along(i);
      farthest.offer(i, value);
      visit(i);
      if (value < farthest.value - rounding) break;
    }
  }
  return farthest.index;
}

template <class R, class S, int D>
[[nodiscard]] int farthest_vertex(const Along<R, S, D>& along) {
  return along.vertices.is_ring() ? climb(along, [](int) {}) : scan(along);
}

/// The vertices that `farthest_vertex` looks at, in its order.
template <class R, class S, int D>
[[nodiscard]] std::vector<ScanEntry<R>> scan_entries(const Along<R, S, D>& along) {
  std::vector<ScanEntry<R>> entries;
  const Vec<R, D> centre = along.prepared.in_unit(along.centre);
  const R at_centre =
      dot(along.d, along.turns_vertices ? along.shape.pose.template rotated<R>(centre) : centre);
  Farthest<R> farthest;
  const auto note = [&](int i) {
    const R value = along(i);
    const bool improves = entries.empty() || farthest.offer(i, value);
    if (entries.empty()) farthest = {i, value};
    entries.push_back({i, value + at_centre, improves});
  };
  if (along.vertices.is_ring()) {
    static_cast<void>(climb(along, note));
  } else {
    for (int i = 0; i < static_cast<int>(along.vertices.size()); ++i) note(i);
  }
  return entries;
}

}  // namespace detail

/// w = (Ry y + ty) - (Rx x + tx), in the run's unit. A translation common to both shapes cancels
/// before anything rounds.
template <class R, class S, int D>
[[nodiscard]] SupportPoint<R, D> support_point(const Query<S, D>& query,
                                               const Prepared<R, D>& prepared, VertexPair pair) {
  if (prepared.same_frame) {
    const auto& x = converted<R, S, D>(query.x.vertices[pair.x]);
    const auto& y = converted<R, S, D>(query.y.vertices[pair.y]);
    return {prepared.in_unit(y) - prepared.in_unit(x), pair};
  }
  const Vec<R, D> placed_x = detail::placed(query.x, prepared, prepared.x_centre, pair.x);
  const Vec<R, D> placed_y = detail::placed(query.y, prepared, prepared.y_centre, pair.y);
  return {Vec<R, D>(placed_y - placed_x) + prepared.offset, pair};
}

namespace detail {

/// What rounding may have added to the distance of a support plane, in the run's unit: to its
/// support point, to dot(d, w), and by a wrong choice of the scans; and to the result.
template <class R, int D>
[[nodiscard]] R plane_error(const Flat<R>& distance_and_reach, const Prepared<R, D>& prepared) {
  const auto& [distance, reach] = distance_and_reach;
  return prepared.plane_error() +
         ScalarTraits<R>::unit_roundoff() * (R(D + 1) * reach + R(4) * distance);
}
/// The lower bound of the distance that a support plane proves.
template <class R, int D>
[[nodiscard]] R plane_bound(const R& distance_sq, const R& reach_sq,
                            const Prepared<R, D>& prepared) {
  const Flat<R> lengths = roots(distance_sq, reach_sq);
  return larger(R(lengths.x - plane_error(lengths, prepared)), R(0));
}

/// Larsen's slab (1998, "Proof of Local Verification"): all of Z lies beyond the plane through the
/// support point, normal to d, so -dot(d, w) / |d| is a lower bound of the distance.
template <class R, int D>
void note_support_plane(State<R, D>& state) {
  const R d_sq = dot(state.d, state.d);
  if (!(state.support_value < R(0)) || !(R(0) < d_sq)) return;
  const R distance_sq = state.support_value * R(state.support_value / d_sq);
  if (!(state.plane_distance_sq < distance_sq)) return;
  state.plane_distance_sq = distance_sq;
  state.plane_reach_sq = dot(state.support.w, state.support.w);
}

/// support(Z, d) = support(Y, d) - support(X, -d)  (Catto 2010, slide "Property 2: support
/// points").
template <class R, class S, int D>
[[nodiscard]] VertexPair farthest_pair(const Query<S, D>& query, const Prepared<R, D>& prepared,
                                       const Vec<R, D>& d) {
  return {farthest_vertex(along_x(query, prepared, d)),
          farthest_vertex(along_y(query, prepared, d))};
}

template <class R, class S, int D, class Rec>
void find_support(State<R, D>& state, const Query<S, D>& query, const Prepared<R, D>& prepared,
                  Rec& record) {
  if constexpr (Rec::kOn) {
    record.scan_x = scan_entries(along_x(query, prepared, state.d));
    record.scan_y = scan_entries(along_y(query, prepared, state.d));
  }
  state.support = support_point(query, prepared, farthest_pair(query, prepared, state.d));
  state.support_value = dot(state.d, state.support.w);
  note_support_plane(state);
  if (state.support_value == R(0)) state.touches_plane = true;
  state.previous = Phase::support;
  state.phase = Phase::stop;
}

}  // namespace detail
}  // namespace gjk
