
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "effects/second_run.hpp"
#include "lesson/names.hpp"
#include "picture/blocks/blocks.hpp"

namespace gjkscope::blocks {
namespace {

using gjk::Phase;
using namespace rows;

/// One column: a run, and its state at the frame.
struct Column {
  std::string title;
  double x = 0.0;  ///< Right edge.
  const PositionedRun& run;
  const gjk::State<double, 2>* state;  ///< Null where the run has no step beside the frame's.
  Numbers numbers;
};

void two_runs(PanelBuilder& panel) {
  const Lesson& lesson = panel.run.lesson;
  const SecondRun::Value& second = panel.effects.get<SecondRun>(panel.frame);
  const gjk::Step<double, 2>* beside = step_beside(second, panel.run, panel.frame);
  const PositionedRun& first = panel.run.run(panel.frame);
  const gjk::State<double, 2>* state = panel.knows.phase ? &panel.state : nullptr;
  Lesson other = lesson;
  other.scalar = *lesson.beside;
  const double half = 0.5 * (panel.right - panel.left - 62.0);
  const std::array<Column, 2> columns = {
      Column{std::string(name_of(lesson.scalar)), panel.left + 62.0 + half, first, state,
             panel.numbers},
      Column{std::string(name_of(*lesson.beside)), panel.right, second.run,
             beside ? &beside->after : nullptr, Numbers(other)}};

  panel.write("heading", panel.left, "Two runs", type::kHeading);
  for (const Column& column : columns)
    panel.write("heading", column.x, column.title, type::kHeading, Align::right);
  panel.y += kRow + 2.0;

  const auto known = [&](Phase since) {
    return panel.knows.phase && *panel.knows.phase >= since && *panel.knows.phase != Phase::add;
  };
  // From its first digit that differs on a text has a line below it.
  const auto underline = [&](const std::string& role, double right, const std::string& text,
                             const std::string& compared) {
    const std::u32string mine = code_points(text);
    const std::u32string its = code_points(compared);
    const auto same = std::mismatch(mine.begin(), mine.end(), its.begin(), its.end()).first;
    const double width =
        panel.fonts.width(type::kCodeBold, "0") * static_cast<double>(mine.end() - same);
    if (width > 0.0)
      panel.add(role, Box{{{right - width, panel.y + 3.0}, {right, panel.y + 5.0}}, 0.0});
  };
  // What differs stands out: the values themselves, which have their own digits in each column.
  const auto row = [&](const std::string& name, bool since, auto value, auto words) {
    panel.write("code", panel.left, name, type::kCode);
    std::array<std::string, 2> texts = {"–", "–"};
    for (int i = 0; i < 2; ++i)
      if (since && columns[i].state) texts[i] = words(columns[i], value(columns[i]));
    const bool both = columns[0].state && columns[1].state;
    const bool differ = since && (!both || value(columns[0]) != value(columns[1]));
    for (int i = 0; i < 2; ++i) {
      const char* const role = !differ ? "code" : i == 0 ? "fail" : "pass";
      panel.write(role, columns[i].x, texts[i], differ ? type::kCodeBold : type::kCode,
                  Align::right);
      if (differ && both) underline(role, columns[i].x, texts[i], texts[1 - i]);
    }
    panel.y += kRow;
  };
  const auto coordinate = [&](const std::string& name, Phase since, auto vector, int axis) {
    row(
        name, known(since), [&](const Column& column) { return vector(column)[axis]; },
        [](const Column& column, double value) { return column.numbers(value); });
  };
  // A point query's difference is the polygon seen from Q.
  const auto p = [&](const Column& column) {
    return panel.run.point_query() ? Eigen::Vector2d(column.state->p + column.run.x().world[0])
                                   : column.state->p;
  };
  const auto d = [](const Column& column) { return column.state->d; };
  coordinate("P.x", Phase::closest, p, 0);
  coordinate("P.y", Phase::closest, p, 1);
  coordinate("d.x", Phase::direction, d, 0);
  coordinate("d.y", Phase::direction, d, 1);
  row("towards", known(Phase::direction), d, [](const Column&, const Eigen::Vector2d& along) {
    return fixed(std::atan2(along.y(), along.x()) * 180.0 / std::numbers::pi, 1) + "°";
  });
  const auto as_it_is = [](const Column&, const std::string& text) { return text; };
  row(
      "support", known(Phase::support),
      [&](const Column& column) { return panel.run.pair_name(column.state->support.pair); },
      as_it_is);
  row(
      "stops", known(Phase::stop),
      [](const Column& column) {
        return std::string(column.state->stop == gjk::StopReason::running ? "no" : "yes");
      },
      as_it_is);
}

}  // namespace

const Block kTwoRuns{.name = "two-runs",
                     .meaning = "the lesson's run and the second one side by side",
                     .write = two_runs,
                     .second_run = true};

}  // namespace gjkscope::blocks
