#include <fmt/format.h>

#include <algorithm>

#include "run/questions.hpp"
#include "subjects/space/subject.hpp"

namespace gjkscope::blocks {
namespace {

/// How many of the conditions of a region hold, and how many it has.
std::pair<int, int> conditions_of(const WideSimplex& simplex, gjk::Face region) {
  int holds = 0;
  int all = 0;
  for (int i = 0; i < simplex.count; ++i) {
    const bool is_in = gjk::contains(region, i);
    if (is_in && gjk::vertex_count(region) == 1) continue;
    const auto face = static_cast<gjk::Face>(region | gjk::face_of(i));
    const bool is_positive = gjk::barycentric(simplex, face).numerator[i] > 0.0;
    holds += is_positive == is_in ? 1 : 0;
    ++all;
  }
  return {holds, all};
}

void faces(PanelBuilder& panel) {
  constexpr double kHeight = 23.0;
  const int step = std::max(panel.run.gjk_step(panel.frame), 0);
  const WideSimplex& simplex = state_before(panel.run.run(panel.frame).trace, step).simplex;
  panel.write("heading", panel.left, "Region", type::kHeading);
  panel.write("heading", panel.right, "conditions that hold", type::kHeading, Align::right);
  panel.y += rows::kRow;
  const SimplexWords words(panel.run, simplex);
  const gjk::FaceList order = gjk::tested_faces(simplex.count, gjk::RegionOrder::vertices_first);
  for (int i = 0; i < order.count; ++i) {
    const gjk::Face face = order.faces[i];
    const bool tries = panel.knows.gradual;
    const bool is_reached = !tries || i <= panel.knows.tests_reached;
    const bool knows = tries ? is_reached : panel.knows.closest_point;
    const bool wins = panel.knows.closest_point && face == panel.state.region;
    const bool current = wins || (tries && i == panel.knows.tests_reached);
    if (current) panel.highlight(wins ? "highlight.pass" : "highlight");
    const TextStyle style = current ? type::kStrong : type::kBody;
    const std::string role = current ? "body" : "body.muted";
    if (tries) {
      panel.write(!is_reached ? "untried"
                  : wins      ? "pass"
                              : "fail",
                  panel.left,
                  !is_reached ? "·"
                  : wins      ? "✓"
                              : "✗",
                  type::kStrong);
    }
    panel.write(role, panel.left + (tries ? 28.0 : 8.0), words.face(face), style);
    const auto [holds, all] = conditions_of(simplex, face);
    if (knows) {
      panel.write(role, panel.right, fmt::format("{}{} of {}", wins ? "all: " : "", holds, all),
                  style, Align::right);
    }
    panel.y += kHeight;
  }
}

}  // namespace

const Block kFaces{.name = "faces",
                   .meaning =
                       "in space: the Voronoi regions of a simplex, and how many of their "
                       "conditions hold",
                   .write = faces,
                   .shown_of = ShownOf::space};

}  // namespace gjkscope::blocks
