#include "lesson/study_results.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "lesson/study_times.hpp"

namespace gjkscope {
namespace {

std::string row(const std::string& family, const std::string& configuration, double ns,
                const std::string& error, bool front, int repetitions = 5) {
  return fmt::format(
      R"({{"family": "{}", "configuration": "{}", "axis": "cap", "front": {}, "pairs": 7,
          "repetitions": {}, "ns": {}, "ratio": 0.5, "undecided": 2, "wrong": 1, "error_scale": {},
          "worst": {{"answer": null, "distance": 2.0,
                     "case": {{"dimension": 2, "a": [[0, 0]], "b": [[2, 0], [3, 1]]}}}}}})",
      family, configuration, front, repetitions, ns, error);
}

std::string results(const std::string& rows) { return R"({"seed": 1, "rows": [)" + rows + "]}"; }

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(parse_study_results(text));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(StudyResults, HoldWhatTheRowsSay) {
  const auto dots = parse_study_results(results(row("needles", "double", 90.0, "1e-16", true) +
                                                "," + row("random", "half", 80.0, "null", false) +
                                                "," + row("random", "quad", 70.0, "0", true, 0)));
  ASSERT_EQ(dots.size(), 2u) << "what was not timed has no place";
  EXPECT_EQ(dots[0].family, "needles");
  EXPECT_EQ(dots[0].configuration, "double");
  EXPECT_EQ(dots[0].axis, "cap");
  EXPECT_EQ(dots[0].pairs, 7);
  EXPECT_EQ(dots[0].wrong, 1);
  EXPECT_EQ(dots[0].undecided, 2);
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
  const auto front = front_of(parse_study_results(
      results(row("a", "slow", 90.0, "1e-16", true) + "," + row("a", "not", 50.0, "1", false) +
              "," + row("a", "fast", 10.0, "0.1", true))));
  ASSERT_EQ(front.size(), 2u);
  EXPECT_EQ(front[0].configuration, "fast");
  EXPECT_EQ(front[1].configuration, "slow");
}

TEST(StudyResults, TimesByRatioPutTheFrontRightThatNoiseTurned) {
  const auto dot = [](const char* family, const char* configuration, double ns, double ratio) {
    StudyDot out;
    out.family = family;
    out.configuration = configuration;
    out.ns = ns;
    out.ratio = ratio;
    return out;
  };
  std::vector<StudyDot> measured = {dot("a", "double", 100.0, 1.0), dot("a", "loop", 105.0, 0.8),
                                    dot("b", "alone", 7.0, 0.5)};
  measured[0].on_front = true;
  // "loop" was timed in slower turns than "double", but took 0.8 of its time in each of them.
  for (int i = 0; i < 2; ++i) measured[static_cast<std::size_t>(i)].error = 1e-16;
  const std::vector<StudyDot> dots = timed_by_ratio(measured);
  EXPECT_EQ(dots[0].ns, 100.0);
  EXPECT_EQ(dots[1].ns, 80.0);
  EXPECT_EQ(dots[2].ns, 7.0) << "there is nothing that it could be compared with";
  EXPECT_FALSE(dots[0].on_front);
  EXPECT_TRUE(dots[1].on_front);
  EXPECT_FALSE(dots[2].on_front);
  EXPECT_EQ(default_of(dots, "a"), &dots[0]);
  EXPECT_EQ(default_of(dots, "b"), nullptr);
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
  EXPECT_NE(complaint(with("\"pairs\": 7", "\"pears\": 7")).find("row 2: "), std::string::npos);
  EXPECT_NE(complaint(with("\"pairs\": 7", "\"pairs\": \"7\"")).find("row 2: "), std::string::npos);
  EXPECT_NE(complaint(with("[[0, 0]]", "[]")).find("row 2: "), std::string::npos);
  for (const std::string& text : {results("3"), with("[[0, 0]]", "[]")})
    EXPECT_NE(complaint(text).find("gjkscope study accuracy"), std::string::npos);
}

}  // namespace
}  // namespace gjkscope
