// Lessons in space: what their files say, what is refused, and from which side they are seen.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lesson/eye.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "run/run.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace space_test {

using Eigen::Vector3d;

constexpr std::string_view kLesson = R"(title = "Two tetrahedra"
chapter = 9
order = 1
prose = "Words."

[shapes.X]
names = ["A", "B", "C", "D"]
vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
rotate = 30
axis = [1, 1, 0]

[shapes.Y]
names = ["K", "L", "M", "N"]
vertices = [[3, 0, 0], [4, 0, 0], [3, 1, 0], [3, 0, 1]]
translate = [0, 0.5, 0.25]

[[views]]
show = "world"
eye = { azimuth = -40, elevation = 25 }

[[views]]
show = "difference"
effects = ["minkowski-hull"]

[panel]
blocks = ["pseudocode", "simplex", "bounds"]
listing = "gjk"

[expect]
stop = "repeated-support"
)";

LoadedLesson parse(std::string_view text) {
  return parse_lesson(text, "lessons/space.toml", vocabulary());
}

TEST(LessonInSpace, IsSavedAsItWasRead) {
  const LoadedLesson loaded = parse(kLesson);
  ASSERT_TRUE(loaded.lesson) << to_string(loaded.problems);
  EXPECT_EQ(loaded.lesson->dimension, 3);
  EXPECT_EQ(loaded.lesson->views[0].eye, (Eye{-40.0, 25.0}));
  const LoadedLesson again = parse(lesson_toml(*loaded.lesson));
  ASSERT_TRUE(again.lesson) << to_string(again.problems);
  EXPECT_EQ(*again.lesson, *loaded.lesson);
}

TEST(LessonInSpace, TurnsAboutItsAxisWithoutChangingLengths) {
  const LessonRun run = run_lesson(*parse(kLesson).lesson);
  const std::vector<Vector3d>& x = run.runs[0].x().world;
  const Vector3d axis = Vector3d(1, 1, 0).normalized();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vector3d& before = run.lesson.x().vertices[i];
    EXPECT_NEAR(x[i].norm(), before.norm(), 1e-15);
    EXPECT_NEAR(x[i].dot(axis), before.dot(axis), 1e-15);
  }
  // A quarter turn about x takes y to z, counter-clockwise seen from the tip of x.
  EXPECT_LT(
      (turn_of({Vector3d::Zero(), 90.0, Vector3d::UnitX()}) * Vector3d::UnitY() - Vector3d::UnitZ())
          .norm(),
      1e-15);
}

TEST(LessonInSpace, WhatIsWrongIsSaidWithItsPlace) {
  const auto refusal = [](const std::string& from, const std::string& to) {
    std::string text(kLesson);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return to_string(parse(text.replace(at, from.size(), to)).problems);
  };
  const auto says = [&](const std::string& from, const std::string& to, const std::string& what) {
    const std::string said = refusal(from, to);
    EXPECT_NE(said.find(what), std::string::npos) << to << "\n" << said;
  };
  says("[4, 0, 0]", "[4, 0]",
       "14:24: entry 2 of 'vertices' has 2 coordinates; expected point [x, y, z]");
  says("[0, 0.5, 0.25]", "[0, 0.5]", "15:13: 'translate' has 2 coordinates");
  says("axis = [1, 1, 0]", "axis = [0, 0, 0]", "the axis has no direction");
  says("[1, 0, 0], [0, 1", "[nan, 0, 0], [0, 1",
       "8:25: entry 1 of entry 2 of 'vertices' is not a finite number");
  says("[1, 0, 0], [0, 1", "[1e308, 0, 0], [0, 1", "1e+308");
  says("azimuth = -40", "azimuth = 900", "azimuth");
  says("\"minkowski-hull\"", "\"shape-hull\"", "effect 'shape-hull' of shapes in space");
  says("\"bounds\"]", "\"areas\"]", "block 'areas' of shapes in space");
  says("[panel]", "[steps]\ntour = \"pairs\"\n\n[panel]", "tour 'pairs' in space");
  says("\"bounds\"]", "\"depth-edges\"]", "block 'depth-edges' of shapes in space");
  const std::string two_runs =
      "[steps]\ntour = \"two-runs\"\n\n[second]\nmistake = \"wrong-sign\"\n\n[panel]";
  says("[panel]", two_runs, "a mistake in a loop in space");
}

TEST(LessonInSpace, HasUpToThreeViews) {
  std::string text(kLesson);
  const std::string view = "[[views]]\nshow = \"world\"\n\n";
  const auto with_one_more = [&] { return text.insert(text.find("[panel]"), view); };
  EXPECT_EQ(to_string(parse(with_one_more()).problems), "");
  EXPECT_NE(to_string(parse(with_one_more()).problems).find("4 views; expected 1 to 3"),
            std::string::npos);
}

TEST(LessonInSpace, StartsWithATetrahedronWhereFramesAreAboutOne) {
  std::string text(kLesson);
  text.insert(text.find("[[views]]"),
              "[steps]\ntour = \"fractions\"\n\n[path]\npoints = [[0, 0, 0], [1, 1, 1]]\n\n");
  EXPECT_NE(to_string(parse(text).problems).find("tour 'fractions' without a tetrahedron"),
            std::string::npos);
}

TEST(LessonInSpace, ThePlaneHasNeitherAnEyeNorAnAxis) {
  constexpr std::string_view plane = R"(title = "A"
chapter = 1
order = 1
prose = "Words."
[shapes.X]
vertices = [[0, 0]]
axis = [0, 0, 1]
[shapes.Y]
vertices = [[1, 0], [2, 0]]
[[views]]
show = "world"
eye = { azimuth = 0, elevation = 0 }
[expect]
stop = "repeated-support"
)";
  const std::string said = to_string(parse(plane).problems);
  EXPECT_NE(said.find("7:8: an 'axis' in the plane"), std::string::npos) << said;
  EXPECT_NE(said.find("12:7: an 'eye' in the plane"), std::string::npos) << said;
}

TEST(LessonInSpace, BodiesWithoutVolumeRun) {
  for (const std::string vertices :
       {"[[3, 0, 0]]", "[[3, 0, 0], [4, 1, 1]]", "[[3, 0, 0], [4, 1, 1], [3, 1, 2]]",
        "[[3, 0, 0], [3, 0, 0], [3, 0, 0], [3, 0, 0]]"}) {
    std::string text(kLesson);
    const std::string from =
        "names = [\"K\", \"L\", \"M\", \"N\"]\nvertices = [[3, 0, 0], [4, 0, 0], [3, 1, 0], [3, 0, "
        "1]]";
    text.replace(text.find(from), from.size(), "vertices = " + vertices);
    const LoadedLesson loaded = parse(text);
    ASSERT_TRUE(loaded.lesson) << to_string(loaded.problems);
    const LessonRun run = run_lesson(*loaded.lesson);
    EXPECT_TRUE(why_not_drawn(run.runs[0]).empty());
    EXPECT_GT(run.runs[0].trace.result.distance, 1.0);
  }
}

TEST(AnEye, HasAxesThatAreATurn) {
  for (const Eye eye : {Eye{}, Eye{30.0, 20.0}, Eye{-170.0, 90.0}, Eye{200.0, -45.0}}) {
    const Eigen::Matrix3d axes = axes_of(eye);
    EXPECT_LT((axes * axes.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-15);
    EXPECT_NEAR(axes.determinant(), 1.0, 1e-15);
  }
  EXPECT_EQ(axes_of({}).row(0), Eigen::RowVector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(axes_of({}).row(1), Eigen::RowVector3d(0.0, 0.0, 1.0));
}

TEST(AnEye, AcrossADirectionSeesItsTrueLength) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d d(coordinate(random), coordinate(random), coordinate(random));
    const Eye eye = eye_across(d);
    EXPECT_LE(eye.elevation, 20.0);
    const double seen = (axes_of(eye).topRows<2>() * d).norm() / d.norm();
    EXPECT_GT(seen, 0.9999) << d.transpose();  // whole degrees
  }
  EXPECT_EQ(eye_across(Vector3d::UnitZ()).elevation, 0.0);
}

}  // namespace space_test
}  // namespace gjkscope
