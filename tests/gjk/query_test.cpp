// Poses, and the options a query starts with.

#include "gjk/query.hpp"

#include "check.hpp"

namespace {

using gjk::Vec;

gjk::Pose<double, 2> quarter_turn() {
  gjk::Pose<double, 2> pose;
  pose.rotation << 0, -1, 1, 0;
  pose.translation = Vec<double, 2>(10, 20);
  return pose;
}

TEST(turning, "a quarter turn carries x to y; direction_to_local is its inverse") {
  const gjk::Pose<double, 2> pose = quarter_turn();
  const Vec<double, 2> turned = pose.rotated(Vec<double, 2>(1, 0));
  CHECK_EQ(0.0, turned[0]);
  CHECK_EQ(1.0, turned[1]);
  const Vec<double, 2> back = pose.direction_to_local(turned);
  CHECK_EQ(1.0, back[0]);
  CHECK_EQ(0.0, back[1]);
}

TEST(directions, "translation moves points, not directions") {
  const Vec<double, 2> local = quarter_turn().direction_to_local(Vec<double, 2>(0, 3));
  CHECK_EQ(3.0, local[0]);
  CHECK_EQ(0.0, local[1]);
}

TEST(space, "poses turn in space, too") {
  gjk::Pose<float, 3> pose;
  pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Vec<float, 3> turned = pose.rotated(Vec<float, 3>(1, 2, 3));
  CHECK_EQ(-2.0f, turned[0]);
  CHECK_EQ(1.0f, turned[1]);
  CHECK_EQ(3.0f, turned[2]);
}

TEST(defaults, "the default options are the slides': vertices first, start at the first vertices") {
  const gjk::Options options;
  CHECK_EQ(gjk::DirectionRule::perpendicular, options.direction_rule);
  CHECK_EQ(gjk::RegionOrder::vertices_first, options.region_order);
  CHECK_EQ(gjk::StartRule::given, options.start_rule);
  CHECK_EQ(1, options.start_count);
  CHECK(options.start[0] == gjk::VertexPair{});
  CHECK(options.stop_on_repeated_support);
  CHECK(options.stop_on_no_progress);
  CHECK_EQ(0.0, options.tolerance);
}

}  // namespace
