// The certificate: lower <= exact distance <= upper, and verdicts that are true, against exact
// integer arithmetic on grids. (tests/geometry does the same for any coordinates, in rationals.)

#include <cmath>
#include <numeric>

#include "check.hpp"
#include "gjk/gjk.hpp"
#include "study/families.hpp"

namespace bounds_test {
/// An exact scalar: fractions of numbers as small as those of a run on a small grid.
class Fraction {
 public:
  Fraction(std::int64_t numerator = 0, std::int64_t denominator = 1)  // NOLINT: as other numbers
      : numerator_(numerator), denominator_(denominator) {
    const std::int64_t common = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
    numerator_ /= common;
    denominator_ /= common;
  }
  [[nodiscard]] std::int64_t numerator() const { return numerator_; }
  [[nodiscard]] std::int64_t denominator() const { return denominator_; }
  explicit operator double() const {
    return static_cast<double>(numerator_) / static_cast<double>(denominator_);
  }

  friend Fraction operator+(const Fraction& a, const Fraction& b) {
    return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
            a.denominator_ * b.denominator_};
  }
  friend Fraction operator*(const Fraction& a, const Fraction& b) {
    return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
  }
  friend Fraction operator/(const Fraction& a, const Fraction& b) {
    return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
  }
  friend Fraction operator-(const Fraction& a) { return {-a.numerator_, a.denominator_}; }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return a + -b; }
  friend bool operator==(const Fraction&, const Fraction&) = default;
  friend auto operator<=>(const Fraction& a, const Fraction& b) {
    return a.numerator_ * b.denominator_ <=> b.numerator_ * a.denominator_;
  }

 private:
  std::int64_t numerator_;
  std::int64_t denominator_;
};
}  // namespace bounds_test

template <>
struct Eigen::NumTraits<bounds_test::Fraction> : Eigen::GenericNumTraits<bounds_test::Fraction> {
  using Real = bounds_test::Fraction;
  using NonInteger = bounds_test::Fraction;
  using Nested = bounds_test::Fraction;
  using Literal = bounds_test::Fraction;
  enum { IsInteger = 0, IsSigned = 1, RequireInitialization = 1 };
};

template <>
struct gjk::ScalarTraits<bounds_test::Fraction> {
  using Fraction = bounds_test::Fraction;
  using Real = double;
  static constexpr bool kExact = true;
  template <class From>
  [[nodiscard]] static Fraction from(const From& value) {
    return value;
  }
  [[nodiscard]] static bool is_finite(const Fraction&) { return true; }
  [[nodiscard]] static Real root(const Fraction& a) { return std::sqrt(static_cast<double>(a)); }
  [[nodiscard]] static Real root_below(const Fraction& a) { return root(a) * (1 - 0x1p-51); }
  [[nodiscard]] static Real root_above(const Fraction& a) { return root(a) * (1 + 0x1p-51); }
  [[nodiscard]] static Fraction scaled(const Fraction& a, int) { return a; }
  [[nodiscard]] static Real no_length() { return std::numeric_limits<double>::quiet_NaN(); }
};

namespace bounds_test {

using gjk::Vec;
using gjk::Verdict;
__extension__ typedef __int128 Int128;

struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
};
std::int64_t cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
std::int64_t dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

/// Squared distance as a fraction, and how the shapes stand.
struct Exact {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  Verdict verdict = Verdict::none;
};

/// O against the points of Z, by definition. O is outside when all points lie within less than half
/// a turn counter-clockwise of one of them; on the boundary when some line through O has all of
/// them on one side.
Exact exact_distance(const std::vector<Point>& z) {
  bool outside = false;
  bool boundary = true;
  for (const Point& a : z) boundary = boundary && a.x == 0 && a.y == 0;
  for (const Point& a : z) {
    if (a.x == 0 && a.y == 0) continue;
    bool all_ahead = true;
    bool all_left = true;
    for (const Point& b : z) {
      const std::int64_t side = cross(a, b);
      all_left = all_left && side >= 0;
      all_ahead = all_ahead && (side > 0 || (side == 0 && dot(a, b) > 0));
    }
    outside = outside || all_ahead;
    boundary = boundary || all_left;
  }
  Exact best;
  best.verdict = outside ? Verdict::separated : boundary ? Verdict::touching : Verdict::overlapping;
  if (!outside) return best;
  best.numerator = -1;
  const auto offer = [&](std::int64_t numerator, std::int64_t denominator) {
    if (best.numerator < 0 ||
        Int128(numerator) * best.denominator < Int128(best.numerator) * denominator) {
      best.numerator = numerator;
      best.denominator = denominator;
    }
  };
  for (std::size_t i = 0; i < z.size(); ++i) {
    offer(dot(z[i], z[i]), 1);
    for (std::size_t j = 0; j < i; ++j) {
      const Point edge{z[j].x - z[i].x, z[j].y - z[i].y};
      const bool foot_inside = -dot(z[i], edge) > 0 && dot(z[j], edge) > 0;
      if (foot_inside) offer(cross(z[i], z[j]) * cross(z[i], z[j]), dot(edge, edge));
    }
  }
  return best;
}

/// The sign of bound^2 - numerator / denominator, exactly: a double is m 2^e with m below 2^53, and
/// on grids as small as these both sides stay below 2^127 once they are of equal magnitude.
int compare_square(double bound, const Exact& exact) {
  if (exact.numerator == 0) return bound > 0 ? 1 : 0;
  const double about =
      static_cast<double>(exact.numerator) / static_cast<double>(exact.denominator);
  if (bound * bound < about / 2) return -1;
  if (bound * bound > about * 2) return 1;
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(bound, &exponent), 53));
  exponent -= 53;
  Int128 left = Int128(mantissa) * mantissa;
  left *= exact.denominator;
  const Int128 right = Int128(exact.numerator) << (-2 * exponent);
  return left < right ? -1 : left > right ? 1 : 0;
}

template <class S>
Point difference(const Vec<S, 2>& x, const Vec<S, 2>& y) {
  return {std::int64_t(y[0]) - std::int64_t(x[0]), std::int64_t(y[1]) - std::int64_t(x[1])};
}

using Counts = std::array<long, 5>;

/// Quarter turns and steps of the grid.
template <class S>
gjk::Pose<S, 2> grid_pose(families::Source& random, int size) {
  gjk::Pose<S, 2> pose;
  const auto cosine = static_cast<S>(random.among(-1, 1));
  const auto sine = cosine == S(0) ? static_cast<S>(2 * random.among(0, 1) - 1) : S(0);
  pose.rotation = Eigen::Matrix<S, 2, 2>{{cosine, -sine}, {sine, cosine}};
  const auto step = [&] { return static_cast<S>(random.among(-size, size)); };
  pose.translation = Vec<S, 2>(step(), step());
  return pose;
}

/// Grid polygons of different densities, each in double and float, with both direction rules.
template <class S>
void check_grid(int size, int pairs, std::uint64_t seed, const gjk::Options& options,
                Counts& counts, bool posed = false) {
  families::Source random(seed);
  for (int i = 0; i < pairs; ++i) {
    std::vector<Vec<S, 2>> x = random.grid_points<S>(random.among(1, 5), size);
    std::vector<Vec<S, 2>> y = random.grid_points<S>(random.among(1, 5), size);
    const int shift = random.among(0, 2 * size);
    for (Vec<S, 2>& vertex : y) vertex[0] += static_cast<S>(shift);
    gjk::Query<S, 2> query{{x}, {y}};
    if (posed) {
      query.x.pose = grid_pose<S>(random, size);
      query.y.pose = grid_pose<S>(random, size);
    }
    const auto world = [](const gjk::Shape<S, 2>& shape, const Vec<S, 2>& vertex) -> Vec<S, 2> {
      return shape.pose.rotated(vertex) + shape.pose.translation;
    };
    std::vector<Point> z;
    for (const Vec<S, 2>& a : x) {
      for (const Vec<S, 2>& b : y) z.push_back(difference(world(query.x, a), world(query.y, b)));
    }
    const Exact exact = exact_distance(z);
    const gjk::Result<S, 2> result = gjk::distance<S>(query, options);
    ++counts[static_cast<int>(exact.verdict)];
    const check::Context context("seed", seed, "grid", size, "pair", i, "bytes", sizeof(S));
    CHECK(compare_square(static_cast<double>(result.lower), exact) <= 0);
    CHECK(compare_square(static_cast<double>(result.upper), exact) >= 0);
    const double truth =
        std::sqrt(static_cast<double>(exact.numerator) / static_cast<double>(exact.denominator));
    const double u = static_cast<double>(gjk::ScalarTraits<S>::unit_roundoff());
    CHECK_NEAR(truth, static_cast<double>(result.distance), 32 * u * size);
    CHECK_EQ(exact.verdict, result.verdict);
  }
}

TEST(grid, "bounds enclose the exact distance on integer grids, and verdicts are exact") {
  Counts counts = {};
  constexpr std::uint64_t kSeed = 9;
  for (const int size : {2, 5, 20}) {
    gjk::Options options;
    options.start.count = 1;
    check_grid<double>(size, 20000, kSeed, options, counts);
    check_grid<float>(size, 20000, kSeed, options, counts);
    options.region_order = gjk::RegionOrder::edges_first;
    check_grid<float>(size, 5000, kSeed + 1, options, counts);
    options.start.count = 0;
    check_grid<double>(size, 5000, kSeed + 2, options, counts);
    check_grid<double>(size, 10000, kSeed + 3, options, counts, true);
    check_grid<float>(size, 10000, kSeed + 3, options, counts, true);
  }
  const auto exact = [&](Verdict verdict) { return counts[static_cast<int>(verdict)]; };
  std::printf("  separated %ld, touching %ld, overlapping %ld\n", exact(Verdict::separated),
              exact(Verdict::touching), exact(Verdict::overlapping));
  CHECK(exact(Verdict::separated) > 50000);
  CHECK(exact(Verdict::overlapping) > 20000);
  CHECK(exact(Verdict::touching) > 5000);
}

TEST(exact_scalars,
     "in exact arithmetic the distance is the exact one, and so are both bounds; a run cut short "
     "says no more than it proved") {
  constexpr std::uint64_t kSeed = 11;
  families::Source random(kSeed);
  Counts counts = {};
  Counts cut_short = {};
  for (int i = 0; i < 10000; ++i) {
    const check::Context context("seed", kSeed, "pair", i);
    const auto points = [&](int shift) {
      std::vector<Vec<Fraction, 2>> out;
      for (const Vec<float, 2>& p : random.grid_points<float>(random.among(1, 5), 4)) {
        out.emplace_back(std::int64_t(p[0]) + shift, std::int64_t(p[1]));
      }
      return out;
    };
    const std::vector<Vec<Fraction, 2>> x = points(0);
    const std::vector<Vec<Fraction, 2>> y = points(random.among(0, 8));
    std::vector<Point> z;
    for (const Vec<Fraction, 2>& a : x) {
      for (const Vec<Fraction, 2>& b : y) {
        z.push_back({(b - a)[0].numerator(), (b - a)[1].numerator()});
      }
    }
    const Exact exact = exact_distance(z);
    ++counts[static_cast<int>(exact.verdict)];
    const gjk::Query<Fraction, 2> query{{x}, {y}};
    const auto result = gjk::distance(query);
    const Fraction square(exact.numerator, exact.denominator);
    CHECK_EQ(exact.verdict, result.verdict);
    CHECK(square == result.distance_sq);
    CHECK(square ==
          gjk::dot(Vec<Fraction, 2>(result.y - result.x), Vec<Fraction, 2>(result.y - result.x)));
    using Traits = gjk::ScalarTraits<Fraction>;
    CHECK_EQ(Traits::root(square), result.distance);
    CHECK_EQ(Traits::root_below(square), result.lower);
    CHECK_EQ(Traits::root_above(square), result.upper);

    gjk::Options options;
    options.iteration_cap = 1;
    const auto cut = gjk::distance(query, options);
    ++cut_short[static_cast<int>(cut.verdict)];
    CHECK(cut.verdict == exact.verdict || cut.verdict == Verdict::undecided);
    CHECK(cut.lower <= result.upper);
    CHECK(result.lower <= cut.upper);
    CHECK_EQ(cut.verdict == Verdict::separated, cut.lower > 0);
  }
  CHECK(cut_short[static_cast<int>(Verdict::undecided)] > 500);
  CHECK(cut_short[static_cast<int>(Verdict::separated)] > 500);
  for (const Verdict verdict : {Verdict::separated, Verdict::touching, Verdict::overlapping}) {
    CHECK(counts[static_cast<int>(verdict)] > 500);
  }
}

TEST(cap, "bounds enclose the distance wherever the cap cuts the run short") {
  constexpr std::uint64_t kSeed = 10;
  families::Source random(kSeed);
  for (int cap = 1; cap <= 4; ++cap) {
    for (int i = 0; i < 4000; ++i) {
      const auto x = random.grid_points<double>(5, 20);
      auto y = random.grid_points<double>(5, 20);
      for (Vec<double, 2>& vertex : y) vertex[1] += 30;
      std::vector<Point> z;
      for (const Vec<double, 2>& a : x) {
        for (const Vec<double, 2>& b : y) z.push_back(difference(a, b));
      }
      gjk::Options options;
      options.iteration_cap = cap;
      const gjk::Result<double, 2> result = gjk::distance(gjk::Query<double, 2>{{x}, {y}}, options);
      const Exact exact = exact_distance(z);
      const check::Context context("seed", kSeed, "cap", cap, "pair", i);
      CHECK(compare_square(result.lower, exact) <= 0);
      CHECK(compare_square(result.upper, exact) >= 0);
    }
  }
}

TEST(width, "without a cap the bounds are as close as rounding allows") {
  constexpr std::uint64_t kSeed = 11;
  families::Source random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    const auto pair = random.pair<double>(families::Family::random);
    const auto result = gjk::distance(pair.query());
    if (result.verdict != Verdict::separated) continue;
    const check::Context context("seed", kSeed, "pair", i);
    CHECK_NEAR(result.lower, result.upper, 1e-13);
  }
}

TEST(identical, "identical shapes overlap, surely: the upper bound is 0") {
  const std::vector<Vec<double, 2>> square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto result = gjk::distance(gjk::Query<double, 2>{{square}, {square}});
  CHECK_EQ(0.0, result.distance);
  CHECK_EQ(0.0, result.lower);
  CHECK(result.upper < 1e-14);
  CHECK_EQ(Verdict::overlapping, result.verdict);
}

TEST(surely, "a deep overlap is certain: lower = upper = 0") {
  const std::vector<Vec<float, 2>> square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const std::vector<Vec<float, 2>> point = {{0.25f, 0.5f}};
  const auto result = gjk::distance(gjk::Query<float, 2>{{point}, {square}});
  CHECK_EQ(0.0f, result.lower);
  CHECK_EQ(0.0f, result.upper);
}

}  // namespace bounds_test
