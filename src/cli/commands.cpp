#include "cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <ostream>

#include "cli/input.hpp"
#include "cli/transcript.hpp"
#include "export/record.hpp"
#include "frames/frame.hpp"
#include "lesson/case.hpp"
#include "lesson/names.hpp"
#include "outlines/search.hpp"
#include "picture/theme.hpp"
#include "run/effect_info.hpp"
#include "run/run.hpp"
#include "run/traced.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

[[nodiscard]] std::optional<int> parse_count(std::string_view text) {
  int value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size() || value < 1) return std::nullopt;
  return value;
}

int print(const Environment& env, const Printed& printed) {
  env.err << printed.err;
  for (const std::string& text : printed.out) env.out << text;
  return printed.err.empty() ? kDone : kProblem;
}

/// Problems that loading cannot see: the outcome, and characters that the fonts do not have.
std::vector<Problem> problems_of_run(const Lesson& lesson) {
  std::vector<Problem> problems = check_expectation(run_lesson(lesson));
  for (const auto& [key, text] : texts_of(lesson)) {
    if (const char32_t missing = Fonts::first_missing(text); missing != 0) {
      const Place place = place_of_key(lesson.path, key);
      problems.push_back({lesson.path, place.line, place.column,
                          fmt::format("no font has the character U+{:04X} of \"{}\"",
                                      static_cast<std::uint32_t>(missing), text),
                          "a character that the fonts of assets/fonts.toml have", ""});
    }
  }
  return problems;
}

/// Why a case has no answer.
gjk::Error error_of(const ReadCase& read) {
  if (read.outlines) {
    const models::SearchResult found = models::search<models::Box>(
        models::model_of(read.outlines->a), models::model_of(read.outlines->b));
    return std::isfinite(found.answer.distance) ? gjk::Error::none : gjk::Error::overflow;
  }
  return read.value ? run_case(*read.value, ScalarKind::double_).trace.result.error
                    : run_case(*read.in_space, ScalarKind::double_).trace.result.error;
}

/// Those of reading, and queries that a run in double refuses. Outlines are asked about by trees,
/// which take all of them.
std::vector<Problem> problems_of_cases(const std::vector<ReadCase>& cases,
                                       const std::string& file) {
  std::vector<Problem> problems;
  for (const ReadCase& read : cases) {
    problems.insert(problems.end(), read.problems.begin(), read.problems.end());
    if (!read.problems.empty()) continue;
    const gjk::Error error = error_of(read);
    if (error == gjk::Error::none) continue;
    problems.push_back({file, read.place.line, read.place.column,
                        fmt::format("the query is refused: {}", name_of(error)),
                        "shapes that GJK can answer for", ""});
  }
  return problems;
}

}  // namespace

std::optional<std::pair<int, int>> parse_size(std::string_view text) {
  const std::size_t x = text.find('x');
  if (x == std::string_view::npos) return std::nullopt;
  const std::optional<int> width = parse_count(text.substr(0, x));
  const std::optional<int> height = parse_count(text.substr(x + 1));
  if (!width || !height) return std::nullopt;
  return std::pair{*width, *height};
}

std::optional<StepRange> parse_steps(std::string_view text) {
  const std::size_t dots = text.find("..");
  const bool single = dots == std::string_view::npos;
  const std::string_view first = text.substr(0, dots);
  const std::string_view last = single ? text : text.substr(dots + 2);
  StepRange range;
  if (!first.empty() && !(range.first = parse_count(first))) return std::nullopt;
  if (!last.empty() && !(range.last = parse_count(last))) return std::nullopt;
  if (!range.first && !range.last) return std::nullopt;
  if (range.first && range.last && *range.last < *range.first) return std::nullopt;
  return range;
}

int list_lessons(const Environment& env, bool json) {
  const fs::path folder = env.share / "lessons";
  std::error_code none;
  if (!fs::is_directory(folder, none)) {
    env.err << fmt::format("gjkscope: there is no folder {}\n", folder.string());
    return kCannot;
  }
  int exit_code = kDone;
  Json list = Json::array();
  for (const LoadedLesson& loaded : load_lessons(folder, vocabulary())) {
    for (const Problem& problem : loaded.problems) env.err << to_string(problem) << '\n';
    if (!loaded.lesson) {
      exit_code = kProblem;
      continue;
    }
    const LessonRun run = run_lesson(*loaded.lesson);
    Json one;
    one["id"] = run.lesson.id;
    one["chapter"] = run.lesson.chapter;
    one["title"] = run.lesson.title;
    one["steps"] = run.frames.size();
    list.push_back(std::move(one));
  }
  if (json) {
    env.out << list.dump(1) << '\n';
  } else {
    std::size_t widest = 0;
    for (const Json& one : list) {
      widest = std::max(widest, one["id"].get_ref<const std::string&>().size());
    }
    env.out << fmt::format("{:<{}}  chapter  steps  title\n", "id", widest);
    for (const Json& one : list) {
      env.out << fmt::format("{:<{}}  {:>7}  {:>5}  {}\n", one["id"].get<std::string>(), widest,
                             one["chapter"].get<int>(), one["steps"].get<std::size_t>(),
                             one["title"].get<std::string>());
    }
  }
  return flushed(env) ? exit_code : kCannot;
}

int export_pages_command(const Environment& env, const LessonChoice& choice,
                         const SiteOptions& options, bool json) {
  const FoundLessons found = find_lessons(env, choice);
  if (found.exit_code != kDone) return found.exit_code;
  if (!options.file_name.empty() && (found.lessons.size() > 1 || options.index)) {
    env.err << fmt::format(
        "gjkscope: {} is one file; name one lesson without --index, or a folder\n",
        options.file_name);
    return kUsage;
  }
  const std::vector<fs::path> files = export_site(found.lessons, options);
  if (json) {
    Json list = Json::array();
    for (const fs::path& file : files) list.push_back(file.string());
    env.out << Json{{"files", std::move(list)}}.dump(2) << '\n';
  } else {
    const auto pages = std::count_if(files.begin(), files.end(), [](const fs::path& file) {
      return file.extension() == ".html";
    });
    env.out << fmt::format("{} pages in {}{}\n", pages,
                           (options.out_dir / options.file_name).string(),
                           options.package ? "; `npm pack` there makes a package" : "");
  }
  return flushed(env) ? kDone : kCannot;
}

namespace {

/// Frames of their own, and not only one of them.
bool has_several_files(const ExportOptions& options) {
  return has_file_per_frame(options.format) &&
         (!options.first_step || options.first_step != options.last_step);
}

}  // namespace

int sheet_command(const Environment& env, int chapter, SheetFile options) {
  FoundLessons found = find_lessons(env, {.names = {}, .all = true});
  if (found.exit_code != kDone) return found.exit_code;
  options.assets_dir = env.share / "assets";
  if (options.file.has_parent_path())
    std::filesystem::create_directories(options.file.parent_path());
  write_sheet(chapter, std::move(found.lessons), options);
  env.out << options.file.string() << '\n';
  return flushed(env) ? kDone : kCannot;
}

int export_command(const Environment& env, const LessonChoice& choice, ExportOptions options,
                   bool json) {
  FoundLessons found = find_lessons(env, choice);
  if (found.exit_code != kDone) return found.exit_code;
  const std::vector<Lesson> lessons = std::move(found.lessons);
  options.assets_dir = env.share / "assets";
  const std::vector<std::string> themes = Theme::names(options.assets_dir / "themes");
  if (!themes.empty() && std::find(themes.begin(), themes.end(), options.theme) == themes.end()) {
    env.err << fmt::format("gjkscope: there is no theme '{}'; there are {}\n", options.theme,
                           fmt::join(themes, ", "));
    return kUsage;
  }
  if (!options.file_name.empty() && (lessons.size() > 1 || has_several_files(options))) {
    env.err << fmt::format(
        "gjkscope: {} is one file; {}\n", options.file_name,
        lessons.size() > 1 ? "name one lesson, or a folder" : "say which frame, --steps 3");
    return kUsage;
  }
  const ExportResult result = export_lessons(lessons, options);
  if (json) {
    env.out << to_json(result) << '\n';
  } else {
    env.out << fmt::format(
        "{} frames of {} lessons in {} ({:.1f} s, {:.0f} frames per second{})\n", result.frames,
        lessons.size(), (options.out_dir / options.file_name).string(), result.seconds,
        result.frames_per_second(),
        result.kept == 0 ? "" : fmt::format("; {} were up to date", result.kept));
  }
  if (!flushed(env)) return kCannot;
  return result.signal == 0 ? kDone : kSignalBase + result.signal;
}

int practice_command(const Environment& env, int chapter, int tasks, std::uint64_t seed,
                     WorkSheetFile options) {
  const std::vector<int>& chapters = practice::chapters_with_practice();
  if (std::find(chapters.begin(), chapters.end(), chapter) == chapters.end()) {
    env.err << fmt::format("gjkscope practice: chapter {} has no practice; {} have\n", chapter,
                           fmt::join(chapters, ", "));
    return kUsage;
  }
  if (options.file.extension() != ".pdf") {
    env.err << fmt::format("gjkscope practice: {} is no .pdf; a work sheet is\n",
                           options.file.string());
    return kUsage;
  }
  options.assets_dir = env.share / "assets";
  if (options.file.has_parent_path()) fs::create_directories(options.file.parent_path());
  write_work_sheet(chapter, tasks, seed, options);
  env.out << options.file.string() << '\n';
  return flushed(env) ? kDone : kCannot;
}

int open_command(const Environment& env, const std::string& file, bool json) {
  const std::optional<std::string> bytes = read_text(env, file);
  if (!bytes) return kCannot;
  const std::optional<Record> record =
      find_record({reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()});
  if (!record) {
    env.err << fmt::format(
        "gjkscope: {} has no record of a lesson; png, apng, svg, pdf and gif that `gjkscope "
        "export` "
        "wrote have\n",
        file);
    return kProblem;
  }
  if (json) {
    env.out << record_text(*record) << '\n';
    return flushed(env) ? kDone : kCannot;
  }
  std::error_code none;
  const fs::path viewer =
      fs::read_symlink("/proc/self/exe", none).parent_path() / "gjkscope-viewer";
  std::string program = fs::exists(viewer, none) ? viewer.string() : "gjkscope-viewer";
  std::string path = file;
  std::array<char*, 3> arguments = {program.data(), path.data(), nullptr};
  ::execvp(program.c_str(), arguments.data());
  env.err << fmt::format("gjkscope: cannot start {}: {}\n", program, std::strerror(errno));
  return kCannot;
}

int trace_command(const Environment& env, const std::string& name, const CaseOptions& options,
                  bool json) {
  Printed printed;
  if (is_case_file(name)) {
    const std::optional<std::string> text = read_text(env, name);
    if (!text) return kCannot;
    const std::string file = name_of_input(name);
    printed =
        print_traces(parse_cases(*text, file, gjk::kMaxDimension, needs_of_trace(options.method)),
                     options, json);
  } else {
    FoundLesson found = find_lesson(env, name);
    if (!found.lesson) return found.exit_code;
    const LessonRun run = run_lesson(*std::move(found.lesson));
    printed = print_trace(traced(run), json);
  }
  const int exit_code = print(env, printed);
  return flushed(env) ? exit_code : kCannot;
}

int solve_command(const Environment& env, const std::vector<std::string>& files,
                  const CaseOptions& options) {
  int exit_code = kDone;
  for (std::size_t i = 0; i < files.size();) {
    const std::optional<CasesOfFiles> found = read_cases(env, files, i, needs_of(options.method));
    i += found ? found->files : 1;
    const int code = found ? print(env, print_answers(found->cases, options)) : kCannot;
    if (code == kCannot || exit_code == kDone) exit_code = code;
  }
  return flushed(env) ? exit_code : kCannot;
}

int check_command(const Environment& env, const std::vector<std::string>& files) {
  std::size_t problem_count = 0;
  std::size_t bad_files = 0;
  bool unknown = false;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string& name = files[i];
    std::vector<Problem> problems;
    if (is_case_file(name)) {
      const std::optional<CasesOfFiles> found =
          read_cases(env, files, i, needs_of(ModelMethod::boxes));
      if (found) {
        problems = problems_of_cases(found->cases, name_of_input(name));
        const ReadCase& first = found->cases.front();
        if (!first.understood.empty())
          env.out << fmt::format("{}: {}\n", first.name, first.understood);
        i += found->files - 1;
      }
      unknown = unknown || !found;
    } else if (const std::optional<fs::path> file = lesson_file(env, name); file) {
      LoadedLesson loaded = load_lesson_or_log(*file);
      problems = std::move(loaded.problems);
      if (loaded.lesson) problems = problems_of_run(*loaded.lesson);
    } else {
      unknown = true;
    }
    for (const Problem& problem : problems) env.out << to_string(problem) << '\n';
    problem_count += problems.size();
    bad_files += problems.empty() ? 0 : 1;
  }
  if (!flushed(env) || unknown) return kCannot;
  if (problem_count == 0) return kDone;
  env.err << fmt::format("{} problem{} in {} of {} files\n", problem_count,
                         problem_count == 1 ? "" : "s", bad_files, files.size());
  return kProblem;
}

int transcript_command(const Environment& env, const LessonChoice& choice, bool markdown,
                       bool questions) {
  FoundLessons found = find_lessons(env, choice);
  if (found.exit_code != kDone) return found.exit_code;
  bool first = true;
  for (Lesson& lesson : found.lessons) {
    if (!first) env.out << '\n';
    first = false;
    if (!questions) lesson.questions.clear();
    env.out << transcript(run_lesson(std::move(lesson)), markdown);
  }
  return flushed(env) ? kDone : kCannot;
}

int explain_command(const Environment& env, const std::string& name, bool json) {
  const FoundLesson found = find_lesson(env, name);
  if (!found.lesson) return found.exit_code;
  const LessonRun run = run_lesson(*found.lesson);
  const Fonts fonts(env.share / "assets" / "fonts.toml");
  EffectGraph effects(run);
  const std::size_t frames = lesson_pictures(run, effects, fonts).size();

  Json list = Json::array();
  for (const EffectInfo* info : registered_effects()) {
    const EffectCount count = effects.count(info->name);
    Json one;
    one["effect"] = info->name;
    one["called"] = count.pulls > 0;
    one["pulls"] = count.pulls;
    one["runs"] = count.runs;
    one["seconds"] = count.seconds;
    one["needs"] = info->needs;
    one["summary"] = info->summary;
    list.push_back(std::move(one));
  }
  if (json) {
    Json out;
    out["lesson"] = run.lesson.id;
    out["frames"] = frames;
    out["effects"] = std::move(list);
    env.out << out.dump(1) << '\n';
  } else {
    env.out << fmt::format("{}: {} frames\n\n{:<20} {:<10} {:>6} {:>6} {:>9}  {}\n", run.lesson.id,
                           frames, "effect", "called for", "pulls", "runs", "ms", "what it is");
    for (const Json& one : list) {
      env.out << fmt::format("{:<20} {:<10} {:>6} {:>6} {:>9.3f}  {}\n",
                             one["effect"].get<std::string>(),
                             one["called"].get<bool>() ? "yes" : "no", one["pulls"].get<long>(),
                             one["runs"].get<long>(), 1000.0 * one["seconds"].get<double>(),
                             one["summary"].get<std::string>());
    }
  }
  return flushed(env) ? kDone : kCannot;
}

}  // namespace gjkscope
