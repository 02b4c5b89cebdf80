#pragma once
// A run of GJK, iteration by iteration and phase by phase: what the files of this folder define.

#include "picture/act.hpp"
#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace acts {
extern const Act kIteration;
extern const Act kPath;
extern const Act kPhase;
}  // namespace acts

namespace blocks {

extern const Block kSimplex;
extern const Block kScan;
extern const Block kBounds;
extern const Block kDirectionRules;
extern const Block kPseudocode;
extern const Block kStopTests;

/// What a line says of the frame's step.
struct LineView {
  enum class State { idle, untried, current, past, rejected } state = State::idle;
  std::optional<bool> verdict = {};  ///< Of a region test.
  std::string value = {};            ///< What the line computed.
};
void write_line(PanelBuilder& panel, const std::string& text, const LineView& line);
/// A line of a listing that is current or not; its value is written where it is.
void listing_line(PanelBuilder& panel, const std::string& text, bool current,
                  std::string value = {});

}  // namespace blocks

namespace listings {
extern const Listing kSegment;
extern const Listing kTriangle;
extern const Listing kStructures;
extern const Listing kSupport;
extern const Listing kGjkPoint;
extern const Listing kMinkowski;
extern const Listing kGjk;
}  // namespace listings

namespace layers {

extern const Layer kOtherNormal;
extern const Layer kShapes;
extern const Layer kPath;
extern const Layer kQueryPoint;

/// The name of a vertex, of X, Y or the difference, that the frame leaves without one; a disk where
/// it has none, too.
void vertex_name(SceneBuilder& scene, const Subject& vertex, bool has_mark);

/// The support line that the lower bound comes from, where it is not that of the frame's search.
void best_support_line(SceneBuilder& scene);
/// Simplices of earlier iterations, below that of the frame; their closest points, above it.
void history(SceneBuilder& scene);
void history_points(SceneBuilder& scene);
void simplex(SceneBuilder& scene);
void closest_line(SceneBuilder& scene);
/// A length beside the line that it is the length of; none within a pixel.
void length_label(SceneBuilder& scene, const std::string& id, double length, const Point& from,
                  const Point& to);
void closest_point(SceneBuilder& scene);
void witness_points(SceneBuilder& scene);
/// An arrow along d, and its name.
void search_arrow(SceneBuilder& scene, const Point& from, const Eigen::Vector3d& d, double length,
                  const std::string& text);
/// The search direction at P.
void search_direction(SceneBuilder& scene);
/// The line through a point, normal to d.
void support_line(SceneBuilder& scene, const Point& through, const Eigen::Vector3d& d,
                  const std::string& role = "support.plane");
/// Search direction, support line and support point.
void search(SceneBuilder& scene);
void search_between_shapes(SceneBuilder& scene);

/// P and its line, but where frames measure weights along a path: it would lie on them.
[[nodiscard]] bool shows_closest_point(const SceneBuilder& scene);
[[nodiscard]] bool reaches_query(const SceneBuilder& scene);
/// Simplex, closest point, search direction and support point of a step.
void stage_step(SceneBuilder& scene);

}  // namespace layers

namespace captions {

/// What a phase did, and why.
void step(const Story& story, FrameText& text);
void start(const Story& story, FrameText& text);
/// "vertex K of Y and edge CD of X": those whose differences hold P at the end of a run.
[[nodiscard]] std::string closest_features(const Story& story);
/// The values of a run's step.
void run_values(const Story& story, FrameText& text);
void drop(const Story& story, FrameText& text);
void direction(const Story& story, FrameText& text);
void support(const Story& story, FrameText& text);
void stop(const Story& story, FrameText& text);
void add(const Story& story, FrameText& text);

void direction_rules(const Story& story, FrameText& text);

/// The closest point of X or of Y: its vertices and edges to choose from, in the world.
void closest_question(const Story& story, FrameText& text);
/// The question of a frame that asks one, what there is to choose from, and the answer.
void question(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kDirectionRules;
extern const EffectInfo kHistory;
extern const EffectInfo kOtherNormal;
}  // namespace effect_infos

}  // namespace gjkscope
