#include "subjects/growth/growth.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "exact/instances.hpp"
#include "exact/rational.hpp"
#include "outlines/minkowski.hpp"
#include "subjects/growth/random.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;

/// Vertices that are made for one size at least: small polygons are made anew for each run, of the
/// largest one pair stands in many poses.
constexpr int kMadeVertices = 200'000;

/// Corners at random places of an ellipse, one in each of `count` parts of it, so that rounding
/// leaves every corner convex.
std::vector<Vector2d> random_polygon(Random& random, int count) {
  constexpr double kPlay = 0.8;  // of a part; the rest keeps neighbours apart
  const double narrow = random.uniform(0.4, 1.0);
  std::vector<Vector2d> corners;
  corners.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Vector2d corner = on_circle(4.0 * (i + random.uniform(0.0, kPlay)) / count);
    corners.emplace_back(corner.x(), narrow * corner.y());
  }
  return corners;
}

/// Anywhere around the origin: farther than two polygons of radius 1 reach, up to twice as far.
gjk::Pose<double, 2> random_pose(Random& random) {
  constexpr double kNear = 2.05;
  const Vector2d turn = on_circle(random.uniform(0.0, 4.0));
  const Vector2d bearing = on_circle(random.uniform(0.0, 4.0));
  gjk::Pose<double, 2> pose;
  pose.rotation = Eigen::Matrix2d{{turn.x(), -turn.y()}, {turn.y(), turn.x()}};
  pose.translation = random.uniform(kNear, 2.0 * kNear) * bearing;
  return pose;
}

/// The first iteration after which the bounds are close enough; else the last.
int iterations_within(double tolerance, const gjk::Trace<double, 2>& trace) {
  const double part = 1.0 - tolerance;
  for (const gjk::Step<double, 2>& step : trace.steps) {
    if (step.phase == gjk::Phase::stop &&
        part * part * step.after.evidence.best_sq <= step.after.evidence.plane_distance_sq)
      return step.iteration;
  }
  return trace.result.iterations;
}

void add(Growth::Sample& sample, const gjk::Trace<double, 2>& trace, double tolerance) {
  std::set<std::pair<int, int>> touched;
  const auto touch = [&](gjk::VertexPair pair) { touched.insert({pair.x, pair.y}); };
  for (int i = 0; i < trace.initial.simplex.count; ++i)
    touch(trace.initial.simplex.vertices[i].pair);
  for (const gjk::Step<double, 2>& step : trace.steps) {
    if (step.phase != gjk::Phase::support) continue;
    touch(step.after.support.pair);
    sample.support_calls += 1.0;
    sample.seen_vertices +=
        static_cast<double>(step.record.scan_x.size() + step.record.scan_y.size());
    sample.scanned_vertices += 2.0 * sample.vertices;
  }
  sample.iterations += trace.result.iterations;
  sample.most_iterations = std::max(sample.most_iterations, trace.result.iterations);
  sample.within_tolerance += iterations_within(tolerance, trace);
  sample.touched_points += static_cast<double>(touched.size());
  ++sample.runs;
}

Growth::Example example_of(const gjk::Query<double, 2>& query, const gjk::Trace<double, 2>& trace) {
  constexpr std::size_t kMostDots = 1000;
  constexpr std::size_t kMostCorners = 400;
  const auto in_world = [](const gjk::Shape<double, 2>& shape) {
    std::vector<Vector2d> vertices;
    vertices.reserve(shape.vertices().size());
    for (const Vector2d& vertex : shape.vertices())
      vertices.emplace_back(shape.pose.rotated(vertex) + shape.pose.translation);
    return vertices;
  };
  const std::vector<Vector2d> x = in_world(query.x);
  const std::vector<Vector2d> y = in_world(query.y);
  Growth::Example example;
  if (x.size() * y.size() <= kMostDots) {
    for (const CloudPoint& point : minkowski_cloud(x, y)) example.cloud.push_back(point.z);
  }
  const std::vector<CloudPoint> corners = minkowski_merge(x, y);
  const std::size_t every = corners.size() / kMostCorners + 1;
  for (std::size_t i = 0; i < corners.size(); i += every) example.hull.push_back(corners[i].z);
  example.touched.push_back(trace.initial.simplex.vertices[0].w);
  for (const gjk::Step<double, 2>& step : trace.steps) {
    if (step.phase == gjk::Phase::support) example.touched.push_back(step.after.support.w);
  }
  example.closest = trace.result.y - trace.result.x;
  return example;
}

gjk::Options options_of(const Lesson& lesson) {
  gjk::Options options = lesson.options;
  options.start = {.count = std::min(options.start.count, 1)};
  options.proof = gjk::Proof::none;  // the iterations count, not the last digits of the answer
  return options;
}

Growth::Sample measured(Random& random, const Lesson& lesson, int vertices) {
  const gjk::Options options = options_of(lesson);
  const int runs = lesson.settings.as<LessonGrowth>()->runs;
  const int pairs = std::clamp(kMadeVertices / vertices, 1, runs);
  Growth::Sample sample;
  sample.vertices = vertices;
  for (int pair = 0; pair < pairs; ++pair) {
    const gjk::MeasuredShape x(random_polygon(random, vertices));
    const gjk::MeasuredShape y(random_polygon(random, vertices));
    gjk::Query<double, 2> query{{x}, {y}};
    sample.is_climbed = x.measures().is_ring;
    for (int i = pair; i < runs; i += pairs) {
      query.y.pose = random_pose(random);
      const gjk::Trace<double, 2> trace = gjk::trace(query, options);
      add(sample, trace, lesson.settings.as<LessonGrowth>()->tolerance);
      if (sample.runs == 1) sample.example = example_of(query, trace);
    }
  }
  for (double* sum : {&sample.iterations, &sample.within_tolerance, &sample.support_calls,
                      &sample.touched_points, &sample.seen_vertices, &sample.scanned_vertices})
    *sum /= sample.runs;
  return sample;
}

}  // namespace

bool Growth::is_same(const LessonRun& one, const LessonRun& other) {
  return one.lesson.settings == other.lesson.settings &&
         options_of(one.lesson) == options_of(other.lesson);
}

EffectKey Growth::key(const LessonRun&, const Frame&) { return {-1, -1, -1}; }

Growth::Value Growth::compute(EffectGraph&, const LessonRun& run, const Frame&) {
  Random random(run.lesson.settings.as<LessonGrowth>()->seed);
  Value samples;
  for (const int vertices : run.lesson.settings.as<LessonGrowth>()->vertices)
    samples.push_back(measured(random, run.lesson, vertices));
  return samples;
}

namespace {

/// From the outermost vertex to the innermost, on a parabola below the origin of X.
std::vector<Vector2d> slow_polygon(int count) {
  std::vector<Vector2d> found;
  for (int i = 0; i < count; ++i) {
    const double x = std::ldexp(i % 2 == 0 ? 1.0 : -1.0, -i);
    found.emplace_back(x, -0.25 * x * x);
  }
  return found;
}

const Vector2d kSlowPoint(0.0, 1.0);

gjk::Vec<Rational, 2> exactly(const Vector2d& point) {
  return {Rational(point.x()), Rational(point.y())};
}

}  // namespace

SlowGrowth::Value SlowGrowth::compute(EffectGraph&, const LessonRun& run, const Frame&) {
  gjk::Options options;
  options.proof = gjk::Proof::none;
  options.start.count = 1;
  Value runs;
  for (const int vertices : run.lesson.settings.as<LessonGrowth>()->vertices) {
    if (vertices > kMost) break;
    const std::vector<gjk::Vec<Rational, 2>> x = {exactly(kSlowPoint)};
    std::vector<gjk::Vec<Rational, 2>> y;
    for (const Vector2d& vertex : slow_polygon(vertices)) y.push_back(exactly(vertex));
    const gjk::Query<Rational, 2> query{{x}, {y}};
    runs.push_back({vertices, gjk::distance<Rational>(query, options).iterations});
  }
  return runs;
}

Growth::Example SlowGrowth::example(int vertices) {
  Growth::Example example;
  for (const Vector2d& vertex : slow_polygon(vertices))
    example.touched.push_back(vertex - kSlowPoint);
  example.hull = example.touched;
  std::stable_sort(example.hull.begin(), example.hull.end(),
                   [](const Vector2d& a, const Vector2d& b) { return a.x() > b.x(); });
  example.closest = example.touched.back();
  return example;
}

const EffectInfo effect_infos::kGrowth =
    effect_info<Growth>("panel", "runs on random polygons, with more and more vertices");
const EffectInfo effect_infos::kSlowGrowth =
    effect_info<SlowGrowth>("frame", "runs that need as many iterations as there are vertices");

}  // namespace gjkscope
