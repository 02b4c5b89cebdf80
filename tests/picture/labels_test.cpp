#include "picture/labels.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <vector>

#include "picture/text_box.hpp"

namespace gjkscope {
namespace labels_test {

class Labels : public ::testing::Test {
 protected:
  Fonts fonts{std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml"};
  LabelPlacer placer{fonts, Rect{{0.0, 0.0}, {400.0, 300.0}}};

  static LabelRequest request(const std::string& id, const Point& anchor, const Point& towards) {
    return {id, "label", "role", type::kVertex, anchor, 8.0, towards, false};
  }
  static Point center(const Mark& mark) { return std::get<Text>(mark.shape).at; }
};

TEST_F(Labels, StandOnThePreferredSideWhenItIsFree) {
  placer.begin_frame({});
  EXPECT_GT(center(placer.place(request("a", {200.0, 150.0}, {1.0, 0.0}), false)).x(), 210.0);
  EXPECT_LT(center(placer.place(request("b", {100.0, 150.0}, {-1.0, 0.0}), false)).x(), 90.0);
}

TEST_F(Labels, AvoidLinesAndEachOther) {
  Obstacles obstacles;
  obstacles.segments.push_back({{200.0, 150.0}, {400.0, 150.0}});
  placer.begin_frame(obstacles);
  const Point first = center(placer.place(request("a", {200.0, 150.0}, {1.0, 0.0}), false));
  EXPECT_GT(std::abs(first.y() - 150.0), 4.0) << "not on the line";
  const Point second = center(placer.place(request("b", {200.0, 150.0}, {1.0, 0.0}), false));
  EXPECT_GT((first - second).norm(), 14.0);
}

TEST_F(Labels, RatherStandCloseToAnotherThanOnIt) {
  const double height = fonts.cap_height(type::kVertex) + 0.22 * type::kVertex.size;
  const Rect other{{0.0, height + 8.0}, {400.0, 2.0 * height + 16.0}};
  LabelPlacer low(fonts, Rect{{0.0, 0.0}, other.max});
  low.begin_frame({});
  low.reserve(other);
  LabelRequest label = request("a", {200.0, other.min.y()}, {0.0, 1.0});
  label.gap = 3.0;
  const Mark mark = low.place(label, false);
  EXPECT_FALSE(overlap(box_of(fonts, std::get<Text>(mark.shape)), other));
}

TEST_F(Labels, StayInsideTheStage) {
  placer.begin_frame({});
  const Mark mark = placer.place(request("a", {398.0, 150.0}, {1.0, 0.0}), false);
  EXPECT_LT(center(mark).x() + 0.5 * fonts.width(type::kVertex, "label"), 400.0);
}

TEST_F(Labels, KeepTheirPlaceFromFrameToFrameWhileItIsFree) {
  Obstacles obstacles;
  obstacles.segments.push_back({{200.0, 150.0}, {400.0, 150.0}});
  placer.begin_frame(obstacles);
  const Point first = center(placer.place(request("a", {200.0, 150.0}, {1.0, 0.0}), false));
  placer.begin_frame({});  // the preferred side is free now, but moving would cost the eye more
  EXPECT_EQ(center(placer.place(request("a", {200.0, 150.0}, {1.0, 0.0}), false)), first);
}

TEST_F(Labels, ThatHadToGoFarAwayComeBackOnceThereIsRoom) {
  Obstacles crowd;
  for (double x = 150.0; x <= 250.0; x += 10.0) crowd.segments.push_back({{x, 100.0}, {x, 200.0}});
  placer.begin_frame(crowd);
  const Point anchor(200.0, 150.0);
  const auto distance = [&] {
    return (center(placer.place(request("a", anchor, {1.0, 0.0}), false)) - anchor).norm();
  };
  EXPECT_GT(distance(), 50.0);
  placer.begin_frame({});
  EXPECT_LT(distance(), 40.0);
}

TEST_F(Labels, WithAPlaceForAllFramesStepAsideForALineOnlyWhereTheyMay) {
  Obstacles crossed;
  crossed.passing.push_back({{0.0, 150.0}, {400.0, 150.0}});
  for (const bool may : {false, true}) {
    LabelRequest label = request(may ? "may" : "may not", {200.0, 150.0}, {1.0, 0.0});
    label.steps_aside = may;
    placer.begin_frame({});
    const Point home = center(placer.place(label, true));
    placer.begin_frame(crossed);
    EXPECT_EQ(center(placer.place(label, true)) == home, !may);
    placer.begin_frame({});
    EXPECT_EQ(center(placer.place(label, true)), home) << "back once the line is gone";
  }
}

TEST_F(Labels, RatherTakeAnotherSideThanStandNearerToAnotherMark) {
  const Point anchor(150.0, 150.0);
  const double width = fonts.width(type::kVertex, "label");
  Obstacles obstacles;
  obstacles.circles.push_back({anchor, 30.0});  // the label has to be that far away
  placer.begin_frame(obstacles);
  const double right = center(placer.place(request("a", anchor, {1.0, 0.0}), false)).x();
  EXPECT_GT(right, anchor.x() + 30.0);
  const Point other(right + 0.5 * width + 20.0, 150.0);
  obstacles.circles.push_back({other, 5.0});
  placer.begin_frame(obstacles);
  const Point moved = center(placer.place(request("b", anchor, {1.0, 0.0}), false));
  EXPECT_LT(moved.x(), right);
}

TEST_F(Labels, FarFromWhatTheyNameHaveALineThatLeadsThere) {
  const LabelRequest label = request("a", {200.0, 150.0}, {1.0, 0.0});
  const double limit = label.gap + kLeaderFrom;
  const auto leader = [&](double x) {
    return leader_line(label, Rect{{x, 140.0}, {x + 40.0, 160.0}});
  };
  EXPECT_FALSE(leader(200.0 + limit - 0.5));
  const auto line = leader(200.0 + limit + 0.5);
  ASSERT_TRUE(line);
  for (const Point& end : {line->a, line->b}) {
    EXPECT_GT(end.x(), 200.0);
    EXPECT_LT(end.x(), 200.0 + limit + 0.5);
  }
}

TEST_F(Labels, KeepOffALineThatLeadsToAnother) {
  placer.begin_frame({});
  placer.avoid({{0.0, 136.0}, {400.0, 136.0}});
  EXPECT_GT(center(placer.place(request("a", {200.0, 150.0}, {0.0, -1.0}), false)).y(), 140.0);
}

TEST_F(Labels, KeepTheirDistanceWhenTheirTextGetsShorter) {
  LabelRequest label = request("a", {200.0, 150.0}, {1.0, 0.0});
  const auto gap = [&](const std::string& text) {
    label.text = text;
    placer.begin_frame({});
    const Mark mark = placer.place(label, false);
    return center(mark).x() - 0.5 * fonts.width(type::kVertex, text) - 200.0;
  };
  EXPECT_DOUBLE_EQ(gap("P = Q"), gap("Q"));
}

TEST_F(Labels, StandOnTheSideOfALineThatWhatTheyNameIsOn) {
  Obstacles obstacles;
  obstacles.segments.push_back({{0.0, 140.0}, {400.0, 140.0}});
  placer.begin_frame(obstacles);
  EXPECT_GT(center(placer.place(request("a", {200.0, 150.0}, {0.0, -1.0}), false)).y(), 140.0);
}

TEST_F(Labels, OfAnAreaKeepAwayFromMarksThatHaveNamesOfTheirOwn) {
  Obstacles obstacles;
  obstacles.circles.push_back({{100.0, 50.0}, 5.0});
  placer.begin_frame(obstacles);
  const std::vector<Point> wide = {{0.0, 0.0}, {200.0, 0.0}, {200.0, 100.0}, {0.0, 100.0}};
  const auto marks = placer.place_inside({"a", "label", "role", type::kRegion, wide, {}});
  ASSERT_EQ(marks.size(), 1u);
  const Point from = center(marks[0]) - Point(100.0, 50.0);
  const double half = 0.5 * fonts.width(type::kRegion, "label");
  EXPECT_TRUE(std::abs(from.x()) > half + 18.0 || std::abs(from.y()) > 22.0);
}

TEST_F(Labels, OfAnAreaStandInItOrNowhere) {
  placer.begin_frame({});
  const std::vector<Point> wide = {{0.0, 0.0}, {200.0, 0.0}, {200.0, 100.0}, {0.0, 100.0}};
  const std::vector<Mark> marks =
      placer.place_inside({"a", "label", "role", type::kRegion, wide, {}});
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_GT(center(marks[0]).y(), 0.0);
  EXPECT_LT(center(marks[0]).y(), 100.0);
  const std::vector<Point> thin = {{0.0, 200.0}, {200.0, 200.0}, {200.0, 206.0}, {0.0, 206.0}};
  EXPECT_TRUE(placer.place_inside({"b", "label", "role", type::kRegion, thin, {}}).empty());
}

/// A field answers as if it asked each obstacle.
TEST(Field, FindsAllThatABoxMeets) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(-150.0, 550.0);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto point = [&] { return Point(place(random), place(random)); };
  Field<Obstacles::Segment> segments({{0.0, 0.0}, {400.0, 300.0}});
  Field<Obstacles::Circle> circles({{0.0, 0.0}, {400.0, 300.0}});
  std::vector<Obstacles::Segment> all_segments;
  std::vector<Obstacles::Circle> all_circles;
  for (int i = 0; i < 300; ++i) {
    const Point a = point();
    const Point b = i % 3 == 0 ? Point(a + Point(3.0, 2.0)) : point();
    all_segments.push_back({a, i % 7 == 0 ? Point(b.x(), a.y()) : b});
    all_circles.push_back({point(), 12.0 * part(random)});
  }
  segments.add(all_segments);
  circles.add(all_circles);
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    const Point corner = point();
    const Rect box{corner, corner + Point(60.0 * part(random), 20.0 * part(random))};
    for (const Obstacles::Segment& segment : all_segments) {
      // A point of it in the box, if there is one at hand.
      const Point at = segment.a + part(random) * (segment.b - segment.a);
      if ((at.array() < box.min.array()).any() || (at.array() > box.max.array()).any()) continue;
      ++met;
      EXPECT_TRUE(segments.any_near(box, [&](const auto& item) { return item.shape == segment; }));
    }
    for (const Obstacles::Circle& circle : all_circles) {
      if (!overlap(box, circle.box())) continue;
      ++met;
      EXPECT_TRUE(circles.any_near(box, [&](const auto& item) { return item.shape == circle; }));
    }
  }
  EXPECT_GT(met, 150);
}

TEST(Field, CountsEqualOnesAndAsksEachOnce) {
  Field<Obstacles::Segment> field({{0.0, 0.0}, {400.0, 300.0}});
  const std::vector<Obstacles::Segment> lines = {{{0.0, 0.0}, {400.0, 300.0}},
                                                 {{10.0, 300.0}, {390.0, 0.0}}};
  for (int i = 0; i < 3; ++i) field.add(lines);
  std::vector<int> counts;
  EXPECT_FALSE(field.any_near({{0.0, 0.0}, {400.0, 300.0}}, [&](const auto& item) {
    counts.push_back(item.count);
    return false;
  }));
  EXPECT_EQ(counts, (std::vector<int>{3, 3}));
}

}  // namespace labels_test
}  // namespace gjkscope
