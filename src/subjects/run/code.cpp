#include "subjects/run/code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "subjects/run/subject.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::code {
namespace {

using gjk::Face;
using gjk::Phase;

constexpr std::string_view kCpp = ".cpp";
constexpr std::string_view kPython = ".py";

/// A line that steps stand for.
enum class Line : std::uint8_t {
  start,
  vertex,  // regions of a single vertex, a segment AB and a triangle ABC
  segment_numbers,
  segment_b,
  segment_a,
  segment_ab,
  triangle_numbers,
  triangle_a,
  triangle_b,
  triangle_c,
  triangle_ab,
  triangle_bc,
  triangle_ca,
  triangle_abc,
  simplex,
  call,
  inside,
  from_vertex,
  from_edge,
  support,
  repeated,
  gives_up,
  add,
  farthest,
  simplex_vertex,
};

struct Marked {
  Line line;
  std::string_view cpp;
  std::string_view python;
  std::optional<Phase> phase = {};  ///< A click on the line goes to the next step of this phase.
};

constexpr std::array<Marked, 25> kMarked = {{
    {Line::start, "Simplex s = {{in.start_x", "s = [SimplexVertex(data.start_x"},
    {Line::vertex, "if (s.size() == 1) return s;", "if len(s) == 1: return s", Phase::closest},
    {Line::segment_numbers, "const double ab = edge", "ab, ba = edge", Phase::closest},
    {Line::segment_b, "if (s.size() == 2 && ab <= 0)", "if len(s) == 2 and ab <= 0",
     Phase::closest},
    {Line::segment_a, "if (s.size() == 2 && ba <= 0)", "if len(s) == 2 and ba <= 0",
     Phase::closest},
    {Line::segment_ab, "if (s.size() == 2) return", "if len(s) == 2: return", Phase::closest},
    {Line::triangle_numbers, "const double a = part", "a, b, c = part", Phase::closest},
    {Line::triangle_a, "if (ba <= 0 && ca <= 0)", "if ba <= 0 and ca <= 0", Phase::closest},
    {Line::triangle_b, "if (ab <= 0 && cb <= 0)", "if ab <= 0 and cb <= 0", Phase::closest},
    {Line::triangle_c, "if (bc <= 0 && ac <= 0)", "if bc <= 0 and ac <= 0", Phase::closest},
    {Line::triangle_ab, "if (ab > 0 && ba > 0", "if ab > 0 and ba > 0", Phase::closest},
    {Line::triangle_bc, "if (bc > 0 && cb > 0", "if bc > 0 and cb > 0", Phase::closest},
    {Line::triangle_ca, "if (ca > 0 && ac > 0", "if ca > 0 and ac > 0", Phase::closest},
    {Line::triangle_abc, "return keep(s, a, b, c)", "return keep(s, a, b, c)", Phase::closest},
    {Line::simplex, "inline Simplex closest(", "def closest("},
    {Line::call, "s = closest(s)", "s = closest(s)", Phase::closest},
    {Line::inside, "if (s.size() == 3) return out", "if len(s) == 3: return out", Phase::stop},
    {Line::from_vertex, "Point d = s.size() == 1", "d = -s[0].w if len(s) == 1", Phase::direction},
    {Line::from_edge, "if (dot(d, s[0].w) > 0)", "if dot(d, s[0].w) > 0", Phase::direction},
    {Line::support, "const int far_x = support", "far_x, far_y = support", Phase::support},
    {Line::repeated, "if (v.index_x == far_x", "if v.index_x == far_x", Phase::stop},
    {Line::gives_up, "if (d.isZero(0)", "if d == 0 or", Phase::stop},
    {Line::add, "s.push_back(", "s.append(", Phase::add},
    {Line::farthest, "return best;", "return best", Phase::support},
    {Line::simplex_vertex, "struct SimplexVertex", "class SimplexVertex"},
}};

std::string_view text_of(const Marked& marked, Language language) {
  return language == Language::python ? marked.python : marked.cpp;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    out.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return out;
}

std::string_view without_indent(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  return line;
}

/// The mark of a line of the page; nullptr where no step stands for it.
const Marked* marked_as(std::string_view line, Language language) {
  const auto found = std::find_if(kMarked.begin(), kMarked.end(), [&](const Marked& each) {
    return without_indent(line).starts_with(text_of(each, language));
  });
  return found == kMarked.end() ? nullptr : &*found;
}

// The line of a step
// ---------------------------------------------------------------------------------------------------

/// The line that takes the region of a simplex of `count` vertices.
Line line_of_region(int count, Face region) {
  using enum Line;
  if (count == 1) return vertex;
  if (count == 2) return region == 0b10 ? segment_b : region == 0b01 ? segment_a : segment_ab;
  constexpr std::array<Line, 8> kTriangle = {triangle_abc, triangle_a,  triangle_b,  triangle_ab,
                                             triangle_c,   triangle_ca, triangle_bc, triangle_abc};
  return kTriangle[region];
}

/// The steps of the frame's iteration up to the frame's.
struct Steps {
  explicit Steps(const PanelBuilder& panel) {
    const auto& all = panel.run.run(panel.frame).trace.steps;
    const int now = panel.run.gjk_step(panel.frame);
    for (int i = 0; i <= now; ++i) {
      if (all[i].iteration == all[now].iteration)
        of_phase[static_cast<std::size_t>(all[i].phase)] = &all[i];
    }
  }
  [[nodiscard]] const WideStep* operator[](Phase phase) const {
    return of_phase[static_cast<std::size_t>(phase)];
  }
  std::array<const WideStep*, gjk::kPhaseCount> of_phase = {};
};

/// Whether the panel's listing is this one, in whatever language.
bool is_listing(const PanelBuilder& panel, std::string_view name) {
  const std::string& listing = panel.run.lesson.listing;
  return std::string_view(listing).substr(0, listing.find('.')) == name;
}

bool shows_function(const PanelBuilder& panel) {
  return is_listing(panel, "segment") || is_listing(panel, "triangle");
}

/// The vertices that the closest point was asked of.
int count_before(const Steps& steps) { return steps[Phase::closest]->after.simplex.count; }

/// Nothing where the run ended by a test that the page does without.
std::optional<Line> line_of_stop(const PanelBuilder& panel) {
  using enum gjk::StopReason;
  switch (panel.state.stop) {
    case running:
    case repeated_support:
      return Line::repeated;
    case zero_direction:
    case iteration_cap:
      return Line::gives_up;
    case origin_inside:
      if (panel.state.simplex.count == 3) return Line::inside;
      break;
    default:
      break;
  }
  return std::nullopt;
}

std::optional<Line> line_of_step(const PanelBuilder& panel, const Steps& steps) {
  if (is_listing(panel, "structures")) return Line::simplex_vertex;
  if (panel.run.gjk_step(panel.frame) < 0)
    return shows_function(panel) ? Line::simplex : Line::start;
  const auto& knows = panel.knows;
  const bool is_vertex = panel.state.simplex.count == 1;
  switch (knows.phase.value_or(Phase::closest)) {
    case Phase::closest: {
      const int count = count_before(steps);
      if (!knows.gradual) return line_of_region(count, panel.state.region);
      if (knows.tests_reached < 0)
        return count == 3 ? Line::triangle_numbers : Line::segment_numbers;
      return line_of_region(count, knows.region_tests[knows.tests_reached].region);
    }
    case Phase::drop:
      return Line::call;
    case Phase::direction:
      return is_vertex ? Line::from_vertex : Line::from_edge;
    case Phase::support:
      return is_listing(panel, "support") ? Line::farthest : Line::support;
    case Phase::stop:
      return line_of_stop(panel);
    case Phase::add:
      return Line::add;
  }
  return std::nullopt;
}

// Lines on rows
// ---------------------------------------------------------------------------------------------------

constexpr double kIndent = 6.0;   // of a space at the begin of a line, in frame pixels
constexpr double kNumber = 27.0;  // left of the code: its line's number
constexpr int kRows = 10;
constexpr int kBefore = 2;  // lines in sight above the current one

struct Row {
  double left = 0.0;  ///< From where code begins.
  std::string code;
  std::string comment;  ///< Right of it.
};

/// A line on as many rows as it needs.
std::vector<Row> rows_of(const PanelBuilder& panel, std::string_view line, double room) {
  const auto width = [&](const std::string& text) { return panel.fonts.width(type::kCode, text); };
  const std::string_view sign =
      language_of(panel.run.lesson.listing) == Language::python ? "#" : "//";
  constexpr double kHanging = 2 * kIndent;
  const std::string_view code = without_indent(line);
  std::vector<Row> out(1);
  out[0].left = static_cast<double>(line.size() - code.size()) * kIndent;
  const double hanging = out[0].left + kHanging;
  bool in_comment = false;
  std::size_t at = 0;
  while (at < code.size()) {
    std::size_t end = std::min(code.find(' ', at), code.size());
    // These stay with the word that follows them.
    for (const std::string_view before : {sign, std::string_view("return")}) {
      if (code.substr(at, end - at) == before) end = std::min(code.find(' ', end + 1), code.size());
    }
    const std::string word(code.substr(at, end - at));
    at = std::min(code.find_first_not_of(' ', end), code.size());
    in_comment = in_comment || word.starts_with(sign);
    const bool is_first = out.back().code.empty() && out.back().comment.empty();
    const std::string more = is_first ? word : " " + word;
    if (!is_first && out.back().left + width(out.back().code + out.back().comment + more) > room) {
      out.push_back({hanging, {}, {}});
      (in_comment ? out.back().comment : out.back().code) = word;
    } else {
      (in_comment ? out.back().comment : out.back().code) += more;
    }
  }
  return out;
}

/// The first of the lines in sight, of which `heights` are the rows: the current one stands below
/// `before` others where it can, and the end of the page at the end.
int first_in_sight(const std::vector<int>& heights, int current, int before) {
  const int count = static_cast<int>(heights.size());
  const auto rows_from = [&](int first, int last) {
    int rows = 0;
    for (int i = first; i <= last; ++i) rows += heights[i];
    return rows;
  };
  int first = std::max(current - before, 0);
  while (first < current && rows_from(first, current) > kRows) ++first;
  while (first > 0 && rows_from(first - 1, count - 1) <= kRows) --first;
  return first;
}

void write_rows(PanelBuilder& panel, const std::vector<Row>& rows, int number, bool is_current) {
  const std::string role = is_current ? "code.current" : "code";
  const TextStyle& style = is_current ? type::kCodeBold : type::kCode;
  if (is_current)
    panel.highlight("highlight", static_cast<double>(rows.size() - 1) * rows::kTightRow);
  const double left = panel.left + kNumber;
  panel.write("code.muted", left - 8.0, std::to_string(number), type::kCode, Align::right);
  for (const Row& row : rows) {
    if (!row.code.empty()) panel.write(role, left + row.left, row.code, style);
    const double end = left + row.left + panel.fonts.width(style, row.code);
    // SVG would drop a space at the begin of a text.
    const std::string comment(without_indent(row.comment));
    const double gap =
        panel.fonts.width(type::kCode, std::string(row.comment.size() - comment.size(), ' '));
    if (!comment.empty()) panel.write("code.muted", end + gap, comment, type::kCode);
    panel.y += rows::kTightRow;
  }
}

void write_lines(PanelBuilder& panel, std::optional<Line> shown) {
  const Language language = language_of(panel.run.lesson.listing);
  const Page whole = page(language);
  const std::vector<std::string_view> lines = lines_of(whole.text);
  const double room = panel.right - panel.left - kNumber;
  std::vector<std::vector<Row>> rows;
  std::vector<int> heights;
  int current = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    rows.push_back(rows_of(panel, lines[i], room));
    heights.push_back(static_cast<int>(rows.back().size()));
    const Marked* marked = marked_as(lines[i], language);
    if (marked != nullptr && marked->line == shown.value_or(Line::repeated))
      current = static_cast<int>(i);
  }
  const bool is_struct = shown == Line::simplex_vertex;  // its fields follow it
  int first = first_in_sight(heights, current, is_struct ? 0 : kBefore);
  int last = first;
  const auto height = [&](int line) { return heights[line]; };
  int left = kRows - height(first);
  while (last + 1 < static_cast<int>(lines.size()) && height(last + 1) <= left)
    left -= height(++last);
  while (first > 0 && height(first - 1) <= left) left -= height(--first);
  panel.heading(
      fmt::format("{}, lines {} to {} of {}", whole.name, first + 1, last + 1, lines.size()));
  for (int i = first; i <= last; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Marked* marked = marked_as(lines[at], language);
    if (marked != nullptr && marked->phase)
      panel.subject = {Subject::Kind::phase, static_cast<int>(*marked->phase)};
    write_rows(panel, rows[at], i + 1, shown && i == current);
    panel.subject = {};
  }
  panel.y += left * rows::kTightRow;
}

// Variables
// ---------------------------------------------------------------------------------------------------

/// Writes variables: a name, on its right the value.
struct Variables {
  PanelBuilder& panel;
  /// `is_new`: the current line has set it.
  void row(const std::string& name, const std::string& value, const std::string& what = "",
           bool is_new = false) {
    panel.write("code", panel.left, name, type::kCode);
    panel.write(is_new ? "code.value" : "code", panel.right, value,
                is_new ? type::kCodeBold : type::kCode, Align::right);
    const auto width = [&](const std::string& text) {
      return panel.fonts.width(type::kCode, text);
    };
    constexpr double kGap = 10.0;
    const double at = panel.left + width(name) + kGap;
    if (!what.empty() && at + width(what) + kGap <= panel.right - width(value))
      panel.write("code.muted", at, what, type::kCode);
    panel.y += rows::kTightRow;
  }
  struct Cell {
    std::string name;
    std::string value;
  };
  /// Several on one row, in columns of one width.
  void cells(const std::vector<Cell>& all, int columns, bool are_new = false) {
    constexpr double kGap = 24.0;
    const double step = (panel.right - panel.left + kGap) / columns;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double at = panel.left + static_cast<double>(i) * step;
      panel.write("code", at, all[i].name, type::kCode);
      panel.write(are_new ? "code.value" : "code", at + step - kGap, all[i].value,
                  are_new ? type::kCodeBold : type::kCode, Align::right);
    }
    panel.y += rows::kTightRow;
  }
};

std::string braces(Language language, const std::string& inside) {
  return language == Language::python ? "(" + inside + ")" : "{" + inside + "}";
}

/// The variable s of the loop. A vertex that was just added has weight 1, as it is made.
void write_simplex(Variables& out, bool is_weighed) {
  const PanelBuilder& panel = out.panel;
  const Language language = language_of(panel.run.lesson.listing);
  const WideSimplex& simplex = panel.state.simplex;
  out.row("s", "", braces(language, "index_x, index_y, w, weight"));
  const bool has_new = panel.knows.phase_is(Phase::add);
  for (int i = 0; i < simplex.count; ++i) {
    const WideVertex& vertex = simplex.vertices[i];
    const bool is_new = has_new && i + 1 == simplex.count;
    const double weight = is_weighed && !is_new ? simplex.weights[i] : 1.0;
    out.row(
        fmt::format("s[{}]", i),
        braces(language, fmt::format("{}, {}, {}, {}", vertex.pair.x, vertex.pair.y,
                                     panel.numbers.point(vertex.w), panel.numbers.weight(weight))),
        panel.words.vertex(i), panel.knows.phase_is(Phase::drop) || is_new);
  }
}

void write_loop(Variables& out, const Steps& steps) {
  const PanelBuilder& panel = out.panel;
  write_simplex(out, steps[Phase::closest] != nullptr);
  if (const WideStep* step = steps[Phase::closest])
    out.row("out.p", panel.numbers.point(step->after.p));
  const WideStep* support = steps[Phase::support];
  const SupportPart reached = support
                                  ? support_part(panel.run, panel.frame).value_or(SupportPart::of_z)
                                  : SupportPart::direction;
  if (const WideStep* step = steps[Phase::direction])
    out.row("d", panel.numbers.point(step->after.d), "", panel.knows.phase_is(Phase::direction));
  if (reached >= SupportPart::of_y) {
    const gjk::VertexPair pair = support->after.support.pair;
    const bool knows_x = reached >= SupportPart::of_x;
    out.cells({{"far_x", knows_x ? std::to_string(pair.x) : ""}, {"far_y", std::to_string(pair.y)}},
              2, panel.knows.phase_is(Phase::support));
  }
}

/// The numbers of the function that finds the closest point, by their names in it.
void write_regions(Variables& out, const Steps& steps) {
  const PanelBuilder& panel = out.panel;
  const WideState& after = steps[Phase::closest]->after;
  const WideSimplex& s = after.simplex;
  for (int i = 0; i < s.count; ++i)
    out.row(fmt::format("s[{}].w", i), panel.numbers.point(s.vertices[i].w), panel.words.vertex(i));
  const auto w = [&](int i) { return in_plane(s.vertices[i].w); };
  const auto edge = [&](int i, int k) { return panel.numbers(w(k).dot(w(k) - w(i))); };
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const bool are_new = panel.knows.gradual && panel.knows.tests_reached < 0;
  if (s.count == 2) out.cells({{"ab", edge(0, 1)}, {"ba", edge(1, 0)}}, 2, are_new);
  if (s.count == 3) {
    out.cells({{"ab", edge(0, 1)}, {"ba", edge(1, 0)}, {"bc", edge(1, 2)}}, 3, are_new);
    out.cells({{"cb", edge(2, 1)}, {"ca", edge(2, 0)}, {"ac", edge(0, 2)}}, 3, are_new);
    const double abc = cross(w(1) - w(0), w(2) - w(0));
    const auto part = [&](int i, int k) { return panel.numbers(abc * cross(w(i), w(k))); };
    out.cells({{"a", part(1, 2)}, {"b", part(2, 0)}, {"c", part(0, 1)}}, 3, are_new);
    out.cells({{"abc", panel.numbers(abc)}}, 3, are_new);
  }
  const auto& knows = panel.knows;
  const bool holds = !knows.gradual || knows.closest_point;
  if (knows.gradual && knows.tests_reached >= 0 && !holds) out.row("this test", "false", "", true);
  if (!holds) return;
  std::string kept;
  for (int i = 0; i < s.count; ++i) {
    if (!gjk::contains(after.region, i)) continue;
    kept += fmt::format("{}{} {}", kept.empty() ? "" : "  ", panel.words.vertex(i),
                        panel.numbers.weight(s.weights[i]));
  }
  out.row("returns", kept, "", true);
}

/// The newest vertex, field by field.
void write_vertex(Variables& out) {
  const PanelBuilder& panel = out.panel;
  const WideSimplex& simplex = panel.state.simplex;
  const int newest = simplex.count - 1;
  const WideVertex& vertex = simplex.vertices[newest];
  const bool is_weighed = panel.knows.phase && !panel.knows.phase_is(Phase::add);
  const bool is_python = language_of(panel.run.lesson.listing) == Language::python;
  out.row(is_python ? "len(s)" : "s.size()", std::to_string(simplex.count));
  out.row(is_python ? "s[-1]" : "s.back()", panel.words.vertex(newest));
  out.cells(
      {{"index_x", std::to_string(vertex.pair.x)}, {"index_y", std::to_string(vertex.pair.y)}}, 2);
  out.row("w", panel.numbers.point(vertex.w));
  out.row("weight", panel.numbers.weight(is_weighed ? simplex.weights[newest] : 1.0));
}

/// The function that finds the support point, as it looks at Y.
void write_support(Variables& out) {
  const PanelBuilder& panel = out.panel;
  const LessonShape& y = panel.run.lesson.y();
  const int best = panel.state.support.pair.y;
  out.row("shape", fmt::format("{}, {} vertices", y.name, y.vertices.size()));
  out.row("d", panel.numbers.point(panel.state.d));
  out.row("best", std::to_string(best), y.vertex_names[best], true);
}

void write_variables(PanelBuilder& panel, std::optional<Line> line, const Steps& steps) {
  Variables out{panel};
  if (line == Line::simplex_vertex) return write_vertex(out);
  if (line == Line::farthest) return write_support(out);
  const bool is_closest = panel.knows.phase_is(Phase::closest) && steps[Phase::closest];
  if (is_closest) return write_regions(out, steps);
  write_loop(out, steps);
  if (line) return;
  panel.write("body", panel.left, "The run ends by a test that this page does without.",
              type::kBody);
  panel.y += rows::kTightRow;
}

}  // namespace

Language language_of(std::string_view listing) {
  return listing.ends_with(kCpp)      ? Language::cpp
         : listing.ends_with(kPython) ? Language::python
                                      : Language::pseudocode;
}

std::optional<std::string> in_language(const Lesson& lesson, Language language) {
  if (lesson.dimension == 3) return std::nullopt;
  return in_language(std::string_view(lesson.listing), language);
}

std::optional<std::string> in_language(std::string_view listing, Language language) {
  const std::string_view ending = language == Language::cpp      ? kCpp
                                  : language == Language::python ? kPython
                                                                 : "";
  const std::string stem(listing.substr(0, listing.find('.')));
  const auto is_there = [](const std::string& name) {
    return std::any_of(registered_listings().begin(), registered_listings().end(),
                       [&](const Listing* each) { return each->name == name; });
  };
  if (!is_there(stem + std::string(kCpp))) return std::nullopt;
  return stem + std::string(ending);
}

std::vector<std::string_view> marked_lines(Language language) {
  std::vector<std::string_view> out;
  for (const Marked& each : kMarked) out.push_back(text_of(each, language));
  return out;
}

void write(PanelBuilder& panel) {
  const Steps steps(panel);
  const std::optional<Line> line = line_of_step(panel, steps);
  write_lines(panel, line);
  panel.rule();
  write_variables(panel, line, steps);
}

}  // namespace gjkscope::code

namespace gjkscope::listings {

const Listing kSegmentCpp{
    .name = "segment.cpp", .meaning = "point to segment, in C++", .write = code::write};
const Listing kSegmentPython{
    .name = "segment.py", .meaning = "point to segment, in Python", .write = code::write};
const Listing kTriangleCpp{
    .name = "triangle.cpp", .meaning = "point to triangle, in C++", .write = code::write};
const Listing kTrianglePython{
    .name = "triangle.py", .meaning = "point to triangle, in Python", .write = code::write};
const Listing kStructuresCpp{.name = "structures.cpp",
                             .meaning = "what a simplex is stored as, in C++",
                             .write = code::write,
                             .tour = "phase"};
const Listing kStructuresPython{.name = "structures.py",
                                .meaning = "what a simplex is stored as, in Python",
                                .write = code::write,
                                .tour = "phase"};
const Listing kSupportCpp{
    .name = "support.cpp", .meaning = "support point of a polygon, in C++", .write = code::write};
const Listing kSupportPython{
    .name = "support.py", .meaning = "support point of a polygon, in Python", .write = code::write};
const Listing kGjkPointCpp{
    .name = "gjk-point.cpp", .meaning = "point to convex polygon, in C++", .write = code::write};
const Listing kGjkPointPython{
    .name = "gjk-point.py", .meaning = "point to convex polygon, in Python", .write = code::write};
const Listing kGjkCpp{
    .name = "gjk.cpp", .meaning = "convex polygon to convex polygon, in C++", .write = code::write};
const Listing kGjkPython{.name = "gjk.py",
                         .meaning = "convex polygon to convex polygon, in Python",
                         .write = code::write};

}  // namespace gjkscope::listings
