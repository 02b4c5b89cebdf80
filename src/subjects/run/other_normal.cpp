#include "subjects/run/other_normal.hpp"

#include <algorithm>

#include "run/facts.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope {

using Eigen::Vector3d;

namespace {

int farthest(const std::vector<Vector3d>& vertices, const Vector3d& d) {
  const auto less = [&](const Vector3d& a, const Vector3d& b) { return a.dot(d) < b.dot(d); };
  return static_cast<int>(std::max_element(vertices.begin(), vertices.end(), less) -
                          vertices.begin());
}

/// The step that chose d, of the frame's iteration; none before it.
const WideStep* direction_step(const LessonRun& run, const Frame& frame) {
  const std::vector<WideStep>& steps = run.run(frame).trace.steps;
  for (int i = run.gjk_step(frame); i >= 0; --i) {
    const WideStep& step = steps[i];
    if (step.phase == gjk::Phase::direction) return &step;
    if (step.phase == gjk::Phase::closest) break;
  }
  return nullptr;
}

}  // namespace

EffectKey OtherNormal::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), frame.part};
}

OtherNormal::Value OtherNormal::compute(EffectGraph& graph, const LessonRun& run,
                                        const Frame& frame) {
  const WideStep* step = direction_step(run, frame);
  if (!graph.get<FrameFacts>(frame).direction || step == nullptr ||
      !step->record.direction.sign_is_arbitrary)
    return std::nullopt;
  Search search{-run.state(frame).d, {}, false};
  search.support = {farthest(run.run(frame).x().world, -search.d),
                    farthest(run.run(frame).y().world, search.d)};
  const WideSimplex& simplex = run.state(frame).simplex;
  for (int i = 0; i < simplex.count; ++i)
    search.in_simplex |= simplex.vertices[i].pair == search.support;
  return search;
}

const EffectInfo effect_infos::kOtherNormal = effect_info<OtherNormal>(
    "view", "where Q lies on the simplex, a segment: the other normal, and what it finds");

}  // namespace gjkscope
