#pragma once
// The pairs that libraries are timed on: X stands at the identity, Y is turned and moved, by a pose
// or with its vertices. All numbers are floats, kept as doubles, so that every library sees the
// same shapes.

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "gjk/gjk.hpp"
#include "study/families.hpp"

namespace bench {

template <int D>
using Point = gjk::Vec<double, D>;
template <int D>
using Pair = families::Pair<double, D>;

/// How the two shapes, each about 2 across, stand to each other.
struct Spacing {
  const char* name;
  double gap;  ///< Their distance; negative: the distance of their centers, which lie inside both.
};
inline constexpr Spacing kSpacings[] = {
    {"separated", 1.0}, {"gap 1e-3", 1e-3}, {"gap 1e-6", 1e-6}, {"overlap", -0.2}};

enum class Poses : std::uint8_t { set, none };

template <int D>
class PairSource {
 public:
  explicit PairSource(std::uint64_t seed) : bits_(seed) {}

  /// Convex shapes of `count` vertices each: polygons in order, counter-clockwise, or polyhedra.
  [[nodiscard]] std::vector<Pair<D>> pairs(std::size_t how_many, int count, const Spacing& spacing,
                                           Poses poses = Poses::set) {
    std::vector<Pair<D>> out;
    for (std::size_t i = 0; i < how_many; ++i) out.push_back(pair(count, spacing, poses));
    return out;
  }

 private:
  static constexpr double kTurn = 6.283185307179586;
  static constexpr double kGoldenAngle = 2.399963229728653;

  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }

  [[nodiscard]] Pair<D> pair(int count, const Spacing& spacing, Poses poses) {
    for (int tries = 0; tries < 1000; ++tries) {
      Pair<D> shapes{shape(count), shape(count)};
      shapes.y_pose.rotation = any_turn();
      const Point<D> away = direction();
      if (spacing.gap < 0.0) {
        Pair<D> out = placed(shapes, away * -spacing.gap, poses);
        if (gjk::distance(out.query()).distance == 0.0) return out;
        continue;
      }
      // Along the shortest connection nothing else comes in between.
      const auto apart = gjk::distance(placed(shapes, away * 5.0, poses).query());
      const Point<D> connection = apart.y - apart.x;
      Pair<D> out =
          placed(shapes, away * 5.0 - connection * (1.0 - spacing.gap / apart.distance), poses);
      // Rounded to float, the gap has changed a little.
      if (std::abs(gjk::distance(out.query()).distance - spacing.gap) < 0.2 * spacing.gap)
        return out;
    }
    throw std::logic_error("no pair with the spacing wanted");
  }

  /// Vertices on an ellipse or ellipsoid, about equally far from each other.
  [[nodiscard]] std::vector<Point<D>> shape(int count) {
    std::vector<Point<D>> vertices;
    const double begin = between(0.0, kTurn);
    const double width = between(0.6, 1.0);
    for (int i = 0; i < count; ++i) {
      const double place = i + between(-0.25, 0.25);
      if constexpr (D == 2) {
        const double angle = begin + kTurn * place / count;
        vertices.emplace_back(std::cos(angle), width * std::sin(angle));
      } else {  // along a spiral from pole to pole
        const double height = (2.0 * place + 1.0) / count - 1.0;
        const double radius = std::sqrt(1.0 - height * height);
        const double angle = begin + kGoldenAngle * i;
        vertices.emplace_back(radius * std::cos(angle), width * radius * std::sin(angle), height);
      }
    }
    return vertices;
  }

  [[nodiscard]] Point<D> direction() {
    const double angle = between(0.0, kTurn);
    if constexpr (D == 2) {
      return {std::cos(angle), std::sin(angle)};
    } else {
      const double height = between(-1.0, 1.0);
      const double radius = std::sqrt(1.0 - height * height);
      return {radius * std::cos(angle), radius * std::sin(angle), height};
    }
  }

  [[nodiscard]] Eigen::Matrix<double, D, D> any_turn() {
    const double angle = between(0.0, kTurn);
    if constexpr (D == 2) {
      return Eigen::Rotation2Dd(angle).toRotationMatrix();
    } else {
      return Eigen::AngleAxisd(angle, direction()).toRotationMatrix();
    }
  }

  /// With the origin of Y at `place`, all numbers rounded to floats.
  [[nodiscard]] static Pair<D> placed(Pair<D> pair, const Point<D>& place, Poses poses) {
    pair.y_pose.translation = place;
    if (poses == Poses::none) {
      for (Point<D>& y : pair.y) y = pair.y_pose.rotated(y) + place;
      pair.y_pose = {};
    }
    return families::rounded_to_floats(pair);
  }

  std::mt19937_64 bits_;
};

}  // namespace bench
