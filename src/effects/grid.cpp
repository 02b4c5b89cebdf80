#include "effects/grid.hpp"

#include "effects/registry.hpp"

namespace gjkscope {

const EffectInfo effect_infos::kGrid =
    effect_info<Grid>("view", "axes, and lines at round coordinates");

}  // namespace gjkscope
