#include "subjects/walk_in_space/growth.hpp"

#include <array>
#include <cmath>

#include "exact/instances.hpp"
#include "outlines/v_clip.hpp"
#include "subjects/growth/random.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;

constexpr std::array<int, 7> kWalkSizes = {8, 30, 100, 300, 1000, 3000, 10000};
constexpr int kWalkSeed = 1991;
constexpr int kBits = 20;  // of a coordinate

double on_lattice(double value) { return std::ldexp(std::round(std::ldexp(value, kBits)), -kBits); }

std::vector<Vector3d> ball(Random& random, int count) {
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) points.push_back(on_sphere(random).unaryExpr(&on_lattice));
  return points;
}

SpaceWalkGrowth::Sample passing(Random& random, int vertices) {
  const std::vector<Vector3d> x = ball(random, vertices);
  const std::vector<Vector3d> y = ball(random, vertices);
  const v_clip::Body of_x = v_clip::body_of(x);
  v_clip::Body of_y = v_clip::body_of(y);
  const v_clip::Query walked{of_x, of_y};
  SpaceWalkGrowth::Sample sample{.vertices = vertices};
  v_clip::State start = v_clip::start(walked);
  gjk::Options cold;
  cold.proof = gjk::Proof::none;
  cold.start.count = 1;
  gjk::Options warm = cold;
  for (int i = 0; i <= SpaceWalkGrowth::kPositions; ++i) {
    const Vector3d shift(2.5, 0.0625 * i - 0.625, 0.03125 * i);
    for (std::size_t k = 0; k < y.size(); ++k) of_y.points[k] = y[k] + shift;
    const v_clip::Result result = v_clip::walk(walked, start);
    start = v_clip::start(walked, result.x, result.y);
    const gjk::Query<double, 3> query{{of_x.points}, {of_y.points}};
    const auto from_last = gjk::trace<double>(query, warm).result;
    warm.start = from_last.warm();
    if (i == 0) continue;
    sample.pairs += result.pairs;
    sample.warm += from_last.iterations;
    sample.cold += gjk::trace<double>(query, cold).result.iterations;
  }
  for (double* sum : {&sample.pairs, &sample.warm, &sample.cold})
    *sum /= SpaceWalkGrowth::kPositions;
  return sample;
}

}  // namespace

SpaceWalkGrowth::Value SpaceWalkGrowth::compute(EffectGraph&, const LessonRun&, const Frame&) {
  Random random(kWalkSeed);
  Value samples;
  for (const int vertices : kWalkSizes) samples.push_back(passing(random, vertices));
  return samples;
}

Plot space_walk_plot(const SpaceWalkGrowth::Value& samples) {
  Plot plot;
  plot.x = {1.0, 1e4, true, "vertices n of each body"};
  plot.y = {0.0, 20.0, false, "steps a position"};
  plot.series = {{PlotStyle::fourth, "iterations of GJK, cold", {}},
                 {PlotStyle::second, "iterations of GJK, warm", {}},
                 {PlotStyle::first, "pairs of Lin-Canny", {}}};
  for (const SpaceWalkGrowth::Sample& sample : samples) {
    plot.series[0].points.emplace_back(sample.vertices, sample.cold);
    plot.series[1].points.emplace_back(sample.vertices, sample.warm);
    plot.series[2].points.emplace_back(sample.vertices, sample.pairs);
  }
  return plot;
}

}  // namespace gjkscope
