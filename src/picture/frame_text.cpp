#include "picture/frame_text.hpp"

#include <algorithm>
#include <cmath>

namespace gjkscope {

using Eigen::Vector3d;

Spot spot_of_triangle(ViewKind view, const std::array<Vector3d, 3>& corners) {
  const Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  double room = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d along = (corners[(i + 1) % 3] - corners[i]).normalized();
    const Vector3d to_middle = middle - corners[i];
    room = std::min(room, (to_middle - along * along.dot(to_middle)).norm());
  }
  return {view, middle, middle, 0.5 * room};
}

}  // namespace gjkscope
