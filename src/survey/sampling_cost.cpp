#include "survey/sampling_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/decimal.hpp"
#include "frames/frame.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

constexpr int kFrameWidth = 1280;
constexpr int kFrameHeight = 720;
constexpr int kSmaller = 4;
constexpr int kFinest = 16;

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

}  // namespace

SamplingStudy::SamplingStudy(const Fonts& fonts, const Theme& theme)
    : fonts_(fonts), finest_(canvas(fonts, theme, kSmaller, kFinest)) {
  for (const int factor : kFactors) {
    small_.push_back(canvas(fonts, theme, kSmaller, factor));
    full_.push_back(canvas(fonts, theme, 1, factor));
  }
}

std::vector<SamplingCost> SamplingStudy::costs(const Lesson& lesson, int repetitions,
                                               const std::function<bool()>& go_on) {
  const LessonRun run = run_lesson(lesson);
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts_);
  const Picture picture = pictures.picture(static_cast<int>(run.frames.size()) - 1);
  if (!go_on()) return {};
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
  const std::vector<study::Timing> timings =
      study::interleave(contestants, 1, static_cast<std::size_t>(std::max(repetitions, 1)), go_on);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (timings[i].ns.empty()) return {};
    rows[i].repetitions = static_cast<int>(timings[i].ns.size());
    rows[i].ns = study::quartiles(timings[i].ns);
  }
  return rows;
}

std::string sampling_table(const std::vector<SamplingCost>& rows) {
  if (rows.empty()) return "Nothing was measured.\n";
  std::string out = fmt::format(
      "The last frame of each lesson with so many samples a pixel each way, against 16, at 320 x "
      "180 pixels: root of the mean square\nover the channels and the largest difference, in steps "
      "of 8 bits; the share of the pixels off by more than {}. time: to paint the\nframe at 1280 x "
      "720.\n\n{:<24} {:>7} {:>6} {:>8} {:>7} {:>9}\n",
      kSeenStep, "lesson", "samples", "rms", "largest", "pixels", "time");
  for (const SamplingCost& row : rows) {
    out += fmt::format("{:<24} {:>7} {:>6.2f} {:>8} {:>6.2f}% {:>9}\n", row.lesson, row.factor,
                       row.rms, row.largest, 100.0 * row.seen, time_text(row.ns.median));
  }
  return out;
}

std::string sampling_csv(const std::vector<SamplingCost>& rows) {
  std::string out = "lesson,factor,rms,largest,seen,repetitions,ns,ns_low,ns_high\n";
  for (const SamplingCost& row : rows) {
    out += fmt::format("{},{},{},{},{},{},{},{},{}\n", row.lesson, row.factor, row.rms, row.largest,
                       row.seen, row.repetitions, row.ns.median, row.ns.low, row.ns.high);
  }
  return out;
}

}  // namespace gjkscope
