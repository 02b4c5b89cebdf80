#include "subjects/lengths/measured.hpp"

#include "run/facts.hpp"
#include "run/questions.hpp"
#include "subjects/lengths/subject.hpp"

namespace gjkscope {

using Eigen::Vector3d;

namespace {

SupportAxis::Side side_of(const std::vector<Vector3d>& vertices, const Vector3d& d, int farthest) {
  SupportAxis::Side side{{}, farthest};
  for (const Vector3d& vertex : vertices) side.reach.push_back(vertex.dot(d));
  return side;
}

}  // namespace

EffectKey SupportAxis::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), frame.part};
}

SupportAxis::Value SupportAxis::compute(EffectGraph& graph, const LessonRun& run,
                                        const Frame& frame) {
  if (!graph.get<FrameFacts>(frame).support) return std::nullopt;
  const WideState& state = run.state(frame);
  if (!(state.d.norm() > 0.0)) return std::nullopt;
  const Vector3d d = state.d.normalized();
  return Sides{d, side_of(run.run(frame).y().world, d, state.support.pair.y),
               side_of(run.run(frame).x().world, -d, state.support.pair.x)};
}

EffectKey ClosestCircle::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), frame.part};
}

ClosestCircle::Value ClosestCircle::compute(EffectGraph& graph, const LessonRun& run,
                                            const Frame& frame) {
  const FrameFacts::Value& knows = graph.get<FrameFacts>(frame);
  if (!knows.phase_is(gjk::Phase::closest) || !knows.closest_point || knows.is_at_query)
    return std::nullopt;
  return run.state(frame).p.norm();
}

EffectKey TestedFeet::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), frame.part};
}

TestedFeet::Value TestedFeet::compute(EffectGraph& graph, const LessonRun& run,
                                      const Frame& frame) {
  Value feet;
  const FrameFacts::Value& knows = graph.get<FrameFacts>(frame);
  if (!knows.gradual || knows.tests_reached < 0) return feet;
  const WideSimplex& simplex = state_before(run.run(frame).trace, run.gjk_step(frame)).simplex;
  const gjk::RegionTest<double>& test = knows.region_tests[knows.tests_reached];
  for (const gjk::RegionTerm<double>& term : test.terms) {
    if (gjk::vertex_count(term.face) != 2 || !(term.denominator > 0.0)) continue;
    Foot foot{term.vertex, 0, term.numerator / term.denominator};
    while (foot.other == foot.vertex || !gjk::contains(term.face, foot.other)) ++foot.other;
    foot.at = foot.value * simplex.vertices[foot.vertex].w +
              (1.0 - foot.value) * simplex.vertices[foot.other].w;
    feet.push_back(foot);
  }
  return feet;
}

const EffectInfo effect_infos::kSupportAxis = effect_info<SupportAxis>(
    "view", "an axis along d with the foot of each vertex: the farthest is the support point");

const EffectInfo effect_infos::kClosestCircle = effect_info<ClosestCircle>(
    "view", "the circle about the query point through P, which touches the closest feature");

const EffectInfo effect_infos::kTestedFeet = effect_info<TestedFeet>(
    "view", "the foot of Q on each edge that a region test asks about, and the lengths compared",
    "test");

}  // namespace gjkscope
