// Files: opening, saving, exporting, and what is remembered between two starts.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "app.hpp"
#include "drawers/study.hpp"
#include "export/export.hpp"
#include "export/record.hpp"
#include "files.hpp"
#include "lesson/file.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/save.hpp"
#include "picture/registry.hpp"
#include "session/edit.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 10;

/// What a run came to, for the lesson's file to expect.
Expectation outcome_of(const LessonRun& run) {
  const WideTrace& trace = run.runs.back().trace;
  Expectation expect;
  if (run.has_gjk()) {
    expect.stop = name_of(trace.result.stop);
    expect.distance = trace.result.distance;
    expect.supports.emplace();
  }
  if (const Algorithm* algorithm = run.act->algorithm) {
    const std::string_view stop = run.algorithm_traces.back()->stop();
    if (!expect.stop && !stop.empty()) expect.stop = stop;
    for (const std::string_view name : algorithm->answers) {
      if (const double found = run.algorithm_traces.back()->answer(name); found >= 0.0)
        expect.answers.emplace_back(name, found);
    }
  }
  for (const gjk::Step<double, 2>& step : trace.steps) {
    if (step.phase != gjk::Phase::support) continue;
    const gjk::VertexPair pair = step.after.support.pair;
    const std::string& y = run.lesson.y().vertex_names[static_cast<std::size_t>(pair.y)];
    const std::string& x = run.lesson.x().vertex_names[static_cast<std::size_t>(pair.x)];
    expect.supports->push_back(run.point_query() ? y : fmt::format("{}-{}", y, x));
  }
  return expect;
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::error_code none;
  std::vector<std::string> lines;
  if (!fs::exists(file, none)) return lines;
  std::istringstream text(read_whole(file));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

}  // namespace

fs::path opening_lesson(const fs::path& share) { return share / "lessons" / "polygons-gjk.toml"; }

bool is_in(const fs::path& file, const fs::path& folder) {
  std::error_code none;
  return fs::equivalent(file.parent_path(), folder, none);
}

void App::open_path(const fs::path& path) {
  try {
    if (path.extension() == ".json") {
      const std::string text = read_whole(path);
      if (text.find("\"rows\":") == std::string::npos) {
        open_case_text(text, path.string());
      } else {
        open_results(*this, text, path);
      }
    } else if (path.extension() == ".toml") {
      open_lesson(path);
    } else {
      open_exported(path);
    }
  } catch (const std::runtime_error& error) {
    say(error.what(), true);
  }
}

void App::open_exported(const fs::path& file) {
  const std::string bytes = read_whole(file);
  const std::optional<Record> record =
      find_record({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  if (!record || record->frames.empty()) {
    return say(
        fmt::format("{} is no lesson (.toml), no case (.json) and no export of one", file.string()),
        true);
  }
  // Results of a study stand beside the shipped lessons.
  const fs::path shipped = paths_.share / "lessons" / (record->lesson + ".toml");
  LoadedLesson loaded = parse_lesson(record->toml, shipped, vocabulary());
  if (!loaded.lesson) return say(to_string(loaded.problems), true);
  // The step counts the frames that ask, which the window shows only in predict mode.
  const std::vector<Frame> frames = run_lesson(*loaded.lesson).frames;
  const auto step = static_cast<std::size_t>(std::max(record->frames.front().step, 1));
  const auto end = frames.begin() + static_cast<std::ptrdiff_t>(std::min(step, frames.size()));
  const auto index = session_.is_predicting()
                         ? end - frames.begin() - 1
                         : std::count_if(frames.begin(), end, [](const Frame& frame) {
                             return frame.question < 0;
                           }) - 1;
  if (show(std::move(*loaded.lesson), {}, file.string())) session_.go_to(static_cast<int>(index));
}

void App::open_lesson(const fs::path& named) {
  // However a listed lesson is named, it is the one that is listed.
  const fs::path listed = share() / "lessons" / named.filename();
  const fs::path& file = is_in(named, share() / "lessons") ? listed : named;
  LoadedLesson loaded = parse_lesson(read_whole(file), file, vocabulary());
  if (!loaded.lesson) return say(to_string(loaded.problems), true);
  if (show(std::move(*loaded.lesson), file, file.string())) remember_recent(file);
}

void App::open_case_text(std::string_view text, const std::string& name, bool unsaved) {
  const std::vector<ReadCase> cases = parse_cases(text, name);
  if (!cases.front().value) return say(to_string(cases.front().problems), true);
  std::optional<Lesson> lesson = lesson_around(*cases.front().value, cases.front().name);
  if (lesson && show(*std::move(lesson), {}, name, unsaved) && cases.size() > 1)
    say(fmt::format("the first of {} cases", cases.size()));
}

std::optional<Lesson> App::lesson_around(const Case& shapes, const std::string& name) {
  // A case has no words and no views: it is shown as the opening lesson shows its shapes.
  const fs::path file = opening_lesson(paths_.share);
  LoadedLesson loaded = parse_lesson(read_whole(file), file, vocabulary());
  if (!loaded.lesson) {
    say(to_string(loaded.problems), true);
    return std::nullopt;
  }
  Lesson lesson = edit::told_of(*std::move(loaded.lesson), shapes);
  lesson.id = name;
  lesson.path.clear();
  lesson.title = name;
  lesson.prose = "Shapes of a case.";
  lesson.source.clear();
  lesson.options = {};
  return lesson;
}

bool App::show(Lesson lesson, const fs::path& file, const std::string& name, bool unsaved) {
  picture_.release();
  const bool leaves_unsaved = session_.is_unsaved();
  if (!session_.open(std::move(lesson), file, unsaved)) {
    say(fmt::format("{}: {}", name, session_.problem()), true);
    return false;
  }
  say(leaves_unsaved ? "undo goes back to what was not saved" : "");
  picture_.selected = {};
  playing_ = false;
  keep_unsaved();
  return true;
}

void App::file_changed(const fs::path& path) {
  thumbnails_.forget(path);
  if (path != session_.file()) return;
  try {
    LoadedLesson loaded = parse_lesson(read_whole(path), path, vocabulary());
    if (!loaded.lesson) return say(to_string(loaded.problems), true);
    if (session_.saved() && *loaded.lesson == *session_.saved()) return;
    picture_.release();
    if (!session_.reload(std::move(*loaded.lesson)))
      return say(fmt::format("{}: {}", path.string(), session_.problem()), true);
    say(fmt::format("{} has changed and was read again; undo brings back what was here",
                    path.filename().string()));
  } catch (const std::runtime_error&) {
    // Between two writes of an editor there may be no file.
  }
}

void App::save_to(const fs::path& file) {
  if (file.extension() == ".json") {
    const PositionedRun& run = session_.run().run(session_.frame());
    return write_text(file, case_json(case_of(run), session_.lesson().id));
  }
  Lesson lesson = with_absolute_file(session_.lesson_as_seen());
  lesson.expect = outcome_of(session_.run());
  const std::string text = lesson_toml(lesson);
  LoadedLesson saved = parse_lesson(text, file, vocabulary());
  if (!saved.lesson) return say(to_string(saved.problems), true);
  try {
    std::error_code none;
    std::string note;
    // What is saved has no comments, and another lesson's place is taken only once.
    if (fs::exists(file, none)) {
      const std::string old = read_whole(file);
      if (file != session_.file() || old.find('#') != std::string::npos) {
        const std::string backup = file.string() + "~";
        write_whole(backup, old);
        note = fmt::format("; as it was, it is {}", backup);
      }
    }
    write_whole(file, text);
    session_.mark_saved(file, *std::move(saved.lesson));
    remember_recent(file);
    say(fmt::format("saved {}{}", file.string(), note));
    keep_unsaved();
  } catch (const std::runtime_error& error) {
    say(error.what(), true);
  }
}

void App::write_text(const fs::path& file, const std::string& text) {
  try {
    write_whole(file, text);
    say(fmt::format("saved {}", file.string()));
  } catch (const std::runtime_error& error) {
    say(error.what(), true);
  }
}

void App::export_frames(ExportOptions options, bool all) {
  options.assets_dir = paths_.share / "assets";
  options.index = all && options.format == Format::png;
  options.questions = false;
  Lesson lesson = session_.lesson_as_seen();
  lesson.questions.clear();
  if (!all) {
    int step = 0;
    for (int i = 0; i <= session_.index(); ++i)
      step += session_.run().frames[static_cast<std::size_t>(i)].question < 0 ? 1 : 0;
    options.first_step = options.last_step = std::max(step, 1);
  }
  say(fmt::format("exporting into {}", options.out_dir.string()));
  // A thread of its own: there the off-screen renderer's context is current, and here the window's.
  exporting_ = std::async(std::launch::async, [lesson = std::move(lesson), options]() -> Exported {
    try {
      const ExportResult result = export_lessons({lesson}, options);
      return {fmt::format("{} {} in {}", result.frames, result.frames == 1 ? "frame" : "frames",
                          options.out_dir.string())};
    } catch (const std::exception& error) {
      return {error.what(), true};
    }
  });
}

void App::end_export() {
  if (!is_exporting() || !is_ready(exporting_)) return;
  Exported ended = exporting_.get();
  say(std::move(ended.outcome), ended.failed);
}

// Between two starts -----------------------------------------------------------------------------

void App::read_recent() {
  if (paths_.state.empty()) return;
  try {
    recent_ = lines_of(paths_.state / "recent");
    for (std::string& id : lines_of(paths_.state / "finished")) finished_.insert(std::move(id));
  } catch (const std::runtime_error&) {
    // Conveniences.
  }
  if (recent_.size() > kMostRecent) recent_.resize(kMostRecent);
}

void App::remember_recent(const fs::path& file) {
  const std::string path = fs::absolute(file).lexically_normal().string();
  std::erase(recent_, path);
  recent_.insert(recent_.begin(), path);
  if (recent_.size() > kMostRecent) recent_.resize(kMostRecent);
  write_lines("recent", recent_);
}

void App::write_lines(const char* name, const std::vector<std::string>& lines) const {
  if (paths_.state.empty()) return;
  const std::string text = fmt::format("{}\n", fmt::join(lines, "\n"));
  try {
    write_whole(paths_.state / name,
                std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  } catch (const std::runtime_error&) {
    // A convenience; a full disk is said where work is saved.
  }
}

void App::offer_left_work() {
  try {
    left_ = unsaved_.left();
  } catch (const std::runtime_error& error) {
    say(fmt::format("unsaved work cannot be read: {}", error.what()), true);
  }
}

void App::open_left_work() {
  std::vector<std::string> opened;
  for (const UnsavedWork::Left& left : left_) {
    const bool has_file = fs::exists(left.file);
    LoadedLesson loaded =
        parse_lesson(left.text, left.file.empty() ? "unsaved.toml" : left.file, vocabulary());
    if (!loaded.lesson) return say(to_string(loaded.problems), true);
    LoadedLesson saved = has_file ? load_lesson(left.file, vocabulary()) : LoadedLesson{};
    const std::string name = left.file.empty() ? loaded.lesson->title : left.file.string();
    // On top of what its file holds, so that undo and revert lead there.
    const bool shown = saved.lesson ? show(*std::move(saved.lesson), left.file, name) &&
                                          edit("what was not saved", *std::move(loaded.lesson))
                                    : show(*std::move(loaded.lesson), left.file, name, true);
    if (!shown) return;
    opened.push_back(left.file.empty() ? name : left.file.filename().string());
  }
  keep_unsaved();
  unsaved_.forget_left();
  left_.clear();
  say(fmt::format("opened what was not saved of {}{}", fmt::join(opened, ", "),
                  opened.size() > 1 ? "; undo goes back through them" : ""));
}

}  // namespace gjkscope
