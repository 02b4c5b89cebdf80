#pragma once
// From what a command line names to lessons and texts.

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "lesson/case.hpp"
#include "lesson/load.hpp"

namespace gjkscope {

/// The file that a lesson's id or path names. Says on `env.err` what there is instead, and gives
/// nothing, when there is none.
[[nodiscard]] std::optional<std::filesystem::path> lesson_file(const Environment& env,
                                                               const std::string& name);

/// A lesson file, or a log of any GJK, set beside this one.
[[nodiscard]] LoadedLesson load_lesson_or_log(const std::filesystem::path& file);

/// The lesson of an id or path, or an exit code after its problems were printed on `env.err`.
struct FoundLesson {
  std::optional<Lesson> lesson;
  int exit_code = kDone;
};
[[nodiscard]] FoundLesson find_lesson(const Environment& env, const std::string& name);

/// The lessons of a choice, in the order named, and of files of shapes one for each case; all
/// lessons are in the order of the chapters. If any of them has a problem there are none, but an
/// exit code: a list is never done by half.
struct FoundLessons {
  std::vector<Lesson> lessons;
  int exit_code = kDone;
};
[[nodiscard]] FoundLessons find_lessons(const Environment& env, const LessonChoice& choice);

/// A whole file, or standard input for "-"; nothing when it cannot be read.
[[nodiscard]] std::optional<std::string> read_text(const Environment& env, const std::string& file);

/// As messages name it: "<stdin>" for "-".
[[nodiscard]] std::string name_of_input(const std::string& file);

/// Whether `name` is a file of shapes, by its ending, or "-".
[[nodiscard]] bool is_case_file(const std::string& name);

/// The cases of files[first]; where that holds one shape, and so does the next file, those of both.
struct CasesOfFiles {
  std::vector<ReadCase> cases;
  std::size_t files = 1;  ///< How many were read.
};
/// Nothing, with a message on `env.err`, when the file cannot be read.
[[nodiscard]] std::optional<CasesOfFiles> read_cases(const Environment& env,
                                                     const std::vector<std::string>& files,
                                                     std::size_t first,
                                                     std::optional<models::Needs> needs,
                                                     const CaseLimits& limits = {});

/// Whether the output arrived: false, with a message on `env.err`, when the disk is full or the
/// like.
[[nodiscard]] bool flushed(const Environment& env);

}  // namespace gjkscope
