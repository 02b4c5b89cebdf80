#pragma once
// Costs of general models in pictures: what a frame shows of them, and what its tour draws and
// says.

#include <array>

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "run/algorithm_facts.hpp"
#include "subjects/general_growth/lesson_trace.hpp"
#include "subjects/growth/choices.hpp"

namespace gjkscope::costs {

inline constexpr AskInfo kAskVisits{
    "visits", "how many times the visits of the last size a size takes", "about size"};
inline constexpr AskInfo kAskMethod{
    "method", "which method is the fastest for the largest outlines", "about size"};
inline constexpr AskInfo kAskAgrees{
    "agrees", "whether what Larsen says agrees with what was measured", "about claim"};

/// How many times the visits of the size before, about: none more, as the segments, or as the
/// pairs.
[[nodiscard]] std::array<GrowthChoice, 3> growth_choices(const general_growth::Sample& before,
                                                         const general_growth::Sample& sample);

/// The subject of a frame: a size, the times of all sizes, or something that Larsen says.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : trace(general_growth_trace(run.algorithm_trace(frame))), over(frame.step + 1) {}

  const GeneralGrowthTrace& trace;
  int over = 0;  ///< Steps.

  [[nodiscard]] int sizes() const { return trace.sizes(); }
  [[nodiscard]] bool is(GrowthPhase phase) const {
    return over >= 1 && over <= trace.steps() && trace.phase(over - 1) == phase;
  }
  /// The newest size; at the start the first.
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(std::clamp(over - 1, 0, sizes() - 1));
  }
  [[nodiscard]] const general_growth::Sample& sample() const { return trace.samples[size()]; }
  /// The number of the claim, from 1.
  [[nodiscard]] int claim_number() const { return over - (trace.steps() - kClaims); }
  [[nodiscard]] Claim claim() const { return static_cast<Claim>(claim_number() - 1); }
  /// The plot is of times: where they are what the frame is about.
  [[nodiscard]] bool plots_times() const {
    return trace.times &&
           (is(GrowthPhase::time) || (is(GrowthPhase::claim) && claim() == Claim::brute_force));
  }
};

// blocks.cpp
extern const Block kCosts;

// layers.cpp
bool fill(SceneBuilder& scene, const Fonts& fonts);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::costs
