#include "judge/log.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lesson/json_place.hpp"
#include "lesson/names.hpp"

namespace gjkscope::judging {
namespace {

using json = nlohmann::ordered_json;

/// A log with more problems is not listed further.
constexpr std::size_t kListedProblems = 20;

constexpr std::string_view kHead =
    R"({"gjk_log":1, "difference":"b-a", "a":[[x, y], ...], "b":[[x, y], ...]})";

const std::vector<std::string> kHeadKeys = {"gjk_log",   "difference", "scalar", "dimension",
                                            "tolerance", "name",       "a",      "b"};
const std::vector<std::string> kIterationKeys = {
    "simplex", "points",    "kept",    "kept_points",   "weights",
    "closest", "direction", "support", "support_point", "answer"};
const std::vector<std::string> kAnswerKeys = {"distance", "overlap", "a",
                                              "b",        "depth",   "translation"};

JsonPath below(JsonPath path, std::string key) {
  path.push_back(std::move(key));
  return path;
}

/// A value as a message shows it.
std::string shown(const json& value) {
  constexpr std::size_t kLongest = 40;
  if (value.is_object()) return "an object";
  if (value.is_array() && value.size() > 4) return fmt::format("an array of {}", value.size());
  if (std::any_of(value.begin(), value.end(),
                  [](const json& each) { return each.is_structured(); }))
    return "an array of arrays or objects";
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

class Reader {
 public:
  explicit Reader(std::string_view file) : file_(file) {}

  ReadLog read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty() && problems_.size() < kListedProblems) {
      const std::size_t end = text.find('\n');
      line_ = text.substr(0, end);
      ++number_;
      const bool ends = end != std::string_view::npos;
      text.remove_prefix(ends ? end + 1 : text.size());
      if (skip_space(line_, 0) == line_.size()) continue;
      read_line(ends);
      if (!has_shapes_) break;
    }
    if (number_ == 0) number_ = 1;
    if (!has_head_ && problems_.empty()) report({}, "there is no log", kHead);
    if (!problems_.empty()) return {std::nullopt, std::move(problems_)};
    return {std::move(log_), {}};
  }

 private:
  void report_at(std::size_t at, std::string what, std::string_view expected,
                 std::string nearest = "") {
    problems_.push_back({file_, number_, 1 + character_count(line_.substr(0, at)), std::move(what),
                         std::string(expected), std::move(nearest)});
  }
  void report(const JsonPath& path, std::string what, std::string_view expected) {
    report_at(find_value(line_, 0, path), std::move(what), expected);
  }

  void read_line(bool ends) {
    json value;
    try {
      value = json::parse(line_);
    } catch (const json::parse_error& error) {
      if (!ends && has_head_) {
        log_.cut_off = true;
        return;
      }
      report_at(std::min(error.byte > 0 ? error.byte - 1 : 0, line_.size()), "this is not JSON",
                has_head_ ? "one JSON object a line" : kHead);
      return;
    } catch (const json::exception&) {  // a number too large, the only other one
      report_at(0, "a number of this line is too large for a double",
                R"(magnitudes below 1.8e308, or the string "inf")");
      return;
    }
    if (!value.is_object()) {
      report({}, "this line is " + shown(value), "one JSON object a line");
    } else if (!has_head_) {
      has_head_ = true;
      read_head(value);
    } else if (log_.answer) {
      report({}, "a line follows the answer", "one run a file, which its answer ends");
    } else if (value.contains("answer")) {
      read_answer(value);
    } else {
      read_iteration(value);
    }
  }

  void check_keys(const json& value, const JsonPath& path, const std::vector<std::string>& known) {
    for (const auto& [key, unused] : value.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      report_at(find_value(line_, 0, below(path, key)),
                fmt::format("unknown key '{}'", key.substr(0, 40)),
                fmt::format("one of: {}", fmt::join(known, ", ")), nearest_name(key, known));
    }
  }

  /// Whether the key is there.
  static const json* member(const json& value, const char* key) {
    const auto found = value.find(key);
    return found == value.end() ? nullptr : &*found;
  }

  void read_head(const json& value) {
    check_keys(value, {}, kHeadKeys);
    const json* version = member(value, "gjk_log");
    if (version == nullptr || *version != 1) {
      report(
          version == nullptr ? JsonPath{} : JsonPath{"gjk_log"},
          version == nullptr ? "the first line has no 'gjk_log'" : "/gjk_log is " + shown(*version),
          kHead);
      return;
    }
    if (const json* given = member(value, "difference")) {
      if (*given != "b-a" && *given != "a-b")
        report({"difference"}, "/difference is " + shown(*given), R"("b-a" or "a-b")");
      log_.a_is_x = *given != "a-b";
    }
    if (const json* given = member(value, "scalar")) {
      const std::optional<ScalarKind> kind =
          given->is_string() ? value_of<ScalarKind>(given->get<std::string>()) : std::nullopt;
      if (!kind || *kind == ScalarKind::exact)
        report({"scalar"}, "/scalar is " + shown(*given), R"("double", "float" or "half")");
      log_.scalar = kind.value_or(ScalarKind::double_);
    }
    if (const json* given = member(value, "tolerance")) {
      log_.tolerance = number_in(*given).value_or(-1);
      if (!(0 <= log_.tolerance && log_.tolerance < 1))
        report({"tolerance"}, "/tolerance is " + shown(*given), "a number from 0 to below 1");
    }
    read_dimension(value);
    if (!problems_.empty()) return;
    std::vector<Point> a = read_shape(value, "a");
    std::vector<Point> b = read_shape(value, "b");
    if (!log_.a_is_x) std::swap(a, b);
    log_.x = std::move(a);
    log_.y = std::move(b);
    has_shapes_ = problems_.empty();
  }

  /// Takes the dimension from its key or, without one, from the first point.
  void read_dimension(const json& value) {
    if (const json* given = member(value, "dimension")) {
      if (*given != 2 && *given != 3)
        report({"dimension"}, "/dimension is " + shown(*given), "2, the plane, or 3, space");
      else
        log_.dimension = given->get<int>();
      return;
    }
    const json* a = member(value, "a");
    if (a != nullptr && a->is_array() && !a->empty() && (*a)[0].is_array() && (*a)[0].size() == 3)
      log_.dimension = 3;
  }

  std::vector<Point> read_shape(const json& value, const char* key) {
    const json* list = member(value, key);
    if (list == nullptr) {
      report({}, fmt::format("the first line has no '{}'", key), kHead);
      return {};
    }
    if (list->is_array() && list->empty()) report({key}, fmt::format("/{} is empty", key), kHead);
    std::vector<Point> points = read_points(*list, {key});
    for (std::size_t i = 0; i < points.size() && problems_.size() < kListedProblems; ++i) {
      if (!points[i].allFinite())
        report({key, std::to_string(i)}, fmt::format("/{}/{} is not finite", key, i),
               "finite numbers");
    }
    return points;
  }

  std::optional<Point> read_point(const json& value, const JsonPath& path) {
    const auto size = static_cast<std::size_t>(log_.dimension);
    Point point = Point::Zero();
    bool good = value.is_array() && value.size() == size;
    for (std::size_t i = 0; good && i < size; ++i) {
      const std::optional<double> number = number_in(value[i]);
      good = number.has_value();
      point[static_cast<int>(i)] = number.value_or(0);
    }
    if (good) return point;
    report(path, fmt::format("/{} is {}", fmt::join(path, "/"), shown(value)),
           log_.dimension == 2 ? "two numbers, [x, y]" : "three numbers, [x, y, z]");
    return std::nullopt;
  }

  std::optional<gjk::VertexPair> read_pair(const json& value, const JsonPath& path) {
    const int a_count = static_cast<int>((log_.a_is_x ? log_.x : log_.y).size());
    const int b_count = static_cast<int>((log_.a_is_x ? log_.y : log_.x).size());
    const auto is_index = [](const json& index, int count) {
      return index.is_number_unsigned() &&
             index.get<std::uint64_t>() < static_cast<std::uint64_t>(count);
    };
    if (!value.is_array() || value.size() != 2 || !is_index(value[0], a_count) ||
        !is_index(value[1], b_count)) {
      report(path, fmt::format("/{} is {}", fmt::join(path, "/"), shown(value)),
             fmt::format("[index in a, index in b], from 0 to {} and to {}", a_count - 1,
                         b_count - 1));
      return std::nullopt;
    }
    const int a = value[0].get<int>();
    const int b = value[1].get<int>();
    return log_.a_is_x ? gjk::VertexPair{a, b} : gjk::VertexPair{b, a};
  }

  template <class Each>
  auto read_list(const json& list, const JsonPath& path, const Each& each) {
    std::vector<typename decltype(each(list, path))::value_type> out;
    if (!list.is_array()) {
      report(path, fmt::format("/{} is {}", fmt::join(path, "/"), shown(list)), "an array");
      return out;
    }
    for (std::size_t i = 0; i < list.size() && problems_.size() < kListedProblems; ++i) {
      if (auto read = each(list[i], below(path, std::to_string(i)))) out.push_back(*read);
    }
    return out;
  }
  std::vector<Point> read_points(const json& list, const JsonPath& path) {
    return read_list(list, path, [this](const json& value, const JsonPath& at) {
      return read_point(value, at);
    });
  }

  void read_iteration(const json& value) {
    check_keys(value, {}, kIterationKeys);
    Iteration out;
    out.line = number_;
    for (const auto& [key, list] :
         {std::pair{"simplex", &out.simplex}, std::pair{"kept", &out.kept}}) {
      if (const json* given = member(value, key))
        *list = read_list(*given, {key}, [this](const json& pair, const JsonPath& at) {
          return read_pair(pair, at);
        });
    }
    for (const auto& [key, list] :
         {std::pair{"points", &out.points}, std::pair{"kept_points", &out.kept_points}}) {
      if (const json* given = member(value, key)) *list = read_points(*given, {key});
    }
    if (const json* given = member(value, "weights"))
      out.weights = read_list(*given, {"weights"}, [this](const json& weight, const JsonPath& at) {
        const std::optional<double> number = number_in(weight);
        if (!number)
          report(at, fmt::format("/{} is {}", fmt::join(at, "/"), shown(weight)), "a number");
        return number;
      });
    for (const auto& [key, point] :
         {std::pair{"closest", &out.closest}, std::pair{"direction", &out.direction},
          std::pair{"support_point", &out.support_point}}) {
      if (const json* given = member(value, key)) *point = read_point(*given, {key});
    }
    if (const json* given = member(value, "support")) out.support = read_pair(*given, {"support"});
    if (!problems_.empty()) return;
    check_count("points", out.points.size(), "simplex", out.simplex.size());
    check_count("kept_points", out.kept_points.size(), "kept", out.kept.size());
    const std::size_t kept = std::max(out.kept.size(), out.kept_points.size());
    const std::size_t whole = std::max(out.simplex.size(), out.points.size());
    check_count("weights", out.weights.size(), kept > 0 ? "kept" : "simplex",
                kept > 0 ? kept : whole);
    log_.iterations.push_back(std::move(out));
  }

  void check_count(const char* key, std::size_t count, const char* of, std::size_t expected) {
    if (count == 0 || expected == 0 || count == expected) return;
    report({key}, fmt::format("/{} has {} entries, /{} has {}", key, count, of, expected),
           "as many");
  }

  void read_answer(const json& value) {
    check_keys(value, {}, {"answer"});
    const json& given = value["answer"];
    if (!given.is_object()) {
      report({"answer"}, "/answer is " + shown(given),
             R"({"distance":..., "overlap":true or false})");
      return;
    }
    check_keys(given, {"answer"}, kAnswerKeys);
    Answer out;
    out.line = number_;
    for (const auto& [key, number] :
         {std::pair{"distance", &out.distance}, std::pair{"depth", &out.depth}}) {
      const json* number_given = member(given, key);
      if (number_given == nullptr) continue;
      *number = number_in(*number_given);
      if (!*number)
        report({"answer", key}, fmt::format("/answer/{} is {}", key, shown(*number_given)),
               "a number");
    }
    if (const json* overlap = member(given, "overlap")) {
      if (overlap->is_boolean())
        out.overlap = overlap->get<bool>();
      else
        report({"answer", "overlap"}, "/answer/overlap is " + shown(*overlap), "true or false");
    }
    for (const auto& [key, point] : {std::pair{"a", log_.a_is_x ? &out.x : &out.y},
                                     std::pair{"b", log_.a_is_x ? &out.y : &out.x}}) {
      if (const json* at = member(given, key)) *point = read_point(*at, {"answer", key});
    }
    if (const json* by = member(given, "translation")) {
      out.translation = read_point(*by, {"answer", "translation"});
      if (out.translation && !log_.a_is_x) *out.translation = -*out.translation;
    }
    log_.answer = out;
  }

  std::string file_;
  std::string_view line_;
  int number_ = 0;
  bool has_head_ = false;
  bool has_shapes_ = false;  ///< Without them the other lines say nothing.
  Log log_;
  std::vector<Problem> problems_;
};

}  // namespace

ReadLog read_log(std::string_view text, std::string_view file) { return Reader(file).read(text); }

}  // namespace gjkscope::judging
