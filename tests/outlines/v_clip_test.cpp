// The walk on features in space: exact answers for bodies of all kinds, each rule where it is
// needed, and O(1) pairs from the last answer.

#include "outlines/v_clip.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "v_clip_truth.hpp"

namespace test::v_clip_test {

using namespace v_clip_truth;
using Points = std::vector<Vector3d>;

Points box(const Vector3d& low, const Vector3d& high) {
  Points out;
  for (const double x : {low.x(), high.x()}) {
    for (const double y : {low.y(), high.y()}) {
      for (const double z : {low.z(), high.z()}) out.emplace_back(x, y, z);
    }
  }
  return out;
}

/// The face with this normal, which lies along an axis.
Feature face_toward(const Body& body, const Vector3d& normal) {
  for (std::size_t i = 0; i < body.faces.size(); ++i) {
    const Points corners = corners_of(body, {Kind::face, static_cast<int>(i)});
    const Vector3d found = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (found.normalized() == normal) return {Kind::face, static_cast<int>(i)};
  }
  ADD_FAILURE() << "no such face";
  return {};
}

Feature edge_between(const Body& body, const Vector3d& a, const Vector3d& b) {
  for (std::size_t i = 0; i < body.edges.size(); ++i) {
    const Points ends = corners_of(body, {Kind::edge, static_cast<int>(i)});
    if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a))
      return {Kind::edge, static_cast<int>(i)};
  }
  ADD_FAILURE() << "no such edge";
  return {};
}

std::vector<Reason> reasons_of(const v_clip::Trace& trace) {
  std::vector<Reason> out;
  for (const v_clip::Step& step : trace.steps) {
    if (step.phase != v_clip::Phase::swap && step.after.next.reason != Reason::none)
      out.push_back(step.after.next.reason);
  }
  return out;
}

TEST(VClip, FindsTheClosestFeaturesOfAllFamiliesFromAnyFeatures) {
  Row all;
  for (int family = 0; family < kFamilies; ++family) {
    const Row row = check_family(family, 2026 + static_cast<std::uint64_t>(family), 100);
    EXPECT_EQ(row.broken, 0) << family_name(family);
    for (const std::string& failure : row.failures) ADD_FAILURE() << failure;
    all.add(row);
  }
  EXPECT_GT(all.overlaps, all.pairs / 5);
  EXPECT_LT(all.overlaps, all.pairs * 4 / 5);
  for (std::size_t kind = 0; kind < 4; ++kind) EXPECT_GT(all.kinds[kind], all.pairs / 50) << kind;
  for (std::size_t reason = 1; reason < all.reasons.size(); ++reason)
    EXPECT_GT(all.reasons[reason], 20) << "reason " << reason;
}

TEST(VClip, ABodyKnowsWhatLiesBesideWhat) {
  families::Source source(3);
  for (int family = 0; family < kFamilies; ++family) {
    for (const Points& points : points_of(source, family)) {
      const Body body = v_clip::body_of(points);
      for (std::size_t f = 0; f < body.faces.size(); ++f) {
        const auto& face = body.faces[f];
        for (std::size_t i = 0; i < face.vertices.size(); ++i) {
          const auto& edge = body.edges[static_cast<std::size_t>(face.edges[i])];
          const bool forward = edge.from == face.vertices[i];
          EXPECT_EQ(forward ? edge.to : edge.from, face.vertices[(i + 1) % face.vertices.size()]);
          EXPECT_EQ(forward ? edge.left : edge.right, static_cast<int>(f));
        }
      }
      for (const int v : body.vertices) {
        const std::vector<int>& spokes = body.spokes[static_cast<std::size_t>(v)];
        EXPECT_EQ(std::set<int>(spokes.begin(), spokes.end()).size(), spokes.size());
        for (std::size_t i = 0; i < spokes.size() && spokes.size() > 2; ++i) {
          const auto& a = body.edges[static_cast<std::size_t>(spokes[i])];
          const auto& b = body.edges[static_cast<std::size_t>(spokes[(i + 1) % spokes.size()])];
          EXPECT_EQ(a.from == v ? a.left : a.right, b.from == v ? b.right : b.left);
        }
      }
    }
  }
}

TEST(VClip, AVertexBehindAFaceLeavesTheLocalMinimumOrLiesInside) {
  const Body x = v_clip::body_of(box({0, 0, 0}, {4, 4, 4}));
  const Body above = v_clip::body_of({{1, 2, 6}});
  const Feature bottom = face_toward(x, -Vector3d::UnitZ());
  const v_clip::Trace trace = v_clip::trace({x, above}, v_clip::start({x, above}, bottom, {}));
  EXPECT_EQ(reasons_of(trace), std::vector<Reason>{Reason::behind_face});
  EXPECT_EQ(trace.result.stop, Stop::closest);
  EXPECT_EQ(trace.result.x, face_toward(x, Vector3d::UnitZ()));
  EXPECT_EQ(trace.result.points.distance, 2.0);
  EXPECT_EQ(trace.steps[1].record.faces_asked, 6);

  const Body within = v_clip::body_of({{1, 2, 3}});
  const v_clip::Result result = v_clip::walk({x, within}, v_clip::start({x, within}, bottom, {}));
  EXPECT_EQ(result.reason, Reason::inside);
  EXPECT_EQ(result.points.x, Vector3d(1, 2, 3));
}

TEST(VClip, AnEdgeIsClippedAgainstAFace) {
  const Body x = v_clip::body_of(box({0, 0, 0}, {4, 4, 4}));
  const Feature top = face_toward(x, Vector3d::UnitZ());
  const Vector3d a(2, 2, 8);
  const auto walk_of = [&](const Vector3d& b) {
    const Body y = v_clip::body_of({a, b});
    return v_clip::trace({x, y}, v_clip::start({x, y}, top, {Kind::edge, 0}));
  };
  // Over the face until its end, beyond a side, and through the face.
  const v_clip::Trace end = walk_of({3, 2, 6});
  EXPECT_EQ(reasons_of(end), std::vector<Reason>{Reason::clip_end});
  EXPECT_EQ(end.result.points.distance, 2.0);
  const v_clip::Trace side = walk_of({6, 2, 4});
  EXPECT_EQ(reasons_of(side).front(), Reason::clip_side);
  EXPECT_EQ(side.steps[1].after.x, edge_between(x, {4, 0, 4}, {4, 4, 4}));
  ASSERT_TRUE(side.steps[0].record.clip.has_value());
  EXPECT_EQ(side.steps[0].record.clip->from, 0.0);
  EXPECT_EQ(side.steps[0].record.clip->to, 0.5);
  const v_clip::Trace through = walk_of({2, 2, 0.5});
  EXPECT_EQ(reasons_of(through), std::vector<Reason>{Reason::penetration});
  EXPECT_EQ(through.result.points.x, Vector3d(2, 2, 4));
  const v_clip::Trace beside =
      v_clip::trace({x, v_clip::body_of({{6, 1, 8}, {6, 3, 5}})},
                    {v_clip::Phase::closest, top, {Kind::edge, 0}, {}, 0, Stop::running});
  EXPECT_EQ(reasons_of(beside).front(), Reason::clip_empty);
  EXPECT_EQ(beside.result.stop, Stop::closest);
}

TEST(VClip, FlatAndThinBodiesAreBodies) {
  const Body square = v_clip::body_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(square.faces.size(), 2u);
  for (const double z : {-3.0, 3.0}) {
    const Body point = v_clip::body_of({{1, 0.5, z}});
    for (const int face : {0, 1}) {
      const v_clip::Result result =
          v_clip::walk({square, point}, v_clip::start({square, point}, {Kind::face, face}, {}));
      EXPECT_EQ(result.stop, Stop::closest);
      EXPECT_EQ(result.x.kind, Kind::face);
      EXPECT_EQ(result.points.distance, 3.0);
    }
  }
  const Body segment = v_clip::body_of({{1, 1, 1}, {1, 1, -1}});
  EXPECT_EQ(v_clip::walk({square, segment}, v_clip::start({square, segment})).stop, Stop::overlap);
  const Body across = v_clip::body_of({{0, 1, 0}, {2, 1, 0}});
  EXPECT_EQ(v_clip::walk({segment, across}, v_clip::start({segment, across})).reason, Reason::meet);
}

/// Multiples of 2^-30 below 2^10 can be added without rounding.
double snapped(double value) { return std::nearbyint(value * 0x1p30) * 0x1p-30; }

Points round_body(families::Source& source, int count) {
  Points out;
  while (static_cast<int>(out.size()) < count) {
    const double x = source.between(-1, 1);
    const double y = source.between(-1, 1);
    const Vector3d p(x, y, source.between(-1, 1));
    if (p.norm() < 0.1 || p.norm() > 1) continue;
    out.push_back((p / p.norm()).unaryExpr([](double value) { return snapped(value); }));
  }
  return out;
}

/// A cone's base or a drum: faces of many sides, and a vertex of many edges.
Points pyramid(int sides) {
  Points out = {{0, 0, 0.5}};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * 3.14159265358979 * i / sides;
    out.emplace_back(snapped(std::cos(angle)), snapped(std::sin(angle)), -0.5);
  }
  return out;
}

/// Moves y around x in steps of `angle`, and counts the pairs of each walk from the last answer.
struct Counts {
  int cold = 0;
  int most = 0;
  double mean = 0.0;
};
Counts around(const Body& x, Body y, double distance, double angle) {
  constexpr int kSteps = 150;
  Counts out;
  const Points rest = y.points;
  v_clip::Result last;
  for (int k = 0; k <= kSteps; ++k) {
    const double t = angle * k;
    const Vector3d by(snapped(distance * std::cos(t) * std::cos(0.7 * t)),
                      snapped(distance * std::sin(t) * std::cos(0.7 * t)),
                      snapped(distance * std::sin(0.7 * t)));
    for (std::size_t i = 0; i < rest.size(); ++i) y.points[i] = rest[i] + by;
    const Query query{x, y};
    last =
        v_clip::walk(query, k == 0 ? v_clip::start(query) : v_clip::start(query, last.x, last.y));
    EXPECT_EQ(last.stop, Stop::closest);
    if (k == 0) {
      out.cold = last.pairs;
    } else {
      out.most = std::max(out.most, last.pairs);
      out.mean += static_cast<double>(last.pairs) / kSteps;
    }
    EXPECT_EQ(v_clip::walk(query, v_clip::start(query, last.x, last.y)).pairs, 1);
  }
  return out;
}

TEST(VClip, FromTheLastAnswerItTakesAsFewPairsHoweverManyVerticesThereAre) {
  families::Source source(5);
  Counts of_round;
  for (const int count : {8, 100, 1000, 10000}) {
    const Body body = v_clip::body_of(round_body(source, count));
    const Counts counts = around(body, body, 2.2, 0.5 / std::sqrt(count));
    EXPECT_LE(counts.most, 15) << count;
    EXPECT_LE(counts.mean, 4.0) << count;
    EXPECT_GE(counts.mean, 1.1) << count << ": the features must change on the way";
    of_round = counts;
  }
  EXPECT_GT(of_round.cold, 100) << "a cold start walks";
  for (const int count : {8, 100, 1000, 10000}) {
    const Body body = v_clip::body_of(pyramid(count - 1));
    const Counts counts = around(body, body, 2.5, 2.0 / count);
    EXPECT_LE(counts.most, 10) << count;
    EXPECT_LE(counts.mean, 4.0) << count;
    EXPECT_GE(counts.mean, 1.1) << count << ": the features must change on the way";
  }
}

}  // namespace test::v_clip_test
