#include <fmt/format.h>

#include <array>

#include "subjects/faces_of_difference/growth.hpp"
#include "subjects/faces_of_difference/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::zfaces {
namespace {

using sums_in_space::Kind;
using Phase = FacesTrace::Phase;

/// Each pair of edges is looked at, in each step of a drag.
constexpr int kMostVertices = 100;

void frames(LessonRun& run, int index) {
  add_algorithm_frames(run, index);
  const int steps = run.algorithm_traces[index]->steps();
  if (steps == 0 || index + 1 != static_cast<int>(run.runs.size())) return;
  for (const Growing part : {Growing::faces, Growing::depth, Growing::general})
    run.frames.push_back({.run = index, .step = steps, .part = static_cast<int>(part)});
}

constexpr std::array kAsks = {kAskSource, kAskMover, kAskFaces, kAskDepthPoints, kAskCorners};

std::optional<Growing> growth_asked(std::string_view ask) {
  if (ask == kAskFaces.name) return Growing::faces;
  if (ask == kAskDepthPoints.name) return Growing::depth;
  if (ask == kAskCorners.name) return Growing::general;
  return std::nullopt;
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const std::optional<Growing> growing = growth_of(run, frame);
  if (const auto asked = growth_asked(question.ask); asked || growing)
    return asked == growing ? frame.step : -1;
  const Shown shown(run, frame);
  if (shown.is_answer || shown.step < 0 || shown.face() == nullptr) return -1;
  const Kind kind = shown.at().kind;
  if (question.at && *question.at != static_cast<int>(kind) + 1) return -1;
  const bool is_asked = question.ask == kAskSource.name ? kind != Kind::of_several
                                                        : kind == Kind::of_y || kind == Kind::of_x;
  return is_asked ? frame.step : -1;
}

std::string name_of(const LessonRun& run, Kind kind) {
  switch (kind) {
    case Kind::of_y:
      return fmt::format("faces of {}", run.lesson.y().name);
    case Kind::of_x:
      return fmt::format("faces of −{}", run.lesson.x().name);
    case Kind::of_edges:
      return "pairs of edges";
    case Kind::of_several:
      break;
  }
  return "of several";
}

std::string_view name_of(Growing growing) {
  switch (growing) {
    case Growing::faces:
      return "faces, as bodies grow";
    case Growing::depth:
      return "depth, as bodies grow";
    case Growing::general:
      break;
  }
  return "bodies that are not convex";
}

std::string position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const Shown shown(run, frame);
  if (shown.step < 0) return "start";
  const std::string of = fmt::format("{} of {}", index + 1, run.frames.size());
  if (const auto growing = growth_of(run, frame))
    return fmt::format("{} · {}", name_of(*growing), of);
  if (shown.is_answer) return fmt::format("answer · {}", of);
  const std::string what =
      shown.at().phase == Phase::all ? "all faces" : name_of(run, shown.at().kind);
  if (run.runs.size() > 1) return fmt::format("{} · {}", position_on_path(run, index), what);
  return asks_later(run, index) ? what : fmt::format("{} · {}", what, of);
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  if (shown.step < 0) return {.group = group_of_position(run, frame, "start"), .label = "start"};
  if (growth_of(run, frame)) return {.group = "as bodies grow", .label = "all n", .event = true};
  if (shown.is_answer)
    return {.group = group_of_position(run, frame, "answer"), .label = "GJK", .event = true};
  const Phase phase = shown.at().phase;
  return {.group = group_of_position(run, frame,
                                     phase == Phase::all ? "all" : name_of(run, shown.at().kind)),
          .label = phase == Phase::one ? "one" : "all",
          .event = phase == Phase::all};
}

const Tour kTour{
    .name = "faces-of-the-difference",
    .meaning =
        "kind of face of the Minkowski difference: one of it, then all; then counts as bodies "
        "grow; "
        "in space",
    .needs = {.most_vertices = kMostVertices,
              .shown_of = ShownOf::space,
              .why_no_until = "frames show all kinds"},
    .add_frames = frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kFacesOfDifferenceAlgorithm,
    .position = position,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
    .fill = fill,
    .plot_title = [](const LessonRun&) { return std::string("Faces of Z as bodies grow"); },
};

}  // namespace

std::optional<Growing> growth_of(const LessonRun& run, const Frame& frame) {
  if (frame.question >= 0) return growth_asked(run.asked(frame).ask);
  return part_of<Growing>(kTour, run, frame);
}

}  // namespace gjkscope::zfaces

namespace gjkscope {

namespace {

const EffectInfo kFaceGrowth =
    effect_info<FaceGrowth>("frame", "faces of Z and support points asked for as bodies grow");

}  // namespace

const SubjectParts subjects::faces_of_difference{
    .tours = {&zfaces::kTour},
    .blocks = {&zfaces::kFaceKinds},
    .effects = {&kFaceGrowth},
    .legend = {{"zface.asked", "the marked face"},
               {"zface.y", "from a face of Y"},
               {"zface.x", "from a face of X"},
               {"zface.behind", "a face behind the body"},
               {"zface.edges", "from an edge of each"},
               {"cloud.touched", "corner of the marked face"},
               {"from.x", "edge of X"},
               {"from.y", "edge of Y"},
               {"support.vertex", "a support point"}},
};

}  // namespace gjkscope
