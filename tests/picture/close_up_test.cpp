#include "picture/close_up.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "run/trail.hpp"

namespace gjkscope {
namespace close_up_test {

constexpr double kMargin = 24.0;  // as far outside of a card lines may end

const Rect kCard{{100.0, 100.0}, {200.0, 200.0}};

template <class T>
std::vector<T> shapes_of(const std::vector<Mark>& marks) {
  std::vector<T> out;
  for (const Mark& mark : marks) {
    if (const T* shape = std::get_if<T>(&mark.shape)) out.push_back(*shape);
  }
  return out;
}

TEST(CloseUp, CutsLinesThatGoFarBeyondItWhereTheyLeave) {
  // Through the card's middle; in single precision its ends are a thousand pixels apart.
  const double far = 3e10;
  const std::vector<Mark> seen =
      cut({{"line", Polyline{{{150.0 - far, 150.0 - far}, {150.0 + far, 150.0 + far}}}}}, kCard);
  ASSERT_EQ(seen.size(), 1u);
  const Polyline line = std::get<Polyline>(seen[0].shape);
  ASSERT_EQ(line.points.size(), 2u);
  for (const Point& end : line.points) {
    EXPECT_NEAR(end.x(), end.y(), 1e-4);
    EXPECT_NEAR(std::abs(end.x() - 150.0), 50.0 + kMargin, 1e-4);
  }
}

TEST(CloseUp, KeepsPointsInsideAndLeavesOutOthers) {
  const Subject vertex{Subject::Kind::vertex_of_x, 0};
  const std::vector<Mark> seen = cut({{"in", Disk{{150.0, 150.0}, 4.0}, -1, vertex},
                                      {"out", Disk{{150.0, 450.0}, 4.0}, -1, vertex},
                                      {"out", Cross{{-1e12, 0.0}, 4.0}}},
                                     kCard);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].role, "in");
  EXPECT_EQ(seen[0].subject, Subject{}) << "nothing of it can be taken hold of";
}

TEST(CloseUp, ALineThatComesBackIsTwo) {
  const Polyline away{{{150.0, 150.0}, {150.0, 900.0}, {160.0, 900.0}, {160.0, 150.0}}};
  EXPECT_EQ(shapes_of<Polyline>(cut({{"line", away}}, kCard)).size(), 2u);
}

TEST(CloseUp, AnArrowWhoseHeadIsOutsideIsALine) {
  const std::vector<Mark> seen = cut(
      {{"d", Arrow{{150.0, 150.0}, {150.0, 900.0}}}, {"d", Arrow{{150.0, 900.0}, {150.0, 150.0}}}},
      kCard);
  EXPECT_EQ(shapes_of<Polyline>(seen).size(), 1u);
  ASSERT_EQ(shapes_of<Arrow>(seen).size(), 1u);
  EXPECT_EQ(shapes_of<Arrow>(seen)[0].to, Point(150.0, 150.0));
}

/// In the lesson K is 8.5e-9 away from BC: 31 pixels in its close-up, which shows both.
TEST(CloseUp, ShowsTheGapThatTheViewCannot) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  const LessonRun run = run_lesson(testing::shipped_lesson("touching"));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts);
  const Picture picture = pictures.picture(answering_index(run));
  ASSERT_EQ(picture.clips.size(), 3u) << "the world, its close-up, the difference";
  const auto gap_in = [&](int clip) {
    std::vector<Point> ends;
    for (const Mark& mark : picture.marks) {
      if (mark.clip == clip && mark.role == "closest")
        ends.push_back(std::get<Disk>(mark.shape).center);
    }
    EXPECT_EQ(ends.size(), 2u);
    return (ends.front() - ends.back()).norm();
  };
  EXPECT_LT(gap_in(0), 1e-4);
  const LessonView& view = run.lesson.views[0];
  const double scale = (picture.clips[1].size().y() + 4.0) / view.close_up->camera.height;
  EXPECT_NEAR(gap_in(1), run.runs[0].trace.result.distance * scale, 0.1);
  EXPECT_GT(gap_in(1), 25.0);
}

TEST(CloseUp, StandsInTheCornerThatItIsGiven) {
  for (const CardCorner corner : {CardCorner::top_left, CardCorner::top_right,
                                  CardCorner::bottom_left, CardCorner::bottom_right}) {
    const Rect at = close_up_in(kCard, corner);
    const bool right = corner == CardCorner::top_right || corner == CardCorner::bottom_right;
    const bool low = corner == CardCorner::bottom_left || corner == CardCorner::bottom_right;
    EXPECT_EQ(at.center().x() > 150.0, right);
    EXPECT_TRUE(low ? at.max.y() < 200.0 && at.max.y() > 180.0 : at.min.y() > 140.0);
    EXPECT_TRUE(at.min.x() >= 100.0 && at.max.x() <= 200.0);
  }
}

}  // namespace close_up_test
}  // namespace gjkscope
