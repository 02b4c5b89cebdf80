// The cost of time steps: the state of scenes with a clock against the size of the step. An
// argument: the id of one lesson.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/decimal.hpp"
#include "shipped_lessons.hpp"
#include "study/interleave.hpp"
#include "subjects/balance/balance.hpp"
#include "subjects/balance/table.hpp"
#include "subjects/study/results.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

using study::Contestant;

constexpr std::size_t kRepetitions = 15;

/// A step of the simulation of a beam (subjects/balance/balance.hpp), or between the positions of
/// shapes that move.
struct TimeStepCost {
  std::string lesson;
  double step = 0.0;        ///< Seconds.
  bool is_shown = false;    ///< It is the lesson's own.
  double error = 0.0;       ///< Error of a beam's angle at the lesson's moments, the largest over
                            ///< its runs, in radians, against steps of kFinestStep. Of a motion:
                            ///< of the place of a vertex at the moments that the coarsest step
                            ///< shares with the others, in the world's unit, against the finest.
  double iterations = 0.0;  ///< On average over the runs of a motion,
  double cold_iterations = 0.0;  ///< and when each run starts anew.
  study::Quartiles ns;           ///< For each second that passes in the scene.
};

inline constexpr double kFinestStep = 0x1p-18;

std::vector<TimeStepCost> timed(std::vector<TimeStepCost> rows,
                                const std::vector<Contestant>& contestants, double seconds) {
  const std::vector<study::Timing> timings = study::interleave(contestants, 1, kRepetitions);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const study::Quartiles all = study::quartiles(timings[i].ns);
    rows[i].ns = {all.low / seconds, all.median / seconds, all.high / seconds};
  }
  return rows;
}

/// The beams of a lesson: one for each run whose simplex is a segment.
std::vector<TimeStepCost> beams(const Lesson& lesson) {
  const LessonRun run = run_lesson(lesson);
  EffectGraph effects(run);
  struct BeamScene {
    int position;
    Balance::Value balance;
  };
  std::vector<BeamScene> scenes;
  for (int i = 0; i < static_cast<int>(run.runs.size()); ++i) {
    const auto frame = std::find_if(run.frames.begin(), run.frames.end(),
                                    [&](const Frame& each) { return each.run == i; });
    if (frame == run.frames.end()) continue;
    const Balance::Value& balance = effects.get<Balance>(*frame);
    if (!balance.moments.empty()) scenes.push_back({i, balance});
  }
  const LessonTime time = *lesson.settings.as<LessonTime>();
  const auto simulate = [time](const BeamScene& scene, double step) {
    return swing(scene.balance.masses, scene.balance.weights[1], time, scene.position, step);
  };
  std::vector<std::vector<Beam>> reference;
  for (const BeamScene& scene : scenes) reference.push_back(simulate(scene, kFinestStep));

  std::vector<TimeStepCost> rows;
  std::vector<Contestant> contestants;
  if (scenes.empty()) return rows;
  for (double step = 0x1p-4; step >= 0x1p-14; step /= 4.0) {
    TimeStepCost row;
    row.lesson = lesson.id;
    row.step = step;
    row.is_shown = step == kBeamStep;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const std::vector<Beam> moments = simulate(scenes[i], step);
      for (std::size_t k = 0; k < moments.size(); ++k) {
        row.error = std::max(row.error, std::abs(moments[k].angle - reference[i][k].angle));
      }
    }
    rows.push_back(std::move(row));
    contestants.push_back({[=] {
                             double sum = 0.0;
                             for (const BeamScene& scene : scenes) {
                               sum += simulate(scene, step).back().angle;
                             }
                             return sum;
                           },
                           {}});
  }
  return timed(std::move(rows), contestants, time.seconds * static_cast<double>(scenes.size()));
}

double average_iterations(const LessonRun& run) {
  long sum = 0;
  for (const PositionedRun& each : run.runs) sum += each.trace.result.iterations;
  return static_cast<double>(sum) / static_cast<double>(run.runs.size());
}

/// The lesson with `steps` steps of time.
Lesson in_steps(Lesson lesson, int steps) {
  lesson.path_of_shapes->frames = steps + 1;
  return lesson;
}

/// How far a vertex stands from where it stands with finer steps, at the moments of both.
double place_error(const LessonRun& run, const LessonRun& finest) {
  const std::size_t each = (finest.runs.size() - 1) / (run.runs.size() - 1);
  double out = 0.0;
  for (std::size_t i = 0; i < run.runs.size(); ++i) {
    const PositionedRun& a = run.runs[i];
    const PositionedRun& b = finest.runs[i * each];
    for (std::size_t k = 0; k < a.x().world.size(); ++k) {
      out = std::max(out, (a.x().world[k] - b.x().world[k]).norm());
    }
    for (std::size_t k = 0; k < a.y().world.size(); ++k) {
      out = std::max(out, (a.y().world[k] - b.y().world[k]).norm());
    }
  }
  return out;
}

/// Steps twice as coarse as the lesson's up to 16 times as fine.
std::vector<TimeStepCost> motions(const Lesson& lesson) {
  const int own = lesson.path_of_shapes->frames - 1;
  const double seconds = *lesson.path_of_shapes->seconds;
  constexpr int kFiner = 16;
  Lesson cold = lesson;
  cold.warm_start = false;
  const LessonRun finest = run_lesson(in_steps(lesson, own * kFiner));
  std::vector<TimeStepCost> rows;
  std::vector<Contestant> contestants;
  for (int twice = 1; twice <= 2 * kFiner; twice *= 2) {
    const int steps = own * twice / 2;
    if (steps < 1 || own * kFiner % steps != 0) continue;
    const Lesson stepped = in_steps(lesson, steps);
    const LessonRun run = run_lesson(stepped);
    TimeStepCost row;
    row.lesson = lesson.id;
    row.step = seconds / steps;
    row.is_shown = steps == own;
    row.error = place_error(run, finest);
    row.iterations = average_iterations(run);
    row.cold_iterations = average_iterations(run_lesson(in_steps(cold, steps)));
    rows.push_back(std::move(row));
    contestants.push_back(
        {[=] { return static_cast<double>(run_lesson(stepped).runs.size()); }, {}});
  }
  return timed(std::move(rows), contestants, seconds);
}

/// Rows from the largest step to the smallest; none of a lesson without a clock.
std::vector<TimeStepCost> time_step_costs(const Lesson& lesson) {
  if (lesson.settings.as<LessonTime>()) return beams(lesson);
  const bool moves = lesson.path_of_shapes && lesson.path_of_shapes->seconds;
  return moves ? motions(lesson) : std::vector<TimeStepCost>();
}

void print_head() {
  fmt::print(
      "error: of a beam's angle, in radians, against steps of {} s; of a moving vertex, in the "
      "world's unit,\nagainst the finest step. time: for each second that passes in the scene. * "
      "the lesson's own step.\n\n  {:<20} {:>12} {:>9} {:>10} {:>10} {:>6} {:>6}\n",
      kFinestStep, "lesson", "step", "error", "order", "time", "warm", "cold");
}

void print(const std::vector<TimeStepCost>& rows) {
  const TimeStepCost* before = nullptr;
  for (const TimeStepCost& row : rows) {
    // By which power of the step the error falls.
    const bool has_order =
        before != nullptr && row.error > 0.0 && before->error > 0.0 && row.iterations == 0.0;
    const std::string order = has_order
                                  ? fmt::format("{:.1f}", std::log(before->error / row.error) /
                                                              std::log(before->step / row.step))
                                  : "";
    const auto iterations = [&](double value) {
      return row.iterations > 0.0 ? fmt::format("{:.2f}", value) : std::string();
    };
    fmt::print("{} {:<20} {:>10.5g} s {:>9} {:>10} {:>10} {:>6} {:>6}\n", row.is_shown ? '*' : ' ',
               row.lesson, row.step, error_text(row.error), order, time_text(row.ns.median),
               iterations(row.iterations), iterations(row.cold_iterations));
    before = &row;
  }
}

}  // namespace
}  // namespace gjkscope

int main(int count, char** arguments) {
  using namespace gjkscope;
  print_head();
  for (const Lesson& lesson : bench::shipped_lessons())
    if (count == 1 || lesson.id == arguments[1]) print(time_step_costs(lesson));
}
