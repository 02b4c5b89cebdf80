#pragma once
// Quinlan 1994, "Efficient distance computation between non-convex objects": the surface is tiled
// with small circles, and the tree bounds these and not the segments. So several leaves may have
// one segment, and pairs of segments that were measured are kept in a table. A relative error may
// be allowed: then pairs that could gain less are cut off, too.

#include "outlines/search.hpp"

namespace models {

/// Circles of at most this radius that cover the segments, in their order along each.
/// `radius` > 0. A segment has at most `most` circles; a longer one has larger circles.
[[nodiscard]] inline std::vector<Item> tiles_of(const Model& model, double radius,
                                                int most = 1 << 16) {
  std::vector<Item> tiles;
  for (std::size_t i = 0; i < model.segments.size(); ++i) {
    const Segment& s = model.segments[i];
    const double length = detail::length_above(s.b - s.a);
    const int count = static_cast<int>(
        std::clamp(std::ceil(length / (2.0 * radius)), 1.0, static_cast<double>(most)));
    // Parts begin and end on the segment but for rounding, which the radius makes up for.
    const double rounding =
        8.0 * detail::kRoundoff * std::max(s.a.cwiseAbs().maxCoeff(), s.b.cwiseAbs().maxCoeff());
    const double reach = (0.5 * length / count) * (1.0 + 4.0 * detail::kRoundoff) + rounding;
    for (int k = 0; k < count; ++k) {
      const double share = (k + 0.5) / count;
      const Point center = (1.0 - share) * s.a + share * s.b;
      tiles.push_back({center, center, reach, static_cast<int>(i)});
    }
  }
  return tiles;
}

[[nodiscard]] inline Hierarchy<Circle> sphere_tree(const Model& model, double radius) {
  return build_hierarchy<Circle>(tiles_of(model, radius));
}

}  // namespace models
