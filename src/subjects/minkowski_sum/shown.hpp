#pragma once
// The merge of edges in pictures: what a frame shows of it, and what its tour draws and says.

#include <array>

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "run/algorithm_facts.hpp"
#include "subjects/minkowski_sum/lesson_trace.hpp"

namespace gjkscope::sums {

inline constexpr AskInfo kAskEdge{"next-edge", "which edge of the difference comes next"};

inline constexpr AskInfo kAskLowest{"lowest", "where the lowest corner of the sum lies"};

/// The part of the merge that a frame shows.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : lesson(run.lesson),
        trace(sum_trace(run.algorithm_trace(frame))),
        merge(trace.merge),
        step(last_step_over(merge.steps, frame)),
        is_answer(frame.step >= static_cast<int>(merge.steps.size())) {}

  const Lesson& lesson;
  const SumTrace& trace;
  const minkowski_sum::Merge& merge;
  const minkowski_sum::Step* step = nullptr;  ///< The last that is over; none at the start.
  bool is_answer = false;                     ///< The frame after the last step.

  [[nodiscard]] bool is(minkowski_sum::Phase phase) const {
    return step != nullptr && !is_answer && step->phase == phase;
  }
  /// All edges are there.
  [[nodiscard]] bool is_closed() const {
    return step != nullptr && step->after.edges_of_y == merge.y.size() &&
           step->after.edges_of_x == merge.x.size();
  }
  /// The number of edges that the difference has so far.
  [[nodiscard]] int edges() const {
    if (step == nullptr) return 0;
    return std::min(static_cast<int>(step - merge.steps.data()),
                    static_cast<int>(merge.edges.size()));
  }
  [[nodiscard]] std::string corner(const minkowski_sum::Corner& at) const {
    return corner_name(lesson, merge, at);
  }
  [[nodiscard]] std::string edge(const minkowski_sum::Corner& from,
                                 minkowski_sum::Source source) const {
    return edge_name(lesson, merge, from, source);
  }
};

/// Places to choose from for the lowest corner: of Y, of −X, their sum, and −X's less Y's.
inline constexpr int kRightPlace = 1;
[[nodiscard]] std::array<Eigen::Vector2d, 4> lowest_places(const Shown& shown);

// blocks.cpp
extern const Block kMerge;
extern const Listing kListing;

// layers.cpp
/// The edge that leads on from a corner, as a way.
[[nodiscard]] Eigen::Vector2d edge_of(const Shown& shown, const minkowski_sum::Corner& from,
                                      minkowski_sum::Source source);
void stage(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::sums
