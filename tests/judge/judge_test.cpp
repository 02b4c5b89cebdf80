// Findings on logs with one step that is wrong, by hand, and on a long log.

#include "judge/judge.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gjkscope::judging {
namespace judge_test {

Judgement judged(const std::string& text) {
  const ReadLog read = read_log(text, "log");
  EXPECT_TRUE(read.log) << to_string(read.problems) << '\n' << text;
  return read.log ? judge(*read.log) : Judgement{};
}

/// Two squares 2 apart: Z reaches from (2, -1) to (4, 1).
const std::string kSquares =
    R"({"gjk_log":1,"a":[[0,0],[1,0],[1,1],[0,1]],"b":[[3,0],[4,0],[4,1],[3,1]])";

struct Case {
  std::string lines;  ///< After the first.
  Part part;
  std::string says;
};

TEST(Judge, SaysWhatIsWrongWithItsNumbers) {
  const std::vector<Case> cases = {
      {R"({"points":[[3,0.5]]})", Part::vertex, "(3, 0.5) is no difference: the nearest is"},
      {R"({"simplex":[[0,0]],"points":[[-3,0]]})", Part::vertex,
       "a0 - b0, the difference of the other sign"},
      {R"({"simplex":[[0,0]],"kept":[[1,0]]})", Part::vertex,
       "is kept, but the simplex does not hold it"},
      {R"({"simplex":[[0,0]],"support":[1,3]})"
       "\n"
       R"({"simplex":[[0,0],[1,0]]})",
       Part::vertex, "the support point b3 - a1 of the iteration before is not in the simplex"},
      {R"({"simplex":[[0,0]],"support":[1,3]})"
       "\n"
       R"({"simplex":[[2,0],[1,3]]})",
       Part::vertex, "which the iteration before did not leave in it"},
      {R"({"simplex":[[1,0],[1,3],[2,0]],"kept":[[1,3]]})", Part::drop,
       "b0 - a1 was dropped, but has weight 1 in P: O lies in the region of the vertex b0 - a1. "
       "Without it the simplex is 2.236067977 away from O, with it 2"},
      {R"({"simplex":[[0,0],[0,1]],"kept":[[0,0],[0,1]]})", Part::drop,
       "b1 - a0 is kept without weight: O lies in the region of the vertex b0 - a0, 3 beside"},
      {R"({"simplex":[[0,0],[1,0]],"weights":[1,1]})", Part::weights, "add up to 2 and not to 1"},
      {R"({"simplex":[[0,0],[0,1]],"weights":[4,-3]})", Part::weights,
       "the weight of b1 - a0 is -3: O lies in the region of the vertex b0 - a0"},
      {R"({"simplex":[[0,0],[1,0]],"weights":["nan",1]})", Part::weights, "is not finite"},
      {R"({"simplex":[[0,0],[1,0]],"closest":[3,0]})", Part::closest,
       "it is 3 away, 1 more than needed; the closest point is (2, 0): O lies in the region of the "
       "vertex b0 - a1"},
      {R"({"simplex":[[0,0],[1,0]],"closest":[2,0.5]})", Part::closest,
       "lies 0.5 beside the simplex"},
      {R"({"simplex":[[1,0]],"direction":[1,0]})", Part::direction,
       "dot(d, O - P) is -2; the support point becomes b1 - a0 instead of b0 - a1, which lies 2 "
       "farther towards O"},
      {R"({"simplex":[[1,0]],"direction":[-1,0.001]})", Part::direction,
       "is 0.05729576041 degrees beside the way from P = (2, 0) to O; the support point is b3 - a1 "
       "all the same"},
      {R"({"simplex":[[1,0]],"direction":[0,0]})", Part::direction,
       "d = 0, though P = (2, 0) is not O"},
      {R"({"simplex":[[1,0]],"direction":[-1,0],"support":[0,0]})", Part::support,
       "b0 - a0 is not the farthest along d = (-1, 0): b0 - a1 lies 1 farther"},
      {R"({"simplex":[[1,0]],"kept":[[1,0]],"direction":[-1,0],"support":[1,0]})"
       "\n"
       R"({"simplex":[[1,0],[1,0]],"kept":[[1,0]]})"
       "\n"
       R"({"simplex":[[1,0],[1,0]],"kept":[[1,0]]})",
       Part::stop, "P is as near as it gets, and the run should end here"},
      {R"({"simplex":[[0,0]],"kept":[[0,0]],"direction":[-1,0],"support":[1,0]})"
       "\n"
       R"({"answer":{"distance":3}})",
       Part::stop,
       "P is 3 away from O, the shapes 2; all that is proved is that the distance lies between 2 "
       "and 3"},
      {R"({"simplex":[[0,0],[1,0],[2,0],[3,0]]})", Part::drop, "in the plane 3 are enough"},
  };
  for (const Case& each : cases) {
    const Judgement judgement = judged(kSquares + "}\n" + each.lines + "\n");
    SCOPED_TRACE(each.lines);
    ASSERT_TRUE(judgement.wrong) << (judgement.answer ? judgement.answer->what : "right");
    EXPECT_EQ(name_of(judgement.wrong->part), name_of(each.part)) << judgement.wrong->what;
    EXPECT_NE(judgement.wrong->what.find(each.says), std::string::npos) << judgement.wrong->what;
  }
}

TEST(Judge, SaysWhatIsWrongWithTheAnswer) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"({"distance":2.5})", "the distance 2.5 is wrong by 0.5: the distance is 2"},
      {R"({"distance":"nan"})", "the distance is nan: the distance is 2"},
      {R"({"distance":1e308})", "is wrong by"},
      {R"({"overlap":true})", "said to overlap, but they are apart"},
      {R"({"distance":2,"a":[1,0],"b":[3,1]})", "2.236067977 apart: the distance is 2"},
      {R"({"distance":2,"a":[1,2],"b":[3,1]})", "the closest point (1, 2) of a lies 1 beside it"},
      {R"({"a":["inf",2],"b":[3,1]})", "is not finite"},
      {R"({"distance":2,"overlap":false,"a":[1,0.5],"b":[3,0.5]})", ""},
      {R"({"distance":2.0000000000000004})", ""},
      {R"({})", ""},
  };
  for (const auto& [answer, says] : cases) {
    const Judgement judgement = judged(kSquares + "}\n{\"answer\":" + answer + "}\n");
    EXPECT_EQ(judgement.answer.has_value(), !says.empty()) << answer;
    const std::string what = judgement.answer ? judgement.answer->what : "";
    EXPECT_NE(what.find(says), std::string::npos) << what;
  }
  const Judgement overlap = judged(
      "{\"gjk_log\":1,\"a\":[[0,0],[2,0],[0,2]],\"b\":[[0.5,0.5]]}\n{\"answer\":{\"overlap\":false}"
      "}\n");
  ASSERT_TRUE(overlap.answer);
  EXPECT_EQ(overlap.answer->what, "the shapes are said to be apart, but they overlap");
}

TEST(Judge, ADepthIsHeldToTheExactOne) {
  const std::string plane =
      R"("a":[[0,0],[2,0],[2,2],[0,2]],"b":[[1.5,0.25],[3,0.25],[3,1],[1.5,1]])";
  const std::string space =
      R"("a":[[0,0,0],[2,0,0],[0,2,0],[2,2,0],[0,0,2],[2,0,2],[0,2,2],[2,2,2]],)"
      R"("b":[[1.5,0.25,0.5],[3,0.25,0.5],[1.5,1,0.5],[3,1,0.5],)"
      R"([1.5,0.25,1.25],[3,0.25,1.25],[1.5,1,1.25],[3,1,1.25]])";
  const auto answered = [](const std::string& head, const std::string& answer) {
    return judged("{\"gjk_log\":1," + head + "}\n{\"answer\":" + answer + "}\n");
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {R"({"depth":0.5,"translation":[-0.5,0Z]})", ""},
      {R"({"distance":0,"overlap":true,"depth":0.50000000000000011})", ""},
      {R"({"depth":0.75})", "the depth 0.75 is wrong by 0.25: the depth is 0.5"},
      {R"({"depth":0.25})", "the depth 0.25 is wrong by 0.25: the depth is 0.5"},
      {R"({"depth":0})", "the depth 0 is wrong by 0.5"},
      {R"({"depth":-0.5})", "the depth is 0.5; a depth is not negative"},
      {R"({"depth":"nan"})", "the depth is nan: the depth is 0.5"},
      {R"({"translation":[0.5,0Z]})", "the shapes still lie 1 deep in each other"},
      {R"({"translation":[0,-0.5Z]})", "the shapes still lie 0.5 deep in each other"},
      {R"({"translation":[0,-2Z]})", "is 2 long: the depth is 0.5"},
      {R"({"translation":[0,0Z]})", "is 0 long: the depth is 0.5"},
      {R"({"translation":["inf",0Z]})", "is not finite"},
  };
  for (const auto& [text, says] : cases) {
    for (const bool in_space : {false, true}) {
      std::string answer = text;
      if (const std::size_t at = answer.find('Z'); at != std::string::npos)
        answer.replace(at, 1, in_space ? ",0" : "");
      for (const char* difference : {"b-a", "a-b"}) {
        const Judgement judgement = answered(
            fmt::format("\"difference\":\"{}\",{}", difference, in_space ? space : plane), answer);
        SCOPED_TRACE(answer + ' ' + difference);
        EXPECT_EQ(judgement.depth, 0.5);
        EXPECT_EQ(judgement.answer.has_value(), !says.empty());
        const std::string what = judgement.answer ? judgement.answer->what : "";
        EXPECT_NE(what.find(says), std::string::npos) << what;
      }
    }
  }
  EXPECT_FALSE(answered(plane, R"({"distance":0})").depth);
  EXPECT_FALSE(answered("\"scalar\":\"float\"," + plane, R"({"depth":0.5000001})").answer);
  EXPECT_TRUE(answered(plane, R"({"depth":0.5000001})").answer);
  EXPECT_FALSE(answered("\"tolerance\":0.1," + plane, R"({"depth":0.46})").answer);
  EXPECT_TRUE(answered("\"tolerance\":0.1," + plane, R"({"depth":0.44})").answer);
}

TEST(Judge, ShapesThatTouchOrAreApartHaveNoDepth) {
  const auto what = [](const std::string& b, const std::string& answer) {
    const Judgement judgement = judged(R"({"gjk_log":1,"a":[[0,0],[2,0],[2,2],[0,2]],"b":)" + b +
                                       "}\n{\"answer\":" + answer + "}\n");
    EXPECT_EQ(judgement.depth, 0);
    return judgement.answer ? judgement.answer->what : "";
  };
  const std::string touching = "[[2,1],[3,1],[3,2]]";
  EXPECT_EQ(what(touching, R"({"depth":0,"translation":[0,0]})"), "");
  EXPECT_EQ(what(touching, R"({"depth":0.5})"), "the depth 0.5 is wrong by 0.5: the depth is 0");
  const std::string apart = "[[3,1],[4,1],[4,2]]";
  EXPECT_EQ(what(apart, R"({"distance":1,"depth":0})"), "");
  EXPECT_EQ(what(apart, R"({"depth":-1,"translation":[7,7]})"), "");
  EXPECT_EQ(what(apart, R"({"depth":0.5})"),
            "the depth 0.5 is wrong by 0.5: the shapes are apart, and have no depth");
}

TEST(Judge, AFloatIsHeldToFloats) {
  const std::string steps = R"(}
{"simplex":[[1,0],[1,3]],"closest":[2.0000002,0],"direction":[-1,1e-7],"support":[1,0]}
{"answer":{"distance":2.0000002}}
)";
  EXPECT_TRUE(judged(kSquares + ",\"scalar\":\"float\"" + steps).right());
  const Judgement judgement = judged(kSquares + steps);
  ASSERT_TRUE(judgement.wrong);
  EXPECT_NE(judgement.wrong->what.find("rounding in float would explain it"), std::string::npos);
}

TEST(Judge, ADeclaredToleranceIsGranted) {
  const std::string answer = "}\n{\"answer\":{\"distance\":2.001}}\n";
  EXPECT_FALSE(judged(kSquares + answer).right());
  EXPECT_TRUE(judged(kSquares + ",\"tolerance\":0.001" + answer).right());
}

TEST(Judge, TheOtherDifferenceIsTheSameRun) {
  const std::string log = R"(,"difference":"a-b"}
{"simplex":[[0,0]],"points":[[-3,0]],"closest":[-3,0],"direction":[1,0],"support":[1,0]}
{"simplex":[[0,0],[1,0]],"points":[[-3,0],[-2,0]],"closest":[-2,0],"direction":[2,0],"support":[1,3]}
{"answer":{"distance":2,"a":[1,0],"b":[3,0]}}
)";
  const Judgement judgement = judged(kSquares + log);
  EXPECT_TRUE(judgement.right()) << (judgement.wrong ? judgement.wrong->what : "");
}

TEST(Judge, WasteLeavesARunRight) {
  const std::string first = "{\"simplex\":[[1,0]],\"direction\":[-1,0],\"support\":[1,0]}\n";
  const Judgement judgement = judged(kSquares + "}\n" + first + "{\"simplex\":[[1,0],[1,0]]}\n" +
                                     "{\"answer\":{\"distance\":2}}\n");
  EXPECT_TRUE(judgement.right());
  ASSERT_TRUE(judgement.waste);
  EXPECT_EQ(judgement.waste->what, "P is the answer already; 1 iteration follows without a gain");
}

TEST(Judge, HugeAndTinyShapesAreJudged) {
  for (const double size : {1e-300, 1e-150, 1e150, 1e307}) {
    const std::string log = fmt::format(
        "{{\"gjk_log\":1,\"a\":[[0,0],[{0},0]],\"b\":[[{1},0],[{1},{0}]]}}\n"
        "{{\"simplex\":[[0,0]],\"closest\":[{1},0],\"direction\":[-1,0],\"support\":[1,0]}}\n"
        "{{\"simplex\":[[0,0],[1,0]],\"closest\":[{2},0],\"direction\":[-1,0],\"support\":[1,0]}}\n"
        "{{\"answer\":{{\"distance\":{2}}}}}\n",
        size, 3 * size, 3 * size - size);
    const Judgement judgement = judged(log);
    EXPECT_TRUE(judgement.right()) << size << ' ' << (judgement.wrong ? judgement.wrong->what : "");
  }
}

/// Edges of Z, each with its closest point and the direction to O. All are right; the run just ends
/// too early.
TEST(Judge, TenThousandIterationsTakeLessThanASecond) {
  constexpr int kVertices = 100;
  std::vector<Point> a;
  std::vector<Point> b;
  for (int i = 0; i < kVertices; ++i) {
    const double t = 6.283185307179586 * i / kVertices;
    a.emplace_back(std::cos(t), std::sin(t), std::sin(3 * t));
    b.emplace_back(10 + std::sin(t), std::cos(t), std::cos(2 * t));
  }
  const auto list = [](const std::vector<Point>& points) {
    std::string out;
    for (const Point& p : points)
      out += fmt::format("{}[{},{},{}]", out.empty() ? "" : ",", p[0], p[1], p[2]);
    return out;
  };
  std::string log = fmt::format("{{\"gjk_log\":1,\"a\":[{}],\"b\":[{}]}}\n", list(a), list(b));
  for (std::size_t k = 0; k < kVertices * kVertices; ++k) {
    const std::size_t i = k % kVertices;
    const std::size_t next = (i + 1) % kVertices;
    const std::size_t j = k / kVertices;
    const Point from = b[j] - a[i];
    const Point edge = a[i] - a[next];
    const double t = std::clamp(-from.dot(edge) / edge.dot(edge), 0.0, 1.0);
    const Point p = from + t * edge;
    log += fmt::format(
        "{{\"simplex\":[[{},{}],[{},{}]],\"closest\":[{},{},{}],\"direction\":[{},{},{}]}}\n", i, j,
        next, j, p[0], p[1], p[2], -p[0], -p[1], -p[2]);
  }
  const ReadLog read = read_log(log, "log");
  ASSERT_TRUE(read.log) << to_string(read.problems);
  const Judgement judgement = judge(*read.log);
  ASSERT_TRUE(judgement.wrong);
  EXPECT_EQ(judgement.wrong->iteration, kVertices * kVertices) << judgement.wrong->what;
  EXPECT_EQ(judgement.wrong->part, Part::stop) << judgement.wrong->what;
  EXPECT_GT(judgement.rounding, 0);
}

}  // namespace judge_test
}  // namespace gjkscope::judging
