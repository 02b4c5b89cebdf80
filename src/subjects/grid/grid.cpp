#include "subjects/grid/grid.hpp"

#include "subjects/grid/subject.hpp"

namespace gjkscope {

const EffectInfo effect_infos::kGrid =
    effect_info<Grid>("view", "axes, and lines at round coordinates");

}  // namespace gjkscope
