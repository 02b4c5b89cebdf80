#pragma once
// The exact truth about a pair, and an answer judged by it.

#include "geometry/rational.hpp"
#include "study/answer.hpp"

namespace gjkscope::study {

/// Of an exact run.
struct Truth {
  bool overlap = false;  ///< The shapes share a point.
  Rational distance_sq;
  /// The distance as a sum of three doubles, each what the ones before leave out: good to 2^-150 of
  /// itself, so that answers in quad can be told from it.
  std::array<double, 3> distance = {};
};

/// The pair has no pose.
[[nodiscard]] Truth truth_of(const DoublePair& pair);

/// value - distance, good to a few digits however small it is.
[[nodiscard]] double difference(const Quad& value, const Truth& truth);

struct Judgement {
  bool failed = false;     ///< No answer, or one that is no number. Nothing else is judged then.
  bool undecided = false;  ///< The answer leaves open whether the shapes overlap.
  bool wrong = false;      ///< It says so wrongly, of the pair as it was given,
  bool wrong_as_kept = false;  ///< of the pair as it was kept.
  bool broken_bounds = false;  ///< Not lower <= distance <= upper, of the pair as it was kept.
  double error = 0.0;          ///< |answer - distance| of the pair as it was given,
  double error_as_kept = 0.0;  ///< of the pair as it was kept: what computing alone did.
  double witness = 0.0;  ///< How far a witness point lies outside its shape, or their distance from
                         ///< the exact one, as kept; below 1e-19 of the scale it is not resolved.
  double width = 0.0;    ///< upper - lower; NaN where there are no bounds.
};

/// A pair in two forms: as it was given and as a configuration keeps it.
struct Judged {
  const Truth& given;
  const Truth& as_kept;
  const DoublePair& kept;
};
[[nodiscard]] Judgement judge(const Answer& answer, const Judged& judged);

}  // namespace gjkscope::study
