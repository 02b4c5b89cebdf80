#pragma once
// Distance queries of several libraries as contestants: each has its shapes prepared beforehand and
// is given the poses query by query. Answers are distances, 0 where the library says overlap.

#include <cstddef>
#include <cstdint>
#include <functional>
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

template <int D>
struct Library {
  std::string name;        ///< With its version.
  std::string how;         ///< How it is asked, and its tolerances by design.
  bool in_double = false;  ///< Else in float.
  bool measures = true;    ///< Else it only tells overlap: any positive answer means none.
  std::size_t max_vertices = std::numeric_limits<std::size_t>::max();
  std::function<Contestant(std::span<const Pair<D>>)> prepare;
};

template <int D>
[[nodiscard]] Library<D> core_double();
template <int D>
[[nodiscard]] Library<D> core_float_in_double();
template <int D>
[[nodiscard]] Library<D> core_float();
template <int D>
[[nodiscard]] Library<D> core_bounds();
template <int D>
[[nodiscard]] Library<D> core_no_proof();
template <int D>
[[nodiscard]] Library<D> core_stepping();
template <int D>
[[nodiscard]] Library<D> core_plain();

// Those that were found when this was built; see peers.cmake.
[[nodiscard]] Library<2> box2d_2();
[[nodiscard]] Library<2> box2d_3();
template <int D>
[[nodiscard]] Library<D> libccd();
[[nodiscard]] Library<3> fcl_own();
[[nodiscard]] Library<3> fcl_libccd();
[[nodiscard]] Library<3> bullet();
[[nodiscard]] Library<3> opengjk();

/// The peers that were found: those that are made for dimension D, or all that can be asked.
enum class Peers : std::uint8_t { native, all };
template <int D>
[[nodiscard]] std::vector<Library<D>> peers(Peers which);

}  // namespace bench
