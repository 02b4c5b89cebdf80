#pragma once
// The pairs of shapes that the study asks about.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lesson/case.hpp"
#include "study/families.hpp"

namespace gjkscope::study {

using DoublePair = families::Pair<double>;

/// No pair has a pose: each is two lists of vertices, as a case is.
struct Family {
  std::string name;
  std::string about;  ///< A few words about its pairs.
  std::vector<DoublePair> pairs;
  int vertices = 0;        ///< The vertices of every shape, where families differ by size; else 0.
  bool in_motion = false;  ///< Each pair is the one before, a moment later.
};

/// How many pairs a family has, at most: the exact run of large polygons takes its time.
struct Sizes {
  int pairs = 512;
  int timed_pairs = 96;      ///< The first so many are timed: time is spent on repetitions.
  int most_vertices = 1024;  ///< The limit of families that differ by size.
};

/// The families, those that differ by size last. A seed gives the same pairs everywhere.
/// `reported`: cases that were reported to libraries as failures; without any their family is left
/// out.
[[nodiscard]] std::vector<Family> families_of(std::uint64_t seed, const Sizes& sizes,
                                              std::span<const Case> reported);

}  // namespace gjkscope::study
