#include "claim.hpp"

#include <algorithm>

namespace truth {
namespace {

/// Touching may pass for a distance of so many units.
constexpr double kTouchingUnits = 4;

bool verdict_is_wrong(const ExactPair& pair, const Truth& truth, const Claim& claim, double unit) {
  switch (claim.verdict) {
    case gjk::Verdict::separated:
      return truth.overlap && !(claim.distance <= kTouchingUnits * unit && pair.touching());
    case gjk::Verdict::overlapping:
      return !truth.overlap;
    case gjk::Verdict::touching:
      return !truth.overlap || !pair.touching();
    case gjk::Verdict::undecided:
      return false;
    case gjk::Verdict::none:
      return true;
  }
  return true;
}

}  // namespace

Judgement judge(const ExactPair& pair, const Truth& truth, long double scale, const Claim& claim) {
  Judgement out;
  out.refused = claim.error != gjk::Error::none;
  if (out.refused) return out;
  const double numbers[] = {claim.distance, claim.lower, claim.upper, claim.x[0],
                            claim.x[1],     claim.y[0],  claim.y[1]};
  out.not_a_number = !std::all_of(std::begin(numbers), std::end(numbers),
                                  [](double number) { return std::isfinite(number); });
  if (out.not_a_number) return out;

  const long double unit = std::max<long double>(claim.unit_roundoff * scale, claim.smallest);
  const auto in_units = [&](long double error) { return static_cast<double>(error / unit); };
  out.capped = claim.stop == gjk::StopReason::iteration_cap;
  out.undecided = claim.verdict == gjk::Verdict::undecided;
  out.wrong_verdict = verdict_is_wrong(pair, truth, claim, static_cast<double>(unit));
  out.broken_certificate = !(claim.lower >= 0) || pair.compare(claim.lower, truth) > 0 ||
                           pair.compare(claim.upper, truth) < 0 || claim.distance < claim.lower ||
                           claim.distance > claim.upper;
  const long double error = std::abs(claim.distance - truth.distance);
  out.distance_error = in_units(error);
  if (!truth.overlap) out.relative_error = static_cast<double>(error / truth.distance);
  out.width = in_units(static_cast<long double>(claim.upper) - claim.lower);

  const auto coarseness = [&](const Eigen::Vector2d& point) {
    const auto away = std::hypot<long double>(point[0], point[1]);
    return claim.unit_roundoff * std::max<long double>(0, away - scale);
  };
  const auto without = [&](long double rounding, long double found) {
    return in_units(std::max<long double>(0, found - rounding));
  };
  const long double x_rounding = coarseness(claim.x);
  const long double y_rounding = coarseness(claim.y);
  out.outside = std::max(without(x_rounding, pair.distance_from_x(claim.x)),
                         without(y_rounding, pair.distance_from_y(claim.y)));
  const long double length = std::hypot(static_cast<long double>(claim.y[0]) - claim.x[0],
                                        static_cast<long double>(claim.y[1]) - claim.x[1]);
  out.apart = without(x_rounding + y_rounding, std::abs(length - claim.distance));
  return out;
}

}  // namespace truth
