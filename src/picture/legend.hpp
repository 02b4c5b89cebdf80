#pragma once
// Explanations of marks: in the frame that shows them first, and, if the panel has room, as long as
// they are there.

#include <string_view>
#include <vector>

#include "picture/scene.hpp"

namespace gjkscope {

struct LegendEntry {
  std::string_view role;
  std::string_view text;
};

/// The first mark with this role that is to be seen; null where there is none.
[[nodiscard]] const Mark* mark_of(const Scene& scene, std::string_view role);

/// A mark, and what it means.
struct LegendRow {
  const Mark* mark = nullptr;
  std::string_view text;
};

[[nodiscard]] Point legend_size(const std::vector<LegendRow>& rows, const Fonts& fonts);
/// With its upper left corner at `at`.
[[nodiscard]] std::vector<Mark> legend(const std::vector<LegendRow>& rows, const Point& at,
                                       const Fonts& fonts);
/// At an edge of the card, where it hides no marks and none of the `words`: as many of the rows as
/// have room there.
[[nodiscard]] std::vector<Mark> legend_on_stage(std::vector<LegendRow> rows, const Scene& scene,
                                                const Rect& card, const std::vector<Rect>& words,
                                                const Fonts& fonts);

}  // namespace gjkscope
