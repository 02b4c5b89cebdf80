#include "cli/input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <iterator>
#include <ostream>
#include <stdexcept>

#include "base/file.hpp"
#include "lesson/paste.hpp"
#include "session/case_lesson.hpp"
#include "subjects/subjects.hpp"
#include "subjects/two_runs/log_lesson.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lesson_ids(const fs::path& folder) {
  std::vector<std::string> ids;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".toml") ids.push_back(entry.path().stem().string());
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

[[nodiscard]] bool is_path(const std::string& name) {
  return name.find('/') != std::string::npos || fs::path(name).extension() == ".toml";
}

/// A lesson for each case of `file`, shown as the first lesson about two polygons shows its shapes;
/// returns an exit code, after problems were printed on `env.err`.
int add_lessons_of(const Environment& env, const std::string& file,
                   const std::vector<ReadCase>& cases, std::vector<Lesson>& lessons) {
  const LoadedLesson example =
      load_lesson(env.share / "lessons" / "polygons-gjk.toml", vocabulary());
  const std::string stem = file == "-" ? "case" : fs::path(file).stem().string();
  const std::string name = name_of_input(file);
  int exit_code = kDone;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const ReadCase& read = cases[i];
    std::vector<Problem> problems = example.lesson ? read.problems : example.problems;
    if (problems.empty()) {
      const std::string id = i == 0 ? stem : fmt::format("{}-{}", stem, i + 1);
      const bool has_name = !read.name.starts_with(name);
      Lesson lesson = case_lesson(*example.lesson, read, has_name ? read.name : id);
      lesson.id = id;
      problems = why_case_is_not_said(lesson, read, name);
      if (problems.empty()) lessons.push_back(std::move(lesson));
    }
    for (const Problem& problem : problems) env.err << to_string(problem) << '\n';
    if (!problems.empty()) exit_code = kProblem;
  }
  return exit_code;
}

}  // namespace

std::optional<fs::path> lesson_file(const Environment& env, const std::string& name) {
  std::error_code none;
  const fs::path folder = env.share / "lessons";
  if (is_path(name)) {
    if (fs::is_regular_file(name, none)) return fs::path(name);
    env.err << fmt::format("gjkscope: there is no file '{}'\n", name);
    return std::nullopt;
  }
  const fs::path file = folder / (name + ".toml");
  if (!name.empty() && fs::is_regular_file(file, none)) return file;
  env.err << fmt::format("gjkscope: there is no lesson '{}'", name);
  const std::vector<std::string> ids = lesson_ids(folder);
  const std::string nearest = nearest_name(name, ids);
  if (!nearest.empty()) {
    env.err << fmt::format("; did you mean '{}'?\n", nearest);
  } else if (ids.empty()) {
    env.err << fmt::format("; {} holds no lessons\n", folder.string());
  } else {
    env.err << "; `gjkscope lessons` lists them\n";
  }
  return std::nullopt;
}

LoadedLesson load_lesson_or_log(const fs::path& file) {
  std::optional<LoadedLesson> log;
  if (file.extension() != ".toml") log = log_as_lesson(read_whole(file), file);
  return log ? *std::move(log) : load_lesson(file, vocabulary());
}

FoundLesson find_lesson(const Environment& env, const std::string& name) {
  const std::optional<fs::path> file = lesson_file(env, name);
  if (!file) return {std::nullopt, is_path(name) ? kCannot : kUsage};
  LoadedLesson loaded = load_lesson_or_log(*file);
  for (const Problem& problem : loaded.problems) env.err << to_string(problem) << '\n';
  const int exit_code = loaded.lesson ? kDone : kProblem;
  return {std::move(loaded.lesson), exit_code};
}

FoundLessons find_lessons(const Environment& env, const LessonChoice& choice) {
  FoundLessons all;
  const fs::path folder = env.share / "lessons";
  if (choice.all) {
    for (LoadedLesson& loaded : load_lessons(folder, vocabulary())) {
      for (const Problem& problem : loaded.problems) env.err << to_string(problem) << '\n';
      if (loaded.lesson) {
        all.lessons.push_back(std::move(*loaded.lesson));
      } else {
        all.exit_code = kProblem;
      }
    }
  }
  for (std::size_t i = 0; i < choice.names.size(); ++i) {
    if (is_case_file(choice.names[i])) {
      const std::optional<CasesOfFiles> found =
          read_cases(env, choice.names, i, std::nullopt, CaseLimits::of_lessons());
      const int exit_code =
          found ? add_lessons_of(env, choice.names[i], found->cases, all.lessons) : kCannot;
      all.exit_code = std::max(all.exit_code, exit_code);
      i += found ? found->files - 1 : 0;
      continue;
    }
    FoundLesson found = find_lesson(env, choice.names[i]);
    if (found.lesson) {
      all.lessons.push_back(std::move(*found.lesson));
    } else {
      all.exit_code = std::max(all.exit_code, found.exit_code);
    }
  }
  for (Lesson& lesson : all.lessons) {
    if (!choice.language) break;
    lesson.listing = code::in_language(lesson, *choice.language).value_or(lesson.listing);
  }
  if (all.exit_code == kDone && all.lessons.empty()) {
    env.err << fmt::format("gjkscope: {} holds no lessons\n", folder.string());
    all.exit_code = kCannot;
  }
  return all;
}

std::optional<std::string> read_text(const Environment& env, const std::string& file) {
  if (file == "-") return std::string(std::istreambuf_iterator<char>(env.in), {});
  try {
    return read_whole(file);
  } catch (const std::runtime_error& error) {
    env.err << fmt::format("gjkscope: {}\n", error.what());
    return std::nullopt;
  }
}

std::string name_of_input(const std::string& file) { return file == "-" ? "<stdin>" : file; }

bool is_case_file(const std::string& name) {
  const std::string ending = fs::path(name).extension().string();
  return name == "-" || ending == ".json" || is_pasted_ending(ending);
}

std::optional<CasesOfFiles> read_cases(const Environment& env,
                                       const std::vector<std::string>& files, std::size_t first,
                                       std::optional<models::Needs> needs,
                                       const CaseLimits& limits) {
  const std::string& file = files[first];
  std::optional<std::string> text = read_text(env, file);
  if (!text) return std::nullopt;
  CasesOfFiles read{parse_cases(*text, name_of_input(file), gjk::kMaxDimension, needs, limits)};
  std::error_code none;
  if (read.cases.front().has_one_shape && first + 1 < files.size() &&
      fs::is_regular_file(files[first + 1], none)) {
    const std::string& next = files[first + 1];
    std::optional<std::string> second = read_text(env, next);
    if (!second) return read;
    if (auto both = paired_case({name_of_input(file), *std::move(text)}, {next, *std::move(second)},
                                gjk::kMaxDimension, needs))
      return CasesOfFiles{{*std::move(both)}, 2};
  }
  return read;
}

bool flushed(const Environment& env) {
  if (env.out.flush()) return true;
  env.err << "gjkscope: the output cannot be written\n";
  return false;
}

}  // namespace gjkscope
