// How much of each bound of rounding is used at worst, over random pairs of every family: the error
// that a bound is for, computed in rationals, as a share of the bound. A share above 1 would be a
// broken bound; then the exit code is 1. `--write` puts the table into a document.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "bench/document.hpp"
#include "exact_run.hpp"
#include "study/families.hpp"

namespace gjkscope {
namespace {

constexpr double kU = 0x1p-53;

template <int D>
using Exact = gjk::Vec<Rational, D>;

template <int D>
double length(const Exact<D>& a) {
  double sum = 0.0;
  for (int i = 0; i < D; ++i) sum = std::hypot(sum, to_double(a[i]));
  return sum;
}
/// |computed| - sqrt(exact_sq), good however small it is.
double beyond_root(double computed, const Rational& exact_sq) {
  const double root = std::sqrt(to_double(exact_sq));
  if (computed + root == 0.0) return 0.0;
  return to_double(Rational(computed) * Rational(computed) - exact_sq) / (computed + root);
}

struct Share {
  const char* bound;
  const char* why_not_half;  ///< Why half of it is not seen broken, or that it is.
  double worst = 0.0;
  long measured = 0;

  void add(double error, double allowed) {
    if (!(allowed > 0.0)) return;
    ++measured;
    worst = std::max(worst, std::abs(error) / allowed);
  }
};

/// One row for each bound, in the order of the table.
template <int D>
struct Shares {
  Share vertex{"vertex_error + u abs(w)", "broken: the last sum of a vertex uses all of it"};
  Share scan{"scan_error_within",
             "two vertices must lie equally far, and both dot products err the other way"};
  Share plane{"plane_error", "a sum of vertex, scan and length, which are not worst together"};
  Share volume{"volume_error", "all vertices as long as the longest, and their roundings agree"};
  Share foot{"error of foot_of, own digits", "broken in both"};
  Share careful{"error of foot_of, double words", "broken in both"};
  Share inside{"error of weights times height",
               "broken in the plane; in space a triangle must be slanted, and all roundings agree"};
  Share weights{"weights_bound", "weights and vertices have errors of one sign"};
  Share root{"root_above, root_below", "2 of 8 roundings are those of IEEE types"};
  Share turn{"turn of a ring", "4 of 8 roundings are derived, and they do not all agree"};
  Share climb{"rounding of climb", "11 of 12 roundings are derived, and they do not all agree"};

  [[nodiscard]] std::vector<const Share*> all() const {
    return {&vertex, &scan,    &plane, &volume, &foot, &careful,
            &inside, &weights, &root,  &turn,   &climb};
  }
};

/// A pair and its run.
template <int D>
struct Run {
  families::Pair<double, D> pair;
  gjk::Query<double, D> query = pair.query();
  gjk::Trace<double, D> trace = gjk::trace(query);
  ExactPair<D> in_rationals = exact(pair);
  RationalPoints<D> x = world(in_rationals.x, in_rationals.x_pose);
  RationalPoints<D> y = world(in_rationals.y, in_rationals.y_pose);

  explicit Run(families::Pair<double, D> given) : pair(std::move(given)) {}
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  [[nodiscard]] Exact<D> z(gjk::VertexPair at) const { return y[at.y] - x[at.x]; }
};

template <int D>
void measure_supports(const Run<D>& run, Shares<D>& shares) {
  const gjk::Prepared<double, D>& prepared = run.trace.prepared;
  for (const gjk::Step<double, D>& step : run.trace.steps) {
    if (step.phase != gjk::Phase::support) continue;
    const gjk::State<double, D>& state = step.after;
    const Exact<D> w = run.z(state.support.pair);
    const double size = gjk::length(state.support.w);
    shares.vertex.add(length<D>(exact<double, D>(state.support.w) - w),
                      prepared.vertex_error + kU * size);
    const Exact<D> d = exact<double, D>(state.d);
    const Rational d_sq = gjk::dot(d, d);
    const auto farthest = [&](const RationalPoints<D>& points, const Exact<D>& along) {
      Rational most = gjk::dot(along, points[0]);
      for (const Exact<D>& point : points) most = std::max(most, Rational(gjk::dot(along, point)));
      return most;
    };
    const Rational support = farthest(run.y, d) + farthest(run.x, Exact<D>(-d));
    const double d_length = std::sqrt(to_double(d_sq));
    shares.scan.add(to_double(support - gjk::dot(d, w)) / d_length,
                    prepared.scan_error_within(0.0));
    if (!(state.support_value < 0.0)) continue;
    const double distance =
        std::sqrt(state.support_value * (state.support_value / gjk::dot(state.d, state.d)));
    const double beyond = support < Rational(0)
                              ? beyond_root(distance, Rational(support * support / d_sq))
                              : distance + to_double(support) / d_length;
    shares.plane.add(std::max(beyond, 0.0), prepared.plane_error(distance, size));
  }
}

/// The simplex with exact vertices.
template <int D>
gjk::Simplex<Rational, D> in_rationals(const Run<D>& run, const gjk::Simplex<double, D>& simplex) {
  gjk::Simplex<Rational, D> out;
  out.count = simplex.count;
  for (int i = 0; i < simplex.count; ++i) {
    out.vertices[i] = {run.z(simplex.vertices[i].pair), simplex.vertices[i].pair};
    out.weights[i] = Rational(simplex.weights[i]);
  }
  return out;
}

template <int D>
void measure_simplices(const Run<D>& run, Shares<D>& shares) {
  const gjk::Prepared<double, D>& prepared = run.trace.prepared;
  for (const gjk::Step<double, D>& step : run.trace.steps) {
    if (step.phase != gjk::Phase::drop) continue;
    const gjk::Simplex<double, D>& simplex = step.after.simplex;
    const gjk::Simplex<Rational, D> truth = in_rationals(run, simplex);
    Exact<D> point = Exact<D>::Zero();
    Rational sum(0);
    for (int i = 0; i < simplex.count; ++i) {
      point += truth.vertices[i].w * truth.weights[i];
      sum += truth.weights[i];
    }
    const double p =
        gjk::length(gjk::weighted_point(simplex, simplex.all(), simplex.weights)) /
        std::accumulate(simplex.weights.begin(), simplex.weights.begin() + simplex.count, 0.0);
    shares.weights.add(beyond_root(p, Rational(gjk::dot(point, point) / (sum * sum))),
                       gjk::weights_bound<double, D>(simplex, prepared) - p);
    if (simplex.count != D + 1) continue;
    const gjk::Barycentric<double, D> found = gjk::volume_coordinates(simplex);
    const gjk::Barycentric<Rational, D> expected = gjk::volume_coordinates(truth);
    if (found.denominator == 0.0 || expected.denominator == Rational(0)) continue;
    const double allowed = gjk::volume_error(gjk::largest_coordinate(simplex), prepared);
    for (int i = 0; i <= D; ++i)
      shares.volume.add(to_double(Rational(found.numerator[i]) - expected.numerator[i]), allowed);
  }
}

/// The squared distance of O from the line or plane through a face.
template <int D>
Rational distance_sq(const gjk::Simplex<Rational, D>& face) {
  if (face.count == 1) return gjk::dot(face.vertices[0].w, face.vertices[0].w);
  return gjk::distance_sq(face, face.all());
}

template <int D>
void measure_feet(const Run<D>& run, Shares<D>& shares) {
  const gjk::State<double, D>& end = run.trace.steps.back().after;
  gjk::Simplex<double, D> face = end.evidence.best;
  if (face.count == 0 || face.count == D + 1) return;
  const gjk::Simplex<Rational, D> truth = in_rationals(run, face);
  const gjk::Barycentric<Rational, D> coordinates = gjk::barycentric(truth, truth.all());
  if (coordinates.denominator == Rational(0)) return;
  const Rational exact_sq = distance_sq(truth);
  gjk::OutsideBounds<double, double, D> bounds(end, run.query, run.trace.prepared, face);
  bounds.measure();
  if (bounds.is_inside) {
    shares.foot.add(beyond_root(bounds.foot.distance, exact_sq), bounds.error);
    for (int i = 0; face.count > 1 && i < face.count; ++i) {
      const Rational weight = coordinates.numerator[i] / coordinates.denominator;
      shares.inside.add(to_double(Rational(face.weights[i]) - weight) * bounds.foot.height,
                        bounds.beyond);
    }
  }
  bounds.measure_anew();
  if (bounds.foot.height > 0.0)
    shares.careful.add(beyond_root(bounds.foot.distance, exact_sq), bounds.error);
  using Traits = gjk::ScalarTraits<double>;
  const double p_sq = end.evidence.best_sq;
  shares.root.add(beyond_root(Traits::root(p_sq), Rational(p_sq)),
                  Traits::root_above(p_sq) - Traits::root(p_sq));
}

/// Turns of the polygons, as is_strictly_convex_ring asks for them.
void measure_turns(const Run<2>& run, Shares<2>& shares) {
  for (const auto* points : {&run.pair.x, &run.pair.y}) {
    const std::size_t count = points->size();
    for (std::size_t i = 0; count > 2 && i < count; ++i) {
      const auto corner = [&](std::size_t k) { return (*points)[(i + k) % count]; };
      const gjk::Vec<double, 2> before = corner(1) - corner(0);
      const gjk::Vec<double, 2> edge = corner(2) - corner(1);
      const double left = before[0] * edge[1];
      const double right = before[1] * edge[0];
      const Exact<2> a = exact<double, 2>(corner(1)) - exact<double, 2>(corner(0));
      const Exact<2> b = exact<double, 2>(corner(2)) - exact<double, 2>(corner(1));
      shares.turn.add(to_double(Rational(left - right) - gjk::cross(a, b)),
                      8 * kU * (std::abs(left) + std::abs(right)));
    }
  }
}

/// Differences of two values of a scan of a turned ring.
void measure_climbs(families::Source& random, Shares<2>& shares) {
  std::vector<gjk::Vec<double, 2>> ring;
  constexpr int kCount = 40;
  for (int i = 0; i < kCount; ++i) {
    const double angle = 6.283185307179586 * (i + 0.3 * random.between(0.0, 1.0)) / kCount;
    ring.emplace_back(30 + std::cos(angle), 10 + std::sin(angle));
  }
  const double turn = random.between(0.0, 6.0);
  const gjk::Pose<double, 2> pose{Eigen::Rotation2Dd(turn).toRotationMatrix(), {1, 2}};
  const std::vector<gjk::Vec<double, 2>> point = {{0, 0}};
  const gjk::Query<double, 2> query{{point}, {ring, pose}};
  const gjk::Prepared<double, 2> prepared = gjk::prepare<double>(query, {});
  if (!prepared.y.is_ring) return;
  const gjk::Vec<double, 2> d(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
  const gjk::Along<double, double, 2> along(d, query.y, prepared, prepared.y);
  const auto turned = [&](int i) {
    return gjk::dot(exact<double, 2>(d), exact(pose).rotated(exact<double, 2>(ring[i])));
  };
  for (int i = 1; i < kCount; ++i) {
    shares.climb.add(
        to_double(Rational(along(i)) - Rational(along(i - 1)) - (turned(i) - turned(i - 1))),
        along.rounding());
  }
}

template <int D>
Shares<D> measured(long pairs, std::uint64_t seed) {
  families::Source random(seed);
  Shares<D> shares;
  constexpr int kFamilies = D == 2 ? families::kFamilyCount : families::kSpaceFamilyCount;
  for (long i = 0; i < pairs; ++i) {
    const Run<D> run(random.pair<double, D>(static_cast<families::Family>(i % kFamilies)));
    if (run.trace.result.error != gjk::Error::none || run.trace.prepared.exponent != 0) continue;
    measure_supports(run, shares);
    measure_simplices(run, shares);
    measure_feet(run, shares);
    if constexpr (D == 2) {
      measure_turns(run, shares);
      if (i % kFamilies == 0) measure_climbs(random, shares);
    }
  }
  return shares;
}

int report(long pairs, std::uint64_t seed, const std::string& document) {
  const Shares<2> plane = measured<2>(pairs, seed);
  const Shares<3> space = measured<3>(pairs, seed);
  std::string text = fmt::format(
      "\nMade by `bound-shares --pairs {} --seed {} --write docs/numerics.md`: the largest error "
      "that was seen, as a share of its bound.\n\n| bound | in the plane | in space | half of it "
      "|\n| --- | --- | --- | --- |\n",
      pairs, seed);
  const auto cell = [](const Share& share) {
    return share.measured == 0 ? std::string("-") : fmt::format("{:.3f}", share.worst);
  };
  bool broken = false;
  for (std::size_t i = 0; i < plane.all().size(); ++i) {
    const Share& flat = *plane.all()[i];
    const Share& spatial = *space.all()[i];
    text += fmt::format("| {} | {} | {} | {} |\n", flat.bound, cell(flat), cell(spatial),
                        flat.why_not_half);
    broken = broken || flat.worst > 1.0 || spatial.worst > 1.0;
  }
  text += "\n";
  fmt::print("{}", text);
  if (!document.empty()) bench::write_section(document, "bound-shares", text);
  return broken ? 1 : 0;
}

}  // namespace
}  // namespace gjkscope

int main(int argc, char** argv) {
  CLI::App app("Reports how much of each bound of rounding is used at worst");
  long pairs = 2000;
  std::uint64_t seed = 1;
  std::string document;
  app.add_option("--pairs", pairs, "pairs over all families, in each dimension")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "seed");
  app.add_option("--write", document, "document whose marked section gets the table");
  CLI11_PARSE(app, argc, argv);
  try {
    return gjkscope::report(pairs, seed, document);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "bound-shares: {}\n", problem.what());
    return 1;
  }
}
