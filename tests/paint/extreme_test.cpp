// Lessons at the ends of what the loader accepts come out as images: no crash, no hang.

#include <gtest/gtest.h>

#include <filesystem>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "paint/canvas.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace extreme_test {

TEST(ExtremeLessons, ArePaintedWhateverTheCameraAndTheSizeOfShapes) {
  const std::filesystem::path assets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";
  const Fonts fonts(assets / "fonts.toml");
  CanvasOptions options;
  options.width = 320;
  options.height = 180;
  options.supersampling = 1;
  options.zoom = 0.25;
  const Theme theme = Theme::load(assets / "themes", "light");
  Canvas by_cairo(fonts, theme, options);
  options.renderer = Renderer::osmesa;
  Canvas by_gl(fonts, theme, options);
  int painted = 0;
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    for (const double camera : {1e-18, 1e-3, 1e3, 1e18}) {
      for (const double size : {1e-12, 1.0, 1e17}) {
        if (lesson.scalar != ScalarKind::double_ && size != 1.0) continue;
        Lesson extreme = lesson;
        for (Eigen::Vector3d& vertex : extreme.x().vertices) vertex *= size;
        for (Eigen::Vector3d& vertex : extreme.y().vertices) vertex *= size;
        for (LessonView& view : extreme.views) view.camera = Camera{{0.25, -camera, 0.0}, camera};
        const LessonRun run = run_lesson(extreme);
        EffectGraph effects(run);
        LessonPictures pictures(run, effects, fonts, {}, LabelScope::frame);
        const Picture picture = pictures.picture(static_cast<int>(run.frames.size()) / 2);
        (void)by_cairo.paint(picture);
        (void)by_gl.paint(picture);
        ++painted;
      }
    }
  }
  EXPECT_GT(painted, 100);
}

}  // namespace extreme_test
}  // namespace gjkscope
