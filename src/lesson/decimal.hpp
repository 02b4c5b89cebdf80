#pragma once
// Numbers as files hold them.

#include <fmt/format.h>

#include <string>

namespace gjkscope {

/// The shortest decimal that reads back to the same bits, told from a whole number by a point or an
/// exponent: "2.0", "-0.0", "1e-07". `value` must be finite.
[[nodiscard]] inline std::string decimal(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

}  // namespace gjkscope
