#pragma once
// Families of pairs of models, from a seed.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string_view>

#include "outlines/outline.hpp"

namespace test {

inline constexpr std::array<std::string_view, 9> kSceneFamilies = {
    "convex", "random", "needles", "nested", "touching", "identical", "holes", "combs", "spirals"};

struct Scene {
  std::vector<models::Outline> a;
  std::vector<models::Outline> b;
};

/// Draws by hand: the distributions of the standard library differ between libraries.
class Scenes {
 public:
  explicit Scenes(std::uint64_t seed) : bits_(seed) {}

  double real(double from, double to) {
    return from + (to - from) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  int among(int from, int to) {
    return from + static_cast<int>(bits_() % static_cast<std::uint64_t>(to - from + 1));
  }
  bool chance(double share) { return real(0.0, 1.0) < share; }

  /// Mostly few segments, rarely up to `most`.
  int count(int most) {
    if (chance(0.9)) return among(3, std::min(most, 24));
    return static_cast<int>(3.0 * std::pow(most / 3.0, real(0.0, 1.0)));
  }

  Scene scene(std::string_view family, int most) {
    const bool on_grid = chance(0.4);
    Scene out{shapes(family, most), shapes(family, most)};
    if (family == "identical") out.b = out.a;
    if (on_grid) {
      for (auto* side : {&out.a, &out.b}) {
        for (models::Outline& outline : *side) {
          for (models::Point& p : outline.points) p = (p * 16.0).array().round().matrix();
        }
      }
    }
    place(out, family, on_grid ? 16.0 : 1.0);
    return out;
  }

  /// Star-shaped, counter-clockwise: radii between `inner` and 1.
  models::Outline star(int n, double inner) {
    models::Outline out;
    const double first = real(0.0, 6.0);
    for (int i = 0; i < n; ++i) {
      const double angle = first + 2.0 * std::numbers::pi * (i + real(0.0, 0.9)) / n;
      out.points.push_back(real(inner, 1.0) * models::Point(std::cos(angle), std::sin(angle)));
    }
    return out;
  }
  /// Teeth that point up, counter-clockwise.
  models::Outline comb(int teeth) {
    models::Outline out;
    out.points = {{2.0 * teeth, -1.0}};
    for (int i = teeth - 1; i >= 0; --i) {
      // One after the other: in a call compilers are free to draw the second one first.
      const double at = 2.0 * i + real(1.2, 1.9);
      out.points.emplace_back(at, real(0.5, 6.0));
      out.points.emplace_back(2.0 * i + 1.0, 0.0);
    }
    out.points.emplace_back(0.0, 0.0);
    out.points.emplace_back(0.0, -1.0);
    for (models::Point& p : out.points) p /= teeth;
    return out;
  }
  /// A band that winds inward.
  models::Outline spiral(int n) {
    models::Outline out;
    const double turns = real(1.0, 4.0);
    const double width = real(0.2, 0.8);
    const int half = std::max(3, n / 2);
    const auto at = [&](double share, double radius_share) {
      const double angle = 2.0 * std::numbers::pi * turns * share;
      const double radius = (share * turns + radius_share) / (turns + 1.0);
      return models::Point(radius * std::cos(angle), radius * std::sin(angle));
    };
    for (int i = 0; i <= half; ++i) out.points.push_back(at(1.0 * i / half, width + 0.1));
    for (int i = half; i >= 0; --i) out.points.push_back(at(1.0 * i / half, 0.1));
    return out;
  }
  models::Outline scaled(models::Outline outline, double by) {
    for (models::Point& p : outline.points) p *= by;
    return outline;
  }
  static models::Outline turned(models::Outline outline, double angle) {
    const models::Point difference(std::cos(angle), std::sin(angle));
    for (models::Point& p : outline.points)
      p = models::Point(difference.x() * p.x() - difference.y() * p.y(),
                        difference.y() * p.x() + difference.x() * p.y());
    return outline;
  }
  static models::Outline reversed(models::Outline outline) {
    std::reverse(outline.points.begin(), outline.points.end());
    return outline;
  }

 private:
  std::vector<models::Outline> shapes(std::string_view family, int most) {
    const int n = count(most);
    if (family == "convex") return {star(n, 1.0)};
    if (family == "needles") {
      models::Outline needle = star(n, chance(0.5) ? 1.0 : 0.9);
      const double thin = std::pow(10.0, real(-12.0, -1.0));
      for (models::Point& p : needle.points) p.y() *= thin;
      return {chance(0.5) ? needle : turned(needle, real(0.0, 6.3))};
    }
    if (family == "holes") {
      std::vector<models::Outline> out = {scaled(star(std::max(n, 8), 0.8), 4.0)};
      for (int i = among(0, 3); i >= 0; --i) {
        models::Outline hole = reversed(star(std::max(3, n / 4), 0.3));
        for (models::Point& p : hole.points) p += models::Point(i % 2 - 0.5, i / 2 - 0.5) * 2.2;
        out.push_back(hole);
      }
      return out;
    }
    if (family == "combs") return {comb(std::max(2, n / 2))};
    if (family == "spirals") return {spiral(n)};
    std::vector<models::Outline> out = {star(n, real(0.05, 0.9))};
    if (family == "random" && chance(0.2)) out[0].closed = false;
    if (family == "random" && chance(0.1)) out[0].points.push_back(out[0].points.back());
    return out;
  }

  /// Moves b, so that some scenes overlap, some are close, and touching ones touch.
  void place(Scene& scene, std::string_view family, double unit) {
    double far = chance(0.5) ? real(1.0, 4.0) : real(0.0, 2.0);
    if (family == "holes") far *= 3.0;
    // Needles that are placed anywhere hardly ever meet: three in four are brought together.
    const int together = family == "needles" ? among(0, 3) : 0;
    const bool inside = together == 1;
    const bool touches = together == 2;
    if (together == 3) far *= 0.1;
    const double angle = real(0.0, 6.3);
    models::Point by = unit * far * models::Point(std::cos(angle), std::sin(angle));
    if (unit != 1.0) by = by.array().round().matrix();
    if (family == "identical" && chance(0.5)) by.setZero();
    if (inside) scene.b = scene.a;
    if (family == "nested" || inside) {
      const double small = unit == 1.0 ? std::pow(10.0, real(-4.0, -0.3)) : 0.125;
      for (models::Outline& outline : scene.b) outline = scaled(outline, small);
      by *= inside ? 0.0 : 0.2;
    }
    if (family == "touching" || touches) return touch(scene);
    for (models::Outline& outline : scene.b) {
      for (models::Point& p : outline.points) p += by;
    }
  }

  /// Puts a vertex of b on a vertex of a, or on the middle of two of them.
  void touch(Scene& scene) {
    const auto& points = scene.a.front().points;
    const int last = static_cast<int>(points.size()) - 1;
    const models::Point& p = points[static_cast<std::size_t>(among(0, last))];
    const models::Point& q = points[static_cast<std::size_t>(among(0, last))];
    const models::Point at = chance(0.5) ? p : models::Point(0.5 * (p + q));
    auto& moved = scene.b.front().points;
    const models::Point by = at - moved.front();
    moved.front() = at;
    for (std::size_t i = 1; i < moved.size(); ++i) moved[i] += by;
  }

  std::mt19937_64 bits_;
};

}  // namespace test
