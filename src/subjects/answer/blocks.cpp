#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "subjects/answer/cold_start.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/answer/tour.hpp"
#include "subjects/growth/growth.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/round_shapes/round_shapes.hpp"
#include "subjects/support/touched_points.hpp"

namespace gjkscope::blocks {
namespace {

using rows::kRow;
using rows::kTightRow;

/// One of the three sums with the same weights: of differences, of vertices of Y, of those of X.
struct Sum {
  std::string heading;
  std::string name;
  bool is_known = false;
  bool is_current = false;
  Eigen::Vector3d value;
};

template <class NameOf, class PointOf>
void write_sum(PanelBuilder& panel, const Sum& sum, const NameOf& name_of,
               const PointOf& point_of) {
  const WideSimplex& simplex = panel.run.run(panel.frame).trace.result.simplex;
  const std::string role = sum.is_current ? "code.current" : sum.is_known ? "code" : "untried";
  const TextStyle style = sum.is_current ? type::kCodeBold : type::kCode;
  panel.write("heading", panel.left, sum.heading, type::kHeading);
  panel.y += kTightRow + 2.0;
  for (const int i : SimplexWords(panel.run, simplex).order(simplex.all())) {
    const WideVertex& vertex = simplex.vertices[i];
    panel.write(role, panel.left, panel.numbers.weight(simplex.weights[i]), style);
    panel.write(role, panel.left + 64.0, "· " + name_of(vertex.pair), style);
    if (sum.is_known)
      panel.write(role, panel.right, panel.numbers.point(point_of(vertex)), style, Align::right);
    panel.y += kTightRow;
  }
  panel.y += 3.0;
  if (sum.is_current) panel.highlight("highlight.pass");
  panel.write(role, panel.left + 64.0, sum.name, style);
  if (sum.is_known)
    panel.write(role, panel.right, panel.numbers.point(sum.value), style, Align::right);
  panel.y += kRow + 6.0;
}

/// Without the weights that give them.
void closest_points(PanelBuilder& panel, const WideResult& result) {
  panel.heading("The closest points");
  const auto row = [&](const std::string& name, const Eigen::Vector3d& point) {
    panel.write("code", panel.left, name, type::kCode);
    panel.write("code", panel.right, panel.numbers.point(point), type::kCode, Align::right);
    panel.y += kRow;
  };
  row("y", result.y);
  row("x", result.x);
  row("y − x = P", result.y - result.x);
  panel.y += 6.0;
}

void sums(PanelBuilder& panel, WitnessPart reached) {
  const PositionedRun& positioned = panel.run.run(panel.frame);
  const WideResult& result = positioned.trace.result;
  const auto sum = [&](std::string heading, std::string name, WitnessPart part,
                       const Eigen::Vector3d& value) {
    return Sum{std::move(heading), std::move(name), reached >= part, reached == part, value};
  };
  const Lesson& lesson = panel.run.lesson;
  write_sum(
      panel, sum("Weights of P", "P =", WitnessPart::p, result.y - result.x),
      [&](gjk::VertexPair pair) { return panel.run.pair_name(pair); },
      [](const auto& vertex) { return vertex.w; });
  write_sum(
      panel,
      sum(fmt::format("The same weights on {}", lesson.y().name), "y =", WitnessPart::on_y,
          result.y),
      [&](gjk::VertexPair pair) {
        return reached >= WitnessPart::on_y ? lesson.y().vertex_names[pair.y] : "?";
      },
      [&](const auto& vertex) { return positioned.y().world[vertex.pair.y]; });
  write_sum(
      panel,
      sum(fmt::format("The same weights on {}", lesson.x().name), "x =", WitnessPart::on_x,
          result.x),
      [&](gjk::VertexPair pair) {
        return reached >= WitnessPart::on_x ? lesson.x().vertex_names[pair.x] : "?";
      },
      [&](const auto& vertex) { return positioned.x().world[vertex.pair.x]; });
}

void witness(PanelBuilder& panel) {
  const std::optional<WitnessPart> part = witness_part(panel.run, panel.frame);
  const WitnessPart reached = part.value_or(WitnessPart::distance);
  const WideResult& result = panel.run.run(panel.frame).trace.result;
  part ? sums(panel, *part) : closest_points(panel, result);
  panel.write("heading", panel.left, "|y − x| = |P|", type::kHeading);
  panel.write(reached >= WitnessPart::distance ? "code.current" : "untried", panel.right,
              reached >= WitnessPart::distance ? panel.numbers(result.distance) : "–",
              type::kCodeBold, Align::right);
  panel.y += kRow;
  const RoundShapes::Value* round = RoundShapes::of(panel.effects, panel.run, panel.frame);
  if (round == nullptr) return;
  const bool is_known = reached >= WitnessPart::distance;
  panel.write("heading", panel.left, fmt::format("less the radii, {}", panel.numbers(round->radii)),
              type::kHeading);
  panel.write(is_known ? "code.current" : "untried", panel.right,
              is_known ? panel.numbers(round->distance) : "–", type::kCodeBold, Align::right);
  panel.y += kRow;
}

}  // namespace

const Block kWitness{
    .name = "witness",
    .meaning =
        "the closest points; with tour `witness` the weights on the differences, on "
        "the vertices of Y and on those of X",
    .write = witness};

namespace {

void counters(PanelBuilder& panel) {
  if (shown_size(panel.run, panel.frame)) return growth_counters(panel);
  const PositionedRun& positioned = panel.run.run(panel.frame);
  const int touched = static_cast<int>(panel.effects.get<TouchedPoints>(panel.frame).size());
  const int all = static_cast<int>(positioned.x().world.size() * positioned.y().world.size());
  const int calls = panel.knows.support_calls;
  panel.write("heading", panel.left, "Support calls so far", type::kHeading);
  panel.write("code.current", panel.right, std::to_string(calls), type::kCodeBold, Align::right);
  panel.y += kRow;
  panel.write("heading", panel.left, "Differences computed", type::kHeading);
  panel.write("code.current", panel.right, fmt::format("{} of {}", touched, all), type::kCodeBold,
              Align::right);
  panel.y += kRow - 3.0;
  panel.bar(panel.left, panel.right, 0.0, all, touched, "weight.bar");
  panel.y += kRow;
}

}  // namespace

const Block kCounters{.name = "counters",
                      .meaning = "iterations, support calls and differences computed so far",
                      .write = counters};

namespace {

void starts(PanelBuilder& panel) {
  const int now = panel.frame.run;
  std::vector<int> cold;
  std::vector<int> warm;
  int most = 1;
  for (int i = 0; i <= now; ++i) {
    cold.push_back(panel.effects.get<ColdStart>({.run = i}).iterations);
    warm.push_back(panel.run.runs[i].trace.result.iterations);
    most = std::max({most, cold.back(), warm.back()});
  }
  panel.heading("Iterations at each position");
  // The scale is that of the whole motion, so that bars keep their height from frame to frame.
  const int count = static_cast<int>(panel.run.runs.size());
  constexpr double kHeight = 112.0;
  constexpr int kFullScale = 6;  // iterations; more make the scale finer
  const int scale = std::max(kFullScale, most);
  const double top = panel.y - 8.0;
  const double bottom = top + kHeight;
  const double axis = panel.left + 18.0;
  for (int tick = 0; tick <= scale; tick += 2) {
    const double at = bottom - kHeight * tick / scale;
    panel.add("chart.grid", Polyline{{{axis, at}, {panel.right, at}}});
    panel.y = at + 4.0;
    panel.write("body.muted", axis - 6.0, std::to_string(tick), type::kTick, Align::right);
  }
  const double column = (panel.right - axis) / count;
  const double half = 0.5 * std::min(column - 2.0, 22.0);
  for (int i = 0; i <= now; ++i) {
    const double middle = axis + (i + 0.5) * column;
    const auto bar = [&](const std::string& role, double x0, double x1, int value) {
      panel.add(role, Box{{{x0, bottom - kHeight * value / scale}, {x1, bottom}}, 0.0});
    };
    bar("chart.cold", middle - half, middle, cold[i]);
    // The first run has no simplex to start from.
    bar(i == 0 ? "chart.cold" : "chart.warm", middle, middle + half, warm[i]);
  }
  panel.y = bottom + 30.0;
  const double cold_at = panel.right - 76.0;
  const double warm_at = panel.right;
  const auto swatch = [&](const std::string& role, double right, const std::string& text) {
    const double width = panel.fonts.width(type::kHeading, text);
    panel.add(role,
              Box{{{right - width - 18.0, panel.y - 11.0}, {right - width - 7.0, panel.y}}, 0.0});
    panel.write("heading", right, text, type::kHeading, Align::right);
  };
  swatch("chart.cold", cold_at, "cold");
  swatch("chart.warm", warm_at, "warm");
  panel.y += kRow;
  const auto row = [&](const std::string& text, int of_cold, int of_warm) {
    panel.write("body", panel.left, text, type::kBody);
    panel.write("code", cold_at, std::to_string(of_cold), type::kCode, Align::right);
    panel.write("code.current", warm_at, std::to_string(of_warm), type::kCodeBold, Align::right);
    panel.y += kTightRow + 1.0;
  };
  row("iterations here", cold.back(), warm.back());
  row("iterations so far", std::accumulate(cold.begin(), cold.end(), 0),
      std::accumulate(warm.begin(), warm.end(), 0));
}

}  // namespace

const Block kStarts{
    .name = "starts",
    .meaning = "cold start against warm start: iterations and support calls at each position",
    .write = starts};

namespace {

void bound_steps(PanelBuilder& panel) {
  const PositionedRun& positioned = panel.run.run(panel.frame);
  panel.heading("Bounds after each iteration");
  if (positioned.bounds.empty()) return;
  const double most = positioned.bounds.front().upper;
  const int iterations = positioned.trace.result.iterations;
  const double x0 = panel.left + 20.0;
  const double x1 = panel.right - 148.0;
  const int now = panel.run.gjk_step(panel.frame);
  int step = 0;
  constexpr int kShown = 8;
  for (int iteration = 1; iteration <= std::min(iterations, kShown); ++iteration) {
    const bool is_reached = now >= step;
    // The last step of this iteration that the frame knows.
    int last = step;
    const auto& steps = positioned.trace.steps;
    while (last + 1 < static_cast<int>(steps.size()) && last < now &&
           steps[static_cast<std::size_t>(last) + 1].iteration == iteration)
      ++last;
    const DistanceBounds& bounds = positioned.bounds[last];
    const double middle = panel.y - 5.0;
    panel.write(is_reached ? "strong" : "untried", panel.left, std::to_string(iteration),
                type::kStrong);
    panel.add("bounds.track", Box{{{x0, middle - 4.0}, {x1, middle + 4.0}}, 4.0});
    if (is_reached) {
      const auto at = [&](double value) {
        return x0 + (most > 0.0 ? std::min(value / most, 1.0) : 0.0) * (x1 - x0);
      };
      double low = at(bounds.lower);
      double high = at(bounds.upper);
      if (high - low < 4.0) low = std::max(x0, 0.5 * (low + high) - 2.0), high = low + 4.0;
      panel.add("bounds.bar", Box{{{low, middle - 4.0}, {high, middle + 4.0}}, 2.0});
      panel.write("code", panel.right,
                  fmt::format("{} … {}", fixed(bounds.lower, 3), fixed(bounds.upper, 3)),
                  type::kCode, Align::right);
    }
    while (step < static_cast<int>(steps.size()) && steps[step].iteration == iteration) ++step;
    panel.y += kRow + 2.0;
  }
}

}  // namespace

const Block kBoundSteps{.name = "bound-steps",
                        .meaning = "lower and upper bound of the distance after each iteration",
                        .write = bound_steps,
                        .shown_of = ShownOf::both};

}  // namespace gjkscope::blocks
