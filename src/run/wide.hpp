#pragma once
// Traces of GJK as pictures, words and files read them: in doubles and in three coordinates,
// whatever the scalar and the dimension of the run. In the plane z = 0.

#include <vector>

#include "gjk/trace.hpp"
#include "lesson/plane.hpp"

namespace gjkscope {

using WideVertex = gjk::SupportPoint<double, 3>;
using WideSimplex = gjk::Simplex<double, 3>;
using WideState = gjk::State<double, 3>;
using WideDirection = gjk::DirectionNote<double, 3>;
using WideRecord = gjk::Record<double, 3>;
using WideStep = gjk::Step<double, 3>;
using WideResult = gjk::Result<double, 3>;

/// A whole run. Its numbers are exact for half, float and double, and rounded to nearest for exact
/// runs. Lengths are in units of 2^exponent; those of the result, but for its simplex, are in the
/// world's unit.
struct WideTrace {
  int dimension = 2;  ///< 2 or 3.
  int exponent = 0;   ///< 0 but for runs in space, and for double runs whose squares would leave
                      ///< the range of a double. A run with another one is not drawn.
  WideState initial;
  std::vector<WideStep> steps;
  WideResult result;

  /// GJK was not asked.
  [[nodiscard]] bool is_empty() const { return result.stop == gjk::StopReason::running; }
};

/// Vertices and simplices of the plane as those of space, and back.
[[nodiscard]] inline gjk::Simplex<double, 2> in_plane(const WideSimplex& simplex) {
  gjk::Simplex<double, 2> out;
  out.count = simplex.count;
  for (int i = 0; i < simplex.count; ++i) {
    out.vertices[i] = {in_plane(simplex.vertices[i].w), simplex.vertices[i].pair};
    out.weights[i] = simplex.weights[i];
  }
  return out;
}
[[nodiscard]] inline WideVertex in_space(const gjk::SupportPoint<double, 2>& v) {
  return {in_space(v.w), v.pair};
}
[[nodiscard]] inline const WideVertex& in_space(const WideVertex& v) { return v; }

}  // namespace gjkscope
