#include "command_line.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace gjkscope::test {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Ran run_program(const std::string& arguments, const std::string& input, const std::string& output) {
  const TemporaryFolder folder;
  const std::string in = folder.file("in", input);
  const std::string out = output.empty() ? (folder.path() / "out").string() : output;
  const std::string err = (folder.path() / "err").string();
  const std::string command =
      std::string(GJKSCOPE_BINARY) + " " + arguments + " <" + in + " >" + out + " 2>" + err;
  const int status = std::system(command.c_str());
  Ran ran;
  ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (output.empty()) ran.out = read_file(out);
  ran.err = read_file(err);
  return ran;
}

}  // namespace gjkscope::test
