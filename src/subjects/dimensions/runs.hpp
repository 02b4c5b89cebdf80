#pragma once
// Runs in fewer dimensions than the lesson has, or about fewer vertices, made from the lesson.

#include <memory>
#include <vector>

#include "picture/tour.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// A run that a view shows, with its effects. The lesson's own run is no such value.
struct LesserRun {
  LesserRun(Lesson lesson, const Tour& tour, EffectGraph& counts)
      : run(std::make_unique<LessonRun>(run_lesson(std::move(lesson), tour))),
        effects(std::make_unique<EffectGraph>(*run, counts)) {}
  std::unique_ptr<LessonRun> run;
  std::unique_ptr<EffectGraph> effects;
};

/// The frame in the view's own run: the lessers come first, then the lesson's.
[[nodiscard]] inline FrameInView in_view_of(const std::vector<LesserRun>& lessers,
                                            const LessonRun& run, EffectGraph& effects,
                                            const Frame& frame, std::size_t view) {
  if (view >= lessers.size()) return {&run, &effects, frame};
  return {lessers[view].run.get(), lessers[view].effects.get(), frame};
}

/// The lesson's shapes in their first run, pressed onto a line, and in space onto a plane, too.
struct FlatRuns {
  static constexpr std::string_view kName = "flat-runs";
  static constexpr std::string_view kNeeds = "";
  using Value = std::vector<LesserRun>;  ///< In one dimension, two, ... fewer than the lesson has.
  static EffectKey key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// The query point and the segment of the first two vertices of the tetrahedron that the lesson
/// starts with, and the triangle of the first three.
struct FirstVertices {
  static constexpr std::string_view kName = "first-vertices";
  static constexpr std::string_view kNeeds = "";
  using Value = std::vector<LesserRun>;
  static EffectKey key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
