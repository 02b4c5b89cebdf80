#include <fmt/format.h>

#include <cmath>

#include "picture/words.hpp"
#include "subjects/balance/balance.hpp"
#include "subjects/balance/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

constexpr double kFoot = 0.06;    // half the width of the support's foot, in the same unit
constexpr double kHanger = 0.07;  // half the width of what the beam hangs by, in the same unit
constexpr double kAxleRadius = 4.0;

/// A mass has its middle at its end of the beam; one that would have to be negative is only
/// outlined.
void mass(SceneBuilder& scene, int vertex, double weight, const Point& center, double radius,
          const Point& up) {
  const bool there = weight > 0.0;
  const std::string number = Numbers(scene.run.lesson).weight(weight);
  if (radius >= 1.0) {
    scene.disk(!there        ? "beam.missing"
               : vertex == 0 ? "beam.mass.u"
                             : "beam.mass.v",
               center, radius);
  }
  scene.out.moving_labels.push_back(scene.label(
      fmt::format("mass:{}", vertex),
      fmt::format("{} = {}{}", vertex == 0 ? 'u' : 'v', number,
                  weight < 0.0 ? ": no such mass" : ""),
      there ? "beam.label" : "beam.missing.label", type::kSmallVertex, center, radius, up));
}

void balance(SceneBuilder& scene) {
  const Balance::Value& value = scene.effects.get<Balance>(scene.frame);
  if (value.moments.empty()) return;
  const Beam& beam = value.moments[*beam_moment(scene.run, scene.frame)];
  const Vector2d a = in_plane(scene.state.simplex.vertices[0].w) + in_plane(scene.shift);
  const Vector2d along = in_plane(scene.state.simplex.vertices[1].w) + in_plane(scene.shift) - a;
  Vector2d up(-along.y(), along.x());
  if (up.y() < 0.0) up = -up;
  // Positions beside the segment in its own unit: along it, and upwards from the beam's level.
  const auto at = [&](double x, double y) {
    return scene.at(a + x * along + (y - kBeamDrop) * up);
  };
  const double cosine = std::cos(beam.angle);
  const double sine = std::sin(beam.angle);
  const auto on_beam = [&](double x) {
    const double arm = x - beam.support;
    return at(beam.support + arm * cosine + kAxleHeight * sine,
              kAxleHeight * (1.0 - cosine) + arm * sine);
  };
  for (const double x : {0.0, value.weights[1], 1.0})
    scene.line("beam.guide", scene.at(a + x * along), at(x, 0.0));
  constexpr double kFar = 10.0;
  const Point axle = at(beam.support, kAxleHeight);
  scene.line("beam.ground", at(-kFar, -kBeamHeight), at(kFar, -kBeamHeight));
  const std::vector<Point> support = {axle, at(beam.support - kFoot, -kBeamHeight),
                                      at(beam.support + kFoot, -kBeamHeight)};
  scene.area("beam.support", support);
  scene.outline(support);
  if (beam.support < kHanger)
    scene.line("beam.extension", on_beam(beam.support - kHanger), on_beam(0.0));
  if (beam.support > 1.0 - kHanger)
    scene.line("beam.extension", on_beam(1.0), on_beam(beam.support + kHanger));
  scene.line("beam", on_beam(0.0), on_beam(1.0));
  for (const double side : {-kHanger, kHanger})
    scene.line("beam.hanger", axle, on_beam(beam.support + side));
  scene.disk("beam.axle", axle, kAxleRadius);
  const Point lifted = (at(0.0, 1.0) - at(0.0, 0.0)).normalized();
  const Point turned = (on_beam(1.0) - on_beam(0.0)).normalized();
  const Point normal(-turned.y(), turned.x());
  const Point upright = normal.dot(lifted) < 0.0 ? Point(-normal) : normal;
  const double length = (at(1.0, 0.0) - at(0.0, 0.0)).norm();
  for (int i = 0; i < 2; ++i) {
    mass(scene, i, value.weights[i], on_beam(i), length * radius_of_mass(value.weights[i]),
         upright);
  }
  scene.out.moving_labels.push_back(scene.label("support", "support", "beam.label",
                                                type::kSmallVertex, at(beam.support, -kBeamHeight),
                                                2.0, -lifted));
}

}  // namespace

const Layer kBalance{
    .effect = gjkscope::Balance::kName, .on = Layer::On::every_view, .order = 111, .draw = balance};

}  // namespace gjkscope::layers
