#pragma once
// The window's content: Dear ImGui calls from a session, and from input back to it. Knows no SDL
// and no GL; window.cpp feeds it, and so do tests.

#include <imgui.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "asking.hpp"
#include "command.hpp"
#include "dialog.hpp"
#include "drawer.hpp"
#include "export/export.hpp"
#include "icon.hpp"
#include "known_files.hpp"
#include "lesson/case.hpp"
#include "lesson/terms.hpp"
#include "memory.hpp"
#include "paint/imgui_painter.hpp"
#include "picture_view.hpp"
#include "presenter.hpp"
#include "room.hpp"
#include "session/session.hpp"
#include "settings.hpp"
#include "thumbnails.hpp"
#include "unsaved.hpp"

namespace gjkscope {

/// A lesson file of the list beside the picture.
struct ListedLesson {
  std::filesystem::path file;
  std::string id;
  std::string title;
  int chapter = 0;
  std::string problem;  ///< The first, with its place; empty for a lesson that can be opened.
};

/// Seconds; an export that ends before is no matter for a notice.
inline constexpr double kLongExport = 0.5;

/// Seconds; between two writes of an editor there may be no file.
inline constexpr double kGoneAfter = 0.5;

/// A line above the picture: a fact to know, or a question to answer, while it holds.
struct Notice {
  std::string cause;  ///< One of each at a time.
  std::string text;
  std::string details = {};  ///< For who points at it.
  bool is_error = true;
  std::vector<std::string_view> answers = {};  ///< Names of commands.
  bool can_be_closed = true;
};

/// Fonts of the panels besides their usual one, which stands for those that are null.
struct PanelFonts {
  ImFont* mono = nullptr;    ///< For numbers.
  ImFont* strong = nullptr;  ///< For headings.
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
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  // Called by the window

  /// The pixels that an atlas must hold for a window of this size, in pixels: pixels per frame
  /// pixel of the picture. `density`: how many times finer the pixels are than on an ordinary
  /// screen.
  [[nodiscard]] double layout(double width, double height, double density = 1.0);
  /// Pixels of the panels' type and spaces per pixel of theirs at scale 1.
  [[nodiscard]] double ui_scale() const { return ui_scale_; }
  /// All windows of a frame.
  void draw(const AtlasFonts& fonts, const PanelFonts& panel_fonts = {});
  /// False when no command has this key.
  bool press(const KeyPress& press);
  /// Whether keys go to the panels, and not to commands.
  [[nodiscard]] bool panels_have_keys() const;
  /// Files that were dropped on the window, or named by another program.
  void open_path(const std::filesystem::path& path);
  /// A file that is shown has changed.
  void file_changed(const std::filesystem::path& path);
  /// Time passes. Steps while playing, saves unsaved work.
  void tick(double now);
  /// Until when nothing happens by itself; nothing at all: never.
  [[nodiscard]] std::optional<double> wakes_at() const;
  /// The clipboard that pasting and copying use.
  std::function<std::string()> paste;
  std::function<void(const std::string&)> copy;

  /// Quits, unless work would be lost that nobody has agreed to lose; whoever asks again has.
  void ask_to_quit();
  [[nodiscard]] bool wants_to_quit() const { return quit_; }
  [[nodiscard]] bool wants_full_screen() const { return presenter_.is_on(); }
  /// False while a lecture has no use for it.
  [[nodiscard]] bool shows_pointer() const { return presenter_.pointer_opacity(now_) > 0.0; }
  [[nodiscard]] std::string title() const;
  /// The panels take the colours of the theme.
  void set_colors() const;
  /// Characters of names that came up: of lessons, files and vertices.
  [[nodiscard]] const std::set<char32_t>& characters() const { return characters_; }
  /// Panels will show this name.
  void will_show(std::string_view name);
  /// The file whose changes matter.
  [[nodiscard]] std::filesystem::path watched() const { return session_.file(); }

  // Knowledge that the parts of the window share

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] PictureView& picture() { return picture_; }
  [[nodiscard]] const Fonts& fonts() const { return fonts_; }
  [[nodiscard]] const Theme& theme() const { return theme_; }
  [[nodiscard]] const std::string& theme_name() const { return theme_name_; }
  [[nodiscard]] bool is_dark() const;
  [[nodiscard]] bool is_presenting() const { return presenter_.is_on(); }
  [[nodiscard]] const Presenter& presenter() const { return presenter_; }
  [[nodiscard]] Asking& asking() { return asking_; }
  [[nodiscard]] const std::filesystem::path& share() const { return paths_.share; }
  [[nodiscard]] const std::vector<Command>& commands() const { return commands_; }
  [[nodiscard]] const std::vector<ListedLesson>& lessons() const { return lessons_; }
  [[nodiscard]] const std::vector<CourseTerm>& terms() const { return terms_; }
  [[nodiscard]] const std::vector<std::string>& recent() const { return recent_; }
  /// The last message, or the error of the last action.
  [[nodiscard]] const std::string& message() const { return error_.empty() ? message_ : error_; }
  [[nodiscard]] std::vector<Notice> notices() const;
  /// The shown case's expectation, and how the run compares; empty where it expects nothing.
  [[nodiscard]] std::string compared_with_case() const;
  [[nodiscard]] const PanelFonts& panel_fonts() const { return panel_fonts_; }
  /// Whether a hand is held to round numbers: the other way round while Shift is down.
  [[nodiscard]] bool snaps() const { return snaps_ != ImGui::GetIO().KeyShift; }
  /// How drawers write numbers.
  bool hexadecimal = false;
  /// Whether lessons of the list get small pictures.
  bool has_thumbnails = true;
  /// How what is made beside the window, for a large case, is started. Tests that look at the
  /// window meanwhile defer it, and call `wait_beside`.
  std::launch beside = std::launch::async;
  void wait_beside() const;
  /// The options of the last export of frames.
  std::optional<ExportOptions> last_export;
  /// Names of values (drawers/values.hpp) that stay in sight.
  std::vector<std::string> pinned;
  /// The things that drawers point at in the frame that is being drawn.
  Subject pointed_in_panel;

  /// The one way to change a lesson; says why when it is refused.
  bool edit(const std::string& name, Lesson lesson);
  void say(std::string message, bool is_error = false);
  /// Why something was refused.
  void say(const std::vector<Problem>& problems);
  bool run_command(std::string_view name);
  void show_dialog(Dialog dialog);
  void close_dialog() { dialog_.reset(); }
  [[nodiscard]] bool has_dialog() const { return dialog_ != nullptr; }
  void show_drawer(std::string_view name, bool open = true);
  /// A click on the picture that a drawer may want.
  bool offer_click(const Subject& subject);
  /// A button that does a command, grey while that would do nothing. `width` as of Dear ImGui.
  void draw_button(std::string_view name, float width = 0.0f);
  void stop_playing() { playing_ = false; }
  /// Whether what changes from step to step moves.
  [[nodiscard]] bool moves() const { return moves_; }
  [[nodiscard]] double now() const { return now_; }
  [[nodiscard]] const Room& room() const { return room_; }

  /// The first lesson of a chapter, if there is one.
  void open_chapter(int chapter);
  /// Lessons of the list that were stepped to their end.
  struct Progress {
    int done = 0;
    int of = 0;
  };
  /// A chapter's; without one, all.
  [[nodiscard]] Progress progress(std::optional<int> chapter = std::nullopt) const;
  /// The place where practice of a chapter was left; it is kept for the next start.
  [[nodiscard]] Memory::Practised& practised(int chapter) { return memory_.practised[chapter]; }

  /// At the step that an exported file shows.
  void open_exported(const std::filesystem::path& file);
  void open_lesson(const std::filesystem::path& named);
  /// Shows a lesson; `file` is empty for what has none, `name` is for messages. False when it
  /// cannot be shown. `unsaved`: it comes from no file.
  bool show(Lesson lesson, const std::filesystem::path& file, const std::string& name,
            bool unsaved = false);
  /// Work that other windows left, the newest first.
  struct LeftWork {
    UnsavedWork::Left work;
    bool is_discarded = false;  ///< It goes when the window ends.
  };
  [[nodiscard]] std::vector<LeftWork>& left_work() { return left_; }
  /// The small picture of a lesson file, in the current window; empty until it is made.
  void draw_small_picture(const std::filesystem::path& file, const ImVec2& at, const ImVec2& size);
  /// False when it cannot be shown.
  bool open_left(std::size_t index);
  void save_as();

  /// The opening lesson with the shapes of a case, and no words; nothing when that has problems.
  [[nodiscard]] std::optional<Lesson> lesson_around(const ReadCase& read,
                                                    const std::string& name) const;
  void save_to(const std::filesystem::path& file);
  /// Writes text of the user's; says what was written, or why not.
  void write_text(const std::filesystem::path& file, const std::string& text);
  /// This frame, or all: the lesson as it is seen. `options` says where, and how they look. Goes on
  /// beside the window, which says how it ended.
  void export_frames(ExportOptions options, bool all);
  /// How many frames are exported by now, and of how many; 0 of 0 before that is known.
  [[nodiscard]] std::pair<int, int> exported() const { return {export_done_, export_count_}; }
  [[nodiscard]] bool is_opening() const { return opening_.has_value(); }
  [[nodiscard]] bool is_exporting() const { return exporting_.valid(); }
  /// Whether small pictures of lessons that are in sight are yet to come.
  [[nodiscard]] bool makes_thumbnails() const { return thumbnails_.is_making(); }

  // For scripts
  [[nodiscard]] std::string state_json();

 private:
  // Parts of the window
  void draw_top_bar();
  void draw_transport();
  void draw_steps();
  bool draw_tab(const char* name);
  void draw_menu(const char* name, const std::vector<std::string_view>& items);
  /// Words and buttons on the stage beside the picture: where to begin, and the way home.
  void draw_on_stage();
  void draw_lessons();
  void draw_drawer();
  void draw_dialog();
  void draw_notices();
  void draw_message();
  void draw_status();
  void draw_pinned(float begin);
  [[nodiscard]] std::string pinned_text();
  /// Beside the stage, or over it.
  [[nodiscard]] bool has_lessons() const;
  [[nodiscard]] double drawer_width() const;
  void drag_edge();
  /// A menu or a list is open, besides a dialog.
  [[nodiscard]] bool has_popup() const;
  /// The keyboard's frame is around what it would press in a panel.
  void show_focus(const std::string& panel);
  [[nodiscard]] const std::string& said() const;
  /// How many lines notices take.
  [[nodiscard]] std::size_t notice_count() const;
  [[nodiscard]] bool fits_status(const std::string& text) const;
  void draw_lesson(const ListedLesson& lesson, bool is_open);
  void draw_icon_button(Icon icon, std::string_view name, bool at_top = false);
  void draw_menu_item(std::string_view name);

  // Deeds
  void make_commands();
  [[nodiscard]] const Command* command(std::string_view name) const;
  /// A lesson, or the problems of its text: what a file of this name and text shows.
  struct NotedCase {
    std::vector<Eigen::Vector3d> x;
    std::vector<Eigen::Vector3d> y;
    CaseNotes notes;
  };
  struct ReadLesson {
    std::optional<Lesson> lesson;
    std::vector<Problem> problems;
    std::size_t cases = 0;  ///< How many the text holds.
    std::optional<NotedCase> noted = {};
    std::string understood = {};
  };
  /// In whatever thread.
  [[nodiscard]] ReadLesson read_lesson(std::string_view text,
                                       const std::filesystem::path& file) const;
  [[nodiscard]] ReadLesson read_case(std::string_view text, const std::string& file) const;
  void note(std::optional<NotedCase> noted);
  /// After a lesson of a file is shown.
  void opened(const std::filesystem::path& file, std::string text, ReadLesson read);
  /// Ends the opening of a lesson, or says that it failed.
  bool shown(bool is_shown, const std::string& name);
  void open_beside(const std::filesystem::path& file);
  void end_opening();
  void work_beside();
  void open_pasted(const std::string& text, const std::string& name = "pasted");
  void save_case_to(const std::filesystem::path& file);
  /// Whether this is a lesson of the course, or still the same as one.
  [[nodiscard]] bool is_of_course(const std::filesystem::path& file) const;
  /// The text that the own file of the lesson or case holds, and the last one that could be
  /// shown: what stays of it when it is saved.
  [[nodiscard]] std::vector<std::string> texts_to_keep(const std::filesystem::path& file) const;
  /// Keeps what a file holds beside it, unless this window wrote it; says where.
  std::string keep_beside(const std::filesystem::path& file);
  /// Whether the file of the lesson holds what it held when it was read or written last; where it
  /// does not, it is read, or what is open about it is asked.
  bool is_file_as_known();
  void find_missing_character();
  /// Whether the lesson's file is another one than before, or has been gone for a while.
  void watch_file();
  void take_theirs();
  void keep_mine();
  /// The notes of the case whose shapes these are; null where it has none.
  [[nodiscard]] const CaseNotes* case_notes() const;
  void close_notice(const std::string& cause);
  void forget_closed();
  /// Those that were closed, too.
  [[nodiscard]] std::vector<Notice> all_notices() const;
  [[nodiscard]] bool would_lose_work() const;
  /// One frame on, or back.
  void step(int by);
  /// The same by a clicker, with the lesson's own questions; in a lecture from lesson to lesson.
  void click_on(int by);
  [[nodiscard]] bool can_click_on(int by) const;
  /// The next lesson of the list that can be shown, or the one before; null where there is none.
  [[nodiscard]] const ListedLesson* neighbour(int by) const;
  void nudge(const Eigen::Vector2d& pixels);
  void erase_selected();
  void select_next(int by);
  void set_theme(const std::string& name);
  void focus_next_panel(int by);
  void toggle_drawer(std::size_t index);
  void keep_unsaved();
  /// The same in a thread of its own: large shapes take their time, and a drag would wait.
  void keep_unsaved_beside();
  void end_keeping();
  void offer_left_work();
  void show_left_work();
  void discard_left_work(bool is_discarded);
  void read_recent();
  void remember_recent(const std::filesystem::path& file);
  [[nodiscard]] Settings settings() const;
  void apply(const Settings& settings);
  void keep_settings();
  void write_lines(const char* name, const std::vector<std::string>& lines) const;
  void end_export();
  void note_memory();
  void keep_memory();
  [[nodiscard]] const ListedLesson* listed(const std::string& id) const;
  /// Opens the lesson where the window was left last.
  void go_on();
  void repeat_question();

  Paths paths_;
  const Fonts& fonts_;
  Session session_;
  std::string theme_name_ = "light";
  Theme theme_;
  PictureView picture_;
  Asking asking_;
  Thumbnails thumbnails_;
  std::map<int, std::string> chapters_;  ///< Their titles.
  std::vector<CourseTerm> terms_;
  std::vector<ListedLesson> lessons_;
  std::vector<Drawer> drawers_;
  std::vector<Command> commands_;
  UnsavedWork unsaved_;
  std::vector<LeftWork> left_;  ///< By windows that are gone; waits to be opened or not.
  KnownFiles files_;
  /// The content of a lesson's file now, if it differs from the shown one and waits for an answer.
  struct Outside {
    std::filesystem::path file;
    std::string text;
    std::optional<Lesson> lesson;  ///< Nothing where the text has problems.
    std::vector<Problem> problems;
  };
  std::optional<Outside> outside_;
  std::filesystem::path looked_at_;     ///< The file that was the lesson's in the last tick.
  bool is_missing_ = false;             ///< The file, at the last look.
  std::optional<double> gone_since_;    ///< When that was seen first.
  std::vector<NotedCase> noted_cases_;  ///< Those opened last.

  double panel_size_ = 1.0;  ///< As the user chose.
  double ui_scale_ = 1.0;    ///< Times the density of the screen.
  double width_ = 0.0;       ///< The window's, in pixels.
  double height_ = 0.0;
  double density_ = 1.0;
  Room room_;
  PanelFonts panel_fonts_;
  const AtlasFonts* atlas_fonts_ = nullptr;  ///< Those of the drawn frame.

  std::optional<std::size_t> drawer_;
  std::shared_ptr<Dialog> dialog_;        ///< Shared with the frame that draws it.
  std::shared_ptr<Dialog> dialog_drawn_;  ///< In the last frame.
  std::optional<std::string> focused_;    ///< The panel that keys go to.
  bool focus_moves_ = false;
  bool lessons_shown_ = true;
  bool lessons_over_ = false;  ///< Over the stage, which has no room beside it.
  std::optional<std::string> menu_open_;
  std::map<std::string, double> drawer_widths_;  ///< Those that were chosen.
  bool welcomes_ = false;                        ///< Says where to begin.
  Settings kept_settings_;                       ///< As the file has them.
  std::string listed_;  ///< The file of the lesson that was open when the list was drawn last.
  Presenter presenter_;
  bool playing_ = false;
  bool moves_ = true;
  double frames_per_second_ = 1.0;
  double now_ = 0.0;
  double next_step_ = 0.0;
  double next_save_ = 0.0;
  long kept_version_ = 0;
  bool quit_ = false;
  bool snaps_ = false;
  std::string message_;
  std::optional<double> message_ends_;  ///< Set when it is seen first.
  std::string error_;                   ///< That of the last action, until the next.
  std::string error_details_;
  std::optional<std::pair<long, int>> error_at_;  ///< Version and step when it was seen first.
  /// The first character of the lesson's words that the stage cannot draw, of this version.
  std::pair<long, std::string> missing_ = {-1, ""};
  std::set<char32_t> characters_;
  std::string not_kept_;          ///< Why unsaved work is not; empty when it is.
  std::set<std::string> closed_;  ///< Notices that were, as cause and text.
  std::size_t notice_lines_ = 0;  ///< As they were laid out last.
  bool leaves_unsaved_ = false;   ///< The lesson that another one was opened over.
  std::vector<std::string> recent_;
  Memory memory_;
  Memory kept_memory_;                           ///< As its file has it.
  std::optional<Memory::Place> stopped_before_;  ///< This start.
  std::size_t noted_answers_ = 0;
  std::pair<std::string, int> noted_at_;  ///< The lesson, and its frame.
  struct Exported {
    std::string outcome;
    bool failed = false;
  };
  std::atomic<int> export_done_ = 0;
  std::atomic<int> export_count_ = 0;
  std::stop_source stop_export_;
  std::filesystem::path export_folder_;
  double export_began_ = 0.0;
  bool gives_export_up_ = false;  ///< A second wish to quit is granted.
  std::future<Exported> exporting_;
  std::future<void> keeping_;  ///< Work that is being kept; uses `unsaved_`.
  /// Consequences of a drag of large shapes; uses `session_`.
  std::future<std::shared_ptr<Session::Made>> working_;
  /// A large file that is read, run and drawn beside the window.
  struct Opening {
    std::filesystem::path file;
    struct Result {
      std::string text;
      ReadLesson read;
      std::shared_ptr<Session::Made> made;  ///< Null where there are problems, or it was given up.
      std::string problem;
    };
    std::future<Result> result;
    std::stop_source stop;
  };
  std::optional<Opening> opening_;
  std::vector<Opening> given_up_;  ///< Those that have not ended yet.
};

}  // namespace gjkscope
