// What lessons/README.md says is what the code does.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/run.hpp"
#include "lesson/schema.hpp"
#include "lesson_texts.hpp"
#include "picture/registry.hpp"

namespace gjkscope {
namespace {

/// The rows of the table under a heading, without its two head lines.
std::vector<std::string> table_under(const std::string& heading) {
  std::istringstream in(testing::readme());
  std::vector<std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) {
      inside = line == heading;
    } else if (inside && line.starts_with("|")) {
      rows.push_back(line);
    }
  }
  if (rows.size() >= 2) rows.erase(rows.begin(), rows.begin() + 2);
  return rows;
}

std::string joined(const std::vector<std::string>& rows) {
  std::string out;
  for (const std::string& row : rows) out += row + "\n";
  return out;
}

TEST(Readme, ListsEveryKey) {
  std::vector<std::string> rows;
  for (const LessonKey& key : lesson_keys()) {
    rows.push_back(fmt::format("| `{}{}{}` | {} | {} | {} |", key.table,
                               key.table.empty() ? "" : ".", key.key, key.type, key.otherwise,
                               key.meaning));
  }
  EXPECT_EQ(joined(table_under("## Keys")), joined(rows));
}

TEST(Readme, ListsEveryPlaceholder) {
  std::vector<std::string> rows;
  for (const PlaceholderInfo& placeholder : kPlaceholders) {
    rows.push_back(fmt::format("| `{{{}}}` | {} |", placeholder.name, placeholder.meaning));
  }
  EXPECT_EQ(joined(table_under("## Placeholders")), joined(rows));
}

TEST(Readme, ListsEveryEffectOfViews) {
  std::vector<std::string> rows;
  for (const EffectInfo& effect : registered_effects()) {
    if (effect.used_by != "view") continue;
    rows.push_back(fmt::format("| `{}` | {} |", effect.name, effect.summary));
  }
  EXPECT_EQ(joined(table_under("## Effects")), joined(rows));
}

TEST(Readme, ListsEveryGranularityBlockAndListing) {
  const auto row = [](const auto& of) { return fmt::format("| `{}` | {} |", of.name, of.meaning); };
  std::vector<std::string> acts;
  for (const StagedAct* each : registered_acts()) acts.push_back(row(each->act));
  EXPECT_EQ(joined(table_under("## Granularity")), joined(acts));
  std::vector<std::string> blocks;
  for (const Block* each : registered_blocks()) blocks.push_back(row(*each));
  EXPECT_EQ(joined(table_under("## Panel blocks")), joined(blocks));
  std::vector<std::string> rows;
  for (const Listing* each : registered_listings()) rows.push_back(row(*each));
  EXPECT_EQ(joined(table_under("## Listings")), joined(rows));
}

TEST(Readme, TheExampleIsALessonThatKeepsItsWord) {
  const LoadedLesson loaded = parse_lesson(testing::readme_example(), "example.toml", vocabulary());
  for (const Problem& problem : loaded.problems) ADD_FAILURE() << to_string(problem);
  ASSERT_TRUE(loaded.lesson);
  const LessonRun run = run_lesson(*loaded.lesson);
  EXPECT_GT(run.frames.size(), 1u);
  for (const Problem& problem : check_expectation(run)) ADD_FAILURE() << to_string(problem);
}

TEST(ShippedLessons, AllLoad) {
  for (const auto& file : testing::shipped_lessons()) {
    for (const Problem& problem : load_lesson(file, vocabulary()).problems)
      ADD_FAILURE() << to_string(problem);
  }
}

}  // namespace
}  // namespace gjkscope
