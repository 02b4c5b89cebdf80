#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <type_traits>

#include "lesson/names.hpp"
#include "subjects/second_run/second_run.hpp"
#include "subjects/second_run/subject.hpp"

namespace gjkscope::blocks {
namespace {

using gjk::Phase;
using namespace rows;

/// Two numbers that differ, with as many digits as that takes.
std::array<std::string, 2> different_texts(const std::array<double, 2>& numbers) {
  std::array<std::string, 2> texts;
  constexpr int kAllDigits = 17;
  for (int digits = 4; digits <= kAllDigits && texts[0] == texts[1]; ++digits) {
    for (int i = 0; i < 2; ++i) texts[i] = significant(numbers[i], digits);
  }
  return texts;
}

/// Digits that are too many go from the middle: the first ones say how large a number is, the last
/// ones how it differs.
std::string without_middle(std::string text, const std::function<bool(const std::string&)>& fits) {
  constexpr std::size_t kFirst = 5;
  std::string shown = text;
  for (std::size_t gone = 1; !fits(shown) && kFirst + gone + 1 < text.size(); ++gone) {
    std::size_t begin = kFirst;
    std::size_t end = kFirst + gone;
    while (begin > 0 && !starts_character(text[begin])) --begin;
    while (end < text.size() && !starts_character(text[end])) ++end;
    shown = text.substr(0, begin) + "…" + text.substr(end);
  }
  return shown;
}

}  // namespace

void two_columns(PanelBuilder& panel, const std::array<RunColumn, 2>& columns, double share) {
  constexpr double kNames = 62.0;
  const double half = 0.5 * (panel.right - panel.left - kNames);
  const std::array<double, 2> rights = {panel.left + kNames + half, panel.right};
  panel.write("heading", panel.left, "Two runs", type::kHeading);
  for (int i = 0; i < 2; ++i)
    panel.write("heading", rights[i], columns[i].title, type::kHeading, Align::right);
  panel.y += kRow + 2.0;

  const auto known = [&](Phase since) {
    return panel.knows.phase && *panel.knows.phase >= since && *panel.knows.phase != Phase::add;
  };
  constexpr double kBetween = 8.0;  // columns
  const auto fitting = [&](std::string text) {
    return without_middle(std::move(text), [&](const std::string& shown) {
      return panel.fonts.width(type::kCodeBold, shown) <= half - kBetween;
    });
  };
  // A text is underlined from the first digit that differs.
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
  const auto row = [&](const std::string& name, bool since, auto value, auto words) {
    panel.write("code", panel.left, name, type::kCode);
    std::array<std::string, 2> texts = {"–", "–"};
    const bool both = columns[0].state && columns[1].state;
    for (int i = 0; i < 2; ++i)
      if (since && columns[i].state) texts[i] = words(columns[i], value(columns[i]));
    bool differ = texts[0] != texts[1];
    if constexpr (std::is_same_v<decltype(value(columns[0])), double>) {
      // The values themselves, which have their own digits in each column.
      if (since && both) {
        const std::array<double, 2> numbers = {value(columns[0]), value(columns[1])};
        const double most = std::max(std::abs(numbers[0]), std::abs(numbers[1]));
        differ = std::abs(numbers[0] - numbers[1]) > share * most;
        if (differ && texts[0] == texts[1]) texts = different_texts(numbers);
      }
      for (std::string& text : texts) text = fitting(std::move(text));
    }
    for (int i = 0; i < 2; ++i) {
      const char* const role = !differ ? "code" : i == 0 ? "fail" : "pass";
      panel.write(role, rights[i], texts[i], differ ? type::kCodeBold : type::kCode, Align::right);
      if (differ && both) underline(role, rights[i], texts[i], texts[1 - i]);
    }
    panel.y += kRow;
  };
  const auto coordinate = [&](const std::string& name, Phase since, auto vector, int axis) {
    row(
        name, known(since), [&](const RunColumn& column) -> double { return vector(column)[axis]; },
        [&](const RunColumn& column, double value) {
          // In space, as many digits as a float has, so that the columns can be compared.
          const bool in_float = panel.run.lesson.scalar == ScalarKind::single;
          return in_float && panel.run.lesson.dimension == 3 ? significant(value, 8)
                                                             : column.numbers(value);
        });
  };
  // A point query's difference is the polygon seen from Q.
  const auto p = [&](const RunColumn& column) {
    return panel.run.point_query() ? Eigen::Vector3d(column.state->p + column.run.x().world[0])
                                   : column.state->p;
  };
  const auto d = [](const RunColumn& column) { return column.state->d; };
  const int dimension = panel.run.lesson.dimension;
  const std::string_view axes = "xyz";
  for (int axis = 0; axis < dimension; ++axis)
    coordinate(fmt::format("P.{}", axes[axis]), Phase::closest, p, axis);
  for (int axis = 0; axis < dimension; ++axis)
    coordinate(fmt::format("d.{}", axes[axis]), Phase::direction, d, axis);
  if (dimension == 2) {
    row("towards", known(Phase::direction), d, [](const RunColumn&, const Eigen::Vector3d& along) {
      if (along.isZero(0.0)) return std::string("–");
      return fixed(std::atan2(along.y(), along.x()) * 180.0 / std::numbers::pi, 1) + "°";
    });
  }
  const auto as_it_is = [](const RunColumn&, const std::string& text) { return text; };
  row(
      "support", known(Phase::support),
      [&](const RunColumn& column) { return panel.run.pair_name(column.state->support.pair); },
      as_it_is);
  row(
      "stops", panel.knows.phase.has_value(),
      [&](const RunColumn& column) {
        const gjk::StopReason stop = column.state->stop;  // one run may have ended before the other
        if (stop == gjk::StopReason::iteration_cap) return std::string("cut off");
        if (stop != gjk::StopReason::running) return std::string("yes");
        return std::string(known(Phase::stop) ? "no" : "–");
      },
      as_it_is);
}

namespace {

void two_runs(PanelBuilder& panel) {
  const Lesson& lesson = panel.run.lesson;
  const SecondRun::Value& second = panel.effects.get<SecondRun>(panel.frame);
  const WideStep* beside = step_beside(second, panel.run, panel.frame);
  Lesson other = lesson;
  other.scalar = *second_of(lesson)->scalar;
  two_columns(panel, {RunColumn{std::string(name_of(lesson.scalar)), panel.run.run(panel.frame),
                                panel.knows.phase ? &panel.state : nullptr, panel.numbers},
                      RunColumn{std::string(name_of(other.scalar)), second.run,
                                beside ? &beside->after : nullptr, Numbers(other)}});
}

}  // namespace

const Block kTwoRuns{.name = "two-runs",
                     .meaning = "the lesson's run and the second one side by side",
                     .write = two_runs,
                     .table = LessonSecond::kTable,
                     .shown_of = ShownOf::both};

}  // namespace gjkscope::blocks
