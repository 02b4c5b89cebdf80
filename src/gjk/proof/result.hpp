#pragma once
// The answer to a query.

#include "gjk/state.hpp"

namespace gjk {

/// How the shapes lie. With Proof::exact every verdict but `undecided` is proved, by exact
/// arithmetic where rounding leaves it open; with Proof::none a rounded run proves nothing.
enum class Verdict : std::uint8_t {
  separated,    ///< The distance is positive.
  touching,     ///< Distance 0, and O is a boundary point of Z: the least motion can part them.
  overlapping,  ///< Distance 0, and O is an inner point of Z.
  undecided,    ///< The bounds leave it open, and exact arithmetic did not settle it: the run gave
                ///< up, or exact arithmetic was not asked for or has no room for the scalars.
  none,         ///< The query was refused.
};

/// The computed distance, and bounds of the exact one.
template <class R>
struct Bounds {
  R lower = R(0);
  R distance = R(0);
  R upper = R(0);
};

/// The answer, with its certificate: lower <= exact distance <= upper, rounding included. With
/// Proof::none a rounded run has no bounds (both are `no_length()`), and its verdict is whether
/// |P| = 0. Lengths are in the query's unit.
template <class R, int D>
struct Result {
  using Real = typename ScalarTraits<R>::Real;
  Error error = Error::none;
  StopReason stop = StopReason::running;
  Verdict verdict = Verdict::none;
  bool settled = false;  ///< Exact arithmetic answered, because bounds were wide or undecided.
  Real distance = ScalarTraits<R>::no_length();
  Real lower = ScalarTraits<R>::no_length();
  Real upper = ScalarTraits<R>::no_length();
  R distance_sq = R(0);
  Vec<R, D> x = Vec<R, D>::Zero();  ///< Witness point on X, world coordinates.
  Vec<R, D> y = Vec<R, D>::Zero();  ///< Witness point on Y: equal to x where the shapes meet.
  int iterations = 0;
  Simplex<R, D> simplex;  ///< Its weights made the witness points. In the run's unit.

  /// A start for the next query of the same shapes, somewhat moved.
  [[nodiscard]] WarmStart warm() const { return simplex.as_start(); }
};

}  // namespace gjk
