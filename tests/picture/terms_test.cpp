// Terms on the pictures of all lessons.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "lessons.hpp"
#include "picture/term_spots.hpp"

namespace gjkscope {
namespace term_spots_test {

std::vector<CourseTerm> course_terms() {
  std::ifstream in(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "terms.toml");
  std::ostringstream out;
  out << in.rdbuf();
  return parse_terms(out.str(), "assets/terms.toml");
}

/// Panels and legends are no part of transcripts, and name no term earlier, either.
TEST(TermSpots, OfAnyFrameAreOfTermsWhoseLessonHasCome) {
  const std::vector<CourseTerm> terms = course_terms();
  std::set<std::string> come;
  std::set<std::string> early;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    come.insert(lesson.id);
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, testing::fonts());
    for (int i = 0; i < static_cast<int>(run.frames.size()); ++i) {
      Picture picture = pictures.picture(i);
      // A map names chapters that are still to come.
      std::erase_if(picture.marks, [](const Mark& mark) { return mark.role == "map.title"; });
      for (const TermSpot& spot : term_spots(picture, testing::fonts(), terms)) {
        if (!come.contains(spot.term->lesson))
          early.insert(lesson.id + " shows '" + spot.term->name + "'");
      }
    }
  }
  for (const std::string& each : early) ADD_FAILURE() << each << " before its lesson";
}

TEST(TermSpots, StandAroundTheirWordsAndGoOnInTheNextLine) {
  std::vector<CourseTerm> terms = {{"support point", {"support point"}, "a", "b."}};
  Picture picture;
  const TextStyle style = type::kCaption;
  const Text first{{100.0, 50.0}, "C is the support", style};
  const Text second{{100.0, 77.0}, "point, a support point.", style};
  picture.marks = {{"caption", first}, {"caption", second}};
  const std::vector<TermSpot> spots = term_spots(picture, testing::fonts(), terms);
  ASSERT_EQ(spots.size(), 3u);
  const auto width = [&](const char* words) { return testing::fonts().width(style, words); };
  EXPECT_DOUBLE_EQ(spots[0].box.min.x(), 100.0 + width("C is the "));
  EXPECT_DOUBLE_EQ(spots[0].box.max.x(), 100.0 + width("C is the support"));
  EXPECT_DOUBLE_EQ(spots[1].box.min.x(), 100.0);
  EXPECT_DOUBLE_EQ(spots[1].box.max.x(), 100.0 + width("point"));
  EXPECT_DOUBLE_EQ(spots[2].box.min.x(), 100.0 + width("point, a "));
  for (const TermSpot& spot : spots) EXPECT_EQ(spot.term, &terms.front());
  EXPECT_LT(spots[0].box.min.y(), 50.0);
  EXPECT_GT(spots[0].box.max.y(), 50.0);
  // A label of another role is no next line.
  picture.marks[1].role = "detail";
  EXPECT_EQ(term_spots(picture, testing::fonts(), terms).size(), 1u);
}

}  // namespace term_spots_test
}  // namespace gjkscope
