#pragma once
#include "run/graph.hpp"

namespace gjkscope {

/// Facts that a frame shows of an algorithm other than GJK, as a value of the type that its folder
/// makes of a run and a frame. Stage, panel and words all read it here.
struct AlgorithmFacts {
  static constexpr std::string_view kName = "algorithm-facts";
  static constexpr std::string_view kNeeds = "";
  static EffectKey key(const LessonRun& run, const Frame& frame);
};

template <class Shown>
struct AlgorithmFactsAs : AlgorithmFacts {
  using Value = Shown;
  static Value compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
    return Shown(run, frame);
  }
};

/// Such facts for the frame of a scene, a panel or a story.
template <class Shown, class Part>
[[nodiscard]] const Shown& shown_in(const Part& part) {
  return part.effects.template get<AlgorithmFactsAs<Shown>>(part.frame);
}

}  // namespace gjkscope
