#pragma once
// Shapes by name: what the drawer of shapes has buttons for.

#include <cstddef>

#include "session/edit.hpp"

namespace gjkscope {

class App;

inline constexpr int kFewestCorners = 3;
inline constexpr int kMostCorners = static_cast<int>(edit::kMostEditable);

/// The shape becomes a regular polygon of so many corners, kFewestCorners to kMostCorners.
void make_regular(App& app, std::size_t body, int corners);

}  // namespace gjkscope
