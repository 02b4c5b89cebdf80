#include "app.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "effects/registry.hpp"
#include "export/export.hpp"
#include "lesson/case.hpp"
#include "lesson/file.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/save.hpp"
#include "picture/registry.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector2d;

constexpr const char* kOpening = "polygons-gjk";
constexpr double kSaveEvery = 1.0;  // seconds; what a crash may cost
constexpr std::size_t kMostRecent = 10;

std::string read_whole(const fs::path& file) {
  std::error_code none;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || fs::is_directory(file, none))
    throw std::runtime_error(fmt::format("cannot read {}", file.string()));
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What is saved has no comments: a file that may have some is kept beside itself, and its new name
/// returned.
std::string keep_commented(const fs::path& file) {
  std::error_code none;
  if (!fs::exists(file, none)) return "";
  const std::string text = read_whole(file);
  if (text.find('#') == std::string::npos) return "";
  std::string beside = file.string() + "~";
  write_whole(beside, text);
  return beside;
}

/// A lesson that can be written anywhere.
Lesson with_absolute_results(Lesson lesson) {
  if (lesson.study) {
    lesson.study->results =
        fs::absolute(fs::path(lesson.path).parent_path() / lesson.study->results).string();
  }
  return lesson;
}

/// What a run came to, for the lesson's file to expect.
Expectation outcome_of(const LessonRun& run) {
  const WideTrace& trace = run.runs.back().trace;
  Expectation expect;
  expect.stop = trace.result.stop;
  expect.distance = trace.result.distance;
  if (!run.depths.empty() && run.depths.back().result.depth >= 0.0)
    expect.depth = run.depths.back().result.depth;
  expect.supports.emplace();
  for (const gjk::Step<double, 2>& step : trace.steps) {
    if (step.phase != gjk::Phase::support) continue;
    const gjk::VertexPair pair = step.after.support.pair;
    const std::string& y = run.lesson.y.vertex_names[static_cast<std::size_t>(pair.y)];
    const std::string& x = run.lesson.x.vertex_names[static_cast<std::size_t>(pair.x)];
    expect.supports->push_back(run.point_query() ? y : fmt::format("{}-{}", y, x));
  }
  return expect;
}

std::string all_of(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems)
    text += fmt::format("{}{}", text.empty() ? "" : "\n", to_string(problem));
  return text;
}

}  // namespace

App::App(Paths paths, const Fonts& fonts, const std::string& name)
    : paths_(std::move(paths)),
      fonts_(fonts),
      session_(fonts),
      theme_(Theme::load(paths_.share / "assets" / "themes", theme_name_)) {
  const fs::path folder = fs::is_directory(name) ? fs::path(name) : paths_.share / "lessons";
  for (const LoadedLesson& loaded : load_lessons(folder, vocabulary())) {
    if (loaded.lesson) {
      lessons_.push_back({loaded.lesson->path, loaded.lesson->id, loaded.lesson->title,
                          loaded.lesson->chapter, ""});
    } else {
      const Problem& first = loaded.problems.front();
      lessons_.push_back({first.file, fs::path(first.file).stem().string(),
                          fs::path(first.file).filename().string(), 0, to_string(first)});
    }
  }
  make_commands();
  const fs::path opening = paths_.share / "lessons" / (std::string(kOpening) + ".toml");
  fs::path file = opening;
  if (!name.empty() && !fs::is_directory(name)) {
    const fs::path by_id = paths_.share / "lessons" / (name + ".toml");
    file = fs::exists(name) ? fs::path(name) : by_id;
    if (!fs::exists(file)) {
      throw std::runtime_error(fmt::format(
          "there is no lesson, case or folder '{}'; `gjkscope lessons` lists the lessons", name));
    }
  } else if (fs::is_directory(name)) {
    const auto good =
        std::find_if(lessons_.begin(), lessons_.end(),
                     [](const ListedLesson& lesson) { return lesson.problem.empty(); });
    if (good == lessons_.end())
      throw std::runtime_error(fmt::format("{} holds no lesson that can be shown", name));
    file = good->file;
  }
  open_path(file);
  if (message_is_error_) throw std::runtime_error(message_);
  message_.clear();
  if (name.empty()) session_.step_iteration(1);
  if (!paths_.state.empty()) {
    std::error_code none;
    fs::create_directories(paths_.state, none);
    std::ifstream recent(paths_.state / "recent");
    for (std::string line; std::getline(recent, line) && recent_.size() < kMostRecent;)
      recent_.push_back(line);
    restore();
  }
}

App::~App() {
  if (session_.all_unsaved().empty()) keep_only(0);
}

// Files ------------------------------------------------------------------------------------------

void App::say(std::string message, bool is_error) {
  message_ = std::move(message);
  message_is_error_ = is_error;
}

void App::open_path(const fs::path& path) {
  try {
    if (path.extension() == ".json") {
      const std::string text = read_whole(path);
      if (text.find("\"rows\":") == std::string::npos) {
        open_case_text(text, path.string());
      } else {
        open_results(text, path);
      }
    } else {
      open_lesson(path);
    }
  } catch (const std::runtime_error& error) {
    say(error.what(), true);
  }
}

void App::open_lesson(const fs::path& file) {
  LoadedLesson loaded = parse_lesson(read_whole(file), file, vocabulary());
  if (!loaded.lesson) return say(all_of(loaded.problems), true);
  if (show(std::move(*loaded.lesson), file, file.string())) remember_recent(file);
}

void App::open_case_text(std::string_view text, const std::string& name, bool unsaved) {
  const std::vector<ReadCase> cases = parse_cases(text, name);
  if (!cases.front().value) return say(all_of(cases.front().problems), true);
  std::optional<Lesson> lesson = lesson_around(*cases.front().value, cases.front().name);
  if (lesson && show(*std::move(lesson), {}, name, unsaved) && cases.size() > 1)
    say(fmt::format("the first of {} cases", cases.size()));
}

std::optional<Lesson> App::lesson_around(const Case& shapes, const std::string& name) {
  // A case has no words and no views: it is shown as the opening lesson shows its shapes.
  const Lesson plain = lesson_of(shapes, name, ScalarKind::double_);
  const fs::path template_file = paths_.share / "lessons" / (std::string(kOpening) + ".toml");
  LoadedLesson loaded = parse_lesson(read_whole(template_file), template_file, vocabulary());
  if (!loaded.lesson) {
    say(all_of(loaded.problems), true);
    return std::nullopt;
  }
  Lesson lesson = std::move(*loaded.lesson);
  lesson.id = plain.id;
  lesson.path.clear();
  lesson.title = name;
  lesson.prose = "Shapes of a case. The distance is {distance}.";
  lesson.source.clear();
  lesson.x = plain.x;
  lesson.y = plain.y;
  lesson.options = plain.options;
  lesson.questions.clear();
  lesson.expect = {};
  for (LessonView& view : lesson.views) view.camera.reset();
  // All differences of large shapes are more than can be told apart, and than can be computed.
  constexpr std::size_t kMostPairs = 100'000;
  if (lesson.x.vertices.size() * lesson.y.vertices.size() > kMostPairs) {
    for (LessonView& view : lesson.views) view.effects.clear();
  }
  lesson.expect.stop = gjk::StopReason::repeated_support;  // saving writes what it comes to
  return lesson;
}

bool App::show(Lesson lesson, const fs::path& file, const std::string& name, bool unsaved) {
  release();
  const bool leaves_unsaved = session_.is_unsaved();
  if (!session_.open(std::move(lesson), file, unsaved)) {
    say(fmt::format("{}: {}", name, session_.problem()), true);
    return false;
  }
  say(leaves_unsaved ? "undo goes back to what was not saved" : "");
  selected_ = {};
  playing_ = false;
  if (leaves_unsaved || unsaved) {
    keep_unsaved();
  } else {
    kept_version_ = session_.version();
  }
  back_.reset();
  return true;
}

void App::file_changed(const fs::path& path) {
  if (path != session_.file()) return;
  try {
    LoadedLesson loaded = parse_lesson(read_whole(path), path, vocabulary());
    if (!loaded.lesson) return say(all_of(loaded.problems), true);
    if (*loaded.lesson == session_.lesson()) return;
    release();
    if (!session_.reload(std::move(*loaded.lesson)))
      return say(fmt::format("{}: {}", path.string(), session_.problem()), true);
    say(fmt::format("{} has changed and was read again; undo brings back what was here",
                    path.filename().string()));
  } catch (const std::runtime_error&) {
    // Between two writes of an editor there may be no file.
  }
}

void App::save_to(const fs::path& file) {
  try {
    if (file.extension() == ".json") {
      const PositionedRun& run = session_.run().run(session_.frame());
      write_whole(file, case_json(case_of(run), session_.lesson().id));
      return say(fmt::format("saved the case {}", file.string()));
    }
    Lesson lesson = with_absolute_results(session_.lesson_as_seen());
    lesson.expect = outcome_of(session_.run());
    const std::string commented = keep_commented(file);
    write_whole(file, lesson_toml(lesson));
    session_.mark_saved(file);
    remember_recent(file);
    keep_unsaved();
    say(fmt::format("saved {}{}", file.string(),
                    commented.empty() ? "" : "; as it was, with its comments: " + commented));
  } catch (const std::runtime_error& error) {
    say(error.what(), true);
  }
}

void App::save_answers_to(const fs::path& file) {
  try {
    write_whole(file, session_.answers_json());
    say(fmt::format("saved {}", file.string()));
  } catch (const std::runtime_error& error) {
    say(error.what(), true);
  }
}

void App::export_to(const fs::path& folder, bool all) {
  ExportOptions options;
  options.out_dir = folder;
  options.assets_dir = paths_.share / "assets";
  options.theme = theme_name_;
  options.index = all;
  options.questions = false;
  Lesson lesson = session_.lesson_as_seen();
  lesson.questions.clear();
  if (!all) {
    int step = 0;
    for (int i = 0; i <= session_.index(); ++i)
      step += session_.run().frames[static_cast<std::size_t>(i)].question < 0 ? 1 : 0;
    options.first_step = options.last_step = std::max(step, 1);
  }
  std::string outcome;
  bool failed = false;
  // A thread of its own: there the off-screen renderer's context is current, and here the window's.
  std::thread([&] {
    try {
      const ExportResult result = export_lessons({lesson}, options);
      outcome = fmt::format("{} {} in {}", result.frames, result.frames == 1 ? "frame" : "frames",
                            folder.string());
    } catch (const std::exception& error) {
      outcome = error.what();
      failed = true;
    }
  }).join();
  say(outcome, failed);
}

void App::remember_recent(const fs::path& file) {
  const std::string path = fs::absolute(file).lexically_normal().string();
  std::erase(recent_, path);
  recent_.insert(recent_.begin(), path);
  if (recent_.size() > kMostRecent) recent_.resize(kMostRecent);
  if (paths_.state.empty()) return;
  std::string text;
  for (const std::string& each : recent_) text += each + "\n";
  try {
    write_whole(paths_.state / "recent", text);
  } catch (const std::runtime_error&) {
    // A convenience; a full disk is said where work is saved.
  }
}

// Unsaved work -----------------------------------------------------------------------------------

namespace {
constexpr std::string_view kKeptFrom = "# unsaved work on ";
std::string kept_name(long process, int number) {
  return fmt::format("unsaved-{}-{}.toml", process, number);
}
}  // namespace

void App::autosave() {
  if (session_.version() != kept_version_) keep_unsaved();
}

void App::keep_unsaved() {
  if (paths_.state.empty()) return;
  kept_version_ = session_.version();
  next_save_ = now_ + kSaveEvery;
  int kept = 0;
  try {
    for (const Session::Unsaved& each : session_.all_unsaved()) {
      const std::string text = fmt::format("{}{}\n{}", kKeptFrom, each.file.string(),
                                           lesson_toml(with_absolute_results(each.lesson)));
      // Bytes: not pushed to the disk, which would hold up a drag; a killed process loses none.
      write_whole(paths_.state / kept_name(::getpid(), ++kept),
                  std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    }
    keep_only(kept);
  } catch (const std::runtime_error& error) {
    say(fmt::format("unsaved work cannot be kept: {}", error.what()), true);
  }
}

void App::keep_only(int count) const {
  if (paths_.state.empty()) return;
  std::error_code none;
  while (fs::remove(paths_.state / kept_name(::getpid(), ++count), none)) continue;
}

void App::restore() {
  std::error_code none;
  std::map<std::pair<long, int>, fs::path> kept;
  for (const fs::directory_entry& entry : fs::directory_iterator(paths_.state, none)) {
    const std::string name = entry.path().filename().string();
    long process = 0;
    int number = 0;
    if (std::sscanf(name.c_str(), "unsaved-%ld-%d.toml", &process, &number) != 2 ||
        name != kept_name(process, number)) {
      continue;
    }
    const bool alive = ::kill(static_cast<pid_t>(process), 0) == 0;
    if (!alive) kept[{process, number}] = entry.path();
  }
  std::vector<std::string> restored;
  std::vector<fs::path> taken;
  for (const auto& [key, path] : kept) {
    try {
      const std::string text = read_whole(path);
      const std::size_t end = text.find('\n');
      std::string from;
      if (text.starts_with(kKeptFrom) && end != std::string::npos)
        from = text.substr(kKeptFrom.size(), end - kKeptFrom.size());
      LoadedLesson loaded = parse_lesson(text, from.empty() ? "unsaved.toml" : from, vocabulary());
      if (!loaded.lesson || !session_.open(std::move(*loaded.lesson), from, true)) continue;
      restored.push_back(from.empty() ? session_.lesson().title
                                      : fs::path(from).filename().string());
      taken.push_back(path);
    } catch (const std::runtime_error&) {
      continue;
    }
  }
  if (restored.empty()) return;
  keep_unsaved();
  for (const fs::path& path : taken) fs::remove(path, none);
  say(fmt::format("restored what was not saved of {}{}", fmt::join(restored, ", "),
                  restored.size() > 1 ? "; undo goes back through them" : ""));
}

// Time -------------------------------------------------------------------------------------------

void App::tick(double now) {
  now_ = now;
  if (playing_ && now_ >= next_step_) {
    const bool waits = session_.question() != nullptr;
    if (waits || !session_.step(1)) playing_ = false;
    next_step_ = now_ + 1.0 / frames_per_second_;
  }
  if (now_ >= next_save_) autosave();
}

std::optional<double> App::wakes_at() const {
  std::optional<double> at;
  if (playing_) at = next_step_;
  if (!paths_.state.empty() && session_.version() != kept_version_)
    at = std::min(at.value_or(HUGE_VAL), next_save_);
  return at;
}

// Commands ---------------------------------------------------------------------------------------

void App::step(int by) {
  playing_ = false;
  if (by > 0 && session_.question()) {
    say("a question is open: answer it, or go on with Shift+Right");
    return;
  }
  session_.step(by);
}

void App::choose(int number) {
  const FrameQuestion* question = session_.question();
  if (question && number < static_cast<int>(question->choices.size()))
    answer(question->choices[static_cast<std::size_t>(number)]);
}

void App::answer(const std::string& choice) {
  session_.answer(choice);
  const Answer& given = session_.answers().back();
  last_answer_ = given.is_right();
  say(given.is_right() ? fmt::format("Right: {}.", given.right)
                       : fmt::format("Not {}: {}.", given.chosen, given.right));
}

void App::select_next(int by) {
  using Kind = Subject::Kind;
  const int of_x = static_cast<int>(session_.lesson().x.vertices.size());
  const int of_y = static_cast<int>(session_.lesson().y.vertices.size());
  int at = selected_.kind == Kind::vertex_of_x   ? selected_.x
           : selected_.kind == Kind::vertex_of_y ? of_x + selected_.y
           : by > 0                              ? -1
                                                 : 0;
  at = (at + by + of_x + of_y) % (of_x + of_y);
  selected_ =
      at < of_x ? Subject{Kind::vertex_of_x, at} : Subject{Kind::vertex_of_y, -1, at - of_x};
}

void App::nudge(const Vector2d& pixels) {
  using Kind = Subject::Kind;
  if (session_.stages().empty()) return;
  const LessonPictures::Stage stage = session_.stages().front();
  const double unit = stage.camera.height / stage.card.size().y();
  const Vector2d by = snap_ > 0.0 ? Vector2d(snap_ * pixels / pixels.cwiseAbs().maxCoeff())
                                  : Vector2d(2.0 * unit * pixels);
  const bool of_x = selected_.kind == Kind::vertex_of_x || selected_.kind == Kind::shape_x;
  const edit::Which which = of_x ? edit::Which::x : edit::Which::y;
  session_.end_drag();
  const PositionedRun& run = session_.run().run(session_.frame());
  const auto& world = of_x ? run.x_world : run.y_world;
  if (selected_.kind == Kind::vertex_of_x || selected_.kind == Kind::vertex_of_y) {
    const int index = of_x ? selected_.x : selected_.y;
    session_.change("move a vertex", [&](Lesson& lesson) {
      if (world.size() == 1) return edit::move_shape(lesson, which, by);
      edit::put_vertex(lesson, which, index, edit::placement_of(run, which),
                       world[static_cast<std::size_t>(index)] + by);
    });
  } else if (selected_.kind == Kind::shape_x || selected_.kind == Kind::shape_y) {
    session_.change("move a shape", [&](Lesson& lesson) { edit::move_shape(lesson, which, by); });
  }
}

void App::erase_selected() {
  using Kind = Subject::Kind;
  const bool of_x = selected_.kind == Kind::vertex_of_x;
  if (!of_x && selected_.kind != Kind::vertex_of_y) return say("no vertex is selected");
  const edit::Which which = of_x ? edit::Which::x : edit::Which::y;
  const int index = of_x ? selected_.x : selected_.y;
  const Lesson& lesson = session_.lesson();
  Lesson tried = lesson;
  if (!edit::erase_vertex(tried, which, index)) return say("a shape keeps its last vertex", true);
  if (!is_sound(tried)) return;
  session_.change("delete a vertex", [&](Lesson& edited) { edited = tried; });
  selected_ = {};
}

bool App::is_sound(const Lesson& lesson) {
  const LoadedLesson read =
      parse_lesson(lesson_toml(lesson), lesson.path.empty() ? "lesson" : lesson.path, vocabulary());
  if (read.lesson) return true;
  std::string why;
  for (const Problem& problem : read.problems) {
    why += fmt::format("{}{}", why.empty() ? "" : "; ", problem.what);
    if (!problem.expected.empty()) why += fmt::format(", expected {}", problem.expected);
  }
  say(fmt::format("this lesson cannot have that: {}", why), true);
  return false;
}

void App::set_theme(const std::string& name) {
  theme_ = Theme::load(paths_.share / "assets" / "themes", name);
  theme_name_ = name;
}

bool App::is_dark() const {
  const Color c = theme_.background();
  return 0.3 * c.r + 0.6 * c.g + 0.1 * c.b < 128.0;
}

void App::make_commands() {
  const auto add = [&](std::string group, std::string name, std::vector<std::string> keys,
                       std::function<void()> run) {
    commands_.push_back({std::move(name), std::move(group), std::move(keys), std::move(run)});
  };
  add("Step", "Next step", {"Right", "PageDown"}, [&] { step(1); });
  add("Step", "Step before", {"Left", "PageUp"}, [&] { step(-1); });
  add("Step", "Next iteration", {"Shift+Right"}, [&] {
    playing_ = false;
    session_.step_iteration(1);
  });
  add("Step", "Iteration before", {"Shift+Left"}, [&] {
    playing_ = false;
    session_.step_iteration(-1);
  });
  add("Step", "First frame", {"Home"}, [&] { session_.go_to(0); });
  add("Step", "Last frame", {"End"}, [&] { session_.go_to(session_.frame_count() - 1); });
  add("Step", "Play or pause", {"Space"}, [&] {
    playing_ = !playing_;
    if (playing_ && session_.index() + 1 == session_.frame_count()) session_.go_to(0);
    next_step_ = now_ + 1.0 / frames_per_second_;
  });
  add("Step", "Play faster", {"]"},
      [&] { frames_per_second_ = std::min(2.0 * frames_per_second_, 32.0); });
  add("Step", "Play slower", {"["},
      [&] { frames_per_second_ = std::max(0.5 * frames_per_second_, 0.25); });
  add("Predict", "Predict mode", {"P"}, [&] {
    session_.set_predicting(!session_.is_predicting());
    drawer_ = session_.is_predicting() ? Drawer::predict : Drawer::none;
    last_answer_.reset();
  });
  for (int i = 0; i < 9; ++i) {
    add("Predict", fmt::format("Answer {}", i + 1), {std::to_string(i + 1)},
        [this, i] { choose(i); });
  }
  add("Edit", "Undo", {"Ctrl+Z"}, [&] {
    release();  // what is held may not be there afterwards
    const std::string name = session_.undo_name();
    say(session_.undo() ? fmt::format("undone: {}", name) : "nothing to undo");
  });
  add("Edit", "Redo", {"Ctrl+Y", "Ctrl+Shift+Z"}, [&] {
    release();
    const std::string name = session_.redo_name();
    say(session_.redo() ? fmt::format("done again: {}", name) : "nothing to do again");
  });
  add("Edit", "Select the next vertex", {"Tab"}, [&] { select_next(1); });
  add("Edit", "Select the vertex before", {"Shift+Tab"}, [&] { select_next(-1); });
  add("Edit", "Move what is selected right", {"Ctrl+Right"}, [&] { nudge({1, 0}); });
  add("Edit", "Move what is selected left", {"Ctrl+Left"}, [&] { nudge({-1, 0}); });
  add("Edit", "Move what is selected up", {"Ctrl+Up"}, [&] { nudge({0, 1}); });
  add("Edit", "Move what is selected down", {"Ctrl+Down"}, [&] { nudge({0, -1}); });
  add("Edit", "Delete the selected vertex", {"Delete", "Backspace"}, [&] { erase_selected(); });
  add("Edit", "Snap to a grid", {"G"}, [&] { snap_ = snap_ > 0.0 ? 0.0 : 0.25; });
  add("Edit", "Copy as case", {"Ctrl+C"}, [&] {
    if (copy) copy(case_json(case_of(session_.run().run(session_.frame())), session_.lesson().id));
    say("copied the shapes as a case");
  });
  add("Edit", "Paste a case", {"Ctrl+V"}, [&] {
    if (paste) open_case_text(paste(), "pasted", true);
  });
  add("File", "Open", {"Ctrl+O"}, [&] {
    dialog_ = Dialog::open;
    field_ = session_.file().parent_path().string();
  });
  add("File", "Save", {"Ctrl+S"}, [&] {
    const fs::path& file = session_.file();
    std::error_code none;
    const bool shipped =
        !file.empty() && fs::equivalent(file.parent_path(), paths_.share / "lessons", none);
    if (!file.empty() && !shipped) return save_to(file);
    dialog_ = Dialog::save;
    field_ = fmt::format("{}.toml", session_.lesson().id);
  });
  add("File", "Save as", {"Ctrl+Shift+S"}, [&] {
    dialog_ = Dialog::save;
    field_ = session_.file().empty() ? session_.lesson().id + ".toml" : session_.file().string();
  });
  add("File", "Export frames", {"Ctrl+E"}, [&] {
    dialog_ = Dialog::export_frames;
    field_ = "frames";
  });
  add("File", "Quit", {"Ctrl+Q"}, [&] { quit_ = true; });
  add("View", "Fit", {"F"}, [&] { session_.fit(); });
  add("View", "Lessons", {"L"}, [&] { lessons_shown_ = !lessons_shown_; });
  const auto toggle = [this](Drawer drawer) {
    drawer_ = drawer_ == drawer ? Drawer::none : drawer;
  };
  add("View", "Shapes", {"S"}, [toggle] { toggle(Drawer::shapes); });
  add("View", "Values", {"V"}, [toggle] { toggle(Drawer::values); });
  add("View", "Numerics", {"N"}, [toggle] { toggle(Drawer::numerics); });
  add("View", "Effects", {"E"}, [toggle] { toggle(Drawer::effects); });
  add("View", "Study", {"A"}, [toggle] { toggle(Drawer::study); });
  add("View", "Worst run of the configuration", {"Enter"}, [&] {
    const auto& study = session_.lesson().study;
    const StudyFrame shown = session_.frame().study.value_or(StudyFrame{});
    if (shown.stage != StudyStage::mark)
      return say("this frame introduces no configuration of a study");
    const StudyMark& mark = study->marks[static_cast<std::size_t>(shown.marks - 1)];
    open_worst_run(study->dot(mark.configuration));
  });
  add("View", "Back to the study", {"B"}, [&] { go_back(); });
  add("View", "Presenter mode", {"F5", "F11"}, [&] { presenting_ = !presenting_; });
  add("View", "Larger panels", {"Ctrl+=", "Ctrl++"},
      [&] { panel_size_ = std::min(panel_size_ + 0.125, 3.0); });
  add("View", "Smaller panels", {"Ctrl+-"},
      [&] { panel_size_ = std::max(panel_size_ - 0.125, 0.75); });
  for (const std::string& theme : Theme::names(paths_.share / "assets" / "themes"))
    add("View", "Theme " + theme, {}, [this, theme] { set_theme(theme); });
  add("View", "Next theme", {"T"}, [&] {
    const std::vector<std::string> names = Theme::names(paths_.share / "assets" / "themes");
    const auto now = std::find(names.begin(), names.end(), theme_name_);
    set_theme(now == names.end() || now + 1 == names.end() ? names.front() : *(now + 1));
  });
  add("Help", "Keys", {"?", "F1"},
      [&] { dialog_ = dialog_ == Dialog::help ? Dialog::none : Dialog::help; });
  add("Help", "Any command", {"Ctrl+P", "/"}, [&] {
    dialog_ = Dialog::palette;
    filter_.clear();
  });
  add("Help", "Close or leave", {"Escape"}, [&] {
    if (dialog_ != Dialog::none) {
      dialog_ = Dialog::none;
    } else if (presenting_) {
      presenting_ = false;
    } else {
      selected_ = {};
      say("");
    }
  });
}

bool App::press(const KeyPress& press) {
  const std::string name =
      fmt::format("{}{}{}", press.ctrl ? "Ctrl+" : "", press.shift ? "Shift+" : "", press.key);
  // Under a dialog nothing moves but the dialog.
  if (dialog_ != Dialog::none && name != "Escape" && !(dialog_ == Dialog::help && name == "?"))
    return false;
  for (const Command& command : commands_) {
    if (std::find(command.keys.begin(), command.keys.end(), name) == command.keys.end()) continue;
    command.run();
    return true;
  }
  return false;
}

bool App::run_command(std::string_view name) {
  for (const Command& command : commands_) {
    if (command.name != name) continue;
    command.run();
    return true;
  }
  return false;
}

// For tests and scripts --------------------------------------------------------------------------

std::string App::title() const {
  return fmt::format("{}{} - gjkscope", session_.is_unsaved() ? "* " : "", session_.lesson().title);
}

std::string App::state_json() {
  const Frame& frame = session_.frame();
  nlohmann::ordered_json json = {{"lesson", session_.lesson().id},
                                 {"frame", session_.index()},
                                 {"frames", session_.frame_count()},
                                 {"iteration", session_.text().iteration},
                                 {"phase", session_.text().phase},
                                 {"caption", session_.text().caption},
                                 {"distance", session_.run().run(frame).trace.result.distance},
                                 {"unsaved", session_.is_unsaved()},
                                 {"undo", session_.undo_name()},
                                 {"redo", session_.redo_name()},
                                 {"playing", playing_},
                                 {"presenting", presenting_},
                                 {"theme", theme_name_},
                                 {"message", message_},
                                 {"question", session_.question() != nullptr},
                                 {"asked", session_.answers().size()},
                                 {"right", session_.right_answers()}};
  const auto vertices = [](const LessonShape& shape) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const Vector2d& vertex : shape.vertices) out.push_back({vertex.x(), vertex.y()});
    return out;
  };
  json["x"] = vertices(session_.lesson().x);
  json["y"] = vertices(session_.lesson().y);
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace gjkscope
