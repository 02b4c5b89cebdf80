#pragma once
// The GJK distance algorithm: a loop over phases (Catto 2010, slide "GJK algorithm"; Gilbert,
// Johnson, Keerthi 1988).
//
//   pick an initial simplex S
//   loop
//     closest    compute the closest point P on S
//     cull       drop the vertices that have no weight in P
//     direction  build d, pointing from P to O
//     support    find the support point of Z = Y - X in direction d
//     stop       decide whether the answer is found
//     add        add the support point to S
//
// No phase reads a record, so recording cannot change a decision.

#include "gjk/closest_point.hpp"
#include "gjk/direction.hpp"
#include "gjk/stop.hpp"
#include "gjk/support.hpp"

namespace gjk {

/// A shape's numbers in double.
template <int D>
struct InDouble {
  std::vector<Vec<double, D>> points;
  Pose<double, D> pose;

  template <class S>
  explicit InDouble(const Shape<S, D>& shape)
      : pose{Rotation<double, D>(shape.pose.rotation.matrix().template cast<double>()),
             converted<double, S, D>(shape.pose.translation)} {
    for (const Vec<S, D>& point : shape.vertices())
      points.push_back(converted<double, S, D>(point));
  }
};

/// The pair that a run starts from when it is given none: the support point of Z along the line
/// between the centres of the shapes. It is chosen in double, whatever the run computes in, so that
/// runs of one query start alike in every scalar. Only queries that double cannot hold choose for
/// themselves.
template <class R, class S, int D>
[[nodiscard]] VertexPair first_pair(const Query<S, D>& query, const Prepared<R, D>& prepared) {
  const auto chosen = [](const auto& asked, const auto& in) {
    return farthest_pair(asked, in, (-in.offset).eval());
  };
  if constexpr (ScalarTraits<S>::kExact) {
    const InDouble<D> x(query.x);
    const InDouble<D> y(query.y);
    const Query<double, D> in_double{{x.points, x.pose}, {y.points, y.pose}};
    const Prepared<double, D> rounded = prepare<double>(in_double, {});
    if (rounded.error == Error::none) return chosen(in_double, rounded);
  } else if constexpr (!std::is_same_v<R, double> &&
                       std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits) {
    const Prepared<double, D> rounded = prepare<double>(query, {});
    if (rounded.error == Error::none) return chosen(query, rounded);
  }
  return chosen(query, prepared);
}

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
    case Phase::cull:
      return cull(state, options, record);
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

/// Runs until the run ends, recording nothing: the same as `step` in a loop, but the compiler sees
/// which phase follows which.
template <class R, class S, int D>
void run(State<R, D>& state, const Query<S, D>& query, const Options& options,
         const Prepared<R, D>& prepared) {
  NoRecord none;
  while (state.stop == StopReason::running) {
    find_closest_point(state, options, none);
    cull(state, options, none);
    if (state.phase == Phase::direction) build_direction(state, options, none);
    if (state.phase == Phase::support) find_support(state, query, prepared, none);
    run_stop_tests(state, options, prepared, none);
    if (state.stop == StopReason::running) add_support(state);
  }
}

}  // namespace gjk
