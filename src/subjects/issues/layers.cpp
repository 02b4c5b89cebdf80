#include "subjects/issues/numerical_issue.hpp"
#include "subjects/issues/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::layers {
namespace {

/// Earlier places of Q, numbered as in the panel.
void earlier_places(SceneBuilder& scene) {
  for (int i = 0; i < scene.frame.run; ++i) {
    const Point q = scene.at(scene.run.runs[i].x().world[0]);
    scene.disk("query.earlier", q, sizes::kClosestRadius);
    const std::string number = std::to_string(i + 1);
    scene.out.fixed_labels.push_back(
        scene.label("place:" + number, number, "query.label", type::kSmallVertex, q, 5.0));
  }
}

}  // namespace

const Layer kEarlierPlaces{
    .effect = NumericalIssue::kName, .on = Layer::On::world, .order = 1010, .draw = earlier_places};

void issue(SceneBuilder& scene) {
  const WideState& state = scene.state;
  if (state.stop == gjk::StopReason::origin_inside) {
    const std::vector<Point> triangle = {scene.vertex_at(0), scene.vertex_at(1),
                                         scene.vertex_at(2)};
    scene.area("simplex.fill", triangle);
    for (std::size_t i = 0; i < 3; ++i)
      scene.line("simplex.edge", triangle[i], triangle[(i + 1) % 3]);
  }
  stage_step(scene);
  const NumericalIssue::Value& issue = scene.effects.get<NumericalIssue>(scene.frame);
  if (scene.frame.step >= 0 && issue.kind == NumericalIssue::Kind::direction)
    scene.search_arrow(scene.at_difference(state.p), state.d, sizes::kShortArrow, "d");
}

}  // namespace gjkscope::layers
