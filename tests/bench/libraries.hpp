#pragma once
// Distance queries of several libraries as contestants: each has its shapes prepared beforehand and
// is given the poses query by query. Answers are distances, 0 where the library says overlap.

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "grid_pairs.hpp"
#include "study/interleave.hpp"

namespace bench {

using namespace gjkscope::study;

/// The answer of a library that says that it has none.
inline constexpr double kGaveUp = -1.0;

struct Library {
  std::string name;        ///< With its version.
  std::string how;         ///< How it is asked, and its tolerances by design.
  bool in_double = false;  ///< Else in float.
  bool measures = true;    ///< Else it only tells overlap: any positive answer means none.
  std::size_t max_vertices = std::numeric_limits<std::size_t>::max();
  Contestant (*prepare)(std::span<const Pair> pairs) = nullptr;
};

[[nodiscard]] Library core_double();
[[nodiscard]] Library core_float_in_double();
[[nodiscard]] Library core_float();
[[nodiscard]] Library core_bounds();
[[nodiscard]] Library core_no_proof();
[[nodiscard]] Library core_stepping();

// Those that were found when this was built; see peers.cmake.
[[nodiscard]] Library box2d_2();
[[nodiscard]] Library box2d_3();
[[nodiscard]] Library libccd();
[[nodiscard]] Library fcl_own();
[[nodiscard]] Library fcl_libccd();
[[nodiscard]] Library bullet();

/// The core in double and in float, and the peers that were found.
[[nodiscard]] std::vector<Library> libraries();

}  // namespace bench
