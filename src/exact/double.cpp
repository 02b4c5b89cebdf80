#include "exact/instances.hpp"

GJKSCOPE_INSTANCES(, double, 2)
GJKSCOPE_INSTANCES(, double, 3)
template gjk::Result<double, 2> gjk::distance<gjk::Default>(const gjk::Query<double, 2>&,
                                                            const gjk::Options&);
