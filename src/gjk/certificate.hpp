#pragma once
// What is proved of the distance: bounds that include what rounding can do.
//
// P bounds the distance from above, the best support plane from below (Larsen 1998, "Proof of Local
// Verification"). tests/truth holds all of it against exact answers.

#include "gjk/careful.hpp"
#include "gjk/support.hpp"

namespace gjk {

/// The distance as a floating-point run has it, between its bounds.
template <class R>
struct Bounds {
  R lower = R(0);
  R distance = R(0);
  R upper = R(0);
};

namespace detail {

/// The lower bound of the distance that the best support plane proves.
template <class R, int D>
[[nodiscard]] R plane_bound(const State<R, D>& state, const Prepared<R, D>& prepared) {
  const R distance = ScalarTraits<R>::root(state.plane_distance_sq);
  const R reach = ScalarTraits<R>::root(state.plane_reach_sq);
  return larger(R(distance - prepared.plane_error(distance, reach)), R(0));
}

/// What rounding can do to a determinant of D vertices with no coordinate larger than `size`: when
/// none is longer than r and each in doubt by e + u r, it errs by less than r^(D-1) (D e +
/// 8 D D! u r).
template <class R, int D>
[[nodiscard]] R volume_error(const R& size, const Prepared<R, D>& prepared) {
  const R r = ScalarTraits<R>::from(D == 2 ? 1.5 : 1.8) * size;
  R error =
      R(D) * prepared.vertex_error + R(D == 2 ? 32 : 144) * ScalarTraits<R>::unit_roundoff() * r;
  for (int i = 1; i < D; ++i) error = error * r;
  return error;
}

/// True when every weight of the full simplex around O is positive beyond doubt.
template <class R, int D>
[[nodiscard]] bool surely_inside(const Simplex<R, D>& simplex, const Prepared<R, D>& prepared) {
  const R error = volume_error(largest_coordinate(simplex), prepared);
  const Barycentric<R, D> coordinates = volume_coordinates(simplex);
  for (int i = 0; i <= D; ++i) {
    if (!(error < coordinates.numerator[i])) return false;
  }
  return true;
}

/// True when, for all that rounding lets one know, no vertex of the shape but i and j lies as far
/// along d as either of them. `error`: of a difference of two dot products with d.
template <class R, class S, int D>
[[nodiscard]] bool are_alone(const Vec<R, D>& d, const Shape<S, D>& shape,
                             const Prepared<R, D>& prepared, const Body<R, D>& body, int i, int j,
                             const R& error) {
  return look_along(d, shape, prepared, body, [&](int count, const auto& along) {
    const R certainly_nearer = smaller(R(along(i)), R(along(j))) - error;
    int as_far = 0;
    for (int k = 0; k < count; ++k) as_far += along(k) < certainly_nearer ? 0 : 1;
    return as_far == (i == j ? 1 : 2);
  });
}

/// Distances less than this share of the reach of Z are mostly rounding: they are computed anew
/// with about twice the digits, and so is the support of their plane.
inline constexpr int kNear = 4096;
/// The same for vertices of one frame, which round so little that distances of a sixteenth of the
/// reach gain by it,
inline constexpr int kNearInOneFrame = 16;
/// and for those from an edge that are over half of the reach: they round up to six times.
inline constexpr int kFarFromEdge = 2;
/// How wide bounds may be, in u times the distance from O to some vertex of Z, before rounding must
/// have led the run astray. Just below 16, which is what tests/truth demands.
inline constexpr double kAllowedWidth = 15.5;
/// How often a distance in the run's own digits rounds at worst: from a vertex, or from the line of
/// an edge; there the edge itself has rounded, too, and its product with the nearer end.
inline constexpr int kRoundings = 4;
inline constexpr int kEdgeRoundings = 3;

/// Proves bounds for a run in the plane that ended outside of Z: at vertex a, or between a and b.
///
/// Mostly the numbers of the run do. The nearer P is, the more of its distance is the rounding of
/// vertices: then the distance is computed anew, with about twice the digits. Nearer still, the
/// vertices that P lies between may be the wrong ones, unless all others are certainly farther.
template <class R, class S>
class OutsideBounds {
 public:
  OutsideBounds(const State<R, 2>& state, const Query<S, 2>& query, const Prepared<R, 2>& prepared)
      : state_(state), query_(query), prepared_(prepared) {
    length_a_ = length(a_.w);
    if (on_edge_) {
      way_ = b_.w - a_.w;
      length_b_ = length(b_.w);
      edge_length_ = length(way_);
    }
  }

  /// `ended`: by itself, so that wide bounds mean that rounding has led it astray.
  [[nodiscard]] Bounds<R> prove(bool ended) {
    Bounds<R> out;
    out.lower = plane_bound(state_, prepared_);
    distance_ = on_edge_ ? R(cross(a_.w, way_) / edge_length_) : length_a_;
    error_ = prepared_.vertex_error + R(kRoundings) * u_ * magnitude(distance_);
    if (on_edge_) {
      error_ = error_ + u_ * (size() + R(kEdgeRoundings) * smaller(length_a_, length_b_));
    }
    near_ = R(kNear) * magnitude(distance_) < prepared_.reach;
    const R width = magnitude(distance_) + error_ - out.lower;
    const bool wide = ended && !near_ && !is_allowed(width);
    if (near_ || wide || is_too_rounded()) compute_anew();
    out.distance = magnitude(distance_);
    out.upper = reach_of_foot(out.distance);
    if ((near_ || wide) && is_certainly_farthest()) {
      out.lower = larger(R(out.distance - error_), R(0));
    }
    out.distance = larger(out.distance, out.lower);
    out.upper = larger(out.distance, out.upper);
    return out;
  }

  /// As close as rounding lets bounds be. Else rounding led the run astray.
  [[nodiscard]] bool is_tight(const Bounds<R>& bounds) const {
    const R width = bounds.upper - bounds.lower;
    return near_ ? width <= R(4) * error_ : is_allowed(width);
  }

 private:
  /// Of the vertices that P is made of, the farthest from O.
  [[nodiscard]] R size() const { return on_edge_ ? larger(length_a_, length_b_) : length_a_; }
  [[nodiscard]] R vertex_error() const { return prepared_.vertex_error + u_ * size(); }
  /// Of the direction from P to O.
  [[nodiscard]] R d_length() const { return on_edge_ ? edge_length_ : length_a_; }
  [[nodiscard]] R angle() const { return R(2) * u_ + R(2) * vertex_error() / d_length(); }

  /// The squared distance from O to the farthest of four vertices of Z: those that are made of the
  /// points of X, and of Y, that lie far apart.
  [[nodiscard]] R corner_reach_sq() const {
    R most(0);
    for (const int x : prepared_.x.far_apart) {
      for (const int y : prepared_.y.far_apart) {
        const Vec<R, 2> w = support_point(query_, prepared_, {x, y}).w;
        most = larger(most, dot(w, w));
      }
    }
    return most;
  }
  [[nodiscard]] bool is_allowed(const R& width) const {
    const R allowed = ScalarTraits<R>::from(kAllowedWidth) * u_;
    return width <= allowed * larger(prepared_.least_reach, size()) ||
           width <= allowed * ScalarTraits<R>::root(corner_reach_sq());
  }
  [[nodiscard]] bool is_too_rounded() const {
    return (prepared_.same_frame && R(kNearInOneFrame) * magnitude(distance_) < prepared_.reach) ||
           (on_edge_ && prepared_.reach < R(kFarFromEdge) * magnitude(distance_));
  }
  void compute_anew() {
    distance_ = on_edge_ ? careful_distance<R>(careful_edge(query_, prepared_, a_.pair, b_.pair))
                         : careful_distance<R>(careful_vertex(query_, prepared_, a_.pair));
    error_ = R(kCarefulRoundings) * u_ * magnitude(distance_) + prepared_.careful_error();
  }
  /// An upper bound. The foot of the perpendicular from O may lie a little beyond an end of the
  /// edge.
  [[nodiscard]] R reach_of_foot(const R& distance) const {
    const R upper = distance + error_;
    if (!on_edge_) return upper;
    const R beyond = vertex_error() + R(4) * u_ * size() + angle() * distance;
    const R least_weight = smaller(state_.best.weights[0], state_.best.weights[1]);
    if (!(edge_length_ * least_weight < beyond)) return upper;
    return length(Vec<R, 2>(upper, smaller(beyond, edge_length_)));
  }
  /// Certainly no vertex of Z but those that P is made of lies as far along the direction to O.
  [[nodiscard]] bool is_certainly_farthest() const {
    const R side = sign_of(distance_);
    const Vec<R, 2> d = on_edge_ ? Vec<R, 2>(-side * way_[1], side * way_[0]) : Vec<R, 2>(-a_.w);
    const R error = d_length() * prepared_.scan_error_within(angle());
    const VertexPair a = a_.pair;
    const VertexPair b = on_edge_ ? b_.pair : a;
    if (on_edge_ && a.x != b.x && a.y != b.y) return false;
    return are_alone(Vec<R, 2>(-d), query_.x, prepared_, prepared_.x, a.x, b.x, error) &&
           are_alone(d, query_.y, prepared_, prepared_.y, a.y, b.y, error);
  }

  const State<R, 2>& state_;
  const Query<S, 2>& query_;
  const Prepared<R, 2>& prepared_;
  const SupportPoint<R, 2>& a_ = state_.best.vertices[0];
  const SupportPoint<R, 2>& b_ = state_.best.vertices[1];
  bool on_edge_ = state_.best.count == 2;
  R u_ = ScalarTraits<R>::unit_roundoff();
  Vec<R, 2> way_ = Vec<R, 2>::Zero();
  R length_a_;
  R length_b_ = R(0);
  R edge_length_ = R(0);
  /// From the vertex, or from the edge's line: negative when O lies on that side of the edge to
  /// which perpendicular(way) points.
  R distance_ = R(0);
  R error_ = R(0);
  bool near_ = false;
};

}  // namespace detail
}  // namespace gjk
