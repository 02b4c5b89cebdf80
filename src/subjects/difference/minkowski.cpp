#include "subjects/difference/minkowski.hpp"

#include "subjects/difference/subject.hpp"

namespace gjkscope {

EffectKey MinkowskiCloud::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

MinkowskiCloud::Value MinkowskiCloud::compute(EffectGraph&, const LessonRun& run,
                                              const Frame& frame) {
  return minkowski_cloud(in_plane(run.run(frame).x().world), in_plane(run.run(frame).y().world));
}

EffectKey MinkowskiHull::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

MinkowskiHull::Value MinkowskiHull::compute(EffectGraph&, const LessonRun& run,
                                            const Frame& frame) {
  return minkowski_hull(in_plane(run.run(frame).x().world), in_plane(run.run(frame).y().world));
}

const EffectInfo effect_infos::kMinkowskiCloud =
    shown_of(ShownOf::both, effect_info<MinkowskiCloud>("view", "every difference y - x"));

const EffectInfo effect_infos::kMinkowskiHull =
    shown_of(ShownOf::both, effect_info<MinkowskiHull>("view", "convex hull of the differences"));

}  // namespace gjkscope
