#pragma once
// Questions of a lesson: which steps of a run answer them, and the frames that ask.

#include "lesson/run.hpp"

namespace gjkscope {

/// True for a step that tells what is asked for. P tells which vertices will be dropped, and what
/// leads to the stop tests whether they will hold: a question asked later would hold its answer.
[[nodiscard]] bool tells(const WideTrace& trace, int step, Ask ask);

/// The state before a step.
[[nodiscard]] const gjk::State<double, 2>& state_before(const WideTrace& trace, int step);

/// More than one answer could be given to somebody who sees only what came before `step`.
[[nodiscard]] bool is_open(const LessonRun& run, const WideTrace& trace, Ask ask, int step);

/// Puts before each frame that answers a question of the lesson the frame that asks it. What has
/// only one answer is not asked: of what region of a single vertex, say, Q lies in.
void add_question_frames(LessonRun& run);

/// Questions that no frame asks; places are those in the lesson's file.
[[nodiscard]] std::vector<Problem> unasked_questions(const LessonRun& run);

}  // namespace gjkscope
