// Numbers drawn as what they measure.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "picture/words.hpp"
#include "run/facts.hpp"
#include "subjects/lengths/measured.hpp"
#include "subjects/lengths/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace sizes;

constexpr double kAxisOffset = 34.0;  // of an axis from the nearest vertex
constexpr double kFootRadius = 4.0;
constexpr double kNamedApart = 20.0;  // between feet that are both named

/// On which side of a shape its axis has more room: 1 to the right of d on the screen, or -1. It
/// keeps away from the other shape.
double roomier_side(const SceneBuilder& scene, const std::vector<Point>& points,
                    const std::vector<Vector3d>& others, const Point& across) {
  const Rect& area = scene.map.area();
  const auto room = [&](double side) {
    double least = HUGE_VAL;
    double offset = -HUGE_VAL;
    for (const Point& point : points) offset = std::max(offset, side * point.dot(across));
    for (const Vector3d& other : others)
      least = std::min(least, std::abs(side * scene.at(other).dot(across) - offset - kAxisOffset));
    for (const Point& point : points) {
      const Point far = point + side * kAxisOffset * across;
      least = std::min({least, far.x() - area.min.x(), area.max.x() - far.x(),
                        far.y() - area.min.y(), area.max.y() - far.y()});
    }
    return least;
  };
  return room(1.0) >= room(-1.0) ? 1.0 : -1.0;
}

/// A shape's axis along `d`, a line from each vertex to its foot, and the farthest foot marked.
void axis(SceneBuilder& scene, const std::vector<Vector3d>& vertices, const LessonShape& shape,
          const SupportAxis::Side& side, const std::vector<Vector3d>& others, const Vector3d& d,
          const std::string& id) {
  if (vertices.size() < 2) return;
  const Point along = scene.map.direction(d);
  std::vector<Point> points;
  for (const Vector3d& vertex : vertices) points.push_back(scene.at(vertex));
  const Point right(-along.y(), along.x());
  const Point across = roomier_side(scene, points, others, right) * right;
  double offset = -HUGE_VAL;
  double last = -HUGE_VAL;
  double first = HUGE_VAL;
  for (const Point& point : points) {
    offset = std::max(offset, point.dot(across) + kAxisOffset);
    first = std::min(first, point.dot(along));
    last = std::max(last, point.dot(along));
  }
  const auto on_axis = [&](double at) { return Point(at * along + offset * across); };
  scene.arrow("support.axis", on_axis(first - 18.0), on_axis(last + 34.0));
  scene.out.moving_labels.push_back(scene.label(id + ":axis", id, "support.axis.label",
                                                type::kSmallVertex, on_axis(last + 34.0), 4.0,
                                                along));
  std::vector<double> named;
  std::vector<std::size_t> order = {static_cast<std::size_t>(side.farthest)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i != order.front()) order.push_back(i);
  }
  for (const std::size_t i : order) {
    const double at = points[i].dot(along);
    const Point foot = on_axis(at);
    const bool wins = i == order.front();
    scene.line(wins ? "support.plane" : "support.axis.link", points[i], foot);
    if (wins)
      scene.diamond("support", foot, 7.0);
    else
      scene.square("support.axis.foot", foot, kFootRadius);
    const bool apart = std::none_of(named.begin(), named.end(), [&](double other) {
      return std::abs(other - at) < kNamedApart;
    });
    if (!apart) continue;
    named.push_back(at);
    scene.out.moving_labels.push_back(scene.label(id + ":foot:" + shape.vertex_names[i],
                                                  shape.vertex_names[i],
                                                  wins ? "support.label" : "support.axis.label",
                                                  type::kSmallVertex, foot, kFootRadius, across));
  }
}

void support_axis(SceneBuilder& scene) {
  const SupportAxis::Value& sides = scene.effects.get<SupportAxis>(scene.frame);
  const bool is_in_parts = support_part(scene.run, scene.frame).has_value();
  if (!sides || !(is_in_parts || scene.knows.phase_is(gjk::Phase::support))) return;
  const Lesson& lesson = scene.run.lesson;
  const SupportPart reached = support_part(scene.run, scene.frame).value_or(SupportPart::of_z);
  if (reached == SupportPart::of_y || reached == SupportPart::of_z)
    axis(scene, scene.positioned.y().world, lesson.y(), sides->y, scene.positioned.x().world,
         sides->d, "along d");
  if (reached >= SupportPart::of_x)
    axis(scene, scene.positioned.x().world, lesson.x(), sides->x, scene.positioned.y().world,
         -sides->d, "along −d");
}

void closest_circle(SceneBuilder& scene) {
  const ClosestCircle::Value& radius = scene.effects.get<ClosestCircle>(scene.frame);
  if (!radius || !scene.shows_difference) return;
  constexpr int kCorners = 96;
  Polyline circle{{}, true};
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    circle.points.push_back(
        scene.at_difference(*radius * Vector2d(std::cos(angle), std::sin(angle))));
  }
  scene.passing_outline(circle.points);
  scene.add("closest.circle", std::move(circle));
}

/// The foot on an edge's line, and the length that the coordinate measures, `row` rows beside it.
void tested_foot(SceneBuilder& scene, const TestedFeet::Foot& foot, int row) {
  const Point q = scene.at_difference(Vector2d::Zero());
  const Point at = scene.at_difference(foot.at);
  const Point zero = scene.vertex_at(foot.other);
  const Point one = scene.vertex_at(foot.vertex);
  const Point along = (one - zero).normalized();
  if (row == 1) {
    const double reach = scene.map.area().size().norm();
    scene.line("projection.axis", zero, zero - reach * along);
    scene.line("projection.axis", one, one + reach * along);
    if ((q - at).norm() > 1.0) scene.line("projection.line", q, at);
    scene.square("projection.point", at, kFootRadius + 1.0);
  }
  const SimplexWords words(scene.run, scene.state.simplex);
  Point normal(along.y(), -along.x());
  if (normal.dot(q - at) > 0.0) normal = -normal;
  const Point offset = row * kLengthOffset * normal;
  const auto edge = static_cast<gjk::Face>(gjk::face_of(foot.vertex) | gjk::face_of(foot.other));
  const std::string name = words.coordinate(edge, foot.vertex);  // "uBC"
  const std::string role = fmt::format("area.{}.length", name[0]);
  if ((at - zero).norm() > 1.0) scene.arrow(role, zero + offset, at + offset);
  LabelRequest label =
      scene.label(fmt::format("foot:{}:{}", foot.vertex, foot.other),
                  fmt::format("{} = {}", name, Numbers(scene.run.lesson).weight(foot.value)),
                  "area.label", type::kSmallVertex, 0.5 * (zero + at) + offset, 3.0, normal);
  label.other_anchors = {0.25 * zero + 0.75 * at + offset, 0.75 * zero + 0.25 * at + offset};
  scene.out.moving_labels.push_back(std::move(label));
}

/// The border of a half-plane through `at`, with ticks on the side `towards`.
void half_plane(SceneBuilder& scene, const Point& at, const Point& towards) {
  const Point along(-towards.y(), towards.x());
  const Point reach = scene.map.area().size().norm() * along;
  scene.line("condition", at - reach, at + reach);
  ticks(scene, "condition.hatch", at - reach, at + reach, towards);
}

/// Draws the half-plane on which each condition of the tested region is met.
void conditions(SceneBuilder& scene, const TestedFeet::Value& feet) {
  const gjk::Face region = scene.knows.region_tests[scene.knows.tests_reached].region;
  const bool of_vertex = gjk::vertex_count(region) == 1;
  for (const TestedFeet::Foot& foot : feet) {
    const Point zero = scene.vertex_at(foot.other);
    const Point along = (scene.vertex_at(foot.vertex) - zero).normalized();
    half_plane(scene, zero, of_vertex ? Point(-along) : along);
  }
  if (of_vertex || scene.state.simplex.count != 3 || feet.empty()) return;
  const Point a = scene.vertex_at(feet[0].vertex);
  const Point along = (scene.vertex_at(feet[0].other) - a).normalized();
  const Point third = scene.vertex_at(3 - feet[0].vertex - feet[0].other);
  Point beyond(along.y(), -along.x());
  if (beyond.dot(third - a) > 0.0) beyond = -beyond;
  half_plane(scene, a, beyond);
}

void tested_feet(SceneBuilder& scene) {
  const TestedFeet::Value& feet = scene.effects.get<TestedFeet>(scene.frame);
  if (!feet.empty()) conditions(scene, feet);
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const bool same_edge =
        i > 0 && feet[i].vertex == feet[i - 1].other && feet[i].other == feet[i - 1].vertex;
    tested_foot(scene, feet[i], same_edge ? 2 : 1);
  }
}

}  // namespace

void ticks(SceneBuilder& scene, const std::string& role, const Point& a, const Point& b,
           const Point& towards) {
  constexpr double kSpacing = 11.0;
  constexpr double kLean = 0.6;  // of a tick's height
  constexpr double kHeight = 9.0;
  const double length = (b - a).norm();
  const Point along = (b - a) / length;
  const Eigen::AlignedBox2d seen(scene.map.area().min, scene.map.area().max);
  for (double t = 0.0; t < length; t += kSpacing) {
    const Point from = a + t * along;
    if (seen.contains(from))
      scene.add(role, Polyline{{from, from + kHeight * (towards + kLean * along)}});
  }
}

const Layer kSupportAxis{.effect = gjkscope::SupportAxis::kName,
                         .on = Layer::On::world,
                         .order = 110,
                         .draw = support_axis};
const Layer kClosestCircle{.effect = gjkscope::ClosestCircle::kName,
                           .on = Layer::On::every_view,
                           .order = 90,
                           .draw = closest_circle};
const Layer kTestedFeet{.effect = gjkscope::TestedFeet::kName,
                        .on = Layer::On::every_view,
                        .order = 95,
                        .draw = tested_feet};

}  // namespace gjkscope::layers
