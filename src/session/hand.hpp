#pragma once
// The hand on a picture: what lies under it, what it takes, and where that goes. Window and page
// tell it where their pointers are, in frame pixels of the session's page.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "session/session.hpp"

namespace gjkscope {

/// The nearest multiples of round numbers; 0 leaves a coordinate as it is.
[[nodiscard]] Eigen::Vector2d snapped(const Eigen::Vector2d& value, const Eigen::Vector2d& grid);

/// A way in the world that goes right and up on the screen.
[[nodiscard]] Eigen::Vector3d along_screen(const Camera& camera,
                                           const Eigen::Vector2d& right_and_up);

/// Sides from which space is seen: along y, along x, along z, across the frame's d, and along it.
inline constexpr std::array<std::string_view, 5> kSides = {"front", "side", "top", "across d",
                                                           "along d"};
/// The eye on one of these sides; nothing for any other name. Before the run has a d, the shortest
/// way between the shapes takes its place.
[[nodiscard]] std::optional<Eye> eye_from(std::string_view side, const LessonRun& run,
                                          const Frame& frame);

class Hand {
 public:
  static constexpr double kSlack = 7.0;  ///< Around a point or a line that still hit it.
  static constexpr double kStill = 2.0;  ///< A press that goes no farther is a click.

  /// Both must outlive the hand.
  Hand(Session& session, const Fonts& fonts) : session_(session), fonts_(fonts) {}

  // Places

  [[nodiscard]] std::optional<std::size_t> view_at(const Point& page) const;
  /// In space the place under `page` in the plane through the camera's center that faces the eye.
  [[nodiscard]] Eigen::Vector3d to_view(std::size_t view, const Point& page) const;
  [[nodiscard]] Subject subject_at(const Point& page, double slack = kSlack) const;
  /// The vertex whose name appears: what is pointed at, or else what is near.
  [[nodiscard]] Subject named_at(const Point& page, const Subject& pointed) const;
  /// A few pixels of a view along x and y, as a round number of its units.
  [[nodiscard]] Eigen::Vector2d round_step(std::size_t view) const;

  // The selected shape and the handle that turns it

  Subject selected;
  /// Beside the selected shape, in the first view of the world, where it covers no label; nothing
  /// where there is none.
  [[nodiscard]] std::optional<Point> handle() const;
  [[nodiscard]] bool is_on_handle(const Point& page, double slack = kSlack) const;
  [[nodiscard]] std::vector<Mark> handle_marks() const;

  // A new vertex

  struct WithVertex {
    Lesson lesson;
    Subject vertex;       ///< The new one.
    std::string problem;  ///< Why the lesson stays as it is; empty where it does not.
  };
  /// The lesson with the vertex that a double click adds beside an edge of X or Y in the world;
  /// nothing elsewhere.
  [[nodiscard]] std::optional<WithVertex> with_vertex(const Point& page, bool snaps) const;

  // Drags

  /// Takes the handle if it is there, else the subject, and selects that if it is a vertex or a
  /// shape; in space, else the ground, which turns the views. False where there is nothing to
  /// take.
  bool press(const Subject& subject, const Point& page, double handle_slack = kSlack);
  /// Whether something is held.
  [[nodiscard]] bool holds() const { return held_.has_value(); }
  /// Whether the ground has been dragged, which turns the views and changes nothing else.
  [[nodiscard]] bool turns_views() const { return held_ && held_->walks && held_->moved; }
  /// Moves or turns what is held; `snaps`: by round numbers, and in space along the one axis that
  /// the pointer's way follows most. False while the press is a click.
  bool move(const Point& page, bool snaps);
  /// Ends the drag. False when no run can be shown for the new place: then everything is as it was
  /// before the drag, and Session::problem says why.
  bool release();
  /// Ends a drag as if it had not been. False as for release().
  bool cancel();

 private:
  struct Held {
    Subject subject;
    std::size_t view = 0;
    Point last;
    Point pressed;
    Eigen::Vector3d start;                           ///< In the view.
    Eigen::Vector3d went = Eigen::Vector3d::Zero();  ///< In space: since then.
    long version = 0;                                ///< The lesson's, when it was taken.
    bool turns = false;
    bool walks = false;  ///< The eye, around all that is shown.
    bool moved = false;
  };

  /// Along an axis of space, so that its picture goes with the pointer, to a round coordinate.
  [[nodiscard]] Eigen::Vector3d along_axis(const Held& held, const Point& page,
                                           const Eigen::Vector3d& from) const;

  Session& session_;
  const Fonts& fonts_;
  std::optional<Held> held_;
};

}  // namespace gjkscope
