#include "picture/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "effects/barycentric.hpp"
#include "effects/direction_rules.hpp"
#include "lesson/names.hpp"
#include "picture/words.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using fmt::format;

constexpr double kPad = 16.0;  // card edge to text
constexpr double kRow = 23.0;  // base line to base line
constexpr double kTightRow = 20.0;
constexpr double kBlockGap = 15.0;  // around the rule between blocks

constexpr std::array<std::string_view, 3> kLetters = {"u", "v", "w"};

/// One line of a listing: its text, and which phase or region test it stands for.
struct CodeLine {
  std::string_view text;
  std::optional<gjk::Phase> phase;
  std::optional<gjk::Face> region;  ///< Set: the line that tests this region, or takes it.
  bool takes = false;               ///< The line that is reached when the test holds.
};

using gjk::Phase;
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
      {"if wABC ≤ 0:  P ← on AB", {}, gjk::Face{0b011}, false},
      {"if uABC ≤ 0:  P ← on BC", {}, gjk::Face{0b110}, false},
      {"if vABC ≤ 0:  P ← on CA", {}, gjk::Face{0b101}, false},
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

/// Writes blocks downwards from the top of a card.
class PanelBuilder {
 public:
  PanelBuilder(const LessonRun& run, EffectGraph& effects, const Frame& frame, const Fonts& fonts,
               const Rect& card)
      : run_(run),
        effects_(effects),
        frame_(frame),
        fonts_(fonts),
        state_(run.state(frame)),
        numbers_(run.lesson),
        words_(run, state_.simplex),
        left_(card.min.x() + kPad),
        right_(card.max.x() - kPad),
        y_(card.min.y() + 30.0) {}

  std::vector<Mark> build() {
    bool first = true;
    for (const PanelBlock kind : run_.lesson.panel) {
      if (!first) rule();
      first = false;
      block(kind);
    }
    return std::move(marks_);
  }

 private:
  // Writing
  // --------------------------------------------------------------------------------------------------------

  void add(std::string role, decltype(Mark::shape) shape) {
    marks_.push_back({std::move(role), std::move(shape)});
  }
  void write(std::string role, double x, std::string text, const TextStyle& style,
             Align align = Align::left) {
    add(std::move(role), Text{{x, y_}, std::move(text), style, align});
  }
  void heading(std::string text) {
    write("heading", left_, std::move(text), type::kHeading);
    y_ += kRow + 2.0;
  }
  void rule() {
    y_ += kBlockGap - kRow + 2.0;
    add("card.rule", Polyline{{{left_, y_}, {right_, y_}}});
    y_ += kBlockGap + 9.0;
  }
  /// A box behind the current row.
  void highlight(const std::string& role = "highlight") {
    const double rise = fonts_.cap_height(type::kCode);
    add(role, Box{{{left_ - 8.0, y_ - rise - 6.5}, {right_ + 8.0, y_ + 6.5}}, 5.0});
  }
  /// A bar from zero, on a track from `low` to `high`.
  void bar(double x0, double x1, double low, double high, double value, const std::string& role) {
    const double middle = y_ - 0.5 * fonts_.cap_height(type::kBody);
    const auto at = [&](double v) {
      return x0 + (std::clamp(v, low, high) - low) / (high - low) * (x1 - x0);
    };
    add("weight.track", Box{{{x0, middle - 6.0}, {x1, middle + 6.0}}, 3.0});
    if (std::abs(at(value) - at(0.0)) >= 1.0) {
      add(role, Box{{{std::min(at(0.0), at(value)), middle - 6.0},
                     {std::max(at(0.0), at(value)), middle + 6.0}},
                    2.0});
    }
    if (low < 0.0) add("weight.axis", Polyline{{{at(0.0), middle - 9.0}, {at(0.0), middle + 9.0}}});
  }

  // The step
  // -------------------------------------------------------------------------------------------------------

  std::optional<Phase> phase() const {
    return frame_.step < 0 ? std::nullopt : std::optional(run_.step(frame_).phase);
  }
  bool gradual() const { return run_.lesson.granularity == Granularity::test; }
  const std::vector<gjk::RegionTest<double>>& region_tests() const {
    static const std::vector<gjk::RegionTest<double>> none;
    return phase() == Phase::closest ? run_.step(frame_).record.region_tests : none;
  }
  int tests_reached() const {
    return gradual() ? frame_.detail : static_cast<int>(region_tests().size()) - 1;
  }
  bool stop_follows_support() const {
    return phase() == Phase::stop && frame_.step > 0 &&
           run_.run(frame_).trace.steps[frame_.step - 1].phase == Phase::support;
  }
  bool knows_support() const { return phase() == Phase::support || stop_follows_support(); }

  void block(PanelBlock kind) {
    switch (kind) {
      case PanelBlock::pseudocode:
        return pseudocode();
      case PanelBlock::tests:
        return tests();
      case PanelBlock::regions:
        return regions();
      case PanelBlock::weights:
        return weights();
      case PanelBlock::linear_system:
        return linear_system();
      case PanelBlock::simplex:
        return simplex();
      case PanelBlock::scan:
        return scan();
      case PanelBlock::bounds:
        return bounds();
      case PanelBlock::pairs:
        return pairs();
      case PanelBlock::direction_rules:
        return direction_rules();
    }
  }

  // Pseudocode
  // -----------------------------------------------------------------------------------------------------

  enum class LineState { idle, current, past, crossed };

  LineState line_state(const CodeLine& line, int index) const {
    if (frame_.step < 0) return index == 0 ? LineState::current : LineState::idle;
    if (!line.region) {
      if (gradual()) {
        if (line.phase && frame_.detail < 0) return LineState::current;
        return line.phase ? LineState::past : LineState::idle;
      }
      return line.phase == phase() ? LineState::current : LineState::idle;
    }
    const auto& tried = region_tests();
    for (int i = 0; i <= tests_reached(); ++i) {
      if (tried[i].region != *line.region) continue;
      const bool reached = i == tests_reached();
      if (line.takes) return tried[i].holds ? LineState::current : LineState::idle;
      return reached ? LineState::current : LineState::crossed;
    }
    return LineState::idle;
  }

  /// What this line computed, at this step; nothing for lines that are not current or were not
  /// reached.
  std::string line_value(const CodeLine& line, LineState line_state) const {
    const bool point_query = run_.point_query();
    if (run_.lesson.listing == Listing::segment && line_state != LineState::idle) {
      if (line.region && !line.takes) {
        for (const auto& test : region_tests()) {
          if (test.region == *line.region && gjk::vertex_count(test.region) == 1)
            return test_values(test);
        }
      }
      if (line.phase) {
        const auto& value = effects_.get<BarycentricWeights>(frame_);
        if (value.weights.size() == 2)
          return format("{}, {}", numbers_.weight(value.weights[0]),
                        numbers_.weight(value.weights[1]));
      }
      return {};
    }
    if (run_.lesson.listing == Listing::triangle && line.region) {
      for (int i = 0; i <= tests_reached(); ++i) {
        if (region_tests()[i].region == *line.region) return test_values(region_tests()[i]);
      }
      return {};
    }
    if (line_state != LineState::current || !point_query) return {};
    if (!phase()) return words_.face(state_.simplex.all());
    switch (*phase()) {
      case Phase::closest:
        return numbers_.point(state_.p + run_.run(frame_).x_world[0]);
      case Phase::cull: {
        std::string dropped;
        for (const auto& vertex : run_.step(frame_).record.dropped)
          dropped += run_.pair_name(vertex.pair);
        return dropped.empty() ? "none" : dropped;
      }
      case Phase::direction:
        return numbers_.point(state_.d);
      case Phase::support:
        return run_.pair_name(state_.support.pair);
      case Phase::stop:
        return state_.stop == gjk::StopReason::running ? "no" : "yes";
      case Phase::add:
        return words_.face(state_.simplex.all());
    }
    return {};
  }

  std::string test_values(const gjk::RegionTest<double>& test) const {
    std::string out;
    // An edge test also repeats that the projections lie within the edge; the area's sign is what
    // is new.
    for (const gjk::RegionTerm<double>& term : words_.terms(test)) {
      if (gjk::vertex_count(test.region) == 2 && term.wants_positive && test.terms.size() > 2)
        continue;
      const double value = term.denominator > 0.0 ? term.numerator / term.denominator : 0.0;
      if (gjk::vertex_count(test.region) == 3) continue;
      if (!out.empty()) out += " ";
      out += run_.lesson.scalar == ScalarKind::double_ ? signed_fixed(value, 3)
                                                       : numbers_.weight(value);
    }
    return out;
  }

  void pseudocode() {
    const std::vector<CodeLine>& lines = code_of(run_.lesson.listing);
    for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
      const CodeLine& line = lines[i];
      const LineState now = line_state(line, i);
      const bool current = now == LineState::current;
      if (current) highlight();
      const std::string role = current                     ? "code.current"
                               : now == LineState::crossed ? "code.muted"
                                                           : "code";
      const std::size_t indent = line.text.find_first_not_of(' ');
      write(role, left_ + 10.0 * static_cast<double>(indent), std::string(line.text.substr(indent)),
            current ? type::kCodeBold : type::kCode);
      const std::string value = line_value(line, now);
      if (!value.empty())
        write(current ? "code.value" : "code.muted", right_, value,
              current ? type::kCodeBold : type::kCode, Align::right);
      if (now == LineState::crossed && value.empty())
        write("fail", right_, "✗", type::kCode, Align::right);
      y_ += kRow;
    }
  }

  // Region tests
  // ---------------------------------------------------------------------------------------------------

  std::string condition(const gjk::detail::RegionList& order, int index) const {
    const gjk::Face face = order.conditions[index].face;
    const int size = gjk::vertex_count(face);
    const int count = state_.simplex.count;
    if (size == count) return count == 1 ? "only region" : "else";
    gjk::RegionTest<double> test{face, {}, false};
    for (int i = 0; i < count; ++i) {
      if (!gjk::contains(face, i))
        test.terms.push_back({static_cast<gjk::Face>(face | gjk::face_of(i)), i});
    }
    std::string out;
    for (const gjk::RegionTerm<double>& term : words_.terms(test)) {
      if (!out.empty()) out += " and ";
      out += words_.coordinate(term.face, term.vertex) + " ≤ 0";
    }
    if (size == 2) out += ", u, v > 0";
    return out;
  }

  void tests() {
    heading("First true test wins");
    const gjk::detail::RegionList order =
        gjk::detail::list_regions(state_.simplex.count, run_.lesson.options.region_order);
    const auto& tried = region_tests();
    for (int i = 0; i < order.count; ++i) {
      const bool reached = i <= tests_reached() && i < static_cast<int>(tried.size());
      const bool holds = reached && tried[i].holds;
      const bool current = reached && i == tests_reached();
      if (current) highlight(holds ? "highlight.pass" : "highlight");
      const TextStyle name_style = current ? type::kStrong : TextStyle{Face::regular, 15};
      const TextStyle code = current ? type::kCodeBold : type::kCode;
      const std::string role = !reached ? "untried" : current ? "code.current" : "code";
      write(!reached ? "untried"
            : holds  ? "pass"
                     : "fail",
            left_,
            !reached ? "·"
            : holds  ? "✓"
                     : "✗",
            type::kStrong);
      write(!reached ? "untried" : "body", left_ + 24.0, words_.face(order.conditions[i].face),
            name_style);
      write(role, left_ + 78.0, condition(order, i), code);
      if (reached) write(role, right_, test_values(tried[i]), code, Align::right);
      y_ += kRow + 2.0;
    }
  }

  void regions() {
    heading("Closest feature");
    const int count = state_.simplex.count;
    constexpr std::array<std::string_view, 4> kKinds = {"", "vertex", "edge", "interior"};
    gjk::detail::RegionList order =
        gjk::detail::list_regions(count, gjk::RegionOrder::vertices_first);
    if (count == 2)
      std::swap(order.conditions[0], order.conditions[1]);  // A before B: this is no order of tests
    for (int i = 0; i < order.count; ++i) {
      const gjk::Face face = order.conditions[i].face;
      const bool current = phase() && face == state_.region;
      if (current) highlight("highlight.pass");
      write(current ? "pass" : "untried", left_, current ? "●" : "○", type::kBody);
      write(current ? "body" : "body.muted", left_ + 24.0,
            std::string(kKinds[gjk::vertex_count(face)]), current ? type::kStrong : type::kBody);
      write(current ? "body" : "body.muted", left_ + 104.0, words_.face(face),
            current ? type::kStrong : type::kBody);
      if (current) {
        const std::string p =
            gjk::vertex_count(face) == 3 ? "P = Q" : "P = " + words_.combination(face, numbers_);
        write("code.current", right_, p, type::kCodeBold, Align::right);
      }
      y_ += kRow + 2.0;
    }
    y_ += 4.0;
    if (phase()) {
      write("heading", left_, "distance", type::kHeading);
      write("code.current", right_, numbers_(std::sqrt(state_.p_sq)), type::kCodeBold,
            Align::right);
      y_ += kRow;
    }
  }

  // Weights
  // --------------------------------------------------------------------------------------------------------

  void weights() {
    const BarycentricWeights::Value& value = effects_.get<BarycentricWeights>(frame_);
    const int count = value.simplex.count;
    const bool point_query = run_.point_query();
    heading(count == 3   ? "Weights: fractional areas, signed"
            : count == 2 ? "Weights: fractional lengths, signed"
                         : "Weights");
    if (value.weights.empty()) {
      write("body.muted", left_, "the simplex is degenerate: no coordinates", type::kBody);
      y_ += kRow;
      return;
    }
    constexpr double kLow = -1.0;
    constexpr double kHigh = 2.0;
    const double x0 = left_ + 28.0;
    const double x1 = right_ - 84.0;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
      const double weight = value.weights[i];
      sum += weight;
      write("strong", left_,
            point_query ? std::string(kLetters[i]) : run_.pair_name(value.simplex.vertices[i].pair),
            type::kStrong);
      bar(x0, x1, kLow, kHigh, weight, weight < 0.0 ? "weight.negative" : "weight.bar");
      write("code.current", right_,
            run_.lesson.scalar == ScalarKind::double_ ? signed_fixed(weight, 3)
                                                      : numbers_.weight(weight),
            type::kCodeBold, Align::right);
      y_ += 28.0;
    }
    y_ -= 6.0;
    for (const int tick : {-1, 0, 1, 2}) {
      write("body.muted", x0 + (tick - kLow) / (kHigh - kLow) * (x1 - x0), fixed(tick, 0),
            type::kTick, Align::center);
    }
    y_ += kRow + 2.0;
    write("body.muted", left_, count == 3 ? "u + v + w" : "u + v", type::kBody);
    write("code", right_,
          run_.lesson.scalar == ScalarKind::double_ ? fixed(sum, 3) : numbers_.weight(sum),
          type::kCode, Align::right);
    y_ += kRow;
    if (!point_query) return;
    const std::string& a = run_.lesson.y.vertex_names[0];
    const std::string& b = run_.lesson.y.vertex_names[1];
    const std::string q = query_name(run_);
    const auto formula = [&](const std::string& text) {
      write("code", left_, text, type::kCode);
      y_ += kTightRow + 2.0;
    };
    if (count == 2) {
      formula(format("u = dot({1} − {2}, {1} − {0}) / |{1} − {0}|²", a, b, q));
      formula(format("v = dot({2} − {0}, {1} − {0}) / |{1} − {0}|²", a, b, q));
    }
  }

  void linear_system() {
    const BarycentricWeights::Value& value = effects_.get<BarycentricWeights>(frame_);
    if (value.simplex.count != 3) return;
    heading("The same as a linear system");
    const PositionedRun& positioned = run_.run(frame_);
    const Vector2d q = positioned.x_world[0];
    constexpr double kColumn = 62.0;
    const double top = y_;
    for (int row = 0; row < 3; ++row) {
      double x = left_ + 58.0;
      for (int column = 0; column < 3; ++column) {
        const Vector2d vertex = value.simplex.vertices[column].w + q;
        write("code", x, row < 2 ? fixed(vertex[row], 2) : "1", type::kCode, Align::right);
        x += kColumn;
      }
      write("code.current", left_ + 216.0, std::string(kLetters[row]), type::kCodeBold,
            Align::center);
      write("code", left_ + 252.0, row == 1 ? "=" : "", type::kCode, Align::center);
      write("code", left_ + 334.0, row < 2 ? fixed(q[row], 2) : "1", type::kCode, Align::right);
      y_ += kRow;
    }
    const auto bracket = [&](double x, double open) {
      const double up = top - 16.0;
      const double down = y_ - kRow + 8.0;
      add("weight.axis", Polyline{{{x + open, up}, {x, up}, {x, down}, {x + open, down}}});
    };
    bracket(left_ + 2.0, 5.0);
    bracket(left_ + 194.0, -5.0);
    bracket(left_ + 204.0, 5.0);
    bracket(left_ + 228.0, -5.0);
    bracket(left_ + 274.0, 5.0);
    bracket(left_ + 344.0, -5.0);
  }

  // Simplex, scan, bounds
  // ------------------------------------------------------------------------------------------

  bool weights_known() const { return phase() && *phase() != Phase::add; }

  void simplex() {
    write("heading", left_, "Simplex", type::kHeading);
    const double x0 = left_ + 152.0;
    write("heading", x0, "weight", type::kHeading);
    y_ += kRow;
    const double name_at = left_ + 24.0;
    const double middle = 0.5 * fonts_.cap_height(type::kStrong);
    int rows = 0;
    for (int i = 0; i < state_.simplex.count; ++i, ++rows) {
      add("simplex.vertex", Disk{{left_ + 8.0, y_ - middle}, 5.0});
      write("strong", name_at, words_.vertex(i), type::kStrong);
      const bool has_weight = weights_known();
      const double weight = state_.simplex.weights[i];
      const std::string number = has_weight ? numbers_.weight(weight) : "–";
      const double number_width = std::max(62.0, fonts_.width(type::kCode, number));
      bar(x0, right_ - number_width - 16.0, 0.0, 1.0, has_weight ? weight : 0.0, "weight.bar");
      write("code.current", right_, number, type::kCode, Align::right);
      y_ += kRow;
    }
    if (phase() == Phase::cull) {
      for (const auto& vertex : run_.step(frame_).record.dropped) {
        add("dropped", Disk{{left_ + 8.0, y_ - middle}, 5.0});
        write("body.muted", name_at, run_.pair_name(vertex.pair), type::kStrong);
        write("body.muted", x0, "dropped: weight 0", type::kBody);
        y_ += kRow;
        ++rows;
      }
    }
    if (knows_support()) {
      add("support", Disk{{left_ + 8.0, y_ - middle}, 5.0});
      write("support.label", name_at, run_.pair_name(state_.support.pair), type::kStrong);
      const bool known = state_.stop == gjk::StopReason::repeated_support;
      const bool decided = phase() == Phase::stop;
      write("support.label", x0,
            !decided                                  ? "support point"
            : known                                   ? "in S already: stop"
            : state_.stop == gjk::StopReason::running ? "new: goes on"
                                                      : "support point",
            type::kBody);
      y_ += kRow;
      ++rows;
    }
    // Blocks below keep their place while the simplex grows and shrinks.
    for (; rows < 4; ++rows) y_ += kRow;
  }

  void scan_of(const std::vector<gjk::ScanEntry<double>>& entries,
               const std::vector<std::string>& names, double x0, double x1,
               const std::string& title) {
    write("heading", x0, title, type::kHeading);
    y_ += kRow;
    int best = -1;
    for (const auto& entry : entries) {
      if (entry.improves) best = entry.index;
    }
    constexpr int kShown = 6;
    for (int i = 0; i < static_cast<int>(names.size()) && i < kShown; ++i) {
      // The scan of a large polygon does not look at every vertex.
      const auto entry = std::find_if(entries.begin(), entries.end(),
                                      [&](const auto& seen) { return seen.index == i; });
      const bool wins = i == best;
      write(wins ? "support.label" : "body", x0, names[i], wins ? type::kStrong : type::kBody);
      write(wins ? "support.label" : "code", x1,
            entry == entries.end() ? "–" : numbers_(entry->value),
            wins ? type::kCodeBold : type::kCode, Align::right);
      y_ += kTightRow;
    }
    if (names.size() > kShown) {
      write("body.muted", x0, format("and {} more", names.size() - kShown), type::kBody);
      y_ += kTightRow;
    }
  }

  void scan() {
    static const std::vector<gjk::ScanEntry<double>> none;
    const gjk::Record<double, 2>* record = nullptr;
    if (phase() == Phase::support) record = &run_.step(frame_).record;
    if (stop_follows_support()) record = &run_.run(frame_).trace.steps[frame_.step - 1].record;
    const double top = y_;
    if (run_.point_query()) {
      scan_of(record ? record->scan_y : none, run_.lesson.y.vertex_names, left_, right_,
              "Support scan: dot(d, vertex)");
      return;
    }
    const double middle = 0.5 * (left_ + right_);
    scan_of(record ? record->scan_y : none, run_.lesson.y.vertex_names, left_, middle - 14.0,
            "dot(d, Y)");
    const double bottom = y_;
    y_ = top;
    scan_of(record ? record->scan_x : none, run_.lesson.x.vertex_names, middle + 14.0, right_,
            "dot(−d, X)");
    y_ = std::max(y_, bottom);
  }

  void bounds() {
    write("heading", left_, "Distance lies in", type::kHeading);
    const bool known = frame_.step >= 0;
    const DistanceBounds bounds = known ? run_.bounds(frame_) : DistanceBounds{};
    const double low = bounds.lower;
    const double high = bounds.upper;
    write("code.current", right_, known ? format("[{}, {}]", numbers_(low), numbers_(high)) : "–",
          type::kCode, Align::right);
    y_ += 22.0;
    const double first_high = known ? run_.run(frame_).bounds.front().upper : 0.0;
    add("bounds.track", Box{{{left_, y_ - 8.0}, {right_, y_}}, 4.0});
    if (known && first_high > 0.0) {
      const auto at = [&](double v) {
        return left_ + std::min(v / first_high, 1.0) * (right_ - left_);
      };
      double a = at(low);
      double b = at(high);
      if (b - a < 4.0) a = std::max(left_, 0.5 * (a + b) - 2.0), b = a + 4.0;
      add("bounds.bar", Box{{{a, y_ - 8.0}, {b, y_}}, 4.0});
      y_ += 18.0;
      const bool close = b - a < 110.0;
      const double line_at = close ? a - 6.0 : a;
      if (low > 0.0) {
        write("body.muted", std::max(line_at, left_ + 80.0), "support line", type::kTick,
              Align::right);
      }
      write("body.muted", std::min(b, right_ - 12.0), "P", type::kTick,
            close && low > 0.0 ? Align::left : Align::center);
    } else {
      y_ += 18.0;
    }
    y_ += kRow;
  }

  // Differences
  // ----------------------------------------------------------------------------------------------------

  void pairs() {
    const PositionedRun& positioned = run_.run(frame_);
    const int per_x = static_cast<int>(positioned.y_world.size());
    const int all = static_cast<int>(positioned.x_world.size()) * per_x;
    heading("Z = { y − x }: every pair");
    constexpr int kMost = 16;
    for (int i = 0; i < std::min(all, kMost); ++i) {
      const gjk::VertexPair pair{i / per_x, i % per_x};
      const bool made = i < frame_.detail;
      const bool current = i == frame_.detail - 1;
      if (current) highlight();
      const std::string role = !made ? "untried" : current ? "code.current" : "code";
      const TextStyle style = current ? type::kCodeBold : type::kCode;
      write(role, left_, run_.pair_name(pair), style);
      if (made)
        write(role, right_, numbers_.point(positioned.y_world[pair.y] - positioned.x_world[pair.x]),
              style, Align::right);
      y_ += kTightRow + 2.0;
      if ((i + 1) % per_x == 0) y_ += 8.0;
    }
    if (all > kMost) {
      write("body.muted", left_, format("and {} more", all - kMost), type::kBody);
      y_ += kRow;
    }
  }

  void direction_rules() {
    heading("Two ways to build d");
    const bool built = state_.simplex.count == 2 && phase() && *phase() != Phase::closest &&
                       *phase() != Phase::cull;
    static const DirectionRules::Value none;
    const DirectionRules::Value& rules = built ? effects_.get<DirectionRules>(frame_) : none;
    const std::string edge =
        state_.simplex.count == 2 ? words_.vertex(1) + " − " + words_.vertex(0) : "edge";
    for (const gjk::DirectionRule rule :
         {gjk::DirectionRule::towards_origin, gjk::DirectionRule::perpendicular}) {
      const bool towards = rule == gjk::DirectionRule::towards_origin;
      write("strong", left_, towards ? "d = Q − P" : format("d = cross({}, z)", edge),
            type::kStrong);
      const bool used = run_.lesson.options.direction_rule == rule;
      write("body.muted", right_, used ? "used by this run" : "for comparison", type::kTick,
            Align::right);
      y_ += kRow;
      const auto found =
          std::find_if(rules.begin(), rules.end(), [&](const auto& b) { return b.rule == rule; });
      const bool known = found != rules.end();
      write("code", left_ + 12.0, "d", type::kCode);
      write("code.current", right_, known ? numbers_.point(found->d) : "–", type::kCode,
            Align::right);
      y_ += kTightRow;
      write("code", left_ + 12.0, format("dot(d, {})", edge), type::kCode);
      write(known && found->dot_with_edge == 0.0 ? "pass"
            : known                              ? "fail"
                                                 : "code",
            right_, known ? numbers_(found->dot_with_edge) : "–", type::kCodeBold, Align::right);
      y_ += kTightRow;
      write("body.muted", left_ + 12.0,
            !known                        ? ""
            : found->dot_with_edge == 0.0 ? "exactly perpendicular"
                                          : "not perpendicular: round-off of P",
            type::kBody);
      y_ += kRow + 6.0;
    }
  }

  const LessonRun& run_;
  EffectGraph& effects_;
  const Frame& frame_;
  const Fonts& fonts_;
  const gjk::State<double, 2>& state_;
  Numbers numbers_;
  SimplexWords words_;
  double left_;
  double right_;
  double y_;
  std::vector<Mark> marks_;
};

// Timeline
// -----------------------------------------------------------------------------------------------------------

struct Tick {
  std::string label;
  std::string short_label;  ///< Where the label is wider than the tick.
  bool event = false;       ///< A vertex dropped, containment, the end.
};
struct Group {
  std::string label;
  std::vector<Tick> ticks;
};

std::vector<Group> timeline_groups(const LessonRun& run) {
  std::vector<Group> groups;
  const auto group = [&](const std::string& label) -> Group& {
    if (groups.empty() || groups.back().label != label) groups.push_back({label, {}});
    return groups.back();
  };
  const Granularity granularity = run.lesson.granularity;
  const int per_x = static_cast<int>(run.lesson.y.vertices.size());
  const int all = static_cast<int>(run.lesson.x.vertices.size()) * per_x;
  for (const Frame& frame : run.frames) {
    if (granularity == Granularity::path) {
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
    } else if (frame.step < 0) {
      group("start").ticks.push_back({"S", "", false});
    } else {
      const gjk::Step<double, 2>& step = run.step(frame);
      const bool event =
          !step.record.dropped.empty() || step.after.stop != gjk::StopReason::running;
      constexpr std::array<std::array<std::string_view, 2>, 6> kPhases = {{{"closest", "P"},
                                                                           {"cull", "−"},
                                                                           {"direction", "d"},
                                                                           {"support", "w"},
                                                                           {"stop?", "?"},
                                                                           {"add", "+"}}};
      const auto& [label, short_label] = kPhases[static_cast<std::size_t>(step.phase)];
      group(format("iteration {}", step.iteration))
          .ticks.push_back({std::string(label), std::string(short_label), event});
    }
  }
  return groups;
}

}  // namespace

std::vector<Mark> panel_marks(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                              const Fonts& fonts, const Rect& card) {
  return PanelBuilder(run, effects, frame, fonts, card).build();
}

std::vector<Mark> timeline_marks(const LessonRun& run, int current, const Fonts& fonts,
                                 const Rect& area) {
  std::vector<Mark> marks;
  const std::vector<Group> groups = timeline_groups(run);
  const int count = static_cast<int>(run.frames.size());
  constexpr double kGroupGap = 18.0;
  constexpr double kTickGap = 5.0;
  constexpr double kWidest = 116.0;
  const double gaps = kGroupGap * static_cast<double>(groups.size() - 1) +
                      kTickGap * static_cast<double>(count - static_cast<int>(groups.size()));
  const double width = std::min(kWidest, (area.size().x() - gaps) / count);
  double x = area.min.x();
  int index = 0;
  const double bar_y = area.min.y() + 14.0;
  double label_end = -1e9;
  for (const Group& group : groups) {
    const int first = index;
    const double group_x = x;
    for (const Tick& tick : group.ticks) {
      const bool now = index == current;
      const std::string role = now               ? "timeline.current"
                               : index < current ? "timeline.done"
                                                 : "timeline.ahead";
      marks.push_back({role, Box{{{x, bar_y}, {x + width, bar_y + (now ? 15.0 : 10.0)}}, 4.0}});
      if (tick.event)
        marks.push_back({"timeline.event", Disk{{x + width - 8.0, bar_y + 5.0}, 2.5}});
      x += width + kTickGap;
      ++index;
    }
    const double group_end = x - kTickGap;
    x = group_end + kGroupGap;
    const bool holds_current = current >= first && current < index;
    const TextStyle style = holds_current ? type::kTickBold : type::kTick;
    const double label_width = fonts.width(style, group.label);
    // Labels of narrow groups would run into each other; the current one always shows.
    if (holds_current ||
        (group_x > label_end && label_width <= group_end - group_x + kGroupGap - 6.0)) {
      marks.push_back({holds_current ? "timeline.label.current" : "timeline.label",
                       Text{{group_x, area.min.y() + 4.0}, group.label, style, Align::left}});
      label_end = group_x + label_width + 8.0;
    }
    if (!holds_current) continue;
    // The current tick's label first, whole; the others as far as there is room beside it.
    std::vector<std::pair<double, double>> taken;
    const auto place = [&](int k, const std::string& label, bool now) {
      const TextStyle tick_style = now ? type::kTickBold : type::kTick;
      const double half = 0.5 * fonts.width(tick_style, label);
      const double center = std::clamp(group_x + (k - first) * (width + kTickGap) + 0.5 * width,
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
    for (int k = first; k < index; ++k) {
      if (k != current && !place(k, tick_at(k).label, false))
        place(k, tick_at(k).short_label, false);
    }
  }
  return marks;
}

}  // namespace gjkscope
