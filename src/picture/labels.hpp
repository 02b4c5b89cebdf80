#pragma once
// Placement of labels: beside what they name, off lines and disks and off each other, and in the
// place of the frame before.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "picture/obstacles.hpp"

namespace gjkscope {

/// A label beside a point.
struct LabelRequest {
  std::string id;  ///< The same thing has the same id in every frame.
  std::string text;
  std::string role;
  TextStyle style;
  Point anchor = Point::Zero();
  double gap =
      0.0;  ///< Free space around the anchor: the radius of what is drawn there, and a little.
  Point towards = Point::Zero();          ///< Preferred side; zero: any.
  bool keeps_side = false;                ///< Rather farther away than on another side.
  std::vector<Point> other_anchors = {};  ///< Beside these it may stand, too; rather the first.
  /// A fixed label may leave its place for a frame in which something else is there.
  bool steps_aside = false;
  /// A fixed label that is left out where there is no room near the anchor.
  bool needs_room = false;
  std::vector<Tone> tones = {};
};

/// A label farther than this from what it names has a line that leads there, in pixels.
inline constexpr double kLeaderFrom = 13.0;  // beyond the gap
/// The line from a far label to what it names; none where the label is near.
[[nodiscard]] std::optional<Obstacles::Segment> leader_line(const LabelRequest& request,
                                                            const Rect& label);

/// All of a box lies in a convex polygon.
[[nodiscard]] bool is_inside(std::span<const Point> polygon, const Rect& box);

/// A label somewhere inside a convex polygon.
struct AreaLabelRequest {
  std::string id;
  std::string text;
  std::string role;
  TextStyle style;
  std::vector<Point> polygon;
  std::optional<LabelRequest> otherwise;  ///< For a polygon without room; else no label.
};

class LabelPlacer {
 public:
  /// Labels stay inside `bounds`.
  LabelPlacer(const Fonts& fonts, const Rect& bounds);

  /// Starts a frame: labels of earlier frames are no obstacles any more, but are remembered.
  void begin_frame(const Obstacles& obstacles);
  /// Obstacles of another frame, which count in this one, too; lines that pass count once.
  void add(const Obstacles& obstacles);
  /// Reserves room that labels must not take.
  void reserve(const Rect& box) { taken_.push_back(box); }
  /// A line that leads to a label, which labels from here on keep off.
  void avoid(const Obstacles::Segment& leader) { leaders_.push_back(leader); }

  /// The text mark of a label. `fixed`: a place found once for the id is kept for good.
  [[nodiscard]] Mark place(const LabelRequest& request, bool fixed);
  /// Takes back the label that was placed last.
  void take_back(const std::string& id);
  /// Something is drawn where a label stands.
  [[nodiscard]] bool is_crossed(const Rect& label) const;
  /// No mark when the polygon has no room and there is no other place. `in_any_case`: rather on a
  /// mark than nowhere.
  [[nodiscard]] std::vector<Mark> place_inside(const AreaLabelRequest& request,
                                               bool in_any_case = false);

 private:
  /// A place that is kept when the text gets longer or shorter.
  struct Kept {
    Point beside = Point::Zero();  ///< The label's point nearest to the anchor, from there.
    Point face = Point::Zero();    ///< From there to the middle, in halves of the label's size.
  };

  struct Cover {
    double cost = 0.0;
    bool is_buried = false;  ///< It covers too many marks to count them all.
  };

  /// The cost of all that the box covers. Marks beyond a cost of `least` are not counted.
  [[nodiscard]] Cover cover_of(const Rect& box, double least) const;
  /// The cost when the box is nearer to another mark than to the one that it names.
  [[nodiscard]] double cost_of_neighbours(const Rect& box, const LabelRequest& request) const;
  /// The cost of a line from a far label to what it names, which would cross other labels.
  [[nodiscard]] double cost_of_leader(const Rect& box, const LabelRequest& request) const;
  [[nodiscard]] double cost_of_passing(const Rect& box, bool in_frame) const;
  [[nodiscard]] Mark mark_of(const LabelRequest& request, const Rect& box) const;
  [[nodiscard]] Mark mark_at(const Rect& box, const std::string& text, const std::string& role,
                             const TextStyle& style) const;
  [[nodiscard]] Point size_of(const std::string& text, const TextStyle& style) const;

  const Fonts& fonts_;
  Rect bounds_;
  Field<Obstacles::Segment> segments_;
  Field<Obstacles::Segment> passing_;
  Field<Obstacles::Circle> circles_;
  std::vector<Rect> grounds_;
  std::vector<Rect> taken_;
  std::vector<Obstacles::Segment> leaders_;
  std::map<std::string, Kept> places_;  ///< By label: the place in its last frame.
};

}  // namespace gjkscope
