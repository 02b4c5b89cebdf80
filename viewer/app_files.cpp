// Files: opening, saving, exporting, and what is remembered between two starts.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "app.hpp"
#include "base/file.hpp"
#include "drawers/study.hpp"
#include "export/export.hpp"
#include "export/record.hpp"
#include "files.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/paste.hpp"
#include "lesson/save.hpp"
#include "session/edit.hpp"
#include "subjects/subjects.hpp"
#include "subjects/two_runs/log_lesson.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 10;
/// Bytes of a file that is opened beside the window: some 10,000 vertices.
constexpr std::uintmax_t kLarge = 400'000;

/// The outcome of a run, for the lesson's file to expect.
Expectation outcome_of(const LessonRun& run) {
  const WideTrace& trace = run.runs.back().trace;
  Expectation expect;
  if (!trace.is_empty()) {
    expect.stop = name_of(trace.result.stop);
    expect.distance = trace.result.distance;
    expect.supports.emplace();
  }
  const AlgorithmTrace& shown = *run.algorithm_traces.back();
  if (!expect.stop && !shown.stop().empty()) expect.stop = shown.stop();
  for (const std::string_view name : run.tour->algorithm->answers) {
    if (const double found = shown.answer(name); found >= 0.0)
      expect.answers.emplace_back(name, found);
  }
  for (const WideStep& step : trace.steps) {
    if (step.phase != gjk::Phase::support) continue;
    const gjk::VertexPair pair = step.after.support.pair;
    const std::string& y = run.lesson.y().vertex_names[pair.y];
    const std::string& x = run.lesson.x().vertex_names[pair.x];
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
  will_show(path.string());
  try {
    if (path.extension() == ".json" || path.extension() == ".jsonl") {
      const std::string text = read_whole(path);
      if (std::optional<LoadedLesson> log = log_as_lesson(text, path)) {
        if (!log->lesson) return say(log->problems);
        (void)show(*std::move(log->lesson), {}, path.string(), true);
      } else if (text.find("\"rows\":") == std::string::npos) {
        open_lesson(path);
      } else {
        open_results(*this, text, path);
      }
    } else if (path.extension() == ".toml") {
      open_lesson(path);
    } else if (is_pasted_ending(path.extension().string())) {
      open_pasted(read_whole(path), path.string());
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
    return say(fmt::format(
                   "{} is no lesson (.toml), no case (.json), no log (.jsonl) and no export of one",
                   file.string()),
               true);
  }
  // Results of a study stand beside the shipped lessons.
  const fs::path shipped = paths_.share / "lessons" / (record->lesson + ".toml");
  LoadedLesson loaded = parse_lesson(record->toml, shipped, vocabulary());
  if (!loaded.lesson) return say(loaded.problems);
  // The step counts frames that ask, which the window shows only if it is set to.
  const std::vector<Frame> frames = run_lesson(*loaded.lesson).frames;
  const auto step = static_cast<std::size_t>(std::max(record->frames.front().step, 1));
  const auto end = frames.begin() + static_cast<std::ptrdiff_t>(std::min(step, frames.size()));
  const auto index = session_.is_asking() && !session_.is_predicting()
                         ? end - frames.begin() - 1
                         : std::count_if(frames.begin(), end, [](const Frame& frame) {
                             return frame.question < 0;
                           }) - 1;
  if (show(std::move(*loaded.lesson), {}, file.string())) session_.go_to(static_cast<int>(index));
}

App::ReadLesson App::read_lesson(std::string_view text, const fs::path& file) const {
  if (file.extension() == ".json") return read_case(text, file.string());
  LoadedLesson loaded = parse_lesson(text, file, vocabulary());
  return {std::move(loaded.lesson), std::move(loaded.problems)};
}

void App::open_lesson(const fs::path& named) {
  // However a listed lesson is named, it is the one that is listed.
  const fs::path listed = share() / "lessons" / named.filename();
  const fs::path& file = is_in(named, share() / "lessons") ? listed : named;
  std::error_code none;
  // The first lesson is waited for: there is nothing to show meanwhile.
  if (!looked_at_.empty() && fs::file_size(file, none) > kLarge && !none) return open_beside(file);
  std::string text = read_whole(file);
  ReadLesson read = read_lesson(text, file);
  if (!read.lesson) return say(read.problems);
  if (show(*std::move(read.lesson), file, file.string()))
    opened(file, std::move(text), std::move(read));
}

void App::opened(const fs::path& file, std::string text, ReadLesson read) {
  files_.note_read(file, std::move(text));
  note(std::move(read.noted));
  looked_at_ = file;
  if (outside_ && outside_->file == file) outside_.reset();
  remember_recent(file);
  if (read.cases > 1) say(fmt::format("the first of {} cases", read.cases));
}

void App::open_beside(const fs::path& file) {
  run_command("Cancel opening");
  Opening opening{file, {}, {}};
  opening.result =
      std::async(beside, [this, file, stopped = opening.stop.get_token()]() -> Opening::Result {
        Opening::Result result;
        try {
          result.text = read_whole(file);
          result.read = read_lesson(result.text, file);
          if (result.read.lesson && !stopped.stop_requested())
            result.made = session_.maker(*result.read.lesson)();
        } catch (const std::exception& error) {
          result.problem = error.what();
        }
        return result;
      });
  opening_ = std::move(opening);
}

void App::work_beside() {
  if (working_.valid() && is_ready(working_)) {
    const bool was_settling = session_.is_settling();
    try {
      session_.take_work(working_.get());
      if (was_settling && !session_.problem().empty()) say(session_.problem(), true);
    } catch (const std::exception& error) {
      session_.take_work(nullptr);
      say(error.what(), true);
    }
  }
  if (working_.valid()) return;
  if (auto work = session_.work()) working_ = std::async(beside, std::move(work));
}

void App::wait_beside() const {
  if (working_.valid()) working_.wait();
  if (opening_) opening_->result.wait();
  for (const Opening& each : given_up_) each.result.wait();
}

void App::end_opening() {
  std::erase_if(given_up_, [](const Opening& each) { return is_ready(each.result); });
  if (!opening_ || !is_ready(opening_->result)) return;
  const fs::path file = opening_->file;
  Opening::Result result = opening_->result.get();
  opening_.reset();
  if (!result.problem.empty()) return say(result.problem, true);
  if (!result.read.lesson) return say(result.read.problems);
  picture_.release();
  leaves_unsaved_ = session_.is_unsaved();
  if (shown(session_.open(result.made, file), file.string()))
    opened(file, std::move(result.text), std::move(result.read));
}

bool App::show(Lesson lesson, const fs::path& file, const std::string& name, bool unsaved) {
  picture_.release();
  leaves_unsaved_ = session_.is_unsaved();
  return shown(session_.open(std::move(lesson), file, unsaved), name);
}

bool App::shown(bool is_shown, const std::string& name) {
  if (!is_shown) {
    say(fmt::format("{}: {}", name, session_.problem()), true);
    return false;
  }
  error_.clear();
  say(leaves_unsaved_ ? "undo goes back to what was not saved" : "");
  picture_.hand().selected = {};
  playing_ = false;
  keep_unsaved();
  return true;
}

void App::file_changed(const fs::path& path) {
  thumbnails_.forget(path);
  if (path == session_.file()) (void)is_file_as_known();
}

void App::watch_file() {
  const fs::path& file = session_.file();
  if (looked_at_ != file) {
    // Undo has led back to a file that nobody watched meanwhile.
    looked_at_ = file;
    is_missing_ = false;
    if (!file.empty()) (void)is_file_as_known();
  }
  if (!is_missing_) return gone_since_.reset();
  if (!gone_since_) gone_since_ = now_;
  // A lesson that is in no file is unsaved work.
  if (now_ >= *gone_since_ + kGoneAfter && session_.saved()) session_.set_saved(std::nullopt);
}

bool App::is_file_as_known() {
  const fs::path& file = session_.file();
  std::error_code none;
  is_missing_ = !fs::exists(file, none);
  if (is_missing_) return true;
  std::string text;
  try {
    text = read_whole(file);
  } catch (const std::runtime_error& error) {
    say(error.what(), true);
    return false;
  }
  outside_.reset();
  if (session_.saved() && !files_.is_changed(file, text)) return true;
  ReadLesson read = read_lesson(text, file);
  note(std::move(read.noted));
  const bool is_as_known = read.lesson && !files_.is_changed(file, text);  // and was gone meanwhile
  if (is_as_known) session_.set_saved(*read.lesson);
  if (read.lesson && session_.saved() && *read.lesson == *session_.saved()) {
    files_.note_read(file, std::move(text));  // other comments
    return true;
  }
  const bool is_asked = !read.lesson || session_.is_unsaved();
  outside_ = Outside{file, std::move(text), std::move(read.lesson), std::move(read.problems)};
  if (!is_asked) take_theirs();
  return false;
}

void App::take_theirs() {
  Outside taken = *std::exchange(outside_, std::nullopt);
  picture_.release();
  const bool had_own = session_.is_unsaved();
  if (!session_.reload(std::move(*taken.lesson)))
    return say(fmt::format("{}: {}", taken.file.string(), session_.problem()), true);
  files_.note_read(taken.file, std::move(taken.text));
  say(fmt::format("{} {}; undo brings back what was here", taken.file.filename().string(),
                  had_own ? "as the file has it" : "has changed and was read again"));
}

void App::keep_mine() {
  Outside other = *std::exchange(outside_, std::nullopt);
  picture_.release();
  // Theirs is an entry of the history below mine.
  if (other.lesson) {
    Lesson mine = session_.lesson();
    if (!session_.reload(std::move(*other.lesson)))
      return say(fmt::format("{}: {}", other.file.string(), session_.problem()), true);
    if (!edit("keep what was here", std::move(mine))) return;
  }
  if (other.lesson) {
    files_.note_read(other.file, std::move(other.text));
  } else {
    files_.note_broken(other.file, std::move(other.text));
  }
  say(fmt::format("kept what is here; Save writes it, and what the file holds goes to {}~",
                  other.file.filename().string()));
}

bool App::is_of_course(const fs::path& file) const {
  const fs::path folder = share() / "lessons";
  if (is_in(file, folder)) return true;
  // A copy of the course is not overwritten unasked, either.
  std::error_code none;
  const fs::path shipped = folder / file.filename();
  const KnownFiles::Known* known = files_.find(file);
  return known != nullptr && fs::exists(shipped, none) && known->text == read_whole(shipped);
}

void App::save_as() {
  const std::string title = "Save as a lesson (.toml) or a case (.json)";
  const fs::path& file = session_.file();
  const bool has_own_place = !file.empty() && !is_in(file, share() / "lessons") &&
                             ::access(file.parent_path().c_str(), W_OK) == 0;
  const fs::path name = fs::path(session_.lesson().id + ".toml").filename();
  show_dialog(save_dialog(*this, title, has_own_place ? file.string() : name.string(),
                          is_of_course(file) ? fs::path() : file,
                          [this](const fs::path& to) { save_to(to); }));
}

std::vector<std::string> App::texts_to_keep(const fs::path& file) const {
  std::error_code none;
  std::vector<std::string> texts;
  if (fs::exists(file, none)) texts.push_back(read_whole(file));
  if (const KnownFiles::Known* known = files_.find(file)) texts.push_back(known->good);
  return texts;
}

std::string App::keep_beside(const fs::path& file) {
  std::error_code none;
  if (!fs::exists(file, none)) return "";
  const std::string old = read_whole(file);
  const KnownFiles::Known* known = files_.find(file);
  if (known != nullptr && known->is_ours && known->text == old) return "";
  const std::string backup = file.string() + "~";
  write_whole(backup, old);
  return fmt::format("; as it was, it is {}", backup);
}

void App::save_to(const fs::path& file) {
  if (file == session_.file() && !is_file_as_known()) {
    if (outside_) say(fmt::format("{} was not saved", file.filename().string()), true);
    return;
  }
  if (file.extension() == ".json") return save_case_to(file);
  std::error_code none;
  Lesson lesson = session_.lesson_as_seen();
  if (!is_in(file, fs::absolute(fs::path(lesson.path).parent_path(), none)))
    lesson = with_absolute_file(std::move(lesson));
  // The author's statement of the outcome stays while it is true.
  LessonRun run = session_.run();
  run.lesson.expect = lesson.expect;
  if (lesson.expect == Expectation() || !check_expectation(run).empty())
    lesson.expect = outcome_of(session_.run());
  try {
    const bool is_own = file == session_.file();
    std::optional<std::string> kept;
    for (const std::string& before : is_own ? texts_to_keep(file) : std::vector<std::string>()) {
      kept = lesson_toml_kept(before, lesson, file, vocabulary());
      if (kept) break;
    }
    std::string text = kept.value_or(lesson_toml(lesson));
    LoadedLesson saved = parse_lesson(text, file, vocabulary());
    if (!saved.lesson) return say(saved.problems);
    const std::string note = keep_beside(file);
    write_whole(file, std::string_view(text));
    files_.note_written(file, std::move(text));
    is_missing_ = false;
    looked_at_ = file;
    session_.mark_saved(file, *std::move(saved.lesson));
    thumbnails_.forget(file);
    remember_recent(file);
    say(fmt::format(
        "saved {}{}{}", file.string(), note,
        is_own && !kept && !note.empty() ? ", with the comments that the new text has not" : ""));
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
      step += session_.run().frames[i].question < 0 ? 1 : 0;
    options.first_step = options.last_step = std::max(step, 1);
  }
  options.out_dir = fs::absolute(options.out_dir).lexically_normal();
  export_folder_ = options.out_dir;
  export_began_ = now_;
  export_done_ = export_count_ = 0;
  gives_export_up_ = false;
  stop_export_ = {};
  options.stop = stop_export_.get_token();
  options.on_progress = [this](int done, int count) {
    export_done_ = done;
    export_count_ = count;
  };
  say(fmt::format("exporting into {}", options.out_dir.string()));
  // A thread of its own: there the off-screen renderer's context is current, and here the window's.
  exporting_ = std::async(std::launch::async, [lesson = std::move(lesson), options]() -> Exported {
    try {
      const ExportResult result = export_lessons({lesson}, options);
      return {fmt::format("{}{} {} in {}",
                          result.is_complete ? "" : "the export was given up: ", result.frames,
                          result.frames == 1 ? "frame" : "frames", options.out_dir.string())};
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

Settings App::settings() const {
  ExportSettings exported;
  if (last_export)
    exported = {last_export->out_dir.string(),
                std::string(name_of(last_export->format)),
                last_export->theme,
                last_export->width,
                last_export->height,
                last_export->transparent,
                last_export->stage_only};
  return {theme_name_, panel_size_, frames_per_second_, lessons_shown_, has_thumbnails,
          moves_,      snaps_,      hexadecimal,        drawer_widths_, exported};
}

void App::apply(const Settings& settings) {
  kept_settings_ = settings;
  const std::vector<std::string> themes = Theme::names(paths_.share / "assets" / "themes");
  if (std::find(themes.begin(), themes.end(), settings.theme) != themes.end())
    set_theme(settings.theme);
  panel_size_ = std::clamp(settings.panel_size, kSmallestPanels, kLargestPanels);
  frames_per_second_ = std::clamp(settings.frames_per_second, kSlowest, kFastest);
  lessons_shown_ = settings.lessons;
  has_thumbnails = settings.thumbnails;
  moves_ = settings.motion;
  snaps_ = settings.snaps;
  hexadecimal = settings.hexadecimal;
  drawer_widths_ = settings.drawers;
  const ExportSettings& exported = settings.exported;
  const std::optional<Format> format = format_of(exported.format);
  const bool has_theme = std::find(themes.begin(), themes.end(), exported.theme) != themes.end();
  if (exported.folder.empty() || !format || !has_theme) return;
  ExportOptions options;
  options.out_dir = exported.folder;
  options.format = *format;
  options.theme = exported.theme;
  options.width = std::clamp(exported.width, 1, kMostPixels);
  options.height = std::clamp(exported.height, 1, kMostPixels);
  options.transparent = exported.transparent;
  options.stage_only = exported.stage_only;
  last_export = options;
}

void App::keep_settings() {
  const Settings now = settings();
  if (paths_.state.empty() || now == kept_settings_) return;
  kept_settings_ = now;
  try {
    write_whole(paths_.state / "settings", settings_text(now));
  } catch (const std::runtime_error&) {
    // This is a convenience: a full disk is reported when work is saved.
  }
}

void App::read_recent() {
  if (paths_.state.empty()) return;
  try {
    recent_ = lines_of(paths_.state / "recent");
    kept_memory_ = memory_ = memory_of(lines_of(paths_.state / "memory"));
    stopped_before_ = memory_.stopped;
  } catch (const std::runtime_error&) {
    // Conveniences.
  }
  if (recent_.size() > kMostRecent) recent_.resize(kMostRecent);
  for (const std::string& recent : recent_) will_show(recent);
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
    // This is a convenience: a full disk is reported when work is saved.
  }
}

}  // namespace gjkscope
