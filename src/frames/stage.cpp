#include "frames/stage.hpp"

#include <algorithm>

#include "outlines/polyhedron.hpp"
#include "picture/layer.hpp"
#include "subjects/motion/motion.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// The lesson's eye, or one that sees the true distance of the first run.
Eye eye_of(const LessonRun& run, const LessonView& view) {
  const WideResult& result = run.runs.front().trace.result;
  return view.eye.value_or(eye_across(result.y - result.x));
}

struct SphereInSpace {
  Vector3d center;
  double radius = 0.0;
};

/// Spheres around all that a view shows: those of the shapes, or of their differences and O.
std::vector<SphereInSpace> spheres_in_space(const LessonRun& run, ViewKind kind) {
  std::vector<SphereInSpace> out;
  for (const PositionedRun& positioned : run.runs) {
    const auto sphere_of = [&](const Body& body) {
      Eigen::AlignedBox3d box;
      for (const Vector3d& vertex : body.world) box.extend(vertex);
      SphereInSpace sphere{box.center()};
      for (const Vector3d& vertex : body.world)
        sphere.radius = std::max(sphere.radius, length(vertex - sphere.center));
      return sphere;
    };
    const SphereInSpace x = sphere_of(positioned.x());
    const SphereInSpace y = sphere_of(positioned.y());
    if (kind == ViewKind::world) {
      out.insert(out.end(), {x, y});
    } else {
      out.insert(out.end(), {{Vector3d::Zero()}, {y.center - x.center, x.radius + y.radius}});
    }
  }
  return out;
}

/// Fits a sphere around all that a view shows, so that nothing leaves it when the eye walks.
Camera camera_in_space(const LessonRun& run, const LessonView& view, const Rect& area) {
  // Room for labels, and for the title.
  const double side = std::min(46.0, 0.12 * area.size().x());
  const std::vector<SphereInSpace> seen = spheres_in_space(run, view.kind);
  Eigen::AlignedBox3d box;
  for (const SphereInSpace& sphere : seen) {
    const Vector3d around = Vector3d::Constant(sphere.radius);
    box.extend(Vector3d(sphere.center - around)).extend(Vector3d(sphere.center + around));
  }
  double radius = 0.0;
  for (const SphereInSpace& sphere : seen)
    radius = std::max(radius, length(sphere.center - box.center()) + sphere.radius);
  constexpr double kShown = 0.88;  // of the sphere, which shapes hardly fill
  Camera camera{box.center(), radius > 0.0 ? 2.0 * kShown * radius : 1.0, 1.0, eye_of(run, view)};
  camera.height *= area.size().y() / (area.size().minCoeff() - 2.0 * side);
  return camera;
}

}  // namespace

Camera camera_of(const LessonRun& run, const LessonView& view, const Rect& area) {
  if (view.camera) {
    // On a page narrower than the usual one the height gives way, so that nothing is cut off at the
    // sides.
    const double usual_aspect = run.lesson.views.size() == 1 ? 1.8 : 0.95;
    Camera camera = *view.camera;
    camera.height *= std::max(1.0, usual_aspect * area.size().y() / area.size().x());
    if (run.lesson.dimension == 3) camera.eye = eye_of(run, view);
    return camera;
  }
  if (run.lesson.dimension == 3) return camera_in_space(run, view, area);
  Eigen::AlignedBox2d seen;
  const Tour& tour = *run.tour;
  for (std::size_t index = 0; index < run.runs.size(); ++index) {
    const PositionedRun& positioned = run.runs[index];
    if (tour.reach != nullptr) tour.reach(run, static_cast<int>(index), view.kind, seen);
    const auto box_of = [&](std::size_t body) {
      Eigen::AlignedBox2d box;
      for (const Vector2d& vertex : in_plane(positioned.bodies[body].world)) box.extend(vertex);
      return box;
    };
    const auto extend = [&](const Eigen::AlignedBox2d& box, double radius) {
      const Vector2d around = Vector2d::Constant(radius);
      seen.extend(box.min() - around).extend(box.max() + around);
    };
    const Eigen::AlignedBox2d x = box_of(0);
    const Eigen::AlignedBox2d y = box_of(1);
    const bool is_world = view.kind == ViewKind::world;
    if (is_world) {
      extend(x, run.lesson.x().radius);
      extend(y, run.lesson.y().radius);
      if (!view.calls_for(GrownObstacle::kName)) continue;
    }
    const Vector2d shift =
        is_world ? in_plane(positioned.x().placement.translate) : Vector2d(0.0, 0.0);
    extend(Eigen::AlignedBox2d(shift),
           is_world ? 0.0 : run.lesson.x().radius + run.lesson.y().radius);
    extend({y.min() - x.max() + shift, y.max() - x.min() + shift}, 0.0);
  }
  return camera_around(seen, area);
}

namespace {

bool is_on(const Layer& layer, ViewKind kind) {
  return layer.on == Layer::On::every_view ||
         (layer.on == Layer::On::world) == (kind == ViewKind::world);
}

}  // namespace

Scene stage_scene(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                  const LessonView& view, const StageMap& map, const Fonts& fonts,
                  StillLayers& drawn) {
  const Tour& tour = *run.tour;
  SceneBuilder scene(run, effects, frame, view, map);
  /// Marks with a depth come between the flat marks of the layers below the tour and its own.
  const auto finished = [&](std::size_t below) {
    Scene& out = scene.out;
    const std::vector<Mark> marks =
        in_order_of_depth(std::move(out.surfaces), std::move(out.loose_marks));
    out.marks.insert(out.marks.begin() + static_cast<std::ptrdiff_t>(below), marks.begin(),
                     marks.end());
    return std::move(out);
  };
  if (tour.fill != nullptr && tour.fill(scene, fonts)) return finished(0);
  const auto draw_layer = [&](const Layer& layer) {
    if (layer.key == nullptr) return layer.draw(scene);
    const auto [still, is_new] = drawn.try_emplace({&layer, layer.key(scene)});
    if (is_new) {
      std::swap(scene.out, still->second);
      layer.draw(scene);
      std::swap(scene.out, still->second);
    }
    scene.out.append(still->second);
  };
  const auto draw = [&](bool above) {
    for (const Layer* layer : registered_layers()) {
      const bool is_above = layer->order > Layer::kOfTour;
      const bool is_called = layer->effect.empty() || scene.shows(layer->effect);
      if (is_above == above && is_called && is_on(*layer, view.kind)) draw_layer(*layer);
    }
  };
  draw(false);
  const std::size_t below = scene.out.marks.size();
  tour.stage(scene);
  draw(true);
  return finished(below);
}

}  // namespace gjkscope
