#pragma once
// An effect, by its name: when a lesson may ask for it, and which others it pulls.

#include <string_view>

#include "lesson/shown_of.hpp"

namespace gjkscope {

struct EffectInfo {
  std::string_view name;
  std::string_view
      needs;  ///< Names of the effects that it pulls, separated by commas; empty: the trace alone.
  std::string_view summary;     ///< One line for `gjkscope explain`.
  std::string_view used_by;     ///< "view": a lesson's views call for it by name; "panel": a panel
                                ///< block does; "frame": any part of a frame may.
  std::string_view tour = {};   ///< The tour that it goes with; empty: any.
  std::string_view table = {};  ///< The table that it shows; empty: none.
  ShownOf shown_of = ShownOf::plane;
};

/// The entry of the effect E (run/graph.hpp).
template <class E>
[[nodiscard]] constexpr EffectInfo effect_info(std::string_view used_by, std::string_view summary,
                                               std::string_view tour = {},
                                               std::string_view table = {}) {
  return {E::kName, E::kNeeds, summary, used_by, tour, table};
}

/// The entry, of an effect that shapes in space have, too, or alone.
[[nodiscard]] constexpr EffectInfo shown_of(ShownOf what, EffectInfo info) {
  info.shown_of = what;
  return info;
}

/// These belong to no subject: any frame may use them.
namespace effect_infos {
extern const EffectInfo kFrameFacts;
extern const EffectInfo kAlgorithmFacts;
}  // namespace effect_infos

}  // namespace gjkscope
