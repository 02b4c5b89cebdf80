#pragma once
// Costs of general models in pictures: what a frame shows of them, and what its act draws and says.

#include "algorithms/general_growth/lesson_trace.hpp"
#include "picture/act.hpp"
#include "picture/blocks/blocks.hpp"

namespace gjkscope::costs {

/// What a frame is about: a size, or something that Larsen says.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : told(general_growth_told(run.algorithm_trace(frame))), over(*frame.steps_over) {}

  const GeneralGrowthTrace& told;
  int over = 0;  ///< Steps.

  [[nodiscard]] int sizes() const { return static_cast<int>(told.samples.size()); }
  /// The newest size; at the start the first.
  [[nodiscard]] const general_growth::Sample& sample() const {
    return told.samples[static_cast<std::size_t>(std::clamp(over - 1, 0, sizes() - 1))];
  }
  [[nodiscard]] bool is_size() const { return over >= 1 && over <= sizes(); }
  [[nodiscard]] bool is_claim() const { return over > sizes() && over <= sizes() + kClaims; }
  [[nodiscard]] Claim claim() const { return static_cast<Claim>(over - sizes() - 1); }
};

// blocks.cpp
extern const Block kCosts;

// layers.cpp
bool fill(SceneBuilder& scene, const Fonts& fonts);

// words.cpp
void words(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::costs
