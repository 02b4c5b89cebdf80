#pragma once
// The cost of supersampling: pictures drawn by OpenGL with few samples a pixel, against one with
// many.

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "paint/canvas.hpp"
#include "run/run.hpp"
#include "study/interleave.hpp"

namespace gjkscope {

/// The last frame of a lesson, painted with `factor` x `factor` samples a pixel.
struct SamplingCost {
  std::string lesson;
  int factor = 1;
  /// Against 16 x 16 samples, at 320 x 180 pixels (a quarter of the frame's size, so that the
  /// finest picture fits): of all channels, in steps of 8 bits.
  double rms = 0.0;
  int largest = 0;
  double seen = 0.0;  ///< Share of the pixels with a channel off by more than kSeenStep.
  int repetitions = 0;
  study::Quartiles ns;  ///< To paint and shrink the frame at 1280 x 720 pixels.
};

inline constexpr int kSeenStep = 16;

/// The canvases of a study, made once.
class SamplingStudy {
 public:
  /// Throws std::runtime_error as Canvas does.
  SamplingStudy(const Fonts& fonts, const Theme& theme);

  /// Rows by factor: 1, 2, 4. Empty when `go_on` said no before all were timed.
  [[nodiscard]] std::vector<SamplingCost> costs(
      const Lesson& lesson, int repetitions,
      const std::function<bool()>& go_on = [] { return true; });

 private:
  static constexpr std::array<int, 3> kFactors = {1, 2, 4};
  const Fonts& fonts_;
  std::vector<std::unique_ptr<Canvas>> small_;
  std::vector<std::unique_ptr<Canvas>> full_;
  std::unique_ptr<Canvas> finest_;
};

/// For a terminal: over all lessons.
[[nodiscard]] std::string sampling_table(const std::vector<SamplingCost>& rows);
/// A line of names, then one line a row.
[[nodiscard]] std::string sampling_csv(const std::vector<SamplingCost>& rows);

}  // namespace gjkscope
