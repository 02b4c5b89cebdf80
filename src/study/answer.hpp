#pragma once
// How a configuration answers the pairs of a family.

#include <array>

#include "gjk/certificate.hpp"
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
  bool has_bounds = false;
  Quad distance;
  Quad lower;
  Quad upper;
  std::array<Quad, 2> x;  ///< Witness points.
  std::array<Quad, 2> y;
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
