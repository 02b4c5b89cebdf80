#include "lesson/case.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>

#include "run/run.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace case_test {

using Eigen::Vector2d;

const std::string kGood = R"({"dimension":2,"a":[[0,0]],"b":[[3,4],[5,6]]})";

ReadCase only(const std::string& text) {
  const std::vector<ReadCase> cases = parse_cases(text, "f.json");
  EXPECT_EQ(1u, cases.size()) << text;
  return cases.empty() ? ReadCase{} : cases.front();
}

TEST(Case, IsTwoPointSets) {
  const ReadCase read = only(kGood);
  ASSERT_TRUE(read.value);
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ("f.json", read.name);
  EXPECT_EQ(Eigen::Vector2d(0, 0), read.value->a[0]);
  EXPECT_EQ(Eigen::Vector2d(5, 6), read.value->b[1]);
}

TEST(Case, OtherKeysAreIgnoredAndTheNameIsTaken) {
  const ReadCase read = only(R"({"name":"n","why":{"x":[1]},"a":[[0,0]],"b":[[1,1]],"c":null})");
  ASSERT_TRUE(read.value);
  EXPECT_EQ("n", read.name);
}

TEST(Case, StringsHoldDecimalAndHexadecimalNumbers) {
  const ReadCase read = only(R"({"a":[["0x1.8p1","-0x1p-1074"]],"b":[["1e-3","-.5"]]})");
  ASSERT_TRUE(read.value);
  EXPECT_EQ(Eigen::Vector2d(3.0, -0x1p-1074), read.value->a[0]);
  EXPECT_EQ(Eigen::Vector2d(1e-3, -0.5), read.value->b[0]);
}

TEST(Case, WhatALessonCannotHoldIsAProblemInItsPlace) {
  const auto problem = [](const std::string& text) {
    const auto cases = parse_cases(text, "f", 2, std::nullopt, CaseLimits::of_lessons());
    return cases.front().problems.empty() ? "" : to_string(cases.front().problems.front());
  };
  EXPECT_EQ("f:1:9: /a/0/0 is 1e+308; expected a number from -1e+18 to 1e+18",
            problem(R"({"a": [[1e308,0],[-1e308,0]], "b": [[3,1e308]]})"));
  EXPECT_EQ("f:2:7: /b/0/1 is -1e+19; expected a number from -1e+18 to 1e+18",
            problem("{\"a\":[[0,0]],\"b\":[[1,\n      -1e19]]}"));
  std::string many = R"({"b":[[9,9]],"a":[[0,0])";
  for (int i = 0; i < 10000; ++i) many += ",[0,0]";
  EXPECT_EQ("f:1:18: /a has 10001 points; expected at most 10000", problem(many + "]}"));
  EXPECT_EQ("", problem(kGood));
  EXPECT_TRUE(only(R"({"a":[[1e308,0]],"b":[[3,1e308]]})").value) << "by itself it is a case";
}

TEST(Case, ATextHoldsAnyNumberOfThem) {
  EXPECT_EQ(2u, parse_cases(kGood + "\n" + kGood + "\n", "f").size());
  EXPECT_EQ(2u, parse_cases(kGood + kGood, "f").size());
  EXPECT_EQ(3u, parse_cases("[" + kGood + "," + kGood + "]\n" + kGood, "f").size());
  EXPECT_EQ("f#2", parse_cases(kGood + kGood, "f")[1].name);
}

TEST(Case, OneThatCannotBeReadDoesNotHideTheOthers) {
  const auto cases =
      parse_cases(kGood + "\n{\"a\":[[0,0],\n" + kGood + "\n{\"a\":1}\n" + kGood, "f");
  ASSERT_EQ(5u, cases.size());
  EXPECT_TRUE(cases[0].value);
  EXPECT_FALSE(cases[1].value);
  EXPECT_TRUE(cases[2].value);
  EXPECT_FALSE(cases[3].value);
  EXPECT_TRUE(cases[4].value);
}

struct Bad {
  std::string text;
  std::string place;  ///< line:column
  std::string what;   ///< Part of the message.
};

TEST(Case, ProblemsHaveTheirPlace) {
  const Bad bads[] = {
      {"", "1:1", "no case"},
      {"  \n ", "2:2", "no case"},
      {"[]", "1:1", "no case"},
      {"3", "1:1", "a case is a number"},
      {"nonsense", "1:2", "not JSON"},
      {"{\"a\":[[0,0]],\n \"b\":[[1,]]}", "2:10", "not JSON"},
      {R"({"b":[[1,1]]})", "1:1", "/a is missing"},
      {R"({"a":[[0,0]],"b":[]})", "1:18", "/b is empty"},
      {R"({"a":[[0,0]],"b":7})", "1:18", "/b is a number"},
      {R"({"a":[[0,0]],"b":null})", "1:18", "/b is null"},
      {R"({"é":1,"a":[[0,0]],"b":7})", "1:24", "/b is a number"},
      {"{\"a\":[[0,0]],\n\"b\":[[1,1],\n[1,2,3]]}", "3:1", "/b/1 has 3 coordinates"},
      {R"({"a":[[0,0]],"b":[4]})", "1:19", "/b/0 is a number"},
      {R"({"a":[[0,"zero"]],"b":[[1,1]]})", "1:10", "/a/0/1 is \"zero\""},
      {R"({"a":[[0,"nan"]],"b":[[1,1]]})", "1:10", "/a/0/1 is \"nan\""},
      {R"({"a":[[0,"inf"]],"b":[[1,1]]})", "1:10", "/a/0/1 is \"inf\""},
      {R"({"a":[[0,"1e999"]],"b":[[1,1]]})", "1:10", "/a/0/1"},
      {R"({"a":[[0,1e999]],"b":[[1,1]]})", "1:10", "1e999 is too large"},
      {R"({"a":[[0,true]],"b":[[1,1]]})", "1:10", "/a/0/1 is true"},
      {R"({"a":[[NaN,0]],"b":[[1,1]]})", "1:8", "not JSON"},
      {R"({"dimension":3,"a":[[0,0,0]],"b":[[1,1,1]]})", "1:14", "/dimension is 3"},
      {R"({"dimension":"2","a":[[0,0]],"b":[[1,1]]})", "1:14", "/dimension is \"2\""},
  };
  for (const Bad& bad : bads) {
    SCOPED_TRACE(bad.text);
    const ReadCase read = only(bad.text);
    EXPECT_FALSE(read.value);
    ASSERT_FALSE(read.problems.empty());
    const Problem& problem = read.problems.front();
    EXPECT_EQ(bad.place, std::to_string(problem.line) + ":" + std::to_string(problem.column));
    EXPECT_NE(std::string::npos, problem.what.find(bad.what)) << problem.what;
    EXPECT_FALSE(problem.expected.empty());
    EXPECT_EQ("f.json", problem.file);
  }
}

TEST(Case, IsInSpaceWhereThatIsAskedFor) {
  const std::string text = R"({"dimension":3,"a":[[0,0,0]],"b":[[3,4,"0x1p-3"],[5,6,7]]})";
  const ReadCase read = parse_cases(kGood + "\n" + text, "f.json", 3)[1];
  ASSERT_TRUE(read.in_space);
  EXPECT_FALSE(read.value);
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(2, read.place.line);
  EXPECT_EQ(Eigen::Vector3d(0, 0, 0), read.in_space->a[0]);
  EXPECT_EQ(Eigen::Vector3d(3, 4, 0.125), read.in_space->b[0]);

  const std::pair<const char*, const char*> bads[] = {
      {R"({"dimension":3,"a":[[0,0]],"b":[[1,1,1]]})", "three coordinates, [x, y, z]"},
      {R"({"dimension":2,"a":[[0,0]],"b":[[1,1,1]]})", "\"dimension\": 3"},
      {R"({"a":[[0,0,0]],"b":[[1,1,1]]})", "\"dimension\": 3"},
      {R"({"dimension":4,"a":[[0,0]],"b":[[1,1]]})", "2, the plane, or 3, space"},
      {R"({"dimension":3,"a":[],"b":[[1,1,1]]})", "[[x, y, z], ...]"},
  };
  for (const auto& [bad, expected] : bads) {
    const ReadCase refused = parse_cases(bad, "f.json", 3).front();
    EXPECT_FALSE(refused.value || refused.in_space) << bad;
    ASSERT_FALSE(refused.problems.empty()) << bad;
    EXPECT_NE(std::string::npos, refused.problems.front().expected.find(expected))
        << bad << ": " << refused.problems.front().expected;
  }
}

TEST(Case, AllProblemsOfOneAreToldAtOnce) {
  EXPECT_EQ(3u, only(R"({"a":[["x","y"],[1]],"b":[[1,1]]})").problems.size());
}

TEST(Case, MutatedTextsAreReadOrRefusedNeverHalf) {
  constexpr std::uint32_t kSeed = 77;
  std::mt19937 random(kSeed);
  const std::string original =
      "{\"name\":\"n\",\"dimension\":2,\"a\":[[0.5,\"0x1p3\"],[1e5,-2]],\n"
      "\"b\":[[3,4],[5,6]],\"note\":\"\\u00e9\\\"\"}\n" +
      kGood + "\n";
  const std::string alphabet = "{}[],:\"\\0129.-+eExXpPnul \n\t\xC3\xFF";
  int refused = 0;
  int accepted = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = original;
    for (int k = static_cast<int>(random() % 4); k >= 0 && !text.empty(); --k) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text.erase(at, 1 + random() % 5);
          break;
        case 1:
          text.insert(at, 1, alphabet[random() % alphabet.size()]);
          break;
        case 2:
          text[at] = alphabet[random() % alphabet.size()];
          break;
        default:
          text.resize(at);
      }
    }
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " text " << i << ": " << text);
    const std::vector<ReadCase> cases = parse_cases(text, "f");
    ASSERT_FALSE(cases.empty());
    for (const ReadCase& read : cases) {
      ASSERT_EQ(read.problems.empty(), read.value.has_value());
      ++(read.value ? accepted : refused);
      for (const Problem& problem : read.problems) {
        ASSERT_GE(problem.line, 1);
        ASSERT_GE(problem.column, 1);
        ASSERT_FALSE(problem.what.empty());
      }
      if (read.value) {
        ASSERT_FALSE(read.value->a.empty());
        ASSERT_FALSE(read.value->b.empty());
      }
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(accepted, 500);
}

TEST(Case, MayEndAfterEachLetter) {
  const std::string text = R"([{"name": "n1", "a": [[0, 1], [2, 3]], "b": [[4, 5.5e0]]}])";
  for (std::size_t size = 0; size < text.size(); ++size) {
    const std::vector<ReadCase> cases = parse_cases(text.substr(0, size), "f");
    for (const ReadCase& read : cases) EXPECT_FALSE(read.problems.empty()) << size;
  }
}

TEST(Case, LongNonsenseIsRefusedQuickly) {
  EXPECT_LE(parse_cases(std::string(1000000, '['), "f").size(), 1u);
  EXPECT_LE(parse_cases(std::string(1000000, '{'), "f").size(), 1u);
  std::string broken;
  for (int i = 0; i < 10000; ++i) broken += "{\"a\":\n";
  EXPECT_LE(parse_cases(broken, "f").size(), 100u);
}

TEST(Case, MillionsOfFlawsOnOneLineAreReadOnce) {
  // Looking for the place of each from the start would take hours.
  constexpr std::size_t kMany = 300000;
  std::string points;
  std::string cases;
  for (std::size_t i = 0; i < kMany; ++i) {
    points += "0,";
    cases += R"({"a":[[0,0]],"b":0},)";
  }
  const ReadCase read = only(R"({"a":[)" + points + R"(0],"b":[[1,1]]})");
  EXPECT_EQ(20u, read.problems.size());
  EXPECT_EQ(7 + 2 * 19, read.problems.back().column);
  const std::vector<ReadCase> all = parse_cases("[" + cases + kGood + "]", "f.json");
  ASSERT_EQ(kMany + 1, all.size());
  EXPECT_EQ(2 + 20 * static_cast<int>(kMany), all.back().place.column);
  EXPECT_TRUE(all.back().value);
  EXPECT_EQ(all[kMany - 1].place.column + 17, all[kMany - 1].problems.front().column);
}

TEST(Case, BecomesALessonToTrace) {
  const Lesson lesson = lesson_of(*only(kGood).value, "n", ScalarKind::exact);
  EXPECT_EQ(ScalarKind::exact, lesson.scalar);
  EXPECT_EQ("x1", lesson.x().vertex_names[0]);
  EXPECT_EQ("y2", lesson.y().vertex_names[1]);
}

// ---- written ----

/// 0.0 and -0.0 differ.
void expect_same_bits(const std::vector<Vector2d>& points, const std::vector<Vector2d>& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 2; ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(points[i][k]),
                std::bit_cast<std::uint64_t>(expected[i][k]))
          << points[i][k] << " for " << expected[i][k];
    }
  }
}

TEST(CaseJson, IsOneLine) {
  const Case value{{Vector2d(0, -0.0)}, {Vector2d(3, 0.1), Vector2d(1e-7, 1e300)}};
  EXPECT_EQ(case_json(value, "two \"points\""),
            R"({"name": "two \"points\"", "dimension": 2, "a": [[0.0, -0.0]], )"
            R"("b": [[3.0, 0.1], [1e-07, 1e+300]]})"
            "\n");
  EXPECT_TRUE(case_json(value, "").starts_with(R"({"dimension": 2, "a")"));
  EXPECT_EQ(only(case_json(value, "two \"points\"\n")).name, "two \"points\"\n");
}

TEST(CaseJson, ReadsBackToTheSameBits) {
  std::mt19937_64 random(20100311);
  Case value;
  for (const double number : {0.0, -0.0, 0.1, 1e308, std::numeric_limits<double>::max(), 0x1p-1074,
                              -0x1.fffffffffffffp-1023, 0x1p-1022, 0x1p53 + 2.0, 1.0 / 3.0})
    value.a.emplace_back(number, -number);
  while (value.b.size() < 10000) {
    const Vector2d point(std::bit_cast<double>(random()), std::bit_cast<double>(random()));
    if (point.allFinite()) value.b.push_back(point);
  }
  const ReadCase read = only(case_json(value, "bits"));
  ASSERT_TRUE(read.value);
  EXPECT_EQ(read.name, "bits");
  expect_same_bits(read.value->a, value.a);
  expect_same_bits(read.value->b, value.b);
}

TEST(CaseOf, ARunIsTheShapesInTheWorld) {
  Lesson lesson = lesson_of({{Vector2d(1, 0)}, {Vector2d(2, 0), Vector2d(3, 1)}}, "placed",
                            ScalarKind::double_);
  lesson.x().translate = Eigen::Vector3d(10, 20, 0);
  lesson.x().rotate_degrees = 90.0;
  const Case placed = case_of(lesson);
  EXPECT_NEAR(placed.a[0].x(), 10.0, 1e-15);
  EXPECT_EQ(placed.a[0].y(), 21.0);
  expect_same_bits(placed.b, in_plane(lesson.y().vertices));
  for (const ScalarKind scalar :
       {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
    lesson.scalar = scalar;
    const Case from_run = case_of(run_lesson(lesson).runs[0]);
    expect_same_bits(case_of(lesson).a, from_run.a);
    expect_same_bits(case_of(lesson).b, from_run.b);
  }
}

TEST(CaseOf, AMovingLessonIsWhereItStarts) {
  Lesson lesson = lesson_of({{Vector2d(1, 0)}, {Vector2d(2, 0)}}, "moving", ScalarKind::double_);
  lesson.path_of_shapes.emplace().x().points = {Eigen::Vector3d(5, 6, 0), Eigen::Vector3d(7, 8, 0)};
  EXPECT_EQ(case_of(lesson).a[0], Vector2d(6, 6));
  EXPECT_EQ(case_of(run_lesson(lesson).runs[1]).a[0], Vector2d(8, 8));
}

}  // namespace case_test
}  // namespace gjkscope
