#pragma once
// The blocks of the panel, and the listings that one of them shows. Each is a value that a subject
// defines; it writes from the current row downwards.

#include <optional>
#include <string>
#include <string_view>

#include "lesson/shown_of.hpp"
#include "picture/panel_builder.hpp"

namespace gjkscope {

struct Block {
  std::string_view name;     ///< By which lessons call for it.
  std::string_view meaning;  ///< The content of the block, in words.
  void (*write)(PanelBuilder& panel) = nullptr;
  std::string_view tour = {};   ///< The tour that it goes with; empty: any.
  std::string_view table = {};  ///< The table that it shows; empty: none.
  bool takes_listing = false;
  ShownOf shown_of = ShownOf::plane;
};

/// The listings that the block `pseudocode` can show.
struct Listing {
  std::string_view name;
  std::string_view meaning;  ///< The algorithm that it is one of.
  void (*write)(PanelBuilder& panel) = nullptr;
  std::string_view tour = {};  ///< The tour that it goes with; empty: any.
  ShownOf shown_of = ShownOf::plane;
};

}  // namespace gjkscope
