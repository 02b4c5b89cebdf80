#pragma once
// Traces in any scalar, widened to double for pictures and files.

#include <type_traits>

#include "geometry/rational.hpp"
#include "gjk/gjk.hpp"

namespace gjkscope {

/// Conversions between a lesson's scalar and double. half, float and double values survive the way
/// to double and back.
template <class S>
[[nodiscard]] double widened(const S& value) {
  if constexpr (std::is_same_v<S, Rational>) {
    return to_double(value);
  } else {
    return static_cast<double>(value);
  }
}
template <class S>
[[nodiscard]] Eigen::Vector2d widened(const gjk::Vec<S, 2>& v) {
  return {widened(v[0]), widened(v[1])};
}
template <class S>
[[nodiscard]] gjk::Vec<S, 2> narrowed(const Eigen::Vector2d& v) {
  return gjk::Vec<S, 2>(S(v[0]), S(v[1]));
}

template <class S>
[[nodiscard]] gjk::SupportPoint<double, 2> widened(const gjk::SupportPoint<S, 2>& point) {
  return {widened(point.w), widened(point.x), widened(point.y), point.pair};
}

template <class S>
[[nodiscard]] gjk::Simplex<double, 2> widened(const gjk::Simplex<S, 2>& simplex) {
  gjk::Simplex<double, 2> out;
  out.count = simplex.count;
  for (int i = 0; i < 3; ++i) {
    out.vertices[i] = widened(simplex.vertices[i]);
    out.weights[i] = widened(simplex.weights[i]);
  }
  return out;
}

template <class S>
[[nodiscard]] gjk::Simplex<S, 2> narrowed(const gjk::Simplex<double, 2>& simplex) {
  gjk::Simplex<S, 2> out;
  out.count = simplex.count;
  for (int i = 0; i < 3; ++i) {
    const gjk::SupportPoint<double, 2>& vertex = simplex.vertices[i];
    out.vertices[i] = {narrowed<S>(vertex.w), narrowed<S>(vertex.x), narrowed<S>(vertex.y),
                       vertex.pair};
    out.weights[i] = S(simplex.weights[i]);
  }
  return out;
}

template <class S>
[[nodiscard]] gjk::State<double, 2> widened(const gjk::State<S, 2>& state) {
  gjk::State<double, 2> out;
  out.phase = state.phase;
  out.previous = state.previous;
  out.iteration = state.iteration;
  out.simplex = widened(state.simplex);
  out.region = state.region;
  out.p = widened(state.p);
  out.p_sq = widened(state.p_sq);
  out.d = widened(state.d);
  out.support = widened(state.support);
  out.support_value = widened(state.support_value);
  out.best = widened(state.best);
  out.best_sq = widened(state.best_sq);
  out.plane_distance_sq = widened(state.plane_distance_sq);
  out.touches_plane = state.touches_plane;
  out.stop = state.stop;
  out.error = state.error;
  return out;
}

template <class S>
[[nodiscard]] gjk::Record<double, 2> widened(const gjk::Record<S, 2>& record) {
  gjk::Record<double, 2> out;
  for (const gjk::RegionTest<S>& test : record.region_tests) {
    gjk::RegionTest<double> wide{test.region, {}, test.holds};
    for (const gjk::RegionTerm<S>& term : test.terms) {
      wide.terms.push_back({term.face, term.vertex, term.wants_positive, widened(term.numerator),
                            widened(term.denominator), term.holds});
    }
    out.region_tests.push_back(std::move(wide));
  }
  out.no_region_held = record.no_region_held;
  for (const gjk::SupportPoint<S, 2>& point : record.dropped) out.dropped.push_back(widened(point));
  const gjk::DirectionNote<S, 2>& note = record.direction;
  out.direction = {widened(note.d),    note.from_normal, widened(note.normal),
                   widened(note.side), note.flipped,     note.sign_is_arbitrary};
  for (const auto& entry : record.scan_x)
    out.scan_x.push_back({entry.index, widened(entry.value), entry.improves});
  for (const auto& entry : record.scan_y)
    out.scan_y.push_back({entry.index, widened(entry.value), entry.improves});
  for (const gjk::StopTest<S>& test : record.stop_tests) {
    out.stop_tests.push_back({test.reason, test.enabled, test.tried, test.holds, widened(test.left),
                              widened(test.right)});
  }
  return out;
}

template <class S>
[[nodiscard]] gjk::Trace<double, 2> widened(const gjk::Trace<S, 2>& trace) {
  gjk::Trace<double, 2> out;
  out.initial = widened(trace.initial);
  for (const gjk::Step<S, 2>& step : trace.steps) {
    out.steps.push_back({step.phase, step.iteration, widened(step.after), widened(step.record)});
  }
  const gjk::Result<S, 2>& result = trace.result;
  out.result.error = result.error;
  out.result.stop = result.stop;
  out.result.verdict = result.verdict;
  out.result.distance = widened(result.distance);
  out.result.lower = widened(result.lower);
  out.result.upper = widened(result.upper);
  out.result.distance_sq = widened(result.distance_sq);
  out.result.x = widened(result.x);
  out.result.y = widened(result.y);
  out.result.iterations = result.iterations;
  out.result.simplex = widened(result.simplex);
  return out;
}

}  // namespace gjkscope
