#pragma once
// How far an answer is off, drawn over the frame that tells.

#include <span>

#include "frames/frame.hpp"
#include "session/session.hpp"

namespace gjkscope {

/// A ring around the right choice and a struck one around a wrong one; of an edge a line along it.
/// Of a place that was pointed at the way to where it is. Choices that the drawing does not have
/// get no marks.
void add_verdict(Picture& picture, const LessonRun& run,
                 std::span<const LessonPictures::ShownView> views, const FrameQuestion& asked,
                 const Answer& answer);

}  // namespace gjkscope
