#pragma once
// Features of bodies and their regions in pictures, for all lessons that show them.

#include <limits>

#include "picture/scene.hpp"
#include "subjects/feature_regions/features.hpp"

namespace gjkscope::cells {

[[nodiscard]] Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& points);
/// How far the points reach from their middle.
[[nodiscard]] double radius_of(const std::vector<Eigen::Vector3d>& points);

/// The region of one of the features of a body, as far as `reach` from the body. Empty where it
/// does not reach so far.
[[nodiscard]] SolidPart region_of(const Feature& feature, const std::vector<Feature>& of_body,
                                  const std::vector<Eigen::Vector3d>& points, double reach);

/// The vertices of a feature of a body of the run, in the picture.
[[nodiscard]] std::vector<Point> corners_of(const SceneBuilder& scene, std::size_t body,
                                            const Feature& feature);
/// A feature of a body of the run; dashed where its body is before it.
void draw_feature(SceneBuilder& scene, std::size_t body, const Feature& feature);
/// A vertex or an edge that bounds the region of another feature.
void draw_neighbour(SceneBuilder& scene, std::size_t body, const Feature& feature);

/// The line between a point of X and one of Y, and those of them that have a name.
void draw_pair(SceneBuilder& scene, const std::array<Eigen::Vector3d, 2>& points,
               const std::string& role, const std::array<std::string, 2>& names);

/// Draws the plane of a border between `from`, a point of the feature, and the foot of the
/// perpendicular from `point`, which lies beyond the border; at most `most` in size.
void draw_refuting_plane(SceneBuilder& scene, const Border& border, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& point,
                         double most = std::numeric_limits<double>::infinity());

}  // namespace gjkscope::cells
