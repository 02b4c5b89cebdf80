// Faces of the difference by what they come from, held to the hull of all differences.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lessons.hpp"
#include "subjects/faces_of_difference/growth.hpp"
#include "subjects/faces_of_difference/lesson_trace.hpp"

namespace gjkscope {
namespace faces_of_difference_test {

using Eigen::Vector3d;
using sums_in_space::Face;
using sums_in_space::Kind;
using Points = std::vector<Vector3d>;

class Bodies {
 public:
  explicit Bodies(int seed) : bits_(static_cast<unsigned>(seed)) {}
  /// Anywhere in a cube, or on places of a lattice, where faces and edges are often parallel.
  Points body(int count, bool on_lattice) {
    Points points;
    for (int i = 0; i < count; ++i) {
      Vector3d point;
      for (double& each : point)
        each = on_lattice ? std::uniform_int_distribution<int>(-2, 2)(bits_)
                          : std::uniform_real_distribution<double>(-1.0, 1.0)(bits_);
      points.push_back(point);
    }
    return points;
  }

 private:
  std::mt19937 bits_;
};

Points differences(const Points& x, const Points& y) {
  Points z;
  for (const Vector3d& of_y : y) {
    for (const Vector3d& of_x : x) z.emplace_back(of_y - of_x);
  }
  return z;
}

int count(const std::vector<Face>& faces, Kind kind) {
  return static_cast<int>(std::count_if(faces.begin(), faces.end(),
                                        [&](const Face& face) { return face.kind() == kind; }));
}

TEST(FacesOfDifference, AreThoseOfTheHullOfAllDifferences) {
  Bodies random(9);
  int several = 0;
  int compared = 0;
  for (int round = 0; round < 300; ++round) {
    const bool on_lattice = round % 2 == 1;
    const Points x = random.body(4 + round % 11, on_lattice);
    const Points y = random.body(4 + round % 8, on_lattice);
    const Polyhedron hull_x = exact_hull(x);
    const Polyhedron hull_y = exact_hull(y);
    const std::vector<Face> faces = sums_in_space::faces_of_difference(x, hull_x, y, hull_y);
    if (hull_x.faces.empty() || hull_y.faces.empty()) {
      EXPECT_TRUE(faces.empty());
      continue;
    }
    ++compared;
    const Points z = differences(x, y);
    const Polyhedron hull = on_lattice ? exact_hull(z) : hull_in_space(z);
    ASSERT_EQ(faces.size(), hull.faces.size()) << "round " << round;
    several += count(faces, Kind::of_several);
    if (count(faces, Kind::of_several) == 0) {
      EXPECT_EQ(count(faces, Kind::of_y), static_cast<int>(hull_y.faces.size()));
      EXPECT_EQ(count(faces, Kind::of_x), static_cast<int>(hull_x.faces.size()));
    }
    std::size_t sides = 0;  // each edge of Z is one of two faces
    for (const Face& face : faces) {
      const auto corners = sums_in_space::corners_of(face, x, y);
      sides += corners.size();
      const auto at = [&](const gjk::VertexPair& pair) -> Vector3d {
        return y[static_cast<std::size_t>(pair.y)] - x[static_cast<std::size_t>(pair.x)];
      };
      for (const Vector3d& point : z)
        EXPECT_LE(face.normal.dot(point - at(corners[0])), 1e-12) << "round " << round;
    }
    EXPECT_EQ(hull.vertices.size() + faces.size(), sides / 2 + 2);
  }
  EXPECT_GT(compared, 200);
  EXPECT_GT(several, 200);
}

TEST(FacesOfDifference, OfTwoBoxesWithParallelSidesAreSixOfSeveralSources) {
  Points x;
  for (int i = 0; i < 8; ++i) x.emplace_back(i % 2, i / 2 % 2, i / 4);
  Points y;
  for (const Vector3d& corner : x) y.emplace_back(0.3 * corner + Vector3d(2.0, 0.1, 0.7));
  const std::vector<Face> faces =
      sums_in_space::faces_of_difference(x, exact_hull(x), y, exact_hull(y));
  EXPECT_EQ(faces.size(), 6u);
  EXPECT_EQ(count(faces, Kind::of_several), 6);
}

TEST(FacesOfDifference, OfTheLessonAreAllThreeKinds) {
  const LessonRun run = run_lesson(testing::shipped_lesson("faces-of-the-difference"));
  const FacesTrace& trace = faces_trace(*run.algorithm_traces[0]);
  for (const Kind kind : {Kind::of_y, Kind::of_x, Kind::of_edges}) EXPECT_GT(trace.count(kind), 2);
  EXPECT_EQ(trace.count(Kind::of_several), 0);
  EXPECT_EQ(trace.faces.size(), static_cast<std::size_t>(trace.answer("faces")));
}

TEST(FacesOfDifference, HaveWordsAndPicturesForAnyShapes) {
  Bodies random(4);
  for (int round = 0; round < 40; ++round) {
    Lesson lesson = testing::shipped_lesson("faces-of-the-difference");
    lesson.questions.clear();
    lesson.options.start = {};
    const double size = round % 4 == 2 ? 1e15 : round % 4 == 3 ? 1e-100 : 1.0;
    for (std::size_t i = 0; i < 2; ++i) {
      LessonShape& shape = lesson.bodies[i];
      shape.vertices = random.body(1 + (round + 3 * static_cast<int>(i)) % 9, round % 2 == 1);
      shape.vertex_names.clear();
      for (std::size_t k = 0; k < shape.vertices.size(); ++k) {
        shape.vertices[k] *= size;
        shape.vertex_names.push_back(fmt::format("{}{}", i == 0 ? "x" : "y", k));
      }
    }
    LessonRun run = run_lesson(std::move(lesson));
    if (!why_not_drawn(run.runs[0]).empty()) continue;
    std::erase_if(run.frames, [](const Frame& frame) { return frame.part >= 0; });  // growth
    EffectGraph effects(run);
    for (const FramePicture& frame : lesson_pictures(run, effects, testing::fonts()))
      EXPECT_FALSE(frame.text.caption.empty());
  }
}

TEST(FacesOfDifference, AreOfSpaceAlone) {
  std::string text = lesson_toml(testing::shipped_lesson("stop-vertex"));
  text.insert(text.find("[[views]]"), "[steps]\ntour = \"faces-of-the-difference\"\n\n");
  const LoadedLesson loaded = parse_lesson(text, "lessons/plane.toml", vocabulary());
  EXPECT_NE(to_string(loaded.problems).find("tour 'faces-of-the-difference' in the plane"),
            std::string::npos)
      << to_string(loaded.problems);
}

TEST(FaceGrowth, IsLikeNForSpheresAndLikeItsSquareForLenses) {
  const LessonRun run = run_lesson(testing::shipped_lesson("faces-of-the-difference"));
  EffectGraph effects(run);
  for (const FaceGrowth::Sample& sample : effects.get<FaceGrowth>(run.frames.back())) {
    const double n = sample.vertices;
    EXPECT_GT(sample.of_spheres, 4.0 * n - 10.0);
    EXPECT_LT(sample.of_spheres, 12.0 * n);
    EXPECT_LT(sample.asked_of_lenses, 20);
    EXPECT_LT(sample.asked_of_spheres, 20);
    EXPECT_GT(sample.asked_for_depth, sample.asked_of_spheres);
    EXPECT_GT(sample.asked_for_depth, 0.4 * n);
    EXPECT_LT(sample.asked_for_depth, 1.2 * n);
    if (n <= 20) continue;
    EXPECT_NEAR(sample.of_lenses, 0.5 * n * n, 0.15 * n * n);
  }
}

}  // namespace faces_of_difference_test
}  // namespace gjkscope
