#pragma once
// The commands of `gjkscope`, one function each: arguments in, text on streams, exit code out.
// main.cpp only parses the command line.

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "answers/answers.hpp"
#include "export/export.hpp"
#include "export/sheet.hpp"
#include "export/work_sheet.hpp"
#include "lesson/lesson.hpp"
#include "lesson/names.hpp"
#include "site/site.hpp"
#include "subjects/run/code.hpp"
#include "trial/trial.hpp"

namespace gjkscope {

// Exit codes, as --help tells them.
inline constexpr int kDone = 0;
inline constexpr int kProblem = 1;  ///< A lesson or case has a problem, or a query was refused.
inline constexpr int kUsage = 2;    ///< The command line: unknown command, option, lesson or value.
inline constexpr int kCannot = 3;   ///< Something cannot be read, written or drawn.
inline constexpr int kSignalBase = 128;  ///< Plus the number of the signal that ended a command.

/// All that a command works with besides its arguments.
struct Environment {
  std::filesystem::path share;  ///< Holds lessons/ and assets/.
  std::istream& in;
  std::ostream& out;  ///< The answer.
  std::ostream& err;  ///< Complaints.
};

/// A list of lessons by id or path, or all of the shipped ones.
struct LessonChoice {
  std::vector<std::string> names;
  bool all = false;
  std::optional<Language> language = {};  ///< Replaces that of listings with code.
};

int list_lessons(const Environment& env, bool json);

/// Lessons as pages for browsers.
int export_pages_command(const Environment& env, const LessonChoice& choice,
                         const SiteOptions& options, bool json);

/// `options.assets_dir` is filled in here.
int export_command(const Environment& env, const LessonChoice& choice, ExportOptions options,
                   bool json);

/// Writes the sheet of a chapter.
int sheet_command(const Environment& env, int chapter, SheetFile options);

/// Writes tasks of a chapter and their answers; kUsage where the chapter has no practice.
/// `options.assets_dir` is filled in here.
int practice_command(const Environment& env, int chapter, int tasks, std::uint64_t seed,
                     WorkSheetFile options);

/// Starts the window, beside this program or on the PATH, with the step that an exported file
/// shows; `json`: prints the file's record instead.
int open_command(const Environment& env, const std::string& file, bool json);

/// `name` is a lesson or a case file; `options` are for cases, lessons bring their own. Brute force
/// has no trace.
int trace_command(const Environment& env, const std::string& name, const CaseOptions& options,
                  bool json);

/// One JSON object for each case and line. "-" is standard input.
int solve_command(const Environment& env, const std::vector<std::string>& files,
                  const CaseOptions& options);

/// Says of each log of a run (docs/log-format.md) whether it is right, and which step is the first
/// that is not: kProblem then, and kCannot where a log cannot be read. "-" is standard input.
int judge_command(const Environment& env, const std::vector<std::string>& files, bool json);

/// Asks programs about families of pairs, and prints what they get wrong: returns kProblem if there
/// is anything, kCannot if a program answers nothing. Several programs stand in columns. For a
/// single one the smallest failing case of each family is reduced, printed and written to `out_dir`
/// as a case and, in the plane, as a lesson.
int judge_programs_command(const Environment& env, const std::vector<std::string>& programs,
                           judging::TrialOptions options, const std::filesystem::path& out_dir,
                           bool json);

/// Problems of lesson and case files on `out`, each with its place; also runs them, and checks what
/// lessons expect and whether cases are refused.
int check_command(const Environment& env, const std::vector<std::string>& files);

/// Title, prose and captions of lessons; `markdown`: with headings and lists.
int transcript_command(const Environment& env, const LessonChoice& choice, bool markdown,
                       bool questions);

int explain_command(const Environment& env, const std::string& name, bool json);

struct StudyOptions {
  bool quick = false;
  std::uint64_t seed = 1;
  std::filesystem::path out_dir;      ///< Empty: nothing but the table is wanted.
  std::filesystem::path advice;       ///< Empty: none is wanted.
  std::vector<std::string> families;  ///< Empty: all.
};

/// Measures error against time and prints a table; in `out_dir` accuracy.csv, .json and .html, and
/// figures as PNG and SVG; in `advice` what it comes to, with its numbers beside it as .csv.
/// Interrupted, it does so with what there is.
int study_accuracy_command(const Environment& env, const StudyOptions& options);

/// Times methods for general models on the outlines of lessons of the tour `general-growth`,
/// and prints a table; in `out_dir` models.toml, the table [growth.times] for such a lesson.
/// Without names all lessons are meant. Interrupted, it does so with what there is.
int study_models_command(const Environment& env, LessonChoice choice, const StudyOptions& options);

/// "1280x720"; nullopt when it is not of that form.
[[nodiscard]] std::optional<std::pair<int, int>> parse_size(std::string_view text);
/// "3..7", "3..", "..7" or "3"; nullopt when it is none of these, or empty as a range.
struct StepRange {
  std::optional<int> first;
  std::optional<int> last;
};
[[nodiscard]] std::optional<StepRange> parse_steps(std::string_view text);

}  // namespace gjkscope
