#pragma once
// Traces in any scalar, widened to double for pictures and files.

#include <cmath>
#include <type_traits>
#include <vector>

#include "exact/rational.hpp"
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
template <class S, int D>
[[nodiscard]] gjk::Vec<double, D> widened(const gjk::Vec<S, D>& v) {
  gjk::Vec<double, D> out;
  for (int i = 0; i < D; ++i) out[i] = widened(v[i]);
  return out;
}
template <class S, int D>
[[nodiscard]] gjk::Vec<S, D> narrowed(const gjk::Vec<double, D>& v) {
  gjk::Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = S(v[i]);
  return out;
}
template <class S, int D>
[[nodiscard]] std::vector<gjk::Vec<S, D>> narrowed_all(
    const std::vector<gjk::Vec<double, D>>& vertices) {
  std::vector<gjk::Vec<S, D>> out;
  for (const gjk::Vec<double, D>& vertex : vertices) out.push_back(narrowed<S, D>(vertex));
  return out;
}

/// A simplex in units of 2^exponent, in the world's unit, and back.
template <class S, int D>
[[nodiscard]] gjk::Simplex<double, D> widened(const gjk::Simplex<S, D>& simplex, int exponent) {
  gjk::Simplex<double, D> out;
  out.count = simplex.count;
  for (int i = 0; i <= D; ++i) {
    out.vertices[i] = {widened(simplex.vertices[i].w) * std::ldexp(1.0, exponent),
                       simplex.vertices[i].pair};
    out.weights[i] = widened(simplex.weights[i]);
  }
  return out;
}
template <class S, int D>
[[nodiscard]] gjk::Simplex<S, D> narrowed(const gjk::Simplex<double, D>& simplex, int exponent) {
  gjk::Simplex<S, D> out;
  out.count = simplex.count;
  for (int i = 0; i <= D; ++i) {
    out.vertices[i] = {narrowed<S, D>(simplex.vertices[i].w * std::ldexp(1.0, -exponent)),
                       simplex.vertices[i].pair};
    out.weights[i] = S(simplex.weights[i]);
  }
  return out;
}

/// Widens what a run in units of 2^exponent left, to the world's unit: powers of two are exact.
template <class S, int D>
class Widener {
 public:
  explicit Widener(int exponent)
      : exponent_(exponent),
        unit_(std::ldexp(1.0, exponent)),
        unit_sq_(std::ldexp(1.0, 2 * exponent)) {}

  [[nodiscard]] gjk::State<double, D> operator()(const gjk::State<S, D>& state) const {
    gjk::State<double, D> out;
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
    out.evidence.best = widened(state.evidence.best, exponent_);
    out.evidence.best_sq = square(state.evidence.best_sq);
    out.evidence.plane_distance_sq = square(state.evidence.plane_distance_sq);
    out.evidence.plane_reach_sq = square(state.evidence.plane_reach_sq);
    out.evidence.touches_plane = state.evidence.touches_plane;
    out.stop = state.stop;
    out.error = state.error;
    return out;
  }

  [[nodiscard]] gjk::Record<double, D> operator()(const gjk::Record<S, D>& record) const {
    gjk::Record<double, D> out;
    for (const gjk::RegionTest<S>& test : record.region_tests) {
      gjk::RegionTest<double> wide{test.region, {}, test.holds};
      for (const gjk::RegionTerm<S>& term : test.terms) {
        wide.terms.push_back({term.face, term.vertex, term.wants_positive, square(term.numerator),
                              square(term.denominator), term.holds});
      }
      out.region_tests.push_back(std::move(wide));
    }
    out.no_region_held = record.no_region_held;
    for (const gjk::SupportPoint<S, D>& dropped : record.dropped)
      out.dropped.push_back(point(dropped));
    const gjk::DirectionNote<S, D>& note = record.direction;
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
  [[nodiscard]] gjk::Vec<double, D> length(const gjk::Vec<S, D>& v) const {
    return widened(v) * unit_;
  }
  [[nodiscard]] double square(const S& value) const { return widened(value) * unit_sq_; }
  [[nodiscard]] gjk::SupportPoint<double, D> point(const gjk::SupportPoint<S, D>& value) const {
    return {length(value.w), value.pair};
  }

  [[nodiscard]] gjk::StopTest<double> widen(const gjk::StopTest<S>& test) const {
    double factor = 1.0;
    if (test.reason == gjk::StopReason::zero_direction) factor = unit_;
    if (test.reason == gjk::StopReason::not_nearer || test.reason == gjk::StopReason::no_progress ||
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
template <class S, int D>
[[nodiscard]] gjk::Result<double, D> widened(const gjk::Result<S, D>& result, int exponent) {
  gjk::Result<double, D> out;
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

/// The trace in double and, in the plane, in the world's unit. Where the squares of a double run
/// would leave the range of a double, and in space, where products are of up to six lengths, it
/// stays in its own unit, which `prepared.exponent` names. Of `prepared`, the error and the
/// exponent are filled in.
template <class S, int D>
[[nodiscard]] gjk::Trace<double, D> widened(const gjk::Trace<S, D>& trace) {
  gjk::Trace<double, D> out;
  out.prepared.error = trace.prepared.error;
  int exponent = trace.prepared.exponent;
  if (D == 3 || std::is_same_v<S, double>) {
    out.prepared.exponent = exponent;
    exponent = 0;
  }
  const Widener<S, D> widen(exponent);
  out.initial = widen(trace.initial);
  for (const gjk::Step<S, D>& step : trace.steps) {
    out.steps.push_back({step.phase, step.iteration, widen(step.after), widen(step.record), {}});
  }
  out.result = widened(trace.result, exponent);
  return out;
}

}  // namespace gjkscope
