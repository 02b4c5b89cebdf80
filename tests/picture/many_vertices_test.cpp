// Views of shapes that have more vertices than there is room for.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/text_box.hpp"
#include "run/trail.hpp"

namespace gjkscope {
namespace many_vertices_test {

using Kind = Subject::Kind;

const Fonts& fonts() {
  static const Fonts all(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  return all;
}

/// A regular polygon of `count` vertices, x1, x2, ..., as X beside a segment as Y.
Lesson lesson_of_many(int count) {
  Lesson lesson = testing::shipped_lesson("polygons-gjk");
  lesson.questions.clear();
  lesson.expect = {};
  lesson.options.start = {};
  lesson.x().vertices.clear();
  lesson.x().vertex_names.clear();
  for (int i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / count;
    lesson.x().vertices.emplace_back(3.0 * std::cos(turn), 3.0 * std::sin(turn), 0.0);
    lesson.x().vertex_names.push_back(fmt::format("x{}", i + 1));
  }
  lesson.y().vertices = {{5.0, 5.0, 0.0}, {6.0, 5.0, 0.0}};
  lesson.y().vertex_names = {"y1", "y2"};
  return lesson;
}

/// A label that a reader sees in any frame is in all of them, or it would come and go.
TEST(ManyVertices, NamesAreFewEnoughForTheViewAndHoldThoseOfTheRun) {
  for (const int count : {3, 12, 22, 23, 40, 64, 150, 256, 257, 1000, 10000}) {
    SCOPED_TRACE(count);
    const LessonRun run = run_lesson(lesson_of_many(count));
    std::set<std::string> met;
    for (const auto& step : run.runs[0].trace.steps) {
      const auto& simplex = step.after.simplex;
      for (int i = 0; i < simplex.count; ++i) {
        const auto index = static_cast<std::size_t>(simplex.vertices[i].pair.x);
        met.insert(run.lesson.x().vertex_names[index]);
      }
    }
    ASSERT_FALSE(met.empty());
    EffectGraph effects(run);
    std::optional<std::set<std::string>> first;
    LessonPictures pictures(run, effects, fonts());
    for (int i = 0; i <= answering_index(run); ++i) {
      std::set<std::string> names;
      for (const Mark& mark : pictures.picture(i).marks) {
        if (mark.role == "shape.x.label") names.insert(std::get<Text>(mark.shape).text);
      }
      for (const std::string& name : met) EXPECT_TRUE(names.contains(name)) << name;
      if (!first) first = names;
      EXPECT_EQ(names, *first);
      if (count + 2 <= 24) {
        EXPECT_EQ(names.size(), static_cast<std::size_t>(count));
      } else {
        // Those of the run, and corners all around.
        EXPECT_GE(names.size(), 6u);
        EXPECT_LE(names.size(), 22u);
      }
    }
  }
}

/// The disks of X, in the order of its vertices.
std::vector<Disk> disks_of_x(const Picture& picture) {
  std::vector<Disk> disks;
  for (const Mark& mark : picture.marks) {
    if (mark.role == "shape.x.vertex") disks.push_back(std::get<Disk>(mark.shape));
  }
  return disks;
}

TEST(ManyVertices, DisksFollowTheRoomAndNeverTouch) {
  double last = HUGE_VAL;
  for (const int count : {3, 12, 40, 64, 100, 150, 200, 300, 1000, 10000}) {
    SCOPED_TRACE(count);
    const LessonRun run = run_lesson(lesson_of_many(count));
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, fonts());
    const std::vector<Disk> disks = disks_of_x(pictures.picture(0));
    // All of them, or those that have names.
    ASSERT_GE(disks.size(), count > 100 ? 6u : static_cast<std::size_t>(count));
    ASSERT_LE(disks.size(), count > 100 ? 22u : static_cast<std::size_t>(count));
    if (disks.size() < static_cast<std::size_t>(count)) continue;
    for (std::size_t i = 0; i < disks.size(); ++i) {
      const Disk& next = disks[(i + 1) % disks.size()];
      EXPECT_GT((next.center - disks[i].center).norm(), next.radius + disks[i].radius + 0.5);
    }
    EXPECT_LE(disks.front().radius, last);
    last = disks.front().radius;
  }
  EXPECT_LT(last, 3.0);
}

/// Vertices that stand close together have no disks, while those with room have.
TEST(ManyVertices, ACrowdHasFewerDisks) {
  Lesson lesson = lesson_of_many(40);
  for (int i = 1; i < 9; ++i)
    lesson.x().vertices[static_cast<std::size_t>(i)] =
        lesson.x().vertices[0] + (0.01 * i) * (lesson.x().vertices[9] - lesson.x().vertices[0]);
  const LessonRun run = run_lesson(lesson);
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts());
  const std::vector<Disk> disks = disks_of_x(pictures.picture(0));
  EXPECT_GE(disks.size(), 32u);
  EXPECT_LT(disks.size(), 38u);
}

/// A lesson of two shapes whose vertices lie in squares side by side, in no order.
Lesson lesson_of_scribbles(int count) {
  Lesson lesson = lesson_of_many(3);
  std::mt19937_64 random(static_cast<std::uint64_t>(count));
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  for (const std::size_t body : {0u, 1u}) {
    LessonShape& shape = lesson.bodies[body];
    shape.vertices.clear();
    shape.vertex_names.clear();
    for (int i = 0; i < count; ++i) {
      const double x = coordinate(random) + (body == 0 ? -4.0 : 4.0);
      shape.vertices.emplace_back(x, coordinate(random), 0.0);
      shape.vertex_names.push_back(fmt::format("{}{}", body == 0 ? "x" : "y", i + 1));
    }
  }
  return lesson;
}

TEST(ManyVertices, NoLineThatLeadsFromANameCrossesAnother) {
  int leaders = 0;
  for (const int count : {40, 150, 1000}) {
    const LessonRun run = run_lesson(lesson_of_scribbles(count));
    EffectGraph effects(run);
    for (const FramePicture& frame : lesson_pictures(run, effects, fonts())) {
      for (const Mark& leader : frame.picture.marks) {
        if (leader.role != "leader") continue;
        ++leaders;
        const std::vector<Point>& ends = std::get<Polyline>(leader.shape).points;
        for (const Mark& mark : frame.picture.marks) {
          if (mark.role != "shape.x.label" && mark.role != "shape.y.label") continue;
          const auto& text = std::get<Text>(mark.shape);
          const Rect box = box_of(fonts(), text);
          for (double part = 0.0; part <= 1.0; part += 0.02) {
            const Point at = ends[0] + part * (ends[1] - ends[0]);
            EXPECT_FALSE(overlap(box, {at, at})) << count << ": " << text.text;
          }
        }
      }
    }
  }
  EXPECT_GT(leaders, 20);
}

TEST(ManyVertices, LinesWithoutRoomAreThinAndPale) {
  for (const auto& [count, role] : {std::pair(12, "shape.x"), std::pair(1000, "shape.x.dense")}) {
    const LessonRun run = run_lesson(lesson_of_scribbles(count));
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, fonts());
    const Picture picture = pictures.picture(0);
    EXPECT_TRUE(std::any_of(picture.marks.begin(), picture.marks.end(),
                            [wanted = role](const Mark& mark) {
                              return mark.role == wanted &&
                                     std::holds_alternative<Polyline>(mark.shape);
                            }))
        << count;
  }
}

TEST(ManyVertices, WhatIsPointedAtHasANameAndAllElseStays) {
  const LessonRun run = run_lesson(lesson_of_many(1000));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts());
  for (const int index : {0, 3}) {
    const Picture before = pictures.picture(index);
    const auto text = [](const Picture& picture, const std::string& name) {
      return std::count_if(picture.marks.begin(), picture.marks.end(), [&](const Mark& mark) {
        const Text* label = std::get_if<Text>(&mark.shape);
        return label != nullptr && label->text == name;
      });
    };
    ASSERT_EQ(text(before, "x8"), 0);
    const Subject pointed[] = {{Kind::vertex_of_x, 7}};
    const Picture now = pictures.picture(index, pointed);
    EXPECT_EQ(text(now, "x8"), 1);
    std::size_t next = 0;
    for (const Mark& mark : now.marks) {
      if (next < before.marks.size() && mark == before.marks[next]) ++next;
    }
    EXPECT_EQ(next, before.marks.size());
    EXPECT_EQ(pictures.picture(index), before) << "as it was once nothing is pointed at";
    // One that has a name does not get a second.
    const Subject named[] = {{Kind::vertex_of_y, -1, 0}};
    EXPECT_EQ(pictures.picture(index, named), before);
  }
}

/// No vertex that is not there, as after undo.
TEST(ManyVertices, WhatIsGoneIsNotPointedAt) {
  const LessonRun run = run_lesson(lesson_of_many(12));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts());
  const Picture before = pictures.picture(0);
  const Subject gone[] = {{Kind::vertex_of_x, 12},
                          {Kind::vertex_of_y, -1, 2},
                          {Kind::difference_vertex, 12, 0},
                          {Kind::vertex_of_x, -1}};
  EXPECT_EQ(pictures.picture(0, gone), before);
}

}  // namespace many_vertices_test
}  // namespace gjkscope
