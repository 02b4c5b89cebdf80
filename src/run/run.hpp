#pragma once
// A lesson, run: one traced run for each position of X, and the frames that the lesson's tour makes
// of them.

#include <functional>
#include <string>
#include <vector>

#include "lesson/algorithm.hpp"
#include "lesson/case.hpp"
#include "lesson/frame.hpp"
#include "lesson/lesson.hpp"
#include "lesson/problem.hpp"
#include "run/gjk_algorithm.hpp"
#include "run/wide.hpp"

namespace gjkscope {

/// Proved bounds, rounding included: lower <= exact distance <= upper.
struct DistanceBounds {
  double lower = 0.0;
  double upper = 0.0;
};

/// The place of a shape.
struct Placement {
  Eigen::Vector3d translate = Eigen::Vector3d::Zero();
  double rotate_degrees = 0.0;                      ///< Counter-clockwise, seen against the axis.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< As LessonShape::axis.
};

/// Its turn, rounded from more digits: a double's sine differs in the last bit from library to
/// library.
[[nodiscard]] Eigen::Matrix3d turn_of(const Placement& placement);

/// A shape of a run.
struct Body {
  Placement placement;
  std::vector<Eigen::Vector3d> world;  ///< Its vertices, as the run rounds them.
};

/// One run: where the shapes stood, and what GJK did; nothing where it was not asked.
struct PositionedRun {
  std::vector<Body> bodies{2};  ///< As those of the lesson: X and Y come first.
  double time = 0.0;            ///< Seconds since the start of the motion; 0 without a clock.
  int exponent = 0;  ///< The run computed in units of 2^exponent, whatever the trace is in.
  WideTrace trace;
  std::vector<DistanceBounds> bounds;  ///< After each step, in the world's unit; the last are
                                       ///< those of the result.

  [[nodiscard]] const Body& x() const { return bodies[0]; }
  [[nodiscard]] const Body& y() const { return bodies[1]; }
};

/// The place of each body.
[[nodiscard]] std::vector<Placement> placements_of(const PositionedRun& run);

/// True when a pair of vertices is one of those that a simplex is made of.
[[nodiscard]] bool has_pair(const WideSimplex& simplex, gjk::VertexPair pair);

/// How often a run asked for a support point.
[[nodiscard]] int support_calls(const WideTrace& trace);

/// Why there is no picture of a run: GJK refused it, a vertex stands where its scalar has no
/// number, or its lengths are not in the world's unit. Empty for all others.
[[nodiscard]] std::string why_not_drawn(const PositionedRun& run);

struct Tour;

struct LessonRun {
  Lesson lesson;
  const Tour* tour = nullptr;  ///< The tour named by Lesson::tour (lesson/vocabulary.hpp).
  std::vector<PositionedRun> runs;
  /// The trace of the tour's algorithm in each run.
  std::vector<std::shared_ptr<const AlgorithmTrace>> algorithm_traces;
  std::vector<Frame> frames;

  [[nodiscard]] const PositionedRun& run(const Frame& frame) const { return runs[frame.run]; }
  /// The step of GJK that a frame shows: its own, or the last one, which another algorithm goes on
  /// from; -1: the start.
  [[nodiscard]] int gjk_step(const Frame& frame) const;
  /// The state after it, or the initial one.
  [[nodiscard]] const WideState& state(const Frame& frame) const;
  /// The step itself, and what is proved by then; only where gjk_step(frame) >= 0.
  [[nodiscard]] const WideStep& step(const Frame& frame) const;
  [[nodiscard]] const DistanceBounds& bounds(const Frame& frame) const;

  /// The trace of the tour's algorithm in the run of a frame.
  [[nodiscard]] const AlgorithmTrace& algorithm_trace(const Frame& frame) const {
    return *algorithm_traces[frame.run];
  }

  /// The question that a frame asks; only where Frame::question is not -1.
  [[nodiscard]] const LessonQuestion& asked(const Frame& frame) const {
    return lesson.questions[frame.question];
  }
  /// The step of a frame in the algorithm that the tour shows.
  [[nodiscard]] StepInfo info(const Frame& frame) const;
  /// The iteration of the step that answers a frame's question.
  [[nodiscard]] int answering_iteration(const Frame& frame) const;

  /// Name of a vertex of the Minkowski difference: "K−C"; with a single vertex in X (a point query)
  /// that of Y's: "K".
  [[nodiscard]] std::string pair_name(gjk::VertexPair pair) const;
  [[nodiscard]] bool point_query() const { return lesson.x().vertices.size() == 1; }
};

/// `tour` is the one that the lesson names; it must outlive the run.
[[nodiscard]] LessonRun run_lesson(Lesson lesson, const Tour& tour);

/// Index of the last step that frames of a run may show: the first of Lesson::until, else the last
/// of all. -1 where GJK refused the run.
[[nodiscard]] int last_step(const Lesson& lesson, const WideTrace& trace);

/// A pasted case, run with the default options. D: 2 or 3.
template <int D>
[[nodiscard]] PositionedRun run_case(const CaseIn<D>& shapes, ScalarKind scalar);

/// "K−C"; with a single vertex in X (a point query) the name of Y's vertex: "K".
[[nodiscard]] std::string pair_name(const std::vector<std::string>& x_names,
                                    const std::vector<std::string>& y_names, gjk::VertexPair pair);

/// The shapes as they stand in the world, rounded as the run rounds them; of a lesson: as they
/// stand in its first run. Finite where they can be drawn (why_not_drawn). Of the plane alone.
[[nodiscard]] Case case_of(const PositionedRun& run);
[[nodiscard]] Case case_of(const Lesson& lesson);
/// Calls `use` with the shapes of a run in their dimension: with a CaseIn<2> or a CaseIn<3>.
template <class Use>
decltype(auto) with_case(const PositionedRun& run, const Use& use) {
  return run.trace.dimension == 3 ? use(CaseIn<3>{run.x().world, run.y().world})
                                  : use(case_of(run));
}

/// The run with the shapes where those of run `index` stood, started as the lesson's first run is.
[[nodiscard]] PositionedRun run_afresh(const LessonRun& run, int index);

/// The options, with the start that a run had.
[[nodiscard]] gjk::Options started_as(const PositionedRun& run, gjk::Options options);

/// GJK once more with other options or in another scalar. It is asked about the vertices in the
/// world as `run` rounded them, so that both compute from the very same numbers. `before_phase` may
/// throw, to give up.
[[nodiscard]] PositionedRun run_again(
    const PositionedRun& run, const gjk::Options& options, ScalarKind scalar,
    const std::function<void()>& before_phase = [] {});

/// Reports where the outcome differs from Lesson::expect, and questions that it does not answer;
/// places are those of the keys in the lesson's file.
[[nodiscard]] std::vector<Problem> check_expectation(const LessonRun& run);

}  // namespace gjkscope
