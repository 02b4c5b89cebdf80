#include <Eigen/Geometry>
#include <algorithm>

#include "picture/solid.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/depth/shown.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/space/solids.hpp"

namespace gjkscope::depths {
namespace {

using depth::Phase;
using Eigen::Vector3d;
using namespace sizes;

/// The polytope of a frame as pictures draw it, and its faces on the screen.
class Drawn {
 public:
  Drawn(SceneBuilder& scene, const ShownInSpace& shown) : scene_(scene), shown_(shown) {
    for (const WideVertex& corner : shown.polytope().corners) points_.push_back(corner.w);
    std::vector<int> place(shown.polytope().faces.size(), -1);
    const std::vector<int> all = shown.faces();
    bool has_area = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto [a, b, c] = shown.corners(all[i]);
      const Vector3d normal = (b - a).cross(c - a).normalized();
      has_area = has_area && normal.norm() > 0.0;
      const std::array<int, 3>& corners = shown.face(all[i]).corners;
      solid_.faces.push_back({{corners.begin(), corners.end()}, normal});
      solid_.vertices.insert(solid_.vertices.end(), corners.begin(), corners.end());
      place[all[i]] = static_cast<int>(i);
    }
    std::sort(solid_.vertices.begin(), solid_.vertices.end());
    solid_.vertices.erase(std::unique(solid_.vertices.begin(), solid_.vertices.end()),
                          solid_.vertices.end());
    for (const int face : all) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int beyond = shown.face(face).neighbours[i];
        if (beyond < face) continue;
        solid_.edges.push_back({shown.face(face).corners[i], shown.face(face).corners[(i + 1) % 3],
                                place[face], place[beyond]});
      }
    }
    if (!has_area) solid_ = hull_in_space(points_);
  }

  [[nodiscard]] bool is_in_front(int face) const {
    const auto [a, b, c] = shown_.corners(face);
    return scene_.map.towards_eye((b - a).cross(c - a)) > 0.0;
  }

  void draw() {
    marked_faces(false);
    draw_solid(scene_, solid_, points_, "simplex.solid");
    marked_faces(true);
    horizon();
    const std::vector<bool> behind = vertices_behind(scene_.map, solid_, points_.size());
    for (const int vertex : solid_.vertices) {
      const auto i = static_cast<std::size_t>(vertex);
      scene_.simplex_vertex(shown_.polytope().corners[i],
                            behind[i] ? "polytope.hidden" : "polytope");
    }
    names();
  }

 private:
  [[nodiscard]] std::vector<Point> corners(int face) const {
    std::vector<Point> out;
    for (const Vector3d& corner : shown_.corners(face)) out.push_back(scene_.at(corner));
    return out;
  }

  /// Those that the frame is about: behind the polytope, or in front.
  void marked_faces(bool in_front) {
    for (const int face : shown_.faces()) {
      if (is_in_front(face) != in_front) continue;
      const std::string end = in_front ? "" : ".hidden";
      if (shown_.is_visible(face)) scene_.area("depth.visible" + end, corners(face));
      if (shown_.is_new(face)) scene_.area("depth.new" + end, corners(face));
      if (shown_.is_nearest(face)) scene_.area("depth.face" + end, corners(face));
    }
  }

  /// The edges between faces that are visible from the support point, and those that are not.
  void horizon() {
    for (const int face : shown_.faces()) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int beyond = shown_.face(face).neighbours[i];
        const bool is_of_it = (shown_.is_visible(face) && !shown_.is_visible(beyond)) ||
                              (shown_.is_new(face) && !shown_.is_new(beyond));
        if (!is_of_it) continue;
        const bool is_hidden = !is_in_front(face) && !is_in_front(beyond);
        const std::vector<Point> ends = corners(face);
        scene_.line(is_hidden ? "depth.horizon.hidden" : "depth.horizon", ends[i],
                    ends[(i + 1) % 3]);
      }
    }
  }

  /// Names of faces: those behind have pale ones.
  void names() {
    for (const int face : shown_.faces()) {
      const bool front = is_in_front(face);
      const bool is_marked =
          shown_.is_nearest(face) || shown_.is_visible(face) || shown_.is_new(face);
      if (shown_.is_answer ? !is_marked : !front && !is_marked && scene_.frame.question < 0)
        continue;
      const std::string name = face_name(shown_.trace, face);
      const std::string role = front ? "polytope.label" : "polytope.hidden.label";
      const LabelRequest beside = scene_.label("face:" + name, name, role, type::kSmallVertex,
                                               scene_.at(shown_.middle(face)), 0.0);
      scene_.out.area_labels.push_back(
          {"face:" + name, name, role, type::kSmallVertex, corners(face), beside});
    }
  }

  SceneBuilder& scene_;
  const ShownInSpace& shown_;
  std::vector<Vector3d> points_;
  Polyhedron solid_;
};

void name_at(SceneBuilder& scene, const std::string& name, const Point& at, const Point& towards) {
  scene.out.moving_labels.push_back(scene.label("depth:" + name, name, "closest.label",
                                                type::kVertex, at, kPointRadius, towards));
}

void in_difference(SceneBuilder& scene, const ShownInSpace& shown) {
  const Point o = scene.at(Vector3d(Vector3d::Zero()));
  if (shown.is(Phase::support) || shown.has_stopped())
    scene.support_plane(shown.state.support.w, shown.state.n, "depth.plane");
  Drawn(scene, shown).draw();
  if (shown.is_answer) {
    const Point end = scene.at(shown.result.translation);
    if ((end - o).norm() > kOriginRadius) scene.arrow("difference.arrow", o, end);
    scene.disk("closest", end, kClosestRadius);
    return name_at(scene, "t", end, end - o);
  }
  if (shown.knows_nearest()) {
    const Point foot = scene.at(shown.foot());
    const bool is_apart = (foot - o).norm() > kClosestRadius;
    if (is_apart) scene.line("closest.line", o, foot);
    if (is_apart && shown.is(Phase::nearest))
      scene.length_label("distance", shown.foot().norm(), o, foot);
    if (is_apart) scene.disk("depth.foot", foot, kClosestRadius);
    scene.search_arrow(foot, shown.state.n, kShortArrow + 18.0, "n");
  }
  if (!shown.knows_support()) return;
  const std::vector<WideVertex>& corners = shown.polytope().corners;
  const WideVertex& support = shown.state.support;
  // A corner has its name already.
  if (std::none_of(corners.begin(), corners.end(),
                   [&](const WideVertex& corner) { return corner.pair == support.pair; }))
    return scene.simplex_vertex(support, "support");
  scene.diamond("support.vertex", scene.at(support.w), kSupportRadius,
                subject_of(scene.run, support.pair));
}

/// X where it just touches Y, and the way there.
void moved(SceneBuilder& scene, const DepthResult& result) {
  const ShapeSolids::Value& hulls = scene.effects.get<ShapeSolids>(scene.frame);
  std::vector<Vector3d> points;
  for (const Vector3d& vertex : scene.positioned.x().world)
    points.emplace_back(vertex + result.translation);
  if (result.depth > 0.0) draw_solid(scene, hulls[0], points, "depth.moved");
  const Point from = scene.at(result.x);
  const Point to = scene.at(result.y);
  if ((to - from).norm() > kPointRadius) {
    scene.arrow("difference.arrow", from, to);
    name_at(scene, "t", 0.5 * (from + to), Point(from.y() - to.y(), to.x() - from.x()));
  }
  scene.disk("closest", from, kClosestRadius);
  scene.disk("closest", to, kClosestRadius);
}

void in_world(SceneBuilder& scene, const ShownInSpace& shown) {
  if (shown.is_answer) return moved(scene, shown.result);
  if (scene.frame.question >= 0 && shown.is(Phase::nearest)) {
    scene.search_arrow(scene.at(middle_of(scene.positioned.y().world)), shown.state.n, kPairArrow,
                       "n");
    scene.search_arrow(scene.at(middle_of(scene.positioned.x().world)), -shown.state.n, kPairArrow,
                       "−n");
    return;
  }
  if (shown.is(Phase::nearest)) {
    for (const int corner : shown.face(shown.state.face).corners)
      scene.simplex_vertex(shown.polytope().corners[corner], "polytope");
  }
  if (!shown.knows_support()) return;
  scene.search_arrow(scene.at(scene.vertex_of_y(shown.state.support)), shown.state.n, kPairArrow,
                     "n");
  scene.search_arrow(scene.at(scene.vertex_of_x(shown.state.support)), -shown.state.n, kPairArrow,
                     "−n");
  scene.simplex_vertex(shown.state.support, "support");
}

}  // namespace

void stage_in_space(SceneBuilder& scene) {
  const ShownInSpace& shown = shown_in<ShownInSpace>(scene);
  if (shown.polytope().faces.empty()) return layers::answer(scene);
  scene.shows_difference ? in_difference(scene, shown) : in_world(scene, shown);
}

}  // namespace gjkscope::depths
