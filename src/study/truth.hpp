#pragma once
// The exact truth about a pair of shapes, and an answer judged by it.

#include <array>
#include <vector>

#include "gjk/gjk.hpp"
#include "study/pair.hpp"
#include "study/quad.hpp"

namespace gjkscope::study {

/// Found by integers, and proved; what is rounded of it says how far.
template <int D>
struct Truth {
  bool overlap = false;   ///< The shapes share a point,
  bool touching = false;  ///< but O is no inner point of Z.
  double distance = 0.0;  ///< The nearest double.
  Quad rest;  ///< The sum with `distance` is good to 2^-160 of itself, enough to judge quad.
  long double scale = 0;           ///< The largest distance between a vertex of X and one of Y.
  families::Pair<double, D> pair;  ///< The pair that it is the truth about.
};

/// A good guess at the pairs of vertices that the distance hangs on saves time, and a wrong one
/// costs some: what comes out is the same. In the plane and in space.
template <int D>
[[nodiscard]] Truth<D> truth_of(const families::Pair<double, D>& pair,
                                const gjk::WarmStart& guess = {});

/// value - distance, good to a few digits however small it is.
template <int D>
[[nodiscard]] double difference(const Quad& value, const Truth<D>& truth);

/// The claims of a run about a pair, in any arithmetic, widened: nothing rounds, since 113 bits
/// hold every type that the core answers in.
template <int D>
struct Claim {
  bool refused = false;  ///< There is no answer: the query was refused.
  gjk::Verdict verdict = gjk::Verdict::none;
  bool has_bounds = false;  ///< Else `lower` and `upper` say nothing.
  Quad distance;
  Quad lower;
  Quad upper;
  std::array<Quad, D> x;  ///< Witness points.
  std::array<Quad, D> y;
  gjk::WarmStart near;  ///< Vertices they may be close to: a guess, that saves time.
  /// The unit roundoff of the witness points' scalar, when they are to be forgiven that far from
  /// the origin they stand on a coarse grid.
  double unit_roundoff = 0.0;
};

template <class R, int D>
[[nodiscard]] Claim<D> claim_of(const gjk::Result<R, D>& result) {
  const auto wide = [](const R& value) {
    if constexpr (std::is_same_v<R, Eigen::half>) {
      return Quad(static_cast<float>(value));
    } else {
      return Quad(value);
    }
  };
  Claim<D> out;
  out.refused = result.error != gjk::Error::none;
  out.verdict = result.verdict;
  out.has_bounds = result.lower == result.lower;
  out.distance = wide(result.distance);
  if (out.has_bounds) {
    out.lower = wide(result.lower);
    out.upper = wide(result.upper);
  }
  for (int i = 0; i < D; ++i) {
    out.x[i] = wide(result.x[i]);
    out.y[i] = wide(result.y[i]);
  }
  out.near = result.warm();
  out.unit_roundoff = static_cast<double>(gjk::ScalarTraits<R>::unit_roundoff());
  return out;
}

struct Judgement {
  bool failed = false;     ///< No answer, or one that is no number. Nothing else is judged then.
  bool undecided = false;  ///< The answer leaves open whether the shapes overlap.
  bool wrong = false;      ///< It says so wrongly, of the pair as it was given,
  bool wrong_as_kept = false;  ///< of the pair as it was kept.
  bool wrong_contact = false;  ///< It takes touching for overlapping or the other way, as kept.
  bool broken_bounds = false;  ///< The distance, as kept, or the answer lies outside the bounds.
  double error = 0.0;          ///< |answer - distance| of the pair as it was given,
  double error_as_kept = 0.0;  ///< of the pair as it was kept: what computing alone did.
  double witness = 0.0;  ///< How far a witness point lies outside its shape, or their distance from
                         ///< the exact one, as kept; 1e-19 of the scale is not resolved of that.
  double width = 0.0;    ///< upper - lower; NaN where there are no bounds.
};

/// A pair as it was given and as a run keeps it, which may round it.
template <int D>
struct Judged {
  const Truth<D>& given;
  const Truth<D>& as_kept;
};
template <int D>
[[nodiscard]] Judgement judge(const Claim<D>& claim, const Judged<D>& judged);

}  // namespace gjkscope::study
