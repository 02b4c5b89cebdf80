#pragma once
// Plane geometry that pictures and effects need: hulls, areas, half-planes.

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace gjkscope {

/// The closed half-plane of points q with dot(normal, q - point) <= 0.
struct HalfPlane {
  Eigen::Vector2d point;
  Eigen::Vector2d normal;
};

/// Indices of the hull's corners, counter-clockwise from the lowest leftmost point; points on hull
/// edges are left out. One index for coinciding points, two for collinear ones. (Andrew 1979,
/// monotone chain.)
[[nodiscard]] std::vector<int> convex_hull(std::span<const Eigen::Vector2d> points);

/// Positive for counter-clockwise polygons.
[[nodiscard]] double signed_area(std::span<const Eigen::Vector2d> polygon);

/// True for a polygon that turns in one direction only (collinear corners allowed) and once around.
[[nodiscard]] bool is_convex(std::span<const Eigen::Vector2d> polygon);
/// Whether one sees that an outline is not that of its hull: it has a dent, or crosses itself. A
/// smooth outline whose corners are rounded has none.
[[nodiscard]] bool differs_from_hull(std::span<const Eigen::Vector2d> outline);

/// Whether a ray from `point` crosses the outline, convex or not, an odd number of times.
[[nodiscard]] bool is_inside(std::span<const Eigen::Vector2d> outline,
                             const Eigen::Vector2d& point);

/// Indices of the triangles that fill a simple polygon, ear by ear (Meisters 1975). None where no
/// ear is left, as in some polygons that cross themselves.
[[nodiscard]] std::vector<std::array<int, 3>> triangles(std::span<const Eigen::Vector2d> polygon);

/// The part of a convex polygon that lies in a half-plane; empty when there is none. (Sutherland
/// and Hodgman 1974.)
[[nodiscard]] std::vector<Eigen::Vector2d> clip(std::span<const Eigen::Vector2d> polygon,
                                                const HalfPlane& half_plane);

/// The part of a convex polygon that lies in a box.
[[nodiscard]] std::vector<Eigen::Vector2d> clip_to_box(std::vector<Eigen::Vector2d> polygon,
                                                       const Eigen::AlignedBox2d& box);

/// The part of the segment from `a` to `b` that lies in a box, if it has a length. (Liang and
/// Barsky 1984.)
[[nodiscard]] std::optional<std::array<Eigen::Vector2d, 2>> clip(const Eigen::Vector2d& a,
                                                                 const Eigen::Vector2d& b,
                                                                 const Eigen::AlignedBox2d& box);

/// Mean of the points.
[[nodiscard]] Eigen::Vector2d centroid(std::span<const Eigen::Vector2d> points);

/// The point of the segment from `a` to `b` that is closest to `point`.
[[nodiscard]] Eigen::Vector2d closest_on_segment(const Eigen::Vector2d& point,
                                                 const Eigen::Vector2d& a,
                                                 const Eigen::Vector2d& b);

/// Distance of `point` from the segment from `a` to `b`.
[[nodiscard]] double segment_distance(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                                      const Eigen::Vector2d& b);

}  // namespace gjkscope
