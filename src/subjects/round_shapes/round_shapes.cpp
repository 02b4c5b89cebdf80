#include "subjects/round_shapes/round_shapes.hpp"

#include "subjects/round_shapes/subject.hpp"

namespace gjkscope {

EffectKey RoundShapes::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

RoundShapes::Value RoundShapes::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const double of_x = run.lesson.x().radius;
  const double of_y = run.lesson.y().radius;
  const PositionedRun& positioned = run.run(frame);
  const WideResult& result = positioned.trace.result;
  Value answer{of_x + of_y, result.distance - (of_x + of_y), Meeting::touching, result.x, result.y};
  if (positioned.bounds.empty()) return answer;
  const auto& [lower, upper] = positioned.bounds.back();
  if (lower > answer.radii) answer.meeting = Meeting::apart;
  if (upper < answer.radii) answer.meeting = Meeting::overlapping;
  if (result.distance > 0.0) {
    const Eigen::Vector3d towards_y = (result.y - result.x).normalized();
    answer.x += of_x * towards_y;
    answer.y -= of_y * towards_y;
  }
  return answer;
}

const EffectInfo effect_infos::kRoundShapes = effect_info<RoundShapes>(
    "frame", "the distance of shapes with a radius: GJK's, less the radii");

}  // namespace gjkscope
