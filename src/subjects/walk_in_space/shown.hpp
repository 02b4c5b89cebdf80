#pragma once
// The walk on features in space in pictures: what a frame shows of it, and what its tour draws and
// says.

#include <optional>
#include <string_view>

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "subjects/walk_in_space/growth.hpp"
#include "subjects/walk_in_space/lesson_trace.hpp"

namespace gjkscope::space_walks {

inline constexpr AskInfo kAskNext{"feature-in-space",
                                  "which feature the walk in space goes to; along a path, ends at",
                                  "at pair or position"};
inline constexpr AskInfo kAskPairs{"pairs-in-space", "how many pairs the walk looks at",
                                   "at position"};

inline constexpr AskInfo kAskSmallMoves{
    "small-moves", "how pairs grow with the bodies where moves shrink as features do"};
inline constexpr AskInfo kAskFirstPair{
    "first-pair", "how pairs grow with the bodies where each walk starts anew"};

/// Frames after the path: counts as bodies grow. A question about them is one of them.
[[nodiscard]] std::optional<WalkGrowing> growth_of(const LessonRun& run, const Frame& frame);

/// The part of the walk that a frame shows. A frame that asks shows the step that answers, and
/// nothing of where it leads; along a path nothing but the start.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : lesson(run.lesson),
        trace(space_walk_trace(run.algorithm_trace(frame))),
        is_path(run.lesson.path_of_shapes.has_value()),
        asks(frame.question >= 0),
        is_answer(frame.step >= trace.steps() && !asks),
        index(asks ? (is_path ? -1 : frame.answering_step)
                   : std::min(frame.step, trace.steps() - 1)) {}

  const Lesson& lesson;
  const SpaceWalk& trace;
  bool is_path;  ///< Each position has one frame.
  bool asks;
  bool is_answer;
  int index;  ///< -1: the start, or there are no steps.

  /// The step, at the start the first one; only where there are steps.
  [[nodiscard]] const SpaceWalk::Step& step() const { return trace.all[std::max(index, 0)]; }
  /// True when the frame shows a step, and neither the start nor the answer.
  [[nodiscard]] bool is_step() const { return index >= 0 && !is_answer; }
  /// "face KLM"; of the body itself its name.
  [[nodiscard]] std::string short_name(std::size_t body, int feature) const {
    const LessonShape& shape = lesson.bodies[body];
    if (feature < 0) return shape.name;
    return cells::name_of(trace.features[body][feature], shape);
  }
  /// "face KLM of Y"
  [[nodiscard]] std::string name(std::size_t body, int feature) const {
    return short_name(body, feature) + " of " + lesson.bodies[body].name;
  }
};

// blocks.cpp
extern const Block kFeatures;
extern const Listing kListing;

// layers.cpp
extern const Layer kBehind;
bool fill(SceneBuilder& scene, const Fonts& fonts);
void stage(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::space_walks
