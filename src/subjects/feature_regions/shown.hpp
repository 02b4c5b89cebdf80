#pragma once
// Voronoi regions of features in pictures: what a frame shows of them, and what their tour draws
// and says.

#include <optional>
#include <utility>

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"
#include "subjects/feature_regions/lesson_trace.hpp"

namespace gjkscope::cells {

inline constexpr AskInfo kAskHolding{"holding-region", "the feature whose region holds Q",
                                     "at position"};
inline constexpr AskInfo kAskRefuting{"refuting-plane",
                                      "the neighbour beyond whose plane a point lies", "in test"};

inline constexpr AskInfo kAskPlanes{"planes-tested", "how many planes tell that a region holds Q",
                                    "at position"};
inline constexpr AskInfo kAskAgain{"computed-again", "what a move of Q changes", "at position"};
inline constexpr AskInfo kAskReach{"slab-reach",
                                   "the vertex that reaches into the slab of a refuted pair"};
inline constexpr AskInfo kAskBefore{"before-plane", "which vertex lies before the plane of a point",
                                    "in test"};

/// A frame that asks about a pair shows the region that it asks about.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : lesson(run.lesson),
        trace(regions_trace(run.algorithm_trace(frame))),
        bodies(run.run(frame).bodies),
        is_query(run.point_query()),
        asks(frame.question >= 0),
        step(!asks      ? std::min(frame.step, trace.steps() - 1)
             : is_query ? -1
                        : frame.answering_step) {}

  const Lesson& lesson;
  const RegionsTrace& trace;
  const std::vector<Body>& bodies;
  bool is_query;
  bool asks;
  int step;  ///< -1: the start, or there are no regions.

  // For a frame with a step
  [[nodiscard]] const RegionsTrace::Step& at() const { return trace.all[step]; }
  [[nodiscard]] bool is(RegionsTrace::Phase phase) const {
    return step >= 0 && at().phase == phase;
  }
  [[nodiscard]] const RegionsTrace::Pair& pair() const {
    return trace.pairs[step < 0 ? 0 : static_cast<std::size_t>(at().pair)];
  }
  /// The feature that the step is about; -1: none.
  [[nodiscard]] int feature_index() const { return trace.feature(at()); }
  [[nodiscard]] const Feature& feature(int index) const { return trace.features[at().body][index]; }
  [[nodiscard]] std::string name(int feature) const {
    return trace.name(lesson, at().body, feature);
  }
  /// The region holds the point that it is asked about.
  [[nodiscard]] bool holds() const { return !(trace.border(at()).depth(trace.point(at())) < 0.0); }
  [[nodiscard]] const Eigen::Vector3d& vertex(std::size_t body, int index) const {
    return bodies[body].world[index];
  }
  /// For a slab of the first pair: the vertex that reaches into it from the body whose region was
  /// left, if it is the only one.
  [[nodiscard]] std::optional<std::pair<std::size_t, int>> reaching_vertex() const {
    if (at().pair > 0) return std::nullopt;
    const std::size_t body = trace.all[step - 1].body;
    std::optional<std::pair<std::size_t, int>> found;
    for (const std::pair<std::size_t, int>& each : trace.reaches) {
      if (each.first == body && std::exchange(found, each)) return std::nullopt;
    }
    return found;
  }
};

/// The regions that a frame shows, cut off.
struct FeatureRegions {
  static constexpr std::string_view kName = "feature-regions";
  static constexpr std::string_view kNeeds = "";
  struct Region {
    const Feature* feature = nullptr;  ///< In the run's trace.
    std::size_t body = 1;
    SolidPart solid;
  };
  using Value = std::vector<Region>;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

// blocks.cpp
extern const Block kRegionPlanes;

// layers.cpp
extern const Layer kBehind;
void stage(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::cells
