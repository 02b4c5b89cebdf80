#include "subjects/space/solids.hpp"

#include "subjects/space/subject.hpp"

namespace gjkscope {

EffectKey ShapeSolids::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

ShapeSolids::Value ShapeSolids::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  Value out;
  for (const Body& body : run.run(frame).bodies) out.push_back(hull_in_space(body.world));
  return out;
}

EffectKey DifferenceSolid::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

DifferenceSolid::Value DifferenceSolid::compute(EffectGraph& graph, const LessonRun& run,
                                                const Frame& frame) {
  const ShapeSolids::Value& solids = graph.get<ShapeSolids>(frame);
  const PositionedRun& positioned = run.run(frame);
  Value out;
  for (const int x : solids[0].vertices) {
    for (const int y : solids[1].vertices) {
      out.pairs.push_back({x, y});
      out.points.emplace_back(positioned.y().world[static_cast<std::size_t>(y)] -
                              positioned.x().world[static_cast<std::size_t>(x)]);
    }
  }
  out.hull = hull_in_space(out.points);
  return out;
}

const EffectInfo effect_infos::kShapeSolids =
    effect_info<ShapeSolids>("frame", "the hulls of X and Y in space");

const EffectInfo effect_infos::kDifferenceSolid =
    effect_info<DifferenceSolid>("frame", "the hull of the differences in space");

}  // namespace gjkscope
