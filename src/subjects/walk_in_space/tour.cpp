#include <fmt/format.h>

#include <array>

#include "subjects/subjects.hpp"
#include "subjects/walk_in_space/growth.hpp"
#include "subjects/walk_in_space/shown.hpp"

namespace gjkscope::space_walks {
namespace {

void frames(LessonRun& run, int index) {
  const int steps = run.algorithm_traces[index]->steps();
  if (!run.lesson.path_of_shapes) return add_algorithm_frames(run, index);
  run.frames.push_back({.run = index, .step = steps > 0 ? steps : -1});
  if (steps == 0 || index + 1 != static_cast<int>(run.runs.size())) return;
  for (const WalkGrowing part : {WalkGrowing::beside_gjk, WalkGrowing::coherent, WalkGrowing::cold})
    run.frames.push_back({.run = index, .step = steps, .part = static_cast<int>(part)});
}

constexpr std::array kAsks = {kAskNext, kAskPairs, kAskSmallMoves, kAskFirstPair};

std::optional<WalkGrowing> growth_asked(std::string_view ask) {
  if (ask == kAskSmallMoves.name) return WalkGrowing::coherent;
  if (ask == kAskFirstPair.name) return WalkGrowing::cold;
  return std::nullopt;
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const std::optional<WalkGrowing> growing = growth_of(run, frame);
  if (const auto asked = growth_asked(question.ask); asked || growing)
    return asked == growing ? frame.step : -1;
  const Shown shown(run, frame);
  if (shown.index < 0 || shown.is_answer != shown.is_path) return -1;
  if (shown.trace.overlaps()) return -1;
  if (question.at && *question.at != (shown.is_path ? frame.run + 1 : shown.step().number))
    return -1;
  if (question.ask == kAskPairs.name) return shown.is_path ? frame.step : -1;
  // Two edges may both be left at once; and a point should be seen to lie beyond a plane.
  constexpr double kSeen = 0.05;
  const SpaceWalk::Step& step = shown.step();
  const bool is_seen = step.at[1 - step.body] == step.next[1 - step.body] &&
                       (!step.moves() || shown.trace.beyond(step) > kSeen * step.distance());
  return shown.is_path || is_seen ? frame.step : -1;
}

Frame asking(const LessonRun& run, const Frame& frame) {
  return {.run = frame.run, .step = run.lesson.path_of_shapes ? -1 : frame.step - 1};
}

std::string_view name_of(WalkGrowing growing) {
  switch (growing) {
    case WalkGrowing::beside_gjk:
      return "beside GJK";
    case WalkGrowing::coherent:
      return "with coherence";
    case WalkGrowing::cold:
      break;
  }
  return "without coherence";
}

std::string position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const Shown shown(run, frame);
  if (const auto growing = growth_of(run, frame))
    return fmt::format("{} · {} of {}", name_of(*growing), index + 1, run.frames.size());
  if (shown.is_path) return position_on_path(run, index);
  return position_in_algorithm(run, index);
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  if (growth_of(run, frame)) return {.group = "as bodies grow", .label = "all n", .event = true};
  if (shown.is_path) {
    const bool is_event = shown.trace.steps() > 0 && shown.trace.pairs() > 1;
    return {.group = "positions", .label = std::to_string(frame.run + 1), .event = is_event};
  }
  return tick_of_algorithm(run, frame);
}

const Tour kTour{
    .name = "lin-canny-in-space",
    .meaning =
        "pair of features that the walk in space looks at, then its answer; along a path for each "
        "position, then steps as bodies grow; in space",
    .needs = {.shown_of = ShownOf::space, .why_no_until = "frames show how the walk ends"},
    .add_frames = frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .asking = asking,
    .algorithm = &kWalkInSpaceAlgorithm,
    .position = position,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
    .fill = fill,
    .plot_title = [](const LessonRun&) { return std::string("Steps as bodies grow"); },
};

const EffectInfo kSpaceWalkGrowth =
    effect_info<SpaceWalkGrowth>("frame", "steps of the walk and of GJK as moving bodies grow");

}  // namespace

std::optional<WalkGrowing> growth_of(const LessonRun& run, const Frame& frame) {
  if (frame.question >= 0) return growth_asked(run.asked(frame).ask);
  return part_of<WalkGrowing>(kTour, run, frame);
}

}  // namespace gjkscope::space_walks

namespace gjkscope {

const SubjectParts subjects::walk_in_space{
    .tours = {&space_walks::kTour},
    .blocks = {&space_walks::kFeatures},
    .listings = {&space_walks::kListing},
    .layers = {&space_walks::kBehind},
    .effects = {&space_walks::kSpaceWalkGrowth},
    .legend = {{"feature.vertex", "a feature of the pair: a vertex"},
               {"feature.edge", "a feature of the pair: an edge"},
               {"cell.mark", "a feature of the pair: a face"},
               {"cell.x", "region of fx, cut off"},
               {"cell.y", "region of fy, cut off"},
               {"cell.out", "plane that the point lies beyond"},
               {"cell.beside", "the feature that is next"},
               {"closest.line", "segment between x and y"}},
};

}  // namespace gjkscope
