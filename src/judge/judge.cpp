#include "judge/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "depth/instances.hpp"

namespace gjkscope::judging {
namespace {

using Vertex = gjk::Vec<Rational, 3>;
using gjk::VertexPair;
using Pairs = std::vector<VertexPair>;

Vertex exact(const Point& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }
double length(const Vertex& v) { return root_nearest(gjk::dot(v, v)); }
Vertex difference(const Vertex& a, const Vertex& b) { return a - b; }

/// The simplex of all vertices.
gjk::Simplex<Rational, 3> simplex_of(const std::vector<Vertex>& vertices) {
  gjk::Simplex<Rational, 3> out;
  out.count = static_cast<int>(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) out.vertices[i].w = vertices[i];
  return out;
}

/// The point closest to O of one to four vertices.
struct Nearest {
  gjk::Face face = 0;  ///< In whose region O lies.
  Vertex p;
  std::array<Rational, 4> weights;
  double distance = 0;
};
Nearest nearest_of(const std::vector<Vertex>& vertices) {
  gjk::State<Rational, 3> state;
  state.simplex = simplex_of(vertices);
  gjk::NoRecord none;
  gjk::find_closest_point(state, gjk::Options{}, none);
  return {state.region, state.p, state.simplex.weights, length(state.p)};
}

/// The largest length of the vertices, and the smallest height of their simplex over a face; the
/// latter is infinite for a point.
struct Extent {
  double longest = 0;
  double height = std::numeric_limits<double>::infinity();
  double thin =
      1;  ///< For a triangle or a tetrahedron L^2 / area or L^3 / volume, but for a factor.
};
Extent extent_of(const std::vector<Vertex>& vertices) {
  Extent out;
  std::vector<Point> points;
  for (const Vertex& v : vertices) {
    out.longest = std::max(out.longest, length(v));
    points.emplace_back(to_double(v[0]), to_double(v[1]), to_double(v[2]));
  }
  const std::size_t count = points.size();
  if (count == 1 || out.longest == 0) return out;
  for (Point& p : points) p /= out.longest;
  double content = 0;  // of all, and the largest of a face: length, area, volume
  double of_face = 1;
  const auto edge = [&](std::size_t i, std::size_t k) { return Point(points[k] - points[i]); };
  const auto normal = [&](std::size_t i, std::size_t j, std::size_t k) {
    return gjk::cross<double>(edge(i, j), edge(i, k));
  };
  if (count == 2) {
    content = edge(0, 1).norm();
  } else if (count == 3) {
    content = normal(0, 1, 2).norm();
    of_face = std::max({edge(0, 1).norm(), edge(1, 2).norm(), edge(2, 0).norm()});
  } else {
    content = std::abs(normal(0, 1, 2).dot(edge(0, 3)));
    of_face = std::max({normal(0, 1, 2).norm(), normal(0, 1, 3).norm(), normal(0, 2, 3).norm(),
                        normal(1, 2, 3).norm()});
  }
  out.height = of_face == 0 ? 0 : out.longest * (content / of_face);
  if (count > 2) out.thin = std::max(1.0, 1 / content);
  return out;
}

/// One of the shapes, to be searched.
struct Body {
  std::vector<Vertex> vertices;
  std::vector<Point> scaled;  ///< Coordinates up to 1, but for rounding far below that.
  double longest = 0;         ///< The largest length of a vertex.

  explicit Body(const std::vector<Point>& points) : scaled(points) {
    double most = 0;
    for (const Point& p : points) {
      vertices.push_back(exact(p));
      most = std::max(most, p.cwiseAbs().maxCoeff());
      longest = std::max(longest, p.stableNorm());
    }
    if (most == 0) return;
    const int exponent = std::ilogb(most) + 1;
    for (Point& p : scaled) {
      for (double& c : p) c = std::ldexp(c, -exponent);
    }
  }

  /// The vertex that lies farthest along d, which is not 0; of equal ones the first. Doubles rule
  /// out most vertices; the others are compared exactly.
  [[nodiscard]] int farthest(const Vertex& d, int sign) const {
    Point along(to_double(d[0]), to_double(d[1]), to_double(d[2]));
    const double most = along.cwiseAbs().maxCoeff();
    const bool is_usable = std::isfinite(most) && most > 1e-290;
    if (is_usable) along *= sign / most;
    constexpr double kError = 1e-14;  // more than 3 products of numbers up to 1 can be off
    double best = -std::numeric_limits<double>::infinity();
    if (is_usable) {
      for (const Point& p : scaled) best = std::max(best, along.dot(p));
    }
    int found = -1;
    Rational value;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (is_usable && along.dot(scaled[i]) < best - kError) continue;
      Rational here = gjk::dot(d, vertices[i]) * Rational(sign);
      if (found >= 0 && here <= value) continue;
      found = static_cast<int>(i);
      value = std::move(here);
    }
    return found;
  }
};

/// Whether a polygon, by its vertices in their order, turns both ways.
bool turns_both_ways(const std::vector<Point>& polygon) {
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const Point& c = polygon[(i + 2) % polygon.size()];
    const double turn = gjk::cross<double>(Point(b - a), Point(c - b))[2];
    left = left || turn > 0;
    right = right || turn < 0;
  }
  return left && right;
}

class Judge {
 public:
  explicit Judge(const Log& log)
      : log_(log), x_(log.x), y_(log.y), iterations_(log.iterations), unit_(roundoff(log.scalar)) {}

  Judgement run() {
    out_.iterations = static_cast<int>(iterations_.size());
    out_.cut_off = log_.cut_off;
    const gjk::Query<Rational, 3> query{{x_.vertices}, {y_.vertices}};
    const gjk::Result<Rational, 3> truth = gjk::distance<Rational>(query);
    distance_sq_ = truth.distance_sq;
    out_.distance = truth.distance;
    out_.overlap = distance_sq_.sign() == 0;
    resolve();
    find_cycle();
    for (std::size_t i = 0; i < steps_.size() && check(i); ++i) {
    }
    if (!out_.wrong) out_.wrong = unresolved_;
    check_answer();
    if (!out_.wrong && (out_.answer || !log_.answer)) check_early_stop();
    if (!out_.wrong && !out_.waste) check_late_stop();
    out_.steps = std::move(steps_);
    return std::move(out_);
  }

 private:
  static double roundoff(ScalarKind scalar) {
    return scalar == ScalarKind::half ? 0x1p-11 : scalar == ScalarKind::single ? 0x1p-24 : 0x1p-53;
  }
  /// The smallest positive number of the scalar.
  [[nodiscard]] double smallest() const {
    return log_.scalar == ScalarKind::half     ? 0x1p-24
           : log_.scalar == ScalarKind::single ? 0x1p-149
                                               : 0x1p-1074;
  }
  /// The part that rounding explains of an error whose unit is u `longest`.
  [[nodiscard]] double explained(double longest) const {
    return kUnits * (unit_ * longest + smallest());
  }
  /// The same for a point of the simplex of these vertices. Where that is thin, its corners move
  /// the point by more than they move themselves: areas and volumes have errors of u L^2 and u L^3.
  [[nodiscard]] double explained_on(const std::vector<Vertex>& vertices) const {
    const Extent extent = extent_of(vertices);
    return explained(extent.longest) * extent.thin;
  }
  /// The same for the choice of the face that holds P. In the plane edges decide it, which are no
  /// shorter than their error; in space areas and volumes do, of the facets alone if the whole
  /// simplex has no volume.
  [[nodiscard]] double explained_region(const std::vector<Vertex>& vertices) const {
    const double longest = extent_of(vertices).longest;
    if (log_.dimension == 2) return explained(longest);
    const double whole = explained_on(vertices);
    if (std::isfinite(whole)) return whole;
    double most = explained(longest);
    for (std::size_t i = 0; i < vertices.size() && vertices.size() == 4; ++i) {
      std::vector<Vertex> facet = vertices;
      facet.erase(facet.begin() + static_cast<long>(i));
      const double of_facet = explained_on(facet);
      if (std::isfinite(of_facet)) most = std::max(most, of_facet);
    }
    return most;
  }

  // Names and numbers as sentences have them.
  [[nodiscard]] std::string number(double value) const {
    return fmt::format("{:.{}g}", value + 0.0, log_.digits);  // no -0
  }
  [[nodiscard]] std::string x_name(int i) const {
    if (!log_.x_names.empty()) return log_.x_names[i];
    return fmt::format("{}{}", log_.a_is_x ? 'a' : 'b', i);
  }
  [[nodiscard]] std::string y_name(int i) const {
    if (!log_.y_names.empty()) return log_.y_names[i];
    return fmt::format("{}{}", log_.a_is_x ? 'b' : 'a', i);
  }
  [[nodiscard]] std::string shape_name(bool of_x) const {
    const std::string& given = of_x ? log_.x_name : log_.y_name;
    return !given.empty() ? given : of_x == log_.a_is_x ? "a" : "b";
  }
  [[nodiscard]] std::string name(const VertexPair& pair) const {
    if (log_.x_names.empty()) return y_name(pair.y) + " - " + x_name(pair.x);
    return log_.x.size() == 1 ? y_name(pair.y) : y_name(pair.y) + "−" + x_name(pair.x);
  }
  [[nodiscard]] std::string shown(const Point& p) const {
    return log_.dimension == 2
               ? fmt::format("({}, {})", number(p[0]), number(p[1]))
               : fmt::format("({}, {}, {})", number(p[0]), number(p[1]), number(p[2]));
  }
  [[nodiscard]] std::string shown(const Vertex& p) const {
    return shown(Point(to_double(p[0]), to_double(p[1]), to_double(p[2])));
  }
  [[nodiscard]] std::string names(const Pairs& pairs) const {
    std::string out;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      out += i == 0 ? "" : i + 1 == pairs.size() ? " and " : ", ";
      out += name(pairs[i]);
    }
    return out;
  }
  [[nodiscard]] std::string region(const Pairs& of, gjk::Face face) const {
    Pairs in_face;
    for (const int i : gjk::vertices_of(face)) in_face.push_back(of[i]);
    const std::string listed = names(in_face);
    if (in_face.size() == 1) return "the region of the vertex " + listed;
    if (static_cast<int>(in_face.size()) == log_.dimension + 1)
      return "the inside of the simplex " + listed;
    return fmt::format("the region of the {} {}", in_face.size() == 2 ? "edge" : "triangle",
                       listed);
  }

  [[nodiscard]] Vertex vertex(const VertexPair& pair) const {
    return difference(y_.vertices[pair.y], x_.vertices[pair.x]);
  }
  [[nodiscard]] std::vector<Vertex> vertices(const Pairs& pairs) const {
    std::vector<Vertex> out;
    for (const VertexPair& pair : pairs) out.push_back(vertex(pair));
    return out;
  }
  [[nodiscard]] bool same(const VertexPair& a, const VertexPair& b) const {
    return a == b || gjk::is_zero(difference(vertex(a), vertex(b)));
  }
  [[nodiscard]] bool holds(const Pairs& pairs, const VertexPair& pair) const {
    return std::any_of(pairs.begin(), pairs.end(),
                       [&](const VertexPair& each) { return same(each, pair); });
  }

  Finding finding(Part part, std::size_t i, std::string what) const {
    return {part, static_cast<int>(i) + 1, iterations_[i].line, std::move(what)};
  }
  /// A step is wrong: the checks end.
  bool fail(Part part, std::size_t i, std::string what) {
    out_.wrong = finding(part, i, std::move(what));
    return false;
  }
  /// An error beyond what rounding explains: in doubles, it may be that of a narrower scalar.
  bool fail(Part part, std::size_t i, std::string what, double error, double allowed) {
    constexpr double kOfFloat = 0x1p29;  // times as large
    if (log_.scalar == ScalarKind::double_ && error <= allowed * kOfFloat &&
        error > std::numeric_limits<float>::min())
      what +=
          "; rounding in float would explain it, which the log declares as \"scalar\":\"float\"";
    return fail(part, i, std::move(what));
  }
  void explain(Part part, std::size_t i, double error, double allowed) {
    if (!(error > 0) || !(allowed > 0)) return;
    const double units = kUnits * (error / allowed);
    if (units <= out_.rounding) return;
    out_.rounding = units;
    out_.rounded = finding(part, i, "");
  }

  // Claims that several lines make together.

  /// The pair whose difference is `point`, or nothing, with the reason.
  std::optional<VertexPair> pair_of(const Point& point, std::optional<VertexPair> given,
                                    std::size_t i) {
    const std::string p = shown(point);
    if (!point.allFinite()) {
      unresolved_ = finding(Part::vertex, i, fmt::format("the vertex {} is not finite", p));
      return std::nullopt;
    }
    const auto error = [&](const VertexPair& pair) {
      return length(difference(exact(point), vertex(pair)));
    };
    const double allowed = explained(x_.longest + y_.longest);
    const VertexPair nearest = given ? *given : nearest_pair(point);
    const double off = error(nearest);
    if (off <= allowed) {
      explain(Part::vertex, i, off, allowed);
      return nearest;
    }
    std::string what = fmt::format("the vertex {} is no difference: {} {} {}, which is {} away", p,
                                   given ? "its pair is" : "the nearest is", name(nearest),
                                   shown(vertex(nearest)), number(off));
    for (const auto& [x, y] : given ? Pairs{*given} : all_pairs()) {
      const Vertex& at_x = x_.vertices[x];
      const Vertex& at_y = y_.vertices[y];
      if (length(Vertex(exact(point) - at_y - at_x)) <= allowed) {
        what += fmt::format("; it is the sum {} + {}", y_name(y), x_name(x));
        break;
      }
      if (length(Vertex(exact(point) + at_y - at_x)) <= allowed) {
        what +=
            fmt::format("; it is {} - {}, the difference of the other sign", x_name(x), y_name(y));
        break;
      }
    }
    unresolved_ = finding(Part::vertex, i, what);
    return std::nullopt;
  }
  /// At most this many, for a hint.
  [[nodiscard]] Pairs all_pairs() const {
    constexpr std::size_t kMost = 4096;
    Pairs out;
    for (int x = 0; x < static_cast<int>(log_.x.size()); ++x) {
      for (int y = 0; y < static_cast<int>(log_.y.size()) && out.size() < kMost; ++y)
        out.push_back({x, y});
    }
    return out;
  }
  [[nodiscard]] VertexPair nearest_pair(const Point& point) {
    const std::array<double, 3> key = {point[0], point[1], point[2]};
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    VertexPair best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t y = 0; y < log_.y.size(); ++y) {
      for (std::size_t x = 0; x < log_.x.size(); ++x) {
        const double off = (log_.y[y] - log_.x[x] - point).cwiseAbs().maxCoeff();
        if (off < least) {
          least = off;
          best = {static_cast<int>(x), static_cast<int>(y)};
        }
      }
    }
    return known_[key] = best;
  }

  /// Pairs from pairs, points or both; false when one is not resolved.
  bool resolve_list(const Pairs& pairs, const std::vector<Point>& points, std::size_t i,
                    Pairs& out) {
    out = pairs;
    if (points.empty()) return true;
    out.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::optional<VertexPair> found =
          pair_of(points[k], pairs.empty() ? std::nullopt : std::optional(pairs[k]), i);
      if (!found) return false;
      out.push_back(*found);
    }
    return true;
  }

  bool resolve(std::size_t i) {
    const Iteration& it = iterations_[i];
    Step& step = steps_[i];
    if (!resolve_list(it.simplex, it.points, i, step.simplex) ||
        !resolve_list(it.kept, it.kept_points, i, step.kept))
      return false;
    step.support = it.support;
    if (it.support_point && !(step.support = pair_of(*it.support_point, it.support, i)))
      return false;
    if (i > 0 && !resolve_from(i, steps_[i - 1])) return false;
    for (const VertexPair& pair : step.kept) {
      if (step.simplex.empty() || holds(step.simplex, pair)) continue;
      unresolved_ = finding(
          Part::vertex, i, fmt::format("{} is kept, but the simplex does not hold it", name(pair)));
      return false;
    }
    return true;
  }
  /// A simplex is what the iteration before it kept, and its support point.
  bool resolve_from(std::size_t i, Step& before) {
    Step& step = steps_[i];
    if (step.simplex.empty()) {
      if (before.kept.empty() || !before.support) return true;
      step.simplex = before.kept;
      step.simplex.push_back(*before.support);
      return true;
    }
    if (!before.support) return true;
    const bool kept_is_logged = !before.kept.empty();
    const Pairs& source = kept_is_logged ? before.kept : before.simplex;
    Pairs rest = step.simplex;
    const auto added = std::find_if(rest.rbegin(), rest.rend(), [&](const VertexPair& pair) {
      return same(pair, *before.support);
    });
    if (added == rest.rend()) {
      unresolved_ =
          finding(Part::vertex, i,
                  fmt::format("the support point {} of the iteration before is not in the "
                              "simplex",
                              name(*before.support)));
      return false;
    }
    rest.erase(std::next(added).base());
    if (source.empty()) return true;
    for (const VertexPair& pair : rest) {
      if (holds(source, pair)) continue;
      unresolved_ = finding(
          Part::vertex, i,
          fmt::format("the simplex holds {}, which the iteration before did not leave in it",
                      name(pair)));
      return false;
    }
    if (!kept_is_logged) {
      before.kept = std::move(rest);
    } else if (rest.size() != before.kept.size()) {
      unresolved_ =
          finding(Part::vertex, i,
                  fmt::format("the simplex has {} vertices, but the iteration before kept "
                              "{} and added one",
                              step.simplex.size(), before.kept.size()));
      return false;
    }
    return true;
  }
  /// Up to the first iteration that does not fit.
  void resolve() {
    steps_.resize(iterations_.size());
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (resolve(i)) continue;
      steps_.resize(i);
      return;
    }
  }

  /// A simplex that comes a third time: from there on the run only repeats itself.
  void find_cycle() {
    std::map<std::vector<std::pair<int, int>>, std::vector<std::size_t>> seen;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      std::vector<std::pair<int, int>> key;
      for (const VertexPair& pair : steps_[i].kept.empty() ? steps_[i].simplex : steps_[i].kept)
        key.emplace_back(pair.x, pair.y);
      if (key.empty()) continue;
      std::sort(key.begin(), key.end());
      std::vector<std::size_t>& at = seen[key];
      at.push_back(i);
      if (at.size() == 3) {
        cycle_ = {at[0], at[1]};
        return;
      }
    }
  }

  // The steps.

  bool check(std::size_t i) {
    const Step& step = steps_[i];
    const Pairs& base = step.simplex.empty() ? step.kept : step.simplex;
    const Iteration& it = iterations_[i];
    if (it.closest && !it.closest->allFinite())
      return fail(Part::closest, i, fmt::format("P = {} is not finite", shown(*it.closest)));
    if (it.direction && !it.direction->allFinite())
      return fail(Part::direction, i, fmt::format("d = {} is not finite", shown(*it.direction)));
    if (static_cast<int>(std::max(base.size(), step.kept.size())) > log_.dimension + 1)
      return fail(
          Part::drop, i,
          fmt::format("the simplex has {} vertices, and in {} {} are enough: none was dropped",
                      base.size(), log_.dimension == 2 ? "the plane" : "space",
                      log_.dimension + 1));
    if (!base.empty()) {
      const std::vector<Vertex> all = vertices(base);
      const Nearest nearest = nearest_of(all);
      std::vector<Vertex> face;
      for (const int k : gjk::vertices_of(nearest.face)) face.push_back(all[k]);
      const double allowed = std::max(explained_on(face), explained(extent_of(all).longest));
      if (!check_drop(i, base, all, nearest) || !check_weights(i, base, all, nearest, allowed) ||
          !check_closest(i, base, all, nearest, allowed) || !check_direction(i, base))
        return false;
    }
    return check_support(i) && check_going_on(i);
  }

  bool check_drop(std::size_t i, const Pairs& base, const std::vector<Vertex>& all,
                  const Nearest& nearest) {
    const Pairs& kept = steps_[i].kept;
    if (kept.empty()) return true;
    const std::vector<Vertex> left = vertices(kept);
    const Nearest of_kept = nearest_of(left);
    const double allowed = explained_region(all);
    const double lost = of_kept.distance - nearest.distance;
    if (lost > allowed) {
      Pairs missing;
      std::string weights;
      for (const int k : gjk::vertices_of(nearest.face)) {
        const VertexPair& pair = base[k];
        if (holds(kept, pair)) continue;
        missing.push_back(pair);
        weights += (weights.empty() ? "" : " and ") + number(to_double(nearest.weights[k]));
      }
      return fail(
          Part::drop, i,
          fmt::format("{} {} dropped, but {} weight {} in P: O lies in {}. Without {} the "
                      "simplex is {} away from O, with {} {}",
                      names(missing), missing.size() == 1 ? "was" : "were",
                      missing.size() == 1 ? "has" : "have", weights, region(base, nearest.face),
                      missing.size() == 1 ? "it" : "them", number(of_kept.distance),
                      missing.size() == 1 ? "it" : "them", number(nearest.distance)),
          lost, allowed);
    }
    explain(Part::drop, i, lost, allowed);
    return check_extra(i, kept, left, of_kept);
  }
  /// A vertex without weight was kept. Loops take what they keep for the face of P, and P for the
  /// point closest to O of its line, plane or space: that point is as far off as O is beyond the
  /// face's border.
  bool check_extra(std::size_t i, const Pairs& kept, const std::vector<Vertex>& left,
                   const Nearest& of_kept) {
    const auto simplex = simplex_of(left);
    if (of_kept.face == simplex.all() || of_kept.distance <= explained(extent_of(left).longest))
      return true;
    Pairs extra;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      if (!gjk::contains(of_kept.face, static_cast<int>(k))) extra.push_back(kept[k]);
    }
    const gjk::Barycentric<Rational, 3> foot = gjk::barycentric(simplex, simplex.all());
    if (foot.denominator.sign() == 0) {
      if (!out_.waste)
        out_.waste =
            finding(Part::drop, i,
                    fmt::format("{} {} kept without weight, beside vertices that lie in one "
                                "line or plane with {}",
                                names(extra), extra.size() == 1 ? "is" : "are",
                                extra.size() == 1 ? "it" : "them"));
      return true;
    }
    Vertex at = Vertex::Zero();
    for (std::size_t k = 0; k < left.size(); ++k)
      at += Vertex(left[k] * (foot.numerator[k] / foot.denominator));
    const double off = length(difference(at, of_kept.p));
    const bool is_full = static_cast<int>(left.size()) == log_.dimension + 1;
    const double allowed = is_full ? explained_region(left) : explained_on(left);
    if (off > allowed)
      return fail(Part::drop, i,
                  fmt::format("{} {} kept without weight: O lies in {}, {} beside what is kept",
                              names(extra), extra.size() == 1 ? "is" : "are",
                              region(kept, of_kept.face), number(off)),
                  off, allowed);
    explain(Part::drop, i, off, allowed);
    return true;
  }

  bool check_weights(std::size_t i, const Pairs& base, const std::vector<Vertex>& all,
                     const Nearest& nearest, double allowed) {
    const Iteration& it = iterations_[i];
    if (it.weights.empty()) return true;
    const bool of_kept = std::max(it.kept.size(), it.kept_points.size()) > 0;
    const Pairs& of = of_kept ? steps_[i].kept : base;
    if (of.size() != it.weights.size()) return true;
    const std::vector<Vertex> corners = of_kept ? vertices(of) : all;
    const double on_corners = std::max(allowed, explained_on(corners));
    Rational sum;
    Vertex at = Vertex::Zero();
    double negative = 0;
    std::size_t worst = 0;
    for (std::size_t k = 0; k < of.size(); ++k) {
      if (!std::isfinite(it.weights[k]))
        return fail(Part::weights, i, fmt::format("the weight of {} is not finite", name(of[k])));
      sum += Rational(it.weights[k]);
      at += Vertex(corners[k] * Rational(it.weights[k]));
      if (it.weights[k] < negative) {
        negative = it.weights[k];
        worst = k;
      }
    }
    const double from_one = std::abs(to_double(sum - Rational(1)));
    const double of_sum = explained(static_cast<double>(of.size()));
    if (from_one > of_sum)
      return fail(Part::weights, i,
                  fmt::format("the weights add up to {} and not to 1", number(to_double(sum))),
                  from_one, of_sum);
    const double longest = extent_of(corners).longest;
    if (-negative * longest > on_corners)
      return fail(Part::weights, i,
                  fmt::format("the weight of {} is {}: O lies in {}", name(of[worst]),
                              number(negative), region(base, nearest.face)),
                  -negative * longest, on_corners);
    return check_place(Part::weights, i, base, all, nearest, at, on_corners, "the weighted sum");
  }

  bool check_closest(std::size_t i, const Pairs& base, const std::vector<Vertex>& all,
                     const Nearest& nearest, double allowed) {
    const Iteration& it = iterations_[i];
    if (!it.closest) return true;
    return check_place(Part::closest, i, base, all, nearest, exact(*it.closest), allowed, "P");
  }
  /// Whether a point lies on the simplex, and is no farther from O than the closest one.
  bool check_place(Part part, std::size_t i, const Pairs& base, const std::vector<Vertex>& all,
                   const Nearest& nearest, const Vertex& at, double allowed, const char* what) {
    const double off = length(difference(at, nearest.p));
    if (off <= allowed / 8) {  // too little to ask which way
      explain(part, i, off, allowed);
      return true;
    }
    const double excess = length(at) - nearest.distance;
    std::vector<Vertex> seen_from;
    for (const Vertex& v : all) seen_from.push_back(difference(v, at));
    const double beside = nearest_of(seen_from).distance;
    const std::string truth = fmt::format("the closest point is {}: O lies in {}", shown(nearest.p),
                                          region(base, nearest.face));
    if (beside > allowed)
      return fail(part, i,
                  fmt::format("{} = {} lies {} beside the simplex; {}", what, shown(at),
                              number(beside), truth),
                  beside, allowed);
    if (excess > allowed)
      return fail(part, i,
                  fmt::format("{} = {} is not the point closest to O: it is {} away, {} more than "
                              "needed; {}",
                              what, shown(at), number(length(at)), number(excess), truth),
                  excess, allowed);
    explain(part, i, std::max(beside, excess), allowed);
    return true;
  }

  [[nodiscard]] VertexPair farthest(const Vertex& d) const {
    return {x_.farthest(d, -1), y_.farthest(d, 1)};
  }

  bool check_direction(std::size_t i, const Pairs& base) {
    const Iteration& it = iterations_[i];
    if (!it.direction) return true;
    const std::vector<Vertex> corners = vertices(steps_[i].kept.empty() ? base : steps_[i].kept);
    const Nearest nearest = nearest_of(corners);
    const Extent extent = extent_of(corners);
    const Vertex d = exact(*it.direction);
    const Vertex to_origin = -nearest.p;
    const bool is_last = i + 1 == iterations_.size();
    if (gjk::is_zero(d)) {
      if (nearest.distance > explained(extent.longest))
        return fail(Part::direction, i,
                    fmt::format("d = 0, though P = {} is not O", shown(nearest.p)));
      if (!is_last)
        return fail(
            Part::direction, i,
            "d = 0: O lies on the simplex, so the distance is 0 and the run is over; along 0 "
            "no support point means anything");
      return true;
    }
    if (nearest.distance <= explained(extent.longest)) return true;
    const double beside = length(gjk::cross(d, to_origin));
    const double ahead = to_double(gjk::dot(d, to_origin));
    const double angle = std::atan2(beside, ahead);
    const double allowed = explained(extent.longest) * (1 / nearest.distance + 1 / extent.height);
    if (angle <= allowed) {
      explain(Part::direction, i, angle, allowed);
      return true;
    }
    const VertexPair wanted = farthest(to_origin);
    const VertexPair found = farthest(d);
    const double short_of =
        to_double(gjk::dot(to_origin, difference(vertex(wanted), vertex(found)))) /
        nearest.distance;
    const std::string effect =
        short_of <= 0
            ? fmt::format("the support point is {} all the same", name(found))
            : fmt::format(
                  "the support point becomes {} instead of {}, which lies {} farther towards O",
                  name(found), name(wanted), number(short_of));
    if (ahead <= 0)
      return fail(Part::direction, i,
                  fmt::format("d = {} does not lead from P = {} to O: dot(d, O - P) is {}; {}",
                              shown(*it.direction), shown(nearest.p), number(ahead), effect));
    constexpr double kDegrees = 57.29577951308232;
    return fail(
        Part::direction, i,
        fmt::format("d = {} is {} degrees beside the way from P = {} to O; {}",
                    shown(*it.direction), number(angle * kDegrees), shown(nearest.p), effect),
        angle, allowed);
  }

  bool check_support(std::size_t i) {
    const Iteration& it = iterations_[i];
    const std::optional<VertexPair>& support = steps_[i].support;
    if (!support || !it.direction) return true;
    const Vertex d = exact(*it.direction);
    if (gjk::is_zero(d)) return true;
    const VertexPair best = farthest(d);
    const double size = length(d);
    const double short_of =
        to_double(gjk::dot(d, difference(vertex(best), vertex(*support)))) / size;
    const double allowed = explained(x_.longest + y_.longest);
    if (short_of <= allowed) {
      explain(Part::support, i, short_of, allowed);
      return true;
    }
    std::string what = fmt::format(
        "the support point {} is not the farthest along d = {}: {} lies {} "
        "farther",
        name(*support), shown(*it.direction), name(best), number(short_of));
    const VertexPair least = farthest(Vertex(-d));
    if (gjk::dot(d, difference(vertex(*support), vertex(least))).sign() == 0)
      what += "; it is the least far of all";
    for (const bool of_x : {true, false}) {
      const bool differs = of_x ? support->x != best.x : support->y != best.y;
      if (log_.dimension == 2 && differs && turns_both_ways(of_x ? log_.x : log_.y))
        what += fmt::format("; {} is not convex, and its hull counts", shape_name(of_x));
    }
    return fail(Part::support, i, what, short_of, allowed);
  }

  /// How much farther along d than the simplex Z reaches: nothing where the log does not tell.
  [[nodiscard]] std::optional<Rational> gain(std::size_t i) const {
    const Iteration& it = iterations_[i];
    const Pairs& base = steps_[i].kept.empty() ? steps_[i].simplex : steps_[i].kept;
    if (base.empty() || !it.direction || !it.direction->allFinite()) return std::nullopt;
    const Vertex d = exact(*it.direction);
    if (gjk::is_zero(d)) return std::nullopt;
    Rational most = gjk::dot(d, vertex(base[0]));
    for (const VertexPair& pair : base) {
      Rational here = gjk::dot(d, vertex(pair));
      if (here > most) most = std::move(here);
    }
    return gjk::dot(d, vertex(farthest(d))) - most;
  }

  bool check_going_on(std::size_t i) {
    if (!cycle_) return true;
    const std::size_t count = iterations_.size();
    const std::optional<Rational> more = i == cycle_->first ? gain(i) : std::nullopt;
    if (more && more->sign() <= 0)
      return fail(
          Part::stop, i,
          fmt::format("no point of Z lies farther along d than the simplex{}: P is as near as "
                      "it gets, and the run should end here. It goes on to iteration {}, and "
                      "has the same simplex again in iteration {}",
                      steps_[i].support ? fmt::format(", not the support point {} either",
                                                      name(*steps_[i].support))
                                        : "",
                      count, cycle_->second + 1));
    if (i != cycle_->second) return true;  // the step that leads back may be wrong
    return fail(
        Part::stop, cycle_->first,
        fmt::format("a cycle: the simplex of this iteration comes again in iteration {}, and "
                    "the run goes on to iteration {}",
                    cycle_->second + 1, count));
  }

  // The end.

  /// The largest length that Z can have.
  [[nodiscard]] double size() const {
    Point most = Point::Zero();
    for (int k = 0; k < 3; ++k) {
      const auto by = [k](const Point& a, const Point& b) { return a[k] < b[k]; };
      const auto [x_low, x_high] = std::minmax_element(log_.x.begin(), log_.x.end(), by);
      const auto [y_low, y_high] = std::minmax_element(log_.y.begin(), log_.y.end(), by);
      most[k] = std::max((*y_high)[k] - (*x_low)[k], (*x_high)[k] - (*y_low)[k]);
    }
    return most.stableNorm();
  }

  /// The distance that the last direction proves, at least.
  [[nodiscard]] std::optional<double> lower_bound() const {
    if (iterations_.empty() || steps_.size() < iterations_.size()) return std::nullopt;
    const std::optional<Point>& last = iterations_.back().direction;
    if (!last || !last->allFinite() || last->isZero(0)) return std::nullopt;
    const Vertex d = exact(*last);
    return std::max(0.0, -to_double(gjk::dot(d, vertex(farthest(d)))) / length(d));
  }

  void check_answer() {
    if (!log_.answer) return;
    const Answer& answer = *log_.answer;
    const auto wrong = [&](std::string what) {
      if (!out_.answer) out_.answer = Finding{Part::answer, 0, answer.line, std::move(what)};
    };
    const double allowed = explained(size()) + log_.tolerance * out_.distance;
    const std::string truth = out_.overlap ? "the shapes meet, and their distance is 0"
                                           : "the distance is " + number(out_.distance);
    if (answer.distance) {
      const double error = std::abs(*answer.distance - out_.distance);
      if (!(error <= allowed)) {
        std::string what =
            std::isfinite(*answer.distance)
                ? fmt::format("the distance {} is wrong by {}: {}", number(*answer.distance),
                              number(error), truth)
                : fmt::format("the distance is {}: {}", number(*answer.distance), truth);
        const std::optional<double> lower = lower_bound();
        if (*answer.distance > 0 && lower && std::abs(*answer.distance - *lower) <= allowed)
          what += "; it is only the lower bound that the last direction proves";
        if (size() < std::sqrt(smallest() / unit_))
          what += "; products of lengths so small underflow";
        wrong(what);
      }
    }
    if (answer.overlap && *answer.overlap && out_.distance > allowed)
      wrong(fmt::format("the shapes are said to overlap, but they are apart: {}", truth));
    if (answer.overlap && !*answer.overlap && out_.overlap && !answer.distance && overlaps_deeply())
      wrong("the shapes are said to be apart, but they overlap");
    if (answer.depth || answer.translation) check_depth(answer, wrong);
    if (out_.overlap || !answer.x || !answer.y) return;
    const double coordinates = explained(x_.longest + y_.longest) + log_.tolerance * out_.distance;
    for (const bool of_x : {true, false}) {
      const Point& p = of_x ? *answer.x : *answer.y;
      const char letter = of_x == log_.a_is_x ? 'a' : 'b';
      if (!p.allFinite())
        return wrong(fmt::format("the closest point {} of {} is not finite", shown(p), letter));
      const std::vector<Vertex> alone = {exact(p)};
      const gjk::Query<Rational, 3> query{{alone}, {of_x ? x_.vertices : y_.vertices}};
      const double beside = gjk::distance<Rational>(query).distance;
      if (beside > coordinates)
        return wrong(fmt::format("the closest point {} of {} lies {} beside it", shown(p), letter,
                                 number(beside)));
    }
    const double apart = length(difference(exact(*answer.y), exact(*answer.x)));
    if (std::abs(apart - out_.distance) > coordinates)
      wrong(fmt::format("the closest points {} and {} are {} apart: {}",
                        shown(log_.a_is_x ? *answer.x : *answer.y),
                        shown(log_.a_is_x ? *answer.y : *answer.x), number(apart), truth));
  }
  /// `ask(query)` about the points without the coordinates that the log's dimension has not.
  template <class S, class Ask>
  [[nodiscard]] auto in_dimension(const std::vector<gjk::Vec<S, 3>>& all_x,
                                  const std::vector<gjk::Vec<S, 3>>& all_y, const Ask& ask) const {
    const auto asked = [&]<int D>(std::integral_constant<int, D>) {
      std::vector<gjk::Vec<S, D>> x;
      std::vector<gjk::Vec<S, D>> y;
      for (const auto& v : all_x) x.push_back(v.template head<D>());
      for (const auto& v : all_y) y.push_back(v.template head<D>());
      return ask(gjk::Query<S, D>{{x}, {y}});
    };
    return log_.dimension == 2 ? asked(std::integral_constant<int, 2>())
                               : asked(std::integral_constant<int, 3>());
  }
  /// How deep the shapes lie in each other, and bounds of it that are a few units of rounding
  /// apart; NaNs where they are apart, or their numbers are too small or too large.
  struct Depth {
    double value = 0;
    double lower = 0;
    double upper = 0;
  };
  /// The same when x has moved by t.
  [[nodiscard]] Depth depth_after(const Point& t) const {
    return in_dimension<double>(log_.x, log_.y, [&](auto query) {
      auto& translation = query.x.pose.translation;
      for (int i = 0; i < translation.size(); ++i) translation[i] = t[i];
      const auto found = depth::penetration<double>(query);
      return Depth{found.depth, found.lower, found.upper};
    });
  }
  /// `wrong(what)` notes a fault.
  template <class Wrong>
  void check_depth(const Answer& answer, const Wrong& wrong) {
    const Depth exact_depth = out_.overlap ? depth_after(Point::Zero()) : Depth{};
    if (std::isnan(exact_depth.value)) return;
    out_.depth = exact_depth.value;
    const double allowed = explained(size()) + log_.tolerance * exact_depth.upper;
    const auto fits = [&](double depth) {
      return exact_depth.lower - allowed <= depth && depth <= exact_depth.upper + allowed;
    };
    const std::string truth = out_.overlap ? "the depth is " + number(exact_depth.value)
                                           : "the shapes are apart, and have no depth";
    // Some loops answer a distance with the other sign.
    const bool is_distance = !out_.overlap && answer.depth && *answer.depth <= 0;
    if (answer.depth && !is_distance && !fits(*answer.depth)) {
      std::string what =
          std::isfinite(*answer.depth)
              ? fmt::format("the depth {} is wrong by {}: {}", number(*answer.depth),
                            number(std::abs(*answer.depth - exact_depth.value)), truth)
              : fmt::format("the depth is {}: {}", number(*answer.depth), truth);
      if (fits(-*answer.depth)) what += "; a depth is not negative";
      wrong(what);
    }
    if (!answer.translation || !out_.overlap) return;
    const Point& t = *answer.translation;
    const std::string shown_t = shown(log_.a_is_x ? t : Point(-t));
    if (!t.allFinite()) return wrong(fmt::format("the translation {} is not finite", shown_t));
    const double size_of_t = length(exact(t));
    if (!fits(size_of_t))
      return wrong(
          fmt::format("the translation {} is {} long: {}", shown_t, number(size_of_t), truth));
    const Depth rest = depth_after(t);
    if (rest.lower > allowed)
      wrong(fmt::format("after the translation {} the shapes still lie {} deep in each other: {}",
                        shown_t, number(rest.value), truth));
  }

  /// Not by rounding alone: a verdict that is as deep as that.
  [[nodiscard]] bool overlaps_deeply() const {
    return in_dimension<Rational>(x_.vertices, y_.vertices, [](const auto& query) {
      return gjk::distance<Rational>(query).verdict == gjk::Verdict::overlapping;
    });
  }

  /// Checks for a run whose steps are all right, but that ends before P is the answer.
  void check_early_stop() {
    if (steps_.empty()) return;
    const std::size_t last = steps_.size() - 1;
    const Pairs& base = steps_[last].kept.empty() ? steps_[last].simplex : steps_[last].kept;
    if (base.empty()) return;
    const double reached = nearest_of(vertices(base)).distance;
    const double excess = reached - out_.distance;
    const double allowed = explained(size()) + log_.tolerance * out_.distance;
    if (excess <= allowed) return;
    std::string what = fmt::format("the run stops too early: P is {} away from O, the shapes {}",
                                   number(reached), number(out_.distance));
    if (const std::optional<double> lower = lower_bound())
      what += fmt::format("; all that is proved is that the distance lies between {} and {}",
                          number(*lower), number(reached));
    fail(Part::stop, last, what, excess, allowed);
  }

  /// Iterations after P was the answer exactly; one is needed to see that it is.
  void check_late_stop() {
    for (std::size_t i = 0; i + 1 < steps_.size(); ++i) {
      const Pairs& base = steps_[i].kept.empty() ? steps_[i].simplex : steps_[i].kept;
      if (base.empty()) continue;
      const Vertex p = nearest_of(vertices(base)).p;
      if (gjk::dot(p, p) > distance_sq_) continue;
      const std::size_t more = steps_.size() - 1 - i;
      out_.waste = finding(Part::stop, i,
                           fmt::format("P is the answer already; {} {} without a gain", more,
                                       more == 1 ? "iteration follows" : "iterations follow"));
      return;
    }
  }

  const Log& log_;
  Body x_;
  Body y_;
  const std::vector<Iteration>& iterations_;
  double unit_;
  Rational distance_sq_;
  std::vector<Step> steps_;  ///< Up to the first that does not fit.
  std::optional<Finding> unresolved_;
  std::optional<std::pair<std::size_t, std::size_t>> cycle_;  ///< A simplex, and where it is again.
  std::map<std::array<double, 3>, VertexPair> known_;
  Judgement out_;
};

}  // namespace

Judgement judge(const Log& log) { return Judge(log).run(); }

}  // namespace gjkscope::judging
