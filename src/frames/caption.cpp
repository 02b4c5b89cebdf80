#include "frames/caption.hpp"

#include <map>

#include "frames/spots.hpp"
#include "lesson/prose.hpp"
#include "run/trail.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/run/trail_words.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {

FrameText frame_text(const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  FrameText text;
  const Story story(run, effects, frame);
  const Tour& tour = *run.tour;
  const StepInfo info = run.info(frame);
  text.phase = info.phase;
  text.iteration = info.iteration;
  if (frame.question >= 0) {
    (tour.question ? tour.question : captions::question)(story, text);
    if (text.question->spots.empty())
      text.question->spots = spots_of(run, frame, text.question->choices);
    if (text.detail.empty()) text.detail = listed_choices(text.question->choices);
    text.phase = "question";
    text.iteration = run.answering_iteration(frame);
  } else if (frame.step < 0 && tour.algorithm == &kGjkAlgorithm) {
    (tour.start ? tour.start : captions::start)(story, text);
  } else if (is_trail(frame)) {
    captions::trail(story, text);
  } else {
    tour.words(story, text);
    for (const SubjectParts* subject : all_subjects()) {
      if (subject->adds != nullptr) subject->adds(story, text);
    }
  }
  (tour.values ? tour.values : captions::run_values)(story, text);
  text.prose = expand(run.lesson.prose,
                      std::map<std::string, std::string>(text.values.begin(), text.values.end()));
  return text;
}

}  // namespace gjkscope
