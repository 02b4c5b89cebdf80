#pragma once
// Checks a run of any GJK, step by step, in exact arithmetic, and finds the first step that is
// wrong.
//
// A step is held to what the log says of the steps before it, not to what an exact run would have
// done: P to the simplex of its iteration, d to the vertices that were kept, the support point to
// d. So one mistake is blamed once. What the log leaves out is not checked.
//
// Rounding is what the log's scalar explains: an error of at most `kUnits` units u L, where u is
// the scalar's unit roundoff and L the largest length that the step computes with, times what the
// step amplifies such an error by. docs/log-format.md says it for each step. Waste is what costs
// time and leaves the answer alone.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/log.hpp"
#include "lesson/names.hpp"

namespace gjkscope::judging {

/// How many units u L rounding may explain. The textbook's loop and the core stay below
/// a quarter of it on all families of pairs: tests/judge/judge_test.cpp.
inline constexpr double kUnits = 16;

/// The part of a step that a finding is about.
enum class Part : std::uint8_t {
  vertex,     ///< Each vertex of the simplex is a difference y - x, and was in S or was added.
  drop,       ///< The kept vertices are those that P needs.
  weights,    ///< The barycentric coordinates of P.
  closest,    ///< P is the point of the simplex closest to O.
  direction,  ///< d leads from P to O.
  support,    ///< No point of Z lies farther along d.
  stop,       ///< The run ends when it is done, and not before.
  answer,     ///< The distance, the overlap, the closest points, the depth and the translation.
};

/// An iteration, with what follows from the lines around it.
struct Step {
  std::vector<gjk::VertexPair> simplex;  ///< Empty where it is not known.
  std::vector<gjk::VertexPair> kept;
  std::optional<gjk::VertexPair> support;
};

struct Finding {
  Part part = Part::vertex;
  int iteration = 0;  ///< From 1; 0 for the answer.
  int line = 0;
  std::string what;
};

struct Judgement {
  int iterations = 0;
  double distance = 0;             ///< The exact one, rounded.
  bool overlap = false;            ///< The shapes meet, exactly.
  std::optional<double> depth;     ///< The true depth, if the answer has one.
  std::optional<Finding> wrong;    ///< The first step that is wrong.
  std::optional<Finding> answer;   ///< The fault of the answer.
  std::optional<Finding> waste;    ///< The first.
  double rounding = 0;             ///< The largest error that is explained, in units u L.
  std::optional<Finding> rounded;  ///< The step that has it.
  bool cut_off = false;            ///< The log's last line does not end.
  std::vector<Step> steps;         ///< Up to the first that does not fit.
  [[nodiscard]] bool right() const { return !wrong && !answer; }
};

[[nodiscard]] Judgement judge(const Log& log);

}  // namespace gjkscope::judging

template <>
struct gjkscope::Named<gjkscope::judging::Part> {
  using Part = gjkscope::judging::Part;
  static constexpr std::array<std::pair<std::string_view, Part>, 8> kTable = {
      {{"vertex", Part::vertex},
       {"drop", Part::drop},
       {"weights", Part::weights},
       {"closest", Part::closest},
       {"direction", Part::direction},
       {"support", Part::support},
       {"stop", Part::stop},
       {"answer", Part::answer}}};
};
