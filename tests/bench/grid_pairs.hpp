#pragma once
// The pairs that libraries are timed on: X stands at the identity, Y is turned and moved. All
// numbers are floats, kept as doubles, so that every library sees the same shapes.

#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "gjk/gjk.hpp"
#include "study/families.hpp"

namespace bench {

using Point = gjk::Vec<double, 2>;
using Pair = families::Pair<double>;

/// How the two shapes, each about 2 across, stand to each other.
struct Spacing {
  const char* name;
  double gap;  ///< Their distance; negative: the distance of their centres, which lie inside both.
};
inline constexpr Spacing kSpacings[] = {
    {"separated", 1.0}, {"gap 1e-3", 1e-3}, {"gap 1e-6", 1e-6}, {"overlap", -0.2}};

class PairSource {
 public:
  explicit PairSource(std::uint64_t seed) : bits_(seed) {}

  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }

  /// A pair of strictly convex polygons, counter-clockwise, of `count` vertices each.
  [[nodiscard]] Pair pair(int count, const Spacing& spacing) {
    for (int tries = 0; tries < 1000; ++tries) {
      Pair out{polygon(count), polygon(count), {}, turned(between(0.0, kTurn))};
      const double bearing = between(0.0, kTurn);
      const Point away(std::cos(bearing), std::sin(bearing));
      if (spacing.gap < 0.0) {
        out = placed(out, away * -spacing.gap);
        if (gjk::distance(out.query()).distance == 0.0) return out;
        continue;
      }
      out = placed(out, away * 5.0);
      // Along the shortest connection nothing else comes in between.
      const gjk::Result<double, 2> apart = gjk::distance(out.query());
      const Point connection = apart.y - apart.x;
      out = placed(out, away * 5.0 - connection * (1.0 - spacing.gap / apart.distance));
      // Rounded to float, the gap has changed a little.
      if (std::abs(gjk::distance(out.query()).distance - spacing.gap) < 0.2 * spacing.gap)
        return out;
    }
    throw std::logic_error("no pair with the spacing wanted");
  }

  [[nodiscard]] std::vector<Pair> pairs(std::size_t how_many, int count, const Spacing& spacing) {
    std::vector<Pair> out;
    for (std::size_t i = 0; i < how_many; ++i) out.push_back(pair(count, spacing));
    return out;
  }

 private:
  static constexpr double kTurn = 6.283185307179586;

  [[nodiscard]] std::vector<Point> polygon(int count) {
    std::vector<Point> vertices;
    const double begin = between(0.0, kTurn);
    const double width = between(0.6, 1.0);
    for (int i = 0; i < count; ++i) {
      const double angle = begin + kTurn * (i + between(-0.25, 0.25)) / count;
      vertices.emplace_back(std::cos(angle), width * std::sin(angle));
    }
    return vertices;
  }

  [[nodiscard]] static gjk::Pose<double, 2> turned(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    gjk::Pose<double, 2> pose;
    pose.rotation = Eigen::Matrix2d{{c, -s}, {s, c}};
    return pose;
  }

  /// With the origin of Y at `place`, all numbers rounded to floats.
  [[nodiscard]] static Pair placed(Pair pair, const Point& place) {
    pair.y_pose.translation = place;
    return families::rounded_to_floats(pair);
  }

  std::mt19937_64 bits_;
};

}  // namespace bench
