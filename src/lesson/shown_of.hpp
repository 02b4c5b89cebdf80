#pragma once
// Whether a block, a listing or an effect shows shapes in the plane, in space, or both.

namespace gjkscope {

enum class ShownOf { plane, both, space };

[[nodiscard]] constexpr bool is_shown_of(ShownOf what, int dimension) {
  return what == ShownOf::both || (what == ShownOf::space) == (dimension == 3);
}

}  // namespace gjkscope
