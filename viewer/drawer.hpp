#pragma once
// Drawers: panels beside the picture, one at a time. Each is a value made by one file of drawers/
// and named in drawers.def; what it remembers lives in its functions.

#include <functional>
#include <string>
#include <vector>

#include "command.hpp"
#include "picture/picture.hpp"

namespace gjkscope {

class App;

struct Drawer {
  std::string name;  ///< On its tab, and of the command that opens and closes it.
  std::string key;
  std::string help;  ///< One line, for who points at the tab.
  std::function<void()> draw;
  std::function<void(bool is_open)> toggled = nullptr;
  /// A click on the picture; true when it was meant for this drawer, which need not be open.
  std::function<bool(const Subject&)> clicked = nullptr;
  /// The subject under the pointer on the picture.
  std::function<void(const Subject&)> pointed = nullptr;
  std::vector<Command> commands = {};
  /// Whether it waits for what is computed beside the window; it is drawn again until it has it.
  std::function<bool()> waits = nullptr;
  /// In pixels at scale 1, until another one is chosen; the usual one without.
  std::function<double()> width = nullptr;
};

#define DRAWER(name) [[nodiscard]] Drawer name##_drawer(App& app);
#include "drawers.def"
#undef DRAWER

}  // namespace gjkscope
