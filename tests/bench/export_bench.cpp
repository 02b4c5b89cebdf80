// The time of an export by task: building, painting, encoding one frame of 1280 x 720, and all
// shipped lessons from file to file. The project promises the last one: at least 30 frames per
// second on two cores. export_costs.cpp has ratios.

#include <benchmark/benchmark.h>

#include <filesystem>
#include <vector>

#include "export/export.hpp"
#include "frames/frame.hpp"
#include "paint/canvas.hpp"
#include "paint/png.hpp"
#include "run/graph.hpp"
#include "run/run.hpp"
#include "sample_picture.hpp"
#include "shipped_lessons.hpp"
#include "subjects/subjects.hpp"

namespace {

using namespace gjkscope;

const std::filesystem::path kSource = GJKSCOPE_SOURCE_DIR;

/// A canvas and a frame painted on it.
struct Studio {
  Fonts fonts{kSource / "assets" / "fonts.toml"};
  Canvas canvas{fonts, Theme::load(kSource / "assets" / "themes", "light"), {}};
  Picture picture = sample::picture();
};

void prepare_canvas(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    Studio studio;
    benchmark::DoNotOptimize(studio.canvas.paint(studio.picture));
  }
}
BENCHMARK(prepare_canvas)->Unit(benchmark::kMillisecond);

void build_pictures(benchmark::State& state) {
  const Fonts fonts(kSource / "assets" / "fonts.toml");
  const std::vector<Lesson> lessons = bench::shipped_lessons();
  std::size_t frames = 0;
  for ([[maybe_unused]] auto _ : state) {
    for (const Lesson& lesson : lessons) {
      const LessonRun run = run_lesson(lesson);
      EffectGraph effects(run);
      frames += lesson_pictures(run, effects, fonts).size();
    }
  }
  state.counters["frames"] =
      benchmark::Counter(static_cast<double>(frames), benchmark::Counter::kIsRate);
}
BENCHMARK(build_pictures)->Unit(benchmark::kMillisecond);

void paint(benchmark::State& state) {
  Studio studio;
  Image image;
  for ([[maybe_unused]] auto _ : state) studio.canvas.paint(studio.picture, image);
}
// The rasteriser has threads of its own.
BENCHMARK(paint)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void encode(benchmark::State& state) {
  Studio studio;
  const Image image = studio.canvas.paint(studio.picture);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(encode_png(image));
}
BENCHMARK(encode)->Unit(benchmark::kMillisecond);

void export_all_lessons(benchmark::State& state) {
  const std::vector<Lesson> lessons = bench::shipped_lessons();
  ExportOptions options;
  options.out_dir = std::filesystem::temp_directory_path() / "gjkscope-export-bench";
  options.assets_dir = kSource / "assets";
  options.index = true;
  options.force = true;
  int frames = 0;
  for ([[maybe_unused]] auto _ : state) frames += export_lessons(lessons, options).frames;
  state.counters["frames"] =
      benchmark::Counter(static_cast<double>(frames), benchmark::Counter::kIsRate);
  std::filesystem::remove_all(options.out_dir);
}
BENCHMARK(export_all_lessons)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
