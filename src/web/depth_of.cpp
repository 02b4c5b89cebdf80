#include "web/depth_of.hpp"

#include "depth/depth.hpp"
#include "lesson/scalar.hpp"
#include "lesson/widen.hpp"

namespace gjkscope {

std::optional<Depth> depth_of(const PositionedRun& run, ScalarKind scalar) {
  const gjk::Verdict verdict = run.trace.result.verdict;
  if (verdict != gjk::Verdict::touching && verdict != gjk::Verdict::overlapping) return {};
  return with_scalar(scalar, [&]<class S>(std::type_identity<S>) {
    const auto x = narrowed_all<S, 2>(run.x_world);
    const auto y = narrowed_all<S, 2>(run.y_world);
    const auto found = depth::penetration<S>(gjk::Query<S, 2>{{x}, {y}});
    return Depth{widened(found.depth), widened(found.lower), widened(found.upper),
                 widened(found.translation), widened(found.x)};
  });
}

}  // namespace gjkscope
