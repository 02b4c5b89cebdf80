#pragma once
// The answer to a query.

#include "gjk/state.hpp"

namespace gjk {

/// What the run came to. For exact scalars and those that a double can hold it is proved: by exact
/// arithmetic where rounding leaves it open.
enum class Verdict : std::uint8_t {
  separated,    ///< The distance is positive.
  touching,     ///< Distance 0, but some support plane of Z passes through O: the least motion in
                ///< some direction parts the shapes.
  overlapping,  ///< Distance 0, and O is an inner point of Z.
  undecided,  ///< The bounds leave it open: the run gave up, or its scalar has no exact arithmetic.
  none,       ///< The query was refused.
};

/// The answer, with its certificate: lower <= exact distance <= upper, rounding included. With
/// Proof::none both bounds are `no_length()` (a NaN), and the verdict is what |P| = 0 says.
template <class R, int D>
struct Result {
  using Real = typename ScalarTraits<R>::Real;
  Error error = Error::none;
  StopReason stop = StopReason::running;
  Verdict verdict = Verdict::none;
  bool settled = false;  ///< Rounding left the verdict open; exact arithmetic decided it.
  Real distance = ScalarTraits<R>::no_length();
  Real lower = ScalarTraits<R>::no_length();
  Real upper = ScalarTraits<R>::no_length();
  R distance_sq = R(0);
  Vec<R, D> x = Vec<R, D>::Zero();  ///< Witness point on X, world coordinates.
  Vec<R, D> y = Vec<R, D>::Zero();  ///< Witness point on Y: the same where the shapes meet.
  int iterations = 0;
  Simplex<R, D> simplex;  ///< The simplex whose weights made the witness points, in the run's unit
                          ///< of length.

  /// For the next query of the same shapes, somewhat moved.
  [[nodiscard]] WarmStart warm() const {
    WarmStart out;
    out.count = simplex.count;
    for (int i = 0; i < simplex.count; ++i) out.pairs[i] = simplex.vertices[i].pair;
    return out;
  }
};

}  // namespace gjk
