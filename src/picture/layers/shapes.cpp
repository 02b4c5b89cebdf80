#include <algorithm>
#include <limits>
#include <vector>

#include "effects/motion.hpp"
#include "effects/projection.hpp"
#include "geometry/polygon.hpp"
#include "picture/layers/layers.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using namespace sizes;

/// A shape with more vertices than this is drawn as its outline alone: disks would cover it.
constexpr std::size_t kMostVertexDisks = 256;
/// Names in a view: more would hide the shapes.
constexpr std::size_t kMostNames = 24;

/// Where GJK does not name them, names of more vertices than this would only be in the way, and
/// disks of more vertices hide the line.
constexpr std::size_t kMostLabels = 8;
constexpr std::size_t kMostDisks = 64;

constexpr double kPathNow = 5.0;  // radius: where a shape is on its way

/// Without the points that are less than `apart` pixels from the one before.
std::vector<Point> told_apart(const std::vector<Point>& points, double apart) {
  std::vector<Point> out;
  for (const Point& point : points) {
    if (out.empty() || (point - out.back()).norm() >= apart) out.push_back(point);
  }
  return out;
}

/// A shape of several outlines: what is solid, then its holes.
void outlines(SceneBuilder& scene, const LessonShape& shape, const std::vector<Vector2d>& world,
              const std::string& role, const Subject& whole) {
  for (const bool holes : {false, true}) {
    for (const auto& [first, count] : shape.ranges()) {
      const std::vector<Vector2d> corners(world.begin() + first, world.begin() + first + count);
      if ((signed_area(corners) < 0.0) != holes) continue;
      for (const auto& [a, b, c] : triangles(corners)) {
        const auto at = [&](int i) { return scene.at(corners[static_cast<std::size_t>(i)]); };
        scene.area(holes ? "hole" : role + ".fill", {at(a), at(b), at(c)},
                   holes ? Subject{} : whole);
      }
      std::vector<Point> line;
      for (const Vector2d& corner : corners) line.push_back(scene.at(corner));
      scene.add(role, Polyline{line, true}, whole);
      scene.outline(line);
    }
  }
}

/// The vertices of a shape that the run ever looks at: those of all its simplices and support
/// points. They are the same in each frame of the run, so names neither come nor go between steps.
std::vector<bool> vertices_of_run(const SceneBuilder& scene, bool is_x, std::size_t count) {
  std::vector<bool> met(count, false);
  const auto meet = [&](const gjk::State<double, 2>& state) {
    const auto note = [&](const gjk::SupportPoint<double, 2>& vertex) {
      met[static_cast<std::size_t>(is_x ? vertex.pair.x : vertex.pair.y)] = true;
    };
    for (int i = 0; i < state.simplex.count; ++i) note(state.simplex.vertices[i]);
  };
  meet(scene.positioned.trace.initial);
  for (const auto& step : scene.positioned.trace.steps) meet(step.after);
  return met;
}

/// The vertices of a shape that have names: all of them where a view has room for that, else those
/// that the run looks at, and then corners that are far from all that have one.
std::vector<bool> named_vertices(const SceneBuilder& scene, std::size_t body,
                                 const std::vector<Vector2d>& world) {
  std::size_t others = 0;
  for (std::size_t i = 0; i < scene.positioned.bodies.size(); ++i)
    others += i == body ? 0 : scene.positioned.bodies[i].world.size();
  if (world.size() + others <= kMostNames) return std::vector<bool>(world.size(), true);
  std::vector<bool> named = vertices_of_run(scene, body == 0, world.size());
  if (world.size() > kMostVertexDisks) return named;

  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<double> to_named(world.size(), kFar);  // squared distances
  const auto measure_from = [&](std::size_t from) {
    for (std::size_t i = 0; i < world.size(); ++i)
      to_named[i] = std::min(to_named[i], (world[i] - world[from]).squaredNorm());
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (!named[i]) continue;
    measure_from(i);
    ++count;
  }
  const std::size_t wanted = kMostNames - std::min(others, kMostNames / 2);
  for (; count < std::min(wanted, world.size()); ++count) {
    const auto farthest = std::max_element(to_named.begin(), to_named.end()) - to_named.begin();
    named[static_cast<std::size_t>(farthest)] = true;
    measure_from(static_cast<std::size_t>(farthest));
  }
  return named;
}

void shape(SceneBuilder& scene, std::size_t body) {
  using Kind = Subject::Kind;
  const Lesson& lesson = scene.run.lesson;
  const bool is_x = body == 0;
  const std::string role = scene.run.point_query() ? "shape" : is_x ? "shape.x" : "shape.y";
  const LessonShape& shape = lesson.bodies[body];
  const std::vector<Vector2d>& world = scene.positioned.bodies[body].world;
  const Subject whole{is_x ? Kind::shape_x : Kind::shape_y};
  std::vector<Point> points;
  for (const Vector2d& vertex : world) points.push_back(scene.at(vertex));
  const bool has_corners = world.size() <= kMostVertexDisks;
  if (!has_corners) points = told_apart(points, 0.5);
  const Point middle = centroid(points);
  if (!shape.outlines.empty()) {
    outlines(scene, shape, world, role, whole);
  } else if (points.size() == 2) {
    scene.line(role, points[0], points[1], whole);
  } else if (points.size() > 2) {
    if (is_convex(world)) {
      scene.area(role, points, whole);
    } else {
      if (has_corners) {
        for (const auto& [a, b, c] : triangles(world))
          scene.area(role + ".fill", {points[a], points[b], points[c]}, whole);
      }
      scene.add(role, Polyline{points, true}, whole);
    }
    // Labels keep as far from a line as the corners that are left out here are apart.
    scene.outline(has_corners ? points : told_apart(points, 4.0));
  }
  const bool has_disks = has_corners && (scene.run.has_gjk() || points.size() <= kMostDisks);
  for (std::size_t i = 0; has_disks && i < points.size(); ++i) {
    const int index = static_cast<int>(i);
    scene.disk(role + ".vertex", points[i], kVertexRadius,
               is_x ? Subject{Kind::vertex_of_x, index} : Subject{Kind::vertex_of_y, -1, index});
  }
  if (!scene.run.has_gjk() && (!has_disks || world.size() > kMostLabels)) return;
  const std::vector<bool> named = scene.run.has_gjk() ? named_vertices(scene, body, world)
                                                      : std::vector<bool>(world.size(), true);
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (!named[i]) continue;
    const Point at = scene.at(world[i]);
    const Point away = world.size() == 1 ? Point::Zero() : Point(at - middle);
    // Beside a vertex that moves, no place is free for good.
    const bool moves = lesson.path_of_shapes && world.size() > 1 &&
                       !lesson.path_of_shapes->motions[body].points.empty();
    auto& labels = moves ? scene.out.moving_labels : scene.out.fixed_labels;
    labels.push_back(scene.label("vertex:" + shape.vertex_names[i], shape.vertex_names[i],
                                 role + ".label", type::kVertex, at, kSimplexRadius, away));
  }
}

void shapes(SceneBuilder& scene) {
  // The query point has a mark of its own.
  const std::size_t first = scene.run.point_query() ? 1 : 0;
  for (std::size_t body = first; body < scene.run.lesson.bodies.size(); ++body) shape(scene, body);
}

}  // namespace

const Layer kShapes{.effect = {}, .on = Layer::On::world, .order = 60, .draw = shapes};

namespace {

/// The end of a way, as an arrow: long enough to be seen, however short the last step is.
void end_of_way(SceneBuilder& scene, const std::vector<Point>& points) {
  constexpr double kLeast = 16.0;
  const auto before = std::find_if(points.rbegin(), points.rend(), [&](const Point& point) {
    return (point - points.back()).norm() >= kLeast;
  });
  if (before != points.rend()) scene.add("path.end", Arrow{*before, points.back()});
}

void path(SceneBuilder& scene) {
  // Arrows stand in place of a way.
  if (!scene.run.lesson.path_of_shapes || scene.shows(LastPosition::kName)) return;
  const LessonPath& path = *scene.run.lesson.path_of_shapes;
  // Without a number of frames a path is a set of places to be in, not a way between them.
  if (path.frames == 0) return;
  for (std::size_t body = 0; body < path.motions.size(); ++body) {
    const Lesson& lesson = scene.run.lesson;
    if (!scene.run.point_query()) {
      const Point middle = scene.at(centroid(scene.positioned.bodies[body].world));
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
      points.push_back(scene.at(centroid(run.bodies[body].world)));
    scene.add("path", Polyline{points});
    for (std::size_t i = 1; i < points.size(); ++i)
      scene.out.obstacles.segments.push_back({points[i - 1], points[i]});
    for (const Point& point : points) scene.disk("path.point", point, 3.0);
    end_of_way(scene, points);
    if (!scene.run.point_query())
      scene.disk("path.now", points[static_cast<std::size_t>(scene.frame.run)], kPathNow);
  }
}

}  // namespace

const Layer kPath{.effect = {}, .on = Layer::On::world, .order = 160, .draw = path};

namespace {

void query_point(SceneBuilder& scene) {
  if (scene.view.kind == ViewKind::world && scene.run.point_query()) {
    const Point q = scene.at(scene.positioned.x().world[0]);
    scene.cross("query", q, kPointRadius, {Subject::Kind::vertex_of_x, 0});
    std::string name = scene.run.lesson.x().vertex_names[0];
    if (scene.shows(Projection::kName)) {
      // Within a pixel of the line, G has no mark of its own.
      const Projection::Value& g = scene.effects.get<Projection>(scene.frame);
      if (g && (scene.at_difference(*g) - q).norm() < 1.0) name = "G = " + name;
    }
    // Along a path, on the side where the line to P is not.
    const bool has_way =
        scene.run.act->sweeps && scene.shows_closest_point() && !scene.reaches_query();
    const Point away = has_way ? Point(q - scene.at_difference(scene.state.p)) : Point::Zero();
    scene.out.moving_labels.push_back(scene.label("Q", scene.reaches_query() ? "P = " + name : name,
                                                  "query.label", type::kVertex, q, kPointRadius,
                                                  away));
  }
  if (scene.view.kind == ViewKind::difference) {
    const Point o = scene.at(Vector2d::Zero());
    scene.add("origin", Cross{o, kOriginRadius});
    scene.out.obstacles.circles.push_back({o, kOriginRadius});
    scene.labels_of_difference().push_back(
        scene.label("O", "O", "origin.label", type::kVertex, o, kOriginRadius));
  }
}

}  // namespace

const Layer kQueryPoint{
    .effect = {}, .on = Layer::On::every_view, .order = 1020, .draw = query_point};

}  // namespace gjkscope::layers
