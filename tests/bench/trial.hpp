#pragma once
// Libraries on trial: what each answers to pairs of a family, held against the exact truth.

#include <cstdint>
#include <vector>

#include "libraries.hpp"
#include "study/truth.hpp"

namespace bench {

template <int D>
struct Case {
  Pair<D> pair;
  Truth<D> truth;
};

template <int D>
[[nodiscard]] std::vector<Case<D>> cases_of(families::Family family,
                                            families::Representation representation,
                                            std::size_t count, std::uint64_t seed);

/// Relative errors beyond these count as failures.
inline constexpr double kFloatLimit = 1e-3;
inline constexpr double kDoubleLimit = 1e-9;

inline constexpr int kSecondsPerQuery = 2;  ///< Processor time; then a library is stopped.

struct Tally {
  int asked = 0;
  int missed = 0;      ///< Overlaps called separated: more than 4 u * scale apart.
  int invented = 0;    ///< Separated pairs called overlapping.
  int inaccurate = 0;  ///< Relative errors beyond the limit.
  int not_finite = 0;  ///< NaN, infinity.
  int gave_up = 0;     ///< It said so, or threw.
  int crashed = 0;     ///< Or ran for too long.
  double worst = 0.0;  ///< Largest relative error.
};

template <int D>
[[nodiscard]] bool fits(const Library<D>& library, const Pair<D>& pair) {
  return std::max(pair.x.size(), pair.y.size()) <= library.max_vertices;
}

/// Asks about the pairs that fit the library.
template <int D>
[[nodiscard]] Tally tally(const Library<D>& library, const std::vector<Case<D>>& cases);

}  // namespace bench
