#pragma once
// The cost of methods for general models as outlines grow: pairs visited, on random outlines that
// are not convex and lie apart. Nothing is timed, so counts are the same on every machine; the
// outlines come of sums, products, quotients and square roots alone.

#include <algorithm>
#include <random>

#include "outlines/pieces.hpp"
#include "outlines/search.hpp"

namespace general_growth {

using models::Model;
using models::Point;

/// Pairs of outlines with n segments each. What is counted is an average over the runs.
struct Sample {
  int segments = 0;
  int runs = 0;
  double boxes = 0.0;       ///< Pairs of nodes visited for the distance, in trees of boxes,
  double circles = 0.0;     ///< in trees of circles,
  double remembered = 0.0;  ///< in trees of boxes, from the closest pair of the position before,
  double collide = 0.0;     ///< and only to find whether they collide.
  double pieces = -1.0;     ///< Runs of GJK on convex pieces; negative where they are not cut.
  Model x;                  ///< The first pair.
  Model y;
  models::Answer answer;
  [[nodiscard]] double pairs() const { return 1.0 * segments * segments; }
};

/// Cutting takes O(n^2): larger outlines are not cut.
inline constexpr int kMostCut = 300;
/// The segments of one size, in all runs together: larger outlines have fewer runs.
inline constexpr int kMostSegments = 300000;
/// How far Y moves from one position to the next, as a share of its radius.
inline constexpr double kStep = 0.02;

namespace detail {

[[nodiscard]] inline double real(std::mt19937_64& bits, double from, double to) {
  return from + (to - from) * (static_cast<double>(bits() >> 11) * 0x1p-53);
}

/// A coast: 1 in places, less elsewhere by bays of all sizes down to that of a segment.
[[nodiscard]] inline std::vector<double> radii(std::mt19937_64& bits, int segments) {
  std::vector<double> out(static_cast<std::size_t>(segments), 1.0);
  double depth = 0.2;
  for (int bays = 8; bays <= segments; bays *= 2, depth *= 0.6) {
    std::vector<double> bay;
    for (int i = 0; i < bays; ++i) bay.push_back(real(bits, 0.0, depth));
    for (int i = 0; i < segments; ++i) {
      const double at = 1.0 * i * bays / segments;
      const int left = static_cast<int>(at);
      const double share = at - left;
      out[i] -= (1.0 - share) * bay[left] + share * bay[left + 1 == bays ? 0 : left + 1];
    }
  }
  return out;
}

/// A star around `center`: its radii lie between 0.5 and 1.
[[nodiscard]] inline models::Outline star(std::mt19937_64& bits, int segments,
                                          const Point& center) {
  models::Outline out;
  const std::vector<double> radius = radii(bits, segments);
  for (int i = 0; i < segments; ++i) {
    const int quarter = static_cast<int>(4ll * i / segments);
    const double t = 4.0 * i / segments - quarter;
    Point direction = Point(1.0 - t * t, 2.0 * t) / (1.0 + t * t);
    for (int k = 0; k < quarter; ++k) direction = Point(-direction.y(), direction.x());
    out.points.push_back(center + radius[i] * direction);
  }
  return out;
}

[[nodiscard]] inline Model moved(const Model& model, const Point& by) {
  std::vector<models::Outline> outlines = model.outlines;
  for (models::Outline& outline : outlines) {
    for (Point& point : outline.points) point += by;
  }
  return models::model_of(std::move(outlines));
}

template <class Volume>
[[nodiscard]] models::Hierarchy<Volume> tree(const Model& model) {
  return models::build_hierarchy<Volume>(models::items_of(model));
}

}  // namespace detail

/// Two outlines, and Y at the position before.
struct Scene {
  Model x;
  Model before;
  Model y;
};
/// `bits`, fresh from a seed, gives the first pair of that seed.
[[nodiscard]] inline Scene scene(std::mt19937_64& bits, int segments) {
  Scene out;
  out.x = models::model_of({detail::star(bits, segments, Point(0.0, 0.0))});
  const double up = detail::real(bits, 1.3, 1.5);
  out.before = models::model_of({detail::star(bits, segments, Point(1.4, up))});
  out.y = detail::moved(out.before, {0.0, kStep});
  return out;
}

[[nodiscard]] inline Sample measure(int segments, int runs, int seed) {
  using models::Box;
  using models::Circle;
  Sample out;
  out.segments = segments;
  out.runs = std::clamp(kMostSegments / segments, 1, runs);
  std::mt19937_64 bits(static_cast<std::uint64_t>(seed));
  const double share = 1.0 / out.runs;
  for (int run = 0; run < out.runs; ++run) {
    const Scene pair = scene(bits, segments);
    const Model& x = pair.x;
    const Model& y = pair.y;
    const auto x_boxes = detail::tree<Box>(x);
    const auto y_boxes = detail::tree<Box>(y);
    const auto visits = [&](const models::SearchOptions& options) {
      return share *
             static_cast<double>(models::search<Box>({x, y, x_boxes, y_boxes}, options).visits);
    };
    models::SearchOptions options;
    out.boxes += visits(options);
    options.goal = models::Goal::collide;
    out.collide += visits(options);
    options.goal = models::Goal::distance;
    options.remembered =
        models::search<Box>({x, pair.before, x_boxes, detail::tree<Box>(pair.before)}, options)
            .segments;
    out.remembered += visits(options);
    out.circles += share * static_cast<double>(
                               models::search<Circle>(
                                   {x, y, detail::tree<Circle>(x), detail::tree<Circle>(y)}, {})
                                   .visits);
    if (segments <= kMostCut) {
      const auto cut = models::pieces_distance(x, y, models::pieces_of(x), models::pieces_of(y));
      out.pieces = std::max(out.pieces, 0.0) + share * static_cast<double>(cut.visits);
    }
    if (run > 0) continue;
    out.x = x;
    out.y = y;
    out.answer = models::search<Box>({x, y, x_boxes, y_boxes}, {}).answer;
  }
  return out;
}

}  // namespace general_growth
