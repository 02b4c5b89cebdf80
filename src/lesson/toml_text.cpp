#include "lesson/toml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/decimal.hpp"
#include "lesson/problem.hpp"

namespace gjkscope {
namespace {

constexpr int kWidth = 120;  // characters of a line that can be broken
constexpr std::string_view kIndent = "    ";

/// The text as it stands between the quotes.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\u{:04X}", byte);
    } else {
      out += c;
    }
  }
  return out;
}

/// True when a line of TOML's long texts may begin with `c`. Parsers skip what they take for a
/// blank: ' ' and, some of them, Unicode's, which are in the ranges left out here.
bool may_begin_line(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte > ' ' && byte < 0x80) || (byte >= 0xC3 && byte < 0xE0);
}

bool fits(std::string_view name, std::string_view value) {
  return character_count(name) + character_count(" = ") + character_count(value) <= kWidth;
}

template <class T, class Text>
std::vector<std::string> texts_of(const std::vector<T>& values, Text text) {
  std::vector<std::string> out;
  for (const T& value : values) out.push_back(text(value));
  return out;
}

}  // namespace

std::string as_text(std::string_view text) { return '"' + escaped(text) + '"'; }

std::vector<std::string> as_texts(const std::vector<std::string>& texts) {
  return texts_of(texts, as_text);
}

std::string in_brackets(const Eigen::Vector3d& point, int dimension) {
  return in_brackets(std::vector<double>(point.data(), point.data() + dimension));
}

std::string in_brackets(const std::vector<double>& numbers) {
  return fmt::format("[{}]", fmt::join(texts_of(numbers, decimal), ", "));
}

std::vector<std::string> as_texts(const std::vector<double>& numbers) {
  return texts_of(numbers, decimal);
}

std::vector<std::string> as_texts(const std::vector<int>& numbers) {
  return texts_of(numbers, [](int number) { return std::to_string(number); });
}

std::vector<std::string> as_texts(const std::vector<Eigen::Vector3d>& points, int dimension) {
  return texts_of(points,
                  [&](const Eigen::Vector3d& point) { return in_brackets(point, dimension); });
}

std::string key_line(std::string_view key, std::string_view value) {
  return fmt::format("{} = {}\n", key, value);
}

std::string list_line(std::string_view key, const std::vector<std::string>& entries) {
  const std::string one_line = fmt::format("[{}]", fmt::join(entries, ", "));
  if (fits(key, one_line)) return key_line(key, one_line);
  std::string lines = "[";
  int width = kWidth;
  for (const std::string& entry : entries) {
    width += character_count(" ,") + character_count(entry);
    if (width > kWidth) {
      lines += fmt::format("\n{}", kIndent);
      width = character_count(kIndent) + character_count(entry) + 1;
    } else {
      lines += ' ';
    }
    lines += entry + ",";
  }
  return key_line(key, lines + "\n]");
}

std::string long_text_line(std::string_view key, std::string_view text) {
  const std::string short_form = as_text(text);
  if (fits(key, short_form) || !may_begin_line(text.front())) return key_line(key, short_form);
  std::string lines = "\"\"\"";
  int width = kWidth;
  while (!text.empty()) {
    std::size_t end = 1;  // of a word and the blanks behind it
    while (end < text.size() && !(text[end - 1] == ' ' && may_begin_line(text[end]))) ++end;
    const std::string word = escaped(text.substr(0, end));
    text.remove_prefix(end);
    width += character_count(word);
    if (width >= kWidth) {
      lines += fmt::format("\\\n{}", kIndent);
      width = character_count(kIndent) + character_count(word);
    }
    lines += word;
  }
  return key_line(key, lines + "\"\"\"");
}

std::string in_braces(const std::vector<std::string>& lines) {
  std::string keys;
  for (const std::string& line : lines) {
    if (line.empty()) continue;
    keys += (keys.empty() ? "" : ", ") + line.substr(0, line.find('\n'));
  }
  return fmt::format("{{ {} }}", keys);
}

void TomlText::write_header() {
  if (!header_.empty()) text_ += fmt::format("\n{}\n", header_);
  header_.clear();
}

void TomlText::lines(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (!line.empty()) write_header();
    text_ += line;
  }
}

}  // namespace gjkscope
