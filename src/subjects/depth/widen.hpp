#pragma once
// Traces of penetration depth in any scalar, widened to double for pictures and files.

#include "depth/depth.hpp"
#include "run/widen.hpp"

namespace gjkscope {

/// The trace in double and in the world's unit, but for that of GJK, which stands beside it.
template <class S>
[[nodiscard]] depth::Trace<double> widened(const depth::Trace<S>& trace) {
  const double unit = std::ldexp(1.0, trace.gjk.prepared.exponent);
  const auto point = [&](const gjk::SupportPoint<S, 2>& value) {
    return gjk::SupportPoint<double, 2>{in_plane(widened<S, 2>(value.w)) * unit, value.pair};
  };
  const auto edge = [&](const depth::Edge<S>& value) {
    return depth::Edge<double>{value.from, value.to, widened(value.distance_sq) * unit * unit};
  };
  const auto edges = [&](const std::vector<depth::Edge<S>>& values) {
    std::vector<depth::Edge<double>> out;
    for (const depth::Edge<S>& value : values) out.push_back(edge(value));
    return out;
  };
  const auto state = [&](const depth::State<S>& value) {
    depth::State<double> out;
    out.phase = value.phase;
    out.iteration = value.iteration;
    for (const depth::Corner<S>& corner : value.polygon.corners)
      out.polygon.corners.push_back({point(corner.point), corner.previous, corner.next});
    out.polygon.count = value.polygon.count;
    out.polygon.first = value.polygon.first;
    out.polygon.edges = edges(value.polygon.edges);
    out.edge = edge(value.edge);
    out.n = in_plane(widened<S, 2>(value.n)) * unit;
    out.support = point(value.support);
    out.stop = value.stop;
    return out;
  };
  const auto scan = [&](const std::vector<gjk::ScanEntry<S>>& entries) {
    std::vector<gjk::ScanEntry<double>> out;
    for (const gjk::ScanEntry<S>& entry : entries)
      out.push_back({entry.index, widened(entry.value) * unit * unit, entry.improves});
    return out;
  };

  depth::Trace<double> out;
  out.initial = state(trace.initial);
  for (const depth::Step<S>& step : trace.steps) {
    depth::Record<double> record{edges(step.record.edges),
                                 scan(step.record.scan_x),
                                 scan(step.record.scan_y),
                                 {},
                                 step.record.outgrown};
    for (const depth::StopTest<S>& test : step.record.stop_tests) {
      const double factor = test.reason == depth::StopReason::no_progress ? unit * unit : 1.0;
      record.stop_tests.push_back({test.reason, test.tried, test.holds, widened(test.left) * factor,
                                   widened(test.right) * factor});
    }
    out.steps.push_back({step.phase,
                         step.iteration,
                         state(step.after),
                         std::move(record),
                         {widened(step.bounds.lower) * unit, widened(step.bounds.upper) * unit}});
  }
  const depth::Result<S>& result = trace.result;
  out.result.error = result.error;
  out.result.stop = result.stop;
  out.result.verdict = result.verdict;
  out.result.settled = result.settled;
  out.result.depth = widened(result.depth);
  out.result.lower = widened(result.lower);
  out.result.upper = widened(result.upper);
  for (int i = 0; i < 2; ++i) out.result.direction[i] = widened(result.direction[i]);
  out.result.translation = in_plane(widened<S, 2>(result.translation));
  out.result.x = in_plane(widened<S, 2>(result.x));
  out.result.y = in_plane(widened<S, 2>(result.y));
  out.result.iterations = result.iterations;
  out.result.face = in_plane(widened(result.face, trace.gjk.prepared.exponent));
  return out;
}

}  // namespace gjkscope
