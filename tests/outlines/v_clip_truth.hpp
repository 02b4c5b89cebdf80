#pragma once
// Pairs of bodies in space, and the truth about walks on their features: GJK's exact verdict, and
// in GMP's rationals that the planes through the closest points support the bodies.

#include <gmpxx.h>

#include <set>
#include <string>

#include "depth/pairs_in_space.hpp"
#include "gjk/gjk.hpp"
#include "outlines/v_clip.hpp"

namespace test::v_clip_truth {

using Eigen::Vector3d;
using v_clip::Body;
using v_clip::Feature;
using v_clip::Kind;
using v_clip::Query;
using v_clip::Reason;
using v_clip::Stop;

using Exact = std::array<mpq_class, 3>;
inline Exact exact(const Vector3d& p) {
  return {mpq_class(p[0]), mpq_class(p[1]), mpq_class(p[2])};
}
inline Exact operator-(const Exact& a, const Exact& b) {
  return {mpq_class(a[0] - b[0]), mpq_class(a[1] - b[1]), mpq_class(a[2] - b[2])};
}
inline Exact operator+(const Exact& a, const Exact& b) {
  return {mpq_class(a[0] + b[0]), mpq_class(a[1] + b[1]), mpq_class(a[2] + b[2])};
}
inline Exact operator*(const mpq_class& s, const Exact& a) {
  return {mpq_class(s * a[0]), mpq_class(s * a[1]), mpq_class(s * a[2])};
}
inline mpq_class dot(const Exact& a, const Exact& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Exact cross(const Exact& a, const Exact& b) {
  return {mpq_class(a[1] * b[2] - a[2] * b[1]), mpq_class(a[2] * b[0] - a[0] * b[2]),
          mpq_class(a[0] * b[1] - a[1] * b[0])};
}

/// The corners of a feature.
inline std::vector<Vector3d> corners_of(const Body& body, Feature f) {
  const auto index = static_cast<std::size_t>(f.index);
  const auto at = [&](int v) { return body.points[static_cast<std::size_t>(v)]; };
  if (f.kind == Kind::vertex) return {at(f.index)};
  if (f.kind == Kind::edge) return {at(body.edges[index].from), at(body.edges[index].to)};
  std::vector<Vector3d> out;
  for (const int v : body.faces[index].vertices) out.push_back(at(v));
  return out;
}

/// Closest points of two final features, which are no two faces and no edge and face: feet on the
/// lines and planes that hold them.
inline std::array<Exact, 2> feet(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  if (a.size() > b.size()) {
    const auto [y, x] = feet(b, a);
    return {x, y};
  }
  const Exact p = exact(a[0]);
  const Exact q = exact(b[0]);
  if (b.size() == 1) return {p, q};
  const Exact w = exact(b[1]) - q;
  if (a.size() == 1 && b.size() == 2) {
    const mpq_class share = dot(w, p - q) / dot(w, w);
    return {p, q + share * w};
  }
  if (a.size() == 1) {
    const Exact n = cross(w, exact(b[2]) - q);
    const mpq_class share = dot(n, q - p) / dot(n, n);
    return {p, p + share * n};
  }
  const Exact u = exact(a[1]) - p;
  const Exact n = cross(u, w);
  const mpq_class of_a = dot(cross(q - p, w), n) / dot(n, n);
  const mpq_class of_b = dot(cross(q - p, u), n) / dot(n, n);
  return {p + of_a * u, q + of_b * w};
}

/// Whether a point of the line or plane of a feature lies in the feature.
inline bool lies_in(const Exact& p, const std::vector<Vector3d>& corners) {
  const auto at = [&](std::size_t i) { return exact(corners[i % corners.size()]); };
  if (corners.size() == 1) return p == at(0);
  if (corners.size() == 2) return dot(p - at(0), p - at(1)) <= 0;
  const Exact n = cross(at(1) - at(0), at(2) - at(0));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (dot(n, cross(at(i + 1) - at(i), p - at(i))) < 0) return false;
  }
  return dot(n, p - at(0)) == 0;
}

/// Whether the plane through p, normal to n, supports the points, and all corners of the feature
/// lie in it: then p + n lies in the feature's Voronoi region.
inline bool supports(const Exact& p, const Exact& n, const std::vector<Vector3d>& points,
                     const std::vector<Vector3d>& feature) {
  for (const Vector3d& v : points) {
    if (dot(n, exact(v) - p) > 0) return false;
  }
  for (const Vector3d& v : feature) {
    if (dot(n, exact(v) - p) != 0) return false;
  }
  return true;
}

/// The error of a length beside the root of its square, in roundings: 2^-53 of it, or half of the
/// smallest positive number.
inline double error_of(double length, const mpq_class& squared) {
  const mpf_class root = sqrt(mpf_class(squared, 4000));
  const mpf_class error = abs(mpf_class(length, 4000) - root);
  const mpf_class rounding = std::max<mpf_class>(root * 0x1p-53, mpf_class(0x1p-1074) / 2);
  return mpf_class(error / rounding).get_d();
}

struct Row {
  long pairs = 0;
  long overlaps = 0;
  std::array<long, 6> kinds = {};  ///< Final pairs: vv, ve, vf, ee, and none of the others.
  std::array<long, 13> reasons = {};
  int most_pairs = 0;
  double error = 0.0;
  long broken = 0;
  std::vector<std::string> failures;  ///< The first ones.

  void fail(const std::string& what) {
    constexpr std::size_t kKept = 3;
    ++broken;
    if (failures.size() < kKept) failures.push_back(what);
  }
  void add(const Row& other) {
    pairs += other.pairs;
    overlaps += other.overlaps;
    for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] += other.kinds[i];
    for (std::size_t i = 0; i < reasons.size(); ++i) reasons[i] += other.reasons[i];
    most_pairs = std::max(most_pairs, other.most_pairs);
    error = std::max(error, other.error);
    broken += other.broken;
    for (const std::string& failure : other.failures) failures.push_back(failure);
    if (failures.size() > 3) failures.resize(3);
  }
};

/// The flaw of a walk's end; empty if it has none.
inline std::string flaw_of(const Query& query, const v_clip::Result& result, Row& row) {
  constexpr double kMostError = 4.0;  // in roundings
  const auto gjk = gjk::distance<double>(gjk::Query<double, 3>{{query.x.points}, {query.y.points}});
  if (gjk.verdict == gjk::Verdict::undecided || gjk.verdict == gjk::Verdict::none)
    return "GJK has no verdict";
  const bool apart = gjk.verdict == gjk::Verdict::separated;
  row.overlaps += !apart;
  if (result.stop != (apart ? Stop::closest : Stop::overlap)) return "verdict";
  if (!apart) return result.points.distance == 0.0 && result.points.x == result.points.y ? "" : "0";
  const auto of_x = corners_of(query.x, result.x);
  const auto of_y = corners_of(query.y, result.y);
  if (of_x.size() > 1 && of_y.size() > 1 && of_x.size() + of_y.size() > 4) return "kinds";
  ++row.kinds[of_x.size() + of_y.size() > 4    ? 2
              : of_x.size() * of_y.size() == 4 ? 3
                                               : of_x.size() + of_y.size() - 2];
  const auto [x, y] = feet(of_x, of_y);
  if (!lies_in(x, of_x) || !lies_in(y, of_y)) return "a closest point is not on its feature";
  const Exact gap = y - x;
  if (!supports(x, gap, query.x.points, of_x)) return "the region of X's feature";
  if (!supports(y, x - y, query.y.points, of_y)) return "the region of Y's feature";
  const double error = error_of(result.points.distance, dot(gap, gap));
  row.error = std::max(row.error, error);
  if (error > kMostError) return "distance";
  if (result.points.distance * (1 + 0x1p-50) < gjk.lower ||
      gjk.upper < result.points.distance * (1 - 0x1p-50))
    return "GJK's bounds";
  for (int i = 0; i < 3; ++i) {
    const auto is_near = [&](double value, const mpq_class& truth) {
      return abs(mpq_class(value) - truth) <=
             mpq_class(0x1p-50) * abs(truth) + mpq_class(0x1p-1074);
    };
    if (!is_near(result.points.x[i], x[static_cast<std::size_t>(i)]) ||
        !is_near(result.points.y[i], y[static_cast<std::size_t>(i)]))
      return "witness";
  }
  return "";
}

inline bool starts_alone(Reason reason) {
  return reason == Reason::clip_empty || reason == Reason::two_faces;
}

/// The flaw of the steps on the way; empty if they have none.
inline std::string flaw_of(const v_clip::Trace& trace, Row& row) {
  std::set<std::pair<Feature, Feature>> seen = {{trace.start.x, trace.start.y}};
  double last = std::numeric_limits<double>::infinity();
  Reason reason = Reason::none;
  for (const v_clip::Step& step : trace.steps) {
    if (step.phase != v_clip::Phase::swap) {
      reason = step.after.next.reason;
      if (reason == Reason::none) continue;
      ++row.reasons[static_cast<std::size_t>(reason)];
      // There the first pair has no distance to fall from.
      if (starts_alone(reason) && seen.size() > 1) return "a rule of the start on the way";
      continue;
    }
    if (!seen.insert({step.after.x, step.after.y}).second) return "a pair came twice";
    const double now = step.points.distance;
    if (!starts_alone(reason) && now > last * (1 + 0x1p-50)) return "the distance rose";
    last = now;
  }
  return "";
}

/// A walk of any start: held to the truth, and its trace to that.
inline void check(const Query& query, Feature x, Feature y, Row& row, const std::string& name) {
  ++row.pairs;
  const v_clip::State start = v_clip::start(query, x, y);
  const v_clip::Result result = v_clip::walk(query, start);
  const v_clip::Trace trace = v_clip::trace(query, start);
  row.most_pairs = std::max(row.most_pairs, result.pairs);
  std::string flaw = flaw_of(query, result, row);
  if (flaw.empty()) flaw = flaw_of(trace, row);
  if (flaw.empty() && (trace.result.x != result.x || trace.result.y != result.y ||
                       trace.result.pairs != result.pairs))
    flaw = "trace and walk part";
  if (!flaw.empty()) row.fail(name + ": " + flaw);
}

/// Any feature of a body.
inline Feature any_feature(families::Source& source, const Body& body) {
  const auto among = [&](std::size_t count) {
    return source.among(0, static_cast<int>(count) - 1);
  };
  const int kind = source.among(0, 2);
  if (kind == 2 && !body.faces.empty()) return {Kind::face, among(body.faces.size())};
  if (kind == 1 && !body.edges.empty()) return {Kind::edge, among(body.edges.size())};
  return {Kind::vertex, body.vertices[static_cast<std::size_t>(among(body.vertices.size()))]};
}

/// Families of pairs: those of the study, and those in space of depth; then round prisms and
/// pyramids, with faces of many sides and vertices of many edges.
inline constexpr int kFamilies = space::kDepthFamilyCount + 1;
inline std::string family_name(int family) {
  return family == kFamilies - 1
             ? "many-sided"
             : std::string(space::name_of(static_cast<space::DepthFamily>(family)));
}

/// A prism, or a pyramid, over a polygon of whole coordinates; the axis along a coordinate axis.
inline std::vector<Vector3d> many_sided(families::Source& source) {
  constexpr double kRadius = 1024;
  const int sides = source.among(3, 40);
  const bool pyramid = source.with_chance(0.5);
  const int axis = source.among(0, 2);
  const Vector3d at(source.among(-3000, 3000), source.among(-3000, 3000),
                    source.among(-3000, 3000));
  std::vector<Vector3d> out;
  const auto add = [&](double u, double v, double w) {
    Vector3d p;
    p[axis] = w;
    p[(axis + 1) % 3] = u;
    p[(axis + 2) % 3] = v;
    out.push_back(p + at);
  };
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * 3.14159265358979 * i / sides;
    const double u = std::nearbyint(kRadius * std::cos(angle));
    const double v = std::nearbyint(kRadius * std::sin(angle));
    add(u, v, 0);
    if (!pyramid) add(u, v, 512);
  }
  if (pyramid) add(0, 0, source.with_chance(0.5) ? 700 : -700);
  return out;
}

inline std::array<std::vector<Vector3d>, 2> points_of(families::Source& source, int family) {
  if (family == kFamilies - 1) return {many_sided(source), many_sided(source)};
  const auto values = source.with_chance(0.5) ? families::Representation::full_doubles
                                              : families::Representation::float_values;
  auto of = static_cast<space::DepthFamily>(family);
  const bool is_extreme = of == space::DepthFamily::extreme;
  const std::array<int, 5> others = {
      static_cast<int>(families::Family::random), static_cast<int>(families::Family::touching),
      static_cast<int>(families::Family::needle), static_cast<int>(families::Family::flat),
      static_cast<int>(space::DepthFamily::boxes)};
  if (is_extreme)
    of = static_cast<space::DepthFamily>(others[static_cast<std::size_t>(source.among(0, 4))]);
  space::Pair pair = space::pair_of(source, of, values);
  if (is_extreme) pair = scaled(pair, source.with_chance(0.5) ? 332 : -332);
  const auto placed = [](const std::vector<Vector3d>& points, const auto& pose) {
    std::vector<Vector3d> out;
    for (const Vector3d& p : points) out.push_back(pose.rotation.matrix() * p + pose.translation);
    return out;
  };
  return {placed(pair.x, pair.x_pose), placed(pair.y, pair.y_pose)};
}

/// Pairs of one family, each from a start of its own.
inline Row check_family(int family, std::uint64_t seed, long pairs) {
  families::Source source(seed);
  Row row;
  for (long i = 0; i < pairs; ++i) {
    const auto points = points_of(source, family);
    const Body x = v_clip::body_of(points[0]);
    const Body y = v_clip::body_of(points[1]);
    const Feature of_x = any_feature(source, x);
    const Feature of_y = any_feature(source, y);
    check({x, y}, of_x, of_y, row, family_name(family) + " " + std::to_string(i));
  }
  return row;
}

}  // namespace test::v_clip_truth
