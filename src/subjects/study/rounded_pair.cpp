#include "subjects/study/rounded_pair.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "exact/instances.hpp"
#include "subjects/study/subject.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using Gap = RoundedPair::Gap;
using Vertex = RoundedPair::Vertex;

/// The vertex that the closest points of a run are at: that of Y, unless only X has a single one.
Vertex closest_vertex(const PositionedRun& run) {
  const WideSimplex& simplex = run.trace.result.simplex;
  const gjk::VertexPair first = simplex.vertices[0].pair;
  const auto all = [&](auto is_same) {
    return std::all_of(simplex.vertices.begin(), simplex.vertices.begin() + simplex.count,
                       [&](const auto& vertex) { return is_same(vertex.pair); });
  };
  const bool one_of_y = all([&](gjk::VertexPair pair) { return pair.y == first.y; });
  const bool one_of_x = all([&](gjk::VertexPair pair) { return pair.x == first.x; });
  return !one_of_y && one_of_x ? Vertex{true, first.x} : Vertex{false, first.y};
}

Gap gap_at(const PositionedRun& run, const Vertex& vertex) {
  const std::vector<Vector2d> other = in_plane(vertex.of_x ? run.y().world : run.x().world);
  const std::vector<Vector2d> point = {vertex_in_world(run, vertex)};
  const gjk::Query<double, 2> query{{point}, {other}};
  const gjk::Result<double, 2> result = gjk::distance(query);
  return {point[0], result.y, result.distance};
}

/// The edge of one shape on which the run ended, and the one between two vertices of the other.
std::vector<Vertex> facing_edges(const PositionedRun& run, const Vertex& a, const Vertex& b) {
  const WideSimplex& simplex = run.trace.result.simplex;
  if (a.of_x != b.of_x || a.index == b.index || simplex.count != 2) return {};
  std::vector<Vertex> out;
  for (int i = 0; i < 2; ++i) {
    const gjk::VertexPair pair = simplex.vertices[i].pair;
    out.push_back({!a.of_x, a.of_x ? pair.y : pair.x});
  }
  if (out[0].index == out[1].index) return {};
  out.push_back(a);
  out.push_back(b);
  return out;
}

}  // namespace

EffectKey RoundedPair::key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }

RoundedPair::Value RoundedPair::compute(EffectGraph&, const LessonRun& run, const Frame&) {
  const PositionedRun& given = run.runs.front();
  const gjk::Options options = started_as(given, run.lesson.options);
  Value value{run_again(given, options, ScalarKind::exact),
              run_again(given, options, ScalarKind::single),
              run_again(given, options, ScalarKind::double_),
              {},
              {}};
  const PositionedRun* ends[] = {&value.exact, &value.in_float};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vertex vertex = closest_vertex(*ends[i]);
    value.ends[i] = {vertex, gap_at(value.exact, vertex), gap_at(value.in_float, vertex)};
  }
  value.facing =
      facing_edges(value.exact, closest_vertex(value.exact), closest_vertex(value.in_float));
  if (!value.facing.empty()) {
    const auto at = [&](std::size_t i) { return vertex_in_world(value.exact, value.facing[i]); };
    const Vector2d u = (at(1) - at(0)).normalized();
    const Vector2d v = (at(3) - at(2)).normalized();
    value.tilt = std::abs(u.x() * v.y() - u.y() * v.x());
  }
  return value;
}

Vector2d vertex_in_world(const PositionedRun& run, const RoundedPair::Vertex& vertex) {
  const Body& body = vertex.of_x ? run.x() : run.y();
  return in_plane(body.world[vertex.index]);
}

double spacing_of_floats(double value) {
  const auto at = static_cast<float>(std::abs(value));
  return static_cast<double>(std::nextafter(at, INFINITY)) - static_cast<double>(at);
}

double RoundedPair::Value::magnification() const {
  constexpr double kShare = 0.25;  // of the shapes' size that the spacing shall look like
  const double spacing = spacing_of_floats(ends[0].exact.vertex.lpNorm<Eigen::Infinity>());
  Eigen::AlignedBox2d seen;
  for (const auto* points : {&exact.x().world, &exact.y().world}) {
    for (const Vector2d& point : in_plane(*points)) seen.extend(point);
  }
  const double wanted = std::max(1.0, kShare * seen.sizes().maxCoeff() / spacing);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  return power * (wanted >= 5.0 * power ? 5.0 : wanted >= 2.0 * power ? 2.0 : 1.0);
}

double error_of(double answer, double distance) {
  const double error = std::abs(answer - distance);
  return error > 0.0 ? error / std::max(answer, distance) : 0.0;
}

const EffectInfo effect_infos::kRoundedPair =
    effect_info<RoundedPair>("panel", "the same query as floats and doubles keep it, and exactly");

}  // namespace gjkscope
