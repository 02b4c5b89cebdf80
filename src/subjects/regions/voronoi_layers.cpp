#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "picture/words.hpp"
#include "run/questions.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/regions/tour.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/run/voronoi.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

/// The verdict of the region tests on a face so far; frames may reveal them one by one.
enum class RegionFate { untried, rejected, testing, holds };
RegionFate fate_of(const SceneBuilder& scene, gjk::Face face) {
  const auto& tests = scene.knows.region_tests;
  const int reached = scene.knows.tests_reached;
  for (int i = 0; i <= reached; ++i) {
    if (tests[i].region != face) continue;
    if (tests[i].holds) return RegionFate::holds;
    return i == reached && scene.knows.gradual ? RegionFate::testing : RegionFate::rejected;
  }
  return RegionFate::untried;
}

/// Frames before the one that answers which region holds Q show those regions alone that its tests
/// have ruled out: where the others are would be the answer.
bool keeps_answer_back(const SceneBuilder& scene) {
  const LessonRun& run = scene.run;
  const Frame& frame = scene.frame;
  if (!scene.knows.gradual || scene.knows.closest_point) return false;
  return std::any_of(run.frames.begin(), run.frames.end(), [&](const Frame& other) {
    return other.run == frame.run && other.question >= 0 &&
           run.asked(other).ask == asks::kRegion.name;
  });
}

/// Each region's border once: the normals of every edge at its ends, outwards. A border is drawn
/// where a region on one of its sides is.
template <class IsDrawn>
void borders(SceneBuilder& scene, const IsDrawn& is_drawn) {
  const WideSimplex& simplex = scene.state.simplex;
  const double reach = (scene.map.visible()[2] - scene.map.visible()[0]).norm();
  for (int i = 0; i < simplex.count; ++i) {
    for (int j = i + 1; j < simplex.count; ++j) {
      const Vector2d a = in_plane(simplex.vertices[i].w) + in_plane(scene.shift);
      const Vector2d b = in_plane(simplex.vertices[j].w) + in_plane(scene.shift);
      const Vector2d edge = b - a;
      if (edge.norm() == 0.0) continue;
      Vector2d outwards = Vector2d(edge.y(), -edge.x()).normalized();
      const bool triangle = simplex.count == 3;
      if (triangle &&
          outwards.dot(in_plane(simplex.vertices[3 - i - j].w) + in_plane(scene.shift) - a) > 0.0)
        outwards = -outwards;
      const auto face = static_cast<gjk::Face>(gjk::face_of(i) | gjk::face_of(j));
      for (const int vertex : {i, j}) {
        if (!is_drawn(face) && !is_drawn(gjk::face_of(vertex))) continue;
        const Vector2d& end = vertex == i ? a : b;
        scene.line("region.border", scene.at(triangle ? end : Vector2d(end - reach * outwards)),
                   scene.at(end + reach * outwards));
      }
    }
  }
}

void regions(SceneBuilder& scene) {
  if (!scene.knows.phase_is(gjk::Phase::closest)) return;
  const auto map = map_stage(scene.run, scene.frame);
  if (map && *map > MapStage::voronoi && *map < MapStage::blended) return;
  if (map && *map == MapStage::difference) return borders(scene, [](gjk::Face) { return true; });
  const bool untried_are_drawn = !keeps_answer_back(scene);
  const auto is_drawn = [&](gjk::Face face) {
    return untried_are_drawn || fate_of(scene, face) != RegionFate::untried;
  };
  const SimplexWords words(scene.run, scene.state.simplex);
  for (const VoronoiRegions::Region& region : scene.effects.get<VoronoiRegions>(scene.frame)) {
    std::vector<Vector2d> polygon = scene.map.visible();
    for (const HalfPlane& half_plane : region.half_planes) {
      polygon = clip(polygon, {half_plane.point + in_plane(scene.shift), half_plane.normal});
    }
    if (polygon.empty()) continue;
    std::vector<Point> points;
    for (const Vector2d& corner : polygon) points.push_back(scene.at(corner));
    constexpr std::array<std::string_view, 4> kKinds = {"", "vertex", "edge", "interior"};
    const RegionFate fate = fate_of(scene, region.face);
    std::string role = fmt::format("region.{}", kKinds[gjk::vertex_count(region.face)]);
    if (fate == RegionFate::holds && !map) role = "region.active";
    if (scene.knows.gradual && fate == RegionFate::rejected) role = "region.rejected";
    if (fate == RegionFate::testing) role = "region.testing";
    if (!is_drawn(region.face)) role = "region.hidden";
    const bool is_ruled_out = role == "region.rejected";
    scene.area(std::move(role), points, {Subject::Kind::region, region.face});
    if (is_ruled_out) scene.hatched("region.hatch", points);
    if (!is_drawn(region.face)) continue;
    const bool interior = gjk::vertex_count(region.face) == 3;
    const std::string name = interior ? "interior" : "region " + words.face(region.face);
    scene.out.area_labels.push_back(
        {"region:" + name, name, "region.label", type::kRegion, points, {}});
  }
  borders(scene, is_drawn);
}

}  // namespace

const Layer kRegions{.effect = gjkscope::VoronoiRegions::kName,
                     .on = Layer::On::every_view,
                     .order = 10,
                     .draw = regions};

}  // namespace gjkscope::layers
