#include "lesson/prose.hpp"

#include <gtest/gtest.h>

#include <set>

namespace gjkscope {
namespace prose_test {

TEST(Prose, PlaceholdersAreFilledIn) {
  EXPECT_EQ(expand("d = {distance}, u = {u}", {{"distance", "1.5"}, {"u", "0.25"}}),
            "d = 1.5, u = 0.25");
}

TEST(Prose, AKnownPlaceholderWithoutValueBecomesADash) {
  EXPECT_EQ(expand("w = {w}.", {}), "w = –.");
}

TEST(Prose, DoubledBracesAreBraces) {
  EXPECT_EQ(expand("{{A, B}} {{{x}}}", {{"x", "Q"}}), "{A, B} {Q}");
}

TEST(Prose, AValueIsNotExpandedAgain) {
  EXPECT_EQ(expand("{x}", {{"x", "{y}"}, {"y", "no"}}), "{y}");
}

TEST(Prose, StrayBracesStay) { EXPECT_EQ(expand("{u} } { {u", {{"u", "0.5"}}), "0.5 } { {u"); }

TEST(Prose, StrayBracesAreParts) {
  int stray = 0;
  for (const ProsePart& part : prose_parts("a } b { c {d} {e")) {
    stray += part.kind == ProsePart::Kind::stray_brace;
  }
  EXPECT_EQ(stray, 3);
}

TEST(Prose, PlaceholderNamesAreUnique) {
  std::set<std::string_view> names;
  for (const PlaceholderInfo& placeholder : kPlaceholders) names.insert(placeholder.name);
  EXPECT_EQ(names.size(), kPlaceholders.size());
}

}  // namespace prose_test
}  // namespace gjkscope
