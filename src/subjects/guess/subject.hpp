#pragma once
// How a course begins: guess the closest points, try vertices alone, walk downhill. Three acts.

#include "picture/act.hpp"
#include "picture/scene.hpp"
#include "picture/story.hpp"

namespace gjkscope::guesses {

extern const Act kGuess;

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
extern const Act kAct;
}
namespace gjkscope::downhill {
extern const Act kAct;
}
