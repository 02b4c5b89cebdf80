// The window's own work on a frame while a shape is dragged: trace, effects, picture and draw list,
// without what OpenGL makes of them. The target is 2 ms.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "headless_app.hpp"

namespace gjkscope {
namespace {

constexpr double kTarget = 2.0;  // milliseconds

/// Milliseconds of each of `frames` frames of a drag of Y around a circle.
std::vector<double> drag_times(const std::string& lesson, int frames) {
  test::HeadlessApp window(lesson);
  window.resize(1280.0, 720.0);
  const Point start = window.at({Subject::Kind::vertex_of_y, -1, 0});
  window.move(start);
  window.button(true);
  std::vector<double> times;
  for (int i = 1; i <= frames; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / frames;
    const Point at = start + 40.0 * Point(std::cos(turn) - 1.0, std::sin(turn));
    ImGui::GetIO().MousePos = ImVec2(static_cast<float>(at.x()), static_cast<float>(at.y()));
    const auto begin = std::chrono::steady_clock::now();
    window.frame();
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
            .count());
  }
  window.button(false);
  std::sort(times.begin(), times.end());
  return times;
}

int run(int argc, char** argv) {
  CLI::App app("The window's own work on a frame of a drag at 1280x720");
  int frames = 400;
  app.add_option("--frames", frames, "frames of each drag")->check(CLI::Range(10, 100000));
  CLI11_PARSE(app, argc, argv);
  bool reached = true;
  fmt::print("{:<20} {:>8} {:>8}   milliseconds a frame\n", "lesson", "median", "95 %");
  for (const char* lesson : {"polygons-gjk", "segment-regions", "polygon-evolution",
                             "minkowski-build", "polygons-motion", "slab-certificate"}) {
    const std::vector<double> times = drag_times(lesson, frames);
    const double median = times[times.size() / 2];
    reached = reached && median < kTarget;
    fmt::print("{:<20} {:>8.2f} {:>8.2f}\n", lesson, median, times[times.size() * 95 / 100]);
  }
  fmt::print("wanted: a median under {} ms: {}\n", kTarget, reached ? "ok" : "FAIL");
  return reached ? 0 : 1;
}

}  // namespace
}  // namespace gjkscope

int main(int argc, char** argv) { return gjkscope::run(argc, argv); }
