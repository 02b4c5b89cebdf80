#include <array>

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
  const Eigen::Vector2d way = corner(next) - a;
  if (at.is_vertex) {
    const int before = ring(of_x).previous(at.index);
    return {{{a, way}, {false, at.index}}, {{a, corner(before) - a}, {false, before}}};
  }
  return {{{a, -way}, {true, at.index}},
          {{corner(next), way}, {true, next}},
          {{a, Eigen::Vector2d(-way.y(), way.x())}, at}};
}

namespace {

constexpr std::array kAsks = {kAskFeature};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  if (question.ask != kAskFeature.name || !shown.is(WalkPhase::regions)) return -1;
  if (question.at && *question.at != run.info(frame).iteration) return -1;
  return shown.state.found.behind ? -1 : frame.step;
}

const Act kAct{
    .name = "lin-canny",
    .meaning = "phase of the walk on the features of two polygons, then its answer",
    .needs = {.why_no_until = "frames show how the walk ends"},
    .add_frames = add_algorithm_frames,
    .follows_run = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kLinCannyAlgorithm,
    .position = position_in_algorithm,
    .tick = tick_of_algorithm,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
};

}  // namespace
}  // namespace gjkscope::walks

namespace gjkscope {

const SubjectParts subjects::lin_canny{
    .acts = {&walks::kAct},
    .blocks = {&walks::kFeatures},
    .listings = {&walks::kListing},
    .legend = {{"feature.vertex", "current feature, a vertex"},
               {"feature.edge", "current feature, an edge"},
               {"walk.region.x", "region of fx: beside the ticks"},
               {"walk.region.y", "region of fy: beside the ticks"}},
};

}  // namespace gjkscope
