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

std::string Story::moved() const {
  if (frame.run == 0) return {};
  const PositionedRun& last = run.runs[static_cast<std::size_t>(frame.run) - 1];
  if (run.point_query()) {
    return fmt::format("{} moves from {} to {}.", q, numbers.point(last.x().world[0]),
                       numbers.point(positioned.x().world[0]));
  }
  std::string out;
  for (std::size_t i = 0; i < positioned.bodies.size(); ++i) {
    const Placement& from = last.bodies[i].placement;
    const Placement& to = positioned.bodies[i].placement;
    std::vector<std::string> changes;
    if (to.translate != from.translate)
      changes.push_back("moves by " + numbers.point(to.translate - from.translate));
    if (to.rotate_degrees != from.rotate_degrees)
      changes.push_back(
          fmt::format("turns by {}°", fixed(to.rotate_degrees - from.rotate_degrees, 1)));
    if (changes.empty()) continue;
    out += fmt::format("{}{} {}.", out.empty() ? "" : " ", run.lesson.bodies[i].name,
                       and_list(std::move(changes)));
  }
  return out;
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
