#pragma once
// The state of the window: the lesson being edited with its history, the run that follows from it,
// and the place in that run. No window, no GL.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frames/frame.hpp"
#include "lesson/lesson.hpp"
#include "lesson/load.hpp"

namespace gjkscope {

/// An answer given in predict mode.
struct Answer {
  std::string lesson;
  int iteration = 0;
  std::string ask;  ///< "support", ...
  std::vector<std::string> choices;
  std::string chosen;
  std::string right;  ///< From the trace.
  /// The question, by version of the lesson, run and step.
  long version = 0;
  int run = 0;
  int step = 0;
  /// The place that was pointed at, and the one that was asked for; if there is one.
  std::optional<Eigen::Vector2d> pointed = {};
  std::optional<Eigen::Vector2d> place = {};
  /// If a direction was asked for: it leads from here to each of both.
  std::optional<Eigen::Vector2d> origin = {};
  /// Degrees between both directions.
  [[nodiscard]] double turned() const;
  [[nodiscard]] bool is_right() const { return chosen == right; }
};

/// Why no lesson file could say this, as the loader says it of the file that would be saved; empty
/// when one could. `read` gives the files that it names.
[[nodiscard]] std::vector<Problem> why_not_said(const Lesson& lesson,
                                                const FileReader& read = read_file);

class Session {
 public:
  /// `fonts` must outlive the session. `read` gives files that lessons name.
  explicit Session(const Fonts& fonts, FileReader read = read_file);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // The lesson

  /// A lesson with its run and its pictures, before it is shown.
  struct Made;
  /// Makes one, in whatever thread: `lesson` and all that this session had when it was asked go
  /// into the work; the session may change, but must not end, until it is done.
  [[nodiscard]] std::function<std::shared_ptr<Made>()> maker(Lesson lesson) const;
  /// Shows what was made, as open() shows a lesson.
  bool open(const std::shared_ptr<Made>& made, std::filesystem::path file, bool unsaved = false);

  /// Shows another lesson, from its start: an entry of the history, so that undo goes back to the
  /// one before, whatever was done to it. `file` is where it is saved, empty for what has no file
  /// yet. `unsaved`: it differs from its file. False, and all stays as it was, when its run cannot
  /// be shown.
  bool open(Lesson lesson, std::filesystem::path file, bool unsaved = false);
  /// The file changed: the same place of the new lesson; an entry of the history.
  bool reload(Lesson lesson);
  [[nodiscard]] const Lesson& lesson() const { return lesson_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Whether the lesson differs from what its file holds.
  [[nodiscard]] bool is_unsaved() const { return unsaved_; }
  /// The content of its file; null when there is none.
  [[nodiscard]] const Lesson* saved() const { return saved_.get(); }
  /// The file holds this now; nothing: it is gone.
  void set_saved(std::optional<Lesson> lesson);
  struct Unsaved {
    const Lesson& lesson;
    const std::filesystem::path& file;
  };
  /// Lessons that differ from their files: those that undo and redo lead to, and this one, the
  /// last.
  [[nodiscard]] std::vector<Unsaved> all_unsaved() const;
  /// `file` holds `lesson` now: this one, as a file says it.
  void mark_saved(std::filesystem::path file, Lesson lesson);
  /// Grows with every change.
  [[nodiscard]] long version() const { return version_; }
  /// Why a change was refused, or the run that follows from the lesson is not shown (the last one
  /// that could be is); empty when all is well.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// The same, with places where it has some.
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

  // Changes. `name` is what undo calls it.

  /// The lesson becomes `lesson`: one entry of the history. False, and all stays as it was, when a
  /// lesson file could not say it, or its run cannot be shown.
  bool edit(const std::string& name, Lesson lesson);
  /// Back to what its file holds. False when there is no file.
  bool revert();
  /// Many changes of shapes, one entry: a drag. Cameras stay, but for that of a difference that was
  /// wholly in sight and would leave it. `held`: the view in which the hand is; it stays, too,
  /// until the drag ends.
  void begin_drag(const std::string& name, std::optional<std::size_t> held = std::nullopt);
  void drag(const std::function<void(Lesson&)>& edit);
  void end_drag();
  [[nodiscard]] bool is_dragging() const { return dragging_; }

  // Drags of shapes larger than those of lesson files, beside whoever drives the session

  /// From here on moves of such shapes, and the ends of their drags, change the lesson alone; run
  /// and pictures stay until `take_work` gets what `work` has made.
  void work_beside() { beside_ = true; }
  /// Makes what follows from the lesson, in whatever thread; the session must not end before it is
  /// done. Null where nothing is to be made, or the last work was not taken yet.
  [[nodiscard]] std::function<std::shared_ptr<Made>()> work();
  /// Shows what work() has made, if it is still asked for; null: it has failed.
  void take_work(const std::shared_ptr<Made>& made);
  /// A drag has ended, and what follows from it is not shown yet.
  [[nodiscard]] bool is_settling() const { return !dragging_ && before_drag_.has_value(); }
  /// The lesson, and what is shown, as before a drag that goes on, or has not settled.
  void cancel_drag();

  /// Whether undo and redo leave cameras as they are, or bring back those of then.
  enum class Cameras { stay, as_then };
  bool undo(Cameras cameras = Cameras::stay);
  bool redo(Cameras cameras = Cameras::stay);
  /// The name of what undo, or redo, would take back; empty when there is nothing.
  [[nodiscard]] std::string undo_name() const;
  [[nodiscard]] std::string redo_name() const;

  // The history from outside: it outlives the session where one keeps the lessons.

  /// A lesson of the history, distinguished from all others by a number, and the change that
  /// separates it from the one that is shown, or from its neighbour on that side.
  struct Kept {
    long id = 0;
    std::string change;
  };
  [[nodiscard]] std::vector<Kept> past() const { return kept(past_); }      ///< The oldest first.
  [[nodiscard]] std::vector<Kept> future() const { return kept(future_); }  ///< The next one last.
  [[nodiscard]] long lesson_id() const { return id_; }
  struct KeptLesson {
    Kept kept;
    Lesson lesson;
  };
  /// The history becomes this one, and what is shown `now`. False, and all stays as it was, when
  /// that cannot be shown.
  bool restore(std::vector<KeptLesson> past, KeptLesson now, std::vector<KeptLesson> future);

  // The place in the run

  [[nodiscard]] const LessonRun& run() const;
  [[nodiscard]] int frame_count() const;
  [[nodiscard]] int index() const { return index_; }
  [[nodiscard]] const Frame& frame() const;
  void go_to(int index);
  /// By frames; clamped to the ends. False when there was nowhere to go.
  bool step(int by);
  /// To the first frame of the next iteration, or of this one, or of the one before.
  bool step_iteration(int by);
  /// To the next frame of the phase, from the start again after the last, or to an open question
  /// on the way there. False when there is none.
  bool go_to_next(std::string_view phase);
  /// Events to run to. The first two are GJK's.
  enum class Event { simplex_changes, vertex_dropped, run_ends };
  /// The first frame after this one that shows it; nothing when none does.
  [[nodiscard]] std::optional<int> next(Event event) const;
  /// To that frame. False when there is none.
  bool run_until(Event event);

  // Predict mode: frames ask before they tell

  /// A question is put before each frame that would tell its answer at once.
  void set_predicting(bool on);
  [[nodiscard]] bool is_predicting() const { return predicting_; }
  /// The lesson's own questions, in the frames that its export has. Predict mode asks all there
  /// are.
  void set_asking(bool on);
  [[nodiscard]] bool is_asking() const { return asking_; }
  /// The question of the frame, while it is open.
  [[nodiscard]] const FrameQuestion* question() const;
  /// Takes the choice, and goes on to the next frame. `pointed`: the place in the world that was
  /// pointed at.
  void answer(const std::string& choice, const std::optional<Eigen::Vector2d>& pointed = {});
  /// Takes the choice. Goes on where the next frame tells; where it asks something else, the
  /// verdict comes first.
  void grade(const std::string& choice, const std::optional<Eigen::Vector2d>& pointed = {});
  /// The answer that was given to the question of a frame; null where none was, or none was asked.
  [[nodiscard]] const Answer* given(int index) const;
  /// The words of this frame, with the verdict on answers to its question, or to those that it
  /// tells.
  [[nodiscard]] FrameText shown_text() const;
  /// The last frame that may be shown: what comes after an open question would answer it.
  [[nodiscard]] int last_open() const;
  [[nodiscard]] const std::vector<Answer>& answers() const { return answers_; }
  [[nodiscard]] int right_answers() const;
  /// Right ones, and all, of the lesson that is open.
  [[nodiscard]] std::pair<int, int> score() const;
  void forget_answers();
  [[nodiscard]] std::string answers_json() const;

  // Pictures

  void set_page(const Page& page);
  [[nodiscard]] const Page& page() const { return page_; }
  /// The picture of the frame, at the page's size.
  [[nodiscard]] const Picture& picture();
  /// Vertices that have names in the picture, whatever else has: what is pointed at or dragged. Of
  /// a difference its two vertices have names in the world.
  void point_at(const std::vector<Subject>& vertices);
  /// The vertex, of a shape or of the difference, that is nearest to a place on the page, if it is
  /// within `reach` (frame pixels) and in the same view; kind none where there is none. However
  /// dense the vertices are, and whether they have disks or not.
  [[nodiscard]] Subject vertex_near(const Point& page, double reach);
  [[nodiscard]] const FrameText& text() const;
  /// The texts of all frames.
  [[nodiscard]] const std::vector<FrameText>& texts() const;
  [[nodiscard]] std::vector<LessonPictures::ShownView> views() const;
  /// Sets the camera of a view, for this window: it is not part of the lesson and its history.
  void set_camera(std::size_t view, const Camera& camera);
  /// Sees all views of space from another side; nothing of the plane changes. Elevations beyond
  /// ±90 degrees end there.
  void set_eye(const Eye& eye);
  /// The eye of the first view of space; none in the plane.
  [[nodiscard]] std::optional<Eye> eye() const;
  /// All views fit what they show again.
  void fit();
  [[nodiscard]] EffectGraph& effects();

  /// The lesson as the window shows it: cameras where they stand.
  [[nodiscard]] Lesson lesson_as_seen() const;

 private:
  /// The file of a lesson, and the step that it was left at.
  struct Whereabouts {
    std::filesystem::path file;
    std::shared_ptr<const Lesson> saved;
    int index = 0;
  };
  struct Entry {
    std::string name;
    Lesson lesson;
    std::optional<Whereabouts> of_other = std::nullopt;  ///< When another lesson was opened.
    long id = 0;
    CameraOverrides cameras = {};
  };
  struct Shown;
  /// A place in the run, to find it again in another.
  struct Moment {
    int run = 0;
    int iteration = 0;
    int phase = -1;
    int part = -1;
  };

  /// The first of the frames whose questions this one answers; without one, this frame.
  [[nodiscard]] int first_shown() const;
  /// False when no question is open.
  bool take(const std::string& choice, const std::optional<Eigen::Vector2d>& pointed = {});
  /// The lesson that was there; nothing, and all stays as it was, when this one cannot be shown.
  std::optional<Lesson> replace(Lesson lesson, CameraOverrides cameras);
  /// With the cameras that `lesson` was seen with.
  void remember(Entry entry, CameraOverrides cameras);
  [[nodiscard]] static std::vector<Kept> kept(const std::vector<Entry>& entries);
  /// Undo and redo: the lesson changes places with the last entry of `from`, which goes to `to`.
  bool swap_with_last(std::vector<Entry>& from, std::vector<Entry>& to, Cameras cameras);
  /// Why the run cannot be shown; empty when it can.
  [[nodiscard]] static std::string why_not_shown(const LessonRun& run);
  /// Runs the lesson; false, and the last run stays, when it cannot be shown.
  bool show(LabelScope scope);
  /// In place of what is shown, at the same place of the run.
  void put(std::shared_ptr<Shown> shown);
  /// Makes pictures of the lesson, and that of a frame, seen by these cameras.
  [[nodiscard]] std::function<std::shared_ptr<Made>()> maker(Lesson lesson, CameraOverrides cameras,
                                                             std::optional<bool> stacked,
                                                             LabelScope scope, int index) const;
  /// The lesson as before the drag that is the last entry of the history, and no longer is.
  void take_back_drag();
  /// The lesson is another one than before.
  void changed();
  void lay_out(LabelScope scope);
  /// One for each frame.
  [[nodiscard]] std::vector<Moment> moments() const;
  [[nodiscard]] int find(const Moment& wanted) const;
  void hold_cameras();
  void fit(std::size_t view, const Rect& card);
  /// Whether all of Z is in sight in a view of the difference.
  [[nodiscard]] bool is_difference_in_sight(const LessonPictures::ShownView& view) const;
  /// Z goes where X and Y are dragged: a view that follows, and that it would leave, fits it again.
  void keep_difference_in_sight();
  [[nodiscard]] Lesson lesson_to_run() const { return to_run(lesson_); }
  [[nodiscard]] Lesson to_run(Lesson lesson) const;

  const Fonts& fonts_;
  FileReader read_;
  Page page_;
  Lesson lesson_;
  std::filesystem::path file_;
  long version_ = 0;
  long id_ = 0;       ///< The lesson's, in the history;
  long last_id_ = 0;  ///< the newest one's.
  std::shared_ptr<const Lesson> saved_;
  bool unsaved_ = false;
  std::string problem_;
  std::vector<Problem> problems_;
  std::vector<Entry> past_;
  std::vector<Entry> future_;
  bool dragging_ = false;
  bool beside_ = false;
  long drags_ = 0;                    ///< Drags until now.
  std::optional<LabelScope> wanted_;  ///< The scope of pictures that are to be made beside.
  bool making_ = false;
  /// The picture that was shown before.
  struct BeforeDrag {
    std::shared_ptr<Shown> shown;
    int index = 0;
    long layout = 0;
  };
  std::optional<BeforeDrag> before_drag_;  ///< Kept for a drag beside, until it has settled.
  std::vector<std::size_t> follows_;  ///< Views that a difference may not leave, during a drag.
  std::optional<std::size_t> held_;
  bool predicting_ = false;
  bool asking_ = false;
  std::vector<Answer> answers_;
  CameraOverrides cameras_;
  std::optional<bool> stacked_;  ///< Cards keep their place on this page, until all is fitted.
  std::shared_ptr<Shown> shown_;
  long layout_ = 0;  ///< Grows with each.
  int index_ = 0;
  std::vector<Subject> pointed_;
  std::optional<Picture> picture_;
};

}  // namespace gjkscope
