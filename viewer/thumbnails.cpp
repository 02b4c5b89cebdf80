#include "thumbnails.hpp"

#include "frames/frame.hpp"
#include "frames/stage.hpp"
#include "lesson/load.hpp"
#include "run/trail.hpp"
#include "subjects/subjects.hpp"
#include "widgets.hpp"

namespace gjkscope {

Picture thumbnail(Lesson lesson, const Fonts& fonts) {
  constexpr double kUsual = 4.0;  // times as large a camera leaves the usual room at the edges
  const Page page{
      .width = thumbnails::kWidth, .height = thumbnails::kHeight, .zoom = 1.0, .bare = true};
  lesson.views.resize(1);
  lesson.views[0].close_up.reset();
  lesson.panel.clear();
  const LessonRun run = run_lesson(std::move(lesson));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts, page, LabelScope::frame);
  const LessonView& view = run.lesson.views[0];
  if (shows_shapes(view.kind)) {
    const Rect usual{{0.0, 0.0}, kUsual * Point(page.width, page.height)};
    pictures.lay_out(page, {CameraOverride{camera_of(run, view, usual), page.width / page.height}},
                     LabelScope::frame);
  }
  Picture picture = pictures.picture(answering_index(run));
  std::erase_if(picture.marks, [](const Mark& mark) {
    return std::holds_alternative<Text>(mark.shape) || mark.role == "leader" ||
           mark.role == "label.halo" || mark.role == "view-title.box";
  });
  return picture;
}

const Picture* Thumbnails::of(const std::filesystem::path& file) {
  const auto found = made_.find(file);
  if (found != made_.end()) return &found->second;
  if (is_making()) return nullptr;
  being_made_ = file;
  making_ = std::async(std::launch::async, [file, &fonts = fonts_]() -> Picture {
    try {
      const LoadedLesson loaded = load_lesson(file, vocabulary());
      if (loaded.lesson) return thumbnail(*loaded.lesson, fonts);
    } catch (const std::exception&) {
      // Opening it says what is wrong.
    }
    return {};
  });
  return nullptr;
}

void Thumbnails::forget(const std::filesystem::path& file) {
  made_.erase(file);
  if (file == being_made_) being_made_.clear();
}

void Thumbnails::tick() {
  if (!is_making() || !is_ready(making_)) return;
  Picture made = making_.get();
  if (!being_made_.empty()) made_[being_made_] = std::move(made);
}

}  // namespace gjkscope
