#pragma once
// Traces of algorithms that ask about outlines: what they need of a lesson, and their steps.

#include <optional>
#include <string>
#include <vector>

#include "lesson/algorithm.hpp"
#include "outlines/outline.hpp"
#include "run/fields.hpp"

namespace gjkscope {

/// X and Y where a run puts them.
struct OutlinesOfRun {
  models::Model x;
  models::Model y;
};
[[nodiscard]] OutlinesOfRun outlines_of(const Lesson& lesson, const PositionedRun& run);

/// Why an algorithm does not take the outlines.
struct Refusal {
  models::Flaw flaw;
  bool of_y = false;
};
/// The first flaw of X, else of Y.
[[nodiscard]] std::optional<Refusal> refusal_of(const OutlinesOfRun& outlines, models::Needs needs);
/// "X: the outline is not convex"
[[nodiscard]] std::string words_of(const Refusal& refusal, const Lesson& lesson);

/// A trace with a step, and a result, in JSON.
class OutlineTrace : public AlgorithmTrace {
 public:
  explicit OutlineTrace(std::optional<Refusal> refused) : refusal(refused) {}
  [[nodiscard]] nlohmann::ordered_json json(const Lesson& lesson,
                                            const PositionedRun& run) const final;

  std::optional<Refusal> refusal;  ///< Then there are no steps.

 protected:
  /// The content of a step, without its phase and iteration.
  [[nodiscard]] virtual fields::Json step_json(const Lesson& lesson, int step) const = 0;
  [[nodiscard]] virtual fields::Json result_json(const Lesson& lesson) const = 0;
};

}  // namespace gjkscope
