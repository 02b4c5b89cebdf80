// Cases that users of other libraries reported, and regression data: tests/hard-cases. Those in
// space wait for the third dimension.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "claim.hpp"
#include "lesson/case.hpp"
#include "oracle.hpp"

namespace truth {
namespace {

using Eigen::Vector2d;
using gjk::Verdict;
using gjkscope::Rational;
using gjkscope::RationalPoint;
using nlohmann::json;

struct HardCase {
  json told;
  gjkscope::Case shapes;
  [[nodiscard]] gjk::Query<double, 2> query() const { return {{shapes.a}, {shapes.b}}; }
};

json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  return json::parse(file);
}

std::vector<HardCase> cases_in_the_plane() {
  std::vector<HardCase> out;
  for (const auto& entry :
       std::filesystem::directory_iterator(GJKSCOPE_SOURCE_DIR "/tests/hard-cases")) {
    HardCase hard{read_json(entry.path()), {}};
    if (hard.told["dimension"] != 2) continue;
    const auto read = gjkscope::parse_cases(hard.told.dump(), entry.path().string());
    EXPECT_TRUE(read.size() == 1 && read[0].value) << entry.path();
    hard.shapes = read[0].value.value();
    out.push_back(std::move(hard));
  }
  return out;
}

Rational distance_sq_of(const json& told) {
  return Rational(told["expected_distance_squared_exact"].get<std::string>());
}

std::vector<RationalPoint> rational(const std::vector<Vector2d>& points) {
  std::vector<RationalPoint> out;
  for (const Vector2d& p : points) out.push_back(gjkscope::rational(p[0], p[1]));
  return out;
}

TEST(HardCases, AreAllThere) {
  int plane = 0;
  int space = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(GJKSCOPE_SOURCE_DIR "/tests/hard-cases")) {
    const json told = read_json(entry.path());
    EXPECT_FALSE(told["source"].get<std::string>().empty());
    ++(told["dimension"] == 2 ? plane : space);
  }
  EXPECT_EQ(19, plane);
  EXPECT_EQ(22, space);
}

TEST(HardCases, TheTruthIsWhatTheyTell) {
  for (const HardCase& hard : cases_in_the_plane()) {
    SCOPED_TRACE(hard.told["name"]);
    const gjkscope::ExactAnswer answer =
        gjkscope::exact_answer(rational(hard.shapes.a), rational(hard.shapes.b));
    EXPECT_EQ(distance_sq_of(hard.told), answer.distance_sq);
    EXPECT_EQ(hard.told["expected_overlap"], answer.overlap);
    EXPECT_EQ(hard.told.value("touching", false), answer.touching);
    const ExactPair exact(hard.query());
    const Truth truth = exact.truth({});
    EXPECT_EQ(answer.overlap, truth.overlap);
    EXPECT_EQ(answer.touching, truth.overlap && exact.touching());
    EXPECT_EQ(gjkscope::root_nearest(answer.distance_sq), static_cast<double>(truth.distance));
  }
}

TEST(HardCases, AreSolvedInDouble) {
  for (const HardCase& hard : cases_in_the_plane()) {
    SCOPED_TRACE(hard.told["name"]);
    const auto result = gjk::distance(hard.query());
    EXPECT_EQ(hard.told["expected_overlap"], result.verdict != Verdict::separated);
    const ExactPair exact(hard.query());
    const Judgement found = judge(exact, exact.truth({}), exact.scale(), claim_of(result));
    EXPECT_FALSE(found.refused || found.not_a_number || found.capped || found.undecided ||
                 found.wrong_verdict || found.broken_certificate);
    EXPECT_LE(found.distance_error, 4);
    EXPECT_LE(found.outside, 4);
    EXPECT_LE(found.apart, 4);
    EXPECT_LE(found.width, 16);
  }
}

TEST(HardCases, AreSolvedExactly) {
  for (const HardCase& hard : cases_in_the_plane()) {
    SCOPED_TRACE(hard.told["name"]);
    const auto x = rational(hard.shapes.a);
    const auto y = rational(hard.shapes.b);
    const auto result = gjk::distance(gjk::Query<Rational, 2>{{x}, {y}});
    EXPECT_EQ(distance_sq_of(hard.told), result.distance_sq);
    EXPECT_EQ(hard.told["expected_overlap"],
              result.verdict == Verdict::touching || result.verdict == Verdict::overlapping);
    EXPECT_TRUE(result.verdict != Verdict::touching || hard.told.value("touching", false));
    const RationalPoint difference = result.y - result.x;
    EXPECT_EQ(result.distance_sq, gjk::dot(difference, difference));
    EXPECT_TRUE(gjkscope::is_nearest_pair(x, y, result.x, result.y));
    for (const auto& [point, hull] : {std::pair(result.x, x), std::pair(result.y, y)}) {
      const std::vector<RationalPoint> alone = {point};
      EXPECT_TRUE(gjkscope::exact_answer(alone, hull).overlap);
    }
  }
}

}  // namespace
}  // namespace truth
