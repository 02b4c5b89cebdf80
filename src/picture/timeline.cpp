#include "picture/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "lesson/names.hpp"
#include "picture/words.hpp"

namespace gjkscope {
namespace {

using fmt::format;

struct Tick {
  std::string label;
  std::string short_label;  ///< Where the label is wider than the tick.
  bool event = false;       ///< A vertex dropped, containment, the end.
  bool question = false;
  std::optional<gjk::Phase> phase = {};
};
struct Group {
  std::string label;
  std::vector<Tick> ticks;
};

/// "30k", "1M"; in full what is no whole number of thousands.
std::string short_count(int count) {
  constexpr int kThousand = 1000;
  constexpr int kMillion = kThousand * kThousand;
  if (count % kMillion == 0) return std::to_string(count / kMillion) + "M";
  if (count % kThousand == 0) return std::to_string(count / kThousand) + "k";
  return std::to_string(count);
}

std::string act_of(const StudyFrame& frame) {
  if (frame.stage < StudyStage::error_axis) return "one pair";
  return frame.stage < StudyStage::front ? "time and error" : "the front";
}

Tick tick_of(const LessonRun& run, const StudyFrame& frame) {
  switch (frame.stage) {
    case StudyStage::shapes:
      return {"shapes", "", false};
    case StudyStage::gap:
      return {"gap", "", false};
    case StudyStage::in_float:
      return {"float", "", false};
    case StudyStage::in_double:
      return {"double", "", false};
    case StudyStage::error:
      return {"error", "", true};
    case StudyStage::error_axis:
      return {"errors", "", false};
    case StudyStage::time_axis:
      return {"times", "", false};
    case StudyStage::mark:
      return {run.lesson.study->marks[static_cast<std::size_t>(frame.marks - 1)].configuration, "",
              false};
    case StudyStage::front:
      return {"of the marks", "", false};
    case StudyStage::all:
      return {"of all", "", false};
    case StudyStage::choice:
      return {"what to take", "", true};
  }
  return {};
}

std::vector<Group> timeline_groups(const LessonRun& run) {
  std::vector<Group> groups;
  const auto group = [&](const std::string& label) -> Group& {
    if (groups.empty() || groups.back().label != label) groups.push_back({label, {}});
    return groups.back();
  };
  const Granularity granularity = run.lesson.granularity;
  const int per_x = static_cast<int>(run.lesson.y.vertices.size());
  const int all = static_cast<int>(run.lesson.x.vertices.size()) * per_x;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const Frame& frame = run.frames[i];
    if (frame.question >= 0) {
      // A question belongs to the group of its answer.
      const int iteration = run.run(frame).trace.steps[frame.answer].iteration;
      const bool stays = granularity == Granularity::test || granularity == Granularity::study;
      (stays ? groups.back() : group(format("iteration {}", iteration)))
          .ticks.push_back({"question", "", false, true});
    } else if (granularity == Granularity::path) {
      const SimplexWords words(run, run.state(frame).simplex);
      const gjk::Face face = run.state(frame).region;
      group(gjk::vertex_count(face) == 3 ? "interior" : "region " + words.face(face))
          .ticks.push_back({});
    } else if (granularity == Granularity::test) {
      Group& position =
          group(run.runs.size() > 1 ? format("position {}", frame.run + 1) : "ordered tests");
      if (frame.detail < 0) {
        position.ticks.push_back({"weights", "", false});
      } else {
        const gjk::RegionTest<double>& test = run.step(frame).record.region_tests[frame.detail];
        position.ticks.push_back(
            {"region " + SimplexWords(run, run.state(frame).simplex).face(test.region),
             SimplexWords(run, run.state(frame).simplex).face(test.region), test.holds});
      }
    } else if (granularity == Granularity::time) {
      const gjk::Simplex<double, 2>& simplex = run.state(frame).simplex;
      const gjk::Barycentric<double, 2> weights = gjk::barycentric(simplex, simplex.all());
      const auto weight = [&](int k) {
        return fixed(weights.numerator[k] / weights.denominator, 2);
      };
      group(format("u = {}, v = {}", weight(0), weight(1)))
          .ticks.push_back({fixed(run.seconds(frame), 2) + " s", "", false});
    } else if (granularity == Granularity::maps) {
      constexpr std::array<std::string_view, kMapStages> kMaps = {
          "Voronoi", "interior", "u < 0", "v < 0", "w < 0", "signs", "both", "difference"};
      group(frame.run == 0 ? "maps" : format("position {}", frame.run + 1))
          .ticks.push_back({std::string(kMaps[frame.detail]), "", false});
    } else if (granularity == Granularity::orders) {
      constexpr std::array<std::string_view, kOrderStages> kOrders = {"numbers", "vertices first",
                                                                      "edges first", "whole tests"};
      group(format("position {}", frame.run + 1))
          .ticks.push_back({std::string(kOrders[frame.detail]), "", false});
    } else if (granularity == Granularity::growth && frame.detail >= 0) {
      const std::vector<int>& sizes = run.lesson.growth->vertices;
      const auto size = static_cast<std::size_t>(frame.detail);
      if (size < sizes.size()) {
        group("vertices n").ticks.push_back({short_count(sizes[size]), "", false});
      } else {
        group("outcome").ticks.push_back({"all n", "", true});
      }
    } else if (granularity == Granularity::study) {
      group(act_of(run.study(frame))).ticks.push_back(tick_of(run, run.study(frame)));
    } else if (granularity == Granularity::pairs) {
      if (frame.detail == 0) {
        group("start").ticks.push_back({});
      } else if (frame.detail > all) {
        group("hull").ticks.push_back({"Z", "", true});
      } else {
        const gjk::VertexPair pair{(frame.detail - 1) / per_x, (frame.detail - 1) % per_x};
        group(format("{} − {}", run.lesson.y.name, run.lesson.x.vertex_names[pair.x]))
            .ticks.push_back({run.pair_name(pair), "", false});
      }
    } else if (granularity == Granularity::support && frame.detail >= 0) {
      constexpr std::array<std::string_view, 4> kParts = {"d", "Y along d", "X along −d", "Z"};
      const auto part = static_cast<std::size_t>(frame.detail);
      group(format("iteration {}", run.step(frame).iteration))
          .ticks.push_back({std::string(kParts[part]), std::string(1, "dYXZ"[part]),
                            frame.detail == kSupportOfZ});
    } else if (granularity == Granularity::witness && frame.detail >= 0) {
      constexpr std::array<std::string_view, 4> kParts = {"P", "on Y", "on X", "y − x"};
      group(run.runs.size() > 1 ? format("position {}", frame.run + 1) : "answer")
          .ticks.push_back({std::string(kParts[static_cast<std::size_t>(frame.detail)]), "",
                            frame.detail == kWitnessDistance});
    } else if (granularity == Granularity::answer && frame.step >= 0) {
      const gjk::Result<double, 2>& result = run.run(frame).trace.result;
      const std::string closest = result.distance > 0.0
                                      ? format("{} – {}", feature_name(run, result.simplex, true),
                                               feature_name(run, result.simplex, false))
                                      : "distance 0";
      group(closest).ticks.push_back({});
    } else if (frame.step < 0) {
      group("start").ticks.push_back({"S", "", false});
    } else {
      const gjk::Step<double, 2>& step = run.step(frame);
      const bool event =
          !step.record.dropped.empty() || step.after.stop != gjk::StopReason::running;
      constexpr std::array<std::array<std::string_view, 2>, 6> kPhases = {{{"closest", "P"},
                                                                           {"drop", "−"},
                                                                           {"direction", "d"},
                                                                           {"support", "V"},
                                                                           {"stop?", "?"},
                                                                           {"add", "+"}}};
      const auto& [label, short_label] = kPhases[static_cast<std::size_t>(step.phase)];
      group(format("iteration {}", step.iteration))
          .ticks.push_back(
              {std::string(label), std::string(short_label), event, false, step.phase});
    }
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
        if (tick.phase) {
          const Rect stripe{{x, bar.max.y() + 2.0}, {x + width, bar.max.y() + 5.0}};
          marks.push_back(
              {format("timeline.phase.{}", name_of(*tick.phase)), Box{stripe, 1.5}, -1, subject});
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
      if (!place(k, tick_at(k).label, false)) place(k, tick_at(k).short_label, false);
    }
  }
  return marks;
}

}  // namespace gjkscope
