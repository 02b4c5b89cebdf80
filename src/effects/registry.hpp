#pragma once
// The effects there are, by name.

#include <string_view>
#include <vector>

namespace gjkscope {

struct EffectInfo {
  std::string_view name;
  std::string_view
      needs;  ///< Names of the effects that it pulls, separated by commas; empty: the trace alone.
  std::string_view summary;   ///< One line for `gjkscope explain`.
  std::string_view used_by;   ///< "view": a lesson's views call for it by name; "panel": a panel
                              ///< block does; "frame": any part of a frame may.
  std::string_view act = {};  ///< The act that it goes with; empty: any.
  bool second_run = false;    ///< It shows the run in the scalar `query.beside`.

  /// True when it is the effect called `other`, or needs it, directly or through other effects.
  [[nodiscard]] bool pulls(std::string_view other) const;
};

/// What the registry says of the effect E (effects/graph.hpp).
template <class E>
[[nodiscard]] constexpr EffectInfo effect_info(std::string_view used_by, std::string_view summary,
                                               std::string_view act = {}, bool second_run = false) {
  return {E::kName, E::kNeeds, summary, used_by, act, second_run};
}

/// Each is defined beside its effect, and listed in list.def.
namespace effect_infos {
#define GJKSCOPE_EFFECT(name) extern const EffectInfo k##name;
#include "effects/list.def"
#undef GJKSCOPE_EFFECT
}  // namespace effect_infos

/// In the order in which `explain` lists them.
[[nodiscard]] const std::vector<EffectInfo>& registered_effects();

}  // namespace gjkscope
