#pragma once
// The picture in the window: where it stands, and what the pointer does there.

#include <optional>
#include <string>

#include "paint/imgui_painter.hpp"
#include "picture/term_spots.hpp"
#include "session/hand.hpp"
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
  /// Lets go of what is held.
  void release();

  [[nodiscard]] const Subject& hovered() const { return hovered_; }
  [[nodiscard]] Hand& hand() { return hand_; }
  /// The place of a mark of the subject on the window; nothing when none is in sight.
  [[nodiscard]] std::optional<Point> pixel_of(const Subject& subject);
  [[nodiscard]] Point to_pixel(const Point& page) const { return area_.min + zoom_ * page; }
  /// The step that a hand is held to; 0 where it goes anywhere.
  [[nodiscard]] Eigen::Vector2d grid(std::size_t view) const;
  /// The card of the panel, or of the last view where there is none, on the window.
  [[nodiscard]] Rect last_card();
  /// Cards of shapes that show none, on the window.
  [[nodiscard]] std::vector<Rect> empty_cards();
  /// The box on the window in which the frame lists the choices of its question; nothing without
  /// one.
  [[nodiscard]] std::optional<Rect> words_of_choices();

 private:
  /// A button that is down: it goes along the timeline, moves a view, or has the hand hold
  /// something.
  struct Press {
    Point last;  ///< On the page.
    bool on_timeline = false;
    std::optional<std::size_t> view = std::nullopt;
    bool moved = false;
    bool drags_direction = false;  ///< As an answer.
    /// A question was open: this is an answer, unless it becomes a drag.
    std::optional<Subject> aim = std::nullopt;
    /// The shape whose vertex is held, where it is convex.
    std::optional<std::size_t> convex = std::nullopt;
  };

  /// The picture when a step was taken, and the time of that.
  struct Motion {
    Picture from;
    double start = 0.0;
  };

  [[nodiscard]] Point to_page(const Point& pixel) const { return (pixel - area_.min) / zoom_; }
  /// The frame of the timeline at this height that is nearest; nothing elsewhere.
  [[nodiscard]] std::optional<int> frame_at(const Point& page);
  /// The chapter whose tile is there, where the map of the course is shown.
  [[nodiscard]] std::optional<int> chapter_at(const Point& page);
  /// The session's picture, or what leads to it from the step that was shown before.
  [[nodiscard]] Picture picture_now();
  void draw_highlights(const Picture& picture, const AtlasFonts& fonts);
  /// Terms are underlined while the pointer is beside the views, and the pointed one is explained.
  void underline_terms() const;
  void explain_term(const Point& page);
  void press(const Subject& subject, const Point& page);
  /// The button went up.
  void let_go();
  void continue_drag(const Point& page);
  void double_click(const Point& page);
  void zoom(std::size_t view, const Point& page, double factor);

  App& app_;
  Session& session_;
  Hand hand_;
  Rect area_;
  double zoom_ = 1.0;
  Subject hovered_;
  std::optional<Press> press_;
  int clicks_ = 0;
  Picture shown_;  ///< The last, of this version of the lesson and this step.
  long shown_version_ = -1;
  int shown_index_ = 0;
  std::vector<TermSpot> terms_;  ///< On the shown picture.
  bool underlines_terms_ = false;
  std::optional<Motion> motion_;
};

}  // namespace gjkscope
