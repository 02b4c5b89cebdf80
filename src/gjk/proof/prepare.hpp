#pragma once
// Before a run: checks the query, chooses the unit of length, and measures.

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
[[nodiscard]] Error first_wrong(const MeasuredQuery<S, D>& measured, const Options& options) {
  const auto& [query, x, y] = measured;
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

template <class R, class S, int D>
void prepare_in_unit(const MeasuredQuery<S, D>& measured, int exponent, Prepared<R, D>& prepared) {
  set_frames<R>(measured, exponent, prepared);
  place<R>(measured.query.x, measured.x, prepared, prepared.x);
  place<R>(measured.query.y, measured.y, prepared, prepared.y);
  static_cast<Rounding<R, D>&>(prepared) =
      rounding_of(measured, static_cast<const Frames<R, D>&>(prepared));
}

/// Prepares again, in a unit in which squares of coordinates neither overflow nor underflow.
template <class R, class S, int D>
[[nodiscard, gnu::noinline]] Prepared<R, D> prepared_in_good_unit(
    const MeasuredQuery<S, D>& measured) {
  using Traits = ScalarTraits<R>;
  const auto refused = [](Error error) {
    Prepared<R, D> prepared;
    prepared.error = error;
    return prepared;
  };
  if (!is_finite(measured.query.x.pose)) return refused(Error::x_not_finite);
  if (!is_finite(measured.query.y.pose)) return refused(Error::y_not_finite);
  // Squares may have gone out of range: first a unit in which they do not.
  constexpr int kLimit = std::numeric_limits<R>::max_exponent - 3;
  const auto in_unit = [&](int exponent) {
    Prepared<R, D> prepared;
    prepare_in_unit(measured, std::clamp(exponent, -kLimit, kLimit), prepared);
    return prepared;
  };
  const Vec<S, D> apart = measured.query.y.pose.translation - measured.query.x.pose.translation;
  const S largest = std::max({measured.x.largest, measured.y.largest, norm_max(apart)});
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
void prepare(const MeasuredQuery<S, D>& measured, const Options& options,
             Prepared<R, D>& prepared) {
  prepared.error = first_wrong(measured, options);
  if (prepared.error != Error::none) return;
  if constexpr (ScalarTraits<R>::kExact) {
    set_frames<R>(measured, 0, prepared);
  } else {
    prepare_in_unit(measured, 0, prepared);
    if (ScalarTraits<R>::template is_in_range<kDegree<D>>(prepared.reach)) [[likely]]
      return;
    prepared = prepared_in_good_unit<R>(measured);
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
    detail::prepare(detail::MeasuredQuery<S, D>{query, *x, *y}, options, prepared);
  } else {
    const Measures<S, D> of_x = x != nullptr ? *x : measured<S, D>(query.x.vertices());
    const Measures<S, D> of_y = y != nullptr ? *y : measured<S, D>(query.y.vertices());
    detail::prepare(detail::MeasuredQuery<S, D>{query, of_x, of_y}, options, prepared);
  }
  return prepared;
}

}  // namespace gjk
