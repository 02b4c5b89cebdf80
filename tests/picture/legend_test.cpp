// The legend of a frame names only what is to be seen in it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "fonts.hpp"
#include "frames/frame.hpp"
#include "lessons.hpp"
#include "paint/canvas.hpp"

namespace gjkscope::legend_test {

/// The drawing on the stages: no words, no panel.
bool is_drawn(const Mark& mark) {
  return mark.clip >= 0 && !std::holds_alternative<Text>(mark.shape);
}

/// Roles in the legend of a picture, each with the words beside it.
std::vector<std::pair<std::string, std::string>> explained(const Picture& picture) {
  std::vector<std::pair<std::string, std::string>> out;
  for (std::size_t i = 1; i < picture.marks.size(); ++i) {
    const Mark& mark = picture.marks[i];
    if (mark.role == "legend")
      out.emplace_back(picture.marks[i - 1].role, std::get<Text>(mark.shape).text);
  }
  return out;
}

/// Pixels that differ by more than edges do that are smoothed twice.
int differing(const Image& a, const Image& b) {
  constexpr int kSeen = 5;  // of 255: a shadow on the floor is 11 darker
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += Image::kChannels) {
    bool differs = false;
    for (std::size_t c = 0; c < 3; ++c)
      differs = differs || std::abs(a.pixels[i + c] - b.pixels[i + c]) > kSeen;
    count += differs ? 1 : 0;
  }
  return count;
}

TEST(Legend, NamesOnlyWhatIsSeen) {
  const Theme theme =
      Theme::load(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "themes", "light");
  Canvas canvas(testing::fonts(), theme, {.width = 640, .height = 360, .zoom = 0.5});
  int rows = 0;
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, testing::fonts());
    const std::vector<LegendEntry> entries = legend_entries(run);
    for (int i = 0; i < static_cast<int>(run.frames.size()); ++i) {
      const Picture picture = pictures.picture(i);
      Picture all = picture;
      std::erase_if(all.marks, [](const Mark& mark) { return !is_drawn(mark); });
      std::optional<Image> painted;
      for (const auto& [role, words] : explained(picture)) {
        const auto is_it = [&role = role, &words = words](const LegendEntry& entry) {
          return entry.role == role && entry.text == words;
        };
        if (std::none_of(entries.begin(), entries.end(), is_it)) continue;  // a key of another kind
        ++rows;
        Picture without = all;
        std::erase_if(without.marks,
                      [&role = role](const Mark& mark) { return mark.role == role; });
        if (!painted) painted = canvas.paint(all);
        EXPECT_GT(differing(*painted, canvas.paint(without)), 2)
            << lesson.id << ", frame " << i + 1 << ": " << role << ", \"" << words << '"';
      }
    }
  }
  EXPECT_GT(rows, 500);
}

}  // namespace gjkscope::legend_test
