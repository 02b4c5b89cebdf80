#include "effects/balance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "effects/barycentric.hpp"

namespace gjkscope {
namespace {

constexpr double kGravity = 9.81;  // m/s²
constexpr double kDamping = 0.65;  // N m s: nearly at rest after one period

double support_at(double seconds, double balance_point, const LessonTime& time) {
  constexpr double kMiddle = 0.5;
  const double along =
      (seconds / time.seconds - kSupportStarts) / (kSupportArrives - kSupportStarts);
  const double t = std::clamp(along, 0.0, 1.0);
  return kMiddle + t * t * (3.0 - 2.0 * t) * (balance_point - kMiddle);
}

/// The angle at which the ground stops an end; an arm too short to reach it has none.
double lowest(double arm, double radius) {
  const double reach = std::hypot(arm, kAxleHeight);
  const double way = kAxleHeight + kBeamHeight - radius;
  if (reach <= way) return std::numbers::pi / 2.0;
  return std::max(0.0, std::asin(way / reach) - std::atan2(kAxleHeight, std::abs(arm)));
}

/// One step of the semi-implicit Euler method for I angle'' = moment - damping * angle'.
void advance(Beam& beam, const std::array<double, 2>& masses, double step) {
  const std::array<double, 2> arms = {-beam.support, 1.0 - beam.support};
  double inertia = 0.0;
  double moment = 0.0;
  for (int i = 0; i < 2; ++i) {
    inertia += masses[i] * (arms[i] * arms[i] + kAxleHeight * kAxleHeight);
    moment -= masses[i] * kGravity *
              (arms[i] * std::cos(beam.angle) + kAxleHeight * std::sin(beam.angle));
  }
  const double before = beam.angle;
  beam.rate += step * (moment - kDamping * beam.rate) / inertia;
  beam.angle += step * beam.rate;
  // An end on the ground stays there until it is lifted, and moves as the support slides under it.
  for (int i = 0; i < 2; ++i) {
    const double arm = arms[i];
    if (arm == 0.0) continue;
    const double limit = lowest(arm, radius_of_mass(masses[i]));
    const bool down = arm < 0.0 ? beam.angle > limit : beam.angle < -limit;
    if (!down) continue;
    beam.angle = arm < 0.0 ? limit : -limit;
    beam.rate = (beam.angle - before) / step;
  }
}

}  // namespace

double radius_of_mass(double mass) {
  constexpr double kRadius = 0.07;   // of mass 1
  constexpr double kLargest = 0.12;  // beyond that a mass would stand on the ground
  return std::min(kRadius * std::sqrt(std::abs(mass)), kLargest);
}

std::vector<Beam> swing(const std::array<double, 2>& masses, double balance_point,
                        const LessonTime& time, double step) {
  std::vector<Beam> moments;
  Beam beam;
  for (int i = 0; i < time.frames; ++i) {
    const double until = time.seconds * i / (time.frames - 1);
    while (beam.seconds + step <= until) {
      beam.seconds += step;
      beam.support = support_at(beam.seconds, balance_point, time);
      advance(beam, masses, step);
    }
    moments.push_back(beam);
    moments.back().seconds = until;
  }
  return moments;
}

EffectKey Balance::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

Balance::Value Balance::compute(EffectGraph& graph, const LessonRun& run, const Frame& frame) {
  const std::vector<double>& weights = graph.get<BarycentricWeights>(frame).weights;
  Value value;
  if (weights.size() != 2 || !run.lesson.time) return value;
  value.weights = {weights[0], weights[1]};
  value.masses = {std::max(weights[0], 0.0), std::max(weights[1], 0.0)};
  value.moments = swing(value.masses, weights[1], *run.lesson.time);
  return value;
}

}  // namespace gjkscope
