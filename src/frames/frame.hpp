#pragma once
// Lesson + run + effects -> pictures: the layout of a frame, and the words that go with it.

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "picture/frame_text.hpp"
#include "picture/legend.hpp"
#include "picture/picture.hpp"
#include "picture/scene.hpp"
#include "run/graph.hpp"

namespace gjkscope {

/// The alternative text of a frame's figure, for readers who cannot see it.
[[nodiscard]] std::string alternative_text(const FrameText& text);

/// The words of all frames of a lesson, in order; nothing is drawn for them.
[[nodiscard]] std::vector<FrameText> lesson_texts(const LessonRun& run, EffectGraph& effects);

struct FramePicture {
  Picture picture;
  FrameText text;
};

/// The area on which frames are laid out: at least 1280 x 720 frame pixels (in a window 760 x 720),
/// `zoom` pixels of the image each.
/// Type keeps its proportion to the page whatever the size of the image.
struct Page {
  double width = 1280.0;
  double height = 720.0;
  double zoom = 1.0;
  /// Holds the stages alone, from edge to edge, and may be smaller: the words, the panel and the
  /// timeline are shown by other means.
  bool bare = false;
  bool captions = false;  ///< On a bare page: the caption stands below its stages.
  friend bool operator==(const Page&, const Page&) = default;
};
/// The page of an image of `width` x `height` pixels.
[[nodiscard]] Page page_of(int width, int height);

/// The frames for which places of labels are chosen: all of the lesson, so that labels stay in
/// place from frame to frame; or the first frame drawn alone, which is quicker.
enum class LabelScope { lesson, frame };

/// A camera in place of the lesson's. A card of another aspect still shows everything that it shows
/// in a card of this aspect.
struct CameraOverride {
  Camera camera;
  double aspect = 1.0;  ///< Width over height of the card that it was set in.
};
/// One for each view; nothing for the lesson's own camera.
using CameraOverrides = std::vector<std::optional<CameraOverride>>;

/// The pictures of a lesson, each built when it is asked for. Labels of things that move keep their
/// place from one picture asked for to the next.
class LessonPictures {
 public:
  /// One view on the page: what `camera` sees of it, centered in `card`.
  struct ShownView {
    Rect card;
    ViewKind kind = ViewKind::world;
    Camera camera;
  };

  /// All but `page` must outlive the pictures.
  LessonPictures(const LessonRun& run, EffectGraph& effects, const Fonts& fonts,
                 const Page& page = {}, LabelScope scope = LabelScope::lesson);
  ~LessonPictures();
  /// The same frames on another page, or seen by other cameras than the lesson's: `cameras` has one
  /// for each view, nothing for the lesson's own. Nothing is run again. `stacked`: whether views
  /// stand one below the other, on a page that has room for both; without, as suits the lesson.
  void lay_out(const Page& page, const CameraOverrides& cameras, LabelScope scope,
               std::optional<bool> stacked = std::nullopt);
  [[nodiscard]] bool is_stacked() const { return stacked_; }
  /// While frames are laid out one by one (LabelScope::frame), the panel explains what `other` has
  /// explained: the same lesson, before a hand changed it.
  void explain_as(const LessonPictures& other) { explained_marks_ = other.explained_marks_; }
  LessonPictures(const LessonPictures&) = delete;
  LessonPictures& operator=(const LessonPictures&) = delete;

  /// `index` is that of the frame in LessonRun::frames. Vertices pointed at are named in any case;
  /// all else stays where it is.
  [[nodiscard]] Picture picture(int index, std::span<const Subject> pointed = {}) {
    return picture(index, texts_[index], pointed);
  }
  /// With other words than those of the frame.
  [[nodiscard]] Picture picture(int index, const FrameText& text,
                                std::span<const Subject> pointed = {});
  [[nodiscard]] const std::vector<FrameText>& texts() const { return texts_; }
  [[nodiscard]] std::vector<ShownView> views() const;

 private:
  struct View;
  [[nodiscard]] const Scene& scene(View& view, std::size_t index);
  void place_fixed_labels(View& view, std::size_t shown);
  void draw(Picture& picture, View& view, std::size_t index);
  void draw_label(Picture& picture, View& view, const LabelRequest& label, bool fixed);
  void draw_leader(Picture& picture, View& view, const LabelRequest& label, const Rect& box);
  /// Names of vertices pointed at that have none.
  void draw_pointed(Picture& picture, View& view, std::size_t index,
                    std::span<const Subject> pointed);
  void draw_close_up(Picture& picture, View& near, std::size_t index);
  [[nodiscard]] std::vector<LegendEntry> marks_to_explain(std::size_t view, std::size_t index);
  [[nodiscard]] std::vector<LegendRow> standing_legend(std::size_t index);
  [[nodiscard]] std::vector<Mark> legend_in(const Rect& spare, std::size_t index);

  const LessonRun& run_;
  EffectGraph& effects_;
  const Fonts& fonts_;
  Page page_;
  LabelScope scope_ = LabelScope::lesson;
  bool stacked_ = false;
  std::vector<FrameText> texts_;
  std::vector<View> views_;
  /// Explanations in each frame of each view: those of the marks that are shown first there.
  std::vector<std::vector<LegendEntry>> explained_;
  std::vector<LegendEntry> explained_marks_;  ///< All of these, in this order.
  std::optional<Rect> panel_;
  double prose_y_ = 0.0;
  double caption_y_ = 0.0;
  Rect timeline_;
};

/// All of them, in order.
[[nodiscard]] std::vector<FramePicture> lesson_pictures(const LessonRun& run, EffectGraph& effects,
                                                        const Fonts& fonts, const Page& page = {});

}  // namespace gjkscope
