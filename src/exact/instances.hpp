#pragma once
// The core in the scalars of lessons, compiled once. A source that includes this, and links
// gjkscope::instances, calls the compiled code instead of compiling it again.

#include "exact/rational.hpp"
#include "gjk/gjk.hpp"

// NOLINTBEGIN(bugprone-macro-parentheses): a type takes none.
/// Names what runs in S are made of; `linkage` is `extern` where they are declared only.
#define GJKSCOPE_INSTANCES(linkage, S, D)                                                          \
  linkage template gjk::Result<S, D> gjk::distance<S>(const gjk::Query<S, D>&,                     \
                                                      const gjk::Options&);                        \
  linkage template gjk::Prepared<S, D> gjk::prepare<S>(const gjk::Query<S, D>&,                    \
                                                       const gjk::Options&);                       \
  linkage template gjk::State<S, D> gjk::start(const gjk::Query<S, D>&, const gjk::Options&,       \
                                               const gjk::Prepared<S, D>&);                        \
  linkage template void gjk::run(gjk::State<S, D>&, const gjk::Query<S, D>&, const gjk::Options&,  \
                                 const gjk::Prepared<S, D>&);                                      \
  linkage template void gjk::step(gjk::State<S, D>&, const gjk::Query<S, D>&, const gjk::Options&, \
                                  const gjk::Prepared<S, D>&, gjk::Record<S, D>&);                 \
  linkage template gjk::Result<S, D> gjk::result(const gjk::State<S, D>&, const gjk::Query<S, D>&, \
                                                 const gjk::Options&, const gjk::Prepared<S, D>&); \
  linkage template gjk::Bounds<gjk::ScalarTraits<S>::Real> gjk::bounds_so_far(                     \
      const gjk::State<S, D>&, const gjk::Prepared<S, D>&);
// NOLINTEND(bugprone-macro-parentheses)

GJKSCOPE_INSTANCES(extern, Eigen::half, 2)
GJKSCOPE_INSTANCES(extern, Eigen::half, 3)
GJKSCOPE_INSTANCES(extern, float, 2)
GJKSCOPE_INSTANCES(extern, float, 3)
GJKSCOPE_INSTANCES(extern, double, 2)
GJKSCOPE_INSTANCES(extern, double, 3)
GJKSCOPE_INSTANCES(extern, gjkscope::Rational, 2)
GJKSCOPE_INSTANCES(extern, gjkscope::Rational, 3)
extern template gjk::Result<double, 2> gjk::distance<gjk::Default>(const gjk::Query<double, 2>&,
                                                                   const gjk::Options&);
