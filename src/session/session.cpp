#include "session/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <tuple>
#include <utility>

#include "frames/stage.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lesson/schema.hpp"
#include "picture/words.hpp"
#include "run/questions.hpp"
#include "run/trail.hpp"
#include "session/hit.hpp"
#include "session/verdict_marks.hpp"
#include "subjects/difference/minkowski.hpp"
#include "subjects/faces_of_difference/growth.hpp"
#include "subjects/growth/growth.hpp"
#include "subjects/hill_climbing/growth.hpp"
#include "subjects/subjects.hpp"
#include "subjects/walk_in_space/growth.hpp"

namespace gjkscope {
namespace {

constexpr std::size_t kMostEntries = 500;
/// Vertices of shapes in all entries of the history together: some tens of megabytes.
constexpr std::size_t kMostRemembered = 1'000'000;

std::size_t weight(const Lesson& lesson) {
  return lesson.x().vertices.size() + lesson.y().vertices.size();
}

/// The lesson's camera that makes `seen` of it in `card`: a page may widen a lesson's camera.
Camera camera_for(const LessonRun& run, LessonView view, const Rect& card, const Camera& seen) {
  view.camera = Camera{seen.center, 1.0};
  return {seen.center, seen.height / camera_of(run, view, card).height, seen.stretch, {}};
}

CameraOverride override_of(const Camera& camera, const Rect& card) {
  return {camera, card.size().x() / card.size().y()};
}

/// The verdict of the run on an answer; null where none was given.
std::string verdict(const FrameQuestion& asked, const Answer* answer, const Numbers& numbers) {
  const std::string& right = asked.answer;
  if (answer && answer->pointed && answer->origin) {
    return fmt::format("{}: {}. Yours is turned by {}°.", answer->is_right() ? "Right" : "Not so",
                       right, numbers(answer->turned()));
  }
  if (answer && answer->pointed && answer->place) {
    return fmt::format("{}: {}. You pointed {} away.", answer->is_right() ? "Right" : "Not so",
                       right, numbers((*answer->pointed - *answer->place).norm()));
  }
  if (asked.ask == asks::kStop.name) {
    const std::string clause = right == "no" ? "GJK goes on" : "GJK stops, " + right;
    if (answer && answer->is_right()) return fmt::format("Right: {}.", clause);
    if (right == "no") return fmt::format("{}: {}.", answer ? "No" : "Answer", clause);
    if (answer && answer->chosen == "no") return fmt::format("Yes: {}.", clause);
  }
  if (!answer) return fmt::format("Answer: {}.", right);
  if (answer->is_right()) return fmt::format("Right: {}.", right);
  if (right == "no" || right == "yes") return fmt::format("Not so: the answer is {}.", right);
  return fmt::format("Not so: {}, not {}.", right, answer->chosen);
}

}  // namespace

double Answer::turned() const {
  const Eigen::Vector2d a = *pointed - *origin;
  const Eigen::Vector2d b = *place - *origin;
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return kDegrees * std::abs(std::atan2(gjk::cross(a, b), gjk::dot(a, b)));
}

std::vector<Problem> why_not_said(const Lesson& lesson, const FileReader& read) {
  return parse_lesson(lesson_toml(lesson), lesson.path.empty() ? "lesson" : lesson.path,
                      vocabulary(), read)
      .problems;
}

/// A run and its pictures, which refer to it.
struct Session::Shown {
  LessonRun run;
  EffectGraph effects;
  LessonPictures pictures;
  Shown(LessonRun the_run, const Fonts& fonts, const EffectGraph* before)
      : run(std::move(the_run)), effects(run), pictures(drawn(*this, fonts, before)) {}

 private:
  static LessonPictures drawn(Shown& shown, const Fonts& fonts, const EffectGraph* before) {
    if (before) {
      shown.effects.take_over<Growth>(*before);
      shown.effects.take_over<ClimbGrowth>(*before);
      shown.effects.take_over<FaceGrowth>(*before);
      shown.effects.take_over<SpaceWalkGrowth>(*before);
    }
    return {shown.run, shown.effects, fonts};
  }
};

Session::Session(const Fonts& fonts, FileReader read) : fonts_(fonts), read_(std::move(read)) {}
Session::~Session() = default;

std::optional<Lesson> Session::replace(Lesson lesson, CameraOverrides cameras) {
  cameras.resize(lesson.views.size());
  std::swap(lesson_, lesson);
  std::swap(cameras_, cameras);
  if (show(LabelScope::lesson)) return lesson;
  lesson_ = std::move(lesson);
  cameras_ = std::move(cameras);
  return std::nullopt;
}

bool Session::open(Lesson lesson, std::filesystem::path file, bool unsaved) {
  if (dragging_) end_drag();
  const bool is_first = !shown_;
  Whereabouts there{file_, saved_, index_};
  CameraOverrides cameras = cameras_;
  const std::optional<bool> stacked = std::exchange(stacked_, std::nullopt);
  std::optional<Lesson> before = replace(std::move(lesson), {});
  if (!before) {
    stacked_ = stacked;
    return false;
  }
  go_to(0);
  file_ = std::move(file);
  saved_ = unsaved ? nullptr : std::make_shared<const Lesson>(lesson_);
  if (!is_first)
    remember({"open " + lesson_.id, *std::move(before), std::move(there)}, std::move(cameras));
  changed();
  return true;
}

struct Session::Made {
  Lesson lesson;
  Page page;  ///< The page that its pictures are laid out on.
  LabelScope scope = LabelScope::lesson;
  long layout = 0;               ///< Session::layout_, and
  long drag = 0;                 ///< Session::drags_, when it was asked for.
  std::string problem = {};      ///< Why there are no pictures.
  std::shared_ptr<Shown> shown;  ///< Null where there is a problem.
};

std::function<std::shared_ptr<Session::Made>()> Session::maker(Lesson lesson) const {
  CameraOverrides cameras(lesson.views.size());
  return maker(std::move(lesson), std::move(cameras), std::nullopt, LabelScope::lesson, 0);
}

std::function<std::shared_ptr<Session::Made>()> Session::maker(Lesson lesson,
                                                               CameraOverrides cameras,
                                                               std::optional<bool> stacked,
                                                               LabelScope scope, int index) const {
  Lesson asked = to_run(lesson);
  Made asked_for{std::move(lesson), page_, scope, layout_, drags_, {}, nullptr};
  return [this, asked = std::move(asked), made = std::move(asked_for), cameras = std::move(cameras),
          stacked, index]() mutable {
    LessonRun run = run_lesson(asked);
    made.problem = why_not_shown(run);
    if (made.problem.empty()) {
      const int last = static_cast<int>(run.frames.size()) - 1;
      made.shown = std::make_shared<Shown>(std::move(run), fonts_, nullptr);
      made.shown->pictures.lay_out(made.page, cameras, made.scope, stacked);
      // Builds the frame's marks now; they are kept.
      (void)made.shown->pictures.picture(std::min(index, last));
    }
    return std::make_shared<Made>(std::move(made));
  };
}

std::function<std::shared_ptr<Session::Made>()> Session::work() {
  if (!wanted_ || making_) return nullptr;
  making_ = true;
  return maker(lesson_, cameras_, stacked_, *std::exchange(wanted_, std::nullopt), index_);
}

void Session::take_work(const std::shared_ptr<Made>& made) {
  making_ = false;
  if (!made) return cancel_drag();
  if (!before_drag_ || made->drag != drags_) return;
  problems_.clear();
  problem_ = made->problem;
  if (!problem_.empty()) {
    if (is_settling() && !wanted_) cancel_drag();
    problem_ = made->problem;
    return;
  }
  if (made->scope == LabelScope::frame) made->shown->pictures.explain_as(shown_->pictures);
  put(made->shown);
  stacked_ = shown_->pictures.is_stacked();
  picture_.reset();
  if (made->layout != layout_) lay_out(made->scope);
  if (!is_settling()) return keep_difference_in_sight();
  if (wanted_) return;
  before_drag_.reset();
  keep_difference_in_sight();
}

void Session::cancel_drag() {
  if (!before_drag_) return;
  const BeforeDrag before = *std::exchange(before_drag_, std::nullopt);
  dragging_ = false;
  held_.reset();
  wanted_.reset();
  cameras_ = past_.back().cameras;
  take_back_drag();
  shown_ = before.shown;
  index_ = before.index;
  stacked_ = shown_->pictures.is_stacked();
  picture_.reset();
  problems_.clear();
  problem_.clear();
  if (layout_ != before.layout) lay_out(LabelScope::lesson);
}

void Session::take_back_drag() {
  lesson_ = std::move(past_.back().lesson);
  id_ = past_.back().id;
  past_.pop_back();
  changed();
}

bool Session::open(const std::shared_ptr<Made>& made, std::filesystem::path file, bool unsaved) {
  if (dragging_) end_drag();
  problems_.clear();
  problem_ = made->problem;
  if (!problem_.empty()) return false;
  const bool is_first = !shown_;
  Whereabouts there{file_, saved_, index_};
  Lesson before = std::exchange(lesson_, std::move(made->lesson));
  CameraOverrides cameras = std::exchange(cameras_, CameraOverrides(lesson_.views.size()));
  shown_ = std::move(made->shown);
  wanted_.reset();
  before_drag_.reset();
  stacked_ = shown_->pictures.is_stacked();
  index_ = 0;
  picture_.reset();
  // The window may have changed meanwhile.
  if (shown_->run.lesson.questions != lesson_to_run().questions) {
    show(LabelScope::lesson);
  } else if (made->page != page_) {
    lay_out(LabelScope::lesson);
  }
  file_ = std::move(file);
  saved_ = unsaved ? nullptr : std::make_shared<const Lesson>(lesson_);
  if (!is_first)
    remember({"open " + lesson_.id, std::move(before), std::move(there)}, std::move(cameras));
  changed();
  return true;
}

std::vector<Session::Unsaved> Session::all_unsaved() const {
  std::vector<Unsaved> out;
  const auto add = [&](const Lesson& lesson, const Whereabouts& there) {
    if (!there.saved || lesson != *there.saved) out.push_back({lesson, there.file});
  };
  // Each other lesson as it was left, or as far as redo leads in it.
  for (const Entry& entry : past_) {
    if (entry.of_other) add(entry.lesson, *entry.of_other);
  }
  const Entry* other = nullptr;
  const Entry* last = nullptr;
  for (auto entry = future_.rbegin(); entry != future_.rend(); ++entry) {
    if (entry->of_other) {
      if (other) add(last->lesson, *other->of_other);
      other = &*entry;
    }
    last = &*entry;
  }
  if (other) add(last->lesson, *other->of_other);
  if (is_unsaved()) out.push_back({lesson_, file_});
  return out;
}

bool Session::reload(Lesson lesson) {
  if (dragging_) end_drag();
  CameraOverrides cameras = cameras_;
  std::optional<Lesson> before = replace(std::move(lesson), {});
  if (!before) return false;
  remember({"reload", *std::move(before)}, std::move(cameras));
  saved_ = std::make_shared<const Lesson>(lesson_);
  changed();
  return true;
}

void Session::mark_saved(std::filesystem::path file, Lesson lesson) {
  lesson_ = std::move(lesson);
  file_ = std::move(file);
  saved_ = std::make_shared<const Lesson>(lesson_);
  changed();
}

void Session::set_saved(std::optional<Lesson> lesson) {
  saved_ = lesson ? std::make_shared<const Lesson>(*std::move(lesson)) : nullptr;
  changed();
}

void Session::changed() {
  ++version_;
  unsaved_ = !saved_ || lesson_ != *saved_;
}

void Session::remember(Entry entry, CameraOverrides cameras) {
  future_.clear();
  entry.id = std::exchange(id_, ++last_id_);
  entry.cameras = std::move(cameras);
  past_.push_back(std::move(entry));
  std::size_t all = 0;
  for (const Entry& each : past_) all += weight(each.lesson);
  while (past_.size() > kMostEntries || (all > kMostRemembered && past_.size() > 1)) {
    all -= weight(past_.front().lesson);
    past_.erase(past_.begin());
  }
}

bool Session::edit(const std::string& name, Lesson lesson) {
  if (dragging_) end_drag();
  problems_ = why_not_said(lesson, read_);
  problem_ = to_string(problems_);
  if (!problem_.empty()) return false;
  CameraOverrides cameras = cameras_;
  hold_cameras();
  std::optional<Lesson> before = replace(std::move(lesson), cameras_);
  if (!before) return false;
  remember({name, *std::move(before)}, std::move(cameras));
  changed();
  return true;
}

bool Session::revert() { return saved_ && edit("revert", *saved_); }

void Session::begin_drag(const std::string& name, std::optional<std::size_t> held) {
  if (dragging_) end_drag();
  if (is_settling()) show(LabelScope::lesson);
  remember({name, lesson_}, cameras_);
  hold_cameras();
  problems_.clear();
  problem_.clear();
  held_ = held;
  ++drags_;
  const std::size_t vertices = std::max(lesson_.x().vertices.size(), lesson_.y().vertices.size());
  if (beside_ && vertices > limits::kVertices) before_drag_ = {shown_, index_, layout_};
  follows_.clear();
  const std::vector<LessonPictures::ShownView> seen = views();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (is_difference_in_sight(seen[i])) follows_.push_back(i);
  }
  dragging_ = true;
}

void Session::drag(const std::function<void(Lesson&)>& edit) {
  if (!dragging_) return;
  edit(lesson_);
  changed();
  if (before_drag_) {
    wanted_ = LabelScope::frame;
  } else if (show(LabelScope::frame)) {
    keep_difference_in_sight();
  }
}

void Session::end_drag() {
  if (!dragging_) return;
  dragging_ = false;
  held_.reset();
  if (before_drag_) {
    wanted_ = LabelScope::lesson;
    return;
  }
  if (problem_.empty()) {
    // The last move has run it; labels get places that suit all frames.
    lay_out(LabelScope::lesson);
    return keep_difference_in_sight();
  }
  // Dropped where no run can be shown: back to where it was.
  const std::string why = problem_;
  take_back_drag();
  show(LabelScope::lesson);
  problem_ = why;
}

bool Session::swap_with_last(std::vector<Entry>& from, std::vector<Entry>& to, Cameras cameras) {
  if (dragging_) end_drag();
  if (from.empty()) return false;
  Entry entry = std::move(from.back());
  from.pop_back();
  std::swap(lesson_, entry.lesson);
  std::swap(id_, entry.id);
  CameraOverrides then = std::exchange(entry.cameras, cameras_);
  if (cameras == Cameras::as_then) cameras_ = std::move(then);
  std::optional<int> index;
  if (entry.of_other) {
    const Whereabouts there = std::exchange(*entry.of_other, {file_, saved_, index_});
    cameras_.clear();
    stacked_.reset();
    file_ = there.file;
    saved_ = there.saved;
    index = there.index;
  }
  to.push_back(std::move(entry));
  cameras_.resize(lesson_.views.size());
  changed();
  show(LabelScope::lesson);
  if (index) go_to(*index);
  return true;
}

bool Session::undo(Cameras cameras) { return swap_with_last(past_, future_, cameras); }
bool Session::redo(Cameras cameras) { return swap_with_last(future_, past_, cameras); }

std::string Session::undo_name() const { return past_.empty() ? "" : past_.back().name; }
std::string Session::redo_name() const { return future_.empty() ? "" : future_.back().name; }

std::vector<Session::Kept> Session::kept(const std::vector<Entry>& entries) {
  std::vector<Kept> list;
  for (const Entry& entry : entries) list.push_back({entry.id, entry.name});
  return list;
}

bool Session::restore(std::vector<KeptLesson> past, KeptLesson now,
                      std::vector<KeptLesson> future) {
  if (dragging_) end_drag();
  if (!replace(std::move(now.lesson), {})) return false;
  id_ = last_id_ = now.kept.id;
  const auto entries = [&](std::vector<KeptLesson>& from) {
    std::vector<Entry> list;
    for (KeptLesson& each : from) {
      last_id_ = std::max(last_id_, each.kept.id);
      list.push_back({.name = std::move(each.kept.change),
                      .lesson = std::move(each.lesson),
                      .id = each.kept.id});
    }
    return list;
  };
  past_ = entries(past);
  future_ = entries(future);
  changed();
  return true;
}

Lesson Session::to_run(Lesson lesson) const {
  if (predicting_) {
    lesson.questions.clear();
    for (const AskInfo& ask : vocabulary().tour(lesson.tour)->asks)
      lesson.questions.push_back({std::string(ask.name), {}});
  } else if (!asking_) {
    lesson.questions.clear();
  }
  return lesson;
}

Lesson Session::lesson_as_seen() const {
  Lesson lesson = lesson_;
  const std::vector<LessonPictures::ShownView> seen = views();
  for (std::size_t i = 0; i < lesson.views.size(); ++i) {
    if (!cameras_[i]) continue;
    lesson.views[i].eye = seen[i].camera.eye;
    lesson.views[i].camera = camera_for(run(), lesson.views[i], seen[i].card, seen[i].camera);
  }
  return lesson;
}

std::string Session::why_not_shown(const LessonRun& run) {
  std::string why;
  for (const PositionedRun& positioned : run.runs) {
    if (why.empty()) why = why_not_drawn(positioned);
  }
  return why.empty() && run.frames.empty() ? "the run has no frame to show" : why;
}

bool Session::show(LabelScope scope) {
  LessonRun run = run_lesson(lesson_to_run());
  problems_.clear();
  problem_ = why_not_shown(run);
  if (!problem_.empty()) return false;
  // Nothing that was asked for before is waited for.
  wanted_.reset();
  before_drag_.reset();
  auto shown = std::make_shared<Shown>(std::move(run), fonts_, shown_ ? &shown_->effects : nullptr);
  if (shown_) shown->pictures.explain_as(shown_->pictures);
  put(std::move(shown));
  lay_out(scope);
  return true;
}

void Session::put(std::shared_ptr<Shown> shown) {
  const bool first = !shown_;
  const bool was_answer = !first && index_ == answering_index(run());
  const bool was_trail = !first && is_trail(frame());
  const Moment was = first || was_answer || was_trail ? Moment{} : moments()[index_];
  shown_ = std::move(shown);
  index_ = first        ? 0
           : was_answer ? answering_index(run())
           : was_trail  ? frame_count() - 1
                        : find(was);
}

void Session::lay_out(LabelScope scope) {
  ++layout_;
  shown_->pictures.lay_out(page_, cameras_, scope, stacked_);
  stacked_ = shown_->pictures.is_stacked();
  picture_.reset();
}

const LessonRun& Session::run() const { return shown_->run; }
int Session::frame_count() const { return static_cast<int>(shown_->run.frames.size()); }
const Frame& Session::frame() const { return shown_->run.frames[index_]; }
EffectGraph& Session::effects() { return shown_->effects; }

std::vector<Session::Moment> Session::moments() const {
  const std::span<const std::string_view> phases = run().tour->algorithm->phases;
  std::map<std::tuple<int, int, int>, int> steps;  // of a phase in an iteration, so far
  std::vector<Moment> list;
  for (const Frame& frame : run().frames) {
    const StepInfo info = run().info(frame);
    const auto phase = std::find(phases.begin(), phases.end(), info.phase);
    Moment& now = list.emplace_back(Moment{frame.run, info.iteration, -1, frame.part});
    if (info.phase != "start") now.phase = static_cast<int>(phase - phases.begin());
    // Another run comes there in another number of steps.
    if (run().tour->algorithm != &kGjkAlgorithm)
      now.part = steps[{now.run, now.iteration, now.phase}]++;
  }
  return list;
}

int Session::find(const Moment& wanted) const {
  // The same moment, or the last one before it.
  const auto key = [](const Moment& m) { return std::tie(m.run, m.iteration, m.phase, m.part); };
  const std::vector<Moment> all = moments();
  int best = 0;
  for (int i = 1; i < frame_count(); ++i) {
    const Moment& moment = all[i];
    if (run().frames[i].question >= 0) continue;
    if (key(moment) <= key(wanted) && key(moment) >= key(all[best])) best = i;
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
    const Frame& frame = run().frames[i];
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
    const Frame& frame = run().frames[i];
    if (frame.question >= 0 || run().info(frame).phase != phase) continue;
    go_to(i > index_ ? std::min(i, last_open()) : i);
    return true;
  }
  return false;
}

std::optional<int> Session::next(Event event) const {
  if (event != Event::run_ends && run().tour->algorithm != &kGjkAlgorithm) return std::nullopt;
  const std::vector<Frame>& frames = run().frames;
  const WideSimplex& now = run().state(frame()).simplex;
  const auto is_another = [&](const WideSimplex& later) {
    return later.count != now.count ||
           std::any_of(later.vertices.begin(), later.vertices.begin() + later.count,
                       [&](const auto& vertex) { return !has_pair(now, vertex.pair); });
  };
  const auto shows = [&](const Frame& later, const Frame* after) {
    switch (event) {
      case Event::simplex_changes:
        return is_another(run().state(later).simplex);
      case Event::vertex_dropped:
        return later.step >= 0 && !run().step(later).record.dropped.empty();
      case Event::run_ends:
        return !is_trail(later) &&
               (after == nullptr || after->run != later.run || is_trail(*after));
    }
    return false;
  };
  for (std::size_t i = static_cast<std::size_t>(index_) + 1; i < frames.size(); ++i) {
    const Frame* const after = i + 1 < frames.size() ? &frames[i + 1] : nullptr;
    if (frames[i].question < 0 && shows(frames[i], after)) return static_cast<int>(i);
  }
  return std::nullopt;
}

bool Session::run_until(Event event) {
  const std::optional<int> to = next(event);
  if (to) go_to(*to);
  return to.has_value();
}

void Session::set_predicting(bool on) {
  if (on == predicting_) return;
  predicting_ = on;
  show(LabelScope::lesson);
  if (!on) return;
  const std::vector<Frame>& frames = run().frames;
  int first = index_;
  while (first > 0 && frames[static_cast<std::size_t>(first) - 1].question >= 0) --first;
  go_to(first);
}

void Session::set_asking(bool on) {
  if (on == asking_) return;
  asking_ = on;
  if (!predicting_ && !lesson_.questions.empty()) show(LabelScope::lesson);
}

const FrameQuestion* Session::question() const {
  const std::optional<FrameQuestion>& question = text().question;
  return question && !given(index_) ? &*question : nullptr;
}

void Session::answer(const std::string& choice, const std::optional<Eigen::Vector2d>& pointed) {
  if (take(choice, pointed)) step(1);
}

void Session::grade(const std::string& choice, const std::optional<Eigen::Vector2d>& pointed) {
  if (!take(choice, pointed)) return;
  const auto next = static_cast<std::size_t>(index_) + 1;
  picture_.reset();
  if (next < texts().size() && !texts()[next].question) step(1);
}

bool Session::take(const std::string& choice, const std::optional<Eigen::Vector2d>& pointed) {
  const FrameQuestion* asked = question();
  if (!asked) return false;
  answers_.push_back({lesson_.id, text().iteration, asked->ask, asked->choices, choice,
                      asked->answer, version_, frame().run, frame().answering_step, pointed,
                      asked->place, asked->origin});
  return true;
}

const Answer* Session::given(int index) const {
  const auto at = static_cast<std::size_t>(index);
  if (!texts()[at].question) return nullptr;
  const Frame& frame = run().frames[at];
  const auto found = std::find_if(answers_.begin(), answers_.end(), [&](const Answer& answer) {
    return answer.version == version_ && answer.run == frame.run &&
           answer.step == frame.answering_step && answer.ask == texts()[at].question->ask;
  });
  return found == answers_.end() ? nullptr : &*found;
}

int Session::first_shown() const {
  int first = index_;
  if (text().question) return first;
  while (first > 0 && texts()[static_cast<std::size_t>(first) - 1].question) --first;
  return first;
}

FrameText Session::shown_text() const {
  FrameText text = this->text();
  const bool asks = text.question.has_value();
  const int first = first_shown();
  std::string verdicts;
  int count = 0;
  bool all_right = true;
  for (int i = first; i < index_ + (asks ? 1 : 0); ++i) {
    const Answer* answer = given(i);
    if (answer) ++count;
    if (answer && !answer->is_right()) all_right = false;
    verdicts += verdict(*texts()[i].question, answer, Numbers(lesson_)) + " ";
  }
  if (count == 0) return text;
  const std::string& reason = texts()[first].question->reason;
  text.is_right = all_right;
  if (asks) {
    verdicts.pop_back();
    text.caption = verdicts;
    text.detail = reason;
  } else {
    text.caption = verdicts + reason;
  }
  return text;
}

int Session::last_open() const {
  int at = index_;
  while (at + 1 < frame_count() && !(texts()[at].question && !given(at))) ++at;
  return at;
}

void Session::forget_answers() {
  answers_.clear();
  picture_.reset();
}

std::pair<int, int> Session::score() const {
  std::pair<int, int> out = {0, 0};
  for (const Answer& answer : answers_) {
    if (answer.lesson != lesson_.id) continue;
    out.first += answer.is_right() ? 1 : 0;
    ++out.second;
  }
  return out;
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
  stacked_.reset();
  if (shown_) lay_out(dragging_ || is_settling() ? LabelScope::frame : LabelScope::lesson);
}

const Picture& Session::picture() {
  if (picture_) return *picture_;
  picture_ = shown_->pictures.picture(index_, shown_text(), pointed_);
  for (int i = first_shown(); i <= index_; ++i) {
    const Answer* answer = given(i);
    if (answer != nullptr) {
      add_verdict(*picture_, run(), views(), *texts()[i].question, *answer);
    }
  }
  return *picture_;
}

void Session::point_at(const std::vector<Subject>& vertices) {
  std::vector<Subject> pointed;
  for (const Subject& vertex : vertices) {
    const bool is_difference = vertex.kind == Subject::Kind::difference_vertex;
    if (is_difference || is_vertex(vertex)) pointed.push_back(vertex);
    if (!is_difference) continue;
    pointed.push_back(vertex_of(0, vertex.x));
    pointed.push_back(vertex_of(1, vertex.y));
  }
  if (pointed == pointed_) return;
  pointed_ = std::move(pointed);
  picture_.reset();
}

Subject Session::vertex_near(const Point& page, double reach) {
  Subject nearest;
  if (is_trail(frame())) return nearest;
  double least = reach;
  const PositionedRun& shapes = run().run(frame());
  const auto seen = views();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!shows_shapes(seen[i].kind) || !is_in(seen[i].card, page)) continue;
    const StageMap map(seen[i].card, seen[i].camera);
    const auto consider = [&](const auto& at, const Subject& subject) {
      const double away = (map(at) - page).norm();
      if (away > least) return;
      least = away;
      nearest = subject;
    };
    if (seen[i].kind == ViewKind::world) {
      for (const std::size_t body : {0, 1}) {
        const auto& world = shapes.bodies[body].world;
        for (std::size_t k = 0; k < world.size(); ++k)
          consider(world[k], vertex_of(body, static_cast<int>(k)));
      }
    } else if (lesson_.views[i].calls_for(MinkowskiHull::kName)) {
      for (const auto& [z, pair] : effects().get<MinkowskiHull>(frame()))
        consider(z, {Subject::Kind::difference_vertex, pair.x, pair.y});
    }
  }
  return nearest;
}

const FrameText& Session::text() const { return texts()[index_]; }

const std::vector<FrameText>& Session::texts() const { return shown_->pictures.texts(); }

std::vector<LessonPictures::ShownView> Session::views() const { return shown_->pictures.views(); }

void Session::set_camera(std::size_t view, const Camera& camera) {
  if (!shows_shapes(lesson_.views[view].kind) || is_trail(frame())) return;
  cameras_[view] = override_of(camera, views()[view].card);
  lay_out(LabelScope::frame);
}

void Session::set_eye(const Eye& eye) {
  const std::vector<LessonPictures::ShownView> seen = views();
  bool is_other = false;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    Camera camera = seen[i].camera;
    if (!camera.eye) continue;
    camera.eye = Eye{std::remainder(eye.azimuth, 360.0),
                     std::clamp(eye.elevation, -limits::kUpright, limits::kUpright)};
    is_other = is_other || camera.eye != seen[i].camera.eye;
    cameras_[i] = override_of(camera, seen[i].card);
  }
  if (is_other) lay_out(LabelScope::frame);
}

std::optional<Eye> Session::eye() const {
  for (const LessonPictures::ShownView& view : views()) {
    if (view.camera.eye) return view.camera.eye;
  }
  return std::nullopt;
}

void Session::hold_cameras() {
  if (!shown_) return;
  const std::vector<LessonPictures::ShownView> seen = views();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (shows_shapes(seen[i].kind) && !cameras_[i] && !lesson_.views[i].camera)
      cameras_[i] = override_of(seen[i].camera, seen[i].card);
  }
}

void Session::fit() {
  if (!shown_) return;
  stacked_.reset();
  const std::vector<LessonPictures::ShownView> seen = views();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    // A view without a camera of its own fits what it shows, on whatever card.
    cameras_[i].reset();
    if (shows_shapes(seen[i].kind) && lesson_.views[i].camera) fit(i, seen[i].card);
  }
  lay_out(LabelScope::lesson);
}

void Session::fit(std::size_t view, const Rect& card) {
  LessonView free = lesson_.views[view];
  free.camera.reset();
  free.eye = views()[view].camera.eye;
  cameras_[view] = override_of(camera_of(run(), free, card), card);
}

bool Session::is_difference_in_sight(const LessonPictures::ShownView& view) const {
  if (view.kind != ViewKind::difference) return false;
  const PositionedRun& shapes = run().run(frame());
  Eigen::AlignedBox2d x;
  Eigen::AlignedBox2d y;
  const auto seen = [&](const Eigen::Vector3d& vertex) -> Eigen::Vector2d {
    if (!view.camera.eye) return in_plane(vertex);
    return axes_of(*view.camera.eye).topRows<2>() * vertex;
  };
  for (const Eigen::Vector3d& vertex : shapes.x().world) x.extend(seen(vertex));
  for (const Eigen::Vector3d& vertex : shapes.y().world) y.extend(seen(vertex));
  const Eigen::Vector2d half =
      0.5 * view.camera.units_per_pixel(view.card.size().y()).cwiseProduct(view.card.size());
  const Eigen::Vector2d center = seen(view.camera.center);
  const Eigen::AlignedBox2d in_view(center - half, center + half);
  return in_view.contains(Eigen::AlignedBox2d(y.min() - x.max(), y.max() - x.min()));
}

void Session::keep_difference_in_sight() {
  const std::vector<LessonPictures::ShownView> seen = views();
  bool moved = false;
  for (const std::size_t i : follows_) {
    if (i == held_ || is_difference_in_sight(seen[i])) continue;
    fit(i, seen[i].card);
    moved = true;
  }
  if (moved) lay_out(dragging_ ? LabelScope::frame : LabelScope::lesson);
}

}  // namespace gjkscope
