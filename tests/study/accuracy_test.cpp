#include "study/accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "gjk/gjk.hpp"
#include "small_study.hpp"
#include "study/counter.hpp"
#include "study/interleave.hpp"
#include "study/truth.hpp"

namespace gjkscope::study {
namespace accuracy_test {

using test::small_plan;
using test::small_study;

double error_of(double value, const Truth<2>& truth) {
  return std::abs(difference(Quad(value), truth));
}

const Row* find(const Study& study, std::string_view family, std::string_view configuration) {
  for (const Row& row : study.rows) {
    if (row.family == family && row.configuration == configuration) return &row;
  }
  return nullptr;
}

bool has_more_digits_than_double(const Row& row) {
  return row.configuration.starts_with("quad") || row.configuration.starts_with("long double");
}

/// But for times, and what follows from them.
void expect_same(const Row& a, const Row& b) {
  EXPECT_EQ(a.family, b.family);
  EXPECT_EQ(a.configuration, b.configuration);
  EXPECT_EQ(a.error_scale, b.error_scale);
  EXPECT_EQ(a.error, b.error);
  EXPECT_EQ(a.error_units, b.error_units);
  EXPECT_EQ(a.witness_scale, b.witness_scale);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.settled, b.settled);
  EXPECT_EQ(a.wrong, b.wrong);
  EXPECT_EQ(a.worst.json, b.worst.json);
}

TEST(Configurations, HaveNamesOfTheirOwnAndTheDefaultFirst) {
  for (const bool quick : {false, true}) {
    std::set<std::string> names;
    std::set<std::string_view> axes;
    for (const Configuration& each : configurations(quick)) {
      EXPECT_TRUE(names.insert(name_of(each)).second) << name_of(each);
      axes.insert(axis_of(each));
    }
    EXPECT_EQ(name_of(configurations(quick).front()), "double");
    EXPECT_EQ(axes.size(), 7u);
  }
  EXPECT_GT(configurations(false).size(), configurations(true).size());
}

TEST(Configurations, AreFoundByTheirNames) {
  for (const auto& all : {configurations(false), configurations_by_size()}) {
    for (const Configuration& each : all) {
      const std::optional<Configuration> found = configuration_named(name_of(each));
      ASSERT_TRUE(found) << name_of(each);
      EXPECT_EQ(name_of(*found), name_of(each));
      EXPECT_EQ(found->options.tolerance, each.options.tolerance);
      EXPECT_EQ(found->start, each.start);
    }
  }
  EXPECT_FALSE(configuration_named("single"));
}

TEST(Study, AsksAboutTheFamiliesThatThePlanNames) {
  Plan plan = test::small_plan();
  plan.families = {"touching", "needles"};
  const std::vector<Family> families = families_of(plan);
  ASSERT_EQ(families.size(), 2u);
  EXPECT_EQ(families[0].name, "needles");
  EXPECT_EQ(families[1].name, "touching");
  plan.families = {"needle"};
  try {
    static_cast<void>(families_of(plan));
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no family 'needle'; expected one of: 'random', "),
              std::string::npos)
        << error.what();
  }
}

TEST(Counter, CountsWhatTheThreadDoes) {
  const Counter counter(Counter::Kind::nanoseconds);
  const std::optional<std::uint64_t> before = counter.read();
  if (!before) GTEST_SKIP() << "this system lets no program count";
  const auto work = [](int times) {
    double sum = 0.0;
    for (int i = 0; i < times; ++i) keep(sum += i);
  };
  work(1'000'000);
  const std::uint64_t first = *counter.read() - *before;
  work(20'000'000);
  const std::uint64_t second = *counter.read() - *before - first;
  EXPECT_GT(first, 0u);
  EXPECT_GT(second, first);
}

TEST(Study, WorstCasesAreWhatAnOracleSaysTheyAre) {
  int checked = 0;
  for (const Row& row : small_study().rows) {
    SCOPED_TRACE(row.family + ": " + row.configuration);
    const std::vector<ReadCase> cases = parse_cases(row.worst.json, "row");
    ASSERT_EQ(cases.size(), 1u);
    ASSERT_TRUE(cases[0].value);
    const DoublePair pair{cases[0].value->a, cases[0].value->b, {}, {}};
    const Truth truth = truth_of(pair);
    EXPECT_EQ(row.worst.distance, truth.distance);
    if (row.failed > 0 || has_more_digits_than_double(row)) continue;
    const double error = error_of(row.worst.answer, truth);
    const double share = error > 0.0 ? error / std::max(row.worst.answer, row.worst.distance) : 0.0;
    EXPECT_NEAR(row.error, share, 1e-9 * share);
    ++checked;
  }
  EXPECT_GT(checked, 200);
}

TEST(Study, ErrorsAreTheLargestOfAllPairs) {
  const Plan plan = small_plan();
  const std::vector<Family> families = families_of(plan.seed, plan.sizes, plan.reported);
  for (const Family& family : families) {
    SCOPED_TRACE(family.name);
    double in_double = 0.0;
    double in_float = 0.0;
    int wrong = 0;
    for (const DoublePair& pair : family.pairs) {
      const Truth truth = truth_of(pair);
      const double scale = families::scale_of(pair);
      const auto narrow = families::converted<float>(pair);
      const double wide_answer = gjk::distance(pair.query()).distance;
      const auto float_answer = gjk::distance<float>(narrow.query());
      in_double = std::max(in_double, error_of(wide_answer, truth) / scale);
      in_float =
          std::max(in_float, error_of(static_cast<double>(float_answer.distance), truth) / scale);
      wrong += (float_answer.verdict == gjk::Verdict::separated) != !truth.overlap;
    }
    const Row* row = find(small_study(), family.name, "double");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->pairs, static_cast<int>(family.pairs.size()));
    EXPECT_NEAR(row->error_scale, in_double, 1e-9 * in_double);
    const Row* narrow_row = find(small_study(), family.name, "float");
    ASSERT_NE(narrow_row, nullptr);
    EXPECT_NEAR(narrow_row->error_scale, in_float, 1e-9 * in_float);
    EXPECT_EQ(narrow_row->wrong, wrong);
  }
}

TEST(Study, CertificatesHoldWhereTheyArePromised) {
  for (const Row& row : small_study().rows) {
    EXPECT_EQ(row.broken_bounds, 0) << row.family << ": " << row.configuration;
  }
}

TEST(Study, TheDefaultIsNeverWrong) {
  int families = 0;
  for (const Row& row : small_study().rows) {
    if (row.configuration != "double") continue;
    ++families;
    EXPECT_EQ(row.wrong + row.undecided + row.failed, 0) << row.family;
    EXPECT_EQ(row.ratio.median, 1.0);
    EXPECT_LE(row.error_units, 4.0) << row.family;
  }
  EXPECT_EQ(families, small_study().families_planned);
}

TEST(Study, FindsTheErrorsThatRoundingMakes) {
  int wrong = 0;
  for (const Row& row : small_study().rows) {
    if (row.configuration == "half, loop only") wrong += row.wrong_as_kept;
  }
  EXPECT_GT(wrong, 0);
  EXPECT_GT(find(small_study(), "random", "double, cap 1")->error_scale, 0.01);
  EXPECT_GT(find(small_study(), "nearly parallel", "float")->settled, 0);
  EXPECT_EQ(find(small_study(), "nearly parallel", "float, bounds only")->settled, 0);
  EXPECT_GT(find(small_study(), "in motion", "double, warm start")->repetitions, 0);
  EXPECT_EQ(find(small_study(), "random", "double, warm start"), nullptr);
}

TEST(Study, AllButTheTimesFollowsFromTheSeed) {
  const Study again = study_accuracy(small_plan());
  ASSERT_EQ(again.rows.size(), small_study().rows.size());
  for (std::size_t i = 0; i < again.rows.size(); ++i) {
    expect_same(again.rows[i], small_study().rows[i]);
  }
}

TEST(Study, InterruptedKeepsWhatItHas) {
  int asked = 0;
  const Study part =
      study_accuracy(small_plan(), {[&] { return ++asked < 2000; }, [](double, auto&) {}});
  EXPECT_FALSE(part.complete);
  ASSERT_FALSE(part.rows.empty());
  ASSERT_LT(part.rows.size(), small_study().rows.size());
  for (std::size_t i = 0; i < part.rows.size(); ++i) {
    expect_same(part.rows[i], small_study().rows[i]);
  }
}

TEST(Study, InterruptedAtOnceHasNothingToKeep) {
  const Study none = study_accuracy(small_plan(), {[] { return false; }, [](double, auto&) {}});
  EXPECT_FALSE(none.complete);
  EXPECT_TRUE(none.rows.empty());
}

TEST(Study, TellsHowFarItIs) {
  double last = 0.0;
  std::set<std::string> names;
  Plan plan = small_plan();
  plan.sizes = {2, 2, 4};
  const Study study = study_accuracy(plan, {[] { return true; },
                                            [&](double share, const auto& what) {
                                              EXPECT_GE(share, last);
                                              EXPECT_LE(share, 1.0);
                                              last = share;
                                              names.insert(what);
                                            }});
  EXPECT_GT(last, 0.95);
  EXPECT_GE(static_cast<int>(names.size()), study.families_planned);
}

TEST(Front, IsThatOfEachFamily) {
  std::vector<Row> rows;
  const auto add = [&](const char* family, double ns, double error, int repetitions = 1) {
    Row& row = rows.emplace_back();
    row.family = family;
    row.repetitions = repetitions;
    row.ns.median = ns;
    row.error = error;
  };
  add("a", 10.0, 1e-3);
  add("b", 20.0, 1e-2);
  add("a", 20.0, 1e-2);
  add("a", 5.0, 1e-9, 0);
  add("a", 5.0, std::numeric_limits<double>::infinity());
  mark_front(rows);
  std::vector<bool> front;
  for (const Row& row : rows) front.push_back(row.on_front);
  EXPECT_EQ(front, (std::vector<bool>{true, true, false, false, false}));
}

}  // namespace accuracy_test
}  // namespace gjkscope::study
