// All questions of all lessons: none gives its answer away, and every lesson asks.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "frames/frame.hpp"
#include "frames/spots.hpp"
#include "lessons.hpp"
#include "texts.hpp"

namespace gjkscope {
namespace asking_test {

bool is_word(const std::string& text, std::size_t at, std::size_t length) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 ||
                               static_cast<unsigned char>(text[i]) >= 0x80);
  };
  return (at == 0 || !is_letter(at - 1)) && !is_letter(at + length);
}

/// `name` stands in the text as a word of its own; "A" is no name where it is the article.
bool says(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::string after = text.substr(at + name.size(), 2);
    const bool is_article = name == "A" && after.size() == 2 && after[0] == ' ' &&
                            std::islower(static_cast<unsigned char>(after[1])) != 0;
    if (is_word(text, at, name.size()) && !is_article) return true;
  }
  return false;
}

/// Words of a frame by where they stand.
std::map<std::string, std::string> words_of(const FramePicture& frame) {
  const std::set<std::string> of_panel = {"heading",      "body",       "body.muted", "strong",
                                          "code.current", "code.value", "pass",       "untried"};
  std::map<std::string, std::string> out = {{"prose", frame.text.prose},
                                            {"position", frame.text.position}};
  for (const Mark& mark : frame.picture.marks) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (text == nullptr) continue;
    std::string where;
    if (mark.role == "title" || mark.role == "view-title") where = "title";
    if (mark.role == "timeline.label.current") where = "timeline";
    if (mark.role == "legend") where = "legend";
    if (of_panel.contains(mark.role)) where = "panel";
    if (!where.empty()) out[where] += text->text + "\n";
  }
  return out;
}

/// Words of which any text may have some.
const std::set<std::string> kPlainWords = {"no", "none", "yes", "true", "false", "cut", "neither"};

/// Lessons whose panels name a support point, which may be the answer as well as not.
const std::set<std::string> kNameTheSupportPoint = {"far-away", "duplicates"};

/// Words that name the answer, and no other choice and no vertex that is not of it. That a shape
/// has the name of the answer tells nothing.
std::vector<std::string> given_away(const Lesson& lesson, const FramePicture& frame) {
  const FrameQuestion& asked = *frame.text.question;
  std::vector<std::string> out;
  if (kPlainWords.contains(asked.answer)) return out;
  std::set<std::string> others(asked.choices.begin(), asked.choices.end());
  for (const LessonShape& shape : lesson.bodies) {
    if (shape.name == asked.answer) return out;
    for (const std::string& vertex : shape.vertex_names) {
      if (asked.answer.find(vertex) == std::string::npos) others.insert(vertex);
    }
  }
  others.erase(asked.answer);
  for (const auto& each : words_of(frame)) {
    const std::string& words = each.second;
    if (each.first == "panel" && kNameTheSupportPoint.contains(lesson.id)) continue;
    const bool has_others = std::any_of(others.begin(), others.end(),
                                        [&](const std::string& name) { return says(words, name); });
    if (says(words, asked.answer) && !has_others) out.push_back(each.first + ": " + words);
  }
  return out;
}

TEST(AllQuestions, AreNotAnsweredByTheWordsOfTheirFrames) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  int questions = 0;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    if (lesson.questions.empty()) continue;
    const LessonRun run = run_lesson(lesson);
    EffectGraph effects(run);
    LessonPictures pictures(run, effects, fonts);
    for (int i = 0; i < static_cast<int>(run.frames.size()); ++i) {
      const FrameText& text = pictures.texts()[static_cast<std::size_t>(i)];
      if (!text.question) continue;
      ++questions;
      const std::string at = lesson.id + ", frame " + std::to_string(i + 1);
      const FrameQuestion& asked = *text.question;
      EXPECT_TRUE(std::find(asked.choices.begin(), asked.choices.end(), asked.answer) !=
                  asked.choices.end())
          << at << ": " << asked.answer;
      EXPECT_TRUE(asked.spots.empty() || asked.spots.size() == asked.choices.size()) << at;
      for (const std::string& words : given_away(lesson, {pictures.picture(i), text}))
        ADD_FAILURE() << at << " answers '" << asked.answer << "' in its " << words;
    }
  }
  EXPECT_GT(questions, 150);
}

TEST(AllQuestions, AreTwoOfEachLessonAndOneOfThemIsAnsweredInTheDrawing) {
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    if (lesson.chapter == 6 || lesson.chapter > 7) continue;
    const LessonRun run = run_lesson(lesson);
    int questions = 0;
    int in_drawing = 0;
    for (const FrameText& text : testing::texts_of(run)) {
      if (!text.question) continue;
      ++questions;
      in_drawing += is_answered_in_drawing(*text.question) ? 1 : 0;
    }
    EXPECT_GE(questions, 2) << lesson.id;
    EXPECT_GE(in_drawing, 1) << lesson.id << ": of " << questions;
  }
}

TEST(AllQuestions, OfChaptersZeroToFourLeadToTheNextLesson) {
  for (const Lesson& lesson : testing::shipped_lessons()) {
    if (lesson.chapter > 4) continue;
    ASSERT_FALSE(lesson.next.empty()) << lesson.id;
    EXPECT_EQ(lesson.next.back(), '?') << lesson.id;
    const LessonRun run = run_lesson(lesson);
    EXPECT_TRUE(testing::texts_of(run).back().detail.ends_with(lesson.next)) << lesson.id;
  }
}

}  // namespace asking_test
}  // namespace gjkscope
