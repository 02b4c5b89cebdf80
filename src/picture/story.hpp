#pragma once
// The contents of a frame's captions: its state, the names of things, and what is known by then.

#include <string>
#include <string_view>
#include <vector>

#include "picture/frame_text.hpp"
#include "picture/words.hpp"
#include "run/facts.hpp"

namespace gjkscope {

struct Story {
  Story(const LessonRun& lesson_run, EffectGraph& graph, const Frame& shown);

  /// True when a view of the lesson calls for this effect.
  [[nodiscard]] bool shows(std::string_view effect) const { return run.lesson.calls_for(effect); }

  [[nodiscard]] Eigen::Vector3d p_world() const;
  /// "Q moves from (1.00, 2.00) to (3.00, 2.00)." for a query point, "Y moves by (0.50, 0.25) and
  /// turns by 15.0°." for other shapes: what happened since the run before, if there is one.
  [[nodiscard]] std::string moved() const;
  [[nodiscard]] std::string distance() const;
  /// The polygon of a point query, or Z.
  [[nodiscard]] std::string set_name() const;
  [[nodiscard]] std::string simplex_name() const;
  /// Whether a face is a simplex of the whole dimension: a triangle in the plane, a tetrahedron in
  /// space. A point that projects into it lies in it.
  [[nodiscard]] bool is_solid(gjk::Face face) const {
    return gjk::vertex_count(face) == run.lesson.dimension + 1;
  }
  /// The support line, or plane.
  [[nodiscard]] std::string_view plane() const {
    return run.lesson.dimension == 3 ? "plane" : "line";
  }
  /// "P = 0.3 B + 0.7 C"
  [[nodiscard]] std::string p_is() const;
  /// "vertex K of Y and edge CD of X": those whose differences hold P at the end of a run.
  [[nodiscard]] std::string closest_features() const;
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
  const WideState& state;
  const FrameFacts::Value& knows;
  Numbers numbers;
  SimplexWords words;
  std::string q;  ///< Name of the query point.
};

}  // namespace gjkscope
