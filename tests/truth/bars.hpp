#pragma once
// How far off the core's claims may be, whoever asks.

#include <limits>

#include "study/truth.hpp"

namespace gjkscope::study {

/// The unit of a result in R: u * scale, or the smallest positive number if that is larger.
template <class R, int D>
[[nodiscard]] double unit_of(const Truth<D>& truth) {
  return static_cast<double>(std::max<long double>(
      gjk::ScalarTraits<R>::unit_roundoff() * truth.scale, std::numeric_limits<R>::denorm_min()));
}

/// `relative` is that of the distance, of shapes apart; the others are in units.
struct Errors {
  double distance = 0;
  double relative = 0;
  double witness = 0;
  double width = 0;
};
template <int D>
[[nodiscard]] Errors errors_of(const Judgement& found, const Truth<D>& truth, double unit) {
  return {found.error / unit, truth.distance > 0 ? found.error / truth.distance : 0,
          found.witness / unit, found.width / unit};
}

inline constexpr double kNoBar = std::numeric_limits<double>::infinity();
/// Bars for every claim. In float, whose bounds are judged by float's own u, widths have none.
inline constexpr Errors kBars = {4, kNoBar, 4, 16};
inline constexpr Errors kFloatBars = {4, kNoBar, 4, kNoBar};

/// The bar that is broken, or "".
[[nodiscard]] inline const char* broken_bar(const Judgement& found, const Errors& errors,
                                            const Errors& bars) {
  if (found.failed) return "no answer, or no number";
  if (found.wrong || found.wrong_contact) return "wrong verdict";
  if (found.undecided) return "undecided";
  if (found.broken_bounds) return "bounds";
  if (!(errors.distance <= bars.distance)) return "distance";
  if (!(errors.relative <= bars.relative)) return "relative error";
  if (!(errors.witness <= bars.witness)) return "witness";
  if (!(errors.width <= bars.width)) return "width of the bounds";
  return "";
}

}  // namespace gjkscope::study
