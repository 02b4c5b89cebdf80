// Checks that docs/accuracy.md says what its numbers say, and that the core answers so today.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "study/report.hpp"
#include "subjects/study/results.hpp"

namespace gjkscope::study {
namespace docs_test {

const std::filesystem::path kSource = GJKSCOPE_SOURCE_DIR;

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

const Study& documented() {
  static const Study study = from_csv(read_file(kSource / "docs" / "accuracy.csv"));
  return study;
}

std::vector<Case> reported_cases() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "tests" / "hard-cases")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Case> out;
  for (const auto& file : files) {
    for (ReadCase& read : parse_cases(read_file(file), file.string())) {
      if (read.value) out.push_back(std::move(*read.value));
    }
  }
  return out;
}

const Row* find(const Study& study, const Row& like) {
  for (const Row& row : study.rows) {
    if (row.family == like.family && row.configuration == like.configuration) return &row;
  }
  return nullptr;
}

constexpr const char* kHint = "run `gjkscope study accuracy --advice docs/accuracy.md` again";

TEST(Docs, AccuracySaysWhatItsNumbersSay) {
  EXPECT_EQ(read_file(kSource / "docs" / "accuracy.md"), advice(documented())) << kHint;
  EXPECT_TRUE(documented().complete);
  EXPECT_FALSE(documented().quick);
}

/// Only configurations that are quick to ask; times are those of the machine.
TEST(Docs, NumbersAreThoseOfTheCore) {
  std::vector<Configuration> some;
  for (const Arithmetic arithmetic : {Arithmetic::double_, Arithmetic::single_in_double}) {
    for (const gjk::Proof proof : {gjk::Proof::exact, gjk::Proof::none})
      some.push_back(configuration(arithmetic, proof));
  }
  some.push_back({});
  some.back().start = Start::warm;
  some.push_back({});
  some.back().options.iteration_cap = 2;

  Study now;
  const Sizes sizes = plan(false).sizes;
  for (const Family& family : families_of(documented().seed, sizes, reported_cases())) {
    if (family.vertices > 0) continue;
    const std::vector<Row> rows = judged_rows(family, some, documented().seed);
    now.rows.insert(now.rows.end(), rows.begin(), rows.end());
  }
  int compared = 0;
  for (const Row& row : summary(now).rows) {
    SCOPED_TRACE(row.family + ": " + row.configuration);
    const Row* then = find(documented(), row);
    ASSERT_NE(then, nullptr) << kHint;
    EXPECT_EQ(then->pairs, row.pairs) << kHint;
    EXPECT_EQ(then->error_scale, row.error_scale) << kHint;
    EXPECT_EQ(then->error, row.error) << kHint;
    EXPECT_EQ(then->error_units, row.error_units) << kHint;
    EXPECT_EQ(then->witness_scale, row.witness_scale) << kHint;
    EXPECT_EQ(then->iterations, row.iterations) << kHint;
    EXPECT_EQ(then->wrong, row.wrong) << kHint;
    EXPECT_EQ(then->undecided, row.undecided) << kHint;
    EXPECT_EQ(then->settled, row.settled) << kHint;
    EXPECT_EQ(then->failed, row.failed) << kHint;
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

TEST(Docs, TheLessonShowsWhatTheCoreAnswers) {
  const std::vector<StudyDot> dots =
      parse_study_results(read_file(kSource / "lessons" / "accuracy-cost.json")).dots;
  std::vector<Configuration> some;
  for (const gjk::Proof proof : {gjk::Proof::exact, gjk::Proof::none}) {
    for (const Arithmetic arithmetic : {Arithmetic::double_, Arithmetic::single})
      some.push_back(configuration(arithmetic, proof));
  }
  Plan asked = plan(false);
  asked.families = families_in(dots);
  int compared = 0;
  for (const Family& family : families_of(asked)) {
    for (const Row& row : judged_rows(family, some, asked.seed)) {
      SCOPED_TRACE(row.family + ": " + row.configuration);
      const auto dot = std::find_if(dots.begin(), dots.end(), [&](const StudyDot& each) {
        return each.family == row.family && each.configuration == row.configuration;
      });
      ASSERT_NE(dot, dots.end());
      EXPECT_EQ(dot->pairs, row.pairs);
      EXPECT_EQ(dot->error, row.error);
      EXPECT_EQ(dot->wrong, row.wrong);
      EXPECT_EQ(dot->undecided, row.undecided);
      EXPECT_EQ(dot->settled, row.settled);
      EXPECT_EQ(dot->answer, row.worst.answer);
      EXPECT_EQ(dot->distance, row.worst.distance);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 8) << "two families";
}

}  // namespace docs_test
}  // namespace gjkscope::study
