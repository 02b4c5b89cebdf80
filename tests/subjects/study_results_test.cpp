#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "subjects/study/results.hpp"

namespace gjkscope {
namespace study_results_test {

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
  EXPECT_EQ(front_of({{100.0, 0.0}, {50.0, INFINITY}, {INFINITY, 0.0}, {200.0, 0.0}}),
            (std::vector<bool>{true, false, false, false}));
  EXPECT_TRUE(front_of(std::vector<Cost>{}).empty());
}

TEST(Front, HasNoPlaceForAnswersOfWhichNotOneDigitIsRight) {
  EXPECT_EQ(front_of({{10.0, 1.0}, {100.0, 0.1}}), (std::vector<bool>{false, true}));
  EXPECT_EQ(front_of({{10.0, 1.0}}), (std::vector<bool>{false}));
}

TEST(Front, OfEqualTimesAndErrorsHoldsThePlainest) {
  EXPECT_EQ(front_of({{109.0, 1e-3}, {100.0, 1e-3}}), (std::vector<bool>{true, false}));
  EXPECT_EQ(front_of({{111.0, 1e-3}, {100.0, 1e-3}}), (std::vector<bool>{false, true}));
  EXPECT_EQ(front_of({{109.0, 1.9e-3}, {100.0, 1e-3}}), (std::vector<bool>{true, false}));
  EXPECT_EQ(front_of({{109.0, 2.1e-3}, {100.0, 1e-3}}), (std::vector<bool>{false, true}));
  EXPECT_EQ(front_of({{100.0, 1e-3}, {200.0, 0.6e-3}}), (std::vector<bool>{true, false}))
      << "half as much again is no gain";
  EXPECT_EQ(front_of({{100.0, 1e-3}, {109.0, 1e-9}}), (std::vector<bool>{false, true}))
      << "in the same time";
}

/// For any costs, those on the front are worth their time, and stand for all the others.
TEST(Front, BeatsAllThatIsNotOnIt) {
  std::uint32_t state = 1;
  const auto among = [&](std::uint32_t count) {
    state = state * 1664525u + 1013904223u;
    return (state >> 16) % count;
  };
  for (int round = 0; round < 50; ++round) {
    std::vector<Cost> costs;
    for (int i = 0; i < 60; ++i) {
      const std::uint32_t steps = among(80);  // digits take time, so that there is a choice
      costs.push_back({std::pow(1.07, steps), std::pow(0.6, among(steps + 1))});
    }
    const std::vector<bool> front = front_of(costs);
    std::vector<Cost> best;
    for (std::size_t i = 0; i < costs.size(); ++i) {
      if (front[i]) best.push_back(costs[i]);
    }
    ASSERT_GE(best.size(), 2u);
    std::sort(best.begin(), best.end(),
              [](const Cost& a, const Cost& b) { return a.error > b.error; });
    for (std::size_t i = 1; i < best.size(); ++i) {
      EXPECT_LE(best[i].error, best[i - 1].error / kSameError);
      EXPECT_GE(best[i].ns * kSameTime, best[i - 1].ns);
    }
    for (const Cost& cost : costs) {
      if (cost.error > kNoDigit) continue;
      EXPECT_TRUE(std::any_of(best.begin(), best.end(),
                              [&](const Cost& each) {
                                return each.ns <= kSameTime * cost.ns &&
                                       each.error <= kSameError * cost.error;
                              }))
          << cost.ns << " " << cost.error;
    }
  }
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

}  // namespace study_results_test
}  // namespace gjkscope
