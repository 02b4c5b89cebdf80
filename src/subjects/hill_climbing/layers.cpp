#include <algorithm>

#include "picture/solid.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/hill_climbing/growth.hpp"
#include "subjects/hill_climbing/shown.hpp"
#include "subjects/space/solids.hpp"

namespace gjkscope::climbs {
namespace {

using Eigen::Vector3d;
using namespace sizes;

/// Whether an edge lies behind its body.
bool is_behind(const SceneBuilder& scene, const Shown& shown, int from, int to) {
  const Polyhedron& solid = scene.effects.get<ShapeSolids>(scene.frame)[shown.body()];
  const auto edge = std::find_if(solid.edges.begin(), solid.edges.end(), [&](const auto& each) {
    return each.from == std::min(from, to) && each.to == std::max(from, to);
  });
  if (edge == solid.edges.end() || edge->left < 0) return false;
  const std::vector<bool> front = faces_in_front(scene.map, solid);
  return !front[edge->left] && !front[edge->right];
}

/// The plane through a vertex normal to d, and d at its upper end, where it hides no edge.
void plane(SceneBuilder& scene, const Vector3d& vertex, const Vector3d& d,
           const std::string& name) {
  constexpr double kOfView = 0.2;  // half a side, of the view's height
  const double half = kOfView * scene.map.area().size().y() / scene.map.scale();
  const Vector3d n = d.normalized();
  draw_plane(scene, vertex, n, half, "support.plane");
  const Vector3d up = scene.map.axes().row(1).transpose();
  const Vector3d in_plane = up - n * n.dot(up);
  const double length = in_plane.norm();
  constexpr double kSeen = 0.1;
  const Vector3d from = length > kSeen ? Vector3d(vertex + 0.8 * half / length * in_plane) : vertex;
  scene.search_arrow(scene.at(from), d, kArrowLength, name);
}

void walk_line(SceneBuilder& scene, const Shown& shown, const climbing::Walk& walk, int looks) {
  for (int i = 0; i + 1 < looks; ++i) {
    const int from = walk.looks[i].at;
    const int to = walk.looks[static_cast<std::size_t>(i) + 1].at;
    scene.add(is_behind(scene, shown, from, to) ? "climb.path.hidden" : "climb.path",
              Polyline{{scene.at(shown.at(from)), scene.at(shown.at(to))}});
    scene.disk("path.point", scene.at(shown.at(from)), kVertexRadius, shown.subject(from));
  }
}

void step(SceneBuilder& scene, const Shown& shown) {
  const climbing::Look& look = shown.look();
  const Vector3d& d = shown.climb().walk.d;
  const Point now = scene.at(shown.at(look.at));
  plane(scene, shown.at(look.at), d, shown.d());
  for (const int end : shown.neighbours()) {
    if (end == look.next && !shown.asks) continue;
    scene.add(is_behind(scene, shown, look.at, end) ? "climb.edge.hidden" : "climb.edge",
              Polyline{{now, scene.at(shown.at(end))}});
  }
  walk_line(scene, shown, shown.climb().walk, shown.trace.all[shown.step].look + 1);
  if (!shown.asks && look.next >= 0) scene.arrow("climb.move", now, scene.at(shown.at(look.next)));
  if (look.next < 0 && !shown.asks) {
    scene.diamond("support.vertex", now, kSupportRadius, shown.subject(look.at));
  } else {
    scene.disk("path.now", now, kSimplexRadius, shown.subject(look.at));
  }
}

/// All walks, and the support points that they found.
void all_walks(SceneBuilder& scene, const Frame& frame) {
  Frame each = frame;
  for (const bool ends : {false, true}) {
    for (each.step = 0; each.step < scene.run.algorithm_trace(frame).steps(); ++each.step) {
      const Shown shown(scene.run, each);
      const climbing::Look& look = shown.look();
      if (look.next >= 0) continue;
      const climbing::Walk& walk = shown.climb().walk;
      if (!ends) walk_line(scene, shown, walk, static_cast<int>(walk.looks.size()));
      if (ends)
        scene.diamond("support.vertex", scene.at(shown.at(look.at)), kSupportRadius,
                      shown.subject(look.at));
    }
  }
}

}  // namespace

bool fill(SceneBuilder& scene, const Fonts& fonts) {
  if (scene.view.kind != ViewKind::plot && !after_of(scene.run, scene.frame)) return false;
  layers::add_plot(scene, climb_plot(scene.effects.get<ClimbGrowth>(scene.frame)), fonts);
  return true;
}

void stage(SceneBuilder& scene) {
  const Shown shown(scene.run, scene.frame);
  if (scene.view.kind != ViewKind::world || shown.trace.steps() == 0) return;
  if (shown.is_answer && !shown.asks) return all_walks(scene, scene.frame);
  if (shown.step >= 0) return step(scene, shown);
  const Shown first(scene.run, {.run = scene.frame.run, .step = 0});
  scene.disk("path.now", scene.at(first.at(first.look().at)), kSimplexRadius,
             first.subject(first.look().at));
}

}  // namespace gjkscope::climbs
