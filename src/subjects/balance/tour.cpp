#include <fmt/format.h>

#include <array>

#include "run/questions.hpp"
#include "subjects/balance/balance.hpp"
#include "subjects/balance/subject.hpp"
#include "subjects/balance/table.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
namespace {

void time_frames(LessonRun& run, int index) {
  if (run.runs[index].trace.steps.empty()) return;
  const int moments = static_cast<int>(run.lesson.settings.as<LessonTime>()->at(index).size());
  for (int i = 0; i < moments; ++i) run.frames.push_back({.run = index, .step = 0, .part = i});
}

std::string time_position(const LessonRun& run, int index) {
  const double seconds = seconds_of(run, run.frames[index]);
  return fmt::format("t = {} s · {} of {}", fixed(seconds, 2), index + 1, run.frames.size());
}

Tick time_tick(const LessonRun& run, const Frame& frame) {
  const WideSimplex& simplex = run.state(frame).simplex;
  const gjk::Barycentric<double, 2> weights = gjk::barycentric(in_plane(simplex), simplex.all());
  const auto weight = [&](int k) { return fixed(weights.numerator[k] / weights.denominator, 2); };
  return {.group = fmt::format("u = {}, v = {}", weight(0), weight(1)),
          .label = fixed(seconds_of(run, frame), 2) + " s"};
}

constexpr AskInfo kAskSinks{"sinks", "the end of the beam that sinks", "at position"};
constexpr AskInfo kAskBalance{"balance-point", "where the beam balances", "at position"};
constexpr std::array kTimeAsks = {kAskSinks, kAskBalance};

/// The frame that lets the beam go tells which end sinks; the moment after it, where it balances.
int time_answer(const LessonRun& run, const Frame&, const Frame& frame,
                const LessonQuestion& question) {
  if (!is_at(frame, question)) return -1;
  if (question.ask == kAskBalance.name) return *beam_moment(run, frame) == 1 ? frame.step : -1;
  return *beam_moment(run, frame) == 0 && seconds_of(run, frame) == 0.0 ? frame.step : -1;
}

Frame time_asking(const LessonRun&, const Frame& frame) {
  return {.run = frame.run, .step = frame.step, .part = 0};
}

void time_question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  const Balance::Value& value = story.effects.get<Balance>(story.frame);
  const std::string a = story.words.vertex(0);
  const std::string b = story.words.vertex(1);
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  if (ask == kAskSinks.name) {
    asked.choices = {a, b, "neither"};
    const double turns = value.masses[0] - value.masses[1];
    asked.answer = asked.choices[turns > 0.0 ? 0 : turns < 0.0 ? 1 : 2];
    text.caption = "Question: the beam hangs from its middle, and is let go. Which end sinks?";
    return;
  }
  const Eigen::Vector2d q = in_plane(story.positioned.x().world.front());
  const Eigen::Vector2d from = q + in_plane(story.state.simplex.vertices[0].w);
  const Eigen::Vector2d along = q + in_plane(story.state.simplex.vertices[1].w) - from;
  const Eigen::Vector2d up = Eigen::Vector2d(-along.y(), along.x()) * (along.x() < 0.0 ? -1 : 1);
  const auto on_beam = [&](double x) { return Eigen::Vector2d(from + x * along - kBeamDrop * up); };
  const double v = value.weights[1];
  asked.choices = {fmt::format("nearer to {}", a), "in the middle", fmt::format("nearer to {}", b),
                   "nowhere on the beam"};
  constexpr double kMiddle = 0.05;
  asked.spots = {Spot{ViewKind::world, on_beam(0.0), on_beam(0.5 - kMiddle)},
                 Spot{ViewKind::world, on_beam(0.5 - kMiddle), on_beam(0.5 + kMiddle)},
                 Spot{ViewKind::world, on_beam(0.5 + kMiddle), on_beam(1.0)}, std::nullopt};
  asked.answer = asked.choices[v < 0.0 || v > 1.0  ? 3
                               : v < 0.5 - kMiddle ? 0
                               : v > 0.5 + kMiddle ? 2
                                                   : 1];
  if (v >= 0.0 && v <= 1.0) asked.place = on_beam(v);
  text.caption = "Question: where must the support stand, so that the beam stays level?";
}

}  // namespace

const Tour kTime{
    .name = "time",
    .meaning =
        "moment of [time], at each position of X; for a point query whose `start` is a "
        "segment",
    .needs = {.settings = &LessonTime::kKind,
              .start = 2,
              .why_no_until = "frames go through the first region tests"},
    .add_frames = time_frames,
    .asks = kTimeAsks,
    .answering_step = time_answer,
    .asking = time_asking,
    .algorithm = &kGjkAlgorithm,
    .position = time_position,
    .tick = time_tick,
    .words = captions::balance,
    .stage = layers::stage_step,
    .question = time_question,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<int> beam_moment(const LessonRun& run, const Frame& frame) {
  return part_of<int>(tours::kTime, run, frame);
}

}  // namespace gjkscope
