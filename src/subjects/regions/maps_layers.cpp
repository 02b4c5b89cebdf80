#include <fmt/format.h>

#include <array>
#include <cmath>

#include "picture/words.hpp"
#include "subjects/regions/sign_map.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/regions/tour.hpp"
#include "subjects/run/voronoi.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

constexpr std::array<std::string_view, 3> kCoordinates = {"u", "v", "w"};

/// The part of an intersection of half-planes that is in view; empty when there is none.
std::vector<Point> visible_part(const SceneBuilder& scene,
                                const std::vector<HalfPlane>& half_planes) {
  std::vector<Vector2d> polygon = scene.map.visible();
  for (const HalfPlane& half_plane : half_planes)
    polygon = clip(polygon, {half_plane.point + in_plane(scene.shift), half_plane.normal});
  std::vector<Point> points;
  for (const Vector2d& corner : polygon) points.push_back(scene.at(corner));
  return points;
}

/// "u, v < 0"; "u, v, w > 0" in the interior.
std::string signs_of(gjk::Face positive) {
  if (positive == 0b111) return "u, v, w > 0";
  std::string out;
  for (int i = 0; i < 3; ++i) {
    if (gjk::contains(positive, i)) continue;
    out += fmt::format("{}{}", out.empty() ? "" : ", ", kCoordinates[i]);
  }
  return out + " < 0";
}

/// An area of fewer square pixels is a border to the eye: it has no name.
constexpr double kSmallestArea = 400.0;

/// The name of an area; beside it where it is too narrow.
void add_name(SceneBuilder& scene, const std::string& id, const std::string& name,
              const TextStyle& style, const std::vector<Point>& area) {
  if (std::abs(signed_area(area)) < kSmallestArea) return;
  const Point middle = centroid(area);
  scene.out.area_labels.push_back(
      {id, name, "region.label", style, area,
       scene.label(id + ":outside", name, "region.label", style, middle, 0.0)});
}

/// The single coordinate whose sign a map shows, or none.
std::optional<int> coordinate_of(const SceneBuilder& scene) {
  const auto stage = map_stage(scene.run, scene.frame);
  if (stage && *stage == MapStage::negative_u) return 0;
  if (stage && *stage == MapStage::negative_v) return 1;
  if (stage && *stage == MapStage::negative_w) return 2;
  return std::nullopt;
}

/// Draws the line on which a coordinate is 0: its edge, prolonged.
void zero_line(SceneBuilder& scene, int vertex) {
  const Point a = scene.vertex_at((vertex + 1) % 3);
  const Point b = scene.vertex_at((vertex + 2) % 3);
  const Point along = (b - a).normalized();
  const double reach = scene.map.area().size().norm();
  scene.line("sign.border", a - reach * along, b + reach * along);
}

void signs(SceneBuilder& scene) {
  if (!scene.knows.phase_is(gjk::Phase::closest)) return;
  const auto stage = map_stage(scene.run, scene.frame);
  if (stage && *stage == MapStage::voronoi) return;
  const std::optional<int> coordinate = coordinate_of(scene);
  const bool interior_only = stage && *stage == MapStage::interior;
  // Two fills that shine through each other could not be told apart.
  const bool lines_only = stage && *stage >= MapStage::blended;
  for (const SignMap::Region& region : scene.effects.get<SignMap>(scene.frame)) {
    if (lines_only || (interior_only && region.positive != 0b111)) continue;
    std::vector<HalfPlane> half_planes = region.half_planes;
    std::string name = signs_of(region.positive);
    if (coordinate) {
      // One region that has this coordinate alone negative knows the whole half-plane.
      if (region.positive != (0b111 & ~gjk::face_of(*coordinate))) continue;
      half_planes = {region.half_planes[*coordinate]};
      name = fmt::format("{} < 0", kCoordinates[*coordinate]);
    }
    const std::vector<Point> points = visible_part(scene, half_planes);
    if (points.empty()) continue;
    constexpr std::array<std::string_view, 4> kKinds = {"", "two", "one", "none"};
    scene.area(fmt::format("sign.{}", kKinds[gjk::vertex_count(region.positive)]), points);
    add_name(scene, "sign:" + name, name, type::kRegion, points);
  }
  if (scene.state.simplex.count != 3) return;
  for (int i = 0; i < 3; ++i) {
    if (!coordinate || *coordinate == i) zero_line(scene, i);
  }
}

}  // namespace

const Layer kSigns{
    .effect = gjkscope::SignMap::kName, .on = Layer::On::every_view, .order = 20, .draw = signs};

namespace {

void map_difference(SceneBuilder& scene) {
  if (!scene.knows.phase_is(gjk::Phase::closest)) return;
  if (map_stage(scene.run, scene.frame).value_or(MapStage::difference) != MapStage::difference)
    return;
  const SimplexWords words(scene.run, scene.state.simplex);
  for (const MapDifference::Part& part : scene.effects.get<MapDifference>(scene.frame)) {
    const std::vector<Point> points = visible_part(scene, part.half_planes);
    if (points.size() < 3) continue;
    scene.area("map.difference", points);
    const std::string name =
        fmt::format("signs {}, closest {}", words.face(part.by_signs), words.face(part.closest));
    add_name(scene, "difference:" + name, name, type::kSmallVertex, points);
  }
}

}  // namespace

const Layer kMapDifference{.effect = gjkscope::MapDifference::kName,
                           .on = Layer::On::every_view,
                           .order = 30,
                           .draw = map_difference};

}  // namespace gjkscope::layers
