#include "lesson/prose.hpp"

namespace gjkscope {

std::vector<ProsePart> prose_parts(std::string_view prose) {
  using Kind = ProsePart::Kind;
  std::vector<ProsePart> parts;
  const auto add_text = [&](char c) {
    if (parts.empty() || parts.back().kind != Kind::text) parts.push_back({Kind::text, {}});
    parts.back().text += c;
  };
  std::size_t at = 0;
  while (at < prose.size()) {
    const char c = prose[at];
    if (c != '{' && c != '}') {
      add_text(c);
      ++at;
    } else if (at + 1 < prose.size() && prose[at + 1] == c) {
      add_text(c);
      at += 2;
    } else {
      const std::size_t end = c == '{' ? prose.find_first_of("{}", at + 1) : std::string_view::npos;
      if (end == std::string_view::npos || prose[end] == '{') {
        parts.push_back({Kind::stray_brace, std::string(1, c)});
        ++at;
      } else {
        parts.push_back({Kind::placeholder, std::string(prose.substr(at + 1, end - at - 1))});
        at = end + 1;
      }
    }
  }
  return parts;
}

std::string expand(std::string_view prose, const std::map<std::string, std::string>& values) {
  std::string out;
  for (const ProsePart& part : prose_parts(prose)) {
    if (part.kind != ProsePart::Kind::placeholder) {
      out += part.text;
    } else {
      const auto value = values.find(part.text);
      out += value == values.end() ? std::string(kNoValue) : value->second;
    }
  }
  return out;
}

}  // namespace gjkscope
