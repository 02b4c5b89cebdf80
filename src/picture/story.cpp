#include "picture/story.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gjkscope {

Story::Story(const LessonRun& lesson_run, EffectGraph& graph, const Frame& shown)
    : run(lesson_run),
      effects(graph),
      frame(shown),
      positioned(run.run(frame)),
      trace(positioned.trace),
      state(run.state(frame)),
      knows(effects.get<FrameFacts>(frame)),
      numbers(run.lesson),
      words(run, state.simplex),
      q(query_name(run)) {}

Eigen::Vector3d Story::p_world() const {
  return run.point_query() ? Eigen::Vector3d(state.p + positioned.x().world[0]) : state.p;
}

std::string Story::distance() const { return numbers(std::sqrt(state.p_sq)); }

std::string Story::set_name() const { return run.point_query() ? run.lesson.y().name : "Z"; }

std::string Story::simplex_name() const { return words.kind_and_face(state.simplex.all()); }

std::string Story::p_is() const {
  if (is_solid(state.region)) return "P = " + q;
  return "P = " + words.combination(state.region, numbers);
}

std::string Story::closest_features() const {
  const WideSimplex& simplex = trace.result.simplex;
  return fmt::format("{} of {} and {} of {}", feature_name(run, simplex, true), run.lesson.x().name,
                     feature_name(run, simplex, false), run.lesson.y().name);
}

std::string Story::edge_name(gjk::Face face) const {
  return run.point_query() ? words.face(face) : "the " + words.kind_and_face(face);
}

std::string Story::weight(const gjk::RegionTerm<double>& term) const {
  return numbers.weight(term.denominator > 0.0 ? term.numerator / term.denominator : 0.0);
}

std::string Story::signed_weight(const gjk::RegionTerm<double>& term) const {
  const double value = term.denominator > 0.0 ? term.numerator / term.denominator : 0.0;
  return run.lesson.scalar == ScalarKind::double_ ? signed_fixed(value, 3) : numbers.weight(value);
}

}  // namespace gjkscope
