#pragma once
// The expanding polytope (van den Bergen 2001, "Proximity queries and penetration depth computation
// on 3D game objects"; Cameron 1997, "Enhancing GJK: computing minimum and penetration distances
// between convex polyhedra"), in the plane a polygon. One loop serves both; read "edge" for "face"
// in the plane.
//
//   start with GJK's last simplex
//   loop
//     nearest    take the face that is nearest to O, and its outward normal n
//     support    find the support point of Z = Y - X in direction n
//     stop       decide whether the face lies on the boundary of Z
//     expand     replace all faces that see the support point by faces from it
//
// All corners are points of Z, so the polytope lies in Z: the nearest face bounds the depth from
// below. All of Z lies on this side of the plane through the support point, normal to n: that plane
// bounds the depth from above. They meet in the face of Z that is nearest to O.

#include "depth/plane/polygon.hpp"
#include "depth/space/polytope.hpp"
#include "gjk/proof/result.hpp"

namespace depth {
namespace detail {

/// The obstacle to a run: `running` where there is none.
[[nodiscard]] constexpr StopReason obstacle(gjk::Verdict verdict) {
  if (verdict == gjk::Verdict::none) return StopReason::failed;
  if (verdict == gjk::Verdict::separated) return StopReason::separated;
  if (verdict == gjk::Verdict::undecided) return StopReason::undecided;
  return StopReason::running;
}

template <class R, class S, int D, class Rec>
void find_support(State<R, D>& state, const gjk::Query<S, D>& query,
                  const gjk::Prepared<R, D>& prepared, Rec& record) {
  if constexpr (Rec::kOn) {
    record.scan_x = gjk::scan_entries(Vec<R, D>(-state.n), query.x, prepared, prepared.x);
    record.scan_y = gjk::scan_entries(state.n, query.y, prepared, prepared.y);
  }
  state.support = gjk::support_point(query, prepared, gjk::farthest_pair(query, prepared, state.n));
}

/// The most iterations. In the plane exact arithmetic finds another corner of Z in each, and Z has
/// no more corners than both shapes have vertices; rounding may find some twice. In space there may
/// be as many as pairs of vertices, so runs on large round shapes end at a cap.
template <class S, int D>
[[nodiscard]] int iteration_cap(const gjk::Query<S, D>& query) {
  constexpr std::size_t kMost = 10000;
  const std::size_t x = query.x.vertices().size();
  const std::size_t y = query.y.vertices().size();
  return static_cast<int>(D == 2 ? 8 + 2 * (x + y) : std::min(8 + x * y, kMost));
}

/// Roundings of dot(n, support - corner) that are taken for no progress: in the plane all that it
/// can have. In space exact arithmetic has decided before that the face sees the support point.
template <int D>
inline constexpr int kProgressRoundings = D == 2 ? 4 : 1;

/// The stop tests, in order; the first that holds names the reason. What each compares:
///
///   reason            left                                     right           holds if
///   repeated_support  corner of the face that is the support   0               left >= right
///                     point: 0, 1, 2, or -1 for none
///   no_progress       dot(n, support - corner of the face);    its rounding    left <= right
///                     in space 0 where the face does not see it
///   iteration_cap     cap                                      iteration       left <= right
template <class R, class S, int D, class Rec>
void run_stop_tests(State<R, D>& state, const gjk::Query<S, D>& query, Rec& record) {
  const auto test = [&](StopReason reason, bool holds, const R& left, const R& right) {
    const bool tried = state.stop == StopReason::running;
    if constexpr (Rec::kOn) {
      record.stop_tests.push_back({reason, tried, tried && holds, left, right});
    }
    if (tried && holds) state.stop = reason;
  };
  int repeated = -1;
  for (int i = D - 1; i >= 0; --i) {
    if (nearest_corner(state, i).pair == state.support.pair) repeated = i;
  }
  bool is_seen = true;
  if constexpr (D == 3) {
    is_seen = repeated < 0 && space::detail::sees(state.polytope, state.face, state.support.w);
  }
  const Vec<R, D> beyond = state.support.w - nearest_corner(state, 0).w;
  const R farther = is_seen ? gjk::dot(state.n, beyond) : R(0);
  R rounding(0);
  if constexpr (!gjk::ScalarTraits<R>::kExact) {
    rounding = R(kProgressRoundings<D>) * gjk::ScalarTraits<R>::unit_roundoff() *
               gjk::norm_1(state.n) * gjk::norm_max(beyond);
  }
  const int cap = iteration_cap(query);

  test(StopReason::repeated_support, repeated >= 0, R(repeated), R(0));
  test(StopReason::no_progress, !(rounding < farther), farther, rounding);
  test(StopReason::iteration_cap, cap <= state.iteration, R(cap), R(state.iteration));
}

}  // namespace detail

/// The state before the first phase: what expands is the simplex that GJK found around O.
template <class R, class S, int D, class Found>
[[nodiscard]] State<R, D> start(const gjk::Query<S, D>& query, const gjk::Prepared<R, D>& prepared,
                                const gjk::Result<Found, D>& found) {
  State<R, D> state;
  state.stop = detail::obstacle(found.verdict);
  if (state.stop != StopReason::running) {
    state.phase = Phase::stop;
    return state;
  }
  std::vector<gjk::SupportPoint<R, D>> points;
  points.reserve(D + 1);
  for (int i = 0; i < found.simplex.count; ++i)
    points.push_back(gjk::support_point(query, prepared, found.simplex.vertices[i].pair));
  detail::start_with(std::move(points), query, prepared, state);
  return state;
}

/// Runs the phase `state.phase`. The run goes on while `state.stop` is StopReason::running.
template <class R, class S, int D, class Rec>
void step(State<R, D>& state, const gjk::Query<S, D>& query, const gjk::Prepared<R, D>& prepared,
          Rec& record) {
  switch (state.phase) {
    case Phase::nearest:
      detail::find_nearest(state, record);
      state.phase = Phase::support;
      break;
    case Phase::support:
      detail::find_support(state, query, prepared, record);
      state.phase = Phase::stop;
      break;
    case Phase::stop:
      detail::run_stop_tests(state, query, record);
      if (state.stop == StopReason::running) state.phase = Phase::expand;
      break;
    case Phase::expand:
      detail::expand(state, record);
      ++state.iteration;
      state.phase = Phase::nearest;
      break;
  }
}

/// Runs all phases until the run ends, recording nothing.
template <class R, class S, int D>
void run(State<R, D>& state, const gjk::Query<S, D>& query, const gjk::Prepared<R, D>& prepared) {
  NoRecord none;
  while (state.stop == StopReason::running) step(state, query, prepared, none);
}

}  // namespace depth
