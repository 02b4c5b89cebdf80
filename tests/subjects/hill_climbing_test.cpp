// Walks to support points: each ends where a scan would, whatever the points are.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lessons.hpp"
#include "outlines/polyhedron.hpp"
#include "subjects/hill_climbing/growth.hpp"
#include "subjects/hill_climbing/lesson_trace.hpp"

namespace gjkscope {
namespace hill_climbing_test {

using climbing::Neighbours;
using Eigen::Vector3d;

Neighbours neighbours_in(const std::vector<Vector3d>& points) {
  return neighbours_of(exact_hull(points), points.size());
}

class Points {
 public:
  explicit Points(int seed) : bits_(static_cast<unsigned>(seed)) {}
  double real() { return std::uniform_real_distribution<double>(-1.0, 1.0)(bits_); }
  int whole(int most) { return std::uniform_int_distribution<int>(0, most)(bits_); }
  Vector3d any() { return {real(), real(), real()}; }

  /// Points of a family: in a ball, on few places of a lattice, on a plane, a line, one place; with
  /// copies; almost on a plane; far from the origin; huge and tiny.
  std::vector<Vector3d> family(int kind, int count) {
    const Vector3d u = any();
    const Vector3d v = any();
    const Vector3d far = 1e8 * any();
    std::vector<Vector3d> out;
    for (int i = 0; i < count; ++i) {
      const Vector3d lattice(whole(2), whole(2), whole(2));
      switch (kind) {
        case 0:
          out.push_back(any());
          break;
        case 1:
          out.push_back(lattice);
          break;
        case 2:
          out.emplace_back(whole(4), whole(4), 3.0);
          break;
        case 3:
          out.emplace_back(whole(9) * Vector3d(1.0, 2.0, -1.0));
          break;
        case 4:
          out.emplace_back(1.0, 2.0, 3.0);
          break;
        case 5:
          out.push_back(i > 3 && whole(1) == 0 ? out[static_cast<std::size_t>(whole(i - 1))]
                                               : any());
          break;
        case 6:
          out.emplace_back(real() * u + real() * v + 1e-15 * any());
          break;
        case 7:
          out.emplace_back(far + any());
          break;
        case 8:
          out.emplace_back(1e17 * any());
          break;
        default:
          out.emplace_back(1e-150 * lattice);
      }
    }
    return out;
  }
  static constexpr int kFamilies = 10;

 private:
  std::mt19937 bits_;
};

TEST(Walks, EndAtASupportPointOfAScanWhateverThePointsAre) {
  Points random(17);
  int plateaus = 0;
  int long_walks = 0;
  for (int round = 0; round < 400; ++round) {
    const int kind = round % Points::kFamilies;
    const std::vector<Vector3d> points = random.family(kind, 1 + random.whole(40));
    const Neighbours neighbours = neighbours_in(points);
    ASSERT_EQ(neighbours.size(), points.size());
    for (int k = 0; k < 30; ++k) {
      Vector3d d = random.any();
      const auto any = [&] {
        return points[static_cast<std::size_t>(random.whole(static_cast<int>(points.size()) - 1))];
      };
      if (k % 3 == 1) d = Vector3d::Unit(k % 9 / 3) * (k % 2 == 0 ? 1.0 : -1.0);
      if (k % 3 == 2) d = (any() - any()).cross(any() - any());  // often the normal of a face
      const int from =
          climbing::start_at(neighbours, random.whole(static_cast<int>(points.size()) - 1));
      const climbing::Walk walk = climbing::walk(points, neighbours, d, from);
      const Vector3d& end = points[static_cast<std::size_t>(walk.end())];
      for (const Vector3d& point : points)
        ASSERT_LE(climbing::farther(d, end, point), 0) << "family " << kind << ", round " << round;
      EXPECT_LE(walk.products(), static_cast<int>(points.size()));
      if (walk.looks.size() > 3) ++long_walks;
      plateaus += static_cast<int>(std::count_if(
          neighbours[static_cast<std::size_t>(walk.end())].begin(),
          neighbours[static_cast<std::size_t>(walk.end())].end(), [&](int other) {
            return climbing::farther(d, end, points[static_cast<std::size_t>(other)]) == 0;
          }));
    }
  }
  EXPECT_GT(plateaus, 500);
  EXPECT_GT(long_walks, 500);
}

TEST(Walks, WouldStopTooEarlyAtAPointInsideOfAFace) {
  // The middle of a cube's top: all neighbours in its face are equally far straight down.
  std::vector<Vector3d> points = {{0, 0, 2}};
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-2.0, 2.0}) points.emplace_back(x, y, z);
    }
  }
  const Neighbours neighbours = neighbours_in(points);
  EXPECT_TRUE(neighbours[0].empty());
  Neighbours in_face(points.size());
  in_face[0] = {2, 4, 6, 8};
  const Vector3d down(0, 0, -1);
  EXPECT_EQ(climbing::walk(points, in_face, down, 0).end(), 0);
  EXPECT_EQ(climbing::start_at(neighbours, 0), 1);
}

TEST(ExactHull, OfACubeWithPointsOnAllItsPartsAreItsEdges) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 27; ++i) points.emplace_back(i % 3, i / 3 % 3, i / 9);
  std::shuffle(points.begin(), points.end(), std::mt19937(3));
  points.insert(points.end(), points.begin(), points.end());
  const Neighbours neighbours = neighbours_in(points);
  int vertices = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (neighbours[i].empty()) continue;
    ++vertices;
    ASSERT_EQ(neighbours[i].size(), 3u);
    for (const int end : neighbours[i])
      EXPECT_EQ((points[static_cast<std::size_t>(end)] - points[i]).lpNorm<1>(), 2.0);
  }
  EXPECT_EQ(vertices, 8);
}

TEST(Climbs, OfTheLessonFindTheSupportPointsOfItsRun) {
  const LessonRun run = run_lesson(testing::shipped_lesson("hill-climbing"));
  const ClimbTrace& trace = climbs_trace(*run.algorithm_traces[0]);
  ASSERT_GT(trace.climbs.size(), 3u);
  EXPECT_EQ(static_cast<int>(trace.climbs.size()), support_calls(run.runs[0].trace));
  for (std::size_t i = 0; i < trace.climbs.size(); ++i) {
    const Climb& climb = trace.climbs[i];
    EXPECT_EQ(climb.walk.end(), climb.scanned);
    if (i == 0) continue;
    EXPECT_EQ(climb.walk.looks.front().at, trace.climbs[i - 1].walk.end());
  }
  EXPECT_LT(trace.climbs.back().walk.products(), trace.climbs.front().walk.products());
  EXPECT_LT(trace.answer("walked"), trace.answer("scanned"));
}

TEST(Climbs, OfTwoPolyhedraGoAlongDAndAgainstIt) {
  Lesson lesson = testing::shipped_lesson("polyhedra-gjk");
  lesson.tour = "hill-climbing";
  const LessonRun run = run_lesson(std::move(lesson));
  const ClimbTrace& trace = climbs_trace(*run.algorithm_traces[0]);
  int of_x = 0;
  for (const Climb& climb : trace.climbs) {
    of_x += climb.of_x ? 1 : 0;
    // At the end d is normal to what is closest: its vertices lie equally far, but for rounding.
    const std::vector<Vector3d>& points = run.runs[0].bodies[climb.of_x ? 0 : 1].world;
    const Vector3d& d = climb.walk.d;
    EXPECT_NEAR(d.dot(points[static_cast<std::size_t>(climb.walk.end())]),
                d.dot(points[static_cast<std::size_t>(climb.scanned)]), 1e-12);
  }
  EXPECT_EQ(2 * of_x, static_cast<int>(trace.climbs.size()));
}

TEST(Climbs, HaveWordsAndPicturesForAnyShape) {
  const Lesson shipped = testing::shipped_lesson("hill-climbing");
  Points random(5);
  for (int kind = 0; kind < Points::kFamilies; ++kind) {
    for (const int count : {1, 2, 5, 20, 300}) {
      Lesson lesson = shipped;
      lesson.questions.clear();
      LessonShape& y = lesson.y();
      y.vertices = random.family(kind, count);
      y.vertex_names.clear();
      for (int i = 0; i < count; ++i) y.vertex_names.push_back(fmt::format("{}", i));
      lesson.options.start = {};
      LessonRun run = run_lesson(std::move(lesson));
      if (!why_not_drawn(run.runs[0]).empty()) continue;
      if (run.frames.size() > 2) run.frames.resize(run.frames.size() - 2);  // those of growth
      EffectGraph effects(run);
      for (const FramePicture& frame : lesson_pictures(run, effects, testing::fonts()))
        EXPECT_FALSE(frame.text.caption.empty());
    }
  }
}

TEST(Climbs, AreOfSpaceAlone) {
  std::string text = lesson_toml(testing::shipped_lesson("stop-vertex"));
  const std::size_t at = text.find("[[views]]");
  ASSERT_NE(at, std::string::npos);
  text.insert(at, "[steps]\ntour = \"hill-climbing\"\n\n");
  const LoadedLesson loaded = parse_lesson(text, "lessons/plane.toml", vocabulary());
  EXPECT_FALSE(loaded.lesson);
  EXPECT_NE(to_string(loaded.problems).find("tour 'hill-climbing' in the plane"), std::string::npos)
      << to_string(loaded.problems);
}

TEST(ClimbGrowth, IsLikeTheRootOfNAndLaterWalksAreShort) {
  const LessonRun run = run_lesson(testing::shipped_lesson("hill-climbing"));
  EffectGraph effects(run);
  const ClimbGrowth::Value& samples = effects.get<ClimbGrowth>(run.frames.back());
  ASSERT_GE(samples.size(), 5u);
  EXPECT_EQ(samples.back().vertices, 10000);
  for (const ClimbGrowth::Sample& sample : samples) {
    EXPECT_LE(sample.first, sample.vertices);
    EXPECT_LE(sample.later, sample.first);
    if (sample.vertices < 300) continue;
    const double root = std::sqrt(sample.vertices);
    EXPECT_GT(sample.first_moves, 0.25 * root);
    EXPECT_LT(sample.first_moves, 1.5 * root);
  }
}

}  // namespace hill_climbing_test
}  // namespace gjkscope
