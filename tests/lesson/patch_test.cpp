// A lesson that is saved over its file leaves what somebody wrote there.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <sstream>

#include "base/file.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lesson/toml_patch.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace patch_test {

namespace fs = std::filesystem;

const std::string kMine = R"(# My lesson. It has a # in a comment, and "quotes".
title = "It's # not a comment"   # but this is one
chapter = 4
order = 3   # after "segment"
prose = '''[not.a.table] key = "#"'''

# The triangle of the lecture.
[ shapes.X ]   # X stays where it is
name = "X"
names = ["A", "B", "C"]
vertices = [
  # seen from the left
  [0, 0],        # A
  [ 1.50 , 0 ],  # B, [not] a list
  [0, 1e0],      # C
]
rotate = 0  # degrees

[shapes.Y]
name = "Y"
vertices = [[3, 0], [4, 0], [4, 1]]

[query]  # the usual one
direction = "towards-origin"   # as on the slides
cap = 64

[steps]
tour = "phase"

# The views.
[[views]]
show = "world"
# Labels are not needed here.
effects = []
[[views]]
show = "difference" # Z

[panel]
blocks = ["simplex"]

[expect]  # what comes out
stop = "repeated-support"
distance = 1.5
)";

LoadedLesson parse(const std::string& text) {
  return parse_lesson(text, "mine.toml", vocabulary());
}

Lesson lesson(const std::string& text) {
  const LoadedLesson loaded = parse(text);
  for (const Problem& problem : loaded.problems) ADD_FAILURE() << to_string(problem);
  return loaded.lesson.value_or(Lesson{});
}

std::string kept(const std::string& text, const Lesson& wanted) {
  const std::optional<std::string> out = lesson_toml_kept(text, wanted, "mine.toml", vocabulary());
  EXPECT_TRUE(out);
  if (!out) return "";
  EXPECT_EQ(wanted, lesson(*out)) << *out;
  return *out;
}

/// Lines of `after` that are not in `before`, and the other way round.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}
std::vector<std::string> without(const std::string& all, const std::string& some) {
  std::vector<std::string> out;
  const std::vector<std::string> other = lines_of(some);
  for (const std::string& line : lines_of(all)) {
    if (std::find(other.begin(), other.end(), line) == other.end()) out.push_back(line);
  }
  return out;
}

TEST(Patch, WhatDoesNotChangeIsTheSameBytes) { EXPECT_EQ(kMine, kept(kMine, lesson(kMine))); }

TEST(Patch, AMovedVertexChangesItsOwnLineAlone) {
  Lesson moved = lesson(kMine);
  moved.x().vertices[1] = {1.25, -0.5, 0.0};
  const std::string text = kept(kMine, moved);
  EXPECT_EQ(std::vector<std::string>{"  [1.25, -0.5],  # B, [not] a list"}, without(text, kMine));
  EXPECT_EQ(std::vector<std::string>{"  [ 1.50 , 0 ],  # B, [not] a list"}, without(kMine, text));
}

TEST(Patch, AKeyThatComesStandsInItsTable) {
  Lesson more = lesson(kMine);
  more.scalar = ScalarKind::half;
  more.views[1].title = "The difference";
  const std::string text = kept(kMine, more);
  const std::vector<std::string> added = {"scalar = \"half\"", "title = \"The difference\""};
  EXPECT_EQ(added, without(text, kMine));
  EXPECT_TRUE(without(kMine, text).empty());
}

TEST(Patch, CommentsOfWhatGoesStay) {
  Lesson fewer = lesson(kMine);
  fewer.x().vertices.pop_back();
  fewer.x().vertex_names.pop_back();
  fewer.views.pop_back();
  fewer.panel.clear();
  const std::string text = kept(kMine, fewer);
  for (const std::string& line : lines_of(kMine)) {
    // The strings of this file hold a # in two lines only.
    const std::size_t sign = line.rfind("# ");
    if (sign == std::string::npos || line.starts_with("title")) continue;
    EXPECT_NE(std::string::npos, text.find(line.substr(sign))) << line << "\n" << text;
  }
}

TEST(Patch, ATableThatComesAndOneThatGoes) {
  Lesson other = lesson(kMine);
  other.questions.push_back({"support", 1});
  const std::string more = kept(kMine, other);
  EXPECT_TRUE(without(kMine, more).empty());
  other.questions.clear();
  EXPECT_TRUE(without(kMine, kept(more, other)).empty());
}

TEST(Patch, AnotherLayoutIsRefusedAndNothingElse) {
  std::string dotted = kMine;
  const std::size_t at = dotted.find("[query]");
  dotted.erase(at, dotted.find("[steps]") - at);
  dotted.insert(0, "query.cap = 64\n");
  Lesson wanted = lesson(dotted);
  EXPECT_EQ(dotted, kept(dotted, wanted));
  wanted.options.iteration_cap = 7;
  EXPECT_FALSE(lesson_toml_kept(dotted, wanted, "mine.toml", vocabulary()));
  EXPECT_FALSE(lesson_toml_kept("title = ", wanted, "mine.toml", vocabulary()));
}

TEST(Patch, AFileWithoutALastLineBreakAndWithThoseOfWindows) {
  std::string text = kMine;
  text.pop_back();
  Lesson more = lesson(text);
  more.panel = {"pseudocode"};
  more.listing = "gjk";
  more.expect.stop = "zero-direction";
  (void)kept(text, more);
  std::string windows;
  for (const char c : kMine) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  Lesson moved = lesson(windows);
  moved.order = 9;
  const std::string saved = kept(windows, moved);
  EXPECT_NE(std::string::npos, saved.find("order = 9   # after \"segment\"\r\n"));
}

/// Every lesson becomes every other one, in its own file: whatever comes out says the same, or is
/// refused.
TEST(Patch, AnyLessonIsSavedOverAnyOther) {
  std::vector<std::pair<fs::path, std::string>> files;
  for (const auto& entry : fs::directory_iterator(fs::path(GJKSCOPE_SOURCE_DIR) / "lessons")) {
    if (entry.path().extension() == ".toml")
      files.emplace_back(entry.path(), read_whole(entry.path()));
  }
  std::sort(files.begin(), files.end());
  std::mt19937 random(7);
  int patched = 0;
  int all = 0;
  for (const auto& [path, text] : files) {
    const LoadedLesson own = parse_lesson(text, path, vocabulary());
    ASSERT_TRUE(own.lesson) << path;
    EXPECT_EQ(text, lesson_toml_kept(text, *own.lesson, path, vocabulary())) << path;
    for (int i = 0; i < 3; ++i) {
      const auto& [other_path, other_text] = files[random() % files.size()];
      const LoadedLesson other = parse_lesson(other_text, other_path, vocabulary());
      ++all;
      patched += lesson_toml_kept(text, *other.lesson, path, vocabulary()).has_value() ? 1 : 0;
    }
  }
  EXPECT_GE(patched, 9 * all / 10) << "of " << all;
}

}  // namespace patch_test
}  // namespace gjkscope
