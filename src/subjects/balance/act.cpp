#include <fmt/format.h>

#include "subjects/balance/balance.hpp"
#include "subjects/balance/subject.hpp"
#include "subjects/balance/table.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::acts {
namespace {

void time_frames(LessonRun& run, int index) {
  if (run.runs[static_cast<std::size_t>(index)].trace.steps.empty()) return;
  const int moments = static_cast<int>(run.lesson.table.as<LessonTime>()->at(index).size());
  for (int i = 0; i < moments; ++i) run.frames.push_back({.run = index, .step = 0, .part = i});
}

std::string time_position(const LessonRun& run, int index) {
  const double seconds = seconds_of(run, run.frames[static_cast<std::size_t>(index)]);
  return fmt::format("t = {} s · {} of {}", fixed(seconds, 2), index + 1, run.frames.size());
}

Tick time_tick(const LessonRun& run, const Frame& frame) {
  const WideSimplex& simplex = run.state(frame).simplex;
  const gjk::Barycentric<double, 2> weights = gjk::barycentric(in_plane(simplex), simplex.all());
  const auto weight = [&](int k) { return fixed(weights.numerator[k] / weights.denominator, 2); };
  return {.group = fmt::format("u = {}, v = {}", weight(0), weight(1)),
          .label = fixed(seconds_of(run, frame), 2) + " s"};
}

}  // namespace

const Act kTime{
    .name = "time",
    .meaning =
        "moment of [time], at each position of X; for a point query whose `start` is a "
        "segment",
    .needs = {.table = &LessonTime::kKind,
              .start = 2,
              .why_no_until = "frames go through the first region tests"},
    .add_frames = time_frames,
    .algorithm = &kGjkAlgorithm,
    .position = time_position,
    .tick = time_tick,
    .words = captions::balance,
    .stage = layers::stage_step,
};

}  // namespace gjkscope::acts

namespace gjkscope {

std::optional<int> beam_moment(const LessonRun& run, const Frame& frame) {
  return part_of<int>(acts::kTime, run, frame);
}

}  // namespace gjkscope
