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

/// "[1.0, 2.0]"; of dimension 3 "[1.0, 2.0, 3.0]".
[[nodiscard]] std::string in_brackets(const Eigen::Vector3d& point, int dimension);
[[nodiscard]] std::string in_brackets(const std::vector<double>& numbers);

/// 0.0 and -0.0 differ.
[[nodiscard]] bool same_bits(double a, double b);

/// The text of a file, key by key.
class TomlText {
 public:
  /// The table that the next keys belong to; without any it is not written.
  void table(std::string_view header) { header_ = header; }
  /// The header of the table that was begun, though it has no keys.
  void write_header();

  /// `value` is written as it is.
  void key(std::string_view name, std::string_view value);
  /// On one line where it fits. `entries` are written as they are.
  void list(std::string_view name, const std::vector<std::string>& entries);
  void list(std::string_view name, const std::vector<double>& numbers);
  void list(std::string_view name, const std::vector<int>& numbers);
  void list(std::string_view name, const std::vector<Eigen::Vector3d>& points, int dimension);
  /// On one line where it fits, else filled lines that each end with a backslash.
  void long_text(std::string_view name, std::string_view text);

  // These are left out where the value is `otherwise`.
  template <class E>
  void choice(std::string_view name, E value, E otherwise) {
    if (value != otherwise) key(name, as_text(name_of(value)));
  }
  void number(std::string_view name, double value, double otherwise);
  void whole_number(std::string_view name, int value, int otherwise);
  void text(std::string_view name, std::string_view value, std::string_view otherwise);

  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
  std::string header_;
};

}  // namespace gjkscope
