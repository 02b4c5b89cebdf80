#include "oracle.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gjkscope {
namespace {

std::vector<RationalPoint> points(std::initializer_list<std::pair<double, double>> list) {
  std::vector<RationalPoint> out;
  for (const auto& [x, y] : list) out.push_back(rational(x, y));
  return out;
}

TEST(Oracle, KnownAnswers) {
  const auto square = points({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  EXPECT_EQ(Rational(4), exact_answer(square, points({{3, 0}})).distance_sq);
  EXPECT_EQ(Rational(2), exact_answer(square, points({{2, 2}, {3, 2}, {2, 3}})).distance_sq);
  EXPECT_EQ(Rational(1, 2), exact_answer(points({{0, 0}}), points({{1, 0}, {0, 1}})).distance_sq);
  const ExactAnswer apart = exact_answer(points({{0, 0}}), points({{1, 0}, {0, 1}}));
  EXPECT_FALSE(apart.overlap);
  EXPECT_FALSE(apart.touching);
  EXPECT_EQ(Rational(1, 2), apart.y[0]);
}

TEST(Oracle, TouchingIsAnOverlapWithoutDepth) {
  const auto square = points({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  for (const auto& other : {points({{1, 1}}), points({{1, 0}}), points({{1, 0}, {5, 0}}),
                            points({{1, -3}, {1, 3}, {4, 0}}), points({{2, 0}, {0, 2}})}) {
    const ExactAnswer answer = exact_answer(square, other);
    EXPECT_TRUE(answer.overlap);
    EXPECT_TRUE(answer.touching);
    EXPECT_EQ(Rational(0), answer.distance_sq);
  }
  for (const auto& other : {points({{0, 0}}), square, points({{0.999, 0}, {5, 0}})}) {
    const ExactAnswer answer = exact_answer(square, other);
    EXPECT_TRUE(answer.overlap);
    EXPECT_FALSE(answer.touching);
  }
  // Flat differences have no interior: crossing on one line is touching.
  EXPECT_TRUE(exact_answer(points({{0, 0}, {2, 0}}), points({{1, 0}, {3, 0}})).touching);
  EXPECT_FALSE(exact_answer(points({{-1, 0}, {1, 0}}), points({{0, -1}, {0, 1}})).touching);
}

TEST(Oracle, TellsADoubleFromItsNeighbour) {
  const auto square = points({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  EXPECT_FALSE(exact_answer(square, points({{std::nextafter(1.0, 2.0), 0}})).overlap);
  EXPECT_TRUE(exact_answer(square, points({{1.0, 0}})).overlap);
}

TEST(Oracle, ItsPairIsTheNearestByDualityToo) {
  std::mt19937_64 random(3);
  int separated = 0;
  for (int i = 0; i < 500; ++i) {
    std::vector<RationalPoint> x;
    std::vector<RationalPoint> y;
    for (int k = 0; k < 4; ++k) {
      x.push_back(rational(static_cast<int>(random() % 9), static_cast<int>(random() % 9)));
      y.push_back(rational(static_cast<int>(random() % 9) + 6, static_cast<int>(random() % 9)));
    }
    const ExactAnswer answer = exact_answer(x, y);
    if (answer.overlap) continue;
    ++separated;
    EXPECT_TRUE(is_nearest_pair(x, y, answer.x, answer.y));
    EXPECT_FALSE(is_nearest_pair(x, y, RationalPoint(answer.x - (answer.y - answer.x)), answer.y));
  }
  EXPECT_GT(separated, 150);
}

}  // namespace
}  // namespace gjkscope
