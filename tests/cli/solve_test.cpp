#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "cli/commands.hpp"
#include "command_line.hpp"

namespace gjkscope {
namespace solve_test {

using nlohmann::json;

struct Solved {
  int exit_code = 0;
  std::vector<json> answers;
  std::string err;
};

Solved solve(const std::string& text, ScalarKind scalar = ScalarKind::double_,
             ModelMethod method = ModelMethod::boxes) {
  std::istringstream in(text);
  std::ostringstream out;
  std::ostringstream err;
  const Environment env{GJKSCOPE_SOURCE_DIR, in, out, err};
  Solved solved;
  solved.exit_code = solve_command(env, {"-"}, {scalar, method});
  for (const std::string& line : test::lines_of(out.str()))
    solved.answers.push_back(json::parse(line));
  solved.err = err.str();
  return solved;
}

const std::string kApart = R"({"a":[[-1,-1],[1,-1],[1,1],[-1,1]],"b":[[2,2],[3,2],[2,3]]})";
const std::string kOverlap = R"({"a":[[-1,-1],[1,-1],[1,1],[-1,1]],"b":[[0,0.5],[3,2],[2,3]]})";
const std::string kTouch = R"({"a":[[-1,-1],[1,-1],[1,1],[-1,1]],"b":[[1,0],[3,2],[3,-3]]})";

TEST(Solve, AnswersWithDistanceBoundsAndWitnesses) {
  const Solved solved = solve(kApart);
  EXPECT_EQ(kDone, solved.exit_code);
  ASSERT_EQ(1u, solved.answers.size());
  const json& answer = solved.answers[0];
  EXPECT_NEAR(std::sqrt(2.0), answer["distance"].get<double>(), 1e-15);
  EXPECT_LE(answer["lower"].get<double>(), std::sqrt(2.0));
  EXPECT_GE(answer["upper"].get<double>(), std::sqrt(2.0));
  EXPECT_EQ(false, answer["overlap"].get<bool>());
  EXPECT_EQ(json({1.0, 1.0}), answer["a"]);
  EXPECT_EQ(json({2.0, 2.0}), answer["b"]);
  EXPECT_EQ("separated", answer["verdict"]);
  EXPECT_EQ(false, answer["settled"].get<bool>());
  EXPECT_EQ("repeated-support", answer["stop"]);
  EXPECT_GE(answer["iterations"].get<int>(), 1);
}

TEST(Solve, AnswersWithTheDepthOfShapesThatOverlap) {
  for (const ScalarKind scalar :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    const json answer = solve(kOverlap, scalar).answers[0];
    EXPECT_NEAR(0.5, answer["depth"].get<double>(), 2e-3);
    EXPECT_LE(answer["depth_lower"].get<double>(), 0.5);
    EXPECT_GE(answer["depth_upper"].get<double>(), 0.5);
    EXPECT_EQ(json({0.0, -1.0}), answer["direction"]);
    EXPECT_EQ(0.0, answer["translation"][0].get<double>());
    EXPECT_EQ(-answer["depth"].get<double>(), answer["translation"][1].get<double>());
    const json touching = solve(kTouch, scalar).answers[0];
    EXPECT_EQ("touching", touching["verdict"]);
    EXPECT_EQ(0.0, touching["depth"].get<double>());
    EXPECT_EQ(0.0, touching["depth_upper"].get<double>());
    EXPECT_EQ(json({-1.0, 0.0}), touching["direction"]);
    for (const char* key : {"depth", "depth_lower", "depth_upper", "direction", "translation"}) {
      EXPECT_FALSE(solve(kApart, scalar).answers[0].contains(key)) << key;
    }
  }
  // A coordinate is so small that no exact product of doubles holds it: rationals do.
  const json tiny =
      solve(R"({"a":[[0,0],[1,0],["1e-200",1]],"b":[["1e-250","1e-250"]]})").answers[0];
  EXPECT_TRUE(tiny["overlap"].get<bool>());
  EXPECT_GE(1e-249, tiny["depth"].get<double>());
  EXPECT_LE(tiny["depth_lower"].get<double>(), tiny["depth"].get<double>());
}

TEST(Solve, AnswersWithTheDepthOfPolyhedraThatOverlap) {
  const std::string box = R"({"dimension":3,"a":[[0,0,0],[2,0,0],[0,2,0],[2,2,0],[0,0,2],[2,0,2],)"
                          R"([0,2,2],[2,2,2]],"b":)";
  for (const ScalarKind scalar :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    const json answer = solve(box + R"([[1,1,1.5],[1,1,4]]})", scalar).answers[0];
    EXPECT_NEAR(0.5, answer["depth"].get<double>(), 2e-3);
    EXPECT_LE(answer["depth_lower"].get<double>(), 0.5);
    EXPECT_GE(answer["depth_upper"].get<double>(), 0.5);
    EXPECT_EQ(json({0.0, 0.0, -1.0}), answer["direction"]);
    EXPECT_EQ(-answer["depth"].get<double>(), answer["translation"][2].get<double>());
    const json touching = solve(box + R"([[1,1,2],[1,1,4]]})", scalar).answers[0];
    EXPECT_EQ("touching", touching["verdict"]);
    EXPECT_EQ(0.0, touching["depth"].get<double>());
    EXPECT_EQ(0.0, touching["depth_upper"].get<double>());
    for (const char* key : {"depth", "depth_lower", "depth_upper", "direction", "translation"}) {
      EXPECT_FALSE(solve(box + R"([[1,1,3],[1,1,4]]})", scalar).answers[0].contains(key)) << key;
    }
  }
}

TEST(Solve, EveryScalarAgrees) {
  for (const ScalarKind scalar :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    EXPECT_NEAR(std::sqrt(2.0), solve(kApart, scalar).answers[0]["distance"].get<double>(), 2e-3);
    EXPECT_TRUE(solve(kOverlap, scalar).answers[0]["overlap"].get<bool>());
    EXPECT_TRUE(solve(kTouch, scalar).answers[0]["overlap"].get<bool>());
  }
}

TEST(Solve, ExactAnswersCarryTheSquareAndMeetingBounds) {
  const json answer = solve(R"({"a":[[0,0]],"b":[[1,0],[0,1]]})", ScalarKind::exact).answers[0];
  EXPECT_EQ("1/2", answer["distance_squared"]);
  const double lower = answer["lower"].get<double>();
  EXPECT_EQ(std::nextafter(lower, 1.0), answer["upper"].get<double>());
  const json representable = solve(R"({"a":[[0,0]],"b":[[3,4]]})", ScalarKind::exact).answers[0];
  EXPECT_EQ("25", representable["distance_squared"]);
  EXPECT_EQ(5.0, representable["lower"].get<double>());
  EXPECT_EQ(5.0, representable["upper"].get<double>());
  EXPECT_EQ("0", solve(kTouch, ScalarKind::exact).answers[0]["distance_squared"]);
}

TEST(Solve, NumbersRoundTrip) {
  const json answer =
      solve(R"({"a":[[0.1,0.2]],"b":[["0x1.999999999999bp-1",0.30000000000000004]]})").answers[0];
  EXPECT_EQ(0.1, answer["a"][0].get<double>());
  EXPECT_EQ(0x1.999999999999bp-1, answer["b"][0].get<double>());
  EXPECT_EQ(0.30000000000000004, answer["b"][1].get<double>());
}

TEST(Solve, OverlapIsRightWhereTheRunCannotTell) {
  // The gap is far below half of a unit in the last place of the coordinates' products.
  const std::string gap = R"({"a":[[0,0],[3,1]],"b":[["0x1.8p0","0x1.0000000000001p-1"]]})";
  const Solved apart = solve(gap);
  EXPECT_FALSE(apart.answers[0]["overlap"].get<bool>());
  EXPECT_EQ("separated", apart.answers[0]["verdict"]);
  EXPECT_TRUE(solve(R"({"a":[[0,0],[3,1]],"b":[[1.5,0.5]]})").answers[0]["overlap"].get<bool>());
}

TEST(Solve, ErrorsAreAnswersToo) {
  const Solved solved =
      solve("{\"a\":[]}\n" + kApart + "\n{\"a\":[[-1e308,0]],\"b\":[[1e308,0]]}\n");
  EXPECT_EQ(kProblem, solved.exit_code);
  ASSERT_EQ(3u, solved.answers.size());
  EXPECT_TRUE(solved.answers[0].contains("error"));
  EXPECT_FALSE(solved.answers[0].contains("distance"));
  EXPECT_FALSE(solved.answers[1].contains("error"));
  EXPECT_NE(std::string::npos, solved.answers[2]["error"].get<std::string>().find("overflow"));
  EXPECT_FALSE(solved.err.empty());
}

TEST(Solve, AnExactDistanceBeyondDoublesIsAnError) {
  for (const char* far : {"1e308", "8.98846567431158e307"}) {
    const std::string text =
        fmt::format(R"({{"a":[[-{0},1]],"b":[[{0},0]]}})", far);  // at least 2^1024 apart
    const json answer = solve(text, ScalarKind::exact).answers[0];
    EXPECT_FALSE(answer.contains("distance"));
    EXPECT_TRUE(answer["error"].get<std::string>().starts_with("overflow")) << answer;
  }
}

TEST(Solve, WhatFloatCannotHoldDoubleAndExactCan) {
  const std::string large = R"({"a":[[0,0]],"b":[[3e200,4e200]]})";
  EXPECT_TRUE(solve(large, ScalarKind::single).answers[0].contains("error"));
  EXPECT_DOUBLE_EQ(5e200, solve(large).answers[0]["distance"].get<double>());
  EXPECT_DOUBLE_EQ(5e200, solve(large, ScalarKind::exact).answers[0]["distance"].get<double>());
}

TEST(Solve, EachScalarComputesInItself) {
  const std::string tenths = R"({"a":[[0,0]],"b":[[0.3,0.7]]})";
  const double single = solve(tenths, ScalarKind::single).answers[0]["distance"].get<double>();
  EXPECT_EQ(single, static_cast<double>(static_cast<float>(single)));
  EXPECT_NE(single, solve(tenths).answers[0]["distance"].get<double>());
  const double half = solve(tenths, ScalarKind::half).answers[0]["distance"].get<double>();
  EXPECT_EQ(half, std::ldexp(std::round(std::ldexp(half, 11)), -11)) << "11 digits";
}

TEST(Solve, ReportedHardCasesHaveRightAnswers) {
  int overlapping = 0;
  int apart = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(GJKSCOPE_SOURCE_DIR "/tests/hard-cases")) {
    const std::string text = test::read_file(entry.path().string());
    const json given = json::parse(text);
    SCOPED_TRACE(entry.path().filename().string());
    for (const ScalarKind scalar : {ScalarKind::double_, ScalarKind::exact}) {
      const json answer = solve(text, scalar).answers[0];
      EXPECT_EQ(given["expected_overlap"], answer["overlap"]);
      EXPECT_NE("undecided", answer["verdict"]);
      EXPECT_DOUBLE_EQ(given["expected_distance"].get<double>(), answer["distance"].get<double>());
      EXPECT_LE(answer["lower"], given["expected_distance"]);
      EXPECT_GE(answer["upper"], given["expected_distance"]);
    }
    ++(given["expected_overlap"].get<bool>() ? overlapping : apart);
  }
  EXPECT_GE(overlapping, 5);
  EXPECT_GE(apart, 5);
  EXPECT_EQ(41, overlapping + apart);
}

const std::string kInSpace =
    R"({"dimension":3,"a":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"b":[[2,2,2],[3,2,2],[2,3,2]]})";

TEST(Solve, CasesInSpaceHaveTheSameAnswers) {
  const double distance = std::sqrt(25.0 / 3.0);
  for (const ScalarKind scalar :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    const Solved solved = solve(kInSpace, scalar);
    EXPECT_EQ(kDone, solved.exit_code);
    const json& answer = solved.answers[0];
    EXPECT_NEAR(distance, answer["distance"].get<double>(), 4e-3);
    EXPECT_LE(answer["lower"].get<double>(), distance);
    EXPECT_GE(answer["upper"].get<double>(), distance);
    EXPECT_EQ(false, answer["overlap"]);
    EXPECT_EQ(json({2.0, 2.0, 2.0}), answer["b"]);
    ASSERT_EQ(3u, answer["a"].size());
    for (const json& third : answer["a"]) EXPECT_NEAR(1.0 / 3.0, third.get<double>(), 1e-3);
  }
  EXPECT_EQ("25/3", solve(kInSpace, ScalarKind::exact).answers[0]["distance_squared"]);
  const json touching =
      solve(R"({"dimension":3,"a":[[0,0,0],[2,0,0],[0,2,0]],"b":[[0.5,0.5,0],[1,1,1]]})")
          .answers[0];
  EXPECT_EQ("touching", touching["verdict"]);
  EXPECT_EQ(true, touching["overlap"]);
  EXPECT_EQ(0.0, touching["depth"].get<double>());
  const Solved refused = solve(R"({"dimension":3,"a":[[-1e308,0,0]],"b":[[1e308,0,0]]})");
  EXPECT_EQ(kProblem, refused.exit_code);
  EXPECT_NE(std::string::npos, refused.answers[0]["error"].get<std::string>().find("overflow"));
}

TEST(Solve, MutatedCasesAreAnsweredOrRefusedOneObjectALine) {
  constexpr std::uint32_t kSeed = 78;
  std::mt19937 random(kSeed);
  const std::string alphabet = "{}[],:\"012345678901234567890123456789.-+e \n\xFF";
  int refused = 0;
  int answered = 0;
  for (int i = 0; i < 600; ++i) {
    std::string text = i % 2 == 0 ? kApart : kTouch;
    for (int k = static_cast<int>(random() % 2); k >= 0; --k) {
      text[random() % text.size()] = alphabet[random() % alphabet.size()];
    }
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " text " << i << ": " << text);
    const Solved solved = solve(text);
    ASSERT_FALSE(solved.answers.empty());
    bool any_refused = false;
    for (const json& answer : solved.answers) {
      const bool error = answer.contains("error");
      any_refused = any_refused || error;
      ASSERT_NE(error, answer.contains("distance"));
      if (!error) {
        ASSERT_LE(answer["lower"].get<double>(), answer["upper"].get<double>());
      }
      ++(error ? refused : answered);
    }
    ASSERT_EQ(any_refused ? kProblem : kDone, solved.exit_code);
  }
  EXPECT_GT(refused, 200);
  EXPECT_GT(answered, 50);
}

TEST(Solve, PointSetsStandForTheirHulls) {
  const std::string unsorted =
      R"({"a":[[1,1],[-1,-1],[0,0],[1,-1],[0.5,0],[-1,1],[1,1]],"b":[[2,3],[2,2],[3,2]]})";
  EXPECT_EQ(solve(kApart).answers[0]["distance"], solve(unsorted).answers[0]["distance"]);
}

TEST(Solve, EmptyInputIsAProblem) {
  const Solved solved = solve("");
  EXPECT_EQ(kProblem, solved.exit_code);
  ASSERT_EQ(1u, solved.answers.size());
  EXPECT_TRUE(solved.answers[0].contains("error"));
}

TEST(Solve, FilesAreReadAndMissingOnesNamed) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("case.json", kApart);
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  const Environment env{GJKSCOPE_SOURCE_DIR, in, out, err};
  EXPECT_EQ(kCannot, solve_command(env, {file, file + ".missing", folder.path().string()}, {}));
  EXPECT_EQ(1u, test::lines_of(out.str()).size());
  EXPECT_NE(std::string::npos, err.str().find(".missing"));
  EXPECT_NE(std::string::npos, err.str().find("Is a directory"));
}

TEST(SolveOutlines, EveryMethodGivesTheSameAnswer) {
  const std::string text =
      R"({"outlines_a":[[[0,0],[4,0],[4,4],[0,4]]],"outlines_b":[[[6,1],[9,0],[9,3]]]})";
  for (const auto& [name, method] : Named<ModelMethod>::kTable) {
    SCOPED_TRACE(name);
    const Solved solved = solve(text, ScalarKind::double_, method);
    ASSERT_EQ(kDone, solved.exit_code) << solved.err;
    const json& answer = solved.answers[0];
    EXPECT_EQ(json(name), answer["method"]);
    EXPECT_EQ(2.0, answer["distance"]);
    EXPECT_EQ(false, answer["overlap"]);
    EXPECT_EQ(json({4.0, 1.0}), answer["a"]);
    EXPECT_EQ(json({6.0, 1.0}), answer["b"]);
    EXPECT_EQ(json({{"kind", "segment"}, {"outline", 0}, {"index", 1}}), answer["features"]["a"]);
    EXPECT_EQ(json({{"kind", "vertex"}, {"outline", 0}, {"index", 0}}), answer["features"]["b"]);
    EXPECT_LE(1, answer["visits"]);
  }
}

TEST(SolveOutlines, AHoleAndAChainHaveNoMatter) {
  const std::string frame = R"([[0,0],[10,0],[10,10],[0,10]])";
  const std::string hole = R"([[2,2],[2,8],[8,8],[8,2]])";
  const auto answer = [&](const std::string& a) {
    return solve(R"({"outlines_a":[)" + a + R"(],"outlines_b":[[[4,4],[5,4],[5,5]]]})").answers[0];
  };
  EXPECT_EQ(true, answer(frame)["overlap"]);
  EXPECT_EQ(2.0, answer(frame + "," + hole)["distance"]);
  EXPECT_EQ(4.0, answer(R"({"open":)" + frame + "}")["distance"]);
}

TEST(SolveOutlines, WhatAMethodDoesNotTakeIsSaidWithItsPlace) {
  struct Bad {
    std::string outline;
    ModelMethod method;
    std::string said;
  };
  const Bad bads[] = {
      {"[[0,0],[4,4],[4,0],[0,4]]", ModelMethod::pieces, "1:17: /outlines_a/0/0: not simple"},
      {"[[0,0],[4,0],[1,1],[0,4]]", ModelMethod::lin_canny, "1:16: /outlines_a/0: not convex"},
      {R"({"open":[[0,0],[4,0]]})", ModelMethod::pieces, "/outlines_a/0/open: open chain"},
      {"[[0,0]]", ModelMethod::boxes, "1:16: /outlines_a/0: too few points"},
      {R"([[0,0],[1,"nan"]])", ModelMethod::boxes, R"(1:26: /outlines_a/0/1/1 is "nan")"},
  };
  for (const Bad& bad : bads) {
    SCOPED_TRACE(bad.outline);
    const Solved solved =
        solve(R"({"outlines_a":[)" + bad.outline + R"(],"outlines_b":[[[6,1],[9,0],[9,3]]]})",
              ScalarKind::double_, bad.method);
    EXPECT_EQ(kProblem, solved.exit_code);
    EXPECT_NE(std::string::npos, solved.err.find(bad.said)) << solved.err;
    EXPECT_TRUE(solved.answers[0].contains("error"));
  }
}

}  // namespace solve_test
}  // namespace gjkscope
