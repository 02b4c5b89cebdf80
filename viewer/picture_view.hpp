#pragma once
// The picture in the window: where it stands, what is under the pointer, and what a hand does to
// it.

#include <optional>
#include <string>

#include "paint/imgui_painter.hpp"
#include "session/edit.hpp"
#include "session/session.hpp"

namespace gjkscope {

class App;

class PictureView {
 public:
  /// Widths of a page, in frame pixels: what the words of all lessons need, and what shapes need.
  static constexpr double kNarrow = 1000.0;
  static constexpr double kNarrowest = 760.0;
  /// The least width of a page of stages and captions alone, in a window that has no room for more.
  static constexpr double kBarest = 240.0;

  explicit PictureView(App& app);

  /// Fills `area`, in pixels of the window; gives pixels per frame pixel: fewer than `density`
  /// where there is no room, but never so few that type has less than 12 pixels.
  double lay_out(const Rect& area, double density);
  [[nodiscard]] const Rect& area() const { return area_; }
  void draw(const AtlasFonts& fonts);
  /// On its way from one step to the next.
  [[nodiscard]] bool is_moving() const { return motion_.has_value(); }
  /// The pointer as Dear ImGui has it, after all panels were drawn.
  void take_pointer();
  /// The button went down for the first time, or for the second within a moment.
  void clicked(int times) { clicks_ = times; }
  /// What is held is let go.
  void release();

  [[nodiscard]] const Subject& hovered() const { return hovered_; }
  Subject selected;
  /// The place of a mark of the subject on the window; nothing when none is in sight.
  [[nodiscard]] std::optional<Point> pixel_of(const Subject& subject);
  /// A few pixels of a view along x and y, as a round number of its units.
  [[nodiscard]] Eigen::Vector2d round_step(std::size_t view) const;
  /// The step that a hand is held to; 0 where it goes anywhere.
  [[nodiscard]] Eigen::Vector2d grid(std::size_t view) const;
  /// The card of the panel, or of the last view where there is none, on the window.
  [[nodiscard]] Rect last_card();
  /// Cards of shapes that show none, on the window.
  [[nodiscard]] std::vector<Rect> empty_cards();
  /// The box on the window in which the frame lists the choices of its question; nothing without
  /// one.
  [[nodiscard]] std::optional<Rect> words_of_choices();
  /// The place of the handle that turns a shape.
  [[nodiscard]] std::optional<Point> rotation_handle_at(std::size_t body) const;

 private:
  struct Drag {
    Subject subject;
    std::size_t view = 0;
    Point last;                     ///< On the page.
    Eigen::Vector2d start_in_view;  ///< The point at which it was taken.
    bool turns = false;
    bool moved = false;
    bool was_convex = false;  ///< The shape whose vertex it is.
  };

  /// The press of a button while a question was open: an answer, unless it becomes a drag.
  struct Aim {
    Subject subject;
    std::size_t view = 0;
    Eigen::Vector2d at;
  };

  /// What was shown when a step was taken, and when that was.
  struct Motion {
    Picture from;
    double start = 0.0;
  };

  [[nodiscard]] Point to_page(const Point& pixel) const { return (pixel - area_.min) / zoom_; }
  [[nodiscard]] Point to_pixel(const Point& page) const { return area_.min + zoom_ * page; }
  [[nodiscard]] std::optional<std::size_t> view_at(const Point& page) const;
  [[nodiscard]] Eigen::Vector2d to_view(std::size_t view, const Point& page) const;
  [[nodiscard]] Rect rotation_handle(std::size_t body) const;
  /// The frame of the timeline at this height that is nearest; nothing elsewhere.
  [[nodiscard]] std::optional<int> frame_at(const Point& page);
  /// The session's picture, or what leads to it from the step that was shown before.
  [[nodiscard]] Picture picture_now();
  void draw_highlights(const Picture& picture, const AtlasFonts& fonts);
  void press(const Subject& subject, const Point& page);
  /// The button went up.
  void let_go();
  void continue_drag(const Point& page);
  void double_click(const Point& page);
  void zoom(std::size_t view, const Point& page, double factor);

  App& app_;
  Session& session_;
  Rect area_;
  double zoom_ = 1.0;
  Subject hovered_;
  std::optional<Drag> drag_;
  std::optional<Aim> aim_;
  int clicks_ = 0;
  Picture shown_;  ///< The last, of this version of the lesson and this step.
  long shown_version_ = -1;
  int shown_index_ = 0;
  std::optional<Motion> motion_;
};

}  // namespace gjkscope
