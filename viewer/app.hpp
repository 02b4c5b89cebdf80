#pragma once
// The window's content: Dear ImGui calls from a session, and from input back to it. Knows no SDL
// and no GL; window.cpp feeds it, and so do tests.

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/case.hpp"
#include "paint/imgui_painter.hpp"
#include "session/edit.hpp"
#include "session/session.hpp"

namespace gjkscope {

/// A key as it was pressed: "Right", "PageUp", "Space", "F5", "A", "/" and so on.
struct KeyPress {
  std::string key;
  bool ctrl = false;
  bool shift = false;
};

/// A lesson file of the list beside the picture.
struct ListedLesson {
  std::filesystem::path file;
  std::string id;
  std::string title;
  int chapter = 0;
  std::string problem;  ///< The first, with its place; empty for a lesson that can be opened.
};

class App {
 public:
  struct Paths {
    std::filesystem::path share;  ///< Holds lessons/ and assets/.
    std::filesystem::path state;  ///< For unsaved work and recent files; empty: nothing is kept.
  };

  /// Opens `name`: a lesson by id or path, a case, a folder; empty: what the window opens on.
  /// Throws std::runtime_error with the problems of a file that cannot be shown.
  App(Paths paths, const Fonts& fonts, const std::string& name);
  ~App();

  // Called by the window

  /// What the atlas must hold for a window of this size, in pixels: pixels per frame pixel of the
  /// picture. `density`: how many times finer the pixels are than on an ordinary screen.
  [[nodiscard]] double layout(double width, double height, double density = 1.0);
  /// Pixels of the panels' type and spaces per pixel of theirs at scale 1.
  [[nodiscard]] double ui_scale() const { return ui_scale_; }
  /// All windows of a frame.
  void draw(const AtlasFonts& fonts);
  /// False when no command has this key.
  bool press(const KeyPress& press);
  /// The button went down for the first time, or for the second within a moment.
  void clicked(int times) { clicks_ = times; }
  /// Files that were dropped on the window, or named by another program.
  void open_path(const std::filesystem::path& path);
  /// A file that is shown has changed.
  void file_changed(const std::filesystem::path& path);
  /// Time passes. Steps while playing, saves unsaved work.
  void tick(double now);
  /// Until when nothing happens by itself; nothing at all: never.
  [[nodiscard]] std::optional<double> wakes_at() const;
  /// What pasting and copying use.
  std::function<std::string()> paste;
  std::function<void(const std::string&)> copy;

  [[nodiscard]] bool wants_to_quit() const { return quit_; }
  [[nodiscard]] bool wants_full_screen() const { return presenting_; }
  [[nodiscard]] std::string title() const;
  [[nodiscard]] Color background() const { return theme_.background(); }
  /// The panels take the colours of the theme.
  void set_colors() const;
  /// The files whose changes matter.
  [[nodiscard]] std::filesystem::path watched() const { return session_.file(); }

  // Asked by tests and scripts

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] std::string state_json();
  /// Where on the window a mark of the subject is; nothing when none is to be seen.
  [[nodiscard]] std::optional<Point> place_of(const Subject& subject);
  /// Where the handle is that turns a shape.
  [[nodiscard]] std::optional<Point> rotation_handle_at(edit::Which which) const;
  [[nodiscard]] const Subject& hovered() const { return hovered_; }
  [[nodiscard]] const std::string& message() const { return message_; }
  void save_to(const std::filesystem::path& file);
  bool run_command(std::string_view name);

 private:
  struct Command {
    std::string name;   ///< "Next phase"
    std::string group;  ///< "Step"
    std::vector<std::string> keys;
    std::function<void()> run;
  };
  enum class Drawer { none, shapes, values, numerics, effects, predict, study };
  enum class Dialog { none, open, save, export_frames, help, palette, save_answers };

  [[nodiscard]] bool is_dark() const;

  // Where things are
  [[nodiscard]] Point to_page(const Point& pixel) const;
  [[nodiscard]] Point to_pixel(const Point& on_page) const;
  [[nodiscard]] std::optional<std::size_t> stage_at(const Point& on_page) const;
  [[nodiscard]] Eigen::Vector2d to_view(std::size_t stage, const Point& on_page) const;
  [[nodiscard]] Rect rotation_handle(edit::Which which) const;

  // Parts of the window
  void draw_picture(const AtlasFonts& fonts);
  void draw_highlights();
  void draw_toolbar();
  void draw_lessons();
  void draw_drawer();
  void draw_shapes();
  void draw_values();
  void draw_numerics();
  /// Rows that choose how a run computes; true when one was changed.
  static bool choose_options(ScalarKind& scalar, gjk::Options& options);
  [[nodiscard]] gjk::Options options_beside() const;
  /// The second run, computed when something that it depends on has changed.
  const PositionedRun& run_beside();
  void draw_effects();
  void draw_predict();
  void draw_study();
  /// What a dot of the study's plot says, beside the pointer.
  void draw_dot_tooltip() const;
  void draw_dialogs();
  void draw_open_dialog(bool entered);
  void draw_palette(bool entered);
  void draw_message();

  // Input on the picture
  void point_at_picture();
  void press_on(const Subject& subject, const Point& on_page);
  void continue_drag(const Point& on_page);
  void release();
  void double_click(const Point& on_page);
  void zoom(std::size_t stage, const Point& on_page, double factor);

  // Deeds
  void make_commands();
  void say(std::string message, bool is_error = false);
  void open_lesson(const std::filesystem::path& file);
  /// `unsaved`: it comes from no file.
  void open_case_text(std::string_view text, const std::string& name, bool unsaved = false);
  /// The opening lesson with the shapes of a case, and no words; nothing when that has problems.
  [[nodiscard]] std::optional<Lesson> lesson_around(const Case& shapes, const std::string& name);
  /// Shows a lesson; `file` is empty for what has none, `name` is for messages. False when it
  /// cannot be shown.
  bool show(Lesson lesson, const std::filesystem::path& file, const std::string& name,
            bool unsaved = false);
  /// Results of a study, in the lesson that shows them.
  void open_results(std::string_view json, const std::filesystem::path& file);
  /// The pair that a configuration answers worst, stepped as it computes.
  void open_worst_run(const StudyDot& dot);
  /// From a worst run back to the study.
  void go_back();
  /// The dots that the lesson's plot shows, by their index; empty without a study.
  [[nodiscard]] std::vector<StudyDot> dots() const;
  void save_answers_to(const std::filesystem::path& file);
  void export_to(const std::filesystem::path& folder, bool all);
  void step(int by);
  void choose(int number);
  void answer(const std::string& choice);
  void nudge(const Eigen::Vector2d& pixels);
  void erase_selected();
  /// Whether a lesson file could say this; says why not.
  [[nodiscard]] bool is_sound(const Lesson& lesson);
  void select_next(int by);
  void set_theme(const std::string& name);
  /// Where something has changed since.
  void autosave();
  /// Each lesson in a file of its own, for a window that starts after this one was killed.
  void keep_unsaved();
  /// Removes the files after the first so many.
  void keep_only(int count) const;
  void restore();
  void remember_recent(const std::filesystem::path& file);
  /// The name by which a question's choices call a subject; empty when they do not.
  [[nodiscard]] std::string name_of_subject(const Subject& subject) const;

  Paths paths_;
  const Fonts& fonts_;
  Session session_;
  std::string theme_name_ = "light";
  Theme theme_;
  std::vector<ListedLesson> lessons_;
  std::vector<Command> commands_;

  Rect area_;  ///< Of the picture, in pixels of the window.
  double zoom_ = 1.0;
  Point toolbar_end_ = Point::Zero();  ///< What is free of its last row begins here.
  double toolbar_height_ =
      0.0;                   ///< As it was drawn last, in pixels; one row at least is kept for it.
  double panel_size_ = 1.0;  ///< As the user chose.
  double ui_scale_ = 1.0;    ///< Times the density of the screen.
  double window_width_ = 0.0;
  double window_height_ = 0.0;

  Subject hovered_;
  Subject pointed_in_panel_;  ///< By the pointer on a line of a drawer.
  Subject selected_;
  struct Drag {
    Subject subject;
    std::size_t stage = 0;
    Point last;                     ///< On the page.
    Eigen::Vector2d start_in_view;  ///< Where it was taken.
    bool turns = false;
    bool moved = false;
  };
  std::optional<Drag> drag_;
  int clicks_ = 0;

  Drawer drawer_ = Drawer::none;
  Dialog dialog_ = Dialog::none;
  Dialog dialog_shown_ = Dialog::none;  ///< In the last frame.
  bool lessons_shown_ = true;
  bool presenting_ = false;
  bool playing_ = false;
  double frames_per_second_ = 1.0;
  double now_ = 0.0;
  double next_step_ = 0.0;
  double next_save_ = 0.0;
  long kept_version_ = 0;
  bool quit_ = false;
  double snap_ = 0.0;  ///< Grid to snap to; 0: none.
  bool hex_ = false;
  std::string message_;
  bool message_is_error_ = false;
  std::optional<bool> last_answer_;
  std::string field_;  ///< What is being typed in a dialog.
  std::string filter_;
  /// The numerics drawer's second run: the lesson's options where it has none of its own.
  ScalarKind beside_scalar_ = ScalarKind::exact;
  std::optional<gjk::Options> beside_options_;
  /// What `beside_run_` was computed from.
  struct Beside {
    long version = 0;
    int run = 0;
    ScalarKind scalar = ScalarKind::exact;
    gjk::Options options;
    friend bool operator==(const Beside&, const Beside&) = default;
  };
  Beside beside_;
  std::optional<PositionedRun> beside_run_;
  std::vector<std::string> recent_;
  /// Where a worst run was opened from.
  struct Visit {
    Lesson lesson;
    std::filesystem::path file;
    bool unsaved = false;
    int index = 0;
  };
  std::optional<Visit> back_;
};

}  // namespace gjkscope
