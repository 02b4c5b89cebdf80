#include <algorithm>
#include <cmath>
#include <vector>

#include "outlines/polygon.hpp"
#include "picture/solid.hpp"
#include "run/facts.hpp"
#include "subjects/difference/minkowski.hpp"
#include "subjects/difference/subject.hpp"
#include "subjects/difference/tour.hpp"
#include "subjects/space/solids.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace sizes;

/// An arrow that is there for one frame.
void difference_arrow(SceneBuilder& scene, const Point& from, const Point& to) {
  scene.add("difference.arrow", Arrow{from, to});
  scene.out.obstacles.passing.push_back({from, to});
}

/// Z is what GJK does without while a run is followed, and known once it is built.
bool hull_is_ghost(const SceneBuilder& scene) {
  const bool is_part_of_search = scene.frame.part >= 0 && scene.knows.phase_is(gjk::Phase::support);
  return scene.run.tour->follows_run || is_part_of_search;
}

/// Disks of the differences: smaller where they stand close together. A dense cloud has one disk in
/// each cell of a grid, for the others would be hidden, and labels stand on them.
class CloudDots {
 public:
  /// `row`: so many of the points, one after the other, are of one vertex of X.
  CloudDots(SceneBuilder& scene, const std::vector<Point>& points, std::size_t row)
      : scene_(scene),
        radius_(
            std::min(kCloudRadius, kPartOfRoom * std::min({room_of(points), apart(points, 1, row),
                                                           apart(points, row, points.size())}))) {
    if (radius_ >= kLeast) return;
    const Point size = scene.map.area().size() / kCell;
    columns_ = static_cast<std::size_t>(size.x()) + 1;
    taken_.resize(columns_ * (static_cast<std::size_t>(size.y()) + 1));
  }

  [[nodiscard]] bool have_room() const { return radius_ >= kRoom; }

  /// In space, where there is room, at its depth.
  void draw(const Eigen::Vector3d& z, gjk::VertexPair pair) {
    if (!have_room()) return draw(scene_.at(z), pair);
    scene_.disk_in_space("cloud.point", z, radius_,
                         {Subject::Kind::difference_vertex, pair.x, pair.y});
  }

  void draw(const Point& point, gjk::VertexPair pair) {
    const Subject subject{Subject::Kind::difference_vertex, pair.x, pair.y};
    if (taken_.empty()) return scene_.disk("cloud.point", point, radius_, subject);
    const Rect& card = scene_.map.area();
    const Point at = (point - card.min) / kCell;
    if ((at.array() < 0.0).any() || (point.array() > card.max.array()).any()) return;
    const Point cell = at.array().floor();
    const auto index =
        static_cast<std::size_t>(cell.y()) * columns_ + static_cast<std::size_t>(cell.x());
    if (taken_[index]) return;
    taken_[index] = true;
    scene_.add("cloud.point", Disk{point, kLeast}, subject);
    scene_.out.obstacles.grounds.push_back(
        {card.min + kCell * cell, card.min + kCell * (cell + Point::Ones())});
  }

 private:
  /// The median distance of neighbours, every `step` of the first `count` points.
  static double apart(const std::vector<Point>& points, std::size_t step, std::size_t count) {
    std::vector<double> lengths;
    for (std::size_t i = step; i < count; i += step)
      lengths.push_back((points[i] - points[i - step]).norm());
    if (lengths.empty()) return HUGE_VAL;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
  }

  static constexpr double kLeast = 1.3;  // radius
  static constexpr double kRoom = 2.0;   // radius
  static constexpr double kCell = 5.0;
  SceneBuilder& scene_;
  double radius_;
  std::size_t columns_ = 0;
  std::vector<bool> taken_;
};

void difference_in_space(SceneBuilder& scene, bool wants_hull, bool wants_cloud) {
  const DifferenceSolid::Value& z = scene.effects.get<DifferenceSolid>(scene.frame);
  if (wants_hull) {
    draw_solid(scene, z.hull, z.points, hull_is_ghost(scene) ? "hull.ghost" : "hull",
               {Subject::Kind::difference});
  }
  if (!wants_cloud) return;
  CloudDots dots(scene, scene.mapped(z.points), z.points.size());
  // Points that cannot be told apart would hide the solid that they make.
  if (wants_hull && !dots.have_room()) return;
  for (std::size_t i = 0; i < z.points.size(); ++i) dots.draw(z.points[i], z.pairs[i]);
}

void difference(SceneBuilder& scene) {
  const bool wants_hull = scene.shows(MinkowskiHull::kName);
  const bool wants_cloud = scene.shows(MinkowskiCloud::kName);
  if (!wants_hull && !wants_cloud) return;
  if (scene.map.is_of_space()) return difference_in_space(scene, wants_hull, wants_cloud);
  const auto build = build_frame(scene.run, scene.frame);
  if (wants_hull && (!build || build->part >= BuildPart::hull)) {
    std::vector<Point> points;
    for (const CloudPoint& corner : scene.effects.get<MinkowskiHull>(scene.frame))
      points.push_back(scene.at(corner.z));
    points = separate_points(points);
    scene.area(hull_is_ghost(scene) ? "hull.ghost" : "hull", points, {Subject::Kind::difference});
    scene.outline(points);
  }
  if (!wants_cloud) return;
  const MinkowskiCloud::Value& cloud = scene.effects.get<MinkowskiCloud>(scene.frame);
  const std::size_t made = build ? static_cast<std::size_t>(build->made) : cloud.size();
  // More names would hide what they name; where edges have names, they are what counts.
  const bool has_names = build && build->part <= BuildPart::hull && cloud.size() <= 12;
  std::vector<Point> points;
  points.reserve(cloud.size());
  Point middle = Point::Zero();
  for (const CloudPoint& point : cloud) {
    points.push_back(scene.at(point.z));
    middle += points.back() / static_cast<double>(cloud.size());
  }
  CloudDots dots(scene, points, scene.positioned.y().world.size());
  for (std::size_t i = 0; i < made; ++i) {
    const gjk::VertexPair pair = cloud[i].pair;
    const Point& point = points[i];
    dots.draw(point, pair);
    if (has_names)
      scene.out.fixed_labels.push_back(
          scene.pair_name(pair, "cloud.label", point, kCloudRadius, point - middle));
  }
}

/// It is another one while it is built.
EffectKey difference_key(const SceneBuilder& scene) {
  const auto build = build_frame(scene.run, scene.frame);
  if (build) return {scene.frame.run, static_cast<int>(build->part), build->made};
  return {scene.frame.run, -1, hull_is_ghost(scene) ? 1 : 0};
}

}  // namespace

const Layer kDifference{.effect = {},
                        .on = Layer::On::difference,
                        .order = 71,
                        .draw = difference,
                        .key = difference_key};

namespace {

/// A closed outline of a shape turned and moved: sign · vertex + offset.
void copy(SceneBuilder& scene, const std::vector<Vector3d>& vertices, double sign,
          const Vector3d& offset, const std::string& role) {
  std::vector<Point> points;
  for (const Vector3d& vertex : vertices) points.push_back(scene.at(sign * vertex + offset));
  scene.add(role, Polyline{points, true});
  for (std::size_t i = 0; i < points.size(); ++i)
    scene.out.obstacles.passing.push_back({points[i], points[(i + 1) % points.size()]});
}

/// −X, and how each vertex of X is reflected in O.
void mirror_image(SceneBuilder& scene, bool with_ways) {
  const std::vector<Vector3d>& x = scene.positioned.x().world;
  copy(scene, x, -1.0, Vector3d::Zero(), "shape.x.copy");
  const Point o = scene.at(Vector2d::Zero());
  scene.cross("origin", o, kOriginRadius);
  scene.out.moving_labels.push_back(
      scene.label("O", "O", "origin.label", type::kVertex, o, kOriginRadius));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Point at = scene.at(-x[i]);
    scene.disk("shape.x.vertex", at, kVertexRadius);
    if (with_ways) scene.link(x[i], -x[i]);
    scene.out.moving_labels.push_back(scene.label("mirror:" + scene.run.lesson.x().vertex_names[i],
                                                  "−" + scene.run.lesson.x().vertex_names[i],
                                                  "shape.x.label", type::kSmallVertex, at,
                                                  kVertexRadius, at - o));
  }
}

/// An edge in the colour of the shape that it comes from, and its name.
void origin_of_edge(SceneBuilder& scene, const Vector2d& from, const Vector2d& to,
                    const Vector2d& middle, const std::string& name, bool of_x) {
  const std::string role = of_x ? "shape.x" : "shape.y";
  const Point a = scene.at(from);
  const Point b = scene.at(to);
  scene.line(role, a, b);
  scene.out.moving_labels.push_back(scene.label("edge:" + name, name, role + ".label",
                                                type::kSmallVertex, 0.5 * (a + b), 3.0,
                                                0.5 * (a + b) - scene.at(middle)));
}

void origins_of_edges(SceneBuilder& scene) {
  const MinkowskiHull::Value& hull = scene.effects.get<MinkowskiHull>(scene.frame);
  const auto& x_names = scene.run.lesson.x().vertex_names;
  const auto& y_names = scene.run.lesson.y().vertex_names;
  // As words name an edge: AC, though −X is walked along from C to A.
  const auto edge = [](const std::vector<std::string>& names, int a, int b) {
    return names[std::min(a, b)] + names[std::max(a, b)];
  };
  Vector2d middle = Vector2d::Zero();
  for (const CloudPoint& corner : hull) middle += corner.z / static_cast<double>(hull.size());
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const auto& [from, a] = hull[i];
    const auto& [to, b] = hull[(i + 1) % hull.size()];
    // Edges of both that are parallel make one.
    if (a.y != b.y)
      origin_of_edge(scene, from, to, middle, edge(y_names, a.y, b.y), false);
    else if (a.x != b.x)
      origin_of_edge(scene, from, to, middle, edge(x_names, a.x, b.x), true);
  }
}

/// From x to y in the world; from O to y − x in the difference.
void any_difference(SceneBuilder& scene) {
  const Vector2d x = centroid(in_plane(scene.positioned.x().world));
  const Vector2d y = centroid(in_plane(scene.positioned.y().world));
  const auto end = [&](const Vector2d& point, const std::string& name, const Vector2d& other) {
    scene.disk("cloud.current", scene.at(point), kSimplexRadius);
    scene.out.moving_labels.push_back(scene.label("end:" + name, name, "closest.label",
                                                  type::kVertex, scene.at(point), kSimplexRadius,
                                                  scene.at(point) - scene.at(other)));
  };
  if (scene.view.kind == ViewKind::world) {
    difference_arrow(scene, scene.at(x), scene.at(y));
    end(x, "x", y);
    end(y, "y", x);
  } else {
    difference_arrow(scene, scene.at(Vector2d::Zero()), scene.at(y - x));
    end(y - x, "y − x", Vector2d::Zero());
  }
}

void shortest_difference(SceneBuilder& scene) {
  const WideResult& result = scene.positioned.trace.result;
  const bool in_world = scene.view.kind == ViewKind::world;
  const Point from = scene.at(in_world ? result.x : Vector3d(0.0, 0.0, 0.0));
  const Point to = scene.at(in_world ? result.y : Vector3d(result.y - result.x));
  scene.line("closest.line", from, to);
  if (in_world) scene.disk("closest", from, kClosestRadius);
  scene.disk("closest", to, kClosestRadius);
  if (result.distance > 0.0) scene.length_label("distance", result.distance, from, to);
}

void newest_pair(SceneBuilder& scene, gjk::VertexPair pair) {
  const Vector3d& x = scene.positioned.x().world[pair.x];
  const Vector3d& y = scene.positioned.y().world[pair.y];
  if (scene.view.kind == ViewKind::world) {
    difference_arrow(scene, scene.at(x), scene.at(y));
    scene.disk("cloud.current", scene.at(x), kSimplexRadius);
    scene.disk("cloud.current", scene.at(y), kSimplexRadius);
  } else {
    difference_arrow(scene, scene.at(Vector2d::Zero()), scene.at(y - x));
    scene.disk("cloud.current", scene.at(y - x), kSimplexRadius);
  }
}

/// Y − x for the vertices of X up to `newest`.
void copies_of_y(SceneBuilder& scene, int newest) {
  const std::vector<Vector3d>& x = scene.positioned.x().world;
  const std::vector<Vector3d>& y = scene.positioned.y().world;
  if (scene.view.kind == ViewKind::world) {
    for (const Vector3d& vertex : y) scene.link(x[newest], vertex);
    scene.disk("cloud.current", scene.at(x[newest]), kSimplexRadius);
    return;
  }
  for (int i = 0; i <= newest; ++i)
    copy(scene, y, 1.0, -x[i], i == newest ? "cloud.row" : "shape.y.copy");
  for (const Vector3d& vertex : y)
    scene.disk("cloud.current", scene.at(vertex - x[newest]), kTouchedRadius);
}

/// Y, and −X at each of its vertices.
void slid_mirror_image(SceneBuilder& scene) {
  if (scene.view.kind == ViewKind::world) return mirror_image(scene, false);
  const std::vector<Vector3d>& y = scene.positioned.y().world;
  copy(scene, y, 1.0, Vector3d::Zero(), "cloud.row");
  for (const Vector3d& vertex : y)
    copy(scene, scene.positioned.x().world, -1.0, vertex, "shape.x.copy");
}

/// Places to choose from for a difference, and in the world its arrow's ends.
void numbered_places(SceneBuilder& scene) {
  const std::vector<Vector3d>& x = scene.positioned.x().world;
  const std::vector<Vector3d>& y = scene.positioned.y().world;
  if (scene.view.kind == ViewKind::world) {
    return difference_arrow(scene, scene.at(x[kAskedDifference.x]),
                            scene.at(y[kAskedDifference.y]));
  }
  int number = 0;
  for (const gjk::VertexPair pair : places_to_choose(scene.run)) {
    const Point at = scene.at(y[pair.y] - x[pair.x]);
    const std::string name = std::to_string(++number);
    scene.disk("cloud.current", at, kTouchedRadius);
    scene.out.moving_labels.push_back(
        scene.label("place:" + name, name, "cloud.label", type::kVertex, at, kTouchedRadius));
  }
}

}  // namespace

void building(SceneBuilder& scene) {
  const auto [part, made] = *build_frame(scene.run, scene.frame);
  if (scene.frame.question >= 0 && scene.run.asked(scene.frame).ask == kAskPlace.name)
    return numbered_places(scene);
  const int per_x = static_cast<int>(scene.positioned.y().world.size());
  const bool in_world = scene.view.kind == ViewKind::world;
  switch (part) {
    case BuildPart::pair:
      return newest_pair(scene, {(made - 1) / per_x, (made - 1) % per_x});
    case BuildPart::copy:
      return copies_of_y(scene, (made - 1) / per_x);
    case BuildPart::mirror:
      if (in_world) mirror_image(scene, true);
      return;
    case BuildPart::slide:
      return slid_mirror_image(scene);
    case BuildPart::edges:
      if (!in_world) origins_of_edges(scene);
      return;
    case BuildPart::any:
      return any_difference(scene);
    case BuildPart::shortest:
      return shortest_difference(scene);
    case BuildPart::start:
    case BuildPart::hull:
      return;
  }
}

namespace {

void corner_names(SceneBuilder& scene) {
  const Lesson& lesson = scene.run.lesson;
  // Corners come and go when shapes turn; those of the simplex are named in any case.
  const bool turns = lesson.path_of_shapes && (!lesson.path_of_shapes->x().turns.empty() ||
                                               !lesson.path_of_shapes->y().turns.empty());
  const auto build = build_frame(scene.run, scene.frame);
  const bool is_named = build && build->part < BuildPart::any;
  if (is_named || turns || scene.map.is_of_space()) return;
  const MinkowskiHull::Value& hull = scene.effects.get<MinkowskiHull>(scene.frame);
  constexpr std::size_t kMostNames = 16;  // more would hide what they name
  if (hull.size() > kMostNames) return;
  Point middle = Point::Zero();
  for (const CloudPoint& corner : hull)
    middle += scene.at(corner.z) / static_cast<double>(hull.size());
  for (const auto& [z, pair] : hull) {
    const Point point = scene.at(z);
    LabelRequest label =
        scene.pair_name(pair, "cloud.label", point, sizes::kSimplexRadius, point - middle);
    if (hull_is_ghost(scene)) label.tones.clear();
    auto& labels = scene.labels_of_difference();
    // Corners that are one point to the eye have one name.
    constexpr double kOnePoint = 3.0;
    const bool named = std::any_of(labels.begin(), labels.end(), [&](const auto& other) {
      return other.id == label.id ||
             (other.id.starts_with("cloud:") && (other.anchor - point).norm() < kOnePoint);
    });
    if (!named) labels.push_back(label);
  }
}

}  // namespace

const Layer kCornerNames{.effect = gjkscope::MinkowskiHull::kName,
                         .on = Layer::On::every_view,
                         .order = 1030,
                         .draw = corner_names};

}  // namespace gjkscope::layers
