#pragma once
// Functions that several tours (lesson/vocabulary.hpp) use: for frames, their place in a lesson,
// their ticks on the timeline.

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "lesson/vocabulary.hpp"
#include "picture/scene.hpp"
#include "picture/story.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// A frame on the timeline.
struct Tick {
  std::string group;  ///< Ticks in a row with the same group share its label.
  std::string label = {};
  std::string short_label = {};  ///< Used when the label is wider than the tick.
  bool event = false;  ///< True when a vertex is dropped, O is contained, or the run ends.
  bool question = false;
};

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

/// The part of its step that a frame of `tour` shows; none where it shows all of it, or is a frame
/// of another tour.
template <class Part>
[[nodiscard]] std::optional<Part> part_of(const Tour& tour, const LessonRun& run,
                                          const Frame& frame) {
  if (run.tour != &tour || frame.part < 0) return std::nullopt;
  return static_cast<Part>(frame.part);
}

/// A frame for the start and each step that `shows` holds for.
void add_step_frames(LessonRun& run, int index,
                     bool (*shows)(const LessonRun&, int index, int step));
/// For a tour that shows an algorithm: a frame for the start, one for each of its steps, and one
/// for the answer; without steps a single frame, which says why there are none.
void add_algorithm_frames(LessonRun& run, int index);
/// "iteration 2 of 4 · swap", "start", "answer · 9 of 9"; along a path the position before it.
[[nodiscard]] std::string position_in_algorithm(const LessonRun& run, int index);
/// The tick of the start, a step or the answer.
[[nodiscard]] Tick tick_of_algorithm(const LessonRun& run, const Frame& frame);
/// The last step of an algorithm that is over when a frame ends; none at the start.
template <class Step>
[[nodiscard]] const Step* last_step_over(const std::vector<Step>& steps, const Frame& frame) {
  const int last = std::min(frame.step, static_cast<int>(steps.size()) - 1);
  return last < 0 ? nullptr : &steps[last];
}
/// The first step up to that of `frame` that tells what is asked for.
[[nodiscard]] int answering_step_of_run(const LessonRun& run, const Frame& before,
                                        const Frame& frame, const LessonQuestion& question);

}  // namespace gjkscope
