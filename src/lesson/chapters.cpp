#include "lesson/chapters.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <charconv>
#include <stdexcept>

namespace gjkscope {

std::map<int, std::string> parse_chapters(std::string_view text, std::string_view name) {
  const auto fail = [&](const toml::source_region& at, std::string_view what) {
    throw std::runtime_error(fmt::format("{}:{}:{}: {}; expected number = \"title\"", name,
                                         at.begin.line, at.begin.column, what));
  };
  std::map<int, std::string> chapters;
  try {
    for (const auto& [key, node] : toml::parse(text)) {
      int number = 0;
      const std::string_view digits = key.str();
      const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
      if (read.ec != std::errc() || read.ptr != digits.data() + digits.size())
        fail(key.source(), fmt::format("'{}' is no number of a chapter", digits));
      const toml::value<std::string>* title = node.as_string();
      if (title == nullptr) fail(node.source(), fmt::format("chapter {} has no title", number));
      chapters[number] = title->get();
    }
  } catch (const toml::parse_error& error) {
    fail(error.source(), error.description());
  }
  return chapters;
}

}  // namespace gjkscope
