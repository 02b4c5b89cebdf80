#pragma once
// The expanding polytope (van den Bergen 2001, "Proximity queries and penetration depth computation
// on 3D game objects"; Cameron 1997, "Enhancing GJK: computing minimum and penetration distances
// between convex polyhedra").
//
//   start with GJK's last simplex
//   loop
//     nearest    take the face that is nearest to O, and its outward normal n
//     support    find the support point of Z = Y - X in direction n
//     stop       decide whether the face lies on the boundary of Z
//     expand     replace all faces that see the support point by faces from it to their horizon
//
// All corners are points of Z, so the polytope lies in Z: the nearest face bounds the depth from
// below. All of Z lies on this side of the plane through the support point, normal to n: that plane
// bounds the depth from above. They meet in the face of Z that is nearest to O.
//
// Which faces see a point is decided exactly, so the polytope is convex and never folds. Faces in
// one plane with the support point are replaced, too: then no new face is without an area, since
// none of the faces that stay holds the support point in its plane. O need not lie inside: a face
// that O lies beyond counts as nearer than all others, and the polytope grows there first.

#include "depth/space/state.hpp"
#include "gjk/proof/result.hpp"

namespace depth::space {
namespace detail {

template <class R>
[[nodiscard]] bool sees(const Polytope<R>& polytope, int face, const Vec<R, 3>& p, int least = 1) {
  const Face<R>& f = polytope.faces[face];
  return least <= side_of<R>(polytope.at(f, 0), polytope.at(f, 1), polytope.at(f, 2), p);
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

/// Adds a face, whose neighbours are set elsewhere.
template <class R>
int add_face(Polytope<R>& polytope, const std::array<int, 3>& corners) {
  Face<R> face;
  face.corners = corners;
  face.distance_sq =
      plane_distance_sq<R>(polytope.at(face, 0), polytope.at(face, 1), polytope.at(face, 2));
  const int added = static_cast<int>(polytope.faces.size());
  polytope.faces.push_back(std::move(face));
  polytope.heap.push_back(added);
  std::push_heap(polytope.heap.begin(), polytope.heap.end(), is_farther(polytope));
  return added;
}

/// The nearest face, which leaves the heap: it ends the run, or it is replaced.
template <class R>
[[nodiscard]] int take_nearest(Polytope<R>& polytope) {
  for (;;) {
    std::pop_heap(polytope.heap.begin(), polytope.heap.end(), is_farther(polytope));
    const int face = polytope.heap.back();
    polytope.heap.pop_back();
    if (!polytope.faces[face].is_outgrown) return face;
  }
}

/// An edge of the horizon, and the face beyond it, which stays.
struct HorizonEdge {
  int from = 0;
  int to = 0;
  int beyond = 0;
};

/// Marks the faces that see p, or lie in one plane with it, from one that does. They are all
/// connected, and so are those that stay: their common boundary is one ring, which is returned in
/// order.
template <class R, class Rec>
[[nodiscard]] std::vector<HorizonEdge> outgrow(Polytope<R>& polytope, int first, const Vec<R, 3>& p,
                                               Rec& record) {
  std::vector<Face<R>>& faces = polytope.faces;
  std::vector<int> seen = {first};
  faces[first].is_outgrown = true;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    for (const int beyond : faces[seen[k]].neighbours) {
      if (faces[beyond].is_outgrown || !sees(polytope, beyond, p, 0)) continue;
      faces[beyond].is_outgrown = true;
      seen.push_back(beyond);
    }
  }
  std::vector<HorizonEdge> ring;
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
  if constexpr (Rec::kOn) record.outgrown = std::move(seen);
  return ring;
}

/// Makes the polytope the hull of itself and of a point that `first` sees.
template <class R, class Rec>
void add_corner(Polytope<R>& polytope, int first, const gjk::SupportPoint<R, 3>& point,
                Rec& record) {
  const std::vector<HorizonEdge> ring = outgrow(polytope, first, point.w, record);
  const int apex = static_cast<int>(polytope.corners.size());
  polytope.corners.push_back(point);
  const int base = static_cast<int>(polytope.faces.size());
  const int count = static_cast<int>(ring.size());
  for (int k = 0; k < count; ++k) {
    const HorizonEdge& edge = ring[static_cast<std::size_t>(k)];
    const int added = add_face(polytope, {edge.from, edge.to, apex});
    polytope.faces[added].neighbours = {edge.beyond, base + (k + 1) % count,
                                        base + (k + count - 1) % count};
    Face<R>& beyond = polytope.faces[edge.beyond];
    for (int i = 0; i < 3; ++i) {
      if (beyond.corners[i] == edge.to && beyond.corners[(i + 1) % 3] == edge.from)
        beyond.neighbours[i] = added;
    }
    if constexpr (Rec::kOn) record.added.push_back(added);
  }
}

template <class R, class Rec>
void find_nearest_face(State<R>& state, Rec& record) {
  Polytope<R>& polytope = state.polytope;
  if constexpr (Rec::kOn) {
    for (int i = 0; i < static_cast<int>(polytope.faces.size()); ++i) {
      if (!polytope.faces[i].is_outgrown) record.faces.push_back(i);
    }
  }
  state.face = take_nearest(polytope);
  const Face<R>& face = polytope.faces[state.face];
  state.n = outward_normal<R>(polytope.at(face, 0), polytope.at(face, 1), polytope.at(face, 2));
  state.phase = Phase::support;
}

template <class R, class S, class Rec>
void find_support(State<R>& state, const gjk::Query<S, 3>& query,
                  const gjk::Prepared<R, 3>& prepared, Rec& record) {
  if constexpr (Rec::kOn) {
    record.scan_x = gjk::scan_entries(Vec<R, 3>(-state.n), query.x, prepared, prepared.x);
    record.scan_y = gjk::scan_entries(state.n, query.y, prepared, prepared.y);
  }
  state.support = gjk::support_point(query, prepared, gjk::farthest_pair(query, prepared, state.n));
  state.phase = Phase::stop;
}

/// Each iteration adds another pair of vertices, so there are no more of them than such pairs. Of
/// large round shapes not all are waited for: a polytope of twice as many faces.
template <class S>
[[nodiscard]] int iteration_cap(const gjk::Query<S, 3>& query) {
  constexpr std::size_t kMost = 10000;
  return static_cast<int>(
      std::min(8 + query.x.vertices().size() * query.y.vertices().size(), kMost));
}

/// The stop tests, in order; the first that holds names the reason. What each compares:
///
///   reason            left                                     right           holds if
///   repeated_support  corner of the face that is the support   0               left >= right
///                     point: 0, 1, 2, or -1 for none
///   no_progress       dot(n, support - corner of the face);    its rounding    left <= right
///                     0 where the face does not see it
///   iteration_cap     cap                                      iteration       left <= right
template <class R, class S, class Rec>
void run_stop_tests(State<R>& state, const gjk::Query<S, 3>& query, Rec& record) {
  const auto test = [&](StopReason reason, bool holds, const R& left, const R& right) {
    const bool tried = state.stop == StopReason::running;
    if constexpr (Rec::kOn) {
      record.stop_tests.push_back({reason, tried, tried && holds, left, right});
    }
    if (tried && holds) state.stop = reason;
  };
  const Polytope<R>& polytope = state.polytope;
  const Face<R>& face = polytope.faces[state.face];
  int repeated = -1;
  for (int i = 2; i >= 0; --i) {
    if (polytope.corners[face.corners[i]].pair == state.support.pair) repeated = i;
  }
  const Vec<R, 3> beyond = state.support.w - polytope.at(face, 0);
  const bool is_seen = repeated < 0 && sees(polytope, state.face, state.support.w);
  const R farther = is_seen ? gjk::dot(state.n, beyond) : R(0);
  R rounding(0);
  if constexpr (!gjk::ScalarTraits<R>::kExact) {
    rounding = gjk::ScalarTraits<R>::unit_roundoff() * gjk::norm_1(state.n) * gjk::norm_max(beyond);
  }
  const int cap = iteration_cap(query);

  test(StopReason::repeated_support, repeated >= 0, R(repeated), R(0));
  test(StopReason::no_progress, !(rounding < farther), farther, rounding);
  test(StopReason::iteration_cap, cap <= state.iteration, R(cap), R(state.iteration));
  if (state.stop == StopReason::running) state.phase = Phase::expand;
}

template <class R, class Rec>
void expand(State<R>& state, Rec& record) {
  add_corner(state.polytope, state.face, state.support, record);
  ++state.iteration;
  state.phase = Phase::nearest;
}

/// The first polytope, of the simplex and what it lacks to be a triangle: two faces back to back,
/// and what other points of the simplex see of it. Z has no more dimensions than it where it has
/// no area.
template <class R, class S>
void start_with(const gjk::Query<S, 3>& query, const gjk::Prepared<R, 3>& prepared,
                std::vector<gjk::SupportPoint<R, 3>> points, Polytope<R>& polytope) {
  using Point = gjk::SupportPoint<R, 3>;
  std::vector<Point>& corners = polytope.corners;
  const auto take = [&](const Point& point) {
    const bool fits = corners.empty() ||
                      (corners.size() == 1 && !gjk::is_zero(Vec<R, 3>(point.w - corners[0].w))) ||
                      (corners.size() == 2 && !has_no_area<R>(corners[0].w, corners[1].w, point.w));
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
    const Vec<R, 3> beside = outward_normal<R>(corners[0].w, corners[1].w, corners[1].w);
    if (!look_along(beside)) {
      look_along(gjk::cross(beside, Vec<R, 3>(corners[1].w - corners[0].w)));
    }
  }
  while (corners.size() < 3) corners.push_back(Point(corners.back()));
  for (const std::array<int, 3>& face : {std::array{0, 1, 2}, std::array{0, 2, 1}}) {
    const int added = add_face(polytope, face);
    polytope.faces[added].neighbours.fill(1 - added);
  }
  NoRecord none;
  for (const Point& point : points) {
    for (int face = 0; face < static_cast<int>(polytope.faces.size()); ++face) {
      if (polytope.faces[face].is_outgrown || !sees(polytope, face, point.w)) continue;
      add_corner(polytope, face, point, none);
      break;
    }
  }
}

}  // namespace detail

/// The state before the first phase: the polytope is the simplex that GJK found around O.
template <class R, class S, class Found>
[[nodiscard]] State<R> start(const gjk::Query<S, 3>& query, const gjk::Prepared<R, 3>& prepared,
                             const gjk::Result<Found, 3>& found) {
  State<R> state;
  const auto refuse = [&](StopReason reason) {
    state.stop = reason;
    state.phase = Phase::stop;
    return state;
  };
  if (found.verdict == gjk::Verdict::none) return refuse(StopReason::failed);
  if (found.verdict == gjk::Verdict::separated) return refuse(StopReason::separated);
  if (found.verdict == gjk::Verdict::undecided) return refuse(StopReason::undecided);

  std::vector<gjk::SupportPoint<R, 3>> points;
  for (int i = 0; i < found.simplex.count; ++i) {
    points.push_back(gjk::support_point(query, prepared, found.simplex.vertices[i].pair));
  }
  detail::start_with(query, prepared, std::move(points), state.polytope);
  return state;
}

/// Runs the phase `state.phase`. The run goes on while `state.stop` is StopReason::running.
template <class R, class S, class Rec>
void step(State<R>& state, const gjk::Query<S, 3>& query, const gjk::Prepared<R, 3>& prepared,
          Rec& record) {
  switch (state.phase) {
    case Phase::nearest:
      return detail::find_nearest_face(state, record);
    case Phase::support:
      return detail::find_support(state, query, prepared, record);
    case Phase::stop:
      return detail::run_stop_tests(state, query, record);
    case Phase::expand:
      return detail::expand(state, record);
  }
}

/// Runs all phases until the run ends, recording nothing.
template <class R, class S>
void run(State<R>& state, const gjk::Query<S, 3>& query, const gjk::Prepared<R, 3>& prepared) {
  NoRecord none;
  while (state.stop == StopReason::running) step(state, query, prepared, none);
}

}  // namespace depth::space
