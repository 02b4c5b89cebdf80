#pragma once
// Pairs that meet, of every family, and what is asked of their depths.

#include "algorithms/depth/depth.hpp"
#include "truth.hpp"

namespace test {

/// A pair of the family; one that is apart is moved so that the shapes meet: in a common vertex
/// (but for rounding), somewhat deeper than that, or with their means in one place.
[[nodiscard]] inline Pair meeting_pair(families::Source& source, families::Family family,
                                       families::Representation representation) {
  Pair pair = source.pair<double>(family, representation);
  const bool as_it_is = source.with_chance(0.25);
  if (as_it_is && gjk::distance(pair.query()).verdict != gjk::Verdict::separated) return pair;
  const auto one_of = [&](const std::vector<Eigen::Vector2d>& points,
                          const gjk::Pose<double, 2>& pose) {
    const int i = source.among(0, static_cast<int>(points.size()) - 1);
    return Eigen::Vector2d(pose.rotated(points[static_cast<std::size_t>(i)]) + pose.translation);
  };
  const auto mean_of = [](const std::vector<Eigen::Vector2d>& points,
                          const gjk::Pose<double, 2>& pose) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : points) sum += p / static_cast<double>(points.size());
    return Eigen::Vector2d(pose.rotated(sum) + pose.translation);
  };
  const Eigen::Vector2d between_means = mean_of(pair.x, pair.x_pose) - mean_of(pair.y, pair.y_pose);
  Eigen::Vector2d by = between_means;
  if (source.with_chance(0.7)) {
    by = one_of(pair.x, pair.x_pose) - one_of(pair.y, pair.y_pose);
    const double deeper = source.with_chance(0.5) ? source.magnitude(1e-12, 0.5) : 0.0;
    by += (between_means - by) * deeper;
  }
  if (pair.x_pose.rotation.turns() || pair.y_pose.rotation.turns()) {
    pair.y_pose.translation += by;
  } else {
    for (Eigen::Vector2d& p : pair.y) p += by;
  }
  return representation == families::Representation::float_values
             ? families::rounded_to_floats(pair)
             : pair;
}

/// The most that lengths may be off, in u * scale.
inline const Judgement kBars = {"", 4, 16, 8, 8};

/// What breaks a bar or a claim, or "".
template <class R>
[[nodiscard]] std::string broken_bar(const depth::Result<R>& result, const Judgement& found,
                                     const Judgement& bars) {
  if (!found.broken.empty()) return found.broken;
  if (result.stop == depth::StopReason::iteration_cap) return "iteration cap";
  if (!(found.error <= bars.error)) return "error";
  if (!(found.width <= bars.width)) return "width";
  if (!(found.touch <= bars.touch)) return "touch";
  if (!(found.contact <= bars.contact)) return "contact";
  return "";
}

/// A power of two times the pair has the same depth, times that power, to the bit. Holds where
/// nothing becomes denormal.
[[nodiscard]] inline bool keeps_bits_when_scaled(const Pair& pair,
                                                 const depth::Result<double>& result,
                                                 int exponent) {
  if (result.error != gjk::Error::none || !(1e-150 < result.depth)) return true;
  Pair larger = pair;
  bool has_room = true;
  const auto scale = [&](Eigen::Vector2d& v) {
    for (int i = 0; i < 2; ++i) {
      v[i] = std::ldexp(v[i], exponent);
      has_room = has_room && (v[i] == 0 || (1e-200 < std::abs(v[i]) && std::abs(v[i]) < 1e200));
    }
  };
  for (std::vector<Eigen::Vector2d>* points : {&larger.x, &larger.y}) {
    for (Eigen::Vector2d& p : *points) scale(p);
  }
  scale(larger.x_pose.translation);
  scale(larger.y_pose.translation);
  if (!has_room) return true;
  const auto scaled = depth::penetration<double>(larger.query());
  const auto as_before = [&](double a) { return std::ldexp(a, exponent); };
  return scaled.depth == as_before(result.depth) && scaled.lower == as_before(result.lower) &&
         scaled.upper == as_before(result.upper) && scaled.direction == result.direction &&
         scaled.settled == result.settled && scaled.iterations == result.iterations;
}

}  // namespace test
