#pragma once
// The exact penetration depth, from all edges of the hull of Z, and answers judged by it. Integers:
// on a common grid nothing rounds.

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "depth/depth.hpp"
#include "study/families.hpp"

namespace test {

using Pair = families::Pair<double>;
using ExactPoint = std::array<mpz_class, 2>;

[[nodiscard]] inline ExactPoint minus(const ExactPoint& a, const ExactPoint& b) {
  return {mpz_class(a[0] - b[0]), mpz_class(a[1] - b[1])};
}
[[nodiscard]] inline mpz_class cross(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[1] - a[1] * b[0];
}
[[nodiscard]] inline mpz_class length_sq(const ExactPoint& a) { return a[0] * a[0] + a[1] * a[1]; }

/// The nearest long double, or a neighbour of it.
[[nodiscard]] inline long double to_long_double(const mpq_class& a) {
  const double most = a.get_d();
  return most + static_cast<long double>(mpq_class(a - mpq_class(most)).get_d());
}

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
[[nodiscard]] inline std::vector<ExactPoint> hull_of(std::vector<ExactPoint> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<ExactPoint> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const ExactPoint& p : points) {
      while (hull.size() >= begin + 2 &&
             cross(minus(hull.back(), hull[hull.size() - 2]), minus(p, hull.back())) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// A pair on a grid, and the hull of its Z.
struct Truth {
  gjk::Verdict verdict = gjk::Verdict::separated;
  mpq_class depth_sq;     ///< On the grid.
  mpz_class per_unit;     ///< A length of 1 is so many steps of the grid.
  long double scale = 0;  ///< The largest distance between a vertex of X and one of Y.
  std::vector<ExactPoint> x;
  std::vector<ExactPoint> y;
  std::vector<ExactPoint> z;

  [[nodiscard]] mpq_class on_grid(double length) const { return mpq_class(length) * per_unit; }
  [[nodiscard]] long double from_grid(const mpq_class& length) const {
    return to_long_double(length / per_unit);
  }
};

[[nodiscard]] inline Truth truth_of(const Pair& pair) {
  using Point = std::array<mpq_class, 2>;
  const auto moved = [](const std::vector<Eigen::Vector2d>& points,
                        const gjk::Pose<double, 2>& pose) {
    std::vector<Point> out;
    for (const Eigen::Vector2d& p : points) {
      Point& q = out.emplace_back();
      for (int row = 0; row < 2; ++row) {
        q[static_cast<std::size_t>(row)] = mpq_class(pose.translation[row]) +
                                           mpq_class(pose.rotation(row, 0)) * mpq_class(p[0]) +
                                           mpq_class(pose.rotation(row, 1)) * mpq_class(p[1]);
      }
    }
    return out;
  };
  const std::vector<Point> x = moved(pair.x, pair.x_pose);
  const std::vector<Point> y = moved(pair.y, pair.y_pose);
  Truth out;
  out.per_unit = 1;
  for (const std::vector<Point>* points : {&x, &y}) {
    for (const Point& p : *points) {
      for (const mpq_class& coordinate : p) {  // denominators are powers of two
        if (out.per_unit < coordinate.get_den()) out.per_unit = coordinate.get_den();
      }
    }
  }
  const auto on_grid = [&](const std::vector<Point>& points) {
    std::vector<ExactPoint> exact;
    for (const Point& p : points) {
      exact.push_back({mpz_class(p[0].get_num() * (out.per_unit / p[0].get_den())),
                       mpz_class(p[1].get_num() * (out.per_unit / p[1].get_den()))});
    }
    return hull_of(exact);
  };
  out.x = on_grid(x);
  out.y = on_grid(y);
  std::vector<ExactPoint> cloud;
  mpz_class farthest_sq;
  for (const ExactPoint& a : out.x) {
    for (const ExactPoint& b : out.y) {
      cloud.push_back(minus(b, a));
      farthest_sq = std::max(farthest_sq, length_sq(cloud.back()));
    }
  }
  // The root of twice the digits has all those of a long double.
  out.scale = out.from_grid(mpq_class(sqrt(mpz_class(farthest_sq << 256)), mpz_class(1) << 128));
  out.z = hull_of(std::move(cloud));

  if (out.z.size() == 1) {
    out.verdict = length_sq(out.z[0]) == 0 ? gjk::Verdict::touching : gjk::Verdict::separated;
    return out;
  }
  if (out.z.size() == 2) {
    const bool beside = cross(out.z[0], out.z[1]) != 0;
    const mpz_class behind = out.z[0][0] * out.z[1][0] + out.z[0][1] * out.z[1][1];
    out.verdict = beside || behind > 0 ? gjk::Verdict::separated : gjk::Verdict::touching;
    return out;
  }
  out.verdict = gjk::Verdict::overlapping;
  for (std::size_t i = 0; i < out.z.size(); ++i) {
    const ExactPoint& a = out.z[i];
    const ExactPoint& b = out.z[(i + 1) % out.z.size()];
    const mpz_class area = cross(a, b);
    if (area < 0) {
      out.verdict = gjk::Verdict::separated;
      out.depth_sq = 0;
      return out;
    }
    mpq_class distance_sq(area * area, length_sq(minus(b, a)));
    distance_sq.canonicalize();
    if (i == 0 || distance_sq < out.depth_sq) out.depth_sq = distance_sq;
  }
  if (out.depth_sq == 0) out.verdict = gjk::Verdict::touching;
  return out;
}

/// Lengths in u * scale, or in the smallest positive number where that is larger.
struct Judgement {
  std::string broken;     ///< The claim that does not hold, or "".
  long double error = 0;  ///< |depth - exact depth|
  long double width = 0;  ///< upper - lower
  /// How far the shapes are from just touching once X is moved by the translation.
  long double touch = 0;
  /// How far the contact points lie outside of their shapes, or from being one after that motion.
  long double contact = 0;
};

namespace detail {

using Near = std::array<long double, 2>;
[[nodiscard]] inline long double cross(const Near& a, const Near& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Points seen from `q`, on the grid of `truth`.
[[nodiscard]] inline std::vector<Near> seen_from(const std::array<mpq_class, 2>& q,
                                                 const std::vector<ExactPoint>& points,
                                                 const Truth& truth) {
  std::vector<Near> out;
  for (const ExactPoint& p : points) {
    out.push_back({truth.from_grid(p[0] - q[0]), truth.from_grid(p[1] - q[1])});
  }
  return out;
}

/// Distance of the origin from the boundary of a convex polygon: negative inside.
[[nodiscard]] inline long double outside(const std::vector<Near>& hull) {
  bool inside = hull.size() > 2;
  long double nearest = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Near& a = hull[i];
    const Near& b = hull[(i + 1) % hull.size()];
    const Near difference = {b[0] - a[0], b[1] - a[1]};
    const long double length_sq = difference[0] * difference[0] + difference[1] * difference[1];
    const long double from_a = -(a[0] * difference[0] + a[1] * difference[1]);
    const long double share = length_sq > 0 ? std::clamp(from_a / length_sq, 0.0L, 1.0L) : 0.0L;
    nearest =
        std::min(nearest, std::hypot(a[0] + share * difference[0], a[1] + share * difference[1]));
    inside = inside && cross(a, b) >= 0;
  }
  return inside ? -nearest : nearest;
}

}  // namespace detail

/// An answer against the truth. Bars are the caller's.
template <class R>
[[nodiscard]] Judgement judge(const depth::Result<R>& found, const Truth& truth) {
  Judgement out;
  const auto exact = [&](const R& a) { return truth.on_grid(static_cast<double>(a)); };
  if (found.error != gjk::Error::none) {
    out.broken = "no answer";
  } else if (found.verdict != truth.verdict) {
    out.broken = "verdict";
  }
  if (!out.broken.empty()) return out;
  if (truth.verdict == gjk::Verdict::separated) {
    if (found.depth == found.depth || found.stop != depth::StopReason::separated) {
      out.broken = "a depth of shapes apart";
    }
    return out;
  }

  const mpq_class lower = exact(found.lower);
  const mpq_class upper = exact(found.upper);
  if (!(R(0) <= found.lower && found.lower <= found.depth && found.depth <= found.upper) ||
      truth.depth_sq < lower * lower || upper * upper < truth.depth_sq) {
    out.broken = "bounds";
  }
  // A depth below the smallest positive number may round to 0.
  const mpq_class smallest = exact(std::numeric_limits<R>::denorm_min());
  const bool may_be_zero = truth.depth_sq < smallest * smallest;
  const bool must_be_zero = truth.verdict == gjk::Verdict::touching;
  if (found.depth == R(0) ? !may_be_zero : must_be_zero) out.broken = "zero";

  // Along the direction nothing of Z lies beyond `upper`.
  const std::array<mpq_class, 2> d = {mpq_class(static_cast<double>(found.direction[0])),
                                      mpq_class(static_cast<double>(found.direction[1]))};
  mpq_class reach;
  for (std::size_t i = 0; i < truth.z.size(); ++i) {
    const mpq_class along = d[0] * truth.z[i][0] + d[1] * truth.z[i][1];
    if (i == 0 || reach < along) reach = along;
  }
  const mpq_class d_sq = d[0] * d[0] + d[1] * d[1];
  const bool parts = reach <= 0 || reach * reach <= upper * upper * d_sq;
  if (!parts && truth.verdict == gjk::Verdict::overlapping) out.broken = "does not part";
  const auto u = static_cast<double>(gjk::ScalarTraits<R>::unit_roundoff());
  if (std::abs(mpq_class(d_sq - 1).get_d()) > 6 * u) out.broken = "length of the direction";

  const std::array<mpq_class, 2> t = {exact(found.translation[0]), exact(found.translation[1])};
  const std::array<mpq_class, 2> x = {exact(found.x[0]), exact(found.x[1])};
  const std::array<mpq_class, 2> y = {exact(found.y[0]), exact(found.y[1])};
  const mpq_class square = truth.depth_sq;
  const mpz_class wide = (square.get_num() << 256) / square.get_den();
  const mpq_class depth(sqrt(wide), mpz_class(1) << 128);
  const long double unit =
      std::max<long double>(u * truth.scale, std::numeric_limits<R>::denorm_min());
  out.error = std::abs(truth.from_grid(exact(found.depth) - depth)) / unit;
  out.width = truth.from_grid(upper - lower) / unit;
  out.touch = std::abs(detail::outside(detail::seen_from(t, truth.z, truth))) / unit;

  // Far from the origin world coordinates stand on a coarse grid.
  const auto forgiven = [&](const gjk::Vec<R, 2>& p) {
    const long double away =
        std::hypot(static_cast<long double>(p[0]), static_cast<long double>(p[1]));
    return u * std::max(0.0L, away - truth.scale);
  };
  const long double rest =
      std::hypot(truth.from_grid(y[0] - x[0] - t[0]), truth.from_grid(y[1] - x[1] - t[1]));
  out.contact =
      std::max({0.0L, detail::outside(detail::seen_from(x, truth.x, truth)) - forgiven(found.x),
                detail::outside(detail::seen_from(y, truth.y, truth)) - forgiven(found.y),
                rest - forgiven(found.x) - forgiven(found.y)}) /
      unit;
  return out;
}

}  // namespace test
