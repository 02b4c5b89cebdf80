#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "picture/words.hpp"
#include "subjects/weights/barycentric.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

/// Frames that go through the region tests show an area only while its sign decides: when the
/// region of its edge is tested.
bool measures_tested_edge(const SceneBuilder& scene, const BarycentricParts::Part& part) {
  if (!scene.knows.gradual || part.points.size() != 3) return true;
  if (scene.knows.tests_reached < 0) return false;
  const gjk::Face tested = scene.knows.region_tests[scene.knows.tests_reached].region;
  return gjk::vertex_count(tested) == 2 && !gjk::contains(tested, part.vertex);
}

/// Lengths and areas in proportion to the barycentric coordinates.
void parts(SceneBuilder& scene) {
  if (!scene.knows.phase_is(gjk::Phase::closest)) return;
  constexpr std::array<std::string_view, 3> kRoles = {"area.u", "area.v", "area.w"};
  constexpr std::array<std::string_view, 3> kLetters = {"u", "v", "w"};
  int side = 1;
  // A negative area lies over those that are positive, a negative length beside those.
  BarycentricParts::Value parts = scene.effects.get<BarycentricParts>(scene.frame);
  std::stable_partition(parts.begin(), parts.end(),
                        [](const auto& part) { return part.weight >= 0.0; });
  for (const BarycentricParts::Part& part : parts) {
    if (!measures_tested_edge(scene, part)) continue;
    std::vector<Point> points;
    for (const Eigen::Vector3d& point : part.points) points.push_back(scene.at_difference(point));
    const std::string hue(kRoles[part.vertex]);
    const std::string role = part.weight < 0.0 ? "area.negative" : hue;
    const std::string text = fmt::format("{} = {}", kLetters[part.vertex],
                                         Numbers(scene.run.lesson).weight(part.weight));
    if (points.size() == 3) {
      scene.area(role, points);
      if (part.weight < 0.0) scene.hatched(hue + ".hatch", points);
      scene.outline(points);
      // A label that has no room in a thin area goes outside of the simplex, at the edge that the
      // area stands on. A negative area lies beyond that edge, up to Q: its label goes to the far
      // side of the longer of its other edges.
      const bool beyond = part.weight < 0.0;
      const Point q = points[0];
      const Point edge = 0.5 * (points[1] + points[2]);
      const std::string id = fmt::format("part:{}{}", part.vertex, beyond ? ":beyond" : "");
      LabelRequest outside = scene.label(id + ":outside", text, "area.label", type::kSmallVertex,
                                         edge, 4.0, edge - scene.vertex_at(part.vertex));
      outside.keeps_side = true;
      if (beyond) {
        const bool first = (points[1] - q).norm() > (points[2] - q).norm();
        const Point far = first ? points[1] : points[2];
        const Point near = first ? points[2] : points[1];
        const Point across(far.y() - q.y(), q.x() - far.x());
        outside.towards = across.dot(near - q) < 0.0 ? across : Point(-across);
        outside.anchor = 0.5 * (q + far);
        outside.other_anchors = {0.25 * q + 0.75 * far, 0.75 * q + 0.25 * far, 0.5 * (q + near)};
      }
      scene.out.area_labels.push_back(
          {id, text, "area.label", type::kSmallVertex, points, outside});
    } else {
      const Point along = points[1] - points[0];
      if (along.norm() < 1.0) continue;
      Point normal = Point(along.y(), -along.x()).normalized();
      if (normal.y() < 0.0) normal = -normal;  // below the segment on screen, one row a weight
      const Point offset = normal * kLengthOffset * side;
      scene.line(role + ".length", points[0] + offset, points[1] + offset);
      scene.out.moving_labels.push_back(
          scene.label("part:" + std::to_string(part.vertex), text, "area.label", type::kSmallVertex,
                      0.5 * (points[0] + points[1]) + offset, 3.0, normal));
    }
    ++side;
  }
}

}  // namespace

const Layer kParts{.effect = gjkscope::BarycentricParts::kName,
                   .on = Layer::On::every_view,
                   .order = 91,
                   .draw = parts};

bool shows_closest_point(const SceneBuilder& scene) {
  // Frames that measure weights along a path leave P out: it would lie on what they measure.
  const bool measures = scene.run.tour->sweeps && scene.shows(BarycentricParts::kName);
  return scene.knows.closest_point && !measures;
}

}  // namespace gjkscope::layers
