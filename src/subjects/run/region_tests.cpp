#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "gjk/regions.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/weights/projection.hpp"

namespace gjkscope::blocks {
namespace {

using namespace rows;

constexpr double kCondition = 68.0;  // from a card's text to the condition of a test

std::string condition(const PanelBuilder& panel, const gjk::FaceList& order, int index) {
  const gjk::Face face = order[index];
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
    const bool has_area =
        gjk::barycentric(in_plane(panel.state.simplex), term.face).denominator > 0.0;
    out += has_area || gjk::vertex_count(term.face) < 3
               ? panel.words.coordinate(term.face, term.vertex) + " ≤ 0"
               : "area 0";
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
    case TestMark::misleads:
      return panel.write("fail", panel.left + 6.0, "!", type::kStrong);
  }
}

void test_row(PanelBuilder& panel, TestMark mark, bool current, const std::string& region,
              const std::string& condition, const std::string& values) {
  const bool tried = mark != TestMark::untried;
  const bool holds = mark == TestMark::holds;
  // In a narrow panel the values stand below a condition that leaves them no room.
  constexpr double kApart = 3.0;
  const double width = panel.fonts.width(type::kCodeBold, condition + values);
  const bool is_narrow = tried && kCondition + width + kApart > panel.right - panel.left;
  const double below = is_narrow ? kTightRow : 0.0;
  if (current) panel.highlight(holds ? "highlight.pass" : "highlight", below);
  const TextStyle name_style = current ? type::kStrong : type::kBody;
  const TextStyle code = current ? type::kCodeBold : type::kCode;
  const std::string role = !tried ? "untried" : current ? "code.current" : "code";
  test_mark(panel, mark);
  panel.write(!tried ? "untried" : "body", panel.left + 24.0, region, name_style);
  panel.write(role, panel.left + kCondition, condition, code);
  panel.y += below;
  if (tried) panel.write(role, panel.right, values, code, Align::right);
  panel.y += kRow + 2.0;
}

namespace {

/// A further row of an edge's test that holds: its weights on the edge, which must be positive.
void between_ends(PanelBuilder& panel, const gjk::RegionTest<double>& test) {
  std::string names;
  std::string values;
  for (const gjk::RegionTerm<double>& term : panel.words.terms(test)) {
    if (!term.wants_positive) continue;
    if (!names.empty()) {
      names += ", ";
      values += " ";
    }
    names += panel.words.coordinate(term.face, term.vertex);
    values += signed_fixed(term.numerator / term.denominator, 3);
  }
  panel.highlight("highlight.pass");
  panel.write("code.current", panel.left + kCondition, names, type::kCodeBold);
  panel.write("code.current", panel.right, values, type::kCodeBold, Align::right);
  panel.y += kRow + 2.0;
}

void tests(PanelBuilder& panel) {
  // Once P is found, its tests stay, with the simplex that they were about.
  Frame asked = panel.frame;
  const auto& steps = panel.run.run(asked).trace.steps;
  if (panel.run.tour->algorithm == &kGjkAlgorithm && panel.knows.phase != gjk::Phase::add)
    while (asked.step > 0 && steps[asked.step].phase != gjk::Phase::closest) --asked.step;
  PanelBuilder before(panel.run, panel.effects, asked, panel.fonts, {});
  before.left = panel.left;
  before.right = panel.right;
  before.y = panel.y;
  const bool asks_now = asked.step == panel.frame.step;
  before.heading("First true test wins");
  const gjk::FaceList order =
      gjk::tested_faces(before.state.simplex.count, before.run.lesson.options.region_order);
  const auto& tried = before.knows.region_tests;
  const bool leaves_room = before.knows.gradual && before.state.simplex.count == 3;
  bool has_weights = false;
  for (int i = 0; i < order.count; ++i) {
    const bool reached = i <= before.knows.tests_reached && i < static_cast<int>(tried.size());
    const TestMark mark = !reached         ? TestMark::untried
                          : tried[i].holds ? TestMark::holds
                                           : TestMark::fails;
    test_row(before, mark, asks_now && reached && i == before.knows.tests_reached,
             before.words.face(order[i]), condition(before, order, i),
             reached ? before.test_values(tried[i]) : "");
    if (!leaves_room || !reached || !tried[i].holds || gjk::vertex_count(tried[i].region) != 2)
      continue;
    between_ends(before, tried[i]);
    has_weights = true;
  }
  if (leaves_room && !has_weights) before.y += kRow + 2.0;
  panel.y = before.y;
  std::move(before.marks.begin(), before.marks.end(), std::back_inserter(panel.marks));
}

}  // namespace

const Block kTests{.name = "tests",
                   .meaning = "the region tests in order, with their numbers and verdicts",
                   .write = tests};

namespace {

/// Tells where Q projects to on the line of an edge: on it, or beyond one of its ends.
void ruler(PanelBuilder& panel, int from, int to) {
  const WideSimplex& simplex = panel.state.simplex;
  const auto face = static_cast<gjk::Face>(gjk::face_of(from) | gjk::face_of(to));
  const auto along = gjk::barycentric(in_plane(simplex), face);
  if (!(along.denominator > 0.0)) return;
  const double share = along.numerator[to] / along.denominator;
  const std::string a = panel.words.vertex(from);
  const std::string b = panel.words.vertex(to);
  std::string name = "on " + panel.words.face(face);
  if (simplex.count == 3) {
    const int other = 3 - from - to;
    const bool inside = gjk::barycentric(in_plane(simplex), simplex.all()).numerator[other] > 0.0;
    name += inside ? fmt::format(", on {}'s side", panel.words.vertex(other)) : ", beyond it";
  }
  panel.write("body", panel.left, name, type::kBody);
  panel.write("strong", panel.right,
              share <= 0.0   ? "beyond " + a
              : share >= 1.0 ? "beyond " + b
                             : fmt::format("between {} and {}", a, b),
              type::kStrong, Align::right);
  panel.y += 14.0;
  constexpr double kBeyond = 0.6;  // lengths of the edge before and after it
  constexpr double kHalf = 4.0;
  const auto at = [&](double v) {
    const double part = (std::clamp(v, -kBeyond, 1.0 + kBeyond) + kBeyond) / (1.0 + 2.0 * kBeyond);
    return panel.left + part * (panel.right - panel.left);
  };
  const auto strip = [&](const std::string& role, double low, double high, bool holds) {
    panel.add(holds ? "region.active" : role,
              Box{{{at(low), panel.y - kHalf}, {at(high), panel.y + kHalf}}, 0.0});
  };
  strip("region.vertex", -kBeyond, 0.0, share <= 0.0);
  strip("region.edge", 0.0, 1.0, share > 0.0 && share < 1.0);
  strip("region.vertex", 1.0, 1.0 + kBeyond, share >= 1.0);
  for (const double end : {0.0, 1.0}) {
    panel.add("weight.axis",
              Polyline{{{at(end), panel.y - 2.0 * kHalf}, {at(end), panel.y + 2.0 * kHalf}}});
  }
  const Point foot(at(share), panel.y);
  const Point half = Point::Constant(kHalf + 1.0);
  panel.add("projection.point", Box{{foot - half, foot + half}});
  panel.y += 24.0;
  panel.write("body.muted", at(0.0), a, type::kTick, Align::center);
  panel.write("body.muted", at(1.0), b, type::kTick, Align::center);
  panel.y += kRow;
}

/// Q's distance from everything on a segment that can be closest.
void candidates(PanelBuilder& panel) {
  const WideSimplex& simplex = panel.state.simplex;
  const Projection::Value& g = panel.effects.get<Projection>(panel.frame);
  if (!g) return;
  const auto row = [&](const std::string& name, const std::string& note, double distance,
                       bool holds) {
    panel.write(holds ? "strong" : "body.muted", panel.left, "from " + name,
                holds ? type::kStrong : type::kBody);
    panel.write("body.muted", panel.left + 92.0, note, type::kBody);
    panel.write(holds ? "code.current" : "code", panel.right, panel.numbers(distance),
                holds ? type::kCodeBold : type::kCode, Align::right);
    panel.y += kRow;
  };
  panel.heading(fmt::format("Distance of {}", query_name(panel.run)));
  for (int i = 0; i < 2; ++i) {
    row(panel.words.vertex(i), "", simplex.vertices[i].w.norm(),
        panel.state.region == gjk::face_of(i));
  }
  const bool on_edge = panel.state.region == simplex.all();
  const std::string segment = panel.words.face(simplex.all());
  row("G", (on_edge ? "on " : "not on ") + segment, g->norm(), on_edge);
}

void regions(PanelBuilder& panel) {
  panel.heading("Closest feature");
  const int count = panel.state.simplex.count;
  constexpr std::array<std::string_view, 4> kKinds = {"", "vertex", "edge", "interior"};
  const gjk::Face all = panel.state.simplex.all();
  gjk::FaceList order = gjk::tested_faces(count, gjk::RegionOrder::vertices_first);
  if (count == 2)
    std::swap(order.entries[0], order.entries[1]);  // A before B: this is no order of tests
  for (int i = 0; i < order.count; ++i) {
    const gjk::Face face = order[i];
    const bool current = panel.knows.phase && face == panel.state.region;
    if (current) panel.highlight("highlight.pass");
    panel.write(current ? "pass" : "untried", panel.left, current ? "●" : "○", type::kBody);
    panel.write(
        current ? "body" : "body.muted", panel.left + 24.0,
        std::string(count == 2 && face == all ? "segment" : kKinds[gjk::vertex_count(face)]),
        current ? type::kStrong : type::kBody);
    panel.write(current ? "body" : "body.muted", panel.left + 116.0, panel.words.face(face),
                current ? type::kStrong : type::kBody);
    if (current) {
      // An edge's point by its place: weights need not be known yet.
      const Eigen::Vector3d on_edge = panel.state.p + panel.run.run(panel.frame).x().world[0];
      const int size = gjk::vertex_count(face);
      const std::string p = "P = " + (size == 3   ? query_name(panel.run)
                                      : size == 2 ? panel.numbers.point(on_edge)
                                                  : panel.words.face(face));
      panel.write("code.current", panel.right, p, type::kCodeBold, Align::right);
    }
    panel.y += kRow + 2.0;
  }
  if (!panel.knows.phase) return;
  panel.rule();
  if (count == 2) {
    candidates(panel);
    panel.rule();
  }
  panel.heading(fmt::format("Projection of {}", query_name(panel.run)));
  for (int i = 0; i + 1 < count; ++i) ruler(panel, i, i + 1);
  if (count == 3) ruler(panel, 2, 0);
}

}  // namespace

const Block kRegions{.name = "regions",
                     .meaning = "the Voronoi regions, and which holds the query point",
                     .write = regions};

}  // namespace gjkscope::blocks
