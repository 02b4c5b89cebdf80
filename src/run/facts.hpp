#pragma once
#include <optional>
#include <span>

#include "run/graph.hpp"

namespace gjkscope {

/// Part of a closest-point step whose region tests are shown one by one: so many of them are tried;
/// 0: their numbers.
struct TriedTests {
  int count = 0;
};

/// Parts of one support step: d, the support point of Y along d, that of X along -d, their
/// difference.
enum class SupportPart { direction, of_y, of_x, of_z };

/// A triangle's numbers, then one chain of region tests each. Short tests leave out that an edge's
/// own coordinates must be positive.
enum class OrderStage { numbers, vertices_first_short, edges_first_short, edges_first_whole };

/// What is known when a frame is shown. Stage, panel and words all read it here.
struct FrameFacts {
  static constexpr std::string_view kName = "facts";
  static constexpr std::string_view kNeeds = "";
  struct Value {
    std::optional<gjk::Phase> phase;  ///< Of the frame's step; none at the start.
    bool closest_point = false;       ///< P, its region and its weights.
    bool is_at_query = false;         ///< P is known, and is the query point.
    bool direction = false;           ///< d
    bool support = false;             ///< The support point along d.
    bool whole_support = false;       ///< The same, and the frame has put it together.
    bool has_ended = false;           ///< The step ends the run.
    std::span<const gjk::RegionTest<double>> region_tests;  ///< Of a closest-point step.
    bool gradual = false;                                   ///< Frames show them one by one.
    int tests_reached = -1;                                 ///< Index of the last one shown.
    int support_calls = 0;                                  ///< Up to here.

    [[nodiscard]] bool phase_is(gjk::Phase of) const { return phase == of; }
  };
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

/// Number of steps that are over when a frame ends.
[[nodiscard]] int steps_over(const Frame& frame);

}  // namespace gjkscope
