// The walk on features in space: where it ends, why it goes on, and how many steps it takes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "gjk/gjk.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lessons.hpp"
#include "subjects/walk_in_space/growth.hpp"
#include "subjects/walk_in_space/lesson_trace.hpp"

namespace gjkscope {
namespace walk_in_space_test {

using cells::Kind;
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;
using v_clip::Reason;

class Bodies {
 public:
  explicit Bodies(int seed) : bits_(static_cast<unsigned>(seed)) {}
  double real(double size) { return std::uniform_real_distribution<double>(-size, size)(bits_); }
  int whole(int most) { return std::uniform_int_distribution<int>(0, most)(bits_); }
  /// Points in a cube, or on few places of a lattice, which have faces of four and more sides.
  Points body(int count, bool on_lattice, const Vector3d& shift) {
    Points points;
    for (int i = 0; i < count; ++i) {
      Vector3d point;
      for (double& each : point) each = on_lattice ? 0.5 * whole(4) - 1.0 : real(1.0);
      points.emplace_back(point + shift);
    }
    return points;
  }

 private:
  std::mt19937 bits_;
};

double distance(const Points& x, const Points& y) {
  return gjk::distance<double>(gjk::Query<double, 3>{{x}, {y}}).distance;
}

Points corners(const SpaceWalk& trace, const PositionedRun& run, std::size_t body, int feature) {
  Points out;
  for (const int vertex : trace.features[body][static_cast<std::size_t>(feature)].vertices)
    out.push_back(run.bodies[body].world[static_cast<std::size_t>(vertex)]);
  return out;
}

/// How far p lies on the far side of the plane through a vertex, normal to an edge from there: by
/// the three sides of a triangle.
double beyond_vertex(const Vector3d& p, const Vector3d& vertex, const Vector3d& end) {
  const double length = (end - vertex).norm();
  return ((p - vertex).squaredNorm() + length * length - (p - end).squaredNorm()) / (2.0 * length);
}
/// How far p is from the plane through an edge of a face, normal to the face: by its distances to
/// the edge's line and to the face's plane.
double from_edge(const Vector3d& p, const Points& edge, const Points& face) {
  const Vector3d u = (edge[1] - edge[0]).normalized();
  const double to_line = (p - edge[0]).cross(u).norm();
  const Vector3d n = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
  const double to_plane = n.dot(p - face[0]);
  return std::sqrt(std::max(0.0, to_line * to_line - to_plane * to_plane));
}

LessonRun run_of(const Lesson& shipped, Points x, Points y) {
  Lesson lesson = shipped;
  lesson.questions.clear();
  lesson.expect = {};
  lesson.options.start = {};
  const std::array<Points, 2> points = {std::move(x), std::move(y)};
  for (const std::size_t body : {0, 1}) {
    LessonShape& shape = lesson.bodies[body];
    shape.vertices = points[body];
    shape.vertex_names.clear();
    for (std::size_t i = 0; i < points[body].size(); ++i)
      shape.vertex_names.push_back(fmt::format("{}{}", body == 0 ? "x" : "y", i));
  }
  return run_lesson(std::move(lesson));
}

TEST(WalkInSpace, EndsAtTheDistanceAndCrossesEachPlaneThatItNames) {
  const Lesson shipped = testing::shipped_lesson("lin-canny-in-space");
  Bodies random(1991);
  std::array<int, 13> reasons = {};
  for (int round = 0; round < 300; ++round) {
    const int few = 4 + random.whole(12);
    const int many = 4 + random.whole(12);
    const Vector3d shift(2.6 + random.real(0.4), random.real(2.0), random.real(2.0));
    Points x = random.body(few, round % 3 == 0, Vector3d::Zero());
    Points y = random.body(many, round % 3 == 0, shift);
    const LessonRun run = run_of(shipped, x, y);
    const SpaceWalk& trace = space_walk_trace(*run.algorithm_traces[0]);
    if (trace.all.empty()) continue;
    const double exact = distance(x, y);
    ASSERT_EQ(trace.overlaps(), exact == 0.0) << "round " << round;
    if (exact > 0.0) {
      EXPECT_NEAR(trace.answer("distance"), exact, 1e-12) << "round " << round;
    }
    for (std::size_t i = 0; i < trace.all.size(); ++i) {
      const SpaceWalk::Step& step = trace.all[i];
      ++reasons[static_cast<std::size_t>(step.reason)];
      if (!step.moves() || step.reason == Reason::behind_face) continue;
      const Vector3d& p = step.points[1 - step.body];
      const double beyond = trace.beyond(step);
      const auto of = [&](int feature) { return corners(trace, run.runs[0], step.body, feature); };
      const Points own = of(step.at[step.body]);
      const Points other = of(trace.border(step).beyond);
      if (own.size() <= 2 && other.size() <= 2) {
        const Points& vertex = own.size() == 1 ? own : other;
        const Points& edge = own.size() == 1 ? other : own;
        const Vector3d& end = edge[0] == vertex[0] ? edge[1] : edge[0];
        const double along = beyond_vertex(p, vertex[0], end);
        EXPECT_NEAR(beyond, own.size() == 1 ? along : -along, 1e-9) << "round " << round;
      } else {
        const Points& edge = own.size() == 2 ? own : other;
        EXPECT_NEAR(std::abs(beyond), from_edge(p, edge, own.size() == 2 ? other : own), 1e-6)
            << "round " << round;
      }
      // The next feature is nearer, or is where the closest point lies.
      const double from_own = distance({p}, own);
      const double from_next = distance({p}, of(step.next[step.body]));
      if (step.is_region) {
        EXPECT_GT(beyond, 0.0) << "round " << round;
        EXPECT_LT(from_next, from_own) << "round " << round;
      } else {
        EXPECT_GT(beyond, -1e-9) << "round " << round;
        EXPECT_NEAR(from_next, from_own, 1e-9) << "round " << round;
      }
      EXPECT_LE(trace.all[i + 1].distance(), step.distance() + 1e-12) << "round " << round;
    }
  }
  for (const Reason each : {Reason::none, Reason::edge_end, Reason::face_side,
                            Reason::vertex_border, Reason::edge_border})
    EXPECT_GT(reasons[static_cast<std::size_t>(each)], 5);
}

TEST(WalkInSpace, ShowsAVertexAnEdgeAndAFace) {
  const LessonRun run = run_lesson(testing::shipped_lesson("lin-canny-in-space"));
  const SpaceWalk& trace = space_walk_trace(*run.algorithm_traces[0]);
  std::array<int, 3> seen = {};
  for (const SpaceWalk::Step& step : trace.all)
    for (const std::size_t body : {0, 1})
      ++seen[static_cast<std::size_t>(
          trace.features[body][static_cast<std::size_t>(step.at[body])].kind())];
  for (const int count : seen) EXPECT_GT(count, 0);
  EXPECT_GE(trace.pairs(), 5);
}

TEST(WalkInSpace, HasWordsAndPicturesForAnyBodies) {
  Bodies random(4);
  int flat = 0;
  int overlaps = 0;
  for (int round = 0; round < 24; ++round) {
    const Vector3d shift((round % 3) * 1.5, 0.0, 0.0);
    const int few = 1 + round % 9;
    Points x = random.body(few, round % 2 == 0, Vector3d::Zero());
    Points y = random.body(8, round % 2 == 0, shift);
    const char* id = round % 4 == 0 ? "lin-canny-space-motion" : "lin-canny-in-space";
    LessonRun run = run_of(testing::shipped_lesson(id), std::move(x), std::move(y));
    const SpaceWalk& trace = space_walk_trace(*run.algorithm_traces[0]);
    flat += trace.all.empty() ? 1 : 0;
    overlaps += !trace.all.empty() && trace.overlaps() ? 1 : 0;
    EffectGraph effects(run);
    for (const FramePicture& frame : lesson_pictures(run, effects, testing::fonts()))
      EXPECT_FALSE(frame.text.caption.empty());
  }
  EXPECT_GT(flat, 3);
  EXPECT_GT(overlaps, 3);
}

TEST(WalkInSpace, AlongAPathStartsFromTheLastPairAndIsCountedBesideGjk) {
  const LessonRun run = run_lesson(testing::shipped_lesson("lin-canny-space-motion"));
  const gjk::Options cold{.start = run.lesson.options.start};
  gjk::Options warm = cold;
  std::optional<v_clip::Result> last;
  int one = 0;
  for (std::size_t i = 0; i < run.runs.size(); ++i) {
    const Points& x = run.runs[i].x().world;
    const Points& y = run.runs[i].y().world;
    const v_clip::Body of_x = v_clip::body_of(x);
    const v_clip::Body of_y = v_clip::body_of(y);
    const v_clip::Query query{of_x, of_y};
    const gjk::VertexPair first = cold.start.pairs[0];
    last = v_clip::walk(query, last ? v_clip::start(query, last->x, last->y)
                                    : v_clip::start(query, {v_clip::Kind::vertex, first.x},
                                                    {v_clip::Kind::vertex, first.y}));
    const SpaceWalk& trace = space_walk_trace(*run.algorithm_traces[i]);
    EXPECT_EQ(trace.pairs(), last->pairs);
    one += trace.pairs() == 1 ? 1 : 0;
    const gjk::Query<double, 3> both{{x}, {y}};
    EXPECT_EQ(trace.cold, gjk::distance<double>(both, cold).iterations);
    const auto again = gjk::distance<double>(both, warm);
    EXPECT_EQ(run.runs[i].trace.result.iterations, again.iterations);
    warm.start = again.warm();
  }
  EXPECT_GE(one, 2);
}

TEST(SpaceWalkGrowth, PairsDoNotGrowWithTheBodiesWhenTheWalkStartsFromTheLast) {
  const LessonRun run = run_lesson(testing::shipped_lesson("lin-canny-space-motion"));
  EffectGraph effects(run);
  const SpaceWalkGrowth::Value& samples = effects.get<SpaceWalkGrowth>(run.frames.back());
  ASSERT_GE(samples.size(), 5u);
  EXPECT_EQ(samples.front().vertices, 8);
  EXPECT_EQ(samples.back().vertices, 10000);
  for (const SpaceWalkGrowth::Sample& sample : samples) {
    EXPECT_GE(sample.pairs, 1.0);
    EXPECT_LE(sample.warm, sample.cold);
    EXPECT_LE(sample.pairs, std::sqrt(sample.vertices));
    EXPECT_LE(sample.small_moves, 1.5) << "moves as small as features";
    EXPECT_GT(sample.first_pair, std::sqrt(sample.vertices));
    EXPECT_LT(sample.first_pair, 5.0 * std::sqrt(sample.vertices));
  }
}

TEST(WalkInSpace, IsOfSpaceAlone) {
  std::string text = lesson_toml(testing::shipped_lesson("stop-vertex"));
  text.insert(text.find("[[views]]"), "[steps]\ntour = \"lin-canny-in-space\"\n\n");
  const LoadedLesson loaded = parse_lesson(text, "lessons/plane.toml", vocabulary());
  EXPECT_NE(to_string(loaded.problems).find("tour 'lin-canny-in-space' in the plane"),
            std::string::npos)
      << to_string(loaded.problems);
}

}  // namespace walk_in_space_test
}  // namespace gjkscope
