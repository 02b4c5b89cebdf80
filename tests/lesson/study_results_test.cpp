#include "lesson/study_results.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace gjkscope {
namespace {

std::string row(const std::string& family, const std::string& configuration, double ns,
                const std::string& error, bool front, int repetitions = 5) {
  return fmt::format(
      R"({{"family": "{}", "configuration": "{}", "axis": "cap", "proof": "exact", "front": {}, "pairs": 7,
          "repetitions": {}, "ns": {}, "ratio": 0.5, "undecided": 2, "wrong": 1, "settled": 3, "error": {},
          "worst": {{"answer": null, "distance": 2.0,
                     "case": {{"dimension": 2, "a": [[0, 0]], "b": [[2, 0], [3, 1]]}}}}}})",
      family, configuration, front, repetitions, ns, error);
}

std::string results(const std::string& rows) {
  return R"({"machine": {"processor": "abacus"}, "rows": [)" + rows + "]}";
}

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(parse_study_results(text));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(StudyResults, HoldWhatTheRowsSay) {
  const StudyResults read =
      parse_study_results(results(row("needles", "double", 90.0, "1e-16", true) + "," +
                                  row("random", "half", 80.0, "null", false) + "," +
                                  row("random", "quad", 70.0, "0", true, 0)));
  EXPECT_EQ(read.processor, "abacus");
  const std::vector<StudyDot>& dots = read.dots;
  ASSERT_EQ(dots.size(), 2u) << "what was not timed has no place";
  EXPECT_EQ(dots[0].family, "needles");
  EXPECT_EQ(dots[0].configuration, "double");
  EXPECT_EQ(dots[0].axis, "cap");
  EXPECT_EQ(dots[0].pairs, 7);
  EXPECT_EQ(dots[0].wrong, 1);
  EXPECT_EQ(dots[0].undecided, 2);
  EXPECT_EQ(dots[0].settled, 3);
  EXPECT_EQ(dots[0].proof, "exact");
  EXPECT_TRUE(dots[0].on_front);
  EXPECT_EQ(dots[0].ns, 90.0);
  EXPECT_EQ(dots[0].ratio, 0.5);
  EXPECT_EQ(dots[0].error, 1e-16);
  EXPECT_EQ(dots[0].answer, std::nullopt);
  EXPECT_EQ(dots[0].distance, 2.0);
  EXPECT_EQ(dots[0].x.size(), 1u);
  EXPECT_EQ(dots[0].y[1], Eigen::Vector2d(3, 1));
  EXPECT_EQ(dots[1].error, std::nullopt);
  EXPECT_EQ(families_in(dots), (std::vector<std::string>{"needles", "random"}));
  EXPECT_EQ(of_family(dots, "random").size(), 1u);
}

TEST(StudyResults, FrontGoesFromFastToAccurate) {
  const auto front =
      front_of(parse_study_results(results(row("a", "slow", 90.0, "1e-16", true) + "," +
                                           row("a", "not", 50.0, "1", false) + "," +
                                           row("a", "fast", 10.0, "0.1", true)))
                   .dots);
  ASSERT_EQ(front.size(), 2u);
  EXPECT_EQ(front[0].configuration, "fast");
  EXPECT_EQ(front[1].configuration, "slow");
}

TEST(Front, HoldsWhatNothingBeats) {
  EXPECT_EQ(front_of({{100.0, 1e-3}, {200.0, 1e-9}, {150.0, 1e-3}, {300.0, 1e-6}}),
            (std::vector<bool>{true, true, false, false}));
  EXPECT_EQ(front_of({{100.0, 0.0}, {50.0, INFINITY}, {INFINITY, 0.0}}),
            (std::vector<bool>{true, false, false}));
  EXPECT_TRUE(front_of(std::vector<Cost>{}).empty());
}

TEST(Front, OfEqualTimesIsThePlainest) {
  // 104 is as long as 100, as far as a measurement can tell; 106 is longer.
  EXPECT_EQ(front_of({{104.0, 1e-3}, {100.0, 1e-3}}), (std::vector<bool>{true, false}));
  EXPECT_EQ(front_of({{106.0, 1e-3}, {100.0, 1e-3}}), (std::vector<bool>{false, true}));
  EXPECT_EQ(front_of({{104.0, 1e-2}, {100.0, 1e-3}}), (std::vector<bool>{false, true}));
}

TEST(Front, HoldsExactlyTheCostsThatNoneBeats) {
  std::uint32_t state = 1;
  const auto among = [&](std::uint32_t count) {
    state = state * 1664525u + 1013904223u;
    return static_cast<double>((state >> 16) % count);
  };
  std::vector<Cost> costs;
  for (int i = 0; i < 200; ++i) costs.push_back({std::pow(1.1, among(60)), among(60)});
  const std::vector<bool> front = front_of(costs);
  int on_front = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    bool beaten = false;
    bool has_twin = false;
    for (std::size_t k = 0; k < costs.size(); ++k) {
      const bool equal = costs[k].ns == costs[i].ns && costs[k].error == costs[i].error;
      beaten = beaten || (costs[k].ns <= costs[i].ns && costs[k].error <= costs[i].error && !equal);
      has_twin = has_twin || (equal && k < i);
    }
    EXPECT_EQ(front[i], !beaten && !has_twin) << i;
    on_front += front[i];
  }
  EXPECT_GT(on_front, 3);
  EXPECT_LT(on_front, 30);
}

TEST(StudyResults, SayWhatIsWrongAndWhere) {
  const std::string good = row("needles", "double", 90.0, "1e-16", true);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return results(good + "," + text.replace(text.find(from), from.size(), to));
  };
  EXPECT_EQ(complaint(results(good)), "");
  EXPECT_NE(complaint("[[views]]").find("not JSON"), std::string::npos);
  EXPECT_NE(complaint("[1]").find("no rows"), std::string::npos);
  EXPECT_NE(complaint("{\"rows\": 3}").find("no rows"), std::string::npos);
  EXPECT_NE(complaint(results("")).find("no row was timed"), std::string::npos);
  EXPECT_NE(complaint(results("3")).find("row 1: "), std::string::npos);
  EXPECT_NE(complaint("{\"rows\": [" + good + "]}").find("machine: "), std::string::npos);
  EXPECT_NE(complaint(with("\"pairs\": 7", "\"pears\": 7")).find("row 2: "), std::string::npos);
  EXPECT_NE(complaint(with("\"pairs\": 7", "\"pairs\": \"7\"")).find("row 2: "), std::string::npos);
  EXPECT_NE(complaint(with("[[0, 0]]", "[]")).find("row 2: "), std::string::npos);
  for (const std::string& text : {results("3"), with("[[0, 0]]", "[]")})
    EXPECT_NE(complaint(text).find("gjkscope study accuracy"), std::string::npos);
}

}  // namespace
}  // namespace gjkscope
