#pragma once
// The frames in which a run reads vertices: a unit of length, a center for each shape, and the
// offset between the centers.

#include "gjk/proof/error_free.hpp"
#include "gjk/query.hpp"

namespace gjk {

/// The vertices of a shape of at most so many are turned into world axes before the run. For a
/// larger shape each direction is turned into the shape's frame.
inline constexpr int kMaxPlaced = 8;

/// One shape as a run sees it.
template <class R, int D>
struct Body {
  // As in Measures:
  Vec<R, D> center = Vec<R, D>::Zero();  ///< In the shape's own frame and unit.
  bool is_ring = false;
  std::array<int, 2> far_apart = {};
  R radius = R(0);  ///< In the run's unit.

  int placed_count = 0;  ///< 0 for a large shape, and for exact scalars.
  /// The vertices relative to the center, in world axes and the run's unit.
  std::array<Vec<R, D>, kMaxPlaced> placed;
};

/// Everything but the vertices that the loop reads of a query.
template <class R, int D>
struct Frames {
  /// The run's unit of length is 2^exponent. It is 1 unless squares of coordinates would come near
  /// overflow or underflow.
  int exponent = 0;
  R unit = R(1);            ///< 2^-exponent, for scalars that round.
  bool same_frame = false;  ///< One unturned pose for both: differences of vertices round once.
  bool centered = false;    ///< True when a center is not the origin of its shape's frame.
  Body<R, D> x;
  Body<R, D> y;
  /// From the center of X to that of Y, in world axes and the run's unit.
  Vec<R, D> offset = Vec<R, D>::Zero();
  R offset_error = R(0);

  /// A vector, given in the query's unit, in the run's unit.
  [[nodiscard]] Vec<R, D> in_unit(const Vec<R, D>& a) const {
    if constexpr (ScalarTraits<R>::kExact)
      return scaled(a, -exponent);
    else
      return a * unit;
  }
};

namespace detail {

/// Both shapes with their measures.
template <class S, int D>
struct MeasuredQuery {
  const Query<S, D>& query;
  const Measures<S, D>& x;
  const Measures<S, D>& y;
};

/// From the origin of X's frame to that of Y's, in the run's unit. To stay in the range of R, large
/// coordinates are scaled before the subtraction, and small ones after it.
template <class R, class S, int D>
[[nodiscard]] Vec<DoubleWord<R>, D> offset_of_origins(const Query<S, D>& query,
                                                      const Frames<R, D>& frames) {
  const R first = frames.exponent > 0 ? frames.unit : R(1);
  const R last = frames.exponent > 0 ? R(1) : frames.unit;
  Vec<DoubleWord<R>, D> out;
  for (int i = 0; i < D; ++i) {
    const R x = ScalarTraits<R>::from(query.x.pose.translation[i]) * first;
    const R y = ScalarTraits<R>::from(query.y.pose.translation[i]) * first;
    const DoubleWord<R> offset = exact_sum(y, R(-x));
    out[i] = DoubleWord<R>(offset.hi * last, offset.lo * last);
  }
  return out;
}

/// A point of a shape's frame in world axes and the run's unit, with about twice the digits.
template <class R, class S, int D>
[[nodiscard]] Vec<DoubleWord<R>, D> careful_point(const Shape<S, D>& shape, const Vec<R, D>& local,
                                                  const Frames<R, D>& frames) {
  using Word = DoubleWord<R>;
  return shape.pose.template rotated<Word>(converted<Word, R, D>(frames.in_unit(local)));
}

/// From the center of X to that of Y, computed with about twice the digits and rounded once.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Vec<R, D> offset_of_centers(const Query<S, D>& query,
                                                         const Frames<R, D>& frames) {
  // In one frame vertices of Z are made without it: it only gives the start and the reach of Z.
  if (frames.same_frame) return frames.in_unit(frames.y.center - frames.x.center);
  const Vec<DoubleWord<R>, D> x = careful_point(query.x, frames.x.center, frames);
  const Vec<DoubleWord<R>, D> y = careful_point(query.y, frames.y.center, frames);
  return converted<R, DoubleWord<R>, D>(offset_of_origins(query, frames) + (y - x));
}

/// Sets the unit 2^exponent, the frames and the offset between them.
template <class R, class S, int D>
void set_frames(const MeasuredQuery<S, D>& measured, int exponent, Frames<R, D>& frames) {
  const Query<S, D>& query = measured.query;
  frames.exponent = exponent;
  if (exponent != 0) frames.unit = ScalarTraits<R>::scaled(R(1), -exponent);
  frames.same_frame = !query.x.pose.rotation.turns() && !query.y.pose.rotation.turns() &&
                      is_zero(Vec<S, D>(query.y.pose.translation - query.x.pose.translation));
  if constexpr (ScalarTraits<R>::kExact) {
    frames.offset = frames.in_unit(converted<R, S, D>(query.y.pose.translation) -
                                   converted<R, S, D>(query.x.pose.translation));
  } else {
    frames.centered = measured.x.is_centered || measured.y.is_centered;
    if (frames.centered) {
      frames.x.center = converted<R, S, D>(measured.x.center);
      frames.y.center = converted<R, S, D>(measured.y.center);
      frames.offset = offset_of_centers<R>(query, frames);
      frames.offset_error = ScalarTraits<R>::unit_roundoff() * length(frames.offset);
    } else {
      const Vec<DoubleWord<R>, D> offset = offset_of_origins(query, frames);
      for (int i = 0; i < D; ++i) {
        frames.offset[i] = offset[i].hi;
        frames.offset_error = frames.offset_error + magnitude(offset[i].lo);
      }
    }
  }
}

/// Vertex i relative to its shape's center, in the shape's own axes and the run's unit.
template <class R, class S, int D>
[[nodiscard]] Vec<R, D> from_center(const Shape<S, D>& shape, const Frames<R, D>& frames,
                                    const Body<R, D>& body, int i) {
  const auto& vertex = converted<R, S, D>(shape.vertices()[i]);
  return frames.in_unit(frames.centered ? Vec<R, D>(vertex - body.center) : Vec<R, D>(vertex));
}

/// Sets all of one body but its center.
template <class R, class S, int D>
void place(const Shape<S, D>& shape, const Measures<S, D>& measures, const Frames<R, D>& frames,
           Body<R, D>& body) {
  body.is_ring = measures.is_ring;
  body.far_apart = measures.far_apart;
  body.radius = ScalarTraits<R>::from(measures.radius) * frames.unit;
  const int count = static_cast<int>(shape.vertices().size());
  if (count > kMaxPlaced) return;
  body.placed_count = count;
  for (int i = 0; i < count; ++i) {
    body.placed[i] = shape.pose.template rotated<R>(from_center(shape, frames, body, i));
  }
}

}  // namespace detail
}  // namespace gjk
