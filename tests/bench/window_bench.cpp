// The window while a shape is dragged, or in space the ground, which turns it: its own work on a
// frame (trace, effects, picture and draw list, without what OpenGL makes of them) at 1280x720 and
// 3840x2160, and, where there is a display, whole frames at 1280x720 and how long the first one
// takes from the start of the program.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "headless_app.hpp"

namespace gjkscope {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Milliseconds.
constexpr double kOwnTarget = 2.0;
constexpr double kTurnTarget = 4.0;
constexpr double kWholeTarget = 16.0;  // of 60 frames a second, as is that of own work at 4K
constexpr double kStartTarget = 300.0;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

struct Times {
  explicit Times(std::vector<double> times) : sorted(std::move(times)) {
    std::sort(sorted.begin(), sorted.end());
  }
  [[nodiscard]] double at(double share) const {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }
  std::vector<double> sorted;
};

/// The way of the pointer from its start to frame i of n: once around a circle.
Point on_circle(int i, int n) {
  const double turn = 2.0 * std::numbers::pi * i / n;
  return 40.0 * Point(std::cos(turn) - 1.0, std::sin(turn));
}

/// The time of the window's own work in each of `frames` frames of a drag: of Y's first vertex, in
/// space of the ground.
Times own_times(const std::string& lesson, int frames, double width, double height) {
  test::HeadlessApp window(lesson);
  window.resize(width, height);
  const std::optional<Eye> eye = window.session().eye();
  const Rect card = window.session().views().front().card;
  const Point ground = card.max - Point::Constant(12.0);
  const Point start = eye ? window.app().picture().to_pixel(ground)
                          : window.at({Subject::Kind::vertex_of_y, -1, 0});
  window.move(start);
  window.button(true);
  std::vector<double> times;
  bool turns = false;
  for (int i = 1; i <= frames; ++i) {
    const Point at = start + on_circle(i, frames);
    ImGui::GetIO().MousePos = ImVec2(static_cast<float>(at.x()), static_cast<float>(at.y()));
    const auto begin = Clock::now();
    window.frame();
    times.push_back(milliseconds_since(begin));
    turns = turns || window.session().eye() != eye;
  }
  window.button(false);
  if (eye && !turns) throw std::runtime_error(lesson + " does not turn");
  return Times(std::move(times));
}

/// The times of one run of the program: to the first frame, from the start of the process, and of
/// each frame of a drag.
struct Run {
  double start = 0.0;
  std::vector<double> frames;
};
Run run_viewer(const fs::path& viewer, const std::string& lesson, const fs::path& script) {
  const std::string command =
      fmt::format("exec '{}' --no-state --size 1280 720 --log-frames --script '{}' {} 2>&1",
                  viewer.string(), script.string(), lesson);
  Run run;
  const auto begin = Clock::now();
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> output(popen(command.c_str(), "r"), pclose);
  if (!output) throw std::runtime_error("cannot run " + command);
  char line[512];
  while (std::fgets(line, sizeof line, output.get())) {
    double time = 0.0;
    if (std::sscanf(line, "%lf", &time) != 1) throw std::runtime_error(line);
    if (run.start == 0.0) run.start = milliseconds_since(begin);
    run.frames.push_back(time);
  }
  return run;
}

fs::path write_drag(int moves) {
  fs::path script = fs::temp_directory_path() / fmt::format("gjkscope-drag-{}.txt", getpid());
  std::ofstream stream(script);
  stream << "move y:0\npress\n";
  // The place of the vertex follows the drag, so these are steps and not places on the circle.
  for (int i = 1; i <= moves; ++i) {
    const Point step = on_circle(i, moves) - on_circle(i - 1, moves);
    stream << fmt::format("move y:0+{:.3f},{:.3f}\n", step.x(), step.y());
  }
  stream << "release\n";
  return script;
}

bool compare(const char* what, double found, double target) {
  const bool reached = found < target;
  fmt::print("wanted: {} under {} ms: {}\n", what, target, reached ? "ok" : "FAIL");
  return reached;
}

int run(int argc, char** argv) {
  CLI::App app("The window while a shape is dragged");
  int frames = 400;
  int starts = 11;
  app.add_option("--frames", frames, "frames of each drag")->check(CLI::Range(10, 100000));
  app.add_option("--starts", starts, "how often the program is started")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  const std::vector<std::string> lessons = {"polygons-gjk",      "segment-regions",
                                            "polygon-evolution", "minkowski-build",
                                            "polygons-motion",   "slab-certificate"};
  const std::vector<std::string> in_space = {"polyhedra-gjk", "tetrahedron-regions",
                                             "hill-climbing", "slab-in-space", "depth-in-space"};

  bool reached = true;
  for (const auto& [of, target] : {std::pair(&lessons, kOwnTarget), {&in_space, kTurnTarget}}) {
    double own = 0.0;
    double own_4k = 0.0;
    fmt::print("{:<20} {:>8} {:>8} {:>8} {:>8}   own work on a frame of a {}, in milliseconds\n",
               "lesson", "median", "95 %", "4K", "95 %", of == &lessons ? "drag" : "turn");
    for (const std::string& lesson : *of) {
      const Times times = own_times(lesson, frames, 1280.0, 720.0);
      const Times times_4k = own_times(lesson, frames, 3840.0, 2160.0);
      own = std::max(own, times.at(0.5));
      own_4k = std::max(own_4k, times_4k.at(0.95));
      fmt::print("{:<20} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f}\n", lesson, times.at(0.5),
                 times.at(0.95), times_4k.at(0.5), times_4k.at(0.95));
    }
    reached = compare("a median of own work", own, target) && reached;
    reached = compare("95 % of own work at 3840x2160", own_4k, kWholeTarget) && reached;
  }
  if (!std::getenv("DISPLAY")) {
    fmt::print("no display: whole frames and the start are not measured\n");
    return reached ? 0 : 1;
  }

  const fs::path viewer = fs::read_symlink("/proc/self/exe").parent_path() / "gjkscope-viewer";
  const fs::path script = write_drag(frames);
  double whole = 0.0;
  fmt::print("\n{:<20} {:>8} {:>8} {:>8}   whole frames, in milliseconds\n", "lesson", "median",
             "95 %", "most");
  for (const std::string& lesson : lessons) {
    Run found = run_viewer(viewer, lesson, script);
    found.frames.erase(found.frames.begin());  // the first is part of the start
    const Times times(std::move(found.frames));
    whole = std::max(whole, times.at(0.95));
    fmt::print("{:<20} {:>8.2f} {:>8.2f} {:>8.2f}\n", lesson, times.at(0.5), times.at(0.95),
               times.at(1.0));
  }
  reached = compare("95 % of whole frames", whole, kWholeTarget) && reached;
  std::ofstream(script).close();  // nothing to play: the first frame, and the end
  std::vector<double> first;
  for (int i = 0; i < starts; ++i) first.push_back(run_viewer(viewer, "", script).start);
  fs::remove(script);
  const Times times(std::move(first));
  fmt::print("\nfirst frame after the start: median {:.0f} ms, {:.0f} to {:.0f} in {} starts\n",
             times.at(0.5), times.at(0.0), times.at(1.0), starts);
  reached = compare("a median of first frames", times.at(0.5), kStartTarget) && reached;
  return reached ? 0 : 1;
}

}  // namespace
}  // namespace gjkscope

int main(int argc, char** argv) {
  try {
    return gjkscope::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "window-bench: {}\n", error.what());
    return 2;
  }
}
