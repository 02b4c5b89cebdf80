#pragma once
// Before a run: checks the query, chooses the unit of length, and measures.

#include <optional>

#include "gjk/proof/rounding.hpp"

namespace gjk {

/// How many lengths |d|^2, the longest product of a run, multiplies. In the plane d is as long as
/// an edge; in space it may be a product of three lengths.
template <int D>
inline constexpr int kDegree = D == 2 ? 2 : 6;

/// All that a run needs beside the query: what the loop reads, and what certificates are made of.
template <class R, int D>
struct Prepared : Frames<R, D>, Rounding<R, D> {
  Error error = Error::none;
};

namespace detail {

template <class S, int D>
[[nodiscard]] bool is_finite(const Pose<S, D>& pose) {
  return gjk::is_finite(pose.rotation.matrix()) && gjk::is_finite(pose.translation);
}

/// The first thing wrong. Alone, a pose that is not finite is found later, by `reach`.
template <class S, int D>
[[nodiscard]] Error first_wrong(const MeasuredQuery<S, D>& measured, const Options& options) {
  const auto& [query, x, y] = measured;
  const int x_count = static_cast<int>(query.x.vertices().size());
  const int y_count = static_cast<int>(query.y.vertices().size());
  const bool bad_options =
      options.iteration_cap < 1 || !(options.tolerance >= 0.0 && options.tolerance < 1.0);
  const auto is_outside = [&](const VertexPair& pair) {
    return pair.x < 0 || pair.x >= x_count || pair.y < 0 || pair.y >= y_count;
  };
  const auto& [pairs, count] = options.start;
  const bool bad_start =
      count < 0 || count > D + 1 || std::any_of(pairs.begin(), pairs.begin() + count, is_outside);
  if (x_count == 0) return Error::x_has_no_vertices;
  if (y_count == 0) return Error::y_has_no_vertices;
  if (x.is_finite && y.is_finite && !bad_options && !bad_start) return Error::none;
  if (!x.is_finite || !is_finite(query.x.pose)) return Error::x_not_finite;
  if (!y.is_finite || !is_finite(query.y.pose)) return Error::y_not_finite;
  return bad_options ? Error::bad_options : Error::bad_start;
}

template <class R, class S, int D>
void prepare_in_unit(const MeasuredQuery<S, D>& measured, int exponent, Prepared<R, D>& prepared) {
  set_frames<R>(measured, exponent, prepared);
  place<R>(measured.query.x, measured.x, prepared, prepared.x);
  place<R>(measured.query.y, measured.y, prepared, prepared.y);
  static_cast<Rounding<R, D>&>(prepared) = rounding_of<R>(measured, prepared);
}

/// Prepares again, in a unit in which squares of coordinates neither overflow nor underflow.
template <class R, class S, int D>
[[gnu::noinline]] void prepare_in_good_unit(const MeasuredQuery<S, D>& measured,
                                            Prepared<R, D>& prepared) {
  using Traits = ScalarTraits<R>;
  const auto refuse = [&](Error error) {
    prepared = {};
    prepared.error = error;
  };
  if (!is_finite(measured.query.x.pose)) return refuse(Error::x_not_finite);
  if (!is_finite(measured.query.y.pose)) return refuse(Error::y_not_finite);
  constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
  const auto in_unit = [&](int exponent) {
    prepared = {};
    prepare_in_unit(measured, std::clamp(exponent, -kLimit, kLimit), prepared);
  };
  // Squares may have gone out of range: first a unit in which they do not.
  const Vec<S, D> apart = measured.query.y.pose.translation - measured.query.x.pose.translation;
  const S largest = std::max({measured.x.largest, measured.y.largest, norm_max(apart)});
  in_unit(Traits::exponent(Traits::from(largest)));
  if (prepared.reach == R(0)) return;
  if (Traits::is_finite(prepared.reach)) {
    in_unit(prepared.exponent + Traits::exponent(prepared.reach));
  }
  if (!Traits::is_finite(prepared.reach)) return refuse(Error::overflow);
  if (!Traits::template is_in_range<kDegree<D>>(prepared.reach)) refuse(Error::underflow);
}

}  // namespace detail

/// Checks the query and measures it for a run in R. Problems set Prepared::error.
template <class R, class S, int D>
[[nodiscard]] Prepared<R, D> prepare(const Query<S, D>& query, const Options& options) {
  std::optional<Measures<S, D>> of_x;
  std::optional<Measures<S, D>> of_y;
  const auto measures = [](const Shape<S, D>& shape, auto& own) -> const Measures<S, D>& {
    return shape.measures() != nullptr ? *shape.measures() : own.emplace(shape.vertices());
  };
  const detail::MeasuredQuery<S, D> all{query, measures(query.x, of_x), measures(query.y, of_y)};
  Prepared<R, D> prepared;
  prepared.error = detail::first_wrong(all, options);
  if (prepared.error != Error::none) return prepared;
  if constexpr (ScalarTraits<R>::kExact) {
    detail::set_frames<R>(all, 0, prepared);
  } else {
    detail::prepare_in_unit(all, 0, prepared);
    if (!ScalarTraits<R>::template is_in_range<kDegree<D>>(prepared.reach)) [[unlikely]]
      detail::prepare_in_good_unit(all, prepared);
  }
  return prepared;
}

}  // namespace gjk
