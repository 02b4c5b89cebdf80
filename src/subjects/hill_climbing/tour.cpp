#include <fmt/format.h>

#include <array>

#include "subjects/hill_climbing/growth.hpp"
#include "subjects/hill_climbing/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::climbs {
namespace {

/// If there are more steps, only the ends of walks have a frame.
constexpr int kMostSteps = 60;

void frames(LessonRun& run, int index) {
  const AlgorithmTrace& trace = *run.algorithm_traces[index];
  const int steps = trace.steps();
  run.frames.push_back({.run = index});
  if (steps == 0) return;
  for (int i = 0; i < steps; ++i) {
    if (steps <= kMostSteps || trace.info(i).is_event)
      run.frames.push_back({.run = index, .step = i});
  }
  run.frames.push_back({.run = index, .step = steps});
  if (index + 1 < static_cast<int>(run.runs.size())) return;
  for (const After part : {After::growth, After::needs})
    run.frames.push_back({.run = index, .step = steps, .part = static_cast<int>(part)});
}

constexpr std::array kAsks = {kAskClimb};

/// As far as a reader can see, one neighbour alone lies farthest.
bool is_open(const Shown& shown) {
  constexpr double kSeen = 1e-3;  // of the way along d
  const climbing::Look& look = shown.look();
  if (look.next < 0 || shown.neighbours().size() < 2) return false;
  const double now = shown.product(look.at);
  const double best = shown.product(look.next);
  return std::none_of(shown.neighbours().begin(), shown.neighbours().end(), [&](int each) {
    return each != look.next && shown.product(each) > best - kSeen * (best - now);
  });
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  if (shown.is_answer || shown.step < 0) return -1;
  if (question.at && *question.at != frame.step + 1) return -1;
  return is_open(shown) ? frame.step : -1;
}

std::string position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const Shown shown(run, frame);
  if (after_of(run, frame)) return fmt::format("outcome · {} of {}", index + 1, run.frames.size());
  if (shown.step < 0) return "start";
  if (shown.is_answer) return fmt::format("answer · {} of {}", index + 1, run.frames.size());
  const int walk = shown.trace.all[shown.step].climb + 1;
  const std::string at = fmt::format("at {}", shown.name(shown.look().at));
  if (run.runs.size() > 1) return fmt::format("{} · {}", position_on_path(run, index), at);
  return asks_later(run, index)
             ? fmt::format("walk {} · {}", walk, at)
             : fmt::format("walk {} of {} · {}", walk, shown.trace.climbs.size(), at);
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  if (const std::optional<After> after = after_of(run, frame))
    return {
        .group = "outcome", .label = *after == After::growth ? "all n" : "needs", .event = true};
  if (shown.step < 0) return {.group = group_of_position(run, frame, "start"), .label = "start"};
  if (shown.is_answer)
    return {.group = group_of_position(run, frame, "answer"),
            .label = "answer",
            .short_label = "end",
            .event = true};
  const int walk = shown.trace.all[shown.step].climb + 1;
  const bool stops = shown.look().next < 0;
  const std::string& at = shown.name(shown.look().at);
  return {.group = group_of_position(run, frame, fmt::format("walk {}", walk)),
          .label = stops ? fmt::format("{}: stop", at) : at,
          .short_label = at,
          .event = stops};
}

const Tour kTour{
    .name = "hill-climbing",
    .meaning =
        "vertex of the walks to all support points of a run, then counts of walks and scans as "
        "polyhedra grow; in space",
    .needs = {.shown_of = ShownOf::space, .why_no_until = "frames show all walks"},
    .add_frames = frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kHillClimbingAlgorithm,
    .position = position,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
    .fill = fill,
    .plot_title = [](const LessonRun&) { return std::string("Dot products of a support point"); },
};

}  // namespace

std::optional<After> after_of(const LessonRun& run, const Frame& frame) {
  return part_of<After>(kTour, run, frame);
}

}  // namespace gjkscope::climbs

namespace gjkscope {

namespace {

const EffectInfo kClimbGrowth =
    effect_info<ClimbGrowth>("frame", "dot products of walks and scans as polyhedra grow");

}  // namespace

const SubjectParts subjects::hill_climbing{
    .tours = {&climbs::kTour},
    .blocks = {&climbs::kClimb},
    .listings = {&climbs::kListing},
    .effects = {&kClimbGrowth},
    .legend = {{"path.now", "current vertex v"},
               {"climb.edge", "edge to a neighbour"},
               {"climb.move", "to the next vertex"},
               {"climb.path", "the walk so far"},
               {"path.point", "a vertex of the walk"},
               {"support.plane", "plane through v, normal to d"},
               {"support.vertex", "support point"}},
};

}  // namespace gjkscope
