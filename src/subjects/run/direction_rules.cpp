#include "subjects/run/direction_rules.hpp"

#include <cmath>

#include "run/scalar.hpp"
#include "run/widen.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope {

EffectKey DirectionRules::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), -1};
}

DirectionRules::Value DirectionRules::compute(EffectGraph&, const LessonRun& run,
                                              const Frame& frame) {
  const WideState& state = run.state(frame);
  Value built;
  if (state.simplex.count != 2) return built;
  with_scalar(run.lesson.scalar, [&]<class S>(std::type_identity<S>) {
    // In the run's own unit, as the run built its direction.
    const int exponent = run.run(frame).exponent;
    const gjk::Simplex<S, 2> simplex = narrowed_simplex<S, 2>(state.simplex, exponent);
    const gjk::Vec<S, 2> p = narrowed<S, 2>(Eigen::Vector3d(state.p * std::ldexp(1.0, -exponent)));
    const gjk::Vec<S, 2> edge = simplex.vertices[1].w - simplex.vertices[0].w;
    for (const gjk::DirectionRule rule :
         {gjk::DirectionRule::towards_origin, gjk::DirectionRule::perpendicular}) {
      const gjk::DirectionNote<S, 2> note = gjk::search_direction(simplex, p, rule);
      built.push_back({rule, widened<S, 2>(note.d) * std::ldexp(1.0, exponent),
                       std::ldexp(widened(gjk::dot(note.d, edge)), 2 * exponent)});
    }
  });
  return built;
}

const EffectInfo effect_infos::kDirectionRules =
    effect_info<DirectionRules>("panel", "both ways to build the search direction");

}  // namespace gjkscope
