#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "outlines/polygon.hpp"
#include "picture/plot.hpp"
#include "picture/solid.hpp"
#include "subjects/space/region.hpp"
#include "subjects/space/solids.hpp"
#include "subjects/space/subject.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Below all that a view shows in any run, as deep as the shapes reach.
struct Floor {
  Eigen::AlignedBox3d box;  ///< Around all that stands on it.
  double z = 0.0;
};

Floor floor_of(const SceneBuilder& scene) {
  constexpr double kBelow = 0.1;  // of the diameter
  Floor floor;
  for (const PositionedRun& run : scene.run.runs) {
    Eigen::AlignedBox3d x;
    Eigen::AlignedBox3d y;
    for (const Vector3d& vertex : run.x().world) x.extend(vertex);
    for (const Vector3d& vertex : run.y().world) y.extend(vertex);
    if (scene.view.kind == ViewKind::world) {
      floor.box.extend(x).extend(y);
    } else {
      floor.box.extend(Vector3d(Vector3d::Zero()));
      floor.box.extend(Vector3d(y.min() - x.max())).extend(Vector3d(y.max() - x.min()));
    }
  }
  floor.z = floor.box.min().z() - kBelow * floor.box.diagonal().norm();
  return floor;
}

/// The shadow of a body that light from straight above throws on the floor.
void shadow(SceneBuilder& scene, const Polyhedron& hull, const std::vector<Vector3d>& points,
            double z) {
  std::vector<Vector2d> below;
  for (const int vertex : hull.vertices) below.push_back(in_plane(points[vertex]));
  std::vector<Point> corners;
  for (const int corner : convex_hull(below)) {
    const Vector2d& at = below[corner];
    corners.push_back(scene.at(Vector3d(at.x(), at.y(), z)));
  }
  if (corners.size() > 2) scene.area("floor.shadow", corners);
}

/// Seen from below a floor would hide what stands on it.
bool has_floor(const SceneBuilder& scene) {
  constexpr double kLeast = 0.05;
  return scene.map.is_of_space() && scene.map.towards_eye(Vector3d::UnitZ()) >= kLeast;
}

void floor_and_shadows(SceneBuilder& scene) {
  if (!has_floor(scene)) return;
  const Floor floor = floor_of(scene);
  const double step = round_step(floor.box.diagonal().norm() / 8.0);
  const auto first = [&](int axis) { return std::floor(floor.box.min()[axis] / step) - 1.0; };
  const auto last = [&](int axis) { return std::ceil(floor.box.max()[axis] / step) + 1.0; };
  for (const int axis : {0, 1}) {
    const int other = 1 - axis;
    for (double i = first(axis); i <= last(axis); ++i) {
      Vector3d from(0.0, 0.0, floor.z);
      from[axis] = i * step;
      from[other] = first(other) * step;
      Vector3d to = from;
      to[other] = last(other) * step;
      scene.add("floor.line", Polyline{{scene.at(from), scene.at(to)}});
    }
  }
  if (scene.view.kind == ViewKind::world) {
    const ShapeSolids::Value& hulls = scene.effects.get<ShapeSolids>(scene.frame);
    for (std::size_t i = 0; i < hulls.size(); ++i)
      shadow(scene, hulls[i], scene.positioned.bodies[i].world, floor.z);
  } else {
    const DifferenceSolid::Value& z = scene.effects.get<DifferenceSolid>(scene.frame);
    shadow(scene, z.hull, z.points, floor.z);
  }
}

/// From the point that the question is about straight down.
void drop_line(SceneBuilder& scene) {
  const bool in_world = scene.view.kind == ViewKind::world;
  if (!has_floor(scene) || (in_world && !scene.run.point_query())) return;
  const Vector3d from = in_world ? scene.positioned.x().world.front() : Vector3d(Vector3d::Zero());
  const Vector3d foot(from.x(), from.y(), floor_of(scene).z);
  scene.line_in_space("floor.drop", from, foot);
  scene.add("floor.foot", Disk{scene.at(foot), 2.0});
}

void triad(SceneBuilder& scene) {
  if (!scene.map.is_of_space()) return;
  constexpr double kLength = 26.0;
  constexpr double kName = 36.0;
  const Rect& card = scene.map.area();
  const Point origin(card.min.x() + 46.0, card.max.y() - 40.0);
  for (const auto& [axis, name] : {std::pair(Vector3d(Vector3d::UnitX()), "x"),
                                   {Vector3d(Vector3d::UnitY()), "y"},
                                   {Vector3d(Vector3d::UnitZ()), "z"}}) {
    const Point along = scene.map.direction(axis);
    scene.add("triad", Polyline{{origin, origin + kLength * along}});
    // An axis that points at the eye has no room for its name.
    if (along.norm() > 0.25)
      scene.add("triad.name",
                Text{origin + kName * along + Point(0.0, 5.0), name, type::kTick, Align::center});
  }
  scene.out.obstacles.circles.push_back({origin, kName});
}

void region_solid(SceneBuilder& scene) {
  const RegionSolid::Value& region = scene.effects.get<RegionSolid>(scene.frame);
  std::vector<Vector3d> points;
  for (const Vector3d& point : region.points) points.emplace_back(point + scene.shift);
  if (!points.empty())
    draw_solid(scene, region.hull, points,
               scene.knows.closest_point ? "region.solid" : "region.tested");
}

void faces_before(SceneBuilder& scene) {
  if (!scene.knows.closest_point) return;
  const WideSimplex& simplex = scene.effects.get<BarycentricWeights>(scene.frame).simplex;
  for (const gjk::Face face : scene.effects.get<FacesBefore>(scene.frame)) {
    std::vector<Vector3d> corners;
    for (int i = 0; i < simplex.count; ++i) {
      if (gjk::contains(face, i)) corners.emplace_back(simplex.vertices[i].w + scene.shift);
    }
    draw_face(scene, corners, "face.before");
  }
  for (int i = 0; i < simplex.count; ++i)
    scene.line_in_space("face.way", scene.shift, simplex.vertices[i].w + scene.shift);
}

EffectKey same_in_run(const SceneBuilder& scene) { return {scene.frame.run, -1, -1}; }

}  // namespace

const Layer kFloor{.effect = {},
                   .on = Layer::On::every_view,
                   .order = 5,
                   .draw = floor_and_shadows,
                   .key = same_in_run};

const Layer kTriad{
    .effect = {}, .on = Layer::On::every_view, .order = 6, .draw = triad, .key = same_in_run};

const Layer kDropLine{
    .effect = {}, .on = Layer::On::every_view, .order = 41, .draw = drop_line, .key = same_in_run};

const Layer kRegionSolid{
    .effect = RegionSolid::kName, .on = Layer::On::every_view, .order = 40, .draw = region_solid};

const Layer kFacesBefore{
    .effect = FacesBefore::kName, .on = Layer::On::every_view, .order = 80, .draw = faces_before};

}  // namespace gjkscope::layers
