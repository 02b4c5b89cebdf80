#pragma once
// Penetration depths of several libraries: each has its shapes and poses prepared beforehand.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "grid_pairs.hpp"

namespace bench {

/// An answer about one pair. Apart, and without an answer, nothing is to be moved.
struct Depth {
  bool overlaps = false;  ///< The library gave a depth.
  double depth = 0.0;
  Point<3> translation = Point<3>::Zero();  ///< The motion of X that parts the shapes.
};

struct DepthLibrary {
  std::string name;  ///< With its version.
  std::string how;   ///< The call that is made, and its tolerances.
  bool in_double = true;
  /// Makes what answers pair i. It borrows nothing.
  std::function<std::function<Depth(std::size_t)>(std::span<const Pair<3>>)> prepare;
};

/// In double, with proofs and without.
[[nodiscard]] std::vector<DepthLibrary> core_depths();

// Those that were found when this was built; see peers.cmake.
[[nodiscard]] std::vector<DepthLibrary> ccd_depths();
[[nodiscard]] std::vector<DepthLibrary> fcl_depths();
[[nodiscard]] std::vector<DepthLibrary> bullet_depths();

}  // namespace bench
