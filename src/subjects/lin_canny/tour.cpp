#include <fmt/format.h>

#include <array>
#include <string>

#include "subjects/lin_canny/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::walks {

using models::WalkPhase;

Shown::Shown(const LessonRun& run, const Frame& frame)
    : lesson(run.lesson),
      walk(*walk_trace(run, frame.run)),
      step(last_step_over(walk.trace.steps, frame)),
      state(step == nullptr ? walk.trace.start : step->after),
      is_answer(frame.step >= static_cast<int>(walk.trace.steps.size())) {}

std::vector<Border> Shown::borders(bool of_x) const {
  const models::RingFeature& at = feature(of_x);
  const auto corner = [&](int i) { return ring(of_x).points[i]; };
  const Eigen::Vector2d a = corner(at.index);
  const int next = ring(of_x).next(at.index);
  const Eigen::Vector2d edge = corner(next) - a;
  if (at.is_vertex) {
    const int before = ring(of_x).previous(at.index);
    return {{{a, edge}, {false, at.index}}, {{a, corner(before) - a}, {false, before}}};
  }
  return {{{a, -edge}, {true, at.index}},
          {{corner(next), edge}, {true, next}},
          {{a, Eigen::Vector2d(-edge.y(), edge.x())}, at}};
}

std::vector<models::WalkState> Shown::pairs() const {
  std::vector<models::WalkState> out;
  for (const models::WalkStep& each : walk.trace.steps) {
    if (each.phase == WalkPhase::closest) out.push_back(each.after);
  }
  return out;
}

namespace {

void frames(LessonRun& run, int index) {
  add_algorithm_frames(run, index);
  constexpr int kMostPairs = 2500;  // that a grid has room for
  const TracedWalk& walk = *walk_trace(run, index);
  if (run.runs.size() > 1 || walk.trace.result.stop != models::WalkStop::closest ||
      walk.query->pairs() > kMostPairs)
    return;
  run.frames.push_back(
      {.run = index, .step = static_cast<int>(walk.trace.steps.size()), .part = 0});
}

constexpr std::array kAsks = {kAskFeature, kAskMost};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  if (question.ask == kAskMost.name) return shows_pairs(run, frame) ? frame.step : -1;
  const Shown shown(run, frame);
  if (question.ask != kAskFeature.name || !shown.is(WalkPhase::regions)) return -1;
  if (question.at && *question.at != run.info(frame).iteration) return -1;
  return shown.state.found.behind ? -1 : frame.step;
}

std::string position(const LessonRun& run, int index) {
  if (!shows_pairs(run, run.frames[index])) return position_in_algorithm(run, index);
  return fmt::format("all pairs · {} of {}", index + 1, run.frames.size());
}

Tick tick(const LessonRun& run, const Frame& frame) {
  if (shows_pairs(run, frame)) return {.group = "pairs", .label = "all", .event = true};
  return tick_of_algorithm(run, frame);
}

const Tour kTour{
    .name = "lin-canny",
    .meaning =
        "phase of the walk on the features of two polygons, then its answer and all its pairs",
    .needs = {.why_no_until = "frames show how the walk ends"},
    .add_frames = frames,
    .follows_run = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kLinCannyAlgorithm,
    .position = position,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
    .fill = fill,
    .plot_title = [](const LessonRun&) { return std::string("All pairs of features"); },
};

}  // namespace

bool shows_pairs(const LessonRun& run, const Frame& frame) {
  return frame.question < 0 && part_of<int>(kTour, run, frame).has_value();
}

}  // namespace gjkscope::walks

namespace gjkscope {

const SubjectParts subjects::lin_canny{
    .tours = {&walks::kTour},
    .blocks = {&walks::kFeatures},
    .listings = {&walks::kListing},
    .legend = {{"feature.vertex", "current feature, a vertex"},
               {"feature.edge", "current feature, an edge"},
               {"walk.region.x", "region of fx: beside the ticks"},
               {"walk.region.y", "region of fy: beside the ticks"}},
};

}  // namespace gjkscope
