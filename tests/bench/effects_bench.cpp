// The cost of effects: the frames of each lesson, with each effect and without. An argument: the id
// of one lesson.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "base/decimal.hpp"
#include "frames/frame.hpp"
#include "shipped_lessons.hpp"
#include "study/interleave.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

constexpr double kSeconds = 1.5;  // of timing a lesson, about
constexpr std::size_t kLeastRepetitions = 5;
constexpr std::size_t kMostRepetitions = 201;

struct EffectCost {
  std::string lesson;
  std::string effect;  ///< Empty in the last row of a lesson, for all that nothing calls for.
  std::string off;     ///< Things taken away to be without it: "hull in a view, block bounds".
  int frames = 0;
  long pulls = 0;           ///< How often the frames ask for it, and
  long runs = 0;            ///< how often it is computed for them.
  long pulls_off = 0;       ///< Not 0: the lesson cannot be without it, and there is no ratio.
  double share = 0.0;       ///< The share of the frames' time spent computing it and what it pulls.
  int repetitions = 0;      ///< Repetitions of the timing. Without any the rest is 0.
  study::Quartiles ns;      ///< Per frame, with it.
  study::Quartiles ns_off;  ///< Without it.
  study::Quartiles ratio;   ///< With it to without, repetition by repetition.
};

/// Something of a lesson that may call for effects: an effect named in a view, or a panel block.
struct Caller {
  int view = -1;  ///< Index into Lesson::views, or -1: of the panel.
  std::string effect;
  std::string block;

  [[nodiscard]] std::string words() const {
    return view < 0 ? fmt::format("block {}", block) : fmt::format("{} in a view", effect);
  }
};

std::vector<Caller> callers_of(const Lesson& lesson) {
  std::vector<Caller> out;
  for (std::size_t i = 0; i < lesson.views.size(); ++i) {
    for (const std::string& effect : lesson.views[i].effects) {
      out.push_back({static_cast<int>(i), effect, {}});
    }
  }
  for (const std::string& block : lesson.panel) out.push_back({-1, "", block});
  return out;
}

LessonRun without(LessonRun run, const Caller& caller) {
  if (caller.view < 0) {
    std::erase(run.lesson.panel, caller.block);
  } else {
    std::erase(run.lesson.views[caller.view].effects, caller.effect);
  }
  return run;
}

/// All frames of a run, built from nothing.
std::size_t build(const LessonRun& run, EffectGraph& effects, const Fonts& fonts) {
  std::size_t marks = 0;
  for (const FramePicture& frame : lesson_pictures(run, effects, fonts)) {
    marks += frame.picture.marks.size();
  }
  return marks;
}

long pulls_of(std::string_view effect, const LessonRun& run, const Fonts& fonts) {
  EffectGraph effects(run);
  build(run, effects, fonts);
  return effects.count(effect).pulls;
}

/// The run without all that calls for an effect, and what that was.
LessonRun without(const LessonRun& run, EffectCost& row, const Fonts& fonts) {
  LessonRun out = run;
  row.pulls_off = row.pulls;
  for (const Caller& caller : callers_of(run.lesson)) {
    if (row.pulls_off == 0) break;
    LessonRun less = without(out, caller);
    const long pulls = pulls_of(row.effect, less, fonts);
    if (pulls >= row.pulls_off) continue;
    row.pulls_off = pulls;
    row.off += fmt::format("{}{}", row.off.empty() ? "" : ", ", caller.words());
    out = std::move(less);
  }
  return out;
}

study::Contestant contestant(LessonRun run, const Fonts& fonts) {
  study::Contestant out;
  out.sweep = [run = std::make_shared<const LessonRun>(std::move(run)), &fonts] {
    EffectGraph effects(*run);
    return static_cast<double>(build(*run, effects, fonts));
  };
  return out;
}

/// Times how long the frames of a lesson take to build (layout, words and marks; painting them
/// comes after and does not know of effects). For each effect that is called for, with it and
/// without all that calls for it. The last row times the lesson against a copy of itself: how far
/// the effects that nothing calls for, which are never computed, are from costing nothing, and how
/// large the noise is.
std::vector<EffectCost> effects_cost(const LessonRun& run, const Fonts& fonts) {
  using Clock = std::chrono::steady_clock;
  EffectGraph effects(run);
  const Clock::time_point begin = Clock::now();
  build(run, effects, fonts);
  const std::chrono::duration<double> once = Clock::now() - begin;

  std::vector<EffectCost> rows;
  std::vector<study::Contestant> contestants = {contestant(run, fonts)};
  const auto add = [&](EffectCost row, LessonRun off) {
    row.lesson = run.lesson.id;
    row.frames = static_cast<int>(run.frames.size());
    rows.push_back(std::move(row));
    contestants.push_back(contestant(std::move(off), fonts));
  };
  for (const EffectInfo* info : registered_effects()) {
    const EffectCount count = effects.count(info->name);
    if (count.pulls == 0) continue;
    EffectCost row;
    row.effect = info->name;
    row.pulls = count.pulls;
    row.runs = count.runs;
    row.share = count.seconds / once.count();
    LessonRun off = without(run, row, fonts);
    add(std::move(row), std::move(off));
  }
  add({}, run);

  const double each = once.count() * static_cast<double>(contestants.size());
  const auto wanted = static_cast<std::size_t>(kSeconds / each);
  const std::vector<study::Timing> timings = study::interleave(
      contestants, run.frames.size(), std::clamp(wanted, kLeastRepetitions, kMostRepetitions));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EffectCost& row = rows[i];
    row.repetitions = static_cast<int>(timings[0].ns.size());
    row.ns = study::quartiles(timings[0].ns);
    if (row.pulls_off > 0) continue;
    row.ns_off = study::quartiles(timings[i + 1].ns);
    row.ratio = study::ratio(timings[0], timings[i + 1]);
  }
  return rows;
}

void print_head() {
  fmt::print(
      "Building the frames of a lesson with each effect and without what calls for it. ratio: with "
      "to without, median and quartiles\nof interleaved repetitions. The line without a name: the "
      "lesson against itself; effects that nothing calls for are never computed.\n\n"
      "{:<24} {:<21} {:>6} {:>6} {:>9} {:>6}  {:<13}  {}\n",
      "lesson", "effect", "pulls", "runs", "a frame", "ratio", "quartiles", "without");
}

void print(const std::vector<EffectCost>& rows) {
  for (const EffectCost& row : rows) {
    const bool has_ratio = row.ratio.median > 0.0;
    fmt::print("{:<24} {:<21} {:>6} {:>6} {:>9} {:>6}  {:<13}  {}\n", row.lesson,
               row.effect.empty() ? "(all others)" : row.effect, row.pulls, row.runs,
               time_text(row.ns.median), has_ratio ? fmt::format("{:.3f}", row.ratio.median) : "",
               has_ratio ? fmt::format("{:.3f}-{:.3f}", row.ratio.low, row.ratio.high) : "",
               has_ratio ? row.off : "its words call for it, too");
  }
}

}  // namespace
}  // namespace gjkscope

int main(int count, char** arguments) {
  using namespace gjkscope;
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  print_head();
  for (const Lesson& lesson : bench::shipped_lessons())
    if (count == 1 || lesson.id == arguments[1]) print(effects_cost(run_lesson(lesson), fonts));
}
