#pragma once
// The walk on features in pictures: what a frame shows of it, and what its tour draws and says.

#include "outlines/polygon.hpp"
#include "picture/block.hpp"
#include "picture/legend.hpp"
#include "picture/tour.hpp"
#include "run/algorithm_facts.hpp"
#include "subjects/lin_canny/lesson_trace.hpp"

namespace gjkscope::walks {

inline constexpr AskInfo kAskFeature{"feature", "which feature the walk on features goes to next"};

inline constexpr AskInfo kAskMost{"most-pairs", "how many pairs a walk may look at, at most"};

/// The frame after the answer of a walk from scratch that ends at the closest pair: the pairs that
/// it looked at, among all.
[[nodiscard]] bool shows_pairs(const LessonRun& run, const Frame& frame);

/// A border of a feature's external Voronoi region (Larsen 1998, "Lin-Canny").
struct Border {
  HalfPlane line;                 ///< The region lies within.
  models::RingFeature neighbour;  ///< Beyond it; of the back of an edge, the edge itself.
  /// How far beyond it a point lies; negative within.
  [[nodiscard]] double beyond(const Eigen::Vector2d& point) const {
    return line.normal.normalized().dot(point - line.point);
  }
};

/// The part of the walk that a frame shows.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame);

  const Lesson& lesson;
  const TracedWalk& walk;
  const models::WalkStep* step = nullptr;  ///< The last that is over; none at the start.
  const models::WalkState& state;          ///< The state after that step.
  bool is_answer = false;                  ///< The frame after the last step.

  [[nodiscard]] bool is(models::WalkPhase phase) const {
    return step != nullptr && !is_answer && step->phase == phase;
  }
  /// The closest points of the two features are known.
  [[nodiscard]] bool knows_pair() const {
    return step != nullptr && !is(models::WalkPhase::swap) &&
           state.stop != models::WalkStop::overlap;
  }
  [[nodiscard]] models::Answer closest() const {
    return models::answer_of(state.pair, walk.query->model_a, walk.query->model_b);
  }
  [[nodiscard]] const models::Ring& ring(bool of_x) const {
    return of_x ? walk.query->a : walk.query->b;
  }
  [[nodiscard]] const models::RingFeature& feature(bool of_x) const {
    return of_x ? state.a : state.b;
  }
  [[nodiscard]] std::string name(bool of_x, const models::RingFeature& feature) const {
    return feature_name(lesson, *walk.query, of_x, feature);
  }
  [[nodiscard]] std::string name(bool of_x) const { return name(of_x, feature(of_x)); }
  /// Pairs in the order in which the walk looked at them.
  [[nodiscard]] std::vector<models::WalkState> pairs() const;
  /// The number of vertices and edges.
  [[nodiscard]] int features(bool of_x) const { return 2 * ring(of_x).size(); }
  /// The borders of the feature of X or Y, in the order in which the walk looks at them.
  [[nodiscard]] std::vector<Border> borders(bool of_x) const;
};

// blocks.cpp
extern const Block kFeatures;
extern const Listing kListing;

// layers.cpp
bool fill(SceneBuilder& scene, const Fonts& fonts);
void stage(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::walks
