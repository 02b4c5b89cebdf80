#include "subjects/two_runs/lesson_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "lesson/names.hpp"
#include "mistakes/mistakes.hpp"
#include "picture/words.hpp"
#include "run/fields.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/second_run/second_run.hpp"
#include "subjects/two_runs/logged_run.hpp"

namespace gjkscope {
namespace {

using fields::Json;
using gjk::Phase;
using judging::Part;

constexpr std::array<std::string_view, gjk::kPhaseCount> kPhases = {
    name_of(Phase::closest), name_of(Phase::drop), name_of(Phase::direction),
    name_of(Phase::support), name_of(Phase::stop), name_of(Phase::add)};
constexpr std::array<std::string_view, 2> kAnswers = {"second-distance", "error"};
constexpr std::array<PlaceholderInfo, 2> kValues = {
    {{"distance", "distance of the shapes"},
     {"second distance", "distance that the second run answers"}}};

/// A lesson of one run, whose frames are those of its steps.
LessonRun alone(const Lesson& lesson, PositionedRun positioned) {
  LessonRun out;
  out.lesson = lesson;
  out.lesson.tour = tours::kPhase.name;
  out.lesson.settings = {};
  out.lesson.questions.clear();
  out.tour = &tours::kPhase;
  out.algorithm_traces.push_back(kGjkAlgorithm.run(lesson, positioned, nullptr));
  out.runs.push_back(std::move(positioned));
  tours::kPhase.add_frames(out, 0);
  return out;
}

Phase phase_of(Part part) {
  switch (part) {
    case Part::drop:
      return Phase::drop;
    case Part::direction:
      return Phase::direction;
    case Part::support:
      return Phase::support;
    case Part::stop:
    case Part::answer:
      return Phase::stop;
    default:
      return Phase::closest;
  }
}

/// Whether two runs of this GJK take another decision in a step.
bool differs(const WideStep& a, const WideStep& b) {
  if (a.phase == Phase::support) return a.after.support.pair != b.after.support.pair;
  if (a.phase == Phase::closest) return a.after.region != b.after.region;
  return a.phase == Phase::stop &&
         (a.after.stop == gjk::StopReason::running) != (b.after.stop == gjk::StopReason::running);
}

/// The phase in which the runs part: where the wrong vertices are kept, P may be wrong before.
Phase blamed_phase(const judging::Finding& wrong, const std::array<const WideTrace*, 2>& traces) {
  const Phase phase = phase_of(wrong.part);
  if (phase != Phase::drop) return phase;
  std::array<Eigen::Vector3d, 2> p;
  for (std::size_t k = 0; k < 2; ++k) {
    const int at = index_of_step(*traces[k], wrong.iteration, Phase::closest);
    if (at < 0) return phase;
    p[k] = traces[k]->steps[at].after.p;
  }
  constexpr double kSame = 1e-9;
  return (p[0] - p[1]).norm() > kSame * (p[0].norm() + p[1].norm()) ? Phase::closest : phase;
}

void find_shown(TwoRunsTrace& out) {
  constexpr int kAfter = 2;  // iterations that are shown after the one in which they part
  const std::array<const WideTrace*, 2> traces = {&out.runs[0].runs[0].trace,
                                                  &out.runs[1].runs[0].trace};
  int last = std::max(traces[0]->result.iterations, traces[1]->result.iterations);
  const auto blamed = out.judgement ? out.judgement->wrong : std::nullopt;
  const Phase wrong_phase = blamed ? blamed_phase(*blamed, traces) : Phase::stop;
  for (int iteration = 1; iteration <= last; ++iteration) {
    for (const Phase phase :
         {Phase::closest, Phase::drop, Phase::direction, Phase::support, Phase::stop}) {
      TwoRunsStep step{iteration, phase, {}};
      std::array<bool, 2> has{};
      for (std::size_t k = 0; k < 2; ++k) {
        has[k] = index_of_step(*traces[k], iteration, phase) >= 0;
        step.at[k] = index_up_to(*traces[k], iteration, phase);
      }
      const bool is_blamed = blamed && blamed->iteration == iteration && wrong_phase == phase;
      if (!has[0] && !has[1] && !is_blamed) continue;
      const auto step_of = [&](std::size_t k) -> const WideStep& {
        return traces[k]->steps[step.at[k]];
      };
      const bool parts =
          out.parting < 0 &&
          (is_blamed || (!blamed && (has[0] != has[1] || differs(step_of(0), step_of(1)))));
      const bool is_plain = phase == Phase::closest || phase == Phase::support;
      const bool ends_one =
          phase == Phase::stop && has[0] && has[1] && differs(step_of(0), step_of(1));
      if (!is_plain && !parts && !ends_one) continue;
      if (parts) {
        out.parting = static_cast<int>(out.shown.size());
        last = std::min(last, iteration + kAfter);
      }
      out.shown.push_back(step);
    }
  }
}

std::shared_ptr<const AlgorithmTrace> run_both(const Lesson& lesson, const PositionedRun& run,
                                               const AlgorithmTrace*) {
  auto out = std::make_shared<TwoRunsTrace>();
  const LessonSecond& second = *second_of(lesson);
  out->exact = run.trace.result.distance;
  if (!why_not_drawn(run).empty()) {
    out->runs = {alone(lesson, run), alone(lesson, run)};
    return out;
  }
  if (second.is_gjk()) {
    const PositionedRun other = second_of_gjk(second, run, lesson.options, lesson.scalar);
    out->fits = why_not_drawn(other).empty();
    out->runs = {alone(lesson, run), alone(lesson, out->fits ? other : run)};
    if (out->fits) find_shown(*out);
    return out;
  }
  judging::Log log;
  if (second.log) {
    log = *second.log;
    out->fits = log.x == run.x().world && log.y == run.y().world;
  } else {
    log = mistake_called(second.mistake).log_of(in_plane(run.x().world), in_plane(run.y().world));
  }
  if (!out->fits) {
    out->runs = {alone(lesson, run), alone(lesson, run)};
    return out;
  }
  constexpr int kDigits = 4;
  log.digits = kDigits;
  log.x_names = lesson.x().vertex_names;
  log.y_names = lesson.y().vertex_names;
  log.x_name = lesson.x().name;
  log.y_name = lesson.y().name;
  out->judgement = judging::judge(log);
  out->exact = out->judgement->distance;
  gjk::Options options = lesson.options;
  if (!out->judgement->steps.empty() && !out->judgement->steps.front().simplex.empty()) {
    const auto& pairs = out->judgement->steps.front().simplex;
    options.start.count = static_cast<int>(std::min<std::size_t>(pairs.size(), 3));
    std::copy_n(pairs.begin(), options.start.count, options.start.pairs.begin());
  }
  const bool is_cut_off = !second.log && log.iterations.size() == kMostIterations;
  out->runs = {alone(lesson, run_again(run, options, lesson.scalar)),
               alone(lesson, logged_run(log, *out->judgement, run,
                                        is_cut_off ? gjk::StopReason::iteration_cap
                                                   : gjk::StopReason::not_nearer))};
  find_shown(*out);
  return out;
}

}  // namespace

const Algorithm kTwoRunsAlgorithm{
    .name = "two-runs", .phases = kPhases, .answers = kAnswers, .values = kValues, .run = run_both};

StepInfo TwoRunsTrace::info(int step) const {
  const TwoRunsStep& at = shown[step];
  return {at.iteration, name_of(at.phase), step == parting};
}

double TwoRunsTrace::answer(std::string_view name) const {
  const double second = runs[1].runs[0].trace.result.distance;
  return name == "error" ? std::abs(second - exact) : second;
}

Json TwoRunsTrace::json(const Lesson& lesson, const PositionedRun&) const {
  Json out;
  const LessonSecond& second = *second_of(lesson);
  out["second"] = second.log        ? "log"
                  : second.scalar   ? std::string(name_of(*second.scalar))
                  : second.is_gjk() ? second.rules()
                                    : second.mistake;
  if (!fits) {
    out["refused"] = second.log ? "the log is about other shapes" : "no run in this scalar";
    return out;
  }
  const auto point = [&](const Eigen::Vector3d& v) {
    return fields::point(v.head(lesson.dimension));
  };
  out["steps"] = Json::array();
  for (const TwoRunsStep& step : shown) {
    Json each;
    each["iteration"] = step.iteration;
    each["phase"] = name_of(step.phase);
    for (std::size_t k = 0; k < 2; ++k) {
      const WideState& state = step.at[k] < 0 ? runs[k].runs[0].trace.initial
                                              : runs[k].runs[0].trace.steps[step.at[k]].after;
      Json side;
      side["P"] = point(state.p);
      if (step.phase >= Phase::direction) side["d"] = point(state.d);
      if (step.phase >= Phase::support) side["support"] = runs[k].pair_name(state.support.pair);
      each[k == 0 ? "first" : "second_run"] = side;
    }
    out["steps"].push_back(each);
  }
  if (parting >= 0) {
    const TwoRunsStep& at = shown[parting];
    out["they_part"] = fmt::format("iteration {}, {}", at.iteration, name_of(at.phase));
  }
  if (judgement && judgement->wrong) out["wrong"] = judgement->wrong->what;
  out["distance"] = fields::number(exact);
  out["second_distance"] = fields::number(answer("second-distance"));
  out["error"] = fields::number(answer("error"));
  return out;
}

const TwoRunsTrace& two_runs_of(const LessonRun& run, const Frame& frame) {
  return dynamic_cast<const TwoRunsTrace&>(run.algorithm_trace(frame));
}

}  // namespace gjkscope
