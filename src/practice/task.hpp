#pragma once
// Tasks: a lesson about shapes of a wanted kind, made from a seed, that asks for one decision or
// for those of a whole run. The core answers it.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "practice/shapes.hpp"
#include "run/run.hpp"

namespace gjkscope::practice {

/// The answer that paper asks for.
enum class OnPaper : std::uint8_t {
  choice,   ///< One of the choices of the frame that asks.
  weights,  ///< The weights of P, as fractions.
  run,      ///< All support points of the run, and why it ends.
};

/// A kind of tasks.
struct Kind {
  int chapter = 1;
  std::string_view name;                                 ///< "region of an edge"
  void (*draw)(Draws& draws, Lesson& lesson) = nullptr;  ///< Shapes, of this kind or not.
  int start = 1;                                         ///< Vertices of the first simplex.
  std::string_view ask;                                  ///< A question of the tour.
  bool (*wanted)(const LessonRun& run, const std::string& answer) = nullptr;
  OnPaper on_paper = OnPaper::choice;
  bool is_tie = false;  ///< The decision is a tie, exactly. In all other kinds it is not near one.
  std::string_view tour = "phase";
  ViewKind view = ViewKind::world;
  int at = 1;  ///< As LessonQuestion::at. Of a whole run each iteration is asked about.
};

/// Those of a chapter; none where it has no practice.
[[nodiscard]] std::span<const Kind> kinds_of(int chapter);
/// The chapters that have practice, in ascending order.
[[nodiscard]] const std::vector<int>& chapters_with_practice();

/// How far the decisions of a kind that is no tie are from one: they stay the same wherever within
/// this distance any one point is moved to, in parts of the longest distance between two vertices
/// of a shape.
[[nodiscard]] double margin_of(const Kind& kind, int dimension);

struct Task {
  const Kind* kind = nullptr;
  Lesson lesson;
  int asking = 0;                  ///< The frame that asks.
  int telling = 0;                 ///< The frame that tells.
  std::vector<std::string> given;  ///< "A (−3, 2)" for each point, then S and d where they count.
  std::string question;
  std::vector<std::string> choices;  ///< None where the answer is written down.
  std::string answer;
  std::string reason;
};

/// The same kind and seed give the same task on every machine. Throws std::runtime_error where no
/// shapes of the kind are found.
[[nodiscard]] Task make_task(const Kind& kind, std::uint64_t seed);

/// Tasks of a chapter that has practice: every kind once, in an order of the seed, then every kind
/// again.
[[nodiscard]] std::vector<Task> make_tasks(int chapter, int count, std::uint64_t seed);

}  // namespace gjkscope::practice
