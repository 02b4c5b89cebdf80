#include "exact.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace truth {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64 && GMP_LIMB_BITS == 64);

/// mantissa * 2^exponent, the mantissa odd or 0.
struct Dyadic {
  long mantissa = 0;
  int exponent = 0;
};
Dyadic dyadic(double value) {
  if (value == 0) return {};
  Dyadic out;
  out.mantissa = static_cast<long>(std::ldexp(std::frexp(value, &out.exponent), 53));
  const int zeros = __builtin_ctzl(static_cast<unsigned long>(out.mantissa));
  out.mantissa >>= zeros;
  out.exponent += zeros - 53;
  return out;
}

/// A product of two numbers that is to be added to others of its kind.
struct Term {
  Dyadic a;
  Dyadic b;
  [[nodiscard]] bool is_zero() const { return a.mantissa == 0 || b.mantissa == 0; }
  [[nodiscard]] int exponent() const { return a.exponent + b.exponent; }
};

/// One coordinate of rotation * vertex + translation.
using Sum = std::array<Term, 3>;

Sum coordinate(const gjk::Pose<double, 2>& pose, const Eigen::Vector2d& vertex, int row) {
  return {Term{dyadic(pose.rotation(row, 0)), dyadic(vertex[0])},
          Term{dyadic(pose.rotation(row, 1)), dyadic(vertex[1])},
          Term{dyadic(1.0), dyadic(pose.translation[row])}};
}

mpz_class on_grid(const Sum& sum, int exponent) {
  mpz_class total;
  mpz_class product;
  for (const Term& term : sum) {
    if (term.is_zero()) continue;
    product = term.a.mantissa;
    product *= term.b.mantissa;
    product <<= static_cast<mp_bitcnt_t>(term.exponent() - exponent);
    total += product;
  }
  return total;
}

mpz_class dot(const IntegerPoint& a, const IntegerPoint& b) { return a.x * b.x + a.y * b.y; }
mpz_class cross(const IntegerPoint& a, const IntegerPoint& b) { return a.x * b.y - a.y * b.x; }
IntegerPoint minus(const IntegerPoint& a, const IntegerPoint& b) {
  return {mpz_class(a.x - b.x), mpz_class(a.y - b.y)};
}

/// Its first 64 digits or more: good to 2^-63.
long double rounded(const mpz_class& value) {
  const mpz_srcptr z = value.get_mpz_t();
  const std::size_t size = mpz_size(z);
  long double magnitude = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(size, 2); ++i) {
    const auto limb =
        static_cast<long double>(mpz_getlimbn(z, static_cast<mp_size_t>(size - 1 - i)));
    magnitude += std::ldexp(limb, 64 * static_cast<int>(size - 1 - i));
  }
  return sgn(value) < 0 ? -magnitude : magnitude;
}

/// Value and exponent apart, where 2^16384 would not do.
struct Scaled {
  long double value = 0;
  long exponent = 0;
};
Scaled scaled(const mpz_class& value) {
  const auto size = static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2));
  if (size <= 4096) return {rounded(value), 0};
  mpz_class shifted;
  mpz_tdiv_q_2exp(shifted.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(size - 256));
  return {rounded(shifted), size - 256};
}

/// The nearest point to O of the hull of up to three points.
struct Nearest {
  bool overlap = false;
  std::array<int, 2> face = {};  ///< Of this point, or of this edge.
  int face_size = 0;
  IntegerPoint normal;  ///< Along P.
  mpz_class reach;      ///< dot(normal, P)
  mpz_class numerator;  ///< |P|^2 = numerator / denominator
  mpz_class denominator;
};

void offer(Nearest& best, std::array<int, 2> face, int face_size, const IntegerPoint& normal,
           const mpz_class& reach) {
  // P = normal * reach / |normal|^2.
  const mpz_class numerator = reach * reach;
  const mpz_class denominator = dot(normal, normal);
  if (best.face_size != 0 &&
      mpz_class(best.numerator * denominator) <= mpz_class(numerator * best.denominator)) {
    return;
  }
  best.face = face;
  best.face_size = face_size;
  best.normal = normal;
  best.reach = reach;
  best.numerator = numerator;
  best.denominator = denominator;
}

Nearest nearest(std::span<const IntegerPoint> z) {
  Nearest best;
  const int count = static_cast<int>(z.size());
  for (int i = 0; i < count; ++i) {
    const mpz_class length_sq = dot(z[i], z[i]);
    if (length_sq == 0) {
      best.overlap = true;
      return best;
    }
    offer(best, {i, i}, 1, z[i], length_sq);
  }
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      const IntegerPoint edge = minus(z[i], z[j]);
      if (dot(edge, z[i]) <= 0 || dot(edge, z[j]) >= 0) continue;  // the foot is not inside
      IntegerPoint normal{mpz_class(-edge.y), edge.x};
      mpz_class reach = dot(normal, z[i]);
      if (reach == 0) {
        best.overlap = true;
        return best;
      }
      if (reach < 0) {
        normal = {mpz_class(-normal.x), mpz_class(-normal.y)};
        reach = -reach;
      }
      offer(best, {i, j}, 2, normal, reach);
    }
  }
  if (count == 3) {
    const int side = sgn(cross(z[0], z[1]));
    best.overlap = side != 0 && side == sgn(cross(z[1], z[2])) && side == sgn(cross(z[2], z[0]));
  }
  return best;
}

long double length(const NearPoint& a) { return std::hypot(a[0], a[1]); }
NearPoint minus(const NearPoint& a, const NearPoint& b) { return {a[0] - b[0], a[1] - b[1]}; }
long double cross(const NearPoint& a, const NearPoint& b) { return a[0] * b[1] - a[1] * b[0]; }

long double distance_from_segment(const NearPoint& q, const NearPoint& a, const NearPoint& b) {
  const NearPoint edge = minus(b, a);
  const NearPoint from_a = minus(q, a);
  const long double size = length(edge);
  if (!(size > 0)) return length(from_a);
  const NearPoint unit = {edge[0] / size, edge[1] / size};
  const long double along = from_a[0] * unit[0] + from_a[1] * unit[1];
  if (along <= 0) return length(from_a);
  if (along >= size) return length(minus(q, b));
  return std::abs(cross(unit, from_a));
}

bool in_triangle(const NearPoint& q, const NearPoint& a, const NearPoint& b, const NearPoint& c) {
  const long double ab = cross(minus(b, a), minus(q, a));
  const long double bc = cross(minus(c, b), minus(q, b));
  const long double ca = cross(minus(a, c), minus(q, c));
  return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
}

/// The hull of a point set is the union of the triangles at one of its points, and no segment
/// between two of them leaves it.
long double distance_from_hull(const NearPoint& q, const std::vector<NearPoint>& points) {
  long double best = length(minus(q, points[0]));
  for (std::size_t i = 1; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (in_triangle(q, points[0], points[i], points[j])) return 0;
      best = std::min(best, distance_from_segment(q, points[i], points[j]));
    }
  }
  return best;
}

}  // namespace

ExactPair::ExactPair(const gjk::Query<double, 2>& query) {
  std::vector<std::array<Sum, 2>> sums;
  for (const auto* shape : {&query.x, &query.y}) {
    for (const Eigen::Vector2d& vertex : shape->vertices) {
      sums.push_back({coordinate(shape->pose, vertex, 0), coordinate(shape->pose, vertex, 1)});
    }
  }
  bool any = false;
  for (const auto& point : sums) {
    for (const Sum& sum : point) {
      for (const Term& term : sum) {
        if (term.is_zero()) continue;
        exponent_ = any ? std::min(exponent_, term.exponent()) : term.exponent();
        any = true;
      }
    }
  }
  const std::size_t x_count = query.x.vertices.size();
  for (std::size_t i = 0; i < sums.size(); ++i) {
    (i < x_count ? x_ : y_)
        .push_back({on_grid(sums[i][0], exponent_), on_grid(sums[i][1], exponent_)});
  }
  // Where the first vertex has more digits than a double its first 53 are still on the grid.
  const auto leading = [&](const mpz_class& value) {
    long size = 0;
    const double digits = mpz_get_d_2exp(&size, value.get_mpz_t());
    return std::ldexp(digits, static_cast<int>(size) + exponent_);
  };
  origin_ = {leading(x_[0].x), leading(x_[0].y)};
  for (const IntegerPoint& point : x_) x_near_.push_back(near(point));
  for (const IntegerPoint& point : y_) y_near_.push_back(near(point));
}

IntegerPoint ExactPair::difference(gjk::VertexPair pair) const {
  return minus(y_[static_cast<std::size_t>(pair.y)], x_[static_cast<std::size_t>(pair.x)]);
}

gjk::VertexPair ExactPair::nearest_along(const IntegerPoint& normal) const {
  const auto extreme = [&](const std::vector<IntegerPoint>& points, int sign) {
    int best = 0;
    mpz_class best_value;
    mpz_class value;
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      value = dot(normal, points[static_cast<std::size_t>(i)]);
      if (i == 0 || cmp(value, best_value) * sign > 0) {
        best = i;
        swap(best_value, value);
      }
    }
    return best;
  };
  return {extreme(x_, 1), extreme(y_, -1)};
}

Truth ExactPair::truth(std::span<const gjk::VertexPair> guess) const {
  std::vector<gjk::VertexPair> pairs(guess.begin(), guess.end());
  if (pairs.empty()) pairs.push_back({0, 0});
  assert(pairs.size() <= 3);
  std::vector<IntegerPoint> z;
  for (const gjk::VertexPair pair : pairs) z.push_back(difference(pair));
  Truth out;
  for (;;) {
    const Nearest p = nearest(z);
    if (p.overlap) {
      out.overlap = true;
      out.denominator = 1;
      return out;
    }
    const gjk::VertexPair farther = nearest_along(p.normal);
    IntegerPoint support = difference(farther);
    if (dot(p.normal, support) >= p.reach) {
      out.numerator = p.numerator;
      out.denominator = p.denominator;
      const Scaled above = scaled(out.numerator);
      const Scaled below = scaled(out.denominator);
      const long power = above.exponent - below.exponent;
      const long odd = power & 1;
      const long double quotient = std::ldexp(above.value / below.value, static_cast<int>(odd));
      out.distance =
          std::ldexp(std::sqrt(quotient), static_cast<int>((power - odd) / 2) + exponent_);
      return out;
    }
    std::vector<IntegerPoint> next;
    for (int i = 0; i < p.face_size; ++i) next.push_back(z[static_cast<std::size_t>(p.face[i])]);
    next.push_back(std::move(support));
    z = std::move(next);
  }
}

bool ExactPair::touching() const {
  // Some line through O has all of Z on one side; it can be turned until it meets a vertex of Z.
  bool any_away = false;
  for (const IntegerPoint& x : x_) {
    for (const IntegerPoint& y : y_) {
      const IntegerPoint z = minus(y, x);
      if (z.x == 0 && z.y == 0) continue;
      any_away = true;
      for (const int sign : {1, -1}) {
        const IntegerPoint normal{mpz_class(-z.y * sign), mpz_class(z.x * sign)};
        if (dot(normal, difference(nearest_along(normal))) == 0) return true;
      }
    }
  }
  return !any_away;
}

int ExactPair::compare(double bound, const Truth& truth) const {
  if (truth.overlap) return bound > 0 ? 1 : 0;
  const long double difference = static_cast<long double>(bound) - truth.distance;
  if (std::abs(difference) > std::ldexp(truth.distance, -60)) return difference > 0 ? 1 : -1;
  const Dyadic exact = dyadic(bound);
  mpz_class left = exact.mantissa;
  left *= left;
  left *= truth.denominator;
  mpz_class right = truth.numerator;
  const int shift = 2 * (exact.exponent - exponent_);
  (shift > 0 ? left : right) <<= static_cast<mp_bitcnt_t>(std::abs(shift));
  return cmp(left, right) > 0 ? 1 : left == right ? 0 : -1;
}

long double ExactPair::scale() const {
  long double largest = 0;
  for (const NearPoint& x : x_near_) {
    for (const NearPoint& y : y_near_) largest = std::max(largest, length(minus(y, x)));
  }
  return largest;
}

long double ExactPair::distance_from_x(const Eigen::Vector2d& point) const {
  return distance_from_hull(near(point), x_near_);
}
long double ExactPair::distance_from_y(const Eigen::Vector2d& point) const {
  return distance_from_hull(near(point), y_near_);
}

NearPoint ExactPair::near(const IntegerPoint& point) const {
  const auto relative = [&](const mpz_class& value, double from) {
    const Dyadic exact = dyadic(from);
    mpz_class shifted = exact.mantissa;
    if (exact.mantissa != 0) shifted <<= static_cast<mp_bitcnt_t>(exact.exponent - exponent_);
    return std::ldexp(rounded(value - shifted), exponent_);
  };
  return {relative(point.x, origin_[0]), relative(point.y, origin_[1])};
}
NearPoint ExactPair::near(const Eigen::Vector2d& point) const {
  return {static_cast<long double>(point[0]) - origin_[0],
          static_cast<long double>(point[1]) - origin_[1]};
}

}  // namespace truth
