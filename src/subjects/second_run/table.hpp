#pragma once
// [second]: the run that a lesson sets beside its own.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "judge/log.hpp"
#include "lesson/lesson.hpp"
#include "lesson/tour_settings.hpp"

namespace gjkscope {

/// A mistake, a log, or GJK by the lesson's query but for what is set here.
struct LessonSecond {
  std::string mistake = {};                      ///< The loop of this name (mistakes/mistakes.hpp).
  std::shared_ptr<const judging::Log> log = {};  ///< From the file; in the plane.
  std::optional<ScalarKind> scalar = {};
  std::optional<gjk::DirectionRule> direction = {};
  std::optional<gjk::RegionOrder> regions = {};
  std::optional<std::array<bool, 2>> stop = {};  ///< Whether to stop on a repeated support point,
                                                 ///< and on no progress.
  static constexpr std::string_view kTable = "second";
  static const SettingsKind kKind;

  [[nodiscard]] bool is_gjk() const { return mistake.empty() && !log; }
  [[nodiscard]] bool has_rules() const { return direction || regions || stop; }
  /// A lesson's options with the rules of the second run.
  [[nodiscard]] gjk::Options options(gjk::Options first) const;
  /// Its rules in words: "regions unchecked".
  [[nodiscard]] std::string rules() const;
  /// A log's text is compared by its file.
  friend bool operator==(const LessonSecond& a, const LessonSecond& b) {
    return a.mistake == b.mistake && !a.log == !b.log && a.scalar == b.scalar &&
           a.direction == b.direction && a.regions == b.regions && a.stop == b.stop;
  }
};

/// nullptr where the lesson has none.
[[nodiscard]] const LessonSecond* second_of(const Lesson& lesson);

}  // namespace gjkscope
