#pragma once
// Penetration depth in the scalars of lessons, compiled once. A source that includes this, and
// links gjkscope::depth, calls the compiled code instead of compiling it again.

#include "depth/depth.hpp"
#include "exact/instances.hpp"

// NOLINTBEGIN(bugprone-macro-parentheses): a type takes none.
#define GJKSCOPE_DEPTH_INSTANCES(linkage, S)                                          \
  linkage template depth::Result<S, 2> depth::penetration<S>(const gjk::Query<S, 2>&, \
                                                             const gjk::Options&);    \
  linkage template depth::Result<S, 3> depth::penetration<S>(const gjk::Query<S, 3>&, \
                                                             const gjk::Options&);
// NOLINTEND(bugprone-macro-parentheses)

GJKSCOPE_DEPTH_INSTANCES(extern, Eigen::half)
GJKSCOPE_DEPTH_INSTANCES(extern, float)
GJKSCOPE_DEPTH_INSTANCES(extern, double)
GJKSCOPE_DEPTH_INSTANCES(extern, gjkscope::Rational)
