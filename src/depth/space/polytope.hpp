#pragma once
// The expanding polytope: the loop's part in space.
//
// Which faces see a point is decided exactly, so the polytope is convex and never folds. Faces in
// one plane with the support point are replaced, too: then no new face is without an area, since
// none of the faces that stay holds the support point in its plane. O need not lie inside: a face
// that O lies beyond counts as nearer than all others, and the polytope grows there first.

#include <array>

#include "depth/space/face_plane.hpp"
#include "depth/state.hpp"

namespace depth::space {

/// A triangle, its corners counter-clockwise seen from outside. One that the polytope has outgrown
/// stays where it is, so that indices keep their meaning.
template <class R>
struct Face : Plane<R> {
  std::array<int, 3> corners = {};
  std::array<int, 3> neighbours = {};  ///< [i] lies beyond the edge from corner i to the next one.
  bool is_outgrown = false;

  /// The edge that ends at a corner.
  [[nodiscard]] int edge_to(int corner) const {
    return corners[1] == corner ? 0 : corners[2] == corner ? 1 : 2;
  }
};

/// Some points of Z and their convex hull. A hull that is flat has two faces, back to back; where
/// it has no area both are one edge or point.
template <class R>
struct Polytope {
  std::vector<gjk::SupportPoint<R, 3>> corners;  ///< Also those that have come to lie inside.
  std::vector<Face<R>> faces;
  std::vector<int> hull;  ///< Faces that are not outgrown, in order.

  [[nodiscard]] const Vec<R, 3>& at(const Face<R>& face, int i) const {
    return corners[face.corners[i]].w;
  }
  [[nodiscard]] Triangle<R> triangle(const std::array<int, 3>& of) const {
    return {corners[of[0]].w, corners[of[1]].w, corners[of[2]].w};
  }
};

namespace detail {

/// True where the face sees p, or with `least` 0 lies in one plane with it.
template <class R>
[[nodiscard]] bool sees(const Polytope<R>& polytope, int face, const Vec<R, 3>& p, int least = 1) {
  const Face<R>& f = polytope.faces[face];
  return least <= side_of<R>(polytope.triangle(f.corners), f, p);
}

template <class R>
void add_face(Polytope<R>& polytope, const std::array<int, 3>& corners,
              const std::array<int, 3>& neighbours) {
  const int added = static_cast<int>(polytope.faces.size());
  polytope.faces.push_back({face_plane(polytope.triangle(corners)), corners, neighbours});
  polytope.hull.push_back(added);
}

/// Marks a face that sees the last corner, or lies in one plane with it, and all such faces beyond
/// `count` of its edges from `first` on. They are connected, and so are those that stay: their
/// common boundary is one ring, and the walk meets its edges in order. It adds a face to each.
template <class R, class Rec>
void outgrow(Polytope<R>& polytope, int face, int first, int count, Rec& record) {
  std::vector<Face<R>>& faces = polytope.faces;
  const int apex = static_cast<int>(polytope.corners.size()) - 1;
  faces[face].is_outgrown = true;
  if constexpr (Rec::kOn) record.outgrown.push_back(face);
  for (int k = first; k < first + count; ++k) {
    const int from = faces[face].corners[k % 3];
    const int beyond = faces[face].neighbours[k % 3];
    if (faces[beyond].is_outgrown) continue;
    if (sees(polytope, beyond, polytope.corners[apex].w, 0)) {
      outgrow(polytope, beyond, faces[beyond].edge_to(from) + 1, 2, record);
      continue;
    }
    const int added = static_cast<int>(faces.size());
    faces[beyond].neighbours[faces[beyond].edge_to(from)] = added;
    add_face(polytope, {from, faces[face].corners[(k + 1) % 3], apex},
             {beyond, added + 1, added - 1});
    if constexpr (Rec::kOn) record.added.push_back(added);
  }
}

/// Makes the polytope the hull of itself and of a point that `first` sees.
template <class R, class Rec>
void add_corner(Polytope<R>& polytope, int first, const gjk::SupportPoint<R, 3>& point,
                Rec& record) {
  const int begin = static_cast<int>(polytope.faces.size());
  polytope.corners.push_back(point);
  outgrow(polytope, first, 0, 3, record);
  const int last = static_cast<int>(polytope.faces.size()) - 1;
  polytope.faces[begin].neighbours[2] = last;
  polytope.faces[last].neighbours[1] = begin;
  std::erase_if(polytope.hull, [&](int face) { return polytope.faces[face].is_outgrown; });
}

}  // namespace detail
}  // namespace depth::space

namespace depth {

template <class R>
struct State<R, 3> : Progress<R, 3> {
  space::Polytope<R> polytope;
  int face = -1;  ///< The nearest one.
};

/// Faces are indices.
template <class R>
struct Record<R, 3> : Notes<R> {
  std::vector<int> faces;  ///< The polytope whose nearest face was looked for.
  std::vector<int> added;  ///< Those from the support point to the horizon, in order.
};

namespace detail {

/// The first polytope, of the simplex and what it lacks to be a triangle: two faces back to back,
/// and what other points of the simplex see of it. Z has no more dimensions than it where it has no
/// area.
template <class R, class S>
void start_with(std::vector<gjk::SupportPoint<R, 3>> points, const gjk::Query<S, 3>& query,
                const gjk::Prepared<R, 3>& prepared, State<R, 3>& state) {
  using Point = gjk::SupportPoint<R, 3>;
  space::Polytope<R>& polytope = state.polytope;
  std::vector<Point>& corners = polytope.corners;
  corners.reserve(16);
  polytope.faces.reserve(64);
  polytope.hull.reserve(64);
  const auto has_area = [](const Vec<R, 3>& a, const Vec<R, 3>& b, const Vec<R, 3>& c) {
    return !gjk::is_zero(space::face_plane<R>({a, b, c}).n);  // exact: no thin plane is rough
  };
  const auto take = [&](const Point& point) {
    const std::size_t count = corners.size();
    const bool fits = count == 0 ||
                      (count == 1 && !gjk::is_zero(Vec<R, 3>(point.w - corners[0].w))) ||
                      (count == 2 && has_area(corners[0].w, corners[1].w, point.w));
    if (fits) corners.push_back(point);
    return fits;
  };
  std::erase_if(points, take);
  const auto look_along = [&](const Vec<R, 3>& d) {
    const auto found = [&](const Vec<R, 3>& along) {
      return take(gjk::support_point(query, prepared, gjk::farthest_pair(query, prepared, along)));
    };
    return found(d) || found(-d);
  };
  for (int axis = 0; axis < 3 && corners.size() == 1; ++axis) look_along(Vec<R, 3>::Unit(axis));
  if (corners.size() == 2) {
    const Vec<R, 3> edge = corners[1].w - corners[0].w;
    const Vec<R, 3> beside = space::any_perpendicular(edge);
    if (!look_along(beside)) look_along(gjk::cross(beside, edge));
  }
  while (corners.size() < 3) corners.push_back(Point(corners.back()));
  space::detail::add_face(polytope, {0, 1, 2}, {1, 1, 1});
  space::detail::add_face(polytope, {0, 2, 1}, {0, 0, 0});
  NoRecord none;
  for (const Point& point : points) {
    const auto seeing = std::find_if(polytope.hull.begin(), polytope.hull.end(), [&](int face) {
      return space::detail::sees(polytope, face, point.w);
    });
    if (seeing != polytope.hull.end()) space::detail::add_corner(polytope, *seeing, point, none);
  }
}

/// Corner i of the nearest face.
template <class R>
[[nodiscard]] const gjk::SupportPoint<R, 3>& nearest_corner(const State<R, 3>& state, int i) {
  return state.polytope.corners[state.polytope.faces[state.face].corners[i]];
}

/// A triangle without an area has no normal: any direction perpendicular to its edges will do.
template <class R, class Rec>
void find_nearest(State<R, 3>& state, Rec& record) {
  const std::vector<space::Face<R>>& faces = state.polytope.faces;
  const std::vector<int>& hull = state.polytope.hull;
  if constexpr (Rec::kOn) record.faces = hull;
  state.face = *std::min_element(hull.begin(), hull.end(), [&](int one, int other) {
    return faces[one].distance_sq < faces[other].distance_sq;
  });
  const Vec<R, 3>& a = nearest_corner(state, 0).w;
  const Vec<R, 3> ab = nearest_corner(state, 1).w - a;
  if constexpr (gjk::ScalarTraits<R>::kExact) {
    state.n = gjk::cross(ab, Vec<R, 3>(nearest_corner(state, 2).w - a));
  } else {
    state.n = faces[state.face].n;
  }
  if (gjk::is_zero(state.n)) state.n = space::any_perpendicular(ab);
}

template <class R, class Rec>
void expand(State<R, 3>& state, Rec& record) {
  space::detail::add_corner(state.polytope, state.face, state.support, record);
}

}  // namespace detail
}  // namespace depth
