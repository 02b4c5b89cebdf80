#pragma once
// Keys, which differ between the releases of Dear ImGui: Debian 12 has 1.79, Debian 13 has 1.90.

#include <imgui.h>

namespace gjkscope {

#if IMGUI_VERSION_NUM >= 18700
inline constexpr auto kKeypadEnter = ImGuiKey_KeypadEnter;
#else
inline constexpr auto kKeypadEnter = ImGuiKey_KeyPadEnter;
#endif

/// Keys come by KeyMap and KeysDown, and Shift and Ctrl by KeyShift and KeyCtrl, from the first
/// frame on.
inline void take_keys_by_index([[maybe_unused]] ImGuiIO& io) {
#if IMGUI_VERSION_NUM >= 18700
  io.BackendUsingLegacyKeyArrays = 1;
#endif
}

}  // namespace gjkscope
