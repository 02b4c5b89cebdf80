#pragma once
// Phase "support": the farthest point of the Minkowski difference along d.
//
// The sign convention of the whole project is the slides': Z = Y - X, and the query point is the
// origin O. For a point query X = {Q}, so d, drawn in the world, points from P to Q.

#include "gjk/proof/prepare.hpp"
#include "gjk/record.hpp"

namespace gjk {

/// Vertex i relative to its shape's center, in world axes and the run's unit.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> turned_vertex(const Shape<S, D>& shape, const Frames<R, D>& frames,
                                      const Body<R, D>& body, int i) {
  if (body.placed_count > 0) return body.placed[i];
  return shape.pose.template rotated<R>(detail::from_center(shape, frames, body, i));
}

/// w = (Ry y + ty) - (Rx x + tx), in the run's unit, for rotations R and translations t. A
/// translation common to both shapes cancels before anything rounds.
template <class R, class S, int D>
[[nodiscard]] SupportPoint<R, D> support_point(const Query<S, D>& query, const Frames<R, D>& frames,
                                               VertexPair pair) {
  if (frames.same_frame) {
    const auto& x = converted<R, S, D>(query.x.vertices()[pair.x]);
    const auto& y = converted<R, S, D>(query.y.vertices()[pair.y]);
    return {frames.in_unit(y) - frames.in_unit(x), pair};
  }
  const Vec<R, D> x = turned_vertex(query.x, frames, frames.x, pair.x);
  const Vec<R, D> y = turned_vertex(query.y, frames, frames.y, pair.y);
  return {Vec<R, D>(y - x) + frames.offset, pair};
}

/// dot(d, vertex i - center) of a shape's vertices, for a direction d in world axes.
template <class R, class S, int D>
struct Along {
  const Shape<S, D>& shape;
  const Frames<R, D>& frames;
  const Body<R, D>& body;
  Vec<R, D> d;                          ///< In the axes in which the vertices are read.
  const Vec<R, D>* in_place = nullptr;  ///< The vertices, where they can be read as they are.

  Along(const Vec<R, D>& in_world, const Shape<S, D>& of, const Frames<R, D>& in,
        const Body<R, D>& seen_as)
      : shape(of), frames(in), body(seen_as), d(in_world) {
    if (body.placed_count > 0) {
      in_place = body.placed.data();
      return;
    }
    d = shape.pose.template direction_to_local<R>(in_world);
    if constexpr (std::is_same_v<R, S>) {
      if (!frames.centered && frames.exponent == 0) in_place = shape.vertices().data();
    }
  }
  [[nodiscard]] int count() const { return static_cast<int>(shape.vertices().size()); }
  [[nodiscard]] R operator()(int i) const {
    if (in_place != nullptr) return dot(d, in_place[i]);
    return dot(d, detail::from_center(shape, frames, body, i));
  }
  /// The error of a difference of two values, for `climb`.
  [[nodiscard]] R rounding() const {
    if constexpr (ScalarTraits<R>::kExact) {
      return R(0);
    } else {
      return R(4 * (D + 1)) * ScalarTraits<R>::unit_roundoff() * norm_1(d) * body.radius;
    }
  }
};

/// The vertex of a shape that lies farthest along d; of equal ones the first (Catto 2010, slide
/// "Support point code"). Comparisons select instead of branching, because processors would
/// mispredict the branch.
template <class R, class S, int D>
[[nodiscard]] int farthest_vertex(const Vec<R, D>& d, const Shape<S, D>& shape,
                                  const Frames<R, D>& frames, const Body<R, D>& body) {
  const Along<R, S, D> along(d, shape, frames, body);
  const int count = along.count();
  if (body.is_ring) [[unlikely]]
    return detail::climb(count, along, along.rounding());
  int index = 0;
  R most = along(0);
  for (int i = 1; i < count; ++i) {
    const R value = along(i);
    index = most < value ? i : index;
    most = larger(most, value);
  }
  return index;
}

/// The pair that makes Z's support point: support(Z, d) = support(Y, d) - support(X, -d) (Catto
/// 2010, slide "Property 2: support points").
template <class R, class S, int D>
[[nodiscard]] VertexPair farthest_pair(const Query<S, D>& query, const Frames<R, D>& frames,
                                       const Vec<R, D>& d) {
  return {farthest_vertex(Vec<R, D>(-d), query.x, frames, frames.x),
          farthest_vertex(d, query.y, frames, frames.y)};
}

/// The record of `farthest_vertex`: the vertices that it looks at, in its order.
template <class R, class S, int D>
[[nodiscard]] std::vector<ScanEntry<R>> scan_entries(const Vec<R, D>& d, const Shape<S, D>& shape,
                                                     const Frames<R, D>& frames,
                                                     const Body<R, D>& body) {
  std::vector<ScanEntry<R>> entries;
  const R at_center = dot(d, shape.pose.template rotated<R>(frames.in_unit(body.center)));
  const Along<R, S, D> along(d, shape, frames, body);
  detail::Farthest<R> farthest;
  const auto look_at = [&](int i) {
    R value = along(i);
    entries.push_back({i, value + at_center, farthest.offer(i, value)});
    return value;
  };
  if (body.is_ring) {
    static_cast<void>(detail::climb(along.count(), look_at, along.rounding()));
  } else {
    for (int i = 0; i < along.count(); ++i) look_at(i);
  }
  return entries;
}

template <class R, class S, int D, class Rec>
void find_support(State<R, D>& state, const Query<S, D>& query, const Frames<R, D>& frames,
                  Rec& record) {
  if constexpr (Rec::kOn) {
    record.scan_x = scan_entries(Vec<R, D>(-state.d), query.x, frames, frames.x);
    record.scan_y = scan_entries(state.d, query.y, frames, frames.y);
  }
  state.support = support_point(query, frames, farthest_pair(query, frames, state.d));
  state.support_value = dot(state.d, state.support.w);
  state.evidence.add_plane(state.d, state.support.w, state.support_value);
  state.previous = Phase::support;
  state.phase = Phase::stop;
}

}  // namespace gjk
