#pragma once
#include <functional>
#include <string>
#include <vector>

namespace gjkscope {

/// A key as it was pressed: "Right", "PageUp", "Space", "F5", "A", "/" and so on.
struct KeyPress {
  std::string key;
  bool ctrl = false;
  bool shift = false;
};

/// The action of a key, a button, a menu entry or a line of the palette.
struct Command {
  std::string name;   ///< "Next step"
  std::string group;  ///< "Step"
  std::vector<std::string> keys;
  std::function<void()> run;
  std::function<bool()> can = nullptr;  ///< Whether it would do anything; empty: always.
  [[nodiscard]] bool is_enabled() const { return !can || can(); }
};

}  // namespace gjkscope
