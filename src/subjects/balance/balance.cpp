#include "subjects/balance/balance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "subjects/balance/subject.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope {
namespace {

constexpr double kGravity = 9.81;  // m/s²
constexpr double kDamping = 1.0;   // N m s: about critical, so that a beam swings back and rests

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
  const double height = kAxleHeight + kBeamHeight - radius;
  if (reach <= height) return std::numbers::pi / 2.0;
  return std::max(0.0, std::asin(height / reach) - std::atan2(kAxleHeight, std::abs(arm)));
}

/// The forces on a beam.
struct Swing {
  std::array<double, 2> masses;
  double balance_point;
  const LessonTime& time;

  [[nodiscard]] double support(double seconds) const {
    return support_at(seconds, balance_point, time);
  }

  /// angle'' of I angle'' = moment - damping * angle'.
  [[nodiscard]] double acceleration(const Beam& beam) const {
    const std::array<double, 2> across = arms_of(beam);
    double inertia = 0.0;
    for (int i = 0; i < 2; ++i) {
      const double along = i == 0 ? beam.support : 1.0 - beam.support;
      inertia += masses[i] * (along * along + kAxleHeight * kAxleHeight);
    }
    const double moment = kGravity * (masses[0] * across[0] - masses[1] * across[1]);
    return (moment - kDamping * beam.rate) / inertia;
  }

  /// The angle at which the ground stops end `i`, on a support as at a moment; none where the
  /// support is right under the end.
  [[nodiscard]] std::optional<double> limit(int i, double seconds) const {
    const double arm = i - support(seconds);
    if (arm == 0.0) return std::nullopt;
    const double angle = lowest(arm, radius_of_mass(masses[i]));
    return arm < 0.0 ? angle : -angle;
  }
};

/// One step of the midpoint method.
void advance(Beam& beam, const Swing& swing, double step) {
  Beam middle = beam;
  middle.seconds += 0.5 * step;
  middle.support = swing.support(middle.seconds);
  middle.angle += 0.5 * step * beam.rate;
  middle.rate += 0.5 * step * swing.acceleration(beam);
  beam.seconds += step;
  beam.support = swing.support(beam.seconds);
  beam.angle += step * middle.rate;
  beam.rate += step * swing.acceleration(middle);
  beam.on_ground = false;
  // An end on the ground stays there until it is lifted, and moves as the support slides under it.
  for (int i = 0; i < 2; ++i) {
    const std::optional<double> limit = swing.limit(i, beam.seconds);
    if (!limit || (*limit > 0.0 ? beam.angle <= *limit : beam.angle >= *limit)) continue;
    const double before = swing.limit(i, beam.seconds - 0.5 * step).value_or(*limit);
    const double after = swing.limit(i, beam.seconds + 0.5 * step).value_or(*limit);
    beam.angle = *limit;
    beam.rate = (after - before) / step;
    beam.on_ground = true;
  }
}

}  // namespace

double radius_of_mass(double mass) {
  constexpr double kRadius = 0.07;   // of mass 1
  constexpr double kLargest = 0.12;  // beyond that a mass would stand on the ground
  return std::min(kRadius * std::sqrt(std::abs(mass)), kLargest);
}

std::array<double, 2> arms_of(const Beam& beam) {
  const double sideways = kAxleHeight * std::sin(beam.angle);
  return {beam.support * std::cos(beam.angle) - sideways,
          (1.0 - beam.support) * std::cos(beam.angle) + sideways};
}

double seconds_of(const LessonRun& run, const Frame& frame) {
  const int moment = *beam_moment(run, frame);
  return run.lesson.settings.as<LessonTime>()->at(frame.run)[moment];
}

std::vector<Beam> swing(const std::array<double, 2>& masses, double balance_point,
                        const LessonTime& time, int position, double step) {
  const Swing pulls{masses, balance_point, time};
  std::vector<Beam> moments;
  Beam beam;
  for (const double until : time.at(position)) {
    while (beam.seconds + step <= until) advance(beam, pulls, step);
    // The rest of the way is one of this moment alone: the steps are the same whoever looks.
    moments.push_back(beam);
    if (until > beam.seconds) advance(moments.back(), pulls, until - beam.seconds);
  }
  return moments;
}

EffectKey Balance::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

Balance::Value Balance::compute(EffectGraph& graph, const LessonRun& run, const Frame& frame) {
  const std::vector<double>& weights = graph.get<BarycentricWeights>(frame).weights;
  Value value;
  if (weights.size() != 2 || !run.lesson.settings.as<LessonTime>()) return value;
  value.weights = {weights[0], weights[1]};
  value.masses = {std::max(weights[0], 0.0), std::max(weights[1], 0.0)};
  value.moments = swing(value.masses, weights[1], *run.lesson.settings.as<LessonTime>(), frame.run);
  return value;
}

const EffectInfo effect_infos::kBalance = effect_info<Balance>(
    "view", "a beam with masses u and v, swinging on its support; needs tour `time`", "time");

}  // namespace gjkscope
