#pragma once
// Traces in any scalar, widened to double for pictures and files.

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "exact/rational.hpp"
#include "gjk/gjk.hpp"
#include "run/wide.hpp"

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
[[nodiscard]] Eigen::Vector3d widened(const gjk::Vec<S, D>& v) {
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  for (int i = 0; i < D; ++i) out[i] = widened(v[i]);
  return out;
}
/// Coordinates beyond D are left out.
template <class S, int D>
[[nodiscard]] gjk::Vec<S, D> narrowed(const auto& v) {
  gjk::Vec<S, D> out;
  for (int i = 0; i < D; ++i) out[i] = S(v[i]);
  return out;
}
template <class S, int D>
[[nodiscard]] std::vector<gjk::Vec<S, D>> narrowed_all(const auto& vertices) {
  std::vector<gjk::Vec<S, D>> out;
  for (const auto& vertex : vertices) out.push_back(narrowed<S, D>(vertex));
  return out;
}

/// A simplex in units of 2^exponent, in the world's unit, and back.
template <class S, int D>
[[nodiscard]] WideSimplex widened(const gjk::Simplex<S, D>& simplex, int exponent) {
  WideSimplex out;
  out.count = simplex.count;
  for (int i = 0; i < simplex.count; ++i) {
    out.vertices[i] = {widened<S, D>(simplex.vertices[i].w) * std::ldexp(1.0, exponent),
                       simplex.vertices[i].pair};
    out.weights[i] = widened(simplex.weights[i]);
  }
  return out;
}
template <class S, int D>
[[nodiscard]] gjk::Simplex<S, D> narrowed_simplex(const WideSimplex& simplex, int exponent) {
  gjk::Simplex<S, D> out;
  out.count = simplex.count;
  for (int i = 0; i < simplex.count; ++i) {
    out.vertices[i] = {
        narrowed<S, D>(Eigen::Vector3d(simplex.vertices[i].w * std::ldexp(1.0, -exponent))),
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

  [[nodiscard]] WideState operator()(const gjk::State<S, D>& state) const {
    WideState out;
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

  [[nodiscard]] WideRecord operator()(const gjk::Record<S, D>& record) const {
    WideRecord out;
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
  [[nodiscard]] Eigen::Vector3d length(const gjk::Vec<S, D>& v) const {
    return widened<S, D>(v) * unit_;
  }
  [[nodiscard]] double square(const S& value) const { return widened(value) * unit_sq_; }
  [[nodiscard]] WideVertex point(const gjk::SupportPoint<S, D>& value) const {
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
[[nodiscard]] WideResult widened(const gjk::Result<S, D>& result, int exponent) {
  WideResult out;
  out.error = result.error;
  out.stop = result.stop;
  out.verdict = result.verdict;
  out.settled = result.settled;
  out.distance = widened(result.distance);
  out.lower = widened(result.lower);
  out.upper = widened(result.upper);
  out.distance_sq = widened(result.distance_sq);
  out.x = widened<S, D>(result.x);
  out.y = widened<S, D>(result.y);
  out.iterations = result.iterations;
  out.simplex = widened(result.simplex, exponent);
  return out;
}

/// It stays in the run's unit in space, where products are of up to six lengths.
template <class S, int D>
[[nodiscard]] WideTrace widened(const gjk::Trace<S, D>& trace) {
  WideTrace out;
  out.dimension = D;
  int exponent = trace.prepared.exponent;
  if (D == 3 || std::is_same_v<S, double>) out.exponent = std::exchange(exponent, 0);
  const Widener<S, D> widen(exponent);
  out.initial = widen(trace.initial);
  for (const gjk::Step<S, D>& step : trace.steps) {
    out.steps.push_back({step.phase, step.iteration, widen(step.after), widen(step.record), {}});
  }
  out.result = widened(trace.result, exponent);
  return out;
}

}  // namespace gjkscope
