#pragma once
// Runs the gjkscope program as a user would, and commands in this process with streams of ours.

#include <filesystem>
#include <string>
#include <vector>

#include "temporary_folder.hpp"

namespace gjkscope::test {

struct Ran {
  int exit_code = -1;  ///< 128 + n when signal n ended it.
  std::string out;
  std::string err;
};

/// `arguments` after the name of the program, as in a shell: "solve - --json". The standard output
/// goes to `output` when that is given.
[[nodiscard]] Ran run_program(const std::string& arguments, const std::string& input = "",
                              const std::string& output = "");

[[nodiscard]] std::string read_file(const std::filesystem::path& file);
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

}  // namespace gjkscope::test
