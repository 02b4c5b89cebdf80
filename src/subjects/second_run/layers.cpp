#include "lesson/names.hpp"
#include "subjects/second_run/second_run.hpp"
#include "subjects/second_run/subject.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope::layers {

using Eigen::Vector2d;
using namespace sizes;

namespace {

/// A stretched view slants what is perpendicular: there a right angle at `p` is drawn as stretched.
void right_angle(SceneBuilder& scene, const Point& p, const Eigen::Vector3d& d) {
  constexpr double kSide = 16.0;
  const Point along = kSide * scene.map.direction(d);
  Point across = kSide * scene.map.direction(Eigen::Vector2d(-d.y(), d.x()));
  if (across.y() > 0.0) across = -across;
  if (std::abs(along.dot(across)) < 0.01 * kSide * kSide) return;
  scene.add("second.right-angle", Polyline{{p + across, p + across + along, p + along}});
}

}  // namespace

void second_run(SceneBuilder& scene) {
  if (!scene.shows_difference || !shows_closest_point(scene)) return;
  const SecondRun::Value& second = scene.effects.get<SecondRun>(scene.frame);
  const WideStep* step = step_beside(second, scene.run, scene.frame);
  if (!step) return;
  const WideState& state = step->after;
  const std::string scalar(name_of(*second_of(scene.run.lesson)->scalar));
  const Point p = scene.at_difference(state.p);
  const auto name = [&](const std::string& what, const Point& anchor, double radius,
                        const Point& towards) {
    scene.out.moving_labels.push_back(scene.label("second:" + what, scalar + " " + what,
                                                  "second.label", type::kSmallVertex, anchor,
                                                  radius, towards));
  };
  if (scene.knows.support) {
    scene.support_plane(state.support.w, state.d, "second.plane");
    scene.disk("second.support", scene.at_difference(state.support.w), kRingRadius);
  }
  if (scene.knows.direction && state.d.norm() > 0.0) {
    const Point along = scene.map.direction(state.d);
    const Point tip = p + scene.arrow_length(state.p) * along;
    scene.arrow("second.direction", p, tip);
    if (state.simplex.count == 2 && !scene.map.is_of_space()) right_angle(scene, p, state.d);
    // A support line may pass the tip: the name stands beside the shaft, in space on the side where
    // the other arrow is not.
    Point side(-along.y(), along.x());
    if (scene.map.is_of_space() &&
        side.dot(scene.middle_of_arrow(scene.state) - scene.middle_of_arrow(state)) > 0.0)
      side = -side;
    name("d", 0.5 * (p + tip), 0.0, side);
    scene.out.moving_labels.back().keeps_side = scene.map.is_of_space();
  }
  scene.disk("second.closest", p, kPointRadius);
  // One label is enough when both are the same point to the eye.
  const double apart = (scene.map.is_of_space() ? 1.0 : 3.0) * kPointRadius;
  if ((p - scene.at_difference(scene.state.p)).norm() > apart)
    name("P", p, kPointRadius, p - scene.at_difference(scene.state.p));
}

}  // namespace gjkscope::layers
