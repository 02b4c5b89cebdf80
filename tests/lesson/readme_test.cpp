// Checks that lessons/README.md says what the code does.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "lesson/chapters.hpp"
#include "lesson/load.hpp"
#include "lesson/prose.hpp"
#include "lesson/schema.hpp"
#include "lesson_texts.hpp"
#include "run/run.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace readme_test {

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
  for (const LessonKey& key : vocabulary().keys) {
    rows.push_back(fmt::format("| `{}{}{}` | {} | {} | {} |", key.table,
                               key.table.empty() ? "" : ".", key.key, key.type, key.otherwise,
                               key.meaning));
  }
  EXPECT_EQ(joined(table_under("## Keys")), joined(rows));
}

TEST(Readme, NamesAllThatCanShowSpace) {
  const std::string text = testing::readme();
  const std::size_t begin = text.find("- A lesson is in space");
  ASSERT_NE(begin, std::string::npos);
  const std::string paragraph = text.substr(begin, text.find("\n- ", begin) - begin);
  std::set<std::string> named;
  const std::regex quoted("`([^`]+)`");
  for (std::sregex_iterator each(paragraph.begin(), paragraph.end(), quoted), end; each != end;
       ++each)
    named.insert((*each)[1]);
  std::set<std::string> able = {"axis", "eye"};
  for (const Tour* tour : vocabulary().tours) {
    if (is_shown_of(tour->needs.shown_of, 3)) able.emplace(tour->name);
  }
  for (const auto* terms : {&vocabulary().blocks, &vocabulary().listings, &vocabulary().effects}) {
    for (const Term& term : *terms) {
      if (is_shown_of(term.shown_of, 3)) able.emplace(term.name);
    }
  }
  EXPECT_EQ(named, able);
}

TEST(Readme, ListsEveryPlaceholder) {
  std::vector<std::string> rows;
  for (const PlaceholderInfo& placeholder : kPlaceholders) {
    rows.push_back(fmt::format("| `{{{}}}` | {} |", placeholder.name, placeholder.meaning));
  }
  for (const Tour* each : registered_tours()) {
    for (const PlaceholderInfo& value : each->algorithm->values) {
      rows.push_back(
          fmt::format("| `{{{}}}` | with tour `{}`: {} |", value.name, each->name, value.meaning));
    }
  }
  EXPECT_EQ(joined(table_under("## Placeholders")), joined(rows));
}

TEST(Readme, ListsEveryQuestion) {
  std::vector<std::string> rows;
  for (const Tour* first : registered_tours()) {
    for (const AskInfo& ask : first->asks) {
      std::string tours;
      for (const Tour* each : registered_tours()) {
        if (each->ask(ask.name) == nullptr) continue;
        EXPECT_EQ(ask.meaning, each->ask(ask.name)->meaning);
        tours += (tours.empty() ? "" : ", ") + std::string(each->name);
      }
      const std::string row = fmt::format("| `{}` | {} | {} |", ask.name, tours, ask.meaning);
      if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
    }
  }
  EXPECT_EQ(joined(table_under("## Questions")), joined(rows));
}

TEST(Readme, ListsEveryEffectOfViews) {
  std::vector<std::string> rows;
  for (const EffectInfo* effect : registered_effects()) {
    if (effect->used_by != "view") continue;
    rows.push_back(fmt::format("| `{}` | {} |", effect->name, effect->summary));
  }
  EXPECT_EQ(joined(table_under("## Effects")), joined(rows));
}

TEST(Readme, ListsEveryTourBlockAndListing) {
  const auto row = [](const auto& of) { return fmt::format("| `{}` | {} |", of.name, of.meaning); };
  std::vector<std::string> tours;
  for (const Tour* each : registered_tours()) tours.push_back(row(*each));
  EXPECT_EQ(joined(table_under("## Tour")), joined(tours));
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

TEST(ShippedLessons, AreOfChaptersThatHaveTitles) {
  const std::map<int, std::string> chapters = parse_chapters(
      testing::file_text(testing::lessons_folder().parent_path() / "assets" / "chapters.toml"),
      "chapters.toml");
  for (const auto& file : testing::shipped_lesson_files())
    EXPECT_TRUE(chapters.contains(load_lesson(file, vocabulary()).lesson->chapter)) << file;
}

TEST(Chapters, SayWhereTheirFileIsWrong) {
  const auto problem = [](std::string_view text) {
    try {
      (void)parse_chapters(text, "chapters.toml");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(problem("1 = \"One\"\ntwo = \"Two\""),
            "chapters.toml:2:1: 'two' is no number of a chapter; expected number = \"title\"");
  EXPECT_EQ(problem("1 = 1"),
            "chapters.toml:1:5: chapter 1 has no title; expected number = \"title\"");
  EXPECT_TRUE(problem("1 = ").starts_with("chapters.toml:1:")) << problem("1 = ");
}

/// Each subject hands on what its folder defines, and each table is documented (above, and in
/// `explain`).
TEST(Registries, HoldEveryTourSettingsBlockListingLayerEffectAndDrawerThatIsDefined) {
  namespace fs = std::filesystem;
  const fs::path source = testing::lessons_folder().parent_path() / "src";
  const auto defined = [&](std::string_view kind) {
    const std::regex definition(fmt::format("^const {}\\s+(\\w+::)?k\\w+", kind));
    std::size_t count = 0;
    for (const fs::path& folder : {source / "subjects", source / "run"}) {
      for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".cpp") continue;
        std::ifstream lines(entry.path());
        for (std::string line; std::getline(lines, line);)
          count += std::regex_search(line, definition) ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_EQ(defined("Tour"), registered_tours().size());
  EXPECT_EQ(defined("Block"), registered_blocks().size());
  EXPECT_EQ(defined("Listing"), registered_listings().size());
  EXPECT_EQ(defined("Layer"), registered_layers().size());
  EXPECT_EQ(defined("EffectInfo"), registered_effects().size());
  EXPECT_EQ(defined("SettingsKind"), settings_of(vocabulary().tours).size());

  const auto listed = [](const fs::path& list) {
    const std::regex entry(R"(^[A-Z_]+\((\w+)\)$)");
    std::multiset<std::string> names;
    std::ifstream lines(list);
    for (std::string line; std::getline(lines, line);) {
      std::smatch found;
      if (std::regex_search(line, found, entry)) names.insert(found[1]);
    }
    return names;
  };
  std::multiset<std::string> folders;
  for (const auto& entry : fs::directory_iterator(source / "subjects")) {
    if (entry.is_directory()) folders.insert(entry.path().filename());
  }
  EXPECT_EQ(folders, listed(source / "subjects" / "list.def"));
  const fs::path viewer = source.parent_path() / "viewer";
  std::multiset<std::string> drawers;
  for (const auto& entry : fs::directory_iterator(viewer / "drawers")) {
    if (entry.path().extension() == ".cpp") drawers.insert(entry.path().stem());
  }
  EXPECT_EQ(drawers, listed(viewer / "drawers.def"));
}

/// Arrows go one way: a room of src knows those before it in the table of docs/architecture.md.
TEST(Rooms, KnowOnlyThoseBelowThem) {
  namespace fs = std::filesystem;
  const fs::path source = testing::lessons_folder().parent_path() / "src";
  std::vector<std::string> rooms;
  const std::string text = testing::file_text(source.parent_path() / "docs" / "architecture.md");
  const std::regex row(R"(\n\| `src/(\w+)` \|)");
  for (std::sregex_iterator each(text.begin(), text.end(), row), end; each != end; ++each)
    rooms.push_back((*each)[1]);
  const auto floor_of = [&](const std::string& room) {
    return std::find(rooms.begin(), rooms.end(), room) - rooms.begin();
  };
  const std::regex include("^#include \"(\\w+)/");
  for (const auto& room : fs::directory_iterator(source)) {
    const std::string name = room.path().filename();
    EXPECT_NE(std::find(rooms.begin(), rooms.end(), name), rooms.end()) << name << " has no row";
    for (const auto& file : fs::recursive_directory_iterator(room.path())) {
      if (file.path().extension() != ".hpp" && file.path().extension() != ".cpp") continue;
      std::ifstream lines(file.path());
      for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (!std::regex_search(line, found, include) || !fs::exists(source / found[1].str()))
          continue;
        EXPECT_LE(floor_of(found[1]), floor_of(name)) << file.path() << ": " << line;
      }
    }
  }
}

TEST(ShippedLessons, AllLoad) {
  for (const auto& file : testing::shipped_lesson_files()) {
    for (const Problem& problem : load_lesson(file, vocabulary()).problems)
      ADD_FAILURE() << to_string(problem);
  }
}

}  // namespace readme_test
}  // namespace gjkscope
