#pragma once
// The words and numbers that go with a frame.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/plane.hpp"
#include "picture/picture.hpp"

namespace gjkscope {

/// The vertices of a shape to choose from.
struct VertexChoice {
  std::string shape;
  std::vector<std::string> vertices;
};

/// A place to point at for a choice: a point of a view, or a segment.
struct Spot {
  Spot(ViewKind of, const Eigen::Vector3d& begin, const Eigen::Vector3d& end, double around = 0.0)
      : view(of), from(begin), to(end), reach(around) {}
  Spot(ViewKind of, const Eigen::Vector2d& begin, const Eigen::Vector2d& end, double around = 0.0)
      : view(of), from(in_space(begin)), to(in_space(end)), reach(around) {}
  ViewKind view;
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double reach = 0.0;  ///< How far around it is meant, too.
};

/// The middle of a triangle, with half of the room around it.
[[nodiscard]] Spot spot_of_triangle(ViewKind view, const std::array<Eigen::Vector3d, 3>& corners);

/// The question of a frame.
struct FrameQuestion {
  std::string ask;                   ///< "support", ...
  std::vector<std::string> choices;  ///< As the frame lists them.
  std::string answer;                ///< The next frame that asks nothing tells it.
  /// If a choice is a pair, "K−A": its two parts, each chosen by itself, in order.
  std::vector<VertexChoice> pair = {};
  std::vector<std::optional<Spot>> spots = {};  ///< For the choices, in order; or empty.
  /// The marks to point at for the choices, in order, none where there is no mark; or empty.
  std::vector<Subject> subjects = {};
  /// The place that is asked for, if it is one: an answer says how far off it is.
  std::optional<Eigen::Vector2d> place = {};
  /// If a direction is asked for: it leads from here to `place`.
  std::optional<Eigen::Vector2d> origin = {};
  std::string reason = {};   ///< The caption of the frame that tells, without the answer before it.
  std::string refuted = {};  ///< Sentences on the wrong choices, for the frame that tells.
};

/// The words and numbers of a frame: what the sidecar file, the contact sheet, the transcript and
/// the alternative text say.
struct FrameText {
  std::string caption;   ///< The event and its reason, with this step's values.
  std::string detail;    ///< The numbers behind it, and what comes next.
  std::string prose;     ///< The lesson's prose, placeholders filled in.
  std::string phase;     ///< "closest", ..., or "start"
  int iteration = 0;     ///< From 1; 0 before the first.
  std::string position;  ///< The frame's place in the lesson: "iteration 2 of 4 · support".
  std::vector<std::pair<std::string, std::string>>
      values;  ///< Name and printed value, in reading order.
  std::optional<FrameQuestion> question;
  std::optional<bool> is_right = {};  ///< Set if an answer was given, which the caption grades.
};

}  // namespace gjkscope
