#pragma once
// The numbers of a frame, by name.

#include <string>
#include <vector>

namespace gjkscope {

class App;

struct NamedValue {
  std::string name;
  std::string text;
};

/// All that the frame has, as drawers write numbers.
[[nodiscard]] std::vector<NamedValue> values_now(App& app);

/// Shapes that overlap, with the polygon that finds how deep.
void show_depth(App& app);

/// Keeps a value in sight, or no longer.
void toggle_pin(App& app, const std::string& name);

}  // namespace gjkscope
