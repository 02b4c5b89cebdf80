#pragma once
// A run of GJK, iteration by iteration and phase by phase: what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

/// Parts of one support step: d, the support point of Y along d, that of X along -d, their
/// difference.
enum class SupportPart { direction, of_y, of_x, of_z };
[[nodiscard]] std::optional<SupportPart> support_part(const LessonRun& run, const Frame& frame);

/// The number of region tests of a closest-point step that have been tried; 0: its numbers are
/// shown.
[[nodiscard]] std::optional<int> tried_tests(const LessonRun& run, const Frame& frame);

namespace tours {
extern const Tour kIteration;
extern const Tour kPath;
extern const Tour kPhase;
extern const Tour kTest;
extern const Tour kSupport;
}  // namespace tours

namespace blocks {

extern const Block kSimplex;
extern const Block kScan;
extern const Block kBounds;
extern const Block kDirectionRules;
extern const Block kPseudocode;
extern const Block kStopTests;
extern const Block kTests;
extern const Block kRegions;

/// `misleads`: a test that holds, and takes the wrong point.
enum class TestMark { untried, fails, holds, misleads };
/// At the left of the current row.
void test_mark(PanelBuilder& panel, TestMark mark);
/// One row of a chain of tests: mark, region, condition and numbers.
void test_row(PanelBuilder& panel, TestMark mark, bool current, const std::string& region,
              const std::string& condition, const std::string& values);

/// The look of a line in the frame's step.
struct LineView {
  enum class State { idle, untried, current, past, rejected } state = State::idle;
  std::optional<bool> verdict = {};  ///< The verdict of a region test.
  std::string value = {};            ///< The value that the line computed.
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
extern const Listing kGjk;
}  // namespace listings

namespace layers {

extern const Layer kOtherNormal;
extern const Layer kShapes;
extern const Layer kQueryPoint;
extern const Layer kTurn;
extern const Layer kStarts;

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
void closest_point(SceneBuilder& scene);
void witness_points(SceneBuilder& scene);
/// The search direction at P.
void search_direction(SceneBuilder& scene);
/// The support point; vertices that it shares with the simplex stay visible in a larger diamond.
void support_point(SceneBuilder& scene);
/// Search direction, support line and support point.
void search(SceneBuilder& scene);
void search_between_shapes(SceneBuilder& scene);

[[nodiscard]] bool reaches_query(const SceneBuilder& scene);
/// d, the support point of Y, that of X, their difference, one after the other.
void support_in_parts(SceneBuilder& scene);
/// Simplex, closest point, search direction and support point of a step.
void stage_step(SceneBuilder& scene);

}  // namespace layers

namespace captions {

/// Says what a phase did, and why.
void step(const Story& story, FrameText& text);
void start(const Story& story, FrameText& text);
/// The values of a run's step.
void run_values(const Story& story, FrameText& text);
void closest(const Story& story, FrameText& text);
void region_test(const Story& story, FrameText& text);
void drop(const Story& story, FrameText& text);
void direction(const Story& story, FrameText& text);
void support(const Story& story, FrameText& text);
void support_in_parts(const Story& story, FrameText& text);
void stop(const Story& story, FrameText& text);
void add(const Story& story, FrameText& text);

void direction_rules(const Story& story, FrameText& text);

/// The closest point of X or of Y: its vertices and edges to choose from, in the world.
void closest_question(const Story& story, FrameText& text);
void closest_of_difference_question(const Story& story, FrameText& text);
void overlap_question(const Story& story, FrameText& text);
/// The question of a frame that asks one, what there is to choose from, and the answer.
void question(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kDirectionRules;
extern const EffectInfo kHistory;
extern const EffectInfo kOtherNormal;
extern const EffectInfo kVoronoiRegions;
}  // namespace effect_infos

}  // namespace gjkscope
