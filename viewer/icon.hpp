#pragma once
// Icons of buttons, drawn as strokes and triangles: they need no font, and are sharp at any size.

#include <imgui.h>

namespace gjkscope {

enum class Icon {
  first,
  back_far,
  back,
  play,
  pause,
  forth,
  forth_far,
  last,
  undo,
  redo,
  fit,
  close
};

/// In a square around `center`, of `size` pixels. `paper` is the colour of what it stands on.
void draw_icon(ImDrawList& list, Icon icon, const ImVec2& center, float size, ImU32 color,
               ImU32 paper);

}  // namespace gjkscope
