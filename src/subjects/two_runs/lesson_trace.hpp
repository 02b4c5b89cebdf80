#pragma once
// Two runs about the same shapes: the lesson's, and another one, beside each other.

#include <array>
#include <optional>

#include "judge/judge.hpp"
#include "lesson/algorithm.hpp"
#include "run/run.hpp"

namespace gjkscope {

extern const Algorithm kTwoRunsAlgorithm;

/// The same phase of the same iteration in both runs.
struct TwoRunsStep {
  int iteration = 1;
  gjk::Phase phase = gjk::Phase::closest;
  /// The step of each run, or, where it has ended, its last.
  std::array<int, 2> at = {-1, -1};
};

class TwoRunsTrace final : public AlgorithmTrace {
 public:
  [[nodiscard]] int steps() const override { return static_cast<int>(shown.size()); }
  [[nodiscard]] StepInfo info(int step) const override;
  /// "second-distance", or "error", the second run's.
  [[nodiscard]] double answer(std::string_view name) const override;
  [[nodiscard]] nlohmann::ordered_json json(const Lesson& lesson,
                                            const PositionedRun& run) const override;

  /// The first run from where the second one starts, and that. The first run alone, twice, where
  /// the shapes of a log have moved since, or a scalar has no numbers for them.
  std::array<LessonRun, 2> runs;
  bool fits = true;  ///< The second run is about these shapes.
  std::vector<TwoRunsStep> shown;
  int parting = -1;  ///< Index of the step in which they first differ, or the second is wrong.
  std::optional<judging::Judgement> judgement;  ///< None of a second run of this GJK.
  double exact = 0.0;                           ///< The distance.
};

/// Only of a run of the tour that shows this algorithm.
[[nodiscard]] const TwoRunsTrace& two_runs_of(const LessonRun& run, const Frame& frame);

}  // namespace gjkscope
