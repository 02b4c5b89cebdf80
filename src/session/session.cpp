#include "session/session.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "effects/growth.hpp"
#include "picture/registry.hpp"
#include "picture/stage.hpp"

namespace gjkscope {
namespace {

constexpr std::size_t kMostEntries = 500;
/// Vertices in all entries of the history together: some tens of megabytes.
constexpr std::size_t kMostRemembered = 1'000'000;

std::size_t weight(const Lesson& lesson) {
  std::size_t vertices = lesson.x.vertices.size() + lesson.y.vertices.size();
  if (lesson.study) {
    for (const StudyDot& dot : lesson.study->dots) vertices += dot.x.size() + dot.y.size();
  }
  return vertices;
}

/// The lesson's camera that makes `seen` of it in `card`: a page may widen a lesson's camera.
Camera camera_for(const LessonRun& run, LessonView view, const Rect& card, const Camera& seen) {
  view.camera = Camera{seen.center, 1.0};
  return {seen.center, seen.height / camera_of(run, view, card).height};
}

}  // namespace

/// A run and its pictures, which refer to it.
struct Session::Shown {
  LessonRun run;
  EffectGraph effects;
  LessonPictures pictures;
  Shown(LessonRun the_run, const Fonts& fonts, const Page& page, LabelScope scope,
        const EffectGraph* before)
      : run(std::move(the_run)), effects(run), pictures(drawn(*this, fonts, page, scope, before)) {}

 private:
  static LessonPictures drawn(Shown& shown, const Fonts& fonts, const Page& page, LabelScope scope,
                              const EffectGraph* before) {
    if (before) shown.effects.take_over<Growth>(*before);
    return {shown.run, shown.effects, fonts, page, scope};
  }
};

Session::Session(const Fonts& fonts) : fonts_(fonts) {}
Session::~Session() = default;

bool Session::replace(Lesson lesson) {
  Lesson before = std::exchange(lesson_, std::move(lesson));
  std::vector<std::optional<Camera>> cameras = std::exchange(
      cameras_, std::vector<std::optional<Camera>>(lesson_.views.size(), std::nullopt));
  if (show(false)) return true;
  lesson_ = std::move(before);
  cameras_ = std::move(cameras);
  return false;
}

bool Session::open(Lesson lesson, std::filesystem::path file, bool unsaved) {
  if (dragging_) end_drag();
  std::optional<Entry> before;
  if (shown_) before = {"open " + lesson.id, lesson_, {{file_, is_unsaved(), index_}}};
  if (!replace(std::move(lesson))) return false;
  go_to(0);
  file_ = std::move(file);
  if (before) remember(*std::move(before));
  changed();
  saved_version_ = unsaved ? -1 : version_;
  return true;
}

std::vector<Session::Unsaved> Session::all_unsaved() const {
  std::vector<Unsaved> out;
  for (const std::vector<Entry>* entries : {&past_, &future_}) {
    for (const Entry& entry : *entries) {
      if (entry.of_other && entry.of_other->unsaved)
        out.push_back({entry.lesson, entry.of_other->file});
    }
  }
  if (is_unsaved()) out.push_back({lesson_, file_});
  return out;
}

bool Session::reload(Lesson lesson) {
  if (dragging_) end_drag();
  Lesson before = lesson_;
  if (!replace(std::move(lesson))) return false;
  remember({"reload", std::move(before)});
  changed();
  saved_version_ = version_;
  return true;
}

void Session::mark_saved(std::filesystem::path file) {
  file_ = std::move(file);
  saved_version_ = version_;
}

void Session::changed() {
  ++version_;
  future_.clear();
}

void Session::remember(Entry entry) {
  past_.push_back(std::move(entry));
  std::size_t all = 0;
  for (const Entry& each : past_) all += weight(each.lesson);
  while (past_.size() > kMostEntries || (all > kMostRemembered && past_.size() > 1)) {
    all -= weight(past_.front().lesson);
    past_.erase(past_.begin());
  }
}

bool Session::change(const std::string& name, const std::function<void(Lesson&)>& edit) {
  if (dragging_) end_drag();
  hold_cameras();
  remember({name, lesson_});
  const std::vector<std::optional<Camera>> cameras = cameras_;
  edit(lesson_);
  cameras_.resize(lesson_.views.size());
  if (show(false)) {
    changed();
    return true;
  }
  lesson_ = std::move(past_.back().lesson);
  past_.pop_back();
  cameras_ = cameras;
  return false;
}

void Session::begin_drag(const std::string& name) {
  if (dragging_) end_drag();
  hold_cameras();
  remember({name, lesson_});
  changed();
  dragging_ = true;
}

void Session::drag(const std::function<void(Lesson&)>& edit) {
  if (!dragging_) return;
  edit(lesson_);
  ++version_;
  show(true);
}

void Session::end_drag() {
  if (!dragging_) return;
  dragging_ = false;
  if (show(false)) return;
  // Dropped where no run can be shown: back to where it was.
  const std::string why = problem_;
  lesson_ = std::move(past_.back().lesson);
  past_.pop_back();
  show(false);
  problem_ = why;
}

bool Session::swap_with_last(std::vector<Entry>& from, std::vector<Entry>& to) {
  if (dragging_) end_drag();
  if (from.empty()) return false;
  Entry entry = std::move(from.back());
  from.pop_back();
  std::swap(lesson_, entry.lesson);
  std::optional<Whereabouts> there;
  if (entry.of_other) {
    there = std::exchange(*entry.of_other, {file_, is_unsaved(), index_});
    cameras_.clear();
    file_ = there->file;
  }
  to.push_back(std::move(entry));
  cameras_.resize(lesson_.views.size());
  ++version_;
  show(false);
  if (there) {
    go_to(there->index);
    saved_version_ = there->unsaved ? -1 : version_;
  }
  return true;
}

bool Session::undo() { return swap_with_last(past_, future_); }
bool Session::redo() { return swap_with_last(future_, past_); }

std::string Session::undo_name() const { return past_.empty() ? "" : past_.back().name; }
std::string Session::redo_name() const { return future_.empty() ? "" : future_.back().name; }

Lesson Session::lesson_to_run() const {
  Lesson lesson = lesson_as_seen();
  if (predicting_) {
    lesson.questions = {{Ask::region, {}}, {Ask::dropped, {}}, {Ask::support, {}}, {Ask::stop, {}}};
  } else {
    lesson.questions.clear();
  }
  return lesson;
}

Lesson Session::lesson_as_seen() const {
  Lesson lesson = lesson_;
  for (std::size_t i = 0; i < lesson.views.size(); ++i) {
    if (cameras_[i]) lesson.views[i].camera = cameras_[i];
  }
  return lesson;
}

bool Session::show(bool quick) {
  const Place was = shown_ ? place() : Place{};
  LessonRun run = run_lesson(lesson_to_run());
  problem_.clear();
  for (const PositionedRun& positioned : run.runs) {
    if (problem_.empty()) problem_ = why_not_drawn(positioned);
  }
  if (problem_.empty() && run.frames.empty()) problem_ = "the run has no frame to show";
  if (!problem_.empty()) return false;
  const bool first = !shown_;
  auto shown = std::make_unique<Shown>(std::move(run), fonts_, page_,
                                       quick ? LabelScope::frame : LabelScope::lesson,
                                       first ? nullptr : &shown_->effects);
  shown_ = std::move(shown);
  index_ = first ? 0 : find(was);
  picture_.reset();
  return true;
}

const LessonRun& Session::run() const { return shown_->run; }
int Session::frame_count() const { return static_cast<int>(shown_->run.frames.size()); }
const Frame& Session::frame() const { return shown_->run.frames[static_cast<std::size_t>(index_)]; }
EffectGraph& Session::effects() { return shown_->effects; }

Session::Place Session::place() const {
  const Frame& now = frame();
  Place place{now.run, 0, -1, now.part()};
  if (now.step >= 0) {
    const gjk::Step<double, 2>& step = run().step(now);
    place.iteration = step.iteration;
    place.phase = static_cast<int>(step.phase);
  }
  return place;
}

int Session::find(const Place& wanted) const {
  // The same place, or the last one before it.
  int best = 0;
  std::array<int, 4> best_key = {-1, -1, -2, -2};
  const std::array<int, 4> wanted_key = {wanted.run, wanted.iteration, wanted.phase, wanted.part};
  for (int i = 0; i < frame_count(); ++i) {
    const Frame& frame = run().frames[static_cast<std::size_t>(i)];
    if (frame.question >= 0) continue;
    std::array<int, 4> key = {frame.run, 0, -1, frame.part()};
    if (frame.step >= 0) {
      const gjk::Step<double, 2>& step = run().step(frame);
      key[1] = step.iteration;
      key[2] = static_cast<int>(step.phase);
    }
    if (key <= wanted_key && key >= best_key) {
      best = i;
      best_key = key;
    }
  }
  return best;
}

void Session::go_to(int index) {
  const int to = std::clamp(index, 0, frame_count() - 1);
  if (to == index_) return;
  index_ = to;
  picture_.reset();
}

bool Session::step(int by) {
  const int before = index_;
  go_to(index_ + by);
  return index_ != before;
}

bool Session::step_iteration(int by) {
  const auto group = [&](int i) {
    const Frame& frame = run().frames[static_cast<std::size_t>(i)];
    return std::pair(frame.run, run().info(frame).iteration);
  };
  int to = index_;
  if (by > 0) {
    while (to + 1 < frame_count() && group(to) == group(index_)) ++to;
  } else {
    if (to > 0) --to;
    while (to > 0 && group(to - 1) == group(to)) --to;
  }
  const bool moved = to != index_;
  go_to(to);
  return moved;
}

bool Session::go_to_next(std::string_view phase) {
  for (int k = 1; k <= frame_count(); ++k) {
    const int i = (index_ + k) % frame_count();
    const Frame& frame = run().frames[static_cast<std::size_t>(i)];
    if (frame.question >= 0 || run().info(frame).phase != phase) continue;
    go_to(i);
    return true;
  }
  return false;
}

void Session::set_predicting(bool on) {
  if (on == predicting_) return;
  predicting_ = on;
  show(false);
}

const FrameQuestion* Session::question() const {
  const std::optional<FrameQuestion>& question = text().question;
  return predicting_ && question ? &*question : nullptr;
}

void Session::answer(const std::string& choice) {
  const FrameQuestion* asked = question();
  if (!asked) return;
  answers_.push_back(
      {lesson_.id, text().iteration, asked->ask, asked->choices, choice, asked->answer});
  step(1);
}

int Session::right_answers() const {
  return static_cast<int>(std::count_if(answers_.begin(), answers_.end(),
                                        [](const Answer& answer) { return answer.is_right(); }));
}

std::string Session::answers_json() const {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Answer& answer : answers_) {
    all.push_back({{"lesson", answer.lesson},
                   {"iteration", answer.iteration},
                   {"ask", answer.ask},
                   {"choices", answer.choices},
                   {"chosen", answer.chosen},
                   {"answer", answer.right},
                   {"right", answer.is_right()}});
  }
  const nlohmann::ordered_json log = {
      {"asked", answers_.size()}, {"right", right_answers()}, {"answers", std::move(all)}};
  return log.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void Session::set_page(const Page& page) {
  if (page == page_) return;
  page_ = page;
  if (shown_) show(dragging_);
}

const Picture& Session::picture() {
  if (!picture_) picture_ = shown_->pictures.picture(index_);
  return *picture_;
}

const FrameText& Session::text() const {
  return shown_->pictures.texts()[static_cast<std::size_t>(index_)];
}

std::vector<LessonPictures::Stage> Session::stages() const { return shown_->pictures.stages(); }

void Session::set_camera(std::size_t view, const Camera& camera) {
  if (!shows_shapes(lesson_.views[view].kind)) return;
  cameras_[view] = camera_for(run(), lesson_.views[view], stages()[view].card, camera);
  show(true);
}

void Session::hold_cameras() {
  if (!shown_) return;
  const std::vector<LessonPictures::Stage> seen = stages();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (shows_shapes(seen[i].kind) && !cameras_[i] && !lesson_.views[i].camera)
      cameras_[i] = camera_for(run(), lesson_.views[i], seen[i].card, seen[i].camera);
  }
}

void Session::fit() {
  if (!shown_) return;
  const std::vector<LessonPictures::Stage> seen = stages();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!shows_shapes(seen[i].kind)) continue;
    LessonView free = lesson_.views[i];
    free.camera.reset();
    cameras_[i] = camera_for(run(), free, seen[i].card, camera_of(run(), free, seen[i].card));
  }
  show(false);
}

}  // namespace gjkscope
