// The player of a page as a native program: a request a line on standard input, the answer a line
// on standard output. What a browser answers is compared with this.
// Usage: native-player ASSETS

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "web/player.hpp"

int main(int argc, char** argv) {
  using namespace gjkscope;
  if (argc != 2) return 2;
  const std::filesystem::path assets = argv[1];
  const Fonts fonts(assets / "fonts.toml");
  const auto read = [&](const std::string& name) {
    std::ifstream stream(assets / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  std::map<std::string, std::string> themes;
  for (const std::string& name : Theme::names(assets / "themes"))
    themes[name] = read("themes/" + name + ".toml");
  Player player(faces_of(fonts), std::move(themes), read("terms.toml"));
  for (std::string line; std::getline(std::cin, line);) std::cout << player.answer(line) << '\n';
  return 0;
}
