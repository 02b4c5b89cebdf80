#include "subjects/minkowski_sum/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::sums {
namespace {

using Eigen::Vector2d;
using minkowski_sum::Corner;
using minkowski_sum::Phase;
using minkowski_sum::Source;
using namespace sizes;

const Vector2d& point_of(const models::Ring& ring, int i) { return ring.points[i]; }

std::string role_of(Source source) {
  return source == Source::y ? "from.y" : source == Source::x ? "from.x" : "from.both";
}

/// The step whose edge is asked for; none where a frame tells.
const minkowski_sum::Step* asked_step(const SceneBuilder& scene, const Shown& shown) {
  if (scene.frame.question < 0) return nullptr;
  const minkowski_sum::Step& step = shown.merge.steps[scene.frame.answering_step];
  return step.phase == Phase::edge ? &step : nullptr;
}

/// In the world: the edges of X and Y that make the newest edge, or that can make the next.
void in_world(SceneBuilder& scene, const Shown& shown) {
  const minkowski_sum::Step* asked = asked_step(scene, shown);
  if (asked == nullptr && !shown.is(Phase::edge)) return;
  const auto mark = [&](const models::Ring& ring, int from, const std::string& role) {
    scene.line(role, scene.at(point_of(ring, from)), scene.at(point_of(ring, ring.next(from))));
  };
  const Source source = asked != nullptr ? Source::both : shown.step->source;
  const Corner& from = asked != nullptr ? asked->before.at : shown.step->before.at;
  if (source != Source::x) mark(shown.merge.y, from.y, "from.y");
  if (source != Source::y) mark(shown.merge.x, from.x, "from.x");
}

/// -X and Y, which are added.
void summands(SceneBuilder& scene, const Shown& shown) {
  const auto outline = [&](const models::Ring& ring, double sign, const std::string& role,
                           const std::string& name) {
    std::vector<Point> points;
    Point middle = Point::Zero();
    for (const Vector2d& point : ring.points) points.push_back(scene.at(sign * point));
    for (const Point& point : points) middle += point / static_cast<double>(points.size());
    scene.area(role, points);
    scene.outline(points);
    scene.out.moving_labels.push_back(scene.label("summand:" + name, name, role + ".label",
                                                  type::kVertex, points[0], kVertexRadius,
                                                  points[0] - middle));
  };
  outline(shown.merge.y, 1.0, "shape.y", shown.lesson.y().name);
  outline(shown.merge.x, -1.0, "shape.x", "−" + shown.lesson.x().name);
}

/// The lowest vertices of Y and of -X.
std::array<Vector2d, 2> lowest_vertices(const Shown& shown) {
  const Corner& lowest = shown.merge.steps.front().after.at;
  return {point_of(shown.merge.y, lowest.y), Vector2d(-point_of(shown.merge.x, lowest.x))};
}

/// The lowest vertex of Y, and from there as far as that of -X is from O.
void sum_of_lowest(SceneBuilder& scene, const Shown& shown) {
  summands(scene, shown);
  const auto [of_y, of_x] = lowest_vertices(shown);
  const Point o = scene.at(Vector2d::Zero());
  scene.arrow("ghost.arrow", o, scene.at(of_y));
  scene.arrow("ghost.arrow", o, scene.at(of_x));
  scene.arrow("ghost.arrow", scene.at(of_y), scene.at(Vector2d(of_y + of_x)));
}

void in_difference(SceneBuilder& scene, const Shown& shown) {
  if (shown.step == nullptr) {
    summands(scene, shown);
    const bool asks = scene.frame.question >= 0;
    for (int i = 0; asks && i < static_cast<int>(lowest_places(shown).size()); ++i) {
      const Point place = scene.at(lowest_places(shown)[static_cast<std::size_t>(i)]);
      const std::string name = std::to_string(i + 1);
      scene.disk("cloud.current", place, kTouchedRadius);
      scene.out.moving_labels.push_back(
          scene.label("place:" + name, name, "cloud.label", type::kVertex, place, kTouchedRadius));
    }
    return;
  }
  if (shown.is(Phase::lowest)) sum_of_lowest(scene, shown);
  const minkowski_sum::Merge& merge = shown.merge;
  const auto corner_at = [&](const Corner& corner) { return scene.at(merge.at(corner)); };
  if (shown.is_closed()) {
    std::vector<Point> points;
    for (const Corner& corner : merge.corners) points.push_back(corner_at(corner));
    scene.area("hull", points);
  }
  Point middle = Point::Zero();
  for (const Corner& corner : merge.corners)
    middle += corner_at(corner) / static_cast<double>(merge.corners.size());
  const auto corner_mark = [&](const Corner& corner) {
    const Point point = corner_at(corner);
    scene.disk("cloud.touched", point, kTouchedRadius);
    const std::string name = shown.corner(corner);
    scene.out.fixed_labels.push_back(scene.label("corner:" + name, name, "cloud.label",
                                                 type::kSmallVertex, point, kTouchedRadius,
                                                 point - middle));
  };
  // Both edges that can follow are choices alike, each in its own colour and with its name.
  const minkowski_sum::Step* asked = asked_step(scene, shown);
  for (const Source source : {Source::y, Source::x}) {
    if (asked == nullptr) break;
    const Point from = corner_at(asked->before.at);
    const auto tip = [&](Source of) {
      return scene.at(merge.at(asked->before.at) + edge_of(shown, asked->before.at, of));
    };
    const Point to = tip(source);
    scene.arrow(role_of(source), from, to);
    const std::string name = shown.edge(asked->before.at, source);
    scene.out.moving_labels.push_back(
        scene.label("next:" + name, name, source == Source::y ? "shape.y.label" : "shape.x.label",
                    type::kSmallVertex, 0.5 * (from + to), 2.0,
                    to - tip(source == Source::y ? Source::x : Source::y)));
  }
  // The edge that was not taken stays what it was: next.
  if (asked == nullptr && shown.is(Phase::edge) && shown.step->source != Source::both) {
    const Source other = shown.step->source == Source::y ? Source::x : Source::y;
    const bool is_left = other == Source::y ? shown.step->before.edges_of_y < merge.y.size()
                                            : shown.step->before.edges_of_x < merge.x.size();
    const Vector2d from = merge.at(shown.step->before.at);
    if (is_left)
      scene.arrow("ghost.arrow", scene.at(from),
                  scene.at(from + edge_of(shown, shown.step->before.at, other)));
  }
  const bool waits = shown.is(Phase::lowest) || (shown.is(Phase::edge) && !shown.is_closed());
  for (int i = 0; i < shown.edges(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Vector2d from = merge.at(merge.corners[index]);
    const Source source = merge.edges[index];
    const bool is_separating =
        (shown.is(Phase::inside) || shown.is_answer) && i == merge.separating;
    const Vector2d edge = edge_of(shown, merge.corners[index], source);
    scene.line(role_of(source), scene.at(from), scene.at(from + edge));
    if (is_separating)
      scene.support_line(scene.at(from), in_space(Vector2d(edge.y(), -edge.x())), "slab.side");
  }
  for (int i = 0; i < std::min(shown.edges() + 1, static_cast<int>(merge.corners.size())); ++i)
    corner_mark(merge.corners[i]);
  if (waits) scene.disk("cloud.current", corner_at(shown.step->after.at), kSimplexRadius);
}

}  // namespace

Vector2d edge_of(const Shown& shown, const Corner& from, Source source) {
  const models::Ring& x = shown.merge.x;
  const models::Ring& y = shown.merge.y;
  Vector2d edge = Vector2d::Zero();
  if (source != Source::x) edge += point_of(y, y.next(from.y)) - point_of(y, from.y);
  if (source != Source::y) edge -= point_of(x, x.next(from.x)) - point_of(x, from.x);
  return edge;
}

std::array<Vector2d, 4> lowest_places(const Shown& shown) {
  const auto [of_y, of_x] = lowest_vertices(shown);
  return {of_y, Vector2d(of_y + of_x), Vector2d(of_x - of_y), of_x};
}

void stage(SceneBuilder& scene) {
  const Shown& shown = shown_in<Shown>(scene);
  if (shown.trace.refusal) return;
  scene.view.kind == ViewKind::world ? in_world(scene, shown) : in_difference(scene, shown);
}

}  // namespace gjkscope::sums
