#pragma once

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

namespace gjkscope {

/// A double as a hexadecimal float, "0x1.8p-1", the same with each version of fmt and each C
/// library: fmt 10 writes 0 as 0x0p-1022, and musl 0x1p-1074 for 0x0.0000000000001p-1022.
[[nodiscard]] inline std::string hexadecimal(double value) {
  if (value == 0.0) return std::signbit(value) ? "-0x0p+0" : "0x0p+0";
  if (std::fpclassify(value) != FP_SUBNORMAL) return fmt::format("{:a}", value);
  std::string digits = fmt::format("{:013x}", std::bit_cast<std::uint64_t>(std::abs(value)));
  digits.erase(digits.find_last_not_of('0') + 1);
  return fmt::format("{}0x0.{}p-1022", value < 0 ? "-" : "", digits);
}

}  // namespace gjkscope
