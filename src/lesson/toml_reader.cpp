#include "lesson/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace gjkscope::toml_file {

namespace {

std::string_view kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "text";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// "0x1.8p-3", with an optional sign. TOML itself has no hexadecimal floats.
std::optional<double> hex_number(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (!text.starts_with("0x")) return std::nullopt;
  text.remove_prefix(2);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value, std::chars_format::hex);
  if (result.ec != std::errc() || result.ptr != end || text.starts_with('-')) return std::nullopt;
  return negative ? -value : value;
}

}  // namespace

Place place_at(const toml::source_position& position) {
  return {std::max(1, static_cast<int>(position.line)),
          std::max(1, static_cast<int>(position.column))};
}

Place Field::place() const { return place_at(node->source().begin); }

void Problems::add(Place place, std::string what, std::string expected, std::string nearest) {
  problems_.push_back(
      {file_, place.line, place.column, std::move(what), std::move(expected), std::move(nearest)});
}

void Problems::add_unknown(const Field& field, std::string_view kind, std::string_view name,
                           const std::vector<std::string>& known) {
  add(field.place(), fmt::format("unknown {} {}", kind, in_quotes(name)), field.expected,
      nearest_name(name, known));
}

std::vector<Problem> Problems::sorted() const {
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return Place{a.line, a.column} < Place{b.line, b.column};
  });
  if (sorted.size() > kMostProblems) {
    const std::size_t more = sorted.size() - kMostProblems;
    sorted.resize(kMostProblems + 1);
    sorted.back().what = fmt::format("and {} more problems from here on", more);
    sorted.back().expected.clear();
    sorted.back().nearest.clear();
  }
  return sorted;
}

std::string in_quotes(std::string_view name) {
  constexpr int kLongest = 40;
  std::string out = "'";
  int count = 0;
  for (const char c : name) {
    if (starts_character(c) && ++count > kLongest) return out + "...'";
    out += is_control(c) ? '?' : c;
  }
  return out + "'";
}

namespace {

/// Keys that a table had once, and what says the same today.
constexpr std::array<std::array<std::string_view, 3>, 2> kFormerKeys = {
    {{"query", "beside", "'scalar' in a table [second]"}, {"steps", "granularity", "'tour'"}}};

void refuse_other_keys(const toml::table& table, std::string_view name,
                       const std::vector<std::string>& known, Problems& problems) {
  for (const auto& [key, value] : table) {
    const std::string_view called = key.str();
    if (std::find(known.begin(), known.end(), called) != known.end()) continue;
    const auto former = std::find_if(kFormerKeys.begin(), kFormerKeys.end(), [&](const auto& each) {
      return each[0] == name && each[1] == called;
    });
    if (former != kFormerKeys.end()) {
      problems.add(place_at(key.source().begin), in_quotes(called) + " has another name now",
                   std::string((*former)[2]));
      continue;
    }
    problems.add(place_at(key.source().begin), "unknown key " + in_quotes(key.str()),
                 fmt::format("one of: {}", fmt::join(known, ", ")), nearest_name(key.str(), known));
  }
}

}  // namespace

Table::Table(const toml::table& table, std::string_view name, const std::vector<LessonKey>& keys,
             Problems& problems)
    : table_(table), name_(name), keys_(keys) {
  std::vector<std::string> known;
  for (const LessonKey& key : keys) {
    if (key.table != name) continue;
    known.push_back(key.key);
    if (key.otherwise == kRequired && !table.contains(key.key)) {
      problems.add(place_at(table.source().begin), fmt::format("missing key '{}'", key.key),
                   key.type);
    }
  }
  refuse_other_keys(table, name, known, problems);
}

Field Table::operator[](std::string_view key) const {
  const auto known = std::find_if(keys_.begin(), keys_.end(), [&](const LessonKey& each) {
    return each.table == name_ && each.key == key;
  });
  assert(known != keys_.end());
  return {table_.get(key), fmt::format("'{}'", key), known->type};
}

void Reader::wrong_type(const Field& field) {
  problems_.add(field, fmt::format("{} is {}", field.label, kind_of(*field.node)));
}

std::optional<Table> Reader::table(const Field& field, std::string_view name) {
  if (!field) return std::nullopt;
  if (const toml::table* table = field.node->as_table())
    return Table(*table, name, keys_, problems_);
  wrong_type(field);
  return std::nullopt;
}

std::vector<std::pair<std::string, Field>> Reader::named_entries(
    const Field& field, const std::vector<std::string>& known) {
  std::vector<std::pair<std::string, Field>> entries;
  const toml::table* table = field.node->as_table();
  if (table == nullptr) {
    wrong_type(field);
    return entries;
  }
  refuse_other_keys(*table, "", known, problems_);
  for (const std::string& name : known) {
    if (const toml::node* node = table->get(name))
      entries.emplace_back(name, Field{node, fmt::format("'{}'", name), "number of at least 0"});
  }
  return entries;
}

std::vector<Field> Reader::entries(const Field& field, std::string_view expected) {
  std::vector<Field> entries;
  if (!field) return entries;
  const toml::array* array = field.node->as_array();
  if (array == nullptr) {
    wrong_type(field);
    return entries;
  }
  for (const toml::node& node : *array) {
    entries.push_back({&node, fmt::format("entry {} of {}", entries.size() + 1, field.label),
                       std::string(expected)});
  }
  return entries;
}

std::optional<std::string> Reader::text(const Field& field, int longest) {
  if (!field) return std::nullopt;
  const toml::value<std::string>* value = field.node->as_string();
  if (value == nullptr) {
    wrong_type(field);
    return std::nullopt;
  }
  const std::string& text = value->get();
  const int length = character_count(text);
  if (length == 0) {
    problems_.add(field, field.label + " is empty");
  } else if (std::any_of(text.begin(), text.end(), is_control)) {
    problems_.add(field.place(), field.label + " holds a line break or a control character",
                  "one line of text");
  } else if (length > longest) {
    problems_.add(field, fmt::format("{} has {} characters", field.label, length));
  } else {
    return text;
  }
  return std::nullopt;
}

std::optional<double> Reader::number(const Field& field, double least, double most) {
  if (!field) return std::nullopt;
  std::optional<double> value;
  if (const auto* floating = field.node->as_floating_point()) {
    value = floating->get();
  } else if (const auto* integer = field.node->as_integer()) {
    value = static_cast<double>(integer->get());
  } else if (const auto* text = field.node->as_string()) {
    value = hex_number(text->get());
  }
  if (!value) {
    wrong_type(field);
    return std::nullopt;
  }
  if (!std::isfinite(*value)) {
    problems_.add(field, field.label + " is not a finite number");
    return std::nullopt;
  }
  if (!(least <= *value && *value <= most)) {
    problems_.add(field, fmt::format("{} is {}", field.label, *value));
    return std::nullopt;
  }
  return value;
}

std::optional<int> Reader::whole_number(const Field& field, int least, int most) {
  if (!field) return std::nullopt;
  const toml::value<int64_t>* value = field.node->as_integer();
  if (value == nullptr) {
    if (field.node->is_floating_point()) {
      problems_.add(field, field.label + " is not a whole number");
    } else {
      wrong_type(field);
    }
    return std::nullopt;
  }
  if (value->get() < least || value->get() > most) {
    problems_.add(field, fmt::format("{} is {}", field.label, value->get()));
    return std::nullopt;
  }
  return static_cast<int>(value->get());
}

std::optional<bool> Reader::yes_or_no(const Field& field) {
  if (!field) return std::nullopt;
  if (const auto* value = field.node->as_boolean()) return value->get();
  wrong_type(field);
  return std::nullopt;
}

std::optional<Eigen::Vector3d> Reader::point(const Field& field, double largest, int dimension) {
  if (!field) return std::nullopt;
  const std::vector<Field> coordinates = entries(
      field, fmt::format("number of at most {} in size, or text like \"0x1.8p-3\"", largest));
  if (!field.node->is_array()) return std::nullopt;
  if (static_cast<int>(coordinates.size()) != dimension) {
    problems_.add(field.place(),
                  fmt::format("{} has {} coordinates", field.label, coordinates.size()),
                  dimension == 2 ? field.expected : "point [x, y, z], as the first vertex of X");
    return std::nullopt;
  }
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  bool all_read = true;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const std::optional<double> read = number(coordinates[i], -largest, largest);
    all_read = all_read && read;
    out[static_cast<Eigen::Index>(i)] = read.value_or(0.0);
  }
  return all_read ? std::optional(out) : std::nullopt;
}

std::optional<std::string> Reader::name(const Field& field, std::string_view kind,
                                        const std::vector<std::string>& known) {
  if (!field) return std::nullopt;
  const toml::value<std::string>* value = field.node->as_string();
  if (value == nullptr) {
    wrong_type(field);
    return std::nullopt;
  }
  if (std::find(known.begin(), known.end(), value->get()) != known.end()) return value->get();
  problems_.add_unknown(field, kind, value->get(), known);
  return std::nullopt;
}

std::optional<Place> too_deep_key(std::string_view toml) {
  enum class In { plain, comment, text };
  In in = In::plain;
  std::string_view quote;  // what ends the text: ", ', """ or '''
  int dots = 0;            // since the last character that ends a key
  Place here;
  for (std::size_t at = 0; at < toml.size(); ++at) {
    const char c = toml[at];
    const bool one_line = quote.size() < 3;
    if (c == '\n' && (in != In::text || one_line)) {
      in = In::plain;
      dots = 0;
    } else if (in == In::text) {
      if (c == '\\' && quote.starts_with('"')) {
        ++at;
        ++here.column;
      } else if (toml.substr(at).starts_with(quote)) {
        in = In::plain;
        std::size_t length = quote.size();
        // A long text may end with one or two quotes of its own before the closing three.
        while (length >= 3 && length < 5 && toml.substr(at + length).starts_with(quote[0]))
          ++length;
        at += length - 1;
        here.column += static_cast<int>(length) - 1;
      }
    } else if (in == In::plain) {
      if (c == '#') in = In::comment;
      if (c == '"' || c == '\'') {
        in = In::text;
        const std::string_view triple = c == '"' ? "\"\"\"" : "'''";
        quote = toml.substr(at).starts_with(triple) ? triple : triple.substr(0, 1);
        at += quote.size() - 1;
        here.column += static_cast<int>(quote.size()) - 1;
      }
      if (c == '.' && ++dots >= kDeepestKey) return here;
      if (std::string_view("=,[]{}").find(c) != std::string_view::npos) dots = 0;
    }
    if (at < toml.size() && toml[at] == '\n') {
      ++here.line;
      here.column = 1;
    } else if (at < toml.size() && starts_character(toml[at])) {
      ++here.column;
    }
  }
  return std::nullopt;
}

}  // namespace gjkscope::toml_file
