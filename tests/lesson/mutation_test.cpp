// Lesson files with one or several slips in them: each must give a lesson that runs to its end and
// can be saved, or problems with places. The seeds are fixed, so that a failure can be repeated.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <random>

#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/save.hpp"
#include "lesson_texts.hpp"
#include "run/run.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace mutation_test {

constexpr int kMutants = 10000;  // of all files together, at least
constexpr unsigned kSeed = 20100311;

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t end) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

struct Span {
  std::size_t begin = 0;
  std::size_t size = 0;
};

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

/// Runs of word characters: keys, names, numbers.
std::vector<Span> words(const std::string& text) {
  std::vector<Span> out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_word(text[i])) continue;
    const std::size_t begin = i;
    while (i < text.size() && is_word(text[i])) ++i;
    out.push_back({begin, i - begin});
  }
  return out;
}

std::vector<Span> numbers(const std::string& text) {
  std::vector<Span> out;
  for (const Span& word : words(text)) {
    const char first = text[word.begin];
    const bool quoted = word.begin > 0 && text[word.begin - 1] == '"';
    if (!quoted && (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '-'))
      out.push_back(word);
  }
  return out;
}

/// Words before an equals sign.
std::vector<Span> keys(const std::string& text) {
  std::vector<Span> out;
  for (const Span& word : words(text)) {
    const std::size_t next = text.find_first_not_of(' ', word.begin + word.size);
    if (next != std::string::npos && text[next] == '=') out.push_back(word);
  }
  return out;
}

std::vector<Span> lines(const std::string& text) {
  std::vector<Span> out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    out.push_back({begin, end - begin});
    begin = end;
  }
  return out;
}

enum class Slip {
  flip_byte,
  delete_bytes,
  insert_bytes,
  swap_words,
  double_line,
  delete_line,
  swap_lines,
  replace_number,
  misspell_key,
  truncate,
  other_name,
};
constexpr int kSlips = 11;

void slip(std::string& text, Slip kind, Random& random) {
  const auto pick = [&](const std::vector<Span>& spans) {
    return spans[below(random, spans.size())];
  };
  const std::size_t at = below(random, text.size());
  switch (kind) {
    case Slip::flip_byte:
      text[at] = static_cast<char>(text[at] ^ (1 << below(random, 8)));
      return;
    case Slip::delete_bytes:
      text.erase(at, 1 + below(random, 4));
      return;
    case Slip::insert_bytes: {
      const std::string pieces[] = {"\"",
                                    "[",
                                    "]",
                                    "{",
                                    "}",
                                    "=",
                                    ".",
                                    "\n",
                                    "#",
                                    "'''",
                                    "\\",
                                    "-",
                                    "0",
                                    " ",
                                    ",",
                                    "\xff",
                                    std::string(1, '\0'),
                                    "é"};
      text.insert(at, pieces[below(random, std::size(pieces))]);
      return;
    }
    case Slip::swap_words: {
      Span a = pick(words(text));
      Span b = pick(words(text));
      if (b.begin < a.begin) std::swap(a, b);
      if (a.begin == b.begin) return;
      const std::string first = text.substr(a.begin, a.size);
      const std::string second = text.substr(b.begin, b.size);
      text.replace(b.begin, b.size, first);
      text.replace(a.begin, a.size, second);
      return;
    }
    case Slip::double_line: {
      const Span line = pick(lines(text));
      text.insert(line.begin, text.substr(line.begin, line.size));
      return;
    }
    case Slip::delete_line: {
      const Span line = pick(lines(text));
      text.erase(line.begin, line.size);
      return;
    }
    case Slip::swap_lines: {
      const Span line = pick(lines(text));
      const std::string moved = text.substr(line.begin, line.size);
      text.erase(line.begin, line.size);
      if (text.empty()) return;
      text.insert(pick(lines(text)).begin, moved);
      return;
    }
    case Slip::replace_number: {
      const std::vector<Span> all = numbers(text);
      if (all.empty()) return;
      const std::string values[] = {
          "1e999", "nan",    "-inf",         "-0",  "-0.0", "\"2\"",
          "1e18",  "1e-300", "65504",        "0",   "1",    "-1",
          "2.5",   "500",    "\"0x1.8p-3\"", "1e5", "0.1",  "9223372036854775807"};
      const Span number = pick(all);
      text.replace(number.begin, number.size, values[below(random, std::size(values))]);
      return;
    }
    case Slip::misspell_key: {
      const std::vector<Span> all = keys(text);
      if (all.empty()) return;
      const Span key = pick(all);
      text[key.begin + below(random, key.size)] = static_cast<char>('a' + below(random, 26));
      return;
    }
    case Slip::truncate:
      text.resize(at);
      return;
    case Slip::other_name: {
      // Names of the same kind, so that the file is a lesson more often than not.
      const std::vector<std::string> kinds[] = {
          names_of<ScalarKind>(),         names_of(vocabulary().tours),
          names_of<gjk::Phase>(),         names_of<ViewKind>(),
          names_of<gjk::DirectionRule>(), names_of<gjk::RegionOrder>(),
          names_of(vocabulary().blocks),  names_of<gjk::StopReason>(),
          names_of(vocabulary().effects)};
      std::vector<std::pair<Span, std::string>> choices;
      for (const Span& word : words(text)) {
        for (const auto& names : kinds) {
          const auto found =
              std::find(names.begin(), names.end(), text.substr(word.begin, word.size));
          if (found != names.end()) choices.emplace_back(word, names[below(random, names.size())]);
        }
      }
      if (choices.empty()) return;
      const auto& [word, name] = choices[below(random, choices.size())];
      text.replace(word.begin, word.size, name);
      return;
    }
  }
}

/// The lesson with models of 350 segments where it has some of 100,000: those take seconds to run.
std::string with_small_models(std::string text) {
  const std::string large = "1000, 3000, 10000, 30000, 100000]";
  const std::size_t place = text.find(large);
  if (place != std::string::npos) text.replace(place, large.size(), "310, 320, 330, 340, 350]");
  return text;
}

std::vector<std::string> originals() {
  std::vector<std::string> texts = {testing::kFullLesson, testing::readme_example()};
  for (const auto& file : testing::shipped_lesson_files())
    texts.push_back(with_small_models(testing::file_text(file)));
  return texts;
}

/// All that frames say of a run must be there to be drawn.
void expect_sound(const LessonRun& run) {
  ASSERT_FALSE(run.runs.empty());
  for (const PositionedRun& positioned : run.runs) {
    ASSERT_EQ(positioned.trace.is_empty(), run.tour->algorithm->takes_outlines);
  }
  for (const Frame& frame : run.frames) {
    ASSERT_GE(frame.run, 0);
    ASSERT_LT(frame.run, static_cast<int>(run.runs.size()));
    ASSERT_LE(frame.step, run.algorithm_trace(frame).steps());
    ASSERT_LT(run.gjk_step(frame), static_cast<int>(run.run(frame).trace.steps.size()));
  }
}

/// The outcome of mutants.
struct Tally {
  int lessons = 0;
  int not_toml = 0;
  int refused = 0;
  [[nodiscard]] int all() const { return lessons + not_toml + refused; }
};

/// Adds one mutant to the tally; fails where it breaks the promise.
void meet(const std::string& text, Tally& tally) {
  const LoadedLesson loaded = parse_lesson(text, "mutant.toml", vocabulary());
  ASSERT_NE(loaded.lesson.has_value(), !loaded.problems.empty());
  const auto line_count = std::count(text.begin(), text.end(), '\n') + 1;
  for (const Problem& problem : loaded.problems) {
    ASSERT_EQ(problem.file, "mutant.toml");
    ASSERT_GE(problem.line, 1);
    ASSERT_LE(problem.line, line_count);
    ASSERT_GE(problem.column, 1);
    ASSERT_FALSE(problem.what.empty());
  }
  if (loaded.lesson) {
    ++tally.lessons;
    const LessonRun run = run_lesson(*loaded.lesson);
    expect_sound(run);
    (void)check_expectation(run);
    const LoadedLesson saved =
        parse_lesson(lesson_toml(*loaded.lesson), "mutant.toml", vocabulary());
    ASSERT_TRUE(saved.lesson) << to_string(saved.problems[0]);
    ASSERT_EQ(*saved.lesson, *loaded.lesson);
  } else if (loaded.problems[0].what.starts_with("not TOML")) {
    ++tally.not_toml;
  } else {
    ++tally.refused;
  }
}

TEST(Mutants, EachIsALessonThatEndsOrHasProblemsWithPlaces) {
  const std::vector<std::string> texts = originals();
  const int file_count = static_cast<int>(texts.size());
  const int of_each = (kMutants + file_count - 1) / file_count;
  Tally tally;
  int unchanged = 0;
  std::vector<int> beyond_syntax(kSlips);
  for (int t = 0; t < file_count; ++t) {
    for (int m = 0; m < of_each; ++m) {
      Random random(kSeed + static_cast<unsigned>(t * of_each + m));
      std::string text = texts[t];
      const int first = m % kSlips;
      slip(text, static_cast<Slip>(first), random);
      while (below(random, 4) == 0 && !text.empty())
        slip(text, static_cast<Slip>(below(random, kSlips)), random);
      unchanged += text == texts[t];
      SCOPED_TRACE(fmt::format("file {}, mutant {}:\n{}", t, m, text));

      const int not_toml = tally.not_toml;
      meet(text, tally);
      if (HasFatalFailure()) return;
      if (not_toml == tally.not_toml) ++beyond_syntax[first];
    }
  }
  fmt::print("{} mutants of {} files: {} lessons, {} not TOML, {} refused\n", tally.all(),
             file_count, tally.lessons, tally.not_toml, tally.refused);
  EXPECT_GE(tally.all(), kMutants);
  // Every outcome is met often, and every kind of slip gets past the syntax.
  EXPECT_GE(tally.lessons, tally.all() / 10);
  EXPECT_GE(tally.not_toml, tally.all() / 10);
  EXPECT_GE(tally.refused, tally.all() / 10);
  EXPECT_LE(unchanged, tally.all() / 20);
  for (int s = 0; s < kSlips; ++s) EXPECT_GE(beyond_syntax[s], 10) << "slip " << s;
}

/// The full lesson with other shapes, in another scalar.
std::string lesson_of_size(const std::string& scalar, const std::string& x, const std::string& y) {
  std::string text = testing::kFullLesson;
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("\"float\"", "\"" + scalar + "\"");
  replace("[[0.0, 1.0], [1, 1], [1, \"0x1.8p-3\"]]", x);
  replace("[[4, 0], [6, 0], [5, 2]]", y);
  replace("translate = [0.5, 0.0]", "translate = [0, 0]");
  replace("points = [[0, 0], [1, 1]]", "points = [[0, 0], [0, 0]]");
  replace("until = \"stop\"\n", "");
  return text;
}

/// In half precision the distance of these is infinite, and those are too small for any unit.
const std::string kFar = lesson_of_size("half", "[[-60000, 0], [-60000, 1], [-60000, 2]]",
                                        "[[60000, 0], [60000, 1], [60000, 2]]");
const std::string kTiny = lesson_of_size("half", "[[0, 0], [1e-7, 0], [0, 1e-7]]",
                                         "[[5e-7, 0], [5e-7, 1e-7], [6e-7, 0]]");

TEST(RefusedShapes, HaveSoundFramesAndAProblem) {
  for (const auto& [shapes, error] :
       {std::pair(kFar, gjk::Error::overflow), std::pair(kTiny, gjk::Error::underflow)}) {
    for (const std::string& tour : names_of(vocabulary().tours)) {
      SCOPED_TRACE(tour);
      std::string text = shapes;
      text.replace(text.find("\"iteration\""), 11, fmt::format("\"{}\"", tour));
      const LoadedLesson loaded = parse_lesson(text, "large.toml", vocabulary());
      if (!is_shown_of(vocabulary().tour(tour)->needs.shown_of, 2) || tour == "time" ||
          tour == "maps" || tour == "orders" || tour == "growth" || tour == "issues" ||
          tour == "study" || tour == "downhill" || tour == "course-map" || tour == "two-runs" ||
          tour == "dimensions") {
        EXPECT_FALSE(loaded.lesson) << "needs a point query, no path, or space";
        continue;
      }
      const Algorithm* algorithm = vocabulary().tour(tour)->algorithm;
      if (algorithm->takes_outlines) {
        EXPECT_FALSE(loaded.lesson) << "expects what only a run of GJK can come to";
        continue;
      }
      ASSERT_TRUE(loaded.lesson);
      const LessonRun run = run_lesson(*loaded.lesson);
      EXPECT_EQ(run.runs.back().trace.result.error, error);
      EXPECT_EQ(check_expectation(run).size(), 1u);
      expect_sound(run);
    }
  }
}

TEST(VerticesBeyondTheScalar, AreAProblem) {
  std::string text = lesson_of_size("half", "[[0, 100], [100, 100], [100, 18]]",
                                    "[[95, 0], [600, 3], [500, 200]]");
  const std::string corner = "[0, 0]]\nframes";
  text.replace(text.find(corner), corner.size(), "[0, 65504]]\nframes");
  const LoadedLesson loaded = parse_lesson(text, "high.toml", vocabulary());
  ASSERT_TRUE(loaded.lesson);
  const LessonRun run = run_lesson(*loaded.lesson);
  EXPECT_FALSE(why_not_drawn(run.runs.back()).empty());
  EXPECT_EQ(check_expectation(run).size(), 1u);
}

TEST(ShapesOfAnotherUnit, AreAnsweredAndNotDrawn) {
  const LoadedLesson loaded =
      parse_lesson(lesson_of_size("double", "[[0, 0], [1e-200, 0], [0, 1e-200]]",
                                  "[[4e-200, 0], [4e-200, 1e-200], [5e-200, 0]]"),
                   "tiny.toml", vocabulary());
  ASSERT_TRUE(loaded.lesson);
  const LessonRun run = run_lesson(*loaded.lesson);
  const PositionedRun& positioned = run.runs.back();
  EXPECT_EQ(positioned.trace.result.error, gjk::Error::none);
  EXPECT_NE(positioned.trace.exponent, 0);
  EXPECT_EQ(check_expectation(run).size(), 1u);
  expect_sound(run);
}

/// Every step's bounds hold the answer, in every scalar and in whatever unit the run computed.
TEST(Bounds, HoldTheExactDistanceAfterEveryStep) {
  const std::string shapes[] = {
      lesson_of_size("exact", "[[0, 1], [1, 1], [1, 0.1875]]", "[[4, 0], [6, 0.25], [5, 2]]"),
      lesson_of_size("exact", "[[0, 100], [100, 100], [100, 18]]",
                     "[[95, 0], [600, 3], [500, 200]]"),
      lesson_of_size("exact", "[[0, 1], [3, 1], [1, 0.125]]", "[[2, 0.75], [6, 0.5], [5, 2]]")};
  for (const std::string& text : shapes) {
    LoadedLesson loaded = parse_lesson(text, "bounds.toml", vocabulary());
    ASSERT_TRUE(loaded.lesson);
    Lesson& lesson = *loaded.lesson;
    lesson.x().rotate_degrees = 0.0;
    lesson.y().rotate_degrees = 0.0;
    lesson.options = {};
    const double exact = run_lesson(lesson).runs[0].trace.result.distance;
    int units = 0;
    for (const ScalarKind scalar :
         {ScalarKind::half, ScalarKind::single, ScalarKind::double_, ScalarKind::exact}) {
      lesson.scalar = scalar;
      const PositionedRun run = run_lesson(lesson).runs[0];
      units += run.exponent != 0 ? 1 : 0;
      ASSERT_EQ(run.bounds.size(), run.trace.steps.size());
      for (std::size_t i = 0; i < run.bounds.size(); ++i) {
        SCOPED_TRACE(fmt::format("{}, step {}", name_of(scalar), i));
        const DistanceBounds& bounds = run.bounds[i];
        EXPECT_LE(bounds.lower, exact);
        EXPECT_GE(bounds.upper, exact);
        const WideState& state = run.trace.steps[i].after;
        EXPECT_NEAR(state.p_sq, state.p.squaredNorm(), 2e-3 * state.p_sq);
        for (int k = 0; k < state.simplex.count; ++k) {
          const gjk::VertexPair pair = state.simplex.vertices[k].pair;
          EXPECT_EQ(state.simplex.vertices[k].w,
                    run.y().world[static_cast<std::size_t>(pair.y)] -
                        run.x().world[static_cast<std::size_t>(pair.x)]);
        }
      }
    }
    EXPECT_EQ(units, text == shapes[1] ? 1 : 0) << "half needs another unit for large shapes";
  }
}

}  // namespace mutation_test
}  // namespace gjkscope
