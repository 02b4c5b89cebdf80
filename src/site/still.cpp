#include "site/still.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>

namespace gjkscope {
namespace {

/// A mark as an element; `style` is what its neighbours may share.
struct Element {
  std::string begin;  ///< Its name, and the attributes that are its own.
  std::string style;
  std::string end;
};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// A number of tenths after another one, with no character that SVG can do without.
std::string tenths(long value, bool first) {
  const char* const sign = value < 0 ? "-" : first ? "" : " ";
  const long whole = std::labs(value) / 10;
  const long rest = std::labs(value) % 10;
  if (rest == 0) return fmt::format("{}{}", sign, whole);
  return whole == 0 ? fmt::format("{}.{}", sign, rest) : fmt::format("{}{}.{}", sign, whole, rest);
}

/// An outline "M1 2L3 4...Z" with each point relative to the one before; errors do not add up.
std::string relative(std::string_view path) {
  std::string out;
  std::array<long, 2> last{};
  bool first = true;
  while (!path.empty() && path.front() != 'Z') {
    path.remove_prefix(1);  // M or L
    std::array<long, 2> at{};
    for (long& each : at) {
      if (path.front() == ' ') path.remove_prefix(1);
      double value = 0.0;
      const auto [end, error] = std::from_chars(path.data(), path.data() + path.size(), value);
      path.remove_prefix(static_cast<std::size_t>(end - path.data()));
      each = std::lround(10.0 * value);
    }
    if (out.empty()) {
      out = "M" + tenths(at[0], true) + tenths(at[1], false);
    } else {
      if (first) out += 'l';
      out += tenths(at[0] - last[0], first) + tenths(at[1] - last[1], false);
      first = false;
    }
    last = at;
  }
  return path.empty() ? out : out + "z";
}

/// None where the line is no mark, or the mark draws nothing (`invisible`).
std::optional<Element> parsed(std::string_view line, bool& invisible) {
  const std::size_t name_end = line.find(' ');
  if (name_end == std::string_view::npos || line.front() != '<') return {};
  if (!is_one_of(line.substr(1, name_end - 1), {"path", "circle", "rect", "text"})) return {};
  Element element{std::string(line.substr(0, name_end)), {}, {}};
  line.remove_prefix(name_end);
  while (!line.empty() && line.front() == ' ') {
    const std::size_t equals = line.find("=\"");
    const std::size_t close = line.find('"', equals + 2);
    const std::string_view name = line.substr(1, equals - 1);
    const std::string_view value = line.substr(equals + 2, close - equals - 2);
    const std::string_view whole = line.substr(0, close + 1);
    if (name == "d") {
      element.begin += fmt::format(" d=\"{}\"", relative(value));
    } else if (is_one_of(name,
                         {"x", "y", "cx", "cy", "r", "rx", "width", "height", "textLength"}) ||
               (name == "data-of" && (value.starts_with("x ") || value.starts_with("y ")))) {
      element.begin += whole;
    } else if (!name.starts_with("data-")) {
      element.style += whole;
    }
    line.remove_prefix(close + 1);
  }
  element.end = line;
  invisible = element.style.find(" fill=\"none\"") != std::string::npos &&
              element.style.find(" stroke=") == std::string::npos;
  return element;
}

}  // namespace

std::string still(std::string_view svg) {
  std::string out;
  std::vector<Element> alike;
  const auto put_alike = [&] {
    const bool several = alike.size() > 1;
    if (several) out += fmt::format("<g{}>\n", alike.front().style);
    for (const Element& element : alike)
      out += fmt::format("{}{}{}\n", element.begin, several ? "" : element.style, element.end);
    if (several) out += "</g>\n";
    alike.clear();
  };
  while (!svg.empty()) {
    const std::size_t end = std::min(svg.find('\n'), svg.size() - 1);
    const std::string_view line = svg.substr(0, svg[end] == '\n' ? end : end + 1);
    svg.remove_prefix(end + 1);
    bool invisible = false;
    const std::optional<Element> element = parsed(line, invisible);
    if (invisible) continue;
    if (!element || (!alike.empty() && alike.front().style != element->style)) put_alike();
    if (element) {
      alike.push_back(*element);
    } else {
      out += fmt::format("{}\n", line);
    }
  }
  put_alike();
  // The page's style sheet has it; strict policies take none inside.
  const std::size_t style = out.find(" style=\"");
  if (style != std::string::npos) out.erase(style, out.find('"', style + 8) + 1 - style);
  return out;
}

}  // namespace gjkscope
