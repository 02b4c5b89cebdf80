#pragma once
// How a configuration answers the pairs of a family.

#include "study/configuration.hpp"
#include "study/family.hpp"
#include "study/interleave.hpp"
#include "study/truth.hpp"

namespace gjkscope::study {

struct Answer : Claim {
  int iterations = 0;  ///< -1 where nobody counts them: in lockstep.
};

/// A family's pairs, kept as a configuration keeps them and wrapped for queries (which measures
/// every shape once), and the way to ask about them.
struct Asked {
  std::vector<DoublePair> kept;  ///< The pairs after rounding to what the configuration keeps.
  Contestant contestant;         ///< Its sweep asks about all of them, in order.
  std::vector<Answer> answers;   ///< Of the sweep.
};

/// A warm start needs a family in motion.
[[nodiscard]] Asked ask(const Configuration& configuration, const Family& family);

}  // namespace gjkscope::study
