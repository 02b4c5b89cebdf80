#include "subjects/weights/projection.hpp"

#include "subjects/weights/barycentric.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope {

using Eigen::Vector2d;

EffectKey Projection::key(const LessonRun& run, const Frame& frame) {
  return BarycentricWeights::key(run, frame);
}

Projection::Value Projection::compute(EffectGraph& graph, const LessonRun&, const Frame& frame) {
  const BarycentricWeights::Value& coordinates = graph.get<BarycentricWeights>(frame);
  if (coordinates.simplex.count != 2 || coordinates.weights.empty()) return std::nullopt;
  return Vector2d(coordinates.weights[0] * coordinates.simplex.vertices[0].w +
                  coordinates.weights[1] * coordinates.simplex.vertices[1].w);
}

EffectKey UnitVector::key(const LessonRun& run, const Frame& frame) {
  return BarycentricWeights::key(run, frame);
}

UnitVector::Value UnitVector::compute(EffectGraph& graph, const LessonRun&, const Frame& frame) {
  const Projection::Value& g = graph.get<Projection>(frame);
  if (!g) return std::nullopt;
  const gjk::Simplex<double, 2>& simplex = graph.get<BarycentricWeights>(frame).simplex;
  const Vector2d a = simplex.vertices[0].w;
  const Vector2d b = simplex.vertices[1].w;
  const Vector2d q = Vector2d::Zero();
  Built built;
  built.length = (b - a).norm();
  built.n = (b - a) / built.length;
  const auto lengths = [&](const Vector2d& point) {
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
