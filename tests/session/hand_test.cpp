// The hand on a picture: presses, moves and releases of what lies under it.

#include "session/hand.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fonts.hpp"
#include "lessons.hpp"
#include "outlines/polygon.hpp"
#include "picture/scene.hpp"
#include "run/trail.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"

namespace gjkscope {
namespace hand_test {

using Eigen::Vector2d;
using Kind = Subject::Kind;
using testing::fonts;
using testing::shipped_lesson;

class HandTest : public ::testing::Test {
 protected:
  void open(const std::string& id) { ASSERT_TRUE(session.open(shipped_lesson(id), "file.toml")); }
  /// The place of a point of a view on the page.
  [[nodiscard]] Point at(const Vector2d& point, std::size_t view = 0) const {
    const LessonPictures::ShownView shown = session.views()[view];
    return StageMap(shown.card, shown.camera)(point);
  }
  [[nodiscard]] std::vector<Vector2d> y() const { return in_plane(session.lesson().y().vertices); }
  [[nodiscard]] Vector2d middle_of_y() const {
    return centroid(in_plane(session.run().run(session.frame()).y().world));
  }
  /// Presses what is there, goes `by` pixels and lets go; whether something was held.
  bool drag(const Point& from, const Point& by, bool snaps = false) {
    const bool holds = hand.press(hand.subject_at(from), from);
    hand.move(from + by, snaps);
    EXPECT_TRUE(hand.release());
    return holds;
  }

  Session session{fonts()};
  Hand hand{session, fonts()};
};

TEST_F(HandTest, PlacesOfAViewAndOfThePageAreTheSame) {
  open("polygons-gjk");
  for (const std::size_t view : {0u, 1u}) {
    const Vector2d point(0.25, -0.5);
    EXPECT_EQ(view, hand.view_at(session.views()[view].card.center()));
    EXPECT_LT((in_plane(hand.to_view(view, at(point, view))) - point).norm(), 1e-12);
  }
  EXPECT_FALSE(hand.view_at({-1.0, -1.0}));
}

TEST_F(HandTest, InATrailNothingCanBeTakenAndNoCameraMoves) {
  open("polygons-gjk");
  hand.selected = {Kind::shape_y};
  session.go_to(session.frame_count() - 1);
  ASSERT_TRUE(is_trail(session.frame()));
  const Lesson before = session.lesson();
  EXPECT_FALSE(hand.handle());
  for (const std::size_t view : {0u, 1u}) {
    const Rect card = session.views()[view].card;
    EXPECT_FALSE(hand.with_vertex(at(y().front(), view), false));
    EXPECT_EQ(session.vertex_near(at(y().front(), view), 20.0), Subject());
    for (const double x : {0.25, 0.5, 0.75}) {
      const Point from = card.min + x * card.size();
      EXPECT_FALSE(drag(from, {30.0, 20.0}));
    }
    Camera camera = session.views()[view].camera;
    camera.height *= 2.0;
    session.set_camera(view, camera);
    EXPECT_NE(session.views()[view].camera, camera);
  }
  EXPECT_EQ(session.lesson(), before);
}

TEST_F(HandTest, InATrailOfSpaceADragTurnsTheCells) {
  open("polyhedra-gjk");
  session.go_to(session.frame_count() - 1);
  ASSERT_TRUE(is_trail(session.frame()));
  const Picture before = session.picture();
  EXPECT_TRUE(drag(session.views()[1].card.center(), {40.0, 0.0}));
  EXPECT_NE(session.picture(), before);
}

TEST_F(HandTest, BesideAnEdgeThereIsAVertexToAdd) {
  open("polygons-gjk");
  const std::vector<Eigen::Vector3d>& world = session.run().run(session.frame()).y().world;
  const Vector2d middle = 0.5 * (in_plane(world[0]) + in_plane(world[1]));
  const auto added = hand.with_vertex(at(middle), false);
  ASSERT_TRUE(added);
  EXPECT_TRUE(added->problem.empty());
  EXPECT_EQ(added->vertex, vertex_of(1, 1));
  ASSERT_EQ(added->lesson.y().vertices.size(), y().size() + 1);
  const Lesson& changed = added->lesson;
  const Placement placed = session.run().run(session.frame()).y().placement;
  EXPECT_LT((changed.y().vertices[1] - edit::to_local(placed, in_space(middle))).norm(), 1e-9);
  EXPECT_FALSE(hand.with_vertex(at(middle_of_y()), false)) << "far from all edges";
  EXPECT_FALSE(hand.with_vertex(at(middle, 1), false)) << "the difference has no edges of its own";
}

TEST_F(HandTest, AVertexGoesWhereTheHandGoes) {
  open("polygons-gjk");
  const std::vector<Vector2d> before = y();
  const Point from = at(before[0]);
  EXPECT_EQ((Subject{Kind::vertex_of_y, -1, 0}), hand.subject_at(from));
  EXPECT_TRUE(drag(from, {30.0, -20.0}));
  EXPECT_LT((at(y()[0]) - from - Point(30.0, -20.0)).norm(), 1e-9);
  for (std::size_t i = 1; i < before.size(); ++i) EXPECT_EQ(before[i], y()[i]);
  EXPECT_EQ("move a vertex", session.undo_name());
  EXPECT_EQ((Subject{Kind::vertex_of_y, -1, 0}), hand.selected);
  EXPECT_FALSE(hand.holds());
}

TEST_F(HandTest, AClickIsNoDrag) {
  open("polygons-gjk");
  const std::vector<Vector2d> before = y();
  const Point from = at(before[0]);
  EXPECT_TRUE(hand.press(hand.subject_at(from), from));
  EXPECT_FALSE(hand.move(from + Point(1.0, 1.0), false));
  EXPECT_FALSE(session.is_dragging());
  EXPECT_TRUE(hand.release());
  EXPECT_EQ(before, y());
  EXPECT_EQ("", session.undo_name());
}

TEST_F(HandTest, AShapeMovesAsAWhole) {
  open("polygons-gjk");
  const std::vector<Vector2d> before = y();
  const Point from = at(middle_of_y());
  EXPECT_TRUE(drag(from, {24.0, 10.0}));
  EXPECT_EQ(Subject{Kind::shape_y}, hand.selected);
  const Vector2d by = y()[0] - before[0];
  EXPECT_GT(by.norm(), 0.05);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((y()[i] - before[i] - by).norm(), 1e-12);
  EXPECT_EQ("move a shape", session.undo_name());
}

TEST_F(HandTest, TheDifferenceGoesWhereYGoes) {
  open("polygons-gjk");
  const std::vector<Vector2d> before = y();
  const Vector2d z =
      middle_of_y() - centroid(in_plane(session.run().run(session.frame()).x().world));
  EXPECT_TRUE(drag(at(z, 1), {0.0, 20.0}));
  EXPECT_LT(y()[0].y(), before[0].y());
  EXPECT_EQ(before[0].x(), y()[0].x());
  EXPECT_EQ(Subject{}, hand.selected);
}

TEST_F(HandTest, ThePointOfAQueryIsAShapeOfOneVertex) {
  open("polygon-evolution");
  const Lesson before = session.lesson();
  ASSERT_EQ(1u, before.x().vertices.size());
  const Point from = at(in_plane(session.run().run(session.frame()).x().world.front()));
  EXPECT_TRUE(drag(from, {-17.0, 9.0}));
  const Vector2d now = in_plane(session.run().run(session.frame()).x().world.front());
  EXPECT_LT((at(now) - from - Point(-17.0, 9.0)).norm(), 1e-9);
  EXPECT_EQ(before.y(), session.lesson().y());
  EXPECT_FALSE(hand.handle()) << "a point is not turned";
}

TEST_F(HandTest, AHandThatSnapsGoesToRoundNumbers) {
  open("polygons-gjk");
  const Vector2d step = hand.round_step(0);
  ASSERT_GT(step.x(), 0.0);
  ASSERT_LT(step.x(), 1.0);
  const auto is_round = [&](const Vector2d& point) {
    return point.x() == std::round(point.x() / step.x()) / std::round(1.0 / step.x()) &&
           point.y() == std::round(point.y() / step.y()) / std::round(1.0 / step.y());
  };
  drag(at(y()[0]), {31.3, 17.7}, true);
  EXPECT_TRUE(is_round(y()[0])) << y()[0].transpose();
  const Vector2d before = y()[1];
  drag(at(middle_of_y()), {-31.3, 17.7}, true);
  const Vector2d steps = (y()[1] - before).cwiseQuotient(step);
  EXPECT_GT(steps.norm(), 0.5);
  EXPECT_LT((steps - steps.array().round().matrix()).norm(), 1e-9);
  drag(at(y()[0]), {31.3, 17.7});
  EXPECT_FALSE(is_round(y()[0]));
  EXPECT_EQ((Vector2d{0.3, 7.0}), snapped(Vector2d{0.29, 7.0}, Vector2d{0.1, 0.0}));
}

TEST_F(HandTest, TheHandleTurnsTheSelectedShape) {
  open("polygons-gjk");
  EXPECT_FALSE(hand.handle());
  EXPECT_TRUE(hand.handle_marks().empty());
  const Point inside = at(middle_of_y());
  drag(inside, {0.0, 0.0});
  const std::optional<Point> handle = hand.handle();
  ASSERT_TRUE(handle);
  EXPECT_EQ(2u, hand.handle_marks().size());
  EXPECT_TRUE(hand.is_on_handle(*handle + Point(10.0, 0.0)));
  EXPECT_FALSE(hand.is_on_handle(*handle + Point(20.0, 0.0)));
  const Vector2d middle = middle_of_y();
  EXPECT_TRUE(drag(*handle, {60.0, 30.0}));
  const double turned = session.lesson().y().rotate_degrees;
  EXPECT_LT(turned, -5.0);
  EXPECT_GT(std::abs(std::remainder(turned, 15.0)), 1e-6);
  EXPECT_LT((middle_of_y() - middle).norm(), 1e-9);
  EXPECT_EQ("turn a shape", session.undo_name());
  EXPECT_EQ(Subject{Kind::shape_y}, hand.selected) << "it can be turned on";
  session.undo();
  ASSERT_TRUE(hand.handle());
  drag(*hand.handle(), {60.0, 30.0}, true);
  EXPECT_LT(session.lesson().y().rotate_degrees, -5.0);
  EXPECT_EQ(0.0, std::remainder(session.lesson().y().rotate_degrees, 15.0));
  session.undo();
  drag(*hand.handle(), {3.0, 0.0}, true);
  EXPECT_NE("turn a shape", session.undo_name()) << "no step of 15 degrees, no change";
}

TEST_F(HandTest, APressBesideAllShapesSelectsNothing) {
  open("polygons-gjk");
  drag(at(middle_of_y()), {0.0, 0.0});
  EXPECT_EQ(Subject{Kind::shape_y}, hand.selected);
  const Point corner = session.views()[0].card.max - Point(3.0, 3.0);
  EXPECT_FALSE(drag(corner, {-20.0, -20.0}));
  EXPECT_EQ(Subject{}, hand.selected);
  EXPECT_EQ("", session.undo_name());
}

TEST_F(HandTest, CancelEndsADragAsIfItHadNotBeen) {
  open("polygons-gjk");
  const std::vector<Vector2d> before = y();
  const Point from = at(before[0]);
  hand.press(hand.subject_at(from), from);
  hand.move(from + Point(30.0, 20.0), false);
  EXPECT_NE(before, y());
  EXPECT_TRUE(hand.cancel());
  EXPECT_EQ(before, y());
  EXPECT_FALSE(hand.holds());
  EXPECT_FALSE(hand.move(from + Point(60.0, 20.0), false));
  EXPECT_EQ(before, y());
  hand.press(hand.subject_at(from), from);
  EXPECT_TRUE(hand.cancel()) << "a click leaves nothing to be cancelled";
  EXPECT_EQ("", session.undo_name());
}

TEST_F(HandTest, WhatWasChangedMeanwhileIsNotHeldAnyMore) {
  open("polygons-gjk");
  const Point from = at(y().back());
  hand.press(hand.subject_at(from), from);
  Lesson lesson = session.lesson();
  ASSERT_TRUE(edit::erase_vertex(lesson, 1, static_cast<int>(y().size()) - 1));
  ASSERT_TRUE(session.edit("delete a vertex", lesson));
  hand.move(from + Point(30.0, 20.0), false);
  EXPECT_FALSE(hand.holds());
  EXPECT_EQ(lesson, session.lesson());
}

}  // namespace hand_test
}  // namespace gjkscope
