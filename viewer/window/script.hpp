#pragma once
// Recorded input: what tests and documentation play into the window. One command a line:
//
//   key Shift+Right           a key, with Ctrl+ and Shift+ before it
//   type 0.25                 text, to the end of the line
//   move PLACE                the pointer
//   press | release           its button
//   click PLACE               and doubleclick PLACE
//   drag PLACE PLACE          in ten moves
//   wheel N                   up is positive
//   command NAME              a command by its name, as the list of all commands has it
//   resize WIDTH HEIGHT
//   wait SECONDS              as if that time passed
//   screenshot FILE           what the window shows, as PNG
//   state FILE                what is shown and edited, as JSON
//   # ...                     a comment
//
// A PLACE is two pixels "640 360", or the middle of a mark: "x:0" and "y:2" are vertices, "z:0,2"
// one of the difference, "shape-x", "shape-y", "difference", "frame:7" of the timeline,
// "phase:support" of the pseudocode, "dot:3" of a study's plot; each may be followed by an offset
// in pixels, "y:2+30,-10".

#include <string_view>

#include "window/window.hpp"

namespace gjkscope {

/// Plays a script. Throws std::runtime_error with name:line for a line that it cannot do.
void play_script(std::string_view script, std::string_view name, App& app, Window& window);

}  // namespace gjkscope
