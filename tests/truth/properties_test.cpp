// What must not matter, and what must not grow: properties that hold for all pairs, with pairs that
// shrink to the smallest that break them. RC_PARAMS="seed=... max_success=..." tries others.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <cstring>

#include "bars.hpp"
#include "study/families.hpp"

namespace gjkscope::study {
namespace {

using Eigen::Vector2d;
using Pair = families::Pair<double>;
using Points = std::vector<Vector2d>;

[[maybe_unused]] const int kParameters =
    setenv("RC_PARAMS", "seed=20100311 max_success=2000", 0);  // unless the caller has set it

/// Few digits make ties and touching, many make roundings.
enum class Digits { few, some, many };
double coordinate(Digits digits) {
  switch (digits) {
    case Digits::few:
      return *rc::gen::inRange(-3, 4);
    case Digits::some:
      return *rc::gen::inRange(-40, 41) * 0.25;
    default:
      return static_cast<double>(*rc::gen::inRange(-(1L << 44), (1L << 44) + 1)) * 0x1p-40;
  }
}
Vector2d point(Digits digits) {
  const double x = coordinate(digits);
  return {x, coordinate(digits)};
}
Points shape(Digits digits) {
  Points out;
  for (int i = *rc::gen::inRange(1, 8); i > 0; --i) out.push_back(point(digits));
  return out;
}
Pair any_pair() {
  const Digits digits = *rc::gen::element(Digits::few, Digits::some, Digits::many);
  Pair out;
  out.x = shape(digits);
  out.y = shape(digits);
  return out;
}

bool apart(const gjk::Result<double, 2>& result) {
  return result.verdict == gjk::Verdict::separated;
}

/// Both answers may be those of one question: each errs by at most 4 u * scale.
void check_alike(const Pair& pair, const Pair& other) {
  const auto a = gjk::distance(pair.query());
  const auto b = gjk::distance(other.query());
  const double unit = 0x1p-53 * families::scale_of(pair);
  RC_ASSERT(a.error == gjk::Error::none);
  RC_ASSERT(b.error == gjk::Error::none);
  RC_ASSERT(apart(a) == apart(b));
  RC_ASSERT(std::abs(a.distance - b.distance) <= 8 * unit);
  RC_ASSERT(a.lower <= b.upper);
  RC_ASSERT(b.lower <= a.upper);
}

void check_bits(const gjk::Result<double, 2>& a, const gjk::Result<double, 2>& b) {
  RC_ASSERT(a.error == b.error);
  RC_ASSERT(a.stop == b.stop);
  RC_ASSERT(a.verdict == b.verdict);
  RC_ASSERT(a.iterations == b.iterations);
  RC_ASSERT(a.distance == b.distance);
  RC_ASSERT(a.lower == b.lower);
  RC_ASSERT(a.upper == b.upper);
}

template <class Change>
Pair changed(Pair pair, const Change& change) {
  for (Vector2d& p : pair.x) p = change(p);
  for (Vector2d& p : pair.y) p = change(p);
  return pair;
}

RC_GTEST_PROP(Property, TheOrderOfTheShapesDoesNotMatter, ()) {
  const Pair pair = any_pair();
  check_alike(pair, families::swapped(pair));
}

RC_GTEST_PROP(Property, TheOrderOfVerticesDoesNotMatter, ()) {
  const Pair pair = any_pair();
  Pair other = pair;
  for (Points* points : {&other.x, &other.y}) {
    for (std::size_t i = points->size(); i > 1; --i) {
      std::swap((*points)[i - 1], (*points)[*rc::gen::inRange<std::size_t>(0, i)]);
    }
  }
  check_alike(pair, other);
}

RC_GTEST_PROP(Property, RepeatedVerticesDoNotMatter, ()) {
  const Pair pair = any_pair();
  Pair other = pair;
  for (Points* points : {&other.x, &other.y}) {
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
      const Vector2d copy = (*points)[*rc::gen::inRange<std::size_t>(0, points->size())];
      points->insert(points->begin() + *rc::gen::inRange<long>(0, long(points->size()) + 1), copy);
    }
  }
  check_alike(pair, other);
}

RC_GTEST_PROP(Property, VerticesInsideDoNotMatter, ()) {
  Pair pair;
  pair.x = shape(Digits::some);
  pair.y = shape(Digits::some);
  Pair other = pair;
  for (Points* points : {&other.x, &other.y}) {  // means of quarters are eighths: exact
    const Vector2d a = (*points)[*rc::gen::inRange<std::size_t>(0, points->size())];
    const Vector2d b = (*points)[*rc::gen::inRange<std::size_t>(0, points->size())];
    points->insert(points->begin() + *rc::gen::inRange<long>(0, long(points->size()) + 1),
                   (a + b) / 2);
  }
  check_alike(pair, other);
}

RC_GTEST_PROP(Property, TranslationOfAllVerticesDoesNotMatter, ()) {
  const Pair pair = any_pair();
  // 45 + 8 digits: exact.
  const Vector2d by(*rc::gen::inRange(-2048, 2049), *rc::gen::inRange(-2048, 2049));
  check_alike(pair, changed(pair, [&](const Vector2d& p) { return Vector2d(p + by); }));
}

RC_GTEST_PROP(Property, TranslationOfBothPosesDoesNotMatterToTheLastBit, ()) {
  Pair pair = any_pair();
  const auto expected = gjk::distance(pair.query());
  pair.x_pose.translation = pair.y_pose.translation =
      Vector2d(*rc::gen::arbitrary<int>(), *rc::gen::arbitrary<int>());
  check_bits(expected, gjk::distance(pair.query()));
}

RC_GTEST_PROP(Property, TranslationOfOneShapeEqualsThatOfItsPose, ()) {
  const Pair pair = any_pair();
  Pair moved = pair;
  Pair posed = pair;
  posed.y_pose.translation = Vector2d(*rc::gen::inRange(-16, 17), *rc::gen::inRange(-16, 17));
  for (Vector2d& p : moved.y) p += posed.y_pose.translation;
  check_alike(moved, posed);
}

RC_GTEST_PROP(Property, QuartersOfATurnDoNotMatter, ()) {
  const Pair pair = any_pair();
  const auto quarter = [](const Vector2d& p) { return Vector2d(-p[1], p[0]); };
  check_alike(pair, changed(pair, quarter));
  Pair posed = changed(pair, quarter);
  posed.x_pose.rotation = Eigen::Matrix2d{{0, 1}, {-1, 0}};
  posed.y_pose.rotation = posed.x_pose.rotation;
  check_alike(pair, posed);
}

RC_GTEST_PROP(Property, ReflectionDoesNotMatter, ()) {
  const Pair pair = any_pair();
  check_alike(pair, changed(pair, [](const Vector2d& p) { return Vector2d(-p[0], p[1]); }));
}

RC_GTEST_PROP(Property, PowersOfTwoScaleTheAnswerToTheLastBit, ()) {
  const Pair pair = any_pair();
  const int k = *rc::gen::inRange(-300, 301);
  auto expected = gjk::distance(pair.query());
  for (double* length : {&expected.distance, &expected.lower, &expected.upper}) {
    *length = std::ldexp(*length, k);
  }
  const double factor = std::ldexp(1.0, k);
  const auto scaled = changed(pair, [&](const Vector2d& p) { return Vector2d(p * factor); });
  check_bits(expected, gjk::distance(scaled.query()));
}

RC_GTEST_PROP(Property, MoreVerticesAreNeverFarther, ()) {
  const Pair pair = any_pair();
  Pair more = pair;
  more.y.push_back(point(Digits::some));
  RC_ASSERT(gjk::distance(more.query()).lower <= gjk::distance(pair.query()).upper);
}

RC_GTEST_PROP(Property, BoundsOnlyCloseInAlongATrace, ()) {
  const Pair pair = any_pair();
  const auto trace = gjk::trace(pair.query());
  const gjk::State<double, 2>* before = nullptr;
  for (const auto& step : trace.steps) {
    if (before != nullptr && before->best.count > 0) {
      RC_ASSERT(step.after.best_sq <= before->best_sq);
      RC_ASSERT(step.after.plane_distance_sq >= before->plane_distance_sq);
    }
    before = &step.after;
  }
}

RC_GTEST_PROP(Property, WitnessesOfShapesFarFromTheirOwnOriginsLieInThem, ()) {
  // What turns in a frame of its own ends near the world's origin, and near the other.
  const auto turned = [](const Points& points) {
    const double half = coordinate(Digits::many);
    gjk::Pose<double, 2> pose;
    const double c = (1 - half * half) / (1 + half * half);
    const double s = 2 * half / (1 + half * half);
    pose.rotation = Eigen::Matrix2d{{c, -s}, {s, c}};
    pose.translation = 0x1p-4 * point(Digits::some) - pose.rotated(points[0]);
    return pose;
  };
  const auto few_points = [] {
    Points points = {point(Digits::many)};
    if (*rc::gen::arbitrary<bool>()) points.push_back(points[0] + 0x1p-4 * point(Digits::some));
    return points;
  };
  Pair pair;
  pair.x = few_points();
  pair.y = few_points();
  pair.x_pose = turned(pair.x);
  pair.y_pose = turned(pair.y);
  const Truth truth = truth_of(pair);
  const Judgement found = judge(claim_of(gjk::distance(pair.query())), {truth, truth});
  RC_ASSERT(!found.failed);
  RC_ASSERT(found.witness <= kBars.witness * unit_of<double>(truth));
}

RC_GTEST_PROP(Property, DistanceAndTraceAgreeToTheLastBit, ()) {
  const Pair pair = any_pair();
  gjk::Options options;
  options.direction_rule =
      *rc::gen::element(gjk::DirectionRule::perpendicular, gjk::DirectionRule::towards_origin);
  options.region_order = *rc::gen::element(
      gjk::RegionOrder::vertices_first, gjk::RegionOrder::edges_first, gjk::RegionOrder::unchecked);
  options.start.count = *rc::gen::inRange(0, 2);
  options.iteration_cap = *rc::gen::inRange(1, 9);
  const auto answer = gjk::distance(pair.query(), options);
  const auto trace = gjk::trace(pair.query(), options);
  check_bits(answer, trace.result);
  RC_ASSERT(answer.x == trace.result.x);
  RC_ASSERT(answer.y == trace.result.y);
}

}  // namespace
}  // namespace gjkscope::study
