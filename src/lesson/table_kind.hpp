#pragma once
// A table of lesson files that single acts take, as this folder sees it. Those there are stand in
// src/tables.

#include <filesystem>
#include <string_view>
#include <vector>

#include "lesson/file.hpp"
#include "lesson/lesson.hpp"
#include "lesson/schema.hpp"
#include "lesson/toml_reader.hpp"
#include "lesson/toml_text.hpp"

namespace gjkscope {

/// What a table is read from.
struct TableSource {
  const toml_file::Table& table;
  Place place;  ///< Of the table.
  toml_file::Reader& reader;
  toml_file::Problems& problems;
  const Lesson& lesson;                 ///< Its shapes, query and path have been read.
  const std::filesystem::path& folder;  ///< That of the lesson.
  const FileReader& read_file;
};

/// An act names the one that it takes (ActNeeds::table).
struct TableKind {
  std::string_view name;             ///< "growth": it is written [growth].
  std::string_view meaning;          ///< What it holds.
  std::vector<LessonKey> (*keys)();  ///< Those of the table and of tables in it.
  /// The table, though it has problems: these are reported.
  ActTable (*read)(const TableSource& source);
  void (*write)(const ActTable& table, TomlText& out);
  bool is_optional = false;  ///< Its keys have defaults; without it Lesson::table is empty.
};

}  // namespace gjkscope
