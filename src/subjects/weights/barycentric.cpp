#include "subjects/weights/barycentric.hpp"

#include "run/questions.hpp"
#include "run/scalar.hpp"
#include "run/widen.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope {
namespace {

/// The last closest-point step up to the frame's: its simplex still has all vertices.
int closest_step(const LessonRun& run, const Frame& frame) {
  int step = run.gjk_step(frame);
  while (step > 0 && run.run(frame).trace.steps[step].phase != gjk::Phase::closest) --step;
  return step;
}

template <class S, int D>
std::vector<double> weights_of(const WideSimplex& wide, int exponent) {
  const gjk::Simplex<S, D> simplex = narrowed_simplex<S, D>(wide, exponent);
  const gjk::Barycentric<S, D> coordinates = gjk::barycentric(simplex, simplex.all());
  std::vector<double> out;
  if (!(S(0) < coordinates.denominator)) return out;
  for (int i = 0; i < simplex.count; ++i)
    out.push_back(widened(S(coordinates.numerator[i] / coordinates.denominator)));
  return out;
}

}  // namespace

EffectKey BarycentricWeights::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, closest_step(run, frame), -1};
}

BarycentricWeights::Value BarycentricWeights::compute(EffectGraph&, const LessonRun& run,
                                                      const Frame& frame) {
  Value value;
  value.simplex = state_before(run.run(frame).trace, closest_step(run, frame) + 1).simplex;
  if (value.simplex.count == 0) return value;  // a refused run
  with_scalar(run.lesson.scalar, [&]<class S>(std::type_identity<S>) {
    const int exponent = run.run(frame).exponent;
    value.weights = run.lesson.dimension == 3 ? weights_of<S, 3>(value.simplex, exponent)
                                              : weights_of<S, 2>(value.simplex, exponent);
  });
  return value;
}

EffectKey BarycentricParts::key(const LessonRun& run, const Frame& frame) {
  return BarycentricWeights::key(run, frame);
}

BarycentricParts::Value BarycentricParts::compute(EffectGraph& graph, const LessonRun&,
                                                  const Frame& frame) {
  const BarycentricWeights::Value& coordinates = graph.get<BarycentricWeights>(frame);
  const WideSimplex& simplex = coordinates.simplex;
  Value parts;
  if (coordinates.weights.empty() || simplex.count < 2) return parts;
  Eigen::Vector3d query = Eigen::Vector3d::Zero();
  if (simplex.count == 2) {
    query = coordinates.weights[0] * simplex.vertices[0].w +
            coordinates.weights[1] * simplex.vertices[1].w;
  }
  for (int i = 0; i < simplex.count; ++i) {
    Part part{i, coordinates.weights[i], {query}};
    for (int k = 1; k < simplex.count; ++k)
      part.points.push_back(simplex.vertices[(i + k) % simplex.count].w);
    parts.push_back(std::move(part));
  }
  return parts;
}

const EffectInfo effect_infos::kBarycentricWeights =
    effect_info<BarycentricWeights>("panel", "barycentric coordinates of the query point, signed");

const EffectInfo effect_infos::kBarycentricParts =
    effect_info<BarycentricParts>("view", "the lengths or areas that the coordinates measure");

}  // namespace gjkscope
