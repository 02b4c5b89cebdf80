// No absolute length is hidden in the core: input times 2^k gives output times 2^k, bit for bit.

#include <cstring>

#include "check.hpp"
#include "study/families.hpp"

namespace scaling_test {

using families::Family;
using families::kFamilyNames;
using families::Pair;
using gjk::Vec;

constexpr std::uint64_t kSeed = 17;
constexpr int kApart = GJKSCOPE_POWERS_APART;  // powers of two that are tried

template <int D>
constexpr int kCount = D == 2 ? families::kFamilyCount : families::kSpaceFamilyCount;

template <class S>
S times_power(S value, int k) {
  return std::ldexp(value, k);
}
template <class S, int D>
Vec<S, D> times_power(Vec<S, D> v, int k) {
  for (S& coordinate : v) coordinate = std::ldexp(coordinate, k);
  return v;
}
template <class S, int D>
Pair<S, D> times_power(Pair<S, D> pair, int k) {
  for (auto* points : {&pair.x, &pair.y}) {
    for (Vec<S, D>& vertex : *points) vertex = times_power(vertex, k);
  }
  pair.x_pose.translation = times_power(pair.x_pose.translation, k);
  pair.y_pose.translation = times_power(pair.y_pose.translation, k);
  return pair;
}

/// True when no digit was rounded away.
template <class S, int D>
bool is_times_power(const Pair<S, D>& scaled, const Pair<S, D>& pair, int k) {
  const Pair<S, D> back = times_power(scaled, -k);
  return back.x == pair.x && back.y == pair.y &&
         back.x_pose.translation == pair.x_pose.translation &&
         back.y_pose.translation == pair.y_pose.translation;
}

/// Zero, or in the range where every digit counts and sums of a few do not overflow.
template <class S>
bool is_full(S value) {
  return value == 0 || (std::isnormal(value) && std::isfinite(8 * value));
}
template <class S, int D>
bool is_full(const Vec<S, D>& v) {
  return std::all_of(v.begin(), v.end(), [](S coordinate) { return is_full(coordinate); });
}
template <class S, int D>
bool is_full(const Pair<S, D>& pair) {
  const auto full = [](const Vec<S, D>& v) { return is_full(v); };
  return std::all_of(pair.x.begin(), pair.x.end(), full) &&
         std::all_of(pair.y.begin(), pair.y.end(), full) && full(pair.x_pose.translation) &&
         full(pair.y_pose.translation);
}
template <class S, int D>
bool is_full(const gjk::Result<S, D>& a) {
  return is_full(a.distance) && is_full(a.lower) && is_full(a.upper) && is_full(a.x) &&
         is_full(a.y);
}

template <class S, int D>
gjk::Result<S, D> times_power(gjk::Result<S, D> result, int k) {
  result.distance = times_power(result.distance, k);
  result.lower = times_power(result.lower, k);
  result.upper = times_power(result.upper, k);
  result.x = times_power(result.x, k);
  result.y = times_power(result.y, k);
  return result;
}

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}
template <class S, int D>
bool same_bits(const gjk::Result<S, D>& a, const gjk::Result<S, D>& b) {
  return a.stop == b.stop && a.verdict == b.verdict && a.iterations == b.iterations &&
         same_bits(a.distance, b.distance) && same_bits(a.lower, b.lower) &&
         same_bits(a.upper, b.upper) && same_bits(a.x, b.x) && same_bits(a.y, b.y) &&
         same_bits(a.simplex.weights, b.simplex.weights);
}

/// Pairs of each family, queries in S and runs in R: how many powers of two were tried.
template <int D, class R, class S>
long check_bits(int pairs, int most, families::Representation representation) {
  long compared = 0;
  families::Source random(kSeed);
  for (int i = 0; i < pairs * kCount<D>; ++i) {
    const auto family = static_cast<Family>(i % kCount<D>);
    const auto pair = random.pair<S, D>(family, representation);
    const auto expected = families::run<R>(pair);
    if (!is_full(pair)) continue;
    for (int k = -most; k <= most; k += kApart) {
      const Pair<S, D> scaled = times_power(pair, k);
      const auto scaled_result = times_power(expected, k);
      if (!is_full(scaled) || !is_times_power(scaled, pair, k) || !is_full(scaled_result)) continue;
      const auto result = families::run<R>(scaled);
      ++compared;
      if (result.error == gjk::Error::none && same_bits(scaled_result, result)) continue;
      const check::Context context("seed", kSeed, "pair", i, kFamilyNames[i % kCount<D>], "k", k,
                                   "bytes", sizeof(S), sizeof(R));
      CHECK_EQ(gjk::Error::none, result.error);
      CHECK_EQ(scaled_result.distance, result.distance);
      CHECK_EQ(scaled_result.lower, result.lower);
      CHECK_EQ(scaled_result.upper, result.upper);
      check::fail(__FILE__, __LINE__, "not the same bits");
    }
  }
  return compared;
}

constexpr auto kFloatValues = families::Representation::float_values;
constexpr auto kFullDoubles = families::Representation::full_doubles;

TEST(float_bits, "float queries times 2^-60 ... 2^60 give 2^k times the answer, bit for bit") {
  CHECK(check_bits<2, float, float>(40, 60, kFloatValues) > 60000 / kApart);
  CHECK(check_bits<2, double, float>(40, 60, kFloatValues) > 60000 / kApart);
  CHECK(check_bits<3, float, float>(10, 60, kFloatValues) > 15000 / kApart);
  CHECK(check_bits<3, double, float>(10, 60, kFloatValues) > 15000 / kApart);
}

TEST(double_bits, "double queries times 2^-400 ... 2^400 give 2^k times the answer, bit for bit") {
  CHECK(check_bits<2, double, double>(20, 400, kFloatValues) > 200000 / kApart);
  CHECK(check_bits<2, double, double>(20, 400, kFullDoubles) > 200000 / kApart);
  CHECK(check_bits<3, double, double>(5, 400, kFloatValues) > 50000 / kApart);
  CHECK(check_bits<3, double, double>(5, 400, kFullDoubles) > 50000 / kApart);
}

struct Beyond {
  long answered = 0;
  long refused = 0;
};

/// Down to the smallest numbers and up to the largest: an answer that is right, or an error.
template <int D, class R, class S>
Beyond check_beyond(int pairs, int least, int most) {
  Beyond counts;
  families::Source random(kSeed);
  for (int i = 0; i < pairs * kCount<D>; ++i) {
    const auto family = static_cast<Family>(i % kCount<D>);
    const auto pair = random.pair<S, D>(family);
    const auto expected = families::run<R>(pair);
    if (expected.error != gjk::Error::none) continue;
    const double scale = families::scale_of(pair);
    for (int k = least; k <= most; k += 1 + random.among(0, 6 * kApart)) {
      const Pair<S, D> scaled = times_power(pair, k);
      if (!is_times_power(scaled, pair, k)) continue;
      const check::Context context("seed", kSeed, "pair", i, kFamilyNames[i % kCount<D>], "k", k,
                                   "bytes", sizeof(S), sizeof(R));
      const auto result = families::run<R>(scaled);
      if (result.error != gjk::Error::none) {
        ++counts.refused;
        continue;
      }
      ++counts.answered;
      CHECK_EQ(expected.verdict == gjk::Verdict::separated,
               result.verdict == gjk::Verdict::separated);
      // Both answers are rounded, at times to a multiple of the smallest number.
      const auto smallest = static_cast<double>(std::numeric_limits<R>::denorm_min());
      const double unit = std::max(
          static_cast<double>(gjk::ScalarTraits<R>::unit_roundoff()) * std::ldexp(scale, k),
          smallest * std::max(1.0, std::ldexp(1.0, k)));
      CHECK_NEAR(std::ldexp(static_cast<double>(expected.distance), k),
                 static_cast<double>(result.distance), 4 * unit);
      CHECK(result.lower <= times_power(expected.upper, k));
      CHECK(result.upper >= times_power(expected.lower, k));
    }
  }
  return counts;
}

template <int D, class R, class S>
void check_ends(int pairs, int least, int most) {
  const Beyond counts = check_beyond<D, R, S>(pairs, least, most);
  std::printf("  2^%d ... 2^%d: %ld answered, %ld refused\n", least, most, counts.answered,
              counts.refused);
  CHECK(counts.answered > 50000 / kApart);
}

TEST(beyond, "down to the smallest numbers, up to the largest, the answer is right or an error") {
  check_ends<2, float, float>(40, -149, 130);
  check_ends<2, double, float>(40, -149, 130);
  check_ends<2, double, double>(20, -1074, 1026);
  check_ends<3, float, float>(40, -149, 130);
  check_ends<3, double, double>(20, -1074, 1026);
}

}  // namespace scaling_test
