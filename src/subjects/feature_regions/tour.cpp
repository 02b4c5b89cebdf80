#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "subjects/feature_regions/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::cells {
namespace {

using Phase = RegionsTrace::Phase;

/// All regions of a body are drawn, in each step of a drag.
constexpr int kMostVertices = 24;

void frames(LessonRun& run, int index) {
  const int steps = run.algorithm_traces[index]->steps();
  // Along a path the start is that of the first position.
  for (int i = index == 0 || steps == 0 ? -1 : 0; i < steps; ++i)
    run.frames.push_back({.run = index, .step = i});
}

constexpr std::array kAsks = {kAskHolding, kAskRefuting, kAskPlanes,
                              kAskAgain,   kAskReach,    kAskBefore};

/// The phase that answers a question.
Phase answering_phase(std::string_view ask) {
  if (ask == kAskRefuting.name) return Phase::region;
  if (ask == kAskReach.name) return Phase::slab;
  if (ask == kAskBefore.name) return Phase::plane;
  return Phase::query;
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  const Phase phase = answering_phase(question.ask);
  if (!shown.is(phase)) return -1;
  if (phase == Phase::slab) return shown.reaching_vertex() ? frame.step : -1;
  if (shown.trace.feature(shown.at()) < 0) return -1;
  const auto is_test = [](const RegionsTrace::Step& step) { return step.phase == Phase::region; };
  const auto first = shown.trace.all.begin();
  const auto at =
      phase == Phase::query ? frame.run + 1 : std::count_if(first, first + frame.step + 1, is_test);
  return question.at && *question.at != at ? -1 : frame.step;
}

/// At the new place, before anything is known of it.
Frame asking(const LessonRun& run, const Frame& frame) {
  return {.run = frame.run, .step = run.point_query() ? -1 : frame.step - 1};
}

std::string group(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  if (shown.step < 0) return "start";
  const RegionsTrace::Step& at = shown.at();
  constexpr std::array<std::string_view, kKinds> kNames = {"faces", "edges", "vertices"};
  if (at.phase == Phase::query) return fmt::format("Q {}", frame.run + 1);
  if (at.phase == Phase::all) return "all";
  return shown.is_query ? std::string(kNames[static_cast<std::size_t>(at.kind)])
                        : fmt::format("pair {}", at.pair + 1);
}

std::string position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  const std::string at = group(run, frame);
  return asks_later(run, index) ? at
                                : fmt::format("{} · {} of {}", at, index + 1, run.frames.size());
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  Tick out{.group = group(run, frame), .label = "start"};
  if (shown.step < 0) return out;
  const StepInfo info = shown.trace.info(shown.step);
  out.label = shown.is(Phase::kind) ? "all" : info.phase;
  out.event = info.is_event;
  return out;
}

const Tour kTour{
    .name = "feature-regions",
    .meaning =
        "kind of feature of a polyhedron: one Voronoi region, then all; then the region of Q. Of "
        "two bodies: regions and slab of two pairs of points; in space",
    .needs = {.most_vertices = kMostVertices,
              .shown_of = ShownOf::space,
              .why_no_until = "frames show all kinds"},
    .add_frames = frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .asking = asking,
    .algorithm = &kFeatureRegionsAlgorithm,
    .position = position,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
};

const EffectInfo kFeatureRegionsInfo = shown_of(
    ShownOf::space,
    effect_info<FeatureRegions>(
        "view", "in space: the Voronoi regions of features that a frame is about", kTour.name));

}  // namespace
}  // namespace gjkscope::cells

namespace gjkscope {

const SubjectParts subjects::feature_regions{
    .tours = {&cells::kTour},
    .blocks = {&cells::kRegionPlanes},
    .layers = {&cells::kBehind},
    .effects = {&cells::kFeatureRegionsInfo},
    .legend = {{"cell.face", "region of a face, cut off"},
               {"cell.edge", "region of an edge, cut off"},
               {"cell.vertex", "region of a vertex, cut off"},
               {"cell.x", "region of a feature of X, cut off"},
               {"cell.y", "region of a feature of Y, cut off"},
               {"cell.mark", "the face"},
               {"feature.edge", "the edge"},
               {"feature.vertex", "the vertex"},
               {"cell.beside", "a neighbour, whose plane bounds the region"},
               {"cell.out", "plane that the point lies beyond"},
               {"slab.plane", "plane normal to the segment xy"},
               {"slab.vertex", "vertex that reaches into the slab"},
               {"cell.other", "segment between the first pair"},
               {"closest.line", "segment between the two points"}},
};

}  // namespace gjkscope
