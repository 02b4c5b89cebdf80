#include "picture/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "effects/barycentric.hpp"
#include "effects/history.hpp"
#include "effects/minkowski.hpp"
#include "effects/voronoi.hpp"
#include "picture/words.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;

// Sizes of marks in frame pixels.
constexpr double kVertexRadius = 4.5;
constexpr double kSimplexRadius = 6.5;
constexpr double kPointRadius = 6.0;
constexpr double kClosestRadius = 4.5;  // a simplex vertex under P stays visible as a ring
constexpr double kCloudRadius = 3.0;
constexpr double kOriginRadius = 9.0;
constexpr double kRingRadius = 10.5;
constexpr double kArrowLength = 76.0;
constexpr double kShortArrow = 26.0;
constexpr double kPairArrow = 54.0;  // d and −d at the shapes, which may be close to each other
constexpr double kLabelGap = 7.0;
constexpr double kLengthOffset = 13.0;  // of a fractional length from its segment

bool calls_for(const LessonView& view, std::string_view effect) {
  return std::find(view.effects.begin(), view.effects.end(), effect) != view.effects.end();
}

/// Builds one scene: knows the frame's state, and where view coordinates are.
class SceneBuilder {
 public:
  SceneBuilder(const LessonRun& run, EffectGraph& effects, const Frame& frame,
               const LessonView& view, const StageMap& map)
      : run_(run),
        effects_(effects),
        frame_(frame),
        view_(view),
        map_(map),
        positioned_(run.run(frame)),
        state_(run.state(frame)),
        // A point query's difference is the polygon seen from Q: drawn in the world it stands where
        // the polygon is.
        shift_(view.kind == ViewKind::world && run.point_query() ? positioned_.x_world[0]
                                                                 : Vector2d(0.0, 0.0)),
        shows_difference_(view.kind == ViewKind::difference || run.point_query()),
        phase_(frame.step < 0 ? std::nullopt : std::optional(run.step(frame).phase)) {}

  Scene build() {
    if (calls_for(view_, VoronoiRegions::kName)) regions();
    if (view_.kind == ViewKind::world) shapes();
    if (view_.kind == ViewKind::difference) difference();
    if (calls_for(view_, BarycentricParts::kName)) parts();
    if (run_.lesson.path_of_x && view_.kind == ViewKind::world) path();
    if (run_.lesson.granularity == Granularity::pairs) {
      pair_under_construction();
    } else {
      if (calls_for(view_, History::kName)) history();
      simplex();
      if (shows_difference_) {
        closest_line();
        search();
        closest_point();
      } else {
        witness_points();
        search_between_shapes();
      }
    }
    query_point();
    return std::move(scene_);
  }

 private:
  // Positions
  // ------------------------------------------------------------------------------------------------------

  Point at(const Vector2d& view_point) const { return map_(view_point); }
  Point at_difference(const Vector2d& z) const { return map_(z + shift_); }
  const Vector2d& vertex_of_x(const gjk::SupportPoint<double, 2>& vertex) const {
    return positioned_.x_world[vertex.pair.x];
  }
  const Vector2d& vertex_of_y(const gjk::SupportPoint<double, 2>& vertex) const {
    return positioned_.y_world[vertex.pair.y];
  }
  Point vertex_at(int i) const { return at_difference(state_.simplex.vertices[i].w); }

  // Marks
  // ----------------------------------------------------------------------------------------------------------

  void add(std::string role, decltype(Mark::shape) shape) {
    scene_.marks.push_back({std::move(role), std::move(shape)});
  }

  void area(std::string role, const std::vector<Point>& points) {
    add(std::move(role), Polygon{points});
  }

  void line(std::string role, const Point& a, const Point& b) {
    add(std::move(role), Polyline{{a, b}});
    scene_.obstacles.segments.push_back({a, b});
  }

  void outline(const std::vector<Point>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      scene_.obstacles.segments.push_back({points[i], points[(i + 1) % points.size()]});
    }
  }

  void disk(std::string role, const Point& center, double radius) {
    add(std::move(role), Disk{center, radius});
    scene_.obstacles.circles.push_back({center, radius});
  }

  void arrow(std::string role, const Point& from, const Point& to) {
    add(std::move(role), Arrow{from, to});
    scene_.obstacles.segments.push_back({from, to});
    scene_.obstacles.circles.push_back({to, 6.0});
  }

  LabelRequest label(std::string id, std::string text, std::string role, const TextStyle& style,
                     const Point& anchor, double radius,
                     const Point& towards = Point::Zero()) const {
    return {std::move(id), std::move(text),    std::move(role), style,
            anchor,        radius + kLabelGap, towards};
  }

  // Layers
  // ---------------------------------------------------------------------------------------------------------

  bool tests_regions() const { return phase_ == gjk::Phase::closest || !phase_; }

  /// What the region tests have said of a face so far; granularity "test" reveals them one by one.
  enum class RegionFate { untried, rejected, testing, holds };
  RegionFate fate_of(gjk::Face face) const {
    const auto& tests = run_.step(frame_).record.region_tests;
    const bool gradual = run_.lesson.granularity == Granularity::test;
    const int reached = gradual ? frame_.detail : static_cast<int>(tests.size()) - 1;
    for (int i = 0; i <= reached; ++i) {
      if (tests[i].region != face) continue;
      if (tests[i].holds) return RegionFate::holds;
      return i == reached && gradual ? RegionFate::testing : RegionFate::rejected;
    }
    return RegionFate::untried;
  }

  void regions() {
    if (!phase_ || !tests_regions()) return;
    const SimplexWords words(run_, state_.simplex);
    const bool gradual = run_.lesson.granularity == Granularity::test;
    for (const VoronoiRegions::Region& region : effects_.get<VoronoiRegions>(frame_)) {
      std::vector<Vector2d> polygon = map_.visible();
      for (const HalfPlane& half_plane : region.half_planes) {
        polygon = clip(polygon, {half_plane.point + shift_, half_plane.normal});
      }
      if (polygon.empty()) continue;
      std::vector<Point> points;
      for (const Vector2d& corner : polygon) points.push_back(at(corner));
      constexpr std::array<std::string_view, 4> kKinds = {"", "vertex", "edge", "interior"};
      const RegionFate fate = fate_of(region.face);
      std::string role = fmt::format("region.{}", kKinds[gjk::vertex_count(region.face)]);
      if (fate == RegionFate::holds) role = "region.active";
      if (gradual && fate == RegionFate::rejected) role = "region.rejected";
      if (fate == RegionFate::testing) role = "region.testing";
      area(std::move(role), points);
      const bool interior = gjk::vertex_count(region.face) == 3;
      const std::string name = interior ? "interior" : "region " + words.face(region.face);
      scene_.area_labels.push_back(
          {"region:" + name, name, "region.label", type::kRegion, points, {}});
    }
    borders();
  }

  /// Each region's border once: the normals of every edge at its ends, outwards.
  void borders() {
    const gjk::Simplex<double, 2>& simplex = state_.simplex;
    const double reach = (map_.visible()[2] - map_.visible()[0]).norm();
    for (int i = 0; i < simplex.count; ++i) {
      for (int j = i + 1; j < simplex.count; ++j) {
        const Vector2d a = simplex.vertices[i].w + shift_;
        const Vector2d b = simplex.vertices[j].w + shift_;
        const Vector2d edge = b - a;
        if (edge.norm() == 0.0) continue;
        Vector2d outwards = Vector2d(edge.y(), -edge.x()).normalized();
        const bool triangle = simplex.count == 3;
        if (triangle && outwards.dot(simplex.vertices[3 - i - j].w + shift_ - a) > 0.0)
          outwards = -outwards;
        for (const Vector2d& end : {a, b}) {
          line("region.border", at(triangle ? end : Vector2d(end - reach * outwards)),
               at(end + reach * outwards));
        }
      }
    }
  }

  void shape(const LessonShape& shape, const std::vector<Vector2d>& world,
             const std::string& role) {
    std::vector<Point> points;
    for (const Vector2d& vertex : world) points.push_back(at(vertex));
    const Point middle = centroid(points);
    if (points.size() == 2) {
      line(role, points[0], points[1]);
    } else if (points.size() > 2) {
      if (is_convex(world)) {
        area(role, points);
      } else {
        add(role, Polyline{points, true});
      }
      outline(points);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      disk(role + ".vertex", points[i], kVertexRadius);
      Point away = points[i] - middle;
      if (points.size() == 1) away = Point::Zero();
      scene_.fixed_labels.push_back(label("vertex:" + shape.vertex_names[i], shape.vertex_names[i],
                                          role + ".label", type::kVertex, points[i], kSimplexRadius,
                                          away));
    }
  }

  void shapes() {
    if (run_.point_query()) {
      shape(run_.lesson.y, positioned_.y_world, "shape");
    } else {
      shape(run_.lesson.x, positioned_.x_world, "shape.x");
      shape(run_.lesson.y, positioned_.y_world, "shape.y");
    }
  }

  /// How many differences granularity "pairs" has made by this frame; all of them elsewhere.
  int pairs_made(int all) const {
    return run_.lesson.granularity == Granularity::pairs ? std::min(frame_.detail, all) : all;
  }
  bool hull_is_shown(int all) const {
    return run_.lesson.granularity != Granularity::pairs || frame_.detail > all;
  }

  void difference() {
    const bool wants_hull = calls_for(view_, MinkowskiHull::kName);
    const bool wants_cloud = calls_for(view_, MinkowskiCloud::kName);
    if (!wants_hull && !wants_cloud) return;
    const int all = static_cast<int>(positioned_.x_world.size() * positioned_.y_world.size());
    const bool names_all = all <= 12 && run_.lesson.granularity == Granularity::pairs;
    if (wants_hull && hull_is_shown(all)) {
      const MinkowskiCloud::Value& cloud = effects_.get<MinkowskiCloud>(frame_);
      const MinkowskiHull::Value& hull = effects_.get<MinkowskiHull>(frame_);
      std::vector<Point> points;
      for (const int index : hull) points.push_back(at(cloud[index].z));
      area("hull", points);
      outline(points);
    }
    if (wants_cloud && pairs_made(all) > 0) {
      const MinkowskiCloud::Value& cloud = effects_.get<MinkowskiCloud>(frame_);
      const int made = pairs_made(all);
      Point middle = Point::Zero();
      for (const CloudPoint& point : cloud) middle += at(point.z) / static_cast<double>(all);
      for (int i = 0; i < made; ++i) {
        const Point point = at(cloud[i].z);
        disk("cloud.point", point, kCloudRadius);
        if (names_all) {
          const std::string name = run_.pair_name(cloud[i].pair);
          scene_.fixed_labels.push_back(label("cloud:" + name, name, "cloud.label",
                                              type::kSmallVertex, point, kCloudRadius,
                                              point - middle));
        }
      }
    }
  }

  /// Granularity "pairs": the pair that makes the newest difference, in both views.
  void pair_under_construction() {
    const int all = static_cast<int>(positioned_.x_world.size() * positioned_.y_world.size());
    const int made = frame_.detail;
    if (made > all) {
      if (view_.kind == ViewKind::difference) {
        line("closest.line", at(Vector2d::Zero()),
             at(positioned_.trace.result.y - positioned_.trace.result.x));
        disk("closest", at(positioned_.trace.result.y - positioned_.trace.result.x),
             kClosestRadius);
      } else {
        line("closest.line", at(positioned_.trace.result.x), at(positioned_.trace.result.y));
        disk("closest", at(positioned_.trace.result.x), kClosestRadius);
        disk("closest", at(positioned_.trace.result.y), kClosestRadius);
      }
      return;
    }
    if (made < 1) return;
    const int per_x = static_cast<int>(positioned_.y_world.size());
    const gjk::VertexPair pair{(made - 1) / per_x, (made - 1) % per_x};
    const Vector2d x = positioned_.x_world[pair.x];
    const Vector2d y = positioned_.y_world[pair.y];
    if (view_.kind == ViewKind::world) {
      arrow("difference.arrow", at(x), at(y));
      disk("support", at(x), kSimplexRadius);
      disk("support", at(y), kSimplexRadius);
    } else {
      arrow("difference.arrow", at(Vector2d::Zero()), at(y - x));
      disk("cloud.current", at(y - x), kSimplexRadius);
    }
  }

  void path() {
    std::vector<Point> points;
    for (const PositionedRun& run : run_.runs) points.push_back(at(run.x_world[0]));
    // Without a number of frames the path is a set of places to be in, not a way between them.
    if (run_.lesson.path_of_x->frames > 0) {
      add("path", Polyline{points});
      for (std::size_t i = 1; i < points.size(); ++i) {
        scene_.obstacles.segments.push_back({points[i - 1], points[i]});
      }
    }
    for (const Point& point : points) add("path.point", Disk{point, 3.0});
  }

  void history() {
    for (const History::Entry& entry : effects_.get<History>(frame_)) {
      if (!shows_difference_) continue;
      std::vector<Point> points;
      for (int i = 0; i < entry.simplex.count; ++i)
        points.push_back(at_difference(entry.simplex.vertices[i].w));
      if (points.size() > 1) {
        add("history.simplex", Polyline{points, points.size() > 2});
        outline(points);
      }
      const Point p = at_difference(entry.p);
      add("history.closest", Disk{p, 3.5});
      scene_.obstacles.circles.push_back({p, 3.5});
      scene_.moving_labels.push_back(label(fmt::format("history:{}", entry.iteration),
                                           fmt::format("P{}", subscript(entry.iteration)),
                                           "history.label", type::kSmallVertex, p, 3.5));
    }
  }

  static std::string subscript(int number) {
    std::string out;
    for (const char digit : std::to_string(number))
      out += std::string("₀₁₂₃₄₅₆₇₈₉").substr(3 * (digit - '0'), 3);
    return out;
  }

  /// Granularity "test" shows an area only while its sign decides: when the region of its edge is
  /// tested.
  bool measures_tested_edge(const BarycentricParts::Part& part) const {
    if (run_.lesson.granularity != Granularity::test || part.points.size() != 3) return true;
    if (frame_.detail < 0) return false;
    const gjk::Face tested = run_.step(frame_).record.region_tests[frame_.detail].region;
    return gjk::vertex_count(tested) == 2 && !gjk::contains(tested, part.vertex);
  }

  /// Lengths and areas in proportion to the barycentric coordinates.
  void parts() {
    if (!tests_regions() || !phase_) return;
    constexpr std::array<std::string_view, 3> kRoles = {"area.u", "area.v", "area.w"};
    constexpr std::array<std::string_view, 3> kLetters = {"u", "v", "w"};
    int side = 1;
    for (const BarycentricParts::Part& part : effects_.get<BarycentricParts>(frame_)) {
      if (!measures_tested_edge(part)) continue;
      std::vector<Point> points;
      for (const Vector2d& point : part.points) points.push_back(at_difference(point));
      const std::string role =
          part.weight < 0.0 ? "area.negative" : std::string(kRoles[part.vertex]);
      const std::string text =
          fmt::format("{} = {}", kLetters[part.vertex], Numbers(run_.lesson).weight(part.weight));
      if (points.size() == 3) {
        area(role, points);
        outline(points);
        // Where the area is too thin for its label: outside of the simplex, at the edge that the
        // area stands on.
        // A negative area lies beyond that edge, up to Q.
        const bool beyond = part.weight < 0.0;
        const Point foot = beyond ? points[0] : Point(0.5 * (points[1] + points[2]));
        const std::string id = fmt::format("part:{}{}", part.vertex, beyond ? ":beyond" : "");
        LabelRequest outside = label(id + ":outside", text, "area.label", type::kSmallVertex, foot,
                                     beyond ? kPointRadius : 4.0, foot - vertex_at(part.vertex));
        outside.keeps_side = true;
        scene_.area_labels.push_back({id, text, "area.label", type::kSmallVertex, points, outside});
      } else {
        const Point along = points[1] - points[0];
        if (along.norm() < 1.0) continue;
        Point normal = Point(along.y(), -along.x()).normalized();
        if (normal.y() < 0.0) normal = -normal;  // below the segment on screen, one row a weight
        const Point offset = normal * kLengthOffset * side;
        line(role + ".length", points[0] + offset, points[1] + offset);
        scene_.moving_labels.push_back(label("part:" + std::to_string(part.vertex), text,
                                             "area.label", type::kSmallVertex,
                                             0.5 * (points[0] + points[1]) + offset, 3.0, normal));
      }
      ++side;
    }
  }

  // The run
  // --------------------------------------------------------------------------------------------------------

  bool knows_closest_point() const {
    if (!phase_ || phase_ == gjk::Phase::add) return false;
    if (run_.lesson.granularity != Granularity::test) return true;
    return frame_.detail == static_cast<int>(run_.step(frame_).record.region_tests.size()) - 1;
  }

  bool shows_whole_simplex() const {
    return run_.lesson.granularity == Granularity::phase ||
           run_.lesson.granularity == Granularity::iteration;
  }

  void simplex() {
    const gjk::Simplex<double, 2>& simplex = state_.simplex;
    const gjk::Face face = knows_closest_point() ? state_.region : gjk::Face{0};
    if (shows_difference_) {
      std::vector<Point> points;
      for (int i = 0; i < simplex.count; ++i) points.push_back(vertex_at(i));
      if (shows_whole_simplex() && points.size() == 3) area("simplex.fill", points);
      for (int i = 0; i < simplex.count; ++i) {
        for (int j = i + 1; j < simplex.count; ++j) {
          const bool holds_p =
              gjk::contains(face, i) && gjk::contains(face, j) && gjk::vertex_count(face) == 2;
          if (holds_p || shows_whole_simplex())
            line(holds_p ? "simplex.feature" : "simplex.edge", points[i], points[j]);
        }
      }
    }
    for (int i = 0; i < simplex.count; ++i) {
      if (!shows_whole_simplex() && !gjk::contains(face, i)) continue;
      simplex_vertex(simplex.vertices[i], "simplex");
    }
    if (phase_ == gjk::Phase::cull) {
      for (const gjk::SupportPoint<double, 2>& dropped : run_.step(frame_).record.dropped)
        dropped_vertex(dropped);
    }
  }

  void dropped_vertex(const gjk::SupportPoint<double, 2>& vertex) {
    if (shows_difference_) {
      disk("dropped", at_difference(vertex.w), kRingRadius);
      if (!run_.point_query()) pair_label(vertex, "dropped.label");
    }
  }

  void pair_label(const gjk::SupportPoint<double, 2>& vertex, const std::string& role) {
    const std::string name = run_.pair_name(vertex.pair);
    const Point point = at_difference(vertex.w);
    Point middle = map_.area().center();
    scene_.fixed_labels.push_back(label("cloud:" + name, name, role, type::kSmallVertex, point,
                                        kSimplexRadius, point - middle));
  }

  void simplex_vertex(const gjk::SupportPoint<double, 2>& vertex, const std::string& role) {
    if (shows_difference_) {
      disk(role + ".vertex", at_difference(vertex.w), kSimplexRadius);
      if (!run_.point_query()) pair_label(vertex, role + ".label");
    } else {
      disk(role + ".vertex", at(vertex_of_x(vertex)), kSimplexRadius);
      disk(role + ".vertex", at(vertex_of_y(vertex)), kSimplexRadius);
    }
  }

  bool reaches_query() const { return knows_closest_point() && state_.p.norm() == 0.0; }

  void closest_line() {
    if (knows_closest_point() && !reaches_query()) {
      line("closest.line", at_difference(state_.p), at_difference(Vector2d::Zero()));
    }
  }

  void closest_point() {
    if (!knows_closest_point()) return;
    const Point p = at_difference(state_.p);
    disk("closest", p, kClosestRadius);
    if (reaches_query()) return;  // Q's label names both
    scene_.moving_labels.push_back(label("P", "P", "closest.label", type::kVertex, p, kPointRadius,
                                         p - at_difference(Vector2d::Zero())));
  }

  void witness_points() {
    if (!knows_closest_point()) return;
    Vector2d x = Vector2d::Zero();
    Vector2d y = Vector2d::Zero();
    for (int i = 0; i < state_.simplex.count; ++i) {
      x += state_.simplex.weights[i] * vertex_of_x(state_.simplex.vertices[i]);
      y += state_.simplex.weights[i] * vertex_of_y(state_.simplex.vertices[i]);
    }
    line("closest.line", at(x), at(y));
    disk("closest", at(x), kClosestRadius);
    disk("closest", at(y), kClosestRadius);
  }

  bool has_direction() const {
    return phase_ == gjk::Phase::direction || phase_ == gjk::Phase::support ||
           (phase_ == gjk::Phase::stop && !stopped_early());
  }
  bool has_support() const {
    return phase_ == gjk::Phase::support || (phase_ == gjk::Phase::stop && !stopped_early());
  }
  /// True when the run went from cull or direction straight to the stop tests.
  bool stopped_early() const {
    if (frame_.step < 1) return true;
    return positioned_.trace.steps[frame_.step - 1].phase != gjk::Phase::support;
  }

  Point direction_on_screen(const Vector2d& d) const { return Point(d.x(), -d.y()) / d.norm(); }

  void search_arrow(const Point& from, const Vector2d& d, double length, const std::string& text) {
    if (!(d.norm() > 0.0)) return;
    const Point along = direction_on_screen(d);
    const Point tip = from + length * along;
    arrow("direction", from, tip);
    scene_.moving_labels.push_back(
        label("arrow:" + text, text, "direction.label", type::kVertex, tip, 6.0, along));
  }

  void search() {
    if (has_support()) {
      const Point w = at_difference(state_.support.w);
      const Point along = direction_on_screen(state_.d);
      const Point across(-along.y(), along.x());
      const double reach = map_.area().size().norm();
      add("support.plane", Polyline{{w - reach * across, w + reach * across}});
      scene_.obstacles.segments.push_back({w - reach * across, w + reach * across});
    }
    if (has_direction()) {
      // An arrow as long as the way to O would hide O under its head.
      const double way = (at_difference(state_.p) - at_difference(Vector2d::Zero())).norm();
      const double length =
          way < 1.4 * kArrowLength ? std::max(0.6 * way, kShortArrow) : kArrowLength;
      search_arrow(at_difference(state_.p), state_.d, length, "d");
    }
    if (has_support()) simplex_vertex(state_.support, "support");
  }

  void search_between_shapes() {
    if (!has_support()) return;
    search_arrow(at(vertex_of_y(state_.support)), state_.d, kPairArrow, "d");
    search_arrow(at(vertex_of_x(state_.support)), -state_.d, kPairArrow, "−d");
    simplex_vertex(state_.support, "support");
  }

  void query_point() {
    if (view_.kind == ViewKind::world && run_.point_query()) {
      const Point q = at(positioned_.x_world[0]);
      disk("query", q, kPointRadius);
      const std::string& name = run_.lesson.x.vertex_names[0];
      scene_.moving_labels.push_back(label("Q", reaches_query() ? "P = " + name : name,
                                           "query.label", type::kVertex, q, kPointRadius));
    }
    if (view_.kind == ViewKind::difference) {
      const Point o = at(Vector2d::Zero());
      add("origin", Cross{o, kOriginRadius});
      scene_.obstacles.circles.push_back({o, kOriginRadius});
      scene_.fixed_labels.push_back(
          label("O", "O", "origin.label", type::kVertex, o, kOriginRadius));
    }
  }

  const LessonRun& run_;
  EffectGraph& effects_;
  const Frame& frame_;
  const LessonView& view_;
  const StageMap& map_;
  const PositionedRun& positioned_;
  const gjk::State<double, 2>& state_;
  Vector2d shift_;
  bool shows_difference_;
  std::optional<gjk::Phase> phase_;
  Scene scene_;
};

}  // namespace

std::vector<Vector2d> StageMap::visible() const {
  const Vector2d half = 0.5 * area_.size() / scale();
  return {camera_.center - half, camera_.center + Vector2d(half.x(), -half.y()),
          camera_.center + half, camera_.center + Vector2d(-half.x(), half.y())};
}

Camera camera_of(const LessonRun& run, const LessonView& view, const Rect& area) {
  if (view.camera) {
    // On a page narrower than the usual one the height gives way, so that nothing is cut off at the
    // sides.
    const double usual_aspect = run.lesson.views.size() == 1 ? 1.8 : 0.95;
    Camera camera = *view.camera;
    camera.height *= std::max(1.0, usual_aspect * area.size().y() / area.size().x());
    return camera;
  }
  std::vector<Vector2d> points;
  for (const PositionedRun& positioned : run.runs) {
    if (view.kind == ViewKind::world) {
      points.insert(points.end(), positioned.x_world.begin(), positioned.x_world.end());
      points.insert(points.end(), positioned.y_world.begin(), positioned.y_world.end());
      continue;
    }
    points.push_back(Vector2d::Zero());
    for (const Vector2d& x : positioned.x_world) {
      for (const Vector2d& y : positioned.y_world) points.push_back(y - x);
    }
  }
  Vector2d low = points[0];
  Vector2d high = points[0];
  for (const Vector2d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  // Room for labels, and for the view's title at the top.
  constexpr double kSide = 64.0;
  constexpr double kTop = 64.0;
  constexpr double kBottom = 52.0;
  const Vector2d room = area.size() - Vector2d(2.0 * kSide, kTop + kBottom);
  const Vector2d extent = high - low;
  double scale = std::min(extent.x() > 0.0 ? room.x() / extent.x() : 1e300,
                          extent.y() > 0.0 ? room.y() / extent.y() : 1e300);
  if (scale >= 1e300) scale = room.y();
  Camera camera;
  camera.height = area.size().y() / scale;
  camera.center = 0.5 * (low + high) + Vector2d(0.0, 0.5 * (kTop - kBottom) / scale);
  return camera;
}

Scene stage_scene(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                  const LessonView& view, const StageMap& map) {
  return SceneBuilder(run, effects, frame, view, map).build();
}

}  // namespace gjkscope
