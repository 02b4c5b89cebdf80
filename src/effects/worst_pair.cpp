#include "effects/worst_pair.hpp"

#include "geometry/polygon.hpp"

namespace gjkscope {

namespace {

std::vector<Eigen::Vector2d> corners_of(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Eigen::Vector2d> out;
  for (const int i : convex_hull(points)) out.push_back(points[static_cast<std::size_t>(i)]);
  return out;
}

}  // namespace

EffectKey WorstPair::key(const LessonRun&, const Frame& frame) { return {-1, -1, frame.detail}; }

WorstPair::Value WorstPair::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const LessonStudy& study = *run.lesson.study;
  const StudyDot& dot = study.dot(study.configurations[static_cast<std::size_t>(frame.detail)]);
  const gjk::Query<double, 2> query{{dot.x}, {dot.y}};
  const gjk::Result<double, 2> result = gjk::distance(query);
  return {corners_of(dot.x), corners_of(dot.y), result.x, result.y};
}

}  // namespace gjkscope
