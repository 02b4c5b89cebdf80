#include "outlines/polyhedron.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "gjk/gjk.hpp"
#include "outlines/polygon.hpp"

namespace gjkscope {

using Eigen::Vector2d;
using Eigen::Vector3d;

int volume_sign(const Difference& u, const Difference& w, const Difference& v) {
  const Vector3d a = u.rounded();
  const Vector3d b = w.rounded();
  const Vector3d c = v.rounded();
  const double volume = a.cross(b).dot(c);
  const Vector3d larger(std::abs(a.y() * b.z()) + std::abs(a.z() * b.y()),
                        std::abs(a.z() * b.x()) + std::abs(a.x() * b.z()),
                        std::abs(a.x() * b.y()) + std::abs(a.y() * b.x()));
  // Three rounded differences in each product, two products, three sums (as in Shewchuk 1997,
  // "Adaptive precision floating-point arithmetic", section 4.3); what underflows is left to the
  // exact sum.
  constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
  if (std::abs(volume) > kRounding * larger.dot(c.cwiseAbs()) + std::numeric_limits<double>::min())
    return volume > 0.0 ? 1 : -1;
  const auto exact = [](const Difference& difference, int i) {
    return gjk::Expansion(difference.to[i]) - gjk::Expansion(difference.from[i]);
  };
  const auto minor = [&](int i, int j) {
    return exact(u, i) * exact(w, j) - exact(u, j) * exact(w, i);
  };
  return (minor(1, 2) * exact(v, 0) + minor(2, 0) * exact(v, 1) + minor(0, 1) * exact(v, 2)).sign();
}

int orientation(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  return volume_sign({d, b}, {d, c}, {d, a});
}

namespace {

using Points = std::span<const Vector3d>;
using Triangle = std::array<int, 3>;

const Vector3d& at(Points points, int i) { return points[i]; }

/// The index of the point for which `size` is largest.
template <class Size>
int farthest(Points points, const Size& size) {
  int best = 0;
  double largest = -1.0;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    if (const double found = size(at(points, i)); found > largest) {
      largest = found;
      best = i;
    }
  }
  return best;
}

/// Triangles of the hull, with the points outside of each.
class Quickhull {
 public:
  explicit Quickhull(Points points) : points_(points) {}

  /// All triangles, from a first tetrahedron.
  [[nodiscard]] std::vector<Triangle> run(std::array<int, 4> start) {
    auto [a, b, c, d] = start;
    if (is_above({a, b, c}, d)) std::swap(b, c);
    std::vector<int> all(points_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    add({{a, b, c}, {a, c, d}, {c, b, d}, {b, a, d}}, all);
    for (std::size_t next = 0; next < faces_.size(); ++next) {
      while (faces_[next].is_alive && !faces_[next].outside.empty()) extend(next);
    }
    std::vector<Triangle> out;
    for (const Face& face : faces_) {
      if (face.is_alive) out.push_back(face.corners);
    }
    return out;
  }

 private:
  struct Face {
    Triangle corners;
    std::vector<int> outside;
    bool is_alive = true;
  };

  [[nodiscard]] bool is_above(const Triangle& face, int point) const {
    return orientation(at(points_, face[0]), at(points_, face[1]), at(points_, face[2]),
                       at(points_, point)) < 0;
  }

  /// Adds triangles, and gives each of them points that lie above it and above none before.
  void add(const std::vector<Triangle>& triangles, const std::vector<int>& points) {
    const std::size_t first = faces_.size();
    for (const Triangle& corners : triangles) {
      for (std::size_t i = 0; i < 3; ++i)
        face_at_[{corners[i], corners[(i + 1) % 3]}] = faces_.size();
      faces_.push_back({corners, {}});
    }
    for (const int point : points) {
      for (std::size_t i = first; i < faces_.size(); ++i) {
        if (!is_above(faces_[i].corners, point)) continue;
        faces_[i].outside.push_back(point);
        break;
      }
    }
  }

  /// Takes the farthest point above a face into the hull: what it sees goes, and triangles to the
  /// horizon come.
  void extend(std::size_t from) {
    const Triangle& corners = faces_[from].corners;
    const Vector3d normal = (at(points_, corners[1]) - at(points_, corners[0]))
                                .cross(at(points_, corners[2]) - at(points_, corners[0]));
    const std::vector<int>& outside = faces_[from].outside;
    const int apex = *std::max_element(outside.begin(), outside.end(), [&](int a, int b) {
      return normal.dot(at(points_, a)) < normal.dot(at(points_, b));
    });
    std::vector<std::size_t> seen = {from};
    faces_[from].is_alive = false;
    std::vector<Triangle> cone;
    std::vector<int> orphans;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      Face& face = faces_[seen[k]];
      orphans.insert(orphans.end(), face.outside.begin(), face.outside.end());
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = face.corners[i];
        const int b = face.corners[(i + 1) % 3];
        const std::size_t beyond = face_at_.at({b, a});
        if (!faces_[beyond].is_alive) continue;
        if (is_above(faces_[beyond].corners, apex)) {
          faces_[beyond].is_alive = false;
          seen.push_back(beyond);
        }
      }
    }
    for (const std::size_t k : seen) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = faces_[k].corners[i];
        const int b = faces_[k].corners[(i + 1) % 3];
        if (faces_[face_at_.at({b, a})].is_alive) cone.push_back({a, b, apex});
      }
      faces_[k].outside.clear();
    }
    std::erase(orphans, apex);
    add(cone, orphans);
  }

  Points points_;
  std::vector<Face> faces_;
  std::map<std::pair<int, int>, std::size_t> face_at_;  ///< On the left of a directed edge.
};

Vector3d normal_of(Points points, const Triangle& face) {
  return unit(
      (at(points, face[1]) - at(points, face[0])).cross(at(points, face[2]) - at(points, face[0])));
}

/// Makes one face of triangles in one plane: of those beside each other for which `is_same` holds,
/// which is given normals (that of the face, and of the triangle beside it), and two triangles.
template <class Same>
std::vector<Polyhedron::Face> merged(Points points, const std::vector<Triangle>& triangles,
                                     const Same& is_same) {
  std::map<std::pair<int, int>, std::size_t> owner;
  std::vector<Vector3d> normals;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    normals.push_back(normal_of(points, triangles[k]));
    for (std::size_t i = 0; i < 3; ++i) owner[{triangles[k][i], triangles[k][(i + 1) % 3]}] = k;
  }
  std::vector<int> group(triangles.size(), -1);
  std::vector<Polyhedron::Face> faces;
  for (std::size_t first = 0; first < triangles.size(); ++first) {
    if (group[first] >= 0) continue;
    const int id = static_cast<int>(faces.size());
    const Vector3d normal = normals[first];
    std::vector<std::size_t> members = {first};
    group[first] = id;
    std::map<int, int> next;  // along the boundary
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Triangle& corners = triangles[members[k]];
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = corners[i];
        const int b = corners[(i + 1) % 3];
        const std::size_t beyond = owner.at({b, a});
        if (group[beyond] < 0 && is_same(normal, normals[beyond], corners, triangles[beyond])) {
          group[beyond] = id;
          members.push_back(beyond);
        }
        if (group[beyond] != id) next[a] = b;
      }
    }
    Polyhedron::Face face{{}, normal};
    for (int v = next.begin()->first; face.vertices.size() < next.size(); v = next.at(v))
      face.vertices.push_back(v);
    faces.push_back(std::move(face));
  }
  // An order of their own, whatever triangles they were made of.
  std::sort(faces.begin(), faces.end(), [](const Polyhedron::Face& a, const Polyhedron::Face& b) {
    return a.vertices < b.vertices;
  });
  return faces;
}

/// The hull of points in a plane with this normal.
Polyhedron flat(Points points, const Vector3d& normal) {
  const Vector3d along = normal.unitOrthogonal();
  const Vector3d across = normal.cross(along);
  std::vector<Vector2d> seen;
  for (const Vector3d& point : points) seen.emplace_back(along.dot(point), across.dot(point));
  Polyhedron out;
  const std::vector<int> ring = convex_hull(seen);
  out.faces = {{ring, normal}, {{ring.rbegin(), ring.rend()}, -normal}};
  return out;
}

/// Edges and vertices of the faces.
void complete(Polyhedron& hull) {
  std::map<std::pair<int, int>, int> left;
  std::set<int> vertices;
  for (std::size_t k = 0; k < hull.faces.size(); ++k) {
    const std::vector<int>& ring = hull.faces[k].vertices;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      left[{ring[i], ring[(i + 1) % ring.size()]}] = static_cast<int>(k);
      vertices.insert(ring[i]);
    }
  }
  for (const auto& [ends, face] : left) {
    const auto other = left.find({ends.second, ends.first});
    if (ends.first < ends.second || other == left.end())
      hull.edges.push_back(
          {ends.first, ends.second, face, other == left.end() ? face : other->second});
  }
  hull.vertices.assign(vertices.begin(), vertices.end());
}

}  // namespace

double length(const Vector3d& v) { return std::sqrt(gjk::dot(v, v)); }
Vector3d unit(const Vector3d& v) { return v / length(v); }

Polyhedron hull_in_space(std::span<const Vector3d> points) {
  const int a = farthest(points, [&](const Vector3d& p) { return (p - points[0]).norm(); });
  const Vector3d from = at(points, a);
  const int b = farthest(points, [&](const Vector3d& p) { return (p - from).norm(); });
  const Vector3d edge = at(points, b) - from;
  Polyhedron hull;
  if (edge.isZero(0.0)) {
    hull.vertices = {a};
    return hull;
  }
  constexpr double kFlat = 1e-12;  // of the size: less cannot be seen
  const int c = farthest(points, [&](const Vector3d& p) { return edge.cross(p - from).norm(); });
  const Vector3d normal = edge.cross(at(points, c) - from);
  if (normal.norm() <= kFlat * edge.squaredNorm()) {
    const int end = farthest(points, [&](const Vector3d& p) { return (p - at(points, b)).norm(); });
    hull.edges = {{std::min(end, b), std::max(end, b), -1, -1}};
    hull.vertices = {std::min(end, b), std::max(end, b)};
    return hull;
  }
  const int d = farthest(points, [&](const Vector3d& p) { return std::abs(normal.dot(p - from)); });
  if (std::abs(normal.dot(at(points, d) - from)) <= kFlat * normal.norm() * edge.norm()) {
    hull = flat(points, unit(normal));
  } else {
    constexpr double kSamePlane = 1e-7;
    hull.faces = merged(points, Quickhull(points).run({a, b, c, d}),
                        [](const Vector3d& first, const Vector3d& beside, const auto&...) {
                          return (beside - first).norm() < kSamePlane;
                        });
  }
  complete(hull);
  return hull;
}

namespace {

/// Four points that lie in no plane. If there are none, points that span the rest of space join
/// `points`: the hull of all has the edges of the hull of those before.
std::array<int, 4> spanning(std::vector<Vector3d>& points) {
  const int count = static_cast<int>(points.size());
  // Squares may underflow, and then the points would seem to be one.
  const auto size_of = [](const Vector3d& v) { return std::hypot(v.x(), v.y(), v.z()); };
  const int a = farthest(points, [&](const Vector3d& p) { return size_of(p - points[0]); });
  const Vector3d from = at(points, a);
  const int b = farthest(points, [&](const Vector3d& p) { return size_of(p - from); });
  const Vector3d edge = at(points, b) - from;
  const double reach = std::max({1.0, from.cwiseAbs().maxCoeff(), edge.norm()});
  std::array<Vector3d, 3> beside;
  for (int axis = 0; axis < 3; ++axis) beside[axis] = from + reach * Vector3d::Unit(axis);
  const auto is_on_line = [&](const Vector3d& p) {
    return std::all_of(beside.begin(), beside.end(), [&](const Vector3d& other) {
      return orientation(from, at(points, b), p, other) == 0;
    });
  };
  const auto first = [&](int likely, const auto& fits) {
    for (int i = -1; i < count; ++i) {
      const int index = i < 0 ? likely : i;
      if (fits(at(points, index))) return index;
    }
    return -1;
  };
  const auto join = [&](const Vector3d& p) {
    points.push_back(p);
    return static_cast<int>(points.size()) - 1;
  };
  if (edge.isZero(0.0)) return {a, join(beside[0]), join(beside[1]), join(beside[2])};
  int c = first(farthest(points, [&](const Vector3d& p) { return edge.cross(p - from).norm(); }),
                [&](const Vector3d& p) { return !is_on_line(p); });
  if (c < 0) {
    c = join(*std::find_if(beside.begin(), beside.end(),
                           [&](const Vector3d& p) { return !is_on_line(p); }));
  }
  const auto is_beside = [&](const Vector3d& p) {
    return orientation(from, at(points, b), at(points, c), p) != 0;
  };
  const Vector3d normal = edge.cross(at(points, c) - from);
  int d = first(farthest(points, [&](const Vector3d& p) { return std::abs(normal.dot(p - from)); }),
                is_beside);
  if (d < 0) d = join(*std::find_if(beside.begin(), beside.end(), is_beside));
  return {a, b, c, d};
}

}  // namespace

Polyhedron exact_hull(std::span<const Vector3d> points) {
  std::vector<Vector3d> all(points.begin(), points.end());
  const std::array<int, 4> start = spanning(all);
  Polyhedron hull;
  hull.faces = merged(all, Quickhull(all).run(start),
                      [&](const auto&, const auto&, const Triangle& in, const Triangle& beside) {
                        return std::all_of(beside.begin(), beside.end(), [&](int corner) {
                          return orientation(at(all, in[0]), at(all, in[1]), at(all, in[2]),
                                             at(all, corner)) == 0;
                        });
                      });
  complete(hull);
  std::vector<int> degree(all.size(), 0);
  for (const Polyhedron::Edge& edge : hull.edges) {
    for (const int end : {edge.from, edge.to}) ++degree[end];
  }
  const int count = static_cast<int>(points.size());
  std::erase_if(hull.vertices, [&](int vertex) { return vertex >= count; });
  // A corner of two faces alone lies on an edge; without it triangles have true vertices only.
  std::vector<int> kept;
  for (const int vertex : hull.vertices) {
    if (degree[vertex] > 2) kept.push_back(vertex);
  }
  if (kept.size() < hull.vertices.size()) {
    std::vector<Vector3d> true_vertices;
    for (const int vertex : kept) true_vertices.push_back(at(points, vertex));
    hull = exact_hull(true_vertices);
    const auto named = [&](int& vertex) { vertex = kept[vertex]; };
    for (Polyhedron::Face& face : hull.faces)
      std::for_each(face.vertices.begin(), face.vertices.end(), named);
    for (Polyhedron::Edge& edge : hull.edges) {
      named(edge.from);
      named(edge.to);
    }
    std::for_each(hull.vertices.begin(), hull.vertices.end(), named);
    return hull;
  }
  if (all.size() == points.size()) return hull;
  hull.faces.clear();
  std::erase_if(hull.edges,
                [&](const auto& edge) { return edge.from >= count || edge.to >= count; });
  for (Polyhedron::Edge& edge : hull.edges) edge.left = edge.right = -1;
  return hull;
}

std::vector<std::vector<int>> neighbours_of(const Polyhedron& hull, std::size_t points) {
  std::vector<std::vector<int>> out(points);
  for (const Polyhedron::Edge& edge : hull.edges) {
    out[edge.from].push_back(edge.to);
    out[edge.to].push_back(edge.from);
  }
  for (std::vector<int>& ends : out) std::sort(ends.begin(), ends.end());
  return out;
}

}  // namespace gjkscope
