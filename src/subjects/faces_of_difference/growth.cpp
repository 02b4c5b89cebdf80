#include "subjects/faces_of_difference/growth.hpp"

#include <algorithm>

#include "exact/instances.hpp"
#include "subjects/faces_of_difference/faces.hpp"
#include "subjects/growth/random.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr std::array<int, 5> kFaceSizes = {8, 20, 50, 100, 200};
constexpr int kFaceSeed = 1998;

Points sphere(Random& random, int count) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(on_sphere(random));
  return points;
}

/// A polygon around the axis, one corner in each part of its circle, and two tips close to it.
Points lens(Random& random, int count, int axis) {
  constexpr double kThin = 0.05;
  constexpr double kPlay = 0.8;  // of a part
  Points points;
  for (int i = 0; i < count - 2; ++i) {
    const Eigen::Vector2d corner = on_circle(4.0 * (i + random.uniform(0.0, kPlay)) / (count - 2));
    Vector3d point = Vector3d::Zero();
    point[(axis + 1) % 3] = corner.x();
    point[(axis + 2) % 3] = corner.y();
    points.push_back(point);
  }
  for (const double side : {-kThin, kThin}) points.emplace_back(side * Vector3d::Unit(axis));
  return points;
}

/// Faces of Z, and support points of a run with Y moved away.
std::pair<int, int> counted(const Points& x, Points y) {
  for (Vector3d& point : y) point += Vector3d(0.7, 0.5, 2.5);
  gjk::Options options;
  options.proof = gjk::Proof::none;
  options.start.count = 1;
  const gjk::Trace<double, 3> trace = gjk::trace<double>(gjk::Query<double, 3>{{x}, {y}}, options);
  const auto asked = std::count_if(trace.steps.begin(), trace.steps.end(), [](const auto& step) {
    return step.phase == gjk::Phase::support;
  });
  const std::vector<sums_in_space::Face> faces =
      sums_in_space::faces_of_difference(x, exact_hull(x), y, exact_hull(y));
  return {static_cast<int>(faces.size()), static_cast<int>(asked)};
}

}  // namespace

FaceGrowth::Value FaceGrowth::compute(EffectGraph&, const LessonRun&, const Frame&) {
  Random random(kFaceSeed);
  Value samples;
  for (const int n : kFaceSizes) {
    Sample sample{.vertices = n};
    const Points ball = sphere(random, n);
    std::tie(sample.of_spheres, sample.asked_of_spheres) = counted(ball, sphere(random, n));
    const Points flat = lens(random, n, 0);
    std::tie(sample.of_lenses, sample.asked_of_lenses) = counted(flat, lens(random, n, 1));
    samples.push_back(sample);
  }
  return samples;
}

Lenses crossing_lenses() {
  Random random(kFaceSeed);
  return {{lens(random, Lenses::kVertices, 0), lens(random, Lenses::kVertices, 1)}};
}

Plot faces_plot(const FaceGrowth::Value& samples) {
  Plot plot;
  plot.x = {1.0, 1e3, true, "vertices n of each body"};
  plot.y = {1.0, 1e5, true, "faces of Z, and points asked for"};
  plot.series = {{PlotStyle::fourth, "faces, lenses", {}},
                 {PlotStyle::third, "faces, spheres", {}},
                 {PlotStyle::second, "asked, lenses", {}},
                 {PlotStyle::first, "asked, spheres", {}}};
  for (const FaceGrowth::Sample& sample : samples) {
    const std::array<int, 4> counts = {sample.of_lenses, sample.of_spheres, sample.asked_of_lenses,
                                       sample.asked_of_spheres};
    for (std::size_t i = 0; i < counts.size(); ++i)
      plot.series[i].points.emplace_back(sample.vertices, counts[i]);
  }
  return plot;
}

}  // namespace gjkscope
