#include "subjects/motion/motion.hpp"

#include "subjects/motion/subject.hpp"

namespace gjkscope {
namespace {

/// Corners of the difference at the position of a frame, moved by `shift`.
std::vector<Eigen::Vector2d> hull_corners(EffectGraph& graph, const Frame& frame,
                                          const Eigen::Vector2d& shift) {
  std::vector<Eigen::Vector2d> corners;
  for (const CloudPoint& corner : graph.get<MinkowskiHull>(frame))
    corners.push_back(corner.z + shift);
  return corners;
}

}  // namespace

EffectKey LastPosition::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

LastPosition::Value LastPosition::compute(EffectGraph& graph, const LessonRun& run,
                                          const Frame& frame) {
  if (frame.run == 0) return {};
  const PositionedRun& now = run.run(frame);
  const PositionedRun& last = run.runs[frame.run - 1];
  return Positions{in_plane(last.x().world),
                   in_plane(last.y().world),
                   hull_corners(graph, {.run = frame.run - 1}, Eigen::Vector2d::Zero()),
                   in_plane(now.x().placement.translate - last.x().placement.translate),
                   in_plane(now.y().placement.translate - last.y().placement.translate),
                   now.x().placement.rotate_degrees != last.x().placement.rotate_degrees ||
                       now.y().placement.rotate_degrees != last.y().placement.rotate_degrees};
}

EffectKey GrownObstacle::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

GrownObstacle::Value GrownObstacle::compute(EffectGraph& graph, const LessonRun& run,
                                            const Frame& frame) {
  return hull_corners(graph, frame, in_plane(run.run(frame).x().placement.translate));
}

const EffectInfo effect_infos::kLastPosition =
    effect_info<LastPosition>("view", "where everything was a position ago, and how far it went");

const EffectInfo effect_infos::kGrownObstacle =
    effect_info<GrownObstacle>("view", "Y grown by X, and X as a point against it");

}  // namespace gjkscope
