#pragma once
// Runs the gjkscope program as a user would, and commands in this process with streams of ours.

#include <filesystem>
#include <string>
#include <vector>

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

/// A folder that goes away with the value.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  /// Writes a file into it and gives its path.
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string read_file(const std::filesystem::path& file);
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

}  // namespace gjkscope::test
