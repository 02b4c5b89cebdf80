#pragma once
// Traces in any scalar, widened to double for pictures and files.

#include <cmath>
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

/// A simplex in units of 2^exponent, in the world's unit, and back.
template <class S>
[[nodiscard]] gjk::Simplex<double, 2> widened(const gjk::Simplex<S, 2>& simplex, int exponent) {
  gjk::Simplex<double, 2> out;
  out.count = simplex.count;
  for (int i = 0; i < 3; ++i) {
    out.vertices[i] = {widened(simplex.vertices[i].w) * std::ldexp(1.0, exponent),
                       simplex.vertices[i].pair};
    out.weights[i] = widened(simplex.weights[i]);
  }
  return out;
}
template <class S>
[[nodiscard]] gjk::Simplex<S, 2> narrowed(const gjk::Simplex<double, 2>& simplex, int exponent) {
  gjk::Simplex<S, 2> out;
  out.count = simplex.count;
  for (int i = 0; i < 3; ++i) {
    out.vertices[i] = {narrowed<S>(simplex.vertices[i].w * std::ldexp(1.0, -exponent)),
                       simplex.vertices[i].pair};
    out.weights[i] = S(simplex.weights[i]);
  }
  return out;
}

/// Widens what a run in units of 2^exponent left, to the world's unit: powers of two are exact.
template <class S>
class Widener {
 public:
  explicit Widener(int exponent)
      : exponent_(exponent),
        unit_(std::ldexp(1.0, exponent)),
        unit_sq_(std::ldexp(1.0, 2 * exponent)) {}

  [[nodiscard]] gjk::State<double, 2> operator()(const gjk::State<S, 2>& state) const {
    gjk::State<double, 2> out;
    out.phase = state.phase;
    out.previous = state.previous;
    out.iteration = state.iteration;
    out.simplex = widened(state.simplex, exponent_);
    out.region = state.region;
    out.p = length(state.p);
    out.p_sq = square(state.p_sq);
    out.d = length(state.d);
    out.support = point(state.support);
    out.support_value = square(state.support_value);
    out.best = widened(state.best, exponent_);
    out.best_sq = square(state.best_sq);
    out.plane_distance_sq = square(state.plane_distance_sq);
    out.plane_reach_sq = square(state.plane_reach_sq);
    out.touches_plane = state.touches_plane;
    out.stop = state.stop;
    out.error = state.error;
    return out;
  }

  [[nodiscard]] gjk::Record<double, 2> operator()(const gjk::Record<S, 2>& record) const {
    gjk::Record<double, 2> out;
    for (const gjk::RegionTest<S>& test : record.region_tests) {
      gjk::RegionTest<double> wide{test.region, {}, test.holds};
      for (const gjk::RegionTerm<S>& term : test.terms) {
        wide.terms.push_back({term.face, term.vertex, term.wants_positive, square(term.numerator),
                              square(term.denominator), term.holds});
      }
      out.region_tests.push_back(std::move(wide));
    }
    out.no_region_held = record.no_region_held;
    for (const gjk::SupportPoint<S, 2>& dropped : record.dropped)
      out.dropped.push_back(point(dropped));
    const gjk::DirectionNote<S, 2>& note = record.direction;
    out.direction = {length(note.d),    note.from_normal, length(note.normal),
                     square(note.side), note.flipped,     note.sign_is_arbitrary};
    for (const gjk::ScanEntry<S>& entry : record.scan_x)
      out.scan_x.push_back({entry.index, square(entry.value), entry.improves});
    for (const gjk::ScanEntry<S>& entry : record.scan_y)
      out.scan_y.push_back({entry.index, square(entry.value), entry.improves});
    for (const gjk::StopTest<S>& test : record.stop_tests) out.stop_tests.push_back(widen(test));
    return out;
  }

 private:
  [[nodiscard]] Eigen::Vector2d length(const gjk::Vec<S, 2>& v) const { return widened(v) * unit_; }
  [[nodiscard]] double square(const S& value) const { return widened(value) * unit_sq_; }
  [[nodiscard]] gjk::SupportPoint<double, 2> point(const gjk::SupportPoint<S, 2>& value) const {
    return {length(value.w), value.pair};
  }

  [[nodiscard]] gjk::StopTest<double> widen(const gjk::StopTest<S>& test) const {
    double factor = 1.0;
    if (test.reason == gjk::StopReason::zero_direction) factor = unit_;
    if (test.reason == gjk::StopReason::no_progress ||
        test.reason == gjk::StopReason::within_tolerance) {
      factor = unit_sq_;
    }
    return {test.reason,
            test.enabled,
            test.tried,
            test.holds,
            widened(test.left) * factor,
            widened(test.right) * factor};
  }

  int exponent_;
  double unit_;
  double unit_sq_;
};

/// A result, whose lengths are in the world's unit, and its simplex in units of 2^exponent.
template <class S>
[[nodiscard]] gjk::Result<double, 2> widened(const gjk::Result<S, 2>& result, int exponent) {
  gjk::Result<double, 2> out;
  out.error = result.error;
  out.stop = result.stop;
  out.verdict = result.verdict;
  out.settled = result.settled;
  out.distance = widened(result.distance);
  out.lower = widened(result.lower);
  out.upper = widened(result.upper);
  out.distance_sq = widened(result.distance_sq);
  out.x = widened(result.x);
  out.y = widened(result.y);
  out.iterations = result.iterations;
  out.simplex = widened(result.simplex, exponent);
  return out;
}

/// The trace in double and in the world's unit. Where the squares of a double run would leave the
/// range of a double, it stays in its own unit, which `prepared.exponent` names. Of `prepared`, the
/// error and the exponent are filled in.
template <class S>
[[nodiscard]] gjk::Trace<double, 2> widened(const gjk::Trace<S, 2>& trace) {
  gjk::Trace<double, 2> out;
  out.prepared.error = trace.prepared.error;
  int exponent = trace.prepared.exponent;
  if (std::is_same_v<S, double>) {
    out.prepared.exponent = exponent;
    exponent = 0;
  }
  const Widener<S> widen(exponent);
  out.initial = widen(trace.initial);
  for (const gjk::Step<S, 2>& step : trace.steps) {
    out.steps.push_back({step.phase, step.iteration, widen(step.after), widen(step.record), {}});
  }
  out.result = widened(trace.result, exponent);
  return out;
}

}  // namespace gjkscope
