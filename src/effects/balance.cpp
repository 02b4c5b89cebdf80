#include "effects/balance.hpp"

#include <algorithm>
#include <cmath>

#include "effects/barycentric.hpp"

namespace gjkscope {
namespace {

constexpr double kGravity = 9.81;  // m/s²
constexpr double kHang = 0.15;     // m below the beam: a period of about three seconds
constexpr double kDamping = 0.65;  // N m s: nearly at rest after one period

double support_at(double seconds, double balance_point, const LessonTime& time) {
  constexpr double kMiddle = 0.5;
  const double along =
      (seconds / time.seconds - kSupportStarts) / (kSupportArrives - kSupportStarts);
  const double t = std::clamp(along, 0.0, 1.0);
  return kMiddle + t * t * (3.0 - 2.0 * t) * (balance_point - kMiddle);
}

/// One step of the semi-implicit Euler method for I angle'' = moment - damping * angle'.
void advance(Beam& beam, const std::array<double, 2>& masses, double step) {
  const std::array<double, 2> arms = {-beam.support, 1.0 - beam.support};
  double inertia = 0.0;
  double moment = 0.0;
  for (int i = 0; i < 2; ++i) {
    inertia += masses[i] * (arms[i] * arms[i] + kHang * kHang);
    moment -=
        masses[i] * kGravity * (arms[i] * std::cos(beam.angle) + kHang * std::sin(beam.angle));
  }
  const double before = beam.angle;
  beam.rate += step * (moment - kDamping * beam.rate) / inertia;
  beam.angle += step * beam.rate;
  // An end on the ground stays there until it is lifted, and moves as the support slides under it.
  for (const double arm : arms) {
    if (arm == 0.0) continue;
    const double limit = std::asin(std::min(1.0, kSupportHeight / std::abs(arm)));
    const bool down = arm < 0.0 ? beam.angle > limit : beam.angle < -limit;
    if (!down) continue;
    beam.angle = arm < 0.0 ? limit : -limit;
    beam.rate = (beam.angle - before) / step;
  }
}

}  // namespace

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
