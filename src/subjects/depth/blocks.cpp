#include <fmt/format.h>

#include <algorithm>

#include "subjects/depth/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::depths {
namespace {

using blocks::LineView;
using depth::Phase;
using depth::StopReason;
using namespace rows;

/// Van den Bergen 2001, in the plane.
void depth_listing(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const depth::State<double>& state = shown.state;
  const auto write = [&](const std::string& text, std::optional<Phase> phase, bool current,
                         std::string value = {}) {
    // A phase is over when the frame's iteration has run it.
    const bool over =
        phase && shown.step != nullptr && !shown.is_answer && shown.step->phase > *phase;
    LineView line{current ? LineView::State::current
                  : over  ? LineView::State::past
                          : LineView::State::idle};
    if (current || over) line.value = std::move(value);
    if (phase) panel.subject = {Subject::Kind::phase, static_cast<int>(*phase)};
    blocks::write_line(panel, text, line);
    panel.subject = {};
    panel.y += kTightRow - kRow;
  };
  const bool has_stopped = shown.is(Phase::stop) && state.stop != StopReason::running;
  const bool repeated = state.stop == StopReason::repeated_support;
  const std::string v = shown.step != nullptr ? panel.run.pair_name(state.support.pair) : "";
  write("polygon ← GJK's last simplex", {}, shown.step == nullptr && state.polygon.count > 0);
  write("loop", {}, false);
  write("  e ← its edge nearest to O", Phase::nearest, shown.is(Phase::nearest),
        shown.step != nullptr ? ends(panel.run, state, state.edge) : "");
  write("  n ← normal of e", Phase::nearest, shown.is(Phase::nearest),
        panel.numbers.point(state.n));
  write("  V ← support point of Z along n", Phase::support, shown.is(Phase::support), v);
  write("  if V is an end of e: stop", Phase::stop,
        shown.is(Phase::stop) && (!has_stopped || repeated),
        has_stopped && repeated ? "yes" : "no");
  write("  if V is no farther than e: stop", Phase::stop,
        shown.is(Phase::stop) && (!has_stopped || !repeated),
        has_stopped && !repeated ? "yes" : "no");
  write("  put V between the ends of e", Phase::expand, shown.is(Phase::expand),
        fmt::format("{} edges", state.polygon.count));
  write("t ← e's nearest point", {}, shown.is_answer,
        panel.numbers.point(shown.trace.result.translation));
}

void edges(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const depth::State<double>& state = shown.state;
  panel.write("heading", panel.left, "Edges of the polygon", type::kHeading);
  panel.write("heading", panel.right, "distance from O", type::kHeading, Align::right);
  panel.y += kRow + 2.0;
  if (state.polygon.count == 0) {
    panel.write("body.muted", panel.left, "none: O lies outside of Z", type::kBody);
    panel.y += kRow;
    return;
  }
  constexpr std::size_t kMost = 7;
  std::vector<depth::Edge<double>> all = edges_in_order(state.polygon);
  // Around the polygon, in all frames from its oldest corner.
  std::rotate(all.begin(),
              std::min_element(all.begin(), all.end(),
                               [](const auto& a, const auto& b) { return a.from < b.from; }),
              all.end());
  for (std::size_t i = 0; i < std::min(all.size(), kMost); ++i) {
    const depth::Edge<double>& edge = all[i];
    const bool current = shown.is_nearest(edge);
    if (current) panel.highlight();
    const TextStyle style = current ? type::kCodeBold : type::kCode;
    const std::string role = current ? "code.current" : "code";
    panel.write(role, panel.left, ends(panel.run, state, edge), style);
    const std::optional<double> distance = shown.distance(edge);
    panel.write(distance ? role : "untried", panel.right, distance ? panel.numbers(*distance) : "–",
                style, Align::right);
    panel.y += kTightRow;
  }
  if (all.size() > kMost) {
    panel.write("body.muted", panel.left, fmt::format("and {} more", all.size() - kMost),
                type::kBody);
    panel.y += kRow;
  }
}

void bounds(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  panel.write("heading", panel.left, "Depth lies in", type::kHeading);
  const bool known = shown.step != nullptr;
  const double lower = shown.is_answer ? shown.trace.result.lower
                       : known         ? shown.step->bounds.lower
                                       : 0.0;
  const double upper = shown.is_answer ? shown.trace.result.upper
                       : known         ? shown.step->bounds.upper
                                       : 0.0;
  const bool has_upper = known && upper >= 0.0;
  std::string text = "–";
  if (known) {
    text = has_upper ? fmt::format("[{}, {}]", panel.numbers(lower), panel.numbers(upper))
                     : fmt::format("≥ {}", panel.numbers(lower));
  }
  panel.write("code.current", panel.right, text, type::kCode, Align::right);
  panel.y += 22.0;
  panel.add("bounds.track", Box{{{panel.left, panel.y - 8.0}, {panel.right, panel.y}}, 4.0});
  double largest = 0.0;
  for (const depth::Step<double>& step : shown.trace.steps) {
    if (step.phase == Phase::support) largest = std::max(largest, step.bounds.upper);
  }
  if (known && largest > 0.0) {
    const auto at = [&](double value) {
      return panel.left + std::clamp(value / largest, 0.0, 1.0) * (panel.right - panel.left);
    };
    double a = at(lower);
    double b = has_upper ? at(upper) : panel.right;
    constexpr double kThinnest = 4.0;
    if (b - a < kThinnest) {
      a = std::max(panel.left, 0.5 * (a + b) - 0.5 * kThinnest);
      b = a + kThinnest;
    }
    panel.add("bounds.bar", Box{{{a, panel.y - 8.0}, {b, panel.y}}, 4.0});
  }
  panel.y += kRow;
}

}  // namespace

const Block kEdges{.name = "depth-edges",
                   .meaning = "the edges of the expanding polygon and their distances from O",
                   .write = depths::edges,
                   .act = "depth"};

const Block kBounds{.name = "depth-bounds",
                    .meaning = "lower and upper bound of the penetration depth",
                    .write = depths::bounds,
                    .act = "depth"};

const Listing kListing{.name = "depth",
                       .meaning = "penetration depth, by an expanding polygon",
                       .write = depths::depth_listing,
                       .act = "depth"};

}  // namespace gjkscope::depths
