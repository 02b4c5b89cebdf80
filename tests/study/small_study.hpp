#pragma once
// A study that takes a second.

#include "study/accuracy.hpp"

namespace gjkscope::study::test {

[[nodiscard]] inline Plan small_plan() {
  Plan out = plan(true);
  out.seed = 7;
  out.sizes = {12, 8, 16};
  out.seconds_per_family = 0.0;
  out.seconds_per_turn = 0.0;
  Case& reported = out.reported.emplace_back();
  reported.a = {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.0)};
  reported.b = {Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(1.0, 1.0 + 1e-9)};
  return out;
}

[[nodiscard]] inline const Study& small_study() {
  static const Study study = study_accuracy(small_plan());
  return study;
}

}  // namespace gjkscope::study::test
