#include "lesson/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/decimal.hpp"
#include "lesson/json_place.hpp"
#include "lesson/paste.hpp"
#include "lesson/plane.hpp"
#include "lesson/schema.hpp"
#include "outlines/nearest.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using json = nlohmann::ordered_json;

/// Problems of one case beyond these are counted, not listed.
constexpr std::size_t kListedProblems = 20;

/// After so many values that are not JSON a text is read no further.
constexpr int kMostBroken = 100;

using Path = JsonPath;

/// The outline around points, exactly (Andrew 1979, monotone chain): what a set of points is beside
/// outlines. At least two points, of which both may be the same.
models::Outline hull_of(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), models::before);
  std::vector<Vector2d> hull;
  for (int way = 0; way < 2; ++way) {
    const std::size_t floor = std::max<std::size_t>(hull.size(), 1);
    for (const Vector2d& point : points) {
      while (hull.size() > floor && models::turn(hull[hull.size() - 2], hull.back(), point) <= 0)
        hull.pop_back();
      if (hull.empty() || hull.back() != point) hull.push_back(point);
    }
    std::reverse(points.begin(), points.end());
  }
  if (hull.size() > 2 && hull.front() == hull.back()) hull.pop_back();
  if (hull.size() == 1) hull.push_back(hull.front());
  return {std::move(hull)};
}

/// The need of a method that outlines with this fault do not meet.
std::string_view expected_of(models::Needs needs, models::Fault fault) {
  if (needs == models::Needs::convex) return "one convex outline";
  if (needs == models::Needs::simple)
    return "closed outlines that meet neither themselves nor each other, for this method";
  return fault == models::Fault::open_chain ? "closed outlines: chains are not traced"
                                            : "outlines of at least two finite points";
}

class CaseReader {
 public:
  CaseReader(std::string_view text, std::string_view file, int most_dimension,
             std::optional<models::Needs> outlines, const CaseLimits& limits)
      : text_(text),
        file_(file),
        most_dimension_(most_dimension),
        outlines_(outlines),
        limits_(limits) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') line_starts_.push_back(i + 1);
    }
  }

  std::vector<ReadCase> read() {
    std::size_t at = skip_space(text_, text_.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
    if (at == text_.size()) {
      ReadCase& none = add(at);
      report(none, at, "there is no case", kShape);
    }
    while (at < text_.size()) {
      const std::size_t end = std::max(skip_value(text_, at), at + 1);
      at = skip_space(text_, read_value(at, end));
    }
    return std::move(cases_);
  }

 private:
  static constexpr std::string_view kShape =
      R"({"dimension": 2, "a": [[x, y], ...], "b": [[x, y], ...]})";

  ReadCase& add(std::size_t at) {
    ReadCase& added = cases_.emplace_back();
    added.place = place_at(at);
    added.name = cases_.size() == 1 ? file_ : fmt::format("{}#{}", file_, cases_.size());
    return added;
  }

  void report(ReadCase& to, std::size_t at, std::string what, std::string_view expected) const {
    if (to.problems.size() == kListedProblems) return;
    const Place place = place_at(at);
    to.problems.push_back(
        {file_, place.line, place.column, std::move(what), std::string(expected), ""});
  }

  /// The place of the value at `path`, as seen from `at`; looked for only where it will be listed.
  void report(ReadCase& to, std::size_t at, const Path& path, std::string what,
              std::string_view expected) const {
    if (to.problems.size() < kListedProblems)
      report(to, find_value(text_, at, path), std::move(what), expected);
  }

  [[nodiscard]] Place place_at(std::size_t at) const {
    at = std::min(at, text_.size());
    const auto line = std::upper_bound(line_starts_.begin(), line_starts_.end(), at) - 1;
    if (counted_to_ < *line || counted_to_ > at) {
      counted_to_ = *line;
      column_ = 1;
    }
    column_ += character_count(text_.substr(counted_to_, at - counted_to_));
    counted_to_ = at;
    return {1 + static_cast<int>(line - line_starts_.begin()), column_};
  }

  /// Reads the value in [at, end); returns where to go on.
  std::size_t read_value(std::size_t at, std::size_t end) {
    const std::string_view part = text_.substr(at, end - at);
    json value;
    try {
      value = json::parse(part);
    } catch (const json::parse_error& error) {
      const std::size_t place = at + (error.byte > 0 ? error.byte - 1 : 0);
      report(add(at), place, "this is not JSON: " + reason(error.what()), kShape);
      return after_error(at, end);
    } catch (const json::exception& error) {
      // The only other one is a number too large, which the message quotes.
      const std::string message = error.what();
      const std::size_t open = message.find('\'');
      const std::size_t close = message.rfind('\'');
      const std::string number =
          open < close ? message.substr(open + 1, close - open - 1) : std::string();
      const std::size_t found = part.find(number);
      report(add(at), at + (found == std::string_view::npos ? 0 : found),
             fmt::format("the number {} is too large for a double", number),
             "magnitudes below 1.8e308");
      return end;
    }
    if (value.is_array() && (value.empty() || !value[0].is_number())) {
      std::size_t next = skip_space(text_, at + 1);
      for (const json& each : value) {
        read_case(each, next);
        next = skip_space(text_, skip_space(text_, skip_value(text_, next)) + 1);  // the comma
      }
      if (value.empty()) report(add(at), at, "the array holds no case", kShape);
    } else {
      read_case(value, at);
    }
    return end;
  }

  /// A case with a bracket too few swallows what follows. When cases stand one a line, go on with
  /// the next line that begins one.
  [[nodiscard]] std::size_t after_error(std::size_t at, std::size_t end) {
    if (text_[at] != '{' || ++broken_ == kMostBroken) return text_.size();
    for (std::size_t line = text_.find('\n', at); line < end; line = text_.find('\n', line + 1)) {
      if (line + 1 < end && text_[line + 1] == '{') return line + 1;
    }
    return end;
  }

  /// The library's message without its identifiers and position, which the problem has.
  [[nodiscard]] static std::string reason(std::string_view message) {
    const std::size_t colon = message.find(": ");
    return std::string(colon == std::string_view::npos ? message : message.substr(colon + 2));
  }

  void read_case(const json& value, std::size_t at) {
    ReadCase& out = add(at);
    if (!value.is_object()) {
      report(out, at, fmt::format("a case is {}", article(value)), kShape);
      return;
    }
    if (const auto name = value.find("name"); name != value.end() && name->is_string()) {
      out.name = name->get<std::string>();
    }
    read_notes(value, out.notes);
    const auto found = value.find("dimension");
    const json dimension = found == value.end() ? json(2) : *found;
    const bool has_outlines = value.contains("outlines_a") || value.contains("outlines_b");
    if (outlines_ && has_outlines && dimension == 2) {
      read_models(value, at, out);
    } else if (dimension == 2) {
      out.value = read_shapes<2>(value, at, out);
    } else if (dimension == 3 && most_dimension_ == 3) {
      out.in_space = read_shapes<3>(value, at, out);
    } else {
      report(out, at, {"dimension"}, fmt::format("/dimension is {}", shown(dimension)),
             most_dimension_ == 2 ? "2: the plane" : "2, the plane, or 3, space");
    }
  }

  static void read_notes(const json& value, CaseNotes& notes) {
    const auto text = [&](const char* key, std::string& to) {
      if (const auto found = value.find(key); found != value.end() && found->is_string())
        to = found->get<std::string>();
    };
    text("why", notes.why);
    text("source", notes.source);
    if (const auto found = value.find("expected_distance"); found != value.end())
      notes.expected_distance = number_in(*found);
    if (const auto found = value.find("expected_overlap");
        found != value.end() && found->is_boolean())
      notes.expected_overlap = found->get<bool>();
  }

  template <int D>
  std::optional<CaseIn<D>> read_shapes(const json& value, std::size_t at, ReadCase& out) const {
    CaseIn<D> read;
    read.a = read_points<D>(value, "a", at, out);
    read.b = read_points<D>(value, "b", at, out);
    if (!out.problems.empty()) return std::nullopt;
    return read;
  }

  template <int D>
  std::vector<gjk::Vec<double, D>> read_points(const json& value, const char* key, std::size_t at,
                                               ReadCase& out) const {
    const auto list = value.find(key);
    if (list == value.end()) {
      report(out, at, fmt::format("/{} is missing", key), kShape);
      return {};
    }
    return read_list<D>(*list, {key}, at, out);
  }

  /// The points of the array at `path`.
  template <int D>
  std::vector<gjk::Vec<double, D>> read_list(const json& list, const Path& path, std::size_t at,
                                             ReadCase& out) const {
    std::vector<gjk::Vec<double, D>> points;
    if (!list.is_array() || list.empty()) {
      report(out, at, path,
             fmt::format("{} is {}", shown(path), list.is_array() ? "empty" : article(list)),
             D == 2 ? "an array of at least one point, [[x, y], ...]"
                    : "an array of at least one point, [[x, y, z], ...]");
      return points;
    }
    if (list.size() > limits_.points) {
      report(out, at, path, fmt::format("{} has {} points", shown(path), list.size()),
             fmt::format("at most {}", limits_.points));
      return points;
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
      const json& point = list[i];
      const Path to_point = below(path, std::to_string(i));
      if (!point.is_array() || point.size() != D) {
        report(out, at, to_point,
               point.is_array()
                   ? fmt::format("{} has {} coordinates", shown(to_point), point.size())
                   : fmt::format("{} is {}", shown(to_point), article(point)),
               D == 3                 ? "three coordinates, [x, y, z]"
               : most_dimension_ == 2 ? "two coordinates, [x, y]"
                                      : "two coordinates, [x, y], or \"dimension\": 3");
        continue;
      }
      gjk::Vec<double, D> read = gjk::Vec<double, D>::Zero();
      for (int k = 0; k < D; ++k) {
        const json& given = point[k];
        const std::optional<double> number = number_in(given);
        const bool is_finite = number && std::isfinite(*number);
        if (is_finite && std::abs(*number) <= limits_.magnitude) {
          read[k] = *number;
        } else {
          const Path to_number = below(to_point, std::to_string(k));
          report(out, at, to_number, fmt::format("{} is {}", shown(to_number), shown(given)),
                 is_finite ? fmt::format("a number from -{0} to {0}", limits_.magnitude)
                           : "a finite number, or a string that holds one");
        }
      }
      points.push_back(read);
    }
    return points;
  }

  void read_models(const json& value, std::size_t at, ReadCase& out) const {
    const auto read_one = [&](const char* outlines, const char* points) {
      if (value.contains(outlines) || !value.contains(points))
        return read_outlines(value, outlines, at, out);
      std::vector<Vector2d> read = read_points<2>(value, points, at, out);
      return std::vector<models::Outline>{hull_of(std::move(read))};
    };
    OutlineCase read;
    read.a = read_one("outlines_a", "a");
    read.b = read_one("outlines_b", "b");
    if (out.problems.empty()) out.outlines = std::move(read);
  }

  std::vector<models::Outline> read_outlines(const json& value, const char* key, std::size_t at,
                                             ReadCase& out) const {
    static constexpr std::string_view kExpected =
        R"(an array of outlines, [[[x, y], ...], ...]; {"open": [[x, y], ...]} is an open chain)";
    const auto list = value.find(key);
    if (list == value.end() || !list->is_array()) {
      const bool missing = list == value.end();
      report(out, at, missing ? Path{} : Path{key},
             missing ? fmt::format("/{} is missing", key)
                     : fmt::format("/{} is {}", key, article(*list)),
             kExpected);
      return {};
    }
    const std::size_t before = out.problems.size();
    std::vector<models::Outline> outlines;
    for (std::size_t i = 0; i < list->size(); ++i) {
      const json& given = (*list)[i];
      const Path path = {key, std::to_string(i)};
      const auto open = given.is_object() ? given.find("open") : given.end();
      models::Outline outline;
      outline.closed = !given.is_object();
      if (given.is_object() && open == given.end()) {
        report(out, at, path, fmt::format("{} has no 'open'", shown(path)), kExpected);
        continue;
      }
      outline.points = outline.closed ? read_list<2>(given, path, at, out)
                                      : read_list<2>(*open, below(path, "open"), at, out);
      if (outline.closed && outline.points.size() > 2 &&
          outline.points.front() == outline.points.back()) {
        outline.points.pop_back();
      }
      outlines.push_back(std::move(outline));
    }
    if (out.problems.size() == before) report_flaw(outlines, key, at, out);
    return outlines;
  }

  void report_flaw(const std::vector<models::Outline>& outlines, const char* key, std::size_t at,
                   ReadCase& out) const {
    const models::Flaw flaw = models::check(outlines, *outlines_);
    if (flaw.fault == models::Fault::none) return;
    Path path = {key};
    std::string what;
    if (flaw.fault != models::Fault::no_outline) {
      path.push_back(std::to_string(flaw.outline));
      const bool is_open = !outlines[flaw.outline].closed;
      if (is_open) path.emplace_back("open");
      if (flaw.other_index >= 0) {
        path.push_back(std::to_string(flaw.index));
        what = fmt::format("; its segment meets segment {} of outline {}", flaw.other_index,
                           flaw.other_outline);
      }
    }
    report(out, at, path, fmt::format("{}: {}{}", shown(path), models::name_of(flaw.fault), what),
           expected_of(*outlines_, flaw.fault));
  }

  [[nodiscard]] static Path below(Path path, std::string key) {
    path.push_back(std::move(key));
    return path;
  }
  [[nodiscard]] static std::string shown(const Path& path) {
    return fmt::format("/{}", fmt::join(path, "/"));
  }

  [[nodiscard]] static std::string article(const json& value) {
    const std::string_view type = value.type_name();
    if (type == "null") return "null";
    return fmt::format("{} {}", type == "object" || type == "array" ? "an" : "a", type);
  }

  [[nodiscard]] static std::string shown(const json& value) {
    constexpr std::size_t kLongest = 40;
    if (value.is_structured()) return article(value);
    std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return text;
  }

  std::string_view text_;
  std::string file_;
  int most_dimension_;
  std::optional<models::Needs> outlines_;
  CaseLimits limits_;
  std::vector<std::size_t> line_starts_ = {0};
  // The last place asked for: a line may hold many cases, and is counted once.
  mutable std::size_t counted_to_ = 0;
  mutable int column_ = 1;
  std::vector<ReadCase> cases_;
  int broken_ = 0;
};

template <int D>
std::string points_json(const std::vector<gjk::Vec<double, D>>& points) {
  std::vector<std::string> written;
  for (const gjk::Vec<double, D>& point : points) {
    assert(point.allFinite());
    std::vector<std::string> numbers;
    for (const double value : point) numbers.push_back(decimal(value));
    written.push_back(fmt::format("[{}]", fmt::join(numbers, ", ")));
  }
  return fmt::format("[{}]", fmt::join(written, ", "));
}

template <class Point>
LessonShape shape_of(const std::vector<Point>& points, std::string name, char letter) {
  LessonShape shape;
  shape.name = std::move(name);
  shape.vertices = in_space(points);
  shape.vertex_names = numbered_names(letter, points.size());
  return shape;
}

Lesson lesson_named(std::string_view name) {
  Lesson lesson;
  lesson.id = name;
  lesson.path = name;
  lesson.title = name;
  return lesson;
}

LessonShape shape_of(const std::vector<models::Outline>& outlines, std::string name, char letter) {
  std::vector<Vector2d> points;
  std::vector<int> counts;
  for (const models::Outline& outline : outlines) {
    assert(outline.closed);
    points.insert(points.end(), outline.points.begin(), outline.points.end());
    counts.push_back(static_cast<int>(outline.points.size()));
  }
  LessonShape shape = shape_of(points, std::move(name), letter);
  if (counts.size() > 1) shape.outlines = std::move(counts);
  return shape;
}

// ---- pasted ----

/// Whether a text shall be read as the JSON of cases: it has a key of such, or nothing else to
/// read.
bool is_json_case(std::string_view text) {
  if (text.find_first_of("0123456789") == std::string_view::npos) return true;
  std::size_t at = skip_space(text, text.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  if (text[at] == '[') at = find_value(text, at, {"0"});
  if (text[at] != '{' && text[at] != '[' && text[at] != '(')
    return skip_space(text, skip_value(text, at)) == text.size();
  for (const char* key : {"a", "b", "outlines_a", "outlines_b", "dimension"}) {
    if (text[at] != '{') break;
    const std::size_t found = find_value(text, at, {key});
    // Shapes in a case may be in other forms.
    if (found != at) return found == text.size() || (text[found] != '{' && text[found] != '"');
  }
  return false;
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// "4 vertices", or "1 outline and 1 hole of 9 vertices"; `short_form`: "4".
std::string description(const PastedShape& shape, bool as_outlines, bool short_form) {
  std::string vertices = short_form ? fmt::format("{}", shape.points.size())
                                    : counted(shape.points.size(), "vertex", "vertices");
  if (!as_outlines) return vertices;
  std::array<std::size_t, 3> count = {};
  for (const PastedPart& part : shape.parts) ++count[static_cast<std::size_t>(part.kind)];
  const auto [rings, holes, chains] = count;
  std::string out;
  if (rings > 0) out = counted(rings, "outline", "outlines");
  if (chains > 0) out = counted(chains, "open chain", "open chains");
  if (holes > 0) out += " and " + counted(holes, "hole", "holes");
  return out + " of " + vertices;
}

/// An outline that is its own hull, or so little that its points say all: points.
bool is_its_hull(const PastedShape& shape) {
  if (shape.parts.size() != 1) return shape.parts.empty();
  if (shape.points.size() < 3) return true;
  models::Outline outline;
  for (const Eigen::Vector3d& point : shape.points) outline.points.push_back(point.head<2>());
  return shape.parts[0].kind == PastedPart::Kind::ring && models::is_convex(outline);
}

template <int D>
std::vector<gjk::Vec<double, D>> points_of(const PastedShape& shape) {
  std::vector<gjk::Vec<double, D>> points;
  for (std::size_t part = 0, i = 0; i < shape.points.size(); ++i) {
    while (part + 1 < shape.parts.size() && shape.parts[part + 1].first <= i) ++part;
    if (shape.parts.empty() || shape.parts[part].kind != PastedPart::Kind::hole)
      points.push_back(shape.points[i].head<D>());
  }
  return points;
}

std::vector<models::Outline> outlines_of(const PastedShape& shape) {
  if (shape.parts.empty()) return {hull_of(points_of<2>(shape))};
  std::vector<models::Outline> outlines;
  for (std::size_t part = 0, i = 0; i < shape.points.size(); ++i) {
    if (part < shape.parts.size() && shape.parts[part].first == i)
      outlines.push_back({{}, shape.parts[part++].kind != PastedPart::Kind::chain});
    outlines.back().points.push_back(shape.points[i].head<2>());
  }
  return outlines;
}

ReadCase case_of(const Pasted& pasted, std::string name, int most_dimension,
                 std::optional<models::Needs> needs, const CaseLimits& limits) {
  ReadCase out;
  out.name = std::move(name);
  out.problems = pasted.problems;
  if (!out.problems.empty()) {
    out.place = {out.problems[0].line, out.problems[0].column};
    return out;
  }
  out.place = pasted.shapes[0].place;
  const auto report = [&](const PastedShape& shape, Place place, std::string what,
                          std::string expected) {
    out.problems.push_back(
        {shape.file, place.line, place.column, std::move(what), std::move(expected), ""});
  };
  if (pasted.shapes.size() < 2) {
    out.has_one_shape = true;
    report(pasted.shapes[0], pasted.end,
           "there is one shape, of " + description(pasted.shapes[0], false, false),
           "a second one, Y");
    return out;
  }
  const std::array<const PastedShape*, 2> shapes = {&pasted.shapes[0], &pasted.shapes[1]};
  std::array<bool, 2> dented = {};
  for (std::size_t i = 0; i < 2; ++i) {
    const PastedShape& shape = *shapes[i];
    const char letter = i == 0 ? 'X' : 'Y';
    dented[i] = shape.was_outline || !is_its_hull(shape);
    double largest = 0.0;
    for (const Eigen::Vector3d& point : shape.points)
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
    if (shape.dimension != shapes[0]->dimension) {
      report(shape, shape.place, fmt::format("a point has {} coordinates", shape.dimension),
             fmt::format("{}, as in X", shapes[0]->dimension));
    } else if (shape.dimension > most_dimension) {
      report(shape, shape.place, "the points are in space", "two coordinates: the plane");
    } else if (shape.points.size() > limits.points) {
      report(shape, shape.place, fmt::format("{} has {} points", letter, shape.points.size()),
             fmt::format("at most {}", limits.points));
    } else if (largest > limits.magnitude) {
      report(shape, shape.place, fmt::format("{} has a coordinate of {}", letter, largest),
             fmt::format("numbers from -{0} to {0}", limits.magnitude));
    }
  }
  const bool in_plane = shapes[0]->dimension == 2;
  if (needs && in_plane && (dented[0] || dented[1])) {
    OutlineCase value{outlines_of(*shapes[0]), outlines_of(*shapes[1])};
    for (const auto& [shape, outlines] : {std::pair(shapes[0], &value.a), {shapes[1], &value.b}}) {
      const models::Flaw flaw = models::check(*outlines, *needs);
      if (flaw.fault != models::Fault::none && out.problems.empty()) {
        report(
            *shape, shape->place,
            fmt::format("outline {} of this shape: {}", flaw.outline, models::name_of(flaw.fault)),
            std::string(expected_of(*needs, flaw.fault)));
      }
    }
    if (out.problems.empty()) out.outlines = std::move(value);
  } else if (out.problems.empty() && in_plane) {
    out.value = Case{points_of<2>(*shapes[0]), points_of<2>(*shapes[1])};
  } else if (out.problems.empty()) {
    out.in_space = CaseIn<3>{points_of<3>(*shapes[0]), points_of<3>(*shapes[1])};
  }
  if (!out.problems.empty()) return out;
  const std::array<bool, 2> as_outlines = {dented[0] && in_plane, dented[1] && in_plane};
  out.understood = fmt::format(
      "X has {}, Y {}, in {}", description(*shapes[0], as_outlines[0], false),
      description(*shapes[1], as_outlines[1], !as_outlines[0]), in_plane ? "the plane" : "space");
  if (!out.outlines && (dented[0] || dented[1])) {
    out.understood += fmt::format("; the hull of {} counts", dented[0] && dented[1] ? "both"
                                                             : dented[0]            ? "X"
                                                                                    : "Y");
  }
  if (!pasted.left_out.empty())
    out.understood += fmt::format("; left out: {}", fmt::join(pasted.left_out, ", "));
  return out;
}

}  // namespace

CaseLimits CaseLimits::of_lessons() {
  return {static_cast<std::size_t>(limits::kVertices), limits::kLargest};
}

std::vector<ReadCase> parse_cases(std::string_view text, std::string_view file, int most_dimension,
                                  std::optional<models::Needs> outlines, const CaseLimits& limits) {
  if (is_json_case(text)) return CaseReader(text, file, most_dimension, outlines, limits).read();
  return {case_of(read_pasted(text, file), std::string(file), most_dimension, outlines, limits)};
}

std::optional<ReadCase> paired_case(const NamedText& x, const NamedText& y, int most_dimension,
                                    std::optional<models::Needs> outlines) {
  if (is_json_case(x.text) || is_json_case(y.text)) return std::nullopt;
  Pasted both = read_pasted(x.text, x.file);
  Pasted second = read_pasted(y.text, y.file);
  if (both.shapes.size() != 1 || second.shapes.size() != 1) return std::nullopt;
  both.shapes.push_back(std::move(second.shapes.front()));
  for (std::string& each : second.left_out) {
    if (std::find(both.left_out.begin(), both.left_out.end(), each) == both.left_out.end())
      both.left_out.push_back(std::move(each));
  }
  return case_of(both, fmt::format("{}, {}", x.file, y.file), most_dimension, outlines, {});
}

template <int D>
std::string case_json(const CaseIn<D>& value, std::string_view name) {
  std::string out = "{";
  if (!name.empty()) {
    const std::string text = json(name).dump(-1, ' ', false, json::error_handler_t::replace);
    out += fmt::format(R"("name": {}, )", text);
  }
  return out +
         fmt::format(R"("dimension": {}, "a": {}, "b": {}}})", D, points_json<D>(value.a),
                     points_json<D>(value.b)) +
         "\n";
}

template std::string case_json(const CaseIn<2>& value, std::string_view name);
template std::string case_json(const CaseIn<3>& value, std::string_view name);

template <int D>
std::optional<std::string> case_json_kept(std::string_view original, const CaseIn<D>& value) {
  const std::vector<ReadCase> there = parse_cases(original, "", D);
  if (there.size() != 1 || !there.front().understood.empty()) return std::nullopt;
  const CaseIn<D>* before = nullptr;
  if constexpr (D == 3) {
    if (there.front().in_space) before = &*there.front().in_space;
  } else {
    if (there.front().value) before = &*there.front().value;
  }
  if (before == nullptr) return std::nullopt;
  using Ordered = nlohmann::ordered_json;
  Ordered all = Ordered::parse(original.substr(original.starts_with("\xEF\xBB\xBF") ? 3 : 0));
  Ordered& it = all.is_array() ? all[0] : all;
  const bool moved = before->a != value.a || before->b != value.b;
  if (!moved) return std::string(original);
  std::vector<std::string> untrue;
  for (const auto& [key, each] : it.items()) {
    if (key.starts_with("expected_") || key.starts_with("witness_")) untrue.push_back(key);
  }
  for (const std::string& key : untrue) it.erase(key);
  // A key on each line.
  std::string out;
  for (const auto& [key, each] : it.items()) {
    const auto text = [](const Ordered& json) {
      return json.dump(-1, ' ', false, Ordered::error_handler_t::replace);
    };
    out += fmt::format("{}  {}: {}", out.empty() ? "" : ",\n", text(key),
                       key == "a"   ? points_json<D>(value.a)
                       : key == "b" ? points_json<D>(value.b)
                                    : text(each));
  }
  return fmt::format("{}{{\n{}\n}}{}\n", all.is_array() ? "[" : "", out, all.is_array() ? "]" : "");
}

template std::optional<std::string> case_json_kept(std::string_view original,
                                                   const CaseIn<2>& value);
template std::optional<std::string> case_json_kept(std::string_view original,
                                                   const CaseIn<3>& value);

std::vector<std::string> numbered_names(char letter, std::size_t vertices) {
  std::vector<std::string> out;
  for (std::size_t i = 1; i <= vertices; ++i) out.push_back(fmt::format("{}{}", letter, i));
  return out;
}

template <int D>
Lesson lesson_of(const CaseIn<D>& value, std::string_view name, ScalarKind scalar) {
  Lesson lesson = lesson_named(name);
  lesson.dimension = D;
  lesson.x() = shape_of(value.a, "X", 'x');
  lesson.y() = shape_of(value.b, "Y", 'y');
  lesson.scalar = scalar;
  return lesson;
}

template Lesson lesson_of(const CaseIn<2>& value, std::string_view name, ScalarKind scalar);
template Lesson lesson_of(const CaseIn<3>& value, std::string_view name, ScalarKind scalar);

Lesson lesson_of(const OutlineCase& value, std::string_view name) {
  Lesson lesson = lesson_named(name);
  lesson.x() = shape_of(value.a, "X", 'x');
  lesson.y() = shape_of(value.b, "Y", 'y');
  return lesson;
}

}  // namespace gjkscope
