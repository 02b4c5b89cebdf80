// Questions answered in the drawing: vertices, edges, faces, regions and places.

#include "session/pointing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <numbers>

#include "fonts.hpp"
#include "frames/spots.hpp"
#include "lessons.hpp"
#include "picture/scene.hpp"

namespace gjkscope {
namespace pointing_test {

using Eigen::Vector3d;
using testing::fonts;
using testing::shipped_lesson;

class Pointing : public ::testing::Test {
 protected:
  /// At the first question about this.
  void open(const std::string& id, const std::string& ask) {
    ASSERT_TRUE(session.open(shipped_lesson(id), id + ".toml"));
    session.set_asking(true);
    for (int i = 0; i < session.frame_count(); ++i) {
      session.go_to(i);
      if (session.question() != nullptr && session.question()->ask == ask) return;
    }
    FAIL() << id << " does not ask " << ask;
  }
  [[nodiscard]] Point on_page(const Vector3d& place, std::size_t view = 0) const {
    const LessonPictures::ShownView shown = session.views()[view];
    return StageMap(shown.card, shown.camera)(place);
  }
  [[nodiscard]] std::string chosen_at(const Point& page) {
    const auto found = pointed_choice(session, hand, hand.subject_at(page), page);
    return found ? found->choice : "";
  }
  /// A point of the simplex in the world: the mean of some of its vertices.
  [[nodiscard]] Vector3d mean_of(const std::vector<int>& vertices) const {
    const WideSimplex& simplex = session.run().state(session.frame()).simplex;
    Vector3d mean = session.run().run(session.frame()).x().world.front();
    for (const int i : vertices)
      mean += simplex.vertices[i].w / static_cast<double>(vertices.size());
    return mean;
  }

  Session session{fonts()};
  Hand hand{session, fonts()};
};

TEST_F(Pointing, ARegionOfATriangleIsWhereOneClicks) {
  open("triangle-features", "region");
  const WideSimplex& simplex = session.run().state(session.frame()).simplex;
  ASSERT_EQ(simplex.count, 3);
  const SimplexWords words(session.run(), simplex);
  EXPECT_EQ(chosen_at(on_page(mean_of({0, 1, 2}))), words.face(simplex.all()));
  EXPECT_EQ(chosen_at(on_page(mean_of({0}))), words.face(gjk::face_of(0)));
  EXPECT_EQ(chosen_at(on_page(mean_of({1, 2}))),
            words.face(static_cast<gjk::Face>(gjk::face_of(1) | gjk::face_of(2))));
}

TEST_F(Pointing, ADirectionIsDraggedFromP) {
  open("polygons-gjk", "direction");
  const std::optional<Point> origin = origin_on_page(session);
  ASSERT_TRUE(origin);
  const FrameQuestion asked = *session.question();
  const Point difference = (on_page(in_space(*asked.place), 1) - *origin).normalized();
  EXPECT_NEAR((on_page(in_space(*asked.origin), 1) - *origin).norm(), 0.0, 1e-9);
  // Turned by a fifth of a quarter, and by three quarters.
  const auto at = [&](double degrees) {
    return Point(*origin +
                 70.0 * (Eigen::Rotation2Dd(degrees * std::numbers::pi / 180.0) * difference));
  };
  EXPECT_EQ(chosen_at(at(18.0)), asked.answer);
  EXPECT_EQ(chosen_at(at(-18.0)), asked.answer);
  EXPECT_EQ(chosen_at(at(180.0)), "away from O");
  EXPECT_NE(chosen_at(at(68.0)), asked.answer);
  EXPECT_EQ(chosen_at(*origin), "") << "P alone has no direction";
  // The world has no P.
  EXPECT_EQ(chosen_at(session.views()[0].card.center()), "");
  const auto found = pointed_choice(session, hand, {}, at(18.0));
  session.grade(found->choice, found->place);
  EXPECT_NEAR(session.answers().back().turned(), 18.0, 1e-9);
  EXPECT_TRUE(session.answers().back().is_right());
  EXPECT_FALSE(origin_on_page(session)) << "nothing is asked for";
}

TEST_F(Pointing, InSpaceAFaceOfThePolytopeIsWhereOneClicks) {
  open("depth-in-space", "face");
  const FrameQuestion asked = *session.question();
  ASSERT_EQ(asked.spots.size(), asked.choices.size());
  for (std::size_t i = 0; i < asked.choices.size(); ++i)
    EXPECT_EQ(chosen_at(on_page(asked.spots[i]->from, 1)), asked.choices[i]);
  EXPECT_EQ(chosen_at(on_page({9.0, 9.0, 9.0}, 1)), "");
}

TEST_F(Pointing, InSpaceARegionIsPointedAtByItsVertexEdgeOrFace) {
  open("tetrahedron-regions", "region");
  const WideSimplex& simplex = session.run().state(session.frame()).simplex;
  ASSERT_EQ(simplex.count, 4);
  const SimplexWords words(session.run(), simplex);
  const auto face_of = [](const std::vector<int>& vertices) {
    gjk::Face face = 0;
    for (const int i : vertices) face = static_cast<gjk::Face>(face | gjk::face_of(i));
    return face;
  };
  int fronts = 0;
  for (const Eye& eye : {Eye{24.0, 18.0}, Eye{150.0, 40.0}, Eye{-80.0, -25.0}}) {
    session.set_eye(eye);
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(chosen_at(on_page(mean_of({i}))), words.face(face_of({i})));
    for (int left_out = 0; left_out < 4; ++left_out) {
      std::vector<int> face;
      for (int i = 0; i < 4; ++i) {
        if (i != left_out) face.push_back(i);
      }
      // A face in front is taken; one behind is where another one is.
      const Vector3d a = simplex.vertices[face[0]].w;
      Vector3d normal = (simplex.vertices[face[1]].w - a).cross(simplex.vertices[face[2]].w - a);
      if (normal.dot(simplex.vertices[left_out].w - a) > 0.0) normal = -normal;
      const Point page = on_page(mean_of(face));
      const bool is_front = axes_of(eye).row(2).dot(normal.normalized()) > 0.2;
      if (!is_front) continue;
      EXPECT_EQ(chosen_at(page), words.face(face_of(face)));
      ++fronts;
    }
  }
  EXPECT_GE(fronts, 4);
}

TEST_F(Pointing, InSpaceARegionOfABodyIsPointedAtByItsVertexEdgeOrFace) {
  open("regions-of-a-box", "holding-region");
  const std::vector<Vector3d>& box = session.run().run(session.frame()).y().world;
  const std::vector<std::string>& names = session.lesson().y().vertex_names;
  int faces = 0;
  for (const std::string& choice : session.question()->choices) {
    const std::string feature = choice.substr(choice.find(' ') + 1);
    Vector3d middle = Vector3d::Zero();
    for (const char name : feature) {
      const auto found = std::find(names.begin(), names.end(), std::string(1, name));
      ASSERT_NE(found, names.end()) << choice;
      middle += box[static_cast<std::size_t>(found - names.begin())] /
                static_cast<double>(feature.size());
    }
    // The eye looks at it, from a little aside.
    const Vector3d outwards = middle.cwiseProduct(Vector3d(1.0, 1.0, 1.4));
    session.set_eye({std::atan2(outwards.x(), -outwards.y()) * 180.0 / M_PI + 4.0,
                     20.0 + (outwards.z() > 0.3 ? 25.0 : 0.0)});
    EXPECT_EQ(chosen_at(on_page(middle)), choice);
    faces += choice.starts_with("face") ? 1 : 0;
  }
  EXPECT_GT(faces, 0);
}

TEST_F(Pointing, InSpaceTheNextFeatureOfAWalkIsPointedAt) {
  open("lin-canny-in-space", "feature-in-space");
  session.set_eye({-45.0, 30.0});
  const LessonShape& x = session.lesson().x();
  const std::vector<Vector3d>& world = session.run().run(session.frame()).x().world;
  int pointed = 0;
  for (const std::string& choice : session.question()->choices) {
    if (!choice.starts_with("edge")) continue;
    Vector3d middle = Vector3d::Zero();
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (choice.substr(5, 2).find(x.vertex_names[i]) != std::string::npos)
        middle += 0.5 * world[i];
    }
    EXPECT_EQ(chosen_at(on_page(middle)), choice);
    ++pointed;
  }
  EXPECT_EQ(pointed, 3);
}

TEST_F(Pointing, ASupportPointIsTwoHalves) {
  open("polyhedra-gjk", "support");
  const std::vector<Vector3d>& y = session.run().run(session.frame()).y().world;
  const Point page = on_page(y[0]);
  const auto found = pointed_choice(session, hand, {Subject::Kind::vertex_of_y, -1, 0}, page);
  ASSERT_TRUE(found && found->half);
  EXPECT_EQ(found->choice, session.lesson().y().vertex_names[0]);
  EXPECT_EQ(*found->half, 0u);
}

TEST_F(Pointing, APlaceIsTakenAlong) {
  open("segment-regions", "closest");
  const auto place = session.question()->place;
  ASSERT_TRUE(place);
  const Point page = on_page(in_space(*place));
  const auto found = pointed_choice(session, hand, hand.subject_at(page), page);
  ASSERT_TRUE(found && found->place);
  EXPECT_EQ(found->choice, session.question()->answer);
  EXPECT_LT((*found->place - *place).norm(), 1e-9);
}

/// Each choice that has a mark is chosen at each place where a mark of its own lies: a node in the
/// tree and the middle of its volume in the world, a pair that waits, a place in a plot.
TEST_F(Pointing, AMarkIsWhereItIsDrawn) {
  const std::vector<std::pair<std::string, std::string>> asked = {
      {"hierarchy-collide", "half"},     {"hierarchy-distance", "half"},
      {"hierarchy-large", "half"},       {"sphere-tree", "half"},
      {"hierarchy-orders", "next-pair"}, {"general-growth", "visits"}};
  for (const auto& [lesson, ask] : asked) {
    open(lesson, ask);
    const FrameQuestion question = *session.question();
    for (std::size_t i = 0; i < question.subjects.size(); ++i) {
      if (question.subjects[i].kind == Subject::Kind::none) continue;
      int marks = 0;
      const std::vector<Mark> drawn = session.picture().marks;
      for (const Mark& mark : drawn) {
        const std::optional<MarkPlace> place = place_of(mark);
        if (mark.subject != question.subjects[i] || !place) continue;
        EXPECT_EQ(chosen_at(place->middle), question.choices[i]) << lesson;
        ++marks;
      }
      EXPECT_GE(marks, ask == "half" ? 2 : 1) << lesson << ": " << question.choices[i];
    }
    EXPECT_EQ(chosen_at(session.views()[0].card.min + Point(3.0, 3.0)), "") << lesson;
  }
}

/// A ring at the node and the outline of the volume, for both halves; a stroke for the wrong one.
TEST_F(Pointing, AnAnswerAboutANodeIsDrawnAtItAndAtItsVolume) {
  open("hierarchy-collide", "half");
  const FrameQuestion asked = *session.question();
  session.grade(asked.choices[asked.answer == asked.choices[0] ? 1 : 0]);
  std::map<std::string, std::array<int, 3>> drawn;  // rings, outlines, strokes
  for (const Mark& mark : session.picture().marks) {
    if (!mark.role.starts_with("verdict.")) continue;
    const Polyline* line = std::get_if<Polyline>(&mark.shape);
    ++drawn[mark.role][line == nullptr ? 0 : line->closed ? 1 : 2];
  }
  EXPECT_EQ(drawn["verdict.right"], (std::array{1, 1, 0}));
  EXPECT_EQ(drawn["verdict.wrong"], (std::array{1, 1, 1}));
}

TEST_F(Pointing, BesideEverythingThereIsNoChoice) {
  open("tetrahedron-regions", "region");
  EXPECT_EQ(chosen_at(session.views()[0].card.min + Point(3.0, 60.0)), "");
  session.set_asking(false);
  EXPECT_EQ(chosen_at(on_page(mean_of({0}))), "");
}

}  // namespace pointing_test
}  // namespace gjkscope
