#include "run/widen.hpp"
#include "study/exact.hpp"
#include "study/runs.hpp"

namespace gjkscope::study {

Asked ask_exact(const Configuration& configuration, const Family& family) {
  return detail::asked<double>(configuration, family,
                               [](const gjk::Query<double, 2>& query, const gjk::Options& options) {
                                 return widened(exact_distance(query, options), 0);
                               });
}

}  // namespace gjkscope::study
