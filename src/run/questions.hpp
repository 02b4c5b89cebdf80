#pragma once
// Questions of a lesson: which steps of a run answer them, and the frames that ask.

#include <array>
#include <string_view>

#include "lesson/vocabulary.hpp"
#include "run/run.hpp"

namespace gjkscope {

/// Questions for frames that go through GJK's steps.
namespace asks {
inline constexpr AskInfo kRegion{"region", "the region that holds the query point"};
inline constexpr AskInfo kDropped{"dropped", "the vertices that are dropped"};
inline constexpr AskInfo kSupport{"support", "the next support point"};
inline constexpr AskInfo kStop{"stop", "whether the run stops, and why"};
inline constexpr AskInfo kWhy{"why", "why the run ends: one true reason, two that the run refutes"};
inline constexpr AskInfo kClosest{"closest", "the closest point: where it is", "at position"};
inline constexpr AskInfo kClosestX{"closest-x", "the closest point of X: where it is",
                                   "at position"};
inline constexpr AskInfo kClosestY{"closest-y", "the closest point of Y: where it is",
                                   "at position"};
inline constexpr AskInfo kClosestZ{"closest-z", "the point of Z closest to O: where it is",
                                   "at position"};
inline constexpr AskInfo kOriginIn{"origin-in", "whether O lies in Z, so that the shapes overlap",
                                   "at position"};
inline constexpr AskInfo kSign{"sign", "which barycentric coordinate is negative", "at position"};
inline constexpr AskInfo kFoot{"foot", "the foot of the perpendicular: where it is", "at position"};
inline constexpr AskInfo kWhatIf{
    "what-if", "the place that the query point would have to move to for a weight to become 0",
    "at position"};
inline constexpr AskInfo kReach{"reach", "how far the arrow from Q to a vertex reaches along n",
                                "at position"};
inline constexpr AskInfo kTurn{"turn", "which way Q and an edge turn, and so the sign of an area",
                               "at position"};
inline constexpr AskInfo kSolution{"solution", "the weights that solve the linear system",
                                   "at position"};
inline constexpr AskInfo kSlide{"slide", "which way Z slides when shapes move, dragged",
                                "at position"};
inline constexpr AskInfo kHolds{"holds", "whether Z holds s - t, so that moved shapes meet",
                                "at position"};
inline constexpr AskInfo kMeets{"meets", "the nearest place of p at which X touches Y",
                                "at position"};
inline constexpr AskInfo kDirection{"direction", "the search direction, dragged from P"};
inline constexpr AskInfo kRightAngle{"right-angle",
                                     "which way to compute d makes a right angle exactly"};
inline constexpr AskInfo kNormals{"normals", "where either normal of a segment that holds Q leads"};
inline constexpr AskInfo kMayBe{"may-be", "which points may be the simplex"};
inline constexpr AskInfo kIndex{"index", "the index of the vertex that joins"};
inline constexpr AskInfo kStart{"start", "where runs from other vertices end"};
inline constexpr std::array kOfAnswers = {kClosestX, kClosestY};
inline constexpr std::array kOfSteps = {kRegion,     kDropped, kSupport, kStop,  kWhy,  kDirection,
                                        kRightAngle, kNormals, kMayBe,   kIndex, kStart};
}  // namespace asks

/// True for a step that tells what is asked for. P tells which vertices will be dropped, and what
/// leads to the stop tests whether they will hold: a question asked later would hold its answer.
[[nodiscard]] bool tells(const WideTrace& trace, int step, std::string_view ask);

/// The state before a step.
[[nodiscard]] const WideState& state_before(const WideTrace& trace, int step);

/// More than one answer could be given to somebody who sees only what came before `step`.
[[nodiscard]] bool is_open(const LessonRun& run, const WideTrace& trace, std::string_view ask,
                           int step);

/// The closest point of X (or Y) is a single one, and there are others to choose from.
[[nodiscard]] bool has_closest(const LessonRun& run, const Frame& frame, std::string_view ask);
/// A question that counts positions means that of `frame`.
[[nodiscard]] bool is_at(const Frame& frame, const LessonQuestion& question);

/// Puts before each frame that answers a question of the lesson the frame that asks it. What has
/// only one answer is not asked: of what region of a single vertex, say, Q lies in. Nor is what has
/// several right ones: which of two vertices equally far along d is the support point.
void add_question_frames(LessonRun& run);

/// Questions that no frame asks; places are those in the lesson's file.
[[nodiscard]] std::vector<Problem> unasked_questions(const LessonRun& run);

}  // namespace gjkscope
