#include <fmt/format.h>

#include "picture/words.hpp"
#include "subjects/weights/projection.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

constexpr double kAngleMark = 11.0;    // side of the square that says "normal"
constexpr double kArrowOffset = 16.0;  // of the unit vector from its segment
constexpr double kProjectedRadius = 5.0;
constexpr double kOwnRoom = 14.0;  // around G: the name of a vertex there would read as its own

/// Upwards on the screen, normal to the line from `a` to `b`.
Point upwards(const Point& a, const Point& b) {
  const Point along = (b - a).normalized();
  const Point normal(along.y(), -along.x());
  return normal.y() > 0.0 ? Point(-normal) : normal;
}

void projection(SceneBuilder& scene) {
  const Projection::Value& g = scene.effects.get<Projection>(scene.frame);
  if (!g) return;
  const Point a = scene.vertex_at(0);
  const Point b = scene.vertex_at(1);
  const Point foot = scene.at_difference(*g);
  const Point q = scene.at_difference(Vector2d::Zero());
  const Point along = (b - a).normalized();
  const double reach = scene.map.area().size().norm();
  scene.line("projection.axis", a - reach * along, a);
  scene.line("projection.axis", b, b + reach * along);
  const double height = (q - foot).norm();
  if (height < 1.0) return;  // Q itself
  if (scene.frame.question >= 0 && scene.frame.step < 0) return;
  const bool is_p = shows_closest_point(scene) && gjk::vertex_count(scene.state.region) == 2;
  if (!is_p) scene.line("projection.line", q, foot);
  if (height > 2.0 * kAngleMark) {
    const Point up = (q - foot) / height;
    const Point inwards = (0.5 * (a + b) - foot).dot(along) < 0.0 ? Point(-along) : along;
    const Point corner = foot + kAngleMark * (inwards + up);
    const Point along_line = foot + kAngleMark * inwards;
    const Point along_height = foot + kAngleMark * up;
    scene.add("projection.angle", Polyline{{along_line, corner, along_height}});
    scene.out.obstacles.segments.push_back({along_line, corner});
    scene.out.obstacles.segments.push_back({corner, along_height});
  }
  if (is_p) return;
  scene.square("projection.point", foot, kProjectedRadius);
  scene.out.obstacles.circles.push_back({foot, kOwnRoom});
  scene.out.moving_labels.push_back(
      scene.label("G", "G", "projection.label", type::kVertex, foot, kOwnRoom - 2.0, foot - q));
}

}  // namespace

const Layer kProjection{.effect = gjkscope::Projection::kName,
                        .on = Layer::On::every_view,
                        .order = 80,
                        .draw = projection};

namespace {

void unit_vector(SceneBuilder& scene) {
  const UnitVector::Value& built = scene.effects.get<UnitVector>(scene.frame);
  if (!built) return;
  const Eigen::Vector3d& a = scene.state.simplex.vertices[0].w;
  const Point offset = kArrowOffset * upwards(scene.vertex_at(0), scene.vertex_at(1));
  const Point from = scene.at_difference(a) + offset;
  const Point to = scene.at_difference(a + built->n) + offset;
  scene.arrow("unit-vector", from, to);
  scene.out.moving_labels.push_back(
      scene.label("n", "n", "unit-vector.label", type::kVertex, 0.5 * (from + to), 2.0, offset));
  if (!scene.knows.phase_is(gjk::Phase::closest)) return;
  // The arrow from Q to B, and how far it reaches along n: as far as G is from B.
  const Point q = scene.at_difference(Vector2d::Zero());
  const Point b = scene.vertex_at(1);
  const Point reach = scene.at_difference(Eigen::Vector3d(built->of_q.to_b * built->n));
  if ((reach - q).cwiseAbs().maxCoeff() < 1.0 || (reach - b).norm() < kAngleMark) return;
  scene.line(built->of_q.to_b < 0.0 ? "area.negative.length" : "area.u.length", q, reach);
  scene.arrow("ghost.arrow", q, b);
  const std::string name = scene.run.pair_name(scene.state.simplex.vertices[1].pair);
  scene.out.moving_labels.push_back(
      scene.label("reach", fmt::format("dot({} − {}, n)", name, query_name(scene.run)),
                  "area.label", type::kSmallVertex, 0.5 * (q + reach), 3.0, reach - b));
  scene.line("projection.line", reach, b);
}

}  // namespace

const Layer kUnitVector{.effect = gjkscope::UnitVector::kName,
                        .on = Layer::On::every_view,
                        .order = 100,
                        .draw = unit_vector};

}  // namespace gjkscope::layers
