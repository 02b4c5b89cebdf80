#pragma once
// A stage: one view of a lesson (the world, or the Minkowski difference) drawn into a rectangle of
// the frame.

#include "effects/graph.hpp"
#include "picture/labels.hpp"

namespace gjkscope {

/// From the coordinates of a view to the frame: uniform scale, y up becomes y down.
class StageMap {
 public:
  /// Pixels from the stage's middle beyond which a point is moved in: a painter computes in single
  /// precision, and what is out there is seen only as a line's direction.
  static constexpr double kFarthest = 1e7;

  /// Shows `camera.height` units over the height of `area`, centred.
  StageMap(const Rect& area, const Camera& camera) : area_(area), camera_(camera) {}
  [[nodiscard]] double scale() const { return area_.size().y() / camera_.height; }
  [[nodiscard]] Point operator()(const Eigen::Vector2d& v) const {
    const Eigen::Vector2d d =
        (scale() * (v - camera_.center)).cwiseMax(-kFarthest).cwiseMin(kFarthest);
    return area_.center() + Point(d.x(), -d.y());
  }
  [[nodiscard]] const Rect& area() const { return area_; }
  /// Corners of what `area` shows, counter-clockwise, in view coordinates.
  [[nodiscard]] std::vector<Eigen::Vector2d> visible() const;

 private:
  Rect area_;
  Camera camera_;
};

/// What is drawn on a stage at one frame, labels not yet placed.
struct Scene {
  std::vector<Mark> marks;
  std::vector<LabelRequest>
      fixed_labels;  ///< Of things that stay where they are: one place for the whole lesson.
  std::vector<LabelRequest> moving_labels;
  std::vector<AreaLabelRequest> area_labels;
  Obstacles obstacles;
};

/// The camera of a view: the lesson's, or one that fits everything the view will show over all
/// frames.
[[nodiscard]] Camera camera_of(const LessonRun& run, const LessonView& view, const Rect& area);

[[nodiscard]] Scene stage_scene(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                                const LessonView& view, const StageMap& map);

}  // namespace gjkscope
