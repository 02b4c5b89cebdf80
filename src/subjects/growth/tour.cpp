#include <fmt/format.h>

#include <array>
#include <utility>

#include "subjects/growth/growth.hpp"
#include "subjects/growth/plots.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
namespace {

bool is_support_or_end(const LessonRun& run, int index, int step) {
  const WideTrace& trace = run.runs[index].trace;
  return trace.steps[step].phase == gjk::Phase::support || step == last_step(run.lesson, trace);
}

void growth_frames(LessonRun& run, int index) {
  add_step_frames(run, index, is_support_or_end);
  const int last = last_step(run.lesson, run.runs[index].trace);
  if (last < 0) return;
  const std::vector<int>& sizes = run.lesson.settings.as<LessonGrowth>()->vertices;
  const bool has_slow = sizes.front() <= SlowGrowth::kMost;
  for (int i = 0; i <= static_cast<int>(sizes.size()) + (has_slow ? 1 : 0); ++i)
    run.frames.push_back({.run = index, .step = last, .part = i});
}

/// nullptr where a frame is about all sizes.
const int* vertices_of(const LessonRun& run, const Frame& frame) {
  const std::vector<int>& sizes = run.lesson.settings.as<LessonGrowth>()->vertices;
  const auto size = static_cast<std::size_t>(*shown_size(run, frame));
  return size < sizes.size() ? &sizes[size] : nullptr;
}

std::string growth_position(const LessonRun& run, int index) {
  const Frame& frame = run.frames[index];
  if (!shown_size(run, frame)) return position_in_run(run, index);
  const int* vertices = vertices_of(run, frame);
  return fmt::format("{} · {} of {}",
                     vertices != nullptr   ? fmt::format("n = {}", grouped(*vertices))
                     : is_slow(run, frame) ? "slow runs"
                                           : "outcome",
                     index + 1, run.frames.size());
}

/// "30k", "1M"; in full what is no whole number of thousands.
std::string short_count(int count) {
  constexpr int kThousand = 1000;
  constexpr int kMillion = kThousand * kThousand;
  if (count % kMillion == 0) return std::to_string(count / kMillion) + "M";
  if (count % kThousand == 0) return std::to_string(count / kThousand) + "k";
  return std::to_string(count);
}

Tick growth_tick(const LessonRun& run, const Frame& frame) {
  if (!shown_size(run, frame)) return tick_of_step(run, frame);
  const int* vertices = vertices_of(run, frame);
  if (is_slow(run, frame)) return {.group = "slow runs", .label = "worst", .event = true};
  if (vertices == nullptr) return {.group = "outcome", .label = "all n", .event = true};
  return {.group = "vertices n", .label = short_count(*vertices)};
}

void growth_words(const Story& story, FrameText& text) {
  return shown_size(story.run, story.frame) ? captions::growth(story, text)
                                            : captions::step(story, text);
}

/// The averages of a size's runs. The lesson's own pair is no part of them.
void growth_values(const Story& story, FrameText& text) {
  if (!shown_size(story.run, story.frame)) return captions::run_values(story, text);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  const int* vertices = vertices_of(story.run, story.frame);
  if (vertices == nullptr) return;
  const Growth::Sample& sample =
      story.effects.get<Growth>(story.frame)[*shown_size(story.run, story.frame)];
  put("n", grouped(*vertices));
  put("iterations", fixed(sample.iterations, 1));
  put("support calls", fixed(sample.support_calls, 1));
  put("differences computed", fixed(sample.touched_points, 1));
}

bool growth_fill(SceneBuilder& scene, const Fonts& fonts) {
  if (scene.view.kind == ViewKind::plot) {
    layers::growth(scene, fonts);
    return true;
  }
  if (!shown_size(scene.run, scene.frame) || scene.view.kind != ViewKind::difference) return false;
  layers::growth_example(scene);
  return true;
}

constexpr std::array kGrowthAsks = {kAskIterations, kAskScanned, kAskOutline, kAskSlowest,
                                    kAskDots};

int growth_answer(const LessonRun& run, const Frame&, const Frame& frame,
                  const LessonQuestion& question) {
  const auto answers = [&] {
    if (question.ask == kAskSlowest.name) return is_slow(run, frame);
    if (question.ask != kAskDots.name) {
      const int size = shown_size(run, frame).value_or(0);
      return size > 0 && vertices_of(run, frame) != nullptr &&
             question.at.value_or(size + 1) == size + 1;
    }
    if (shown_size(run, frame) || frame.step < 0) return false;
    const WideStep& step = run.run(frame).trace.steps[frame.step];
    return step.phase == gjk::Phase::support &&
           question.at.value_or(step.iteration) == step.iteration;
  };
  return answers() ? frame.step : -1;
}

std::string growth_plot_title(const LessonRun&) { return "Iterations as polygons grow"; }

}  // namespace

const Tour kGrowth{
    .name = "growth",
    .meaning =
        "support step of the run, then number of vertices in [growth]; then the "
        "outcome, and runs that are slow",
    .needs = {.settings = &LessonGrowth::kKind,
              .path = PathUse::refused,
              .why_no_until = "frames show how the run ends"},
    .add_frames = growth_frames,
    .follows_run = true,
    .asks = kGrowthAsks,
    .answering_step = growth_answer,
    .algorithm = &kGjkAlgorithm,
    .position = growth_position,
    .tick = growth_tick,
    .words = growth_words,
    .stage = layers::stage_step,
    .question = captions::growth_question,
    .values = growth_values,
    .fill = growth_fill,
    .plot_title = growth_plot_title,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<int> shown_size(const LessonRun& run, const Frame& frame) {
  return part_of<int>(tours::kGrowth, run, frame);
}

bool is_slow(const LessonRun& run, const Frame& frame) {
  const int sizes = static_cast<int>(run.lesson.settings.as<LessonGrowth>()->vertices.size());
  const bool asks = frame.question >= 0 && run.asked(frame).ask == kAskSlowest.name;
  return asks || shown_size(run, frame) == sizes + 1;
}

}  // namespace gjkscope
