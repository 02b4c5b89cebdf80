#pragma once
// How a configuration answers the pairs of a family.

#include <array>

#include "gjk/result.hpp"
#include "study/configuration.hpp"
#include "study/family.hpp"
#include "study/interleave.hpp"
#include "study/quad.hpp"

namespace gjkscope::study {

/// An answer in any arithmetic, widened: nothing rounds, since 113 bits hold every type that the
/// core answers in.
struct Answer {
  bool refused = false;  ///< There is no answer: the query was refused.
  gjk::Verdict verdict = gjk::Verdict::none;
  bool has_bounds = false;  ///< Else `lower` and `upper` say nothing.
  Quad distance;
  Quad lower;
  Quad upper;
  std::array<Quad, 2> x;  ///< Witness points.
  std::array<Quad, 2> y;
  // What it took.
  int iterations = 0;
  int support_queries = 0;
  int start_vertices = 1;  ///< Of the first simplex.
  bool settled = false;    ///< Exact arithmetic ran on where rounding left something open.
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
