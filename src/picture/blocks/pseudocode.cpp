#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "effects/barycentric.hpp"
#include "picture/blocks/blocks.hpp"

namespace gjkscope::blocks {
namespace {

using namespace rows;
using fmt::format;
using gjk::Phase;

/// One line of a listing: its text, and which phase or region test it stands for.
struct CodeLine {
  std::string_view text;
  std::optional<gjk::Phase> phase;
  std::optional<gjk::Face> region;  ///< Set: the line that tests this region, or takes it.
  bool takes = false;               ///< The line that is reached when the test holds.
};

const std::vector<CodeLine>& code_of(Listing listing) {
  static const std::vector<CodeLine> none;
  static const std::vector<CodeLine> segment = {
      {"input: A, B, Q", {}, {}, false},
      {"compute u and v", Phase::closest, {}, false},
      {"if u ≤ 0", {}, gjk::Face{0b10}, false},
      {"  P ← B", {}, gjk::Face{0b10}, true},
      {"else if v ≤ 0", {}, gjk::Face{0b01}, false},
      {"  P ← A", {}, gjk::Face{0b01}, true},
      {"else", {}, gjk::Face{0b11}, false},
      {"  P ← u A + v B", {}, gjk::Face{0b11}, true},
  };
  static const std::vector<CodeLine> triangle = {
      {"compute uAB, vAB, uBC, vBC, uCA, vCA", Phase::closest, {}, false},
      {"compute uABC, vABC, wABC", Phase::closest, {}, false},
      {"if vAB ≤ 0 and uCA ≤ 0:  P ← A", {}, gjk::Face{0b001}, false},
      {"if uAB ≤ 0 and vBC ≤ 0:  P ← B", {}, gjk::Face{0b010}, false},
      {"if uBC ≤ 0 and vCA ≤ 0:  P ← C", {}, gjk::Face{0b100}, false},
      {"if u, v > 0, wABC ≤ 0:  P on AB", {}, gjk::Face{0b011}, false},
      {"if u, v > 0, uABC ≤ 0:  P on BC", {}, gjk::Face{0b110}, false},
      {"if u, v > 0, vABC ≤ 0:  P on CA", {}, gjk::Face{0b101}, false},
      {"else:  P ← Q", {}, gjk::Face{0b111}, false},
  };
  static const std::vector<CodeLine> gjk_point = {
      {"S ← any vertex", {}, {}, false},
      {"loop", {}, {}, false},
      {"  P ← closest point to Q on S", Phase::closest, {}, false},
      {"  drop vertices without weight", Phase::cull, {}, false},
      {"  d ← direction from P to Q", Phase::direction, {}, false},
      {"  w ← support point along d", Phase::support, {}, false},
      {"  if w in S: stop", Phase::stop, {}, false},
      {"  add w to S", Phase::add, {}, false},
  };
  static const std::vector<CodeLine> gjk = {
      {"S ← any vertex", {}, {}, false},
      {"loop", {}, {}, false},
      {"  P ← closest point to O on S", Phase::closest, {}, false},
      {"  drop vertices without weight", Phase::cull, {}, false},
      {"  d ← from P towards O", Phase::direction, {}, false},
      {"  w ← support(Y, d) − support(X, −d)", Phase::support, {}, false},
      {"  if w in S: stop", Phase::stop, {}, false},
      {"  add w to S", Phase::add, {}, false},
  };
  switch (listing) {
    case Listing::none:
      return none;
    case Listing::segment:
      return segment;
    case Listing::triangle:
      return triangle;
    case Listing::gjk_point:
      return gjk_point;
    case Listing::gjk:
      return gjk;
  }
  return none;
}

enum class LineState { idle, current, past, crossed };

LineState line_state(const PanelBuilder& panel, const CodeLine& line, int index) {
  if (panel.frame.step < 0) return index == 0 ? LineState::current : LineState::idle;
  if (!line.region) {
    if (panel.gradual()) {
      if (line.phase && panel.frame.detail < 0) return LineState::current;
      return line.phase ? LineState::past : LineState::idle;
    }
    return line.phase == panel.phase() ? LineState::current : LineState::idle;
  }
  const auto& tried = panel.region_tests();
  for (int i = 0; i <= panel.tests_reached(); ++i) {
    if (tried[i].region != *line.region) continue;
    const bool reached = i == panel.tests_reached();
    if (line.takes) return tried[i].holds ? LineState::current : LineState::idle;
    return reached ? LineState::current : LineState::crossed;
  }
  return LineState::idle;
}

/// What this line computed, at this step; nothing for lines that are not current or were not
/// reached.
std::string line_value(const PanelBuilder& panel, const CodeLine& line, LineState line_state) {
  const bool point_query = panel.run.point_query();
  if (panel.run.lesson.listing == Listing::segment && line_state != LineState::idle) {
    if (line.region && !line.takes) {
      for (const auto& test : panel.region_tests()) {
        if (test.region == *line.region && gjk::vertex_count(test.region) == 1)
          return panel.test_values(test);
      }
    }
    if (line.phase) {
      const auto& value = panel.effects.get<BarycentricWeights>(panel.frame);
      if (value.weights.size() == 2)
        return format("{}, {}", panel.numbers.weight(value.weights[0]),
                      panel.numbers.weight(value.weights[1]));
    }
    return {};
  }
  if (panel.run.lesson.listing == Listing::triangle && line.region) {
    for (int i = 0; i <= panel.tests_reached(); ++i) {
      if (panel.region_tests()[i].region == *line.region)
        return panel.test_values(panel.region_tests()[i]);
    }
    return {};
  }
  if (line_state != LineState::current || !point_query) return {};
  if (!panel.phase()) return panel.words.face(panel.state.simplex.all());
  switch (*panel.phase()) {
    case Phase::closest:
      return panel.numbers.point(panel.state.p + panel.run.run(panel.frame).x_world[0]);
    case Phase::cull: {
      std::string dropped;
      for (const auto& vertex : panel.run.step(panel.frame).record.dropped)
        dropped += panel.run.pair_name(vertex.pair);
      return dropped.empty() ? "none" : dropped;
    }
    case Phase::direction:
      return panel.numbers.point(panel.state.d);
    case Phase::support:
      return panel.run.pair_name(panel.state.support.pair);
    case Phase::stop:
      return panel.state.stop == gjk::StopReason::running ? "no" : "yes";
    case Phase::add:
      return panel.words.face(panel.state.simplex.all());
  }
  return {};
}

}  // namespace

void pseudocode(PanelBuilder& panel) {
  const std::vector<CodeLine>& lines = code_of(panel.run.lesson.listing);
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    const CodeLine& line = lines[i];
    const LineState now = line_state(panel, line, i);
    const bool current = now == LineState::current;
    if (current) panel.highlight();
    const std::string role = current                     ? "code.current"
                             : now == LineState::crossed ? "code.muted"
                                                         : "code";
    const std::size_t indent = line.text.find_first_not_of(' ');
    panel.write(role, panel.left + 10.0 * static_cast<double>(indent),
                std::string(line.text.substr(indent)), current ? type::kCodeBold : type::kCode);
    const std::string value = line_value(panel, line, now);
    if (!value.empty())
      panel.write(current ? "code.value" : "code.muted", panel.right, value,
                  current ? type::kCodeBold : type::kCode, Align::right);
    if (now == LineState::crossed && value.empty())
      panel.write("fail", panel.right, "✗", type::kCode, Align::right);
    panel.y += kRow;
  }
}

}  // namespace gjkscope::blocks
