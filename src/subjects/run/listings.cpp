#include <fmt/format.h>

#include <optional>

#include "subjects/run/subject.hpp"
#include "subjects/subjects.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope::blocks {
namespace {

constexpr int kFewestCharacters = 8;

/// One character less, and a sign that there were more.
std::string shortened(std::string words) {
  constexpr std::string_view kMore = "…";
  if (words.ends_with(kMore)) words.resize(words.size() - kMore.size());
  while (!words.empty() && !starts_character(words.back())) words.pop_back();
  words.pop_back();
  while (words.ends_with(' ')) words.pop_back();
  return words + std::string(kMore);
}

}  // namespace

void write_line(PanelBuilder& panel, const std::string& text, const LineView& line) {
  const bool current = line.state == LineView::State::current;
  if (current) panel.highlight();
  const std::string role = current                                   ? "code.current"
                           : line.state == LineView::State::untried  ? "untried"
                           : line.state == LineView::State::rejected ? "code.muted"
                                                                     : "code";
  const TextStyle style = current ? type::kCodeBold : type::kCode;
  const std::size_t indent = text.find_first_not_of(' ');
  const double at = panel.left + 10.0 * static_cast<double>(indent);
  std::string words = text.substr(indent);
  // The listing is the same all the time, the value is not: where both do not fit, words give way.
  constexpr double kSpace = 10.0;
  constexpr double kVerdict = 20.0;
  const double right = panel.right - (line.verdict ? kVerdict : 0.0);
  const double room = right - at - panel.fonts.width(style, line.value) - kSpace;
  if (!line.value.empty()) {
    while (panel.fonts.width(style, words) > room && character_count(words) > kFewestCharacters)
      words = shortened(std::move(words));
  }
  panel.write(role, at, words, style);
  if (line.verdict) {
    panel.write(*line.verdict ? "pass" : "fail", panel.right, *line.verdict ? "✓" : "✗", style,
                Align::right);
  }
  if (!line.value.empty() && panel.fonts.width(style, words) <= room)
    panel.write(current ? "code.value" : "code.muted", right, line.value, style, Align::right);
  panel.y += rows::kRow;
}

void listing_line(PanelBuilder& panel, const std::string& text, bool current, std::string value) {
  LineView line{current ? LineView::State::current : LineView::State::idle};
  if (current) line.value = std::move(value);
  write_line(panel, text, line);
  panel.y += rows::kTightRow - rows::kRow;
}

namespace {

using State = LineView::State;

using namespace rows;
using gjk::Phase;

/// One line of a listing: its text, and what of the run it stands for.
struct CodeLine {
  std::string text;
  std::optional<Phase> phase = {};
  std::optional<gjk::Face> region = {};   ///< Set: the line that tests this region, or takes it.
  bool takes = false;                     ///< The line that is reached when the test holds.
  std::optional<Phase> stops_after = {};  ///< Set: the stop tests that follow this phase.
};

using Lines = std::vector<CodeLine>;

/// Catto 2010, slides "Closet point algorithm" (sic) and "Implementation" to "Testing the interior
/// region".
const Lines& segment_lines() {
  static const Lines lines = {
      {"input: A, B, Q"},
      {"compute u and v", Phase::closest},
      {"if u ≤ 0", {}, gjk::Face{0b10}},
      {"  P ← B", {}, gjk::Face{0b10}, true},
      {"else if v ≤ 0", {}, gjk::Face{0b01}},
      {"  P ← A", {}, gjk::Face{0b01}, true},
      {"else", {}, gjk::Face{0b11}},
      {"  P ← u A + v B", {}, gjk::Face{0b11}, true},
  };
  return lines;
}
const Lines& triangle_lines() {
  static const Lines lines = {
      {"compute uAB, vAB, uBC, vBC, uCA, vCA", Phase::closest},
      {"compute uABC, vABC, wABC", Phase::closest},
      {"if vAB ≤ 0 and uCA ≤ 0:  P ← A", {}, gjk::Face{0b001}},
      {"if uAB ≤ 0 and vBC ≤ 0:  P ← B", {}, gjk::Face{0b010}},
      {"if uBC ≤ 0 and vCA ≤ 0:  P ← C", {}, gjk::Face{0b100}},
      {"if u, v > 0, wABC ≤ 0:  P on AB", {}, gjk::Face{0b011}},
      {"if u, v > 0, uABC ≤ 0:  P on BC", {}, gjk::Face{0b110}},
      {"if u, v > 0, vABC ≤ 0:  P on CA", {}, gjk::Face{0b101}},
      {"else: assert u, v, w > 0;  P ← Q", {}, gjk::Face{0b111}},
  };
  return lines;
}

/// Catto 2010, slide "GJK algorithm", with the conditions of the slides on termination where they
/// are tested, as far as the lesson's options ask for them.
Lines gjk_lines(const LessonRun& run) {
  const std::string q = query_name(run);
  const bool point = run.point_query();
  const bool progress = run.lesson.options.stop_on_no_progress;
  const bool repeated = run.lesson.options.stop_on_repeated_support;
  std::string last = repeated ? "V in S" : "";
  if (progress) last += repeated ? " or no farther" : "V no farther than S";
  Lines lines = {
      {"S ← initial simplex"},
      {"loop"},
      {point ? fmt::format("  P ← closest to {} on S", q) : "  P ← closest point on S",
       Phase::closest},
      {"  drop vertices without weight", Phase::drop},
      {fmt::format("  if {} in S{}: stop", q, progress ? " or P no closer" : ""),
       {},
       {},
       false,
       Phase::drop},
      {fmt::format("  d ← normal of S, to {}", q), Phase::direction},
      {"  if d = 0: stop", {}, {}, false, Phase::direction},
      {point ? "  V ← support point along d" : "  V ← support(Y,d) − support(X,−d)",
       Phase::support},
  };
  if (!last.empty())
    lines.push_back({fmt::format("  if {}: stop", last), {}, {}, false, Phase::support});
  lines.push_back({"  add V to S", Phase::add});
  return lines;
}

// Region tests
// ---------------------------------------------------------------------------------------------------

/// A line of a chain of region tests. `has_takes`: other lines say what follows from a test.
LineView region_line(const PanelBuilder& panel, const CodeLine& line, bool has_takes) {
  if (panel.run.gjk_step(panel.frame) < 0) return {};
  const auto& tests = panel.knows.region_tests;
  for (int i = 0; i <= panel.knows.tests_reached; ++i) {
    if (tests[i].region != *line.region) continue;
    const bool holds = tests[i].holds;
    if (line.takes) {
      if (!holds) return {State::untried};
      const Eigen::Vector3d p = panel.state.p + panel.run.run(panel.frame).x().world[0];
      return {State::current, {}, panel.numbers.point(p, 3)};
    }
    const bool reached = i == panel.knows.tests_reached && !(holds && has_takes);
    std::string value;
    const bool is_else = gjk::vertex_count(line.region.value()) == panel.state.simplex.count;
    if (!is_else) value = panel.test_values(tests[i]);
    return {reached ? State::current : holds ? State::past : State::rejected, holds, value};
  }
  return {State::untried};
}

LineView weights_line(const PanelBuilder& panel) {
  if (panel.run.gjk_step(panel.frame) < 0) return {};
  LineView line{panel.knows.gradual && panel.knows.tests_reached < 0 ? State::current
                                                                     : State::past};
  const auto& value = panel.effects.get<BarycentricWeights>(panel.frame);
  if (panel.run.lesson.listing == "segment" && value.weights.size() == 2) {
    line.value = fmt::format("{}, {}", panel.numbers.weight(value.weights[0]),
                             panel.numbers.weight(value.weights[1]));
  }
  return line;
}

void region_chain(PanelBuilder& panel, const Lines& lines, bool has_takes) {
  for (const CodeLine& line : lines) {
    if (line.region) {
      write_line(panel, line.text, region_line(panel, line, has_takes));
    } else if (line.phase) {
      write_line(panel, line.text, weights_line(panel));
    } else {
      write_line(panel, line.text,
                 {panel.run.gjk_step(panel.frame) < 0 ? State::current : State::idle, {}, {}});
    }
  }
}

// The loop
// ---------------------------------------------------------------------------------------------------

/// The value that a step left beside its line.
std::string value_of(const PanelBuilder& panel, const WideStep& step) {
  const WideState& after = step.after;
  switch (step.phase) {
    case Phase::closest: {
      const bool point = panel.run.point_query();
      return panel.numbers.point(
          point ? Eigen::Vector3d(after.p + panel.run.run(panel.frame).x().world[0]) : after.p);
    }
    case Phase::drop: {
      std::string dropped;
      for (const auto& vertex : step.record.dropped) {
        if (!dropped.empty()) dropped += " ";
        dropped += panel.run.pair_name(vertex.pair);
      }
      return dropped.empty() ? "none" : dropped;
    }
    case Phase::direction:
      return panel.numbers.point(after.d);
    case Phase::support:
      return panel.run.pair_name(after.support.pair);
    case Phase::stop:
      return after.stop == gjk::StopReason::running ? "no" : "yes";
    case Phase::add:
      return SimplexWords(panel.run, after.simplex).face(after.simplex.all());
  }
  return {};
}

/// The steps of the frame's iteration up to the frame's, by phase; null for phases to come.
std::array<const WideStep*, gjk::kPhaseCount> steps_so_far(const PanelBuilder& panel) {
  std::array<const WideStep*, gjk::kPhaseCount> steps = {};
  const auto& all = panel.run.run(panel.frame).trace.steps;
  const int now = panel.run.gjk_step(panel.frame);
  for (int i = 0; i <= now; ++i) {
    if (all[i].iteration == all[now].iteration)
      steps[static_cast<std::size_t>(all[i].phase)] = &all[i];
  }
  return steps;
}

void loop(PanelBuilder& panel) {
  const auto steps = steps_so_far(panel);
  const auto step_of = [&](Phase phase) { return steps[static_cast<std::size_t>(phase)]; };
  const WideStep* stop = step_of(Phase::stop);
  bool first = true;
  // Ten lines leave room for two more blocks when they stand closer than others.
  for (const CodeLine& line : gjk_lines(panel.run)) {
    LineView view;
    if (first && panel.run.gjk_step(panel.frame) < 0) {
      view = {State::current, {}, panel.words.face(panel.state.simplex.all())};
    } else if (line.phase && step_of(*line.phase)) {
      const WideStep& step = *step_of(*line.phase);
      view = {panel.knows.phase == line.phase ? State::current : State::past,
              {},
              value_of(panel, step)};
    } else if (line.stops_after) {
      // The run goes on to the next phase where these tests do not hold; one stop phase stands for
      // all of them.
      const Phase next = static_cast<Phase>(static_cast<int>(*line.stops_after) + 1);
      if (stop && !step_of(next == Phase::stop ? Phase::add : next) && step_of(*line.stops_after)) {
        view = {State::current, {}, value_of(panel, *stop)};
      } else if (step_of(next) && step_of(*line.stops_after)) {
        // The frame of the phase that follows is the one in which they failed.
        view = {panel.knows.phase == next ? State::current : State::past, {}, "no"};
      }
    }
    const std::optional<Phase> phase = line.stops_after ? Phase::stop : line.phase;
    if (phase) panel.subject = {Subject::Kind::phase, static_cast<int>(*phase)};
    write_line(panel, line.text, view);
    panel.subject = {};
    panel.y += rows::kTightRow - rows::kRow;
    first = false;
  }
}

// Other listings
// ---------------------------------------------------------------------------------------------------

/// Catto 2010, slide "Support point code".
void support_listing(PanelBuilder& panel) {
  const bool current = panel.knows.phase == Phase::support;
  const bool known = panel.knows.whole_support;
  const State state = current ? State::current : State::idle;
  const std::string best = known ? panel.run.pair_name(panel.state.support.pair) : std::string();
  const auto& names = panel.run.lesson.y().vertex_names;
  write_line(panel, "input: polygon, d",
             {known ? State::past : State::idle,
              {},
              known ? panel.numbers.point(panel.state.d) : std::string()});
  write_line(panel, "V ← first vertex", {state, {}, current ? names[0] : std::string()});
  write_line(panel, "for each other vertex p",
             {state, {}, current ? fmt::format("{} of them", names.size() - 1) : std::string()});
  write_line(panel, "  if dot(d, p) > dot(d, V): V ← p", {state, {}, {}});
  write_line(panel, "return V", {state, {}, best});
}

/// Catto 2010, slides "If all else fails", "Polygon structure" and on those of the simplex. The
/// vertex is the newest of the simplex.
void structures_listing(PanelBuilder& panel) {
  const WideSimplex& simplex = panel.state.simplex;
  const int newest = simplex.count - 1;
  const WideVertex& vertex = simplex.vertices[newest];
  const Eigen::Vector3d point = vertex.w + panel.run.run(panel.frame).x().world[0];
  const bool weighed = panel.knows.phase && *panel.knows.phase != Phase::add;
  const LessonShape& polygon = panel.run.lesson.y();
  write_line(panel, "Input", {State::past, {}, polygon.name + ", Q"});
  write_line(panel, "Output", {State::past, {}, "P, |P − Q|, iterations"});
  write_line(panel, "Polygon: points, count",
             {State::past, {}, fmt::format("{}, {}", polygon.name, polygon.vertices.size())});
  write_line(panel, "SimplexVertex", {State::past, {}, panel.words.vertex(newest)});
  write_line(panel, "  point: where it is", {State::idle, {}, panel.numbers.point(point)});
  write_line(panel, "  index: which vertex, from 0",
             {State::idle, {}, std::to_string(vertex.pair.y)});
  write_line(panel, "  u: its weight in P",
             {State::idle, {}, weighed ? panel.numbers.weight(simplex.weights[newest]) : "–"});
  write_line(panel, "Simplex", {State::past, {}, "S"});
  write_line(panel, "  vertices: 1, 2 or 3", {State::current, {}, panel.words.face(simplex.all())});
  write_line(
      panel, "  count",
      {State::current, {}, fmt::format("{}, a {}-simplex", simplex.count, simplex.count - 1)});
}

void segment_listing(PanelBuilder& panel) { region_chain(panel, segment_lines(), true); }
void triangle_listing(PanelBuilder& panel) { region_chain(panel, triangle_lines(), false); }

void pseudocode(PanelBuilder& panel) {
  for (const Listing* listing : registered_listings()) {
    if (listing->name == panel.run.lesson.listing) listing->write(panel);
  }
}

}  // namespace

const Block kPseudocode{.name = "pseudocode",
                        .meaning = "a listing with the current line marked",
                        .write = pseudocode,
                        .takes_listing = true,
                        .shown_of = ShownOf::both};

}  // namespace gjkscope::blocks

namespace gjkscope::listings {

using namespace blocks;

const Listing kSegment{.name = "segment", .meaning = "point to segment", .write = segment_listing};
const Listing kTriangle{
    .name = "triangle", .meaning = "point to triangle", .write = triangle_listing};
const Listing kStructures{.name = "structures",
                          .meaning = "what a simplex is stored as",
                          .write = structures_listing,
                          .tour = "phase"};
const Listing kSupport{
    .name = "support", .meaning = "support point of a polygon", .write = support_listing};
const Listing kGjkPoint{.name = "gjk-point",
                        .meaning = "point to convex polygon, or polyhedron",
                        .write = loop,
                        .shown_of = ShownOf::both};

const Listing kGjk{.name = "gjk",
                   .meaning = "convex polygon to convex polygon, or polyhedron to polyhedron",
                   .write = loop,
                   .shown_of = ShownOf::both};

}  // namespace gjkscope::listings
