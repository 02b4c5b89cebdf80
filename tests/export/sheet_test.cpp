// The sheets of chapters: each fits its paper, and says what its lessons have.

#include "export/sheet.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "base/file.hpp"
#include "lesson/chapters.hpp"
#include "lessons.hpp"
#include "picture/text_box.hpp"

namespace gjkscope {
namespace sheet_test {

const std::filesystem::path kAssets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";

std::map<int, SheetWords> shipped_sheets() {
  return parse_sheets(read_whole(kAssets / "sheets.toml"), "assets/sheets.toml");
}

std::string refused(const std::string& text) {
  try {
    (void)parse_sheets(text, "s.toml");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(Sheet, EachChapterFitsBothPapers) {
  const auto titles = parse_chapters(read_whole(kAssets / "chapters.toml"), "chapters.toml");
  const auto sheets = shipped_sheets();
  EXPECT_EQ(sheets.size(), titles.size());
  const Fonts fonts(kAssets / "fonts.toml");
  const auto terms = parse_terms(read_whole(kAssets / "terms.toml"), "terms.toml");
  for (const auto& [chapter, words] : sheets) {
    SCOPED_TRACE(chapter);
    for (const Paper paper : {Paper::a4, Paper::letter}) {
      const Picture picture = sheet_picture(
          {chapter, titles.at(chapter), words, terms, testing::shipped_lessons()}, fonts, paper);
      const auto [width, height] = sheet_size(paper);
      EXPECT_EQ(picture.width, width);
      for (const Mark& mark : picture.marks) {
        const Text* text = std::get_if<Text>(&mark.shape);
        if (text == nullptr) continue;
        EXPECT_LE(text->at.y(), height) << text->text;
        EXPECT_LE(box_of(fonts, *text).max.x(), width) << text->text;
      }
    }
  }
}

TEST(Sheet, TheTrailHasAPictureOfEachIteration) {
  const auto lessons = testing::shipped_lessons();
  const SheetWords words = shipped_sheets().at(4);
  const Picture picture =
      sheet_picture({4, "t", words, {}, lessons}, Fonts(kAssets / "fonts.toml"), Paper::a4);
  int iterations = 0;
  bool has_bounds = false;
  for (const Mark& mark : picture.marks) {
    const Text* text = std::get_if<Text>(&mark.shape);
    if (text && text->text.find(": S = {") != std::string::npos) ++iterations;
    has_bounds = has_bounds || (text && text->text == "at most");
  }
  EXPECT_EQ(iterations, 4);  // polygons-gjk
  EXPECT_TRUE(has_bounds);
}

TEST(Sheet, WhatIsNoSheetIsRefusedInItsPlace) {
  EXPECT_EQ(refused("[3]\nrule = [\"a\", \"b\"]\npitfalls = [\"c\"]\n").substr(0, 45),
            "s.toml:1:1: a sheet has a rule of three sente");
  EXPECT_EQ(refused("[three]\n").substr(0, 30), "s.toml:1:2: 'three' is no chap");
  EXPECT_EQ(refused("[3]\nfigures = [[\"guess\"]]\n").substr(0, 40),
            "s.toml:2:12: a figure is a lesson and th");
  const auto lessons = testing::shipped_lessons();
  const SheetWords words{{"a", "b", "c"}, {"d"}, {}, {{"guess", 99}}};
  const Fonts fonts(kAssets / "fonts.toml");
  EXPECT_THROW((void)sheet_picture({0, "t", words, {}, lessons}, fonts, Paper::a4),
               std::runtime_error);
}

}  // namespace sheet_test
}  // namespace gjkscope
