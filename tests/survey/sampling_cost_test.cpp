#include "survey/sampling_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "lessons.hpp"

namespace gjkscope {
namespace sampling_cost_test {

const std::filesystem::path kAssets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";

TEST(SamplingCost, MoreSamplesErrLess) {
  const Fonts fonts(kAssets / "fonts.toml");
  SamplingStudy study(fonts, Theme::load(kAssets / "themes", "light"));
  const Lesson lesson = testing::shipped_lesson("polygons-gjk");
  const std::vector<SamplingCost> rows = study.costs(lesson, 2);
  ASSERT_EQ(rows.size(), 3u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].factor, 1 << i);
    EXPECT_EQ(rows[i].repetitions, 2);
    EXPECT_GT(rows[i].ns.median, 0.0);
    EXPECT_LE(rows[i].rms, rows[i].largest);
    if (i == 0) continue;
    EXPECT_LT(rows[i].rms, rows[i - 1].rms);
    EXPECT_LE(rows[i].seen, rows[i - 1].seen);
  }
  EXPECT_GT(rows.back().rms, 0.0) << "four samples are not sixteen";
  EXPECT_TRUE(study.costs(lesson, 2, [] { return false; }).empty());

  const std::string csv = sampling_csv(rows);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_NE(sampling_table(rows).find("polygons-gjk"), std::string::npos);
  EXPECT_EQ(sampling_table({}), "Nothing was measured.\n");
}

}  // namespace sampling_cost_test
}  // namespace gjkscope
