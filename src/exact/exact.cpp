#include "exact/instances.hpp"

GJKSCOPE_INSTANCES(, gjkscope::Rational, 2)
GJKSCOPE_INSTANCES(, gjkscope::Rational, 3)
