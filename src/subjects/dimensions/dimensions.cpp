// GJK on a line, in the plane and in space: the same loop, with one more point of S each.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "run/questions.hpp"
#include "subjects/dimensions/runs.hpp"
#include "subjects/dimensions/subject.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/second_run/second_run.hpp"

namespace gjkscope {

FlatRuns::Value FlatRuns::compute(EffectGraph& graph, const LessonRun& run, const Frame&) {
  const PositionedRun& positioned = run.runs.front();
  Eigen::AlignedBox3d box;
  for (const Body& body : positioned.bodies) {
    for (const Eigen::Vector3d& vertex : body.world) box.extend(vertex);
  }
  const Eigen::Vector3d middle = box.center();
  Value out;
  for (int m = 1; m < run.lesson.dimension; ++m) {
    Lesson flat = run.lesson;
    flat.tour = tours::kPhase.name;
    flat.questions.clear();
    for (std::size_t body = 0; body < flat.bodies.size(); ++body) {
      LessonShape& shape = flat.bodies[body];
      shape.translate.setZero();
      shape.rotate_degrees = 0.0;
      shape.vertices = positioned.bodies[body].world;
      for (Eigen::Vector3d& vertex : shape.vertices)
        vertex.segment(m, run.lesson.dimension - m) = middle.segment(m, run.lesson.dimension - m);
    }
    out.emplace_back(std::move(flat), tours::kPhase, graph);
  }
  return out;
}

}  // namespace gjkscope

namespace gjkscope::dimensions {
namespace {

using gjk::Phase;

constexpr std::array<std::string_view, 3> kPlaces = {"on the line", "in the plane", "in space"};

std::string place_of(std::size_t which) { return std::string(kPlaces[which]); }

/// The lesson's runs, of the fewest dimensions first.
std::vector<const PositionedRun*> all_runs(const LessonRun& run, const FlatRuns::Value& flat) {
  std::vector<const PositionedRun*> out;
  for (const LesserRun& each : flat) out.push_back(&each.run->runs.front());
  out.push_back(&run.runs.front());
  return out;
}

/// The step of a run that goes with a frame of the lesson's: the same phase of the same iteration,
/// or the last before it.
int step_with(const WideTrace& trace, const LessonRun& run, const Frame& frame) {
  if (frame.step < 0) return -1;
  const int last = static_cast<int>(trace.steps.size()) - 1;
  if (frame.step + 1 == static_cast<int>(run.runs.front().trace.steps.size())) return last;
  const WideStep& shown = run.step(frame);
  return index_up_to(trace, shown.iteration, shown.phase);
}

const WideState& state_at(const WideTrace& trace, int step) {
  return state_before(trace, step + 1);
}

/// The most points that S has had up to a step.
int most_points(const WideTrace& trace, int step) {
  int most = trace.initial.simplex.count;
  for (int i = 0; i <= step; ++i) most = std::max(most, state_at(trace, i).simplex.count);
  return most;
}

bool has_ended(const WideTrace& trace, int step) {
  return step + 1 == static_cast<int>(trace.steps.size());
}

bool is_shown(const LessonRun& run, int, int step) {
  const WideTrace& trace = run.runs.front().trace;
  const Phase phase = trace.steps[step].phase;
  return phase == Phase::closest || phase == Phase::support || has_ended(trace, step);
}

void frames(LessonRun& run, int index) { add_step_frames(run, index, is_shown); }

FrameInView in_view(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                    std::size_t view) {
  const FlatRuns::Value& flat = effects.get<FlatRuns>(frame);
  FrameInView out = in_view_of(flat, run, effects, frame, view);
  if (view < flat.size())
    out.frame = {.step = step_with(flat[view].run->runs.front().trace, run, frame)};
  return out;
}

// ---- the question ----

constexpr AskInfo kAskMost{"most-points", "how many points S has at most, in each dimension"};
constexpr std::array kAsks = {asks::kRegion, asks::kDropped, asks::kSupport, kAskMost};

int answering_step(const LessonRun& run, const Frame& before, const Frame& frame,
                   const LessonQuestion& question) {
  if (question.ask != kAskMost.name) return answering_step_of_run(run, before, frame, question);
  return frame.step >= 0 && has_ended(run.run(frame).trace, frame.step) ? frame.step : -1;
}

void question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  if (ask != kAskMost.name) return captions::question(story, text);
  const bool in_space = story.run.lesson.dimension == 3;
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  asked.choices = in_space ? std::vector<std::string>{"1, 2 and 3", "2, 3 and 4", "4 in each"}
                           : std::vector<std::string>{"1 and 2", "2 and 3", "3 in each"};
  asked.answer = asked.choices[1];
  text.caption = fmt::format("Question: how many points can S have at most {}, {}?",
                             in_space ? "on a line, in a plane" : "on a line",
                             in_space ? "and in space" : "and in a plane");
}

// ---- the words ----

/// "1 on the line, 2 in the plane and 3 in space", of those that count.
template <class Value>
std::string listed(const std::vector<const PositionedRun*>& runs, const Value& value,
                   const std::vector<bool>& counts = {}) {
  std::vector<std::string> each;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (counts.empty() || counts[i])
      each.push_back(fmt::format("{} {}", value(*runs[i]), place_of(i)));
  }
  return and_list(std::move(each));
}

void words(const Story& story, FrameText& text) {
  const LessonRun& run = story.run;
  const std::vector<const PositionedRun*> runs =
      all_runs(run, story.effects.get<FlatRuns>(story.frame));
  const auto at = [&](const PositionedRun& each) {
    return step_with(each.trace, run, story.frame);
  };
  std::vector<std::string> ended;
  std::vector<bool> goes_on;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    goes_on.push_back(!has_ended(runs[i]->trace, at(*runs[i])));
    if (!goes_on.back()) ended.push_back(place_of(i));
  }
  if (ended.size() == runs.size()) {
    text.caption = fmt::format(
        "All runs have ended. The most points that S had: {}.",
        listed(runs, [&](const PositionedRun& each) { return most_points(each.trace, at(each)); }));
    text.detail =
        "In m dimensions m + 1 are enough: P always lies in a simplex of so many vertices.";
    return;
  }
  const std::string over =
      ended.empty()       ? ""
      : ended.size() == 1 ? fmt::format(" The run {} has ended.", ended.front())
                          : fmt::format(" The runs {} have ended.", and_list(std::move(ended)));
  if (story.knows.phase_is(Phase::support)) {
    const auto support = [&](const PositionedRun& each) {
      return run.pair_name(state_at(each.trace, at(each)).support.pair);
    };
    text.caption = fmt::format("V is {}.", listed(runs, support, goes_on));
    text.detail = fmt::format("It joins S where it lies farther along d than P.{}", over);
    return;
  }
  text.caption =
      fmt::format("Points of S that P needs: {}.", listed(runs, [&](const PositionedRun& each) {
                    return gjk::vertex_count(state_at(each.trace, at(each)).region);
                  }));
  const bool drops = std::any_of(runs.begin(), runs.end(), [&](const PositionedRun* each) {
    const WideState& state = state_at(each->trace, at(*each));
    return gjk::vertex_count(state.region) < state.simplex.count;
  });
  text.detail = fmt::format(
      "{}The most that S has had: {}.{}", drops ? "The others are dropped. " : "",
      listed(runs, [&](const PositionedRun& each) { return most_points(each.trace, at(each)); }),
      over);
}

void start(const Story& story, FrameText& text) {
  const bool in_space = story.run.lesson.dimension == 3;
  text.caption = in_space ? "The same loop runs on a line, in a plane and in space."
                          : "The same loop runs on a line and in the plane.";
  text.detail = fmt::format("{}: the shapes of the last view, pressed flat.",
                            in_space ? "On the line and in the plane" : "On the line");
}

// ---- the panel ----

void dimensions(PanelBuilder& panel) {
  const std::vector<const PositionedRun*> runs =
      all_runs(panel.run, panel.effects.get<FlatRuns>(panel.frame));
  const double width = panel.right - panel.left;
  const auto column = [&](int i) { return panel.right - width * 0.25 * (2 - i); };
  panel.write("heading", panel.left, "Points of S", type::kHeading);
  for (const auto& [i, title] :
       {std::pair(0, "now"), std::pair(1, "most so far"), std::pair(2, "distance")})
    panel.write("heading", column(i), title, type::kHeading, Align::right);
  panel.y += rows::kRow;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const WideTrace& trace = runs[i]->trace;
    const int step = step_with(trace, panel.run, panel.frame);
    const WideState& state = state_at(trace, step);
    const bool ended = has_ended(trace, step);
    panel.write("strong", panel.left, fmt::format("{}  {}", i + 1, place_of(i)), type::kBody);
    panel.write("code", column(0), std::to_string(state.simplex.count), type::kCode, Align::right);
    const bool is_asked = panel.frame.question >= 0;  // it would tell
    panel.write("code", column(1), is_asked ? "–" : std::to_string(most_points(trace, step)),
                type::kCode, Align::right);
    panel.write(ended ? "code.current" : "code", column(2),
                step < 0 ? "–" : panel.numbers(std::sqrt(state.p_sq)), type::kCode, Align::right);
    panel.y += rows::kRow;
  }
}

}  // namespace

const Tour kTour{
    .name = "dimensions",
    .meaning =
        "closest point and support point of runs on a line, in a plane and in space, one "
        "view each",
    .needs = {.path = PathUse::refused, .shown_of = ShownOf::both},
    .add_frames = frames,
    .follows_run = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kGjkAlgorithm,
    .position = position_in_run,
    .tick = tick_of_step,
    .start = start,
    .words = words,
    .stage = layers::stage_step,
    .question = question,
    .in_view = in_view,
};

const Block kBlock{.name = "dimensions",
                   .meaning = "points of S and distance on a line, in a plane and in space",
                   .write = dimensions,
                   .tour = kTour.name,
                   .shown_of = ShownOf::both};

const EffectInfo kEffect = shown_of(
    ShownOf::both, effect_info<FlatRuns>(
                       "frame", "runs of the shapes pressed onto a line and a plane", kTour.name));

}  // namespace gjkscope::dimensions
