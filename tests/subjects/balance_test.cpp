#include "subjects/balance/balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lessons.hpp"
#include "subjects/balance/table.hpp"
#include "subjects/subjects.hpp"
#include "subjects/weights/projection.hpp"

namespace gjkscope {
namespace balance_test {

using Eigen::Vector2d;

const LessonTime kTime{6.0, 61};
/// How far the beam hangs below its axle at the end of an arm: negative where it is higher.
double below_axle(double arm, double angle) {
  return kAxleHeight * std::cos(angle) - arm * std::sin(angle);
}
constexpr double kGround = kAxleHeight + kBeamHeight;  // below the axle

/// The tilt at which a mass on an arm touches the ground, by bisection.
double down(double arm, double mass) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (below_axle(-arm, middle) + radius_of_mass(mass) < kGround ? low : high) = middle;
  }
  return low;
}

constexpr double kLevel = 0.5 * 3.14159265358979 / 180.0;

TEST(Swing, EqualMassesStayLevel) {
  for (const Beam& beam : swing({0.5, 0.5}, 0.5, kTime)) {
    EXPECT_EQ(beam.angle, 0.0);
    EXPECT_EQ(beam.support, 0.5);
  }
}

TEST(Swing, TheHeavierEndGoesDownAndComesBackWhenTheSupportReachesTheBalancePoint) {
  for (const double v : {0.1, 0.25, 0.4, 0.6, 0.9}) {
    const std::vector<Beam> ticks = swing({1.0 - v, v}, v, kTime);
    const double side = v < 0.5 ? 1.0 : -1.0;
    EXPECT_NEAR(ticks[20].angle, side * down(0.5, std::max(v, 1.0 - v)), 1e-12)
        << "on the ground after two seconds, v = " << v;
    EXPECT_DOUBLE_EQ(ticks.back().support, v);
    EXPECT_LT(std::abs(ticks.back().angle), kLevel) << "level at the end, v = " << v;
    EXPECT_LT(std::abs(ticks.back().rate), kLevel) << "at rest at the end, v = " << v;
  }
}

TEST(Swing, WithoutTheMassThatWouldHaveToBeNegativeTheBeamTips) {
  for (const double v : {1.05, 1.25, 1.8}) {
    const std::vector<Beam> ticks = swing({0.0, v}, v, kTime);
    EXPECT_LT(ticks[20].angle, -kLevel) << "B is down on the middle";
    EXPECT_NEAR(ticks.back().angle, down(v, 0.0), 1e-12) << "A is down, v = " << v;
  }
}

TEST(Swing, NoEndSinksIntoTheGround) {
  for (double v = -0.9; v < 2.0; v += 0.1) {
    const std::array<double, 2> masses = {std::max(0.0, 1.0 - v), std::max(0.0, v)};
    for (const Beam& beam : swing(masses, v, kTime)) {
      for (int i = 0; i < 2; ++i) {
        EXPECT_LE(below_axle(i - beam.support, beam.angle) + radius_of_mass(masses[i]),
                  kGround + 1e-12)
            << "v = " << v;
      }
    }
  }
}

TEST(Swing, ABeamThatSwingsBackComesToRestWithoutPassingLevel) {
  for (const double v : {0.2, 0.25, 0.75}) {
    const double side = v < 0.5 ? 1.0 : -1.0;
    for (const Beam& beam : swing({1.0 - v, v}, v, kTime))
      EXPECT_GT(side * beam.angle, -0.1 * kLevel) << "v = " << v << " at " << beam.seconds;
  }
}

TEST(Swing, AMomentBetweenTwoStepsIsNoStepOfTheSimulation) {
  const LessonTime between{6.0, 0, {{0.1, 1.0 / 3.0, 2.6, 6.0}}};
  const std::vector<Beam> coarse = swing({0.8, 0.2}, 0.2, between);
  const std::vector<Beam> fine = swing({0.8, 0.2}, 0.2, between, 0, 0x1p-14);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_NEAR(coarse[i].angle, fine[i].angle, 2e-5) << "at " << coarse[i].seconds;
    EXPECT_DOUBLE_EQ(coarse[i].seconds, between.moments[0][i]);
  }
  EXPECT_EQ(coarse.back().angle, swing({0.8, 0.2}, 0.2, {6.0, 3}).back().angle);
}

TEST(Arms, AreMeasuredAcrossFromTheAxle) {
  Beam beam;
  beam.support = 0.2;
  EXPECT_EQ(arms_of(beam), (std::array<double, 2>{0.2, 0.8}));
  beam.angle = 0.5;  // A is down: both ends move towards B's side
  const auto& [a, b] = arms_of(beam);
  EXPECT_DOUBLE_EQ(a + b, std::cos(0.5));
  EXPECT_DOUBLE_EQ(a, 0.2 * std::cos(0.5) - kAxleHeight * std::sin(0.5));
  EXPECT_LT(0.8 * a, 0.2 * b) << "the beam swings back";
  beam.angle = 0.0;
  beam.support = 1.2;
  EXPECT_LT(arms_of(beam)[1], 0.0) << "B is on A's side";
}

TEST(Swing, IsTheSameHoweverOftenOneLooks) {
  const std::vector<Beam> often = swing({0.7, 0.3}, 0.3, {6.0, 25});
  const std::vector<Beam> seldom = swing({0.7, 0.3}, 0.3, {6.0, 7});
  for (std::size_t i = 0; i < seldom.size(); ++i) {
    EXPECT_EQ(seldom[i].angle, often[4 * i].angle);
    EXPECT_EQ(seldom[i].rate, often[4 * i].rate);
  }
}

TEST(Balance, IsSimulatedOnceForEachPositionAndOnlyInTime) {
  const LessonRun run = run_lesson(testing::shipped_lesson("segment-balance"));
  EffectGraph graph(run);
  for (const Frame& frame : run.frames) {
    const Balance::Value& value = graph.get<Balance>(frame);
    ASSERT_EQ(value.moments.size(), run.lesson.settings.as<LessonTime>()->at(frame.run).size());
    EXPECT_DOUBLE_EQ(value.moments[*beam_moment(run, frame)].seconds, seconds_of(run, frame));
    EXPECT_GE(value.masses[0], 0.0);
    EXPECT_GE(value.masses[1], 0.0);
  }
  EXPECT_EQ(graph.count("balance").runs, static_cast<long>(run.runs.size()));
  const LessonRun still = run_lesson(testing::shipped_lesson("segment-closest"));
  EffectGraph without(still);
  EXPECT_TRUE(without.get<Balance>(still.frames[0]).moments.empty());
}

TEST(Balance, WhatFramesShowOfItDoesNotDependOnTheStep) {
  Lesson lesson = testing::shipped_lesson("segment-balance");
  // More moments than the lesson shows.
  const std::vector<double> swinging = {0.0, 0.15, 0.75, 2.25, 2.5, 3.0, 3.5, 4.0, 6.0};
  lesson.settings.edit<LessonTime>().moments = {
      {0.0, 3.0}, swinging, swinging, {0.0, 0.15, 0.75, 2.25, 2.5, 2.75, 2.9, 3.05, 4.0}};
  const LessonRun run = run_lesson(std::move(lesson));
  EffectGraph graph(run);
  int tilted = 0;
  for (const Frame& frame : run.frames) {
    if (*beam_moment(run, frame) > 0) continue;
    const Balance::Value& value = graph.get<Balance>(frame);
    const std::vector<Beam> fine = swing(value.masses, value.weights[1],
                                         *run.lesson.settings.as<LessonTime>(), frame.run, 0x1p-16);
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const auto tenths = [](double angle) {
        return std::lround(angle * 1800.0 / 3.14159265358979);
      };
      EXPECT_EQ(tenths(value.moments[i].angle), tenths(fine[i].angle))
          << "position " << frame.run + 1 << " at " << fine[i].seconds;
      const auto thousandths = [](const Beam& beam) {
        const auto& [a, b] = arms_of(beam);
        return std::array<long, 2>{std::lround(1000.0 * a), std::lround(1000.0 * b)};
      };
      EXPECT_EQ(thousandths(value.moments[i]), thousandths(fine[i]));
      tilted += tenths(fine[i].angle) != 0;
    }
  }
  EXPECT_GE(tilted, 15);
}

TEST(Balance, EachFrameShowsAnotherBeamAndTheLastOfEachPositionOneAtRest) {
  const LessonRun run = run_lesson(testing::shipped_lesson("segment-balance"));
  EffectGraph graph(run);
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const Frame& frame = run.frames[i];
    const Balance::Value& value = graph.get<Balance>(frame);
    const Beam& beam = value.moments[static_cast<std::size_t>(*beam_moment(run, frame))];
    const bool is_last = i + 1 == run.frames.size() || run.frames[i + 1].run != frame.run;
    if (is_last) {
      constexpr double kShown = 0.1 * kLevel;  // prints as 0.0 degrees
      EXPECT_TRUE(beam.on_ground || std::abs(beam.angle) < kShown) << i;
      EXPECT_LT(std::abs(beam.rate), kLevel) << i;
    } else if (value.masses[0] != value.masses[1]) {
      const Beam& next = value.moments[static_cast<std::size_t>(*beam_moment(run, frame)) + 1];
      EXPECT_GT(std::abs(next.angle - beam.angle), kLevel) << "frame " << i + 2;
    }
  }
}

TEST(UnitVector, GivesTheSameLengthsFromGAndFromQ) {
  const LessonRun run = run_lesson(testing::shipped_lesson("segment-barycentric"));
  EffectGraph graph(run);
  int outside = 0;
  for (const Frame& frame : run.frames) {
    const UnitVector::Value& built = graph.get<UnitVector>(frame);
    const Projection::Value& g = graph.get<Projection>(frame);
    ASSERT_TRUE(built && g);
    EXPECT_NEAR(built->n.norm(), 1.0, 1e-15);
    EXPECT_NEAR(built->n.dot(*g), 0.0, 1e-12) << "Q - G is normal to n";
    EXPECT_NEAR(built->of_g.to_b, built->of_q.to_b, 1e-12);
    EXPECT_NEAR(built->of_g.from_a, built->of_q.from_a, 1e-12);
    EXPECT_NEAR(built->of_g.to_b + built->of_g.from_a, built->length, 1e-12);
    outside += built->of_g.to_b < 0.0 || built->of_g.from_a < 0.0;
  }
  EXPECT_GE(outside, 3) << "G leaves the segment at both ends";
}

TEST(Projection, AVertexOrATriangleHasNone) {
  for (const char* id : {"polygon-evolution", "triangle-features"}) {
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    EffectGraph graph(run);
    EXPECT_FALSE(graph.get<Projection>(run.frames[0]));
    EXPECT_FALSE(graph.get<UnitVector>(run.frames[0]));
  }
}

}  // namespace balance_test
}  // namespace gjkscope
