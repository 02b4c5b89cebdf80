#pragma once
// Answers of a player as text.

#include <nlohmann/json.hpp>
#include <string>

namespace gjkscope {

using Json = nlohmann::ordered_json;

/// On one line; what is not UTF-8 is replaced.
inline std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gjkscope
