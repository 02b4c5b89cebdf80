#pragma once
// [second]: the run that a lesson sets beside its own.

#include <memory>
#include <optional>
#include <string>

#include "judge/log.hpp"
#include "lesson/act_table.hpp"

namespace gjkscope {

/// One of the three is set.
struct LessonSecond {
  std::string mistake;                      ///< The loop of this name (mistakes/mistakes.hpp).
  std::optional<ScalarKind> scalar;         ///< GJK in this scalar.
  std::shared_ptr<const judging::Log> log;  ///< From the file; in the plane.
  static const TableKind kKind;
  /// A log's text is compared by its file.
  friend bool operator==(const LessonSecond& a, const LessonSecond& b) {
    return a.mistake == b.mistake && a.scalar == b.scalar && a.log == b.log;
  }
};

}  // namespace gjkscope
