#include "subjects/faces_of_difference/faces.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "outlines/polygon.hpp"

namespace sums_in_space {
namespace {

using gjkscope::Difference;
using gjkscope::volume_sign;

/// A body: its points, and their hull.
struct Solid {
  Points points;
  const Polyhedron& hull;

  [[nodiscard]] const Vector3d& at(int i) const { return points[i]; }
  [[nodiscard]] Difference difference(int from, int to) const { return {at(from), at(to)}; }
  /// The vertices that lie farthest along u × w, or against it.
  [[nodiscard]] std::vector<int> farthest(const Difference& u, const Difference& w,
                                          int sign) const {
    std::vector<int> best;
    for (const int vertex : hull.vertices) {
      const int more =
          best.empty() ? 1 : sign * volume_sign(u, w, difference(best.front(), vertex));
      if (more > 0) best.clear();
      if (more >= 0) best.push_back(vertex);
    }
    if (best.size() < 3) return best;
    const auto is_it = [&](const Polyhedron::Face& face) {
      return face.vertices.size() == best.size() &&
             std::is_permutation(face.vertices.begin(), face.vertices.end(), best.begin());
    };
    const auto face = std::find_if(hull.faces.begin(), hull.faces.end(), is_it);
    return face == hull.faces.end() ? best : face->vertices;
  }
  /// A vertex of a face that is no end of the edge.
  [[nodiscard]] int beside(const Polyhedron::Edge& edge, int face) const {
    const std::vector<int>& ring = hull.faces[face].vertices;
    return *std::find_if(ring.begin(), ring.end(),
                         [&](int vertex) { return vertex != edge.from && vertex != edge.to; });
  }
};

/// Along the normal of each face of one body the other one lies farthest in a vertex, or more.
void from_faces(std::vector<Face>& out, const Solid& of, const Solid& other, bool is_y) {
  for (const Polyhedron::Face& face : of.hull.faces) {
    const std::vector<int>& ring = face.vertices;
    // X and Y lie farthest against each other.
    std::vector<int> rest =
        other.farthest(of.difference(ring[0], ring[1]), of.difference(ring[0], ring[2]), -1);
    if (is_y) out.push_back({ring, std::move(rest), face.normal});
    // Parallel faces came from Y.
    else if (rest.size() < 3)
      out.push_back({std::move(rest), ring, -face.normal});
  }
}

/// An edge of each, if there is a direction n along which Y lies farthest in its edge and no more,
/// and X so along −n. It is ± the product of the edges.
void from_edges(std::vector<Face>& out, const Solid& x, const Solid& y) {
  for (const Polyhedron::Edge& e : y.hull.edges) {
    const std::array<int, 2> of_y = {y.beside(e, e.left), y.beside(e, e.right)};
    for (const Polyhedron::Edge& f : x.hull.edges) {
      const Difference u = y.difference(e.from, e.to);
      const Difference w = x.difference(f.from, f.to);
      const int sign = volume_sign(u, w, y.difference(e.from, of_y[0]));
      if (sign == 0 || volume_sign(u, w, y.difference(e.from, of_y[1])) != sign) continue;
      if (volume_sign(u, w, x.difference(f.from, x.beside(f, f.left))) != -sign ||
          volume_sign(u, w, x.difference(f.from, x.beside(f, f.right))) != -sign)
        continue;
      const Vector3d normal = -sign * u.rounded().cross(w.rounded()).normalized();
      out.push_back({{e.from, e.to}, {f.from, f.to}, normal});
    }
  }
}

}  // namespace

std::vector<Face> faces_of_difference(Points x, const Polyhedron& hull_x, Points y,
                                      const Polyhedron& hull_y) {
  std::vector<Face> out;
  if (hull_x.faces.empty() || hull_y.faces.empty()) return out;
  const Solid of_x{x, hull_x};
  const Solid of_y{y, hull_y};
  from_faces(out, of_y, of_x, true);
  from_faces(out, of_x, of_y, false);
  from_edges(out, of_x, of_y);
  return out;
}

std::vector<gjk::VertexPair> corners_of(const Face& face, Points x, Points y) {
  std::vector<gjk::VertexPair> all;
  for (const int of_y : face.y) {
    for (const int of_x : face.x) all.push_back({of_x, of_y});
  }
  // Seen along an axis, so that nothing is rounded.
  int axis = 0;
  face.normal.cwiseAbs().maxCoeff(&axis);
  std::vector<Eigen::Vector2d> seen;
  for (const auto& [of_x, of_y] : all) {
    const Vector3d z = y[of_y] - x[of_x];
    seen.emplace_back(z[(axis + 1) % 3], z[(axis + 2) % 3]);
  }
  std::vector<gjk::VertexPair> out;
  for (const int corner : gjkscope::convex_hull(seen)) out.push_back(all[corner]);
  return out;
}

}  // namespace sums_in_space
