#include "survey/effects_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "base/decimal.hpp"
#include "frames/frame.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

constexpr std::size_t kLeastRepetitions = 5;
constexpr std::size_t kMostRepetitions = 201;

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
    std::erase(run.lesson.views[static_cast<std::size_t>(caller.view)].effects, caller.effect);
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

}  // namespace

std::vector<EffectCost> effects_cost(const LessonRun& run, const Fonts& fonts, double seconds,
                                     const std::function<bool()>& go_on) {
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
    if (!go_on()) return {};
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
  const auto wanted = static_cast<std::size_t>(seconds / each);
  const std::vector<study::Timing> timings =
      study::interleave(contestants, run.frames.size(),
                        std::clamp(wanted, kLeastRepetitions, kMostRepetitions), go_on);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EffectCost& row = rows[i];
    row.repetitions = static_cast<int>(timings[0].ns.size());
    if (row.repetitions == 0) return {};
    row.ns = study::quartiles(timings[0].ns);
    if (row.pulls_off > 0) continue;
    row.ns_off = study::quartiles(timings[i + 1].ns);
    row.ratio = study::ratio(timings[0], timings[i + 1]);
  }
  return rows;
}

std::string effects_table(const std::vector<EffectCost>& rows) {
  if (rows.empty()) return "Nothing was measured.\n";
  std::string out = fmt::format(
      "Building the frames of a lesson with each effect and without what calls for it. ratio: with "
      "to without, median and quartiles\nof interleaved repetitions. The line without a name: the "
      "lesson against itself; effects that nothing calls for are never computed.\n\n"
      "{:<24} {:<21} {:>6} {:>6} {:>9} {:>6}  {:<13}  {}\n",
      "lesson", "effect", "pulls", "runs", "a frame", "ratio", "quartiles", "without");
  for (const EffectCost& row : rows) {
    const bool has_ratio = row.ratio.median > 0.0;
    out += fmt::format("{:<24} {:<21} {:>6} {:>6} {:>9} {:>6}  {:<13}  {}\n", row.lesson,
                       row.effect.empty() ? "(all others)" : row.effect, row.pulls, row.runs,
                       time_text(row.ns.median),
                       has_ratio ? fmt::format("{:.3f}", row.ratio.median) : "",
                       has_ratio ? fmt::format("{:.3f}-{:.3f}", row.ratio.low, row.ratio.high) : "",
                       has_ratio ? row.off : "its words call for it, too");
  }
  return out;
}

std::string effects_csv(const std::vector<EffectCost>& rows) {
  std::string out =
      "lesson,effect,frames,pulls,runs,pulls_off,share,repetitions,ns,ns_low,ns_high,ns_off,"
      "ns_off_low,ns_off_high,ratio,ratio_low,ratio_high,off\n";
  const auto quartiles = [](const study::Quartiles& q) {
    return q.median > 0.0 ? fmt::format("{},{},{}", q.median, q.low, q.high) : ",,";
  };
  for (const EffectCost& row : rows) {
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},\"{}\"\n", row.lesson, row.effect,
                       row.frames, row.pulls, row.runs, row.pulls_off, row.share, row.repetitions,
                       quartiles(row.ns), quartiles(row.ns_off), quartiles(row.ratio), row.off);
  }
  return out;
}

}  // namespace gjkscope
