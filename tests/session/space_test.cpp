// A lesson in space under the hand: the eye walks, vertices move in the plane of the screen, and
// cases of three coordinates open.

#include <gtest/gtest.h>

#include <cmath>

#include "fonts.hpp"
#include "lesson/case.hpp"
#include "lessons.hpp"
#include "picture/scene.hpp"
#include "session/edit.hpp"
#include "session/hand.hpp"

namespace gjkscope {
namespace space_hand_test {

using Eigen::Vector3d;
using testing::fonts;
using testing::shipped_lesson;

class SpaceTest : public ::testing::Test {
 protected:
  void SetUp() override {
    Lesson lesson = shipped_lesson("polyhedra-gjk");
    lesson.questions.clear();
    ASSERT_TRUE(session.open(lesson, "file.toml"));
  }
  [[nodiscard]] Point at(const Vector3d& point, std::size_t view = 0) const {
    const LessonPictures::ShownView shown = session.views()[view];
    return StageMap(shown.card, shown.camera)(point);
  }
  /// A place of a view where nothing stands.
  [[nodiscard]] Point ground(std::size_t view) const {
    return session.views()[view].card.min + Point(12.0, 60.0);
  }

  Session session{fonts()};
  Hand hand{session, fonts()};
};

TEST_F(SpaceTest, ADragOfTheGroundTurnsBothViewsAndNothingElse) {
  const Lesson before = session.lesson();
  const Eye eye = *session.eye();
  const double height = session.views()[0].camera.height;
  ASSERT_TRUE(hand.press(hand.subject_at(ground(1)), ground(1)));
  EXPECT_TRUE(hand.move(ground(1) + Point(50.0, 25.0), false));
  EXPECT_TRUE(hand.release());
  for (const LessonPictures::ShownView& view : session.views()) {
    ASSERT_TRUE(view.camera.eye);
    EXPECT_NEAR(view.camera.eye->azimuth, eye.azimuth - 20.0, 1e-9);
    EXPECT_NEAR(view.camera.eye->elevation, eye.elevation + 10.0, 1e-9);
  }
  EXPECT_EQ(session.views()[0].camera.height, height);
  EXPECT_EQ(session.lesson(), before);
  EXPECT_TRUE(session.undo_name().empty());
  // Over the top and no further.
  session.set_eye({400.0, 1000.0});
  EXPECT_EQ(*session.eye(), (Eye{40.0, 90.0}));
}

TEST_F(SpaceTest, AVertexFollowsThePointerAndKeepsItsDepth) {
  const Vector3d vertex = session.lesson().y().vertices[1];
  const Point from = at(vertex);
  const Point to = from + Point(18.0, -11.0);
  const Subject subject = hand.subject_at(from);
  ASSERT_EQ(subject, (Subject{Subject::Kind::vertex_of_y, -1, 1}));
  const double distance = session.run().runs[0].trace.result.distance;
  ASSERT_TRUE(hand.press(subject, from));
  hand.move(to, false);
  EXPECT_TRUE(hand.release());
  const Vector3d& moved = session.lesson().y().vertices[1];
  EXPECT_LT((at(moved) - to).norm(), 1e-6);
  const Eigen::Matrix3d axes = axes_of(*session.eye());
  EXPECT_NEAR(axes.row(2).dot(moved), axes.row(2).dot(vertex), 1e-12);
  EXPECT_EQ(session.run().runs[0].trace.dimension, 3);
  session.undo();
  EXPECT_EQ(session.lesson().y().vertices[1], vertex);
  EXPECT_EQ(session.run().runs[0].trace.result.distance, distance);
}

TEST_F(SpaceTest, AVertexThatSnapsGoesAlongOneAxisToARoundPlace) {
  for (const int axis : {0, 1, 2}) {
    session.set_eye({35.0, 25.0});
    const Vector3d before = session.run().run(session.frame()).y().world[0];
    const Subject vertex{Subject::Kind::vertex_of_y, -1, 0};
    const Point from = at(before);
    const Point along = at(before + Vector3d::Unit(axis)) - from;
    ASSERT_TRUE(hand.press(vertex, from));
    EXPECT_TRUE(hand.move(from + Point(9.0, -4.0), false));  // anywhere at first
    EXPECT_TRUE(hand.move(from + 0.33 * along + Point(1.0, 1.0), true));
    EXPECT_TRUE(hand.release());
    const Vector3d after = session.run().run(session.frame()).y().world[0];
    for (int other = 0; other < 3; ++other) {
      if (other == axis) continue;
      EXPECT_NEAR(after[other], before[other], 1e-12) << axis;
    }
    EXPECT_NEAR(after[axis], before[axis] + 0.33, 0.15);
    const double step = hand.round_step(0).x();
    EXPECT_NEAR(std::remainder(after[axis], step), 0.0, 1e-12);
  }
}

TEST_F(SpaceTest, ALessonAsItIsSeenHoldsTheEye) {
  session.set_eye({70.0, 35.0});
  const Lesson seen = session.lesson_as_seen();
  ASSERT_TRUE(session.open(seen, "seen.toml"));
  EXPECT_EQ(*session.eye(), (Eye{70.0, 35.0}));
}

TEST_F(SpaceTest, SidesAreThoseTheirNamesSay) {
  const auto looks_along = [&](std::string_view side) {
    session.set_eye(*eye_from(side, session.run(), session.frame()));
    return Vector3d(-axes_of(*session.eye()).row(2).transpose());
  };
  EXPECT_LT((looks_along("front") - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((looks_along("side") + Vector3d::UnitX()).norm(), 1e-15);
  EXPECT_LT((looks_along("top") + Vector3d::UnitZ()).norm(), 1e-15);
  session.go_to(session.frame_count() - 1);
  const Vector3d d = session.run().state(session.frame()).d.normalized();
  EXPECT_LT(std::abs(looks_along("across d").dot(d)), 0.01);
  EXPECT_LT((looks_along("along d") - d).norm(), 1e-14);
  EXPECT_LT((-Vector3d(axes_of(eye_along({0, 0, -2})).row(2)) + Vector3d::UnitZ()).norm(), 1e-15);
  EXPECT_FALSE(eye_from("behind", session.run(), session.frame()));
}

TEST_F(SpaceTest, ACaseTakesThePlaceOfAnyLessonInSpace) {
  const CaseIn<3> space{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{3, 1, 1}, {4, 1, 1}}};
  for (const Lesson& lesson : testing::shipped_lessons()) {
    if (lesson.dimension == 2) continue;
    ASSERT_TRUE(session.open(lesson, "file.toml"));
    EXPECT_TRUE(session.edit("case", edit::with_shapes(session.lesson(), space)))
        << lesson.id << ": " << session.problem();
    for (int i = 0; i < session.frame_count(); ++i) {
      session.go_to(i);
      EXPECT_FALSE(session.picture().marks.empty());
    }
  }
}

TEST_F(SpaceTest, CasesOfEitherDimensionTakeItsPlace) {
  const CaseIn<3> space{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{3, 1, 1}}};
  ASSERT_TRUE(session.edit("case", edit::with_shapes(session.lesson(), space)))
      << session.problem();
  EXPECT_EQ(session.lesson().dimension, 3);
  EXPECT_NEAR(session.run().runs[0].trace.result.distance, std::sqrt(6.0), 1e-12);
  const Case plane{{{0, 0}, {1, 0}, {0, 1}}, {{3, 0}}};
  ASSERT_TRUE(session.edit("case", edit::with_shapes(session.lesson(), plane)))
      << session.problem();
  EXPECT_EQ(session.lesson().dimension, 2);
  EXPECT_FALSE(session.eye());
  // A lesson of the plane that shows what space has not.
  ASSERT_TRUE(session.open(shipped_lesson("minkowski-build"), "other.toml"));
  ASSERT_TRUE(session.edit("case", edit::with_shapes(session.lesson(), space)))
      << session.problem();
  EXPECT_EQ(session.lesson().tour, "phase");
  // One that shows what both have.
  ASSERT_TRUE(session.open(shipped_lesson("penetration-depth"), "depth.toml"));
  ASSERT_TRUE(session.edit("case", edit::with_shapes(session.lesson(), space)))
      << session.problem();
  EXPECT_EQ(session.lesson().tour, "depth");
}

}  // namespace space_hand_test
}  // namespace gjkscope
