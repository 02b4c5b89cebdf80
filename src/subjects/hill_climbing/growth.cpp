#include "subjects/hill_climbing/growth.hpp"

#include "exact/instances.hpp"
#include "outlines/polyhedron.hpp"
#include "subjects/growth/random.hpp"
#include "subjects/hill_climbing/climb.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;

constexpr std::array<int, 7> kClimbSizes = {8, 30, 100, 300, 1000, 3000, 10000};
constexpr int kClimbSeed = 2010;

ClimbGrowth::Sample measured(Random& random, int vertices) {
  std::vector<Vector3d> points;
  for (int i = 0; i < vertices; ++i) points.push_back(on_sphere(random));
  const climbing::Neighbours neighbours = neighbours_of(exact_hull(points), points.size());
  ClimbGrowth::Sample sample{.vertices = vertices};
  int later = 0;
  gjk::Options options;
  options.proof = gjk::Proof::none;
  options.start.count = 1;
  for (int i = 0; i < ClimbGrowth::kRuns; ++i) {
    const double away = random.uniform(1.2, 3.0);  // first: a compiler may take either
    const std::vector<Vector3d> query = {away * on_sphere(random)};
    const gjk::Trace<double, 3> trace =
        gjk::trace<double>(gjk::Query<double, 3>{{query}, {points}}, options);
    int at = 0;
    bool is_first = true;
    for (const gjk::Step<double, 3>& step : trace.steps) {
      if (step.phase != gjk::Phase::support) continue;
      const climbing::Walk walk = climbing::walk(points, neighbours, step.after.d, at);
      at = walk.end();
      (is_first ? sample.first : sample.later) += walk.products();
      if (is_first) sample.first_moves += static_cast<double>(walk.looks.size()) - 1.0;
      if (!is_first) ++later;
      is_first = false;
    }
  }
  sample.first /= ClimbGrowth::kRuns;
  sample.first_moves /= ClimbGrowth::kRuns;
  sample.later /= std::max(later, 1);
  return sample;
}

}  // namespace

ClimbGrowth::Value ClimbGrowth::compute(EffectGraph&, const LessonRun&, const Frame&) {
  Random random(kClimbSeed);
  Value samples;
  for (const int vertices : kClimbSizes) samples.push_back(measured(random, vertices));
  return samples;
}

Plot climb_plot(const ClimbGrowth::Value& samples) {
  Plot plot;
  plot.x = {1.0, 1e4, true, "vertices n"};
  plot.y = {1.0, 1e4, true, "dot products for a support point"};
  plot.series = {{PlotStyle::fourth, "a scan", {}},
                 {PlotStyle::second, "a walk from any vertex", {}},
                 {PlotStyle::first, "a walk from the last support point", {}}};
  for (const ClimbGrowth::Sample& sample : samples) {
    plot.series[0].points.emplace_back(sample.vertices, sample.vertices);
    plot.series[1].points.emplace_back(sample.vertices, sample.first);
    plot.series[2].points.emplace_back(sample.vertices, sample.later);
  }
  return plot;
}

}  // namespace gjkscope
