// Shapes with a radius: the answer, its words, its outlines, and where a file may have one.

#include "subjects/round_shapes/round_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "frames/frame.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lessons.hpp"
#include "outlines/polygon.hpp"
#include "subjects/subjects.hpp"
#include "texts.hpp"

namespace gjkscope {
namespace round_shapes_test {

using Eigen::Vector2d;
using Meeting = RoundShapes::Meeting;

Lesson lesson_with_y_moved_by(const Vector2d& by) {
  static const Lesson kShipped = testing::lesson_without_questions("round-shapes");
  Lesson lesson = kShipped;
  lesson.path_of_shapes.reset();
  lesson.y().translate = in_space(by);
  return lesson;
}

/// Points on circles around the vertices: their hull is the round shape, but for what lies between
/// the corners of a circle.
constexpr int kCorners = 128;
std::vector<Vector2d> circles_around(const std::vector<Vector2d>& vertices, double radius) {
  std::vector<Vector2d> out;
  for (const Vector2d& vertex : vertices) {
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kCorners;
      out.emplace_back(vertex + radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
  }
  return out;
}

RoundShapes::Value answer_of(const LessonRun& run) {
  EffectGraph effects(run);
  return effects.get<RoundShapes>(run.frames.back());
}

std::string last_words(const Lesson& lesson) {
  const LessonRun run = run_lesson(lesson);
  return testing::texts_of(run).back().detail;
}

TEST(RoundShapes, AreAsFarApartAsPolygonsWithManyCorners) {
  int apart = 0;
  int overlapping = 0;
  for (int i = 0; i < 21 * 21; ++i) {
    const LessonRun run =
        run_lesson(lesson_with_y_moved_by({0.3 * (i % 21 - 14), 0.3 * (i / 21 - 10)}));
    const PositionedRun& own = run.runs.front();
    const double radius_x = run.lesson.x().radius;
    const double radius_y = run.lesson.y().radius;
    if (!(own.trace.result.distance > 0.0)) continue;
    const PositionedRun many = run_case<2>({circles_around(in_plane(own.x().world), radius_x),
                                            circles_around(in_plane(own.y().world), radius_y)},
                                           ScalarKind::double_);
    const RoundShapes::Value answer = answer_of(run);
    const double off = (radius_x + radius_y) * (1.0 - std::cos(std::numbers::pi / kCorners));
    EXPECT_NEAR(many.trace.result.distance, std::max(answer.distance, 0.0), off);
    EXPECT_NEAR((answer.x - answer.y).norm(), std::abs(answer.distance), 1e-12);
    if (std::abs(answer.distance) < off) continue;
    const bool is_apart = many.trace.result.distance > 0.0;
    EXPECT_EQ(answer.meeting, is_apart ? Meeting::apart : Meeting::overlapping);
    ++(is_apart ? apart : overlapping);
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(overlapping, 30);
}

TEST(RoundShapes, TheLastFrameSubtractsTheRadii) {
  EXPECT_EQ(last_words(lesson_with_y_moved_by({0.0, 0.0})),
            "Less the radii 0.500 + 0.250, GJK's distance 2.500 leaves 1.750 between the round "
            "shapes.");
  EXPECT_EQ(last_words(lesson_with_y_moved_by({-1.75, 0.0})),
            "GJK's distance 0.750 is just the radii 0.500 + 0.250: the round shapes touch.");
  EXPECT_EQ(
      last_words(lesson_with_y_moved_by({-2.0, 0.0})),
      "GJK's distance 0.500 is less than the radii 0.500 + 0.250: the round shapes overlap by "
      "0.250.");
  const std::string meet = last_words(lesson_with_y_moved_by({-3.0, 0.0}));
  EXPECT_TRUE(meet.ends_with("The radii add 0.750 to the overlap.")) << meet;
  Lesson one = lesson_with_y_moved_by({0.0, 0.0});
  one.x().radius = 0.0;
  EXPECT_EQ(last_words(one),
            "Less the radius 0.250, GJK's distance 2.500 leaves 2.250 between the round shapes.");
  one.y().radius = 0.0;
  EXPECT_EQ(last_words(one).find("round"), std::string::npos);
  const LessonRun run = run_lesson(one);
  EffectGraph effects(run);
  EXPECT_EQ(RoundShapes::of(effects, run, run.frames.back()), nullptr);
  EXPECT_EQ(effects.count(RoundShapes::kName).pulls, 0);
}

TEST(RoundShapes, EveryTourThatTakesThemSaysWhatIsLeft) {
  int tours = 0;
  for (const Tour* tour : vocabulary().tours) {
    if (!tour->needs.takes_radius) continue;
    ++tours;
    Lesson lesson = lesson_with_y_moved_by({0.0, 0.0});
    lesson.tour = tour->name;
    const LessonRun run = run_lesson(lesson);
    const std::vector<FrameText> texts = testing::texts_of(run);
    EXPECT_EQ(std::count_if(texts.begin(), texts.end(),
                            [](const FrameText& text) {
                              return text.detail.find("1.750 between") != std::string::npos;
                            }),
              1)
        << tour->name;
  }
  EXPECT_EQ(tours, 4);
}

TEST(RoundShapes, OutlinesKeepTheirDistanceAndStayInSight) {
  const Fonts fonts{std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml"};
  const LessonRun run = run_lesson(testing::shipped_lesson("round-shapes"));
  for (const Page& page : {Page{}, Page{.width = 1280, .height = 1280}}) {
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, fonts, page);
    const Picture picture = pictures.picture(0);
    const LessonPictures::ShownView world = pictures.views().front();
    int outlines = 0;
    for (const Mark& mark : picture.marks) {
      const bool is_x = mark.role == "skin.x";
      if (!is_x && mark.role != "skin.y") continue;
      ++outlines;
      std::vector<Point> corners;
      const StageMap map(world.card, world.camera);
      for (const Eigen::Vector3d& vertex : run.runs[0].bodies[is_x ? 0 : 1].world)
        corners.push_back(map(vertex));
      const double radius = map.scale() * run.lesson.bodies[is_x ? 0 : 1].radius;
      for (const Point& point : std::get<Polygon>(mark.shape).points) {
        double distance = HUGE_VAL;
        for (std::size_t i = 0; i < corners.size(); ++i) {
          distance = std::min(
              distance, segment_distance(point, corners[i], corners[(i + 1) % corners.size()]));
        }
        EXPECT_NEAR(distance, radius, 1e-6);
        EXPECT_TRUE((point.array() >= world.card.min.array()).all());
        EXPECT_TRUE((point.array() <= world.card.max.array()).all());
      }
    }
    EXPECT_EQ(outlines, 2);
  }
}

TEST(RoundShapes, OutlinesTurnOnceAroundHoweverThinTheShapeIs) {
  const Fonts fonts{std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml"};
  using Points = std::vector<Vector2d>;
  for (const Points& vertices :
       {Points{{0, 0}}, Points{{0, 0}, {1, 0}}, Points{{0, 0}, {1, 1}, {0.5, 0.5}},
        Points{{0, 0}, {1, 1e-17}, {0.5, -1e-17}}, Points{{0, 0}, {1, 1e-300}, {2, -1e-300}},
        Points{{0, 0}, {1, 1e-16}, {2, 1e-16}, {3, 0}}}) {
    Lesson lesson = lesson_with_y_moved_by({0.0, 4.0});
    lesson.x().vertices = in_space(vertices);
    lesson.x().vertex_names = {"A", "B", "C", "D"};
    lesson.x().vertex_names.resize(vertices.size());
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    for (const Mark& mark : LessonPictures(run, effects, fonts).picture(0).marks) {
      if (mark.role != "skin.x" && mark.role != "skin.query") continue;
      std::vector<Point> points;
      for (const Point& point : std::get<Polygon>(mark.shape).points) {
        if (points.empty() || (point - points.back()).norm() > 1e-9) points.push_back(point);
      }
      if ((points.front() - points.back()).norm() < 1e-9) points.pop_back();
      double turned = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t n = points.size();
        const Point a = points[(i + 1) % n] - points[i];
        const Point b = points[(i + 2) % n] - points[(i + 1) % n];
        turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      }
      EXPECT_NEAR(std::abs(turned), 2.0 * std::numbers::pi, 1e-6);
    }
  }
}

TEST(RoundShapes, AFileMayHaveThemWhereFramesTellTheEndOfARun) {
  const Lesson lesson = testing::shipped_lesson("round-shapes");
  const auto loaded = [](const std::string& text) {
    return parse_lesson(text, "x.toml", vocabulary());
  };
  const std::string text = lesson_toml(lesson);
  EXPECT_EQ(loaded(text).lesson->x().radius, 0.5);
  const auto problem = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    const LoadedLesson result = loaded(changed);
    EXPECT_EQ(result.problems.size(), 1u);
    return result.problems.empty() ? "" : result.problems.front().what;
  };
  EXPECT_EQ(problem("radius = 0.5", "radius = -0.5"), "'radius' is -0.5");
  Lesson other = lesson;
  other.tour = "test";
  other.questions.clear();
  other.y().radius = 0.0;
  const LoadedLesson refused = loaded(lesson_toml(other));
  ASSERT_FALSE(refused.problems.empty());
  EXPECT_EQ(refused.problems.back().what, "'radius' with tour 'test'");
}

}  // namespace round_shapes_test
}  // namespace gjkscope
