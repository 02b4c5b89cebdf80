#pragma once
// Questions of a lesson: which steps of a run answer them, and the frames that ask.

#include "lesson/run.hpp"

namespace gjkscope {

/// The phase whose step answers.
[[nodiscard]] gjk::Phase phase_of(Ask ask);

/// The state before a step.
[[nodiscard]] const gjk::State<double, 2>& state_before(const WideTrace& trace, int step);

/// Puts before each frame that answers a question of the lesson the frame that asks it. What has
/// only one answer is not asked: of what region of a single vertex, say, Q lies in.
void add_question_frames(LessonRun& run);

/// Questions that no frame asks; places are those in the lesson's file.
[[nodiscard]] std::vector<Problem> unasked_questions(const LessonRun& run);

}  // namespace gjkscope
