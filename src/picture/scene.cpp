#include "picture/scene.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/vocabulary.hpp"
#include "picture/hatch.hpp"
#include "picture/solid.hpp"
#include "picture/words.hpp"

namespace gjkscope {

using Eigen::Vector2d;
using namespace sizes;

namespace {

/// A label keeps as far from an outline as it may leave out of it.
constexpr double kShortest = 2.0;

void add_outline(std::vector<Obstacles::Segment>& to, const std::vector<Point>& points) {
  if (points.empty()) return;
  const std::size_t first = to.size();
  Point from = points[0];
  for (const Point& point : points) {
    if ((point - from).norm() < kShortest) continue;
    to.push_back({from, point});
    from = point;
  }
  if (from != points[0] || to.size() == first) to.push_back({from, points[0]});
}

}  // namespace

void Scene::append(const Scene& more) {
  const auto add = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(marks, more.marks);
  add(surfaces, more.surfaces);
  add(loose_marks, more.loose_marks);
  add(fixed_labels, more.fixed_labels);
  add(moving_labels, more.moving_labels);
  add(area_labels, more.area_labels);
  add(obstacles.segments, more.obstacles.segments);
  add(obstacles.passing, more.obstacles.passing);
  add(obstacles.circles, more.obstacles.circles);
  add(obstacles.grounds, more.obstacles.grounds);
}

std::vector<Point> separate_points(const std::vector<Point>& points) {
  constexpr std::size_t kFew = 256;  // all of which are drawn
  constexpr double kApart = 0.5;
  if (points.size() <= kFew) return points;
  std::vector<Point> out;
  for (const Point& point : points) {
    if (out.empty() || (point - out.back()).norm() >= kApart) out.push_back(point);
  }
  return out;
}

std::vector<Vector2d> StageMap::visible() const {
  const Vector2d half = 0.5 * camera_.units_per_pixel(area_.size().y()).cwiseProduct(area_.size());
  const Vector2d center = in_plane(camera_.center);
  return {center - half, center + Vector2d(half.x(), -half.y()), center + half,
          center + Vector2d(-half.x(), half.y())};
}

namespace {

/// The area of the box around points, with a border: points on one line need room beside it, too.
double area_around(const std::vector<Point>& points) {
  constexpr double kBorder = 24.0;
  Rect box{points[0], points[0]};
  for (const Point& point : points) box = {box.min.cwiseMin(point), box.max.cwiseMax(point)};
  return (box.size() + Point::Constant(kBorder)).prod();
}

}  // namespace

double room_of(const std::vector<Point>& points) {
  return std::sqrt(area_around(points) / static_cast<double>(points.size()));
}

double room_of_outline(const std::vector<Point>& points) {
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    length += (points[(i + 1) % points.size()] - points[i]).norm();
  return area_around(points) / length;
}

Subject subject_of(const LessonRun& run, gjk::VertexPair pair) {
  if (run.point_query()) return {Subject::Kind::vertex_of_y, -1, pair.y};
  return {Subject::Kind::difference_vertex, pair.x, pair.y};
}

SceneBuilder::SceneBuilder(const LessonRun& lesson_run, EffectGraph& graph, const Frame& shown,
                           const LessonView& of_view, const StageMap& stage_map)
    : run(lesson_run),
      effects(graph),
      frame(shown),
      view(of_view),
      map(stage_map),
      positioned(run.run(frame)),
      state(run.state(frame)),
      shift(view.kind == ViewKind::world && run.point_query() ? positioned.x().world[0]
                                                              : Eigen::Vector3d(0.0, 0.0, 0.0)),
      shows_difference(view.kind == ViewKind::difference || run.point_query()),
      knows(effects.get<FrameFacts>(frame)) {}

void SceneBuilder::add(std::string role, decltype(Mark::shape) shape, const Subject& subject) {
  out.marks.push_back({std::move(role), std::move(shape), -1, subject});
}

void SceneBuilder::area(std::string role, const std::vector<Point>& points,
                        const Subject& subject) {
  add(std::move(role), Polygon{points}, subject);
}

void SceneBuilder::hatched(const std::string& role, const std::vector<Point>& points) {
  constexpr double kSpacing = 9.0;
  for (Polyline& line : hatch(points, kSpacing, map.area())) add(role, std::move(line));
}

void SceneBuilder::line(std::string role, const Point& a, const Point& b, const Subject& subject) {
  add(std::move(role), Polyline{{a, b}}, subject);
  out.obstacles.segments.push_back({a, b});
}

void SceneBuilder::line_in_space(std::string role, const Eigen::Vector3d& a,
                                 const Eigen::Vector3d& b, std::string hidden,
                                 const Subject& subject) {
  out.loose_marks.push_back(
      {std::move(role), {map.in_depth(a), map.in_depth(b)}, std::move(hidden), subject});
}

void SceneBuilder::disk_in_space(std::string role, const Eigen::Vector3d& center, double radius,
                                 const Subject& subject) {
  out.loose_marks.push_back({std::move(role), {map.in_depth(center)}, {}, subject, radius});
  out.obstacles.circles.push_back({at(center), radius});
}

void SceneBuilder::outline(const std::vector<Point>& points) {
  add_outline(out.obstacles.segments, points);
}

void SceneBuilder::passing_outline(const std::vector<Point>& points) {
  add_outline(out.obstacles.passing, points);
}

void SceneBuilder::disk(std::string role, const Point& center, double radius,
                        const Subject& subject) {
  add(std::move(role), Disk{center, radius}, subject);
  out.obstacles.circles.push_back({center, radius});
}

void SceneBuilder::diamond(std::string role, const Point& center, double radius,
                           const Subject& subject) {
  add(std::move(role), gjkscope::diamond(center, radius), subject);
  out.obstacles.circles.push_back({center, radius});
}

void SceneBuilder::square(std::string role, const Point& center, double radius) {
  const Point half(radius, radius);
  add(std::move(role), Box{{center - half, center + half}, 0.0});
  out.obstacles.circles.push_back({center, radius});
}

void SceneBuilder::cross(std::string role, const Point& center, double radius,
                         const Subject& subject) {
  add(std::move(role), Cross{center, radius}, subject);
  out.obstacles.circles.push_back({center, radius});
}

void SceneBuilder::arrow(std::string role, const Point& from, const Point& to) {
  add(std::move(role), Arrow{from, to});
  out.obstacles.segments.push_back({from, to});
  out.obstacles.circles.push_back({to, 6.0});
}

LabelRequest SceneBuilder::label(std::string id, std::string text, std::string role,
                                 const TextStyle& style, const Point& anchor, double radius,
                                 const Point& towards) const {
  return {std::move(id), std::move(text),    std::move(role), style,
          anchor,        radius + kLabelGap, towards};
}

void SceneBuilder::pair_label(const WideVertex& vertex, const std::string& role) {
  const Point point = at_difference(vertex.w);
  labels_of_difference().push_back(
      pair_name(vertex.pair, role, point, kSimplexRadius, point - map.area().center()));
}

LabelRequest SceneBuilder::pair_name(gjk::VertexPair pair, const std::string& role,
                                     const Point& anchor, double radius,
                                     const Point& towards) const {
  const std::string name = run.pair_name(pair);
  LabelRequest request =
      label("cloud:" + name, name, role, type::kSmallVertex, anchor, radius, towards);
  request.steps_aside = true;
  if (run.point_query()) return request;
  const std::string& of_x = run.lesson.x().vertex_names[pair.x];
  const std::string& of_y = run.lesson.y().vertex_names[pair.y];
  request.tones = {{of_y, "shape.y.label"}, {"−", role}, {of_x, "shape.x.label"}};
  return request;
}

void SceneBuilder::simplex_vertex(const WideVertex& vertex, const std::string& role) {
  const auto mark = [&](const Point& point, const Subject& subject) {
    if (role == "support")
      diamond("support.vertex", point, kSupportRadius, subject);
    else
      disk(role + ".vertex", point, kSimplexRadius, subject);
  };
  if (shows_difference) {
    mark(at_difference(vertex.w), subject_of(run, vertex.pair));
    if (!run.point_query()) pair_label(vertex, role + ".label");
  } else {
    link(vertex_of_x(vertex), vertex_of_y(vertex));
    mark(at(vertex_of_x(vertex)), {Subject::Kind::vertex_of_x, vertex.pair.x});
    mark(at(vertex_of_y(vertex)), {Subject::Kind::vertex_of_y, -1, vertex.pair.y});
  }
}

void SceneBuilder::link(const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  add("pair.link", Polyline{{at(x), at(y)}});
  out.obstacles.passing.push_back({at(x), at(y)});
}

double SceneBuilder::arrow_length(const Eigen::Vector3d& p) const {
  const double length = (at_difference(p) - at_difference(Vector2d::Zero())).norm();
  // Nothing but the direction is to be seen when P and O are one point to the eye.
  if (length < kPointRadius) return kArrowLength;
  // An arrow as long as the way to O would hide O under its head.
  return length < 1.4 * kArrowLength ? std::max(0.6 * length, kShortArrow) : kArrowLength;
}

Camera camera_around(const Eigen::AlignedBox2d& box, const Rect& area) {
  constexpr double kSide = 46.0;
  constexpr double kTop = 58.0;
  constexpr double kBottom = 42.0;
  const Vector2d room = area.size() - Vector2d(2.0 * kSide, kTop + kBottom);
  const Vector2d extent = box.sizes();
  double scale = std::min(extent.x() > 0.0 ? room.x() / extent.x() : 1e300,
                          extent.y() > 0.0 ? room.y() / extent.y() : 1e300);
  if (scale >= 1e300) scale = room.y();
  Camera camera;
  camera.height = area.size().y() / scale;
  camera.center = in_space(
      Vector2d(0.5 * (box.min() + box.max()) + Vector2d(0.0, 0.5 * (kTop - kBottom) / scale)));
  return camera;
}

void SceneBuilder::search_arrow(const Point& from, const Eigen::Vector3d& d, double length,
                                const std::string& text) {
  if (!(d.norm() > 0.0)) return;
  const Point along = map.direction(d);
  constexpr double kLeastArrow = 6.0;  // pixels: in space d may point at the eye
  const Point tip = from + length * along;
  if ((tip - from).norm() < kLeastArrow) return;
  arrow("direction", from, tip);
  // At the tip it could be taken for the name of a vertex there, in the middle for that of P.
  constexpr double kNamed = 0.6;  // of the arrow
  out.moving_labels.push_back(label("arrow:" + text, text, "direction.label", type::kVertex,
                                    from + kNamed * (tip - from), 0.0,
                                    Point(along.y(), -along.x())));
}

double SceneBuilder::plane_half_width() const {
  constexpr double kOfView = 0.22;
  return kOfView * map.area().size().y() / map.scale();
}

void SceneBuilder::support_plane(const Eigen::Vector3d& w, const Eigen::Vector3d& d,
                                 const std::string& role) {
  if (!map.is_of_space()) return support_line(at_difference(w), d, role);
  const Eigen::Vector3d n = d.normalized();
  // Around the place of the plane that is nearest to the middle of the view.
  const Eigen::Vector3d from = map.center() - shift;
  Eigen::Vector3d center = from + n * n.dot(w - from);
  // The part of the plane that is drawn contains the support point.
  const double reach = 0.9 * plane_half_width();
  if (const double away = (w - center).norm(); away > reach)
    center += (1.0 - reach / away) * (w - center);
  draw_plane(*this, center + shift, n, plane_half_width(), role);
}

void SceneBuilder::support_line(const Point& through, const Eigen::Vector3d& d,
                                const std::string& role) {
  const Point across = map.area().size().norm() * map.direction(Eigen::Vector2d(d.y(), -d.x()));
  line(role, through - across, through + across);
}

void SceneBuilder::length_label(const std::string& id, double length, const Point& from,
                                const Point& to) {
  const double seen = (to - from).norm();
  if (seen < 1.0) return;
  constexpr double kAsLong = 0.95;  // more cannot be told from the whole
  const bool is_short = map.is_of_space() && seen < kAsLong * length * map.scale();
  const std::string text = Numbers(run.lesson)(length) + (is_short ? ", foreshortened" : "");
  out.moving_labels.push_back(label(id, text, "distance.label", type::kSmallVertex,
                                    0.5 * (from + to), 2.0,
                                    Point(from.y() - to.y(), to.x() - from.x())));
}

}  // namespace gjkscope
