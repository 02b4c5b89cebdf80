// Properties that hold for all pairs, in the plane and in space: what must not matter, and what
// must not grow. Pairs shrink to the smallest that break them. RC_PARAMS="seed=... max_success=..."
// tries others.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "bars.hpp"
#include "study/families.hpp"

namespace gjkscope::study {
namespace properties_test {

template <int D>
using Vec = gjk::Vec<double, D>;
template <int D>
using Pair = families::Pair<double, D>;
template <int D>
using Points = std::vector<Vec<D>>;

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
template <int D>
Vec<D> point(Digits digits) {
  Vec<D> out;
  for (double& number : out) number = coordinate(digits);
  return out;
}
template <int D>
Vec<D> whole_numbers(int least, int most) {
  Vec<D> out;
  for (double& number : out) number = *rc::gen::inRange(least, most + 1);
  return out;
}
template <int D>
Points<D> shape(Digits digits) {
  Points<D> out;
  for (int i = *rc::gen::inRange(1, 8); i > 0; --i) out.push_back(point<D>(digits));
  return out;
}
template <int D>
Pair<D> any_pair() {
  const Digits digits = *rc::gen::element(Digits::few, Digits::some, Digits::many);
  Pair<D> out;
  out.x = shape<D>(digits);
  out.y = shape<D>(digits);
  return out;
}
/// By a turn in the plane of the first two axes.
template <int D>
Eigen::Matrix<double, D, D> turn(double cosine, double sine) {
  Eigen::Matrix<double, D, D> out = Eigen::Matrix<double, D, D>::Identity();
  out.template topLeftCorner<2, 2>() = Eigen::Matrix2d{{cosine, -sine}, {sine, cosine}};
  return out;
}

template <int D>
bool apart(const gjk::Result<double, D>& result) {
  return result.verdict == gjk::Verdict::separated;
}

/// Both answers may be those of one question: each errs by at most 4 u * scale.
template <int D>
void check_alike(const Pair<D>& pair, const Pair<D>& other) {
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

template <int D>
void check_bits(const gjk::Result<double, D>& a, const gjk::Result<double, D>& b) {
  RC_ASSERT(a.error == b.error);
  RC_ASSERT(a.stop == b.stop);
  RC_ASSERT(a.verdict == b.verdict);
  RC_ASSERT(a.iterations == b.iterations);
  RC_ASSERT(a.distance == b.distance);
  RC_ASSERT(a.lower == b.lower);
  RC_ASSERT(a.upper == b.upper);
}

template <int D, class Change>
Pair<D> changed(Pair<D> pair, const Change& change) {
  for (Vec<D>& p : pair.x) p = change(p);
  for (Vec<D>& p : pair.y) p = change(p);
  return pair;
}

/// A property of pairs in dimension D, which is 2 in one test and 3 in the other.
#define PROPERTY(Name)                                    \
  template <int D>                                        \
  void Name();                                            \
  RC_GTEST_PROP(Property, Name, ()) { Name<2>(); }        \
  RC_GTEST_PROP(PropertyInSpace, Name, ()) { Name<3>(); } \
  template <int D>                                        \
  void Name()

PROPERTY(TheOrderOfTheShapesDoesNotMatter) {
  const Pair<D> pair = any_pair<D>();
  check_alike<D>(pair, families::swapped(pair));
}

PROPERTY(TheOrderOfVerticesDoesNotMatter) {
  const Pair<D> pair = any_pair<D>();
  Pair<D> other = pair;
  for (Points<D>* points : {&other.x, &other.y}) {
    for (std::size_t i = points->size(); i > 1; --i) {
      std::swap((*points)[i - 1], (*points)[*rc::gen::inRange<std::size_t>(0, i)]);
    }
  }
  check_alike<D>(pair, other);
}

PROPERTY(RepeatedVerticesDoNotMatter) {
  const Pair<D> pair = any_pair<D>();
  Pair<D> other = pair;
  for (Points<D>* points : {&other.x, &other.y}) {
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
      const Vec<D> copy = (*points)[*rc::gen::inRange<std::size_t>(0, points->size())];
      points->insert(points->begin() + *rc::gen::inRange<long>(0, long(points->size()) + 1), copy);
    }
  }
  check_alike<D>(pair, other);
}

PROPERTY(VerticesInsideDoNotMatter) {
  Pair<D> pair;
  pair.x = shape<D>(Digits::some);
  pair.y = shape<D>(Digits::some);
  Pair<D> other = pair;
  for (Points<D>* points : {&other.x, &other.y}) {  // means of quarters are eighths: exact
    const Vec<D> a = (*points)[*rc::gen::inRange<std::size_t>(0, points->size())];
    const Vec<D> b = (*points)[*rc::gen::inRange<std::size_t>(0, points->size())];
    points->insert(points->begin() + *rc::gen::inRange<long>(0, long(points->size()) + 1),
                   (a + b) / 2);
  }
  check_alike<D>(pair, other);
}

PROPERTY(TranslationOfAllVerticesDoesNotMatter) {
  const Pair<D> pair = any_pair<D>();
  // 45 + 8 digits: exact.
  const Vec<D> by = whole_numbers<D>(-2048, 2048);
  check_alike<D>(pair, changed<D>(pair, [&](const Vec<D>& p) { return Vec<D>(p + by); }));
}

PROPERTY(TranslationOfBothPosesDoesNotMatterToTheLastBit) {
  Pair<D> pair = any_pair<D>();
  const auto expected = gjk::distance(pair.query());
  for (double& number : pair.x_pose.translation) number = *rc::gen::arbitrary<int>();
  pair.y_pose.translation = pair.x_pose.translation;
  check_bits<D>(expected, gjk::distance(pair.query()));
}

PROPERTY(TranslationOfOneShapeEqualsThatOfItsPose) {
  const Pair<D> pair = any_pair<D>();
  Pair<D> moved = pair;
  Pair<D> posed = pair;
  posed.y_pose.translation = whole_numbers<D>(-16, 16);
  for (Vec<D>& p : moved.y) p += posed.y_pose.translation;
  check_alike<D>(moved, posed);
}

PROPERTY(QuartersOfATurnDoNotMatter) {
  const Pair<D> pair = any_pair<D>();
  const auto quarter = [](const Vec<D>& p) { return Vec<D>(turn<D>(0, 1) * p); };
  check_alike<D>(pair, changed<D>(pair, quarter));
  Pair<D> posed = changed<D>(pair, quarter);
  posed.x_pose.rotation = turn<D>(0, -1);
  posed.y_pose.rotation = posed.x_pose.rotation;
  check_alike<D>(pair, posed);
}

PROPERTY(ReflectionDoesNotMatter) {
  const Pair<D> pair = any_pair<D>();
  check_alike<D>(pair, changed<D>(pair, [](Vec<D> p) {
                   p[0] = -p[0];
                   return p;
                 }));
}

PROPERTY(PowersOfTwoScaleTheAnswerToTheLastBit) {
  const Pair<D> pair = any_pair<D>();
  const int k = *rc::gen::inRange(-300, 301);
  auto expected = gjk::distance(pair.query());
  for (double* length : {&expected.distance, &expected.lower, &expected.upper}) {
    *length = std::ldexp(*length, k);
  }
  const double factor = std::ldexp(1.0, k);
  const auto scaled = changed<D>(pair, [&](const Vec<D>& p) { return Vec<D>(p * factor); });
  check_bits<D>(expected, gjk::distance(scaled.query()));
}

PROPERTY(MoreVerticesAreNeverFarther) {
  const Pair<D> pair = any_pair<D>();
  Pair<D> more = pair;
  more.y.push_back(point<D>(Digits::some));
  RC_ASSERT(gjk::distance(more.query()).lower <= gjk::distance(pair.query()).upper);
}

PROPERTY(BoundsOnlyCloseInAlongATrace) {
  const Pair<D> pair = any_pair<D>();
  const auto trace = gjk::trace(pair.query());
  const gjk::State<double, D>* before = nullptr;
  for (const auto& step : trace.steps) {
    if (before != nullptr && before->evidence.best.count > 0) {
      RC_ASSERT(step.after.evidence.best_sq <= before->evidence.best_sq);
      RC_ASSERT(step.after.evidence.plane_distance_sq >= before->evidence.plane_distance_sq);
    }
    before = &step.after;
  }
}

PROPERTY(WitnessesOfShapesFarFromTheirOwnOriginsLieInThem) {
  // Shapes that turn in a frame of their own end near the world's origin, and near each other.
  const auto turned = [](const Points<D>& points) {
    const double half = coordinate(Digits::many);
    gjk::Pose<double, D> pose;
    const double c = (1 - half * half) / (1 + half * half);
    const double s = 2 * half / (1 + half * half);
    pose.rotation = turn<D>(c, s);
    pose.translation = 0x1p-4 * point<D>(Digits::some) - pose.rotated(points[0]);
    return pose;
  };
  const auto few_points = [] {
    Points<D> points = {point<D>(Digits::many)};
    if (*rc::gen::arbitrary<bool>()) points.push_back(points[0] + 0x1p-4 * point<D>(Digits::some));
    return points;
  };
  Pair<D> pair;
  pair.x = few_points();
  pair.y = few_points();
  pair.x_pose = turned(pair.x);
  pair.y_pose = turned(pair.y);
  const Truth truth = truth_of(pair);
  const Judgement found = judge(claim_of(gjk::distance(pair.query())), {truth, truth});
  RC_ASSERT(!found.failed);
  RC_ASSERT(found.witness <= kBars.witness * unit_of<double>(truth));
}

PROPERTY(DistanceAndTraceAgreeToTheLastBit) {
  const Pair<D> pair = any_pair<D>();
  gjk::Options options;
  options.direction_rule =
      *rc::gen::element(gjk::DirectionRule::perpendicular, gjk::DirectionRule::towards_origin);
  options.region_order = *rc::gen::element(
      gjk::RegionOrder::vertices_first, gjk::RegionOrder::edges_first, gjk::RegionOrder::unchecked);
  options.start.count = *rc::gen::inRange(0, 2);
  options.iteration_cap = *rc::gen::inRange(1, 9);
  const auto answer = gjk::distance(pair.query(), options);
  const auto trace = gjk::trace(pair.query(), options);
  check_bits<D>(answer, trace.result);
  RC_ASSERT(answer.x == trace.result.x);
  RC_ASSERT(answer.y == trace.result.y);
}

}  // namespace properties_test
}  // namespace gjkscope::study
