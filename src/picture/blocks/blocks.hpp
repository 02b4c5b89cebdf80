#pragma once
// The blocks of the panel. Each is a value, defined in one of the files here, and listed in
// list.def; it writes from the current row downwards.

#include <optional>
#include <string>
#include <string_view>

#include "picture/panel_builder.hpp"

namespace gjkscope {

struct Block {
  std::string_view name;     ///< By which lessons call for it.
  std::string_view meaning;  ///< What it shows.
  void (*write)(PanelBuilder& panel) = nullptr;
  std::string_view act = {};  ///< The act that it goes with; empty: any.
  bool second_run = false;    ///< It shows the run in the scalar `query.beside`.
  bool takes_listing = false;
};

namespace blocks {

#define GJKSCOPE_BLOCK(name) extern const Block k##name;
#include "picture/blocks/list.def"
#undef GJKSCOPE_BLOCK

// What several blocks are written with.

// regions.cpp
/// `misleads`: a test that holds, and takes the wrong point.
enum class TestMark { untried, fails, holds, misleads };
/// At the left of the current row.
void test_mark(PanelBuilder& panel, TestMark mark);
/// One row of a chain of tests: mark, region, condition and numbers.
void test_row(PanelBuilder& panel, TestMark mark, bool current, const std::string& region,
              const std::string& condition, const std::string& values);

// pseudocode.cpp
/// What a line says of the frame's step.
struct LineView {
  enum class State { idle, untried, current, past, rejected } state = State::idle;
  std::optional<bool> verdict = {};  ///< Of a region test.
  std::string value = {};            ///< What the line computed.
};
void write_line(PanelBuilder& panel, const std::string& text, const LineView& line);
/// A line of a listing that is current or not; its value is written where it is.
void listing_line(PanelBuilder& panel, const std::string& text, bool current,
                  std::string value = {});

// growth.cpp
/// In place of the counters where a frame is about many runs.
void growth_counters(PanelBuilder& panel);

}  // namespace blocks

/// The listings that the block `pseudocode` can show.
struct Listing {
  std::string_view name;
  std::string_view meaning;  ///< The algorithm that it is one of.
  void (*write)(PanelBuilder& panel) = nullptr;
  std::string_view act = {};  ///< The act that it goes with; empty: any.
};

namespace listings {

#define GJKSCOPE_LISTING(name) extern const Listing k##name;
#include "picture/blocks/listings.def"
#undef GJKSCOPE_LISTING

}  // namespace listings

}  // namespace gjkscope
