#include <fmt/format.h>

#include <algorithm>

#include "gjk/regions.hpp"
#include "run/questions.hpp"
#include "subjects/space/region.hpp"
#include "subjects/space/subject.hpp"

namespace gjkscope::blocks {
namespace {

void faces(PanelBuilder& panel) {
  constexpr double kHeight = 23.0;
  // Once P is known, its simplex is that of the closest-point step, before any vertex is dropped.
  const std::vector<WideStep>& steps = panel.run.run(panel.frame).trace.steps;
  const bool tries = panel.knows.gradual;
  int step = panel.run.gjk_step(panel.frame);
  while (step > 0 && steps[step].phase != gjk::Phase::closest) --step;
  const bool is_tested = step >= 0 && (tries || panel.knows.closest_point);
  const WideSimplex& simplex = is_tested
                                   ? state_before(panel.run.run(panel.frame).trace, step).simplex
                                   : panel.state.simplex;
  const gjk::Face region = is_tested ? steps[step].after.region : 0;
  panel.write("heading", panel.left, "Region", type::kHeading);
  panel.write("heading", panel.right, "conditions that hold", type::kHeading, Align::right);
  panel.y += rows::kRow;
  const SimplexWords words(panel.run, simplex);
  const gjk::FaceList order = gjk::tested_faces(simplex.count, gjk::RegionOrder::vertices_first);
  for (int i = 0; i < order.count; ++i) {
    const gjk::Face face = order[i];
    const bool is_reached = !tries || i <= panel.knows.tests_reached;
    const bool knows = tries ? is_reached : panel.knows.closest_point;
    const bool wins = panel.knows.closest_point && face == region;
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
    if (knows) {
      const std::vector<RegionCondition> conditions = conditions_of(simplex, face);
      const auto holds =
          std::count_if(conditions.begin(), conditions.end(), [&](const RegionCondition& each) {
            const double weight = gjk::barycentric(simplex, each.face).numerator[each.vertex];
            return (weight > 0.0) == each.wants_positive;
          });
      panel.write(role, panel.right,
                  fmt::format("{}{} of {}", wins ? "all: " : "", holds, conditions.size()), style,
                  Align::right);
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
