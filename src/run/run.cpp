#include "run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "exact/instances.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/vocabulary.hpp"
#include "run/query.hpp"
#include "run/questions.hpp"
#include "run/trail.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;

template <class S, int D>
std::vector<Eigen::Vector3d> world_vertices(const gjk::Shape<S, D>& shape) {
  std::vector<Eigen::Vector3d> out;
  for (const gjk::Vec<S, D>& vertex : shape.vertices()) {
    out.push_back(
        widened<S, D>(gjk::Vec<S, D>(shape.pose.rotated(vertex) + shape.pose.translation)));
  }
  return out;
}

/// In the world's unit, as far as doubles reach.
template <class Real>
DistanceBounds in_world(const gjk::Bounds<Real>& bounds, int exponent) {
  const double largest = std::numeric_limits<double>::max();
  return {std::min(gjk::scaled_below(widened(bounds.lower), exponent), largest),
          gjk::scaled_above(widened(bounds.upper), exponent)};
}

/// A position of all shapes, and the time at which they are there.
struct Position {
  std::vector<Placement> placements{2};  ///< One for each body.
  double time = 0.0;
};

template <class S, int D, class BeforePhase = void (*)()>
PositionedRun run_query(
    const gjk::Query<S, D>& query, const gjk::Options& options, const Position& at,
    const BeforePhase& before_phase = [] {}) {
  const gjk::Trace<S, D> trace = gjk::trace<S>(query, options, before_phase);
  PositionedRun run{
      {{at.placements[0], world_vertices(query.x)}, {at.placements[1], world_vertices(query.y)}},
      at.time,
      trace.prepared.exponent,
      widened(trace),
      {}};
  for (const gjk::Step<S, D>& step : trace.steps)
    run.bounds.push_back(in_world(step.bounds, trace.prepared.exponent));
  if (!run.bounds.empty() && trace.result.error == gjk::Error::none)
    run.bounds.back() = {widened(trace.result.lower), widened(trace.result.upper)};
  return run;
}

/// The options with a start, where they have none: the one that `given` has in double. Coordinates
/// that are rounded to fewer digits could choose another.
template <int D>
gjk::Options with_start(gjk::Options options, const gjk::Query<double, D>& given) {
  if (options.start.count > 0) return options;
  const gjk::Prepared<double, D> prepared = gjk::prepare<double>(given, options);
  if (prepared.error != gjk::Error::none) return options;
  options.start = gjk::start(given, options, prepared).simplex.as_start();
  return options;
}

/// The shapes where they stand; GJK is not asked.
PositionedRun standing_at(const Lesson& lesson, const Position& at) {
  return with_query(lesson, at.placements, [&]<class S, int D>(const gjk::Query<S, D>& query) {
    PositionedRun run;
    run.bodies = {{at.placements[0], world_vertices(query.x)},
                  {at.placements[1], world_vertices(query.y)}};
    run.time = at.time;
    run.trace.dimension = D;
    return run;
  });
}

PositionedRun run_at(const Lesson& lesson, const Position& at, const gjk::Options& options) {
  const auto start = [&](const auto& given) { return with_start(options, given); };
  const gjk::Options started = lesson.dimension == 3
                                   ? with_query_in<double, 3>(lesson, at.placements, start)
                                   : with_query_in<double, 2>(lesson, at.placements, start);
  return with_query(lesson, at.placements, [&]<class S, int D>(const gjk::Query<S, D>& query) {
    return run_query<S, D>(query, started, at);
  });
}

/// Options that start from the final simplex of a run; as they are where it has none.
gjk::Options warm(gjk::Options options, const WideTrace& last) {
  if (last.result.simplex.count > 0) options.start = last.result.warm();
  return options;
}

/// Positions at equal steps along the polyline.
std::vector<Vector3d> along(const std::vector<Vector3d>& corners, int frames) {
  double length = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
  std::vector<Vector3d> out;
  for (int i = 0; i < frames; ++i) {
    double along = length * i / (frames - 1);
    std::size_t k = 1;
    while (k + 1 < corners.size() && along > (corners[k] - corners[k - 1]).norm()) {
      along -= (corners[k] - corners[k - 1]).norm();
      ++k;
    }
    const double edge = (corners[k] - corners[k - 1]).norm();
    const double t = edge > 0.0 ? std::min(along / edge, 1.0) : 0.0;
    out.push_back(corners[k - 1] + t * (corners[k] - corners[k - 1]));
  }
  return out;
}

/// The place of a shape at `part` of its motion, from 0 to 1: the corners come at equal times.
Placement placement_at(const LessonShape& shape, const LessonMotion& motion, double part) {
  Placement placement{shape.translate, shape.rotate_degrees, shape.axis};
  if (motion.points.size() < 2) return placement;
  const std::size_t legs = motion.points.size() - 1;
  const double leg = part * static_cast<double>(legs);
  const std::size_t k = std::min(static_cast<std::size_t>(leg), legs - 1);
  const double t = leg - static_cast<double>(k);
  placement.translate = motion.points[k] + t * (motion.points[k + 1] - motion.points[k]);
  if (!motion.turns.empty())
    placement.rotate_degrees = motion.turns[k] + t * (motion.turns[k + 1] - motion.turns[k]);
  return placement;
}

std::vector<Position> positions_of(const Lesson& lesson) {
  Position standing;
  for (std::size_t i = 0; i < lesson.bodies.size(); ++i)
    standing.placements[i] = {lesson.bodies[i].translate, lesson.bodies[i].rotate_degrees,
                              lesson.bodies[i].axis};
  if (!lesson.path_of_shapes) return {standing};
  const LessonPath& path = *lesson.path_of_shapes;
  std::vector<Position> out;
  if (path.seconds) {
    for (int i = 0; i < path.frames; ++i) {
      const double part = static_cast<double>(i) / (path.frames - 1);
      out.push_back({{}, part * *path.seconds});
      for (std::size_t k = 0; k < lesson.bodies.size(); ++k)
        out.back().placements.push_back(placement_at(lesson.bodies[k], path.motions[k], part));
    }
    return out;
  }
  const std::vector<Vector3d>& corners = path.x().points;
  const bool between_corners = path.frames > 0 && corners.size() > 1;
  for (const Vector3d& position : between_corners ? along(corners, path.frames) : corners) {
    out.push_back(standing);
    out.back().placements[0].translate = position;
  }
  return out;
}

/// Half a unit in the last digit of the shortest decimal that reads back as `value`: the precision
/// it was written with, but at least six decimals.
double written_precision(double value) {
  const std::string text =
      fmt::format("{}", value);  // the shortest that reads back: "12.5", "1e-07"
  const std::size_t e = std::min(text.find('e'), text.size());
  const std::size_t dot = text.find('.');
  const int decimals = dot == std::string::npos ? 0 : static_cast<int>(e - dot) - 1;
  const int exponent = e < text.size() ? std::stoi(text.substr(e + 1)) : 0;
  // A short number needed no more digits: at least kLeast decimals are taken as written.
  constexpr int kLeast = 6;
  return 0.5 * std::pow(10.0, exponent - std::max(decimals, kLeast));
}

}  // namespace

Eigen::Matrix3d turn_of(const Placement& placement) {
  using Long = Eigen::Matrix<long double, 3, 1>;
  const long double angle = placement.rotate_degrees * std::numbers::pi / 180.0;
  const long double c = std::cos(angle);
  const long double s = std::sin(angle);
  const Long a = placement.axis.cast<long double>().normalized();
  Eigen::Matrix<long double, 3, 3> cross;
  cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  const Eigen::Matrix<long double, 3, 3> turn =
      c * Eigen::Matrix<long double, 3, 3>::Identity() + s * cross + (1 - c) * (a * a.transpose());
  return turn.cast<double>();
}

int last_step(const Lesson& lesson, const WideTrace& trace) {
  if (lesson.until) {
    for (int i = 0; i < static_cast<int>(trace.steps.size()); ++i) {
      if (trace.steps[i].phase == *lesson.until) return i;
    }
  }
  return static_cast<int>(trace.steps.size()) - 1;
}

int support_calls(const WideTrace& trace) {
  return static_cast<int>(
      std::count_if(trace.steps.begin(), trace.steps.end(),
                    [](const auto& step) { return step.phase == gjk::Phase::support; }));
}

std::vector<Placement> placements_of(const PositionedRun& run) {
  std::vector<Placement> placements;
  for (const Body& body : run.bodies) placements.push_back(body.placement);
  return placements;
}

std::string why_not_drawn(const PositionedRun& run) {
  if (const gjk::Error error = run.trace.result.error; error != gjk::Error::none)
    return fmt::format("the run is refused: {}", name_of(error));
  const auto finite = [](const Eigen::Vector3d& vertex) { return vertex.allFinite(); };
  if (!std::all_of(run.bodies.begin(), run.bodies.end(), [&](const Body& body) {
        return std::all_of(body.world.begin(), body.world.end(), finite);
      }))
    return "a vertex stands outside the range of the scalar";
  if (run.trace.exponent != 0) return "squares of the shapes' sizes leave the range of a double";
  return {};
}

int LessonRun::gjk_step(const Frame& frame) const {
  return tour->algorithm == &kGjkAlgorithm ? frame.step : last_step(lesson, run(frame).trace);
}

const WideState& LessonRun::state(const Frame& frame) const {
  return gjk_step(frame) < 0 ? run(frame).trace.initial : step(frame).after;
}

const WideStep& LessonRun::step(const Frame& frame) const {
  return run(frame).trace.steps[gjk_step(frame)];
}

StepInfo LessonRun::info(const Frame& frame) const {
  if (frame.step < 0) return {0, "start"};
  if (is_trail(frame)) return {run(frame).trace.result.iterations, "trail", true};
  const AlgorithmTrace& trace = algorithm_trace(frame);
  if (frame.step < trace.steps()) return trace.info(frame.step);
  return {trace.info(trace.steps() - 1).iteration, "answer", true};
}

int LessonRun::answering_iteration(const Frame& frame) const {
  return info({.run = frame.run, .step = frame.answering_step}).iteration;
}

bool has_pair(const WideSimplex& simplex, gjk::VertexPair pair) {
  return std::any_of(simplex.vertices.begin(), simplex.vertices.begin() + simplex.count,
                     [&](const auto& vertex) { return vertex.pair == pair; });
}

const DistanceBounds& LessonRun::bounds(const Frame& frame) const {
  return run(frame).bounds[gjk_step(frame)];
}

std::string pair_name(const std::vector<std::string>& x_names,
                      const std::vector<std::string>& y_names, gjk::VertexPair pair) {
  const std::string& y = y_names[pair.y];
  return x_names.size() == 1 ? y : y + "−" + x_names[pair.x];
}

std::string LessonRun::pair_name(gjk::VertexPair pair) const {
  return gjkscope::pair_name(lesson.x().vertex_names, lesson.y().vertex_names, pair);
}

template <int D>
PositionedRun run_case(const CaseIn<D>& shapes, ScalarKind scalar) {
  const gjk::Options options = with_start<D>({}, {{shapes.a}, {shapes.b}});
  return with_scalar(scalar, [&]<class S>(std::type_identity<S>) {
    const std::vector<gjk::Vec<S, D>> x = narrowed_all<S, D>(shapes.a);
    const std::vector<gjk::Vec<S, D>> y = narrowed_all<S, D>(shapes.b);
    return run_query<S, D>({{x}, {y}}, options, {});
  });
}
template PositionedRun run_case(const CaseIn<2>& shapes, ScalarKind scalar);
template PositionedRun run_case(const CaseIn<3>& shapes, ScalarKind scalar);

LessonRun run_lesson(Lesson lesson, const Tour& tour) {
  LessonRun run;
  run.lesson = std::move(lesson);
  run.tour = &tour;
  for (const Position& position : positions_of(run.lesson)) {
    const bool is_warm = run.lesson.warm_start && !run.runs.empty();
    const gjk::Options& cold = run.lesson.options;
    run.runs.push_back(
        tour.algorithm->takes_outlines
            ? standing_at(run.lesson, position)
            : run_at(run.lesson, position, is_warm ? warm(cold, run.runs.back().trace) : cold));
    const AlgorithmTrace* before =
        run.algorithm_traces.empty() ? nullptr : run.algorithm_traces.back().get();
    run.algorithm_traces.push_back(tour.algorithm->run(run.lesson, run.runs.back(), before));
  }
  for (int i = 0; i < static_cast<int>(run.runs.size()); ++i) tour.add_frames(run, i);
  add_question_frames(run);
  return run;
}

Case case_of(const PositionedRun& run) {
  return {in_plane(run.x().world), in_plane(run.y().world)};
}

Case case_of(const Lesson& lesson) {
  return case_of(standing_at(lesson, positions_of(lesson).front()));
}

PositionedRun run_afresh(const LessonRun& run, int index) {
  const PositionedRun& positioned = run.runs[index];
  return run_at(run.lesson, {placements_of(positioned), positioned.time}, run.lesson.options);
}

gjk::Options started_as(const PositionedRun& run, gjk::Options options) {
  options.start = run.trace.initial.simplex.as_start();
  return options;
}

namespace {

template <int D>
PositionedRun run_again_in(const PositionedRun& run, const gjk::Options& options, ScalarKind scalar,
                           const std::function<void()>& before_phase) {
  const std::vector<gjk::Vec<double, D>> a = narrowed_all<double, D>(run.x().world);
  const std::vector<gjk::Vec<double, D>> b = narrowed_all<double, D>(run.y().world);
  const gjk::Options started = with_start<D>(options, {{a}, {b}});
  return with_scalar(scalar, [&]<class S>(std::type_identity<S>) {
    const std::vector<gjk::Vec<S, D>> x = narrowed_all<S, D>(run.x().world);
    const std::vector<gjk::Vec<S, D>> y = narrowed_all<S, D>(run.y().world);
    return run_query<S, D>({{x}, {y}}, started, {placements_of(run), run.time}, before_phase);
  });
}

}  // namespace

PositionedRun run_again(const PositionedRun& run, const gjk::Options& options, ScalarKind scalar,
                        const std::function<void()>& before_phase) {
  return run.trace.dimension == 3 ? run_again_in<3>(run, options, scalar, before_phase)
                                  : run_again_in<2>(run, options, scalar, before_phase);
}

std::vector<Problem> check_expectation(const LessonRun& run) {
  std::vector<Problem> problems = unasked_questions(run);
  const Lesson& lesson = run.lesson;
  const WideTrace& trace = run.runs.back().trace;
  const auto differ = [&](std::string_view key, std::string what, std::string expected) {
    const Place place = place_of_key(lesson.path, key);
    problems.push_back(
        {lesson.path, place.line, place.column, std::move(what), std::move(expected), ""});
  };
  for (const PositionedRun& positioned : run.runs) {
    if (const std::string why = why_not_drawn(positioned); !why.empty()) {
      differ("shapes", why, "shapes that GJK can answer for, and pictures can show");
      return problems;
    }
  }
  const Expectation& expect = lesson.expect;
  if (expect.supports) {
    std::vector<std::string> supports;  // one an iteration; the last may have none
    for (const WideStep& step : trace.steps) {
      if (step.phase == gjk::Phase::support)
        supports.push_back(run.pair_name(step.after.support.pair));
    }
    for (std::size_t i = 0; i < std::max(supports.size(), expect.supports->size()); ++i) {
      const std::string found = i < supports.size() ? supports[i] : "no support point";
      std::string wanted = i < expect.supports->size() ? (*expect.supports)[i] : "none";
      if (const std::size_t hyphen = wanted.find('-'); hyphen != std::string::npos)
        wanted.replace(hyphen, 1, "−");
      if (found != wanted) {
        differ("expect.supports", fmt::format("iteration {}, support: {}", i + 1, found), wanted);
        break;
      }
    }
  }
  const std::string_view stop =
      trace.is_empty() ? run.algorithm_traces.back()->stop() : name_of(trace.result.stop);
  if (expect.stop && *expect.stop != stop) {
    const std::string at =
        trace.is_empty() ? "" : fmt::format("iteration {}, ", trace.result.iterations);
    differ("expect.stop", fmt::format("{}stop: '{}'", at, stop), fmt::format("'{}'", *expect.stop));
  }
  for (const auto& [name, wanted] : expect.answers) {
    const double found = run.algorithm_traces.back()->answer(name);
    if (!(std::abs(wanted - found) <= written_precision(wanted) * 1.0001))
      differ("expect.answer." + name, fmt::format("the {} is {}", name, found),
             fmt::format("{}", wanted));
  }
  if (expect.distance && !(std::abs(*expect.distance - trace.result.distance) <=
                           written_precision(*expect.distance) * 1.0001)) {
    differ("expect.distance", fmt::format("the distance is {}", trace.result.distance),
           fmt::format("{}", *expect.distance));
  }
  return problems;
}

}  // namespace gjkscope
