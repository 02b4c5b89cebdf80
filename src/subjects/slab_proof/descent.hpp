#pragma once
// Are two points the closest of two convex shapes? They are exactly when slab(x, y) is empty: the
// strip between the parallel lines through x and y, normal to y - x (Larsen 1998, "Proof of Local
// Verification"). The proof makes an algorithm: while a vertex c of X lies in the slab, the segment
// from c to x has a point that is closer to y, which takes the place of x; and so for Y.
//
//   slab     how far each vertex reaches into the slab; none does: stop
//   closer   the point closest to y on the segment from the deepest vertex to x takes its place
//
// It is made for the proof, not for speed: where the closest points lie between vertices it may
// only come near to them. A vertex counts as in the slab when it reaches in farther than rounding.

#include <algorithm>
#include <limits>

#include "outlines/outline.hpp"
#include "outlines/polygon.hpp"

namespace slab_proof {

using models::Point;

enum class Phase : std::uint8_t { slab, closer };
enum class Stop : std::uint8_t { running, empty, overlap, iteration_cap };
inline constexpr int kIterationCap = 40;

/// A vertex, and how far it reaches into the slab, in units of length; negative: not at all.
struct Reach {
  bool of_x = true;
  int vertex = 0;
  double depth = 0.0;
};

struct State {
  Point x = Point::Zero();
  Point y = Point::Zero();
  Phase phase = Phase::slab;
  Stop stop = Stop::running;
  int iteration = 1;
  [[nodiscard]] double distance() const { return (y - x).norm(); }
};

struct Step {
  Phase phase = Phase::slab;
  std::vector<Reach> reaches;   ///< For a slab: those that lie in it, the deepest first.
  std::vector<Reach> farthest;  ///< For a slab: each shape's vertex that reaches farthest.
  Reach towards;                ///< For `closer`: c.
  State before;
  State after;
};

struct Descent {
  std::vector<Step> steps;
  State result;
};

namespace detail {

inline void look(Step& step, const std::vector<Point>& x, const std::vector<Point>& y) {
  const State& at = step.before;
  const Point into = (at.y - at.x) / at.distance();
  double scale = 0.0;
  for (const std::vector<Point>* shape : {&x, &y}) {
    for (const Point& vertex : *shape) scale = std::max(scale, vertex.cwiseAbs().maxCoeff());
  }
  const double rounding = 0x1p-48 * scale;
  for (const bool of_x : {true, false}) {
    const std::vector<Point>& shape = of_x ? x : y;
    Reach farthest{of_x, 0, -std::numeric_limits<double>::infinity()};
    for (int i = 0; i < static_cast<int>(shape.size()); ++i) {
      const Point& vertex = shape[i];
      const Reach reach{of_x, i, of_x ? into.dot(vertex - at.x) : into.dot(at.y - vertex)};
      if (reach.depth > farthest.depth) farthest = reach;
      if (reach.depth > rounding) step.reaches.push_back(reach);
    }
    step.farthest.push_back(farthest);
  }
  std::stable_sort(step.reaches.begin(), step.reaches.end(),
                   [](const Reach& a, const Reach& b) { return a.depth > b.depth; });
}

}  // namespace detail

/// From vertices `start_x` and `start_y` of two convex shapes that do not overlap.
[[nodiscard]] inline Descent descend(const std::vector<Point>& x, const std::vector<Point>& y,
                                     int start_x, int start_y) {
  Descent out;
  State state{x[start_x], y[start_y]};
  while (state.stop == Stop::running) {
    Step slab{Phase::slab, {}, {}, {}, state, state};
    detail::look(slab, x, y);
    slab.after.phase = Phase::closer;
    if (slab.reaches.empty()) slab.after.stop = Stop::empty;
    if (!slab.reaches.empty() && state.iteration == kIterationCap)
      slab.after.stop = Stop::iteration_cap;
    state = slab.after;
    out.steps.push_back(std::move(slab));
    if (state.stop != Stop::running) break;

    Step closer{Phase::closer, {}, {}, out.steps.back().reaches.front(), state, state};
    const Reach& c = closer.towards;
    if (c.of_x) {
      closer.after.x = gjkscope::closest_on_segment(state.y, state.x, x[c.vertex]);
    } else {
      closer.after.y = gjkscope::closest_on_segment(state.x, state.y, y[c.vertex]);
    }
    closer.after.phase = Phase::slab;
    ++closer.after.iteration;
    state = closer.after;
    out.steps.push_back(std::move(closer));
  }
  out.result = state;
  return out;
}

}  // namespace slab_proof
