#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "outlines/polygon.hpp"
#include "picture/solid.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/space/solids.hpp"
#include "subjects/weights/projection.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace sizes;

/// Names in a view: more would hide the shapes.
constexpr std::size_t kMostNames = 24;
/// Pixels between corners that have names because they are far apart: about the width of a name, so
/// that most stand beside what they name.
constexpr double kNamesApart = 44.0;
/// Shapes that are not convex and have more corners than this in sight have no fill: triangles are
/// looked for in a time that grows with the square of their number.
constexpr std::size_t kMostFilled = 256;

/// A shape with more vertices than kMostLabels shows the names of few of them; one with more than
/// kMostDisks has no disks, which would hide its outline.
constexpr std::size_t kMostLabels = 8;
constexpr std::size_t kMostDisks = 64;

/// Radius of a vertex that has a name among others that have no disks.
constexpr double kNamedRadius = 3.0;
/// Lines with less room than this, in pixels, would be one mass of colour: they are thin and pale.
constexpr double kDense = 10.0;

/// A shape of several outlines: what is solid, then its holes.
void outlines(SceneBuilder& scene, const LessonShape& shape, const std::vector<Vector2d>& world,
              const std::string& role, const Subject& whole) {
  for (const bool holes : {false, true}) {
    for (const auto& [first, count] : shape.ranges()) {
      const std::vector<Vector2d> corners(world.begin() + first, world.begin() + first + count);
      if ((signed_area(corners) < 0.0) != holes) continue;
      for (const auto& [a, b, c] : triangles(corners)) {
        const auto at = [&](int i) { return scene.at(corners[i]); };
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
  const auto meet = [&](const WideState& state) {
    const auto note = [&](const WideVertex& vertex) {
      met[is_x ? vertex.pair.x : vertex.pair.y] = true;
    };
    for (int i = 0; i < state.simplex.count; ++i) note(state.simplex.vertices[i]);
  };
  meet(scene.positioned.trace.initial);
  for (const auto& step : scene.positioned.trace.steps) meet(step.after);
  return met;
}

/// Tells for each point of a shape whether it is in the view's card.
std::vector<bool> in_sight(const SceneBuilder& scene, const std::vector<Point>& points) {
  const Rect& card = scene.map.area();
  std::vector<bool> out;
  for (const Point& point : points) {
    out.push_back((point.array() >= card.min.array()).all() &&
                  (point.array() <= card.max.array()).all());
  }
  return out;
}

/// Whether a vertex has a name: never, only if there is room beside it, or always.
enum class Named { no, with_room, yes };

/// Chooses the vertices of a shape that have names: all in the view if there is room, else those
/// that the run looks at, and then corners far from all named ones. Vertices within the hull have
/// names only if there is room.
std::vector<Named> names_of_vertices(const SceneBuilder& scene, std::size_t body,
                                     const std::vector<bool>& seen, bool has_room_inside) {
  const auto count_of = [](const std::vector<bool>& of) {
    return static_cast<std::size_t>(std::count(of.begin(), of.end(), true));
  };
  const std::vector<Vector3d>& world = scene.positioned.bodies[body].world;
  std::size_t others = 0;
  for (std::size_t i = 0; i < scene.positioned.bodies.size(); ++i) {
    if (i != body)
      others += count_of(in_sight(scene, scene.mapped(scene.positioned.bodies[i].world)));
  }
  if (count_of(seen) + others <= kMostNames) return std::vector<Named>(world.size(), Named::yes);

  const std::vector<bool> of_run = vertices_of_run(scene, body == 0, world.size());
  std::vector<Named> named;
  for (const bool is_of_run : of_run) named.push_back(is_of_run ? Named::yes : Named::no);
  const std::size_t wanted = kMostNames - std::min(others, kMostNames / 2);
  std::size_t count = count_of(of_run);
  const auto name_far_ones = [&](const std::vector<int>& candidates) {
    std::vector<double> to_named(candidates.size(), std::numeric_limits<double>::infinity());
    const auto measure_from = [&](std::size_t from) {
      for (std::size_t k = 0; k < candidates.size(); ++k) {
        const auto candidate = static_cast<std::size_t>(candidates[k]);
        to_named[k] = std::min(to_named[k], (world[candidate] - world[from]).squaredNorm());
      }
    };
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (named[i] != Named::no) measure_from(i);
    }
    for (; count < wanted && !candidates.empty(); ++count) {
      const auto farthest = std::max_element(to_named.begin(), to_named.end());
      if (scene.map.scale() * std::sqrt(*farthest) < kNamesApart) return;
      const auto next = static_cast<std::size_t>(candidates[farthest - to_named.begin()]);
      named[next] = Named::with_room;
      measure_from(next);
    }
  };
  // Names of corners of the hull stand outside of the shape, and these are what GJK can meet. Those
  // of the difference are made of them.
  std::vector<bool> on_hull(world.size(), false);
  const std::vector<int> corners = scene.map.is_of_space()
                                       ? scene.effects.get<ShapeSolids>(scene.frame)[body].vertices
                                       : convex_hull(in_plane(scene.positioned.bodies[body].world));
  for (const int corner : corners) on_hull[corner] = true;
  for (const bool of_hull : {true, false}) {
    if (!of_hull && !has_room_inside) break;
    std::vector<int> candidates;
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (seen[i] && on_hull[i] == of_hull) candidates.push_back(static_cast<int>(i));
    }
    name_far_ones(candidates);
  }
  return named;
}

/// The radius of the disks of a shape's vertices, in pixels: less where they stand close together,
/// and 0 where disks would hide the outline.
double disk_radius(const std::vector<Point>& points) {
  constexpr double kLeast = 1.5;
  if (points.size() < 2) return kVertexRadius;
  std::vector<double> edges;
  for (std::size_t i = 0; i < points.size(); ++i)
    edges.push_back((points[(i + 1) % points.size()] - points[i]).norm());
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  // Edges that cross each other say little of the room: disks need some between lines, too.
  const double radius = kPartOfRoom * std::min({*middle, room_of(points), room_of_outline(points)});
  return radius < kLeast ? 0.0 : std::min(radius, kVertexRadius);
}

void shape(SceneBuilder& scene, std::size_t body) {
  using Kind = Subject::Kind;
  const Lesson& lesson = scene.run.lesson;
  const bool is_x = body == 0;
  const std::string role = scene.run.point_query() ? "shape" : is_x ? "shape.x" : "shape.y";
  const LessonShape& shape = lesson.bodies[body];
  const std::vector<Vector2d> world = in_plane(scene.positioned.bodies[body].world);
  const Subject whole{is_x ? Kind::shape_x : Kind::shape_y};
  const std::vector<Point> vertices = scene.mapped(world);
  const std::vector<Point> corners = separate_points(vertices);
  const Point middle = centroid(corners);
  if (!shape.outlines.empty()) {
    outlines(scene, shape, world, role, whole);
  } else if (corners.size() == 2) {
    scene.line(role, corners[0], corners[1], whole);
  } else if (corners.size() > 2) {
    if (is_convex(world)) {
      scene.area(role, corners, whole);
    } else {
      if (corners.size() <= kMostFilled) {
        for (const auto& [a, b, c] : triangles(corners))
          scene.area(role + ".fill", {corners[a], corners[b], corners[c]}, whole);
      }
      const bool is_dense = room_of_outline(corners) < kDense;
      scene.add(is_dense ? role + ".dense" : role, Polyline{corners, true}, whole);
    }
    scene.outline(corners);
  }
  const bool counts_hulls = !scene.run.tour->algorithm->takes_outlines;
  const double radius = counts_hulls || world.size() <= kMostDisks ? disk_radius(vertices) : 0.0;
  const std::vector<bool> seen = in_sight(scene, vertices);
  std::vector<Named> named(world.size(), world.size() <= kMostLabels ? Named::yes : Named::no);
  if (counts_hulls) named = names_of_vertices(scene, body, seen, radius > 0.0);
  const Point* last = nullptr;  // that has a disk
  for (std::size_t i = 0; i < world.size(); ++i) {
    const bool touches = last != nullptr && (vertices[i] - *last).norm() < 2.0 * radius + 0.5;
    if (!seen[i] || (named[i] == Named::no && (radius == 0.0 || touches))) continue;
    last = &vertices[i];
    const int index = static_cast<int>(i);
    scene.disk(role + ".vertex", vertices[i], radius > 0.0 ? radius : kNamedRadius,
               is_x ? Subject{Kind::vertex_of_x, index} : Subject{Kind::vertex_of_y, -1, index});
  }
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (named[i] == Named::no) continue;
    const Point& at = vertices[i];
    const Point away = world.size() == 1 ? Point::Zero() : Point(at - middle);
    // Beside a vertex that moves, no place is free for good.
    const bool moves = lesson.path_of_shapes && world.size() > 1 &&
                       !lesson.path_of_shapes->motions[body].points.empty();
    auto& labels = moves ? scene.out.moving_labels : scene.out.fixed_labels;
    labels.push_back(scene.label("vertex:" + shape.vertex_names[i], shape.vertex_names[i],
                                 role + ".label", type::kVertex, at, kSimplexRadius, away));
    labels.back().needs_room = named[i] == Named::with_room;
  }
}

/// A body in space, and its vertices: those behind it, or behind the other body, are hollow, and
/// have pale names.
void solid(SceneBuilder& scene, std::size_t body) {
  using Kind = Subject::Kind;
  const bool is_x = body == 0;
  const std::string role = scene.run.point_query() ? "shape" : is_x ? "shape.x" : "shape.y";
  const std::vector<Vector3d>& world = scene.positioned.bodies[body].world;
  const ShapeSolids::Value& hulls = scene.effects.get<ShapeSolids>(scene.frame);
  const Polyhedron& hull = hulls[body];
  const SolidBody other{hulls[1 - body], scene.positioned.bodies[1 - body].world};
  draw_solid(scene, hull, world, role, {is_x ? Kind::shape_x : Kind::shape_y}, Stuff::body);
  const std::vector<Point> vertices = scene.mapped(world);
  const std::vector<bool> behind = vertices_behind(scene.map, hull, world.size());
  const std::vector<bool> seen = in_sight(scene, vertices);
  const std::vector<Named> named = names_of_vertices(scene, body, seen, false);
  const double radius = std::min(disk_radius(vertices), kPartOfRoom * room_of(vertices));
  const Point middle = centroid(vertices);
  for (std::size_t i = 0; i < world.size(); ++i) {
    // Among many vertices those alone have a mark that frames speak of: names lie on the body.
    if (!seen[i] || (named[i] != Named::yes && radius == 0.0)) continue;
    const int index = static_cast<int>(i);
    const bool is_hidden = behind[i] || part_behind(scene.map, other, world[i], world[i]);
    scene.disk_in_space(
        role + (is_hidden ? ".vertex.hidden" : ".vertex"), world[i],
        radius > 0.0 ? radius : kNamedRadius,
        is_x ? Subject{Kind::vertex_of_x, index} : Subject{Kind::vertex_of_y, -1, index});
    if (named[i] == Named::no) continue;
    const std::string& name = scene.run.lesson.bodies[body].vertex_names[i];
    const Point away = world.size() == 1 ? Point::Zero() : Point(vertices[i] - middle);
    scene.out.fixed_labels.push_back(scene.label("vertex:" + name, name,
                                                 role + (is_hidden ? ".label.hidden" : ".label"),
                                                 type::kVertex, vertices[i], kSimplexRadius, away));
    scene.out.fixed_labels.back().needs_room = named[i] == Named::with_room;
  }
}

/// The body that is farther from the eye comes first, even where neither hides the other.
void solids(SceneBuilder& scene) {
  if (scene.run.point_query()) return solid(scene, 1);
  const WideResult& result = scene.positioned.trace.result;
  const Vector3d difference =
      result.distance > 0.0
          ? Vector3d(result.y - result.x)
          : Vector3d(middle_of(scene.positioned.y().world) - middle_of(scene.positioned.x().world));
  const std::size_t first = scene.map.towards_eye(difference) >= 0.0 ? 0 : 1;
  solid(scene, first);
  solid(scene, 1 - first);
}

void shapes(SceneBuilder& scene) {
  if (scene.map.is_of_space()) return solids(scene);
  // The query point has a mark of its own.
  const std::size_t first = scene.run.point_query() ? 1 : 0;
  for (std::size_t body = first; body < scene.run.lesson.bodies.size(); ++body) shape(scene, body);
}

}  // namespace

void vertex_name(SceneBuilder& scene, const Subject& vertex, bool has_mark) {
  using Kind = Subject::Kind;
  const auto is_one_of = [](int index, const std::vector<Vector3d>& vertices) {
    return index >= 0 && index < static_cast<int>(vertices.size());
  };
  const std::vector<Vector3d>& x = scene.positioned.x().world;
  const std::vector<Vector3d>& y = scene.positioned.y().world;
  if (vertex.kind == Kind::difference_vertex) {
    if (scene.view.kind != ViewKind::difference || !is_one_of(vertex.x, x) ||
        !is_one_of(vertex.y, y))
      return;
    const Point at = scene.at(y[vertex.y] - x[vertex.x]);
    if (!has_mark) scene.disk("cloud.point", at, kCloudRadius, vertex);
    scene.out.moving_labels.push_back(scene.pair_name(
        {vertex.x, vertex.y}, "cloud.label", at, kSimplexRadius, at - scene.map.area().center()));
    return;
  }
  const bool is_x = vertex.kind == Kind::vertex_of_x;
  const int index = is_x ? vertex.x : vertex.y;
  const std::vector<Vector3d>& world = is_x ? x : y;
  // The query point has a name in each frame.
  if (scene.view.kind != ViewKind::world || !is_one_of(index, world) ||
      (is_x && scene.run.point_query()))
    return;
  const std::string role = scene.run.point_query() ? "shape" : is_x ? "shape.x" : "shape.y";
  const std::string& name = scene.run.lesson.bodies[is_x ? 0 : 1].vertex_names[index];
  const Point at = scene.at(world[index]);
  if (!has_mark) scene.disk(role + ".vertex", at, kNamedRadius, vertex);
  scene.out.moving_labels.push_back(scene.label("vertex:" + name, name, role + ".label",
                                                type::kVertex, at, kSimplexRadius,
                                                at - scene.at(middle_of(world))));
}

const Layer kShapes{.effect = {},
                    .on = Layer::On::world,
                    .order = 60,
                    .draw = shapes,
                    .key = [](const auto& scene) {
                      return EffectKey{scene.frame.run, -1, -1};
                    }};

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
    const bool has_gap =
        scene.run.tour->sweeps && shows_closest_point(scene) && !reaches_query(scene);
    const Point away = has_gap ? Point(q - scene.at_difference(scene.state.p)) : Point::Zero();
    scene.out.moving_labels.push_back(scene.label("Q", reaches_query(scene) ? "P = " + name : name,
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
