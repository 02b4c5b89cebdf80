#include <algorithm>
#include <array>
#include <vector>

#include "outlines/polyhedron.hpp"
#include "run/questions.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/run/voronoi.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/space/region.hpp"
#include "subjects/weights/barycentric.hpp"
#include "subjects/weights/projection.hpp"

namespace gjkscope::tours {
namespace {

void path_frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[index].trace);
  // A refused run has no step: its frame shows the start.
  run.frames.push_back({.run = index, .step = run.lesson.until ? last : std::min(0, last)});
}

Tick path_tick(const LessonRun& run, const Frame& frame) {
  const gjk::Face face = run.state(frame).region;
  if (gjk::vertex_count(face) == run.lesson.dimension + 1) return {.group = "interior"};
  return {.group = "region " + SimplexWords(run, run.state(frame).simplex).face(face)};
}

/// A lesson asks only about things that it shows.
int path_answer(const LessonRun& run, const Frame&, const Frame& frame,
                const LessonQuestion& question) {
  const WideTrace& trace = run.run(frame).trace;
  if (frame.step < 0 || trace.steps[frame.step].phase != gjk::Phase::closest ||
      !is_at(frame, question))
    return -1;
  const WideSimplex& simplex = state_before(trace, frame.step).simplex;
  const int count = simplex.count;
  const bool is_on_map = question.ask == asks::kRegion.name || question.ask == asks::kClosest.name;
  const bool has_map =
      run.lesson.calls_for(VoronoiRegions::kName) || run.lesson.calls_for(RegionSolid::kName);
  const bool in_space = run.lesson.dimension == 3;
  // A flat tetrahedron has no signs; its hull has two faces, back to back.
  const auto has_volume = [&] {
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i < count; ++i)
      corners.push_back(run.run(frame).y().world[simplex.vertices[i].pair.y]);
    return hull_in_space(corners).faces.size() == 4;
  };
  const bool shows = is_on_map  ? has_map
                     : in_space ? question.ask == asks::kSign.name && has_volume() &&
                                      run.lesson.calls_for(FacesBefore::kName)
                                : run.lesson.calls_for(BarycentricParts::kName);
  const bool is_of_line = question.ask == asks::kFoot.name || question.ask == asks::kReach.name;
  const bool is_of_area = question.ask == asks::kTurn.name || question.ask == asks::kSolution.name;
  if (!shows || count < 2 || (is_of_line && count != 2) || (is_of_area && count != 3)) return -1;
  if (question.ask == asks::kReach.name && !run.lesson.calls_for(UnitVector::kName)) return -1;
  return frame.step;
}

/// At the new place, before anything is known of it.
Frame path_asking(const LessonRun&, const Frame& frame) { return {.run = frame.run}; }

constexpr AskInfo kRegionAtPosition{asks::kRegion.name, asks::kRegion.meaning, "at position"};
constexpr std::array kPathAsks = {kRegionAtPosition, asks::kClosest, asks::kSign, asks::kFoot,
                                  asks::kWhatIf,     asks::kReach,   asks::kTurn, asks::kSolution};

}  // namespace

const Tour kPath{
    .name = "path",
    .meaning = "position of X on the path",
    .needs = {.settings = &LessonSecond::kKind,
              .settings_are_optional = true,
              .path = PathUse::needed,
              .shown_of = ShownOf::both},
    .add_frames = path_frames,
    .sweeps = true,
    .asks = kPathAsks,
    .answering_step = path_answer,
    .asking = path_asking,
    .algorithm = &kGjkAlgorithm,
    .position = position_on_path,
    .tick = path_tick,
    .words = captions::step,
    .stage = layers::stage_step,
};

}  // namespace gjkscope::tours
