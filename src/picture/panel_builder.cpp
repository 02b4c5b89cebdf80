#include "picture/panel_builder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "picture/hatch.hpp"

namespace gjkscope {

using namespace rows;

PanelBuilder::PanelBuilder(const LessonRun& lesson_run, EffectGraph& graph, const Frame& shown,
                           const Fonts& type_faces, const Rect& card)
    : run(lesson_run),
      effects(graph),
      frame(shown),
      fonts(type_faces),
      state(run.state(frame)),
      knows(effects.get<FrameFacts>(frame)),
      numbers(run.lesson),
      words(run, state.simplex),
      left(card.min.x() + kPad),
      right(card.max.x() - kPad),
      y(card.min.y() + 30.0) {}

void PanelBuilder::add(std::string role, decltype(Mark::shape) shape) {
  marks.push_back({std::move(role), std::move(shape), -1, subject});
}

void PanelBuilder::write(std::string role, double x, std::string text, const TextStyle& style,
                         Align align) {
  add(std::move(role), Text{{x, y}, std::move(text), style, align});
}

void PanelBuilder::heading(std::string text) {
  write("heading", left, std::move(text), type::kHeading);
  y += kRow + 2.0;
}

void PanelBuilder::row(const std::string& what, const std::string& value) {
  write("body.muted", left, what, type::kBody);
  write("code.current", right, value, type::kCode, Align::right);
  y += kRow;
}

void PanelBuilder::rule() {
  y += kBlockGap - kRow + 2.0;
  add("card.rule", Polyline{{{left, y}, {right, y}}});
  y += kBlockGap + 9.0;
}

void PanelBuilder::highlight(const std::string& role, double below) {
  const double rise = fonts.cap_height(type::kCode);
  add(role, Box{{{left - 8.0, y - rise - 4.5}, {right + 8.0, y + 4.5 + below}}, 5.0});
}

void PanelBuilder::bar(double x0, double x1, double low, double high, double value,
                       const std::string& role) {
  const double middle = y - 0.5 * fonts.cap_height(type::kBody);
  const auto at = [&](double v) {
    return x0 + (std::clamp(v, low, high) - low) / (high - low) * (x1 - x0);
  };
  add("weight.track", Box{{{x0, middle - 6.0}, {x1, middle + 6.0}}, 3.0});
  const double x_low = std::min(at(0.0), at(value));
  const double x_high = std::max(at(0.0), at(value));
  if (x_high - x_low >= 1.0 && value >= 0.0)
    add(role, Box{{{x_low, middle - 6.0}, {x_high, middle + 6.0}}, 2.0});
  if (x_high - x_low >= 1.0 && value < 0.0) {
    const std::vector<Point> box = {{x_low, middle - 6.0},
                                    {x_high, middle - 6.0},
                                    {x_high, middle + 6.0},
                                    {x_low, middle + 6.0}};
    for (Polyline& line : hatch(box, 4.0, {box[0], box[2]})) add(role + ".hatch", std::move(line));
    add("weight.negative", Polyline{box, true});
  }
  if (low < 0.0) add("weight.axis", Polyline{{{at(0.0), middle - 9.0}, {at(0.0), middle + 9.0}}});
}

std::string PanelBuilder::test_values(const gjk::RegionTest<double>& test) const {
  std::string out;
  // An edge test also repeats that the projections lie within the edge; the area's sign is what
  // is new, unless it is the repeated part that fails.
  if (gjk::vertex_count(test.region) == run.lesson.dimension + 1) return out;
  const auto is_flat = [](const gjk::RegionTerm<double>& term) {
    return gjk::vertex_count(term.face) == 3 && !(term.denominator > 0.0);
  };
  const bool has_area = std::none_of(test.terms.begin(), test.terms.end(), is_flat);
  for (const gjk::RegionTerm<double>& term : words.terms(test)) {
    if (gjk::vertex_count(test.region) == 2 && term.wants_positive && test.terms.size() > 2 &&
        term.holds && has_area)
      continue;
    if (is_flat(term)) continue;  // its condition says so
    if (!out.empty()) out += " ";
    if (!(term.denominator > 0.0)) {  // coinciding points
      out += "0/0";
      continue;
    }
    const double value = term.numerator / term.denominator;
    const std::string written =
        run.lesson.scalar == ScalarKind::double_ ? signed_fixed(value, 3) : numbers.weight(value);
    // The sign decides: a small number is no zero.
    const bool is_hidden = value != 0.0 && written.find_first_of("123456789") == std::string::npos;
    out += is_hidden ? fmt::format("{}{}", value > 0.0 ? "+" : "", power_text(value, 2)) : written;
  }
  return out;
}

}  // namespace gjkscope
