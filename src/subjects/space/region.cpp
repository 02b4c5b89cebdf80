#include "subjects/space/region.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "run/facts.hpp"
#include "run/questions.hpp"
#include "subjects/space/subject.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;

/// The weight of a vertex in P's combination, if only this face counted, for a query point at q. It
/// is affine in q.
double weight_at(const WideSimplex& simplex, gjk::Face face, int vertex, const Vector3d& q) {
  WideSimplex moved = simplex;
  for (int i = 0; i < moved.count; ++i) moved.vertices[i].w -= q;
  const gjk::Barycentric<double, 3> weights = gjk::barycentric(moved, face);
  return weights.numerator[vertex] / weights.denominator;
}

/// The half-space in which that weight is positive, or the other one.
HalfSpace where(const WideSimplex& simplex, const RegionCondition& condition, double unit) {
  const auto& [face, vertex, wants_positive] = condition;
  const double at_origin = weight_at(simplex, face, vertex, Vector3d::Zero());
  Vector3d slope;
  for (int i = 0; i < 3; ++i)
    slope[i] = (weight_at(simplex, face, vertex, unit * Vector3d::Unit(i)) - at_origin) / unit;
  const double scale = (wants_positive ? 1.0 : -1.0) / slope.norm();
  return {scale * slope, -scale * at_origin};
}

/// Corners of what all of them have in common, which must be bounded; each once, though more than
/// three planes meet there.
std::vector<Vector3d> corners_of(const std::vector<HalfSpace>& spaces, double slack) {
  std::vector<Vector3d> out;
  const auto is_corner = [&](const Vector3d& q) {
    return std::all_of(spaces.begin(), spaces.end(),
                       [&](const HalfSpace& space) {
                         return space.normal.dot(q) >= space.offset - slack;
                       }) &&
           std::none_of(out.begin(), out.end(),
                        [&](const Vector3d& other) { return (other - q).norm() <= slack; });
  };
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    for (std::size_t j = i + 1; j < spaces.size(); ++j) {
      for (std::size_t k = j + 1; k < spaces.size(); ++k) {
        const auto& [a, of_a] = spaces[i];
        const auto& [b, of_b] = spaces[j];
        const auto& [c, of_c] = spaces[k];
        const double volume = a.dot(b.cross(c));
        constexpr double kParallel = 1e-9;
        if (std::abs(volume) < kParallel) continue;
        const Vector3d q = (of_a * b.cross(c) + of_b * c.cross(a) + of_c * a.cross(b)) / volume;
        if (is_corner(q)) out.push_back(q);
      }
    }
  }
  return out;
}

const WideSimplex& tested_simplex(const LessonRun& run, const Frame& frame) {
  return state_before(run.run(frame).trace, std::max(run.gjk_step(frame), 0)).simplex;
}

}  // namespace

SolidPart cut_off(std::vector<HalfSpace> spaces, const Vector3d& middle, double radius) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Vector3d inwards = Vector3d(x, y, z).normalized();
        spaces.push_back({inwards, inwards.dot(middle) - radius});
      }
    }
  }
  constexpr double kSlack = 1e-9;
  SolidPart part{corners_of(spaces, kSlack * radius), {}};
  if (!part.points.empty()) part.hull = hull_in_space(part.points);
  return part;
}

std::vector<RegionCondition> conditions_of(const WideSimplex& simplex, gjk::Face region) {
  std::vector<RegionCondition> out;
  for (int i = 0; i < simplex.count; ++i) {
    const bool is_in = gjk::contains(region, i);
    if (is_in && gjk::vertex_count(region) == 1) continue;
    out.push_back({static_cast<gjk::Face>(region | gjk::face_of(i)), i, is_in});
  }
  return out;
}

EffectKey RegionSolid::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), frame.part};
}

RegionSolid::Value RegionSolid::compute(EffectGraph& graph, const LessonRun& run,
                                        const Frame& frame) {
  const WideSimplex& simplex = tested_simplex(run, frame);
  const FrameFacts::Value& knows = graph.get<FrameFacts>(frame);
  const bool is_testing = knows.gradual && knows.tests_reached >= 0;
  if (simplex.count < 4 || !(is_testing || knows.closest_point)) return {};
  const gjk::Face region =
      is_testing ? knows.region_tests[knows.tests_reached].region : run.state(frame).region;
  Vector3d middle = Vector3d::Zero();
  for (int i = 0; i < 4; ++i) middle += 0.25 * simplex.vertices[i].w;
  double radius = 0.0;
  for (int i = 0; i < 4; ++i) radius = std::max(radius, (simplex.vertices[i].w - middle).norm());
  std::vector<HalfSpace> spaces;
  for (const RegionCondition& condition : conditions_of(simplex, region))
    spaces.push_back(where(simplex, condition, radius));
  constexpr double kReach = 1.7;  // of the simplex
  return cut_off(std::move(spaces), middle, kReach * radius);
}

EffectKey FacesBefore::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), -1};
}

FacesBefore::Value FacesBefore::compute(EffectGraph& graph, const LessonRun&, const Frame& frame) {
  const BarycentricWeights::Value& weights = graph.get<BarycentricWeights>(frame);
  Value out;
  for (std::size_t i = 0; i < weights.weights.size(); ++i) {
    if (weights.weights[i] < 0.0)
      out.push_back(
          static_cast<gjk::Face>(weights.simplex.all() & ~gjk::face_of(static_cast<int>(i))));
  }
  return out;
}

const EffectInfo effect_infos::kRegionSolid = shown_of(
    ShownOf::space,
    effect_info<RegionSolid>("view", "in space: the Voronoi region that holds the query point"));

const EffectInfo effect_infos::kFacesBefore =
    shown_of(ShownOf::space,
             effect_info<FacesBefore>(
                 "view", "in space: the faces of the simplex that the query point lies beyond"));

}  // namespace gjkscope
