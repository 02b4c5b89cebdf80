#pragma once
// What marks mean, said in the frame that shows them first.

#include <span>
#include <string_view>
#include <vector>

#include "picture/scene.hpp"

namespace gjkscope {

struct LegendEntry {
  std::string_view role;
  std::string_view text;
};

/// Those of marks that are drawn for GJK, in the order in which they are said.
[[nodiscard]] std::span<const LegendEntry> own_legend_entries();

[[nodiscard]] bool has_mark(const Scene& scene, std::string_view role);

/// What explains them: in the `spare` part of the panel, of which it takes what it needs; where
/// that has no room, at the edge of the card where it hides least, and none of the `words`. Nothing
/// where there is no such place.
[[nodiscard]] std::vector<Mark> legend(const std::vector<LegendEntry>& entries, const Scene& scene,
                                       const Rect& card, const std::vector<Rect>& words,
                                       const Fonts& fonts, Rect& spare);

}  // namespace gjkscope
