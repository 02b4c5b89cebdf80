#include "outlines/v_clip.hpp"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "outlines/exact_sign.hpp"

namespace v_clip {
namespace {

using Eigen::Vector3d;
using gjk::cross;
using gjk::dot;
using gjkscope::difference;
using gjkscope::sign_of;
using gjkscope::value_of;
template <class N>
using Vec = gjk::Vec<N, 3>;
using Edge = gjkscope::Polyhedron::Edge;

template <class T>
const T& at(const std::vector<T>& all, int i) {
  return all[i];
}
template <class T>
int count_of(const std::vector<T>& all) {
  return static_cast<int>(all.size());
}

const Vector3d& point(const Body& body, int vertex) { return at(body.points, vertex); }
const Vector3d& corner(const Body& body, const Body::Face& face, int i) {
  return point(body, at(face.vertices, i % count_of(face.vertices)));
}
template <class N>
Vec<N> along(const Body& body, int edge) {
  return difference<N>(point(body, at(body.edges, edge).from),
                       point(body, at(body.edges, edge).to));
}
/// A normal that points outwards, of any length.
template <class N>
Vec<N> normal(const Body& body, const Body::Face& face) {
  const int third = count_of(face.vertices) / 3;  // corners far apart round least
  const Vector3d& from = corner(body, face, 0);
  return cross(difference<N>(from, corner(body, face, third)),
               difference<N>(from, corner(body, face, 2 * third)));
}
template <class N>
N height(const Body& body, const Body::Face& face, const Vector3d& p) {
  return dot(normal<N>(body, face), difference<N>(corner(body, face, 0), p));
}
int side_of(const Body& body, const Body::Face& face, const Vector3d& p) {
  return sign_of([&]<class N>(N) { return height<N>(body, face, p); });
}

/// The point from + way / weight; weight > 0.
template <class N>
struct Spot {
  const Vector3d* from = nullptr;
  Vec<N> difference = Vec<N>(N(0), N(0), N(0));
  N weight = N(1);
};
/// The way from a point to a spot, times its weight.
template <class N>
Vec<N> difference_to(const Vector3d& from, const Spot<N>& spot) {
  return difference<N>(from, *spot.from) * spot.weight + spot.difference;
}

/// A feature of one body, seen beside one of the other.
struct Side {
  const Body& body;
  Feature feature;
  [[nodiscard]] const Vector3d& vertex() const { return point(body, feature.index); }
  [[nodiscard]] const Edge& edge() const { return at(body.edges, feature.index); }
  [[nodiscard]] const Vector3d& from() const { return point(body, edge().from); }
  [[nodiscard]] const Vector3d& to() const { return point(body, edge().to); }
  [[nodiscard]] const Body::Face& face() const { return at(body.faces, feature.index); }
};

/// For edges a and b: the shares of their closest points, times `common`, which is 0 where they
/// are parallel (Ericson 2005, "Real-Time Collision Detection", 5.1.9).
template <class N>
struct Shares {
  N of_a;
  N of_b;
  N common;
};
template <class N>
Shares<N> shares(const Side& a, const Side& b) {
  const Vec<N> u = along<N>(a.body, a.feature.index);
  const Vec<N> w = along<N>(b.body, b.feature.index);
  const Vec<N> r = difference<N>(b.from(), a.from());
  const N uw = dot(u, w);
  return {uw * dot(w, r) - dot(w, w) * dot(u, r), dot(u, u) * dot(w, r) - uw * dot(u, r),
          dot(u, u) * dot(w, w) - uw * uw};
}

/// The point of `a` that is closest to `b`, when both closest points lie inside of their features.
template <class N>
Spot<N> foot(const Side& a, const Side& b) {
  if (a.feature.kind == Kind::vertex) return {&a.vertex()};
  if (a.feature.kind == Kind::face) {
    const Vec<N> n = normal<N>(a.body, a.face());
    return {&b.vertex(), n * -height<N>(a.body, a.face(), b.vertex()), dot(n, n)};
  }
  const Vec<N> u = along<N>(a.body, a.feature.index);
  if (b.feature.kind == Kind::vertex)
    return {&a.from(), u * dot(u, difference<N>(a.from(), b.vertex())), dot(u, u)};
  const Shares<N> s = shares<N>(a, b);
  return {&a.from(), u * s.of_a, s.common};
}

/// The place of a spot's foot on the line ab: -1 at a or before, 1 at b or beyond, else 0.
template <class Foot>
int spot_on(const Vector3d& a, const Vector3d& b, const Foot& spot) {
  const auto from = [&](const Vector3d& end) {
    return sign_of(
        [&]<class N>(N n) { return dot(difference<N>(a, b), difference_to<N>(end, spot(n))); });
  };
  return from(a) <= 0 ? -1 : from(b) >= 0 ? 1 : 0;
}
int spot_on(const Side& edge, const Vector3d& p) {
  return spot_on(edge.from(), edge.to(), [&]<class N>(N) { return Spot<N>{&p}; });
}
Feature end_of(const Side& edge, int end) {
  return {Kind::vertex, end < 0 ? edge.edge().from : edge.edge().to};
}

/// An index i for which `value` has at least the sign `least`, or -1. The pairs (value, weight) are
/// the corners of a convex cone, in order, seen from a plane through it: weights are positive but
/// for the first and the last one, which are 0. So value / weight rises up to its largest and falls
/// from there, where it is not positive at both ends. `note` takes the signs that were asked for.
template <class Value, class Weight, class Note>
int search(int count, int least, const Value& value, const Weight& weight, const Note& note) {
  const auto holds = [&](int i) {
    const int sign = sign_of([&]<class N>(N n) { return value(n, i); });
    note(i, sign);
    return sign >= least;
  };
  if (count == 0) return -1;
  if (holds(0)) return 0;
  if (count > 1 && holds(count - 1)) return count - 1;
  if (count < 3) return -1;
  int low = 1;
  int high = count - 2;
  while (low < high) {
    const int i = (low + high) / 2;
    const int rise = sign_of([&]<class N>(N n) {
      return value(n, i + 1) * weight(n, i) - value(n, i) * weight(n, i + 1);
    });
    (rise > 0 ? low : high) = rise > 0 ? i + 1 : i;
  }
  return holds(low) ? low : -1;
}

/// How far a spot lies beyond side i of a face, in some unit.
template <class N>
N beyond_side(const Body& body, const Body::Face& face, int i, const Spot<N>& spot) {
  const Vector3d& from = corner(body, face, i);
  const Vec<N> out = cross(difference<N>(from, corner(body, face, i + 1)), normal<N>(body, face));
  return dot(out, difference_to<N>(from, spot));
}

/// The feature of a face that is nearest to a spot over or below the face's plane: the face itself
/// only where the spot is over its inside.
template <class Foot>
Feature nearest_of_face(const Body& body, int index, const Foot& spot) {
  const Body::Face& face = at(body.faces, index);
  const int count = count_of(face.vertices);
  int i = search(
      count, 0, [&]<class N>(N n, int side) { return beyond_side<N>(body, face, side, spot(n)); },
      [&]<class N>(N, int side) {
        return -beyond_side<N>(body, face, side, {&corner(body, face, 0)});
      },
      [](int, int) {});
  if (i < 0) return {Kind::face, index};
  // The distance from sides that the spot lies beyond falls toward the nearest one.
  const auto place = [&](int side) {
    return spot_on(corner(body, face, side), corner(body, face, side + 1), spot);
  };
  const int first = place(i);
  if (first == 0) return {Kind::edge, at(face.edges, i)};
  for (;;) {
    const int shared = first < 0 ? i : (i + 1) % count;
    i = (i + first + count) % count;
    const int there = place(i);
    if (there == 0) return {Kind::edge, at(face.edges, i)};
    if (there != first) return {Kind::vertex, at(face.vertices, shared)};
  }
}
Feature nearest_of_face(const Body& body, int index, const Vector3d& p) {
  return nearest_of_face(body, index, [&]<class N>(N) { return Spot<N>{&p}; });
}

/// The state while one phase runs, from the side of either body.
struct Look {
  State& state;
  const Query& query;
  Record& record;

  [[nodiscard]] Side side(bool of_x) const {
    return of_x ? Side{query.x, state.x} : Side{query.y, state.y};
  }
  /// Names what is next: a feature of one body, and of the other the same, or another one.
  void take(Reason reason, bool of_x, Feature own, Feature other) const {
    state.next = {reason, of_x ? own : other, of_x ? other : own};
    state.phase = Phase::swap;
  }
  void take(Reason reason, bool of_x, Feature own) const {
    take(reason, of_x, own, side(!of_x).feature);
  }
  void overlap(Reason reason) const {
    state.next = {reason, state.x, state.y};
    state.stop = Stop::overlap;
  }
};

/// Two edges: an end, or both, where their closest points are ends.
void look_at_edges(const Look& look) {
  const Side a = look.side(true);
  const Side b = look.side(false);
  const auto sign = [&](auto of) {
    return sign_of([&]<class N>(N) { return of(shares<N>(a, b)); });
  };
  const bool parallel = sign([](const auto& s) { return s.common; }) == 0;
  const auto place = [&](auto share) {
    return sign(share) <= 0                                                ? -1
           : sign([&](const auto& s) { return share(s) - s.common; }) >= 0 ? 1
                                                                           : 0;
  };
  const auto end = [](const Side& edge, int spot) { return spot < 0 ? edge.from() : edge.to(); };
  int on_a = parallel ? -1 : place([](const auto& s) { return s.of_a; });
  const int on_b =
      on_a == 0 ? place([](const auto& s) { return s.of_b; }) : spot_on(b, end(a, on_a));
  if (on_b != 0) on_a = spot_on(a, end(b, on_b));
  if (on_a != 0 || on_b != 0) {
    look.take(Reason::edge_end, true, on_a == 0 ? a.feature : end_of(a, on_a),
              on_b == 0 ? b.feature : end_of(b, on_b));
    return;
  }
  const int volume = sign_of([&]<class N>(N) {
    return dot(cross(along<N>(a.body, a.feature.index), along<N>(b.body, b.feature.index)),
               difference<N>(a.from(), b.from()));
  });
  if (volume == 0) look.overlap(Reason::meet);
}

/// The sides over which the line from a to b, seen along a face's normal, enters the face and
/// leaves it; none where it does not cross the inside.
std::optional<std::array<int, 2>> crossed_sides(const Body& body, const Body::Face& face,
                                                const Vector3d& a, const Vector3d& b) {
  const int count = count_of(face.vertices);
  // How far corner i lies on one side of the line: 1 for its left, seen from outside.
  const auto beside = [&]<class N>(N, int i, int side) {
    const N left = dot(cross(normal<N>(body, face), difference<N>(a, b)),
                       difference<N>(a, corner(body, face, i)));
    return side > 0 ? left : -left;
  };
  const auto find = [&](int side) {
    return search(
        count, 1, [&]<class N>(N n, int i) { return beside(n, i, side); },
        [&]<class N>(N, int i) {
          return -beyond_side<N>(body, face, count - 1, {&corner(body, face, i)});
        },
        [](int, int) {});
  };
  // The side on which the ring, from a corner on the other side of the line, comes to `side`.
  const auto crossing = [&](int from, int to, int side) {
    int low = 0;
    int high = (to - from + count) % count;
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      const int i = (from + middle) % count;
      (sign_of([&]<class N>(N n) { return beside(n, i, side); }) > 0 ? high : low) = middle;
    }
    return (from + low) % count;
  };
  const int left = find(1);
  const int right = find(-1);
  if (left < 0 || right < 0) return std::nullopt;
  return std::array{crossing(left, right, -1), crossing(right, left, 1)};
}

/// Mirtich's clip of an edge against a face.
void clip(const Look& look, bool edge_of_x) {
  const Side edge = look.side(edge_of_x);
  const Side other = look.side(!edge_of_x);
  const Body& body = other.body;
  const Body::Face& face = other.face();
  const Vector3d& a = edge.from();
  const Vector3d& b = edge.to();
  const auto beyond = [&](int side, const Vector3d& p) {
    return sign_of([&]<class N>(N) { return beyond_side<N>(body, face, side, {&p}); });
  };
  const auto take_side = [&](Reason reason, int side) {
    look.take(reason, !edge_of_x, {Kind::edge, at(face.edges, side)});
  };
  int entry = -1;  // none: the edge starts over the face
  int exit = -1;   // none: it ends there
  if (const auto sides = crossed_sides(body, face, a, b)) {
    const auto [in, out] = *sides;
    if (beyond(in, b) >= 0) return take_side(Reason::clip_empty, in);
    if (beyond(out, a) >= 0) return take_side(Reason::clip_empty, out);
    if (beyond(in, a) > 0) entry = in;
    if (beyond(out, b) > 0) exit = out;
  } else {  // it stands upright, or misses the face
    const Feature nearest = nearest_of_face(body, other.feature.index, a);
    if (nearest != other.feature) return look.take(Reason::clip_empty, !edge_of_x, nearest);
  }
  // It crosses a side at the share cut[0] / cut[1] of its length.
  const auto cut = [&]<class N>(N, int side) {
    const N at_a = beyond_side<N>(body, face, side, {&a});
    return std::array{at_a, at_a - beyond_side<N>(body, face, side, {&b})};
  };
  const auto share_at = [&](int side, double end) {
    if (side < 0) return end;
    return static_cast<double>(value_of([&]<class N>(N n) { return cut(n, side)[0]; }) /
                               value_of([&]<class N>(N n) { return cut(n, side)[1]; }));
  };
  const auto side_at = [&](int side, const Vector3d& end) {
    if (side < 0) return side_of(body, face, end);
    const int sign = sign_of([&]<class N>(N n) {
      const N at_a = height<N>(body, face, a);
      const std::array<N, 2> share = cut(n, side);
      return at_a * share[1] + (height<N>(body, face, b) - at_a) * share[0];
    });
    return side == entry ? sign : -sign;  // where it leaves, cut[1] is negative
  };
  const Clip part{share_at(entry, 0.0), share_at(exit, 1.0), side_at(entry, a), side_at(exit, b)};
  look.record.clip = part;
  if (part.side_from * part.side_to <= 0) return look.overlap(Reason::penetration);
  const int slope =
      sign_of([&]<class N>(N) { return dot(normal<N>(body, face), difference<N>(a, b)); });
  const bool nearer_at_start = slope * part.side_from >= 0;
  const int side = nearer_at_start ? entry : exit;
  if (side >= 0) return take_side(Reason::clip_side, side);
  look.take(Reason::clip_end, edge_of_x, end_of(edge, nearer_at_start ? -1 : 1));
}

/// A pair with a vertex: what is nearest to it on the other feature, which may be all of that.
void look_at_vertex(const Look& look, bool vertex_of_x) {
  const Vector3d& p = look.side(vertex_of_x).vertex();
  const Side other = look.side(!vertex_of_x);
  if (other.feature.kind == Kind::vertex) {
    if (p == other.vertex()) look.overlap(Reason::meet);
  } else if (other.feature.kind == Kind::edge) {
    const int spot = spot_on(other, p);
    if (spot != 0) return look.take(Reason::edge_end, !vertex_of_x, end_of(other, spot));
    const auto is_zero = [&](int i) {
      return sign_of([&]<class N>(N) {
               return N(cross(difference<N>(other.from(), other.to()),
                              difference<N>(other.from(), p))[i]);
             }) == 0;
    };
    if (is_zero(0) && is_zero(1) && is_zero(2)) look.overlap(Reason::meet);
  } else {
    const Feature nearest = nearest_of_face(other.body, other.feature.index, p);
    if (nearest != other.feature) return look.take(Reason::face_side, !vertex_of_x, nearest);
    if (side_of(other.body, other.face(), p) == 0) look.overlap(Reason::meet);
  }
}

void look_for_closest(const Look& look) {
  const Kind x = look.state.x.kind;
  const Kind y = look.state.y.kind;
  look.state.next = {};
  look.state.phase = Phase::regions;
  if (x == Kind::vertex || y == Kind::vertex) {
    look_at_vertex(look, x == Kind::vertex);
  } else if (x == Kind::edge && y == Kind::edge) {
    look_at_edges(look);
  } else if (x == Kind::edge || y == Kind::edge) {
    clip(look, x == Kind::edge);
  } else {
    look.take(Reason::two_faces, true, {Kind::vertex, look.side(true).face().vertices.front()});
  }
}

/// Mirtich's local minimum: a vertex behind a face, over its inside.
void leave_behind(const Look& look, bool face_of_x) {
  const Side own = look.side(face_of_x);
  const Vector3d& p = look.side(!face_of_x).vertex();
  int best = -1;
  for (int i = 0; i < count_of(own.body.faces); ++i) {
    ++look.record.faces_asked;
    const Body::Face& face = at(own.body.faces, i);
    if (side_of(own.body, face, p) <= 0) continue;
    // The way from p along the normal n enters in front of face i at the share h / -(n . n_i).
    const auto is_later = [&]<class N>(N) {
      const Vec<N> n = normal<N>(own.body, own.face());
      const Body::Face& other = at(own.body.faces, best);
      return height<N>(own.body, other, p) * dot(n, normal<N>(own.body, face)) -
             height<N>(own.body, face, p) * dot(n, normal<N>(own.body, other));
    };
    if (best < 0 || sign_of(is_later) > 0) best = i;
  }
  if (best < 0) return look.overlap(Reason::inside);
  look.take(Reason::behind_face, face_of_x, {Kind::face, best});
}

/// The borders of the region of one body's feature, until one is crossed.
void look_at_region(const Look& look, bool of_x) {
  const Side own = look.side(of_x);
  const Side other = look.side(!of_x);
  const auto spot = [&]<class N>(N) { return foot<N>(other, own); };
  const auto note = [&](Reason border, Feature beyond, int sign) {
    look.record.tests.push_back({border, of_x, beyond, sign});
  };
  if (own.feature.kind == Kind::vertex) {
    const std::vector<int>& spokes = at(own.body.spokes, own.feature.index);
    const auto spoke = [&]<class N>(N, int i) {
      const Edge& edge = at(own.body.edges, at(spokes, i));
      return difference<N>(own.vertex(),
                           point(own.body, edge.from == own.feature.index ? edge.to : edge.from));
    };
    const int crossed = search(
        count_of(spokes), 1,
        [&]<class N>(N n, int i) {
          return dot(spoke(n, i), difference_to<N>(own.vertex(), spot(n)));
        },
        [&]<class N>(N n, int i) {  // the face between the last spoke and the first
          const Edge& edge = at(own.body.edges, spokes.back());
          const int face = edge.from == own.feature.index ? edge.left : edge.right;
          return -dot(normal<N>(own.body, at(own.body.faces, face)), spoke(n, i));
        },
        [&](int i, int sign) {
          note(Reason::vertex_border, {Kind::edge, at(spokes, i)}, sign);
        });
    if (crossed >= 0) look.take(Reason::vertex_border, of_x, {Kind::edge, at(spokes, crossed)});
  } else if (own.feature.kind == Kind::edge) {
    for (const bool is_left : {true, false}) {
      const int face = is_left ? own.edge().left : own.edge().right;
      if (face < 0) return;
      const int inward = sign_of([&]<class N>(N n) {
        return dot(cross(normal<N>(own.body, at(own.body.faces, face)),
                         along<N>(own.body, own.feature.index)),
                   difference_to<N>(own.from(), spot(n)));
      });
      const int side = is_left ? inward : -inward;
      note(Reason::edge_border, {Kind::face, face}, side);
      if (side > 0)
        return look.take(Reason::edge_border, of_x, nearest_of_face(own.body, face, spot));
    }
  } else {
    const int side = -side_of(own.body, own.face(), other.vertex());
    note(Reason::behind_face, own.feature, side);
    if (side > 0) leave_behind(look, of_x);
  }
}

void look_at_regions(const Look& look) {
  look_at_region(look, true);
  if (look.state.next.reason == Reason::none) look_at_region(look, false);
  if (look.state.next.reason == Reason::none) look.state.stop = Stop::closest;
}

void swap(State& state, const Query& query) {
  const auto features = [](const Body& body) {
    return static_cast<double>(body.vertices.size() + body.edges.size() + body.faces.size());
  };
  state.x = state.next.x;
  state.y = state.next.y;
  state.phase = Phase::closest;
  if (++state.swaps > features(query.x) * features(query.y)) state.stop = Stop::pair_cap;
}

/// The way between closest points that lie inside of their features, times a weight; in that order.
template <class N>
std::pair<Vec<N>, N> gap(const Side& a, const Side& b) {
  if (a.feature.kind != Kind::edge || b.feature.kind != Kind::edge) {
    if (a.feature.kind != Kind::vertex) {
      const auto [back, weight] = gap<N>(b, a);
      return {-back, weight};
    }
    const Spot<N> to = foot<N>(b, a);
    return {difference_to<N>(a.vertex(), to), to.weight};
  }
  const Vec<N> k = cross(along<N>(a.body, a.feature.index), along<N>(b.body, b.feature.index));
  return {k * dot(k, difference<N>(a.from(), b.from())), dot(k, k)};
}

Points points_of(const Side& a, const Side& b) {
  const auto place = [](const Side& own, const Side& other) {
    Vector3d out;
    for (int i = 0; i < 3; ++i) {
      const auto coordinate = [&]<class N>(N) {
        const Spot<N> spot = foot<N>(own, other);
        return N(N((*spot.from)[i]) * spot.weight + spot.difference[i]);
      };
      const long double weight = value_of([&]<class N>(N) { return foot<N>(own, other).weight; });
      out[i] = static_cast<double>(value_of(coordinate) / weight);
    }
    return out;
  };
  std::array<long double, 3> difference = {};
  for (std::size_t i = 0; i < 3; ++i)
    difference[i] =
        value_of([&]<class N>(N) { return N(gap<N>(a, b).first[static_cast<int>(i)]); });
  const long double weight = value_of([&]<class N>(N) { return gap<N>(a, b).second; });
  const long double length = std::hypot(difference[0], difference[1], difference[2]) / weight;
  return {place(a, b), place(b, a), static_cast<double>(length)};
}

Points common_point(const Query& query, const State& state) {
  const Side x{query.x, state.x};
  const Side y{query.y, state.y};
  Vector3d p;
  if (state.next.reason == Reason::penetration) {
    const Side& edge = state.x.kind == Kind::edge ? x : y;
    const Side& face = state.x.kind == Kind::edge ? y : x;
    const auto at = [&](const Vector3d& end) {
      return value_of([&]<class N>(N) { return height<N>(face.body, face.face(), end); });
    };
    const long double from = at(edge.from());
    const long double to = at(edge.to());
    const double share = from == to ? 0.0 : static_cast<double>(from / (from - to));
    p = edge.from() + (edge.to() - edge.from()) * share;
  } else if (state.x.kind == Kind::vertex || state.y.kind == Kind::vertex) {
    p = state.x.kind == Kind::vertex ? x.vertex() : y.vertex();
  } else {
    p = points_of(x, y).x;
  }
  return {p, p, 0.0};
}

Points points_after(const Query& query, const State& state) {
  return state.stop == Stop::overlap ? common_point(query, state)
                                     : closest_points(query, state.x, state.y);
}

}  // namespace

Body body_of(std::vector<Vector3d> points) {
  gjkscope::Polyhedron hull = gjkscope::exact_hull(points);
  Body body{std::move(points), std::move(hull.vertices), std::move(hull.edges), {}, {}};
  body.spokes.resize(body.points.size());
  for (int i = 0; i < count_of(body.edges); ++i) {
    for (const int end : {at(body.edges, i).from, at(body.edges, i).to})
      body.spokes[end].push_back(i);
  }
  const auto beyond = [&](int edge, int vertex) {
    const Edge& e = at(body.edges, edge);
    return e.from == vertex ? e.to : e.from;
  };
  for (gjkscope::Polyhedron::Face& face : hull.faces) body.faces.push_back({face.vertices, {}});
  if (body.faces.empty() && body.edges.size() > 2) {  // a polygon
    std::vector<int> ring = {body.vertices.front()};
    int edge = at(body.spokes, ring[0]).front();
    for (int v = beyond(edge, ring[0]); v != ring[0]; v = beyond(edge, v)) {
      ring.push_back(v);
      const std::vector<int>& both = at(body.spokes, v);
      edge = both[0] == edge ? both[1] : both[0];
    }
    body.faces = {{ring, {}}, {{ring.rbegin(), ring.rend()}, {}}};
  }
  std::map<std::pair<int, int>, int> edge_of;
  for (int i = 0; i < count_of(body.edges); ++i)
    edge_of[{at(body.edges, i).from, at(body.edges, i).to}] = i;
  // The edge before each directed edge, in the ring on its left: around a vertex it is the next.
  std::map<std::pair<int, int>, int> before;
  for (int f = 0; f < count_of(body.faces); ++f) {
    Body::Face& face = body.faces[f];
    const int count = count_of(face.vertices);
    for (int i = 0; i < count; ++i) {
      const int from = at(face.vertices, i);
      const int to = at(face.vertices, (i + 1) % count);
      face.edges.push_back(edge_of.at(std::minmax(from, to)));
      Edge& edge = body.edges[face.edges.back()];
      (edge.from == from ? edge.left : edge.right) = f;
    }
    for (int i = 0; i < count; ++i)
      before[{at(face.vertices, i), at(face.edges, i)}] = at(face.edges, (i + count - 1) % count);
  }
  for (const int v : body.vertices) {
    std::vector<int>& spokes = body.spokes[v];
    if (spokes.size() < 3) continue;
    for (std::size_t i = 1; i < spokes.size(); ++i) spokes[i] = before.at({v, spokes[i - 1]});
  }
  return body;
}

State start(const Query& query) {
  return start(query, {Kind::vertex, query.x.vertices.front()},
               {Kind::vertex, query.y.vertices.front()});
}
State start(const Query&, Feature x, Feature y) {
  return {Phase::closest, x, y, {}, 0, Stop::running};
}

void step(State& state, const Query& query, Record& record) {
  switch (state.phase) {
    case Phase::closest:
      return look_for_closest({state, query, record});
    case Phase::regions:
      return look_at_regions({state, query, record});
    case Phase::swap:
      return swap(state, query);
  }
}

Result walk(const Query& query, State state) {
  while (state.stop == Stop::running) {
    Record record;
    step(state, query, record);
  }
  return {state.stop, state.next.reason,          state.x,
          state.y,    points_after(query, state), state.swaps + 1};
}

Trace trace(const Query& query, const State& from) {
  Trace out{from, {}, {}};
  State state = from;
  while (state.stop == Stop::running) {
    Step next;
    next.phase = state.phase;
    step(state, query, next.record);
    next.after = state;
    next.points = points_after(query, state);
    out.steps.push_back(std::move(next));
  }
  out.result = {state.stop, state.next.reason,       state.x,
                state.y,    out.steps.back().points, state.swaps + 1};
  return out;
}

Points closest_points(const Query& query, Feature x, Feature y) {
  State state = start(query, x, y);
  for (;;) {
    Record record;
    step(state, query, record);
    if (state.stop == Stop::overlap) return common_point(query, state);
    if (state.phase == Phase::regions) return points_of({query.x, state.x}, {query.y, state.y});
    swap(state, query);
  }
}

}  // namespace v_clip
