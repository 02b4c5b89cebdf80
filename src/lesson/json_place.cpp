#include "lesson/json_place.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

namespace gjkscope {
namespace {

[[nodiscard]] bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// One past the string that begins at `at`.
[[nodiscard]] std::size_t skip_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

}  // namespace

std::size_t skip_space(std::string_view text, std::size_t at) {
  while (at < text.size() && is_space(text[at])) ++at;
  return std::min(at, text.size());
}

std::size_t skip_value(std::string_view text, std::size_t at) {
  int depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '"') {
      at = skip_string(text, at);
      if (depth == 0) return at;
      continue;
    }
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') {
      if (--depth <= 0) return depth < 0 ? at : at + 1;
    }
    if (depth == 0 && (is_space(c) || c == ',')) return at;
    ++at;
  }
  return at;
}

std::size_t find_value(std::string_view text, std::size_t at, const JsonPath& path) {
  at = skip_space(text, at);
  for (const std::string& wanted : path) {
    const bool object = at < text.size() && text[at] == '{';
    std::optional<std::size_t> found;
    int index = 0;
    std::size_t next = skip_space(text, at + 1);
    while (next < text.size() && text[next] != '}' && text[next] != ']') {
      std::string key = std::to_string(index++);
      if (object) {
        const std::size_t end = skip_string(text, next);
        key = std::string(text.substr(next + 1, end - next - 2));
        next = skip_space(text, skip_space(text, end) + 1);  // the colon
      }
      if (key == wanted) found = next;  // of repeated keys the last one counts
      next = skip_space(text, skip_value(text, next));
      if (next < text.size() && text[next] == ',') next = skip_space(text, next + 1);
    }
    if (!found) return at;
    at = *found;
  }
  return at;
}

std::optional<double> number_in(const nlohmann::ordered_json& value) {
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return std::nullopt;
  const std::string& text = value.get_ref<const std::string&>();
  const char* begin = text.data();
  const char* end = begin + text.size();
  const bool negative = begin != end && *begin == '-';
  if (begin != end && (*begin == '-' || *begin == '+')) ++begin;
  if (begin == end || *begin == '-') return std::nullopt;
  const bool hex = end - begin > 2 && begin[0] == '0' && (begin[1] == 'x' || begin[1] == 'X');
  if (hex) begin += 2;
  double number = 0.0;
  const auto [stop, error] = std::from_chars(
      begin, end, number, hex ? std::chars_format::hex : std::chars_format::general);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return negative ? -number : number;
}

}  // namespace gjkscope
