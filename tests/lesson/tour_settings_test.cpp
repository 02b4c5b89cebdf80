// A tour from elsewhere with a table of its own: lesson/ knows neither of them.

#include "lesson/tour_settings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lesson/settings_kind.hpp"
#include "lesson_texts.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace tour_settings_test {

struct Walls {
  int count = 0;
  static const SettingsKind kKind;
  friend bool operator==(const Walls&, const Walls&) = default;
};

struct Doors {
  int count = 0;
  static const SettingsKind kKind;
  friend bool operator==(const Doors&, const Doors&) = default;
};

std::vector<LessonKey> wall_keys() {
  return {{"walls", "count", "whole number from 1 to 9", std::string(kRequired), "how many"}};
}

TourSettings read_walls(const TableSource& source) {
  return TourSettings(Walls{source.reader.whole_number(source.table["count"], 1, 9).value_or(1)});
}

void write_walls(const TourSettings& table, TomlText& out) {
  out.table("[walls]");
  out.key("count", std::to_string(table.as<Walls>()->count));
}

const SettingsKind Walls::kKind = {"walls", "walls to walk along", wall_keys, read_walls,
                                   write_walls};
const SettingsKind Doors::kKind = {"doors", "ways out", {}, {}, {}};

LoadedLesson load(const std::string& tour, const std::string& table) {
  static const Tour kWalk{.name = "walk",
                          .meaning = "wall",
                          .needs = {.settings = &Walls::kKind, .path = PathUse::refused},
                          .algorithm = &kGjkAlgorithm};
  Vocabulary known = vocabulary();
  known.tours.push_back(&kWalk);
  known.keys = lesson_keys(known.tours);
  const std::string steps = fmt::format("steps.tour = \"{}\"\n", tour);
  return parse_lesson(testing::kShortestLesson + steps + table, "walls.toml", known);
}

std::string complaint(const std::string& tour, const std::string& table) {
  const LoadedLesson loaded = load(tour, table);
  return loaded.problems.empty() ? "" : to_string(loaded.problems.front());
}

TEST(TourSettings, OfATourFromElsewhereIsReadAndWritten) {
  const LoadedLesson loaded = load("walk", "[walls]\ncount = 7\n");
  ASSERT_TRUE(loaded.lesson) << to_string(loaded.problems.front());
  ASSERT_NE(loaded.lesson->settings.as<Walls>(), nullptr);
  EXPECT_EQ(loaded.lesson->settings.as<Walls>()->count, 7);
  EXPECT_EQ(loaded.lesson->settings.as<Doors>(), nullptr);
  EXPECT_NE(lesson_toml(*loaded.lesson).find("\n[walls]\ncount = 7\n"), std::string::npos);
}

TEST(TourSettings, IsRefusedWhereItIsWrong) {
  EXPECT_EQ(complaint("walk", "[walls]\ncount = 10\n"),
            "walls.toml:11:9: 'count' is 10; expected whole number from 1 to 9");
  EXPECT_EQ(complaint("walk", "[walls]\n"),
            "walls.toml:10:1: missing key 'count'; expected whole number from 1 to 9");
  EXPECT_EQ(complaint("walk", "walls = { count = 1, colour = 2 }\n"),
            "walls.toml:10:22: unknown key 'colour'; expected one of: count");
  EXPECT_EQ(complaint("walk", "walls = 4\n"),
            "walls.toml:10:9: 'walls' is a number; expected table [walls]");
  EXPECT_EQ(complaint("walk", ""),
            "walls.toml:9:14: tour 'walk' without its table; expected a table [walls]");
  EXPECT_EQ(complaint("phase", "[walls]\ncount = 7\n"),
            "walls.toml:10:1: a table [walls] without tour 'walk'; expected tour = "
            "\"walk\" in [steps]");
  EXPECT_EQ(complaint("walk", "[walls]\ncount = 7\n[path]\npoints = [[0, 0], [1, 1]]\n"),
            "walls.toml:9:14: tour 'walk' with a path; expected no table [path]");
}

TEST(TourSettings, IsReadWhateverTheTourIs) {
  const LoadedLesson loaded = load("wlak", "[walls]\ncount = 10\n");
  ASSERT_EQ(loaded.problems.size(), 2u) << "nobody knows whether the tour takes it";
  EXPECT_TRUE(loaded.problems[0].what.starts_with("unknown tour 'wlak'"));
  EXPECT_EQ(loaded.problems[1].what, "'count' is 10");
}

TEST(TourSettings, IsSharedUntilOneIsEdited) {
  TourSettings one{Walls{3}};
  TourSettings other = one;
  EXPECT_EQ(one.as<Walls>(), other.as<Walls>());
  Walls& edited = other.edit<Walls>();
  edited.count = 4;
  EXPECT_EQ(one.as<Walls>()->count, 3);
  EXPECT_EQ(other.as<Walls>()->count, 4);
}

TEST(TourSettings, IsTheSameWithTheSameValueAndFile) {
  const TourSettings three{Walls{3}};
  EXPECT_EQ(three, TourSettings(Walls{3}));
  EXPECT_NE(three, TourSettings(Walls{4}));
  EXPECT_NE(three, TourSettings(Doors{3}));
  EXPECT_NE(three, TourSettings());
  EXPECT_EQ(TourSettings(), TourSettings());
  TourSettings with_file = three;
  with_file.file = {"a.json", nullptr};
  EXPECT_NE(three, with_file);
  TourSettings elsewhere = with_file;
  EXPECT_EQ(elsewhere, with_file);
  elsewhere.file->path = "b.json";
  EXPECT_NE(elsewhere, with_file);
}

}  // namespace tour_settings_test
}  // namespace gjkscope
