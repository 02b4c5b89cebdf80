#pragma once
#include "picture/story.hpp"

namespace gjkscope::captions {

/// A whole run at a glance (run/trail.hpp): how it went, why it ended, and what is proved.
void trail(const Story& story, FrameText& text);

}  // namespace gjkscope::captions
