#include "exact/instances.hpp"
#include "study/runs.hpp"

namespace gjkscope::study {

Asked ask_half(const Configuration& configuration, const Family& family) {
  return detail::ask_in<Eigen::half, Eigen::half>(configuration, family);
}

}  // namespace gjkscope::study
