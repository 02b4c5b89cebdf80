#include <fmt/format.h>

#include <algorithm>

#include "picture/scene.hpp"
#include "run/facts.hpp"
#include "subjects/run/direction_rules.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::blocks {
namespace {

using gjk::Phase;
using namespace rows;

bool weights_known(const PanelBuilder& panel) {
  return panel.knows.phase && *panel.knows.phase != Phase::add;
}

void scan_of(PanelBuilder& panel, const std::vector<gjk::ScanEntry<double>>& entries, bool of_x,
             double x0, double x1, const std::string& title) {
  const LessonShape& shape = of_x ? panel.run.lesson.x() : panel.run.lesson.y();
  const std::vector<std::string>& names = shape.vertex_names;
  constexpr int kShown = 6;
  if (entries.empty()) {  // nothing to see yet, and what stands below keeps its place
    const int count = static_cast<int>(names.size());
    panel.y += kRow + kTightRow * (std::min(count, kShown) + (count > kShown ? 1 : 0));
    return;
  }
  panel.write("heading", x0, title, type::kHeading);
  panel.y += kRow;
  int best = -1;
  for (const auto& entry : entries) {
    if (entry.improves) best = entry.index;
  }
  for (int i = 0; i < static_cast<int>(names.size()) && i < kShown; ++i) {
    // The scan of a large polygon does not look at every vertex.
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const auto& seen) { return seen.index == i; });
    const bool wins = i == best;
    // Once it is to be decided whether the winner is news: the vertices that are none.
    const bool in_simplex = panel.run.point_query() && panel.knows.phase_is(Phase::stop) &&
                            panel.knows.support && has_pair(panel.state.simplex, {0, i});
    panel.subject =
        of_x ? Subject{Subject::Kind::vertex_of_x, i} : Subject{Subject::Kind::vertex_of_y, -1, i};
    const bool strong = wins || in_simplex;
    panel.write(wins         ? "support.label"
                : in_simplex ? "simplex.label"
                             : "body",
                x0, names[i], strong ? type::kStrong : type::kBody);
    if (in_simplex) panel.write("simplex.label", x0 + 24.0, "in the simplex", type::kBody);
    panel.write(wins         ? "support.label"
                : in_simplex ? "simplex.label"
                             : "code",
                x1, entry == entries.end() ? "–" : panel.numbers(entry->value),
                strong ? type::kCodeBold : type::kCode, Align::right);
    panel.y += kTightRow;
  }
  panel.subject = {};
  if (names.size() > kShown) {
    panel.write("body.muted", x0, fmt::format("and {} more", names.size() - kShown), type::kBody);
    panel.y += kTightRow;
  }
}

void simplex(PanelBuilder& panel) {
  // A support point that is not in S stands below its vertices.
  const bool candidate = panel.knows.whole_support;
  panel.write("heading", panel.left, candidate ? "Simplex S, and V" : "Simplex S", type::kHeading);
  const double x0 = panel.left + 152.0;
  panel.write("heading", x0, "weight", type::kHeading);
  panel.y += kRow;
  const double name_at = panel.left + 24.0;
  const double middle = 0.5 * panel.fonts.cap_height(type::kStrong);
  int rows = 0;
  for (const int i : panel.words.order(panel.state.simplex.all())) {
    ++rows;
    panel.subject = subject_of(panel.run, panel.state.simplex.vertices[i].pair);
    if (panel.knows.phase == Phase::drop) panel.highlight("highlight.pass");  // what is kept
    panel.add("simplex.vertex", Disk{{panel.left + 8.0, panel.y - middle}, 5.0});
    panel.write("strong", name_at, panel.words.vertex(i), type::kStrong);
    const bool has_weight = weights_known(panel);
    const double weight = panel.state.simplex.weights[i];
    const std::string number = has_weight ? panel.numbers.weight(weight) : "–";
    const double number_width = std::max(62.0, panel.fonts.width(type::kCode, number));
    panel.bar(x0, panel.right - number_width - 16.0, 0.0, 1.0, has_weight ? weight : 0.0,
              "weight.bar");
    panel.write("code.current", panel.right, number, type::kCode, Align::right);
    panel.y += kRow;
  }
  if (panel.knows.phase == Phase::drop) {
    for (const auto& vertex : panel.run.step(panel.frame).record.dropped) {
      panel.subject = subject_of(panel.run, vertex.pair);
      panel.add("dropped", Disk{{panel.left + 8.0, panel.y - middle}, 5.0});
      panel.write("body.muted", name_at, panel.run.pair_name(vertex.pair), type::kStrong);
      panel.write("body.muted", x0, "dropped: weight 0", type::kBody);
      panel.y += kRow;
      ++rows;
    }
  }
  if (candidate) {
    panel.subject = subject_of(panel.run, panel.state.support.pair);
    panel.add("support", diamond({panel.left + 8.0, panel.y - middle}, 7.0));
    panel.write("support.label", name_at, panel.run.pair_name(panel.state.support.pair),
                type::kStrong);
    const bool known = panel.state.stop == gjk::StopReason::repeated_support;
    const bool decided = panel.knows.phase == Phase::stop;
    panel.write("support.label", x0,
                !decided                                       ? "V, support point"
                : known                                        ? "V is in S: stop"
                : panel.state.stop == gjk::StopReason::running ? "V is not in S"
                                                               : "V, support point",
                type::kBody);
    panel.y += kRow;
    ++rows;
  }
  panel.subject = {};
  // Blocks below keep their place while the simplex grows and shrinks.
  for (; rows < 4; ++rows) panel.y += kRow;
}

}  // namespace

const Block kSimplex{.name = "simplex",
                     .meaning = "the vertices of the simplex",
                     .write = simplex,
                     .shown_of = ShownOf::both};

namespace {

void scan(PanelBuilder& panel) {
  static const std::vector<gjk::ScanEntry<double>> none;
  const WideRecord* record = nullptr;
  if (panel.knows.phase == Phase::support) record = &panel.run.step(panel.frame).record;
  if (panel.knows.phase_is(Phase::stop) && panel.knows.support)
    record = &panel.run.run(panel.frame).trace.steps[panel.run.gjk_step(panel.frame) - 1].record;
  const double top = panel.y;
  if (panel.run.point_query()) {
    scan_of(panel, record ? record->scan_y : none, false, panel.left, panel.right,
            "Dot product with d");
    return;
  }
  const double middle = 0.5 * (panel.left + panel.right);
  // A support step in parts looks at one shape after the other.
  const SupportPart reached = support_part(panel.run, panel.frame).value_or(SupportPart::of_z);
  const bool knows_y = record && reached >= SupportPart::of_y;
  const bool knows_x = record && reached >= SupportPart::of_x;
  scan_of(panel, knows_y ? record->scan_y : none, false, panel.left, middle - 14.0, "dot(d, Y)");
  const double bottom = panel.y;
  panel.y = top;
  scan_of(panel, knows_x ? record->scan_x : none, true, middle + 14.0, panel.right, "dot(−d, X)");
  panel.y = std::max(panel.y, bottom);
}

}  // namespace

const Block kScan{.name = "scan",
                  .meaning = "the support scan: each vertex and its dot product",
                  .write = scan,
                  .shown_of = ShownOf::both};

namespace {

void bounds(PanelBuilder& panel) {
  panel.write("heading", panel.left, "Distance lies in", type::kHeading);
  const bool known = panel.run.gjk_step(panel.frame) >= 0;
  const DistanceBounds bounds = known ? panel.run.bounds(panel.frame) : DistanceBounds{};
  const double low = bounds.lower;
  const PositionedRun& positioned = panel.run.run(panel.frame);
  // An upper bound that is no more than what rounding may have done to a distance of 0 is shown as
  // 0.
  constexpr double kRounding = 1e-12;  // of the size of Y: far less than frames show
  double size = 0.0;
  for (const Eigen::Vector3d& vertex : positioned.y().world)
    size = std::max(size, (vertex - positioned.y().world[0]).norm());
  const double high = bounds.upper < kRounding * size ? 0.0 : bounds.upper;
  panel.write("code.current", panel.right,
              known ? fmt::format("[{}, {}]", panel.numbers(low), panel.numbers(high)) : "–",
              type::kCode, Align::right);
  panel.y += 22.0;
  const double first_high = known ? positioned.bounds.front().upper : 0.0;
  panel.add("bounds.track", Box{{{panel.left, panel.y - 8.0}, {panel.right, panel.y}}, 4.0});
  if (known && first_high > 0.0) {
    const auto at = [&](double v) {
      const double share = std::min(v / first_high, 1.0);
      return panel.left + share * (panel.right - panel.left);
    };
    double a = at(low);
    double b = at(high);
    if (b - a < 4.0) a = std::max(panel.left, 0.5 * (a + b) - 2.0), b = a + 4.0;
    panel.add("bounds.bar", Box{{{a, panel.y - 8.0}, {b, panel.y}}, 4.0});
    panel.y += 18.0;
    // The best of all support lines so far need not be the one that is drawn.
    const std::string line = panel.run.lesson.dimension == 3 ? "best plane" : "best line";
    constexpr double kBetween = 6.0;
    const double p_at = std::min(b, panel.right - 12.0);
    if (low > 0.0) {
      const double least = panel.left + panel.fonts.width(type::kTick, line);
      const double line_end = std::max(std::min(a, p_at) - kBetween, least);
      panel.write("body.muted", line_end, line, type::kTick, Align::right);
      panel.write("body.muted", std::max(p_at, line_end + 2.0 * kBetween), "P", type::kTick,
                  Align::center);
    } else {
      panel.write("body.muted", p_at, "P", type::kTick, Align::center);
    }
  } else {
    panel.y += 18.0;
  }
  panel.y += kRow;
}

}  // namespace

const Block kBounds{.name = "bounds",
                    .meaning = "lower and upper bound of the distance",
                    .write = bounds,
                    .shown_of = ShownOf::both};

namespace {

void direction_rules(PanelBuilder& panel) {
  panel.heading("Two ways to build d");
  const bool in_space = panel.run.lesson.dimension == 3;
  // Three coordinates have no room for all digits of a float.
  Lesson shown = panel.run.lesson;
  if (in_space) shown.scalar = ScalarKind::double_;
  const Numbers numbers(shown);
  const auto phase = panel.knows.phase;
  const bool built = panel.state.simplex.count == 2 &&
                     (phase == Phase::direction || phase == Phase::support || phase == Phase::stop);
  static const DirectionRules::Value none;
  const DirectionRules::Value& rules =
      built ? panel.effects.get<DirectionRules>(panel.frame) : none;
  const std::string edge = panel.state.simplex.count == 2
                               ? panel.words.vertex(1) + " − " + panel.words.vertex(0)
                               : "edge";
  for (const gjk::DirectionRule rule :
       {gjk::DirectionRule::towards_origin, gjk::DirectionRule::perpendicular}) {
    const bool towards = rule == gjk::DirectionRule::towards_origin;
    panel.write("strong", panel.left,
                towards    ? fmt::format("d = {} − P", query_name(panel.run))
                : in_space ? fmt::format("d = cross(e, cross(e, {} − {}))",
                                         built ? panel.words.vertex(0) : "A", query_name(panel.run))
                           : fmt::format("d = cross({}, z)", edge),
                type::kStrong);
    const bool used = panel.run.lesson.options.direction_rule == rule;
    panel.write("body.muted", panel.right, used ? "used by this run" : "for comparison",
                type::kTick, Align::right);
    panel.y += kRow;
    const auto found =
        std::find_if(rules.begin(), rules.end(), [&](const auto& b) { return b.rule == rule; });
    const bool known = found != rules.end();
    panel.write("code", panel.left + 12.0, "d", type::kCode);
    panel.write("code.current", panel.right, known ? numbers.point(found->d) : "–", type::kCode,
                Align::right);
    panel.y += kTightRow;
    if (in_space) {
      panel.write("body.muted", panel.left + 12.0, "from perpendicular", type::kBody);
    } else {
      panel.write("code", panel.left + 12.0, fmt::format("dot(d, {})", edge), type::kCode);
    }
    constexpr double kAlmost = 0.1;  // degrees: less cannot be seen
    const bool passes =
        known && (in_space ? found->degrees_off < kAlmost : found->dot_with_edge == 0.0);
    const std::string off = !known     ? "–"
                            : in_space ? fixed(found->degrees_off, 2) + "°"
                                       : panel.numbers(found->dot_with_edge);
    panel.write(passes  ? "pass"
                : known ? "fail"
                        : "code",
                panel.right, off, type::kCodeBold, Align::right);
    panel.y += in_space ? kRow + 6.0 : kTightRow;
    if (in_space) continue;
    panel.write("body.muted", panel.left + 12.0,
                !known                        ? ""
                : found->dot_with_edge == 0.0 ? "exactly perpendicular"
                                              : "no: u and v of P are rounded quotients",
                type::kBody);
    panel.y += kRow + 6.0;
  }
}

}  // namespace

const Block kDirectionRules{.name = "direction-rules",
                            .meaning = "both ways to build the search direction, side by side",
                            .write = direction_rules,
                            .shown_of = ShownOf::both};

}  // namespace gjkscope::blocks
