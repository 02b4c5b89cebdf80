// Terms in texts, and the file that has them.

#include "lesson/terms.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace gjkscope {
namespace course_terms_test {

constexpr const char* kFile = R"(
[convex]
lesson = "why-convex"
sentence = "No dents."

["convex hull"]
forms = ["hull", "hulls"]
lesson = "why-convex"
sentence = "The least of them."
)";

std::string found_in(const std::string& text) {
  const std::vector<CourseTerm> terms = parse_terms(kFile, "terms.toml");
  std::string out;
  for (const FoundTerm& found : find_terms(text, terms))
    out += text.substr(found.begin, found.end - found.begin) + " is " + found.term->name + "; ";
  return out;
}

TEST(CourseTermsInTexts, AreWholeWordsAndTheLongestCounts) {
  EXPECT_EQ(found_in("The convex hull is convex."),
            "convex hull is convex hull; convex is convex; ");
  EXPECT_EQ(found_in("Convex: Hulls"), "Convex is convex; Hulls is convex hull; ");
  EXPECT_EQ(found_in("convexity, hullo, unhull, éhull"), "");
  EXPECT_EQ(found_in("hull"), "hull is convex hull; ");
  EXPECT_EQ(found_in("non-convex hul"), "convex is convex; ");
  EXPECT_EQ(found_in(""), "");
}

TEST(CourseTermsFile, SaysWhatIsWrongAndWhere) {
  const auto problem = [](const char* text) -> std::string {
    try {
      (void)parse_terms(text, "terms.toml");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "none";
  };
  const std::string expected =
      "; expected [term] with 'lesson', 'sentence' and, if it has other forms, 'forms'";
  EXPECT_EQ(problem("a = 1"), "terms.toml:1:5: 'a' is no table" + expected);
  EXPECT_EQ(problem("[a]\nlesson = \"b\""),
            "terms.toml:1:1: 'a' lacks a lesson or a sentence" + expected);
  EXPECT_EQ(problem("[a]\nlesson = 2"), "terms.toml:2:10: this is no text" + expected);
  EXPECT_EQ(problem("[a]\nlessons = \"b\""),
            "terms.toml:2:1: 'lessons' is not known here" + expected);
  EXPECT_TRUE(problem("[a").starts_with("terms.toml:1:")) << problem("[a");
  EXPECT_EQ(problem(""), "none");
}

}  // namespace course_terms_test
}  // namespace gjkscope
