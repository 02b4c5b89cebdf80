// A lesson that is written and read again is the same lesson.

#include "lesson/save.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "base/decimal.hpp"
#include "lesson/case.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson_texts.hpp"
#include "subjects/balance/table.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/study/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace save_test {

using Eigen::Vector3d;

LoadedLesson parse(const std::string& text, const std::filesystem::path& folder = {}) {
  return parse_lesson(text, folder / "saved.toml", vocabulary());
}

/// `folder`: where the file would stand.
Lesson lesson(const std::string& text, const std::filesystem::path& folder = {}) {
  const LoadedLesson loaded = parse(text, folder);
  for (const Problem& problem : loaded.problems) ADD_FAILURE() << to_string(problem);
  return loaded.lesson.value_or(Lesson{});
}

void expect_survives(const Lesson& saved) {
  const std::string text = lesson_toml(saved);
  SCOPED_TRACE(text);
  const Lesson read = lesson(text);
  EXPECT_EQ(read, saved);
  EXPECT_EQ(lesson_toml(read), text);
}

/// Written as it is read: every key but those of time and of a motion, no value that a key has
/// anyway, and lines that are filled.
const std::string kWritten =
    R"(title = "Two \"triangles\", one \\ of them turned – and named"
chapter = 4
order = 3
source = "Own example"
prose = """\
    The distance is {distance}; {{braces}} stay, and so do \"quotes\", a \\, two  blanks and one at the end of this \
    text, which goes on for some more words, until it needs a third line of the file. There it is, at last, past this \
    comma, and ends. """

[shapes.X]
name = "Left"
names = ["A", "B", "C"]
vertices = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.1875]]
rotate = 15.0

[shapes.Y]
vertices = [
    [4.0, 0.0], [6.0, -0.0], [6.123233995736766e-17, 2.0], [0.30000000000000004, 1e+18], [1e-07, 3.3333333333333335],
    [5e-324, 1.0],
]
translate = [0.5, 0.0]
rotate = -30.0

[query]
scalar = "float"
direction = "towards-origin"
regions = "edges-first"
stop = ["no-progress"]
tolerance = 0.125
cap = 20
start = ["y3-C", "y1-A"]

[steps]
until = "stop"
phases = ["closest", "stop"]

[second]
scalar = "exact"

[[views]]
show = "world"
title = "World: X and Y"
camera = { center = [2.0, 1.0], height = 6.0 }
effects = ["voronoi-regions", "second-run"]

[[views]]
show = "difference"

[panel]
blocks = ["pseudocode", "weights"]
listing = "gjk"

[[questions]]
ask = "support"
at = 2

[[questions]]
ask = "stop"

[expect]
stop = "no-progress"
supports = ["y2-B"]
distance = 2.5
)";

const std::string kMotionWritten = R"(title = "Two points"
chapter = 4
order = 6
prose = "Y comes by."

[shapes.X]
vertices = [[0.0, 0.0], [1.0, 0.0]]

[shapes.Y]
name = "comet"
vertices = [[0.0, 0.0]]

[query]
stop = []
start = "center-to-center"
warm = true

[steps]
tour = "answer"

[path]
points = [[0.0, 0.0], [0.0, 1.0]]
turns = [0.0, 90.0]
frames = 9
seconds = 4.0

[path.Y]
points = [[5.0, 0.0], [3.0, 2.0]]
turns = [0.0, -30.0]

[[views]]
show = "world"

[expect]
stop = "iteration-cap"
supports = []
)";

TEST(SavedLesson, IsWrittenLikeTheOnesByHand) {
  EXPECT_EQ(lesson_toml(lesson(kWritten)), kWritten);
  EXPECT_EQ(lesson_toml(lesson(kMotionWritten)), kMotionWritten);
}

TEST(SavedLesson, IsTheLessonAgain) {
  for (const auto& file : testing::shipped_lesson_files()) {
    SCOPED_TRACE(file.string());
    const LoadedLesson loaded = load_lesson(file, vocabulary());
    ASSERT_TRUE(loaded.lesson);
    Lesson read = lesson(lesson_toml(*loaded.lesson), file.parent_path());
    EXPECT_EQ(read.id, "saved");
    read.id = loaded.lesson->id;
    read.path = loaded.lesson->path;
    EXPECT_EQ(read, *loaded.lesson);
    EXPECT_EQ(lesson_toml(read), lesson_toml(*loaded.lesson));
  }
  expect_survives(lesson(testing::kFullLesson));
  expect_survives(lesson(testing::readme_example()));
}

TEST(SavedLesson, HasNoLineTooLongWhereItCanBeBroken) {
  Lesson wide = lesson(kWritten);
  wide.prose.clear();
  while (wide.prose.size() < 290) wide.prose += "twelve chars ";
  wide.y().vertices.resize(600, Vector3d(-1.0 / 3.0, 1e-300, 0.0));
  wide.y().vertex_names = default_vertex_names(wide.y(), "Y");
  const std::string text = lesson_toml(wide);
  std::size_t longest = 0;
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
    longest = std::max(longest, text.find('\n', begin) - begin);
  EXPECT_LE(longest, 122u);
  EXPECT_GE(longest, 110u);
  expect_survives(wide);
}

TEST(SavedLesson, KeepsTheBitsOfNumbers) {
  const double values[] = {0.1,    -0.0,       1.0 / 3.0, 0x1p-1074, 0x1.fffffffffffffp-1023,
                           0x1p53, 0x1p53 + 2, 1e17,      1e18,      -0x1.23456789abcdep-40};
  Lesson saved = lesson(testing::readme_example());
  for (const double value : values) {
    saved.y().vertices[0] = Vector3d(value, -value, 0.0);
    saved.y().translate = Vector3d(-value, value, 0.0);
    const Lesson read = lesson(lesson_toml(saved));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.y().vertices[0].x()),
              std::bit_cast<std::uint64_t>(value));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.y().vertices[0].y()),
              std::bit_cast<std::uint64_t>(-value));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.y().translate.x()),
              std::bit_cast<std::uint64_t>(-value));
  }
}

TEST(SavedLesson, OfTheLargestShapesCanBeRead) {
  Lesson largest = lesson(testing::readme_example());
  largest.x().name = "X";
  for (LessonShape* shape : {&largest.x(), &largest.y()}) {
    shape->vertices.assign(10000,
                           Vector3d(-1.2345678901234567e-300, -1.2345678901234567e-299, 0.0));
    shape->vertex_names = default_vertex_names(*shape, shape == &largest.x() ? "X" : "Y");
  }
  // Other names than those that a file need not tell, as long as names can be.
  const auto letter = [](std::size_t i) { return fmt::format("\xF0\x90\x8C{}", char(0x80 + i)); };
  for (std::size_t i = 0; i < 10000; ++i)
    largest.y().vertex_names[i] = letter(i % 40) + letter(i / 40 % 40) + letter(i / 1600);
  largest.expect.supports.reset();
  expect_survives(largest);
}

TEST(SavedLesson, OfACaseSaysWhatItLacks) {
  const Case value{{{0, 0}}, {{3, 4}, {5, 6}}};
  Lesson saved = lesson_of(value, "pasted", ScalarKind::half);
  std::string missing;
  for (const Problem& problem : parse(lesson_toml(saved)).problems) missing += problem.what + "\n";
  EXPECT_EQ(missing, "missing key 'prose'\nmissing key 'views'\nmissing key 'stop'\n");

  saved.id = "saved";
  saved.path = "saved.toml";
  saved.prose = "Pasted.";
  saved.views.emplace_back().kind = ViewKind::difference;
  saved.expect.stop = "origin-inside";
  expect_survives(saved);
}

TEST(SavedLesson, LeavesOutWhatAFileCannotSay) {
  const Lesson loaded = lesson(kWritten);
  Lesson other = loaded;
  other.options.start.pairs[2] = {1, 2};
  EXPECT_EQ(other, loaded) << "only the first two pairs count";
  other.options.proof = gjk::Proof::none;
  other.id = "other";
  other.path = "other.toml";
  EXPECT_EQ(lesson_toml(other), lesson_toml(loaded));
}

// ---- lessons made up ----

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t end) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}
bool one_in(Random& random, std::size_t count) { return below(random, count) == 0; }

template <class E>
E any_of(Random& random) {
  const auto& table = Named<E>::kTable;
  return table[below(random, table.size())].second;
}

std::string any_name(Random& random, const std::vector<std::string>& names) {
  return names[below(random, names.size())];
}

std::string any_text(Random& random, std::size_t longest) {
  static const std::vector<std::string> pieces = {
      "\"",     "\\",   " ",  "  ", "a",   "word", "'''", "\"\"\"", "#",      "\u00a0", "é",
      "\u2212", "{{",   "}}", "=",  "\\n", "[",    "]",   "\u3000", "\ufeff", "𝔊",      "\u0085",
      "\u2028", "\\u0", ",",  ".",  "{x}", "Ω ",   "–",   " и",     " \\"};
  std::string text;
  for (std::size_t i = 1 + below(random, longest); i > 0; --i)
    text += pieces[below(random, pieces.size())];
  return text;
}

double any_number(Random& random, double largest) {
  switch (below(random, 4)) {
    case 0:
      return std::round(std::uniform_real_distribution<double>(-10.0, 10.0)(random));
    case 1:
      return std::uniform_real_distribution<double>(-10.0, 10.0)(random);
    case 2:
      return std::uniform_real_distribution<double>(-largest, largest)(random);
    default:
      break;
  }
  const double value = std::bit_cast<double>(random());
  return std::abs(value) <= largest ? value : -0.0;
}

Vector3d any_point(Random& random, double largest) {
  const double x = any_number(random, largest);
  return {x, any_number(random, largest), 0.0};
}

std::vector<Vector3d> any_points(Random& random, std::size_t least, std::size_t most) {
  std::vector<Vector3d> points(least + below(random, most - least + 1));
  for (Vector3d& point : points) point = any_point(random, 1e18);
  return points;
}

LessonMotion any_motion(Random& random) {
  LessonMotion motion{any_points(random, 2, 9), {}};
  if (!one_in(random, 3)) return motion;
  for (std::size_t i = 0; i < motion.points.size(); ++i)
    motion.turns.push_back(any_number(random, 360.0));
  return motion;
}

LessonShape any_shape(Random& random, std::string_view key) {
  LessonShape shape;
  shape.name = one_in(random, 2) ? std::string(key) : any_text(random, 4);
  shape.vertices = any_points(random, 1, one_in(random, 4) ? 1 : 12);
  shape.vertex_names = default_vertex_names(shape, key);
  if (one_in(random, 2)) {
    for (std::size_t i = 0; i < shape.vertices.size(); ++i)
      shape.vertex_names[i] = fmt::format("{}{}", key, i);
  }
  if (one_in(random, 2)) shape.translate = any_point(random, 1e18);
  if (one_in(random, 2)) shape.rotate_degrees = any_number(random, 360.0);
  return shape;
}

/// Nearly a lesson: most of these the loader takes.
Lesson any_lesson(Random& random) {
  Lesson out;
  out.id = "saved";
  out.path = "saved.toml";
  out.title = any_text(random, 20);
  out.chapter = 1 + static_cast<int>(below(random, 7));
  out.order = 1 + static_cast<int>(below(random, 99));
  if (one_in(random, 2)) out.source = any_text(random, 30);
  out.prose = any_text(random, 120);
  out.x() = any_shape(random, "X");
  out.y() = any_shape(random, "Y");
  if (one_in(random, 2)) out.scalar = any_of<ScalarKind>(random);
  if (out.scalar == ScalarKind::half) out.scalar = ScalarKind::single;
  out.views.resize(1 + below(random, 2));
  for (LessonView& view : out.views) {
    view.kind = any_of<ViewKind>(random);
    if (one_in(random, 2)) view.title = any_text(random, 20);
    if (one_in(random, 2)) {
      view.camera = {any_point(random, 1e18), std::abs(any_number(random, 1e17)) + 1e-18};
      if (one_in(random, 2)) view.camera->stretch = std::abs(any_number(random, 1e8)) + 1e-8;
    }
    if (one_in(random, 3)) {
      view.close_up = {{any_point(random, 1e18), std::abs(any_number(random, 1e17)) + 1e-18},
                       any_of<CardCorner>(random)};
    }
    if (one_in(random, 2)) view.effects = {any_name(random, names_of(vocabulary().effects))};
  }
  if (one_in(random, 6) && out.scalar != ScalarKind::exact) {
    out.tour = "iteration";
    out.settings = TourSettings(LessonSecond{.scalar = ScalarKind::exact});
    out.views.back().effects = {"second-run"};
  }
  gjk::Options& options = out.options;
  if (one_in(random, 3)) options.direction_rule = any_of<gjk::DirectionRule>(random);
  if (one_in(random, 3)) options.region_order = any_of<gjk::RegionOrder>(random);
  options.stop_on_repeated_support = !one_in(random, 3);
  options.stop_on_no_progress = !one_in(random, 3);
  if (one_in(random, 3)) options.tolerance = std::uniform_real_distribution<double>()(random);
  if (one_in(random, 3)) options.iteration_cap = 1 + static_cast<int>(below(random, 100));
  options.start.count = static_cast<int>(below(random, 4));
  for (gjk::VertexPair& pair : options.start.pairs)
    pair = {static_cast<int>(below(random, out.x().vertices.size())),
            static_cast<int>(below(random, out.y().vertices.size()))};

  if (one_in(random, 2)) out.tour = any_name(random, names_of(vocabulary().tours));
  if (one_in(random, 3)) out.until = any_of<gjk::Phase>(random);
  if (out.tour == "phase" && one_in(random, 2))
    out.phases = {any_of<gjk::Phase>(random), any_of<gjk::Phase>(random)};
  if (one_in(random, 2)) {
    LessonPath& path = out.path_of_shapes.emplace();
    if (one_in(random, 2)) path.seconds = 0.5 + std::abs(any_number(random, 3000.0));
    if (path.seconds || one_in(random, 2)) path.frames = 2 + static_cast<int>(below(random, 90));
    if (path.seconds && one_in(random, 2)) path.y() = any_motion(random);
    if (path.y().points.empty() || one_in(random, 2)) path.x() = any_motion(random);
    if (!path.seconds) path.x().turns.clear();
    if (!path.x().points.empty()) out.x().translate = Vector3d::Zero();
    if (!path.y().points.empty()) out.y().translate = Vector3d::Zero();
    out.x().rotate_degrees = 0.0;
    out.y().rotate_degrees = 0.0;
    out.warm_start = one_in(random, 2);
  }
  if (out.tour == "time") {
    LessonTime time;
    time.seconds = 0.5 + std::abs(any_number(random, 3000.0));
    time.frames = one_in(random, 2) ? 0 : 2 + static_cast<int>(below(random, 4));
    const std::size_t positions = out.path_of_shapes ? out.path_of_shapes->positions() : 1;
    while (time.frames == 0 && time.moments.size() < positions) {
      std::vector<double>& moments = time.moments.emplace_back();
      for (int i = static_cast<int>(below(random, 3)); i < 4; ++i)
        moments.push_back(time.seconds * i / 3);
    }
    out.settings = TourSettings(time);
  }
  if (out.tour == "growth") {
    LessonGrowth growth;
    for (int size = 3; growth.vertices.size() < 2 || !one_in(random, 4); size *= 2)
      growth.vertices.push_back(size + static_cast<int>(below(random, 3)));
    growth.runs = 1 + static_cast<int>(below(random, 200));
    growth.seed = static_cast<int>(below(random, 3));
    if (one_in(random, 2)) growth.tolerance = std::uniform_real_distribution<double>()(random);
    if (one_in(random, 2)) {
      growth.times.emplace().machine = "a \"machine\"";
      for (const auto& [name, member] : kGrowthTimes) {
        for (std::size_t i = 0; i < growth.vertices.size(); ++i)
          (*growth.times.*member).push_back(1.0 + std::abs(any_number(random, 1e9)));
      }
    }
    out.settings = TourSettings(growth);
  }
  if (out.tour == "study") {
    static const TourSettings kShipped =
        with_absolute_file(
            *load_lesson(testing::lessons_folder() / "accuracy-cost.toml", vocabulary()).lesson)
            .settings;
    out.settings = kShipped;
    std::vector<StudyMark>& marks = out.settings.edit<LessonStudy>().marks;
    marks.resize(1 + below(random, marks.size()));
  }
  for (LessonView& view : out.views) {
    if ((out.tour == "growth" || out.tour == "study") && one_in(random, 2))
      view.kind = ViewKind::plot;
    if (!shows_shapes(view.kind)) view.camera.reset();
    if (!shows_shapes(view.kind)) view.close_up.reset();
    if (!shows_shapes(view.kind) && !out.calls_for("second-run")) view.effects.clear();
  }
  for (std::size_t i = below(random, 4); i > 0; --i) {
    const std::string block = any_name(random, names_of(vocabulary().blocks));
    if (std::count(out.panel.begin(), out.panel.end(), block) == 0) out.panel.push_back(block);
    if (block == "pseudocode") out.listing = any_name(random, names_of(vocabulary().listings));
  }
  if (out.tour == "iteration" && one_in(random, 2)) {
    const std::vector<std::string> asks = {"support", "region", "dropped", "stop"};
    out.questions = {{any_name(random, asks), 3}, {any_name(random, asks), 7}};
    if (one_in(random, 2)) out.questions.resize(1);
    if (out.questions.size() == 1) out.questions[0].at.reset();
  }
  out.expect.stop = name_of(any_of<gjk::StopReason>(random));
  if (one_in(random, 2)) out.expect.distance = std::abs(any_number(random, 1e18));
  if (one_in(random, 2)) out.expect.supports.emplace();
  return out;
}

TEST(SavedLesson, SurvivesWhateverItHoldsThatTheLoaderTakes) {
  constexpr int kLessons = 12000;
  constexpr unsigned kSeed = 20100311;
  int taken = 0;
  int long_prose = 0;
  int points = 0;
  int paths = 0;
  int timed = 0;
  int grown = 0;
  int studied = 0;
  for (int i = 0; i < kLessons; ++i) {
    Random random(kSeed + static_cast<unsigned>(i));
    const Lesson made = any_lesson(random);
    const std::string text = lesson_toml(made);
    SCOPED_TRACE(fmt::format("lesson {}:\n{}", i, text));
    const LoadedLesson loaded = parse_lesson(text, "saved.toml", vocabulary());
    ASSERT_TRUE(loaded.lesson || !loaded.problems[0].what.starts_with("not TOML"))
        << to_string(loaded.problems[0]);
    if (!loaded.lesson) continue;
    ASSERT_EQ(*loaded.lesson, made);
    ASSERT_EQ(lesson_toml(*loaded.lesson), text);
    ++taken;
    long_prose += text.find("\"\"\"\\\n") != std::string::npos;
    points += made.x().vertices.size() == 1;
    paths += made.path_of_shapes.has_value();
    timed += made.settings.as<LessonTime>() != nullptr;
    grown += made.settings.as<LessonGrowth>() != nullptr;
    studied += made.settings.as<LessonStudy>() != nullptr;
  }
  fmt::print(
      "{} lessons: {} taken, {} with long prose, {} point queries, {} paths, {} timed, {} grown, "
      "{} studied\n",
      kLessons, taken, long_prose, points, paths, timed, grown, studied);
  // They stand for all there are.
  EXPECT_GE(taken, 500);
  EXPECT_GE(long_prose, 100);
  EXPECT_GE(points, 20);
  EXPECT_GE(paths, 50);
  EXPECT_GE(grown, 10);
  EXPECT_GE(studied, 5);
}

TEST(Decimal, IsShortAndNoWholeNumber) {
  EXPECT_EQ(decimal(2.0), "2.0");
  EXPECT_EQ(decimal(-0.0), "-0.0");
  EXPECT_EQ(decimal(0.1), "0.1");
  EXPECT_EQ(decimal(1e-7), "1e-07");
  EXPECT_EQ(decimal(1e18), "1e+18");
  EXPECT_EQ(decimal(0x1p-1074), "5e-324");
}

}  // namespace save_test
}  // namespace gjkscope
