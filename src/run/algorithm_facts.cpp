#include "run/algorithm_facts.hpp"

#include "run/effect_info.hpp"

namespace gjkscope {

EffectKey AlgorithmFacts::key(const LessonRun&, const Frame& frame) {
  return {frame.run, frame.step, -1};
}

const EffectInfo effect_infos::kAlgorithmFacts =
    effect_info<AlgorithmFacts>("frame", "what a frame shows of an algorithm other than GJK");

}  // namespace gjkscope
