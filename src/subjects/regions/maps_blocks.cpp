#include <fmt/format.h>

#include <array>

#include "gjk/regions.hpp"
#include "subjects/regions/region_orders.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/regions/tour.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope::blocks {
namespace {

using namespace rows;

/// "+0.31 −0.20": two digits, so that three numbers fit beside their condition.
std::string values_of(const PanelBuilder& panel, const gjk::RegionTest<double>& test) {
  std::string out;
  for (const gjk::RegionTerm<double>& term : panel.words.terms(test)) {
    if (!out.empty()) out += " ";
    out += signed_fixed(term.numerator / term.denominator, 2);
  }
  return out;
}

std::string condition_of(const PanelBuilder& panel, const RegionOrders::Chain& chain,
                         gjk::Face face) {
  const int size = gjk::vertex_count(face);
  if (size == 3) return "else";
  gjk::RegionTest<double> test{face, {}, false};
  for (int i = 0; i < 3; ++i) {
    if (!gjk::contains(face, i))
      test.terms.push_back({static_cast<gjk::Face>(face | gjk::face_of(i)), i});
  }
  std::string out;
  for (const gjk::RegionTerm<double>& term : panel.words.terms(test)) {
    const std::string name = panel.words.coordinate(term.face, term.vertex);
    if (size == 2 && chain.whole) return "u, v > 0 ≥ " + name;
    if (!out.empty()) out += " and ";
    out += name + " ≤ 0";
  }
  return out;
}

/// The coordinates on each edge and in the triangle, a row each.
void numbers_of(PanelBuilder& panel) {
  panel.heading("Coordinates, the same in any order");
  for (const gjk::Face face : std::array<gjk::Face, 4>{0b011, 0b110, 0b101, 0b111}) {
    const gjk::Barycentric<double, 2> coordinates =
        gjk::barycentric(in_plane(panel.state.simplex), face);
    double x = panel.left;
    for (const int i : panel.words.order(face)) {
      panel.write("code", x, panel.words.coordinate(face, i), type::kCode);
      panel.write("code.current", x + 108.0,
                  signed_fixed(coordinates.numerator[i] / coordinates.denominator, 3),
                  type::kCodeBold, Align::right);
      x += 136.0;
    }
    panel.y += kRow + 2.0;
  }
  panel.rule();
  panel.heading("Tests: a vertex, an edge, the rest");
  const auto test = [&](gjk::Face face, bool whole, const std::string& name) {
    panel.write("body", panel.left, panel.words.face(face) + name, type::kBody);
    RegionOrders::Chain chain;
    chain.whole = whole;
    panel.write("code", panel.left + 108.0, condition_of(panel, chain, face), type::kCode);
    panel.y += kRow + 2.0;
  };
  test(0b001, false, "");
  test(0b011, false, ", short");
  test(0b011, true, ", whole");
  test(0b111, false, "");
}

/// A box behind one sign of the current row.
void sign_highlight(PanelBuilder& panel, double x) {
  const double rise = panel.fonts.cap_height(type::kCode);
  panel.add("highlight", Box{{{x - 6.0, panel.y - rise - 4.5}, {x + 32.0, panel.y + 4.5}}, 5.0});
}

void signs(PanelBuilder& panel) {
  const BarycentricWeights::Value& value = panel.effects.get<BarycentricWeights>(panel.frame);
  if (value.weights.size() != 3) return;
  panel.heading("Signs, and the feature they name");
  gjk::Face positive = 0;
  for (int i = 0; i < 3; ++i) {
    if (value.weights[i] > 0.0) positive = static_cast<gjk::Face>(positive | gjk::face_of(i));
  }
  const double name_at = panel.left + 164.0;
  const auto feature = [&](gjk::Face face) {
    constexpr std::array<std::string_view, 4> kKinds = {"", "vertex", "edge", "interior"};
    return fmt::format("{} {}", kKinds[gjk::vertex_count(face)], panel.words.face(face));
  };
  // Q's place in the maps is shown once the maps are.
  const auto map = map_stage(panel.run, panel.frame);
  const auto reached = [&](MapStage stage) { return !map || *map >= stage; };
  // The sign that a map of one coordinate shows.
  const auto is_shown = [&](gjk::Face face, int i) {
    if (!map) return false;
    switch (*map) {
      case MapStage::negative_u:
        return i == 0 && !gjk::contains(face, i);
      case MapStage::negative_v:
        return i == 1 && !gjk::contains(face, i);
      case MapStage::negative_w:
        return i == 2 && !gjk::contains(face, i);
      default:
        return false;
    }
  };
  const bool is_interior = map && *map == MapStage::interior;
  for (const gjk::Face face :
       std::array<gjk::Face, 7>{0b111, 0b110, 0b101, 0b011, 0b001, 0b010, 0b100}) {
    const bool holds_q = face == positive && reached(MapStage::signs);
    const bool current = holds_q || (is_interior && face == 0b111);
    if (current) panel.highlight();
    if (holds_q)
      panel.write("query.label", panel.right, query_name(panel.run), type::kStrong, Align::right);
    for (int i = 0; i < 3; ++i) {
      const bool lit = current || is_shown(face, i);
      const double x = panel.left + 44.0 * i;
      if (lit && !current) sign_highlight(panel, x);
      panel.write(lit ? "code.current" : "code", x,
                  fmt::format("{} {}", "uvw"[i], gjk::contains(face, i) ? "+" : "−"),
                  lit ? type::kCodeBold : type::kCode);
    }
    panel.write(current ? "body" : "body.muted", name_at, feature(face),
                current ? type::kStrong : type::kBody);
    panel.y += kRow;
  }
  panel.y += 6.0;
  const bool agree = positive == panel.state.region;
  panel.write("heading", panel.left, "Voronoi region", type::kHeading);
  panel.write("body", name_at, feature(panel.state.region), type::kStrong);
  if (reached(MapStage::difference))
    panel.write(agree ? "pass" : "fail", panel.right, agree ? "✓ the same" : "✗ not the same",
                type::kStrong, Align::right);
  panel.y += kRow;
}

}  // namespace

const Block kSigns{.name = "signs",
                   .meaning = "what the signs of u, v and w would say, beside the Voronoi region",
                   .write = signs};

namespace {

void orders(PanelBuilder& panel) {
  const RegionOrders::Value& chains = panel.effects.get<RegionOrders>(panel.frame);
  if (chains.empty()) return;
  const OrderStage stage = *order_stage(panel.run, panel.frame);
  if (stage == OrderStage::numbers) return numbers_of(panel);
  const RegionOrders::Chain& chain = chains[static_cast<std::size_t>(stage) - 1];
  panel.heading(fmt::format("{} first, {} tests of the edges",
                            chain.order == gjk::RegionOrder::edges_first ? "Edges" : "Vertices",
                            chain.whole ? "whole" : "short"));
  const gjk::FaceList list = gjk::tested_faces(3, chain.order);
  const int tried = static_cast<int>(chain.tests.size());
  for (int i = 0; i < list.count; ++i) {
    const gjk::Face face = list[i];
    const TestMark mark = i >= tried              ? TestMark::untried
                          : !chain.tests[i].holds ? TestMark::fails
                          : chain.error > 0.0     ? TestMark::misleads
                                                  : TestMark::holds;
    test_row(panel, mark, i == tried - 1, panel.words.face(face), condition_of(panel, chain, face),
             i < tried ? values_of(panel, chain.tests[i]) : "");
  }
  panel.rule();
  const auto row = [&](const std::string& name, const std::string& value) {
    panel.write("body", panel.left, name, type::kBody);
    panel.write("code.current", panel.right, value, type::kCodeBold, Align::right);
    panel.y += kRow;
  };
  std::string sum;
  for (const int i : panel.words.order(chain.region)) {
    const std::string weight = gjk::vertex_count(chain.region) > 1
                                   ? panel.numbers.weight(chain.weights[i]) + " "
                                   : std::string();
    sum += (sum.empty() ? "" : " + ") + weight + panel.words.vertex(i);
  }
  if (gjk::vertex_count(chain.region) == 3) sum = query_name(panel.run);
  row("P′, the point found", sum);
  row("its distance from " + query_name(panel.run), panel.numbers(chain.p.norm()));
  row("error |P′ − P|", panel.numbers(chain.error));
}

}  // namespace

const Block kOrders{
    .name = "orders",
    .meaning = "one chain of region tests, the point it takes, and how wrong that is",
    .write = orders,
    .tour = "orders"};

}  // namespace gjkscope::blocks
