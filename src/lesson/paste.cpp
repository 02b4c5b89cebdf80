#include "lesson/paste.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "lesson/json_place.hpp"
#include "outlines/nearest.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;
using std::string_view;

constexpr std::size_t kNowhere = string_view::npos;

/// The flaw that ends the reading of a text.
struct Stop {
  std::size_t at;
  std::string what;
  std::string expected;
};

[[nodiscard]] bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] bool is_hex_digit(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
/// Part of a name; all characters beyond ASCII are.
[[nodiscard]] bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' ||
         (c & 0x80) != 0;
}
[[nodiscard]] bool is_gap(char c) { return c == ' ' || c == '\t' || c == '\r'; }

[[nodiscard]] std::string lower(string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  return out;
}

template <std::size_t N>
[[nodiscard]] bool is_among(string_view word, const std::array<string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Types and functions that leave a number as it is.
constexpr std::array<string_view, 14> kCasts = {
    "float",    "double", "float32", "float64",  "btscalar", "static_cast", "decimal",
    "ccd_real", "scalar", "real",    "fcl_real", "f32",      "f64",         "number"};
/// Methods by which an object gets a point: its name is that of the shape.
constexpr std::array<string_view, 9> kSetters = {
    "set", "push_back", "emplace_back", "append", "add", "addpoint", "push", "insert", "emplace"};
/// Calls of these parts of words have numbers that are no point.
constexpr std::array<string_view, 14> kNoPoints = {
    "box",  "cuboid",    "sphere",   "ball",  "capsule", "circle",   "cylinder",
    "quat", "transform", "isometry", "rotat", "scale",   "translat", "aabb"};
/// Members of GeoJSON and of the like that are not looked into.
constexpr std::array<string_view, 7> kLeftOut = {"properties", "bbox",  "crs",        "id",
                                                 "name",       "title", "description"};
constexpr std::array<string_view, 15> kSuffixes = {
    "f", "d", "m", "l", "u", "ul", "ll", "ull", "n", "f32", "f64", "i32", "u8", "usize", "isize"};

/// The number that begins at `at`, which goes on behind it. Something must begin there.
double read_number(string_view text, std::size_t& at) {
  constexpr string_view kMinus = "\xE2\x88\x92";  // U+2212
  const std::size_t begin = at;
  const auto here = [&](std::size_t ahead = 0) {
    return at + ahead < text.size() ? text[at + ahead] : '\0';
  };
  bool negative = here() == '-';
  if (negative || here() == '+') {
    ++at;
  } else if (text.substr(at, kMinus.size()) == kMinus) {
    negative = true;
    at += kMinus.size();
  }
  const bool hex = here() == '0' && (here(1) == 'x' || here(1) == 'X');
  if (hex) at += 2;
  std::string digits;
  const auto take_digits = [&](bool (*is_one)(char)) {
    for (; is_one(here()) || ((here() == '_' || here() == '\'') && is_one(here(1)) &&
                              !digits.empty() && is_one(digits.back()));
         ++at) {
      if (is_one(here())) digits += here();
    }
  };
  take_digits(hex ? is_hex_digit : is_digit);
  if (here() == '.') {
    digits += '.';
    ++at;
    take_digits(hex ? is_hex_digit : is_digit);
  }
  const char power = here();
  const std::size_t sign = here(1) == '-' || here(1) == '+' ? 1 : 0;
  const bool scaled = (hex ? power == 'p' || power == 'P' : power == 'e' || power == 'E') &&
                      is_digit(here(1 + sign));
  const bool shrunk = scaled && here(1) == '-';
  if (scaled) {
    digits.append(text.substr(at, 1 + sign));
    at += 1 + sign;
    take_digits(is_digit);
  }
  const std::size_t end = at;
  while (is_letter(here()) || is_digit(here())) ++at;
  const string_view suffix = text.substr(end, at - end);
  const std::string shown(text.substr(begin, std::min<std::size_t>(at - begin, 40)));
  const std::string known =
      lower(suffix.substr(std::min(suffix.find_first_not_of('_'), suffix.size())));
  double value = 0.0;
  const auto [stop, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value,
                      hex ? std::chars_format::hex : std::chars_format::general);
  if (error == std::errc::result_out_of_range) {
    throw Stop{
        begin,
        fmt::format("the number {} is too {} for a double", shown, shrunk ? "small" : "large"),
        "magnitudes from 5e-324 to 1.8e308"};
  }
  if (error != std::errc{} || stop != digits.data() + digits.size() ||
      (!known.empty() && !is_among(known, kSuffixes)))
    throw Stop{begin, fmt::format("'{}' is no number", shown), "a number like 0.25, 1f or 0x1.8p3"};
  return negative ? -value : value;
}

struct PointAt {
  Vector3d xyz = Vector3d::Zero();
  int dimension = 2;
  std::size_t at = 0;
};

std::string coordinates(int count) {
  return count == 1 ? "1 coordinate" : fmt::format("{} coordinates", count);
}

/// Adds a shape of these points, all of one dimension, and of that of the shapes before.
PastedShape& add_shape(std::vector<PastedShape>& shapes, const std::vector<PointAt>& points) {
  const int dimension = shapes.empty() ? points.front().dimension : shapes.front().dimension;
  if (shapes.size() == 2)
    throw Stop{points.front().at, "a third shape begins", "two shapes, X and Y"};
  PastedShape& shape = shapes.emplace_back();
  shape.dimension = dimension;
  shape.at = points.front().at;
  for (const PointAt& point : points) {
    if (point.dimension != dimension) {
      throw Stop{point.at, "a point has " + coordinates(point.dimension),
                 coordinates(dimension) + ", as the points before"};
    }
    shape.points.push_back(point.xyz);
  }
  return shape;
}

/// Words of a line, each with its place.
using Fields = std::vector<std::pair<string_view, std::size_t>>;

/// Formats of lines: OBJ, OFF and STL.
class LineReader {
 public:
  explicit LineReader(string_view text) : text_(text) {}

  /// The next line that has words, without its comment.
  bool next(Fields& fields) {
    fields.clear();
    while (fields.empty() && at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      while (at_ < end) {
        if (text_[at_] == '#') break;
        const std::size_t begin = at_;
        while (at_ < end && !is_gap(text_[at_]) && text_[at_] != '#') ++at_;
        if (at_ > begin) fields.emplace_back(text_.substr(begin, at_ - begin), begin);
        while (at_ < end && is_gap(text_[at_])) ++at_;
      }
      at_ = end + 1;
    }
    return !fields.empty();
  }

  [[nodiscard]] std::size_t end() const { return std::min(at_, text_.size()); }

  /// The number of a word that holds nothing else.
  static double number(const std::pair<string_view, std::size_t>& field) {
    const auto& [word, place] = field;
    std::size_t at = 0;
    try {
      const double value = read_number(word, at);
      if (at == word.size()) return value;
    } catch (const Stop& stop) {
      throw Stop{place, stop.what, stop.expected};
    }
    throw Stop{place, fmt::format("'{}' is no number", word), "a number"};
  }

  /// The point of the words from `first` on; `more` words may follow three coordinates.
  static PointAt point(const Fields& fields, std::size_t first, std::size_t more) {
    const std::size_t count = fields.size() - first;
    if (count < 3 || count > 3 + more)
      throw Stop{fields.front().second, fmt::format("a vertex has {} numbers", count),
                 "3 coordinates"};
    PointAt point{{}, 3, fields.front().second};
    for (std::size_t k = 0; k < 3; ++k) point.xyz[static_cast<int>(k)] = number(fields[first + k]);
    return point;
  }

 private:
  string_view text_;
  std::size_t at_ = 0;
};

constexpr std::array<string_view, 4> kOff = {"OFF", "COFF", "NOFF", "CNOFF"};

/// Vertices of shapes, one after the other.
using Vertices = std::vector<std::vector<PointAt>>;

Vertices read_obj(string_view text, std::vector<std::string>& left_out) {
  const auto begins = [&](string_view word) {
    return text.starts_with(word) || text.find("\n" + std::string(word)) != kNowhere;
  };
  const string_view object = begins("o ") ? "o" : "g";
  Vertices shapes;
  bool goes_on = false;
  LineReader lines(text);
  for (Fields fields; lines.next(fields);) {
    const string_view word = fields.front().first;
    if (word == object) goes_on = false;
    if (word != "v") continue;
    if (!goes_on) shapes.emplace_back();
    goes_on = true;
    shapes.back().push_back(LineReader::point(fields, 1, 4));
    if (fields.size() == 5 && LineReader::number(fields[4]) != 1.0)
      throw Stop{fields[4].second, "a vertex has a weight", "x, y and z, or a weight of 1"};
    if (fields.size() > 5 && left_out.empty()) left_out.emplace_back("colours");
  }
  return shapes;
}

Vertices read_off(string_view text, std::vector<std::string>& left_out) {
  Vertices shapes;
  LineReader lines(text);
  for (Fields fields; lines.next(fields);) {
    const std::size_t header = fields.front().second;
    const bool plain = fields.front().first == kOff[0];
    if (!is_among(fields.front().first, kOff)) continue;
    fields.erase(fields.begin());
    if (fields.empty() && !lines.next(fields))
      throw Stop{header, "OFF ends here", "numbers of vertices, faces and edges"};
    const double count = LineReader::number(fields.front());
    const std::size_t place = fields.front().second;
    std::vector<PointAt>& points = shapes.emplace_back();
    while (static_cast<double>(points.size()) < count) {
      if (!lines.next(fields) || is_among(fields.front().first, kOff)) {
        throw Stop{place, fmt::format("OFF has {} vertices", points.size()),
                   fmt::format("{} vertices, as it says here", count)};
      }
      points.push_back(LineReader::point(fields, 0, plain ? 0 : 7));
      if (fields.size() > 3 && left_out.empty()) left_out.emplace_back("colours or normals");
    }
    if (points.empty()) throw Stop{place, "OFF has no vertices", "at least one"};
  }
  return shapes;
}

/// Corners of triangles that are equal are one vertex.
Vertices read_stl(string_view text) {
  const auto before = [](const Vector3d& a, const Vector3d& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  Vertices shapes;
  std::set<Vector3d, decltype(before)> known(before);
  std::size_t open = kNowhere;
  LineReader lines(text);
  for (Fields fields; lines.next(fields);) {
    const string_view word = fields.front().first;
    if (word == "solid") {
      open = fields.front().second;
      shapes.emplace_back();
      known.clear();
    } else if (word == "endsolid") {
      open = kNowhere;
    } else if (word == "vertex") {
      if (open == kNowhere)
        throw Stop{fields.front().second, "a vertex outside of a solid", "'solid' before it"};
      const PointAt point = LineReader::point(fields, 1, 0);
      if (known.insert(point.xyz).second) shapes.back().push_back(point);
    }
  }
  if (open != kNowhere) throw Stop{lines.end(), "the text ends within a solid", "'endsolid'"};
  return shapes;
}

/// A number as it stands in a list.
struct Number {
  double value = 0.0;
  std::size_t at = 0;
  int axis = -1;        ///< 0 to 2 where it is called x, y or z.
  unsigned before = 0;  ///< Signs between it and the number before it.
};
constexpr unsigned kComma = 1;
constexpr unsigned kNewLine = 2;
constexpr unsigned kSemicolon = 4;

/// A pair of brackets, or the text itself; in the end it holds numbers, points or lists.
struct List {
  std::size_t at = 0;
  char open = 0;             ///< The bracket; 0: the text.
  string_view kind;          ///< "Vector3" of Vector3(1, 2, 3), "POLYGON".
  std::string name;          ///< "a" of a[0] = ..., and of a.push_back(...).
  bool is_geo_json = false;  ///< Its kind is a member `type`.
  bool is_run = false;       ///< Points that stand one after the other in a list.
  int lines = 0;             ///< The number of lines that have points of a run.
  int last_line = -1;
  std::size_t second_line = 0;  ///< The first point there.
  std::vector<Number> numbers;
  std::vector<PointAt> points;
  std::vector<List> lists;
  // While it is read:
  std::size_t stray = kNowhere;  ///< The first thing with no place among numbers.
  string_view word;              ///< May name what follows,
  string_view label;             ///< and a word that does: before '=' or ':'.
  unsigned before = 0;
  bool is_counting = false;     ///< [f64; 2]
  bool has_break = false;       ///< A heading or an empty line, after which the next shape begins.
  int words = 0;                ///< In this line, and whether
  bool line_has_items = false;  ///< brackets or numbers stand there.
};

/// `kind` of a list without the path to it: "vector3" of THREE.Vector3, "point2" of Point2::new.
std::string last_of(string_view path) {
  path = path.substr(0, path.find('<'));
  const auto cut = [&] {
    const std::size_t at = path.find_last_of(".:>");
    const string_view last = at == kNowhere ? path : path.substr(at + 1);
    path = at == kNowhere ? string_view() : path.substr(0, path.find_last_not_of(".:->", at) + 1);
    return lower(last);
  };
  const std::string last = cut();
  return path.empty() || (last != "new" && last != "from") ? last : cut();
}

/// The object of a method: "vs[0]" of vs[0].Set.
string_view object_of(string_view path) {
  const std::size_t at = path.find_last_of(".>");
  return at == kNowhere ? string_view() : path.substr(0, at - (path[at] == '>' ? 1 : 0));
}

/// A name without its last index: "vs" of vs[0], "p" of p1.
std::string base_of(string_view name) {
  if (name.ends_with(']')) name = name.substr(0, name.rfind('['));
  const std::size_t last = name.find_last_not_of("0123456789_");
  return std::string(name.substr(0, last == kNowhere ? 0 : last + 1));
}

enum class Geometry : std::uint8_t { none, point, polygon, polygons, chains };

Geometry geometry_of(const List& list) {
  std::string kind = last_of(list.kind);
  if (kind.ends_with('z')) kind.pop_back();
  if (kind == "polygon") return Geometry::polygon;
  if (kind == "multipolygon") return Geometry::polygons;
  if (kind == "linestring" || kind == "multilinestring" || kind == "linearring")
    return Geometry::chains;
  // In code a Point is one of a shape.
  const bool is_shape = kind == "multipoint" ||
                        (kind == "point" && (list.is_geo_json || list.kind.starts_with("POINT")));
  return is_shape ? Geometry::point : Geometry::none;
}

/// A text of numbers, brackets and names.
class FreeReader {
 public:
  FreeReader(string_view text, std::vector<std::string>& left_out)
      : text_(text), left_out_(left_out) {}

  std::vector<PastedShape> read() {
    List all;
    read_items(all);
    // Two lines, one shape each.
    if (all.lists.size() == 1 && all.lists[0].is_run && all.lists[0].name.empty() &&
        all.lists[0].lines == 2 && all.lists[0].points.size() > 2) {
      List second;
      std::vector<PointAt>& points = all.lists[0].points;
      const auto middle = points.begin() + static_cast<std::ptrdiff_t>(all.lists[0].second_line);
      second.points.assign(middle, points.end());
      points.erase(middle, points.end());
      all.lists.push_back(std::move(second));
    }
    std::vector<PastedShape> shapes;
    collect(all, shapes);
    return shapes;
  }

 private:
  [[nodiscard]] char here(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  [[nodiscard]] bool starts(string_view with) const {
    return text_.substr(at_, with.size()) == with;
  }
  [[nodiscard]] std::size_t place_of(string_view word) const {
    return static_cast<std::size_t>(word.data() - text_.data());
  }

  // ---- characters ----

  void read_items(List& list) {
    while (true) {
      const char c = here();
      if (at_ >= text_.size() || c == ')' || c == ']' || c == '}') return end(list);
      if (is_gap(c)) {
        ++at_;
      } else if (c == '\n') {
        ++at_;
        list.before |= kNewLine;
        ++line_;
        if (list.open == 0) end_line(list);
      } else if (c == '#' || starts("//")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (starts("/*")) {
        const std::size_t close = text_.find("*/", at_ + 2);
        if (close == kNowhere) throw Stop{at_, "the comment is never closed", "'*/'"};
        at_ = close + 2;
      } else if (c == '(' || c == '[' || c == '{') {
        read_list(list);
      } else if (starts_number()) {
        take_number(list);
      } else if (is_letter(c)) {
        take_word(list);
      } else if (c == '"' || c == '\'' || c == '`') {
        take_quote(list);
      } else {
        take_sign(list);
      }
    }
  }

  [[nodiscard]] bool starts_number() const {
    constexpr string_view kMinus = "\xE2\x88\x92";
    const std::size_t sign = starts(kMinus)                   ? kMinus.size()
                             : here() == '-' || here() == '+' ? 1
                                                              : 0;
    if (!is_digit(here(sign)) && !(here(sign) == '.' && is_digit(here(sign + 1)))) return false;
    // 1-2 is a difference, and 1 -2 are two numbers.
    const char before = at_ > 0 ? text_[at_ - 1] : ' ';
    return sign == 0 || !(is_digit(before) || is_letter(before) || before == '.' || before == ')' ||
                          before == ']');
  }

  void end(List& list) {
    drop_word(list);
    if (at_ >= text_.size()) {
      if (list.open != 0)
        throw Stop{list.at, fmt::format("'{}' is never closed", list.open),
                   fmt::format("a '{}'", closing(list.open))};
      return end_line(list);
    }
    if (list.open == 0)
      throw Stop{at_, fmt::format("'{}' closes nothing", here()), "a bracket that opens before it"};
    if (here() != closing(list.open))
      throw Stop{at_, fmt::format("'{}' closes a '{}'", here(), list.open),
                 fmt::format("'{}'", closing(list.open))};
    ++at_;
  }

  [[nodiscard]] static char closing(char open) {
    return open == '(' ? ')' : open == '[' ? ']' : '}';
  }

  /// Numbers in a line of their own are a point of the text itself.
  void end_line(List& all) {
    if (all.numbers.empty()) {
      if (!all.line_has_items) all.has_break = true;
    } else {
      List row;
      std::swap(row.numbers, all.numbers);
      std::swap(row.name, all.name);
      row.at = row.numbers.front().at;
      if (all.stray == kNowhere && !all.word.empty()) all.stray = place_of(all.word);
      if (all.stray != kNowhere) throw no_number(all.stray);
      if (row.numbers.size() == 1)
        throw Stop{row.at, fmt::format("a number stands alone: {}", row.numbers[0].value),
                   "two or three coordinates"};
      points_of(row);
      if (row.points.size() > 1 && !row.is_run)
        throw Stop{row.at, fmt::format("a line of {} numbers", row.numbers.size()),
                   "two or three coordinates"};
      for (const PointAt& point : row.points) add_point(all, point, row.name, {});
    }
    all.stray = kNowhere;
    all.word = all.label = {};
    all.words = 0;
    all.before = 0;
    all.line_has_items = false;
  }

  /// A word that named nothing.
  void drop_word(List& list) const {
    if (!list.word.empty() && list.stray == kNowhere && list.open != 0)
      list.stray = place_of(list.word);
    list.word = {};
  }

  void take_sign(List& list) {
    const char c = here();
    if (c == ',' || c == ';') {
      drop_word(list);
      list.label = {};
      list.before |= c == ',' ? kComma : kSemicolon;
      if (c == ';' && list.open == '[' && list.numbers.empty()) list.is_counting = true;
    } else if (starts("::") || starts("==")) {
      ++at_;
    } else if (c == '=' || c == ':' || starts("<<")) {
      if (starts("<<")) ++at_;
      ++at_;
      if (!list.word.empty()) take_label(list, list.word);
      return;
    } else if (c != '.' && c != '|' && list.stray == kNowhere) {
      list.stray = at_;
    }
    ++at_;
  }

  /// Names the next thing, or leaves it out.
  void take_label(List& list, string_view label) {
    list.label = label;
    list.word = {};
    if (list.open != '{' || !is_among(label, kLeftOut)) return;
    const std::size_t begin = skip_space(text_, at_);
    at_ = skip_value(text_, begin);
    list.label = {};
    const string_view value = text_.substr(begin, at_ - begin);
    if (value != "null" && value != "{}") leave_out(label);
  }

  void leave_out(string_view label) {
    if (std::find(left_out_.begin(), left_out_.end(), label) == left_out_.end())
      left_out_.emplace_back(label);
  }

  /// A key of JSON or of Python; quotes of other texts say nothing.
  void take_quote(List& list) {
    constexpr std::size_t kLongest = 200;
    const std::string ends = {here(), '\n'};
    const std::size_t length = text_.substr(at_ + 1, kLongest).find_first_of(ends);
    const std::size_t end = at_ + 1 + length;
    if (length != kNowhere && text_[end] != '\n') {
      const std::size_t next = text_.find_first_not_of(" \t", end + 1);
      const string_view inside = text_.substr(at_ + 1, end - at_ - 1);
      if (next != kNowhere && text_[next] == ':' && !text_.substr(next).starts_with("::")) {
        at_ = next + 1;
        return take_label(list, inside);
      }
      if (inside.find("://") != kNowhere) at_ = end;
    }
    ++at_;
  }

  /// A name with its path, its types and its indices: a.vs[0].Set, std::vector<b2Vec2>, vec!
  void take_word(List& list) {
    constexpr std::size_t kLongest = 200;  // of types in < >
    const std::size_t begin = at_;
    while (is_letter(here())) {
      while (is_letter(here()) || is_digit(here())) ++at_;
      const string_view ahead = text_.substr(at_, kLongest);
      if (ahead.starts_with('<')) {
        const std::size_t close = ahead.find_first_of(">(){}\n;=\"");
        if (close != kNowhere && ahead[close] == '>')
          at_ += std::min(ahead.find_first_not_of('>', close), ahead.size());
      }
      if (here() == '!') ++at_;
      while (here() == '[') {
        const std::size_t close = text_.find_first_not_of(
            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_+-* .", at_ + 1);
        if (text_[at_ - 1] == '!' || close == kNowhere || text_[close] != ']') break;
        at_ = close + 1;
      }
      const std::size_t joint = starts("::") || starts("->") ? 2 : here() == '.' ? 1 : 0;
      if (joint == 0 || !is_letter(here(joint))) break;
      at_ += joint;
    }
    const string_view word = text_.substr(begin, at_ - begin);
    List geometry;
    geometry.kind = list.word;
    if (geometry_of(geometry) != Geometry::none && list.word.size() > 1) {
      if (word == "EMPTY") throw Stop{begin, "an empty geometry", "at least one point"};
      if (word == "M" || word == "ZM")
        throw Stop{begin, "an M coordinate is no place", "x, y and perhaps z"};
      if (word == "Z") return;
    }
    if (list.label == "type") {
      list.kind = word;
      list.is_geo_json = true;
      list.label = {};
      return;
    }
    list.word = word;
    ++list.words;
  }

  void take_number(List& list) {
    Number number{0.0, at_};
    const bool is_first = list.numbers.empty();
    number.value = read_number(text_, at_);
    const std::size_t next = text_.find_first_not_of(" \t", at_);
    if (next != kNowhere && text_[next] == ':' && !text_.substr(next).starts_with("::")) {
      list.has_break = list.has_break || list.open == 0;
      at_ = next + 1;  // a key
      return;
    }
    if (list.is_counting || list.word == "return") return;
    if (list.label == "SRID") return leave_out(list.label);
    if (list.open == 0 && is_first && list.words == 1 && list.label.empty() && !list.word.empty())
      list.label = std::exchange(list.word, {});  // a name, and a point in its line
    if (!list.word.empty() && list.stray == kNowhere) list.stray = place_of(list.word);
    list.word = {};
    add_number(list, number);
  }

  void add_number(List& list, Number number) const {
    const std::string label = lower(list.label);
    if (label.size() == 1 && label[0] >= 'x' && label[0] <= 'z') {
      number.axis = label[0] - 'x';
    } else if (!label.empty() && list.open != 0 && list.stray == kNowhere) {
      list.stray = place_of(list.label);
    }
    if (list.open == 0 && list.numbers.empty()) list.name = list.label;
    list.label = {};
    number.before = std::exchange(list.before, 0);
    list.numbers.push_back(number);
    list.line_has_items = true;
  }

  // ---- brackets ----

  void read_list(List& parent) {
    constexpr int kDeepest = 100;
    List list;
    list.at = at_++;
    list.open = text_[list.at];
    if (++depth_ > kDeepest)
      throw Stop{list.at, "brackets stand too deep in each other", "at most 100"};
    const string_view path = std::exchange(parent.word, {});
    list.kind = path;
    list.name = base_of(parent.label);
    const string_view object = object_of(path);
    if (!object.empty() && is_among(last_of(path), kSetters)) {
      list.name = base_of(object);
      list.kind = {};
    }
    read_items(list);
    --depth_;
    parent.line_has_items = true;
    add_list(parent, std::move(list));
  }

  /// Adds a list that was read to the list around it: as a point, a ring or a shape.
  void add_list(List& parent, List list) {
    const std::string kind = last_of(list.kind);
    const Geometry geometry = geometry_of(list);
    const string_view label = parent.label;
    const bool is_setter = !list.name.empty() && label.empty();
    if (!list.numbers.empty()) {
      if (!list.lists.empty())
        throw Stop{list.numbers[0].at, "a number stands beside points",
                   "brackets around each point"};
      if (list.stray != kNowhere) {
        if (list.numbers.size() == 1 && is_known(list.stray)) return;  // polygon.Set(vertices, 4)
        throw no_number(list.stray);
      }
      if (list.numbers.size() == 1) {
        if (!kind.empty() && !is_among(kind, kCasts))
          throw Stop{list.at, fmt::format("'{}' is not computed", list.kind), "its value"};
        const Number number = list.numbers[0];
        const std::size_t next = text_.find_first_not_of(" \t", at_);
        if (list.open == '[' && next != kNowhere && text_[next] == '=') return;  // an index
        if (parent.open == 0)
          throw Stop{number.at, fmt::format("a number stands alone: {}", number.value),
                     "two or three coordinates"};
        return add_number(parent, number);
      }
      const bool is_no_point = std::any_of(
          kNoPoints.begin(), kNoPoints.end(),
          [&](string_view part) { return list.open == '(' && kind.find(part) != kNowhere; });
      if (is_no_point)
        throw Stop{list.at, fmt::format("the numbers of '{}' are no point", list.kind),
                   "the vertices of the shape"};
      points_of(list);
      if (list.points.size() > 1 && !list.is_run && is_point_like(parent, list)) {
        throw Stop{list.at, fmt::format("a point has {} coordinates", list.numbers.size()),
                   "two or three"};
      }
      list.is_run = false;
      list.numbers.clear();
      if (list.points.size() == 1 && geometry == Geometry::none) {
        note_name(list.name);
        return add_point(parent, list.points[0], list.name, list.kind);
      }
    } else if (list.lists.size() == 1 && list.lists[0].is_run) {
      // {{1, 2, 3}} is one, too, where a point is a struct with an array.
      const char inner = text_[list.lists[0].points[0].at];
      const bool is_struct =
          list.open == '{' && (inner == '{' || inner == '[') && !list.is_geo_json;
      std::vector<PointAt> points = std::move(list.lists[0].points);
      list.lists.clear();
      list.points = std::move(points);
      if (list.points.size() == 1 && (is_setter || is_struct) && geometry == Geometry::none) {
        note_name(list.name);
        return add_point(parent, list.points[0], list.name, list.kind);
      }
    } else if (list.lists.empty()) {
      if (geometry != Geometry::none)
        throw Stop{list.at, "an empty geometry", "at least one point"};
      return;
    }
    note_name(list.name);
    parent.label = {};
    parent.lists.push_back(std::move(list));
  }

  /// Whether a list of many numbers stands where points do.
  [[nodiscard]] static bool is_point_like(const List& parent, const List& list) {
    if (!list.kind.empty()) {
      const std::string kind = lower(list.kind);
      return kind.find("array") == kNowhere && kind != "vec!" && !kind.ends_with(']');
    }
    return list.name.empty() && parent.open != 0 &&
           (parent.kind.empty() || geometry_of(parent) != Geometry::none);
  }

  void note_name(const std::string& name) {
    if (!name.empty() && names_.size() < 100) names_.push_back(name);
  }
  [[nodiscard]] bool is_known(std::size_t at) const {
    std::size_t end = at;
    while (end < text_.size() &&
           (is_letter(text_[end]) || is_digit(text_[end]) || text_[end] == '.'))
      ++end;
    return std::find(names_.begin(), names_.end(), base_of(text_.substr(at, end - at))) !=
           names_.end();
  }
  [[nodiscard]] Stop no_number(std::size_t at) const {
    std::size_t end = at + 1;
    while (end < text_.size() && end < at + 40 && is_letter(text_[at]) &&
           (is_letter(text_[end]) || is_digit(text_[end])))
      ++end;
    while (end < text_.size() && (text_[end] & 0xC0) == 0x80) ++end;
    return {at, fmt::format("'{}' stands among numbers", text_.substr(at, end - at)),
            "numbers alone, as in (1, 2)"};
  }

  // ---- points ----

  /// The numbers of a list as its points. `is_run` where something separates these.
  void points_of(List& list) const {
    const std::vector<Number>& numbers = list.numbers;
    const std::size_t count = numbers.size();
    const auto named = std::count_if(numbers.begin(), numbers.end(),
                                     [](const Number& each) { return each.axis >= 0; });
    if (static_cast<std::size_t>(named) == count || (named > 0 && list.open != 0))
      return add_named_point(list);
    // Points are separated by semicolons; by commas, or by what is none, where there are both; or
    // by new lines.
    const auto separates = [&](std::size_t i, std::size_t rule) {
      const unsigned before = numbers[i].before;
      return rule == 0   ? (before & kSemicolon) != 0
             : rule == 1 ? (before & kComma) != 0
             : rule == 2 ? (before & kComma) == 0
             : rule == 3 ? (before & kNewLine) != 0
                         : before == 0;
    };
    std::array<std::size_t, 5> often = {};
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t rule = 0; rule < 5; ++rule) often[rule] += separates(i, rule) ? 1 : 0;
    }
    if (often[1] == 0) often[2] = 0;
    if (often[4] == 0) often[1] = 0;
    std::optional<Stop> uneven;
    for (std::size_t rule = 0; rule < 4; ++rule) {
      if (often[rule] == 0) continue;
      std::vector<std::size_t> begins = {0};
      for (std::size_t i = 1; i < count; ++i) {
        if (separates(i, rule)) begins.push_back(i);
      }
      begins.push_back(count);
      const std::size_t size = begins[1];
      std::size_t other = 0;
      while (other + 1 < begins.size() && begins[other + 1] - begins[other] == size) ++other;
      if (size != 2 && size != 3) continue;
      if (other + 1 == begins.size()) {
        list.is_run = true;
        return add_points(list, size);
      }
      if (rule != 3 && !uneven) {
        uneven =
            Stop{numbers[begins[other]].at,
                 "a point has " + coordinates(static_cast<int>(begins[other + 1] - begins[other])),
                 coordinates(static_cast<int>(size)) + ", as the points before"};
      }
    }
    if (uneven) throw *uneven;
    if (count <= 3) return add_points(list, count);
    if (count % 2 != 0 && count % 3 != 0)
      throw Stop{list.at, fmt::format("{} numbers are no points", count),
                 "two or three for each point"};
    if (count % 6 == 0) {
      throw Stop{list.at,
                 fmt::format("{} numbers in a row could be points in the plane or in space", count),
                 "a point a line, or brackets around each point"};
    }
    add_points(list, count % 2 == 0 ? 2 : 3);
  }

  void add_points(List& list, std::size_t size) const {
    for (std::size_t i = 0; i < list.numbers.size(); i += size) {
      PointAt point{Vector3d::Zero(), static_cast<int>(size),
                    size == list.numbers.size() && list.open != 0 ? list.at : list.numbers[i].at};
      for (std::size_t k = 0; k < size; ++k)
        point.xyz[static_cast<int>(k)] = list.numbers[i + k].value;
      list.points.push_back(point);
    }
  }

  /// {x: 1, y: 2}, in any order.
  void add_named_point(List& list) const {
    const std::size_t count = list.numbers.size();
    PointAt point{Vector3d::Zero(), static_cast<int>(count), list.at};
    unsigned seen = 0;
    for (const Number& number : list.numbers) {
      if (number.axis >= 0) seen |= 1U << static_cast<unsigned>(number.axis);
      if (number.axis >= 0) point.xyz[number.axis] = number.value;
    }
    if (count > 3 || seen != (1U << count) - 1)
      throw Stop{list.at, fmt::format("a point with {} numbers", count), "x, y and perhaps z"};
    list.points.push_back(point);
    list.name.clear();
  }

  /// A point goes to the points before it, unless its name says otherwise.
  void add_point(List& parent, const PointAt& point, string_view name, string_view kind) const {
    const std::string base = base_of(name);
    parent.label = {};
    List* run = nullptr;
    if (!base.empty()) {
      for (std::size_t i = parent.lists.size();
           i > 0 && i + 2 > parent.lists.size() && run == nullptr; --i) {
        List& each = parent.lists[i - 1];
        if (each.is_run && each.name == base) run = &each;
      }
    } else if (!parent.lists.empty() && parent.lists.back().is_run && !parent.has_break) {
      List& last = parent.lists.back();
      const bool is_other = parent.open == 0 && last.name.empty() && !kind.empty() &&
                            base_of(last.kind) != base_of(kind);
      if (!is_other) run = &last;
    }
    if (run == nullptr) {
      run = &parent.lists.emplace_back();
      run->is_run = true;
      run->name = base;
      run->kind = kind;
    }
    parent.has_break = false;
    if (run->last_line != line_ && ++run->lines == 2) run->second_line = run->points.size();
    run->last_line = line_;
    run->points.push_back(point);
  }

  // ---- shapes ----

  static void collect(const List& list, std::vector<PastedShape>& shapes) {
    const Geometry geometry = list.is_run ? Geometry::none : geometry_of(list);
    if (geometry == Geometry::none || geometry == Geometry::point) {
      if (!list.points.empty()) add_shape(shapes, list.points);
      for (const List& each : list.lists) collect(each, shapes);
      return;
    }
    std::vector<PointAt> points;
    std::vector<PastedPart> parts;
    std::vector<std::size_t> places;
    gather(list, geometry, points, parts);
    PastedShape& shape = add_shape(shapes, points);
    if (shape.dimension == 3) {
      if (parts.size() > 1)
        throw Stop{points[parts[1].first].at, "a second outline in space",
                   "outlines in the plane, or points alone"};
      shape.was_outline = true;
    } else {
      shape.parts = std::move(parts);
      turn_holes(shape, points);
    }
  }

  /// The outlines in a list: of a polygon the first one is its ring, the others are holes.
  static void gather(const List& list, Geometry geometry, std::vector<PointAt>& points,
                     std::vector<PastedPart>& parts) {
    using Kind = PastedPart::Kind;
    bool is_first = geometry == Geometry::polygons;
    const auto add = [&](const List& ring, Kind kind) {
      std::size_t count = ring.points.size();
      if (kind != Kind::chain && count > 1 && ring.points.front().xyz == ring.points.back().xyz)
        --count;
      parts.push_back({points.size(), kind});
      points.insert(points.end(), ring.points.begin(),
                    ring.points.begin() + static_cast<std::ptrdiff_t>(count));
    };
    if (!list.points.empty())
      add(list, geometry == Geometry::chains ? Kind::chain
                : parts.empty() || is_first  ? Kind::ring
                                             : Kind::hole);
    for (const List& each : list.lists) {
      if (each.points.empty() || geometry != Geometry::polygons) {
        gather(each, geometry, points, parts);
      } else {
        add(each, is_first ? Kind::ring : Kind::hole);
        is_first = false;
      }
    }
  }

  /// Rings turn alike, and holes the other way: their place in the list says what they are.
  static void turn_holes(PastedShape& shape, const std::vector<PointAt>& points) {
    using Kind = PastedPart::Kind;
    std::vector<models::Model> rings;
    std::optional<bool> way;
    std::size_t ring = 0;
    for (std::size_t i = 0; i < shape.parts.size(); ++i) {
      const auto [first, kind] = shape.parts[i];
      const auto begin = shape.points.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end =
          i + 1 < shape.parts.size()
              ? shape.points.begin() + static_cast<std::ptrdiff_t>(shape.parts[i + 1].first)
              : shape.points.end();
      models::Outline outline;
      for (auto each = begin; each != end; ++each) outline.points.push_back(each->head<2>());
      if (kind == Kind::ring) ring = i;
      if (kind != Kind::chain && outline.points.size() > 2) {
        const bool flat = std::all_of(begin, end, [&](const Vector3d& p) { return p == *begin; });
        const bool reversed = !flat && models::ring_of(outline).reversed;
        if (!way) way = reversed;
        if (reversed != (*way != (kind == Kind::hole))) std::reverse(begin, end);
      }
      rings.push_back(models::model_of({std::move(outline)}));
      if (kind != Kind::hole) continue;
      for (std::size_t k = ring; k < i; ++k) {
        if (is_around(rings[k], rings[i]).value_or(k == ring) != (k == ring)) {
          throw Stop{points[first].at,
                     k == ring ? "a hole lies outside of its ring" : "a hole lies within another",
                     "holes within the ring before them, and beside each other"};
        }
      }
    }
  }

  /// Whether an outline goes around another; nothing where all points of that lie on it.
  static std::optional<bool> is_around(const models::Model& outer, const models::Model& inner) {
    for (const models::Point& p : inner.outlines[0].points) {
      const bool is_on =
          std::any_of(outer.segments.begin(), outer.segments.end(), [&](const models::Segment& s) {
            return s.a == p || (models::turn(s.a, s.b, p) == 0 && models::along(p, s.a, s.b) < 0);
          });
      if (!is_on) return models::winding(p, outer) != 0;
    }
    return std::nullopt;
  }

  string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string>& left_out_;
  std::vector<std::string> names_;
  int depth_ = 0;
  int line_ = 0;
};

std::vector<PastedShape> shapes_of(const Vertices& vertices) {
  std::vector<PastedShape> shapes;
  for (const std::vector<PointAt>& points : vertices) {
    if (!points.empty()) add_shape(shapes, points);
  }
  return shapes;
}

/// A line begins with the word, and a number follows it where that is asked for.
bool has_line(string_view text, string_view word, bool number) {
  for (std::size_t at = text.find(word); at != kNowhere; at = text.find(word, at + 1)) {
    const std::size_t begin = text.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
    if (at != 0 && begin != kNowhere && text[begin] != '\n') continue;
    const std::size_t next = text.find_first_not_of(" \t", at + word.size());
    const bool ends =
        next == kNowhere || next > at + word.size() || text[next] == '\n' || text[next] == '\r';
    if (ends &&
        (!number || (next != kNowhere &&
                     (is_digit(text[next]) || string_view("-+.").find(text[next]) != kNowhere))))
      return true;
  }
  return false;
}

std::vector<PastedShape> read_shapes(string_view text, std::vector<std::string>& left_out) {
  const auto binary = std::find_if(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' && string_view("\t\n\r\f").find(c) == kNowhere;
  });
  if (binary != text.end())
    throw Stop{static_cast<std::size_t>(binary - text.begin()), "a byte that is no text",
               "text: of STL the ASCII form"};
  if (has_line(text, "facet", false)) return shapes_of(read_stl(text));
  if (has_line(text, "v", true)) return shapes_of(read_obj(text, left_out));
  for (const string_view header : kOff) {
    if (has_line(text, header, false)) return shapes_of(read_off(text, left_out));
  }
  return FreeReader(text, left_out).read();
}

}  // namespace

bool is_pasted_ending(string_view ending) {
  return is_among(ending, std::array<string_view, 9>{".geojson", ".wkt", ".obj", ".off", ".stl",
                                                     ".txt", ".csv", ".xyz", ".dat"});
}

Pasted read_pasted(string_view text, string_view file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const auto place_at = [&](std::size_t at) {
    const string_view before = text.substr(0, at);
    const std::size_t line = before.rfind('\n') + 1;
    return Place{1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
                 1 + character_count(before.substr(line))};
  };
  Pasted pasted;
  pasted.end = place_at(text.size());
  try {
    pasted.shapes = read_shapes(text, pasted.left_out);
    if (pasted.shapes.empty())
      throw Stop{text.size(), "there is no point", "points of two shapes, X and Y"};
    for (PastedShape& shape : pasted.shapes) {
      shape.file = file;
      shape.place = place_at(shape.at);
    }
  } catch (const Stop& stop) {
    const Place place = place_at(stop.at);
    pasted.shapes.clear();
    pasted.problems = {{std::string(file), place.line, place.column, stop.what, stop.expected, ""}};
  }
  return pasted;
}

}  // namespace gjkscope
