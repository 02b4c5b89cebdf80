#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "subjects/depth/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::depths {
namespace {

using blocks::LineView;
using depth::Phase;
using depth::StopReason;
using namespace rows;

/// A line of the listing, for a phase that a frame shows or that is over by then.
template <class S>
void phase_line(PanelBuilder& panel, const S& shown, const std::string& text,
                std::optional<Phase> phase, bool current, std::string value = {}) {
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
}

/// Van den Bergen 2001, in the plane.
void listing_in_plane(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const depth::State<double>& state = shown.state;
  const auto write = [&](const std::string& text, std::optional<Phase> phase, bool current,
                         std::string value = {}) {
    phase_line(panel, shown, text, phase, current, std::move(value));
  };
  const bool has_stopped = shown.has_stopped();
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
        panel.numbers.point(shown.result.translation));
}

/// The same in space.
void listing_in_space(PanelBuilder& panel) {
  const ShownInSpace& shown = shown_in<ShownInSpace>(panel);
  const auto write = [&](const std::string& text, std::optional<Phase> phase, bool current,
                         std::string value = {}) {
    phase_line(panel, shown, text, phase, current, std::move(value));
  };
  const bool expands = shown.step != nullptr && !shown.is_answer && !shown.has_stopped();
  const auto& seen = !expands                ? std::vector<int>{}
                     : shown.is(Phase::stop) ? std::next(shown.step)->record.outgrown
                                             : shown.step->record.outgrown;
  const auto count = [](std::size_t number, const char* of) {
    return fmt::format("{} {}{}", number, of, number == 1 ? "" : "s");
  };
  const bool goes_on = shown.is(Phase::stop) && !shown.has_stopped();
  write("polytope ← GJK's last simplex", {},
        shown.step == nullptr && !shown.polytope().faces.empty());
  write("loop", {}, false);
  write("  f ← its face nearest to O", Phase::nearest, shown.is(Phase::nearest),
        shown.step != nullptr ? face_name(shown.trace, shown.state.face) : "");
  write("  n ← normal of f", Phase::nearest, shown.is(Phase::nearest),
        panel.numbers.point(shown.state.n));
  write("  V ← support point of Z along n", Phase::support, shown.is(Phase::support),
        shown.step != nullptr ? panel.run.pair_name(shown.state.support.pair) : "");
  write("  if V is no farther than f: stop", Phase::stop, shown.is(Phase::stop),
        goes_on || shown.is(Phase::expand) ? "no" : "yes");
  write("  find the faces visible from V", Phase::stop, goes_on, std::to_string(seen.size()));
  write("  join V to their horizon", Phase::expand, shown.is(Phase::expand),
        shown.is(Phase::expand) ? count(shown.step->record.added.size(), "new face") : "");
  write("t ← foot on f", {}, shown.is_answer, panel.numbers.point(shown.result.translation));
}

void depth_listing(PanelBuilder& panel) {
  is_in_space(panel.run) ? listing_in_space(panel) : listing_in_plane(panel);
}

/// A row of a table of edges or faces.
void facet_row(PanelBuilder& panel, const std::string& name, const std::string& value,
               bool is_known, bool current) {
  if (current) panel.highlight();
  const TextStyle style = current ? type::kCodeBold : type::kCode;
  const std::string role = current ? "code.current" : "code";
  panel.write(role, panel.left, name, style);
  panel.write(is_known ? role : "untried", panel.right, value, style, Align::right);
  panel.y += kTightRow;
}

void more_rows(PanelBuilder& panel, std::size_t count) {
  panel.write("body.muted", panel.left, fmt::format("and {} more", count), type::kBody);
  panel.y += kRow;
}

void table_heading(PanelBuilder& panel, const std::string& name, const std::string& value) {
  panel.write("heading", panel.left, name, type::kHeading);
  panel.write("heading", panel.right, value, type::kHeading, Align::right);
  panel.y += kRow + 2.0;
}

void edges(PanelBuilder& panel) {
  const Shown& shown = shown_in<Shown>(panel);
  const depth::State<double>& state = shown.state;
  table_heading(panel, "Edges of the polygon", "distance from O");
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
    const std::optional<double> distance = shown.distance(all[i]);
    facet_row(panel, ends(panel.run, state, all[i]), distance ? panel.numbers(*distance) : "–",
              distance.has_value(), shown.is_nearest(all[i]));
  }
  if (all.size() > kMost) more_rows(panel, all.size() - kMost);
}

/// The faces, new ones first, then the nearest; where a stop test has failed those that are
/// visible.
void faces(PanelBuilder& panel) {
  const ShownInSpace& shown = shown_in<ShownInSpace>(panel);
  const bool tells_visible = shown.is(Phase::stop) && !shown.has_stopped();
  table_heading(panel, "Faces of the polytope",
                tells_visible ? "visible from V" : "distance from O");
  std::vector<int> all = shown.faces();
  if (all.empty()) {
    panel.write("body.muted", panel.left, "none: O lies outside of Z", type::kBody);
    panel.y += kRow;
    return;
  }
  const auto is_measured = [&](int face) { return shown.step != nullptr && !shown.is_new(face); };
  const auto key = [&](int face) {
    return tells_visible       ? (shown.is_visible(face) ? 0.0 : 1.0)
           : is_measured(face) ? shown.face(face).distance_sq
                               : -HUGE_VAL;
  };
  std::stable_sort(all.begin(), all.end(), [&](int a, int b) { return key(a) < key(b); });
  constexpr std::size_t kMost = 5;
  for (std::size_t i = 0; i < std::min(all.size(), kMost); ++i) {
    const int face = all[i];
    const double distance_sq = shown.face(face).distance_sq;
    std::string name = fmt::format("{:<4}", face_name(shown.trace, face));
    for (const int corner : shown.face(face).corners) {
      name += ' ';
      name += panel.run.pair_name(shown.polytope().corners[corner].pair);
    }
    const std::string value =
        tells_visible ? (shown.is_visible(face) ? "yes" : "no")
        : is_measured(face)
            ? panel.numbers(std::copysign(std::sqrt(std::abs(distance_sq)), distance_sq))
            : "–";
    facet_row(panel, name, value, tells_visible || is_measured(face),
              tells_visible ? shown.is_visible(face) : shown.is_nearest(face));
  }
  if (all.size() > kMost) more_rows(panel, all.size() - kMost);
}

template <class S>
void bounds_of(PanelBuilder& panel) {
  const S& shown = shown_in<S>(panel);
  panel.write("heading", panel.left, "Depth lies in", type::kHeading);
  const bool known = shown.step != nullptr;
  const double lower = shown.is_answer ? shown.result.lower
                       : known         ? shown.step->bounds.lower
                                       : 0.0;
  const double upper = shown.is_answer ? shown.result.upper
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
  for (const auto& step : shown.trace.steps) {
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

void bounds(PanelBuilder& panel) {
  is_in_space(panel.run) ? bounds_of<ShownInSpace>(panel) : bounds_of<Shown>(panel);
}

}  // namespace

const Block kEdges{.name = "depth-edges",
                   .meaning = "the edges of the expanding polygon and their distances from O",
                   .write = depths::edges,
                   .tour = "depth"};

const Block kFaces{
    .name = "depth-faces",
    .meaning = "in space: the faces of the expanding polytope and their distances from O",
    .write = depths::faces,
    .tour = "depth",
    .shown_of = ShownOf::space};

const Block kBounds{.name = "depth-bounds",
                    .meaning = "lower and upper bound of the penetration depth",
                    .write = depths::bounds,
                    .tour = "depth",
                    .shown_of = ShownOf::both};

const Listing kListing{.name = "depth",
                       .meaning = "penetration depth, by an expanding polygon or polytope",
                       .write = depths::depth_listing,
                       .tour = "depth",
                       .shown_of = ShownOf::both};

}  // namespace gjkscope::depths
