#include "effects/balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture/layers/layers.hpp"
#include "picture/words.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

constexpr double kDrop = 0.47;        // of the beam below its segment, in lengths of the segment
constexpr double kFoot = 0.05;        // half the width of the support's foot, in the same unit
constexpr double kMassRadius = 24.0;  // of mass 1; areas are as masses
constexpr double kLargestRadius = 240.0;  // beyond that a mass hides the stage

double radius_of(double weight) {
  return std::min(kMassRadius * std::sqrt(std::abs(weight)), kLargestRadius);
}

/// A mass stands on its end of the beam; one that would have to be negative is only outlined.
void mass(SceneBuilder& scene, int vertex, double weight, const Point& end, const Point& up) {
  const bool there = weight > 0.0;
  const std::string number = Numbers(scene.run.lesson).weight(weight);
  const double radius = radius_of(weight);
  const Point center = end + radius * up;
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

}  // namespace

void balance(SceneBuilder& scene) {
  const Balance::Value& value = scene.effects.get<Balance>(scene.frame);
  if (value.moments.empty()) return;
  const Beam& beam = value.moments[scene.frame.detail];
  const Vector2d a = scene.state.simplex.vertices[0].w + scene.shift;
  const Vector2d along = scene.state.simplex.vertices[1].w + scene.shift - a;
  Vector2d up(-along.y(), along.x());
  if (up.y() < 0.0) up = -up;
  // Positions beside the segment in its own unit: along it, and upwards from the beam's level.
  const auto at = [&](double x, double y) { return scene.at(a + x * along + (y - kDrop) * up); };
  const auto on_beam = [&](double x) {
    const double arm = x - beam.support;
    return at(beam.support + arm * std::cos(beam.angle), arm * std::sin(beam.angle));
  };
  for (const double x : {0.0, value.weights[1], 1.0})
    scene.add("beam.guide", Polyline{{scene.at(a + x * along), at(x, 0.0)}});
  constexpr double kFar = 10.0;
  scene.line("beam.ground", at(-kFar, -kSupportHeight), at(kFar, -kSupportHeight));
  scene.area("beam.support", {at(beam.support, 0.0), at(beam.support - kFoot, -kSupportHeight),
                              at(beam.support + kFoot, -kSupportHeight)});
  if (beam.support < 0.0) scene.line("beam.extension", on_beam(beam.support), on_beam(0.0));
  if (beam.support > 1.0) scene.line("beam.extension", on_beam(1.0), on_beam(beam.support));
  scene.line("beam", on_beam(0.0), on_beam(1.0));
  const Point lifted = (at(0.0, 1.0) - at(0.0, 0.0)).normalized();
  const Point turned = (on_beam(1.0) - on_beam(0.0)).normalized();
  const Point normal(-turned.y(), turned.x());
  const Point upright = normal.dot(lifted) < 0.0 ? Point(-normal) : normal;
  mass(scene, 0, value.weights[0], on_beam(0.0), upright);
  mass(scene, 1, value.weights[1], on_beam(1.0), upright);
  scene.out.moving_labels.push_back(scene.label("support", "support", "beam.label",
                                                type::kSmallVertex,
                                                at(beam.support, -kSupportHeight), 2.0, -lifted));
}

}  // namespace gjkscope::layers
