#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "outlines/polygon.hpp"
#include "picture/text_box.hpp"
#include "picture/words.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/study/dot_words.hpp"
#include "subjects/study/plot.hpp"
#include "subjects/study/rounded_pair.hpp"
#include "subjects/study/subject.hpp"
#include "subjects/study/table.hpp"
#include "subjects/study/tour.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using Gap = RoundedPair::Gap;

constexpr double kMargin = 14.0;
constexpr double kInsetHeight = 0.43;  ///< A share of the card.
constexpr double kHeader = 10.0;       ///< In an inset, beside the lines of its title.
constexpr double kLine = 20.0;
constexpr double kDimension = 32.0;  ///< From a vertex to the line that tells its gap.
constexpr double kRing = 9.0;        ///< Around what an inset enlarges.

std::vector<Vector2d> corners_of(const std::vector<Vector2d>& points) {
  std::vector<Vector2d> out;
  for (const int i : convex_hull(points)) out.push_back(points[i]);
  return out;
}

/// A part of the world, enlarged.
class Inset {
 public:
  Inset(SceneBuilder& scene, const Fonts& fonts, const Rect& card, const Vector2d& center,
        double scale, const std::string& title)
      : scene_(scene),
        fonts_(fonts),
        title_(wrapped(fonts, type::kText, title, card.size().x() - 2.0 * kTitleLeft)),
        map_({card.min + Point(0.0, header()), card.max},
             {in_space(center), (card.size().y() - header()) / scale}) {
    for (const Vector2d& corner : map_.visible()) seen_.extend(corner);
    scene_.add("inset", Box{card, 8.0});
    Point at = card.min + Point(kTitleLeft, 22.0);
    for (const std::string& line : title_) {
      scene_.add("inset.label", Text{at, line, type::kText});
      at.y() += kLine;
    }
  }

  void area(const std::string& role, const std::vector<Vector2d>& corners) {
    std::vector<Point> points;
    for (const Vector2d& corner : clip_to_box(corners, seen_)) points.push_back(map_(corner));
    if (points.size() > 2) scene_.area(role, points);
  }
  void outline(const std::string& role, const std::vector<Vector2d>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto seen = clip(corners[i], corners[(i + 1) % corners.size()], seen_);
      if (seen) scene_.line(role, map_((*seen)[0]), map_((*seen)[1]));
    }
  }
  /// The points that floats can be, unless there are too many to tell apart.
  void grid() {
    constexpr double kMost = 100.0;  // along each axis
    for (int k = 0; k < 2; ++k) {
      const double nearest = std::min(std::abs(seen_.min()[k]), std::abs(seen_.max()[k]));
      if (seen_.sizes()[k] > kMost * spacing_of_floats(nearest)) return;
    }
    for (float y = first_float(seen_.min().y()); y <= seen_.max().y(); y = next(y)) {
      for (float x = first_float(seen_.min().x()); x <= seen_.max().x(); x = next(x))
        scene_.add("rounded.grid", Disk{map_(Vector2d(x, y)), 1.5});
    }
  }
  void vertex(const std::string& role, const Vector2d& vertex) {
    if (seen_.contains(vertex)) scene_.disk(role, map_(vertex), sizes::kVertexRadius + 1.0);
  }
  /// Above a vertex, on the side `side` (-1 or 1).
  void name(const std::string& role, const Vector2d& vertex, const std::string& text, double side) {
    scene_.add(role, Text{map_(vertex) + Point(10.0 * side, -9.0), text, type::kVertex,
                          side < 0.0 ? Align::right : Align::left});
  }
  void unknown() {
    scene_.add("inset.label",
               Text{map_.area().center() - Point(0.0, 5.0), "?", type::kTitle, Align::center});
  }
  void move(const Vector2d& from, const Vector2d& to) {
    constexpr double kShortest = 16.0;
    const Point a = map_(from);
    const Point b = map_(to);
    const Point difference = b - a;
    if (difference.norm() < kShortest) return;
    scene_.arrow("rounded.arrow", a, b - 5.0 / difference.norm() * difference);
  }
  /// A gap as a line beside it, on the side `side` (-1 or 1), and its length.
  void gap(const std::string& role, const Gap& gap, double side, const std::string& text) {
    const Point a = map_(gap.vertex);
    const Point b = map_(gap.other);
    const Point along = (b - a).norm() > 1e-6 ? Point((b - a).normalized()) : Point(0.0, 1.0);
    Point across(along.y(), -along.x());
    if (across.x() * side < 0.0) across = -across;
    const Point shift = kDimension * across;
    constexpr double kTick = 7.0;
    scene_.line(role, a + shift, b + shift);
    for (const Point& end : {Point(a + shift), Point(b + shift)})
      scene_.line(role, end - kTick * across, end + kTick * across);
    Point at = 0.5 * (a + b) + shift + 10.0 * across + Point(0.0, 6.0);
    // A text that would leave a narrow inset on the right moves left, and below the other text.
    constexpr double kEdge = 6.0;
    const double width = fonts_.width(type::kName, text);
    const double most = map_.area().max.x() - kEdge - width;
    if (side > 0.0 && at.x() > most) at = Point(most, at.y() + kLine);
    at.x() = std::max(at.x(), scene_.map.area().min.x() + kEdge + (side < 0.0 ? width : 0.0));
    scene_.add(role + ".label",
               Text{at, text, type::kName, side < 0.0 ? Align::right : Align::left});
  }

 private:
  static constexpr double kTitleLeft = 10.0;
  [[nodiscard]] double header() const {
    return kHeader + kLine * std::max(static_cast<double>(title_.size()), 1.0);
  }
  static float first_float(double at) {
    auto out = static_cast<float>(at);
    return static_cast<double>(out) < at ? next(out) : out;
  }
  static float next(float value) { return std::nextafter(value, INFINITY); }

  SceneBuilder& scene_;
  const Fonts& fonts_;
  std::vector<std::string> title_;
  StageMap map_;  ///< Maps to the card below its title.
  Eigen::AlignedBox2d seen_;
};

/// X and Y from afar, and from close by where they are closest, and where a run in float finds them
/// so.
class PairPicture {
 public:
  PairPicture(SceneBuilder& scene, const Fonts& fonts, StudyStage stage)
      : scene_(scene),
        fonts_(fonts),
        stage_(stage),
        pair_(scene.effects.get<RoundedPair>(scene.frame)),
        x_(corners_of(in_plane(pair_.exact.x().world))),
        y_(corners_of(in_plane(pair_.exact.y().world))) {
    const Rect& card = scene.map.area();
    insets_top_ = card.max.y() - kMargin - kInsetHeight * card.size().y();
    from_afar_ = {{card.min.x(), card.min.y()}, {card.max.x(), insets_top_ + 14.0}};
  }

  void draw() {
    Eigen::AlignedBox2d seen;
    for (const auto* corners : {&x_, &y_}) {
      for (const Vector2d& corner : *corners) seen.extend(corner);
    }
    const StageMap map(from_afar_, camera_around(seen, from_afar_));
    shape(map, x_, "shape.x", scene_.run.lesson.x().name);
    shape(map, y_, "shape.y", scene_.run.lesson.y().name);
    const Point to_x = (map(centroid(x_)) - map(centroid(y_))).normalized();
    for (std::size_t i = 0; i < pair_.facing.size(); ++i) {
      const RoundedPair::Vertex& vertex = pair_.facing[i];
      const std::string role = vertex.of_x ? "shape.x.label" : "shape.y.label";
      const Point at = map(vertex_in_world(pair_.exact, vertex));
      const Point along =
          (at - map(vertex_in_world(pair_.exact, pair_.facing[i ^ 1]))).normalized();
      // Away from its edge, and from the other shape.
      scene_.out.fixed_labels.push_back(scene_.label("pair " + name_of(vertex), name_of(vertex),
                                                     role, type::kVertex, at, kRing,
                                                     along + (vertex.of_x ? to_x : -to_x)));
    }
    const auto& ends = pair_.ends;
    const bool is_one = ends[0].exact.vertex == ends[1].exact.vertex;
    const bool in_order = ends[0].exact.vertex.x() < ends[1].exact.vertex.x();
    const Rect& card = scene_.map.area();
    const double width = 0.5 * (card.size().x() - 3.0 * kMargin);
    for (std::size_t i = 0; i < (is_one ? 1u : 2u); ++i) {
      const bool is_left = is_one || (i == 0) == in_order;
      const double left = card.min.x() + kMargin + (is_left ? 0.0 : width + kMargin);
      const Rect box{{left, insets_top_}, {left + width, card.max.y() - kMargin}};
      const Point at = map(ends[i].exact.vertex);
      scene_.line("inset.line", at, {box.center().x(), box.min.y()});
      scene_.add("inset.line", Disk{at, kRing});
      inset(box, i, map.scale(), is_left ? -1.0 : 1.0);
    }
  }

 private:
  void shape(const StageMap& map, const std::vector<Vector2d>& corners, const std::string& role,
             const std::string& name) {
    std::vector<Point> points;
    for (const Vector2d& corner : corners) points.push_back(map(corner));
    if (points.size() > 1) scene_.area(role, points);
    for (const Point& point : points) scene_.add(role + ".vertex", Disk{point, 3.5});
    scene_.add(role + ".label",
               Text{centroid(points) + Point(0.0, 6.0), name, type::kVertex, Align::center});
  }

  [[nodiscard]] const std::string& name_of(const RoundedPair::Vertex& vertex) const {
    const Lesson& lesson = scene_.run.lesson;
    return (vertex.of_x ? lesson.x() : lesson.y()).vertex_names[vertex.index];
  }

  /// `side`: -1 for the left end, 1 for the right one.
  void inset(const Rect& box, std::size_t end, double scale, double side) {
    const RoundedPair::End& shown = pair_.ends[end];
    const bool is_distance = end == 0;
    const Vector2d center = 0.25 * (shown.exact.vertex + shown.exact.other + shown.in_float.vertex +
                                    shown.in_float.other);
    const bool rounds = stage_ == StudyStage::in_float || stage_ == StudyStage::error;
    const bool is_shown = stage_ != StudyStage::shapes;
    const std::string_view which = is_distance ? ": the closest points"
                                   : rounds    ? ": closest in float"
                                               : "";
    const std::string title =
        is_shown ? fmt::format("{} times larger{}", grouped(pair_.magnification()), which) : "";
    Inset inset(scene_, fonts_, box, center, pair_.magnification() * scale, title);
    if (!is_shown) return inset.unknown();
    inset.area("shape.x.fill", x_);
    inset.area("shape.y.fill", y_);
    if (rounds) inset.grid();
    inset.outline("shape.x", x_);
    inset.outline("shape.y", y_);
    const std::string role = shown.of.of_x ? "shape.x" : "shape.y";
    if (rounds) {
      inset.outline("rounded.x", corners_of(in_plane(pair_.in_float.x().world)));
      inset.outline("rounded.y", corners_of(in_plane(pair_.in_float.y().world)));
      inset.move(shown.exact.vertex, shown.in_float.vertex);
      inset.vertex(shown.of.of_x ? "rounded.x.vertex" : "rounded.y.vertex", shown.in_float.vertex);
    }
    inset.vertex(role + ".vertex", shown.exact.vertex);
    inset.name(role + ".label", shown.exact.vertex, name_of(shown.of), side);
    if (stage_ != StudyStage::error || is_distance)
      inset.gap("gap.exact", shown.exact, -1.0, power_text(shown.exact.length, 3));
    if (rounds && (stage_ != StudyStage::error || !is_distance)) {
      inset.gap("gap.answer", shown.in_float, 1.0,
                "float: " + power_text(shown.in_float.length, 3));
    }
    if (stage_ == StudyStage::in_double && is_distance) {
      inset.gap("gap.answer", shown.exact, 1.0,
                "double: " + power_text(pair_.in_double.trace.result.distance, 3));
    }
  }

  SceneBuilder& scene_;
  const Fonts& fonts_;
  StudyStage stage_;
  const RoundedPair::Value& pair_;
  std::vector<Vector2d> x_;
  std::vector<Vector2d> y_;
  Rect from_afar_;
  double insets_top_ = 0.0;
};

}  // namespace

void study(SceneBuilder& scene, const Fonts& fonts) {
  const StudyFrame shown = *study_frame(scene.run, scene.frame);
  if (shown.stage < StudyStage::error_axis) return PairPicture(scene, fonts, shown.stage).draw();
  add_plot(scene, study_plot(*scene.run.lesson.settings.as<LessonStudy>(), shown), fonts);
}

}  // namespace gjkscope::layers
