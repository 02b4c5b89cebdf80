#include "exact/integer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gjkscope {

long digit_count(const Integer& a) { return a.is_zero() ? 0 : static_cast<long>(msb(abs(a))) + 1; }

long trailing_zeros(const Integer& a) { return static_cast<long>(lsb(abs(a))); }

Integer root_down(const Integer& a) {
  if (a.is_zero()) return 0;
  // Newton's method from above, where it only falls: from the root of the leading digits, which
  // leaves room for their rounding and for the digits that follow.
  const long drop = std::max(0L, digit_count(a) - 60) / 2 * 2;
  const auto leading = static_cast<double>(static_cast<std::uint64_t>(a >> drop));
  Integer root = Integer(static_cast<std::uint64_t>(std::sqrt(leading)) + 2) << (drop / 2);
  for (;;) {
    Integer next = (root + a / root) >> 1;
    if (next >= root) return root;
    root = std::move(next);
  }
}

}  // namespace gjkscope
