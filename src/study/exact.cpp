#include "study/exact.hpp"

#include "gjk/gjk.hpp"

namespace gjkscope::study {

gjk::Result<Rational, 2> exact_distance(const gjk::Query<double, 2>& query,
                                        const gjk::Options& options) {
  return gjk::distance<Rational>(query, options);
}

}  // namespace gjkscope::study
