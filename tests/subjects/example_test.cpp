// The subject that docs/architecture.md shows: it is this one, and it draws and writes.

#include <gtest/gtest.h>

#include <algorithm>

#include "frames/frame.hpp"
#include "lesson/lesson_texts.hpp"
#include "lessons.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::subjects {
extern const SubjectParts longest_edge;
}  // namespace gjkscope::subjects

#include "longest_edge.cpp"

namespace gjkscope {
namespace example_test {

TEST(ExampleOfASubject, IsTheOneInTheDocs) {
  const std::string docs =
      testing::file_text(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "docs" / "architecture.md");
  const std::string example = testing::file_text(std::filesystem::path(GJKSCOPE_SOURCE_DIR) /
                                                 "tests" / "subjects" / "longest_edge.cpp");
  EXPECT_NE(docs.find("```cpp\n" + example + "```"), std::string::npos);
}

TEST(ExampleOfASubject, DrawsAndWrites) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygons-gjk"));
  EffectGraph effects(run);
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  PanelBuilder panel(run, effects, run.frames[0], fonts, Rect{{0.0, 0.0}, {400.0, 400.0}});
  subjects::longest_edge.blocks.front()->write(panel);
  const auto says = [&](const Mark& mark) {
    const Text* text = std::get_if<Text>(&mark.shape);
    return text != nullptr && text->text == "The longest edge of Y";
  };
  EXPECT_TRUE(std::any_of(panel.marks.begin(), panel.marks.end(), says));

  const LessonView& world = run.lesson.views.front();
  const StageMap map(Rect{{0.0, 0.0}, {400.0, 400.0}}, Camera{});
  SceneBuilder scene(run, effects, run.frames[0], world, map);
  subjects::longest_edge.layers.front()->draw(scene);
  EXPECT_EQ(scene.out.marks.size(), 1u);
  EXPECT_EQ(effects.count("longest-edge").runs, 1) << "both asked for one value";
}

}  // namespace example_test
}  // namespace gjkscope
