#pragma once
// Writes TOML in the layout of lessons/: key by key, lists and long texts on lines of one width.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lesson/names.hpp"

namespace gjkscope {

/// A text in quotes.
[[nodiscard]] std::string as_text(std::string_view text);
[[nodiscard]] std::vector<std::string> as_texts(const std::vector<std::string>& texts);

/// "1.0", "2.0"
[[nodiscard]] std::vector<std::string> as_texts(const std::vector<double>& numbers);
[[nodiscard]] std::vector<std::string> as_texts(const std::vector<int>& numbers);
/// "[1.0, 2.0]"; of dimension 3 "[1.0, 2.0, 3.0]".
[[nodiscard]] std::string in_brackets(const Eigen::Vector3d& point, int dimension);
[[nodiscard]] std::string in_brackets(const std::vector<double>& numbers);
[[nodiscard]] std::vector<std::string> as_texts(const std::vector<Eigen::Vector3d>& points,
                                                int dimension);

/// "cap = 5\n". `value` is written as it is.
[[nodiscard]] std::string key_line(std::string_view key, std::string_view value);
/// On one line where it fits. `entries` are written as they are.
[[nodiscard]] std::string list_line(std::string_view key, const std::vector<std::string>& entries);
/// On one line where it fits, else filled lines that each end with a backslash.
[[nodiscard]] std::string long_text_line(std::string_view key, std::string_view text);
/// "{ height = 2.0, stretch = 3.0 }" of such lines of keys.
[[nodiscard]] std::string in_braces(const std::vector<std::string>& lines);

/// The text of a file, table by table.
class TomlText {
 public:
  /// The table that the next keys belong to; without any it is not written.
  void table(std::string_view header) { header_ = header; }
  /// The header of the table that was begun, though it has no keys.
  void write_header();
  /// `value` is written as it is.
  void key(std::string_view name, std::string_view value) { lines({key_line(name, value)}); }
  /// As key_line and the like have them.
  void lines(const std::vector<std::string>& lines);
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
  std::string header_;
};

}  // namespace gjkscope
