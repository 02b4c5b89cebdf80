#include "subjects/weights/projection.hpp"

#include "subjects/weights/barycentric.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope {

using Eigen::Vector3d;

EffectKey Projection::key(const LessonRun& run, const Frame& frame) {
  return BarycentricWeights::key(run, frame);
}

Projection::Value Projection::compute(EffectGraph& graph, const LessonRun&, const Frame& frame) {
  const BarycentricWeights::Value& coordinates = graph.get<BarycentricWeights>(frame);
  if (coordinates.simplex.count != 2 || coordinates.weights.empty()) return std::nullopt;
  return Vector3d(coordinates.weights[0] * coordinates.simplex.vertices[0].w +
                  coordinates.weights[1] * coordinates.simplex.vertices[1].w);
}

EffectKey UnitVector::key(const LessonRun& run, const Frame& frame) {
  return BarycentricWeights::key(run, frame);
}

UnitVector::Value UnitVector::compute(EffectGraph& graph, const LessonRun&, const Frame& frame) {
  const Projection::Value& g = graph.get<Projection>(frame);
  if (!g) return std::nullopt;
  const WideSimplex& simplex = graph.get<BarycentricWeights>(frame).simplex;
  const Vector3d& a = simplex.vertices[0].w;
  const Vector3d& b = simplex.vertices[1].w;
  const Vector3d q = Vector3d::Zero();
  Built built;
  built.length = (b - a).norm();
  built.n = (b - a) / built.length;
  const auto lengths = [&](const Vector3d& point) {
    return Lengths{(b - point).dot(built.n), (point - a).dot(built.n)};
  };
  built.of_g = lengths(*g);
  built.of_q = lengths(q);
  return built;
}

const EffectInfo effect_infos::kProjection = effect_info<Projection>(
    "view", "the line through a segment, and the point G = uA + vB where Q falls on it");

const EffectInfo effect_infos::kUnitVector =
    effect_info<UnitVector>("view", "n = (B - A) / length, drawn from A");

}  // namespace gjkscope
