#include "subjects/issues/numerical_issue.hpp"

#include <algorithm>
#include <cmath>

#include "subjects/issues/subject.hpp"
#include "subjects/run/direction_rules.hpp"
#include "subjects/shape_hull/shape_hull.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;

/// The last step of a phase; -1 where there is none.
int last_of(const WideTrace& trace, gjk::Phase phase) {
  for (int i = static_cast<int>(trace.steps.size()) - 1; i >= 0; --i)
    if (trace.steps[i].phase == phase) return i;
  return -1;
}

/// Those of Y that are farthest along d, as far as rounding can tell.
std::vector<int> all_farthest(const std::vector<Vector3d>& vertices, const Vector3d& d) {
  constexpr double kEqual = 1e-6;
  double most = -HUGE_VAL;
  double least = HUGE_VAL;
  for (const Vector3d& vertex : vertices) {
    most = std::max(most, d.dot(vertex));
    least = std::min(least, d.dot(vertex));
  }
  std::vector<int> out;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (d.dot(vertices[i]) >= most - kEqual * (most - least)) out.push_back(static_cast<int>(i));
  }
  return out;
}

/// Whether two vertices are neighbours on the hull.
bool is_edge(const std::vector<int>& corners, int a, int b) {
  const auto place = std::find(corners.begin(), corners.end(), a) - corners.begin();
  const auto count = static_cast<std::ptrdiff_t>(corners.size());
  if (place == count) return false;
  return corners[(place + 1) % count] == b || corners[(place + count - 1) % count] == b;
}

}  // namespace

EffectKey NumericalIssue::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

NumericalIssue::Value NumericalIssue::compute(EffectGraph& graph, const LessonRun& run,
                                              const Frame& frame) {
  const PositionedRun& positioned = run.run(frame);
  const WideResult& result = positioned.trace.result;
  const ShapeHull::Value& hulls = graph.get<ShapeHull>(frame);
  Value value;
  const int direction = last_of(positioned.trace, gjk::Phase::direction);
  if (direction >= 0) {
    const Frame chosen{.run = frame.run, .step = direction};
    for (const DirectionRules::Built& built : graph.get<DirectionRules>(chosen)) {
      if (built.rule == gjk::DirectionRule::towards_origin)
        value.dot_with_edge = built.dot_with_edge;
    }
    value.support = all_farthest(positioned.y().world, run.state(chosen).d);
  }
  const auto y_of = [&](int i) { return result.simplex.vertices[i].pair.y; };
  if (result.distance > 0.0) {
    value.kind = value.support.size() > 2    ? Kind::collinear
                 : result.simplex.count == 2 ? Kind::direction
                                             : Kind::repeated;
  } else if (hulls.outline_distance > 0.0) {
    value.kind = Kind::notch;
  } else if (result.simplex.count == 3) {
    value.kind = Kind::contained;
  } else if (result.simplex.count == 1) {
    value.kind = Kind::vertex;
  } else {
    value.kind = is_edge(hulls.y.corners, y_of(0), y_of(1)) ? Kind::edge : Kind::interior;
  }
  return value;
}

const EffectInfo effect_infos::kNumericalIssue =
    effect_info<NumericalIssue>("view", "the places of Q before this one", "issues");

}  // namespace gjkscope
