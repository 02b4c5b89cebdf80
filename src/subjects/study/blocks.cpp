#include <fmt/format.h>

#include <algorithm>

#include "base/decimal.hpp"
#include "picture/words.hpp"
#include "subjects/study/dot_words.hpp"
#include "subjects/study/plot.hpp"
#include "subjects/study/rounded_pair.hpp"
#include "subjects/study/subject.hpp"
#include "subjects/study/table.hpp"
#include "subjects/study/tour.hpp"

namespace gjkscope::blocks {
namespace {

constexpr double kLine = 22.0;    // base line to base line
constexpr double kBetween = 8.0;  // entries of a list
constexpr double kIndent = 26.0;  // of what stands beside a symbol or a number

void heading(PanelBuilder& panel, const std::string& text) {
  panel.write("heading", panel.left, text, type::kName);
  panel.y += kLine + kBetween;
}

void row(PanelBuilder& panel, const std::string& name, const std::string& value,
         const std::string& role = "body") {
  panel.write("body.muted", panel.left, name, type::kText);
  panel.write(role, panel.right, value, type::kText, Align::right);
  panel.y += kLine + kBetween;
}

/// Decimals of a height that tell it from its neighbours in float.
std::string height(double value) { return fixed(value, 8); }

/// The ends of the facing edges, and what a float makes of them.
void heights(PanelBuilder& panel, const RoundedPair::Value& found, StudyStage stage) {
  if (found.facing.empty()) return;
  const bool rounds = stage == StudyStage::in_float || stage == StudyStage::error;
  const double column = panel.right - (rounds ? 140.0 : 0.0);
  heading(panel, "Heights of the facing edges");
  panel.write("body.muted", panel.left, "vertex", type::kText);
  panel.write("body.muted", column, "given", type::kText, Align::right);
  if (rounds) panel.write("body.muted", panel.right, "as float", type::kText, Align::right);
  panel.y += kLine + kBetween;
  for (const RoundedPair::Vertex& vertex : found.facing) {
    const LessonShape& shape = vertex.of_x ? panel.run.lesson.x() : panel.run.lesson.y();
    panel.write(vertex.of_x ? "shape.x.label" : "shape.y.label", panel.left,
                fmt::format("{} of {}", shape.vertex_names[vertex.index], shape.name), type::kName);
    panel.write("body", column, height(vertex_in_world(found.exact, vertex).y()), type::kText,
                Align::right);
    if (rounds) {
      panel.write("body", panel.right, height(vertex_in_world(found.in_float, vertex).y()),
                  type::kText, Align::right);
    }
    panel.y += kLine + 4.0;
  }
  panel.rule();
}

/// The answers to one pair, as far as the frame knows them.
void pair(PanelBuilder& panel, StudyStage stage) {
  const RoundedPair::Value& found = panel.effects.get<RoundedPair>(panel.frame);
  const double distance = found.distance();
  const auto answer = [&](const PositionedRun& run) { return run.trace.result.distance; };
  heights(panel, found, stage);
  heading(panel, "Their distance");
  row(panel, "exact", stage == StudyStage::shapes ? "?" : power_text(distance, 8));
  if (stage >= StudyStage::in_float)
    row(panel, "answer in float", power_text(answer(found.in_float), 8));
  if (stage >= StudyStage::in_double)
    row(panel, "answer in double", power_text(answer(found.in_double), 8));
  if (stage < StudyStage::error) return;
  panel.rule();
  heading(panel, "Error");
  row(panel, "in float", power_text(error_of(answer(found.in_float), distance), 2));
  row(panel, "in double", power_text(error_of(answer(found.in_double), distance), 2));
}

void symbol(PanelBuilder& panel, const StudyDot& dot) {
  const Point at(panel.left + 7.0, panel.y - 0.5 * panel.fonts.cap_height(type::kName));
  panel.marks.push_back(symbol_mark(style_of(dot), at));
}

/// The marks so far, what each does, and what it costs. The newest is set off.
void legend(PanelBuilder& panel, const LessonStudy& study, const StudyFrame& frame) {
  const std::vector<StudyDot> marks = introduced(study, frame.marks);
  heading(panel, "Ways to run GJK");
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const std::string& about = study.marks[i].about;
    if (frame.stage == StudyStage::mark && i + 1 == marks.size()) {
      panel.add("highlight", Box{{{panel.left - 8.0, panel.y - 19.0},
                                  {panel.right + 8.0, panel.y + (about.empty() ? 7.0 : 28.0)}},
                                 5.0});
    }
    symbol(panel, marks[i]);
    panel.write("strong", panel.left + kIndent, marks[i].configuration, type::kName);
    if (!about.empty()) {
      panel.y += kLine - 1.0;
      panel.write("body.muted", panel.left + kIndent, about, type::kText);
    }
    panel.y += kLine + 3.0;
  }
  if (frame.stage >= StudyStage::mark) return;
  panel.rule();
  heading(panel, "What proved means");
  for (const char* line : {"Bounds that allow for rounding enclose the",
                           "distance. Where they are too far apart, exact",
                           "arithmetic goes on. A float proves its answer",
                           "for the vertices as it has rounded them."}) {
    panel.write("body", panel.left, line, type::kText);
    panel.y += kLine;
  }
}

/// Each mark: on the front, or beaten by which.
void beaten(PanelBuilder& panel, const LessonStudy& study) {
  const std::vector<StudyDot> marks = introduced(study, static_cast<int>(study.marks.size()));
  const std::vector<StudyDot> best = front_among(marks);
  heading(panel, "On the front, or beaten by which");
  for (const StudyDot& dot : marks) {
    const bool on_front = std::any_of(best.begin(), best.end(), [&](const StudyDot& each) {
      return each.configuration == dot.configuration;
    });
    symbol(panel, dot);
    panel.write(on_front ? "strong" : "body.muted", panel.left + kIndent, dot.configuration,
                on_front ? type::kName : type::kText);
    panel.y += kLine - 1.0;
    const std::optional<StudyDot> by = beaten_by(dot, best);
    panel.write("body.muted", panel.left + kIndent,
                on_front ? fmt::format("{}, error {}", time_text(dot.ns), error_words(dot))
                : by     ? "beaten by " + by->configuration
                         : "not one digit is right",
                type::kText);
    panel.y += kLine + 3.0;
  }
}

/// The front of all ways, numbered as in the plot, with as much about each as there is room for.
void front(PanelBuilder& panel, const LessonStudy& study) {
  const std::vector<StudyDot> best = front_of(of_family(study.dots(), study.family));
  heading(panel, "The front of all ways");
  const bool is_short = best.size() < 6;
  const bool is_long = best.size() > 8;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const StudyDot& dot = best[i];
    panel.write("plot.limit.label", panel.left, std::to_string(i + 1), type::kName);
    panel.write("strong", panel.left + kIndent, dot.configuration, type::kName);
    if (is_short) {
      panel.y += kLine - 1.0;
      panel.write("body.muted", panel.left + kIndent, about(study, dot), type::kText);
    }
    if (!is_long) {
      panel.y += kLine - 1.0;
      panel.write("body.muted", panel.left + kIndent,
                  fmt::format("{}, error {}", time_text(dot.ns), error_words(dot)), type::kText);
    }
    panel.y += is_long ? kLine + 4.0 : kLine + 3.0;
  }
}

void needs(PanelBuilder& panel, const std::vector<StudyDot>& family) {
  heading(panel, "You need … so take …");
  for (const Choice& choice : choices(family)) {
    panel.write("body.muted", panel.left, choice.need, type::kText);
    panel.y += kLine;
    panel.write("strong", panel.left + kIndent, choice.dot.configuration, type::kName);
    panel.write("body", panel.right, time_text(choice.dot.ns), type::kText, Align::right);
    panel.y += kLine + 2.0 * kBetween;
  }
}

void study(PanelBuilder& panel) {
  const LessonStudy& study = *panel.run.lesson.settings.as<LessonStudy>();
  const StudyFrame frame = *study_frame(panel.run, panel.frame);
  const std::vector<StudyDot> family = of_family(study.dots(), study.family);
  if (frame.stage < StudyStage::error_axis) return pair(panel, frame.stage);
  if (frame.stage == StudyStage::front) return beaten(panel, study);
  if (frame.stage == StudyStage::all) return front(panel, study);
  if (frame.stage == StudyStage::choice) return needs(panel, family);
  legend(panel, study, frame);
}

}  // namespace

const Block kStudy{.name = "study",
                   .meaning =
                       "with tour `study`: the answers to one pair, then the marks and what "
                       "they are, the front, what to take",
                   .write = study,
                   .tour = "study"};

}  // namespace gjkscope::blocks
