#pragma once
// The content of one frame of a lesson: a run, a step of it, and a part of the step when frames
// take a step apart.

#include <string_view>

namespace gjkscope {

/// The place of a step in its algorithm.
struct StepInfo {
  int iteration = 0;       ///< From 1; 0 before the first.
  std::string_view phase;  ///< "support"; "start" before the first.
  bool is_event = false;   ///< A vertex dropped, containment, the end.
};

struct Frame {
  int run = 0;  ///< Index into LessonRun::runs.
  /// Index into the steps of the algorithm that the tour shows; -1: the start, before the first
  /// phase; one more than the last: the answer.
  int step = -1;

  /// The part of its step, for tours that take steps apart, from 0 in their order; -1: all of it.
  /// The tour alone knows its meaning (part_of in picture/tour.hpp), but for kTrail
  /// (run/trail.hpp).
  int part = -1;

  int question = -1;        ///< Index into Lesson::questions: this frame asks it, over what the
                            ///< frame before it shows; the next frame that asks nothing answers.
  int answering_step = -1;  ///< For a frame that asks: index of the step that answers, among those
                            ///< of the algorithm that the tour shows.
};

}  // namespace gjkscope
