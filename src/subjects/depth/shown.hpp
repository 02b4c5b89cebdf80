#pragma once
// Penetration depth in pictures: what a frame shows of the expanding polygon,
// and what its act draws and says.

#include "picture/act.hpp"
#include "picture/block.hpp"
#include "run/algorithm_facts.hpp"
#include "run/effect_info.hpp"
#include "subjects/depth/lesson_trace.hpp"
#include "subjects/depth/names.hpp"

namespace gjkscope::depths {

inline constexpr AskInfo kAskEdge{"edge", "which edge of the expanding polygon is nearest"};

/// The part of the run that a frame shows.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame);

  const DepthTrace& trace;
  const depth::Step<double>* step = nullptr;  ///< The last that is over; none at the start.
  const depth::State<double>& state;          ///< The state after that step.
  bool is_answer = false;                     ///< The frame after the last step.

  [[nodiscard]] bool is(depth::Phase phase) const {
    return step != nullptr && !is_answer && step->phase == phase;
  }
  /// The nearest edge is known, and part of the polygon.
  [[nodiscard]] bool knows_edge() const { return step != nullptr && !is(depth::Phase::expand); }
  [[nodiscard]] bool is_nearest(const depth::Edge<double>& edge) const;
  [[nodiscard]] bool knows_support() const {
    return is(depth::Phase::support) || is(depth::Phase::stop);
  }
  /// Distance of O from an edge, where a step has measured it.
  [[nodiscard]] std::optional<double> distance(const depth::Edge<double>& edge) const;
};

/// "the edge from K−C to L−D"; a point is an edge, too.
[[nodiscard]] std::string edge_name(const LessonRun& run, const depth::State<double>& state,
                                    const depth::Edge<double>& edge);
/// "K−C to L−D"
[[nodiscard]] std::string ends(const LessonRun& run, const depth::State<double>& state,
                               const depth::Edge<double>& edge);

// blocks.cpp
extern const Block kEdges;
extern const Block kBounds;
extern const Listing kListing;

// layers.cpp
void stage(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::depths

namespace gjkscope::effect_infos {
extern const EffectInfo kPenetrationDepth;
}  // namespace gjkscope::effect_infos
