// Changes of shapes.

#include "session/edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lesson/save.hpp"
#include "lessons.hpp"
#include "outlines/polygon.hpp"
#include "session/session.hpp"
#include "subjects/depth/lesson_trace.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace edit_test {

using Eigen::Vector2d;
using std::size_t;
using testing::shipped_lesson;

std::vector<Vector2d> world(const Lesson& lesson, std::size_t body) {
  const LessonRun run = run_lesson(lesson);
  return in_plane(run.runs.front().bodies[body].world);
}

TEST(Edit, AVertexOfATurnedShapeGoesWhereItIsPut) {
  Lesson lesson = shipped_lesson("polygons-gjk");
  lesson.y().rotate_degrees = 30.0;
  lesson.y().translate = {0.5, -0.25, 0.0};
  const LessonRun run = run_lesson(lesson);
  edit::put_vertex(lesson, 1, 2, run.runs.front().y().placement, {1.0, 4.0, 0.0});
  EXPECT_LT((world(lesson, 1)[2] - Vector2d(1.0, 4.0)).norm(), 1e-12);
  EXPECT_LT((world(lesson, 1)[1] - in_plane(run.runs.front().y().world[1])).norm(), 1e-12);
}

TEST(Edit, AShapeMovesAsAWhole) {
  for (const bool turned : {false, true}) {
    Lesson lesson = shipped_lesson("polygons-gjk");
    if (turned) lesson.x().rotate_degrees = 10.0;
    const auto before = world(lesson, 0);
    edit::move_shape(lesson, 0, {0.5, -2.0, 0.0});
    const auto after = world(lesson, 0);
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_LT((after[i] - before[i] - Vector2d(0.5, -2.0)).norm(), 1e-12);
  }
}

TEST(Edit, AShapeOnAPathTakesThePathWithIt) {
  Lesson lesson = shipped_lesson("segment-regions");
  const LessonRun before = run_lesson(lesson);
  edit::move_shape(lesson, 0, {1.0, 0.5, 0.0});
  const LessonRun after = run_lesson(lesson);
  ASSERT_EQ(before.runs.size(), after.runs.size());
  for (std::size_t i = 0; i < before.runs.size(); ++i)
    EXPECT_LT(
        (after.runs[i].x().world[0] - before.runs[i].x().world[0] - Eigen::Vector3d(1.0, 0.5, 0.0))
            .norm(),
        1e-12);
}

TEST(Edit, AShapeTurnsAboutItsMiddle) {
  Lesson lesson = shipped_lesson("polygons-gjk");
  const auto before = world(lesson, 1);
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& vertex : before) middle += vertex / static_cast<double>(before.size());
  edit::turn_shape(lesson, 1, 90.0);
  const auto after = world(lesson, 1);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vector2d arm = before[i] - middle;
    EXPECT_LT((after[i] - middle - Vector2d(-arm.y(), arm.x())).norm(), 1e-12);
  }
}

TEST(Edit, ANewVertexHasANameOfItsOwnAndStartPairsKeepTheirVertices) {
  Lesson lesson = shipped_lesson("polygons-gjk");
  const gjk::VertexPair start = lesson.options.start.pairs[0];
  const std::string of_x = lesson.x().vertex_names[static_cast<std::size_t>(start.x)];
  const LessonRun run = run_lesson(lesson);
  const int index =
      edit::insert_vertex(lesson, 0, 0, run.runs.front().x().placement, {-3.0, -1.0, 0.0});
  EXPECT_EQ(1, index);
  EXPECT_EQ(6u, lesson.x().vertices.size());
  std::set<std::string> names(lesson.x().vertex_names.begin(), lesson.x().vertex_names.end());
  names.insert(lesson.y().vertex_names.begin(), lesson.y().vertex_names.end());
  EXPECT_EQ(10u, names.size());
  EXPECT_EQ(of_x,
            lesson.x().vertex_names[static_cast<std::size_t>(lesson.options.start.pairs[0].x)]);
  EXPECT_TRUE(edit::erase_vertex(lesson, 0, index));
  EXPECT_EQ(start, lesson.options.start.pairs[0]);
}

TEST(Edit, AStartVertexThatGoesIsForgotten) {
  Lesson lesson = shipped_lesson("polygons-gjk");
  ASSERT_TRUE(edit::erase_vertex(lesson, 1, lesson.options.start.pairs[0].y));
  EXPECT_EQ(gjk::VertexPair{}, lesson.options.start.pairs[0]);
  EXPECT_EQ(gjk::Error::none, run_lesson(lesson).runs.front().trace.result.error);
}

TEST(Edit, TheLastVertexStays) {
  Lesson lesson = shipped_lesson("segment-closest");
  EXPECT_FALSE(edit::erase_vertex(lesson, 0, 0));
}

TEST(Edit, AShapeBecomesAnotherInItsPlaceAndAsLarge) {
  Lesson lesson = shipped_lesson("polygons-gjk");
  lesson.x().vertices = {{1, 1, 0}, {5, 1, 0}, {3, 2, 0}};
  lesson.x().vertex_names = {"R", "S", "T"};
  edit::reshape(lesson, 0, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  const std::vector<Vector2d> box = {{1, -0.5}, {5, -0.5}, {5, 3.5}, {1, 3.5}};
  EXPECT_EQ(box, in_plane(lesson.x().vertices));
  EXPECT_EQ("T", lesson.x().vertex_names[2]);
  EXPECT_EQ(4u, lesson.x().vertex_names.size());
  edit::reshape(lesson, 0, {{0, 0}});
  EXPECT_EQ(std::vector<Vector2d>({{3, 1.5}}), in_plane(lesson.x().vertices));
  lesson.y().vertices = {{0, 0, 0}, {6, 0, 0}, {0, 2, 0}, {1, 1, 0}};
  edit::reshape(lesson, 0, {{-1, 0}, {1, 0}});
  EXPECT_EQ(std::vector<Vector2d>({{0, 1.5}, {6, 1.5}}), in_plane(lesson.x().vertices))
      << "a point has no size: that of Y";
  EXPECT_EQ(gjk::Error::none, run_lesson(lesson).runs.front().trace.result.error);
}

TEST(Edit, ARegularPolygonHasEqualSidesAndALevelLowestOne) {
  for (const int corners : {3, 4, 5, 6, 17}) {
    SCOPED_TRACE(corners);
    const std::vector<Vector2d> unit = edit::regular_polygon(corners);
    ASSERT_EQ(static_cast<size_t>(corners), unit.size());
    EXPECT_NEAR(unit[0].y(), unit[1].y(), 1e-15);
    EXPECT_TRUE(is_convex(unit));
    EXPECT_GT(signed_area(unit), 0.0);
    for (size_t i = 0; i < unit.size(); ++i) {
      EXPECT_NEAR(1.0, unit[i].norm(), 1e-15);
      EXPECT_GE(unit[i].y(), unit[0].y() - 1e-15);
      EXPECT_NEAR((unit[1] - unit[0]).norm(), (unit[(i + 1) % unit.size()] - unit[i]).norm(),
                  1e-14);
    }
  }
}

TEST(Edit, RandomPairsAreConvexKeepTheirSizeAndOverlapOrNot) {
  Lesson lesson = shipped_lesson("polygons-gjk");
  const LessonRun first = run_lesson(lesson);
  const auto width = [](const std::vector<Vector2d>& vertices) {
    const auto [low, high] =
        std::minmax_element(vertices.begin(), vertices.end(),
                            [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x(); });
    return high->x() - low->x();
  };
  int overlapping = 0;
  std::set<size_t> counts;
  double x_width = 0.0;
  constexpr int kPairs = 100;
  for (int seed = 1; seed <= kPairs; ++seed) {
    SCOPED_TRACE(seed);
    edit::make_random_pair(lesson, run_lesson(lesson).runs.front(),
                           static_cast<std::uint64_t>(seed));
    ASSERT_TRUE(why_not_said(lesson).empty()) << to_string(why_not_said(lesson));
    for (const LessonShape& shape : lesson.bodies) {
      EXPECT_TRUE(is_convex(in_plane(shape.vertices)));
      counts.insert(shape.vertices.size());
    }
    if (seed > 1) {
      EXPECT_NEAR(x_width, width(in_plane(lesson.x().vertices)), 1e-9);
    }
    x_width = width(in_plane(lesson.x().vertices));
    if (run_lesson(lesson).runs.front().trace.result.distance == 0.0) ++overlapping;
  }
  EXPECT_GT(overlapping, kPairs / 10);
  EXPECT_LT(overlapping, 9 * kPairs / 10);
  EXPECT_GE(counts.size(), 4u);
}

TEST(Edit, ASecondRunCanBeToldOfEveryLessonOfStepsAndTakenBack) {
  int tried = 0;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    const LessonRun run = run_lesson(lesson);
    if (run.tour->algorithm != &kGjkAlgorithm || !run.tour->follows_run ||
        run.tour->needs.settings != &LessonSecond::kKind)
      continue;
    SCOPED_TRACE(lesson.id);
    const ScalarKind other =
        lesson.scalar == ScalarKind::exact ? ScalarKind::double_ : ScalarKind::exact;
    const Lesson twice = edit::with_second_run(lesson, other);
    EXPECT_TRUE(why_not_said(twice).empty()) << to_string(why_not_said(twice));
    EXPECT_EQ(twice, edit::with_second_run(twice, other));
    const Lesson once = edit::with_second_run(twice, std::nullopt);
    EXPECT_TRUE(why_not_said(once).empty()) << to_string(why_not_said(once));
    EXPECT_FALSE(once.calls_for("second-run") || once.has_block("two-runs"));
    ++tried;
  }
  EXPECT_GT(tried, 10);
}

TEST(Edit, AnyLessonTakesABoxOrSaysWhatItNeeds) {
  int taken = 0;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    for (const size_t body : {0, 1}) {
      SCOPED_TRACE(lesson.id + (body == 0 ? " X" : " Y"));
      Lesson boxed = lesson;
      edit::reshape(boxed, body, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
      const std::vector<Problem> why = why_not_said(boxed);
      if (!why.empty()) {
        EXPECT_FALSE(why[0].what.empty());
        continue;
      }
      ++taken;
      const LessonRun run = run_lesson(boxed);
      if (!run.tour->algorithm->takes_outlines) {
        EXPECT_EQ(gjk::Error::none, run.runs.front().trace.result.error);
      }
    }
  }
  EXPECT_GT(taken, 60);
}

TEST(Edit, TheNearestEdgeIsFoundByDistance) {
  const std::vector<Vector2d> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const auto right = edit::nearest_edge(square, {{0, 4}}, {2.5, 1.0});
  ASSERT_TRUE(right);
  EXPECT_EQ(1, right->edge);
  EXPECT_DOUBLE_EQ(0.5, right->distance);
  EXPECT_EQ(3, edit::nearest_edge(square, {{0, 4}}, {0.25, 1.0})->edge);
  EXPECT_FALSE(edit::nearest_edge({{0, 0}}, {{0, 1}}, {1, 1}));
}

TEST(Edit, EveryLessonOfGjkCanBeToldByTheExpandingPolygonOrPolytope) {
  for (const Lesson& lesson : testing::shipped_lessons()) {
    SCOPED_TRACE(lesson.id);
    if (run_lesson(lesson).tour->algorithm->takes_outlines) continue;
    const Lesson tried = edit::with_tour(lesson, kDepthAlgorithm);
    const LoadedLesson read = parse_lesson(lesson_toml(tried), lesson.path, vocabulary());
    for (const Problem& problem : read.problems) ADD_FAILURE() << to_string(problem);
    const LessonRun run = run_lesson(tried);
    EXPECT_EQ(run.algorithm_traces.size(), run.runs.size());
    EXPECT_FALSE(run.frames.empty());
  }
}

}  // namespace edit_test
}  // namespace gjkscope
