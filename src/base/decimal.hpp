#pragma once
// Numbers as files hold them, and times as people read them.

#include <fmt/format.h>

#include <string>

namespace gjkscope {

/// The shortest decimal that reads back to the same bits, with a point or an exponent, which a
/// whole number has not: "2.0", "-0.0", "1e-07". `value` must be finite.
[[nodiscard]] inline std::string decimal(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

/// "86 ns", "1.23 µs", "34.5 ms", "2.1 s".
[[nodiscard]] inline std::string time_text(double ns) {
  if (ns < 1e3) return fmt::format("{:.0f} ns", ns);
  if (ns < 1e6) return fmt::format("{:.3g} µs", ns / 1e3);
  if (ns < 1e9) return fmt::format("{:.3g} ms", ns / 1e6);
  return ns < 1e12 ? fmt::format("{:.3g} s", ns / 1e9) : fmt::format("{:.0f} s", ns / 1e9);
}

}  // namespace gjkscope
