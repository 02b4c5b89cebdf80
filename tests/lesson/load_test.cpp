#include "lesson/load.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>

#include "lesson/schema.hpp"
#include "lesson_texts.hpp"
#include "run/run.hpp"
#include "subjects/balance/balance.hpp"
#include "subjects/balance/table.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/study/table.hpp"
#include "subjects/study/tour.hpp"
#include "subjects/subjects.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace load_test {

LoadedLesson parse(std::string_view text) {
  return parse_lesson(text, "lessons/two.toml", vocabulary());
}

std::string all_of(const std::vector<Problem>& problems) {
  std::string out;
  for (const Problem& problem : problems) out += to_string(problem) + "\n";
  return out;
}

/// kFullLesson with one text replaced. A '¦' in the new text marks where the problem stands; it is
/// taken out.
struct Edited {
  std::string text;
  Place marked;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "the lesson has no " << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

/// A text, what takes its place, and what the problem says.
using Edits = std::vector<std::array<std::string, 3>>;

void expect_refused(const std::string& text, const Edits& edits,
                    const std::filesystem::path& file = "lessons/two.toml") {
  for (const auto& [from, to, what] : edits) {
    const LoadedLesson loaded = parse_lesson(replaced(text, from, to), file, vocabulary());
    const std::string problems = all_of(loaded.problems);
    EXPECT_NE(problems.find(what), std::string::npos) << to << "\n" << problems;
  }
}

Edited edited(const std::string& from, const std::string& to) {
  const std::string mark = "¦";
  Edited out{replaced(testing::kFullLesson, from, to), {}};
  const std::size_t at = out.text.find(mark);
  if (at == std::string::npos) return out;
  out.text.erase(at, mark.size());
  for (std::size_t i = 0; i < at; ++i) {
    const auto byte = static_cast<unsigned char>(out.text[i]);
    if (byte == '\n') {
      out.marked = {out.marked.line + 1, 1};
    } else if ((byte & 0xC0) != 0x80) {
      ++out.marked.column;
    }
  }
  return out;
}

// --- what is read ---------------------------------------------------------------------------

TEST(Load, EveryKeyReachesTheLesson) {
  const LoadedLesson loaded = parse(testing::kFullLesson);
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  const Lesson& lesson = *loaded.lesson;
  EXPECT_EQ(lesson.id, "two");
  EXPECT_EQ(lesson.path, "lessons/two.toml");
  EXPECT_EQ(lesson.title, "Two triangles");
  EXPECT_EQ(lesson.chapter, 4);
  EXPECT_EQ(lesson.order, 3);
  EXPECT_EQ(lesson.source, "Own example");
  EXPECT_EQ(lesson.prose, "The distance is {distance}; {{braces}} stay.");
  EXPECT_EQ(lesson.x().name, "Left");
  EXPECT_EQ(lesson.x().vertex_names, (std::vector<std::string>{"A", "B", "C"}));
  ASSERT_EQ(lesson.x().vertices.size(), 3u);
  EXPECT_EQ(lesson.x().vertices[2], Eigen::Vector3d(1.0, 0.1875, 0.0));
  EXPECT_EQ(lesson.x().rotate_degrees, 15.0);
  EXPECT_EQ(lesson.y().translate, Eigen::Vector3d(0.5, 0.0, 0.0));
  EXPECT_EQ(lesson.y().rotate_degrees, -30.0);
  EXPECT_EQ(lesson.scalar, ScalarKind::single);
  const gjk::Options& options = lesson.options;
  EXPECT_EQ(options.direction_rule, gjk::DirectionRule::towards_origin);
  EXPECT_EQ(options.region_order, gjk::RegionOrder::edges_first);
  EXPECT_FALSE(options.stop_on_repeated_support);
  EXPECT_TRUE(options.stop_on_no_progress);
  EXPECT_EQ(options.tolerance, 0.125);
  EXPECT_EQ(options.iteration_cap, 20);
  ASSERT_EQ(options.start.count, 2);
  EXPECT_EQ(options.start.pairs[0], (gjk::VertexPair{2, 2}));
  EXPECT_EQ(options.start.pairs[1], (gjk::VertexPair{0, 0}));
  EXPECT_EQ(lesson.tour, "iteration");
  EXPECT_EQ(lesson.until, gjk::Phase::stop);
  ASSERT_TRUE(lesson.path_of_shapes);
  EXPECT_EQ(lesson.path_of_shapes->x().points.size(), 2u);
  EXPECT_EQ(lesson.path_of_shapes->frames, 13);
  ASSERT_EQ(lesson.views.size(), 2u);
  EXPECT_EQ(lesson.views[0].title, "World: X and Y");
  ASSERT_TRUE(lesson.views[0].camera);
  EXPECT_EQ(lesson.views[0].camera->center, Eigen::Vector3d(2, 1, 0));
  EXPECT_EQ(lesson.views[0].camera->height, 6.0);
  EXPECT_EQ(lesson.views[0].effects, (std::vector<std::string>{"voronoi-regions", "history"}));
  EXPECT_EQ(lesson.views[1].kind, ViewKind::difference);
  EXPECT_FALSE(lesson.views[1].close_up);
  ASSERT_TRUE(lesson.views[0].close_up);
  EXPECT_EQ(*lesson.views[0].close_up, (CloseUp{{{0, -1, 0}, 1e-9}, CardCorner::top_left}));
  EXPECT_EQ(lesson.panel, (std::vector<std::string>{"pseudocode", "weights"}));
  EXPECT_EQ(lesson.listing, "gjk");
  EXPECT_EQ(lesson.expect.stop, "no-progress");
  EXPECT_EQ(lesson.expect.supports, (std::vector<std::string>{"K-B"}));
  EXPECT_EQ(lesson.expect.distance, 2.5);
}

TEST(Load, WhatIsMissingHasItsDefault) {
  const LoadedLesson loaded = parse(testing::kShortestLesson);
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  const Lesson& lesson = *loaded.lesson;
  EXPECT_EQ(lesson.x().name, "X");
  EXPECT_EQ(lesson.x().vertex_names, (std::vector<std::string>{"X"}));
  EXPECT_EQ(lesson.y().vertex_names, (std::vector<std::string>{"y1", "y2"}));
  EXPECT_EQ(lesson.scalar, ScalarKind::double_);
  EXPECT_EQ(lesson.options.iteration_cap, gjk::kDefaultIterationCap);
  EXPECT_TRUE(lesson.options.stop_on_repeated_support);
  EXPECT_TRUE(lesson.options.stop_on_no_progress);
  EXPECT_EQ(lesson.options.start.count, 1);
  EXPECT_EQ(lesson.tour, "phase");
  EXPECT_FALSE(lesson.path_of_shapes);
  EXPECT_FALSE(lesson.views[0].camera);
  EXPECT_TRUE(lesson.panel.empty());
  EXPECT_EQ(lesson.listing, "");
  EXPECT_FALSE(lesson.expect.supports);
}

TEST(Load, NumbersKeepEveryBit) {
  const struct {
    std::string written;
    double value;
  } cases[] = {{"21119118e-9", 21119118e-9},
               {"79.584320", 79.584320},
               {"0.1", 0.1},
               {"-0.0", -0.0},
               {"5e-324", 5e-324},
               {"1_000.5", 1000.5},
               {"7", 7.0},
               {"\"0x1.5a0574p-6\"", 0x1.5a0574p-6},
               {"\"-0x1.fffffffffffffp+9\"", -0x1.fffffffffffffp+9},
               {"\"+0x10\"", 16.0},
               {"1e18", 1e18}};
  for (const auto& [written, value] : cases) {
    const LoadedLesson loaded =
        parse(replaced(testing::kFullLesson, "[4, 0]", fmt::format("[{}, 0]", written)));
    ASSERT_TRUE(loaded.lesson) << written << "\n" << all_of(loaded.problems);
    EXPECT_EQ(loaded.lesson->y().vertices[0].x(), value) << written;
    EXPECT_EQ(std::signbit(loaded.lesson->y().vertices[0].x()), std::signbit(value)) << written;
  }
}

TEST(Load, APointQueryNamesVerticesOfY) {
  std::string text = replaced(testing::kFullLesson, R"(names = ["A", "B", "C"])", "");
  text = replaced(text, R"([[0.0, 1.0], [1, 1], [1, "0x1.8p-3"]])", "[[0, 0]]");
  text = replaced(text, R"(["M-C", "K-A"])", R"(["M"])");
  text = replaced(text, R"(["K-B"])", R"(["L", "M"])");
  const LoadedLesson loaded = parse(text);
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  EXPECT_EQ(loaded.lesson->x().vertex_names, (std::vector<std::string>{"Left"}));
  EXPECT_EQ(loaded.lesson->options.start.pairs[0], (gjk::VertexPair{0, 2}));
}

TEST(Load, CenterToCenterIsAStart) {
  const LoadedLesson loaded =
      parse(replaced(testing::kFullLesson, R"(["M-C", "K-A"])", "\"center-to-center\""));
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  EXPECT_EQ(loaded.lesson->options.start.count, 0);
}

TEST(Load, AnEmptyStopListLeavesBothTestsOut) {
  const LoadedLesson loaded = parse(replaced(testing::kFullLesson, R"(["no-progress"])", "[]"));
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  EXPECT_FALSE(loaded.lesson->options.stop_on_repeated_support);
  EXPECT_FALSE(loaded.lesson->options.stop_on_no_progress);
}

TEST(Load, LineEndsAndByteOrderMarksOfOtherSystemsAreRead) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : testing::kFullLesson)
    text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(parse(text).lesson) << all_of(parse(text).problems);
}

// --- what is refused, and where ---------------------------------------------------------------

struct Refused {
  std::string from;
  std::string to;  ///< '¦' marks the place of the problem.
  std::string what;
  std::string nearest = "";
};

const std::string kVerticesOfY =
    "names = [\"K\", \"L\", \"M\"]\nvertices = [[4, 0], [6, 0], [5, 2]]";

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.to.substr(0, 80); }

class LoadRefuses : public ::testing::TestWithParam<Refused> {};

TEST_P(LoadRefuses, AtItsPlaceAndNothingElse) {
  const Refused& wanted = GetParam();
  const Edited edit = edited(wanted.from, wanted.to);
  const LoadedLesson loaded = parse(edit.text);
  EXPECT_FALSE(loaded.lesson);
  ASSERT_EQ(loaded.problems.size(), 1u) << wanted.to << "\n" << all_of(loaded.problems);
  const Problem& problem = loaded.problems[0];
  EXPECT_EQ(problem.file, "lessons/two.toml");
  EXPECT_EQ((std::pair{problem.line, problem.column}),
            (std::pair{edit.marked.line, edit.marked.column}))
      << to_string(problem);
  EXPECT_EQ(problem.what, wanted.what);
  EXPECT_EQ(problem.nearest, wanted.nearest);
}

std::string times(const std::string& piece, int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += piece;
  return out;
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, LoadRefuses,
    ::testing::Values(
        Refused{"cap = 20", "cap = 1e999¦",
                "not TOML: Error while parsing floating-point: '1e999' could not be interpreted "
                "as a value"},
        Refused{"cap = 20", "cap = 20\ncap = ¦21",
                "not TOML: Error while parsing key-value pair: cannot redefine existing integer "
                "'cap'"},
        Refused{"distance = 2.5", "distance = '''2.5¦",
                "not TOML: Error while parsing literal string: encountered end-of-file"},
        Refused{"cap = 20", "cap = 20\na.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p¦.q = 1",
                "a key of too many parts"}));

INSTANTIATE_TEST_SUITE_P(
    Keys, LoadRefuses,
    ::testing::Values(
        Refused{"source =", "¦sorce =", "unknown key 'sorce'", "source"},
        Refused{"rotate = 15", "¦rotat = 15", "unknown key 'rotat'", "rotate"},
        Refused{"tolerance", "¦tolerence", "unknown key 'tolerence'", "tolerance"},
        Refused{"until", "¦util", "unknown key 'util'", "until"},
        Refused{"frames = 13", "¦frame = 13", "unknown key 'frame'", "frames"},
        Refused{"{ center", "{ ¦zoom = 1, center", "unknown key 'zoom'"},
        Refused{"[steps]", "[¦stage]\n[steps]", "unknown key 'stage'"},
        Refused{"distance = 2.5", "¦\"dis\\ntance\" = 2.5", "unknown key 'dis?tance'", "distance"},
        Refused{"[shapes.Y]", "[shapes.¦Z]\n[shapes.Y]", "unknown key 'Z'"},
        Refused{"\nchapter = 4", "", "missing key 'chapter'"},
        Refused{"{ center = [0, -1], height = 1e-9", "¦{ center = [0, -1]", "missing key 'height'"},
        Refused{"[shapes.Y]\nname = \"Right\"\n" + kVerticesOfY, "¦[shapes.Y]",
                "missing key 'vertices'"}));

INSTANTIATE_TEST_SUITE_P(
    Types, LoadRefuses,
    ::testing::Values(
        Refused{"\"Own example\"", "¦3", "'source' is a number"},
        Refused{"chapter = 4", "chapter = ¦\"4\"", "'chapter' is text"},
        Refused{"order = 3", "order = ¦3.0", "'order' is not a whole number"},
        Refused{"order = 3", "order = ¦true", "'order' is true or false"},
        Refused{"rotate = -30", "rotate = ¦1979-05-27", "'rotate' is a date or time"},
        Refused{"rotate = -30", "rotate = ¦[1]", "'rotate' is a list"},
        Refused{"\"float\"", "¦{}", "'scalar' is a table"},
        Refused{"[1, 1], [1,", "¦1, [1,", "entry 2 of 'vertices' is a number"},
        Refused{"[1, 1], [1,", "¦[1, 1, 0], [1,", "entry 2 of 'vertices' has 3 coordinates"},
        Refused{"[1, 1], [1,", "[1, ¦\"1\"], [1,", "entry 2 of entry 2 of 'vertices' is text"},
        Refused{"\"0x1.8p-3\"", "¦\"0x1.8p-3x\"", "entry 2 of entry 3 of 'vertices' is text"},
        Refused{"\"0x1.8p-3\"", "¦\"0x-1\"", "entry 2 of entry 3 of 'vertices' is text"},
        Refused{"\"0x1.8p-3\"", "¦\"0x1p9999\"", "entry 2 of entry 3 of 'vertices' is text"},
        Refused{"[\"no-progress\"]", "¦\"no-progress\"", "'stop' is text"},
        Refused{"[\"M-C\", \"K-A\"]", "¦1", "'start' is a number"},
        Refused{"[\"K-B\"]", "[¦0]", "entry 1 of 'supports' is a number"},
        Refused{"{ center = [2, 1], height = 6.0 }", "¦6.0", "'camera' is a number"},
        Refused{"[\"voronoi-regions\", \"history\"]", "¦\"history\"", "'effects' is text"},
        Refused{"[\"pseudocode\", \"weights\"]\nlisting = \"gjk\"", "¦\"weights\"",
                "'blocks' is text"}));

INSTANTIATE_TEST_SUITE_P(
    Ranges, LoadRefuses,
    ::testing::Values(
        Refused{"chapter = 4", "chapter = ¦-1", "'chapter' is -1"},
        Refused{"chapter = 4", "chapter = ¦100", "'chapter' is 100"},
        Refused{"order = 3", "order = ¦0", "'order' is 0"},
        Refused{"cap = 20", "cap = ¦0", "'cap' is 0"},
        Refused{"cap = 20", "cap = ¦101", "'cap' is 101"},
        Refused{"cap = 20", "cap = ¦9223372036854775807", "'cap' is 9223372036854775807"},
        Refused{"0.125", "¦1.0", "'tolerance' is 1"},
        Refused{"0.125", "¦-0.25", "'tolerance' is -0.25"},
        Refused{"0.125", "¦nan", "'tolerance' is not a finite number"},
        Refused{"frames = 13", "frames = ¦1", "'frames' is 1"},
        Refused{"frames = 13", "frames = ¦501", "'frames' is 501"},
        Refused{"[[0, 0], [1, 1]]", "¦[[0, 0]]", "'points' has 1 entries"},
        Refused{"[[0, 0], [1, 1]]", "¦[" + times("[0, 0],", 501) + "]", "'points' has 501 entries"},
        Refused{"rotate = 15.0", "rotate = ¦inf", "'rotate' is not a finite number"},
        Refused{"rotate = 15.0", "rotate = ¦361", "'rotate' is 361"},
        Refused{"[0.5, 0.0]", "[¦-inf, 0.0]", "entry 1 of 'translate' is not a finite number"},
        Refused{"[0.5, 0.0]", "[0, ¦1e19]", "entry 2 of 'translate' is 1e+19"},
        Refused{"height = 6.0", "height = ¦0", "'height' is 0"},
        Refused{"height = 6.0", "height = ¦-1", "'height' is -1"},
        Refused{"distance = 2.5", "distance = ¦-2.5", "'distance' is -2.5"},
        Refused{"\"Two triangles\"", "¦\"\"", "'title' is empty"},
        Refused{"\"Two triangles\"", "¦\"" + times("ä", 81) + "\"", "'title' has 81 characters"},
        Refused{"\"Own example\"", "¦\"" + times("x", 121) + "\"", "'source' has 121 characters"},
        Refused{"\"The distance", "¦\"" + times("x", 300) + "The distance",
                "'prose' has 344 characters"},
        Refused{"\"Two triangles\"", "¦\"Two\\ntriangles\"",
                "'title' holds a line break or a control character"},
        Refused{"\"World: X and Y\"", "¦\"" + times("x", 61) + "\"", "'title' has 61 characters"},
        Refused{"\"Left\"", "¦\"Robot on wheels\"", "'name' has 15 characters"}));

INSTANTIATE_TEST_SUITE_P(
    Names, LoadRefuses,
    ::testing::Values(
        Refused{"\"float\"", "¦\"flaot\"", "unknown scalar 'flaot'", "float"},
        Refused{"\"towards-origin\"", "¦\"towards_orgin\"",
                "unknown direction rule 'towards_orgin'", "towards-origin"},
        Refused{"\"edges-first\"", "¦\"last\"", "unknown region order 'last'"},
        Refused{"[\"no-progress\"]", "[¦\"iteration-cap\"]", "unknown stop test 'iteration-cap'"},
        Refused{"\"iteration\"", "¦\"iterations\"", "unknown tour 'iterations'", "iteration"},
        Refused{"until = \"stop\"", "until = ¦\"step\"", "unknown phase 'step'", "stop"},
        Refused{"\"difference\"", "¦\"diference\"", "unknown view 'diference'", "difference"},
        Refused{"\"history\"", "¦\"histroy\"", "unknown effect 'histroy'", "history"},
        Refused{"\"weights\"", "¦\"weight\"", "unknown panel block 'weight'", "weights"},
        Refused{"\"gjk\"", "¦\"GJK\"", "unknown listing 'GJK'", "gjk"},
        Refused{"\"top left\"", "¦\"top-left\"", "unknown corner 'top-left'", "top left"},
        Refused{"stop = \"no-progress\"", "stop = ¦\"running\"", "unknown stop reason 'running'"},
        Refused{"[\"M-C\", \"K-A\"]", "¦\"centre-to-centre\"", "unknown start 'centre-to-centre'",
                "center-to-center"},
        Refused{"\"The distance", "¦\"The {distanc}", "unknown placeholder 'distanc'", "distance"},
        Refused{"\"The distance", "¦\"The { distance", "'prose' holds a single '{'"},
        Refused{"\"M-C\"", "¦\"M\"", "'M' is not a pair of vertices"},
        Refused{"\"M-C\"", "¦\"m-C\"", "Y has no vertex 'm'", "M"},
        Refused{"\"M-C\"", "¦\"M-K\"", "X has no vertex 'K'"},
        Refused{"\"K-B\"", "¦\"B-K\"", "pair 'B-K' has the vertex of X first"}));

INSTANTIATE_TEST_SUITE_P(
    Together, LoadRefuses,
    ::testing::Values(
        Refused{"[[4, 0], [6, 0], [5, 2]]", "¦[]", "'vertices' has 0 entries"},
        Refused{"[[4, 0], [6, 0], [5, 2]]", "¦[" + times("[0, 0],", 10001) + "]",
                "'vertices' has 10001 entries"},
        Refused{"[\"K\", \"L\", \"M\"]", "¦[\"K\", \"L\"]", "2 names for 3 vertices"},
        Refused{"[\"K\", \"L\", \"M\"]", "[\"K\", \"L\", ¦\"K\"]", "vertex name 'K' is used twice"},
        Refused{"[\"K\", \"L\", \"M\"]", "[\"K\", ¦\"B\", \"M\"]", "vertex name 'B' is used twice"},
        Refused{"[\"K\", \"L\", \"M\"]", "[\"K\", ¦\"Long\", \"M\"]",
                "entry 2 of 'names' has 4 characters"},
        Refused{"[\"K\", \"L\", \"M\"]", "[\"K\", ¦\"\", \"M\"]", "entry 2 of 'names' is empty"},
        Refused{"[\"K\", \"L\", \"M\"]", "[\"K\", ¦\"L-\", \"M\"]",
                "vertex name 'L-' cannot be told from a pair"},
        Refused{"\"K-A\"]", "¦\"M-C\"]", "entry 2 of 'start' repeats a vertex"},
        Refused{"[\"M-C\", \"K-A\"]", "¦[]", "'start' has 0 entries"},
        Refused{"[\"M-C\", \"K-A\"]", "¦[\"K-A\", \"K-B\", \"K-C\", \"L-A\"]",
                "'start' has 4 entries"},
        Refused{"tour = \"iteration\"", "¦granularity = \"iteration\"",
                "'granularity' has another name now"},
        Refused{"tour = \"iteration\"\nuntil = \"stop\"", "tour = \"test\"\nuntil = ¦\"stop\"",
                "'until' with tour 'test'"},
        Refused{"\"iteration\"\nuntil = \"stop\"\n\n[path]\npoints = [[0, 0], [1, 1]]\nframes = 13",
                "¦\"path\"", "tour 'path' without its table"},
        Refused{"\"iteration\"\nuntil = \"stop\"", "¦\"time\"", "tour 'time' without its table"},
        Refused{"[steps]", "¦[time]\nseconds = 2\nframes = 3\n[steps]",
                "a table [time] without tour 'time'"},
        Refused{"\"iteration\"\nuntil = \"stop\"", "¦\"maps\"", "tour 'maps' without a triangle"},
        Refused{"\"iteration\"\nuntil = \"stop\"", "¦\"orders\"",
                "tour 'orders' without a triangle"},
        Refused{"\"iteration\"\nuntil = \"stop\"", "¦\"growth\"",
                "tour 'growth' without its table"},
        Refused{"[steps]", "¦[growth]\nvertices = [3, 4]\n[steps]",
                "a table [growth] without tour 'growth' or 'general-growth'"},
        Refused{"show = \"difference\"", "show = ¦\"growth\"",
                "view 'growth' without tour 'growth'"},
        Refused{"\"weights\"", "¦\"growth\"", "block 'growth' without tour 'growth'"},
        Refused{"\"iteration\"\nuntil = \"stop\"", "¦\"study\"", "tour 'study' without its table"},
        Refused{"show = \"difference\"", "show = ¦\"study\"", "view 'study' without tour 'study'"},
        Refused{"\"history\"", "¦\"balance\"", "effect 'balance' without tour 'time'"},
        Refused{"\"weights\"", "¦\"balance\"", "block 'balance' without tour 'time'"},
        Refused{"\"weights\"", "¦\"orders\"", "block 'orders' without tour 'orders'"},
        Refused{"rotate = 15.0", "translate = ¦[1, 1]", "'translate' of X besides a path"},
        Refused{"\"history\"", "\"history\", ¦\"history\"", "effect 'history' is named twice"},
        Refused{"\"weights\"", "¦\"pseudocode\"", "block 'pseudocode' is named twice"},
        Refused{"[\"pseudocode\", \"weights\"]\nlisting = \"gjk\"", "¦[\"pseudocode\"]",
                "block 'pseudocode' without a 'listing'"},
        Refused{"[\"pseudocode\", \"weights\"]\nlisting = \"gjk\"", "[]\nlisting = ¦\"gjk\"",
                "'listing' without the block 'pseudocode'"},
        Refused{"[[views]]", "¦[[views]]\nshow = \"world\"\n[[views]]\nshow = \"world\"\n[[views]]",
                "4 views"}));

TEST(Load, TimeHasMomentsForEachPosition) {
  const std::string text = testing::file_text(testing::lessons_folder() / "segment-balance.toml");
  LoadedLesson loaded = parse(text);
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  ASSERT_TRUE(loaded.lesson->settings.as<LessonTime>());
  EXPECT_EQ(loaded.lesson->settings.as<LessonTime>()->seconds, 6.0);
  EXPECT_EQ(loaded.lesson->settings.as<LessonTime>()->frames, 0);
  ASSERT_EQ(loaded.lesson->settings.as<LessonTime>()->moments.size(), 4u);
  loaded.lesson->questions.clear();
  const LessonRun run = run_lesson(*loaded.lesson);
  ASSERT_EQ(run.frames.size(), 2u + 4u + 1u + 3u);
  EXPECT_EQ(seconds_of(run, run.frames[1]), 3.0);
  EXPECT_EQ(seconds_of(run, run.frames[2]), 0.0);
  EXPECT_EQ(seconds_of(run, run.frames[5]), 6.0);
  const std::string list = "[0.0, 3.0],";
  const Edits refused = {
      {"seconds = 6.0", "seconds = 0", "'seconds' is 0"},
      {list, "[0.0, 7.0],", "number from 0 to 6"},
      {list, "[3.0, 3.0],", "does not come later"},
      {list, "[],", "is empty"},
      {list, "3.0,", "list of seconds"},
      {list, "", "3 lists for 4 positions"},
      {"seconds = 6.0", "seconds = 6.0\nframes = 9", "'moments' besides 'frames'"},
      {"moments = [", "moment = [", "a simulation without frames"},
      {"start = [\"A\", \"B\"]", "start = [\"A\"]", "tour 'time' without a segment"}};
  expect_refused(text, refused);
}

TEST(Load, TimeMayHaveItsMomentsAtEqualSteps) {
  std::string text = testing::file_text(testing::lessons_folder() / "segment-balance.toml");
  const std::size_t moments = text.find("moments = [");
  const std::size_t end = text.find("\n]\n", moments) + 3;
  text = text.substr(0, moments) + "frames = 9\n" + text.substr(end);
  LoadedLesson loaded = parse(text);
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  loaded.lesson->questions.clear();
  const LessonRun run = run_lesson(*loaded.lesson);
  ASSERT_EQ(run.frames.size(), 9 * run.runs.size());
  EXPECT_EQ(seconds_of(run, run.frames[1]), 0.75);
  EXPECT_EQ(seconds_of(run, run.frames[8]), 6.0);
  const std::string problems = all_of(parse(replaced(text, "frames = 9", "frames = 300")).problems);
  EXPECT_NE(problems.find("300 frames at each of 4 positions"), std::string::npos) << problems;
}

TEST(Load, GrowthHasAscendingNumbersOfVertices) {
  const std::string text = testing::file_text(testing::lessons_folder() / "lazy-hull.toml");
  const LoadedLesson loaded = parse(text);
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  ASSERT_TRUE(loaded.lesson->settings.as<LessonGrowth>());
  EXPECT_EQ(loaded.lesson->settings.as<LessonGrowth>()->vertices.size(), 12u);
  EXPECT_EQ(loaded.lesson->settings.as<LessonGrowth>()->vertices.back(), 1'000'000);
  EXPECT_EQ(loaded.lesson->settings.as<LessonGrowth>()->runs, 100);
  EXPECT_EQ(loaded.lesson->settings.as<LessonGrowth>()->seed, 1998);
  EXPECT_EQ(loaded.lesson->settings.as<LessonGrowth>()->tolerance, 0.001);
  const Edits refused = {
      {"[3, 10,", "[2, 10,", "entry 1 of 'vertices' is 2"},
      {"[3, 10,", "[3, 3, 10,", "3 vertices after 3; expected ascending numbers"},
      {"300000, 1000000]", "300000, 1000001]", "entry 12 of 'vertices' is 1000001"},
      {"[3, 10,", "[" + times("3, ", 6) + "10,", "'vertices' has 17 entries"},
      {"300000, 1000000]", "999999, 1000000]",
       "vertices in all; expected a sum of at most 2000000"},
      {"runs = 100", "runs = 0", "'runs' is 0"},
      {"seed = 1998", "seed = -1", "'seed' is -1"},
      {"seed = 1998", "tolerance = 1.0", "'tolerance' is 1"},
      {"[steps]", "[path]\npoints = [[0, 0], [1, 0]]\n[steps]", "tour 'growth' with a path"},
      {"tour = \"growth\"", "tour = \"growth\"\nuntil = \"support\"", "'until' with tour 'growth'"},
      {"show = \"growth\"", "show = \"growth\"\neffects = [\"history\"]",
       "'effects' in a view of growth"},
      {"show = \"growth\"", "show = \"growth\"\ncamera = { center = [0, 0], height = 1 }",
       "'camera' in a view of growth"}};
  expect_refused(text, refused);
}

TEST(Load, GrowthHasATimeForEachSize) {
  const std::string text = testing::file_text(testing::lessons_folder() / "general-growth.toml");
  const LoadedLesson loaded = parse(text);
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  ASSERT_TRUE(loaded.lesson->settings.as<LessonGrowth>()->times);
  EXPECT_EQ(loaded.lesson->settings.as<LessonGrowth>()->times->pieces.size(), 4u);
  EXPECT_EQ(loaded.lesson->settings.as<LessonGrowth>()->times->build.size(), 9u);
  const Edits refused = {{"vertices = [10, 30,", "vertices = [30,", "9 times for 8 sizes"},
                         {"pieces = [", "pieces = [1, 2, 3, 4, 5, 6, ", "10 times for 9 sizes"},
                         {"boxes = [", "boxes = [-1, ", "entry 1 of 'boxes' is -1"},
                         {"circles = ", "circle = ", "'circles'"}};
  expect_refused(text, refused);
}

TEST(Load, AStudyShowsWhatItsFileHolds) {
  const std::filesystem::path file = testing::lessons_folder() / "accuracy-cost.toml";
  const std::string text = testing::file_text(file);
  const LoadedLesson loaded = parse_lesson(text, file, vocabulary());
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  const LessonStudy& study = *loaded.lesson->settings.as<LessonStudy>();
  for (const StudyMark& mark : study.marks)
    EXPECT_EQ(study.dot(mark.configuration).configuration, mark.configuration);
  EXPECT_FALSE(study.processor().empty());
  const LessonRun run = run_lesson(*loaded.lesson);
  EXPECT_EQ(run.frames.size(), 5 + study.marks.size() + 3 + loaded.lesson->questions.size());
  EXPECT_EQ(study_frame(run, run.frames.front())->stage, StudyStage::shapes);
  EXPECT_EQ(study_frame(run, run.frames.back())->stage, StudyStage::choice);
  const std::string results = "results = \"accuracy-cost.json\"";
  const std::string family = "family = \"nearly parallel\"";
  const Edits refused = {
      {results, "results = \"nowhere.json\"", "nowhere.json: there is no such file"},
      {results, "results = \"accuracy-cost.toml\"", "accuracy-cost.toml: not JSON"},
      {results, "", "'results'"},
      {family, "family = \"nearly parallell\"", "did you mean 'nearly parallel'?"},
      {"\"double\"", "\"doubel\"", "unknown configuration 'doubel'"},
      {"\"double, cap 3\"", "\"double\"", "configuration 'double' is named twice"},
      {"ask = \"overlap\"", "ask = \"stop\"", "question 'stop' with tour 'study'"},
      {"[steps]", "[path]\npoints = [[0, 0], [1, 0]]\n[steps]", "tour 'study' with a path"},
      {"show = \"study\"", "show = \"study\"\neffects = [\"history\"]",
       "'effects' in a view of study"}};
  expect_refused(text, refused, file);
}

std::string with_second(const std::string& text, const std::string& keys) {
  return replaced(text, "[steps]", "[second]\n" + keys + "\n[steps]");
}

std::string only_problem(const std::string& text) {
  const LoadedLesson refused = parse(text);
  return refused.problems.size() == 1 ? to_string(refused.problems[0]) : all_of(refused.problems);
}

TEST(Load, ASecondRunNeedsAnotherScalarAndAViewThatShowsIt) {
  const std::string shown =
      replaced(testing::kFullLesson, "\"history\"]", "\"history\", \"second-run\"]");
  const LoadedLesson loaded = parse(with_second(shown, "scalar = \"exact\""));
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  EXPECT_EQ(second_of(*loaded.lesson)->scalar, ScalarKind::exact);
  EXPECT_FALSE(second_of(*parse(testing::kFullLesson).lesson));

  EXPECT_EQ(only_problem(with_second(shown, "scalar = \"float\"")),
            "lessons/two.toml:30:10: the second run has the scalar of the first; expected another "
            "one than 'float'");
  EXPECT_EQ(only_problem(shown),
            "lessons/two.toml:41:42: effect 'second-run' without a table [second]; expected a "
            "table [second]");
  EXPECT_EQ(only_problem(with_second(testing::kFullLesson, "scalar = \"exact\"")),
            "lessons/two.toml:29:1: a table [second] that no view shows; expected \"second-run\" "
            "among a view's effects");
  EXPECT_EQ(only_problem(replaced(testing::kFullLesson, "\"weights\"]", "\"two-runs\"]")),
            "lessons/two.toml:48:25: block 'two-runs' without a table [second]; expected a table "
            "[second]");
  EXPECT_EQ(
      only_problem(with_second(shown, "regions = \"unchecked\"")),
      "lessons/two.toml:29:1: a second run that differs from the first in more than its scalar; "
      "expected tour = \"two-runs\" in [steps], which shows them side by side");
  EXPECT_EQ(
      only_problem(with_second(shown, "mistake = \"wrong-sign\"")),
      "lessons/two.toml:29:1: a second run that differs from the first in more than its scalar; "
      "expected tour = \"two-runs\" in [steps], which shows them side by side");
  EXPECT_EQ(only_problem(with_second(shown, "scalar = \"exact\"\nmistake = \"wrong-sign\"")),
            "lessons/two.toml:29:1: [second] does not say which run it is; expected a mistake, a "
            "log, or what differs in a run of GJK: scalar, direction, regions, stop");
}

TEST(Load, TheFormerKeyOfASecondRunIsRefusedWithTheNewOne) {
  EXPECT_EQ(only_problem(replaced(testing::kFullLesson, "scalar = \"float\"",
                                  "scalar = \"float\"\nbeside = \"exact\"")),
            "lessons/two.toml:22:1: 'beside' has another name now; expected 'scalar' in a table "
            "[second]");
}

TEST(Load, EffectsOfAllDifferencesOfTooManyVerticesAreRefused) {
  const auto with = [](int of_x) {
    std::vector<std::string> many;
    for (int i = 0; i < of_x; ++i) many.push_back(fmt::format("[0.0, {}]", i));
    std::string text = replaced(testing::kFullLesson,
                                "names = [\"A\", \"B\", \"C\"]\nvertices = "
                                "[[0.0, 1.0], [1, 1], [1, \"0x1.8p-3\"]]",
                                fmt::format("vertices = [{}]", fmt::join(many, ", ")));
    text = replaced(text, "start = [\"M-C\", \"K-A\"]\n", "");
    text = replaced(text, "[path]\npoints = [[0, 0], [1, 1]]\nframes = 13\n", "");
    text = replaced(text, "vertices = [[4, 0], [6, 0], [5, 2]]",
                    fmt::format("vertices = [[4, 0], {}]",
                                fmt::join(std::vector<std::string>(199, "[6, 0]"), ", ")));
    text = replaced(text, "names = [\"K\", \"L\", \"M\"]\n", "");
    text = replaced(text, "supports = [\"K-B\"]\n", "");
    return replaced(text, "\"history\"]", "\"history\", \"minkowski-cloud\"]");
  };
  const LoadedLesson just = parse(with(5000));
  EXPECT_TRUE(just.problems.empty()) << all_of(just.problems);
  const LoadedLesson more = parse(with(5001));
  ASSERT_EQ(more.problems.size(), 1u) << all_of(more.problems);
  EXPECT_EQ(
      to_string(more.problems[0]),
      "lessons/two.toml:35:42: effect 'minkowski-cloud' of 1000200 differences y - x, 200 times "
      "5001; expected at most 1000000 of them: fewer vertices, or views without this effect");
}

TEST(Load, CoordinatesOfASecondRunInHalfPrecisionMustBeHalves) {
  std::string text = replaced(testing::kFullLesson, "\"history\"]", "\"second-run\"]");
  text = with_second(text, "scalar = \"half\"");
  EXPECT_TRUE(parse(text).lesson) << all_of(parse(text).problems);
  for (const auto& [was, is] :
       {std::pair{"[6, 0]", "[70000, 0]"}, std::pair{"[1, 1]]\nframes", "[70000, 1]]\nframes"}}) {
    const LoadedLesson loaded = parse(replaced(text, was, is));
    ASSERT_EQ(loaded.problems.size(), 1u) << all_of(loaded.problems);
    EXPECT_NE(to_string(loaded.problems[0]).find("65504"), std::string::npos);
  }
}

TEST(Load, TheListingOfTheDifferenceNeedsFramesForThePairs) {
  const std::string text = replaced(testing::kFullLesson, "\"gjk\"", "\"minkowski\"");
  const LoadedLesson loaded = parse(text);
  ASSERT_EQ(loaded.problems.size(), 1u) << all_of(loaded.problems);
  EXPECT_EQ(to_string(loaded.problems[0]),
            "lessons/two.toml:49:11: listing 'minkowski' without tour 'pairs'; expected "
            "tour = \"pairs\" in [steps]");
  EXPECT_TRUE(parse(replaced(text, "\"iteration\"", "\"pairs\"")).lesson);
}

TEST(Load, PairsAreSteppedThroughForSmallShapesOnly) {
  std::string text = replaced(testing::kFullLesson, "\"iteration\"", "\"pairs\"");
  EXPECT_TRUE(parse(text).lesson) << all_of(parse(text).problems);
  text = replaced(text, kVerticesOfY, "vertices = [" + times("[5, 5],", 9) + "]");
  text = replaced(text, "\"M-C\", \"K-A\"", "\"y9-C\"");
  text = replaced(text, "\"K-B\"", "\"y1-B\"");
  const LoadedLesson loaded = parse(text);
  ASSERT_EQ(loaded.problems.size(), 1u) << all_of(loaded.problems);
  EXPECT_EQ(to_string(loaded.problems[0]),
            "lessons/two.toml:29:8: tour 'pairs' with a shape of 9 vertices; expected at "
            "most 8 vertices in each shape");
}

TEST(Load, ManyVerticesAtManyPositionsAreTooMuch) {
  std::string text =
      replaced(testing::kFullLesson, kVerticesOfY, "vertices = [" + times("[5, 5],", 10000) + "]");
  text = replaced(text, "start = [\"M-C\", \"K-A\"]", "");
  text = replaced(text, "supports = [\"K-B\"]", "");
  const LoadedLesson loaded = parse(text);
  ASSERT_EQ(loaded.problems.size(), 1u) << all_of(loaded.problems);
  EXPECT_EQ(to_string(loaded.problems[0]),
            "lessons/two.toml:34:10: 13 positions of shapes with 10003 vertices in all; expected a "
            "product of at most 20000");
}

TEST(Load, HalfHasNoLargeCoordinates) {
  std::string text = replaced(testing::kFullLesson, "\"float\"", "\"half\"");
  text = replaced(text, "[6, 0]", "[-65504, 65505]");
  const LoadedLesson loaded = parse(text);
  ASSERT_EQ(loaded.problems.size(), 1u) << all_of(loaded.problems);
  EXPECT_EQ(to_string(loaded.problems[0]),
            "lessons/two.toml:16:30: entry 2 of entry 2 of 'vertices' is 65505; expected number of "
            "at most 65504 in size, or text like \"0x1.8p-3\"");
}

TEST(Load, AllProblemsOfAFileAtOnceInOrderOfPlace) {
  std::string text = replaced(testing::kFullLesson, "chapter = 4", "chaptr = 4");
  text = replaced(text, "{distance}", "{distanec}");
  text = replaced(text, "\"C\"]", "\"A\"]");
  text = replaced(text, "cap = 20", "cap = 0");
  text = replaced(text, "frames = 13", "frames = 1");
  text = replaced(text, "\"history\"", "\"hystory\"");
  text = replaced(text, "\"gjk\"", "\"gjk-points\"");
  text = replaced(text, "distance = 2.5", "distance = nan");
  const LoadedLesson loaded = parse(text);
  EXPECT_FALSE(loaded.lesson);
  std::string places;
  for (const Problem& p : loaded.problems) {
    places += std::to_string(p.line) + ":" + std::to_string(p.column) + " " + p.nearest + "\n";
  }
  EXPECT_EQ(places,
            "1:1 \n"  // missing key 'chapter'
            "2:1 chapter\n"
            "5:9 distance\n"
            "9:20 \n"
            "26:7 \n"
            "35:10 \n"
            "41:31 history\n"
            "49:11 gjk-point\n"
            "54:12 \n")
      << all_of(loaded.problems);
}

TEST(Load, AFloodOfProblemsIsCut) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += fmt::format("k{} = 1\n", i);
  const LoadedLesson loaded = parse(text);
  ASSERT_EQ(loaded.problems.size(), 101u);
  EXPECT_EQ(loaded.problems.back().what, "and 4907 more problems from here on");
  EXPECT_EQ(loaded.problems.back().line, 94);
}

// --- files that are no lessons at all -----------------------------------------------------------

TEST(Load, AnEmptyFileMissesEveryRequiredKey) {
  const LoadedLesson loaded = parse("");
  EXPECT_FALSE(loaded.lesson);
  std::size_t required = 0;
  for (const LessonKey& key : vocabulary().keys) {
    required += key.table.empty() && key.otherwise == kRequired;
  }
  EXPECT_EQ(loaded.problems.size(), required);
}

TEST(Load, GarbageIsNotToml) {
  const std::string cases[] = {std::string("\x7f"
                                           "ELF\x02\x01\x00\x00",
                                           8),
                               std::string(1000, '\0') + "x",
                               "\xff\xfe[",
                               "\xEF\xBB\xBF\xEF\xBB\xBF",
                               std::string(5000, '"'),
                               std::string(5000, '\''),
                               std::string(5000, '\\'),
                               "title = \"",
                               "[",
                               "[[",
                               "[[views]",
                               "= 1",
                               "a = \"\\q\"",
                               "a = [1,",
                               "{",
                               "\x01"};
  for (const std::string& text : cases) {
    const LoadedLesson loaded = parse(text);
    EXPECT_FALSE(loaded.lesson);
    ASSERT_FALSE(loaded.problems.empty());
    EXPECT_GE(loaded.problems[0].line, 1);
    EXPECT_GE(loaded.problems[0].column, 1);
  }
}

TEST(Load, DeepNestingIsRefusedNotFollowed) {
  const std::string dots = times("a.", 200000);
  const std::string cases[] = {"a = " + std::string(500000, '['),
                               "a = " + times("{a=", 150000),
                               dots + "a = 1",
                               "[" + dots + "a]",
                               "[[" + dots + "a]]",
                               "b = { " + dots + "a = 1 }",
                               "b = [ '''''''', { " + dots + "a = 1 }]",
                               "b = { c = \"\"\"x\"\"\"\"\", " + dots + "a = 1 }",
                               "b = { c = \"\\\"\", " + dots + "a = 1 }",
                               times("\"\".", 200000) + "a = 1",
                               times("a . ", 200000) + "a = 1"};
  for (const std::string& text : cases) {
    const LoadedLesson loaded = parse(text);
    EXPECT_FALSE(loaded.lesson);
    ASSERT_EQ(loaded.problems.size(), 1u) << text.substr(0, 30);
    EXPECT_EQ(loaded.problems[0].line, 1);
    EXPECT_LT(loaded.problems[0].column, 1000);
  }
}

TEST(Load, DotsInTextsNumbersAndCommentsAreNotDeep) {
  std::string text =
      replaced(testing::kFullLesson, "The distance", "a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r.s");
  text = replaced(text, "[query]", "[query] # " + times("a.", 100));
  text = replaced(text, "\"Own example\"", "'''" + times("a.", 40) + "'''");
  EXPECT_TRUE(parse(text).lesson) << all_of(parse(text).problems);
}

TEST(Load, LongLinesAreReadUpToTheLimitOfAFile) {
  const LoadedLesson within = parse("title = \"" + std::string(1000000, 'x') + "\"");
  EXPECT_FALSE(within.lesson);
  EXPECT_NE(all_of(within.problems).find("1:9: 'title' has 1000000 characters"), std::string::npos);
  const LoadedLesson key = parse(std::string(1000000, 'x') + " = 1");
  EXPECT_LT(all_of(key.problems).size(), 5000u);  // messages quote no more than they must
  const LoadedLesson beyond = parse("title = \"" + std::string(5000000, 'x') + "\"");
  ASSERT_EQ(beyond.problems.size(), 1u);
  EXPECT_EQ(to_string(beyond.problems[0]),
            "lessons/two.toml:1:1: the file is too large; expected at most 2097152 bytes");
}

// --- files and folders --------------------------------------------------------------------------

class LessonFolder : public ::testing::Test {
 protected:
  test::TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

TEST_F(LessonFolder, FilesAreLoadedUnderTheirName) {
  const std::filesystem::path file = temporary_.file("my-lesson.toml", testing::kFullLesson);
  const LoadedLesson loaded = load_lesson(file, vocabulary());
  ASSERT_TRUE(loaded.lesson) << all_of(loaded.problems);
  EXPECT_EQ(loaded.lesson->id, "my-lesson");
  EXPECT_EQ(loaded.lesson->path, file.string());
}

TEST_F(LessonFolder, WhatIsNoFileIsAProblem) {
  for (const auto& path : {folder_ / "none.toml", folder_, std::filesystem::path("/dev/zero"),
                           std::filesystem::path("")}) {
    const LoadedLesson loaded = load_lesson(path, {});
    EXPECT_FALSE(loaded.lesson);
    ASSERT_EQ(loaded.problems.size(), 1u);
    EXPECT_EQ(loaded.problems[0].file, path.string());
    EXPECT_EQ(loaded.problems[0].line, 1);
  }
}

TEST_F(LessonFolder, LessonsComeInTeachingOrderBrokenOnesLast) {
  const auto numbered = [](const std::string& chapter, const std::string& order) {
    return replaced(replaced(testing::kFullLesson, "chapter = 4", "chapter = " + chapter),
                    "order = 3", "order = " + order);
  };
  temporary_.file("a.toml", numbered("2", "1"));
  temporary_.file("b.toml", numbered("1", "2"));
  temporary_.file("c.toml", numbered("1", "1"));
  temporary_.file("d.toml", "broken");
  temporary_.file("e.toml", numbered("1", "1"));
  temporary_.file("README.md", "no lesson");
  std::string ids;
  const std::vector<LoadedLesson> lessons = load_lessons(folder_, vocabulary());
  for (const LoadedLesson& loaded : lessons) ids += loaded.lesson ? loaded.lesson->id : "-";
  EXPECT_EQ(ids, "ceba-");
  ASSERT_FALSE(lessons.back().problems.empty());
  EXPECT_EQ(lessons.back().problems[0].file, (folder_ / "d.toml").string());
}

TEST_F(LessonFolder, AFolderThatIsNotThereIsAProblem) {
  const std::vector<LoadedLesson> lessons = load_lessons(folder_ / "none", {});
  ASSERT_EQ(lessons.size(), 1u);
  EXPECT_FALSE(lessons[0].lesson);
  EXPECT_EQ(lessons[0].problems.size(), 1u);
}

TEST_F(LessonFolder, PlacesOfKeys) {
  const std::filesystem::path file = temporary_.file("a.toml", testing::kFullLesson);
  const struct {
    const char* key;
    Place place;
  } cases[] = {{"title", {1, 1}},
               {"prose", {5, 1}},
               {"shapes", {7, 2}},
               {"shapes.Y", {13, 9}},
               {"shapes.Y.rotate", {18, 1}},
               {"shapes.X.names.2", {9, 20}},
               {"views.1", {44, 1}},
               {"views.0.camera.height", {40, 29}},
               {"views.0.effects.1", {41, 31}},
               {"expect.distance", {54, 1}},
               {"expect.nothing", {51, 2}},  // the nearest parent that is there
               {"shapes.X.names.3", {9, 1}},
               {"nothing.at.all", {1, 1}},
               {"", {1, 1}}};
  for (const auto& [key, place] : cases) {
    const Place found = place_of_key(file, key);
    EXPECT_EQ((std::pair{found.line, found.column}), (std::pair{place.line, place.column})) << key;
  }
  EXPECT_EQ(place_of_key(folder_ / "none.toml", "title"), Place{});
}

TEST_F(LessonFolder, EveryTextOfALessonHasItsPlace) {
  const std::filesystem::path file = temporary_.file("a.toml", testing::kFullLesson);
  const LoadedLesson loaded = load_lesson(file, vocabulary());
  ASSERT_TRUE(loaded.lesson);
  std::string listed;
  for (const LessonText& text : texts_of(*loaded.lesson)) {
    const Place place = place_of_key(file, text.key);
    listed +=
        text.text + "@" + std::to_string(place.line) + ":" + std::to_string(place.column) + " ";
  }
  EXPECT_EQ(listed,
            "Two triangles@1:1 Own example@4:1 The distance is {distance}; {{braces}} stay.@5:1 "
            "Left@8:1 A@9:10 B@9:15 C@9:20 Right@14:1 K@15:10 L@15:15 M@15:20 "
            "World: X and Y@39:1 ");
}

}  // namespace load_test
}  // namespace gjkscope
