#include "subjects/run/direction_rules.hpp"

#include <cmath>
#include <numbers>

#include "run/scalar.hpp"
#include "run/widen.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope {
namespace {

template <class S, int D>
DirectionRules::Value built_in(const WideState& state, int exponent) {
  // In the run's own unit, as the run built its direction.
  const gjk::Simplex<S, D> simplex = narrowed_simplex<S, D>(state.simplex, exponent);
  const gjk::Vec<S, D> p = narrowed<S, D>(Eigen::Vector3d(state.p * std::ldexp(1.0, -exponent)));
  const gjk::Vec<S, D> edge = simplex.vertices[1].w - simplex.vertices[0].w;
  const Eigen::Vector3d wide_edge = state.simplex.vertices[1].w - state.simplex.vertices[0].w;
  DirectionRules::Value built;
  for (const gjk::DirectionRule rule :
       {gjk::DirectionRule::towards_origin, gjk::DirectionRule::perpendicular}) {
    const gjk::DirectionNote<S, D> note = gjk::search_direction(simplex, p, rule);
    const Eigen::Vector3d d = widened<S, D>(note.d) * std::ldexp(1.0, exponent);
    const double sine = std::abs(d.dot(wide_edge)) / (d.norm() * wide_edge.norm());
    built.push_back({rule, d, std::ldexp(widened(gjk::dot(note.d, edge)), 2 * exponent),
                     std::asin(sine) * 180.0 / std::numbers::pi});
  }
  return built;
}

}  // namespace

EffectKey DirectionRules::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), -1};
}

DirectionRules::Value DirectionRules::compute(EffectGraph&, const LessonRun& run,
                                              const Frame& frame) {
  const WideState& state = run.state(frame);
  Value built;
  if (state.simplex.count != 2) return built;
  with_scalar(run.lesson.scalar, [&]<class S>(std::type_identity<S>) {
    const int exponent = run.run(frame).exponent;
    built = run.lesson.dimension == 3 ? built_in<S, 3>(state, exponent)
                                      : built_in<S, 2>(state, exponent);
  });
  return built;
}

const EffectInfo effect_infos::kDirectionRules = shown_of(
    ShownOf::both, effect_info<DirectionRules>("panel", "both ways to build the search direction"));

}  // namespace gjkscope
