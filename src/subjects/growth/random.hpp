#pragma once
// Random numbers that are the same on every machine.

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>

namespace gjkscope {

/// The distributions of the standard library differ from one to the next; the generator does not.
class Random {
 public:
  explicit Random(int seed) : bits_(static_cast<std::uint64_t>(seed)) {}
  double uniform(double low, double high) {
    constexpr int kUnused = 11;  // bits beyond those of a double
    return low + (high - low) * std::ldexp(static_cast<double>(bits_() >> kUnused), -53);
  }

 private:
  std::mt19937_64 bits_;
};

/// A point of the unit circle, `turn` from 0 to 4: its whole part is the quadrant, the rest t is
/// tan of half the angle in it, and the point ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)). Libraries
/// round sin and cos differently.
inline Eigen::Vector2d on_circle(double turn) {
  const double quadrant = std::floor(turn);
  const double t = turn - quadrant;
  Eigen::Vector2d point((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
  Eigen::Vector2d ahead(-point.y(), point.x());
  switch (static_cast<int>(quadrant) % 4) {
    case 0:
      return point;
    case 1:
      return ahead;
    case 2:
      return -point;
    default:
      return -ahead;
  }
}

/// Evenly on the unit sphere, of sums, products, quotients and square roots alone.
inline Eigen::Vector3d on_sphere(Random& random) {
  while (true) {
    Eigen::Vector3d point;
    for (double& coordinate : point) coordinate = random.uniform(-1.0, 1.0);
    // In one order everywhere: Eigen's own sums differ with the vectors of a processor.
    const double square = point.x() * point.x() + point.y() * point.y() + point.z() * point.z();
    if (square > 0.01 && square <= 1.0) return point / std::sqrt(square);
  }
}

}  // namespace gjkscope
