#include "session/hand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "outlines/polygon.hpp"
#include "picture/plot.hpp"
#include "picture/scene.hpp"
#include "picture/text_box.hpp"
#include "run/trail.hpp"
#include "session/edit.hpp"
#include "session/hit.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Kind = Subject::Kind;

constexpr double kNear = 24.0;        // frame pixels around a vertex in which its name appears
constexpr double kHandleAway = 40.0;  // of the handle from its shape, frame pixels
constexpr double kHandleRadius = 11.0;
constexpr double kDegreesPerPixel = 0.4;  // of a hand that turns a view
constexpr double kDegrees = 15.0;         // a step of a shape that is turned by round numbers

/// Below 1 the grid is divided by how many make 1: 0.3 is the double that is nearest to it, and 3
/// times 0.1 is not.
double snapped(double value, double grid) {
  if (grid == 0.0) return value;
  const double steps = std::round(value / grid);
  return grid < 1.0 ? steps / std::round(1.0 / grid) : steps * grid;
}

/// Three quarters of a circle, clockwise, and an arrow's head.
Polyline turning_arrow(const Point& center, double radius) {
  constexpr int kCorners = 12;
  const auto at = [&](double quarters, double from_center) {
    const double angle = 0.5 * std::numbers::pi * quarters;
    return Point(center + from_center * Point(std::cos(angle), std::sin(angle)));
  };
  Polyline arrow;
  for (int i = 0; i <= kCorners; ++i) arrow.points.push_back(at(3.0 * i / kCorners, radius));
  const Point tip = arrow.points.back();
  for (const double side : {0.4, 1.6}) {
    arrow.points.push_back(at(2.35, side * radius));
    arrow.points.push_back(tip);
  }
  return arrow;
}

double degrees_between(const Vector2d& a, const Vector2d& b) {
  // Rounded from more digits: the arc tangent of a double differs from library to library.
  const long double across = a.x() * b.y() - a.y() * b.x();
  return static_cast<double>(std::atan2(across, static_cast<long double>(a.dot(b)))) * 180.0 /
         std::numbers::pi;
}

}  // namespace

Vector2d snapped(const Vector2d& value, const Vector2d& grid) {
  return {snapped(value.x(), grid.x()), snapped(value.y(), grid.y())};
}

Vector3d along_screen(const Camera& camera, const Vector2d& right_and_up) {
  if (!camera.eye) return in_space(right_and_up);
  return axes_of(*camera.eye).topRows<2>().transpose() * right_and_up;
}

std::optional<Eye> eye_from(std::string_view side, const LessonRun& run, const Frame& frame) {
  if (side == kSides[0]) return Eye{0.0, 0.0};
  if (side == kSides[1]) return Eye{90.0, 0.0};
  if (side == kSides[2]) return Eye{0.0, 90.0};
  if (side != kSides[3] && side != kSides[4]) return std::nullopt;
  const WideResult& result = run.run(frame).trace.result;
  const Vector3d found = run.state(frame).d;
  const Vector3d d = found.norm() > 0.0 ? found : Vector3d(result.y - result.x);
  return side == kSides[3] ? eye_across(d) : eye_along(d);
}

std::optional<std::size_t> Hand::view_at(const Point& page) const {
  const std::vector<LessonPictures::ShownView> views = session_.views();
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (is_in(views[i].card, page)) return i;
  }
  return std::nullopt;
}

Vector3d Hand::to_view(std::size_t view, const Point& page) const {
  const LessonPictures::ShownView shown = session_.views()[view];
  const Point off = page - shown.card.center();
  const Vector2d right_and_up =
      shown.camera.units_per_pixel(shown.card.size().y()).cwiseProduct(Vector2d(off.x(), -off.y()));
  return shown.camera.center + along_screen(shown.camera, right_and_up);
}

Subject Hand::subject_at(const Point& page, double slack) const {
  return gjkscope::subject_at(session_.picture(), fonts_, page, slack);
}

Subject Hand::named_at(const Point& page, const Subject& pointed) const {
  const bool is_named = is_vertex(pointed) || pointed.kind == Kind::difference_vertex;
  return is_named ? pointed : session_.vertex_near(page, kNear);
}

Vector2d Hand::round_step(std::size_t view) const {
  constexpr double kApart = 8.0;  // frame pixels
  const LessonPictures::ShownView shown = session_.views()[view];
  const Vector2d units = shown.camera.units_per_pixel(shown.card.size().y());
  return {gjkscope::round_step(kApart * units.x()), gjkscope::round_step(kApart * units.y())};
}

std::optional<Point> Hand::handle() const {
  if (!is_shape(selected) || is_trail(session_.frame())) return std::nullopt;
  const auto& world = session_.run().run(session_.frame()).bodies[body_of(selected)].world;
  const std::vector<LessonPictures::ShownView> views = session_.views();
  const auto view = std::find_if(views.begin(), views.end(),
                                 [](const auto& each) { return each.kind == ViewKind::world; });
  // A turn in space has an axis, which a handle does not show.
  const bool is_plane = session_.lesson().dimension == 2;
  if (world.size() < 2 || view == views.end() || !is_plane) return std::nullopt;
  const StageMap map(view->card, view->camera);
  Rect box{map(world.front()), map(world.front())};
  for (const Eigen::Vector3d& vertex : world)
    box = {box.min.cwiseMin(map(vertex)), box.max.cwiseMax(map(vertex))};
  const Point middle = box.center();
  const Point inset = Point::Constant(kHandleRadius + 2.0);
  const std::vector<Mark>& marks = session_.picture().marks;
  std::optional<Point> first;
  for (const Point& beside :
       {Point(middle.x(), box.min.y() - kHandleAway), Point(middle.x(), box.max.y() + kHandleAway),
        Point(box.max.x() + kHandleAway, middle.y()),
        Point(box.min.x() - kHandleAway, middle.y())}) {
    const Point at = beside.cwiseMax(view->card.min + inset).cwiseMin(view->card.max - inset);
    const Point radius = Point::Constant(kHandleRadius);
    const bool covers = std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) {
      const Text* text = std::get_if<Text>(&mark.shape);
      return text && mark.clip >= 0 && overlap(box_of(fonts_, *text), {at - radius, at + radius});
    });
    if (!covers) return at;
    if (!first) first = at;
  }
  return first;
}

bool Hand::is_on_handle(const Point& page, double slack) const {
  const std::optional<Point> at = handle();
  return at && (page - *at).norm() <= kHandleRadius + slack;
}

std::vector<Mark> Hand::handle_marks() const {
  const std::optional<Point> at = handle();
  if (!at) return {};
  return {{"handle", Disk{*at, kHandleRadius}, -1, selected},
          {"handle.arrow", turning_arrow(*at, 0.5 * kHandleRadius), -1, selected}};
}

std::optional<Hand::WithVertex> Hand::with_vertex(const Point& page, bool snaps) const {
  const std::optional<std::size_t> view = view_at(page);
  if (!view || session_.views()[*view].kind != ViewKind::world) return std::nullopt;
  if (session_.lesson().dimension == 3) return std::nullopt;  // a polyhedron has no edge to split
  if (is_trail(session_.frame())) return std::nullopt;
  const Vector2d at = in_plane(to_view(*view, page));
  const LessonPictures::ShownView shown = session_.views()[*view];
  const double reach = 2.0 * kSlack * shown.camera.height / shown.card.size().y();
  const PositionedRun& run = session_.run().run(session_.frame());
  const Lesson& shapes = session_.lesson();
  const auto of_x = edit::nearest_edge(in_plane(run.x().world), shapes.x().ranges(), at);
  const auto of_y = edit::nearest_edge(in_plane(run.y().world), shapes.y().ranges(), at);
  const bool is_x = of_x && (!of_y || of_x->distance < of_y->distance);
  const auto& edge = is_x ? of_x : of_y;
  if (!edge || edge->distance > reach) return std::nullopt;
  const std::size_t body = is_x ? 0 : 1;
  WithVertex added{shapes, {}, {}};
  if (shapes.bodies[body].vertices.size() >= edit::kMostEditable) {
    added.problem = fmt::format("shapes of {} vertices and more are not edited vertex by vertex",
                                edit::kMostEditable);
    return added;
  }
  const Vector2d grid = snaps ? round_step(*view) : Vector2d::Zero();
  const int index = edit::insert_vertex(added.lesson, body, edge->edge, run.bodies[body].placement,
                                        in_space(snapped(at, grid)));
  added.vertex = vertex_of(body, index);
  return added;
}

bool Hand::press(const Subject& subject, const Point& page, double handle_slack) {
  release();
  const std::optional<std::size_t> view = view_at(page);
  if (!view) return false;
  Held taken{.subject = selected,
             .view = *view,
             .last = page,
             .pressed = page,
             .start = to_view(*view, page),
             .version = session_.version()};
  taken.turns = is_on_handle(page, handle_slack);
  if (!taken.turns) {
    taken.subject = gjkscope::held(subject);
    const bool is_of_shapes = is_vertex(taken.subject) || is_shape(taken.subject);
    selected = is_of_shapes ? taken.subject : Subject{};
    const bool in_world = session_.views()[*view].kind == ViewKind::world;
    const bool moves = in_world ? is_of_shapes : is_of_difference(taken.subject);
    taken.walks = !moves && session_.views()[*view].camera.eye.has_value();
    if (!moves && !taken.walks) return false;
  }
  held_ = taken;
  return true;
}

Vector3d Hand::along_axis(const Held& held, const Point& page, const Vector3d& from) const {
  const LessonPictures::ShownView shown = session_.views()[held.view];
  const StageMap map(shown.card, shown.camera);
  const Point difference = page - held.pressed;
  int best = 0;
  double most = -1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double follows =
        std::abs(difference.dot(map.direction(Vector3d::Unit(axis)).normalized()));
    if (!(follows > most)) continue;
    most = follows;
    best = axis;
  }
  const Point unit = map(shown.camera.center + Vector3d::Unit(best)) - map(shown.camera.center);
  const double to = from[best] + difference.dot(unit) / unit.squaredNorm();
  const double step = round_step(held.view).x();
  return (std::round(to / step) * step - from[best]) * Vector3d::Unit(best);
}

bool Hand::move(const Point& page, bool snaps) {
  if (!held_ || session_.is_settling()) return false;
  if (!held_->moved && (page - held_->last).norm() < kStill) return false;
  if (!session_.is_dragging() && session_.version() != held_->version) {
    // The lesson was changed otherwise, and what is held may not be there.
    held_.reset();
    return true;
  }
  Held& held = *held_;
  held.moved = true;
  if (held.walks) {
    const Point by = kDegreesPerPixel * (page - held.last);
    const Eye eye = *session_.eye();
    session_.set_eye({eye.azimuth - by.x(), eye.elevation + by.y()});
    held.last = page;
    return true;
  }
  const Vector3d before = to_view(held.view, held.last);
  const Vector3d now = to_view(held.view, page);
  const bool is_plane = session_.lesson().dimension == 2;
  const Vector2d grid = snaps && is_plane ? round_step(held.view) : Vector2d::Zero();
  const auto on_grid = [&](const Vector3d& place) {
    return in_space(snapped(in_plane(place), grid));
  };
  const std::size_t body = body_of(held.subject);
  const Body& shape = session_.run().run(session_.frame()).bodies[body];
  Vector3d by = now - before;
  if (!is_plane) {
    const bool is_point = is_vertex(held.subject);
    const Vector3d from = is_point ? Vector3d(shape.world[index_of(held.subject)] - held.went)
                                   : Vector3d(Vector3d::Zero());
    const Vector3d goal = snaps ? along_axis(held, page, from) : Vector3d(now - held.start);
    by = goal - held.went;
    held.went = goal;
  }
  double degrees = 0.0;
  if (held.turns) {
    const Vector2d middle = centroid(in_plane(shape.world));
    degrees = degrees_between(in_plane(before) - middle, in_plane(now) - middle);
    if (snaps) degrees = snapped(degrees, kDegrees);
    if (degrees == 0.0) return true;
  }
  if (!session_.is_dragging()) {
    const char* what = is_vertex(held.subject) ? "move a vertex" : "move a shape";
    held.turns ? session_.begin_drag("turn a shape") : session_.begin_drag(what, held.view);
  }
  session_.drag([&](Lesson& lesson) {
    if (held.turns) {
      edit::turn_shape(lesson, body, degrees);
    } else if (is_of_difference(held.subject)) {
      edit::move_shape(lesson, body, by);  // Z = Y - X goes where Y goes
    } else if (is_shape(held.subject)) {
      edit::move_shape(lesson, body,
                       is_plane ? on_grid(now - held.start) - on_grid(before - held.start) : by);
    } else {
      const auto index = static_cast<std::size_t>(index_of(held.subject));
      const Vector3d& at = shape.world[index];
      const Vector3d to = is_plane ? on_grid(now) : Vector3d(at + by);
      shape.world.size() == 1
          ? edit::move_shape(lesson, body, to - at)
          : edit::put_vertex(lesson, body, index_of(held.subject), shape.placement, to);
    }
  });
  held.last = page;
  return true;
}

bool Hand::release() {
  const bool was_dragging = session_.is_dragging();
  session_.end_drag();
  held_.reset();
  return !was_dragging || session_.problem().empty();
}

bool Hand::cancel() {
  const bool was_dragging = session_.is_dragging();
  if (!release()) return false;
  if (was_dragging) session_.undo(Session::Cameras::as_then);
  return true;
}

}  // namespace gjkscope
