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

/// A triangle, its corners counter-clockwise seen from outside. A triangle that is no longer part
/// of the polytope stays in the list, so that indices keep their meaning.
template <class R>
struct Face : Plane<R> {
  std::array<int, 3> corners = {};
  std::array<int, 3> neighbours = {};  ///< [i] lies beyond the edge from corner i to the next one.
  bool is_outgrown = false;
};

/// An edge of the horizon, and the face beyond it, which stays.
struct HorizonEdge {
  int from = 0;
  int to = 0;
  int beyond = 0;
};

/// Some points of Z and their convex hull. A hull that is flat has two faces, back to back; where
/// it has no area both are one edge or point.
template <class R>
struct Polytope {
  std::vector<gjk::SupportPoint<R, 3>> corners;  ///< Also those that have come to lie inside.
  std::vector<Face<R>> faces;
  /// A heap of faces, the nearest in front. Outgrown ones stay until they come to the front.
  std::vector<int> heap;
  std::vector<int> seen;          ///< By the point that is added; kept for the room it has,
  std::vector<HorizonEdge> ring;  ///< as is the horizon.

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

/// The order of the heap: is a farther than b? Of equal ones the older is nearer.
template <class R>
[[nodiscard]] auto is_farther(const Polytope<R>& polytope) {
  return [&polytope](int a, int b) {
    const R& of_a = polytope.faces[a].distance_sq;
    const R& of_b = polytope.faces[b].distance_sq;
    if (of_b < of_a) return true;
    return of_b == of_a && b < a;
  };
}

template <class R>
void make_careful(const Polytope<R>& polytope, Face<R>& face) {
  if (face.is_rough) static_cast<Plane<R>&>(face) = careful_plane(polytope.triangle(face.corners));
}

template <class R>
void push(Polytope<R>& polytope, int face) {
  polytope.heap.push_back(face);
  std::push_heap(polytope.heap.begin(), polytope.heap.end(), is_farther(polytope));
}

/// Adds a face, whose neighbours are set elsewhere.
template <class R>
int add_face(Polytope<R>& polytope, const std::array<int, 3>& corners) {
  const int added = static_cast<int>(polytope.faces.size());
  polytope.faces.push_back({face_plane(polytope.triangle(corners)), corners});
  push(polytope, added);
  return added;
}

/// The nearest face, which leaves the heap: it ends the run, or it is replaced. A rough plane in
/// front may lie behind another one when it is known better.
template <class R>
[[nodiscard]] int take_nearest(Polytope<R>& polytope) {
  std::vector<int>& heap = polytope.heap;
  for (;;) {
    std::pop_heap(heap.begin(), heap.end(), is_farther(polytope));
    const int taken = heap.back();
    heap.pop_back();
    Face<R>& face = polytope.faces[taken];
    if (face.is_outgrown) continue;
    make_careful(polytope, face);
    if (heap.empty() || !is_farther(polytope)(taken, heap.front())) return taken;
    push(polytope, taken);
  }
}

/// Marks the faces that see p, or lie in one plane with it, from one that does. They are all
/// connected, and so are those that stay: their common boundary is one ring, in order.
template <class R>
void outgrow(Polytope<R>& polytope, int first, const Vec<R, 3>& p) {
  std::vector<Face<R>>& faces = polytope.faces;
  std::vector<int>& seen = polytope.seen;
  seen.assign(1, first);
  faces[first].is_outgrown = true;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    for (const int beyond : faces[seen[k]].neighbours) {
      if (faces[beyond].is_outgrown || !sees(polytope, beyond, p, 0)) continue;
      faces[beyond].is_outgrown = true;
      seen.push_back(beyond);
    }
  }
  std::vector<HorizonEdge>& ring = polytope.ring;
  ring.clear();
  for (const int face : seen) {
    const Face<R>& gone = faces[face];
    for (int i = 0; i < 3; ++i) {
      const int beyond = gone.neighbours[i];
      if (faces[beyond].is_outgrown) continue;
      ring.push_back({gone.corners[i], gone.corners[(i + 1) % 3], beyond});
    }
  }
  for (std::size_t k = 1; k < ring.size(); ++k) {
    const auto next = std::find_if(ring.begin() + static_cast<long>(k), ring.end(),
                                   [&](const HorizonEdge& e) { return e.from == ring[k - 1].to; });
    std::swap(ring[k], *next);
  }
}

/// Makes the polytope the hull of itself and of a point that `first` sees.
template <class R, class Rec>
void add_corner(Polytope<R>& polytope, int first, const gjk::SupportPoint<R, 3>& point,
                Rec& record) {
  outgrow(polytope, first, point.w);
  if constexpr (Rec::kOn) record.outgrown = polytope.seen;
  const int apex = static_cast<int>(polytope.corners.size());
  polytope.corners.push_back(point);
  const int base = static_cast<int>(polytope.faces.size());
  const int count = static_cast<int>(polytope.ring.size());
  for (int k = 0; k < count; ++k) {
    const HorizonEdge& edge = polytope.ring[k];
    const int added = add_face(polytope, {edge.from, edge.to, apex});
    polytope.faces[added].neighbours = {edge.beyond, k + 1 < count ? added + 1 : base,
                                        k > 0 ? added - 1 : base + count - 1};
    Face<R>& beyond = polytope.faces[edge.beyond];
    for (int i = 0; i < 3; ++i) {
      if (beyond.corners[i] == edge.to && beyond.corners[(i + 1) % 3] == edge.from)
        beyond.neighbours[i] = added;
    }
    if constexpr (Rec::kOn) record.added.push_back(added);
  }
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
/// and what other points of the simplex see of it. Z has no more dimensions than it where it has
/// no area.
template <class R, class S>
void start_with(std::vector<gjk::SupportPoint<R, 3>> points, const gjk::Query<S, 3>& query,
                const gjk::Prepared<R, 3>& prepared, State<R, 3>& state) {
  using Point = gjk::SupportPoint<R, 3>;
  space::Polytope<R>& polytope = state.polytope;
  std::vector<Point>& corners = polytope.corners;
  corners.reserve(16);
  polytope.faces.reserve(64);
  polytope.heap.reserve(64);
  const auto take = [&](const Point& point) {
    const std::size_t count = corners.size();
    const bool fits = count == 0 ||
                      (count == 1 && !gjk::is_zero(Vec<R, 3>(point.w - corners[0].w))) ||
                      (count == 2 && !space::has_no_area<R>(corners[0].w, corners[1].w, point.w));
    if (fits) corners.push_back(point);
    return fits;
  };
  std::erase_if(points, take);
  const auto look_along = [&](const Vec<R, 3>& d) {
    const auto found = [&](const Vec<R, 3>& way) {
      return take(gjk::support_point(query, prepared, gjk::farthest_pair(query, prepared, way)));
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
  for (const std::array<int, 3>& face : {std::array{0, 1, 2}, std::array{0, 2, 1}}) {
    const int added = space::detail::add_face(polytope, face);
    polytope.faces[added].neighbours.fill(1 - added);
  }
  NoRecord none;
  for (const Point& point : points) {
    for (int face = 0; face < static_cast<int>(polytope.faces.size()); ++face) {
      if (polytope.faces[face].is_outgrown || !space::detail::sees(polytope, face, point.w))
        continue;
      space::detail::add_corner(polytope, face, point, none);
      break;
    }
  }
}

/// Makes all planes careful, as a trace shows them. No decision depends on it.
template <class R>
void measure_all(State<R, 3>& state) {
  space::Polytope<R>& polytope = state.polytope;
  for (space::Face<R>& face : polytope.faces) space::detail::make_careful(polytope, face);
  std::make_heap(polytope.heap.begin(), polytope.heap.end(), space::detail::is_farther(polytope));
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
  if constexpr (Rec::kOn) {
    for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
      if (!faces[i].is_outgrown) record.faces.push_back(i);
    }
  }
  state.face = space::detail::take_nearest(state.polytope);
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
