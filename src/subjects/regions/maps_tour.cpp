#include <fmt/format.h>

#include <array>

#include "run/facts.hpp"
#include "run/questions.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/regions/tour.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
namespace {

void maps_frames(LessonRun& run, int index) {
  using enum MapStage;
  if (run.runs[index].trace.steps.empty()) return;
  for (const MapStage stage :
       {voronoi, interior, negative_u, negative_v, negative_w, signs, blended, difference}) {
    // The maps are the same wherever X stands.
    if (index == 0 || stage == difference)
      run.frames.push_back({.run = index, .step = 0, .part = static_cast<int>(stage)});
  }
}

Tick maps_tick(const LessonRun& run, const Frame& frame) {
  constexpr std::array<std::string_view, 8> kLabels = {
      "Voronoi", "interior", "u < 0", "v < 0", "w < 0", "signs", "both", "difference"};
  return {.group = frame.run == 0 ? "maps" : group_of_position(run, frame, ""),
          .label = std::string(kLabels[static_cast<std::size_t>(*map_stage(run, frame))])};
}

constexpr AskInfo kAskNegative{"negative", "where u is negative"};
constexpr std::array kMapsAsks = {
    kAskNegative, AskInfo{asks::kRegion.name, asks::kRegion.meaning, "at position"}};

int maps_answer(const LessonRun& run, const Frame&, const Frame& frame,
                const LessonQuestion& question) {
  const MapStage stage =
      question.ask == kAskNegative.name ? MapStage::negative_u : MapStage::difference;
  return is_at(frame, question) && map_stage(run, frame) == stage ? frame.step : -1;
}

Frame maps_asking(const LessonRun&, const Frame& frame) {
  const bool is_first = frame.part == static_cast<int>(MapStage::negative_u);
  return {.run = frame.run,
          .step = frame.step,
          .part = static_cast<int>(is_first ? MapStage::interior : MapStage::asked)};
}

void maps_knows(const Frame& frame, KnownFacts& facts) {
  if (frame.part == static_cast<int>(MapStage::asked)) facts.closest_point = false;
}

void maps_question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  if (ask != kAskNegative.name) return captions::question(story, text);
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  for (const gjk::Face edge : {0b110, 0b101, 0b011})
    asked.choices.push_back(story.words.face(edge));
  asked.answer = asked.choices.front();
  text.caption = fmt::format("Question: u, the weight of {}, is negative beyond one edge: which?",
                             story.words.vertex(0));
}

}  // namespace

const Tour kMaps{
    .name = "maps",
    .meaning =
        "map of the plane around a triangle: Voronoi regions, signs of u, v, w, both, and "
        "where they disagree; the last one for further positions of X",
    .needs = {.start = 3, .why_no_until = "frames go through the first region tests"},
    .add_frames = maps_frames,
    .asks = kMapsAsks,
    .answering_step = maps_answer,
    .asking = maps_asking,
    .algorithm = &kGjkAlgorithm,
    .knows = maps_knows,
    .position = position_in_lesson,
    .tick = maps_tick,
    .words = captions::maps,
    .stage = layers::stage_step,
    .question = maps_question,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<MapStage> map_stage(const LessonRun& run, const Frame& frame) {
  return part_of<MapStage>(tours::kMaps, run, frame);
}

}  // namespace gjkscope
