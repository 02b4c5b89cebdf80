#include "density.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gjkscope {

std::optional<double> dpi_of_resources(std::string_view resources) {
  constexpr std::string_view kKey = "Xft.dpi:";
  for (std::size_t at = 0; at < resources.size();) {
    const std::size_t end = std::min(resources.find('\n', at), resources.size());
    std::string_view line = resources.substr(at, end - at);
    at = end + 1;
    if (!line.starts_with(kKey)) continue;
    line.remove_prefix(kKey.size());
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    double dpi = 0.0;
    const auto [rest, error] = std::from_chars(line.data(), line.data() + line.size(), dpi);
    if (error == std::errc() && dpi > 0.0) return dpi;
  }
  return std::nullopt;
}

double scale_of_dpi(double dpi) {
  constexpr double kUsual = 96.0;
  constexpr double kMost = 4.0;  // what says more is wrong
  constexpr double kSteps = 4.0;
  return std::clamp(std::floor(kSteps * dpi / kUsual + 1e-6) / kSteps, 1.0, kMost);
}

}  // namespace gjkscope
