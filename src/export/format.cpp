#include "export/format.hpp"

#include <algorithm>
#include <array>

namespace gjkscope {
namespace {

constexpr std::array<std::string_view, 8> kNames = {"png", "svg",  "pdf", "tex",
                                                    "gif", "apng", "mp4", "webm"};

constexpr std::array<Format, kNames.size()> kFormats = {Format::png, Format::svg, Format::pdf,
                                                        Format::tex, Format::gif, Format::apng,
                                                        Format::mp4, Format::webm};

}  // namespace

std::span<const Format> all_formats() { return kFormats; }

std::optional<Format> format_of(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Format>(found - kNames.begin());
}

std::string_view name_of(Format format) { return kNames[static_cast<std::size_t>(format)]; }

}  // namespace gjkscope
