// Cases that users of other libraries reported, and regression data: tests/hard-cases. Each tells
// its exact distance, from elsewhere.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bars.hpp"
#include "exact_run.hpp"
#include "gjk/gjk.hpp"

namespace gjkscope::study {
namespace hard_cases_test {

using gjk::Verdict;
using nlohmann::json;

template <int D>
struct HardCase {
  std::string name;
  std::vector<gjk::Vec<double, D>> a;
  std::vector<gjk::Vec<double, D>> b;
  bool overlap = false;
  bool touching = false;
  Rational distance_sq;
  [[nodiscard]] gjk::Query<double, D> query() const { return {{a}, {b}}; }
  [[nodiscard]] HardCase swapped() const {
    HardCase out = *this;
    std::swap(out.a, out.b);
    return out;
  }
};

/// "81/25" or "9".
Rational fraction(const std::string& text) {
  const std::size_t slash = text.find('/');
  const Integer numerator(text.substr(0, slash));
  return slash == std::string::npos ? Rational(numerator)
                                    : Rational(numerator, Integer(text.substr(slash + 1)));
}

/// In both orders of arguments.
template <int D>
std::vector<HardCase<D>> cases() {
  std::vector<HardCase<D>> out;
  for (const auto& entry :
       std::filesystem::directory_iterator(GJKSCOPE_SOURCE_DIR "/tests/hard-cases")) {
    std::ifstream file(entry.path());
    const json document = json::parse(file);
    if (document.at("dimension") != D) continue;
    HardCase<D> one;
    one.name = document.at("name");
    const auto read = [](const json& points, auto& to) {
      for (const json& point : points) {
        for (int i = 0; i < D; ++i) {
          if (i == 0) to.emplace_back();
          to.back()[i] = point.at(static_cast<std::size_t>(i)).get<double>();
        }
      }
    };
    read(document.at("a"), one.a);
    read(document.at("b"), one.b);
    one.overlap = document.at("expected_overlap");
    one.touching =
        document.contains("touching") && document["touching"].is_boolean() && document["touching"];
    one.distance_sq = fraction(document.at("expected_distance_squared_exact"));
    out.push_back(one);
    out.push_back(one.swapped());
  }
  return out;
}

/// |value - distance|
template <int D>
double error_of(double value, const HardCase<D>& one) {
  const double distance = root_nearest(one.distance_sq);
  const Rational off = Rational(value) * Rational(value) - one.distance_sq;
  return one.overlap ? value : std::abs(to_double(off) / (value + distance));
}

template <int D>
double scale_of(const HardCase<D>& one) {
  double scale = 0;
  for (const auto& a : one.a) {
    for (const auto& b : one.b) scale = std::max(scale, (b - a).norm());
  }
  return scale;
}

template <int D>
void compare_truths() {
  for (const HardCase<D>& one : cases<D>()) {
    SCOPED_TRACE(one.name);
    const Truth truth = truth_of<D>({one.a, one.b});
    EXPECT_EQ(one.overlap, truth.overlap);
    EXPECT_EQ(one.touching, truth.touching);
    EXPECT_EQ(root_nearest(one.distance_sq), truth.distance);
  }
}
TEST(HardCases, TheTruthIsWhatTheyTell) {
  compare_truths<2>();
  compare_truths<3>();
}

TEST(HardCases, AreSolvedInDouble) {
  for (const HardCase<2>& one : cases<2>()) {
    SCOPED_TRACE(one.name);
    const Truth truth = truth_of<2>({one.a, one.b});
    const Judgement found = judge(claim_of(gjk::distance(one.query())), {truth, truth});
    EXPECT_STREQ("", broken_bar(found, errors_of(found, truth, unit_of<double>(truth)), kBars));
  }
}

template <int D>
void solve_exactly() {
  for (const HardCase<D>& one : cases<D>()) {
    SCOPED_TRACE(one.name);
    const ExactPair<D> pair{exact<double, D>(one.a), exact<double, D>(one.b)};
    const auto result = gjk::distance(pair.query());
    EXPECT_EQ(one.distance_sq, result.distance_sq);
    EXPECT_EQ(one.overlap, result.verdict != Verdict::separated);
    EXPECT_NE(Verdict::undecided, result.verdict);
    EXPECT_EQ(one.touching, result.verdict == Verdict::touching);
    expect_proved(pair, result);
  }
}
TEST(HardCases, AreSolvedExactly) {
  solve_exactly<2>();
  solve_exactly<3>();
}

/// True when lower <= distance <= upper.
bool holds(const gjk::Result<double, 3>& result, const Rational& distance_sq) {
  const Rational lower(result.lower);
  const Rational upper(result.upper);
  return lower >= 0 && lower * lower <= distance_sq && distance_sq <= upper * upper;
}

// In space no exact arithmetic runs on, so verdicts may be left open; a wrong one there must not
// be.
TEST(HardCases, AreAnsweredTrulyInSpace) {
  for (const HardCase<3>& one : cases<3>()) {
    SCOPED_TRACE(one.name);
    const auto result = gjk::distance(one.query());
    ASSERT_EQ(gjk::Error::none, result.error);
    EXPECT_NE(gjk::StopReason::iteration_cap, result.stop);
    EXPECT_TRUE(holds(result, one.distance_sq))
        << root_nearest(one.distance_sq) << " in [" << result.lower << ", " << result.upper << ']';
    EXPECT_NE(Verdict::undecided, result.verdict);
    EXPECT_EQ(one.overlap, result.verdict != Verdict::separated);
    EXPECT_LE(error_of(result.distance, one), kBars.distance * 0x1p-53 * scale_of(one));
    EXPECT_LE(result.upper - result.lower, kBars.width * 0x1p-53 * scale_of(one));
  }
}

// One triangle is a millionth of the other, and a sliver: its plane is no bound by itself.
TEST(HardCases, ASpeckInSpaceKeepsItsBounds) {
  HardCase<3> one;
  one.a = {{-0x1.5c4516bda2ccfp-2, 0x1.ecca194ee19f3p-1, 0x1.fdaef3a41bb2cp-1},
           {-0x1.5c452951ad53cp-2, 0x1.ecca0a92bac99p-1, 0x1.fdaef3cfa3493p-1},
           {-0x1.5c44eb3d918bfp-2, 0x1.ecca1a6d27ec2p-1, 0x1.fdaef71781077p-1}};
  one.b = {{-0x1.073db0806f228p-3, -0x1.cf57c0841ac9p-2, 0x1.cf7b1ec941ad4p-2},
           {-0x1.87c864998d748p-2, 0x1.98eff004bf2dep-1, -0x1.eea00c6e8c122p-1},
           {-0x1.3c91a8f22d734p-2, 0x1.e1af8c4f1fc8p-1, 0x1.9d6062bd56684p-1}};
  const ExactPair<3> pair{exact<double, 3>(one.a), exact<double, 3>(one.b)};
  const auto truth = gjk::distance(pair.query());
  expect_proved(pair, truth);
  const auto result = gjk::distance(one.query());
  EXPECT_TRUE(holds(result, truth.distance_sq));
  EXPECT_EQ(Verdict::separated, result.verdict);
}

}  // namespace hard_cases_test
}  // namespace gjkscope::study
