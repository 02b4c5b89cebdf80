#include "picture/tween.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "frames/frame.hpp"
#include "lessons.hpp"

namespace gjkscope {
namespace tween_test {

using testing::shipped_lesson;

std::vector<FramePicture> pictures_of(const std::string& id) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  const LessonRun run = run_lesson(shipped_lesson(id));
  EffectGraph effects(run);
  return lesson_pictures(run, effects, fonts);
}

Picture picture_of(std::vector<Mark> marks) {
  return {100.0, 100.0, {{{0.0, 0.0}, {100.0, 100.0}}}, 0.0, std::move(marks)};
}
Mark disk(double x, int index, std::string role = "vertex") {
  return {std::move(role), Disk{{x, 50.0}, 4.0}, 0, {Subject::Kind::vertex_of_x, index, -1}};
}
Mark label(double x, std::string words, double y = 50.0) {
  return {"label", Text{{x, y}, std::move(words), type::kVertex}, -1, {}};
}
double x_of(const Mark& mark) { return std::get<Disk>(mark.shape).center.x(); }

TEST(Tween, BeginsAndEndsAsTheFramesThemselves) {
  for (const std::string id : {"polygons-gjk", "lin-canny-motion", "segment-regions"}) {
    const auto frames = pictures_of(id);
    for (std::size_t i = 1; i < frames.size(); ++i) {
      const Picture& from = frames[i - 1].picture;
      const Picture& to = frames[i].picture;
      EXPECT_EQ(tween(from, to, 0.0), from) << id << " " << i;
      EXPECT_EQ(tween(from, to, 1.0), to) << id << " " << i;
      EXPECT_EQ(tween(to, to, 0.5), to) << id << " " << i;
    }
  }
}

TEST(Tween, AMarkMovesAtConstantSpeedToWhatHasItsSubject) {
  // Painted in another order: the subject counts.
  const Picture from = picture_of({disk(10.0, 0), disk(20.0, 1)});
  const Picture to = picture_of({disk(60.0, 1), disk(90.0, 0)});
  for (const double t : {0.25, 0.5, 0.75}) {
    const Picture between = tween(from, to, t);
    ASSERT_EQ(between.marks.size(), 2u);
    EXPECT_DOUBLE_EQ(x_of(between.marks[0]), 20.0 + 40.0 * t);
    EXPECT_DOUBLE_EQ(x_of(between.marks[1]), 10.0 + 80.0 * t);
    EXPECT_EQ(between.marks[0].opacity, 1.0);
  }
}

TEST(Tween, WhatIsNewAppearsAndWhatIsGoneFadesWhereItWas) {
  const Picture from =
      picture_of({disk(10.0, 0), disk(20.0, 1), label(30.0, "old"), disk(40.0, 2)});
  const Picture to = picture_of({disk(10.0, 0), disk(40.0, 2), disk(50.0, 3), label(60.0, "new")});
  const Picture between = tween(from, to, 0.25);
  ASSERT_EQ(between.marks.size(), 5u) << "texts are gone at once";
  EXPECT_EQ(x_of(between.marks[1]), 20.0) << "between the same neighbours as before";
  EXPECT_DOUBLE_EQ(between.marks[1].opacity, 0.75);
  EXPECT_EQ(between.marks[1].subject, Subject()) << "it cannot be pointed at";
  EXPECT_EQ(between.marks[2].opacity, 1.0);
  EXPECT_DOUBLE_EQ(between.marks[3].opacity, 0.25);
  EXPECT_DOUBLE_EQ(between.marks[4].opacity, 0.25);
}

TEST(Tween, ALineWithMoreCornersTakesThePlaceOfTheOther) {
  const Mark two{"line", Polyline{{{0.0, 0.0}, {10.0, 0.0}}}, 0, {}};
  const Mark three{"line", Polyline{{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}}}, 0, {}};
  const Picture between = tween(picture_of({two}), picture_of({three}), 0.5);
  ASSERT_EQ(between.marks.size(), 2u);
  EXPECT_EQ(std::get<Polyline>(between.marks[0].shape), std::get<Polyline>(two.shape));
  EXPECT_EQ(std::get<Polyline>(between.marks[1].shape), std::get<Polyline>(three.shape));
}

TEST(Tween, WordsOutsideOfViewsAreThoseOfTheNextFrame) {
  const Picture from = picture_of({label(30.0, "in"), label(30.0, "out", 200.0)});
  const Picture to = picture_of({label(50.0, "in"), label(70.0, "out", 200.0)});
  const Picture between = tween(from, to, 0.5);
  EXPECT_EQ(std::get<Text>(between.marks[0].shape).at.x(), 40.0);
  EXPECT_EQ(between.marks[1], to.marks[1]);
}

TEST(Tween, EveryMarkOfALessonMovesOnItsWayOnly) {
  const auto frames = pictures_of("polygons-motion");
  int moved = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const Picture& to = frames[i].picture;
    const Picture early = tween(frames[i - 1].picture, to, 0.25);
    const Picture late = tween(frames[i - 1].picture, to, 0.75);
    ASSERT_EQ(early.marks.size(), late.marks.size());
    std::size_t next = 0;
    for (const Mark& end : to.marks) {
      // Marks that fade come in between.
      while (early.marks[next].role != end.role || early.marks[next].subject != end.subject) ++next;
      const Disk* const a = std::get_if<Disk>(&early.marks[next].shape);
      const Disk* const b = std::get_if<Disk>(&late.marks[next].shape);
      const Disk* const c = std::get_if<Disk>(&end.shape);
      ++next;
      if (!a || !b || !c) continue;
      const Point rest = c->center - a->center;
      EXPECT_NEAR((c->center - b->center - rest / 3.0).norm(), 0.0, 1e-9) << end.role;
      moved += rest.norm() > 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 20) << "vertices, closest points";
}

}  // namespace tween_test
}  // namespace gjkscope
