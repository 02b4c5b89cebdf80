// Space drawn with marks: what is hidden is dashed, and regions are those of the run.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "gjk/gjk.hpp"
#include "lessons.hpp"
#include "picture/solid.hpp"
#include "subjects/run/direction_rules.hpp"
#include "subjects/space/region.hpp"
#include "subjects/space/solids.hpp"
#include "subjects/support/slab.hpp"

namespace gjkscope {
namespace space_drawing_test {

using Eigen::Vector3d;
using testing::fonts;
using testing::shipped_lesson;

/// Whether a point lies in a polyhedron, not within `slack` of its faces.
bool is_deep_inside(const Polyhedron& solid, const std::vector<Vector3d>& points,
                    const Vector3d& point, double slack) {
  return std::all_of(solid.faces.begin(), solid.faces.end(), [&](const Polyhedron::Face& face) {
    return face.normal.dot(point - points[static_cast<std::size_t>(face.vertices[0])]) < -slack;
  });
}

TEST(Solids, AVertexIsBehindExactlyWhenTheWayToTheEyeGoesThroughTheBody) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  int behind = 0;
  int before = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Vector3d> points;
    for (int i = 0; i < 10; ++i)
      points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    const Polyhedron solid = hull_in_space(points);
    const Eye eye{180.0 * coordinate(random), 80.0 * coordinate(random)};
    const StageMap map({{0.0, 0.0}, {400.0, 400.0}}, {Vector3d::Zero(), 4.0, 1.0, eye});
    const Vector3d towards = map.axes().row(2).transpose();
    const std::vector<bool> hidden = vertices_behind(map, solid, points.size());
    for (const int vertex : solid.vertices) {
      const auto index = static_cast<std::size_t>(vertex);
      bool passes = false;  // any of many points on the way
      for (double difference = 1e-4; difference < 4.0 && !passes; difference *= 1.2)
        passes = is_deep_inside(solid, points, points[index] + difference * towards, 1e-9);
      EXPECT_EQ(hidden[index], passes);
      ++(passes ? behind : before);
    }
  }
  EXPECT_GT(behind, 50);
  EXPECT_GT(before, 50);
}

/// Whether a ray from a point meets a triangle, all at least `slack` from where that changes;
/// none where it is closer (Möller, Trumbore 1997).
std::optional<bool> meets(const Vector3d& from, const Vector3d& ray, const Vector3d& a,
                          const Vector3d& b, const Vector3d& c, double slack) {
  const Vector3d ab = b - a;
  const Vector3d ac = c - a;
  const double volume = ab.dot(ray.cross(ac));
  if (std::abs(volume) < slack) return std::nullopt;
  const double u = (from - a).dot(ray.cross(ac)) / volume;
  const double v = ray.dot((from - a).cross(ab)) / volume;
  const double difference = ac.dot((from - a).cross(ab)) / volume;
  const double least = std::min({u, v, 1.0 - u - v, difference});
  if (std::abs(least) < slack) return std::nullopt;
  return least > 0.0;
}

/// Casts a ray from a point to the eye: whether it meets a face of the body.
std::optional<bool> hides(const SolidBody& body, const Vector3d& from, const Vector3d& ray) {
  bool met = false;
  for (const Polyhedron::Face& face : body.hull.faces) {
    const auto corner = [&](std::size_t i) {
      return body.points[static_cast<std::size_t>(face.vertices[i])];
    };
    for (std::size_t i = 2; i < face.vertices.size(); ++i) {
      const auto one = meets(from, ray, corner(0), corner(i - 1), corner(i), 1e-4);
      if (!one) return std::nullopt;
      met = met || *one;
    }
  }
  return met;
}

TEST(Solids, PartsOfEdgesBehindAnotherBodyAreThoseWhoseRaysMeetIt) {
  std::mt19937 random(29);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const auto point = [&] {
    const double x = coordinate(random);
    const double y = coordinate(random);
    return Vector3d(x, y, coordinate(random));
  };
  int hidden = 0;
  int seen = 0;
  for (int round = 0; round < 400; ++round) {
    const bool is_plate = round % 4 == 0;
    const Vector3d away = (round % 3) * point();  // many of the pairs overlap
    std::vector<Vector3d> points;
    std::vector<Vector3d> others;
    for (int i = 0; i < 8; ++i) {
      points.push_back(point());
      others.push_back(point());
      if (is_plate) others.back().z() = 0.0;
      others.back() += away;
    }
    const Polyhedron solid = hull_in_space(points);
    const Polyhedron other_hull = hull_in_space(others);
    const SolidBody other{other_hull, others};
    const Eye eye{180.0 * coordinate(random), 80.0 * coordinate(random)};
    const StageMap map({{0.0, 0.0}, {400.0, 400.0}}, {Vector3d::Zero(), 4.0, 1.0, eye});
    for (const Polyhedron::Edge& edge : solid.edges) {
      const Vector3d& from = points[static_cast<std::size_t>(edge.from)];
      const Vector3d& to = points[static_cast<std::size_t>(edge.to)];
      const auto part = part_behind(map, other, from, to);
      for (int i = 0; i < 4; ++i) {
        const double share = 0.5 + 0.5 * coordinate(random);
        const auto expected =
            hides(other, from + share * (to - from), map.axes().row(2).transpose());
        if (!expected) continue;
        EXPECT_EQ(*expected, part && (*part)[0] <= share && share <= (*part)[1])
            << "round " << round << ", share " << share;
        ++(*expected ? hidden : seen);
      }
    }
  }
  EXPECT_GT(hidden, 3000);
  EXPECT_GT(seen, 5000);
}

TEST(Solids, TheBodyBehindIsPaintedFirst) {
  const LessonRun run = run_lesson(shipped_lesson("polyhedra-gjk"));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts());
  const Vector3d difference = run.runs[0].trace.result.y - run.runs[0].trace.result.x;
  for (const double azimuth : {-150.0, -90.0, -30.0, 30.0, 90.0, 150.0}) {
    const Eye eye{azimuth, 15.0};
    CameraOverrides cameras(2);
    cameras[0] = CameraOverride{pictures.views()[0].camera, 1.0};
    cameras[0]->camera.eye = eye;
    pictures.lay_out({}, cameras, LabelScope::frame);
    const Picture picture = pictures.picture(0);
    const auto place = [&](const std::string& role) {
      return std::find_if(picture.marks.begin(), picture.marks.end(),
                          [&](const Mark& mark) {
                            // A body that the other hides in part has its fill alone as a polygon.
                            return (mark.role == role || mark.role == role + ".fill") &&
                                   std::holds_alternative<Polygon>(mark.shape);
                          }) -
             picture.marks.begin();
    };
    const bool y_is_nearer = axes_of(eye).row(2).dot(difference) > 0.0;
    EXPECT_EQ(y_is_nearer, place("shape.x") < place("shape.y")) << azimuth;
  }
}

TEST(RegionSolids, HoldQueryPointsWhoseClosestFaceIsTheirs) {
  const LessonRun run = run_lesson(shipped_lesson("tetrahedron-regions"));
  EffectGraph effects(run);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::set<gjk::Face> seen;
  for (const Frame& frame : run.frames) {
    if (frame.question >= 0) continue;
    const gjk::Face face = run.state(frame).region;
    seen.insert(face);
    const RegionSolid::Value& region = effects.get<RegionSolid>(frame);
    ASSERT_GE(region.hull.faces.size(), 4u);
    EXPECT_TRUE(is_deep_inside(region.hull, region.points, Vector3d::Zero(), 0.0));  // Q itself
    const WideSimplex& simplex = run.run(frame).trace.initial.simplex;
    for (int i = 0; i < 40; ++i) {
      // Any point of the region, as a mean of its corners.
      Vector3d q = Vector3d::Zero();
      double sum = 0.0;
      for (const int corner : region.hull.vertices) {
        const double weight = share(random) * share(random);
        q += weight * region.points[static_cast<std::size_t>(corner)];
        sum += weight;
      }
      q /= sum;
      std::vector<Vector3d> corners;
      for (int k = 0; k < simplex.count; ++k) corners.emplace_back(simplex.vertices[k].w - q);
      gjk::Options options;
      options.start.count = 4;
      for (int k = 0; k < 4; ++k) options.start.pairs[static_cast<std::size_t>(k)] = {0, k};
      const std::vector<Vector3d> origin = {Vector3d::Zero()};
      const auto trace = gjk::trace<double>(gjk::Query<double, 3>{{origin}, {corners}}, options);
      EXPECT_EQ(trace.steps.front().after.region, face);
    }
  }
  EXPECT_EQ(seen.size(), 15u);
}

TEST(Differences, OfTwoPolyhedraAreAllInTheirHull) {
  const LessonRun run = run_lesson(shipped_lesson("polyhedra-gjk"));
  EffectGraph effects(run);
  const DifferenceSolid::Value& z = effects.get<DifferenceSolid>(run.frames[0]);
  for (const Vector3d& x : run.runs[0].x().world) {
    for (const Vector3d& y : run.runs[0].y().world) {
      for (const Polyhedron::Face& face : z.hull.faces) {
        const Vector3d& on = z.points[static_cast<std::size_t>(face.vertices[0])];
        EXPECT_LE(face.normal.dot(y - x - on), 1e-12);
      }
    }
  }
}

TEST(Differences, OfManyVerticesHaveTheSameHullFromFewPairs) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto body = [&](int count) {
    std::vector<Vector3d> points;
    for (int i = 0; i < count; ++i)
      points.push_back(Vector3d(normal(random), normal(random), normal(random)).normalized());
    return points;
  };
  const std::vector<Vector3d> box = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const std::vector<Vector3d> flat = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const std::vector<std::pair<std::vector<Vector3d>, std::vector<Vector3d>>> cases = {
      {body(40), body(60)}, {body(100), box}, {box, box}, {flat, body(30)}, {body(5), body(80)}};
  for (const auto& [x, y] : cases) {
    const Polyhedron of_x = hull_in_space(x);
    const Polyhedron of_y = hull_in_space(y);
    const auto pairs = pairs_of_hull({of_x, x}, {of_y, y});
    EXPECT_LT(pairs.size(), x.size() * y.size());
    std::vector<Vector3d> few;
    for (const gjk::VertexPair& pair : pairs)
      few.emplace_back(y[static_cast<std::size_t>(pair.y)] - x[static_cast<std::size_t>(pair.x)]);
    const Polyhedron hull = hull_in_space(few);
    for (const Vector3d& of : x) {
      for (const Vector3d& at : y) {
        for (const Polyhedron::Face& face : hull.faces) {
          const Vector3d& on = few[static_cast<std::size_t>(face.vertices[0])];
          EXPECT_LE(face.normal.dot(at - of - on), 1e-12);
        }
      }
    }
  }
}

/// Between planes through a vertex of Y and one of X there is no other vertex, and it gets as wide
/// as the distance.
TEST(Slabs, InSpaceAreEmpty) {
  const LessonRun run = run_lesson(shipped_lesson("slab-in-space"));
  EffectGraph effects(run);
  double widest = 0.0;
  for (const Frame& frame : run.frames) {
    const Slab::Value& slab = effects.get<Slab>(frame);
    if (!slab) continue;
    const Vector3d& x = run.run(frame).x().world[static_cast<std::size_t>(slab->support.pair.x)];
    const double side = slab->normal.dot(x);
    for (const Vector3d& each : run.run(frame).x().world)
      EXPECT_GE(slab->normal.dot(each), side - 1e-12);
    for (const Vector3d& each : run.run(frame).y().world)
      EXPECT_LE(slab->normal.dot(each), side - slab->width + 1e-12);
    widest = std::max(widest, slab->width);
  }
  EXPECT_NEAR(widest, run.runs[0].trace.result.distance, 1e-12);
}

TEST(Directions, FromAnEdgeInSpaceMinusPIsFartherFromPerpendicular) {
  const LessonRun run = run_lesson(shipped_lesson("edge-direction"));
  EffectGraph effects(run);
  const auto frame = std::find_if(run.frames.begin(), run.frames.end(), [&](const Frame& each) {
    return each.step >= 0 && run.step(each).phase == gjk::Phase::direction;
  });
  ASSERT_NE(frame, run.frames.end());
  const DirectionRules::Value& rules = effects.get<DirectionRules>(*frame);
  ASSERT_EQ(rules.size(), 2u);
  EXPECT_GT(rules[0].degrees_off, 1.0);
  EXPECT_LT(rules[1].degrees_off, 0.1);
}

TEST(Lengths, SayWhereAViewShowsThemShorter) {
  const LessonRun run = run_lesson(shipped_lesson("polyhedra-witness"));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts());
  const WideResult& result = run.runs[0].trace.result;
  const Vector3d difference = result.y - result.x;
  const auto is_said_from = [&](const Eye& eye) {
    CameraOverrides cameras(run.lesson.views.size());
    cameras[0] = CameraOverride{pictures.views()[0].camera, 1.0};
    cameras[0]->camera.eye = eye;
    pictures.lay_out({}, cameras, LabelScope::frame);
    const Picture picture = pictures.picture(static_cast<int>(run.frames.size()) - 1);
    return std::any_of(picture.marks.begin(), picture.marks.end(), [](const Mark& mark) {
      const auto* text = std::get_if<Text>(&mark.shape);
      return text != nullptr && text->text.find("foreshortened") != std::string::npos;
    });
  };
  constexpr double kDegrees = 57.29577951308232;
  const double along = std::atan2(difference.y(), difference.x()) * kDegrees;
  EXPECT_FALSE(is_said_from(eye_across(difference)));
  EXPECT_TRUE(is_said_from({along + 60.0, 10.0}));
}

}  // namespace space_drawing_test
}  // namespace gjkscope
