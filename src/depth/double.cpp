#include "depth/instances.hpp"

GJKSCOPE_DEPTH_INSTANCES(, double)
