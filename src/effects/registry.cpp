#include "effects/registry.hpp"

#include <algorithm>

namespace gjkscope {

bool EffectInfo::pulls(std::string_view other) const {
  if (name == other) return true;
  for (std::string_view rest = needs; !rest.empty();) {
    const std::string_view need = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(need.size() + 1, rest.size()));
    const auto& all = registered_effects();
    if (std::any_of(all.begin(), all.end(),
                    [&](const EffectInfo& each) { return each.name == need && each.pulls(other); }))
      return true;
  }
  return false;
}

const std::vector<EffectInfo>& registered_effects() {
  static const std::vector<EffectInfo> effects = {
#define GJKSCOPE_EFFECT(name) effect_infos::k##name,
#include "effects/list.def"
#undef GJKSCOPE_EFFECT
  };
  return effects;
}

}  // namespace gjkscope
