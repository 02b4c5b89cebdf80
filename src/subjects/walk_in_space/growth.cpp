#include "subjects/walk_in_space/growth.hpp"

#include <array>
#include <cmath>
#include <string>
#include <utility>

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

/// Y on its way past X; `moves`: the size of all its moves.
Vector3d shift_at(int position, double moves) {
  return {2.5, moves * (0.0625 * position - 0.625), moves * 0.03125 * position};
}

SpaceWalkGrowth::Sample passing(Random& random, int vertices) {
  constexpr int kPositions = SpaceWalkGrowth::kPositions;
  const std::vector<Vector3d> x = ball(random, vertices);
  const std::vector<Vector3d> y = ball(random, vertices);
  const v_clip::Body of_x = v_clip::body_of(x);
  v_clip::Body of_y = v_clip::body_of(y);
  const v_clip::Query walked{of_x, of_y};
  SpaceWalkGrowth::Sample sample{.vertices = vertices};
  const auto move = [&](const Vector3d& shift) {
    for (std::size_t k = 0; k < y.size(); ++k) of_y.points[k] = y[k] + shift;
  };
  v_clip::State start = v_clip::start(walked);
  gjk::Options cold;
  cold.proof = gjk::Proof::none;
  cold.start.count = 1;
  gjk::Options warm = cold;
  for (int i = 0; i <= kPositions; ++i) {
    move(shift_at(i, 1.0));
    const v_clip::Result result = v_clip::walk(walked, start);
    start = v_clip::start(walked, result.x, result.y);
    const gjk::Query<double, 3> query{{of_x.points}, {of_y.points}};
    const auto from_last = gjk::trace<double>(query, warm).result;
    warm.start = from_last.warm();
    if (i == 0) continue;
    sample.pairs += result.pairs;
    sample.warm += from_last.iterations;
    sample.cold += gjk::trace<double>(query, cold).result.iterations;
    sample.first_pair += v_clip::walk(walked, v_clip::start(walked)).pairs;
  }
  // Features are as wide as 1 / √n: a power of two close to that, so that moves do not round.
  const double narrow = std::exp2(-std::round(0.5 * std::log2(1.0 * vertices / kWalkSizes[0])));
  start = v_clip::start(walked);
  for (int i = 0; i <= kPositions; ++i) {
    move(shift_at(i, narrow));
    const v_clip::Result result = v_clip::walk(walked, start);
    start = v_clip::start(walked, result.x, result.y);
    if (i > 0) sample.small_moves += result.pairs;
  }
  for (double* sum :
       {&sample.pairs, &sample.warm, &sample.cold, &sample.small_moves, &sample.first_pair})
    *sum /= kPositions;
  return sample;
}

}  // namespace

SpaceWalkGrowth::Value SpaceWalkGrowth::compute(EffectGraph&, const LessonRun&, const Frame&) {
  Random random(kWalkSeed);
  Value samples;
  for (const int vertices : kWalkSizes) samples.push_back(passing(random, vertices));
  return samples;
}

const SpaceWalkGrowth::Sample& asked_from(const SpaceWalkGrowth::Value& samples) {
  constexpr std::size_t kFrom = 2;  // a hundredth of the largest size
  return samples[kFrom];
}

std::array<GrowthChoice, 3> growth_choices_of(const SpaceWalkGrowth::Value& samples) {
  const double n = 1.0 * samples.back().vertices / asked_from(samples).vertices;
  return {{{"hardly", 1.2}, {"as √n", std::sqrt(n)}, {"as n", n}}};
}

double SpaceWalkGrowth::Sample::*counted_for(WalkGrowing growing) {
  return growing == WalkGrowing::cold ? &SpaceWalkGrowth::Sample::first_pair
                                      : &SpaceWalkGrowth::Sample::small_moves;
}

Plot space_walk_plot(WalkGrowing growing, bool asks, const SpaceWalkGrowth::Value& samples) {
  using Sample = SpaceWalkGrowth::Sample;
  Plot plot;
  const double most = samples.back().vertices;
  plot.x = {1.0, most, true, "vertices n of each body"};
  const auto count = [&](PlotStyle style, std::string name, double Sample::*counted,
                         bool is_shown = true) {
    PlotSeries series{style, std::move(name), {}};
    for (const Sample& sample : samples) {
      if (!is_shown && sample.vertices > asked_from(samples).vertices) break;
      series.points.emplace_back(sample.vertices, sample.*counted);
    }
    plot.series.push_back(std::move(series));
  };
  if (growing == WalkGrowing::beside_gjk) {
    plot.y = {0.0, 20.0, false, "steps a position"};
    count(PlotStyle::fourth, "iterations of GJK, cold", &Sample::cold);
    count(PlotStyle::second, "iterations of GJK, warm", &Sample::warm);
    count(PlotStyle::first, "pairs of Lin-Canny", &Sample::pairs);
    return plot;
  }
  const bool is_cold = growing == WalkGrowing::cold;
  plot.y = {1.0, is_cold ? most * most : most, true, "pairs of Lin-Canny a position"};
  if (is_cold) count(PlotStyle::fourth, "from the first vertices", &Sample::first_pair, !asks);
  count(PlotStyle::second, "from the last pair, moves as small as features", &Sample::small_moves,
        is_cold || !asks);
  count(PlotStyle::first, "from the last pair, one move for all n", &Sample::pairs);
  for (int power = 1; power <= (is_cold ? 2 : 1); ++power) {
    const Eigen::Vector2d end(most, std::pow(most, power));
    plot.series.push_back({PlotStyle::limit, "", {{1.0, 1.0}, end}, PlotJoin::lines, false});
    plot.notes.push_back({PlotStyle::limit, end, power == 1 ? "n" : "n²"});
  }
  if (asks)
    add_choices(plot, most, asked_from(samples).*counted_for(growing), growth_choices_of(samples));
  return plot;
}

}  // namespace gjkscope
