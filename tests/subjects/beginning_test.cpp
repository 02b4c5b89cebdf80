// The lessons that a course begins with: what they say of their shapes is so.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "frames/frame.hpp"
#include "lesson/chapters.hpp"
#include "lessons.hpp"
#include "outlines/polygon.hpp"
#include "picture/words.hpp"
#include "texts.hpp"

namespace gjkscope {
namespace beginning_test {

using Eigen::Vector2d;
using testing::shipped_lesson;

/// The words of the frames that ask nothing.
std::vector<FrameText> texts_in(const LessonRun& run) {
  std::vector<FrameText> texts = testing::texts_of(run);
  std::erase_if(texts, [](const FrameText& text) { return text.question.has_value(); });
  return texts;
}

bool says(const FrameText& text, double number) {
  return (text.caption + text.detail).find(fixed(number, 3)) != std::string::npos;
}

TEST(Beginning, AGuessIsComparedWithTheClosestPoints) {
  const LessonRun run = run_lesson(shipped_lesson("guess"));
  std::vector<Vector2d> places;
  for (const FrameText& text : testing::texts_of(run)) {
    if (text.question) places.push_back(*text.question->place);
  }
  ASSERT_EQ(places.size(), 2u);
  EXPECT_NEAR((places[1] - places[0]).norm(), run.runs[0].trace.result.distance, 1e-12);
}

TEST(Beginning, NeitherVerticesNorSamplesAreAsCloseAsTheClosestPoints) {
  const LessonRun run = run_lesson(shipped_lesson("not-vertices"));
  const std::vector<Vector2d> x = in_plane(run.runs[0].x().world);
  const std::vector<Vector2d> y = in_plane(run.runs[0].y().world);
  const double distance = run.runs[0].trace.result.distance;
  double of_vertices = HUGE_VAL;
  double of_samples = HUGE_VAL;
  constexpr int kSamples = 10;
  const auto sample = [](const std::vector<Vector2d>& shape, std::size_t i) {
    const std::size_t edge = i / kSamples;
    const double share = static_cast<double>(i % kSamples) / kSamples;
    return Vector2d((1.0 - share) * shape[edge] + share * shape[(edge + 1) % shape.size()]);
  };
  for (std::size_t i = 0; i < kSamples * x.size(); ++i) {
    for (std::size_t k = 0; k < kSamples * y.size(); ++k) {
      const double apart = (sample(x, i) - sample(y, k)).norm();
      of_samples = std::min(of_samples, apart);
      if (i % kSamples == 0 && k % kSamples == 0) of_vertices = std::min(of_vertices, apart);
    }
  }
  EXPECT_GT(of_samples, distance);
  EXPECT_GT(of_vertices, of_samples);
  const std::vector<FrameText> texts = texts_in(run);
  ASSERT_EQ(texts.size(), 4u);
  EXPECT_TRUE(says(texts[1], of_vertices)) << texts[1].caption;
  EXPECT_TRUE(says(texts[2], of_vertices - distance)) << texts[2].caption;
  EXPECT_TRUE(says(texts[3], of_samples - distance)) << texts[3].caption;
}

TEST(Beginning, TheWalkIsStuckOnTheOutlineAndFindsTheClosestPointOfTheHull) {
  const LessonRun run = run_lesson(shipped_lesson("why-convex"));
  const Vector2d q = in_plane(run.runs[0].x().world.front());
  const std::vector<Vector2d> y = in_plane(run.runs[0].y().world);
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < y.size(); ++i)
    least = std::min(least, segment_distance(q, y[i], y[(i + 1) % y.size()]));
  const std::vector<FrameText> texts = texts_in(run);
  ASSERT_EQ(texts.size(), 6u);
  EXPECT_TRUE(says(texts[3], least)) << texts[3].caption;
  EXPECT_NE(texts[3].caption.find("stuck"), std::string::npos);
  // GJK sees the hull.
  EXPECT_TRUE(says(texts[5], run.runs[0].trace.result.distance)) << texts[5].caption;
  EXPECT_LT(run.runs[0].trace.result.distance, least);
}

TEST(Beginning, TheMapHasTheTitlesOfTheChapters) {
  std::ifstream in(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "chapters.toml");
  std::stringstream text;
  text << in.rdbuf();
  std::map<int, std::string> chapters = parse_chapters(text.str(), "chapters.toml");
  chapters.erase(0);
  const LessonRun run = run_lesson(shipped_lesson("course-map"));
  EffectGraph effects(run);
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  LessonPictures pictures(run, effects, fonts);
  std::vector<std::string> titles;
  for (const Mark& mark : pictures.picture(0).marks) {
    if (mark.role == "map.title") titles.push_back(std::get<Text>(mark.shape).text);
  }
  std::vector<std::string> wanted;
  for (const auto& [number, title] : chapters)
    wanted.push_back(fmt::format("{}  {}", number, title));
  EXPECT_EQ(titles, wanted);
}

}  // namespace beginning_test
}  // namespace gjkscope
