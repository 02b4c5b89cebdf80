#include "lesson/questions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lesson/load.hpp"
#include "lesson/names.hpp"

namespace gjkscope {
namespace {

/// More than one answer could be given to somebody who sees only what came before.
bool is_open(const LessonRun& run, const WideTrace& trace, Ask ask, int step) {
  switch (ask) {
    case Ask::support:
      return run.lesson.x.vertices.size() * run.lesson.y.vertices.size() > 1;
    case Ask::region:
    case Ask::dropped:
      return state_before(trace, step).simplex.count > 1;
    case Ask::stop:
    case Ask::overlap:
    case Ask::time:
      return true;
  }
  return false;
}

/// True when a frame of granularity `study` answers.
bool answers(const StudyFrame& frame, const LessonQuestion& question) {
  if (question.ask == Ask::overlap) return frame.stage == StudyStage::gap;
  return question.ask == Ask::time && frame.stage == StudyStage::mark &&
         (!question.at || *question.at == frame.marks);
}

/// Index of the step that `frame` shows and the frame before it did not, and that answers; -1 where
/// there is none.
int answering_step(const LessonRun& run, const Frame& before, const Frame& frame,
                   const LessonQuestion& question) {
  if (before.run != frame.run) return -1;
  const WideTrace& trace = run.run(frame).trace;
  if (run.lesson.granularity == Granularity::study)
    return answers(run.study(frame), question) ? frame.step : -1;
  if (run.lesson.granularity == Granularity::test) {
    const int regions = (1 << state_before(trace, frame.step).simplex.count) - 1;
    const bool decides = frame.detail >= 0 && frame.detail + 1 < regions &&
                         run.step(frame).record.region_tests[frame.detail].holds;
    return decides && question.ask == Ask::region ? frame.step : -1;
  }
  for (int i = before.step + 1; i <= frame.step; ++i) {
    const bool is_asked =
        tells(trace, i, question.ask) && (!question.at || *question.at == trace.steps[i].iteration);
    if (is_asked && is_open(run, trace, question.ask, i)) return i;
  }
  return -1;
}

}  // namespace

bool tells(const WideTrace& trace, int step, Ask ask) {
  const auto is = [&](std::size_t i, gjk::Phase phase) {
    return i < trace.steps.size() && trace.steps[i].phase == phase;
  };
  const auto at = static_cast<std::size_t>(step);
  switch (ask) {
    case Ask::support:
      return is(at, gjk::Phase::support);
    case Ask::region:
      return is(at, gjk::Phase::closest);
    case Ask::dropped:
      return is(at, gjk::Phase::closest) && is(at + 1, gjk::Phase::cull);
    case Ask::stop:
      return is(at + 1, gjk::Phase::stop);
    case Ask::overlap:
    case Ask::time:
      return false;
  }
  return false;
}

const gjk::State<double, 2>& state_before(const WideTrace& trace, int step) {
  return step == 0 ? trace.initial : trace.steps[step - 1].after;
}

void add_question_frames(LessonRun& run) {
  const std::vector<LessonQuestion>& questions = run.lesson.questions;
  if (questions.empty()) return;
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    for (int q = 0; i > 0 && q < static_cast<int>(questions.size()); ++q) {
      const int answer = answering_step(run, run.frames[i - 1], run.frames[i], questions[q]);
      if (answer < 0) continue;
      frames.push_back(run.frames[i - 1]);
      frames.back().question = q;
      frames.back().answer = answer;
    }
    frames.push_back(run.frames[i]);
  }
  run.frames = std::move(frames);
}

std::vector<Problem> unasked_questions(const LessonRun& run) {
  std::vector<Problem> problems;
  const Lesson& lesson = run.lesson;
  for (int q = 0; q < static_cast<int>(lesson.questions.size()); ++q) {
    const bool is_asked = std::any_of(run.frames.begin(), run.frames.end(),
                                      [&](const Frame& frame) { return frame.question == q; });
    if (is_asked) continue;
    const LessonQuestion& question = lesson.questions[q];
    const Place place = place_of(lesson.path, fmt::format("questions.{}.ask", q));
    const char* counted = is_about_study(question.ask) ? "about mark" : "in iteration";
    problems.push_back(
        {lesson.path, place.line, place.column,
         fmt::format("no frame asks '{}'{}", name_of(question.ask),
                     question.at ? fmt::format(" {} {}", counted, *question.at) : std::string()),
         "a question that a frame answers, out of more than one answer", ""});
  }
  return problems;
}

}  // namespace gjkscope
