#pragma once
// Loops that people publish: the textbook's page (tests/gjk/textbook.hpp) with one line changed
// each (mistakes.cmake), and the logs of their runs.

#include <span>
#include <string_view>
#include <vector>

#include "judge/log.hpp"

namespace gjkscope {

/// Iterations after which a loop is cut off.
inline constexpr int kMostIterations = 64;

struct Mistake {
  std::string_view name;     ///< "wrong-sign"
  std::string_view meaning;  ///< A sentence.
  std::string_view line;     ///< A part of a line of the textbook's page.
  std::string_view by;       ///< It is replaced by this; empty: it is left out.
  /// The run of the loop. The shapes have vertices.
  judging::Log (*log_of)(const std::vector<Eigen::Vector2d>& x,
                         const std::vector<Eigen::Vector2d>& y) = nullptr;
};

/// All of them; the first is "none", the textbook's own loop.
[[nodiscard]] std::span<const Mistake> mistakes();
/// The one of this name, which must be there.
[[nodiscard]] const Mistake& mistake_called(std::string_view name);

}  // namespace gjkscope
