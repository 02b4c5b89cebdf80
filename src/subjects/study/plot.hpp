#pragma once
// Error against time, as the study of accuracy has measured them.

#include "picture/plot.hpp"
#include "run/run.hpp"
#include "subjects/study/table.hpp"
#include "subjects/study/tour.hpp"

namespace gjkscope {

/// Answers without error are drawn here, at the foot of the axis.
inline constexpr double kNoError = 1e-36;

/// The dots of one family by how far they go, and the front as a line; those that left a pair
/// without an answer have no place. Points have the subjects `study_dot`, by their index in
/// `family`.
[[nodiscard]] Plot study_plot(const std::vector<StudyDot>& family);

/// The axis of errors in frames ends here: what errs less stands at its foot.
inline constexpr double kLeastShown = 1e-21;

/// The plot in a frame; only from StudyStage::error_axis on. The axes have room for all dots of the
/// family, so these stay where they are.
[[nodiscard]] Plot study_plot(const LessonStudy& study, const StudyFrame& frame);

/// The place of a dot; only for dots with an error.
[[nodiscard]] Eigen::Vector2d plotted(const StudyDot& dot);

/// The style of dots that go as far: the loop alone, bounds, a proof; or that stop early.
[[nodiscard]] PlotStyle style_of(const StudyDot& dot);

/// Ends of an axis around values.
class Decades {
 public:
  /// Zeros, infinities and what is no number are left out.
  void hold(double value);
  [[nodiscard]] double low() const;
  /// From one power of ten to another.
  [[nodiscard]] PlotAxis axis(std::string title) const;
  /// Just around the values.
  [[nodiscard]] PlotAxis close_axis(std::string title) const;

 private:
  double least_ = 1e300;
  double most_ = 0.0;
};

}  // namespace gjkscope
