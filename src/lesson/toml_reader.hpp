#pragma once
// Reads TOML values against the keys of lesson files and collects what is wrong with them, each
// with its place. Whoever refuses a value reports it; a required key that is missing was reported.

#include <toml++/toml.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lesson/names.hpp"
#include "lesson/problem.hpp"
#include "lesson/schema.hpp"

namespace gjkscope::toml_file {

/// At least 1, 1, whatever the parser says.
[[nodiscard]] Place place_at(const toml::source_position& position);

/// A value of the file; absent where the key is missing or its value was refused already.
struct Field {
  const toml::node* node = nullptr;
  std::string label;     ///< The name that messages use: "'vertices', entry 3".
  std::string expected;  ///< A description of the value that it should be.

  explicit operator bool() const { return node != nullptr; }
  [[nodiscard]] Place place() const;
};

inline constexpr int kMostProblems = 100;

/// The problems of one file.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  void add(Place place, std::string what, std::string expected = {}, std::string nearest = {});
  void add(const Field& field, std::string what) {
    add(field.place(), std::move(what), field.expected);
  }
  /// "unknown effect 'historry'", with the nearest of the known names.
  void add_unknown(const Field& field, std::string_view kind, std::string_view name,
                   const std::vector<std::string>& known);
  [[nodiscard]] bool empty() const { return problems_.empty(); }
  /// In order of place; after kMostProblems, one that says how many more there are.
  [[nodiscard]] std::vector<Problem> sorted() const;

 private:
  std::string file_;
  std::vector<Problem> problems_;
};

/// A name as messages quote it: in quotes, control characters replaced, long ones cut.
[[nodiscard]] std::string in_quotes(std::string_view name);

/// A table of the file. Opening it reports unknown and missing keys.
class Table {
 public:
  /// `name`: that of LessonKey::table.
  Table(const toml::table& table, std::string_view name, const std::vector<LessonKey>& keys,
        Problems& problems);
  /// One of its LessonKeys; absent where the file does not have it.
  [[nodiscard]] Field operator[](std::string_view key) const;
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  const toml::table& table_;
  std::string name_;
  const std::vector<LessonKey>& keys_;
};

class Reader {
 public:
  /// `keys`: all that a file may have.
  Reader(const std::vector<LessonKey>& keys, Problems& problems)
      : keys_(keys), problems_(problems) {}

  /// The table, if the field is there and is one.
  std::optional<Table> table(const Field& field, std::string_view name);
  /// The entries of a list, each expected to be `expected`; empty if the field is not there.
  std::vector<Field> entries(const Field& field, std::string_view expected);

  /// The values of a table whose keys are among `known`.
  std::vector<std::pair<std::string, Field>> named_entries(const Field& field,
                                                           const std::vector<std::string>& known);

  /// One line of 1 to `longest` characters.
  std::optional<std::string> text(const Field& field, int longest);
  /// A finite number within the bounds; text may hold a hexadecimal one.
  std::optional<double> number(const Field& field, double least, double most);
  std::optional<int> whole_number(const Field& field, int least, int most);
  std::optional<bool> yes_or_no(const Field& field);
  /// A point of 2 or 3 coordinates, which are at most `largest` in size; in the plane z = 0.
  std::optional<Eigen::Vector3d> point(const Field& field, double largest, int dimension);
  /// One of the known names, of which messages speak as "unknown `kind`".
  std::optional<std::string> name(const Field& field, std::string_view kind,
                                  const std::vector<std::string>& known);
  template <class E>
  std::optional<E> choice(const Field& field, std::string_view kind) {
    const std::optional<std::string> found = name(field, kind, names_of<E>());
    return found ? value_of<E>(*found) : std::nullopt;
  }

 private:
  void wrong_type(const Field& field);
  const std::vector<LessonKey>& keys_;
  Problems& problems_;
};

/// The place of the first dotted key that is too deep to be parsed safely: the parser builds and
/// destroys one nested table for each part, on the stack.
[[nodiscard]] std::optional<Place> too_deep_key(std::string_view toml);
inline constexpr int kDeepestKey = 16;

}  // namespace gjkscope::toml_file
