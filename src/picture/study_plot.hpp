#pragma once
// Error against time, as the study of accuracy has measured them.

#include "lesson/study_results.hpp"
#include "picture/plot.hpp"

namespace gjkscope {

/// Answers without error are drawn here, at the foot of the axis.
inline constexpr double kNoError = 1e-36;

/// The dots of one family by what they vary, and the Pareto front as a line; those that left a pair
/// without an answer have no place. Points have the subjects `study_dot`, by their index in
/// `family`.
[[nodiscard]] Plot study_plot(const std::vector<StudyDot>& family);

/// Where a dot stands; only of dots with an error.
[[nodiscard]] Eigen::Vector2d place_of(const StudyDot& dot);

/// The style of the dots that vary the same.
[[nodiscard]] PlotStyle style_of(const StudyDot& dot);

/// Whole powers of ten around values.
class Decades {
 public:
  /// Zeros, infinities and what is no number are left out.
  void hold(double value);
  [[nodiscard]] double low() const;
  [[nodiscard]] PlotAxis axis(std::string title) const;

 private:
  double low_ = 400.0;
  double high_ = -400.0;
};

}  // namespace gjkscope
