#pragma once
// What one frame of a lesson shows: a run, a step of it, and, where frames take a step apart, which
// part of it.

#include <any>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace gjkscope {

/// Where in its algorithm a step is.
struct StepInfo {
  int iteration = 0;       ///< From 1; 0 before the first.
  std::string_view phase;  ///< "support"; "start" before the first.
  bool is_event = false;   ///< A vertex dropped, containment, the end.
};

/// Which part of a step a frame shows, where an act takes steps apart: a value of a type that the
/// act names.
class FramePart {
 public:
  FramePart() = default;  ///< The whole step.
  /// `index`: from 0, of the frames of the step in their order.
  template <class T>
  FramePart(T value, int index) : value_(std::move(value)), index_(index) {}
  /// One of the stages that the act goes through.
  template <class Stage>
  requires std::is_enum_v<Stage>
  explicit FramePart(Stage stage) : FramePart(stage, static_cast<int>(stage)) {}

  /// nullptr where the part is of another type.
  template <class T>
  [[nodiscard]] const T* as() const {
    return std::any_cast<T>(&value_);
  }
  template <class T>
  [[nodiscard]] T value_or(T otherwise) const {
    return as<T>() != nullptr ? *as<T>() : otherwise;
  }
  /// -1 of a whole step. Effects, sessions and searches tell frames of a step apart by it.
  [[nodiscard]] int index() const { return index_; }

 private:
  std::any value_;
  int index_ = -1;
};

struct Frame {
  int run = 0;    ///< Index into LessonRun::runs.
  int step = -1;  ///< Index into the trace's steps; -1: the start, before the first phase.

  FramePart part = {};
  std::optional<int> steps_over = {};  ///< Of an algorithm that is not GJK; one more than there
                                       ///< are: the answer.

  int question = -1;        ///< Index into Lesson::questions: this frame asks it, over what the
                            ///< frame before it shows; the next frame that asks nothing answers.
  int answering_step = -1;  ///< Of a frame that asks: index of the step that answers, among those
                            ///< of the algorithm that the act shows.
};

}  // namespace gjkscope
