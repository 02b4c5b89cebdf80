#pragma once
// Penetration depth in pictures: what a frame shows of the expanding polygon,
// and what its tour draws and says.

#include <array>

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "run/algorithm_facts.hpp"
#include "run/effect_info.hpp"
#include "subjects/depth/lesson_trace.hpp"
#include "subjects/depth/names.hpp"

namespace gjkscope::depths {

inline constexpr AskInfo kAskEdge{"edge", "which edge of the expanding polygon is nearest"};
inline constexpr AskInfo kAskFace{"face", "which face of the expanding polytope is nearest"};
inline constexpr AskInfo kAskVisible{"visible-face", "which other face the support point sees"};
inline constexpr AskInfo kAskBeyond{"beyond", "whether Z reaches beyond the nearest edge or face"};

/// The part of a run that a frame shows, in either dimension.
template <class Trace>
struct ShownPart {
  using Step = typename decltype(Trace::steps)::value_type;

  ShownPart(const Trace& of, const LessonRun& run, const Frame& frame)
      : trace(of),
        result(*depth_result(run, frame.run)),
        step(last_step_over(trace.steps, frame)),
        state(step == nullptr ? trace.initial : step->after),
        is_answer(frame.step >= static_cast<int>(trace.steps.size())) {}

  const Trace& trace;
  const DepthResult& result;
  const Step* step = nullptr;             ///< The last that is over; none at the start.
  const decltype(Trace::initial)& state;  ///< The state after that step.
  bool is_answer = false;                 ///< The frame after the last step.

  [[nodiscard]] bool is(depth::Phase phase) const {
    return step != nullptr && !is_answer && step->phase == phase;
  }
  [[nodiscard]] bool has_stopped() const {
    return is(depth::Phase::stop) && state.stop != depth::StopReason::running;
  }
  /// The nearest edge or face is known, and part of what expands.
  [[nodiscard]] bool knows_nearest() const { return step != nullptr && !is(depth::Phase::expand); }
  [[nodiscard]] bool knows_support() const {
    return is(depth::Phase::support) || is(depth::Phase::stop);
  }
  /// How far Z reaches along n, and how far that is beyond a point.
  [[nodiscard]] double reach() const { return state.n.dot(state.support.w) / state.n.norm(); }
  [[nodiscard]] double beyond(const auto& point) const {
    return state.n.dot(state.support.w - point) / state.n.norm();
  }
};

struct Shown : ShownPart<DepthTrace> {
  Shown(const LessonRun& run, const Frame& frame);
  [[nodiscard]] bool is_nearest(const depth::Edge<double>& edge) const;
  /// Distance of O from an edge, where a step has measured it.
  [[nodiscard]] std::optional<double> distance(const depth::Edge<double>& edge) const;
};

/// Faces are indices of the polytope's.
struct ShownInSpace : ShownPart<DepthTraceInSpace> {
  ShownInSpace(const LessonRun& run, const Frame& frame);
  [[nodiscard]] const depth::space::Polytope<double>& polytope() const { return state.polytope; }
  [[nodiscard]] const depth::space::Face<double>& face(int face) const {
    return state.polytope.faces[face];
  }
  /// The three corners of a face, and the middle between them.
  [[nodiscard]] std::array<Eigen::Vector3d, 3> corners(int of) const;
  [[nodiscard]] Eigen::Vector3d middle(int of) const;
  /// Those that the polytope has, in order.
  [[nodiscard]] std::vector<int> faces() const;
  [[nodiscard]] bool is_nearest(int face) const { return knows_nearest() && face == state.face; }
  /// The next step drops it: the support point sees it. Frames of the stop test say it.
  [[nodiscard]] bool is_visible(int of) const;
  /// The step has added it.
  [[nodiscard]] bool is_new(int of) const;
  /// The foot of the perpendicular from O to the plane of the nearest face.
  [[nodiscard]] Eigen::Vector3d foot() const;
};

[[nodiscard]] inline bool is_in_space(const LessonRun& run) { return run.lesson.dimension == 3; }

/// "the edge from K−C to L−D"; a point is an edge, too.
[[nodiscard]] std::string edge_name(const LessonRun& run, const depth::State<double>& state,
                                    const depth::Edge<double>& edge);
/// "K−C to L−D"
[[nodiscard]] std::string ends(const LessonRun& run, const depth::State<double>& state,
                               const depth::Edge<double>& edge);

// blocks.cpp
extern const Block kEdges;
extern const Block kFaces;
extern const Block kBounds;
extern const Listing kListing;

// layers.cpp, layers_in_space.cpp
void stage(SceneBuilder& scene);
void stage_in_space(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::depths

namespace gjkscope::effect_infos {
extern const EffectInfo kPenetrationDepth;
}  // namespace gjkscope::effect_infos
