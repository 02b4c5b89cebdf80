#pragma once
// The exact run, compiled once: it takes the compiler its time.

#include "exact/rational.hpp"
#include "gjk/proof/result.hpp"

namespace gjkscope::study {

[[nodiscard]] gjk::Result<Rational, 2> exact_distance(const gjk::Query<double, 2>& query,
                                                      const gjk::Options& options = {});

}  // namespace gjkscope::study
