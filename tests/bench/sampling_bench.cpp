// The cost of supersampling: pictures drawn by OpenGL with few samples a pixel, against one with
// many. An argument: the id of one lesson.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "base/decimal.hpp"
#include "frames/frame.hpp"
#include "paint/canvas.hpp"
#include "shipped_lessons.hpp"
#include "study/interleave.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

constexpr int kFrameWidth = 1280;
constexpr int kFrameHeight = 720;
constexpr int kSmaller = 4;
constexpr int kFinest = 16;
constexpr std::size_t kRepetitions = 9;

/// The last frame of a lesson, painted with `factor` x `factor` samples a pixel.
struct SamplingCost {
  std::string lesson;
  int factor = 1;
  /// Against 16 x 16 samples, at 320 x 180 pixels (a quarter of the frame's size, so that the
  /// finest picture fits): of all channels, in steps of 8 bits.
  double rms = 0.0;
  int largest = 0;
  double seen = 0.0;    ///< Share of the pixels with a channel off by more than kSeenStep.
  study::Quartiles ns;  ///< To paint and shrink the frame at 1280 x 720 pixels.
};

inline constexpr int kSeenStep = 16;

/// The canvases of a study, made once.
class SamplingStudy {
 public:
  SamplingStudy(const Fonts& fonts, const Theme& theme);

  /// Rows by factor: 1, 2, 4.
  [[nodiscard]] std::vector<SamplingCost> costs(const Lesson& lesson);

 private:
  static constexpr std::array<int, 3> kFactors = {1, 2, 4};
  const Fonts& fonts_;
  std::vector<std::unique_ptr<Canvas>> small_;
  std::vector<std::unique_ptr<Canvas>> full_;
  std::unique_ptr<Canvas> finest_;
};

std::unique_ptr<Canvas> canvas(const Fonts& fonts, const Theme& theme, int smaller, int factor) {
  CanvasOptions options;
  options.width = kFrameWidth / smaller;
  options.height = kFrameHeight / smaller;
  options.supersampling = factor;
  options.zoom = 1.0 / smaller;
  options.renderer = Renderer::egl;
  return std::make_unique<Canvas>(fonts, theme, options);
}

void compare(const Image& image, const Image& finest, SamplingCost& row) {
  constexpr std::size_t kChannels = 4;  // the last is opaque in both
  double sum = 0.0;
  std::size_t seen = 0;
  const std::size_t pixels = image.pixels.size() / kChannels;
  for (std::size_t i = 0; i < pixels; ++i) {
    int most = 0;
    for (std::size_t k = 0; k + 1 < kChannels; ++k) {
      const std::size_t at = kChannels * i + k;
      const int off = std::abs(int{image.pixels[at]} - int{finest.pixels[at]});
      sum += off * off;
      most = std::max(most, off);
    }
    row.largest = std::max(row.largest, most);
    seen += most > kSeenStep ? 1 : 0;
  }
  const auto count = static_cast<double>(pixels);
  row.rms = std::sqrt(sum / (count * (kChannels - 1)));
  row.seen = static_cast<double>(seen) / count;
}

SamplingStudy::SamplingStudy(const Fonts& fonts, const Theme& theme)
    : fonts_(fonts), finest_(canvas(fonts, theme, kSmaller, kFinest)) {
  for (const int factor : kFactors) {
    small_.push_back(canvas(fonts, theme, kSmaller, factor));
    full_.push_back(canvas(fonts, theme, 1, factor));
  }
}

std::vector<SamplingCost> SamplingStudy::costs(const Lesson& lesson) {
  const LessonRun run = run_lesson(lesson);
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts_);
  const Picture picture = pictures.picture(static_cast<int>(run.frames.size()) - 1);
  const Image finest = finest_->paint(picture);

  std::vector<SamplingCost> rows;
  std::vector<study::Contestant> contestants;
  for (std::size_t i = 0; i < kFactors.size(); ++i) {
    const int factor = kFactors[i];
    SamplingCost row;
    row.lesson = lesson.id;
    row.factor = factor;
    compare(small_[i]->paint(picture), finest, row);
    rows.push_back(std::move(row));
    contestants.push_back({[&picture, canvas = full_[i].get()] {
                             const Image image = canvas->paint(picture);
                             return static_cast<double>(image.pixels[0]);
                           },
                           {}});
  }
  const std::vector<study::Timing> timings = study::interleave(contestants, 1, kRepetitions);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].ns = study::quartiles(timings[i].ns);
  }
  return rows;
}

void print_head() {
  fmt::print(
      "The last frame of each lesson with so many samples a pixel each way, against 16, at 320 x "
      "180 pixels: root of the mean square\nover the channels and the largest difference, in steps "
      "of 8 bits; the share of the pixels off by more than {}. time: to paint the\nframe at 1280 x "
      "720.\n\n{:<24} {:>7} {:>6} {:>8} {:>7} {:>9}\n",
      kSeenStep, "lesson", "samples", "rms", "largest", "pixels", "time");
}

void print(const std::vector<SamplingCost>& rows) {
  for (const SamplingCost& row : rows) {
    fmt::print("{:<24} {:>7} {:>6.2f} {:>8} {:>6.2f}% {:>9}\n", row.lesson, row.factor, row.rms,
               row.largest, 100.0 * row.seen, time_text(row.ns.median));
  }
}

}  // namespace
}  // namespace gjkscope

int main(int count, char** arguments) {
  using namespace gjkscope;
  const std::filesystem::path assets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";
  const Fonts fonts(assets / "fonts.toml");
  SamplingStudy study(fonts, Theme::load(assets / "themes", "light"));
  print_head();
  for (const Lesson& lesson : bench::shipped_lessons())
    if (count == 1 || lesson.id == arguments[1]) print(study.costs(lesson));
}
