#include "study/runs.hpp"

namespace gjkscope::study {

Asked ask_wide(const Configuration& configuration, const Family& family) {
  return configuration.arithmetic == Arithmetic::quad
             ? detail::ask_in<Quad, double>(configuration, family)
             : detail::ask_in<long double, double>(configuration, family);
}

}  // namespace gjkscope::study
