#include "depth/instances.hpp"

GJKSCOPE_DEPTH_INSTANCES(, Eigen::half)
