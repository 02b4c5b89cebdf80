#include "study/answer.hpp"

#include "study/runs.hpp"

namespace gjkscope::study {

Asked ask(const Configuration& configuration, const Family& family) {
  switch (configuration.arithmetic) {
    case Arithmetic::half:
      return ask_half(configuration, family);
    case Arithmetic::single:
    case Arithmetic::single_in_double:
      return ask_float(configuration, family);
    case Arithmetic::long_double:
    case Arithmetic::quad:
      return ask_wide(configuration, family);
    case Arithmetic::exact:
      return ask_exact(configuration, family);
    case Arithmetic::double_:
      break;
  }
  return ask_double(configuration, family);
}

}  // namespace gjkscope::study
