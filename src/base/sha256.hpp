#pragma once
// SHA-256 (FIPS 180-4), by which a content security policy names the scripts that it lets run.

#include <array>
#include <cstdint>
#include <string_view>

namespace gjkscope {

[[nodiscard]] std::array<std::uint8_t, 32> sha256(std::string_view bytes);

}  // namespace gjkscope
