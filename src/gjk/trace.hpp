#pragma once
// A whole run as data: its types, without the loop.

#include <vector>

#include "gjk/proof/result.hpp"
#include "gjk/record.hpp"

namespace gjk {

/// One phase of a trace: the state after it, its record, and the bounds proved so far.
template <class R, int D>
struct Step {
  Phase phase = Phase::closest;
  int iteration = 1;
  State<R, D> after;
  Record<R, D> record;
  Bounds<typename ScalarTraits<R>::Real> bounds;  ///< In the run's unit.
};

/// A whole run: `steps` holds every phase. It is empty only for a query that `prepare` refused.
template <class R, int D>
struct Trace {
  Prepared<R, D> prepared;
  State<R, D> initial;
  std::vector<Step<R, D>> steps;
  Result<R, D> result;
};

}  // namespace gjk
