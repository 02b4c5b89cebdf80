#include <fmt/format.h>

#include <array>
#include <cmath>

#include "picture/blocks/blocks.hpp"

namespace gjkscope::blocks {
namespace {

using namespace rows;

std::string condition(const PanelBuilder& panel, const gjk::detail::RegionList& order, int index) {
  const gjk::Face face = order.conditions[index].face;
  const int size = gjk::vertex_count(face);
  const int count = panel.state.simplex.count;
  if (size == count) return count == 1 ? "only region" : "else";
  gjk::RegionTest<double> test{face, {}, false};
  for (int i = 0; i < count; ++i) {
    if (!gjk::contains(face, i))
      test.terms.push_back({static_cast<gjk::Face>(face | gjk::face_of(i)), i});
  }
  std::string out;
  for (const gjk::RegionTerm<double>& term : panel.words.terms(test)) {
    if (!out.empty()) out += " and ";
    out += panel.words.coordinate(term.face, term.vertex) + " ≤ 0";
  }
  if (size == 2) {
    for (int i = 0; i < count; ++i)
      if (gjk::contains(face, i)) out += fmt::format(", {}", panel.words.coordinate(face, i));
    out += " > 0";
  }
  return out;
}

}  // namespace

void test_mark(PanelBuilder& panel, TestMark mark) {
  switch (mark) {
    case TestMark::untried:
      return panel.write("untried", panel.left, "·", type::kStrong);
    case TestMark::fails:
      return panel.write("fail", panel.left, "✗", type::kStrong);
    case TestMark::holds:
      return panel.write("pass", panel.left, "✓", type::kStrong);
  }
}

void test_row(PanelBuilder& panel, TestMark mark, bool current, const std::string& region,
              const std::string& condition, const std::string& values) {
  const bool tried = mark != TestMark::untried;
  const bool holds = mark == TestMark::holds;
  if (current) panel.highlight(holds ? "highlight.pass" : "highlight");
  const TextStyle name_style = current ? type::kStrong : TextStyle{Face::regular, 15};
  const TextStyle code = current ? type::kCodeBold : type::kCode;
  const std::string role = !tried ? "untried" : current ? "code.current" : "code";
  test_mark(panel, mark);
  panel.write(!tried ? "untried" : "body", panel.left + 24.0, region, name_style);
  panel.write(role, panel.left + 78.0, condition, code);
  if (tried) panel.write(role, panel.right, values, code, Align::right);
  panel.y += kRow + 2.0;
}

void tests(PanelBuilder& panel) {
  panel.heading("First true test wins");
  const gjk::detail::RegionList order =
      gjk::detail::list_regions(panel.state.simplex.count, panel.run.lesson.options.region_order);
  const auto& tried = panel.region_tests();
  for (int i = 0; i < order.count; ++i) {
    const bool reached = i <= panel.tests_reached() && i < static_cast<int>(tried.size());
    const TestMark mark = !reached         ? TestMark::untried
                          : tried[i].holds ? TestMark::holds
                                           : TestMark::fails;
    test_row(panel, mark, reached && i == panel.tests_reached(),
             panel.words.face(order.conditions[i].face), condition(panel, order, i),
             reached ? panel.test_values(tried[i]) : "");
  }
}

void regions(PanelBuilder& panel) {
  panel.heading("Closest feature");
  const int count = panel.state.simplex.count;
  constexpr std::array<std::string_view, 4> kKinds = {"", "vertex", "edge", "interior"};
  gjk::detail::RegionList order =
      gjk::detail::list_regions(count, gjk::RegionOrder::vertices_first);
  if (count == 2)
    std::swap(order.conditions[0], order.conditions[1]);  // A before B: this is no order of tests
  for (int i = 0; i < order.count; ++i) {
    const gjk::Face face = order.conditions[i].face;
    const bool current = panel.phase() && face == panel.state.region;
    if (current) panel.highlight("highlight.pass");
    panel.write(current ? "pass" : "untried", panel.left, current ? "●" : "○", type::kBody);
    panel.write(current ? "body" : "body.muted", panel.left + 24.0,
                std::string(kKinds[gjk::vertex_count(face)]),
                current ? type::kStrong : type::kBody);
    panel.write(current ? "body" : "body.muted", panel.left + 104.0, panel.words.face(face),
                current ? type::kStrong : type::kBody);
    if (current) {
      // An edge's point by its place: weights need not be known yet.
      const Eigen::Vector2d on_edge = panel.state.p + panel.run.run(panel.frame).x_world[0];
      const int size = gjk::vertex_count(face);
      const std::string p = "P = " + (size == 3   ? query_name(panel.run)
                                      : size == 2 ? panel.numbers.point(on_edge)
                                                  : panel.words.face(face));
      panel.write("code.current", panel.right, p, type::kCodeBold, Align::right);
    }
    panel.y += kRow + 2.0;
  }
  panel.y += 4.0;
  if (panel.phase()) {
    panel.write("heading", panel.left, "distance", type::kHeading);
    panel.write("code.current", panel.right, panel.numbers(std::sqrt(panel.state.p_sq)),
                type::kCodeBold, Align::right);
    panel.y += kRow;
  }
}

}  // namespace gjkscope::blocks
