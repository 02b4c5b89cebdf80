#pragma once
// Random queries in families, easy and hard, for the tests that speak of many pairs.

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "gjk/gjk.hpp"

namespace random_pairs {

using gjk::Vec;

/// A query that owns its vertices.
template <class S>
struct Pair {
  std::vector<Vec<S, 2>> x;
  std::vector<Vec<S, 2>> y;
  gjk::Pose<S, 2> x_pose;
  gjk::Pose<S, 2> y_pose;
  [[nodiscard]] gjk::Query<S, 2> query() const { return {{x, x_pose}, {y, y_pose}}; }
};

enum class Family : std::uint8_t {
  polygons,  ///< Convex polygons of 3 to 8 vertices, apart, close or overlapping.
  points,    ///< A point against a polygon or a point.
  segments,  ///< Segments, some collinear.
  clouds,    ///< Unsorted point sets, most of whose points lie inside the hull.
  grid,      ///< Small integers: ties, touching, repeated points, collinear triples.
  parallel,  ///< Boxes with facing edges that are parallel up to 1e-3 ... 1e-7.
  needle,    ///< Triangles 1e-4 ... 1e-7 of their length wide.
  tiny,      ///< Polygons of size 1e-6 at distance 1e-6.
  offset,    ///< Vertices at 1e4 ... 1e6 from the origin.
  ratio,     ///< One shape 1e4 times the other.
  posed,     ///< Polygons, each rotated and moved by its pose.
};
inline constexpr std::array<std::string_view, 11> kFamilyNames = {
    "polygons", "points", "segments", "clouds", "grid", "parallel",
    "needle",   "tiny",   "offset",   "ratio",  "posed"};
inline constexpr int kFamilyCount = static_cast<int>(kFamilyNames.size());

class Source {
 public:
  explicit Source(std::uint64_t seed) : bits_(seed) {}

  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  [[nodiscard]] int among(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }
  [[nodiscard]] bool with_chance(double share) { return between(0, 1) < share; }

  template <class S>
  [[nodiscard]] Vec<S, 2> vector(double x, double y) {
    return Vec<S, 2>(static_cast<S>(x), static_cast<S>(y));
  }

  /// Vertices on an ellipse at sorted angles: convex up to rounding.
  template <class S>
  [[nodiscard]] std::vector<Vec<S, 2>> polygon(int count, double size, double x, double y) {
    std::vector<Vec<S, 2>> vertices;
    const double turn = between(0, 6.283185307179586);
    const double squash = between(0.3, 1.0);
    for (int i = 0; i < count; ++i) {
      const double angle = 6.283185307179586 * (i + between(0, 0.9)) / count;
      const double a = size * std::cos(angle);
      const double b = size * squash * std::sin(angle);
      vertices.push_back(vector<S>(x + a * std::cos(turn) - b * std::sin(turn),
                                   y + a * std::sin(turn) + b * std::cos(turn)));
    }
    return vertices;
  }

  template <class S>
  [[nodiscard]] std::vector<Vec<S, 2>> grid_points(int count, int size) {
    std::vector<Vec<S, 2>> vertices;
    for (int i = 0; i < count; ++i) {
      vertices.push_back(vector<S>(among(-size, size), among(-size, size)));
    }
    return vertices;
  }

  template <class S>
  [[nodiscard]] Pair<S> pair(Family family) {
    Pair<S> out;
    switch (family) {
      case Family::polygons:
        out.x = polygon<S>(among(3, 8), 1.0, 0, 0);
        out.y = polygon<S>(among(3, 8), 1.0, between(-2.5, 2.5), between(-2.5, 2.5));
        break;
      case Family::points:
        out.x = {vector<S>(between(-2, 2), between(-2, 2))};
        out.y = polygon<S>(with_chance(0.2) ? 1 : among(3, 8), 1.0, 0, 0);
        break;
      case Family::segments:
        for (int i = 0; i < 2; ++i) {
          out.x.push_back(vector<S>(between(-1, 1), between(-1, 1)));
          out.y.push_back(vector<S>(between(-1, 1), between(-1, 1)));
        }
        if (with_chance(0.3)) {  // on one line
          const Vec<S, 2> along = out.x[1] - out.x[0];
          out.y[0] = out.x[0] + along * static_cast<S>(between(-1, 3));
          out.y[1] = out.x[0] + along * static_cast<S>(between(-1, 3));
        }
        break;
      case Family::clouds:
        for (int i = 0; i < 12; ++i) {
          out.x.push_back(vector<S>(between(-1, 1), between(-1, 1)));
          out.y.push_back(vector<S>(between(0.5, 2.5), between(-1, 1)));
        }
        break;
      case Family::grid:
        out.x = grid_points<S>(among(1, 6), 3);
        out.y = grid_points<S>(among(1, 6), 3);
        if (with_chance(0.4)) {
          const S shift = static_cast<S>(among(3, 8));
          for (Vec<S, 2>& vertex : out.y) vertex[0] += shift;
        }
        if (with_chance(0.05)) out.y = out.x;
        break;
      case Family::parallel: {
        const double tilt = std::pow(10.0, between(-7, -3));
        const double gap = with_chance(0.2) ? between(-0.5, 0.0) : std::pow(10.0, between(-6, 0));
        const double shift = between(-1.5, 1.5);
        out.x = {vector<S>(-1, -1), vector<S>(1, -1), vector<S>(1, 0), vector<S>(-1, 0)};
        out.y = {vector<S>(shift - 1, gap - tilt), vector<S>(shift + 1, gap + tilt),
                 vector<S>(shift + 1, gap + 1 + tilt), vector<S>(shift - 1, gap + 1 - tilt)};
        break;
      }
      case Family::needle:
        out.x = needle<S>(std::pow(10.0, between(-7, -4)));
        out.y = with_chance(0.5) ? needle<S>(std::pow(10.0, between(-7, -4)))
                                 : polygon<S>(4, 0.5, between(-1, 1), between(-1, 1));
        break;
      case Family::tiny:
        out.x = polygon<S>(among(1, 5), 1e-6, 0, 0);
        out.y = polygon<S>(among(1, 5), 1e-6, between(-3e-6, 3e-6), between(-3e-6, 3e-6));
        break;
      case Family::offset: {
        const double far = std::pow(10.0, between(4, 6));
        out.x = polygon<S>(among(3, 6), 1.0, far, -far);
        out.y = polygon<S>(among(3, 6), 1.0, far + between(-3, 3), -far + between(-3, 3));
        break;
      }
      case Family::ratio:
        out.x = polygon<S>(among(3, 6), 1e4, 0, 0);
        out.y = polygon<S>(among(3, 6), 1.0, between(-1.2e4, 1.2e4), between(-1.2e4, 1.2e4));
        break;
      case Family::posed:
        out.x = polygon<S>(among(1, 6), 1.0, 0, 0);
        out.y = polygon<S>(among(1, 6), 1.0, 0, 0);
        for (gjk::Pose<S, 2>* pose : {&out.x_pose, &out.y_pose}) {
          const double angle = between(0, 6.283185307179586);
          pose->rotation << static_cast<S>(std::cos(angle)), static_cast<S>(-std::sin(angle)),
              static_cast<S>(std::sin(angle)), static_cast<S>(std::cos(angle));
          pose->translation = vector<S>(between(-1.5, 1.5), between(-1.5, 1.5));
        }
        break;
    }
    return out;
  }

 private:
  template <class S>
  [[nodiscard]] std::vector<Vec<S, 2>> needle(double width) {
    const double angle = between(0, 6.283185307179586);
    const double x = between(-1, 1);
    const double y = between(-1, 1);
    const double along_x = std::cos(angle);
    const double along_y = std::sin(angle);
    return {vector<S>(x - along_x, y - along_y),
            vector<S>(x + along_x - width * along_y, y + along_y + width * along_x),
            vector<S>(x + along_x + width * along_y, y + along_y - width * along_x)};
  }

  std::mt19937_64 bits_;
};

}  // namespace random_pairs
