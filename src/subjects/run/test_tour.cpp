#include <fmt/format.h>

#include <array>

#include "run/facts.hpp"
#include "run/questions.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
namespace {

constexpr AskInfo kAskTest{"test", "whether a region's test is true", "of test"};
constexpr std::array kTestAsks = {asks::kRegion, kAskTest};

void test_frames(LessonRun& run, int index) {
  const WideTrace& trace = run.runs[index].trace;
  if (trace.steps.empty()) return;
  const int tests = static_cast<int>(trace.steps[0].record.region_tests.size());
  for (int i = 0; i <= tests; ++i) run.frames.push_back({.run = index, .step = 0, .part = i});
}

int test_answer(const LessonRun& run, const Frame&, const Frame& frame,
                const LessonQuestion& question) {
  const int regions = (1 << state_before(run.run(frame).trace, frame.step).simplex.count) - 1;
  const int tried = *tried_tests(run, frame);
  if (question.ask == kAskTest.name)
    return tried > 0 && tried < regions && question.at.value_or(tried) == tried ? frame.step : -1;
  // When the last but one fails, the last region is what is left.
  const bool decides =
      tried > 0 && tried < regions &&
      (tried + 1 == regions || run.step(frame).record.region_tests[tried - 1].holds);
  return decides && question.ask == asks::kRegion.name ? frame.step : -1;
}

void test_knows(const Frame& frame, KnownFacts& facts) {
  facts.gradual = true;
  facts.tests_reached = frame.part - 1;
  facts.closest_point = facts.tests_reached >= 0 && facts.region_tests[facts.tests_reached].holds;
}

void test_question(const Story& story, FrameText& text) {
  const LessonQuestion& question = story.run.asked(story.frame);
  if (question.ask != kAskTest.name) return captions::question(story, text);
  const gjk::RegionTest<double>& test =
      story.trace.steps[story.frame.answering_step]
          .record.region_tests[*tried_tests(story.run, story.frame)];
  FrameQuestion& asked = text.question.emplace(FrameQuestion{question.ask, {"true", "false"}, {}});
  asked.answer = test.holds ? "true" : "false";
  text.caption = fmt::format("Question: next comes the test of region {}. Is it true?",
                             story.words.face(test.region));
}

Tick test_tick(const LessonRun& run, const Frame& frame) {
  const std::string group = group_of_position(run, frame, "ordered tests");
  const int tried = *tried_tests(run, frame);
  if (tried == 0) return {.group = group, .label = "weights"};
  const gjk::RegionTest<double>& test = run.step(frame).record.region_tests[tried - 1];
  const std::string face = SimplexWords(run, run.state(frame).simplex).face(test.region);
  return {.group = group, .label = "region " + face, .short_label = face, .event = test.holds};
}

}  // namespace

const Tour kTest{
    .name = "test",
    .meaning = "test of a Voronoi region, in the first closest-point phase",
    .needs = {.shown_of = ShownOf::both,
              .why_no_until = "frames go through the first region tests"},
    .add_frames = test_frames,
    .asks = kTestAsks,
    .answering_step = test_answer,
    .algorithm = &kGjkAlgorithm,
    .knows = test_knows,
    .position = position_in_lesson,
    .tick = test_tick,
    .words = captions::step,
    .stage = layers::stage_step,
    .question = test_question,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<int> tried_tests(const LessonRun& run, const Frame& frame) {
  return part_of<int>(tours::kTest, run, frame);
}

}  // namespace gjkscope
