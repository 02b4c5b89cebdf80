#pragma once
// The tools to draw the layers of a stage: the frame's state, where view coordinates are in the
// frame, and marks that labels keep away from.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/vocabulary.hpp"
#include "picture/depth_order.hpp"
#include "picture/labels.hpp"
#include "run/facts.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// From the coordinates of a view to the frame: y up becomes y down. Space is seen by the camera's
/// eye, orthographically.
class StageMap {
 public:
  /// Pixels from the stage's middle beyond which a point is moved in: a painter computes in single
  /// precision, and what is out there is seen only as a line's direction.
  static constexpr double kFarthest = 1e7;

  /// Shows `camera.height` units over the height of `area`, centered. Who cuts off what lies
  /// outside may do without a `farthest`.
  StageMap(const Rect& area, const Camera& camera, double farthest = kFarthest)
      : area_(area), camera_(camera), farthest_(farthest) {
    if (camera.eye) axes_ = axes_of(*camera.eye);
  }
  /// Pixels for a unit along y.
  [[nodiscard]] double scale() const { return area_.size().y() / camera_.height; }
  /// Vectors have two or three coordinates; in the plane the third is not seen.
  template <class V>
  [[nodiscard]] Point operator()(const Eigen::MatrixBase<V>& v) const {
    const Eigen::Vector2d from_center =
        camera_.eye ? seen(in_space(v.eval()) - camera_.center)
                    : Eigen::Vector2d(v.template head<2>() - camera_.center.head<2>());
    const Eigen::Vector2d d =
        stretched(scale() * from_center).cwiseMax(-farthest_).cwiseMin(farthest_);
    return area_.center() + Point(d.x(), -d.y());
  }
  /// Along d, in frame pixels: of unit length; in space shorter, as far as d points towards the eye
  /// or away from it.
  template <class V>
  [[nodiscard]] Point direction(const Eigen::MatrixBase<V>& d) const {
    if (camera_.eye) {
      const Eigen::Vector2d along = seen(in_space(d.eval()).normalized());
      return {along.x(), -along.y()};
    }
    const Eigen::Vector2d along = stretched(d.template head<2>());
    return Point(along.x(), -along.y()) / along.norm();
  }
  [[nodiscard]] bool is_of_space() const { return camera_.eye.has_value(); }
  /// Directions of the world to the right, up and towards the eye, as rows; only in space.
  [[nodiscard]] const Eigen::Matrix3d& axes() const { return axes_; }
  [[nodiscard]] const Eigen::Vector3d& center() const { return camera_.center; }
  /// Frame pixels, and as many towards the eye; only in space.
  [[nodiscard]] Eigen::Vector3d in_depth(const Eigen::Vector3d& v) const {
    const Eigen::Vector3d d = scale() * (axes_ * (v - camera_.center));
    return {area_.center().x() + d.x(), area_.center().y() - d.y(), d.z()};
  }
  /// How far v reaches towards the eye; only in space.
  [[nodiscard]] double towards_eye(const Eigen::Vector3d& v) const { return axes_.row(2).dot(v); }
  [[nodiscard]] const Rect& area() const { return area_; }
  /// Corners of what `area` shows, counter-clockwise, in view coordinates.
  [[nodiscard]] std::vector<Eigen::Vector2d> visible() const;

 private:
  [[nodiscard]] Eigen::Vector2d seen(const Eigen::Vector3d& v) const {
    return axes_.topRows<2>() * v;
  }
  [[nodiscard]] Eigen::Vector2d stretched(const Eigen::Vector2d& v) const {
    return {v.x() / camera_.stretch, v.y()};
  }

  Rect area_;
  Camera camera_;
  double farthest_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
};

/// The drawing on a stage at one frame, labels not yet placed.
struct Scene {
  std::vector<Mark> marks;
  std::vector<PaintedSurface> surfaces;  ///< Areas of space, until they are marks.
  std::vector<LooseMark> loose_marks;    ///< The same.
  std::vector<LabelRequest>
      fixed_labels;  ///< For things that do not move: one place for the whole lesson.
  std::vector<LabelRequest> moving_labels;
  std::vector<AreaLabelRequest> area_labels;
  Obstacles obstacles;
  void append(const Scene& more);
};

/// Corners of an outline, in frame pixels: of more than a few hundred those alone that can be told
/// from the one before.
[[nodiscard]] std::vector<Point> separate_points(const std::vector<Point>& points);

/// How far apart points are, in frame pixels, if they are spread evenly over the box around them.
[[nodiscard]] double room_of(const std::vector<Point>& points);
/// The same for the edges of an outline, which may cross each other.
[[nodiscard]] double room_of_outline(const std::vector<Point>& points);

/// Sizes of marks in frame pixels.
namespace sizes {
inline constexpr double kVertexRadius = 4.0;
inline constexpr double kSimplexRadius = 6.5;
inline constexpr double kSupportRadius = 9.0;  // of a diamond
inline constexpr double kPointRadius = 8.0;    // of the cross at Q
inline constexpr double kClosestRadius = 3.5;  // a simplex vertex under P stays visible around it
inline constexpr double kCloudRadius = 3.0;
inline constexpr double kPartOfRoom = 0.35;  // radius of a disk, of the way to the next
inline constexpr double kTouchedRadius = 4.5;
inline constexpr double kOriginRadius = 9.0;
inline constexpr double kRingRadius = 9.0;
inline constexpr double kArrowLength = 76.0;
inline constexpr double kShortArrow = 26.0;
inline constexpr double kPairArrow =
    54.0;  // d and −d at the shapes, which may be close to each other
inline constexpr double kLabelGap = 7.0;
inline constexpr double kLengthOffset = 13.0;  // of a fractional length from its segment
}  // namespace sizes

/// A vertex of the Minkowski difference; of a point query it is a vertex of Y.
[[nodiscard]] Subject subject_of(const LessonRun& run, gjk::VertexPair pair);

/// Builds the scene of one view at one frame; each layer adds its marks and labels to
/// `out`.
struct SceneBuilder {
  SceneBuilder(const LessonRun& lesson_run, EffectGraph& graph, const Frame& shown,
               const LessonView& of_view, const StageMap& stage_map);

  // Positions, of two or three coordinates
  template <class V>
  [[nodiscard]] Point at(const Eigen::MatrixBase<V>& view_point) const {
    return map(view_point);
  }
  template <class V>
  [[nodiscard]] std::vector<Point> mapped(const std::vector<V>& points) const {
    std::vector<Point> in_frame;
    in_frame.reserve(points.size());
    for (const V& point : points) in_frame.push_back(map(point));
    return in_frame;
  }
  template <class V>
  [[nodiscard]] Point at_difference(const Eigen::MatrixBase<V>& z) const {
    return map(in_space(z.eval()) + shift);
  }
  [[nodiscard]] const Eigen::Vector3d& vertex_of_x(const WideVertex& vertex) const {
    return positioned.x().world[vertex.pair.x];
  }
  [[nodiscard]] const Eigen::Vector3d& vertex_of_y(const WideVertex& vertex) const {
    return positioned.y().world[vertex.pair.y];
  }
  [[nodiscard]] Point vertex_at(int i) const { return at_difference(state.simplex.vertices[i].w); }

  // Marks; all but areas are obstacles for labels, too
  void add(std::string role, decltype(Mark::shape) shape, const Subject& subject = {});
  void area(std::string role, const std::vector<Point>& points, const Subject& subject = {});
  /// An area shown by lines alone, for which no colour is needed.
  void hatched(const std::string& role, const std::vector<Point>& points);
  void line(std::string role, const Point& a, const Point& b, const Subject& subject = {});
  /// In space lines and disks are painted at their depth; `hidden`: the role of what lies behind
  /// an opaque body, if it is another.
  void line_in_space(std::string role, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     std::string hidden = {}, const Subject& subject = {});
  void disk_in_space(std::string role, const Eigen::Vector3d& center, double radius,
                     const Subject& subject = {});
  /// The closed outline as an obstacle alone.
  void outline(const std::vector<Point>& points);
  /// As one that labels rather keep off.
  void passing_outline(const std::vector<Point>& points);
  void disk(std::string role, const Point& center, double radius, const Subject& subject = {});
  void diamond(std::string role, const Point& center, double radius, const Subject& subject = {});
  /// A square that lies on its side: the foot of a perpendicular.
  void square(std::string role, const Point& center, double radius);
  void cross(std::string role, const Point& center, double radius, const Subject& subject = {});
  void arrow(std::string role, const Point& from, const Point& to);
  /// A label `radius` and a little away from its anchor, preferably on the side `towards`.
  [[nodiscard]] LabelRequest label(std::string id, std::string text, std::string role,
                                   const TextStyle& style, const Point& anchor, double radius,
                                   const Point& towards = Point::Zero()) const;
  /// A vertex of the difference; between polygons its two vertices in the world, and its name.
  void simplex_vertex(const WideVertex& vertex, const std::string& role);
  /// In the world, a thin line between the vertices that make a difference.
  void link(const Eigen::Vector3d& x, const Eigen::Vector3d& y);
  void pair_label(const WideVertex& vertex, const std::string& role);
  /// The name of a difference, in the colours of both shapes.
  [[nodiscard]] LabelRequest pair_name(gjk::VertexPair pair, const std::string& role,
                                       const Point& anchor, double radius,
                                       const Point& towards) const;
  /// The list for labels of the difference: along a path it moves.
  [[nodiscard]] std::vector<LabelRequest>& labels_of_difference() {
    return run.lesson.path_of_shapes ? out.moving_labels : out.fixed_labels;
  }
  /// The length of a search direction's arrow that starts at `p`, a point of the difference.
  [[nodiscard]] double arrow_length(const Eigen::Vector3d& p) const;
  /// The middle of the arrow along a state's search direction.
  [[nodiscard]] Point middle_of_arrow(const WideState& of) const {
    return at_difference(of.p) + 0.5 * arrow_length(of.p) * map.direction(of.d);
  }
  /// An arrow along d, and its name.
  void search_arrow(const Point& from, const Eigen::Vector3d& d, double length,
                    const std::string& text);
  /// The line through a point, normal to d.
  void support_line(const Point& through, const Eigen::Vector3d& d,
                    const std::string& role = "support.plane");
  /// The line through a point of the difference, normal to d; in space a part of the plane.
  void support_plane(const Eigen::Vector3d& w, const Eigen::Vector3d& d,
                     const std::string& role = "support.plane");
  /// Half a side of the part of a plane that is drawn: about the size of Z.
  [[nodiscard]] double plane_half_width() const;
  /// A length beside the line that it is the length of, and whether space shows it shorter; none
  /// within a pixel.
  void length_label(const std::string& id, double length, const Point& from, const Point& to);

  [[nodiscard]] bool shows(std::string_view effect) const { return view.calls_for(effect); }
  /// Elsewhere frames are about the vertices that P needs.
  [[nodiscard]] bool shows_whole_simplex() const { return run.tour->follows_run; }

  const LessonRun& run;
  EffectGraph& effects;
  const Frame& frame;
  const LessonView& view;
  const StageMap& map;
  const PositionedRun& positioned;
  const WideState& state;
  /// From the difference to the view. A point query's difference is the polygon seen from Q: drawn
  /// in the world it stands where the polygon is.
  Eigen::Vector3d shift;
  bool shows_difference;
  const FrameFacts::Value& knows;
  Scene out;
};

/// Fits a box of the world, with room for labels and for the view's title.
[[nodiscard]] Camera camera_around(const Eigen::AlignedBox2d& box, const Rect& area);

}  // namespace gjkscope
