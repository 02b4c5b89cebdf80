#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace gjkscope {

/// A double as a hexadecimal float, "0x1.8p-1", the same with each version of fmt: fmt 10 writes 0
/// as 0x0p-1022.
[[nodiscard]] inline std::string hexadecimal(double value) {
  if (value == 0.0) return std::signbit(value) ? "-0x0p+0" : "0x0p+0";
  return fmt::format("{:a}", value);
}

}  // namespace gjkscope
