// Terms before use: all transcripts in the order of the course.

#include "lesson/terms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "cli/transcript.hpp"
#include "lessons.hpp"

namespace gjkscope {
namespace terms_test {

std::string terms_file() {
  std::ifstream in(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "terms.toml");
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

/// Without the full stop: a lesson may go on from there.
std::string words_of(const CourseTerm& term) {
  return term.sentence.substr(0, term.sentence.find_last_not_of('.') + 1);
}

std::vector<std::string> lines_of(const Lesson& lesson) {
  std::istringstream in(transcript(run_lesson(lesson), false));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Course, LessonsOfThePlaneNameLessonsInSpaceThatExist) {
  const std::vector<Lesson> lessons = testing::shipped_lessons();
  int named = 0;
  for (const Lesson& lesson : lessons) {
    if (lesson.in_space.empty()) continue;
    ++named;
    const auto other = std::find_if(lessons.begin(), lessons.end(), [&](const Lesson& candidate) {
      return candidate.id == lesson.in_space;
    });
    ASSERT_NE(other, lessons.end()) << lesson.id << " names " << lesson.in_space;
    EXPECT_EQ(lesson.dimension, 2) << lesson.id;
    EXPECT_EQ(other->dimension, 3) << lesson.in_space;
  }
  EXPECT_GE(named, 12);
}

TEST(CourseTerms, AreExplainedByTheirSentenceBeforeAnyLineUsesThem) {
  const std::vector<CourseTerm> terms = parse_terms(terms_file(), "assets/terms.toml");
  const std::vector<Lesson> lessons = testing::shipped_lessons();
  ASSERT_TRUE(std::is_sorted(lessons.begin(), lessons.end(), [](const Lesson& a, const Lesson& b) {
    return std::pair(a.chapter, a.order) < std::pair(b.chapter, b.order);
  }));
  std::set<std::string> explained;
  std::map<std::string, int> uses;
  for (const Lesson& lesson : lessons) {
    const auto is_of = [&](const CourseTerm& term) { return term.lesson == lesson.id; };
    // Titles may name what the lesson will explain.
    const auto look = [&](const std::string& where, const std::string& words, bool is_title) {
      for (const FoundTerm& found : find_terms(words, terms)) {
        ++uses[found.term->name];
        EXPECT_TRUE(explained.contains(found.term->name) || (is_title && is_of(*found.term)))
            << lesson.id << ", " << where << ": '" << found.term->name
            << "' comes before its sentence, which " << found.term->lesson << " says:\n  " << words;
      }
    };
    for (const LessonView& view : lesson.views) look("title of a view", view.title, true);
    const std::vector<std::string> lines = lines_of(lesson);
    look("title", lines.front(), true);
    for (std::size_t i = 2; i < lines.size(); ++i) {  // after the source
      for (const CourseTerm& term : terms) {
        if (is_of(term) && lines[i].find(words_of(term)) != std::string::npos)
          explained.insert(term.name);
      }
      look("line " + std::to_string(i + 1), lines[i], false);
    }
  }
  for (const CourseTerm& term : terms) {
    EXPECT_TRUE(explained.contains(term.name)) << term.lesson << " does not say: " << term.sentence;
    EXPECT_GE(uses[term.name], 2) << "nothing uses '" << term.name << "' but its sentence";
  }
}

TEST(CourseTerms, AreTheOnesThatTheCourseIsMadeOf) {
  std::set<std::string> names;
  for (const CourseTerm& term : parse_terms(terms_file(), "assets/terms.toml"))
    names.insert(term.name);
  for (const char* name : {"support point", "convex", "feature", "Voronoi region", "weight",
                           "projection", "simplex", "slab", "coherence"})
    EXPECT_TRUE(names.contains(name)) << name;
}

}  // namespace terms_test
}  // namespace gjkscope
