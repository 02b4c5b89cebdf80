#include <fmt/format.h>

#include <array>

#include "outlines/polygon.hpp"
#include "picture/scene.hpp"
#include "subjects/weights/barycentric.hpp"
#include "subjects/weights/projection.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope::blocks {
namespace {

using Eigen::Vector2d;
using namespace rows;

constexpr std::array<std::string_view, 4> kLetters = {"u", "v", "w", "t"};

void weights(PanelBuilder& panel) {
  const BarycentricWeights::Value& value = panel.effects.get<BarycentricWeights>(panel.frame);
  const int count = value.simplex.count;
  const bool point_query = panel.run.point_query();
  panel.heading(count == 4   ? "Weights: signed fractions of volume"
                : count == 3 ? "Weights: signed fractions of area"
                : count == 2 ? "Weights: signed fractions of length"
                             : "Weights");
  if (value.weights.empty()) {
    panel.write("body.muted", panel.left, "the simplex is degenerate: no weights", type::kBody);
    panel.y += kRow;
    return;
  }
  constexpr double kLow = -1.0;
  constexpr double kHigh = 2.0;
  const double x0 = panel.left + 28.0;
  const double x1 = panel.right - 84.0;
  double sum = 0.0;
  std::vector<std::string> terms;
  for (int i = 0; i < count; ++i) {
    const double weight = value.weights[i];
    sum += weight;
    terms.push_back(panel.numbers.weight(weight));
    panel.subject = subject_of(panel.run, value.simplex.vertices[i].pair);
    panel.write("strong", panel.left,
                point_query ? std::string(kLetters[i])
                            : panel.run.pair_name(value.simplex.vertices[i].pair),
                type::kStrong);
    panel.bar(x0, x1, kLow, kHigh, weight,
              point_query ? fmt::format("weight.bar.{}", kLetters[i]) : "weight.bar");
    panel.write("code.current", panel.right,
                panel.run.lesson.scalar == ScalarKind::double_ ? signed_fixed(weight, 3)
                                                               : panel.numbers.weight(weight),
                type::kCodeBold, Align::right);
    panel.y += 28.0;
  }
  panel.subject = {};
  panel.y -= 6.0;
  for (const int tick : {-1, 0, 1, 2}) {
    panel.write("body.muted", x0 + (tick - kLow) / (kHigh - kLow) * (x1 - x0), fixed(tick, 0),
                type::kTick, Align::center);
  }
  panel.y += kRow + 2.0;
  const std::string total = panel.numbers.weight(sum);
  panel.write("body.muted", panel.left,
              std::string(count == 4   ? "u + v + w + t"
                          : count == 3 ? "u + v + w"
                          : count == 2 ? "u + v"
                                       : "u") +
                  (adds_up(terms, total) ? "" : " up to rounding"),
              type::kBody);
  panel.write("code", panel.right, total, type::kCode, Align::right);
  panel.y += kRow;
  if (!point_query || count != 2) return;
  const std::string a = panel.run.pair_name(value.simplex.vertices[0].pair);
  const std::string b = panel.run.pair_name(value.simplex.vertices[1].pair);
  const std::string q = query_name(panel.run);
  const auto formula = [&](const std::string& text) {
    panel.write("code", panel.left, text, type::kCode);
    panel.y += kTightRow + 2.0;
  };
  formula(fmt::format("u = dot({1} − {2}, {1} − {0}) / |{1} − {0}|²", a, b, q));
  formula(fmt::format("v = dot({2} − {0}, {1} − {0}) / |{1} − {0}|²", a, b, q));
}

}  // namespace

const Block kWeights{.name = "weights",
                     .meaning = "barycentric weights as signed bars",
                     .write = weights,
                     .shown_of = ShownOf::both};

namespace {

void linear_system(PanelBuilder& panel) {
  const BarycentricWeights::Value& value = panel.effects.get<BarycentricWeights>(panel.frame);
  if (value.simplex.count != 3) return;
  panel.heading("The same as a linear system");
  const PositionedRun& positioned = panel.run.run(panel.frame);
  const Vector2d q = in_plane(positioned.x().world[0]);
  constexpr double kColumn = 62.0;
  panel.y -= 5.0;
  for (int column = 0; column < 3; ++column) {
    panel.write("body.muted", panel.left + 58.0 + column * kColumn,
                panel.run.pair_name(value.simplex.vertices[column].pair), type::kTick,
                Align::right);
  }
  panel.write("body.muted", panel.left + 334.0, query_name(panel.run), type::kTick, Align::right);
  panel.y += kTightRow;
  const double top = panel.y;
  for (int row = 0; row < 3; ++row) {
    double x = panel.left + 58.0;
    for (int column = 0; column < 3; ++column) {
      const Vector2d vertex = in_plane(value.simplex.vertices[column].w) + q;
      panel.write("code", x, row < 2 ? fixed(vertex[row], 2) : "1", type::kCode, Align::right);
      x += kColumn;
    }
    panel.write("code.current", panel.left + 216.0, std::string(kLetters[row]), type::kCodeBold,
                Align::center);
    panel.write("code", panel.left + 252.0, row == 1 ? "=" : "", type::kCode, Align::center);
    panel.write("code", panel.left + 334.0, row < 2 ? fixed(q[row], 2) : "1", type::kCode,
                Align::right);
    constexpr std::array<std::string_view, 3> kRows = {"x", "y", "sum"};
    panel.write("body.muted", panel.right, std::string(kRows[row]), type::kTick, Align::right);
    panel.y += kRow;
  }
  const auto bracket = [&](double x, double open) {
    const double up = top - 16.0;
    const double down = panel.y - kRow + 8.0;
    panel.add("weight.axis", Polyline{{{x + open, up}, {x, up}, {x, down}, {x + open, down}}});
  };
  bracket(panel.left + 2.0, 5.0);
  bracket(panel.left + 194.0, -5.0);
  bracket(panel.left + 204.0, 5.0);
  bracket(panel.left + 228.0, -5.0);
  bracket(panel.left + 274.0, 5.0);
  bracket(panel.left + 344.0, -5.0);
}

}  // namespace

const Block kLinearSystem{.name = "linear-system",
                          .meaning = "the linear system that the weights solve",
                          .write = linear_system};

namespace {

void unit_vector(PanelBuilder& panel) {
  const UnitVector::Value& built = panel.effects.get<UnitVector>(panel.frame);
  if (!built) return;
  const std::string a = panel.words.vertex(0);
  const std::string b = panel.words.vertex(1);
  const std::string q = query_name(panel.run);
  const auto row = [&](const std::string& text, const std::string& value) {
    panel.write("code", panel.left, text, type::kCode);
    panel.write("code.current", panel.right, value, type::kCode, Align::right);
    panel.y += kRow;
  };
  panel.heading("The unit vector of " + a + b);
  row(fmt::format("length = |{} − {}|", b, a), panel.numbers(built->length));
  row(fmt::format("n = ({} − {}) / length", b, a), panel.numbers.point(built->n));
  panel.rule();
  panel.heading("Fractional lengths along n");
  const double of_g = panel.right - 96.0;
  panel.y -= kRow + 2.0;
  panel.write("heading", of_g, "from G", type::kHeading, Align::right);
  panel.write("heading", panel.right, "from " + q, type::kHeading, Align::right);
  panel.y += kRow + 2.0;
  const auto both = [&](const std::string& text, double g, double from_q, bool weight) {
    const TextStyle style = weight ? type::kCodeBold : type::kCode;
    const auto number = [&](double value) {
      return weight ? signed_fixed(value, 3) : panel.numbers(value);
    };
    panel.write(weight ? "code.current" : "code", panel.left, text, style);
    panel.write("code.current", of_g, number(g), style, Align::right);
    panel.write("code.current", panel.right, number(from_q), style, Align::right);
    panel.y += kRow;
  };
  both(fmt::format("dot({} − G, n)", b), built->of_g.to_b, built->of_q.to_b, false);
  both(fmt::format("dot(G − {}, n)", a), built->of_g.from_a, built->of_q.from_a, false);
  both("u = first row / length", built->of_g.to_b / built->length, built->of_q.to_b / built->length,
       true);
  both("v = second row / length", built->of_g.from_a / built->length,
       built->of_q.from_a / built->length, true);
}

}  // namespace

const Block kUnitVector{.name = "unit-vector",
                        .meaning = "n, and u and v as lengths along it: from G, then from Q",
                        .write = unit_vector};

namespace {

void areas(PanelBuilder& panel) {
  const BarycentricWeights::Value& value = panel.effects.get<BarycentricWeights>(panel.frame);
  if (value.simplex.count != 3 || value.weights.empty()) return;
  panel.heading("Signed area = ½ cross");
  const std::string q = query_name(panel.run);
  std::array<std::string, 3> names;
  std::vector<Vector2d> corners;
  for (int i = 0; i < 3; ++i) {
    names[i] = panel.words.vertex(i);
    corners.push_back(in_plane(value.simplex.vertices[i].w));
  }
  double sum = 0.0;
  const auto row = [&](const std::string& from, const std::string& to, const std::string& third,
                       double area, const std::string& weight) {
    panel.write("strong", panel.left, from + to + third, type::kStrong);
    panel.write("code", panel.left + 42.0,
                fmt::format("½ cross({1}−{0}, {2}−{0})", from, to, third), type::kCode);
    panel.write("code", panel.right - 96.0, fixed(area, 3), type::kCode, Align::right);
    panel.write("code.current", panel.right, weight, type::kCodeBold, Align::right);
    panel.y += kRow;
  };
  for (int i = 0; i < 3; ++i) {
    const std::vector<Vector2d> part = {Vector2d::Zero(), corners[(i + 1) % 3],
                                        corners[(i + 2) % 3]};
    sum += value.weights[i];
    row(q, names[(i + 1) % 3], names[(i + 2) % 3], signed_area(part),
        fmt::format("{} {}", kLetters[i], signed_fixed(value.weights[i], 3)));
  }
  row(names[0], names[1], names[2], signed_area(corners), "sum " + fixed(sum, 3));
}

}  // namespace

const Block kAreas{
    .name = "areas", .meaning = "signed areas, and the weights as their quotients", .write = areas};

}  // namespace gjkscope::blocks
