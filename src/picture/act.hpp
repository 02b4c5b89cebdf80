#pragma once
// An act as pictures know it: how its frames are placed in the lesson, told and drawn. Each is a
// value in a file of acts/, listed in acts/list.def.

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include "lesson/vocabulary.hpp"
#include "picture/captions/story.hpp"
#include "picture/scene.hpp"

namespace gjkscope {

/// A frame on the timeline.
struct Tick {
  std::string group;  ///< Ticks in a row with the same group share its label.
  std::string label = {};
  std::string short_label = {};  ///< Where the label is wider than the tick.
  bool event = false;            ///< A vertex dropped, containment, the end.
  bool question = false;
};

struct StagedAct {
  Act act;
  /// Where in the lesson a frame that asks nothing is: "iteration 2 of 4 · support".
  std::string (*position)(const LessonRun& run, int index) = nullptr;
  Tick (*tick)(const LessonRun& run, const Frame& frame) = nullptr;
  /// The words of a frame that shows the start of a run of GJK.
  void (*start)(const Story& story, FrameText& text) = captions::start;
  /// The words of a frame that shows a step.
  void (*words)(const Story& story, FrameText& text) = nullptr;
  /// Draws what the step adds to a view; layers below and above it do the rest (layers/).
  void (*stage)(SceneBuilder& scene) = nullptr;
  /// Extends `seen` by what a view of run `index` shows beyond the shapes; a view without a camera
  /// fits that, too.
  void (*reach)(const LessonRun& run, int index, ViewKind view,
                Eigen::AlignedBox2d& seen) = nullptr;
  /// The question of a frame that asks one.
  void (*question)(const Story& story, FrameText& text) = captions::question;
  /// The values that prose can name and the sidecar file lists.
  void (*values)(const Story& story, FrameText& text) = captions::run_values;
  /// Draws a view all by itself; false where layers do. Only of an act with a plot.
  bool (*fill)(SceneBuilder& scene, const Fonts& fonts) = nullptr;
  /// What a plot is called where the lesson does not say.
  std::string (*plot_title)(const LessonRun& run) = nullptr;
};

// What several acts are made of.

/// True when a frame from `index` on asks a question: how many steps there are would answer it.
[[nodiscard]] bool asks_later(const LessonRun& run, int index);
/// "iteration 2 of 4 · support"
[[nodiscard]] std::string position_in_run(const LessonRun& run, int index);
/// "position 2 of 9", with the time where there is a clock.
[[nodiscard]] std::string position_on_path(const LessonRun& run, int index);
/// "3 of 8"; where there is a clock, the position on the path.
[[nodiscard]] std::string position_in_lesson(const LessonRun& run, int index);

[[nodiscard]] Tick tick_of_step(const LessonRun& run, const Frame& frame);
/// "position 2", or `otherwise` where there is but one.
[[nodiscard]] std::string group_of_position(const LessonRun& run, const Frame& frame,
                                            const std::string& otherwise);

/// A frame for the start and each step that `shows` holds for.
void add_step_frames(LessonRun& run, int index,
                     bool (*shows)(const LessonRun&, int index, int step));
/// Of an act that shows an algorithm: a frame for the start, one for each of its steps, and one for
/// the answer; where it has no steps a single one, which says why. GJK, where it was asked, has
/// ended.
void add_algorithm_frames(LessonRun& run, int index);
/// "iteration 2 of 4 · swap", "start", "answer · 9 of 9"; along a path the position before it.
[[nodiscard]] std::string position_in_algorithm(const LessonRun& run, int index);
/// Of the start, a step or the answer.
[[nodiscard]] Tick tick_of_algorithm(const LessonRun& run, const Frame& frame);
/// The last step of an algorithm that is over when a frame ends; none at the start.
template <class Step>
[[nodiscard]] const Step* last_step_over(const std::vector<Step>& steps, const Frame& frame) {
  const std::size_t over = std::min(static_cast<std::size_t>(*frame.steps_over), steps.size());
  return over == 0 ? nullptr : &steps[over - 1];
}
/// The first step up to that of `frame` that tells what is asked for.
[[nodiscard]] int answering_step_of_run(const LessonRun& run, const Frame& before,
                                        const Frame& frame, const LessonQuestion& question);

/// Simplex, closest point, search direction and support point of a step.
void stage_step(SceneBuilder& scene);

}  // namespace gjkscope
