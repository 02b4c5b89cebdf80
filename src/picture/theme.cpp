#include "picture/theme.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "base/file.hpp"

namespace gjkscope {
namespace {

[[noreturn]] void fail(const toml::source_region& source, const std::string& what) {
  throw std::runtime_error(fmt::format("{}:{}:{}: {}", source.path ? *source.path : "theme",
                                       source.begin.line, source.begin.column, what));
}

Color parse_hex(std::string_view text, const toml::source_region& source) {
  const std::string_view digits = text.substr(1);
  std::uint32_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  const bool whole = error == std::errc{} && end == digits.data() + digits.size();
  if (!whole || (digits.size() != 6 && digits.size() != 8)) {
    fail(source, fmt::format(R"("{}" is no colour; expected "#rrggbb" or "#rrggbbaa")", text));
  }
  if (digits.size() == 6) value = (value << 8) | 0xFF;
  return {static_cast<std::uint8_t>(value >> 24), static_cast<std::uint8_t>(value >> 16),
          static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
}

/// Resolves the files of a theme, its base first: of two entries with one name the later wins.
class Reader {
 public:
  explicit Reader(const std::vector<toml::table>& files) {
    for (const toml::table& file : files) read_palette(file);
    for (const toml::table& file : files) read_roles(file);
    const auto background = styles_.find("background");
    if (background == styles_.end() || !background->second.fill) {
      fail(files.back().source(), "expected a role \"background\" with a fill");
    }
    background_ = *background->second.fill;
  }

  [[nodiscard]] Color background() const { return background_; }
  [[nodiscard]] std::map<std::string, Style, std::less<>> styles() && { return std::move(styles_); }

 private:
  void read_palette(const toml::table& file) {
    for (const auto& [key, node] : sub_table(file, "palette")) {
      const auto text = node.value<std::string>();
      if (!text || text->empty() || text->front() != '#') {
        fail(node.source(), "expected a colour \"#rrggbb\" or \"#rrggbbaa\"");
      }
      palette_.insert_or_assign(std::string(key.str()), parse_hex(*text, node.source()));
    }
  }

  void read_roles(const toml::table& file) {
    for (const auto& [key, node] : sub_table(file, "roles")) {
      const toml::table* entry = node.as_table();
      if (!entry) fail(node.source(), "expected a role's style, as in { fill = \"ink\" }");
      styles_.insert_or_assign(std::string(key.str()), style(*entry));
    }
  }

  /// Empty when there is none.
  static const toml::table& sub_table(const toml::table& file, std::string_view key) {
    static const toml::table none;
    const toml::node* node = file.get(key);
    if (!node) return none;
    if (!node->is_table()) fail(node->source(), fmt::format("expected a table [{}]", key));
    return *node->as_table();
  }

  [[nodiscard]] Style style(const toml::table& entry) const {
    Style style;
    for (const auto& [key, node] : entry) {
      if (key == "fill") {
        style.fill = color(node);
      } else if (key == "stroke") {
        style.stroke = color(node);
      } else if (key == "width") {
        style.width = length(node);
      } else if (key == "dash") {
        style.dash = dash(node);
      } else {
        fail(key.source(),
             fmt::format(R"(unknown key "{}"; expected fill, stroke, width or dash)", key.str()));
      }
    }
    return style;
  }

  [[nodiscard]] Color color(const toml::node& node) const {
    const auto text = node.value<std::string>();
    if (!text || text->empty()) fail(node.source(), "expected a colour, by name or as \"#rrggbb\"");
    if (text->front() == '#') return parse_hex(*text, node.source());
    const auto found = palette_.find(*text);
    if (found == palette_.end()) {
      std::vector<std::string_view> names;
      for (const auto& [name, value] : palette_) names.push_back(name);
      fail(node.source(), fmt::format(R"(no colour "{}" in the palette; it has {})", *text,
                                      fmt::join(names, ", ")));
    }
    return found->second;
  }

  static double length(const toml::node& node) {
    const auto value = node.value<double>();
    if (!value || !(*value >= 0.0 && *value <= 100.0)) {
      fail(node.source(), "expected a length in pixels, from 0 to 100");
    }
    return *value;
  }

  static std::vector<double> dash(const toml::node& node) {
    const toml::array* array = node.as_array();
    if (!array || array->empty() || array->size() % 2 != 0) {
      fail(node.source(), "expected dash = [on, off, ...]: an even number of lengths");
    }
    std::vector<double> lengths;
    for (std::size_t i = 0; i < array->size(); ++i) {
      lengths.push_back(length(*array->get(i)));
      if (i % 2 == 1 && lengths.back() <= 0.0) {
        fail(array->get(i)->source(), "the gap of a dash must be above 0");
      }
    }
    return lengths;
  }

  std::map<std::string, Color, std::less<>> palette_;
  std::map<std::string, Style, std::less<>> styles_;
  Color background_;
};

toml::table parse(std::string_view text, std::string_view path) {
  toml::table table;
  try {
    table = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    fail(error.source(), std::string(error.description()));
  }
  for (const auto& [key, node] : table) {
    if (key != "base" && key != "palette" && key != "roles") {
      fail(key.source(),
           fmt::format(R"(unknown key "{}"; expected base, palette or roles)", key.str()));
    }
  }
  return table;
}

/// A theme's file, its base before it; `folder` is what errors say that they are in.
std::vector<toml::table> parse_files(const ThemeTexts& texts, std::string_view name,
                                     const std::filesystem::path& folder) {
  const auto path = [&](std::string_view theme) {
    return (folder / fmt::format("{}.toml", theme)).string();
  };
  const std::optional<std::string> text = texts(name);
  if (!text) throw std::runtime_error(fmt::format(R"(no theme "{}")", name));
  std::vector<toml::table> files;  // Moved, never copied: a copy forgets where it was read from.
  files.push_back(parse(*text, path(name)));
  const toml::node* base = files.front().get("base");
  if (!base) return files;
  const std::string base_name = base->value_or(std::string());
  const std::optional<std::string> base_text = base_name == name ? std::nullopt : texts(base_name);
  if (!base_text) fail(base->source(), "expected the name of another theme");
  files.insert(files.begin(), parse(*base_text, path(base_name)));
  if (const toml::node* further = files.front().get("base"))
    fail(further->source(), "the base of a theme has no base itself");
  return files;
}

}  // namespace

Theme Theme::resolve(const ThemeTexts& texts, std::string_view name,
                     const std::filesystem::path& folder) {
  const std::vector<toml::table> files = parse_files(texts, name, folder);
  Reader reader(files);
  Theme theme;
  theme.background_ = reader.background();
  theme.styles_ = std::move(reader).styles();
  return theme;
}

Theme Theme::read(const ThemeTexts& texts, std::string_view name) {
  return resolve(texts, name, {});
}

Theme Theme::load(const std::filesystem::path& folder, std::string_view name) {
  const std::vector<std::string> known = names(folder);
  const auto is_known = [&](std::string_view theme) {
    return std::find(known.begin(), known.end(), theme) != known.end();
  };
  if (!is_known(name)) {
    throw std::runtime_error(fmt::format(R"(no theme "{}" in {}; it has {})", name, folder.string(),
                                         fmt::join(known, ", ")));
  }
  const auto text = [&](std::string_view theme) -> std::optional<std::string> {
    if (!is_known(theme)) return std::nullopt;
    return read_whole(folder / fmt::format("{}.toml", theme));
  };
  return resolve(text, name, folder);
}

std::vector<std::string> Theme::names(const std::filesystem::path& folder) {
  std::vector<std::string> list;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".toml") list.push_back(entry.path().stem().string());
  }
  std::sort(list.begin(), list.end());
  return list;
}

std::vector<Color> Theme::colors() const {
  std::vector<Color> all = {background_};
  for (const auto& [role, style] : styles_) {
    for (const std::optional<Color>& color : {style.fill, style.stroke}) {
      if (color && color->a == 255) all.push_back(*color);
    }
  }
  return all;
}

Style Theme::style(const Mark& mark) const {
  Style out = style(mark.role);
  for (std::optional<Color>* color : {&out.fill, &out.stroke}) {
    if (*color) (*color)->a = static_cast<std::uint8_t>(std::lround((*color)->a * mark.opacity));
  }
  return out;
}

const Style& Theme::style(std::string_view role) const {
  for (std::string_view name = role;;) {
    if (const auto found = styles_.find(name); found != styles_.end()) return found->second;
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos) break;
    name = name.substr(0, dot);
  }
  throw std::out_of_range(fmt::format(R"(the theme has no style for the role "{}")", role));
}

}  // namespace gjkscope
