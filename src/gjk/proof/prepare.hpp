#pragma once
// Before a run: checks the query, chooses the unit of length, places the vertices, and bounds how
// large rounding errors can become.

#include <algorithm>

#include "gjk/proof/error_free.hpp"
#include "gjk/query.hpp"

namespace gjk {

/// The vertices of a shape of at most so many are turned into world axes before the run. For a
/// larger shape each direction is turned into the shape's frame.
inline constexpr int kMaxPlaced = 8;

/// How many lengths |d|^2, the longest product of a run, multiplies. In the plane d is as long as
/// an edge; in space it may be a product of three lengths.
template <int D>
inline constexpr int kDegree = D == 2 ? 2 : 6;

/// One shape as a run sees it. R: the scalar of the run, not of the query.
template <class R, int D>
struct Body {
  // As in Measures:
  Vec<R, D> centre = Vec<R, D>::Zero();  ///< In the shape's own frame and unit.
  bool is_ring = false;
  std::array<int, 2> far_apart = {};
  R radius = R(0);  ///< In the run's unit.

  int placed_count = 0;  ///< 0 for a large shape, and for exact scalars.
  /// The vertices relative to the centre, in world axes and the run's unit.
  std::array<Vec<R, D>, kMaxPlaced> placed;
};

/// All that a run needs beside the query. `prepare` makes it.
template <class R, int D>
struct Prepared {
  /// The run's unit of length is 2^exponent. It is 1 unless squares of coordinates would come near
  /// overflow or underflow.
  int exponent = 0;
  R unit = R(1);  ///< 2^-exponent, for scalars that round.
  Error error = Error::none;
  bool same_frame = false;  ///< One unturned pose for both: differences of vertices round once.
  bool centred = false;     ///< Some centre is not the origin of its shape's frame.
  Body<R, D> x;
  Body<R, D> y;
  /// From the centre of X to that of Y, in world axes and the run's unit.
  Vec<R, D> offset = Vec<R, D>::Zero();
  R offset_error = R(0);

  /// A vector, given in the query's unit, in the run's unit.
  [[nodiscard]] Vec<R, D> in_unit(const Vec<R, D>& a) const {
    Vec<R, D> out;
    for (int i = 0; i < D; ++i) {
      if constexpr (ScalarTraits<R>::kExact) {
        out[i] = ScalarTraits<R>::scaled(a[i], -exponent);
      } else {
        out[i] = a[i] * unit;
      }
    }
    return out;
  }

  // Lengths in the run's unit, up to a few roundings.
  R extent = R(0);        ///< Twice this is at least the diameter of Z.
  R reach = R(0);         ///< No point of Z is farther from O.
  R least_reach = R(0);   ///< Some point of Z is at least as far from O.
  R from_origins = R(0);  ///< `reach`, plus how far both centres are from their frames' origins.
  R moved = R(0);         ///< Sum over the shapes: roundings of moving a vertex, times the radius.
  bool scans_placed = false;  ///< Scans see the vertices of both shapes as Z has them.

  // Bounds of rounding errors, in the run's unit, from an analysis of every operation; tests/truth
  // checks them against exact answers. 0 for exact scalars.

  R vertex_error = R(0);  ///< Of a vertex w of Z, apart from u |w|.
  /// Of the choice of a support point along a direction in doubt by `angle` (in radians): how much
  /// farther along d / |d| the true one may lie. A scan compares two dot products; for each, the
  /// vertex was centred, and the vertex or the direction was turned.
  [[nodiscard]] R scan_error_within(const R& angle) const {
    const R u = ScalarTraits<R>::unit_roundoff();
    return u * (R(2 * D) * extent + R(2) * moved) + R(2) * angle * extent;
  }
  /// Of the distance of a support plane: from its support point w, |w| = `reach_of_w`, and from the
  /// choice of w. With `scans_placed` scans saw w as it is, so `moved` counts in vertex_error only.
  [[nodiscard]] R plane_error(const R& distance, const R& reach_of_w) const {
    const R u = ScalarTraits<R>::unit_roundoff();
    const R dots = u * (R(2 * D) * extent);
    const R of_support =
        scans_placed ? R(vertex_error + dots) : R(vertex_error + (dots + u * (R(2) * moved)));
    return of_support + u * (R(D + 1) * reach_of_w + R(4) * distance);
  }
  /// Of a length computed with about twice the digits.
  [[nodiscard]] R careful_error() const {
    const R u = ScalarTraits<R>::unit_roundoff();
    return R(256) * u * u * from_origins;
  }
  /// Of |P|: from the vertices of the simplex, and from the arithmetic on them.
  [[nodiscard]] R simplex_error() const {
    return vertex_error + R(8 * D) * ScalarTraits<R>::unit_roundoff() * reach;
  }
};

namespace detail {

/// Both shapes with their measures.
template <class S, int D>
struct Bodies {
  const Query<S, D>& query;
  const Measures<S, D>& x;
  const Measures<S, D>& y;
};

template <class S, int D>
[[nodiscard]] bool is_finite(const Pose<S, D>& pose) {
  for (int i = 0; i < D; ++i) {
    if (!gjk::is_finite<S, D>(pose.rotation.col(i))) return false;
  }
  return gjk::is_finite(pose.translation);
}

[[nodiscard]] inline bool bad_start(const WarmStart& start, int x_count, int y_count,
                                    int dimension) {
  if (start.count < 0 || start.count > dimension + 1) return true;
  return std::any_of(start.pairs.begin(), start.pairs.begin() + start.count,
                     [&](const VertexPair& pair) {
                       return pair.x < 0 || pair.x >= x_count || pair.y < 0 || pair.y >= y_count;
                     });
}

/// The first thing wrong. Alone, a pose that is not finite is found later, by `reach`.
template <class S, int D>
[[nodiscard]] Error first_wrong(const Bodies<S, D>& bodies, const Options& options) {
  const auto& [query, x, y] = bodies;
  const int x_count = static_cast<int>(query.x.vertices().size());
  const int y_count = static_cast<int>(query.y.vertices().size());
  const bool bad_options =
      options.iteration_cap < 1 || !(options.tolerance >= 0.0 && options.tolerance < 1.0);
  const bool wrong = x_count == 0 || y_count == 0 || !x.is_finite || !y.is_finite || bad_options ||
                     bad_start(options.start, x_count, y_count, D);
  if (!wrong) [[likely]]
    return Error::none;
  if (x_count == 0) return Error::x_has_no_vertices;
  if (y_count == 0) return Error::y_has_no_vertices;
  if (!x.is_finite || !is_finite(query.x.pose)) return Error::x_not_finite;
  if (!y.is_finite || !is_finite(query.y.pose)) return Error::y_not_finite;
  return bad_options ? Error::bad_options : Error::bad_start;
}

/// From the origin of X's frame to that of Y's, in the run's unit. To stay in the range of R, large
/// coordinates are scaled before the subtraction, and small ones after it.
template <class R, class S, int D>
[[nodiscard]] Vec<DoubleWord<R>, D> offset_of_origins(const Query<S, D>& query,
                                                      const Prepared<R, D>& prepared) {
  const R first = prepared.exponent > 0 ? prepared.unit : R(1);
  const R last = prepared.exponent > 0 ? R(1) : prepared.unit;
  Vec<DoubleWord<R>, D> out;
  for (int i = 0; i < D; ++i) {
    const R x = ScalarTraits<R>::from(query.x.pose.translation[i]) * first;
    const R y = ScalarTraits<R>::from(query.y.pose.translation[i]) * first;
    const DoubleWord<R> offset = exact_sum(y, R(-x));
    out[i] = DoubleWord<R>(offset.hi * last, offset.lo * last);
  }
  return out;
}

/// From the centre of X to that of Y, computed with about twice the digits and rounded once.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Vec<R, D> offset_of_centres(const Query<S, D>& query,
                                                         const Prepared<R, D>& prepared) {
  // In one frame vertices of Z are made without it: it only gives the start and the reach of Z.
  if (prepared.same_frame) return prepared.in_unit(prepared.y.centre - prepared.x.centre);
  const Vec<DoubleWord<R>, D> origins = offset_of_origins(query, prepared);
  const auto turned = [&](const Shape<S, D>& shape, const Vec<R, D>& centre) {
    Vec<DoubleWord<R>, D> in_unit;
    for (int i = 0; i < D; ++i) in_unit[i] = DoubleWord<R>(centre[i] * prepared.unit);
    return shape.pose.template rotated<DoubleWord<R>>(in_unit);
  };
  const Vec<DoubleWord<R>, D> x = turned(query.x, prepared.x.centre);
  const Vec<DoubleWord<R>, D> y = turned(query.y, prepared.y.centre);
  Vec<R, D> out;
  for (int i = 0; i < D; ++i) out[i] = (origins[i] + (y[i] - x[i])).hi;
  return out;
}

/// Sets the unit 2^exponent, the frames and the offset between them.
template <class R, class S, int D>
void set_frames(const Bodies<S, D>& bodies, int exponent, Prepared<R, D>& prepared) {
  const Query<S, D>& query = bodies.query;
  prepared.exponent = exponent;
  if (exponent != 0) prepared.unit = ScalarTraits<R>::scaled(R(1), -exponent);
  prepared.same_frame = !query.x.pose.rotation.turns() && !query.y.pose.rotation.turns() &&
                        is_zero(Vec<S, D>(query.y.pose.translation - query.x.pose.translation));
  if constexpr (ScalarTraits<R>::kExact) {
    prepared.offset = prepared.in_unit(converted<R, S, D>(query.y.pose.translation) -
                                       converted<R, S, D>(query.x.pose.translation));
  } else {
    prepared.centred = bodies.x.is_centred || bodies.y.is_centred;
    if (prepared.centred) {
      prepared.x.centre = converted<R, S, D>(bodies.x.centre);
      prepared.y.centre = converted<R, S, D>(bodies.y.centre);
      prepared.offset = offset_of_centres<R>(query, prepared);
      prepared.offset_error = ScalarTraits<R>::unit_roundoff() * length(prepared.offset);
    } else {
      const Vec<DoubleWord<R>, D> offset = offset_of_origins(query, prepared);
      for (int i = 0; i < D; ++i) {
        prepared.offset[i] = offset[i].hi;
        prepared.offset_error = prepared.offset_error + magnitude(offset[i].lo);
      }
    }
  }
}

/// Vertex i relative to its shape's centre, in the shape's own axes and the run's unit.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> from_centre(const Shape<S, D>& shape, const Prepared<R, D>& prepared,
                                    const Body<R, D>& body, int i) {
  const auto& vertex = converted<R, S, D>(shape.vertices()[i]);
  return prepared.in_unit(prepared.centred ? Vec<R, D>(vertex - body.centre) : Vec<R, D>(vertex));
}

/// Sets all of one body but its centre.
template <class R, class S, int D>
void place(const Shape<S, D>& shape, const Measures<S, D>& measures, const Prepared<R, D>& prepared,
           Body<R, D>& body) {
  body.is_ring = measures.is_ring;
  body.far_apart = measures.far_apart;
  body.radius = ScalarTraits<R>::from(measures.radius) * prepared.unit;
  const int count = static_cast<int>(shape.vertices().size());
  if (count > kMaxPlaced) return;
  body.placed_count = count;
  for (int i = 0; i < count; ++i) {
    body.placed[i] = shape.pose.template rotated<R>(from_centre(shape, prepared, body, i));
  }
}

/// Sets the lengths from which rounding is bounded, and `vertex_error`.
template <class R, class S, int D>
void measure(const Bodies<S, D>& bodies, Prepared<R, D>& prepared) {
  R to_means(0);
  R to_centres(0);
  const auto add = [&](const Shape<S, D>& shape, const Measures<S, D>& measures,
                       const Body<R, D>& body) {
    const R stretch = ScalarTraits<R>::from(shape.pose.rotation.stretch());
    const R radius = body.radius * stretch;
    // A product with a matrix rounds by 1 + sqrt(D) roundings of the radius.
    if (shape.pose.rotation.turns()) {
      prepared.moved = prepared.moved + R(D == 2 ? 2.5 : 2.8) * radius;
    }
    if (prepared.centred) {
      if (measures.is_centred) prepared.moved = prepared.moved + radius;
      to_centres = to_centres +
                   careful_length(shape.pose.template rotated<R>(prepared.in_unit(body.centre)));
    }
    prepared.extent = prepared.extent + radius;
    to_means = to_means + ScalarTraits<R>::from(measures.to_mean) * prepared.unit * stretch;
  };
  add(bodies.query.x, bodies.x, prepared.x);
  add(bodies.query.y, bodies.y, prepared.y);
  const R far = length(prepared.offset);
  prepared.reach = far + prepared.extent;
  prepared.least_reach = far - to_means;
  prepared.from_origins = prepared.reach + to_centres;
  // In one frame a vertex of Z is one difference of given vertices, but scans may see centred ones.
  // Else both vertices are centred and turned, subtracted, and moved by the offset.
  prepared.scans_placed =
      !prepared.same_frame && prepared.x.placed_count > 0 && prepared.y.placed_count > 0;
  if (!prepared.same_frame) {
    prepared.vertex_error = prepared.offset_error +
                            ScalarTraits<R>::unit_roundoff() * (prepared.extent + prepared.moved);
  }
}

template <class R, class S, int D>
void prepare_in_unit(const Bodies<S, D>& bodies, int exponent, Prepared<R, D>& prepared) {
  set_frames(bodies, exponent, prepared);
  place(bodies.query.x, bodies.x, prepared, prepared.x);
  place(bodies.query.y, bodies.y, prepared, prepared.y);
  measure(bodies, prepared);
}

/// Prepares again, in a unit in which squares of coordinates neither overflow nor underflow.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Prepared<R, D> prepared_in_good_unit(const Bodies<S, D>& bodies) {
  using Traits = ScalarTraits<R>;
  const auto refused = [](Error error) {
    Prepared<R, D> prepared;
    prepared.error = error;
    return prepared;
  };
  if (!is_finite(bodies.query.x.pose)) return refused(Error::x_not_finite);
  if (!is_finite(bodies.query.y.pose)) return refused(Error::y_not_finite);
  // Squares may have gone out of range: first a unit in which they do not.
  constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
  const auto in_unit = [&](int exponent) {
    Prepared<R, D> prepared;
    prepare_in_unit(bodies, std::clamp(exponent, -kLimit, kLimit), prepared);
    return prepared;
  };
  const Vec<S, D> apart = bodies.query.y.pose.translation - bodies.query.x.pose.translation;
  const S largest = std::max({bodies.x.largest, bodies.y.largest, norm_max(apart)});
  Prepared<R, D> prepared = in_unit(Traits::exponent(Traits::from(largest)));
  if (prepared.reach == R(0)) return prepared;
  if (Traits::is_finite(prepared.reach)) {
    prepared = in_unit(prepared.exponent + Traits::exponent(prepared.reach));
  }
  if (!Traits::is_finite(prepared.reach)) return refused(Error::overflow);
  return Traits::template is_in_range<kDegree<D>>(prepared.reach) ? prepared
                                                                  : refused(Error::underflow);
}

template <class R, class S, int D>
void prepare(const Bodies<S, D>& bodies, const Options& options, Prepared<R, D>& prepared) {
  prepared.error = first_wrong(bodies, options);
  if (prepared.error != Error::none) return;
  if constexpr (ScalarTraits<R>::kExact) {
    set_frames(bodies, 0, prepared);
  } else {
    prepare_in_unit(bodies, 0, prepared);
    if (ScalarTraits<R>::template is_in_range<kDegree<D>>(prepared.reach)) [[likely]]
      return;
    prepared = prepared_in_good_unit<R>(bodies);
  }
}

}  // namespace detail

/// Checks the query and measures it for a run in R. Problems set Prepared::error.
template <class R, class S, int D>
[[nodiscard]] Prepared<R, D> prepare(const Query<S, D>& query, const Options& options) {
  const Measures<S, D>* x = query.x.measures();
  const Measures<S, D>* y = query.y.measures();
  Prepared<R, D> prepared;
  if (x != nullptr && y != nullptr) {
    detail::prepare(detail::Bodies<S, D>{query, *x, *y}, options, prepared);
  } else {
    const Measures<S, D> of_x = x != nullptr ? *x : measured<S, D>(query.x.vertices());
    const Measures<S, D> of_y = y != nullptr ? *y : measured<S, D>(query.y.vertices());
    detail::prepare(detail::Bodies<S, D>{query, of_x, of_y}, options, prepared);
  }
  return prepared;
}

}  // namespace gjk
