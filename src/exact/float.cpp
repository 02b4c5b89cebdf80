#include "exact/instances.hpp"

GJKSCOPE_INSTANCES(, float, 2)
GJKSCOPE_INSTANCES(, float, 3)
