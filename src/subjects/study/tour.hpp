#pragma once
// The parts of a step that frames of the tour `study` show.

#include <optional>

#include "run/run.hpp"

namespace gjkscope {

/// The stages of a study. First X and Y themselves: from afar, then their gap enlarged, with the
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
[[nodiscard]] std::optional<StudyFrame> study_frame(const LessonRun& run, const Frame& frame);

}  // namespace gjkscope
