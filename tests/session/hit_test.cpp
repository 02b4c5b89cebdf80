// The subject under the pointer.

#include "session/hit.hpp"

#include <gtest/gtest.h>

#include "fonts.hpp"

namespace gjkscope {
namespace hit_test {

using Kind = Subject::Kind;
using testing::fonts;

TEST(Hit, PointsComeBeforeLinesAndLinesBeforeAreas) {
  Picture picture;
  picture.clips.push_back({{0, 0}, {100, 100}});
  picture.marks = {
      {"area", Polygon{{{0, 0}, {80, 0}, {80, 80}, {0, 80}}}, 0, {Kind::shape_y}},
      {"point", Disk{{40, 40}, 4.0}, 0, {Kind::vertex_of_y, -1, 1}},
      {"line", Polyline{{{0, 40}, {80, 40}}}, 0, {Kind::shape_x}},
      {"no subject", Disk{{10, 10}, 30.0}, 0, {}},
  };
  const auto at = [&](double x, double y) { return subject_at(picture, fonts(), {x, y}, 5.0); };
  EXPECT_EQ((Subject{Kind::vertex_of_y, -1, 1}), at(42, 41));
  EXPECT_EQ(Subject{Kind::shape_x}, at(20, 42));
  EXPECT_EQ(Subject{Kind::shape_y}, at(20, 60));
  EXPECT_EQ(Subject{}, at(90, 90));
}

TEST(Hit, TheNearerOfTwoPointsIsMeant) {
  Picture picture;
  picture.marks = {{"a", Disk{{40, 40}, 4.0}, -1, {Kind::vertex_of_x, 0}},
                   {"b", Disk{{46, 40}, 4.0}, -1, {Kind::vertex_of_x, 1}}};
  EXPECT_EQ(0, subject_at(picture, fonts(), {41, 40}, 7.0).x);
  EXPECT_EQ(1, subject_at(picture, fonts(), {45, 40}, 7.0).x);
}

TEST(Hit, WithAVolumeOfATreeItsShapeIsTaken) {
  EXPECT_EQ(held({Kind::tree_node, 3}).kind, Kind::shape_x);
  EXPECT_EQ(held({Kind::tree_node, -1, 3}).kind, Kind::shape_y);
  const Subject vertex{Kind::vertex_of_x, 2};
  EXPECT_EQ(held(vertex), vertex);
}

TEST(Hit, WhatIsCutOffIsNotHit) {
  Picture picture;
  picture.clips.push_back({{0, 0}, {20, 20}});
  picture.marks = {{"a", Disk{{30, 10}, 4.0}, 0, {Kind::vertex_of_x, 0}}};
  EXPECT_EQ(Subject{}, subject_at(picture, fonts(), {30, 10}, 7.0));
}

TEST(Hit, WhatACloseUpHidesIsNotHit) {
  Picture picture;
  picture.clips = {{{0, 0}, {100, 100}}, {{50, 50}, {90, 90}}};
  picture.marks = {{"hidden", Disk{{60, 60}, 4.0}, 0, {Kind::vertex_of_x, 0}},
                   {"in it", Disk{{80, 80}, 4.0}, 1, {}},
                   {"beside", Disk{{20, 20}, 4.0}, 0, {Kind::vertex_of_x, 1}}};
  EXPECT_EQ(Subject{}, subject_at(picture, fonts(), {60, 60}, 5.0));
  EXPECT_EQ((Subject{Kind::vertex_of_x, 1}), subject_at(picture, fonts(), {20, 20}, 5.0));
}

TEST(Hit, ADifferenceIsLinkedToTheVerticesThatMadeIt) {
  const Subject pair{Kind::difference_vertex, 2, 3};
  EXPECT_TRUE(is_linked(pair, {Kind::vertex_of_x, 2}));
  EXPECT_TRUE(is_linked({Kind::vertex_of_y, -1, 3}, pair));
  EXPECT_FALSE(is_linked(pair, {Kind::vertex_of_x, 3}));
  EXPECT_FALSE(is_linked({Kind::vertex_of_x, 2}, {Kind::vertex_of_y, -1, 3}));
  EXPECT_FALSE(is_linked({}, {}));
}

}  // namespace hit_test
}  // namespace gjkscope
