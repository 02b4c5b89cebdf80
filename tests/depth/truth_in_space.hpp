#pragma once
// The exact penetration depth in space, from all faces of Z, and answers judged by it. Integers: on
// a common grid nothing rounds.
//
// A face of Z = Y - X is parallel to a face of X or of Y, or to an edge of X and one of Y. Along
// any direction Z reaches at least as far as it is deep, so the depth is the least reach over all
// normals of these: Z itself need not be built.

#include "depth/depth.hpp"
#include "outlines/polyhedron.hpp"
#include "truth.hpp"

namespace test::space {

using Pair = families::Pair<double, 3>;
using ExactPoint = std::array<mpz_class, 3>;
using RationalPoint = std::array<mpq_class, 3>;

[[nodiscard]] inline ExactPoint minus(const ExactPoint& a, const ExactPoint& b) {
  return {mpz_class(a[0] - b[0]), mpz_class(a[1] - b[1]), mpz_class(a[2] - b[2])};
}
[[nodiscard]] inline ExactPoint cross(const ExactPoint& a, const ExactPoint& b) {
  return {mpz_class(a[1] * b[2] - a[2] * b[1]), mpz_class(a[2] * b[0] - a[0] * b[2]),
          mpz_class(a[0] * b[1] - a[1] * b[0])};
}
template <class A, class B>
[[nodiscard]] A dot(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  return A(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}
[[nodiscard]] inline bool is_zero(const ExactPoint& a) {
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

/// The vertices of a shape on the grid, and the directions of its edges and normals of its faces.
struct ExactShape {
  std::vector<ExactPoint> points;
  std::vector<ExactPoint> edges;
  std::vector<ExactPoint> normals;
};

/// Vectors with one coordinate scaled to about 1: what is left of them in double.
class Rounded {
 public:
  explicit Rounded(const std::vector<ExactPoint>& points) {
    for (const ExactPoint& p : points) {
      for (const mpz_class& c : p) top_ = std::max(top_, exponent_of(c));
    }
    for (const ExactPoint& p : points) values_.push_back(of(p, top_));
  }
  [[nodiscard]] const std::vector<std::array<double, 3>>& values() const { return values_; }
  [[nodiscard]] long top() const { return top_; }

  [[nodiscard]] static std::array<double, 3> of(const ExactPoint& p, long top) {
    std::array<double, 3> out = {};
    for (std::size_t i = 0; i < 3; ++i) {
      long exponent = 0;
      const double mantissa = mpz_get_d_2exp(&exponent, p[i].get_mpz_t());
      out[i] = std::ldexp(mantissa, static_cast<int>(std::max(exponent - top, -2000L)));
    }
    return out;
  }
  [[nodiscard]] static long exponent_of(const mpz_class& c) {
    return c == 0 ? 0 : static_cast<long>(mpz_sizeinbase(c.get_mpz_t(), 2));
  }

 private:
  long top_ = 0;
  std::vector<std::array<double, 3>> values_;
};

/// A pair on a grid.
struct Truth {
  gjk::Verdict verdict = gjk::Verdict::separated;
  mpq_class depth_sq;     ///< On the grid.
  mpz_class per_unit;     ///< A length of 1 is so many steps of the grid.
  long double scale = 0;  ///< The largest distance between a vertex of X and one of Y.
  ExactShape x;
  ExactShape y;

  [[nodiscard]] mpq_class on_grid(double length) const { return mpq_class(length) * per_unit; }
  [[nodiscard]] long double from_grid(const mpq_class& length) const {
    return to_long_double(length / per_unit);
  }
  /// How far Z reaches along a direction, times its length.
  template <class A>
  [[nodiscard]] A reach(const std::array<A, 3>& direction) const {
    A most;
    A least;
    for (std::size_t i = 0; i < y.points.size(); ++i) {
      const A along = dot(direction, y.points[i]);
      if (i == 0 || most < along) most = along;
    }
    for (std::size_t i = 0; i < x.points.size(); ++i) {
      const A along = dot(direction, x.points[i]);
      if (i == 0 || along < least) least = along;
    }
    return A(most - least);
  }
};

namespace detail {

[[nodiscard]] inline std::vector<RationalPoint> moved(const std::vector<Eigen::Vector3d>& points,
                                                      const gjk::Pose<double, 3>& pose) {
  std::vector<RationalPoint> out;
  for (const Eigen::Vector3d& p : points) {
    RationalPoint& q = out.emplace_back();
    for (int row = 0; row < 3; ++row) {
      mpq_class& at = q[static_cast<std::size_t>(row)];
      at = mpq_class(pose.translation[row]);
      for (int k = 0; k < 3; ++k) at += mpq_class(pose.rotation(row, k)) * mpq_class(p[k]);
    }
  }
  return out;
}

/// The shape on the grid. Its hull is that of the points before they were turned.
[[nodiscard]] inline ExactShape on_grid(const std::vector<Eigen::Vector3d>& points,
                                        const std::vector<RationalPoint>& in_world,
                                        const mpz_class& per_unit) {
  // About as large as 1: squares of the smallest numbers are 0.
  double largest = 0.0;
  for (const Eigen::Vector3d& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  std::vector<Eigen::Vector3d> sized = points;
  for (Eigen::Vector3d& p : sized) {
    for (int i = 0; i < 3 && largest > 0.0; ++i) p[i] = std::ldexp(p[i], -std::ilogb(largest));
  }
  const gjkscope::Polyhedron hull = gjkscope::exact_hull(sized);
  std::vector<ExactPoint> all;
  for (const RationalPoint& p : in_world) {
    ExactPoint& q = all.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) q[i] = p[i].get_num() * (per_unit / p[i].get_den());
  }
  const auto at = [&](int i) -> const ExactPoint& { return all[static_cast<std::size_t>(i)]; };
  ExactShape out;
  for (const int i : hull.vertices) out.points.push_back(at(i));
  for (const gjkscope::Polyhedron::Edge& edge : hull.edges)
    out.edges.push_back(minus(at(edge.to), at(edge.from)));
  for (const gjkscope::Polyhedron::Face& face : hull.faces) {
    const std::vector<int>& v = face.vertices;
    out.normals.push_back(cross(minus(at(v[1]), at(v[0])), minus(at(v[2]), at(v[0]))));
  }
  for (const ExactPoint& edge : out.edges) {  // of a hull that is flat
    const ExactPoint normal = cross(out.edges[0], edge);
    if (!hull.faces.empty() || is_zero(normal)) continue;
    out.normals.push_back(normal);
    break;
  }
  return out;
}

/// The verdict of a Z that lies in the plane with this normal, or on a line of it.
[[nodiscard]] inline gjk::Verdict verdict_of_flat(const std::vector<ExactPoint>& z,
                                                  const ExactPoint& normal) {
  if (dot(normal, z[0]) != 0) return gjk::Verdict::separated;
  std::size_t dropped = 0;
  while (normal[dropped] == 0) ++dropped;
  std::vector<test::ExactPoint> flat;
  for (const ExactPoint& p : z) flat.push_back({p[(dropped + 1) % 3], p[(dropped + 2) % 3]});
  const std::vector<test::ExactPoint> hull = hull_of(std::move(flat));
  if (hull.size() == 1) {
    return length_sq(hull[0]) == 0 ? gjk::Verdict::touching : gjk::Verdict::separated;
  }
  bool inside = true;
  for (std::size_t i = 0; i < hull.size(); ++i)
    inside = inside && test::cross(hull[i], hull[(i + 1) % hull.size()]) >= 0;
  if (hull.size() == 2) {
    inside = inside && hull[0][0] * hull[1][0] + hull[0][1] * hull[1][1] <= 0;
  }
  return inside ? gjk::Verdict::touching : gjk::Verdict::separated;
}

}  // namespace detail

[[nodiscard]] inline Truth truth_of(const Pair& pair) {
  const std::vector<RationalPoint> x = detail::moved(pair.x, pair.x_pose);
  const std::vector<RationalPoint> y = detail::moved(pair.y, pair.y_pose);
  Truth out;
  out.per_unit = 1;
  for (const std::vector<RationalPoint>* points : {&x, &y}) {
    for (const RationalPoint& p : *points) {
      for (const mpq_class& coordinate : p) {  // denominators are powers of two
        if (out.per_unit < coordinate.get_den()) out.per_unit = coordinate.get_den();
      }
    }
  }
  out.x = detail::on_grid(pair.x, x, out.per_unit);
  out.y = detail::on_grid(pair.y, y, out.per_unit);
  std::vector<ExactPoint> z;
  mpz_class farthest_sq;
  for (const ExactPoint& a : out.x.points) {
    for (const ExactPoint& b : out.y.points) {
      z.push_back(minus(b, a));
      farthest_sq = std::max(farthest_sq, dot(z.back(), z.back()));
    }
  }
  // The root of twice the digits has all those of a long double.
  out.scale = out.from_grid(mpq_class(sqrt(mpz_class(farthest_sq << 256)), mpz_class(1) << 128));

  // All normals of faces that Z may have, in both senses.
  std::vector<ExactPoint> normals;
  const auto add = [&](const ExactPoint& normal) {
    if (!is_zero(normal)) normals.push_back(normal);
  };
  for (const ExactShape* shape : {&out.x, &out.y}) {
    for (const ExactPoint& normal : shape->normals) add(normal);
  }
  for (const ExactPoint& a : out.x.edges) {
    for (const ExactPoint& b : out.y.edges) add(cross(a, b));
  }
  const auto is_across = [&](const ExactPoint& normal) {
    return std::all_of(z.begin(), z.end(),
                       [&](const ExactPoint& p) { return dot(normal, p) == dot(normal, z[0]); });
  };
  if (normals.empty()) {  // a point or a line: any plane of it, or two
    std::array<ExactPoint, 3> axes;
    for (std::size_t i = 0; i < 3; ++i) axes[i][i] = 1;
    ExactPoint along;
    for (const ExactShape* shape : {&out.x, &out.y}) {
      if (!shape->edges.empty()) along = shape->edges[0];
    }
    out.verdict = gjk::Verdict::touching;
    for (const ExactPoint& axis : axes) {
      const ExactPoint normal = is_zero(along) ? axis : cross(along, axis);
      if (is_zero(normal)) continue;
      if (detail::verdict_of_flat(z, normal) == gjk::Verdict::separated)
        out.verdict = gjk::Verdict::separated;
    }
    return out;
  }
  if (const auto flat = std::find_if(normals.begin(), normals.end(), is_across);
      flat != normals.end()) {
    out.verdict = detail::verdict_of_flat(z, *flat);
    return out;
  }

  // The least reach, in double first: what comes close is asked exactly.
  const Rounded differences(z);
  std::vector<std::array<double, 2>> reaches;
  double least = std::numeric_limits<double>::infinity();
  for (const ExactPoint& normal : normals) {
    const std::array<double, 3> n = Rounded({normal}).values()[0];
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    std::array<double, 2> reach = {-4.0, -4.0};
    for (const std::array<double, 3>& p : differences.values()) {
      const double along = (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) / length;
      reach = {std::max(reach[0], along), std::max(reach[1], -along)};
    }
    reaches.push_back(reach);
    least = std::min({least, reach[0], reach[1]});
  }
  constexpr double kRounding = 1e-13;  // of the largest coordinate, which is about 1
  out.verdict = gjk::Verdict::overlapping;
  bool is_first = true;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (least + kRounding < reaches[i][side]) continue;
      ExactPoint normal = normals[i];
      if (side == 1) normal = minus(ExactPoint(), normal);
      const mpz_class reach = out.reach(normal);
      if (reach < 0) out.verdict = gjk::Verdict::separated;
      mpq_class distance_sq(reach * reach, dot(normal, normal));
      distance_sq.canonicalize();
      if (is_first || distance_sq < out.depth_sq) out.depth_sq = distance_sq;
      is_first = false;
    }
  }
  if (out.verdict == gjk::Verdict::separated) {
    out.depth_sq = 0;
  } else if (out.depth_sq == 0) {
    out.verdict = gjk::Verdict::touching;
  }
  return out;
}

namespace detail {

/// How far a point lies outside of a shape: by a run of many digits, and where its bounds are not
/// close by one in double, which is settled exactly.
[[nodiscard]] inline long double outside(const RationalPoint& q, const ExactShape& shape,
                                         const Truth& truth) {
  using Point = Eigen::Matrix<long double, 3, 1>;
  families::Pair<long double, 3> pair;
  for (const ExactPoint& p : shape.points) {
    pair.x.emplace_back(truth.from_grid(p[0] - q[0]), truth.from_grid(p[1] - q[1]),
                        truth.from_grid(p[2] - q[2]));
  }
  pair.y = {Point(0, 0, 0)};
  gjk::Options options;
  options.proof = gjk::Proof::bounds;
  const auto found = gjk::distance<long double>(pair.query(), options);
  if (found.upper - found.lower <= 0x1p-56L * truth.scale) return found.distance;
  return gjk::distance<double>(families::converted<double>(pair).query()).distance;
}

}  // namespace detail

/// An answer against the truth. Bars are the caller's.
template <class R>
[[nodiscard]] Judgement judge(const depth::Result<R, 3>& found, const Truth& truth) {
  Judgement out;
  const auto exact = [&](const R& a) { return truth.on_grid(static_cast<double>(a)); };
  const auto point = [&](const gjk::Vec<R, 3>& p) {
    return RationalPoint{exact(p[0]), exact(p[1]), exact(p[2])};
  };
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
  RationalPoint d;
  for (int i = 0; i < 3; ++i)
    d[static_cast<std::size_t>(i)] = mpq_class(static_cast<double>(found.direction[i]));
  const mpq_class reach = truth.reach(d);
  const mpq_class d_sq = dot(d, d);
  const bool parts = reach <= 0 || reach * reach <= upper * upper * d_sq;
  if (!parts && truth.verdict == gjk::Verdict::overlapping) out.broken = "does not part";
  const auto u = static_cast<double>(gjk::ScalarTraits<R>::unit_roundoff());
  if (std::abs(mpq_class(d_sq - 1).get_d()) > 8 * u) out.broken = "length of the direction";

  const RationalPoint t = point(found.translation);
  const RationalPoint x = point(found.x);
  const RationalPoint y = point(found.y);
  const mpq_class square = truth.depth_sq;
  const mpz_class wide = (square.get_num() << 256) / square.get_den();
  const mpq_class depth(sqrt(wide), mpz_class(1) << 128);
  const long double unit =
      std::max<long double>(u * truth.scale, std::numeric_limits<R>::denorm_min());
  out.error = std::abs(truth.from_grid(exact(found.depth) - depth)) / unit;
  out.width = truth.from_grid(upper - lower) / unit;
  // The rest of the overlap, seen along the direction, once X is moved by the translation.
  out.touch = std::abs(truth.from_grid(reach - dot(d, t))) / unit;

  // Far from the origin world coordinates stand on a coarse grid.
  const auto forgiven = [&](const gjk::Vec<R, 3>& p) {
    const long double away =
        std::hypot(static_cast<long double>(p[0]), static_cast<long double>(p[1]),
                   static_cast<long double>(p[2]));
    return u * std::max(0.0L, away - truth.scale);
  };
  const long double rest =
      std::hypot(truth.from_grid(y[0] - x[0] - t[0]), truth.from_grid(y[1] - x[1] - t[1]),
                 truth.from_grid(y[2] - x[2] - t[2]));
  out.contact = std::max({0.0L, detail::outside(x, truth.x, truth) - forgiven(found.x),
                          detail::outside(y, truth.y, truth) - forgiven(found.y),
                          rest - forgiven(found.x) - forgiven(found.y)}) /
                unit;
  return out;
}

}  // namespace test::space
