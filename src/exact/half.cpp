#include "exact/instances.hpp"

GJKSCOPE_INSTANCES(, Eigen::half, 2)
GJKSCOPE_INSTANCES(, Eigen::half, 3)
