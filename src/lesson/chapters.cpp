#include "lesson/chapters.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <charconv>
#include <stdexcept>

namespace gjkscope {

std::optional<int> chapter_number(std::string_view key) {
  int number = 0;
  const auto read = std::from_chars(key.data(), key.data() + key.size(), number);
  if (read.ec != std::errc() || read.ptr != key.data() + key.size()) return std::nullopt;
  return number;
}

std::map<int, std::string> parse_chapters(std::string_view text, std::string_view name) {
  const auto fail = [&](const toml::source_region& at, std::string_view what) {
    throw std::runtime_error(fmt::format("{}:{}:{}: {}; expected number = \"title\"", name,
                                         at.begin.line, at.begin.column, what));
  };
  std::map<int, std::string> chapters;
  try {
    for (const auto& [key, node] : toml::parse(text)) {
      const std::optional<int> number = chapter_number(key.str());
      if (!number) fail(key.source(), fmt::format("'{}' is no number of a chapter", key.str()));
      const toml::value<std::string>* title = node.as_string();
      if (title == nullptr) fail(node.source(), fmt::format("chapter {} has no title", *number));
      chapters[*number] = title->get();
    }
  } catch (const toml::parse_error& error) {
    fail(error.source(), error.description());
  }
  return chapters;
}

}  // namespace gjkscope
