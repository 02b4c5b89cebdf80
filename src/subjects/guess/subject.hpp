#pragma once
// How a course begins: guess the closest points, try vertices alone, walk downhill. Three tours.

#include "picture/scene.hpp"
#include "picture/story.hpp"
#include "picture/tour.hpp"

namespace gjkscope::guesses {

extern const Tour kGuess;

/// A line, its ends, and how long it is.
void measured_line(SceneBuilder& scene, const std::string& role, const std::string& id,
                   const Eigen::Vector2d& from, const Eigen::Vector2d& to);
/// A frame for each of `count` parts of a run's last step.
void add_part_frames(LessonRun& run, int index, int count);
/// Nothing of the run is known, whatever the part.
void knows_nothing(const Frame& frame, KnownFacts& facts);
/// The words of a frame of shapes that overlap; false where they do not.
bool overlap_words(const Story& story, FrameText& text);
/// The names of both shapes.
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::guesses

namespace gjkscope::vertex_pairs {
extern const Tour kTour;
}
namespace gjkscope::downhill {
extern const Tour kTour;
}
