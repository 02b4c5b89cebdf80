#pragma once
// What the captions of a frame are told with: its state, the names of things, and what is known by
// then. Each family of captions is a file of this folder.

#include <string>
#include <string_view>
#include <vector>

#include "effects/facts.hpp"
#include "picture/frame.hpp"
#include "picture/words.hpp"

namespace gjkscope {

struct Story {
  Story(const LessonRun& lesson_run, EffectGraph& graph, const Frame& shown);

  /// True when a view of the lesson calls for this effect.
  [[nodiscard]] bool shows(std::string_view effect) const { return run.lesson.calls_for(effect); }

  [[nodiscard]] Eigen::Vector2d p_world() const;
  [[nodiscard]] std::string distance() const;
  /// The polygon of a point query, or Z.
  [[nodiscard]] std::string set_name() const;
  [[nodiscard]] std::string simplex_name() const;
  /// "P = 0.3 B + 0.7 C"
  [[nodiscard]] std::string p_is() const;
  [[nodiscard]] std::string edge_name(gjk::Face face) const;
  [[nodiscard]] std::string edge_words() const { return edge_name(state.simplex.all()); }
  [[nodiscard]] std::string weight(const gjk::RegionTerm<double>& term) const;
  /// The same, positive numbers with a plus sign.
  [[nodiscard]] std::string signed_weight(const gjk::RegionTerm<double>& term) const;

  const LessonRun& run;
  EffectGraph& effects;
  const Frame& frame;
  const PositionedRun& positioned;
  const WideTrace& trace;
  const gjk::State<double, 2>& state;
  const FrameFacts::Value& knows;
  Numbers numbers;
  SimplexWords words;
  std::string q;  ///< Name of the query point.
};

namespace captions {

// regions.cpp
void closest(const Story& story, FrameText& text);
void region_test(const Story& story, FrameText& text);

// run.cpp
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

// line.cpp
/// u and v as fractional lengths, from G and from Q.
void line(const Story& story, FrameText& text);

// balance.cpp
void balance(const Story& story, FrameText& text);

// maps.cpp
void maps(const Story& story, FrameText& text);
void orders(const Story& story, FrameText& text);

// direction_rules.cpp: how far d = O - P is from being perpendicular
void direction_rules(const Story& story, FrameText& text);

// second_run.cpp: where the two runs part
void second_run(const Story& story, FrameText& text);

// issues.cpp
/// What could go wrong where Q stands.
void issue(const Story& story, FrameText& text);
/// What GJK does about it.
void issue_solved(const Story& story, FrameText& text);
void issue_question(const Story& story, FrameText& text);

// round_shapes.cpp: what is left of the distance once the radii are subtracted
void round_shapes(const Story& story, FrameText& text);

// shape_hull.cpp: what a vertex inside of the hull is to GJK
void shape_hull(const Story& story, FrameText& text);

// difference.cpp
void pairs(const Story& story, FrameText& text);

// support.cpp
void support_in_parts(const Story& story, FrameText& text);
/// Adds how much of Z the run has computed.
void touched_points(const Story& story, FrameText& text);
/// Phases of a lesson that shows the slab between X and Y: what they prove.
void slab(const Story& story, FrameText& text);

// growth.cpp
/// A size of polygons, or, after the last one, what all of them say.
void growth(const Story& story, FrameText& text);

// study.cpp
void study(const Story& story, FrameText& text);
/// The question of a frame of the study.
void study_question(const Story& story, FrameText& text);

// answer.cpp
void answer(const Story& story, FrameText& text);
void witness(const Story& story, FrameText& text);

// question.cpp
/// The question of a frame that asks one, what there is to choose from, and the answer.
void question(const Story& story, FrameText& text);

}  // namespace captions
}  // namespace gjkscope
