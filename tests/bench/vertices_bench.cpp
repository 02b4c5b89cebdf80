// The cost of shapes of many vertices: opening a case, a move of the hand, letting go, undo. It is
// a session's own work, without what paints the picture. Prints milliseconds, and which of them are
// more than there is time for: `vertices-bench`, or
// `vertices-bench star` for the rows of stars.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "lesson/case.hpp"
#include "lesson/load.hpp"
#include "lesson/schema.hpp"
#include "session/edit.hpp"
#include "session/session.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

constexpr int kMoves = 30;

/// Time of the processor, in which the machine's other work counts little.
double milliseconds_of(const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  return 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Corners around (x, 0), within 3 of it, as text of a case.
std::string shape_of(const std::string& kind, int count, double x) {
  std::mt19937_64 random(static_cast<std::uint64_t>(count));
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  std::string vertices;
  for (int i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * (i + 0.5) / count;
    const double radius = kind == "star" && i % 2 == 0 ? 1.5 : 3.0;
    const double along = kind == "random" ? coordinate(random) : radius * std::cos(turn);
    const double up = kind == "random" ? coordinate(random) : radius * std::sin(turn);
    vertices += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", x + along, up);
  }
  return vertices;
}

/// Targets in milliseconds: for a window, and for a page, in which the same takes about twice as
/// long.
struct Target {
  const char* name;
  double window;
  double page;
};
constexpr Target kTargets[] = {
    {"open", 150.0, 300.0}, {"move", 30.0, 30.0}, {"let go", 300.0, 300.0}, {"undo", 300.0, 300.0}};

void print_row(const std::string& name, const std::vector<double>& times) {
  fmt::print("{:<22}", name);
  std::string late;
  for (std::size_t i = 0; i < times.size(); ++i) {
    fmt::print(" {:9.1f}", times[i]);
    if (times[i] > kTargets[i].window)
      late += fmt::format("{}{}", late.empty() ? "   late: " : ", ", kTargets[i].name);
  }
  fmt::print("{}\n", late);
}

/// The median of moves of Y, each with its picture.
double move_of(Session& session) {
  std::vector<double> moves;
  session.begin_drag("move a shape");
  for (int i = 0; i < kMoves; ++i) {
    moves.push_back(milliseconds_of([&] {
      session.drag([&](Lesson& shown) {
        edit::move_shape(shown, 1, {-0.02, 0.01 * (i % 3), 0.0});
      });
      (void)session.picture();
    }));
  }
  std::sort(moves.begin(), moves.end());
  return moves[moves.size() / 2];
}

double let_go_of(Session& session) {
  return milliseconds_of([&] {
    session.end_drag();
    (void)session.picture();
  });
}

double undo_of(Session& session) {
  return milliseconds_of([&] {
    session.undo();
    session.fit();
    (void)session.picture();
  });
}

void measure(const Fonts& fonts, const Lesson& lesson, const std::string& wanted,
             const std::string& kind, int of_x, int of_y) {
  const std::string row = fmt::format("{} {} + {}", kind, of_x, of_y);
  if (row.find(wanted) == std::string::npos) return;
  const std::string text = fmt::format(R"({{"a": [{}], "b": [{}]}})", shape_of(kind, of_x, 0.0),
                                       of_y == 2 ? "[5, 5], [6, 5]" : shape_of(kind, of_y, 8.0));
  Session session(fonts);
  session.open(lesson, {});
  const double opened = milliseconds_of([&] {
    const std::vector<ReadCase> read = parse_cases(text, kind);
    Lesson lesson = edit::with_shapes(session.lesson(), *read.front().value);
    // Beyond what a lesson file may hold there are cases alone.
    if (of_x > limits::kVertices)
      session.open(std::move(lesson), {});
    else
      session.edit("case", std::move(lesson));
    session.fit();
    (void)session.picture();
  });
  const double moved = move_of(session);
  const double released = let_go_of(session);
  print_row(row, {opened, moved, released, undo_of(session)});
}

void measure(const Fonts& fonts, const Lesson& lesson) {
  Session session(fonts);
  const double opened = milliseconds_of([&] {
    session.open(lesson, {});
    (void)session.picture();
  });
  const double moved = move_of(session);
  const double released = let_go_of(session);
  print_row(lesson.id, {opened, moved, released, undo_of(session)});
}

/// Rows whose name holds `wanted`.
int run(const std::string& wanted) {
  const std::filesystem::path source = GJKSCOPE_SOURCE_DIR;
  const Fonts fonts(source / "assets" / "fonts.toml");
  const auto lesson_of = [&](const char* name) {
    const LoadedLesson loaded =
        load_lesson(source / "lessons" / fmt::format("{}.toml", name), vocabulary());
    if (!loaded.lesson) fmt::print(stderr, "vertices-bench: {}\n", to_string(loaded.problems));
    return loaded.lesson;
  };
  const std::optional<Lesson> polygons = lesson_of("polygons-gjk");
  const std::optional<Lesson> trees = lesson_of("hierarchy-large");
  if (!polygons || !trees) return 1;
  fmt::print("{:<22}", "milliseconds");
  for (const Target& target : kTargets) fmt::print(" {:>9}", target.name);
  fmt::print("\n{:<22}", "at most, in a window");
  for (const Target& target : kTargets) fmt::print(" {:9.0f}", target.window);
  fmt::print("\n{:<22}", "at most, in a page");
  for (const Target& target : kTargets) fmt::print(" {:9.0f}", target.page);
  fmt::print("\n");
  constexpr int kFewest = 2;  // of Y: a segment
  for (const std::string kind : {"convex", "star", "random"}) {
    for (const int count : {3, 10, 30, 64, 100, 150, 200, 300, 1000, 10000, 100000, 1000000})
      measure(fonts, *polygons, wanted, kind, count, kFewest);
    for (const int count : {12, 50, 100, 150, 1000, 5000})
      measure(fonts, *polygons, wanted, kind, count, count);
  }
  if (trees->id.find(wanted) != std::string::npos) measure(fonts, *trees);
  return 0;
}

}  // namespace
}  // namespace gjkscope

int main(int count, char** arguments) { return gjkscope::run(count > 1 ? arguments[1] : ""); }
