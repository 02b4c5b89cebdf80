#pragma once
// A lesson as data: what is on the stage, how GJK shall run, what to show, and what must come out.
// The file format is described in lessons/README.md.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "gjk/gjk.hpp"

namespace gjkscope {

enum class ScalarKind { half, single, double_, exact };

/// A shape with named vertices. world = rotate(rotate_degrees) * vertex + translate.
struct LessonShape {
  std::string name;                       ///< "X", "Y", "Q"
  std::vector<std::string> vertex_names;  ///< As many as vertices, unique over both shapes.
  std::vector<Eigen::Vector2d> vertices;  ///< In drawing order.
  Eigen::Vector2d translate = Eigen::Vector2d::Zero();
  double rotate_degrees = 0.0;  ///< Counter-clockwise.
};

/// Steps of a lesson: one frame for each iteration, phase or region test of the run, for each
/// position on the path, or for each pair of vertices of the Minkowski difference.
enum class Granularity { iteration, phase, test, path, pairs };

enum class ViewKind { world, difference };

/// What a view shows: the rectangle around `center` that is `height` world units high (wider or
/// narrower with the stage). Without a camera the view fits what it draws.
struct Camera {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double height = 1.0;
};

struct LessonView {
  ViewKind kind = ViewKind::world;
  std::string title;
  std::optional<Camera> camera;
  std::vector<std::string> effects;  ///< Names of registered effects (effects/registry.hpp).
};

/// Blocks of the side panel, from top to bottom.
enum class PanelBlock {
  pseudocode,
  tests,
  regions,
  weights,
  linear_system,
  simplex,
  scan,
  bounds,
  pairs,
  direction_rules
};

/// The listings that the pseudocode block can show.
enum class Listing { none, segment, triangle, gjk_point, gjk };

/// Positions of X, one run each: the corners themselves, or `frames` positions at equal steps along
/// the polyline.
struct LessonPath {
  std::vector<Eigen::Vector2d> points;
  int frames = 0;  ///< 0: the points themselves.
};

/// What the run must come to; the last run of a path. `check` and the tests compare.
struct Expectation {
  std::optional<gjk::StopReason> stop;
  std::optional<std::vector<std::string>>
      supports;  ///< One name for each support phase: "C", or "K-C" for a pair y-x.
  std::optional<double> distance;  ///< To the digits written.
};

struct Lesson {
  std::string id;    ///< File name without ending.
  std::string path;  ///< Where it was read from.
  std::string title;
  int chapter = 1;
  int order = 1;  ///< Within the chapter.
  std::string source;
  std::string prose;  ///< May hold placeholders, {distance} and so on; see lesson/prose.hpp.

  LessonShape x;
  LessonShape y;
  ScalarKind scalar = ScalarKind::double_;
  gjk::Options options;

  Granularity granularity = Granularity::phase;
  std::optional<gjk::Phase> until;  ///< Frames end with the first step of this phase.
  std::optional<LessonPath> path_of_x;

  std::vector<LessonView> views;
  std::vector<PanelBlock> panel;
  Listing listing = Listing::none;
  Expectation expect;
};

}  // namespace gjkscope
