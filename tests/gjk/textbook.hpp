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
struct Input {
  Polygon x, y;
  int start_x = 0, start_y = 0;  // the vertices of X and Y that make the first simplex
};
struct SimplexVertex {   // of Z = Y - X, the set of all differences y - x:
  int index_x, index_y;  // the vertices of X and Y that make it,
  Point w;               // their difference,
  double weight = 1;     // and its share in P, the simplex's point closest to the origin O.
};
using Simplex = std::vector<SimplexVertex>;  // a point, a segment or a triangle
struct Output {
  Simplex simplex;  // a triangle where X and Y overlap
  int iterations;
  Point p = {0, 0}, x = {0, 0}, y = {0, 0};  // P, and the closest points of X and Y
  double distance = 0;
};
inline int support(const Polygon& shape, const Point& d) {
  int best = 0;
  for (int i = 1; i < static_cast<int>(shape.size()); ++i)
    if (dot(d, shape[i]) > dot(d, shape[best])) best = i;
  return best;  // the first vertex that lies farthest along d
}

/// The vertices that P needs. ab is A's coordinate in AB, a that in ABC, but for a divisor.
inline Simplex closest(const Simplex& s) {
  const auto edge = [&](int i, int k) { return dot(s[k].w, s[k].w - s[i].w); };
  const auto keep = [&](Simplex kept, double u, double v = 0, double w = 0) {
    const double parts[] = {u, v, w};
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i].weight = parts[i] / (u + v + w);
    return kept;
  };
  if (s.size() == 1) return s;
  const double ab = edge(0, 1), ba = edge(1, 0);
  if (s.size() == 2 && ab <= 0) return keep({s[1]}, 1);
  if (s.size() == 2 && ba <= 0) return keep({s[0]}, 1);
  if (s.size() == 2) return keep(s, ab, ba);
  const double bc = edge(1, 2), cb = edge(2, 1), ca = edge(2, 0), ac = edge(0, 2);
  const double abc = cross(s[1].w - s[0].w, s[2].w - s[0].w);  // twice the signed area
  const auto part = [&](int i, int k) { return abc * cross(s[i].w, s[k].w); };
  const double a = part(1, 2), b = part(2, 0), c = part(0, 1);
  if (ba <= 0 && ca <= 0) return keep({s[0]}, 1);
  if (ab <= 0 && cb <= 0) return keep({s[1]}, 1);
  if (bc <= 0 && ac <= 0) return keep({s[2]}, 1);
  if (ab > 0 && ba > 0 && c <= 0) return keep({s[0], s[1]}, ab, ba);
  if (bc > 0 && cb > 0 && a <= 0) return keep({s[1], s[2]}, bc, cb);
  if (ca > 0 && ac > 0 && b <= 0) return keep({s[0], s[2]}, ac, ca);
  return keep(s, a, b, c);
}

inline Output gjk(const Input& in, int cap = 64) {
  Simplex s = {{in.start_x, in.start_y, in.y[in.start_y] - in.x[in.start_x]}};
  for (int iterations = 1;; ++iterations) {
    s = closest(s);
    Output out = {s, iterations};
    for (const auto& v : s) out.p += v.weight * v.w;
    for (const auto& v : s) out.x += v.weight * in.x[v.index_x];
    for (const auto& v : s) out.y += v.weight * in.y[v.index_y];
    if (s.size() == 3) return out;  // O is inside: the shapes overlap
    out.distance = out.p.norm();
    const Point e = s.back().w - s[0].w;
    Point d = s.size() == 1 ? Point(-s[0].w) : Point(e.y(), -e.x());  // normal to the edge
    if (dot(d, s[0].w) > 0) d = -d;                                   // and towards O
    const int far_x = support(in.x, -d), far_y = support(in.y, d);
    for (const auto& v : s)
      if (v.index_x == far_x && v.index_y == far_y) return out;  // nothing is farther along d
    if (d.isZero(0) || iterations == cap) return out;  // O lies in a vertex; or it does not end
    s.push_back({far_x, far_y, in.y[far_y] - in.x[far_x]});
  }
}
}  // namespace textbook
