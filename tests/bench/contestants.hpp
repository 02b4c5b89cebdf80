#pragma once
// Distance queries of several libraries as contestants: each has its shapes prepared beforehand and
// is given the poses query by query.

#include <span>

#include "grid_pairs.hpp"
#include "interleave.hpp"

namespace bench {

/// Polygons up to this size fit into the proxies of Box2D.
inline constexpr int kBox2dVertices = 8;

/// b2Distance of Box2D 2.4, in float, useRadii false, an empty cache for each query.
[[nodiscard]] Contestant box2d_2(std::span<const Pair> pairs);

/// b2ShapeDistance of Box2D 3, likewise.
[[nodiscard]] Contestant box2d_3(std::span<const Pair> pairs);

}  // namespace bench
