#include "run/questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lesson/load.hpp"
#include "lesson/vocabulary.hpp"
#include "outlines/polyhedron.hpp"

namespace gjkscope {

namespace {

/// Whether another vertex lies as far along d as the winner, as far as a reader can see.
bool is_tie(const std::vector<gjk::ScanEntry<double>>& scan, const LessonShape& shape,
            const Eigen::Vector3d& d) {
  constexpr double kSeen = 1e-3;  // of the size of the shape
  double first = -HUGE_VAL;
  double second = -HUGE_VAL;
  for (const gjk::ScanEntry<double>& entry : scan) {
    second = std::max(second, std::min(first, entry.value));
    first = std::max(first, entry.value);
  }
  double size = 0.0;
  for (const Eigen::Vector3d& vertex : shape.vertices)
    size = std::max(size, (vertex - shape.vertices.front()).norm());
  return first - second <= kSeen * d.norm() * size;
}

bool ends_by_itself(gjk::StopReason reason) {
  return reason != gjk::StopReason::running && reason != gjk::StopReason::failed &&
         reason != gjk::StopReason::iteration_cap && reason != gjk::StopReason::within_tolerance;
}

/// Whether the closest point in space lies at a vertex or on an edge: a face cannot be pointed at
/// by a place.
bool is_on_edge(const std::vector<Eigen::Vector3d>& points, const std::set<int>& closest) {
  if (points.size() < 2 || closest.size() > 2) return false;
  const Polyhedron hull = hull_in_space(points);
  if (closest.size() == 1)
    return std::count(hull.vertices.begin(), hull.vertices.end(), *closest.begin()) > 0;
  return std::any_of(hull.edges.begin(), hull.edges.end(), [&](const Polyhedron::Edge& edge) {
    return closest == std::set<int>{edge.from, edge.to};
  });
}

}  // namespace

bool is_open(const LessonRun& run, const WideTrace& trace, std::string_view ask, int step) {
  if (ask == asks::kSupport.name) {
    const WideStep& asked = trace.steps[step];
    const LessonShape& x = run.lesson.x();
    const LessonShape& y = run.lesson.y();
    return x.vertices.size() * y.vertices.size() > 1 &&
           !is_tie(asked.record.scan_x, x, asked.after.d) &&
           !is_tie(asked.record.scan_y, y, asked.after.d);
  }
  if (ask == asks::kDirection.name) {
    // A direction of a picture is a plane of directions in space.
    const WideState& after = trace.steps[step].after;
    return run.lesson.dimension == 2 && after.p_sq > 0.0 && after.d.squaredNorm() > 0.0;
  }
  const WideStep& answer = trace.steps[step];
  const bool is_of_segment = run.lesson.dimension == 2 && answer.after.simplex.count == 2;
  if (ask == asks::kRightAngle.name) return is_of_segment && answer.after.p_sq > 0.0;
  if (ask == asks::kNormals.name)
    return is_of_segment && answer.record.direction.sign_is_arbitrary && answer.after.p_sq == 0.0;
  constexpr std::size_t kTooMany = 4;  // vertices for a simplex of the plane
  if (ask == asks::kMayBe.name)
    return run.lesson.dimension == 2 && run.point_query() &&
           run.lesson.y().vertices.size() >= kTooMany;
  if (ask == asks::kIndex.name || ask == asks::kStart.name)
    return run.point_query() && run.lesson.y().vertices.size() > 1;
  return ask == asks::kStop.name || ask == asks::kWhy.name ||
         state_before(trace, step).simplex.count > 1;
}

bool tells(const WideTrace& trace, int step, std::string_view ask) {
  const auto is = [&](std::size_t i, gjk::Phase phase) {
    return i < trace.steps.size() && trace.steps[i].phase == phase;
  };
  const auto at = static_cast<std::size_t>(step);
  if (ask == asks::kWhy.name || ask == asks::kStart.name)
    return at + 1 == trace.steps.size() && ends_by_itself(trace.steps.back().after.stop);
  if (ask == asks::kSupport.name) return is(at, gjk::Phase::support);
  if (ask == asks::kDirection.name || ask == asks::kRightAngle.name || ask == asks::kNormals.name)
    return is(at, gjk::Phase::direction);
  if (ask == asks::kIndex.name) return is(at, gjk::Phase::add);
  if (ask == asks::kMayBe.name) return at == 0 && is(at, gjk::Phase::closest);
  if (ask == asks::kRegion.name) return is(at, gjk::Phase::closest);
  if (ask == asks::kDropped.name)
    return is(at, gjk::Phase::closest) && is(at + 1, gjk::Phase::drop);
  return ask == asks::kStop.name && is(at + 1, gjk::Phase::stop);
}

const WideState& state_before(const WideTrace& trace, int step) {
  return step == 0 ? trace.initial : trace.steps[step - 1].after;
}

bool has_closest(const LessonRun& run, const Frame& frame, std::string_view ask) {
  const WideResult& result = run.run(frame).trace.result;
  if (frame.step < 0 || !(result.distance > 0.0)) return false;
  const bool of_x = ask == asks::kClosestX.name;
  if (run.lesson.dimension == 3) {
    std::set<int> closest;
    for (int i = 0; i < result.simplex.count; ++i) {
      const gjk::VertexPair& pair = result.simplex.vertices[i].pair;
      closest.insert(of_x ? pair.x : pair.y);
    }
    return is_on_edge(run.run(frame).bodies[of_x ? 0 : 1].world, closest);
  }
  const LessonShape& shape = of_x ? run.lesson.x() : run.lesson.y();
  if (shape.vertices.size() < 2) return false;
  bool along_x = false;
  bool along_y = false;
  for (int i = 1; i < result.simplex.count; ++i) {
    along_x = along_x || result.simplex.vertices[i].pair.x != result.simplex.vertices[0].pair.x;
    along_y = along_y || result.simplex.vertices[i].pair.y != result.simplex.vertices[0].pair.y;
  }
  return !(along_x && along_y);  // parallel edges
}

bool is_at(const Frame& frame, const LessonQuestion& question) {
  return question.at.value_or(frame.run + 1) == frame.run + 1;
}

void add_question_frames(LessonRun& run) {
  const std::vector<LessonQuestion>& questions = run.lesson.questions;
  if (questions.empty()) return;
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    for (int q = 0; i > 0 && q < static_cast<int>(questions.size()); ++q) {
      const bool is_elsewhere = run.frames[i - 1].run != run.frames[i].run;
      if (is_elsewhere && !run.tour->sweeps && run.tour->asking == nullptr) continue;
      const int answer =
          run.tour->answering_step(run, run.frames[i - 1], run.frames[i], questions[q]);
      if (answer < 0) continue;
      Frame asked = run.frames[i];
      asked.question = q;
      frames.push_back(run.tour->asking ? run.tour->asking(run, asked) : run.frames[i - 1]);
      frames.back().question = q;
      frames.back().answering_step = answer;
    }
    frames.push_back(run.frames[i]);
  }
  run.frames = std::move(frames);
}

std::vector<Problem> unasked_questions(const LessonRun& run) {
  std::vector<Problem> problems;
  const Lesson& lesson = run.lesson;
  for (int q = 0; q < static_cast<int>(lesson.questions.size()); ++q) {
    const bool is_asked = std::any_of(run.frames.begin(), run.frames.end(),
                                      [&](const Frame& frame) { return frame.question == q; });
    if (is_asked) continue;
    const LessonQuestion& question = lesson.questions[q];
    const Place place = place_of_key(lesson.path, fmt::format("questions.{}.ask", q));
    problems.push_back(
        {lesson.path, place.line, place.column,
         fmt::format("no frame asks '{}'{}", question.ask,
                     question.at
                         ? fmt::format(" {} {}", run.tour->ask(question.ask)->counted, *question.at)
                         : std::string()),
         "a question with more than one answer to choose from, which a frame answers", ""});
  }
  return problems;
}

}  // namespace gjkscope
