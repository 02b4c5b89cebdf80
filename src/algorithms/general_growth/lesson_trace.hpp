#pragma once
// What methods for general models cost, as steps: one for each size of [growth], then one for each
// thing that Larsen says of them.

#include "algorithms/general_growth/measure.hpp"
#include "lesson/algorithm.hpp"
#include "lesson/lesson.hpp"

namespace gjkscope {

/// The shapes of the lesson are no part of it.
extern const Algorithm kGeneralGrowthAlgorithm;

/// Larsen 1998, "Methods for General Models" to "Conclusions".
enum class Claim : std::uint8_t { brute_force, wider_search, coherence, spheres };
inline constexpr int kClaims = 4;

class GeneralGrowthTrace final : public AlgorithmTrace {
 public:
  explicit GeneralGrowthTrace(const LessonGrowth& growth);

  [[nodiscard]] int steps() const override { return static_cast<int>(samples.size()) + kClaims; }
  [[nodiscard]] StepInfo info(int step) const override;
  [[nodiscard]] double answer(std::string_view name) const override;
  [[nodiscard]] nlohmann::ordered_json json(const Lesson& lesson,
                                            const RunIn<2>& run) const override;
  [[nodiscard]] std::string text(const Lesson& lesson, const RunIn<2>& run) const override;

  std::vector<general_growth::Sample> samples;
};

/// Of a run of an act that shows it.
[[nodiscard]] inline const GeneralGrowthTrace& general_growth_told(const AlgorithmTrace& trace) {
  return static_cast<const GeneralGrowthTrace&>(trace);
}

}  // namespace gjkscope
