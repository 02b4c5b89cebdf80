#include "picture/plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <set>

#include "picture/text_box.hpp"

namespace gjkscope {
namespace plot_test {

const Fonts& fonts() {
  static const Fonts loaded(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  return loaded;
}

const Rect kArea{{100.0, 50.0}, {500.0, 350.0}};

Plot two_points() {
  Plot plot;
  plot.x = {1.0, 1e4, true, "n"};
  plot.y = {0.0, 10.0, false, "iterations"};
  plot.series = {{PlotStyle::first, "measured", {{1.0, 0.0}, {100.0, 5.0}}}};
  return plot;
}

template <class Shape>
std::vector<Shape> shapes(const std::vector<Mark>& marks, const std::string& role) {
  std::vector<Shape> out;
  for (const Mark& mark : marks) {
    const Shape* shape = std::get_if<Shape>(&mark.shape);
    if (mark.role == role && shape) out.push_back(*shape);
  }
  return out;
}

std::vector<std::string> labels(const std::vector<PlotTick>& ticks) {
  std::vector<std::string> out;
  for (const PlotTick& tick : ticks) out.push_back(tick.label);
  return out;
}

using Labels = std::vector<std::string>;

PlotAxis linear(double low, double high) { return {low, high, false, ""}; }
PlotAxis logarithmic(double low, double high) { return {low, high, true, ""}; }

TEST(PlotTicks, EqualStepsAreRound) {
  EXPECT_EQ(labels(plot_ticks(linear(0.0, 16.0), 9)),
            (Labels{"0", "2", "4", "6", "8", "10", "12", "14", "16"}));
  EXPECT_EQ(labels(plot_ticks(linear(0.0, 16.0), 5)), (Labels{"0", "5", "10", "15"}));
  EXPECT_EQ(labels(plot_ticks(linear(-0.25, 0.3), 6)),
            (Labels{"−0.2", "−0.1", "0.0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(labels(plot_ticks(linear(0.0, 2500.0), 3)), (Labels{"0", "1,000", "2,000"}));
}

TEST(PlotTicks, PowersOfTenAreWrittenOutWhileTheyAreShort) {
  EXPECT_EQ(labels(plot_ticks(logarithmic(1.0, 1e5), 12)),
            (Labels{"1", "10", "100", "1,000", "10,000", "100,000"}));
  EXPECT_EQ(labels(plot_ticks(logarithmic(0.01, 10.0), 12)), (Labels{"0.01", "0.1", "1", "10"}));
}

TEST(PlotTicks, LongerOnesAreRaisedAndSomeHaveALineAlone) {
  EXPECT_EQ(labels(plot_ticks(logarithmic(1.0, 1e12), 7)),
            (Labels{"1", "", "10²", "", "10⁴", "", "10⁶", "", "10⁸", "", "10¹⁰", "", "10¹²"}));
  EXPECT_EQ(labels(plot_ticks(logarithmic(1e-15, 1e-8), 4)),
            (Labels{"", "10⁻¹⁴", "", "10⁻¹²", "", "10⁻¹⁰", "", "10⁻⁸"}));
  EXPECT_EQ(labels(plot_ticks(logarithmic(1e-17, 1e4), 8)),
            (Labels{"10⁻¹⁵", "10⁻¹²", "10⁻⁹", "10⁻⁶", "10⁻³", "1", "10³"}))
      << "more lines alone would look like a pattern";
}

TEST(PlotTicks, FewPowersOfTenHaveTwoAndFiveBetweenThem) {
  EXPECT_EQ(labels(plot_ticks(logarithmic(1.0, 60.0), 12)),
            (Labels{"1", "2", "5", "10", "20", "50"}));
  EXPECT_EQ(labels(plot_ticks(logarithmic(3e-7, 1e-6), 12)), (Labels{"5·10⁻⁷", "10⁻⁶"}));
}

TEST(PlotTicks, LieOnTheAxisAndNumbersAreNoMoreThanAskedFor) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-12.0, 12.0);
  for (int i = 0; i < 1000; ++i) {
    const double a = exponent(random);
    const double b = exponent(random);
    const double low = std::pow(10.0, std::min(a, b));
    const double high = std::pow(10.0, std::max(a, b));
    const PlotAxis axis = i % 2 == 0 ? logarithmic(low, high) : linear(low, high);
    for (const int most : {2, 5, 12}) {
      const std::vector<PlotTick> ticks = plot_ticks(axis, most);
      std::set<std::string> numbers;
      int numbered = 0;
      for (const PlotTick& tick : ticks) {
        const double slack = 1e-6 * (axis.is_logarithmic ? tick.value : axis.high - axis.low);
        EXPECT_GE(tick.value, axis.low - slack);
        EXPECT_LE(tick.value, axis.high + slack);
        if (!tick.label.empty()) numbers.insert(tick.label), ++numbered;
      }
      EXPECT_LE(numbered, most);
      EXPECT_EQ(numbers.size(), static_cast<std::size_t>(numbered)) << "no number twice";
    }
  }
}

TEST(Plot, PointsStandWhereTheGridSaysTheyDo) {
  const std::vector<Mark> marks = plot_marks(two_points(), fonts(), kArea);
  const std::vector<Disk> points = shapes<Disk>(marks, "plot.first");
  const std::vector<Polyline> grid = shapes<Polyline>(marks, "chart.grid");
  ASSERT_EQ(points.size(), 3u) << "two, and the one before the name";
  const auto vertical = std::find_if(grid.begin(), grid.end(), [](const Polyline& line) {
    return line.points[0].x() == line.points[1].x();
  });
  ASSERT_EQ(grid.end() - vertical, 5) << "1 to 10,000";
  const std::vector<Polyline> rows(grid.begin(), vertical);
  EXPECT_NEAR(points[0].center.x(), vertical[0].points[0].x(), 1e-9) << "n = 1";
  EXPECT_NEAR(points[0].center.y(), rows.front().points[0].y(), 1e-9) << "y = 0";
  EXPECT_NEAR(points[1].center.x(), vertical[2].points[0].x(), 1e-9) << "n = 100";
  EXPECT_NEAR(points[1].center.y(), 0.5 * (rows.front().points[0].y() + rows.back().points[0].y()),
              1e-9);
}

TEST(Plot, SeriesDifferInSymbolAndRoleOfLine) {
  Plot plot = two_points();
  for (const PlotStyle style : {PlotStyle::second, PlotStyle::third, PlotStyle::fourth})
    plot.series.push_back({style, "", {{1.0, 2.0}, {100.0, 8.0}}});
  const std::vector<Mark> marks = plot_marks(plot, fonts(), kArea);
  EXPECT_EQ(shapes<Polygon>(marks, "plot.second").at(0).points.size(), 4u);
  EXPECT_EQ(shapes<Polygon>(marks, "plot.third").at(0).points.size(), 4u);
  EXPECT_EQ(shapes<Polygon>(marks, "plot.fourth").at(0).points.size(), 3u);
  for (const char* role :
       {"plot.first.line", "plot.second.line", "plot.third.line", "plot.fourth.line"})
    EXPECT_EQ(shapes<Polyline>(marks, role).size(), 1u) << role;
}

TEST(Plot, ValuesBeyondAnEndAreDrawnAtIt) {
  Plot plot = two_points();
  plot.series[0].points = {{0.0, -3.0}, {1e9, 30.0}};  // 0 has no logarithm
  const std::vector<Disk> points = shapes<Disk>(plot_marks(plot, fonts(), kArea), "plot.first");
  plot.series[0].points = {{1.0, 0.0}, {1e4, 10.0}};
  const std::vector<Disk> ends = shapes<Disk>(plot_marks(plot, fonts(), kArea), "plot.first");
  for (int i = 0; i < 2; ++i) EXPECT_EQ(points[i].center, ends[i].center);
}

TEST(Plot, TextsStayInTheAreaAndOffEachOther) {
  Plot plot = two_points();
  plot.bands = {{3.0, 6.0, "a band"}};
  plot.series.push_back({PlotStyle::second, "another one", {{1.0, 1.0}, {100.0, 5.2}}});
  plot.series.push_back({PlotStyle::third, "one more", {{1.0, 4.0}, {1e4, 4.5}}});
  plot.series.push_back({PlotStyle::fourth, "the last", {{1.0, 9.0}, {1e4, 4.6}}});
  std::vector<Rect> boxes;
  for (const Mark& mark : plot_marks(plot, fonts(), kArea)) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (!text) continue;
    const Rect box = box_of(fonts(), *text);
    EXPECT_TRUE((box.min.array() >= kArea.min.array() - 1e-9).all()) << text->text;
    EXPECT_TRUE((box.max.array() <= kArea.max.array() + 1e-9).all()) << text->text;
    for (const Rect& other : boxes) EXPECT_FALSE(overlap(box, other)) << text->text;
    boxes.push_back(box);
  }
  EXPECT_GE(boxes.size(), 5u + 5u + 2u);
}

TEST(Plot, ALastNumberThatStaysInTheAreaKeepsOffTheOneBefore) {
  Plot plot = two_points();
  plot.x = {1.0, 1e6, true, "n"};
  for (double right = 250.0; right < 900.0; right += 1.0) {
    double end = -1e9;
    for (const Text& text : shapes<Text>(
             plot_marks(plot, fonts(), {kArea.min, {right, kArea.max.y()}}), "body.muted")) {
      if (text.align != Align::center || text.text == plot.x.title) continue;
      const Rect box = box_of(fonts(), text);
      EXPECT_LT(end, box.min.x()) << text.text << " with " << right;
      EXPECT_LE(box.max.x(), right + 1e-9);
      end = box.max.x();
    }
  }
}

TEST(Plot, TheCurrentValueMovesNoName) {
  Plot plot = two_points();
  const auto name = [&] {
    return shapes<Text>(plot_marks(plot, fonts(), kArea), "plot.first.label").at(0).at;
  };
  EXPECT_TRUE(shapes<Polygon>(plot_marks(plot, fonts(), kArea), "plot.current").empty());
  const Point without = name();
  plot.current = 100.0;
  const std::vector<Mark> marks = plot_marks(plot, fonts(), kArea);
  const std::vector<Polygon> strip = shapes<Polygon>(marks, "plot.current");
  ASSERT_EQ(strip.size(), 1u);
  EXPECT_NEAR(0.5 * (strip[0].points[0].x() + strip[0].points[1].x()),
              shapes<Disk>(marks, "plot.first")[1].center.x(), 1e-9);
  EXPECT_EQ(name(), without);
}

TEST(Plot, StairsGoAlongTheXAxisFirst) {
  Plot plot = two_points();
  plot.series[0].join = PlotJoin::stairs;
  const auto lines = shapes<Polyline>(plot_marks(plot, fonts(), kArea), "plot.first.line");
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(lines[0].points.size(), 3u);
  EXPECT_EQ(lines[0].points[1].x(), lines[0].points[2].x());
  EXPECT_EQ(lines[0].points[1].y(), lines[0].points[0].y());
}

TEST(Plot, PointsThatNothingJoinsHaveNoLine) {
  Plot plot = two_points();
  plot.series[0].join = PlotJoin::none;
  const std::vector<Mark> marks = plot_marks(plot, fonts(), kArea);
  EXPECT_TRUE(shapes<Polyline>(marks, "plot.first.line").empty());
  EXPECT_EQ(shapes<Disk>(marks, "plot.first").size(), 3u) << "and one beside the name";
}

TEST(Plot, NotesStandBesideTheirPoints) {
  Plot plot = two_points();
  plot.notes = {{PlotStyle::first, plot.series[0].points[0], "1"},
                {PlotStyle::first, plot.series[0].points[1], "2"}};
  const std::vector<Mark> marks = plot_marks(plot, fonts(), kArea);
  const auto disks = shapes<Disk>(marks, "plot.first");
  for (std::size_t i = 0; i < plot.notes.size(); ++i) {
    int found = 0;
    for (const Text& text : shapes<Text>(marks, "plot.first.label")) {
      if (text.text != plot.notes[i].text) continue;
      ++found;
      const Point center = box_of(fonts(), text).center();
      const double own = (center - disks[i].center).norm();
      EXPECT_LT(own, 36.0);
      EXPECT_LT(3.0 * own, (center - disks[1 - i].center).norm());
    }
    EXPECT_EQ(found, 1) << plot.notes[i].text;
  }
}

}  // namespace plot_test
}  // namespace gjkscope
