#include "lesson/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "lesson/keys.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/schema.hpp"
#include "lesson/settings_kind.hpp"
#include "lesson/toml_reader.hpp"

namespace gjkscope {

namespace {

using toml_file::Field;
using toml_file::in_quotes;
using toml_file::Problems;
using toml_file::Reader;
using toml_file::Table;

bool has_vertex(const LessonShape& shape, const std::string& name) {
  const auto& names = shape.vertex_names;
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The keys that say where a shape stands; a motion stands in for them.
struct ShapePlace {
  Field translate;
  Field rotate;
};

/// Reads the tables of one file, in an order in which each finds what it refers to.
class LessonReader {
 public:
  /// `folder`: from which the file sees others.
  LessonReader(Problems& problems, const Vocabulary& vocabulary, std::filesystem::path folder,
               const FileReader& read_file)
      : problems_(problems),
        reader_(vocabulary.keys, problems),
        vocabulary_(vocabulary),
        folder_(std::move(folder)),
        read_file_(read_file) {}

  Lesson read(const toml::table& root);

 private:
  template <class T, class Keys>
  void read_keys(const Table& table, Keys keys, T& value, double largest = limits::kLargest) {
    KeyPass pass(reader_, table, lesson_.dimension, largest);
    keys(pass, value);
  }
  void check_prose(const Field& prose);
  [[nodiscard]] static int dimension_of(const Field& x);
  std::optional<Eigen::Vector3d> point(const Field& field) {
    return reader_.point(field, largest_, lesson_.dimension);
  }
  /// "point [x, y]"
  [[nodiscard]] std::string a_point() const {
    return lesson_.dimension == 2 ? "point [x, y]" : "point [x, y, z]";
  }
  void read_shape(const Field& field, std::size_t body);
  void read_axis(const Field& axis, LessonShape& shape);
  void read_vertex_names(const Field& names, const Field& vertices, std::string_view key,
                         LessonShape& shape);
  void read_outlines(const Field& outlines, LessonShape& shape);
  bool claim_vertex_name(const Field& field, const std::string& name);
  void read_beside(const Field& beside);
  void read_start(const Field& start);
  void read_path(const Table& path, Place place);
  LessonMotion read_motion(const Table& motion, std::string_view shape, const ShapePlace& place);
  void read_tour_settings(const Table& file);
  void check_table_is_shown();
  void read_steps(const Table& steps, const Table& file);
  void check_tour(const Tour& tour, const Field& name, const Table& file);
  void check_needs(const Term& term, const Field& field, std::string_view what);
  void read_effects(const Field& effects, LessonView& view);
  [[nodiscard]] std::optional<Eye> read_eye(const Field& field);
  void read_views(const Field& views);
  void read_panel(const Table& panel);
  void read_questions(const Field& questions);
  void read_answers(const Field& answers);
  void read_expect(const Table& expect, Place place);

  std::optional<gjk::VertexPair> simplex_vertex(const Field& field);
  std::optional<int> vertex_index(const Field& field, const LessonShape& shape,
                                  std::string_view shape_key, std::string_view name);

  Problems& problems_;
  Reader reader_;
  const Vocabulary& vocabulary_;
  std::filesystem::path folder_;
  const FileReader& read_file_;
  Lesson lesson_;
  double largest_ = limits::kLargest;  ///< The largest coordinate in the lesson's scalar.
  int shapes_read_ = 0;                ///< Those whose vertices and names are all right.
  Place table_place_;                  ///< The place of the tour's table.
  std::array<ShapePlace, kBodyKeys.size()> places_;  ///< One for each body.
  std::array<Field, kBodyKeys.size()> outlines_;     ///< One for each body.
  std::array<Field, kBodyKeys.size()> radii_;        ///< One for each body.
  bool tour_is_known_ = true;  ///< False: the file names one that there is not.
  std::map<std::string, int> line_of_vertex_name_;
};

Lesson LessonReader::read(const toml::table& root) {
  const Table file(root, "", vocabulary_.keys, problems_);
  read_keys(file, head_keys, lesson_);
  const std::optional<Table> query = reader_.table(file["query"], "query");
  if (query) read_keys(*query, query_keys, lesson_);
  if (lesson_.scalar == ScalarKind::half) largest_ = limits::kLargestHalf;

  if (const auto shapes = reader_.table(file["shapes"], "shapes")) {
    lesson_.dimension = dimension_of((*shapes)["X"]);
    for (std::size_t body = 0; body < kBodyKeys.size(); ++body)
      read_shape((*shapes)[kBodyKeys[body]], body);
  }
  if (query) read_start((*query)["start"]);
  const Field path_field = file["path"];
  if (lesson_.warm_start && !path_field)
    problems_.add((*query)["warm"].place(), "a warm start without a path", "a table [path]");
  if (const auto path = reader_.table(path_field, "path")) read_path(*path, path_field.place());
  if (const auto steps = reader_.table(file["steps"], "steps")) read_steps(*steps, file);
  read_tour_settings(file);
  check_prose(file["prose"]);
  read_views(file["views"]);
  if (const auto panel = reader_.table(file["panel"], "panel")) read_panel(*panel);
  read_questions(file["questions"]);
  const Field expect_field = file["expect"];
  if (const auto expect = reader_.table(expect_field, "expect"))
    read_expect(*expect, expect_field.place());
  return lesson_;
}

void LessonReader::check_prose(const Field& prose) {
  std::vector<std::string> known;
  for (const PlaceholderInfo& placeholder : kPlaceholders) known.emplace_back(placeholder.name);
  for (const PlaceholderInfo& value : vocabulary_.tour(lesson_.tour)->algorithm->values)
    known.emplace_back(value.name);
  for (const ProsePart& part : prose_parts(lesson_.prose)) {
    if (part.kind == ProsePart::Kind::stray_brace) {
      problems_.add(prose.place(), fmt::format("{} holds a single '{}'", prose.label, part.text),
                    "a placeholder like {distance}, or a doubled brace");
    } else if (part.kind == ProsePart::Kind::placeholder &&
               std::find(known.begin(), known.end(), part.text) == known.end()) {
      problems_.add(prose.place(), "unknown placeholder " + in_quotes(part.text),
                    fmt::format("one of: {}", fmt::join(known, ", ")),
                    nearest_name(part.text, known));
    }
  }
}

/// That of the first vertex of X; 2 where there is none.
int LessonReader::dimension_of(const Field& x) {
  const toml::table* table = x ? x.node->as_table() : nullptr;
  const toml::array* vertices = table != nullptr ? (*table)["vertices"].as_array() : nullptr;
  if (vertices == nullptr || vertices->empty()) return 2;
  const toml::array* first = vertices->get(0)->as_array();
  return first != nullptr && first->size() == 3 ? 3 : 2;
}

void LessonReader::read_axis(const Field& axis, LessonShape& shape) {
  if (!axis) return;
  if (lesson_.dimension == 2) {
    problems_.add(axis.place(), "an 'axis' in the plane", "points [x, y, z], or no 'axis'");
    return;
  }
  const std::optional<Eigen::Vector3d> read = point(axis);
  if (!read) return;
  if (!(read->norm() > 0.0) || !std::isfinite(read->squaredNorm()) ||
      !(read->squaredNorm() >= std::numeric_limits<double>::min())) {
    problems_.add(axis.place(), "the axis has no direction", "point [x, y, z] away from 0");
    return;
  }
  shape.axis = *read;
}

void LessonReader::read_shape(const Field& field, std::size_t body) {
  using namespace limits;
  const std::string_view key = kBodyKeys[body];
  LessonShape& shape = lesson_.bodies[body];
  shape.name = key;
  const std::optional<Table> table = reader_.table(field, "shapes.X");
  if (!table) return;
  read_keys(*table, shape_keys, shape, largest_);
  read_axis((*table)["axis"], shape);
  places_[body] = {(*table)["translate"], (*table)["rotate"]};
  radii_[body] = (*table)["radius"];

  const Field vertices = (*table)["vertices"];
  const std::vector<Field> corners = reader_.entries(vertices, a_point());
  if (!vertices || !vertices.node->is_array()) return;
  if (corners.empty() || corners.size() > kVertices) {
    problems_.add(vertices.place(), fmt::format("'vertices' has {} entries", corners.size()),
                  fmt::format("1 to {} (a limit of drawing, not of GJK)", kVertices));
    return;
  }
  bool all_read = true;
  for (const Field& corner : corners) {
    const std::optional<Eigen::Vector3d> vertex = point(corner);
    all_read = all_read && vertex;
    shape.vertices.push_back(vertex.value_or(Eigen::Vector3d::Zero()));
  }
  read_vertex_names((*table)["names"], vertices, key, shape);
  read_outlines((*table)["outlines"], shape);
  outlines_[body] = (*table)["outlines"];
  if (all_read && shape.vertex_names.size() == shape.vertices.size()) ++shapes_read_;
}

/// Leaves the names empty where any of them is wrong: then nothing can be looked up by name.
void LessonReader::read_vertex_names(const Field& names, const Field& vertices,
                                     std::string_view key, LessonShape& shape) {
  const std::size_t count = shape.vertices.size();
  std::vector<std::string> read;
  if (!names) {
    for (const std::string& name : default_vertex_names(shape, key)) {
      if (claim_vertex_name(vertices, name)) read.push_back(name);
    }
  }
  const std::vector<Field> entries = reader_.entries(
      names, fmt::format("vertex name of 1 to {} characters", limits::kVertexNameLength));
  if (names && names.node->is_array() && entries.size() != count) {
    problems_.add(names.place(), fmt::format("{} names for {} vertices", entries.size(), count),
                  fmt::format("{} names", count));
  }
  for (const Field& entry : entries) {
    const std::optional<std::string> name = reader_.text(entry, limits::kVertexNameLength);
    if (!name) continue;
    if (name->find_first_of(" ,-") != std::string::npos ||
        name->find("\u2212") != std::string::npos) {
      problems_.add(entry.place(),
                    fmt::format("vertex name {} cannot be told from a pair", in_quotes(*name)),
                    "no blank, comma, hyphen or minus in it");
    } else if (claim_vertex_name(entry, *name)) {
      read.push_back(*name);
    }
  }
  if (read.size() == count) shape.vertex_names = std::move(read);
}

void LessonReader::read_outlines(const Field& outlines, LessonShape& shape) {
  const int vertices = static_cast<int>(shape.vertices.size());
  int left = vertices;
  for (const Field& entry : reader_.entries(outlines, "whole number")) {
    const std::optional<int> count =
        reader_.whole_number(entry, limits::kOutlineVertices, vertices);
    if (!count) return;
    shape.outlines.push_back(*count);
    left -= *count;
  }
  if (outlines && outlines.node->is_array() && left != 0) {
    problems_.add(outlines.place(),
                  fmt::format("the outlines have {} vertices in all", vertices - left),
                  fmt::format("{}, as many as there are in 'vertices'", vertices));
    shape.outlines.clear();
  }
}

/// False where the name is taken.
bool LessonReader::claim_vertex_name(const Field& field, const std::string& name) {
  const auto [first, added] = line_of_vertex_name_.emplace(name, field.place().line);
  if (!added) {
    problems_.add(
        field.place(), fmt::format("vertex name {} is used twice", in_quotes(name)),
        fmt::format("names unique over both shapes (line {} has it, too)", first->second));
  }
  return added;
}

std::optional<int> LessonReader::vertex_index(const Field& field, const LessonShape& shape,
                                              std::string_view shape_key, std::string_view name) {
  const auto& names = shape.vertex_names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  constexpr std::size_t kListed = 12;
  const std::string expected =
      names.size() <= kListed
          ? fmt::format("vertices of {}: {}", shape_key, fmt::join(names, ", "))
          : fmt::format("one of the {} vertices of {}", names.size(), shape_key);
  problems_.add(field.place(), fmt::format("{} has no vertex {}", shape_key, in_quotes(name)),
                expected, nearest_name(name, names));
  return std::nullopt;
}

/// A vertex of the Minkowski difference: "K" in a point query, else "K-C" with Y's vertex first.
std::optional<gjk::VertexPair> LessonReader::simplex_vertex(const Field& field) {
  constexpr int kLongest = 2 * limits::kVertexNameLength + 1;
  const std::optional<std::string> text =
      reader_.text(field, std::max(kLongest, limits::kShapeNameLength));
  if (!text || shapes_read_ < 2) return std::nullopt;  // without names there is nothing to look up
  if (lesson_.x().vertices.size() == 1) {
    const std::optional<int> y = vertex_index(field, lesson_.y(), "Y", *text);
    return y ? std::optional(gjk::VertexPair{0, *y}) : std::nullopt;
  }
  const std::size_t hyphen = text->find('-');
  if (hyphen == std::string::npos) {
    problems_.add(field.place(), in_quotes(*text) + " is not a pair of vertices",
                  "\"K-C\": a vertex of Y, a hyphen, a vertex of X");
    return std::nullopt;
  }
  const std::string first = text->substr(0, hyphen);
  const std::string second = text->substr(hyphen + 1);
  if (has_vertex(lesson_.x(), first) && has_vertex(lesson_.y(), second)) {
    problems_.add(field.place(), fmt::format("pair {} has the vertex of X first", in_quotes(*text)),
                  fmt::format("\"{}-{}\": the difference is Y - X", second, first));
    return std::nullopt;
  }
  const std::optional<int> y = vertex_index(field, lesson_.y(), "Y", first);
  const std::optional<int> x = vertex_index(field, lesson_.x(), "X", second);
  if (!x || !y) return std::nullopt;
  return gjk::VertexPair{*x, *y};
}

void LessonReader::read_start(const Field& start) {
  if (!start) return;
  gjk::Options& options = lesson_.options;
  if (start.node->is_string()) {
    const std::vector<std::string> known = {"center-to-center"};
    if (reader_.name(start, "start", known)) options.start.count = 0;
    return;
  }
  const std::vector<Field> entries = reader_.entries(start, "name of a simplex vertex");
  if (!start.node->is_array()) return;
  if (entries.empty() || static_cast<int>(entries.size()) > lesson_.dimension + 1) {
    problems_.add(start, fmt::format("'start' has {} entries", entries.size()));
    return;
  }
  options.start.count = 0;
  for (const Field& entry : entries) {
    const std::optional<gjk::VertexPair> pair = simplex_vertex(entry);
    if (!pair) continue;
    const auto end = options.start.pairs.begin() + options.start.count;
    if (std::find(options.start.pairs.begin(), end, *pair) != end) {
      problems_.add(entry.place(), entry.label + " repeats a vertex", "each vertex once");
      continue;
    }
    options.start.pairs[options.start.count++] = *pair;
  }
}

void LessonReader::read_path(const Table& path, Place place) {
  using namespace limits;
  LessonPath read;
  read_keys(path, path_keys, read);
  read.x() = read_motion(path, "X", places_[0]);
  const Field frames = path["frames"];
  const Field seconds = path["seconds"];
  const Field points = path["points"];
  const Field turns = path["turns"];
  const Field y = path["Y"];
  if (const auto motion = reader_.table(y, "path.Y"))
    read.y() = read_motion(*motion, "Y", places_[1]);

  if (!points && !y) {
    problems_.add(place, "a path without a shape that moves",
                  "'points', the corners of X's way, or a table [path.Y]");
  }
  for (const Field& field : {turns, y}) {
    if (field && !seconds)
      problems_.add(field.place(), field.label + " without a clock", "'seconds' in [path]");
  }
  if (seconds && !frames)
    problems_.add(seconds.place(), "a clock without 'frames'", "'frames' in [path]");

  const std::size_t positions = read.positions();
  const std::size_t vertices = lesson_.x().vertices.size() + lesson_.y().vertices.size();
  if (positions * vertices > kScannedVertices) {
    problems_.add(
        (frames ? frames : points).place(),
        fmt::format("{} positions of shapes with {} vertices in all", positions, vertices),
        fmt::format("a product of at most {}", kScannedVertices));
  }
  lesson_.path_of_shapes = std::move(read);
}

LessonMotion LessonReader::read_motion(const Table& motion, std::string_view shape,
                                       const ShapePlace& place) {
  using namespace limits;
  LessonMotion read;
  const Field points = motion["points"];
  const Field turns = motion["turns"];
  const std::string table = shape == "X" ? "[path]" : "[path.Y]";
  if (points && place.translate) {
    problems_.add(place.translate.place(), fmt::format("'translate' of {} besides a path", shape),
                  fmt::format("one of the two: {} says where {} stands", table, shape));
  }
  if (turns && place.rotate) {
    problems_.add(place.rotate.place(), fmt::format("'rotate' of {} besides turns", shape),
                  fmt::format("one of the two: {} says how {} is turned", table, shape));
  }
  const std::vector<Field> corners = reader_.entries(points, a_point());
  const bool is_list = points && points.node->is_array();
  if (is_list && (corners.size() < 2 || corners.size() > kPositions)) {
    problems_.add(points.place(), fmt::format("'points' has {} entries", corners.size()),
                  fmt::format("2 to {}", kPositions));
    return read;
  }
  for (const Field& corner : corners) {
    if (const auto read_point = point(corner)) read.points.push_back(*read_point);
  }
  const std::vector<Field> degrees =
      reader_.entries(turns, fmt::format("number from {:g} to {:g}", -kTurn, kTurn));
  if (turns && turns.node->is_array() && degrees.size() != corners.size()) {
    problems_.add(turns.place(),
                  fmt::format("{} turns for {} points", degrees.size(), corners.size()),
                  points ? fmt::format("{} turns", corners.size()) : "'points', one for each turn");
  }
  for (const Field& entry : degrees) {
    if (const auto turn = reader_.number(entry, -kTurn, kTurn)) read.turns.push_back(*turn);
  }
  return read;
}

/// A block, a listing or an effect goes with one tour, or with a table.
void LessonReader::check_needs(const Term& term, const Field& field, std::string_view what) {
  if (!term.tour.empty() && lesson_.tour != term.tour) {
    const Tour* tour = vocabulary_.tour(term.tour);
    std::string expected = fmt::format("tour = \"{}\" in [steps]", term.tour);
    if (tour != nullptr) {
      for (const std::string_view table : tour->needs.required_tables())
        expected += fmt::format(", and a table [{}]", table);
    }
    problems_.add(field.place(), fmt::format("{} without tour '{}'", what, term.tour), expected);
  }
  if (!has_settings(lesson_, term.table)) {
    problems_.add(field.place(), fmt::format("{} without a table [{}]", what, term.table),
                  fmt::format("a table [{}]", term.table));
  }
  if (!is_shown_of(term.shown_of, lesson_.dimension)) {
    const bool is_space = lesson_.dimension == 3;
    problems_.add(field.place(),
                  fmt::format("{} of shapes in {}", what, is_space ? "space" : "the plane"),
                  is_space ? "points [x, y]: it is shown in the plane alone"
                           : "points [x, y, z]: it is shown in space alone");
  }
  const std::size_t of_x = lesson_.x().vertices.size();
  const std::size_t of_y = lesson_.y().vertices.size();
  if (term.pairs_vertices && of_x * of_y > limits::kDifferences) {
    problems_.add(
        field.place(),
        fmt::format("{} of {} differences y - x, {} times {}", what, of_x * of_y, of_y, of_x),
        fmt::format("at most {} of them: fewer vertices, or views without this effect",
                    limits::kDifferences));
  }
}

void LessonReader::check_tour(const Tour& tour, const Field& name, const Table& file) {
  const auto refuse = [&](std::string_view what, std::string expected) {
    problems_.add(name.place(), fmt::format("tour '{}' {}", tour.name, what), std::move(expected));
  };
  const TourNeeds& needs = tour.needs;
  for (const std::string_view table : needs.required_tables()) {
    if (!file[table]) return refuse("without its table", fmt::format("a table [{}]", table));
  }
  if (!is_shown_of(needs.shown_of, lesson_.dimension)) {
    lesson_.dimension == 3
        ? refuse("in space", "points [x, y]: its frames show the plane alone")
        : refuse("in the plane", "points [x, y, z]: its frames show space alone");
  }
  if (needs.path == PathUse::refused && file["path"]) refuse("with a path", "no table [path]");
  if (shapes_read_ < 2) return;
  const int largest =
      static_cast<int>(std::max(lesson_.x().vertices.size(), lesson_.y().vertices.size()));
  if (needs.most_vertices > 0 && largest > needs.most_vertices) {
    refuse(fmt::format("with a shape of {} vertices", largest),
           fmt::format("at most {} vertices in each shape", needs.most_vertices));
  }
  const bool starts_so =
      lesson_.x().vertices.size() == 1 && lesson_.options.start.count == needs.start;
  if (needs.start > 0 && !starts_so) {
    constexpr std::array<std::string_view, 4> kSimplices = {"single vertex", "segment", "triangle",
                                                            "tetrahedron"};
    refuse(fmt::format("without a {}", kSimplices[needs.start - 1]),
           fmt::format("a point query whose 'start' names {} vertices", needs.start));
  }
}

void LessonReader::read_steps(const Table& steps, const Table& file) {
  const std::vector<std::string> known = names_of(vocabulary_.tours);
  Field name = steps["tour"];
  name.expected = one_of(known);
  if (const std::optional<std::string> chosen = reader_.name(name, "tour", known)) {
    lesson_.tour = *chosen;
    check_tour(*vocabulary_.tour(*chosen), name, file);
  } else {
    tour_is_known_ = !name;
  }
  const Tour& tour = *vocabulary_.tour(lesson_.tour);
  if (!tour.algorithm->takes_outlines) {
    for (const Field& outlines : outlines_) {
      if (!outlines) continue;
      problems_.add(outlines.place(), fmt::format("'outlines' with tour '{}'", tour.name),
                    "no 'outlines': GJK asks about the hull of the vertices");
    }
  }
  for (const Field& radius : radii_) {
    if (!radius || tour.needs.takes_radius) continue;
    problems_.add(radius.place(), fmt::format("'radius' with tour '{}'", tour.name),
                  "no 'radius': only a frame that tells how a run of GJK ends subtracts it");
  }
  read_keys(steps, steps_keys, lesson_);
  const Field until = steps["until"];
  const Field phases = steps["phases"];
  for (const Field& entry : reader_.entries(phases, one_of(names_of<gjk::Phase>()))) {
    if (const auto phase = reader_.choice<gjk::Phase>(entry, "phase"))
      lesson_.phases.push_back(*phase);
  }
  if (phases && !tour.needs.takes_phases) {
    problems_.add(phases.place(), fmt::format("'phases' with tour '{}'", tour.name),
                  "tour 'phase', or no 'phases'");
  }
  if (until && !tour.needs.why_no_until.empty()) {
    problems_.add(until.place(), fmt::format("'until' with tour '{}'", tour.name),
                  fmt::format("no 'until': {}", tour.needs.why_no_until));
  }
}

void LessonReader::read_tour_settings(const Table& file) {
  const SettingsKind* own = vocabulary_.tour(lesson_.tour)->needs.settings;
  for (const SettingsKind* kind : settings_of(vocabulary_.tours)) {
    const Field field = file[kind->name];
    const std::optional<Table> table = reader_.table(field, kind->name);
    if (!field) continue;
    TourSettings read;
    if (table)
      read = kind->read({*table, field.place(), reader_, problems_, lesson_, folder_, read_file_});
    if (kind == own) {
      lesson_.settings = std::move(read);
      table_place_ = field.place();
    } else if (tour_is_known_) {
      const std::vector<std::string> tours = names_of(tours_with(vocabulary_.tours, *kind));
      problems_.add(
          field.place(),
          fmt::format("a table [{}] without tour '{}'", kind->name, fmt::join(tours, "' or '")),
          fmt::format("tour = \"{}\" in [steps]", fmt::join(tours, "\" or \"")));
    }
  }
}

std::optional<Eye> LessonReader::read_eye(const Field& field) {
  const std::optional<Table> table = reader_.table(field, "views.eye");
  if (!table) return std::nullopt;
  if (lesson_.dimension == 2) {
    problems_.add(field.place(), "an 'eye' in the plane", "points [x, y, z], or no 'eye'");
    return std::nullopt;
  }
  Eye eye;
  read_keys(*table, eye_keys, eye);
  return eye;
}

void LessonReader::read_views(const Field& views) {
  const std::vector<Field> entries = reader_.entries(views, "table [[views]]");
  if (views && views.node->is_array() && (entries.empty() || entries.size() > limits::kMostViews)) {
    problems_.add(views, fmt::format("{} views", entries.size()));
  }
  std::vector<std::string> kinds = names_of<ViewKind>();
  for (const Tour* tour : vocabulary_.plots) kinds.emplace_back(tour->name);
  for (const Field& entry : entries) {
    const std::optional<Table> table = reader_.table(entry, "views");
    if (!table) continue;
    LessonView view;
    Field show = (*table)["show"];
    show.expected = one_of(kinds);
    const std::string kind = reader_.name(show, "view", kinds).value_or(kinds[0]);
    view.kind = value_of<ViewKind>(kind).value_or(ViewKind::plot);
    read_keys(*table, view_keys, view);
    view.eye = read_eye((*table)["eye"]);
    if (view.close_up && lesson_.dimension == 3) {
      problems_.add((*table)["close-up"].place(), "a close-up in space",
                    "no 'close-up': it enlarges a part of the plane");
    }
    read_effects((*table)["effects"], view);
    if (!shows_shapes(view.kind)) {
      check_needs({.name = kind, .tour = kind}, show, fmt::format("view '{}'", kind));
      for (const char* key : {"camera", "close-up", "effects"}) {
        if (const Field field = (*table)[key]) {
          problems_.add(field.place(), fmt::format("{} in a view of {}", field.label, kind),
                        "a view of the world or of the difference");
        }
      }
    }
    lesson_.views.push_back(std::move(view));
  }
  check_table_is_shown();
}

/// A table that a tour may do without is there for effects of views.
void LessonReader::check_table_is_shown() {
  if (!vocabulary_.tour(lesson_.tour)->needs.settings_are_optional ||
      lesson_.settings.kind() == nullptr)
    return;
  const std::string_view name = lesson_.settings.kind()->name;
  std::vector<std::string> effects;
  for (const Term& effect : vocabulary_.effects) {
    if (effect.table == name) effects.emplace_back(effect.name);
  }
  const auto shows = [&](const std::string& effect) { return lesson_.calls_for(effect); };
  if (!effects.empty() && std::none_of(effects.begin(), effects.end(), shows)) {
    problems_.add(table_place_, fmt::format("a table [{}] that no view shows", name),
                  fmt::format("\"{}\" among a view's effects", fmt::join(effects, "\" or \"")));
  }
}

void LessonReader::read_effects(const Field& effects, LessonView& view) {
  const std::vector<std::string> known = names_of(vocabulary_.effects);
  for (const Field& effect : reader_.entries(effects, one_of(known))) {
    const std::optional<std::string> name = reader_.name(effect, "effect", known);
    if (!name) continue;
    if (view.calls_for(*name)) {
      problems_.add(effect.place(), "effect " + in_quotes(*name) + " is named twice",
                    "each effect once");
      continue;
    }
    check_needs(*find_term(vocabulary_.effects, *name), effect, fmt::format("effect '{}'", *name));
    view.effects.push_back(*name);
  }
}

void LessonReader::read_panel(const Table& panel) {
  const Field blocks = panel["blocks"];
  const std::vector<std::string> known = names_of(vocabulary_.blocks);
  std::string_view takes_listing;
  for (const Field& entry : reader_.entries(blocks, one_of(known))) {
    const std::optional<std::string> name = reader_.name(entry, "panel block", known);
    if (!name) continue;
    if (lesson_.has_block(*name)) {
      problems_.add(entry.place(), fmt::format("block '{}' is named twice", *name),
                    "each block once");
      continue;
    }
    const Term& block = *find_term(vocabulary_.blocks, *name);
    check_needs(block, entry, fmt::format("block '{}'", *name));
    if (block.takes_listing) takes_listing = block.name;
    lesson_.panel.push_back(*name);
  }
  const std::vector<std::string> listings = names_of(vocabulary_.listings);
  Field listing = panel["listing"];
  listing.expected = one_of(listings);
  lesson_.listing = reader_.name(listing, "listing", listings).value_or("");
  if (!takes_listing.empty() && !listing) {
    problems_.add(blocks.place(), fmt::format("block '{}' without a 'listing'", takes_listing),
                  "listing = " + one_of(listings));
  }
  if (listing && takes_listing.empty()) {
    std::vector<Term> takers;
    std::copy_if(vocabulary_.blocks.begin(), vocabulary_.blocks.end(), std::back_inserter(takers),
                 [](const Term& term) { return term.takes_listing; });
    const std::string blocks_named = fmt::format("{}", fmt::join(names_of(takers), "' or '"));
    problems_.add(listing.place(), fmt::format("'listing' without the block '{}'", blocks_named),
                  fmt::format("'{}' among the blocks", blocks_named));
  }
  if (const Term* term = find_term(vocabulary_.listings, lesson_.listing))
    check_needs(*term, listing, fmt::format("listing '{}'", term->name));
}

void LessonReader::read_questions(const Field& questions) {
  const Tour& tour = *vocabulary_.tour(lesson_.tour);
  std::vector<std::string> known;
  for (const Tour* each : vocabulary_.tours) {
    for (const AskInfo& info : each->asks) {
      if (std::find(known.begin(), known.end(), info.name) == known.end())
        known.emplace_back(info.name);
    }
  }
  std::vector<std::string_view> asked_here;
  for (const AskInfo& info : tour.asks) asked_here.push_back(info.name);
  for (const Field& entry : reader_.entries(questions, "table [[questions]]")) {
    const std::optional<Table> table = reader_.table(entry, "questions");
    if (!table) continue;
    const Field ask = (*table)["ask"];
    const std::optional<std::string> asked = reader_.name(ask, "question", known);
    LessonQuestion question;
    read_keys(*table, question_keys, question);
    if (!asked) continue;
    question.ask = *asked;
    if (tour.ask(*asked) == nullptr) {
      problems_.add(ask.place(), fmt::format("question '{}' with tour '{}'", *asked, tour.name),
                    fmt::format("one of: {}", fmt::join(asked_here, ", ")));
    }
    const auto same = [&](const LessonQuestion& other) {
      return other.ask == *asked && (!other.at || !question.at || other.at == question.at);
    };
    if (std::any_of(lesson_.questions.begin(), lesson_.questions.end(), same)) {
      problems_.add(ask.place(), fmt::format("question '{}' is asked twice", *asked),
                    "each question once in an iteration");
    }
    lesson_.questions.push_back(std::move(question));
  }
}

void LessonReader::read_answers(const Field& answers) {
  if (!answers) return;
  const Algorithm* algorithm = vocabulary_.tour(lesson_.tour)->algorithm;
  if (algorithm->answers.empty()) {
    std::vector<const Tour*> able;
    std::copy_if(vocabulary_.tours.begin(), vocabulary_.tours.end(), std::back_inserter(able),
                 [](const Tour* each) { return !each->algorithm->answers.empty(); });
    problems_.add(answers.place(), fmt::format("'answer' with tour '{}'", lesson_.tour),
                  "tour " + one_of(names_of(able)) + ", or no 'answer'");
    return;
  }
  const std::vector<std::string> known(algorithm->answers.begin(), algorithm->answers.end());
  for (const auto& [name, field] : reader_.named_entries(answers, known)) {
    if (const auto value = reader_.number(field, 0.0, 4.0 * limits::kLargest))
      lesson_.expect.answers.emplace_back(name, *value);
  }
}

void LessonReader::read_expect(const Table& expect, Place place) {
  const Algorithm* algorithm = vocabulary_.tour(lesson_.tour)->algorithm;
  if (algorithm->takes_outlines) {
    const std::vector<std::string> stops(algorithm->stops.begin(), algorithm->stops.end());
    std::vector<std::string_view> of_gjk = {"distance", "supports"};
    if (stops.empty()) {
      of_gjk.emplace_back("stop");
    } else {
      Field ends = expect["stop"];
      ends.expected = one_of(stops);
      lesson_.expect.stop = reader_.name(ends, "stop reason", stops);
    }
    for (const std::string_view key : of_gjk) {
      if (const Field field = expect[key]) {
        problems_.add(field.place(), fmt::format("'{}' with tour '{}'", key, lesson_.tour),
                      "'answer': GJK is not run");
      }
    }
    return read_answers(expect["answer"]);
  }
  std::vector<std::string> outcomes = names_of<gjk::StopReason>();
  std::erase(outcomes, name_of(gjk::StopReason::running));
  std::erase(outcomes, name_of(gjk::StopReason::failed));  // a lesson needs shapes that GJK accepts
  const Field ends = expect["stop"];
  if (!ends) problems_.add(place, "missing key 'stop'", ends.expected);
  lesson_.expect.stop = reader_.name(ends, "stop reason", outcomes);
  read_keys(expect, expect_keys, lesson_.expect);
  read_answers(expect["answer"]);

  const Field supports = expect["supports"];
  if (!supports) return;
  const std::vector<Field> entries = reader_.entries(supports, "name of a simplex vertex");
  if (entries.size() > limits::kCap) {
    problems_.add(supports.place(), fmt::format("'supports' has {} entries", entries.size()),
                  fmt::format("at most {}, one for each iteration", limits::kCap));
    return;
  }
  lesson_.expect.supports.emplace();
  for (const Field& entry : entries) {
    if (simplex_vertex(entry)) lesson_.expect.supports->push_back(entry.node->as_string()->get());
  }
}

/// At most one character behind the end of a line: the parser has the end of the file behind its
/// last line break.
Place within(std::string_view text, Place place) {
  for (int line = 1; line < place.line; ++line) {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  place.column = std::min(place.column, character_count(text.substr(0, text.find('\n'))) + 1);
  return place;
}

/// The parsed file; nothing, and one problem, where it is not TOML.
std::optional<toml::table> parse_toml(std::string_view text, Problems& problems) {
  if (text.size() > limits::kFileBytes) {
    problems.add({}, "the file is too large",
                 fmt::format("at most {} bytes", static_cast<int>(limits::kFileBytes)));
    return std::nullopt;
  }
  if (const std::optional<Place> place = toml_file::too_deep_key(text)) {
    problems.add(*place, "a key of too many parts",
                 fmt::format("at most {}", toml_file::kDeepestKey));
    return std::nullopt;
  }
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    constexpr std::size_t kLongest = 200;  // the parser quotes what it stumbled on, however long
    const auto& begin = error.source().begin;
    const std::string what = std::string(error.description()).substr(0, kLongest);
    problems.add(within(text, toml_file::place_at(begin)), "not TOML: " + what);
    return std::nullopt;
  }
}

}  // namespace

LoadedLesson parse_lesson(std::string_view text, const std::filesystem::path& name,
                          const Vocabulary& vocabulary, const FileReader& read) {
  Problems problems(name.string());
  const std::optional<toml::table> file = parse_toml(text, problems);
  if (!file) return {std::nullopt, problems.sorted()};
  Lesson lesson = LessonReader(problems, vocabulary, name.parent_path(), read).read(*file);
  if (!problems.empty()) return {std::nullopt, problems.sorted()};
  lesson.id = name.stem().string();
  lesson.path = name.string();
  return {std::move(lesson), {}};
}

LoadedLesson load_lesson(const std::filesystem::path& file, const Vocabulary& vocabulary) {
  const FileText read = read_file(file, limits::kFileBytes);
  if (read.text) return parse_lesson(*read.text, file, vocabulary);
  Problems problems(file.string());
  problems.add({}, read.problem, "a lesson file");
  return {std::nullopt, problems.sorted()};
}

Place place_of_key(const std::filesystem::path& file, std::string_view dotted_key) {
  const FileText read = read_file(file, limits::kFileBytes);
  Problems problems(file.string());
  const std::optional<toml::table> root = parse_toml(read.text.value_or(""), problems);
  if (!root) return {};
  Place place;
  const toml::node* node = &*root;
  while (!dotted_key.empty()) {
    const std::size_t dot = std::min(dotted_key.find('.'), dotted_key.size());
    const std::string_view part = dotted_key.substr(0, dot);
    dotted_key.remove_prefix(std::min(dot + 1, dotted_key.size()));
    if (const toml::table* table = node->as_table()) {
      const auto found = table->find(part);
      if (found == table->end()) break;
      node = &found->second;
      place = toml_file::place_at(found->first.source().begin);
    } else if (const toml::array* array = node->as_array()) {
      std::size_t index = 0;
      const auto result = std::from_chars(part.data(), part.data() + part.size(), index);
      if (result.ec != std::errc() || index >= array->size()) break;
      node = array->get(index);
      place = toml_file::place_at(node->source().begin);
    } else {
      break;
    }
  }
  return place;
}

std::vector<LoadedLesson> load_lessons(const std::filesystem::path& folder,
                                       const Vocabulary& vocabulary) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (auto entry = std::filesystem::directory_iterator(folder, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (entry->path().extension() == ".toml") files.push_back(entry->path());
  }
  if (error) {
    Problems problems(folder.string());
    problems.add({}, "the folder cannot be read: " + error.message(), "a folder of lesson files");
    return {{std::nullopt, problems.sorted()}};
  }
  std::sort(files.begin(), files.end());
  std::vector<LoadedLesson> lessons;
  for (const auto& file : files) lessons.push_back(load_lesson(file, vocabulary));
  const auto rank = [](const LoadedLesson& loaded) {
    return loaded.lesson ? std::tuple(false, loaded.lesson->chapter, loaded.lesson->order)
                         : std::tuple(true, 0, 0);
  };
  std::stable_sort(lessons.begin(), lessons.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return lessons;
}

std::vector<std::string> default_vertex_names(const LessonShape& shape, std::string_view key) {
  const std::size_t count = shape.vertices.size();
  if (count == 1) return {shape.name};
  const std::string stem = key == "X" ? "x" : "y";
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back(stem + std::to_string(i));
  return names;
}

std::vector<LessonText> texts_of(const Lesson& lesson) {
  std::vector<LessonText> texts = {{"title", lesson.title},
                                   {"source", lesson.source},
                                   {"prose", lesson.prose},
                                   {"opening", lesson.opening},
                                   {"next", lesson.next}};
  for (std::size_t body = 0; body < lesson.bodies.size(); ++body) {
    const LessonShape& shape = lesson.bodies[body];
    texts.push_back({fmt::format("shapes.{}.name", kBodyKeys[body]), shape.name});
    for (std::size_t i = 0; i < shape.vertex_names.size(); ++i) {
      texts.push_back(
          {fmt::format("shapes.{}.names.{}", kBodyKeys[body], i), shape.vertex_names[i]});
    }
  }
  for (std::size_t i = 0; i < lesson.views.size(); ++i) {
    texts.push_back({fmt::format("views.{}.title", i), lesson.views[i].title});
  }
  std::erase_if(texts, [](const LessonText& text) { return text.text.empty(); });
  return texts;
}

}  // namespace gjkscope
