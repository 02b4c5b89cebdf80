#include "exact/instances.hpp"
#include "study/runs.hpp"

namespace gjkscope::study {

Asked ask_double(const Configuration& configuration, const Family& family) {
  return detail::ask_in<double, double>(configuration, family);
}

}  // namespace gjkscope::study
