#include "picture/caption.hpp"

#include <map>

#include "effects/second_run.hpp"
#include "effects/shape_hull.hpp"
#include "lesson/prose.hpp"
#include "picture/registry.hpp"

namespace gjkscope {

FrameText frame_text(const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  FrameText text;
  const Story story(run, effects, frame);
  const StagedAct& act = staged(run);
  const StepInfo info = run.info(frame);
  text.phase = info.phase;
  text.iteration = info.iteration;
  if (frame.question >= 0) {
    act.question(story, text);
    if (text.detail.empty()) text.detail = listed_choices(text.question->choices);
    text.phase = "question";
    text.iteration = run.answering_iteration(frame);
  } else if (frame.step < 0 && !frame.steps_over) {
    act.start(story, text);
  } else {
    act.words(story, text);
    if (run.lesson.has_block(blocks::kDirectionRules.name)) captions::direction_rules(story, text);
    if (story.shows(SecondRun::kName)) captions::second_run(story, text);
    captions::round_shapes(story, text);
    if (run.act->follows_run && story.shows(ShapeHull::kName)) captions::shape_hull(story, text);
  }
  act.values(story, text);
  text.prose = expand(run.lesson.prose,
                      std::map<std::string, std::string>(text.values.begin(), text.values.end()));
  return text;
}

}  // namespace gjkscope
