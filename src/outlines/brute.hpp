#pragma once
// Every pair of segments (Larsen 1998, "Methods for General Models"), and whether one model lies in
// the other: O(m n). What the other methods are held to.

#include "outlines/nearest.hpp"

namespace models {

struct BruteAnswer {
  Answer answer;
  long visits = 0;  ///< Pairs of segments that were measured.
};
/// Both models have segments. Ends with the first two that meet.
[[nodiscard]] BruteAnswer brute(const Model& a, const Model& b);

}  // namespace models
