#pragma once

#include <imgui.h>

#include "picture/picture.hpp"

namespace gjkscope {

[[nodiscard]] inline ImVec2 vec(const Point& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

}  // namespace gjkscope
