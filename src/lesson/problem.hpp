#pragma once
// A problem in a file: what is wrong, where, and what was expected.

#include <compare>
#include <string>
#include <string_view>
#include <vector>

namespace gjkscope {

/// A place in a file. Columns count characters, not bytes.
struct Place {
  int line = 1;    ///< From 1.
  int column = 1;  ///< From 1.
  friend auto operator<=>(const Place&, const Place&) = default;
};

/// Whether a byte of a UTF-8 text starts a character: all do but those that continue one.
[[nodiscard]] constexpr bool starts_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}
/// Number of characters of a UTF-8 text.
[[nodiscard]] int character_count(std::string_view utf8);

struct Problem {
  std::string file;
  int line = 1;          ///< From 1.
  int column = 1;        ///< From 1.
  std::string what;      ///< "unknown key 'vertice'"
  std::string expected;  ///< "one of: names, vertices, translate, rotate"; may be empty.
  std::string nearest;   ///< "vertices": the nearest known name; may be empty.
};

/// "file:line:column: what; expected ...; did you mean 'nearest'?"
[[nodiscard]] std::string to_string(const Problem& problem);
/// One a line.
[[nodiscard]] std::string to_string(const std::vector<Problem>& problems);
/// One of them, the first that has a nearest name if any has, for a line of a window: what helps
/// comes first, the file is without its folder, and what was expected is there where it is short.
/// Empty without problems.
[[nodiscard]] std::string in_one_line(const std::vector<Problem>& problems);

/// The known name with the smallest edit distance, if that is small enough to be a slip of the
/// fingers (a third of the longer name); else empty. Letter case and `_` for `-` count nothing.
[[nodiscard]] std::string nearest_name(std::string_view name,
                                       const std::vector<std::string>& known);

}  // namespace gjkscope
