#pragma once
// Convex bodies in space, drawn with marks alone: the silhouette thick, edges in front thin, those
// behind dashed, be it behind their own body or another one.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "outlines/polyhedron.hpp"
#include "picture/scene.hpp"

namespace gjkscope {

/// Whether each face looks towards the eye.
[[nodiscard]] std::vector<bool> faces_in_front(const StageMap& map, const Polyhedron& solid);

/// Whether each point is a vertex behind the body: all faces that meet there look away.
[[nodiscard]] std::vector<bool> vertices_behind(const StageMap& map, const Polyhedron& solid,
                                                std::size_t points);

/// A body, with the points that its hull was made of.
struct SolidBody {
  const Polyhedron& hull;
  const std::vector<Eigen::Vector3d>& points;
};

/// The part of a segment from which the way to the eye goes through the body, as shares of its
/// length from 0 at `from` to 1 at `to`; none where the body hides nothing. Ways that only touch
/// it pass by.
[[nodiscard]] std::optional<std::array<double, 2>> part_behind(const StageMap& map,
                                                               const SolidBody& body,
                                                               const Eigen::Vector3d& from,
                                                               const Eigen::Vector3d& to);

/// Lines that lie behind a body are dashed; those of a core, which is shown for what is inside of
/// bodies, are not.
enum class Stuff { body, glass, core };

/// The silhouette has the role, the area within ROLE.fill, faces that turn away from the light
/// ROLE.shade, edges ROLE.edge and ROLE.hidden, as far as they have room. `points`: those that the
/// hull was made of.
void draw_solid(SceneBuilder& scene, const Polyhedron& solid,
                const std::vector<Eigen::Vector3d>& points, const std::string& role,
                const Subject& subject = {}, Stuff stuff = Stuff::glass);

/// A flat convex polygon, as glass.
void draw_face(SceneBuilder& scene, const std::vector<Eigen::Vector3d>& corners,
               const std::string& role);

/// The part of a plane around `center`, which lies in it, as a square with this half-width.
void draw_plane(SceneBuilder& scene, const Eigen::Vector3d& center, const Eigen::Vector3d& normal,
                double half_width, const std::string& role);

}  // namespace gjkscope
