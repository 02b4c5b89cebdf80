#pragma once
// Lesson + run + effects -> pictures: the layout of a frame, and the words that go with it.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effects/graph.hpp"
#include "picture/picture.hpp"

namespace gjkscope {

/// What a frame asks.
struct FrameQuestion {
  std::string ask;                   ///< "support", ...
  std::vector<std::string> choices;  ///< As the frame lists them.
  std::string answer;                ///< The next frame that asks nothing tells it.
};

/// The words and numbers of a frame: what the sidecar file, the contact sheet, the transcript and
/// the alternative text say.
struct FrameText {
  std::string caption;   ///< What happened and why, from this step's values.
  std::string detail;    ///< The numbers behind it, and what comes next.
  std::string prose;     ///< The lesson's prose, placeholders filled in.
  std::string phase;     ///< "closest", ..., or "start"
  int iteration = 0;     ///< From 1; 0 before the first.
  std::string position;  ///< Where in the lesson it is: "iteration 2 of 4 · support".
  std::vector<std::pair<std::string, std::string>>
      values;  ///< Name and printed value, in reading order.
  std::optional<FrameQuestion> question;
};

/// What a frame says to who cannot see it: the alternative text of its figure.
[[nodiscard]] std::string alternative_text(const FrameText& text);

/// The words of all frames of a lesson, in order; nothing is drawn for them.
[[nodiscard]] std::vector<FrameText> lesson_texts(const LessonRun& run, EffectGraph& effects);

struct FramePicture {
  Picture picture;
  FrameText text;
};

/// What frames are laid out on: at least 1280 x 720 frame pixels, `zoom` pixels of the image each.
/// Type keeps its proportion to the page whatever the size of the image.
struct Page {
  double width = 1280.0;
  double height = 720.0;
  double zoom = 1.0;
};
/// The page of an image of `width` x `height` pixels.
[[nodiscard]] Page page_of(int width, int height);

/// All frames of a lesson. Labels keep their place from frame to frame, so frames are built in
/// order, together.
[[nodiscard]] std::vector<FramePicture> lesson_pictures(const LessonRun& run, EffectGraph& effects,
                                                        const Fonts& fonts, const Page& page = {});

}  // namespace gjkscope
