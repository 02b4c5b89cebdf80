#pragma once
// An algorithm, as all but its own folders see it: steps with a phase and an iteration, values, and
// what it did as JSON. run/gjk_algorithm.cpp is one, subjects/depth/lesson_trace.cpp another.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "lesson/frame.hpp"
#include "lesson/prose.hpp"

namespace gjkscope {

struct Lesson;
struct PositionedRun;

/// A record of what an algorithm did with the shapes of one run.
class AlgorithmTrace {
 public:
  virtual ~AlgorithmTrace() = default;
  [[nodiscard]] virtual int steps() const = 0;
  /// The place of a step in the algorithm. `step`: from 0, less than steps().
  [[nodiscard]] virtual StepInfo info(int step) const = 0;
  /// The answer of this name, one of Algorithm::answers; NaN without such an answer.
  [[nodiscard]] virtual double answer(std::string_view name) const = 0;
  /// Why it ended: one of Algorithm::stops; empty where it has no stop reasons.
  [[nodiscard]] virtual std::string_view stop() const { return {}; }
  /// Null where the run itself has it all.
  [[nodiscard]] virtual nlohmann::ordered_json json(const Lesson& lesson,
                                                    const PositionedRun& run) const = 0;
};

/// A tour names the one that it shows; it runs wherever the shapes stand.
struct Algorithm {
  std::string_view name;                      ///< "depth": its key in a trace.
  std::span<const std::string_view> phases;   ///< In the order of their numbers.
  std::span<const std::string_view> answers;  ///< Those that `expect.answer` can check.
  std::span<const PlaceholderInfo> values;    ///< The values that prose can name.
  /// `before`: what it did in the run before, along a path; nullptr in the first.
  std::shared_ptr<const AlgorithmTrace> (*run)(const Lesson& lesson, const PositionedRun& run,
                                               const AlgorithmTrace* before) = nullptr;
  /// It asks about the outlines of the shapes, convex or not, and no run of GJK is made. Others are
  /// GJK, or go on where it ends.
  bool takes_outlines = false;
  /// The names of its stop reasons, which `expect.stop` can check where no run of GJK is made.
  std::span<const std::string_view> stops = {};
  /// A trace as text, made of the JSON of it and of the whole document; nullptr: as run/fields.hpp
  /// writes all.
  std::string (*text)(const nlohmann::ordered_json& document,
                      const nlohmann::ordered_json& trace) = nullptr;
};

}  // namespace gjkscope
