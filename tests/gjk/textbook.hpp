#pragma once
// GJK in the plane on one page, as the slides tell it (Catto 2010), in doubles that it believes.
// The core takes the same steps; what it has beyond them is for rounding: textbook_test.cpp.

#include <Eigen/Core>
#include <vector>

namespace textbook {
using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;

inline double dot(const Point& a, const Point& b) { return a.x() * b.x() + a.y() * b.y(); }
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

struct Vertex {       // of Z = Y - X, the set of all differences y - x:
  int x, y;           // the vertices of X and Y that make it,
  Point w;            // their difference,
  double weight = 1;  // and its share in P, the simplex's point closest to the origin O.
};
using Simplex = std::vector<Vertex>;  // a point, a segment or a triangle

/// The first vertex that lies farthest along d.
inline int support(const Polygon& shape, const Point& d) {
  int best = 0;
  for (int i = 1; i < static_cast<int>(shape.size()); ++i)
    if (dot(d, shape[i]) > dot(d, shape[best])) best = i;
  return best;
}

/// The vertices that P needs, with its barycentric coordinates for weights. ab is the coordinate
/// of A in the segment AB, ba that of B, and a that of A in the triangle, times what they divide
/// by.
inline Simplex closest(const Simplex& s) {
  const auto edge = [&](int i, int k) { return dot(s[k].w, s[k].w - s[i].w); };
  const auto keep = [&](Simplex kept, double u, double v, double w = 0) {
    const double parts[] = {u, v, w};
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i].weight = parts[i] / (u + v + w);
    return kept;
  };
  if (s.size() == 1) return s;
  const double ab = edge(0, 1), ba = edge(1, 0);
  if (s.size() == 2) {
    if (ab <= 0) return keep({s[1]}, 1, 0);
    if (ba <= 0) return keep({s[0]}, 1, 0);
    return keep(s, ab, ba);
  }
  const double bc = edge(1, 2), cb = edge(2, 1), ca = edge(2, 0), ac = edge(0, 2);
  const double abc = cross(s[1].w - s[0].w, s[2].w - s[0].w);  // twice the signed area
  const double a = abc * cross(s[1].w, s[2].w);
  const double b = abc * cross(s[2].w, s[0].w);
  const double c = abc * cross(s[0].w, s[1].w);
  if (ba <= 0 && ca <= 0) return keep({s[0]}, 1, 0);
  if (ab <= 0 && cb <= 0) return keep({s[1]}, 1, 0);
  if (bc <= 0 && ac <= 0) return keep({s[2]}, 1, 0);
  if (ab > 0 && ba > 0 && c <= 0) return keep({s[0], s[1]}, ab, ba);
  if (bc > 0 && cb > 0 && a <= 0) return keep({s[1], s[2]}, bc, cb);
  if (ca > 0 && ac > 0 && b <= 0) return keep({s[0], s[2]}, ac, ca);
  return keep(s, a, b, c);
}

/// The simplex that holds the point of Z closest to O; at most `cap` rounds are made.
inline Simplex gjk(const Polygon& x, const Polygon& y, int cap) {
  Simplex s = {{0, 0, y[0] - x[0]}};
  while (true) {
    s = closest(s);
    if (s.size() == 3) return s;  // O is inside: the shapes overlap
    Point d = -s[0].w;
    if (s.size() == 2) {  // the edge's normal, with the sign that leads to O
      const Point normal(s[1].w.y() - s[0].w.y(), s[0].w.x() - s[1].w.x());
      d = dot(normal, d) < 0 ? Point(-normal) : normal;
    }
    const int far_x = support(x, -d), far_y = support(y, d);
    for (const Vertex& v : s)
      if (v.x == far_x && v.y == far_y) return s;  // nothing of Z lies farther along d
    if (d.isZero(0) || --cap == 0) return s;       // O lies in a vertex; or it does not end
    s.push_back({far_x, far_y, y[far_y] - x[far_x]});
  }
}

}  // namespace textbook
