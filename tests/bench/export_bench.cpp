// The time of an export by task: building, painting, encoding one frame of 1280 x 720, and all
// shipped lessons from file to file. The project promises the last one: at least 30 frames per
// second on two cores. export_costs.cpp has ratios.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
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

/// The frames of a lesson from its run to pixels.
void build_and_paint(benchmark::State& state, const Lesson& lesson) {
  Studio studio;
  Image image;
  std::size_t frames = 0;
  for ([[maybe_unused]] auto _ : state) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    for (const FramePicture& frame : lesson_pictures(run, effects, studio.fonts)) {
      studio.canvas.paint(frame.picture, image);
      ++frames;
    }
  }
  state.counters["time of a frame"] =
      benchmark::Counter(static_cast<double>(frames),
                         benchmark::Counter::kAvgThreadsRate | benchmark::Counter::kInvert);
}

Lesson shipped(std::string_view id) {
  const std::vector<Lesson> lessons = bench::shipped_lessons();
  const auto found = std::find_if(lessons.begin(), lessons.end(),
                                  [&](const Lesson& lesson) { return lesson.id == id; });
  return found == lessons.end() ? throw std::runtime_error("no such lesson") : *found;
}

void polygons(benchmark::State& state) { build_and_paint(state, shipped("polygons-gjk")); }
BENCHMARK(polygons)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// The lesson about two polyhedra, with 64 points of a sphere in place of each.
void polyhedra_of_64_vertices(benchmark::State& state) {
  Lesson lesson = shipped("polyhedra-gjk");
  lesson.questions.clear();
  for (LessonShape& shape : lesson.bodies) {
    const std::vector<Eigen::Vector3d> corners = std::exchange(shape.vertices, {});
    const Eigen::Vector3d middle =
        std::accumulate(corners.begin(), corners.end(), Eigen::Vector3d(0.0, 0.0, 0.0)) /
        static_cast<double>(corners.size());
    shape.vertex_names.clear();
    for (int i = 0; i < 64; ++i) {
      const double z = (i + 0.5) / 32.0 - 1.0;
      const double turn = 2.4 * i;
      shape.vertices.emplace_back(middle + Eigen::Vector3d(std::sqrt(1.0 - z * z) * std::cos(turn),
                                                           std::sqrt(1.0 - z * z) * std::sin(turn),
                                                           z));
      shape.vertex_names.push_back(shape.name + std::to_string(i));
    }
  }
  build_and_paint(state, lesson);
}
BENCHMARK(polyhedra_of_64_vertices)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

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
