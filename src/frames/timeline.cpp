#include "frames/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

struct Group {
  std::string label;
  std::vector<Tick> ticks;
};

std::vector<Group> timeline_groups(const LessonRun& run) {
  const Tour& tour = *run.tour;
  std::vector<Group> groups;
  for (const Frame& frame : run.frames) {
    Tick tick;
    if (frame.question < 0) {
      tick = tour.tick(run, frame);
    } else {
      // A question belongs to the group of its answer, unless that would tell it.
      const Frame answer{.run = frame.run, .step = frame.answering_step};
      tick = {.group = run.tour->follows_run         ? tour.tick(run, answer).group
                       : run.tour->asking != nullptr ? std::string("next")
                                                     : groups.back().label,
              .label = "question",
              .short_label = "?",
              .question = true};
    }
    if (groups.empty() || groups.back().label != tick.group) groups.push_back({tick.group, {}});
    groups.back().ticks.push_back(std::move(tick));
  }
  return groups;
}

/// "3" of "iteration 3", "D – KN" of "vertex D – edge KN"; empty where a label has no such words.
std::string brief(std::string label) {
  const std::string whole = label;
  for (const std::string_view kind :
       {"iteration ", "visit ", "position ", "region ", "vertex ", "edge "}) {
    for (std::size_t at = label.find(kind); at != std::string::npos; at = label.find(kind))
      label.erase(at, kind.size());
  }
  return label == whole ? std::string() : label;
}

/// A tick where it stands.
struct PlacedTick {
  const Tick* tick = nullptr;
  double center = 0.0;
  bool is_named = false;  ///< It belongs to the current group.
  bool is_current = false;
  [[nodiscard]] bool is_event() const { return tick->event || tick->question; }
};

/// Words under ticks, as far as they have room: first the current one's, then what happened, a
/// vertex dropped, a question, the end; then the other ticks of the group.
void name_ticks(std::vector<Mark>& marks, const std::vector<PlacedTick>& ticks, double tick_width,
                const Fonts& fonts, const Rect& area, double base) {
  constexpr double kSpace = 6.0;
  std::vector<std::pair<double, double>> taken;
  const auto place = [&](const PlacedTick& placed, const std::string& label, bool overhangs) {
    const TextStyle style = placed.is_current ? type::kTickBold : type::kTick;
    const double half = 0.5 * fonts.width(style, label);
    if (label.empty() || (!overhangs && 2.0 * half > tick_width)) return false;
    const double center = std::clamp(placed.center, area.min.x() + half, area.max.x() - half);
    const bool is_free = std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
      return center - half - kSpace < other.second && other.first < center + half + kSpace;
    });
    if (!is_free) return false;
    taken.emplace_back(center - half, center + half);
    marks.push_back({placed.is_current ? "timeline.tick.current" : "timeline.label",
                     Text{{center, base}, label, style, Align::center}});
    return true;
  };
  const auto name = [&](const PlacedTick& placed) {
    const Tick& tick = *placed.tick;
    if (tick.label == tick.group) return;
    if (placed.is_current) {
      place(placed, tick.label, true);
      return;
    }
    const bool is_shown = placed.is_named && !tick.question && place(placed, tick.label, false);
    if (is_shown) return;
    place(placed, tick.short_label.empty() ? tick.label : tick.short_label, placed.is_event());
  };
  const auto rank = [](const PlacedTick& placed) {
    return placed.is_current ? 0 : placed.is_event() ? 1 : placed.is_named ? 2 : 3;
  };
  for (int now = 0; now < 3; ++now) {
    for (const PlacedTick& placed : ticks) {
      if (rank(placed) == now) name(placed);
    }
  }
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
  constexpr double kQuestionWidth = 14.0;
  constexpr double kHiddenRest = 120.0;
  constexpr double kBetween = 8.0;  // labels
  const double gaps = kGroupGap * static_cast<double>(groups.size() - 1) +
                      kTickGap * static_cast<double>(count - static_cast<int>(groups.size()));
  const int questions =
      static_cast<int>(std::count_if(run.frames.begin(), run.frames.end(),
                                     [](const Frame& frame) { return frame.question >= 0; }));
  // Some room is hidden if there are questions: the end of the bar would tell a last one's answer.
  const double rest = questions > 0 ? kHiddenRest : 0.0;
  const auto width_beside = [&](double first, int others) {
    return std::min(kWidest,
                    (area.size().x() - rest - gaps - kQuestionWidth * questions - first) / others);
  };
  double width = width_beside(0.0, count - questions);
  // The first group has no shorter name. If its only tick is too narrow for the name, the tick is
  // made wider.
  double first_width = width;
  const double first_label = fonts.width(type::kTickBold, groups.front().label);
  if (groups.front().ticks.size() == 1 && brief(groups.front().label).empty() &&
      count - questions > 1 && first_label > width + kGroupGap - kBetween) {
    first_width = first_label - kGroupGap + kBetween;
    width = width_beside(first_width, count - questions - 1);
  }
  // Frames after the next question would answer it: they are a bar without ticks.
  const auto question = std::find_if(run.frames.begin() + current, run.frames.end(),
                                     [](const Frame& frame) { return frame.question >= 0; });
  const int last = std::min(static_cast<int>(question - run.frames.begin()), count - 1);
  double x = area.min.x();
  int index = 0;
  const double label_y = area.min.y() + 4.0;
  const double bar_y = area.min.y() + 14.0;
  double label_end = -1e9;
  std::optional<std::size_t> last_label;  // its mark
  double hidden_from = area.max.x();
  std::vector<PlacedTick> ticks;
  for (const Group& group : groups) {
    const int first = index;
    const double group_x = x;
    const bool holds_current =
        current >= first && current < first + static_cast<int>(group.ticks.size());
    for (const Tick& tick : group.ticks) {
      const bool now = index == current;
      const Subject subject{Subject::Kind::frame, index};
      // The room that hid the end belongs to the last one.
      const bool fills = questions > 0 && width < kWidest && index + 1 == count;
      const double tick_width = fills           ? area.max.x() - x
                                : tick.question ? kQuestionWidth
                                : index == 0    ? first_width
                                                : width;
      if (index > last) {
        const double gap = &tick == &group.ticks.back() ? kGroupGap : kTickGap;
        const double end = index + 1 == count ? area.max.x() : x + tick_width + gap;
        marks.push_back(
            {"timeline.hidden", Box{{{x, bar_y}, {end, bar_y + 10.0}}, 0.0}, -1, subject});
        hidden_from = std::min(hidden_from, x);
      } else {
        const std::string role = now               ? "timeline.current"
                                 : index < current ? "timeline.done"
                                                   : "timeline.ahead";
        const Rect bar{{x, bar_y}, {x + tick_width, bar_y + (now ? 15.0 : 10.0)}};
        marks.push_back({role, Box{bar, 4.0}, -1, subject});
        ticks.push_back({&tick, x + 0.5 * tick_width, holds_current, now});
      }
      x += tick_width + kTickGap;
      ++index;
    }
    const double group_end = x - kTickGap;
    x = group_end + kGroupGap;
    if (first > last) continue;
    const TextStyle style = holds_current ? type::kTickBold : type::kTick;
    // Labels of narrow groups would run into each other: they are short, or left out.
    for (const std::string& label : {group.label, brief(group.label)}) {
      const double label_width = fonts.width(style, label);
      const bool has_room =
          group_x > label_end && label_width <= group_end - group_x + kGroupGap - kBetween;
      if (label.empty() || !(holds_current || has_room)) continue;
      const double label_x = std::min(group_x, area.max.x() - label_width);
      // The current one stands, wherever it does; a label that it would touch gives way.
      if (label_x < label_end && last_label) {
        marks.erase(marks.begin() + static_cast<std::ptrdiff_t>(*last_label));
      }
      last_label = marks.size();
      marks.push_back({holds_current ? "timeline.label.current" : "timeline.label",
                       Text{{label_x, label_y}, label, style, Align::left}});
      label_end = label_x + label_width + kBetween;
      break;
    }
  }
  if (hidden_from < area.max.x())
    marks.push_back(
        {"timeline.hidden.frame", Box{{{hidden_from, bar_y}, {area.max.x(), bar_y + 10.0}}, 0.0}});
  const std::string hidden = "after the question";
  constexpr double kApart = 12.0;  // it is no part of the label before it
  const double hidden_x = std::max(hidden_from, label_end + kApart);
  if (hidden_x + fonts.width(type::kTick, hidden) <= area.max.x()) {
    marks.push_back(
        {"timeline.label", Text{{hidden_x, label_y}, hidden, type::kTick, Align::left}});
  }
  name_ticks(marks, ticks, width + kTickGap, fonts, area, bar_y + 32.0);
  return marks;
}

}  // namespace gjkscope
