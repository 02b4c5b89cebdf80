#pragma once
// Phases "stop" and "add".

#include "gjk/support.hpp"

namespace gjk {

/// Runs the stop tests in order; the first that holds names the reason. Each compares two values:
///
///   reason            left                                     right                 holds if
///   origin_inside     vertices that drop kept                  those of a full one   left = right
///   not_nearer        |best P|^2                               |P|^2                 left <= right
///   zero_direction    |d|_1                                    0                     left = right
///   repeated_support  index of the simplex vertex that is      0                     left >= right
///                     the support point, or -1
///   no_progress       dot(d, support)                          largest dot(d, w_i)   left <= right
///   within_tolerance  wanted_plane_distance_sq                 plane_distance_sq     left <= right
///   iteration_cap     cap                                      iteration             left <= right
///
/// Rows 1, 3 and 4 are cases 2, 3a and 1 of Catto 2010, slides "Termination".
template <class R, int D, class Rec>
void run_stop_tests(State<R, D>& state, const Options& options, const Prepared<R, D>& prepared,
                    Rec& record) {
  const auto test = [&](StopReason reason, bool enabled, bool holds, const R& left,
                        const R& right) {
    const bool tried = enabled && state.stop == StopReason::running;
    if constexpr (Rec::kOn) {
      record.stop_tests.push_back({reason, enabled, tried, tried && holds, left, right});
    }
    if (tried && holds) state.stop = reason;
  };
  const Simplex<R, D>& simplex = state.simplex;
  const bool has_direction = state.previous != Phase::drop;
  const bool has_support = state.previous == Phase::support;

  int repeated = -1;
  R farthest(0);
  if (has_support) {
    for (int i = 0; i < simplex.count; ++i) {
      if (simplex.vertices[i].pair == state.support.pair) repeated = i;
      const R value = dot(state.d, simplex.vertices[i].w);
      if (i == 0 || farthest < value) farthest = value;
    }
  }

  test(StopReason::origin_inside, true, simplex.count == D + 1, R(simplex.count), R(D + 1));
  test(StopReason::not_nearer, !has_direction && simplex.count <= D, true, state.evidence.best_sq,
       state.p_sq);
  test(StopReason::zero_direction, has_direction, is_zero(state.d), norm_1(state.d), R(0));
  test(StopReason::repeated_support, has_support && options.stop_on_repeated_support, repeated >= 0,
       R(repeated), R(0));
  test(StopReason::no_progress, has_support && options.stop_on_no_progress,
       !(farthest < state.support_value), state.support_value, farthest);
  const bool has_tolerance = has_support && 0.0 < options.tolerance;
  const R wanted = has_tolerance || Rec::kOn
                       ? wanted_plane_distance_sq<R, D>(state.evidence, options.tolerance, prepared)
                       : R(0);
  test(StopReason::within_tolerance, has_tolerance, !(state.evidence.plane_distance_sq < wanted),
       wanted, state.evidence.plane_distance_sq);
  test(StopReason::iteration_cap, has_support, options.iteration_cap <= state.iteration,
       R(options.iteration_cap), R(state.iteration));

  state.previous = Phase::stop;
  if (state.stop == StopReason::running) state.phase = Phase::add;
}

template <class R, int D>
void add_support(State<R, D>& state) {
  state.simplex.vertices[state.simplex.count] = state.support;
  state.simplex.weights[state.simplex.count] = R(0);
  ++state.simplex.count;
  state.region = state.simplex.all();
  ++state.iteration;
  state.previous = Phase::add;
  state.phase = Phase::closest;
}

}  // namespace gjk
