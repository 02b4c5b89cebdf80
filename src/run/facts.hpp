#pragma once
#include <optional>
#include <span>

#include "run/graph.hpp"

namespace gjkscope {

/// Facts that are known when a frame is shown. Stage, panel and words all read them here.
struct KnownFacts {
  std::optional<gjk::Phase> phase;  ///< The phase of the frame's step; none at the start.
  bool closest_point = false;       ///< P, its region and its weights.
  bool is_at_query = false;         ///< P is known, and is the query point.
  bool direction = false;           ///< d
  bool support = false;             ///< The support point along d.
  bool whole_support = false;       ///< The same, and the frame has put it together.
  bool has_ended = false;           ///< The step ends the run.
  bool distance = false;            ///< The answer, the length between the closest points.
  std::span<const gjk::RegionTest<double>> region_tests;  ///< Tests of a closest-point step.
  bool gradual = false;                                   ///< Frames show the tests one by one.
  int tests_reached = -1;                                 ///< Index of the last one shown.
  int steps = 0;                                          ///< GJK's, when the frame ends.
  int support_calls = 0;                                  ///< Up to here.

  [[nodiscard]] bool phase_is(gjk::Phase of) const { return phase == of; }
};

/// The same facts as a derived value; a tour that takes steps apart says what its parts know
/// (Tour::knows).
struct FrameFacts {
  static constexpr std::string_view kName = "facts";
  static constexpr std::string_view kNeeds = "";
  using Value = KnownFacts;
  static EffectKey key(const LessonRun& run, const Frame& frame);
  static Value compute(EffectGraph& graph, const LessonRun& run, const Frame& frame);
};

}  // namespace gjkscope
