#include "subjects/faces_of_difference/growth.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "depth/instances.hpp"
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

gjk::Options counted_options() {
  gjk::Options options;
  options.proof = gjk::Proof::none;
  options.start.count = 1;
  return options;
}

/// Faces of Z, and support points of a run with Y moved away.
std::pair<int, int> counted(const Points& x, Points y) {
  for (Vector3d& point : y) point += Vector3d(0.7, 0.5, 2.5);
  const gjk::Options options = counted_options();
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
    const Points other = sphere(random, n);
    std::tie(sample.of_spheres, sample.asked_of_spheres) = counted(ball, other);
    sample.asked_for_depth =
        depth::penetration<double>(gjk::Query<double, 3>{{ball}, {other}}, counted_options())
            .iterations;
    const Points flat = lens(random, n, 0);
    std::tie(sample.of_lenses, sample.asked_of_lenses) = counted(flat, lens(random, n, 1));
    samples.push_back(sample);
  }
  return samples;
}

CountedBodies crossing_lenses() {
  constexpr int kCount = CountedBodies::kVertices;
  Random random(kFaceSeed);
  return {{lens(random, kCount, 0), lens(random, kCount, 1)}};
}

CountedBodies spheres() {
  constexpr int kCount = CountedBodies::kVertices;
  Random random(kFaceSeed);
  return {{sphere(random, kCount), sphere(random, kCount)}};
}

const FaceGrowth::Sample& asked_from(const FaceGrowth::Value& samples) { return samples[1]; }

GrowthQuestion question_of(Growing growing, const FaceGrowth::Value& samples) {
  const FaceGrowth::Sample& last = samples.back();
  const FaceGrowth::Sample& before = asked_from(samples);
  const double n = last.vertices;
  switch (growing) {
    case Growing::faces: {
      const double more = n / before.vertices;
      return {n,
              1.0 * before.of_lenses,
              1.0 * last.of_lenses,
              {{{"hardly more", 1.1}, {"as n", more}, {"as n²", more * more}}}};
    }
    case Growing::depth:
      return {n,
              1.0,
              1.0 * last.asked_for_depth,
              {{{"a few", 1.0 * last.asked_of_spheres},
                {"about n", n},
                {"all faces", 1.0 * last.of_spheres}}}};
    case Growing::general:
      break;
  }
  constexpr double kVertices = 20.0;
  const double square = kVertices * kVertices;
  return {kVertices,
          1.0,
          square * square * square,
          {{{"n²", square}, {"n⁴", square * square}, {"n⁶", square * square * square}}}};
}

Plot faces_plot(Growing growing, bool asks, const FaceGrowth::Value& samples) {
  using Sample = FaceGrowth::Sample;
  Plot plot;
  plot.x = {1.0, 1e3, true, "vertices n of each body"};
  plot.y = {1.0, growing == Growing::general ? 1e9 : 1e5, true, ""};
  const auto count = [&](PlotStyle style, std::string name, int Sample::*counted, bool is_shown) {
    PlotSeries series{style, std::move(name), {}};
    for (const Sample& sample : samples) {
      if (!is_shown && sample.vertices > asked_from(samples).vertices) break;
      series.points.emplace_back(sample.vertices, sample.*counted);
    }
    plot.series.push_back(std::move(series));
  };
  /// The power of n, as far as the plot reaches.
  const auto power = [&](int exponent, const std::string& name) {
    const double end = std::min(plot.x.high, std::pow(plot.y.high, 1.0 / exponent));
    const Eigen::Vector2d top(end, std::pow(end, exponent));
    plot.series.push_back({PlotStyle::limit, "", {{1.0, 1.0}, top}, PlotJoin::lines, false});
    plot.notes.push_back({PlotStyle::limit, top, name});
  };
  switch (growing) {
    case Growing::faces:
      plot.y.title = "faces of Z, and points asked for";
      count(PlotStyle::fourth, "faces, lenses", &Sample::of_lenses, !asks);
      count(PlotStyle::third, "faces, spheres", &Sample::of_spheres, true);
      count(PlotStyle::second, "asked, lenses", &Sample::asked_of_lenses, true);
      count(PlotStyle::first, "asked, spheres", &Sample::asked_of_spheres, true);
      break;
    case Growing::depth:
      plot.y.title = "spheres: faces of Z, and points asked for";
      count(PlotStyle::third, "faces", &Sample::of_spheres, !asks);
      if (!asks) count(PlotStyle::second, "for the depth", &Sample::asked_for_depth, true);
      count(PlotStyle::first, "for the distance", &Sample::asked_of_spheres, !asks);
      break;
    case Growing::general:
      plot.y.title = "faces of Z, and powers of n";
      count(PlotStyle::fourth, "faces, lenses", &Sample::of_lenses, true);
      if (asks) break;
      power(2, "n²");
      power(6, "n⁶");
      break;
  }
  if (asks) {
    const GrowthQuestion question = question_of(growing, samples);
    add_choices(plot, question.vertices, question.before, question.choices);
  }
  return plot;
}

}  // namespace gjkscope
