#pragma once
// How far an answer is off, drawn over the frame that tells.

#include <span>

#include "frames/frame.hpp"
#include "session/session.hpp"

namespace gjkscope {

/// A ring around the right choice and a struck one around a wrong one; along an edge a line
/// instead. An answer that pointed at a place gets the way to the right one. Choices that the
/// drawing does not have get no marks.
void add_verdict(Picture& picture, const LessonRun& run,
                 std::span<const LessonPictures::ShownView> views, const FrameQuestion& asked,
                 const Answer& answer);

}  // namespace gjkscope
