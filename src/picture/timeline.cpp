#include "picture/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "picture/registry.hpp"

namespace gjkscope {
namespace {

using fmt::format;

struct Group {
  std::string label;
  std::vector<Tick> ticks;
};

std::vector<Group> timeline_groups(const LessonRun& run) {
  const StagedAct& act = staged(run);
  std::vector<Group> groups;
  for (const Frame& frame : run.frames) {
    Tick tick;
    if (frame.question < 0) {
      tick = act.tick(run, frame);
    } else {
      // A question belongs to the group of its answer.
      tick = {.group = run.act->follows_run ? format("iteration {}", run.answering_iteration(frame))
                                            : groups.back().label,
              .label = "question",
              .question = true};
    }
    if (groups.empty() || groups.back().label != tick.group) groups.push_back({tick.group, {}});
    groups.back().ticks.push_back(std::move(tick));
  }
  return groups;
}

}  // namespace

std::vector<Mark> timeline_marks(const LessonRun& run, int current, const Fonts& fonts,
                                 const Rect& area) {
  std::vector<Mark> marks;
  const std::vector<Group> groups = timeline_groups(run);
  const int count = static_cast<int>(run.frames.size());
  constexpr double kGroupGap = 18.0;
  constexpr double kTickGap = 5.0;
  constexpr double kWidest = 116.0;
  constexpr double kQuestionWidth = 10.0;
  constexpr double kHiddenRest = 120.0;
  const double gaps = kGroupGap * static_cast<double>(groups.size() - 1) +
                      kTickGap * static_cast<double>(count - static_cast<int>(groups.size()));
  const int questions =
      static_cast<int>(std::count_if(run.frames.begin(), run.frames.end(),
                                     [](const Frame& frame) { return frame.question >= 0; }));
  // Where a question is asked last, an end of the bar at the end would tell the answer.
  const double rest = questions > 0 ? kHiddenRest : 0.0;
  const double width = std::min(
      kWidest, (area.size().x() - rest - gaps - kQuestionWidth * questions) / (count - questions));
  // What comes after the next question would answer it: a bar without ticks.
  const auto question = std::find_if(run.frames.begin() + current, run.frames.end(),
                                     [](const Frame& frame) { return frame.question >= 0; });
  const int last = std::min(static_cast<int>(question - run.frames.begin()), count - 1);
  double x = area.min.x();
  int index = 0;
  const double bar_y = area.min.y() + 14.0;
  double label_end = -1e9;
  for (const Group& group : groups) {
    const int first = index;
    const double group_x = x;
    std::vector<double> centers;
    for (const Tick& tick : group.ticks) {
      const bool now = index == current;
      const std::string role = now               ? "timeline.current"
                               : index < current ? "timeline.done"
                                                 : "timeline.ahead";
      const Subject subject{Subject::Kind::frame, index};
      const double tick_width = tick.question ? kQuestionWidth : width;
      if (index > last) {
        const double gap = &tick == &group.ticks.back() ? kGroupGap : kTickGap;
        const double end = index + 1 == count ? area.max.x() : x + tick_width + gap;
        marks.push_back(
            {"timeline.hidden", Box{{{x, bar_y}, {end, bar_y + 10.0}}, 0.0}, -1, subject});
        x += tick_width + kTickGap;
        ++index;
        continue;
      }
      centers.push_back(x + 0.5 * tick_width);
      if (tick.question) {
        marks.push_back(
            {role, Disk{{centers.back(), bar_y + 5.0}, 0.5 * kQuestionWidth}, -1, subject});
      } else {
        const Rect bar{{x, bar_y}, {x + width, bar_y + (now ? 15.0 : 10.0)}};
        marks.push_back({role, Box{bar, 4.0}, -1, subject});
        if (!tick.phase.empty()) {
          const Rect stripe{{x, bar.max.y() + 2.0}, {x + width, bar.max.y() + 5.0}};
          marks.push_back({format("timeline.phase.{}", tick.phase), Box{stripe, 1.5}, -1, subject});
        }
      }
      if (tick.event)
        marks.push_back({"timeline.event", Disk{{x + width - 8.0, bar_y + 5.0}, 2.5}});
      x += tick_width + kTickGap;
      ++index;
    }
    const double group_end = x - kTickGap;
    x = group_end + kGroupGap;
    if (first > last) continue;
    const bool holds_current = current >= first && current < index;
    const TextStyle style = holds_current ? type::kTickBold : type::kTick;
    const double label_width = fonts.width(style, group.label);
    // Labels of narrow groups would run into each other; the current one always shows.
    if (holds_current ||
        (group_x > label_end && label_width <= group_end - group_x + kGroupGap - 6.0)) {
      const double label_x = std::min(group_x, area.max.x() - label_width);
      marks.push_back({holds_current ? "timeline.label.current" : "timeline.label",
                       Text{{label_x, area.min.y() + 4.0}, group.label, style, Align::left}});
      label_end = group_x + label_width + 8.0;
    }
    if (!holds_current) continue;
    // The current tick's label first, whole; the others as far as there is room beside it.
    std::vector<std::pair<double, double>> taken;
    const auto place = [&](int k, const std::string& label, bool now) {
      const TextStyle tick_style = now ? type::kTickBold : type::kTick;
      const double half = 0.5 * fonts.width(tick_style, label);
      const double center = std::clamp(centers[static_cast<std::size_t>(k - first)],
                                       area.min.x() + half, area.max.x() - half);
      constexpr double kSpace = 6.0;
      for (const auto& [low, high] : taken) {
        if (center - half - kSpace < high && low < center + half + kSpace) return false;
      }
      if (!now && 2.0 * half > width + kTickGap) return false;
      taken.emplace_back(center - half, center + half);
      marks.push_back({now ? "timeline.tick.current" : "timeline.label",
                       Text{{center, bar_y + 32.0}, label, tick_style, Align::center}});
      return true;
    };
    const auto tick_at = [&](int k) -> const Tick& {
      return group.ticks[static_cast<std::size_t>(k - first)];
    };
    place(current, tick_at(current).label, true);
    for (int k = first; k < std::min(index, last + 1); ++k) {
      if (k == current || tick_at(k).question) continue;  // a question's dot says enough
      const Tick& tick = tick_at(k);
      if (!place(k, tick.label, false) && !tick.short_label.empty())
        place(k, tick.short_label, false);
    }
  }
  return marks;
}

}  // namespace gjkscope
