#include "effects/registry.hpp"

namespace gjkscope {

const std::vector<EffectInfo>& registered_effects() {
  static const std::vector<EffectInfo> effects = {
#define GJKSCOPE_EFFECT(name) effect_infos::k##name,
#include "effects/list.def"
#undef GJKSCOPE_EFFECT
  };
  return effects;
}

}  // namespace gjkscope
