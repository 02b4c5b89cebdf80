#pragma once
// Names that a lesson file can use though they are defined above this folder: tours and their
// tables, panel blocks, listings and effects. The loader is handed all of them, and looks up names
// and needs; lesson/ names none.

#include <Eigen/Geometry>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/algorithm.hpp"
#include "lesson/frame.hpp"
#include "lesson/lesson.hpp"
#include "lesson/schema.hpp"
#include "lesson/shown_of.hpp"

namespace gjkscope {

struct LessonRun;
struct KnownFacts;
struct Tick;
struct Story;
struct FrameText;
struct SceneBuilder;
class Fonts;
class EffectGraph;

/// Whether a table [path] goes with a tour.
enum class PathUse { refused, possible, needed };

/// Requirements of a tour on a lesson.
struct TourNeeds {
  /// The settings that the tour takes, a table of the file; nullptr: none. A lesson has no other
  /// tour's.
  const SettingsKind* settings = nullptr;
  bool settings_are_optional =
      false;  ///< A file may leave them out; then Lesson::settings is empty.
  PathUse path = PathUse::possible;
  int start = 0;              ///< Vertices of a point query's first simplex; 0: any query will do.
  int most_vertices = 0;      ///< In each shape; 0: as many as a lesson may have.
  bool takes_phases = false;  ///< `steps.phases` may choose among its frames.
  bool takes_radius = false;  ///< Shapes may have a radius: its frames tell how the run ends.
  ShownOf shown_of = ShownOf::plane;
  std::string_view why_no_until = {};  ///< Why `steps.until` may not end them; empty: it may.

  /// The tables that must be there, "path" among them.
  [[nodiscard]] std::vector<std::string_view> required_tables() const;
};

/// A frame of another run, which a view shows in place of the lesson's.
struct FrameInView {
  const LessonRun* run = nullptr;
  EffectGraph* effects = nullptr;
  Frame frame;
  void (*adds)(SceneBuilder& scene) = nullptr;  ///< Draws over it what the lesson's frame adds.
};

/// A question that frames of a tour can ask.
struct AskInfo {
  std::string_view name;                      ///< "support"
  std::string_view meaning;                   ///< The thing asked for.
  std::string_view counted = "in iteration";  ///< How LessonQuestion::at counts.
};

/// How runs become frames, which place, words and marks they have. A file names it in `steps.tour`.
struct Tour {
  std::string_view name;     ///< "phase"
  std::string_view meaning;  ///< The purpose of one frame, after "one frame for each".
  TourNeeds needs = {};
  /// Appends the frames of run `index`.
  void (*add_frames)(LessonRun& run, int index) = nullptr;
  /// Frames go through the steps of a run: questions belong to its iterations.
  bool follows_run = false;
  /// Each frame is another position of the path.
  bool sweeps = false;
  std::span<const AskInfo> asks = {};  ///< The questions that its frames can ask.
  /// Index of the step that `frame` shows and the frame before it did not, and that answers; -1
  /// where there is none. Only with `asks`.
  int (*answering_step)(const LessonRun& run, const Frame& before, const Frame& frame,
                        const LessonQuestion& question) = nullptr;
  /// The frame that asks what `frame` answers, less its question; nullptr: the one before it.
  Frame (*asking)(const LessonRun& run, const Frame& frame) = nullptr;
  /// The algorithm that the frames show.
  const Algorithm* algorithm = nullptr;

  /// Corrects what is known where a frame shows a part of its step; only of tours that take steps
  /// apart.
  void (*knows)(const Frame& frame, KnownFacts& facts) = nullptr;
  /// The place in the lesson of a frame that asks nothing: "iteration 2 of 4 · support".
  std::string (*position)(const LessonRun& run, int index) = nullptr;
  Tick (*tick)(const LessonRun& run, const Frame& frame) = nullptr;
  /// The words of a frame that shows the start of a run of GJK; nullptr: as all say them.
  void (*start)(const Story& story, FrameText& text) = nullptr;
  /// The words of a frame that shows a step.
  void (*words)(const Story& story, FrameText& text) = nullptr;
  /// Draws what the step adds to a view; layers below and above it do the rest.
  void (*stage)(SceneBuilder& scene) = nullptr;
  /// Extends `seen` by everything that a view of run `index` shows beyond the shapes, so that a
  /// view without a camera has room for it.
  void (*reach)(const LessonRun& run, int index, ViewKind view,
                Eigen::AlignedBox2d& seen) = nullptr;
  /// The question of a frame that asks one; nullptr: one about a run of GJK.
  void (*question)(const Story& story, FrameText& text) = nullptr;
  /// The values that prose can name and the sidecar file lists; nullptr: those of a run of GJK.
  void (*values)(const Story& story, FrameText& text) = nullptr;
  /// Only of a tour whose views show runs of their own. `view` counts the lesson's views.
  FrameInView (*in_view)(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                         std::size_t view) = nullptr;
  /// Draws a view all by itself; false where layers do. Only of a tour with a plot.
  bool (*fill)(SceneBuilder& scene, const Fonts& fonts) = nullptr;
  /// The title of a plot that the lesson does not name.
  std::string (*plot_title)(const LessonRun& run) = nullptr;

  /// nullptr when its frames cannot ask it.
  [[nodiscard]] const AskInfo* ask(std::string_view asked) const;
};

/// A panel block, a listing or an effect.
struct Term {
  std::string_view name;
  std::string_view tour = {};   ///< The tour that it goes with; empty: any.
  std::string_view table = {};  ///< The table that it shows; empty: none.
  bool takes_listing = false;   ///< A block that shows `panel.listing`.
  /// It needs every pair of a vertex of X and one of Y: more than limits::kDifferences are refused.
  bool pairs_vertices = false;
  ShownOf shown_of = ShownOf::plane;
};

struct Vocabulary {
  std::vector<const Tour*> tours;
  std::vector<const Tour*> plots;  ///< Those that fill a view with a plot, called like the tour.
  std::vector<Term> blocks;
  std::vector<Term> listings;
  std::vector<Term> effects;    ///< Those that views can call for.
  std::vector<LessonKey> keys;  ///< All that a file may have: lesson_keys(tours).

  /// nullptr when there is none of this name.
  [[nodiscard]] const Tour* tour(std::string_view name) const;
};

/// Whether the lesson has the table of this name, or the name is empty.
[[nodiscard]] bool has_settings(const Lesson& lesson, std::string_view name);

/// nullptr when there is none of this name.
[[nodiscard]] const Term* find_term(const std::vector<Term>& terms, std::string_view name);
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Term>& terms);
[[nodiscard]] std::vector<std::string> names_of(const std::vector<const Tour*>& tours);

/// The kinds of settings that tours take, each once.
[[nodiscard]] std::vector<const SettingsKind*> settings_of(const std::vector<const Tour*>& tours);
/// The tours that take settings of this kind.
[[nodiscard]] std::vector<const Tour*> tours_with(const std::vector<const Tour*>& tours,
                                                  const SettingsKind& kind);

}  // namespace gjkscope
