#include "picture/words.hpp"

#include <gtest/gtest.h>

#include "lesson/names.hpp"
#include "lessons.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace words_test {

TEST(Words, NumbersHaveATrueMinusAndNoNegativeZero) {
  EXPECT_EQ(fixed(-1.25, 2), "−1.25");
  EXPECT_EQ(fixed(-0.001, 2), "0.00");
  EXPECT_EQ(signed_fixed(0.5, 1), "+0.5");
  EXPECT_EQ(signed_fixed(0.0, 1), "0.0");
}

TEST(Words, DigitsOfLargeNumbersAreGrouped) {
  EXPECT_EQ(grouped(999.4), "999");
  EXPECT_EQ(grouped(1000.0), "1,000");
  EXPECT_EQ(grouped(-12345.6), "−12,346");
  EXPECT_EQ(grouped(1e12), "1,000,000,000,000");
}

TEST(Words, SumsAddUpAsTheyAreWrittenOrSayThatTheyAreRounded) {
  EXPECT_TRUE(adds_up({"+1.053", "+0.401", "−0.454"}, "1.000"));
  EXPECT_TRUE(adds_up({"0.1", "0.2"}, "0.3"));
  EXPECT_FALSE(adds_up({"+1.996", "+0.098", "−1.093"}, "1.000"));
  EXPECT_FALSE(adds_up({"0.28366947", "0.71633047"}, "1"));
  EXPECT_EQ(difference_as_written("2.367", "1.181", "1.186"), "2.367 − 1.181 = 1.186");
  EXPECT_EQ(difference_as_written("3.612", "0.478", "3.135"),
            "3.612 − 0.478 = 3.135 up to rounding");
}

TEST(Words, FloatLessonsPrintTheDigitsOfTheSlides) {
  Lesson lesson;
  lesson.scalar = ScalarKind::single;
  const Numbers numbers(lesson);
  EXPECT_EQ(numbers(static_cast<double>(3.2457051e-06F)), "3.2457051·10⁻⁶");
  EXPECT_EQ(numbers.point(Eigen::Vector2d(static_cast<double>(-0.021008447F), -0.0)),
            "(−0.021008447, 0)");
}

TEST(Words, HalfLessonsPrintAllDigitsThatTellValuesApart) {
  Lesson lesson;
  lesson.scalar = ScalarKind::half;
  const Numbers numbers(lesson);
  EXPECT_EQ(numbers(-26.375), "−26.375");
  EXPECT_EQ(numbers(10736.0), "10736");
  EXPECT_EQ(numbers(-0.09375), "−0.09375");
}

TEST(Words, PointsHaveDigitsThatCount) {
  const Numbers numbers{Lesson()};
  EXPECT_EQ(numbers.point(Eigen::Vector2d(0.5, -1.25)), "(0.50, −1.25)");
  EXPECT_EQ(numbers.point(Eigen::Vector2d(0.0, 0.0)), "(0.00, 0.00)") << "it is zero";
  EXPECT_EQ(numbers.point(Eigen::Vector2d(0.25, 1e-9)), "(0.25, 0.00)");
  EXPECT_EQ(numbers.point(Eigen::Vector2d(0.0, 1e-4)), "(0.00, 1.00)·10⁻⁴");
  EXPECT_EQ(numbers.point(Eigen::Vector2d(-2.5e-17, 1e-18)), "(−2.50, 0.10)·10⁻¹⁷");
  EXPECT_EQ(numbers.point(Eigen::Vector2d(1.5e7, 0.0)), "(1.50, 0.00)·10⁷");
  EXPECT_EQ(numbers.weight(0.25), "0.250");
  EXPECT_EQ(numbers.weight(0.0), "0.000");
  EXPECT_EQ(numbers.weight(1.24e-9), "1.2·10⁻⁹");
}

TEST(Words, AnEdgeThatARunStartsWithHasItsDirection) {
  const LessonRun right = run_lesson(testing::shipped_lesson("stop-edge-right"));
  for (const Frame& frame : {right.frames.front(), right.frames.back()}) {
    const SimplexWords words(right, right.state(frame).simplex);
    EXPECT_EQ(words.face(0b011), "DC");
  }
  const LessonRun pentagon = run_lesson(testing::shipped_lesson("polygon-evolution"));
  for (const Frame& frame : pentagon.frames) {
    const auto& simplex = pentagon.state(frame).simplex;
    if (simplex.count != 2) continue;
    EXPECT_NE(SimplexWords(pentagon, simplex).face(0b011), "EC") << "others by the alphabet";
  }
}

TEST(Words, ThePhaseThatDropsVerticesIsCalledSo) {
  EXPECT_EQ(name_of(gjk::Phase::drop), "drop");
  EXPECT_EQ(name_of(gjk::Phase::support), "support");
}

TEST(Words, TheThirdEdgeOfATriangleIsCA) {
  const LessonRun run = run_lesson(testing::shipped_lesson("triangle-ordered-test"));
  const SimplexWords words(run, run.state(run.frames[0]).simplex);
  EXPECT_EQ(words.face(0b101), "CA");
  EXPECT_EQ(words.coordinate(0b101, 2), "uCA");
  EXPECT_EQ(words.coordinate(0b101, 0), "vCA");
  EXPECT_EQ(words.coordinate(0b111, 2), "wABC");
}

TEST(Words, VerticesOfADifferenceNameBothTheirVertices) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygons-gjk"));
  EXPECT_EQ(run.pair_name({2, 3}), "N−C");
}

}  // namespace words_test
}  // namespace gjkscope
