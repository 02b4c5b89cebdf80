#include "study/truth.hpp"

#include <algorithm>
#include <cmath>

#include "study/exact.hpp"

namespace gjkscope::study {
namespace {

using Near = std::array<long double, 2>;  ///< A point relative to some vertex close to it.

Near minus(const Near& a, const Near& b) { return {a[0] - b[0], a[1] - b[1]}; }
long double dot(const Near& a, const Near& b) { return a[0] * b[0] + a[1] * b[1]; }
long double cross(const Near& a, const Near& b) { return a[0] * b[1] - a[1] * b[0]; }
long double length(const Near& a) { return std::hypot(a[0], a[1]); }

Near relative(const std::array<Quad, 2>& point, const Eigen::Vector2d& origin) {
  return {static_cast<long double>(point[0] - Quad(origin[0])),
          static_cast<long double>(point[1] - Quad(origin[1]))};
}

long double distance_from_segment(const Near& q, const Near& a, const Near& b) {
  const Near edge = minus(b, a);
  const Near from_a = minus(q, a);
  const long double along = dot(from_a, edge);
  if (along <= 0.0L) return length(from_a);
  if (along >= dot(edge, edge)) return length(minus(q, b));
  return std::abs(cross(edge, from_a)) / length(edge);
}

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Near> hull_of(std::vector<Near> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Near> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const Near& p : points) {
      while (hull.size() >= begin + 2 &&
             cross(minus(hull.back(), hull[hull.size() - 2]), minus(p, hull.back())) <= 0.0L) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// How far `point` lies outside of the hull of `vertices`.
long double outside(const std::array<Quad, 2>& point,
                    const std::vector<Eigen::Vector2d>& vertices) {
  std::vector<Near> points;
  for (const Eigen::Vector2d& vertex : vertices) {
    points.push_back(relative({Quad(vertex[0]), Quad(vertex[1])}, vertices[0]));
  }
  const Near q = relative(point, vertices[0]);
  const std::vector<Near> hull = hull_of(std::move(points));
  if (hull.size() == 1) return length(minus(q, hull[0]));
  bool inside = hull.size() > 2;
  long double best = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Near& a = hull[i];
    const Near& b = hull[(i + 1) % hull.size()];
    inside = inside && cross(minus(b, a), minus(q, a)) >= 0.0L;
    best = std::min(best, distance_from_segment(q, a, b));
  }
  return inside ? 0.0L : best;
}

bool is_finite(const Answer& answer) {
  const Quad numbers[] = {answer.distance, answer.lower, answer.upper, answer.x[0],
                          answer.x[1],     answer.y[0],  answer.y[1]};
  return std::all_of(std::begin(numbers), std::end(numbers),
                     [](const Quad& a) { return gjk::ScalarTraits<Quad>::is_finite(a); });
}

}  // namespace

Truth truth_of(const DoublePair& pair) {
  const gjk::Result<Rational, 2> result = exact_distance(pair.query());
  Truth out;
  out.distance_sq = result.distance_sq;
  out.overlap = result.distance_sq == 0;
  if (out.overlap) return out;
  out.distance[0] = root_nearest(out.distance_sq);
  // With s = distance - n small beside n, distance^2 - n^2 = 2 n s up to s^2.
  Rational sum(out.distance[0]);
  for (std::size_t i = 1; i < out.distance.size(); ++i) {
    const Rational rest = (out.distance_sq - sum * sum) / (2 * sum);
    out.distance[i] = to_double(rest);
    sum += Rational(out.distance[i]);
  }
  return out;
}

double difference(const Quad& value, const Truth& truth) {
  Quad rest = value;
  for (const double part : truth.distance) rest = rest - Quad(part);
  return static_cast<double>(rest);
}

Judgement judge(const Answer& answer, const Judged& judged) {
  Judgement out;
  out.failed = answer.refused || !is_finite(answer);
  if (out.failed) return out;
  out.undecided = answer.verdict == gjk::Verdict::undecided;
  const bool overlap = answer.verdict != gjk::Verdict::separated;
  out.wrong = !out.undecided && overlap != judged.given.overlap;
  out.wrong_as_kept = !out.undecided && overlap != judged.as_kept.overlap;
  out.error = std::abs(difference(answer.distance, judged.given));
  out.error_as_kept = std::abs(difference(answer.distance, judged.as_kept));
  out.width = std::numeric_limits<double>::quiet_NaN();
  if (answer.has_bounds) {
    out.broken_bounds = difference(answer.lower, judged.as_kept) > 0.0 ||
                        difference(answer.upper, judged.as_kept) < 0.0;
    out.width = static_cast<double>(answer.upper - answer.lower);
  }
  const Near apart = {static_cast<long double>(answer.y[0] - answer.x[0]),
                      static_cast<long double>(answer.y[1] - answer.x[1])};
  const long double distance =
      static_cast<long double>(judged.as_kept.distance[0]) + judged.as_kept.distance[1];
  out.witness = static_cast<double>(
      std::max({outside(answer.x, judged.kept.x), outside(answer.y, judged.kept.y),
                std::abs(length(apart) - distance)}));
  return out;
}

}  // namespace gjkscope::study
