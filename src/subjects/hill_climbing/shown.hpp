#pragma once
// The walks in pictures: what a frame shows of them, and what their tour draws and says.

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "subjects/hill_climbing/lesson_trace.hpp"

namespace gjkscope::climbs {

inline constexpr AskInfo kAskClimb{"climb", "which vertex the walk goes to next", "at step"};

/// Frames after the answer: counts as polyhedra grow, then what a walk needs.
enum class After { growth, needs };
[[nodiscard]] std::optional<After> after_of(const LessonRun& run, const Frame& frame);

/// The part of the walks that a frame shows. A frame that asks shows the step that answers, and
/// nothing of where it leads.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : lesson(run.lesson),
        trace(climbs_trace(run.algorithm_trace(frame))),
        bodies(run.run(frame).bodies),
        asks(frame.question >= 0),
        is_answer(frame.step >= trace.steps()),
        step(asks ? frame.answering_step : std::min(frame.step, trace.steps() - 1)) {}

  const Lesson& lesson;
  const ClimbTrace& trace;
  const std::vector<Body>& bodies;
  bool asks;
  bool is_answer;  ///< All walks are over.
  int step;        ///< -1: the start, or there are no walks.

  // For a frame with a step
  [[nodiscard]] const Climb& climb() const { return trace.climb(step); }
  [[nodiscard]] const climbing::Look& look() const { return trace.look(step); }
  [[nodiscard]] bool is_first() const { return trace.all[step].look == 0; }
  [[nodiscard]] std::size_t body() const { return climb().of_x ? 0 : 1; }
  [[nodiscard]] const LessonShape& shape() const { return lesson.bodies[body()]; }
  [[nodiscard]] const std::string& name(int vertex) const { return shape().vertex_names[vertex]; }
  [[nodiscard]] const Eigen::Vector3d& at(int vertex) const { return bodies[body()].world[vertex]; }
  [[nodiscard]] Subject subject(int vertex) const {
    return climb().of_x ? Subject{Subject::Kind::vertex_of_x, vertex}
                        : Subject{Subject::Kind::vertex_of_y, -1, vertex};
  }
  /// "d", or of X "−d".
  [[nodiscard]] std::string d() const { return climb().of_x ? "−d" : "d"; }
  /// Summed in one order everywhere, as the core does it.
  [[nodiscard]] double product(int vertex) const {
    return gjk::dot<double, 3>(climb().walk.d, at(vertex));
  }
  [[nodiscard]] const std::vector<int>& neighbours() const {
    return trace.neighbours[body()][look().at];
  }
  /// Dot products of the current walk by now.
  [[nodiscard]] int products() const {
    return trace.walked(over()) - trace.walked(step - trace.all[step].look);
  }
  /// Steps that are over.
  [[nodiscard]] int over() const { return asks ? step : step + 1; }
};

// blocks.cpp
extern const Block kClimb;
extern const Listing kListing;

// layers.cpp
bool fill(SceneBuilder& scene, const Fonts& fonts);
void stage(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::climbs
