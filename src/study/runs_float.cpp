#include "exact/instances.hpp"
#include "study/runs.hpp"

namespace gjkscope::study {

Asked ask_float(const Configuration& configuration, const Family& family) {
  return configuration.arithmetic == Arithmetic::single_in_double
             ? detail::ask_in<double, float>(configuration, family)
             : detail::ask_in<float, float>(configuration, family);
}

}  // namespace gjkscope::study
