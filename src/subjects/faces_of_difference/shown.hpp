#pragma once
// Faces of the difference in pictures: what a frame shows of them, and what their tour draws and
// says.

#include <optional>
#include <string_view>

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "subjects/faces_of_difference/growth.hpp"
#include "subjects/faces_of_difference/lesson_trace.hpp"

namespace gjkscope::zfaces {

inline constexpr AskInfo kAskSource{"face-source", "what the marked face of Z comes from",
                                    "of kind"};
inline constexpr AskInfo kAskMover{"face-vertex", "which vertex the marked face of Z comes from",
                                   "of kind"};

inline constexpr AskInfo kAskFaces{"faces-grow", "how the faces of Z grow with the bodies"};
inline constexpr AskInfo kAskDepthPoints{"depth-points", "how many support points a depth takes"};
inline constexpr AskInfo kAskCorners{"general-corners",
                                     "which power of n bounds Z of bodies that are not convex"};

/// Frames after the answer: counts as bodies grow. A question about them is one of them.
[[nodiscard]] std::optional<Growing> growth_of(const LessonRun& run, const Frame& frame);

/// The part of Z that a frame shows. A frame that asks shows the face that it asks about.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame)
      : lesson(run.lesson),
        trace(faces_trace(run.algorithm_trace(frame))),
        bodies(run.run(frame).bodies),
        asks(frame.question >= 0),
        asks_source(asks && run.asked(frame).ask == kAskSource.name),
        is_answer(frame.step >= trace.steps()),
        step(asks ? frame.answering_step : std::min(frame.step, trace.steps() - 1)) {}

  const Lesson& lesson;
  const FacesTrace& trace;
  const std::vector<Body>& bodies;
  bool asks;
  bool asks_source;
  bool is_answer;
  int step;  ///< -1: the start, or there are no faces.

  /// The difference of two vertices.
  [[nodiscard]] Eigen::Vector3d z(gjk::VertexPair pair) const {
    return bodies[1].world[pair.y] - bodies[0].world[pair.x];
  }
  /// Corners of a face of Z.
  [[nodiscard]] std::vector<gjk::VertexPair> corners(const sums_in_space::Face& face) const {
    return sums_in_space::corners_of(face, bodies[0].world, bodies[1].world);
  }

  // For a frame with a step
  [[nodiscard]] const FacesTrace::Step& at() const { return trace.all[step]; }
  /// The face that it is about; null where it is about many.
  [[nodiscard]] const sums_in_space::Face* face() const {
    return at().face < 0 ? nullptr : &trace.faces[at().face];
  }
  [[nodiscard]] std::string of_y(const sums_in_space::Face& face) const {
    return part_name(lesson.y(), face.y);
  }
  [[nodiscard]] std::string of_x(const sums_in_space::Face& face) const {
    return part_name(lesson.x(), face.x);
  }
};

// blocks.cpp
extern const Block kFaceKinds;

// layers.cpp
bool fill(SceneBuilder& scene, const Fonts& fonts);
void stage(SceneBuilder& scene);

// words.cpp
void words(const Story& story, FrameText& text);
void question(const Story& story, FrameText& text);
void values(const Story& story, FrameText& text);

}  // namespace gjkscope::zfaces
