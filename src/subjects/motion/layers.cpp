#include <algorithm>

#include "outlines/polygon.hpp"
#include "run/questions.hpp"
#include "subjects/motion/motion.hpp"
#include "subjects/motion/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;

constexpr double kPathNow = 5.0;  // radius of the mark of a shape's place on its way

std::vector<Point> placed(const SceneBuilder& scene, const std::vector<Vector2d>& polygon) {
  std::vector<Point> points;
  for (const Vector2d& point : polygon) points.push_back(scene.at(point));
  return points;
}

/// A shape where it was, and an arrow for how far it went.
void ghost(SceneBuilder& scene, const std::vector<Vector2d>& polygon, const Vector2d& by,
           bool slid) {
  if (by.norm() == 0.0 && slid) return;
  const std::vector<Point> points = placed(scene, polygon);
  if (points.size() > 1) scene.add("ghost", Polyline{points, points.size() > 2});
  if (points.size() == 1) scene.disk("ghost", points[0], sizes::kVertexRadius);
  for (std::size_t i = 0; i < points.size(); ++i)
    scene.out.obstacles.passing.push_back({points[i], points[(i + 1) % points.size()]});
  if (!slid || by.norm() == 0.0) return;
  const Vector2d middle = centroid(polygon);
  scene.arrow("ghost.arrow", scene.at(middle), scene.at(middle + by));
}

/// X moved by s and Y by t meet exactly when Z, as it was before, holds this point.
void difference_of_moves(SceneBuilder& scene, const LastPosition::Positions& moved) {
  const Vector2d difference = moved.x_by - moved.y_by;
  if (moved.turned || difference.norm() == 0.0) return;
  const Point o = scene.at(Vector2d::Zero());
  const Point at = scene.at(difference);
  scene.line("projection.line", o, at);
  scene.disk("cloud.current", at, sizes::kTouchedRadius);
  scene.out.moving_labels.push_back(scene.label("moves", "s − t", "cloud.label", type::kVertex, at,
                                                sizes::kTouchedRadius, at - o));
}

/// Arrows of the move that a question is about.
void coming_move(SceneBuilder& scene, bool marks_difference) {
  const LastPosition::Value& next = scene.effects.get<LastPosition>({.run = scene.frame.run + 1});
  if (scene.shows_difference) {
    if (marks_difference) difference_of_moves(scene, *next);
    return;
  }
  const auto arrow = [&](const std::vector<Vector2d>& polygon, const Vector2d& by) {
    const Vector2d middle = centroid(polygon);
    if (by.norm() > 0.0)
      scene.arrow("ghost.arrow", scene.at(middle), scene.at(Vector2d(middle + by)));
  };
  arrow(next->x, next->x_by);
  arrow(next->y, next->y_by);
}

void last_position(SceneBuilder& scene) {
  if (scene.frame.question >= 0) {
    const std::string& ask = scene.run.asked(scene.frame).ask;
    const bool marks_difference = ask == asks::kHolds.name;
    if (marks_difference || ask == asks::kSlide.name) return coming_move(scene, marks_difference);
  }
  const LastPosition::Value& last = scene.effects.get<LastPosition>(scene.frame);
  if (!last) return;
  if (scene.shows_difference) {
    ghost(scene, last->z, last->y_by - last->x_by, !last->turned);
    difference_of_moves(scene, *last);
  } else {
    ghost(scene, last->x, last->x_by, true);
    ghost(scene, last->y, last->y_by, !last->turned);
  }
}

}  // namespace

const Layer kLastPosition{.effect = gjkscope::LastPosition::kName,
                          .on = Layer::On::every_view,
                          .order = 130,
                          .draw = last_position};

namespace {

void grown_obstacle(SceneBuilder& scene) {
  const std::vector<Point> grown = placed(scene, scene.effects.get<GrownObstacle>(scene.frame));
  scene.area("grown", grown);
  scene.outline(grown);
  const WideResult& result = scene.positioned.trace.result;
  const Vector2d position = in_plane(scene.positioned.x().placement.translate);
  const Point p = scene.at(position);
  if (result.distance > 0.0 && scene.frame.question < 0) {
    // P of the difference, moved by where X stands.
    const Point nearest = scene.at(in_plane(result.y - result.x) + position);
    scene.line("closest.line", p, nearest);
    scene.disk("closest", nearest, sizes::kClosestRadius);
  }
  const Point far = *std::max_element(
      grown.begin(), grown.end(),
      [&](const Point& a, const Point& b) { return (a - p).norm() < (b - p).norm(); });
  scene.out.moving_labels.push_back(scene.label("grown", "grown " + scene.run.lesson.y().name,
                                                "hull.label", type::kSmallVertex, far, 2.0,
                                                far - p));
  scene.cross("query", p, sizes::kPointRadius);
  scene.out.moving_labels.push_back(
      scene.label("reference", "p", "query.label", type::kVertex, p, sizes::kPointRadius));
}

}  // namespace

const Layer kGrownObstacle{.effect = gjkscope::GrownObstacle::kName,
                           .on = Layer::On::every_view,
                           .order = 120,
                           .draw = grown_obstacle};

namespace {

/// The end of a way, as an arrow: long enough to be seen, however short the last step is.
void end_of_path(SceneBuilder& scene, const std::vector<Point>& points) {
  constexpr double kLeast = 16.0;
  const auto before = std::find_if(points.rbegin(), points.rend(), [&](const Point& point) {
    return (point - points.back()).norm() >= kLeast;
  });
  if (before != points.rend()) scene.add("path.end", Arrow{*before, points.back()});
}

/// The middle of a shape; in space of its vertices.
Point middle_of(const SceneBuilder& scene, const Body& body) {
  if (scene.run.lesson.dimension == 2) return scene.at(centroid(in_plane(body.world)));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : body.world) sum += vertex;
  return scene.at(sum / static_cast<double>(body.world.size()));
}

void path(SceneBuilder& scene) {
  // Arrows from the last position take the place of the path.
  if (!scene.run.lesson.path_of_shapes || scene.shows(LastPosition::kName)) return;
  const LessonPath& path = *scene.run.lesson.path_of_shapes;
  // Without a number of frames a path is a set of places to be in, not a way between them.
  if (path.frames == 0) return;
  for (std::size_t body = 0; body < path.motions.size(); ++body) {
    const Lesson& lesson = scene.run.lesson;
    // In space the names of vertices tell whose they are.
    if (!scene.run.point_query() && scene.run.lesson.dimension == 2) {
      const Point middle = middle_of(scene, scene.positioned.bodies[body]);
      const std::string& name = lesson.bodies[body].name;
      const bool moves = !path.motions[body].points.empty();
      auto& labels = moves ? scene.out.moving_labels : scene.out.fixed_labels;
      labels.push_back(scene.label("shape:" + name, name,
                                   body == 0 ? "shape.x.label" : "shape.y.label", type::kVertex,
                                   middle, kPathNow));
    }
    if (path.motions[body].points.empty()) continue;
    std::vector<Point> points;
    for (const PositionedRun& run : scene.run.runs)
      points.push_back(middle_of(scene, run.bodies[body]));
    scene.add("path", Polyline{points});
    for (std::size_t i = 1; i < points.size(); ++i)
      scene.out.obstacles.segments.push_back({points[i - 1], points[i]});
    for (const Point& point : points) scene.disk("path.point", point, 3.0);
    end_of_path(scene, points);
    if (!scene.run.point_query()) scene.disk("path.now", points[scene.frame.run], kPathNow);
  }
}

}  // namespace

const Layer kPath{.effect = {}, .on = Layer::On::world, .order = 160, .draw = path};

}  // namespace gjkscope::layers
