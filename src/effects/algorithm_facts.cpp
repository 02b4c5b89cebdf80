#include "effects/algorithm_facts.hpp"

#include "effects/registry.hpp"

namespace gjkscope {

EffectKey AlgorithmFacts::key(const LessonRun&, const Frame& frame) {
  return {frame.run, *frame.steps_over, -1};
}

const EffectInfo effect_infos::kAlgorithmFacts =
    effect_info<AlgorithmFacts>("frame", "what a frame shows of an algorithm other than GJK");

}  // namespace gjkscope
