#pragma once
// The exact truth about a pair of shapes, and an answer judged by it.

#include <array>
#include <vector>

#include "gjk/gjk.hpp"
#include "study/families.hpp"
#include "study/quad.hpp"

namespace gjkscope::study {

/// A point relative to Truth::origin, good to 2^-63 of its length.
using NearPoint = std::array<long double, 2>;

/// Found by integers, and proved; what is rounded of it says how far.
struct Truth {
  bool overlap = false;   ///< The shapes share a point,
  bool touching = false;  ///< but O is no inner point of Z.
  double distance = 0.0;  ///< The nearest double.
  Quad rest;  ///< What that leaves out. With it, good to 2^-160 of itself: quad can be judged, too.
  long double scale = 0;  ///< The largest distance between a vertex of X and one of Y.

  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< Close to the first vertex of X.
  std::vector<NearPoint> x;  ///< Corners of the hulls, in the world, counter-clockwise.
  std::vector<NearPoint> y;
};

/// A good guess at the pairs of vertices that the distance hangs on saves time, and a wrong one
/// costs some: what comes out is the same.
[[nodiscard]] Truth truth_of(const families::Pair<double>& pair, const gjk::WarmStart& guess = {});

/// value - distance, good to a few digits however small it is.
[[nodiscard]] double difference(const Quad& value, const Truth& truth);

/// What a run says of a pair, in any arithmetic, widened: nothing rounds, since 113 bits hold every
/// type that the core answers in.
struct Claim {
  bool refused = false;  ///< There is no answer: the query was refused.
  gjk::Verdict verdict = gjk::Verdict::none;
  bool has_bounds = false;  ///< Else `lower` and `upper` say nothing.
  Quad distance;
  Quad lower;
  Quad upper;
  std::array<Quad, 2> x;  ///< Witness points.
  std::array<Quad, 2> y;
  /// Of the scalar of the witness points, when they are to be forgiven that far from the origin
  /// they stand on a coarse grid.
  double unit_roundoff = 0.0;
};

template <class R>
[[nodiscard]] Claim claim_of(const gjk::Result<R, 2>& result) {
  const auto wide = [](const R& value) {
    if constexpr (std::is_same_v<R, Eigen::half>) {
      return Quad(static_cast<float>(value));
    } else {
      return Quad(value);
    }
  };
  Claim out;
  out.refused = result.error != gjk::Error::none;
  out.verdict = result.verdict;
  out.has_bounds = result.lower == result.lower;
  out.distance = wide(result.distance);
  if (out.has_bounds) {
    out.lower = wide(result.lower);
    out.upper = wide(result.upper);
  }
  out.x = {wide(result.x[0]), wide(result.x[1])};
  out.y = {wide(result.y[0]), wide(result.y[1])};
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
                         ///< the exact one, as kept; below 1e-19 of the scale it is not resolved.
  double width = 0.0;    ///< upper - lower; NaN where there are no bounds.
};

/// A pair as it was given and as a run keeps it, which may round it.
struct Judged {
  const Truth& given;
  const Truth& as_kept;
};
[[nodiscard]] Judgement judge(const Claim& claim, const Judged& judged);

}  // namespace gjkscope::study
