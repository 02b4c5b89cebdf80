#pragma once
// The cost of methods for general models, as steps: one for each size of [growth], one for the
// times if the lesson has some, then one for each of Larsen's claims about them.

#include "lesson/algorithm.hpp"
#include "lesson/lesson.hpp"
#include "subjects/general_growth/measure.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope {

enum class GrowthPhase : std::uint8_t { size, time, claim };

/// The shapes of the lesson are no part of it.
extern const Algorithm kGeneralGrowthAlgorithm;

/// Larsen 1998, "Methods for General Models" to "Conclusions".
enum class Claim : std::uint8_t { brute_force, wider_search, coherence };
inline constexpr int kClaims = 3;

class GeneralGrowthTrace final : public AlgorithmTrace {
 public:
  explicit GeneralGrowthTrace(const LessonGrowth& growth);

  [[nodiscard]] int sizes() const { return static_cast<int>(samples.size()); }
  [[nodiscard]] int steps() const override { return sizes() + (times ? 1 : 0) + kClaims; }
  [[nodiscard]] GrowthPhase phase(int step) const;
  [[nodiscard]] StepInfo info(int step) const override;
  [[nodiscard]] double answer(std::string_view name) const override;
  [[nodiscard]] nlohmann::ordered_json json(const Lesson& lesson,
                                            const PositionedRun& run) const override;

  /// Whether the largest outlines bear it out: by the times where there are some, else by counts.
  /// Nothing measured bears on the claim about coherence.
  [[nodiscard]] bool agrees(Claim claim) const;

  std::vector<general_growth::Sample> samples;
  std::optional<GrowthTimes> times;
};

/// Only for traces of runs of a tour that shows this algorithm.
[[nodiscard]] inline const GeneralGrowthTrace& general_growth_trace(const AlgorithmTrace& trace) {
  return static_cast<const GeneralGrowthTrace&>(trace);
}

}  // namespace gjkscope
