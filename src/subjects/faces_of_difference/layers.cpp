#include <fmt/format.h>

#include <algorithm>

#include "picture/solid.hpp"
#include "subjects/faces_of_difference/growth.hpp"
#include "subjects/faces_of_difference/shown.hpp"
#include "subjects/growth/subject.hpp"

namespace gjkscope::zfaces {
namespace {

using Eigen::Vector3d;
using sums_in_space::Face;
using sums_in_space::Kind;
using namespace sizes;
using Phase = FacesTrace::Phase;

/// A face of Z, in the difference.
void face_of_z(SceneBuilder& scene, const Shown& shown, const Face& face, const std::string& role) {
  std::vector<Point> corners;
  for (const gjk::VertexPair& pair : shown.corners(face))
    corners.push_back(scene.at(shown.z(pair)));
  if (face.kind() == Kind::of_edges && role == "zface.edges")
    scene.hatched("zface.edges.hatch", corners);
  scene.area(role, corners);
}

std::string role_of(Kind kind) {
  return kind == Kind::of_y       ? "zface.y"
         : kind == Kind::of_x     ? "zface.x"
         : kind == Kind::of_edges ? "zface.edges"
                                  : "zface.several";
}

/// The faces that look at the eye, those of one kind or all.
void faces_of_z(SceneBuilder& scene, const Shown& shown, const Kind* kind) {
  for (const Face& face : shown.trace.faces) {
    if (kind != nullptr && face.kind() != *kind) continue;
    if (scene.map.towards_eye(face.normal) > 0.0)
      face_of_z(scene, shown, face, role_of(face.kind()));
  }
}

/// In the difference: the marked face, its normal, and names of its corners.
void marked(SceneBuilder& scene, const Shown& shown, const Face& face) {
  face_of_z(scene, shown, face, shown.asks_source ? "zface.asked" : role_of(face.kind()));
  const std::vector<gjk::VertexPair> corners = shown.corners(face);
  Vector3d middle = Vector3d::Zero();
  for (const gjk::VertexPair& pair : corners)
    middle += shown.z(pair) / static_cast<double>(corners.size());
  scene.search_arrow(scene.at(middle), face.normal, kArrowLength, "n");
  if (shown.asks) return;
  for (const gjk::VertexPair& pair : corners) {
    const Point at = scene.at(shown.z(pair));
    scene.disk("cloud.touched", at, kTouchedRadius,
               {Subject::Kind::difference_vertex, pair.x, pair.y});
    scene.out.moving_labels.push_back(
        scene.pair_name(pair, "cloud.label", at, kTouchedRadius, at - scene.at(middle)));
  }
}

/// In the world: a vertex, an edge or a face of a body, that makes a face of Z.
void source(SceneBuilder& scene, const Shown& shown, const Face& of_z, bool is_x) {
  const std::vector<int>& part = is_x ? of_z.x : of_z.y;
  const std::vector<Vector3d>& world = shown.bodies[is_x ? 0 : 1].world;
  std::vector<Point> corners;
  for (const int vertex : part) corners.push_back(scene.at(world[vertex]));
  if (corners.size() > 2) {
    std::vector<Vector3d> face;
    for (const int vertex : part) face.push_back(world[vertex]);
    // X is mirrored in Z, so that its faces look the other way there.
    const bool is_behind = scene.map.towards_eye(of_z.normal) * (is_x ? -1.0 : 1.0) < 0.0;
    return draw_face(scene, face, is_behind ? "zface.behind" : is_x ? "zface.x" : "zface.y");
  }
  if (corners.size() == 2) return scene.line(is_x ? "from.x" : "from.y", corners[0], corners[1]);
  scene.diamond("support.vertex", corners[0], kSupportRadius,
                is_x ? Subject{Subject::Kind::vertex_of_x, part[0]}
                     : Subject{Subject::Kind::vertex_of_y, -1, part[0]});
}

/// In the world: all that makes faces of a kind.
void sources(SceneBuilder& scene, const Shown& shown, Kind kind) {
  for (const Face& face : shown.trace.faces) {
    if (face.kind() != kind) continue;
    if (face.y.size() > 1 && (face.y.size() == 2 || scene.map.towards_eye(face.normal) > 0.0))
      source(scene, shown, face, false);
    if (face.x.size() > 1 && (face.x.size() == 2 || scene.map.towards_eye(face.normal) < 0.0))
      source(scene, shown, face, true);
  }
}

void in_world(SceneBuilder& scene, const Shown& shown) {
  const Face* face = shown.face();
  if (face == nullptr) {
    if (shown.at().phase == Phase::kind) sources(scene, shown, shown.at().kind);
    return;
  }
  if (shown.asks_source) return;
  for (const bool is_x : {false, true}) {
    const std::vector<int>& part = is_x ? face->x : face->y;
    // The part that is asked for is not shown.
    if (!shown.asks || part.size() > 1) source(scene, shown, *face, is_x);
  }
}

/// The corners of a box.
std::vector<Vector3d> box(const Vector3d& middle, const Vector3d& half) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(middle + Vector3d((i & 1) == 0 ? -half.x() : half.x(),
                                          (i & 2) == 0 ? -half.y() : half.y(),
                                          (i & 4) == 0 ? -half.z() : half.z()));
  return points;
}

/// A back with teeth, of boxes: Y's teeth cross those of X.
std::vector<std::vector<Vector3d>> comb(std::size_t body) {
  constexpr int kTeeth = 5;
  const double towards = body == 0 ? 1.0 : -1.0;
  std::vector<std::vector<Vector3d>> parts = {box(Vector3d::Zero(), {1.0, 1.0, 0.15})};
  for (int i = 0; i < kTeeth; ++i) {
    const double along = -0.9 + 0.45 * i;
    parts.push_back(body == 0 ? box({along, 0.0, 0.55 * towards}, {0.1, 1.0, 0.4})
                              : box({0.0, along, 0.55 * towards}, {1.0, 0.1, 0.4}));
  }
  return parts;
}

/// The bodies that are counted, one above the other; spheres whose centers meet.
void counted_bodies(SceneBuilder& scene, Growing growing) {
  const double apart = growing == Growing::depth ? 0.0 : 2.3;
  const Rect& card = scene.map.area();
  Camera camera{Vector3d::Zero(), 1.3 * (apart + 2.0), 1.0, Eye{35.0, 25.0}};
  camera.height *= std::max(1.0, 0.6 * card.size().y() / card.size().x());
  const StageMap map(card, camera);
  SceneBuilder more(scene.run, scene.effects, scene.frame, scene.view, map);
  const CountedBodies both = growing == Growing::depth ? spheres() : crossing_lenses();
  for (const std::size_t body : {0, 1}) {
    std::vector<std::vector<Vector3d>> parts = {both.points[body]};
    if (growing == Growing::general) parts = comb(body);
    for (std::vector<Vector3d>& points : parts) {
      for (Vector3d& point : points) point += (body == 0 ? -0.5 : 0.5) * apart * Vector3d::UnitZ();
      draw_solid(more, hull_in_space(points), points, body == 0 ? "shape.x" : "shape.y");
    }
  }
  more.add("body.muted", Text{{card.min.x() + 14.0, card.max.y() - 14.0},
                              growing == Growing::general
                                  ? std::string("combs of boxes")
                                  : fmt::format("{}, n = {}",
                                                growing == Growing::depth ? "spheres that overlap"
                                                                          : "lenses that cross",
                                                CountedBodies::kVertices),
                              type::kBody});
  scene.out.append(more.out);
}

}  // namespace

bool fill(SceneBuilder& scene, const Fonts& fonts) {
  const std::optional<Growing> growing = growth_of(scene.run, scene.frame);
  if (growing && scene.view.kind == ViewKind::world) {
    counted_bodies(scene, *growing);
    return true;
  }
  if (scene.view.kind != ViewKind::plot && !growing) return false;
  layers::add_plot(scene,
                   faces_plot(growing.value_or(Growing::faces), scene.frame.question >= 0,
                              scene.effects.get<FaceGrowth>(scene.frame)),
                   fonts);
  return true;
}

void stage(SceneBuilder& scene) {
  const Shown shown(scene.run, scene.frame);
  if (shown.step < 0) return;
  const bool is_world = scene.view.kind == ViewKind::world;
  if (!shown.asks && shown.is_answer) {
    if (is_world) return;
    // The points of Z that GJK asked for, each once.
    std::vector<gjk::VertexPair> drawn;
    for (const WideStep& step : scene.positioned.trace.steps) {
      const WideVertex& point = step.after.support;
      if (step.phase != gjk::Phase::support ||
          std::find(drawn.begin(), drawn.end(), point.pair) != drawn.end())
        continue;
      drawn.push_back(point.pair);
      const Point at = scene.at(point.w);
      scene.diamond("support.vertex", at, kSupportRadius, subject_of(scene.run, point.pair));
      scene.out.moving_labels.push_back(scene.pair_name(
          point.pair, "cloud.label", at, kSupportRadius, at - scene.map.area().center()));
    }
    return;
  }
  if (is_world) return in_world(scene, shown);
  if (const Face* face = shown.face()) return marked(scene, shown, *face);
  faces_of_z(scene, shown, shown.at().phase == Phase::kind ? &shown.at().kind : nullptr);
}

}  // namespace gjkscope::zfaces
