#pragma once
// Claims that the targets make about their input.

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "lesson/problem.hpp"

namespace gjkscope::fuzz {

/// Ends the program where a claim does not hold: that is how libFuzzer knows.
inline void claim(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "It does not hold that %s\n", what.c_str());
  std::abort();
}

/// A problem says something about a place of the file, at most one character behind a line's end.
inline void claim_located(const Problem& problem, std::string_view file) {
  const std::string text = to_string(problem);
  claim(!problem.what.empty(), "a problem says what is wrong: " + text);
  claim(problem.line >= 1 && problem.column >= 1, "places count from 1: " + text);
  for (int line = 1; line < problem.line; ++line) {
    const std::size_t end = file.find('\n');
    claim(end != std::string_view::npos, "the file has the line of " + text);
    file.remove_prefix(end + 1);
  }
  const std::string_view line = file.substr(0, file.find('\n'));
  claim(problem.column <= character_count(line) + 1, "the line has the column of " + text);
}

}  // namespace gjkscope::fuzz
