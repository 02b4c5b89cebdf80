#pragma once
// The proof by slabs in pictures: what a frame shows of it, and what its tour draws and says.

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "run/algorithm_facts.hpp"
#include "subjects/slab_proof/lesson_trace.hpp"

namespace gjkscope::slabs {

inline constexpr AskInfo kAskVertex{"slab-vertex", "which vertex lies deepest in the slab"};

inline constexpr AskInfo kAskAngle{"slab-angle", "how large an angle the way into the slab makes"};

/// The part of the descent that a frame shows.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : lesson(run.lesson),
        trace(slab_trace(run.algorithm_trace(frame))),
        step(last_step_over(trace.descent.steps, frame)),
        is_answer(frame.step >= trace.steps()) {}

  const Lesson& lesson;
  const SlabTrace& trace;
  const slab_proof::Step* step = nullptr;  ///< The last that is over; none at the start.
  bool is_answer = false;                  ///< The frame after the last step.

  [[nodiscard]] bool has_points() const { return !trace.descent.steps.empty(); }
  [[nodiscard]] const slab_proof::State& state() const {
    return step == nullptr ? trace.descent.steps.front().before : step->after;
  }
  [[nodiscard]] bool is(slab_proof::Phase phase) const {
    return step != nullptr && !is_answer && step->phase == phase;
  }
  [[nodiscard]] std::string name(const slab_proof::Reach& reach) const {
    return vertex_name(lesson, reach);
  }
};

// blocks.cpp
extern const Block kSlabBlock;
extern const Listing kListing;

// layers.cpp
void stage(SceneBuilder& scene);
/// The angle between two directions.
[[nodiscard]] double degrees_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
/// The slab between two points, and its sides.
void strip(SceneBuilder& scene, const Eigen::Vector2d& x, const Eigen::Vector2d& y);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::slabs
