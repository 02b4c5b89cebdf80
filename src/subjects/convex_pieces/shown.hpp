#pragma once
// Convex pieces in pictures: what a frame shows of them, and what its tour draws and says.

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "run/algorithm_facts.hpp"
#include "subjects/convex_pieces/lesson_trace.hpp"

namespace gjkscope::parts {

inline constexpr AskInfo kAskDiagonal{"diagonal", "whether a diagonal can be taken away", "of"};
inline constexpr AskInfo kAskEar{"ear", "which corner can be cut off as an ear", "of"};
inline constexpr AskInfo kAskFewest{"fewest-pieces",
                                    "into how few convex pieces a shape can be cut", "of"};
inline constexpr AskInfo kAskPair{"piece-pair", "whether a pair of pieces is run or skipped", "of"};

/// The part of the work that a frame shows.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : lesson(run.lesson),
        trace(pieces_trace(run.algorithm_trace(frame))),
        step(last_step_over(trace.all, frame)),
        is_answer(frame.step >= trace.steps()) {}

  const Lesson& lesson;
  const PiecesTrace& trace;
  const PiecesStep* step = nullptr;  ///< The last that is over; none at the start.
  bool is_answer = false;            ///< The frame after the last step.

  [[nodiscard]] bool is(PiecesPhase phase) const {
    return step != nullptr && !is_answer && step->phase == phase;
  }
  /// How many steps of a phase are over, of X and Y together.
  [[nodiscard]] int over(PiecesPhase phase) const { return over(phase, true) + over(phase, false); }
  [[nodiscard]] int over(PiecesPhase phase, bool of_x) const;
  /// The pair of a frame that shows one.
  [[nodiscard]] const models::PieceRun& run() const { return trace.result.runs[step->index]; }
  /// The run with the least distance by now; none before the first.
  [[nodiscard]] const models::PieceRun* least() const { return least(over(PiecesPhase::pair)); }
  /// The same of the first `pairs`.
  [[nodiscard]] const models::PieceRun* least(int pairs) const;
  [[nodiscard]] const LessonShape& shape(bool of_x) const { return of_x ? lesson.x() : lesson.y(); }
  /// Corners of a shape that are left at a step that cuts off a triangle: its tip, and those at
  /// which no ear is, in the order of the outline.
  [[nodiscard]] std::vector<int> tip_and_no_ears(const PiecesStep& at) const;
  /// "piece ABCD of X", or the shape itself where it is one piece.
  [[nodiscard]] std::string piece(bool of_x, int index) const;
};

// blocks.cpp
extern const Block kPieces;
extern const Listing kListing;

// layers.cpp
void stage(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::parts
