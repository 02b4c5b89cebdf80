#pragma once
// Each table of a lesson file has a function that states its keys, each once: its words, the value
// that holds it, and its bounds. A pass goes over them, and lists, reads or writes the keys.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/names.hpp"
#include "lesson/schema.hpp"
#include "lesson/toml_reader.hpp"
#include "lesson/toml_text.hpp"

namespace gjkscope {

/// A function of this kind states keys: keys("cap", "", "iterations").whole_number(cap, 1, 100).
template <class T>
using KeysOf = void (*)(class KeyPass& keys, T& value);

class KeyPass {
 public:
  using Texts = std::vector<std::string>;

  /// Lists the keys of a table.
  KeyPass(std::string_view table, std::vector<LessonKey>& keys) : name_(table), keys_(&keys) {}
  /// Reads. A value stays where its key is missing or refused; an optional one has none then.
  KeyPass(toml_file::Reader& reader, const toml_file::Table& table, int of_dimension, double most)
      : dimension(of_dimension), largest(most), reader_(&reader), table_(&table) {}
  /// Writes a line for each key, an empty one where it has no value.
  KeyPass(Texts& lines, bool is_fresh, int of_dimension)
      : dimension(of_dimension), lines_(&lines), is_fresh_(is_fresh) {}

  const int dimension = 2;
  const double largest = limits::kLargest;  ///< Bound of the size of coordinates.

  /// The words of the next key: see LessonKey. Empty: `otherwise` is the value of a fresh object,
  /// `type` what the bounds say.
  KeyPass& operator()(std::string_view key, std::string_view otherwise, std::string meaning,
                      std::string type = {});
  /// The next key is written even where it has the value of a fresh object, as required ones are.
  KeyPass& always();

  // The value of the key. For bounds see toml_file::Reader; V is what is read, or optional.
  void text(std::string& value, int longest);
  void long_text(std::string& value, int longest);  ///< Written on several lines where it is long.
  template <class V>
  void number(V& value, double least, double most) {
    std::optional<double> own = value;
    read_number(own, least, most);
    take(own, value);
  }
  template <class V>
  void whole_number(V& value, int least, int most) {
    std::optional<int> own = value;
    read_whole_number(own, least, most);
    take(own, value);
  }
  void yes_or_no(bool& value);
  void point(Eigen::Vector3d& value);
  /// One of the names; messages speak of it as `kind`.
  void name(std::optional<std::string>& value, std::string_view kind, const Texts& known);
  /// V is an enumeration, or optional.
  template <class E, class V>
  void choice(V& value, std::string_view kind) {
    std::optional<E> own = value;
    std::optional<std::string> called;
    if (own) called = name_of(*own);
    name(called, kind, names_of<E>());
    own = called ? value_of<E>(*called) : std::nullopt;
    take(own, value);
  }
  /// Whether to stop on a repeated support point, and on no progress.
  void stop_tests(std::optional<std::array<bool, 2>>& on);
  /// A table of its own, written in braces: `{ height = 2.0 }`.
  template <class T>
  void table(std::optional<T>& value, KeysOf<T> keys);

  // Keys that are read elsewhere. Values and entries are written as they are.
  void other(std::string_view value = {});
  void other_list(const std::optional<Texts>& entries);

 private:
  template <class T>
  static void take(const std::optional<T>& read, std::optional<T>& value) {
    value = read;
  }
  template <class T>
  static void take(const std::optional<T>& read, T& value) {
    value = read.value_or(value);
  }
  void read_number(std::optional<double>& value, double least, double most);
  void read_whole_number(std::optional<int>& value, int least, int most);
  /// Lists or writes the key; the field that it shall be read from, if it shall.
  std::optional<toml_file::Field> key(std::string_view type, std::string_view fresh,
                                      std::string line);

  LessonKey words_;
  bool always_ = false;
  std::string_view name_;
  std::vector<LessonKey>* keys_ = nullptr;
  toml_file::Reader* reader_ = nullptr;
  const toml_file::Table* table_ = nullptr;
  Texts* lines_ = nullptr;
  bool is_fresh_ = false;
};

/// The keys of a table, before others.
template <class T>
[[nodiscard]] std::vector<LessonKey> listed_keys(std::string_view table, KeysOf<T> keys,
                                                 const std::vector<LessonKey>& others = {}) {
  std::vector<LessonKey> out;
  T fresh;
  KeyPass pass(table, out);
  keys(pass, fresh);
  out.insert(out.end(), others.begin(), others.end());
  return out;
}

/// The keys that a file needs to say `value`, as lines: what `fresh` has goes without saying.
template <class T>
[[nodiscard]] std::vector<std::string> written_keys(T value, KeysOf<T> keys, int dimension = 2,
                                                    T fresh = {}) {
  std::vector<std::string> lines;
  std::vector<std::string> usual;
  KeyPass pass(lines, false, dimension);
  keys(pass, value);
  KeyPass fresh_pass(usual, true, dimension);
  keys(fresh_pass, fresh);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == usual[i]) lines[i].clear();
  }
  return lines;
}

template <class T>
void KeyPass::table(std::optional<T>& value, KeysOf<T> keys) {
  const std::string key = words_.key;
  other(value ? in_braces(written_keys(*value, keys, dimension)) : std::string());
  if (table_ == nullptr) return;
  if (const auto inner = reader_->table((*table_)[key], table_->name() + "." + key)) {
    KeyPass pass(*reader_, *inner, dimension, largest);
    keys(pass, value.emplace());
  }
}

}  // namespace gjkscope
