#pragma once
// Whole numbers of any size.

#include <boost/multiprecision/cpp_int.hpp>

namespace gjkscope {

/// Up to 512 bits are kept in the number itself, more on the heap.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>,
                                              boost::multiprecision::et_off>;

/// Binary digits of |a|; none of 0.
[[nodiscard]] long digit_count(const Integer& a);
/// Zeros at the end of the binary digits of `a`, which is not 0.
[[nodiscard]] long trailing_zeros(const Integer& a);
/// The square root of `a`, which is not negative, rounded down.
[[nodiscard]] Integer root_down(const Integer& a);

}  // namespace gjkscope
