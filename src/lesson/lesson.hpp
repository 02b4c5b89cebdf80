#pragma once
// A lesson as data: what is on the stage, how GJK shall run, what to show, and what must come out.
// The file format is described in lessons/README.md.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gjk/state.hpp"
#include "lesson/eye.hpp"
#include "lesson/tour_settings.hpp"

namespace gjkscope {

enum class ScalarKind { half, single, double_, exact };

/// Compares `start` by the pairs that count.
[[nodiscard]] inline bool operator==(const gjk::Options& a, const gjk::Options& b) {
  return a.direction_rule == b.direction_rule && a.region_order == b.region_order &&
         a.stop_on_repeated_support == b.stop_on_repeated_support &&
         a.stop_on_no_progress == b.stop_on_no_progress && a.tolerance == b.tolerance &&
         a.iteration_cap == b.iteration_cap && a.proof == b.proof && a.start == b.start;
}

/// Vertices of a shape that make an outline: `count` of them from `first` on.
struct VertexRange {
  int first = 0;
  int count = 0;
};

/// A shape with named vertices. world = rotate(axis, rotate_degrees) * vertex + translate. In the
/// plane z = 0.
struct LessonShape {
  std::string name;                       ///< "X", "Y", "Q"
  std::vector<std::string> vertex_names;  ///< As many as vertices, unique over both shapes.
  std::vector<Eigen::Vector3d> vertices;  ///< In the plane in drawing order.
  Eigen::Vector3d translate = Eigen::Vector3d::Zero();
  double rotate_degrees = 0.0;                      ///< Counter-clockwise, seen against the axis.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Not 0; in the plane z.
  /// The shape is all points within it of the vertices' hull, about which GJK is asked
  /// (subjects/round_shapes).
  double radius = 0.0;
  /// How many of the vertices belong to each of its outlines, one after the other; empty: all of
  /// them are one outline. To GJK the shape is the hull of its vertices.
  std::vector<int> outlines = {};
  [[nodiscard]] std::vector<VertexRange> ranges() const {
    if (outlines.empty()) return {{0, static_cast<int>(vertices.size())}};
    std::vector<VertexRange> out;
    for (const int count : outlines)
      out.push_back({out.empty() ? 0 : out.back().first + out.back().count, count});
    return out;
  }
  friend bool operator==(const LessonShape&, const LessonShape&) = default;
};

/// The names of the bodies in files: tables [shapes.X] and [shapes.Y].
inline constexpr std::array<std::string_view, 2> kBodyKeys = {"X", "Y"};

enum class ViewKind { world, difference, plot };

/// These views have a camera, and take effects; plots have neither.
[[nodiscard]] constexpr bool shows_shapes(ViewKind kind) { return kind != ViewKind::plot; }

/// The part of the world that a view shows: the rectangle around `center` that is `height` world
/// units high (wider or narrower with the stage). Without a camera the view fits what it draws.
struct Camera {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double height = 1.0;
  double stretch = 1.0;  ///< y is drawn so many times larger than x; angles are true with 1 alone.
  std::optional<Eye> eye = {};  ///< Without one the view is of the plane.
  /// World units to the right and up, in a view that is `pixels` high.
  [[nodiscard]] Eigen::Vector2d units_per_pixel(double pixels) const {
    return height / pixels * Eigen::Vector2d(stretch, 1.0);
  }
  friend bool operator==(const Camera&, const Camera&) = default;
};

enum class CardCorner { top_left, top_right, bottom_left, bottom_right };

/// A part of a view, enlarged, in one of the view's corners.
struct CloseUp {
  Camera camera;
  CardCorner corner = CardCorner::bottom_right;
  friend bool operator==(const CloseUp&, const CloseUp&) = default;
};

struct LessonView {
  ViewKind kind = ViewKind::world;
  std::string title;
  std::optional<Camera> camera;
  std::vector<std::string> effects = {};  ///< Names of registered effects (subjects/subjects.hpp).
  std::optional<CloseUp> close_up = {};
  std::optional<Eye> eye = {};  ///< In space; without one the view looks across d.
  [[nodiscard]] bool calls_for(std::string_view effect) const {
    return std::find(effects.begin(), effects.end(), effect) != effects.end();
  }
  friend bool operator==(const LessonView&, const LessonView&) = default;
};

/// How one shape moves. Without points it stays where it stands, without turns as it is turned.
struct LessonMotion {
  std::vector<Eigen::Vector3d> points;  ///< Translations at the corners of its way.
  std::vector<double> turns;            ///< Degrees counter-clockwise, one for each corner.
  friend bool operator==(const LessonMotion&, const LessonMotion&) = default;
};

/// Positions of the shapes, one run each: the corners of X's way, or `frames` positions at equal
/// steps along it. With a clock each shape passes its corners at equal times, and `frames` moments
/// at equal steps of time are taken.
struct LessonPath {
  std::vector<LessonMotion> motions{2};  ///< One for each body.
  int frames = 0;                        ///< 0: the corners themselves.
  std::optional<double> seconds;         ///< The clock: how long all of it takes.
  [[nodiscard]] std::size_t positions() const {
    return frames > 0 ? static_cast<std::size_t>(frames) : x().points.size();
  }
  [[nodiscard]] LessonMotion& x() { return motions[0]; }
  [[nodiscard]] LessonMotion& y() { return motions[1]; }
  [[nodiscard]] const LessonMotion& x() const { return motions[0]; }
  [[nodiscard]] const LessonMotion& y() const { return motions[1]; }
  friend bool operator==(const LessonPath&, const LessonPath&) = default;
};

/// A question that a frame asks before a step answers it. The answer comes from the step of the
/// run, so questions can be asked about any shapes.
struct LessonQuestion {
  std::string ask;        ///< One that the tour can ask (Tour::asks): "support".
  std::optional<int> at;  ///< The iteration that answers, or the part asked about, from 1; without
                          ///< it each that can.
  friend bool operator==(const LessonQuestion&, const LessonQuestion&) = default;
};

/// The expected outcome of the run; on a path, of its last run. `check` and the tests compare.
struct Expectation {
  std::optional<std::string> stop;  ///< GJK's; when it is not run, that of the tour's algorithm.
  std::optional<std::vector<std::string>>
      supports;  ///< One name for each support phase: "C", or "K-C" for a pair y-x.
  std::optional<double> distance;  ///< To the digits written.
  /// The same, of what the tour's algorithm comes to (Algorithm::answers): ("depth", 0.75).
  std::vector<std::pair<std::string, double>> answers;
  friend bool operator==(const Expectation&, const Expectation&) = default;
};

struct Lesson {
  std::string id;    ///< File name without ending.
  std::string path;  ///< The file that it was read from.
  std::string title;
  int chapter = 1;
  int order = 1;  ///< Within the chapter.
  std::string source;
  std::string prose;     ///< May hold placeholders, {distance} and so on; see lesson/prose.hpp.
  std::string opening;   ///< Why the lesson is there: heads the words of the first frame.
  std::string next;      ///< A question for the next lesson; ends the last frame.
  std::string in_space;  ///< The `id` of the lesson that shows the same in space, if there is one.

  int dimension = 2;                   ///< 2 or 3.
  std::vector<LessonShape> bodies{2};  ///< GJK asks about the first two: X and Y.
  ScalarKind scalar = ScalarKind::double_;
  /// Start at the first vertices, unless something else is asked for.
  gjk::Options options = {.start = {.count = 1}};
  bool warm_start = false;  ///< Along a path, each run starts from the last one's final simplex.

  std::string tour = "phase";       ///< How runs become frames (subjects/subjects.hpp).
  std::optional<gjk::Phase> until;  ///< Frames end with the first step of this phase.
  std::vector<gjk::Phase> phases;   ///< Those that get a frame, in any order; empty: all.
  std::optional<LessonPath> path_of_shapes;
  TourSettings settings;  ///< Those that the tour takes (TourNeeds::settings); empty: none.

  std::vector<LessonView> views;
  std::vector<std::string> panel;  ///< Names of registered blocks, from top to bottom.
  std::string listing;             ///< The content of the pseudocode block; empty: nothing.
  std::vector<LessonQuestion> questions;
  Expectation expect;

  [[nodiscard]] LessonShape& x() { return bodies[0]; }
  [[nodiscard]] LessonShape& y() { return bodies[1]; }
  [[nodiscard]] const LessonShape& x() const { return bodies[0]; }
  [[nodiscard]] const LessonShape& y() const { return bodies[1]; }
  /// True when one of the views does.
  [[nodiscard]] bool calls_for(std::string_view effect) const {
    return std::any_of(views.begin(), views.end(),
                       [&](const LessonView& view) { return view.calls_for(effect); });
  }
  /// One of the questions is of this name and, where `at` is given, about that place.
  [[nodiscard]] bool asks(std::string_view ask, std::optional<long> at = {}) const {
    return std::any_of(questions.begin(), questions.end(), [&](const LessonQuestion& question) {
      return question.ask == ask && (!at || !question.at || *question.at == *at);
    });
  }
  [[nodiscard]] bool has_block(std::string_view block) const {
    return std::find(panel.begin(), panel.end(), block) != panel.end();
  }
  friend bool operator==(const Lesson&, const Lesson&) = default;
};

}  // namespace gjkscope
