#pragma once
// How a configuration answers the pairs of a family.

#include "gjk/proof/result.hpp"
#include "study/configuration.hpp"
#include "study/family.hpp"
#include "study/interleave.hpp"
#include "study/truth.hpp"

namespace gjkscope::study {

struct Answer : Claim<2> {
  // The work behind the answer.
  int iterations = 0;
  int support_queries = 0;
  int start_vertices = 1;  ///< Vertices of the first simplex.
  bool settled = false;    ///< Exact arithmetic ran on where rounding left something open.
};

/// A family's pairs, kept as a configuration keeps them and wrapped for queries (which measures
/// every shape once), and the way to ask about them.
struct Asked {
  std::vector<DoublePair> kept;  ///< The pairs after rounding to what the configuration keeps.
  Contestant contestant;         ///< Its sweep asks about all of them, in order.
  std::vector<Answer> answers;   ///< The answers of the sweep.
};

/// A warm start needs a family in motion.
[[nodiscard]] Asked ask(const Configuration& configuration, const Family& family);

}  // namespace gjkscope::study
