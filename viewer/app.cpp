#include "app.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/file.hpp"
#include "drawers/study.hpp"
#include "files.hpp"
#include "lesson/chapters.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "paint/svg.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"
#include "subjects/grid/grid.hpp"
#include "subjects/run/code.hpp"
#include "subjects/subjects.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace {

constexpr double kTurn = 10.0;  // degrees for a key

namespace fs = std::filesystem;
using Eigen::Vector2d;

constexpr double kMessageStays = 4.0;  // seconds; errors stay until they were read
constexpr double kLooksBeside = 0.1;   // seconds; at what is done beside the window

/// Whether there is such a vertex or shape: what was selected may have been undone.
bool has(const Lesson& lesson, const Subject& subject) {
  if (!is_vertex(subject)) return is_shape(subject);
  return static_cast<std::size_t>(index_of(subject)) <
         lesson.bodies[body_of(subject)].vertices.size();
}

}  // namespace

App::App(Paths paths, const Fonts& fonts, const std::string& name)
    : paths_(std::move(paths)),
      fonts_(fonts),
      session_(fonts),
      theme_(Theme::load(paths_.share / "assets" / "themes", theme_name_)),
      picture_(*this),
      asking_(*this),
      thumbnails_(fonts),
      chapters_(parse_chapters(read_whole(paths_.share / "assets" / "chapters.toml"),
                               "assets/chapters.toml")),
      terms_(parse_terms(read_whole(paths_.share / "assets" / "terms.toml"), "assets/terms.toml")),
      unsaved_(paths_.state) {
  session_.work_beside();
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
#define DRAWER(name) drawers_.push_back(name##_drawer(*this));
#include "drawers.def"
#undef DRAWER
  for (const ListedLesson& lesson : lessons_) {
    will_show(lesson.title);
    will_show(lesson.problem);
  }
  make_commands();
  read_recent();
  if (!paths_.state.empty()) apply(read_settings(paths_.state / "settings"));
  fs::path file = opening_lesson(paths_.share);
  if (fs::is_directory(name)) {
    const auto good =
        std::find_if(lessons_.begin(), lessons_.end(),
                     [](const ListedLesson& lesson) { return lesson.problem.empty(); });
    if (good == lessons_.end())
      throw std::runtime_error(fmt::format("{} holds no lesson that can be shown", name));
    file = good->file;
  } else if (!name.empty()) {
    file = fs::exists(name) ? fs::path(name) : paths_.share / "lessons" / (name + ".toml");
    if (!fs::exists(file)) {
      std::vector<std::string> known;
      for (const ListedLesson& lesson : lessons_) known.push_back(lesson.id);
      const std::string nearest = nearest_name(name, known);
      throw std::runtime_error(fmt::format(
          "there is no lesson, case or folder '{}'{}; `gjkscope lessons` lists the lessons", name,
          nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest)));
    }
  }
  const bool is_first = recent_.empty();
  open_path(file);
  if (!error_.empty()) throw std::runtime_error(error_details_);
  welcomes_ = is_first && name.empty();
  offer_left_work();
}

App::~App() {
  stop_export_.request_stop();
  keep_unsaved();
  for (const LeftWork& each : left_) {
    if (each.is_discarded) unsaved_.forget(each.work);
  }
  keep_settings();
}

void App::will_show(std::string_view name) {
  for (const char32_t c : code_points(name)) {
    if (c >= 0x80) characters_.insert(c);
  }
}

// Time -------------------------------------------------------------------------------------------

void App::say(std::string message, bool is_error) {
  if (!is_error) {
    message_ = std::move(message);
    message_ends_.reset();
    return;
  }
  error_ = message.substr(0, message.find('\n'));
  error_details_ = std::move(message);
  error_at_.reset();
}

void App::say(const std::vector<Problem>& problems) {
  say(to_string(problems), true);
  error_ = in_one_line(problems);
}

void App::tick(double now) {
  now_ = now;
  if (playing_ && now_ >= next_step_) {
    if (session_.question() || !session_.step(1)) playing_ = false;
    next_step_ = now_ + 1.0 / frames_per_second_;
  }
  asking_.tick(now_);
  end_export();
  end_opening();
  work_beside();
  thumbnails_.tick();
  if (!message_ends_) message_ends_ = is_exporting() ? HUGE_VAL : now_ + kMessageStays;
  if (now_ >= *message_ends_) message_.clear();
  // A new action clears the error of the one before.
  const std::pair<long, int> here(session_.version(), session_.index());
  if (!error_at_) error_at_ = here;
  if (*error_at_ != here) error_.clear();
  watch_file();
  find_missing_character();
  if (!closed_.empty()) forget_closed();
  if (keeping_.valid() && is_ready(keeping_)) end_keeping();
  const bool is_due = unsaved_.keeps() && now_ >= next_save_ && session_.version() != kept_version_;
  if (is_due && !keeping_.valid()) keep_unsaved_beside();
  note_memory();
  if (!ImGui::GetIO().MouseDown[0]) keep_settings();
}

std::optional<double> App::wakes_at() const {
  double at = HUGE_VAL;
  if (playing_) at = next_step_;
  constexpr double kImage = 1.0 / 60.0;
  if (picture_.is_moving()) at = std::min(at, now_ + kImage);
  if (!message_.empty()) at = std::min(at, message_ends_.value_or(0.0));
  if (gone_since_ && now_ < *gone_since_ + kGoneAfter) at = std::min(at, *gone_since_ + kGoneAfter);
  at = std::min(at, presenter_.wakes_at(now_).value_or(HUGE_VAL));
  at = std::min(at, asking_.wakes_at().value_or(HUGE_VAL));
  const Drawer* open = drawer_ ? &drawers_[*drawer_] : nullptr;
  if (is_exporting() || is_opening() || working_.valid() || keeping_.valid() ||
      makes_thumbnails() || (open && open->waits && open->waits()))
    at = std::min(at, now_ + kLooksBeside);
  if (unsaved_.keeps() && session_.version() != kept_version_ && !keeping_.valid())
    at = std::min(at, next_save_);
  if (std::isinf(at)) return std::nullopt;
  return at;
}

// Changes ----------------------------------------------------------------------------------------

bool App::edit(const std::string& name, Lesson lesson) {
  if (session_.edit(name, std::move(lesson))) return true;
  say(session_.problem(), true);
  // The places are those of a file that nobody has seen.
  if (!session_.problems().empty()) {
    const Problem& first = session_.problems().front();
    error_ = first.what + (first.expected.empty() ? "" : "; expected " + first.expected);
  }
  return false;
}

void App::select_next(int by) {
  const int of_x = static_cast<int>(session_.lesson().x().vertices.size());
  const int of_y = static_cast<int>(session_.lesson().y().vertices.size());
  Subject& selected = picture_.hand().selected;
  int at = by > 0 ? -1 : 0;
  if (is_vertex(selected)) at = index_of(selected) + (body_of(selected) == 0 ? 0 : of_x);
  at = (at + by + of_x + of_y) % (of_x + of_y);
  selected = at < of_x ? vertex_of(0, at) : vertex_of(1, at - of_x);
}

void App::nudge(const Vector2d& pixels) {
  if (session_.is_settling()) return;
  const Subject& selected = picture_.hand().selected;
  const LessonPictures::ShownView view = session_.views().front();
  const Vector2d units = view.camera.units_per_pixel(view.card.size().y());
  const Vector2d right_and_up = snaps_ ? Vector2d(picture_.grid(0).cwiseProduct(pixels))
                                       : Vector2d(2.0 * units.cwiseProduct(pixels));
  const Eigen::Vector3d by = along_screen(view.camera, right_and_up);
  session_.begin_drag(is_vertex(selected) ? "move a vertex" : "move a shape");
  const PositionedRun& run = session_.run().run(session_.frame());
  const int index = is_vertex(selected) ? index_of(selected) : -1;
  session_.drag([&](Lesson& lesson) { edit::nudge(lesson, body_of(selected), index, run, by); });
  session_.end_drag();
}

void App::erase_selected() {
  const Subject& selected = picture_.hand().selected;
  Lesson lesson = session_.lesson();
  if (!edit::erase_vertex(lesson, body_of(selected), index_of(selected)))
    return say("a shape keeps its last vertex");
  if (edit("delete a vertex", std::move(lesson))) picture_.hand().selected = {};
}

void App::step(int by) {
  playing_ = false;
  if (by > 0 && session_.is_predicting() && session_.question() && !is_presenting())
    return say("a question is open: choose with ↑ and ↓, answer with Enter, or Page Down tells");
  session_.step(by);
}

const ListedLesson* App::neighbour(int by) const {
  const auto open = std::find_if(lessons_.begin(), lessons_.end(), [&](const ListedLesson& each) {
    return each.id == session_.lesson().id;
  });
  if (open == lessons_.end()) return nullptr;
  for (auto i = open - lessons_.begin() + by; i >= 0 && i < std::ssize(lessons_); i += by) {
    const ListedLesson& lesson = lessons_[i];
    if (lesson.problem.empty()) return &lesson;
  }
  return nullptr;
}

void App::open_chapter(int chapter) {
  const auto first = std::find_if(lessons_.begin(), lessons_.end(), [&](const auto& lesson) {
    return lesson.chapter == chapter && lesson.problem.empty();
  });
  if (first != lessons_.end()) open_path(first->file);
}

bool App::can_click_on(int by) const {
  const int to = session_.index() + by;
  return (to >= 0 && to < session_.frame_count()) || (is_presenting() && neighbour(by) != nullptr);
}

void App::click_on(int by) {
  playing_ = false;
  session_.set_asking(true);
  if (session_.step(by) || !is_presenting() || neighbour(by) == nullptr) return;
  open_path(neighbour(by)->file);
  if (by < 0) session_.go_to(session_.frame_count() - 1);
}

const ListedLesson* App::listed(const std::string& id) const {
  const auto found = std::find_if(lessons_.begin(), lessons_.end(), [&](const auto& lesson) {
    return lesson.id == id && lesson.problem.empty();
  });
  return found == lessons_.end() ? nullptr : &*found;
}

void App::note_memory() {
  const std::string& id = session_.lesson().id;
  const bool is_new = noted_at_.second != session_.index() || noted_at_.first != id;
  if (!is_new && noted_answers_ == session_.answers().size()) return keep_memory();
  noted_at_ = {id, session_.index()};
  if (is_new && session_.index() + 1 == session_.frame_count()) memory_.finished.insert(id);
  // A lesson that was only opened leaves the place of the one before.
  if (is_new && session_.index() > 0 && listed(id) != nullptr) {
    const auto& frames = session_.run().frames;
    const auto asked = std::count_if(frames.begin(), frames.begin() + session_.index(),
                                     [](const Frame& frame) { return frame.question >= 0; });
    memory_.stopped = {id, session_.index() - static_cast<int>(asked)};
  }
  noted_answers_ = std::min(noted_answers_, session_.answers().size());
  for (; noted_answers_ < session_.answers().size(); ++noted_answers_) {
    const Answer& answer = session_.answers()[noted_answers_];
    const Memory::Asked asked{answer.lesson, answer.run, answer.step};
    if (answer.is_right()) memory_.wrong.erase(asked);
    if (!answer.is_right() && listed(answer.lesson) != nullptr) memory_.wrong.insert(asked);
  }
  keep_memory();
}

void App::keep_memory() {
  if (memory_ == kept_memory_) return;
  kept_memory_ = memory_;
  write_lines("memory", memory_lines(memory_));
}

void App::go_on() {
  const Memory::Place place = *stopped_before_;
  stopped_before_.reset();
  open_path(listed(place.lesson)->file);
  const auto& frames = session_.run().frames;
  int at = 0;
  for (int counted = 0; at + 1 < session_.frame_count() && counted < place.frame; ++at)
    counted += frames[at].question < 0 ? 1 : 0;
  session_.go_to(at);
}

void App::repeat_question() {
  const Memory::Asked asked = *memory_.wrong.begin();
  const ListedLesson* lesson = listed(asked.lesson);
  // A right answer takes it off the list, too.
  const auto give_up = [&] {
    memory_.wrong.erase(asked);
    keep_memory();
  };
  if (lesson == nullptr) return give_up();
  open_path(lesson->file);
  session_.set_predicting(true);
  const auto& frames = session_.run().frames;
  const auto found = std::find_if(frames.begin(), frames.end(), [&](const Frame& frame) {
    return frame.question >= 0 && frame.run == asked.run && frame.answering_step == asked.step;
  });
  found == frames.end() ? give_up() : session_.go_to(static_cast<int>(found - frames.begin()));
}

App::Progress App::progress(std::optional<int> chapter) const {
  Progress out;
  for (const ListedLesson& lesson : lessons_) {
    if (!lesson.problem.empty() || (chapter && lesson.chapter != *chapter)) continue;
    ++out.of;
    if (memory_.finished.contains(lesson.id)) ++out.done;
  }
  return out;
}

// Parts of the window ----------------------------------------------------------------------------

void App::show_dialog(Dialog dialog) { dialog_ = std::make_shared<Dialog>(std::move(dialog)); }

void App::show_drawer(std::string_view name, bool open) {
  for (std::size_t i = 0; i < drawers_.size(); ++i) {
    if (drawers_[i].name == name && (drawer_ == i) != open) toggle_drawer(i);
  }
}

void App::toggle_drawer(std::size_t index) {
  const std::optional<std::size_t> was = drawer_;
  drawer_ = was == index ? std::nullopt : std::optional(index);
  for (const std::optional<std::size_t>& changed : {was, drawer_}) {
    if (changed && drawers_[*changed].toggled) drawers_[*changed].toggled(changed == drawer_);
  }
}

bool App::offer_click(const Subject& subject) {
  return std::any_of(drawers_.begin(), drawers_.end(), [&](const Drawer& drawer) {
    return drawer.clicked && drawer.clicked(subject);
  });
}

void App::set_theme(const std::string& name) {
  theme_ = Theme::load(paths_.share / "assets" / "themes", name);
  theme_name_ = name;
}

bool App::is_dark() const {
  const Color c = theme_.background();
  return 0.3 * c.r + 0.6 * c.g + 0.1 * c.b < 128.0;
}

bool App::panels_have_keys() const {
  return focused_ || dialog_ || has_popup() || ImGui::GetIO().WantTextInput;
}

// Commands ---------------------------------------------------------------------------------------

void App::make_commands() {
  const auto add = [&](std::string group, std::string name, std::vector<std::string> keys,
                       std::function<void()> run, std::function<bool()> can = nullptr) {
    commands_.push_back(
        {std::move(name), std::move(group), std::move(keys), std::move(run), std::move(can)});
  };
  const auto is_not_first = [&] { return session_.index() > 0; };
  const auto is_not_last = [&] { return session_.index() + 1 < session_.frame_count(); };
  add(
      "Step", "Next step", {"Right"}, [&] { step(1); }, is_not_last);
  add(
      "Step", "Step before", {"Left"}, [&] { step(-1); }, is_not_first);
  add(
      "Step", "Go on, with the lesson's questions", {"PageDown"}, [&] { click_on(1); },
      [&] { return can_click_on(1); });
  add(
      "Step", "Go back, with the lesson's questions", {"PageUp"}, [&] { click_on(-1); },
      [&] { return can_click_on(-1); });
  add(
      "Step", "Next iteration", {"Shift+Right"},
      [&] {
        playing_ = false;
        session_.step_iteration(1);
      },
      is_not_last);
  add(
      "Step", "Iteration before", {"Shift+Left"},
      [&] {
        playing_ = false;
        session_.step_iteration(-1);
      },
      is_not_first);
  add(
      "Step", "First frame", {"Home"}, [&] { session_.go_to(0); }, is_not_first);
  add(
      "Step", "Last frame", {"End"}, [&] { session_.go_to(session_.frame_count() - 1); },
      is_not_last);
  add(
      "Step", "Play or pause", {"Space"},
      [&] {
        playing_ = !playing_;
        if (playing_ && session_.index() + 1 == session_.frame_count()) session_.go_to(0);
        next_step_ = now_ + 1.0 / frames_per_second_;
      },
      [&] { return session_.frame_count() > 1; });
  add("Step", "Play faster", {"]"},
      [&] { frames_per_second_ = std::min(2.0 * frames_per_second_, kFastest); });
  add("Step", "Play slower", {"["},
      [&] { frames_per_second_ = std::max(0.5 * frames_per_second_, kSlowest); });
  add(
      "Step", "Next lesson", {"Ctrl+PageDown"}, [&] { open_path(neighbour(1)->file); },
      [&] { return neighbour(1) != nullptr; });
  add(
      "Step", "Lesson before", {"Ctrl+PageUp"}, [&] { open_path(neighbour(-1)->file); },
      [&] { return neighbour(-1) != nullptr; });
  add(
      "Step", "Map of the course", {"M"}, [&] { open_path(listed("course-map")->file); },
      [&] { return listed("course-map") != nullptr; });
  add(
      "Step", "Continue where the window was left", {"Ctrl+Home"}, [&] { go_on(); },
      [&] { return stopped_before_ && listed(stopped_before_->lesson) != nullptr; });
  add(
      "Step", "Repeat a question that was answered wrong", {}, [&] { repeat_question(); },
      [&] { return !memory_.wrong.empty(); });
  add(
      "Step", "Forget what was done", {},
      [&] {
        memory_ = {};
        stopped_before_.reset();
        noted_at_ = {session_.lesson().id, session_.index()};
        keep_memory();
      },
      [&] { return memory_ != Memory{} || stopped_before_; });

  add(
      "Edit", "Undo", {"Ctrl+Z"},
      [&] {
        picture_.release();  // what is held may not be there afterwards
        const std::string name = session_.undo_name();
        if (session_.undo()) say(fmt::format("undone: {}", name));
      },
      [&] { return !session_.undo_name().empty(); });
  add(
      "Edit", "Cancel the change", {}, [this] { session_.cancel_drag(); },
      [this] { return session_.is_settling(); });
  add(
      "Edit", "Redo", {"Ctrl+Y", "Ctrl+Shift+Z"},
      [&] {
        picture_.release();
        const std::string name = session_.redo_name();
        if (session_.redo()) say(fmt::format("done again: {}", name));
      },
      [&] { return !session_.redo_name().empty(); });
  add("Edit", "Select the next vertex", {"Tab"}, [&] { select_next(1); });
  add("Edit", "Select the vertex before", {"Shift+Tab"}, [&] { select_next(-1); });
  const auto has_selected = [&] { return has(session_.lesson(), picture_.hand().selected); };
  for (const auto& [key, by] :
       {std::pair("Right", Vector2d(1, 0)), {"Left", {-1, 0}}, {"Up", {0, 1}}, {"Down", {0, -1}}}) {
    std::string where = key;
    where[0] = static_cast<char>(std::tolower(where[0]));
    add(
        "Edit", "Move what is selected " + where, {std::string("Ctrl+") + key},
        [this, by = by] { nudge(by); }, has_selected);
  }
  add(
      "Edit", "Delete the selected vertex", {"Delete", "Backspace"}, [&] { erase_selected(); },
      [&, has_selected] { return has_selected() && is_vertex(picture_.hand().selected); });
  add("Edit", "Snap to round numbers", {"G"}, [&] {
    snaps_ = !snaps_;
    say(snaps_ ? "drags go to round numbers" : "drags go anywhere");
  });
  add("Edit", "Copy as case", {"Ctrl+C"}, [&] {
    if (!copy) return;
    with_case(session_.run().run(session_.frame()),
              [&](const auto& shapes) { copy(case_json(shapes, session_.lesson().id)); });
    say("copied the shapes as a case");
  });
  add("Edit", "Copy the frame as SVG text", {"Ctrl+Shift+C"}, [&] {
    if (copy) copy(to_svg(session_.picture(), fonts_, theme_, alternative_text(session_.text())));
    say("copied the frame: paste it where SVG is read, or into a text file");
  });
  add("Edit", "Copy the frame in words", {}, [&] {
    if (copy) copy(alternative_text(session_.text()));
    say("copied what the frame says");
  });
  add("Edit", "Paste a case", {"Ctrl+V"}, [&] {
    if (paste) open_pasted(paste());
  });

  add("File", "Open", {"Ctrl+O"}, [&] { show_dialog(open_dialog(*this)); });
  add("File", "Save", {"Ctrl+S"}, [this] {
    const fs::path file = session_.file();
    if (file.empty() || is_of_course(file)) return save_as();
    save_to(file);
  });
  add("File", "Save as", {"Ctrl+Shift+S"}, [this] { save_as(); });
  add(
      "File", "Cancel opening", {},
      [this] {
        opening_->stop.request_stop();
        given_up_.push_back(*std::exchange(opening_, std::nullopt));
      },
      [this] { return opening_.has_value(); });
  const auto is_asked = [this] { return outside_ && outside_->file == session_.file(); };
  add(
      "File", "Keep mine", {}, [this] { keep_mine(); }, is_asked);
  add(
      "File", "Take the file's", {}, [this] { take_theirs(); },
      [this, is_asked] { return is_asked() && outside_->lesson; });
  add(
      "File", "Revert to what is saved", {"Ctrl+R"},
      [&] {
        picture_.release();
        if (!session_.revert()) return say(session_.problem(), true);
        say("as it is saved; undo brings back what was here");
      },
      [&] { return session_.saved() && session_.is_unsaved(); });
  const auto has_left = [this](bool is_discarded) {
    return std::any_of(left_.begin(), left_.end(),
                       [&](const LeftWork& each) { return each.is_discarded == is_discarded; });
  };
  add(
      "File", "Open unsaved work", {}, [this] { show_left_work(); },
      [this] { return !left_.empty(); });
  add(
      "File", "Discard unsaved work", {}, [this] { discard_left_work(true); },
      [has_left] { return has_left(false); });
  add(
      "File", "Put back discarded work", {}, [this] { discard_left_work(false); },
      [has_left] { return has_left(true); });
  add(
      "File", "Export frames", {"Ctrl+E"}, [&] { show_dialog(export_dialog(*this)); },
      [&] { return !is_exporting(); });
  add(
      "File", "Cancel the export", {}, [this] { stop_export_.request_stop(); },
      [this] { return is_exporting() && !stop_export_.stop_requested(); });
  add("File", "Quit", {"Ctrl+Q"}, [&] { ask_to_quit(); });

  add("View", "Fit", {"F"}, [&] { session_.fit(); });
  const auto is_in_space = [&] { return session_.eye().has_value(); };
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    const std::string_view side = kSides[i];
    add(
        "View", fmt::format("See from the side: {}", side), {fmt::format("Ctrl+{}", i + 1)},
        [this, side] { session_.set_eye(*eye_from(side, session_.run(), session_.frame())); },
        is_in_space);
  }
  for (const auto& [name, key, azimuth, elevation] :
       {std::tuple("Turn left", "Ctrl+Left", -kTurn, 0.0),
        {"Turn right", "Ctrl+Right", kTurn, 0.0},
        {"Turn up", "Ctrl+Up", 0.0, kTurn},
        {"Turn down", "Ctrl+Down", 0.0, -kTurn}}) {
    add(
        "View", name, {key},
        [this, azimuth = azimuth, elevation = elevation] {
          const Eye now = *session_.eye();
          session_.set_eye({now.azimuth + azimuth, now.elevation + elevation});
        },
        is_in_space);
  }
  add(
      "View", "Grid and axes", {"Shift+G"},
      [&] {
        const std::string name(Grid::kName);
        Lesson lesson = session_.lesson();
        const bool was_on = lesson.calls_for(name);
        for (LessonView& view : lesson.views) {
          std::erase(view.effects, name);
          if (!was_on && shows_shapes(view.kind)) view.effects.push_back(name);
        }
        edit("grid and axes", std::move(lesson));
      },
      [&] {
        const std::vector<LessonView>& views = session_.lesson().views;
        return std::any_of(views.begin(), views.end(),
                           [](const LessonView& view) { return shows_shapes(view.kind); });
      });
  add("View", "Lessons", {"L"}, [&] {
    const bool had = has_lessons();
    lessons_over_ = false;
    lessons_shown_ = !had;
    if (had) return;
    (void)layout(width_, height_, density_);
    lessons_over_ = !has_lessons();
  });
  add(
      "View", "Black screen", {"B", "."}, [&] { presenter_.blacken(true); },
      [&] { return is_presenting(); });
  for (std::size_t i = 0; i < drawers_.size(); ++i) {
    add("View", drawers_[i].name, {drawers_[i].key}, [this, i] { toggle_drawer(i); });
    for (const Command& command : drawers_[i].commands) commands_.push_back(command);
  }
  add("View", "Small pictures of lessons, or none", {}, [&] { has_thumbnails = !has_thumbnails; });
  add("View", "Motion between steps, or none", {}, [&] { moves_ = !moves_; });
  add("View", "Presenter mode", {"F5", "Shift+F5", "F11"}, [&] {
    presenter_.turn(!is_presenting());
    if (is_presenting()) session_.set_asking(true);
  });
  add("View", "Larger panels", {"Ctrl+=", "Ctrl++"},
      [&] { panel_size_ = std::min(panel_size_ + 0.125, kLargestPanels); });
  add("View", "Smaller panels", {"Ctrl+-"},
      [&] { panel_size_ = std::max(panel_size_ - 0.125, kSmallestPanels); });
  add("View", "Next panel by keyboard", {"F6"}, [&] { focus_next_panel(1); });
  add("View", "Panel before by keyboard", {"Shift+F6"}, [&] { focus_next_panel(-1); });
  const std::vector<std::string> themes = Theme::names(paths_.share / "assets" / "themes");
  for (const std::string& theme : themes)
    add("View", "Theme " + theme, {}, [this, theme] { set_theme(theme); });
  const auto has_code = [&] {
    return code::in_language(session_.lesson(), Language::cpp).has_value();
  };
  add(
      "View", "Next language of the listing", {"C"},
      [&] {
        constexpr int kCount = Named<Language>::kTable.size();
        Lesson lesson = session_.lesson();
        const int now = static_cast<int>(code::language_of(lesson.listing));
        const auto next = static_cast<Language>((now + 1) % kCount);
        lesson.listing = code::in_language(lesson, next).value_or(lesson.listing);
        edit("listing", std::move(lesson));
      },
      has_code);
  add(
      "Edit", "Copy the code of the listing", {},
      [&] {
        const code::Page page = code::page(code::language_of(session_.lesson().listing));
        if (copy) copy(std::string(page.text));
        say(fmt::format("copied {}, whole", page.name));
      },
      has_code);
  add("View", "Next theme", {"T"}, [this, themes] {
    const auto now = std::find(themes.begin(), themes.end(), theme_name_);
    set_theme(now == themes.end() || now + 1 == themes.end() ? themes.front() : *(now + 1));
  });

  add("Help", "Where to begin", {}, [&] { welcomes_ = true; });
  add("Help", "Keys", {"?", "F1"}, [&] { show_dialog(keys_dialog(*this)); });
  add("Help", "Any command", {"Ctrl+P", "/"}, [&] { show_dialog(palette_dialog(*this)); });
  add("Help", "Close or leave", {"Escape"}, [&] {
    if (dialog_) {
      close_dialog();
    } else if (focused_) {
      focused_.reset();
      focus_moves_ = true;
    } else if (lessons_over_) {
      lessons_over_ = false;
    } else if (asking_.has_begun()) {
      asking_.forget();
      picture_.hand().selected = {};
    } else if (is_presenting()) {
      presenter_.turn(false);
    } else {
      welcomes_ = false;
      message_.clear();
      error_.clear();
      picture_.hand().selected = {};
    }
  });
}

void App::focus_next_panel(int by) {
  std::vector<std::optional<std::string>> panels = {std::nullopt, "##top"};
  if (has_lessons()) panels.emplace_back("##lessons");
  panels.emplace_back("##transport");
  if (drawer_) panels.emplace_back("##drawer");
  const auto now = std::find(panels.begin(), panels.end(), focused_) - panels.begin();
  const auto count = std::ssize(panels);
  focused_ = panels[(now + by + count) % count];
  focus_moves_ = true;
}

bool App::press(const KeyPress& press) {
  const std::string name =
      fmt::format("{}{}{}", press.ctrl ? "Ctrl+" : "", press.shift ? "Shift+" : "", press.key);
  if (presenter_.is_black()) {
    presenter_.blacken(false);
    return true;
  }
#if IMGUI_VERSION_NUM < 18700
  // Enter presses what the keyboard points at, as Space does.
  if (name == "Enter" && panels_have_keys() && !ImGui::GetIO().WantTextInput)
    ImGui::GetIO().NavInputs[ImGuiNavInput_Activate] = 1.0f;
#endif
  // An open menu or list takes the keys, Escape, too.
  if (has_popup()) return false;
  // Under a dialog nothing moves but the dialog.
  if (dialog_ && name != "Escape") return false;
  if (panels_have_keys() && name != "Escape" && !name.ends_with("F6")) return false;
  bool has_key = false;
  for (const Command& command : commands_) {
    if (std::find(command.keys.begin(), command.keys.end(), name) == command.keys.end()) continue;
    has_key = true;
    if (!command.is_enabled()) continue;
    command.run();
    break;
  }
  return has_key;
}

const Command* App::command(std::string_view name) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(),
                                  [&](const Command& command) { return command.name == name; });
  return found == commands_.end() ? nullptr : &*found;
}

bool App::run_command(std::string_view name) {
  const Command* found = command(name);
  if (found && found->is_enabled()) found->run();
  return found != nullptr;
}

// For scripts ------------------------------------------------------------------------------------

std::string App::title() const {
  return fmt::format("{}{} - gjkscope", session_.is_unsaved() ? "* " : "", session_.lesson().title);
}

std::string App::state_json() {
  const Frame& frame = session_.frame();
  nlohmann::ordered_json json = {
      {"lesson", session_.lesson().id},
      {"frame", session_.index()},
      {"frames", session_.frame_count()},
      {"iteration", session_.text().iteration},
      {"phase", session_.text().phase},
      {"caption", session_.shown_text().caption},
      {"unsaved", session_.is_unsaved()},
      {"undo", session_.undo_name()},
      {"redo", session_.redo_name()},
      {"playing", playing_},
      {"presenting", is_presenting()},
      {"black", presenter_.is_black()},
      {"theme", theme_name_},
      {"drawer", drawer_ ? drawers_[*drawer_].name : ""},
      {"dialog", dialog_ ? dialog_->title : ""},
      {"message", message()},
      {"notices",
       [&] {
         nlohmann::ordered_json texts = nlohmann::ordered_json::array();
         for (const Notice& each : notices()) texts.push_back(each.text);
         return texts;
       }()},
      {"left", std::count_if(left_.begin(), left_.end(),
                             [](const LeftWork& each) { return !each.is_discarded; })},
      {"lessons", has_lessons()},
      {"folded", room_.folded},
      {"welcome", welcomes_},
      {"pinned", pinned_text()},
      {"exporting", is_exporting()},
      {"exported", {export_done_.load(), export_count_.load()}},
      {"recent", recent_},
      {"question", session_.question() != nullptr},
      {"asking", session_.is_asking()},
      {"asked", session_.answers().size()},
      {"right", session_.right_answers()}};
  const LessonRun& run = session_.run();
  if (const WideTrace& trace = run.run(frame).trace; !trace.is_empty())
    json["distance"] = trace.result.distance;
  const int dimension = run.lesson.dimension;
  const auto vertices = [&](const LessonShape& shape) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const Eigen::Vector3d& vertex : shape.vertices)
      out.push_back(std::vector<double>(vertex.data(), vertex.data() + dimension));
    return out;
  };
  json["x"] = vertices(session_.lesson().x());
  json["y"] = vertices(session_.lesson().y());
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace gjkscope
