#pragma once
// Settings that only some tours take, a table of the file, as this folder knows them. They stand
// with their subjects.

#include <filesystem>
#include <string_view>
#include <vector>

#include "base/file.hpp"
#include "lesson/key_pass.hpp"
#include "lesson/lesson.hpp"
#include "lesson/schema.hpp"
#include "lesson/toml_reader.hpp"
#include "lesson/toml_text.hpp"

namespace gjkscope {

/// Everything that a table is read from.
struct TableSource {
  const toml_file::Table& table;
  Place place;  ///< The place of the table.
  toml_file::Reader& reader;
  toml_file::Problems& problems;
  const Lesson& lesson;                 ///< Its shapes, query and path have been read.
  const std::filesystem::path& folder;  ///< The lesson's folder.
  const FileReader& read_file;          ///< Use this one: a page has its files in memory.
  /// Reads the keys of `of`, the table or one in it.
  template <class T>
  void read_keys(const toml_file::Table& of, KeysOf<T> keys, T& value) const {
    KeyPass pass(reader, of, lesson.dimension, limits::kLargest);
    keys(pass, value);
  }
};

/// A tour names the one that it takes (TourNeeds::settings).
struct SettingsKind {
  std::string_view name;     ///< "growth": it is written [growth].
  std::string_view meaning;  ///< The content of the table, in words.
  /// Those of [growth] and of the tables in it: LessonKey::table is "growth", "growth.times".
  /// The key `growth` itself comes from lesson_keys.
  std::vector<LessonKey> (*keys)();
  /// Reports every problem. What it returns counts only where there is none.
  TourSettings (*read)(const TableSource& source);
  void (*write)(const TourSettings& table, TomlText& out);
};

}  // namespace gjkscope
