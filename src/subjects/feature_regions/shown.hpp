#pragma once
// Voronoi regions of features in pictures: what a frame shows of them, and what their act draws and
// says.

#include "picture/act.hpp"
#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "run/effect_info.hpp"
#include "subjects/feature_regions/lesson_trace.hpp"

namespace gjkscope::cells {

inline constexpr AskInfo kAskHolding{"holding-region", "the feature whose region holds Q",
                                     "at position"};
inline constexpr AskInfo kAskRefuting{"refuting-plane",
                                      "the neighbour beyond whose plane a point lies", "in test"};

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
