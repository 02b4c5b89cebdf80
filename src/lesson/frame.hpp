#pragma once
// What one frame of a lesson shows: a run, a step of it, and, where frames take a step apart, how
// much of it.

#include <optional>
#include <string_view>

namespace gjkscope {

/// Parts of one support step: d, the support point of Y along d, that of X along -d, their
/// difference.
enum class SupportPart { direction, of_y, of_x, of_z };

/// Parts of one answer: P and its weights, the same weights on the vertices of Y, on those of X,
/// and the distance between what they give.
enum class WitnessPart { p, on_y, on_x, distance };

/// Maps of a triangle's plane.
enum class MapStage {
  voronoi,
  interior,
  negative_u,
  negative_v,
  negative_w,
  signs,
  blended,
  difference
};

/// A triangle's numbers, then one chain of region tests each. Short tests leave out that an edge's
/// own coordinates must be positive.
enum class OrderStage { numbers, vertices_first_short, edges_first_short, edges_first_whole };

/// How a Minkowski difference is built: the first difference, a copy of Y for each vertex of X, −X,
/// and −X at each vertex of Y; the hull, where its edges come from; any difference, the shortest.
enum class BuildPart { start, pair, copy, mirror, slide, hull, edges, any, shortest };
struct BuildFrame {
  BuildPart part = BuildPart::start;
  int made = 0;  ///< So many differences, those of the first vertex of X before those of the next.
};

/// What a study shows. First X and Y themselves: from afar, then their gap enlarged, with the
/// answer of a run in float, and of one in double, and what an error is. Then a plot: its axis of
/// errors with two marks, its axis of times, the other marks one by one. At last the front of these
/// marks, that of all dots, and what to take.
enum class StudyStage {
  shapes,
  gap,
  in_float,
  in_double,
  error,
  error_axis,
  time_axis,
  mark,
  front,
  all,
  choice
};
struct StudyFrame {
  StudyStage stage = StudyStage::shapes;
  int marks = 0;  ///< The first so many marks of the lesson have been introduced.
};

/// Where in its algorithm a step is.
struct StepInfo {
  int iteration = 0;       ///< From 1; 0 before the first.
  std::string_view phase;  ///< "support"; "start" before the first.
  bool is_event = false;   ///< A vertex dropped, containment, the end.
};

struct Frame {
  int run = 0;    ///< Index into LessonRun::runs.
  int step = -1;  ///< Index into the trace's steps; -1: the start, before the first phase.

  // Where frames take a step apart one of these says what of it is shown.
  std::optional<int> tests = {};  ///< Region tests tried so far; 0: their numbers.
  std::optional<BuildFrame> build = {};
  std::optional<SupportPart> support_part = {};
  std::optional<WitnessPart> witness_part = {};
  std::optional<int> moment = {};  ///< Index into the moments of the position.
  std::optional<MapStage> map = {};
  std::optional<OrderStage> order = {};
  std::optional<int> size =
      {};  ///< Index into LessonGrowth::vertices; as many as there are: all sizes.
  std::optional<StudyFrame> study = {};
  std::optional<int> steps_over = {};  ///< Of an algorithm that is not GJK; one more than there
                                       ///< are: the answer.

  int question = -1;        ///< Index into Lesson::questions: this frame asks it, over what the
                            ///< frame before it shows; the next frame that asks nothing answers.
  int answering_step = -1;  ///< Of a frame that asks: index of the step that answers, among those
                            ///< of the algorithm that the act shows.

  /// Which of the frames of its step this is, from 0; -1 where a step has one frame.
  [[nodiscard]] int part() const {
    if (tests) return *tests;
    if (build) return 100 * static_cast<int>(build->part) + build->made;
    if (support_part) return static_cast<int>(*support_part);
    if (witness_part) return static_cast<int>(*witness_part);
    if (moment) return *moment;
    if (map) return static_cast<int>(*map);
    if (order) return static_cast<int>(*order);
    if (size) return *size;
    if (steps_over) return *steps_over;
    if (study) return 100 * static_cast<int>(study->stage) + study->marks;
    return -1;
  }
};

}  // namespace gjkscope
