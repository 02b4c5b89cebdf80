#pragma once
// Traces of penetration depth in any scalar, widened to double for pictures and files.

#include "depth/instances.hpp"
#include "run/widen.hpp"

namespace gjkscope {

/// Widens what a run in units of 2^exponent left, to the world's unit. Normals, whose length says
/// nothing, stay in that of the run in space.
template <class S, int D>
class DepthWidener {
 public:
  explicit DepthWidener(int exponent) : exponent_(exponent), unit_(std::ldexp(1.0, exponent)) {}

  [[nodiscard]] depth::State<double> operator()(const depth::State<S>& value) const {
    depth::State<double> out;
    set_common(out, value, unit_);
    for (const depth::Corner<S>& corner : value.polygon.corners)
      out.polygon.corners.push_back({point(corner.point), corner.previous, corner.next});
    out.polygon.count = value.polygon.count;
    out.polygon.first = value.polygon.first;
    out.polygon.edges = edges(value.polygon.edges);
    out.edge = edge(value.edge);
    return out;
  }

  [[nodiscard]] depth::space::State<double> operator()(const depth::space::State<S>& value) const {
    depth::space::State<double> out;
    set_common(out, value, 1.0);
    for (const gjk::SupportPoint<S, 3>& corner : value.polytope.corners)
      out.polytope.corners.push_back(point(corner));
    for (const depth::space::Face<S>& face : value.polytope.faces) {
      out.polytope.faces.push_back({{.distance_sq = square(face.distance_sq)},
                                    face.corners,
                                    face.neighbours,
                                    face.is_outgrown});
    }
    out.face = value.face;
    return out;
  }

  [[nodiscard]] depth::Record<double> operator()(const depth::Record<S>& record) const {
    return {notes(record), edges(record.edges)};
  }

  [[nodiscard]] depth::space::Record<double> operator()(
      const depth::space::Record<S>& record) const {
    return {notes(record), record.faces, record.added};
  }

  [[nodiscard]] depth::Result<double, D> operator()(const depth::Result<S, D>& result) const {
    depth::Result<double, D> out;
    out.error = result.error;
    out.stop = result.stop;
    out.verdict = result.verdict;
    out.settled = result.settled;
    out.depth = widened(result.depth);
    out.lower = widened(result.lower);
    out.upper = widened(result.upper);
    for (int i = 0; i < D; ++i) out.direction[i] = widened(result.direction[i]);
    out.translation = vector(result.translation, 1.0);
    out.x = vector(result.x, 1.0);
    out.y = vector(result.y, 1.0);
    out.iterations = result.iterations;
    if constexpr (D == 2) {
      out.face = in_plane(widened(result.face, exponent_));
    } else {
      out.face = widened(result.face, exponent_);
    }
    return out;
  }

  [[nodiscard]] depth::Bounds<double> bounds(const auto& value) const {
    return {widened(value.lower) * unit_, widened(value.upper) * unit_};
  }

 private:
  template <class To, class From>
  void set_common(To& out, const From& value, double unit_of_normal) const {
    out.phase = value.phase;
    out.iteration = value.iteration;
    out.n = vector(value.n, unit_of_normal);
    out.support = point(value.support);
    out.stop = value.stop;
  }
  [[nodiscard]] static gjk::Vec<double, D> vector(const gjk::Vec<S, D>& value, double unit) {
    return widened<S, D>(value).template head<D>() * unit;
  }
  [[nodiscard]] double square(const S& value) const { return widened(value) * unit_ * unit_; }
  [[nodiscard]] gjk::SupportPoint<double, D> point(const gjk::SupportPoint<S, D>& value) const {
    return {vector(value.w, unit_), value.pair};
  }
  [[nodiscard]] depth::Edge<double> edge(const depth::Edge<S>& value) const {
    return {value.from, value.to, square(value.distance_sq)};
  }
  [[nodiscard]] std::vector<depth::Edge<double>> edges(
      const std::vector<depth::Edge<S>>& values) const {
    std::vector<depth::Edge<double>> out;
    for (const depth::Edge<S>& value : values) out.push_back(edge(value));
    return out;
  }
  [[nodiscard]] std::vector<gjk::ScanEntry<double>> scan(
      const std::vector<gjk::ScanEntry<S>>& entries) const {
    const double factor = D == 2 ? unit_ * unit_ : unit_;
    std::vector<gjk::ScanEntry<double>> out;
    for (const gjk::ScanEntry<S>& entry : entries)
      out.push_back({entry.index, widened(entry.value) * factor, entry.improves});
    return out;
  }
  [[nodiscard]] depth::Notes<double> notes(const depth::Notes<S>& value) const {
    return {scan(value.scan_x), scan(value.scan_y), tests(value.stop_tests), value.outgrown};
  }
  [[nodiscard]] std::vector<depth::StopTest<double>> tests(
      const std::vector<depth::StopTest<S>>& values) const {
    const double of_progress = D == 2 ? unit_ * unit_ : unit_;
    std::vector<depth::StopTest<double>> out;
    for (const depth::StopTest<S>& test : values) {
      const double factor = test.reason == depth::StopReason::no_progress ? of_progress : 1.0;
      out.push_back({test.reason, test.tried, test.holds, widened(test.left) * factor,
                     widened(test.right) * factor});
    }
    return out;
  }

  int exponent_;
  double unit_;
};

/// The trace `Out` in double and in the world's unit, but for that of GJK, which stands beside it.
template <class S, int D, class Out, class In>
[[nodiscard]] Out widened_depth(const In& trace) {
  const DepthWidener<S, D> widen(trace.gjk.prepared.exponent);
  Out out;
  out.initial = widen(trace.initial);
  for (const auto& step : trace.steps) {
    out.steps.push_back({step.phase, step.iteration, widen(step.after), widen(step.record),
                         widen.bounds(step.bounds)});
  }
  out.result = widen(trace.result);
  return out;
}

}  // namespace gjkscope
