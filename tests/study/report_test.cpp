#include "study/report.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/decimal.hpp"
#include "small_study.hpp"
#include "subjects/study/results.hpp"

namespace gjkscope::study {
namespace report_test {

using test::small_study;

std::string read_file(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

/// The complaint of from_csv about a text.
std::string complaint(const std::string& text) {
  try {
    static_cast<void>(from_csv(text));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Words, NumbersHaveTheUnitsThatReadBest) {
  EXPECT_EQ(time_text(86.4), "86 ns");
  EXPECT_EQ(time_text(1234.0), "1.23 µs");
  EXPECT_EQ(time_text(3.45e7), "34.5 ms");
  EXPECT_EQ(time_text(2.1e9), "2.1 s");
  EXPECT_EQ(error_text(0.0), "0");
  EXPECT_EQ(error_text(std::numeric_limits<double>::infinity()), "none");
  EXPECT_EQ(error_text(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(Json, IsWhatLessonsRead) {
  const Study& study = small_study();
  const StudyResults results = parse_study_results(to_json(study));
  EXPECT_EQ(results.processor, study.machine.processor);
  const std::vector<StudyDot>& dots = results.dots;
  std::size_t timed = 0;
  for (const Row& row : study.rows) {
    if (row.repetitions == 0) continue;
    ASSERT_LT(timed, dots.size());
    const StudyDot& dot = dots[timed++];
    EXPECT_EQ(dot.family, row.family);
    EXPECT_EQ(dot.configuration, row.configuration);
    EXPECT_EQ(dot.axis, row.axis);
    EXPECT_EQ(dot.proof, row.proof);
    EXPECT_EQ(dot.settled, row.settled);
    EXPECT_EQ(dot.ns, row.ns.median);
    EXPECT_EQ(dot.ratio, row.ratio.median);
    EXPECT_EQ(dot.on_front, row.on_front);
    EXPECT_EQ(dot.distance, row.worst.distance);
    EXPECT_EQ(dot.error.value_or(std::numeric_limits<double>::infinity()), row.error);
  }
  EXPECT_EQ(timed, dots.size());
}

/// Two rows in which doing less costs more, shown in every form.
Study with_costlier() {
  Study study = small_study();
  study.compared = 12;
  study.costlier = {{"random", "double, cap 3", "double", {1.25, 1.5, 1.75}, "a reason, two"},
                    {"needles", "double, cap 3", "double", {1.0625, 1.25, 2.0}, "another"}};
  return study;
}

TEST(Csv, ReadBackIsTheSame) {
  const std::string text = to_csv(with_costlier());
  const Study back = from_csv(text);
  EXPECT_EQ(back.compared, 12);
  ASSERT_EQ(back.costlier.size(), 2u);
  EXPECT_EQ(back.costlier[0].less, "double, cap 3");
  EXPECT_EQ(back.costlier[0].reason, "a reason, two");
  EXPECT_EQ(back.costlier[1].ratio.low, 1.0625);
  ASSERT_EQ(back.rows.size(), small_study().rows.size());
  EXPECT_EQ(to_csv(back), text);
  EXPECT_EQ(back.seed, small_study().seed);
  EXPECT_EQ(back.rows[3].configuration, small_study().rows[3].configuration);
  EXPECT_EQ(back.rows[3].error_scale, small_study().rows[3].error_scale);
}

TEST(Csv, SaysWhichLineIsWrong) {
  Study study = small_study();
  study.costlier.clear();  // by times: how many lines they take is not known
  const std::string text = to_csv(study);
  EXPECT_EQ(complaint(""), "line 0: there are no rows");
  EXPECT_EQ(complaint("# seed: one\n"), "line 1: 'seed' is not known, or has another value");
  EXPECT_EQ(complaint("# sead: 1\n"), "line 1: 'sead' is not known, or has another value");
  EXPECT_NE(complaint("family,error\n").find("line 1: expected the names of the fields"),
            std::string::npos);
  const std::size_t rows = text.find("\n\"") + 1;
  EXPECT_EQ(complaint(text.substr(0, rows) + "\"random\",1\n"), "line 13: 2 fields, expected 31");
  std::string bad = text;
  bad.replace(text.find(",1,12,", rows), 6, ",2,12,");
  EXPECT_NE(complaint(bad).find("'2' is no value of front"), std::string::npos) << complaint(bad);
}

TEST(Json, HoldsEveryRowAndItsWorstCase) {
  const auto json = nlohmann::json::parse(to_json(small_study()));
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["complete"], true);
  EXPECT_FALSE(json["machine"]["compiler"].get<std::string>().empty());
  ASSERT_EQ(json["rows"].size(), small_study().rows.size());
  int without_answer = 0;
  for (std::size_t i = 0; i < json["rows"].size(); ++i) {
    const auto& one = json["rows"][i];
    const Row& row = small_study().rows[i];
    EXPECT_EQ(one["configuration"], row.configuration);
    EXPECT_EQ(one["wrong"], row.wrong);
    if (row.failed == 0) {
      EXPECT_EQ(one["error_scale"], row.error_scale);
    } else {
      EXPECT_TRUE(one["error_scale"].is_null());
      ++without_answer;
    }
    const auto cases = parse_cases(one["worst"]["case"].dump(), "row");
    ASSERT_EQ(cases.size(), 1u);
    EXPECT_TRUE(cases[0].value);
  }
  EXPECT_GT(without_answer, 0) << "half precision cannot hold coordinates of 1e12";
}

TEST(Summary, TakesTheWorstOfAllFamilies) {
  const Study all = summary(small_study());
  const Row& first = all.rows.front();
  EXPECT_EQ(first.family, kAllFamilies);
  EXPECT_EQ(first.configuration, "double");
  int pairs = 0;
  double error = 0.0;
  for (const Row& row : small_study().rows) {
    if (row.configuration != "double" || row.vertices > 0) continue;
    pairs += row.pairs;
    error = std::max(error, row.error_scale);
  }
  EXPECT_EQ(first.pairs, pairs);
  EXPECT_EQ(first.error_scale, error);
  EXPECT_EQ(first.ratio.median, 1.0);
  for (const Row& row : all.rows) {
    if (row.family == kAllFamilies) {
      EXPECT_EQ(row.pairs, pairs) << row.configuration;
    }
  }
}

TEST(Table, MarksTheFrontAndNamesEveryFamily) {
  const std::string text = table(small_study());
  for (const auto& family : by_family(small_study().rows)) {
    EXPECT_NE(text.find("\n" + family.front()->family + " ("), std::string::npos);
  }
  EXPECT_NE(text.find("\nall families ("), std::string::npos);
  EXPECT_NE(text.find("\n* "), std::string::npos);
  EXPECT_EQ(table(Study{}), "Nothing was measured.\n");
}

TEST(Page, HasADotForEveryRowAndNeedsNothingElse) {
  const std::string text =
      page(small_study(), read_file(GJKSCOPE_SOURCE_DIR "/assets/accuracy.html"));
  EXPECT_EQ(count(text, "<section>"), by_family(small_study().rows).size());
  EXPECT_EQ(count(text, "<g class=\"dot "), small_study().rows.size());
  EXPECT_EQ(count(text, "<!-- "), 0u);
  EXPECT_EQ(count(text, "://"), 0u) << "the page must open without a network";
  EXPECT_EQ(count(text, "nan"), 0u);
  EXPECT_NE(text.find("{&quot;name&quot;: &quot;needles, seed 7, pair"), std::string::npos);
}

TEST(Page, SaysThatTheStudyWasInterrupted) {
  Study part = small_study();
  part.complete = false;
  EXPECT_NE(page(part, "<!-- about -->").find("Interrupted"), std::string::npos);
}

TEST(Advice, OffersOnlyWhatIsAccurateEnough) {
  Study study = summary(small_study());
  for (Row& row : study.rows) {
    row.failed = row.configuration == "double" ? 0 : 1;
    if (row.configuration == "double") row.error = 3e-7;
  }
  const std::string text = advice(study);
  EXPECT_NE(text.find("| 1 to 6 | double | 1.00 ×"), std::string::npos) << text;
  EXPECT_NE(text.find("| 7 to "), std::string::npos) << text;
  EXPECT_NE(text.find(" | nothing here |  | double | 1.00 ×"), std::string::npos) << text;
}

TEST(Costlier, IsInTheTableThePageTheAdviceAndTheJson) {
  const Study study = with_costlier();
  EXPECT_NE(table(study).find("  double, cap 3 takes 1.25 to 1.50 times as long as double (random, "
                              "needles): a reason, two\n"),
            std::string::npos)
      << table(study);
  EXPECT_NE(
      advice(summary(study))
          .find("| double, cap 3 | double | 1.25 to 1.50 | random, needles | a reason, two |"),
      std::string::npos);
  EXPECT_NE(page(study, "<!-- costlier -->").find("<li>double, cap 3 takes 1.25 to 1.50 times"),
            std::string::npos);
  const auto json = nlohmann::json::parse(to_json(study));
  EXPECT_EQ(json["compared"], 12);
  ASSERT_EQ(json["costlier"].size(), 2u);
  EXPECT_EQ(json["costlier"][1]["reason"], "another");
  Study none = study;
  none.costlier.clear();
  for (const std::string& text : {table(none), page(none, "<!-- costlier -->")})
    EXPECT_NE(text.find("None does."), std::string::npos) << text;
}

TEST(Advice, ExplainsTheWordsInNames) {
  const std::string text = advice(summary(small_study()));
  for (const Configuration& each : configurations(false)) {
    std::string name = name_of(each);
    for (std::size_t begin = 0; begin < name.size();) {
      const std::size_t end = std::min(name.find(", ", begin), name.size());
      std::string word = name.substr(begin, end - begin);
      for (const char* counted : {"tolerance ", "cap "}) {
        if (word.starts_with(counted)) word = counted;
      }
      EXPECT_NE(text.find("`" + word), std::string::npos) << word;
      begin = end + 2;
    }
  }
}

TEST(Advice, IsMadeFromItsNumbersAlone) {
  const Study study = summary(with_costlier());
  EXPECT_EQ(advice(from_csv(to_csv(study))), advice(study));
}

}  // namespace report_test
}  // namespace gjkscope::study
