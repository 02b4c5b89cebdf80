// Times of opening and dragging a shape of many vertices: a session's own work, without what paints
// the picture. paints the picture. Prints milliseconds, by number of vertices and kind of shape.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "lesson/case.hpp"
#include "lesson/load.hpp"
#include "picture/registry.hpp"
#include "session/edit.hpp"
#include "session/session.hpp"

namespace gjkscope {
namespace {

constexpr int kMoves = 30;

double milliseconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

/// X has `count` vertices within 3 of the origin; Y is a segment beside it.
std::string case_of(const std::string& kind, int count) {
  std::mt19937_64 random(static_cast<std::uint64_t>(count));
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  std::string vertices;
  for (int i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * (i + 0.5) / count;
    const double radius = kind == "star" && i % 2 == 0 ? 1.5 : 3.0;
    const double x = kind == "random" ? coordinate(random) : radius * std::cos(turn);
    const double y = kind == "random" ? coordinate(random) : radius * std::sin(turn);
    vertices += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", x, y);
  }
  return fmt::format(R"({{"a": [{}], "b": [[5, 5], [6, 5]]}})", vertices);
}

void measure(const Fonts& fonts, const Lesson& lesson, const std::string& kind, int count) {
  const std::vector<ReadCase> read = parse_cases(case_of(kind, count), kind);
  Session session(fonts);
  session.open(lesson, {});
  const double opened = milliseconds_of([&] {
    session.edit("case", edit::told_of(session.lesson(), *read.front().value));
    session.fit();
    (void)session.picture();
  });
  std::vector<double> moves;
  session.begin_drag("move a shape");
  for (int i = 0; i < kMoves; ++i) {
    moves.push_back(milliseconds_of([&] {
      session.drag([&](Lesson& shown) { edit::move_shape(shown, 1, {-0.02, 0.01 * (i % 3)}); });
      (void)session.picture();
    }));
  }
  std::sort(moves.begin(), moves.end());
  const double released = milliseconds_of([&] {
    session.end_drag();
    (void)session.picture();
  });
  const double undone = milliseconds_of([&] {
    session.undo();
    session.fit();
    (void)session.picture();
  });
  fmt::print("{:>7} {:>8} {:9.1f} {:9.1f} {:9.1f} {:9.1f} {:9.1f}\n", kind, count, opened,
             moves[moves.size() / 2], moves.back(), released, undone);
}

int run() {
  const std::filesystem::path source = GJKSCOPE_SOURCE_DIR;
  const Fonts fonts(source / "assets" / "fonts.toml");
  const LoadedLesson loaded = load_lesson(source / "lessons" / "polygons-gjk.toml", vocabulary());
  if (!loaded.lesson) {
    fmt::print(stderr, "vertices-bench: {}\n", to_string(loaded.problems));
    return 1;
  }
  fmt::print("{:>7} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "shape", "vertices", "open", "move",
             "worst", "let go", "undo");
  for (const std::string kind : {"convex", "star", "random"}) {
    for (const int count : {3, 10, 30, 64, 100, 150, 200, 300, 1000, 10000})
      measure(fonts, *loaded.lesson, kind, count);
  }
  return 0;
}

}  // namespace
}  // namespace gjkscope

int main() { return gjkscope::run(); }
