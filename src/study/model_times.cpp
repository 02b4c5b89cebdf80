#include "study/model_times.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "base/decimal.hpp"
#include "outlines/brute.hpp"
#include "study/accuracy.hpp"
#include "study/interleave.hpp"
#include "subjects/general_growth/measure.hpp"

namespace gjkscope {
namespace {

using models::Box;
using models::Circle;
using models::Model;

constexpr double kMostPairs = 1e7;  // of segments that one turn looks at
constexpr double kLeastNanoseconds = 5e6;

/// Every `share`-th segment.
Model thinned(const Model& model, int share) {
  Model out = model;
  out.segments.clear();
  for (std::size_t i = 0; i < model.segments.size(); i += static_cast<std::size_t>(share))
    out.segments.push_back(model.segments[i]);
  return out;
}

/// A way to answer, and how long it takes, turn by turn.
struct Timed {
  std::vector<double> GrowthTimes::*member;
  std::function<long()> work;
  int repeats = 1;  ///< In a turn.
  std::vector<double> ns = {};
};

double nanoseconds(const Timed& timed) {
  const std::clock_t begin = std::clock();
  long sum = 0;
  for (int i = 0; i < timed.repeats; ++i) sum += timed.work();
  study::keep(sum);
  return 1e9 / CLOCKS_PER_SEC * static_cast<double>(std::clock() - begin) / timed.repeats;
}

/// Work takes turns, and is repeated until a turn is long enough for the clock. False when `go_on`
/// said no before the first turn was over.
bool take_turns(std::vector<Timed>& all, int turns, const std::function<bool()>& go_on) {
  for (Timed& each : all) {
    while (go_on() && each.repeats * nanoseconds(each) < kLeastNanoseconds) each.repeats *= 2;
  }
  for (int turn = 0; turn < turns && go_on(); ++turn) {
    for (Timed& each : all) each.ns.push_back(nanoseconds(each));
  }
  return !all.front().ns.empty();
}

/// Adds the times of one size. Says whether all were measured.
bool measure(GrowthTimes& times, int segments, int seed, int turns,
             const std::function<bool()>& go_on) {
  std::mt19937_64 bits(static_cast<std::uint64_t>(seed));
  const general_growth::Scene scene = general_growth::scene(bits, segments);
  const Model& x = scene.x;
  const Model& y = scene.y;
  const auto build = [](const Model& model) {
    return models::build_hierarchy<Box>(models::items_of(model));
  };
  const auto x_boxes = build(x);
  const auto y_boxes = build(y);
  const auto x_circles = models::build_hierarchy<Circle>(models::items_of(x));
  const auto y_circles = models::build_hierarchy<Circle>(models::items_of(y));
  models::SearchOptions collide;
  collide.goal = models::Goal::collide;
  models::SearchOptions remembered;
  const auto before = build(scene.before);
  remembered.remembered = models::search<Box>({x, scene.before, x_boxes, before}).segments;
  const auto by_boxes = [&](const models::SearchOptions& options) {
    return [&, options] { return models::search<Box>({x, y, x_boxes, y_boxes}, options).visits; };
  };
  const double pairs = static_cast<double>(segments) * segments;
  const int share = std::max(1, static_cast<int>(std::lround(pairs / kMostPairs)));
  const Model some = thinned(x, share);
  std::vector<Timed> all = {
      {&GrowthTimes::pairs, [&] { return models::brute(some, y).visits; }},
      {&GrowthTimes::boxes, by_boxes({})},
      {&GrowthTimes::circles,
       [&] {
         return models::search<Circle>({x, y, x_circles, y_circles}).visits;
       }},
      {&GrowthTimes::remembered, by_boxes(remembered)},
      {&GrowthTimes::collide, by_boxes(collide)},
      {&GrowthTimes::build,
       [&] { return static_cast<long>(build(x).nodes.size() + build(y).nodes.size()); }}};
  models::Pieces x_pieces;
  models::Pieces y_pieces;
  if (segments <= general_growth::kMostCut) {
    x_pieces = models::pieces_of(x);
    y_pieces = models::pieces_of(y);
    all.push_back({&GrowthTimes::pieces,
                   [&] { return models::pieces_distance(x, y, x_pieces, y_pieces).visits; }});
  }
  if (!take_turns(all, turns, go_on)) return false;
  for (const Timed& each : all) {
    const double ns = study::quartiles(each.ns).median;
    (times.*each.member)
        .push_back(std::round(each.member == &GrowthTimes::pairs ? share * ns : ns));
  }
  return true;
}

}  // namespace

std::vector<ModelTimes> model_times(const Lesson& lesson, int turns,
                                    const std::function<bool()>& go_on) {
  if (lesson.tour != "general-growth") return {};
  const study::Machine machine = study::this_machine();
  ModelTimes out{lesson.id, lesson.settings.as<LessonGrowth>()->vertices, {}};
  out.times.machine = fmt::format("{}, {}", machine.processor, machine.compiler);
  for (const int size : out.sizes) {
    if (!measure(out.times, size, lesson.settings.as<LessonGrowth>()->seed, turns, go_on))
      return {};
  }
  return {std::move(out)};
}

std::string model_times_table(const std::vector<ModelTimes>& all) {
  if (all.empty()) return "Nothing was measured: no lesson has the tour general-growth.\n";
  std::string out;
  for (const ModelTimes& each : all) {
    out += fmt::format("{}, on {}\n  {:>9}", each.lesson, each.times.machine, "segments");
    for (const auto& [name, member] : kGrowthTimes) out += fmt::format(" {:>10}", name);
    for (std::size_t i = 0; i < each.sizes.size(); ++i) {
      out += fmt::format("\n  {:>9}", each.sizes[i]);
      for (const auto& [name, member] : kGrowthTimes) {
        const std::vector<double>& list = each.times.*member;
        out += fmt::format(" {:>10}", i < list.size() ? time_text(list[i]) : "");
      }
    }
    out += '\n';
  }
  return out;
}

std::string model_times_toml(const std::vector<ModelTimes>& all) {
  std::string out;
  for (const ModelTimes& each : all) {
    out += fmt::format("# {}\n[growth.times]\nmachine = \"{}\"\n", each.lesson, each.times.machine);
    for (const auto& [name, member] : kGrowthTimes) {
      std::vector<std::string> numbers;
      for (const double ns : each.times.*member) numbers.push_back(fmt::format("{:.0f}", ns));
      out += fmt::format("{} = [{}]\n", name, fmt::join(numbers, ", "));
    }
  }
  return out;
}

}  // namespace gjkscope
