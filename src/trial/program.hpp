#pragma once
// A program that answers cases: one a line to its standard input, one answer a line from its
// standard output.

#include <string>
#include <vector>

namespace gjkscope::judging {

/// A program's reply to a case.
struct Reply {
  enum class Kind { answered, silent, crashed, not_asked };
  Kind kind = Kind::not_asked;
  std::string line;  ///< The answer; after a crash, how the program ended.
};

struct Patience {
  double seconds = 5;    ///< Without an answer; then a program is silent.
  int most_faults = 10;  ///< Crashes and silences of one call; then it is not asked on.
  bool is_loud = true;   ///< Its standard error is shown, until it fails.
};

/// Asks `command`, which a shell runs, all cases at once. If the program ends early or falls
/// silent, only the answer to that case is lost: the program is started again for the next one. A
/// program may hold back answers until it ends, so the case at fault is found by asking one at a
/// time. A program that answers none of the first three cases is not asked further.
[[nodiscard]] std::vector<Reply> ask(const std::string& command,
                                     const std::vector<std::string>& cases,
                                     const Patience& patience = {});

}  // namespace gjkscope::judging
