// Two runs about the same shapes, one view for each: the lesson's, and one that takes another way.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "mistakes/mistakes.hpp"
#include "picture/text_box.hpp"
#include "run/effect_info.hpp"
#include "run/graph.hpp"
#include "run/questions.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/second_run/subject.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/subjects.hpp"
#include "subjects/two_runs/lesson_trace.hpp"

namespace gjkscope {

/// The effects of the two runs.
struct EffectsOfTwoRuns {
  static constexpr std::string_view kName = "two-runs";
  static constexpr std::string_view kNeeds = "";
  using Value = std::array<std::unique_ptr<EffectGraph>, 2>;
  static EffectKey key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame) {
    const TwoRunsTrace& both = two_runs_of(run, frame);
    return {std::make_unique<EffectGraph>(both.runs[0], graph),
            std::make_unique<EffectGraph>(both.runs[1], graph)};
  }
};

}  // namespace gjkscope

namespace gjkscope::two_runs {
namespace {

using Eigen::Vector3d;
using gjk::Phase;
using judging::Part;

/// The content of a frame.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : both(two_runs_of(run, frame)),
        second(*second_of(run.lesson)),
        step(frame.step),
        is_answer(frame.step < 0 || frame.step >= both.steps()) {}

  /// The frame of one of the runs: at the start and the answer its end.
  [[nodiscard]] Frame frame_of(std::size_t which) const {
    const int end = static_cast<int>(both.runs[which].runs[0].trace.steps.size()) - 1;
    return {.step = is_answer ? end : both.shown[step].at[which]};
  }
  /// The second run ended in a step before the frame's.
  [[nodiscard]] bool second_has_ended() const {
    if (is_answer) return false;
    const std::vector<WideStep>& steps = both.runs[1].runs[0].trace.steps;
    const TwoRunsStep& now = both.shown[step];
    if (now.at[1] < 0 || static_cast<std::size_t>(now.at[1]) + 1 != steps.size()) return false;
    return steps.back().iteration < now.iteration || steps.back().phase < now.phase;
  }
  [[nodiscard]] double answer(std::size_t which) const {
    return which == 0 ? both.exact : both.answer("second-distance");
  }
  /// "the loop"
  [[nodiscard]] std::string name() const {
    if (!second.is_gjk()) return second.log ? "the logged run" : "the loop";
    std::string out = "the run";
    if (second.scalar) out += fmt::format(" in {}", name_of(*second.scalar));
    return second.has_rules() ? out + " with " + second.rules() : out;
  }
  [[nodiscard]] std::string short_name() const {
    if (second.has_rules()) return "second";
    if (second.scalar) return std::string(name_of(*second.scalar));
    return second.log ? "log" : "loop";
  }
  [[nodiscard]] std::string first_name() const {
    return is_in_scalars() ? fmt::format("the run in {}", name_of(both.runs[0].lesson.scalar))
                           : "GJK";
  }
  /// The runs differ in their numbers alone.
  [[nodiscard]] bool is_in_scalars() const { return second.scalar && !second.has_rules(); }
  [[nodiscard]] const std::optional<judging::Finding>& wrong() const {
    return both.judgement->wrong;
  }
  /// The share that rounding may make of an answer. Between runs in two scalars it is the point.
  [[nodiscard]] double rounding() const {
    const ScalarKind scalar = both.runs[1].lesson.scalar;
    const bool is_rounded = second.has_rules() && !second.scalar;
    if (is_rounded && scalar == ScalarKind::single) return 1e-5;
    return is_rounded && scalar == ScalarKind::half ? 1e-1 : 1e-12;
  }
  /// An error that is more than rounding.
  [[nodiscard]] bool errs() const {
    return !(both.answer("error") <= rounding() * std::max(both.exact, answer(1)));
  }
  [[nodiscard]] const Mistake& mistake() const { return mistake_called(second.mistake); }

  const TwoRunsTrace& both;
  const LessonSecond& second;
  int step;
  bool is_answer;
};

// ---- the words ----

/// With true minus signs and powers of ten.
std::string in_type(std::string_view text) {
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == 'e' && i > 0 && is_digit(i - 1) && is_digit(i + 2)) {
      std::size_t end = i + 2;
      while (is_digit(end)) ++end;
      out += "·10" + raised(std::stoi(std::string(text.substr(i + 1, end - i - 1))));
      i = end - 1;
    } else if (text[i] == '-' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '(')) {
      out += "−";
    } else {
      out += text[i];
    }
  }
  return out;
}

/// The symptom: the answers of both.
std::string answers(const Shown& shown, const Numbers& numbers) {
  const std::string name = capitalized(shown.name());
  const int mine = shown.both.runs[0].runs[0].trace.result.iterations;
  const int others = shown.both.runs[1].runs[0].trace.result.iterations;
  if (!shown.errs()) {
    if (others <= mine)
      return fmt::format("{} answers as {} does: the distance is {}.", name, shown.first_name(),
                         numbers(shown.answer(0)));
    const WideResult& second = shown.both.runs[1].runs[0].trace.result;
    if (second.stop == gjk::StopReason::iteration_cap) {
      return fmt::format(
          "{} finds the distance {}, but goes on, and is cut off after {} iterations; {} makes {}.",
          name, numbers(shown.answer(1)), others, shown.first_name(), mine);
    }
    return fmt::format("{} finds the distance {}, but goes on: it makes {} iterations, {} {}.",
                       name, numbers(shown.answer(1)), others, shown.first_name(), mine);
  }
  const std::string is = fmt::format("{} answers {}; the distance is {}.", name,
                                     numbers(shown.answer(1)), numbers(shown.answer(0)));
  return fmt::format("{} The error is {}.", is, numbers(shown.both.answer("error")));
}

/// The place of the second run.
std::string second_step(const Shown& shown, const Numbers& numbers) {
  const std::size_t at = static_cast<std::size_t>(shown.step);
  const TwoRunsStep& step = shown.both.shown[at];
  const LessonRun& run = shown.both.runs[1];
  const WideState& state = run.state(shown.frame_of(1));
  const std::string name = capitalized(shown.name());
  if (shown.second_has_ended()) {
    return fmt::format("{} has ended, with the distance {}.", name, numbers(shown.answer(1)));
  }
  if (step.phase == Phase::closest)
    return fmt::format("{}: P = {}, {} from the origin.", name, numbers.point(state.p),
                       numbers(std::sqrt(state.p_sq)));
  if (state.d.isZero()) return fmt::format("{}: d = 0, and it goes on.", name);
  return fmt::format("{}: d = {}, and the support point is {}.", name, numbers.point(state.d),
                     run.pair_name(state.support.pair));
}

void words(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  if (const std::string why = why_not_drawn(story.positioned); !why.empty()) {
    text.caption = fmt::format("There are no two runs: {}.", why);
    return;
  }
  if (!shown.both.fits && shown.second.is_gjk()) {
    text.caption = fmt::format("{} has no numbers for these shapes. Both views show {}.",
                               capitalized(shown.name()), shown.first_name());
    return;
  }
  if (!shown.both.fits) {
    text.caption = "The log is about these shapes where they stood before. Both views show GJK.";
    text.detail = "Undo the change to see the logged run.";
    return;
  }
  const Numbers& numbers = story.numbers;
  if (shown.is_answer) {
    text.caption = answers(shown, numbers);
    if (story.frame.step < 0) {
      text.detail = shown.second.is_gjk()
                        ? std::string("Follow both runs, and find the step in which they part.")
                        : fmt::format("Follow both runs, and find the step in which {} goes wrong.",
                                      shown.name());
    } else if (!shown.second.mistake.empty()) {
      text.detail = std::string(shown.mistake().meaning);
    } else if (shown.both.judgement && shown.both.judgement->right()) {
      text.detail = "No step of the log is wrong.";
    }
    return;
  }
  auto& effects = story.effects.get<EffectsOfTwoRuns>(story.frame);
  FrameText first;
  captions::step(Story(shown.both.runs[0], *effects[0], shown.frame_of(0)), first);
  if (shown.step == shown.both.parting) {
    const std::string gjk = fmt::format("{}: {}", capitalized(shown.first_name()), first.caption);
    if (!shown.both.judgement || !shown.wrong()) {
      text.caption = fmt::format("Here the runs part. {}", second_step(shown, numbers));
      text.detail = gjk;
      return;
    }
    // The finding, and what follows from it.
    const std::string what = in_type(shown.wrong()->what);
    const std::size_t end = std::min(what.find("; "), what.find(". "));
    text.caption =
        fmt::format("{} goes wrong here: {}.", capitalized(shown.name()), what.substr(0, end));
    text.detail = end == std::string::npos ? gjk : capitalized(what.substr(end + 2)) + ".";
    return;
  }
  text.caption = first.caption;
  const bool same = shown.both.parting < 0 || shown.step < shown.both.parting;
  text.detail = same ? "Both runs do the same." : second_step(shown, numbers);
  if (!same) text.caption = fmt::format("{}: {}", capitalized(shown.first_name()), first.caption);
}

void values(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  text.values.emplace_back("distance", story.numbers(shown.answer(0)));
  text.values.emplace_back("second distance", story.numbers(shown.answer(1)));
}

// ---- the question ----

constexpr AskInfo kAskWrong{"wrong", "what the second run gets wrong where the runs part"};
constexpr AskInfo kAskLine{"line", "the line of the textbook's page that the loop changes"};
constexpr std::array kAsks = {kAskWrong, kAskLine};
constexpr std::array<std::pair<Phase, std::string_view>, 4> kChoices = {
    {{Phase::closest, "P, and the vertices kept for it"},
     {Phase::direction, "d"},
     {Phase::support, "V, the support point"},
     {Phase::stop, "whether to stop"}}};
constexpr std::string_view kNoDifference = "a vertex of S";

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  const int parting = shown.both.parting;
  if (question.ask == kAskWrong.name) return parting >= 0 && frame.step == parting ? parting : -1;
  return shown.is_answer && parting >= 0 && !shown.second.mistake.empty() ? shown.both.steps() - 1
                                                                          : -1;
}

/// The picture asks: it shows the step.
Frame asking(const LessonRun&, const Frame& frame) { return frame; }

/// As a choice, without the semicolon.
std::string as_choice(std::string_view line) {
  return std::string(line.substr(0, line.find_last_not_of(';') + 1));
}

/// The line, and two that other loops change.
void ask_line(const Shown& shown, FrameText& text) {
  constexpr std::size_t kChosen = 3;
  std::vector<std::string> lines;
  for (const Mistake& each : mistakes().subspan(1)) {
    if (std::find(lines.begin(), lines.end(), as_choice(each.line)) == lines.end())
      lines.push_back(as_choice(each.line));
  }
  const std::string changed = as_choice(shown.mistake().line);
  const auto at =
      static_cast<std::size_t>(std::find(lines.begin(), lines.end(), changed) - lines.begin());
  const std::size_t before = (at + at / 3 + 1) % kChosen;  // the place of the right one varies
  FrameQuestion& asked =
      text.question.emplace(FrameQuestion{std::string(kAskLine.name), {}, changed});
  for (std::size_t i = 0; i < kChosen; ++i)
    asked.choices.push_back(lines[(at + lines.size() - before + i) % lines.size()]);
  text.caption = "Question: which line of the textbook's page does the loop change?";
}

void question(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  if (shown.is_answer) return ask_line(shown, text);
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskWrong.name), {}, {}});
  const TwoRunsStep& step = shown.both.shown[shown.both.parting];
  Phase wrong = step.phase == Phase::drop ? Phase::closest : step.phase;
  // Along d = 0 there is nothing to look for: the run is over.
  if (wrong == Phase::direction && shown.both.runs[1].state(shown.frame_of(1)).d.isZero())
    wrong = Phase::stop;
  for (const auto& [phase, choice] : kChoices) {
    asked.choices.emplace_back(choice);
    if (phase == wrong) asked.answer = choice;
  }
  asked.choices.emplace_back(kNoDifference);
  if (shown.both.judgement && shown.wrong() && shown.wrong()->part == Part::vertex)
    asked.answer = kNoDifference;
  text.caption =
      shown.second.is_gjk()
          ? "Question: here the runs differ for the first time. In what?"
          : fmt::format(
                "Question: this is the first step in which {} goes wrong. Which part of it is it?",
                shown.name());
}

// ---- the stage ----

/// How far the second answer is from the distance, on the way from the one closest point to the
/// other.
void draw_error(SceneBuilder& scene) {
  const Shown shown(scene.run, scene.frame);
  if (!shown.both.fits || !shown.errs() || !std::isfinite(shown.answer(1))) return;
  const WideResult& first = shown.both.runs[0].runs[0].trace.result;
  const Vector3d& x = first.x;
  Vector3d difference = first.y - x;
  if (difference.isZero()) difference = shown.both.runs[1].state(shown.frame_of(1)).p;
  if (difference.isZero()) return;
  difference.normalize();
  const Vector3d base = scene.view.kind == ViewKind::world ? x : Vector3d(Vector3d::Zero());
  const Point from = scene.at(base + shown.answer(0) * difference);
  const Point to = scene.at(base + shown.answer(1) * difference);
  scene.line("second.error", from, to);
  const double error = shown.both.answer("error");
  scene.length_label("error", error, from, to);
}

FrameInView in_view(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                    std::size_t view) {
  const Shown shown(run, frame);
  const std::size_t which = view + 1 == run.lesson.views.size() ? 1 : 0;
  return {&shown.both.runs[which], effects.get<EffectsOfTwoRuns>(frame)[which].get(),
          shown.frame_of(which), which == 1 && shown.is_answer ? draw_error : nullptr};
}

/// Layers and views of the runs draw it.
void stage(SceneBuilder&) {}

// ---- the panel ----

void both_runs(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  auto& effects = panel.effects.get<EffectsOfTwoRuns>(panel.frame);
  const Frame frame = shown.frame_of(0);
  const LessonRun& first = shown.both.runs[0];
  const LessonRun& second = shown.both.runs[1];
  PanelBuilder inner(first, *effects[0], frame, panel.fonts, {});
  inner.left = panel.left;
  inner.right = panel.right;
  inner.y = panel.y;
  const Frame beside = shown.frame_of(1);
  const WideState* state = beside.step < 0 ? nullptr : &second.state(beside);
  const std::string name =
      shown.is_in_scalars() ? std::string(name_of(first.lesson.scalar)) : std::string("GJK");
  // Rounding is the point of runs in two scalars alone.
  constexpr double kRounding = 1e-9;
  blocks::two_columns(
      inner,
      {blocks::RunColumn{name, first.runs[0], &inner.state, inner.numbers},
       blocks::RunColumn{shown.short_name(), second.runs[0], state, Numbers(second.lesson)}},
      shown.is_in_scalars() ? 0.0 : std::max(kRounding, shown.rounding()));
  panel.y = inner.y;
  std::move(inner.marks.begin(), inner.marks.end(), std::back_inserter(panel.marks));
}

void two_answers(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  panel.heading("Answers");
  panel.row("distance", panel.numbers(shown.answer(0)));
  panel.row(shown.second.has_rules() ? "the second run's answer"
                                     : fmt::format("as {} answers", shown.name()),
            panel.numbers(shown.answer(1)));
  panel.row(shown.errs() ? "error" : "difference", panel.numbers(shown.both.answer("error")));
}

/// From the step on that is wrong, or where the lesson asks for it from the answer on: before, it
/// would tell.
void changed_line(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  if (shown.second.mistake.empty() || shown.step < shown.both.parting || shown.step < 0) return;
  if (panel.run.lesson.asks(kAskLine.name) && !shown.is_answer) return;
  panel.heading("The line that is changed");
  const auto lines = [&](const std::string& sign, std::string_view text) {
    constexpr double kSign = 20.0;
    panel.write("code", panel.left, sign, type::kCode);
    for (const std::string& line :
         wrapped(panel.fonts, type::kCode, std::string(text), panel.right - panel.left - kSign)) {
      panel.write("code", panel.left + kSign, line, type::kCode);
      panel.y += rows::kTightRow;
    }
  };
  const Mistake& mistake = shown.mistake();
  lines("−", mistake.line);
  lines("+", mistake.by.empty() ? "(nothing)" : mistake.by);
}

const Tour kTour{
    .name = "two-runs",
    .meaning =
        "step of two runs about the same shapes, as long as both go on, and two iterations more",
    .needs = {.settings = &LessonSecond::kKind,
              .path = PathUse::refused,
              .most_vertices = 1000,
              .shown_of = ShownOf::both,
              .why_no_until = "frames show how both runs end"},
    .add_frames = add_algorithm_frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .asking = asking,
    .algorithm = &kTwoRunsAlgorithm,
    .position = position_in_algorithm,
    .tick = tick_of_algorithm,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
    .in_view = in_view,
};

const Block kBothRuns{.name = "both-runs",
                      .meaning = "the numbers of both runs, and where they differ",
                      .write = both_runs,
                      .tour = kTour.name,
                      .shown_of = ShownOf::both};
const Block kTwoAnswers{.name = "two-answers",
                        .meaning = "the distance, the second run's answer and its error",
                        .write = two_answers,
                        .tour = kTour.name,
                        .shown_of = ShownOf::both};
const Block kChangedLine{.name = "changed-line",
                         .meaning = "the line of the textbook's page that the second run changes",
                         .write = changed_line,
                         .tour = kTour.name};
const EffectInfo kEffects = effect_info<EffectsOfTwoRuns>(
    "frame", "the effects of each of two runs that stand side by side", kTour.name);

}  // namespace
}  // namespace gjkscope::two_runs

namespace gjkscope {

const SubjectParts subjects::two_runs{
    .tours = {&gjkscope::two_runs::kTour},
    .blocks = {&gjkscope::two_runs::kBothRuns, &gjkscope::two_runs::kTwoAnswers,
               &gjkscope::two_runs::kChangedLine},
    .effects = {&gjkscope::two_runs::kEffects},
    .legend = {{"second.error", "error of the answer"}},
};

}  // namespace gjkscope
