#include "picture/caption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "effects/second_run.hpp"
#include "effects/shape_hull.hpp"
#include "effects/slab.hpp"
#include "effects/touched_points.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "picture/captions/story.hpp"
#include "picture/study_words.hpp"

namespace gjkscope {
namespace {

/// A lesson that shows the slab is told by what each phase proves.
bool tells_slab(const Story& story) {
  const bool proves = story.knows.phase_is(gjk::Phase::closest) ||
                      story.knows.phase_is(gjk::Phase::support) ||
                      (story.knows.phase_is(gjk::Phase::stop) && story.knows.support);
  return proves && story.shows(Slab::kName);
}

void write(const Story& story, FrameText& text) {
  if (story.frame.question >= 0) return captions::question(story, text);
  const Granularity granularity = story.run.lesson.granularity;
  if (granularity == Granularity::pairs) return captions::pairs(story, text);
  if (story.frame.step < 0) return captions::start(story, text);
  if (granularity == Granularity::time) return captions::balance(story, text);
  if (granularity == Granularity::maps) return captions::maps(story, text);
  if (granularity == Granularity::orders) return captions::orders(story, text);
  if (granularity == Granularity::growth && story.frame.detail >= 0)
    return captions::growth(story, text);
  if (granularity == Granularity::study) return captions::study(story, text);
  if (granularity == Granularity::answer) return captions::answer(story, text);
  if (story.frame.detail >= 0) {
    if (granularity == Granularity::support) return captions::support_in_parts(story, text);
    if (granularity == Granularity::witness) return captions::witness(story, text);
  }
  if (tells_slab(story)) return captions::slab(story, text);
  switch (story.run.step(story.frame).phase) {
    case gjk::Phase::closest:
      return story.run.lesson.granularity == Granularity::test ? captions::region_test(story, text)
                                                               : captions::closest(story, text);
    case gjk::Phase::cull:
      return captions::cull(story, text);
    case gjk::Phase::direction:
      return captions::direction(story, text);
    case gjk::Phase::support:
      return captions::support(story, text);
    case gjk::Phase::stop:
      captions::stop(story, text);
      if (story.knows.has_ended && story.shows(TouchedPoints::kName))
        captions::touched_points(story, text);
      return;
    case gjk::Phase::add:
      return captions::add(story, text);
  }
}

/// The values a lesson's prose can name and the sidecar file lists, in reading order.
std::vector<std::pair<std::string, std::string>> values_of(const Story& story) {
  std::vector<std::pair<std::string, std::string>> out;
  const auto put = [&](std::string name, std::string value) {
    out.emplace_back(std::move(name), std::move(value));
  };
  if (story.run.lesson.granularity == Granularity::study) {
    put("x", story.run.lesson.x.name);
    put("y", story.run.lesson.y.name);
    for (const StudyDot& dot :
         introduced(*story.run.lesson.study, story.run.study(story.frame).marks)) {
      put(dot.configuration, fmt::format("{}, error {}", time_text(dot.ns), error_words(dot)));
    }
    return out;
  }
  const gjk::Result<double, 2>& result = story.trace.result;
  const bool running = story.frame.step >= 0;
  put("x", story.run.lesson.x.name);
  put("y", story.run.lesson.y.name);
  put("iteration", std::to_string(running ? story.run.step(story.frame).iteration : 0));
  put("iterations", std::to_string(result.iterations));
  put("simplex", story.words.face(story.state.simplex.all()));
  if (story.run.point_query()) put("Q", story.numbers.point(story.positioned.x_world[0]));
  if (story.knows.closest_point) {
    put("region", story.words.face(story.state.region));
    constexpr std::array<std::string_view, 3> kLetters = {"u", "v", "w"};
    for (int i = 0; i < story.state.simplex.count; ++i)
      put(std::string(kLetters[i]), story.numbers.weight(story.state.simplex.weights[i]));
    put("P", story.numbers.point(story.p_world()));
    put("distance", story.numbers(std::sqrt(story.state.p_sq)));
  }
  if (story.knows.direction) put("d", story.numbers.point(story.state.d));
  if (story.knows.support) put("support", story.run.pair_name(story.state.support.pair));
  if (running) {
    put("lower", story.numbers(story.run.bounds(story.frame).lower));
    put("upper", story.numbers(story.run.bounds(story.frame).upper));
  }
  if (story.knows.phase_is(gjk::Phase::stop) && story.knows.has_ended) {
    put("stop", std::string(name_of(story.state.stop)));
  }
  return out;
}

}  // namespace

FrameText frame_text(const LessonRun& run, EffectGraph& effects, const Frame& frame) {
  FrameText text;
  const Story story(run, effects, frame);
  write(story, text);
  if (frame.step >= 0 && frame.question < 0) {
    if (run.lesson.has_block(PanelBlock::direction_rules)) captions::direction_rules(story, text);
    if (story.shows(SecondRun::kName)) captions::second_run(story, text);
    if (story.shows(ShapeHull::kName)) captions::shape_hull(story, text);
  }
  text.values = values_of(story);
  text.phase = frame.step < 0 ? "start" : std::string(name_of(run.step(frame).phase));
  text.iteration = frame.step < 0 ? 0 : run.step(frame).iteration;
  if (frame.question >= 0) {
    text.phase = "question";
    text.iteration = run.run(frame).trace.steps[frame.answer].iteration;
  }
  text.prose = expand(run.lesson.prose,
                      std::map<std::string, std::string>(text.values.begin(), text.values.end()));
  return text;
}

}  // namespace gjkscope
