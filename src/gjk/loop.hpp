#pragma once
// The GJK distance algorithm: a loop over phases (Catto 2010, slide "GJK algorithm"; Gilbert,
// Johnson, Keerthi 1988).
//
//   pick an initial simplex S
//   loop
//     closest    compute the closest point P on S
//     drop       drop the vertices that have no weight in P
//     direction  build d, pointing from P to O
//     support    find the support point of Z = Y - X in direction d
//     stop       decide whether the answer is found
//     add        add the support point to S
//
// No phase reads a record, so recording cannot change a decision.

#include "gjk/direction.hpp"
#include "gjk/proof/first_pair.hpp"
#include "gjk/regions.hpp"
#include "gjk/stop.hpp"
#include "gjk/support.hpp"

namespace gjk {

/// The state before the first phase.
template <class R, class S, int D>
[[nodiscard]] State<R, D> start(const Query<S, D>& query, const Options& options,
                                const Prepared<R, D>& prepared) {
  State<R, D> state;
  if (prepared.error != Error::none) {
    state.error = prepared.error;
    state.stop = StopReason::failed;
    state.phase = Phase::stop;
    return state;
  }
  state.simplex.count = std::max(options.start.count, 1);
  for (int i = 0; i < options.start.count; ++i) {
    state.simplex.vertices[i] = support_point(query, prepared, options.start.pairs[i]);
  }
  if (options.start.count == 0) {
    state.simplex.vertices[0] = support_point(query, prepared, first_pair(query, prepared));
  }
  state.region = state.simplex.all();
  return state;
}

/// Runs the phase `state.phase`. Call it only while `state.stop` is StopReason::running.
template <class R, class S, int D, class Rec>
void step(State<R, D>& state, const Query<S, D>& query, const Options& options,
          const Prepared<R, D>& prepared, Rec& record) {
  switch (state.phase) {
    case Phase::closest:
      return find_closest_point(state, options, record);
    case Phase::drop:
      return drop(state, options, record);
    case Phase::direction:
      return build_direction(state, options, record);
    case Phase::support:
      return find_support(state, query, prepared, record);
    case Phase::stop:
      return run_stop_tests(state, options, prepared, record);
    case Phase::add:
      return add_support(state);
  }
}

/// Runs until the run ends, recording nothing. The order of the phases stands here a second time:
/// calling `step` in a loop would do the same, but here the compiler sees which phase follows
/// which. tests/gjk/decisions_test.cpp compares the two to the last bit.
template <class R, class S, int D>
void run(State<R, D>& state, const Query<S, D>& query, const Options& options,
         const Prepared<R, D>& prepared) {
  NoRecord none;
  while (state.stop == StopReason::running) {
    find_closest_point(state, options, none);
    drop(state, options, none);
    if (state.phase == Phase::direction) build_direction(state, options, none);
    if (state.phase == Phase::support) find_support(state, query, prepared, none);
    run_stop_tests(state, options, prepared, none);
    if (state.stop == StopReason::running) add_support(state);
  }
}

}  // namespace gjk
