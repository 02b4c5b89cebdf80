#include "lesson/problem.hpp"

#include <gtest/gtest.h>

namespace gjkscope {
namespace problem_test {

TEST(Problem, ReadsAsOneLine) {
  EXPECT_EQ(to_string({"a.toml", 3, 7, "unknown key 'cpa'", "one of: cap, start", "cap"}),
            "a.toml:3:7: unknown key 'cpa'; expected one of: cap, start; did you mean 'cap'?");
  EXPECT_EQ(to_string({"a.toml", 1, 1, "there is no such file", "", ""}),
            "a.toml:1:1: there is no such file");
}

TEST(NearestName, FindsSlipsOfTheFingers) {
  const std::vector<std::string> known = {"vertices", "vertices-first", "names", "cap", "distance"};
  EXPECT_EQ(nearest_name("vertice", known), "vertices");    // left out
  EXPECT_EQ(nearest_name("verrtices", known), "vertices");  // doubled
  EXPECT_EQ(nearest_name("nmaes", known), "names");         // swapped
  EXPECT_EQ(nearest_name("dustance", known), "distance");   // replaced
  EXPECT_EQ(nearest_name("cpa", known), "cap");
  EXPECT_EQ(nearest_name("Vertices_First", known), "vertices-first");  // case and separator
}

TEST(NearestName, PrefersTheSmallestDistanceThenTheFirst) {
  EXPECT_EQ(nearest_name("abcdef", {"abcxyf", "abcdex"}), "abcdex");
  EXPECT_EQ(nearest_name("abcdef", {"abcdey", "abcdex"}), "abcdey");
}

TEST(NearestName, IsSilentWhereNothingIsNear) {
  EXPECT_EQ(nearest_name("colour", {"names", "vertices"}), "");
  EXPECT_EQ(nearest_name("Q", {"A", "B"}), "");  // one letter is no slip of another
  EXPECT_EQ(nearest_name("", {"A"}), "");
  EXPECT_EQ(nearest_name("name", {}), "");
  EXPECT_EQ(nearest_name(std::string(1000000, 'a'), {"names"}), "");
}

TEST(NearestName, OneLetterNamesMatchInTheOtherCase) {
  EXPECT_EQ(nearest_name("k", {"A", "K"}), "K");
}

}  // namespace problem_test
}  // namespace gjkscope
