// The textbook's loop with one line changed each (tests/mistakes): the judge names the step that is
// to blame. And it calls no run wrong that is right.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "judge/judge.hpp"
#include "mistakes/loops.hpp"
#include "study/families.hpp"

namespace gjkscope::judging {
namespace mistakes_test {

using families::Family;
using mistakes::Polygon;

/// A tenth where the compiler does not optimise.
constexpr int cases(int count) {
#ifdef NDEBUG
  return count;
#else
  return count / 10;
#endif
}

template <int D>
std::vector<gjk::Vec<double, D>> world(const std::vector<gjk::Vec<double, D>>& shape,
                                       const gjk::Pose<double, D>& pose) {
  std::vector<gjk::Vec<double, D>> out;
  for (const auto& vertex : shape) out.push_back(pose.rotated(vertex) + pose.translation);
  return out;
}

Log log_of(const std::string& text) {
  ReadLog read = read_log(text, "log");
  EXPECT_TRUE(read.log) << to_string(read.problems) << '\n' << text;
  return read.log.value_or(Log{});
}
std::string description(const Judgement& judgement) {
  std::string out = "right";
  if (judgement.wrong)
    out = fmt::format("{} of iteration {}: {}", name_of(judgement.wrong->part),
                      judgement.wrong->iteration, judgement.wrong->what);
  return judgement.answer ? out + "\n" + judgement.answer->what : out;
}

struct Blame {
  std::string_view mistake;
  Part part;
  Polygon x;
  Polygon y;
  int iteration;
  std::string_view words;
};

const Polygon kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const Polygon kTriangle = {{3, 0}, {4, 1}, {2, 3}};
Polygon scaled(Polygon polygon, double by) {
  for (auto& p : polygon) p *= by;
  return polygon;
}

/// One pair for each, with the words that name the cause.
const std::vector<Blame> kBlames = {
    {"wrong_sign", Part::direction, kSquare, kTriangle, 2, "does not lead from P"},
    {"nothing_dropped", Part::drop, kSquare, {{2, 2}, {6, 5}, {5, 6}}, 2, "kept without weight"},
    {"region_unchecked",
     Part::drop,
     {{0, 0}},
     {{-4, 5}, {-3, 1}, {4, 1}},
     3,
     "O lies in the region of the edge"},
    {"wrong_drop",
     Part::drop,
     {{0, 0}},
     {{-4, 5}, {-3, 1}, {4, 1}},
     3,
     "was dropped, but has weight"},
    {"exchanged_weights", Part::weights, kSquare, kTriangle, 2, "not the point closest to O"},
    {"no_zero_test", Part::direction, {{0, 0}}, {{1, 1}, {2, 0}, {0, 0}}, 2, "d = 0: O lies on"},
    {"no_progress_test", Part::stop, kSquare, kTriangle, 4, "the run should end here"},
    {"nearest_vertex", Part::support, kSquare, kTriangle, 1, "it is the least far of all"},
    {"absolute_epsilon", Part::stop, scaled(kSquare, 1e-5), scaled(kTriangle, 1e-5), 1,
     "stops too early"},
    {"compared_by_place", Part::stop, kSquare, {{3, 2}, {2, -1}, {4, 0}}, 3, "stops too early"},
    {"direction_not_turned", Part::support, kSquare, kTriangle, 1, "is not the farthest along d"},
    {"sum_for_difference", Part::vertex, kSquare, kTriangle, 2, "it is the sum"},
    {"past_the_origin", Part::stop, kSquare, {{3, 2}, {2, -1}, {4, 0}}, 2, "stops too early"},
    {"reflex_polygon",
     Part::support,
     {{5, 2}},
     {{0, 0}, {2, 0}, {1, 1}, {3, 4}, {0, 4}},
     1,
     "b is not convex, and its hull counts"},
};

TEST(Mistakes, EachIsNamedWithItsStep) {
  EXPECT_EQ(mistakes::kLoops.size(), kBlames.size() + 1);
  for (const Blame& blame : kBlames) {
    const std::string text = mistakes::loop(blame.mistake).log_of(blame.x, blame.y);
    const Judgement judgement = judge(log_of(text));
    SCOPED_TRACE(fmt::format("{}: {}\n{}", blame.mistake, description(judgement), text));
    ASSERT_TRUE(judgement.wrong);
    EXPECT_EQ(blame.part, judgement.wrong->part);
    EXPECT_EQ(blame.iteration, judgement.wrong->iteration);
    EXPECT_NE(std::string::npos, judgement.wrong->what.find(blame.words));
    const Judgement unchanged = judge(log_of(mistakes::loop("none").log_of(blame.x, blame.y)));
    EXPECT_TRUE(unchanged.right()) << description(unchanged);
  }
}

/// Each mistake on random pairs: nothing else is blamed, and no wrong answer passes.
TEST(Mistakes, NothingElseIsBlamedOnRandomPairs) {
  constexpr int kLeast = 20;  // wrong runs of a mistake, so that the claim means something
  for (const Blame& blame : kBlames) {
    families::Source random(20100311);
    int wrong = 0;
    for (int i = 0; i < cases(1100); ++i) {
      const auto family = static_cast<Family>(i % families::kFamilyCount);
      const auto pair = random.pair<double>(family);
      // Products of the smallest numbers are 0 in the textbook's loop.
      if (family == Family::denormals) continue;
      const Polygon x = world(pair.x, pair.x_pose);
      const Polygon y = world(pair.y, pair.y_pose);
      // With O on the simplex the textbook's loop itself goes on for ever.
      if (!judge(log_of(mistakes::loop("none").log_of(x, y))).right()) continue;
      const Judgement judgement = judge(log_of(mistakes::loop(blame.mistake).log_of(x, y)));
      SCOPED_TRACE(fmt::format("{}, pair {}: {}", blame.mistake, i, description(judgement)));
      EXPECT_TRUE(!judgement.answer || judgement.wrong);
      if (!judgement.wrong) continue;
      ++wrong;
      EXPECT_EQ(name_of(blame.part), name_of(judgement.wrong->part));
    }
    EXPECT_GE(wrong, cases(10 * kLeast) / 10) << blame.mistake;
  }
}

class NoFalseAlarm : public testing::TestWithParam<int> {};

/// Right, but for runs that hit their cap: where O lies on the simplex, nothing of the textbook's
/// loop ends it. And but for denormal numbers, whose products are 0: there answers are wrong.
TEST_P(NoFalseAlarm, TheTextbookIsRight) {
  const auto family = static_cast<Family>(GetParam());
  families::Source random(static_cast<std::uint64_t>(GetParam()) + 1);
  double most = 0;
  int right = 0;
  const int count = cases(4600);
  for (int i = 0; i < count; ++i) {
    const auto pair =
        random.pair<double>(family, i % 2 == 0 ? families::Representation::full_doubles
                                               : families::Representation::float_values);
    const std::string text =
        mistakes::loop("none").log_of(world(pair.x, pair.x_pose), world(pair.y, pair.y_pose));
    const Judgement judgement = judge(log_of(text));
    if (judgement.right()) {
      ++right;
      most = std::max(most, judgement.rounding);
      continue;
    }
    SCOPED_TRACE(fmt::format("pair {}: {}\n{}", i, description(judgement), text));
    if (family == Family::denormals && judgement.answer) continue;
    EXPECT_EQ("stop", name_of(judgement.wrong ? judgement.wrong->part : Part::answer));
    EXPECT_EQ(mistakes::kCap, judgement.iterations);
    EXPECT_FALSE(judgement.answer);
  }
  EXPECT_GE(right, count / 3);
  EXPECT_LE(most, kUnits / 4);
  RecordProperty("rounding", fmt::format("{:.3g}", most));
  RecordProperty("right", right);
}
std::string family_name(const testing::TestParamInfo<int>& info) {
  std::string name(families::kFamilyNames[static_cast<std::size_t>(info.param)]);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Family, NoFalseAlarm, testing::Range(0, families::kFamilyCount),
                         family_name);

/// The core's own runs, in the plane and in space, as what a log says.
template <int D>
Log log_of_core(const std::vector<gjk::Vec<double, D>>& x,
                const std::vector<gjk::Vec<double, D>>& y) {
  const auto trace = gjk::trace<double>(gjk::Query<double, D>{{x}, {y}});
  const auto point = [&](const gjk::Vec<double, D>& p, bool in_unit = true) {
    Point out = Point::Zero();
    for (int i = 0; i < D; ++i) out[i] = in_unit ? std::ldexp(p[i], trace.prepared.exponent) : p[i];
    return out;
  };
  const auto pairs = [](const gjk::Simplex<double, D>& simplex) {
    std::vector<gjk::VertexPair> out;
    for (int i = 0; i < simplex.count; ++i)
      out.push_back(simplex.vertices[static_cast<std::size_t>(i)].pair);
    return out;
  };
  Log log;
  log.dimension = D;
  for (const auto& p : x) log.x.push_back(point(p, false));
  for (const auto& p : y) log.y.push_back(point(p, false));
  for (const auto& step : trace.steps) {
    if (step.phase == gjk::Phase::closest) {
      log.iterations.emplace_back();
      log.iterations.back().simplex = pairs(step.after.simplex);
      for (const gjk::VertexPair& pair : log.iterations.back().simplex)
        log.iterations.back().points.emplace_back(log.y[static_cast<std::size_t>(pair.y)] -
                                                  log.x[static_cast<std::size_t>(pair.x)]);
    }
    Iteration& now = log.iterations.back();
    const auto& after = step.after;
    switch (step.phase) {
      case gjk::Phase::drop:
        now.kept = pairs(after.simplex);
        now.weights.assign(after.simplex.weights.begin(),
                           after.simplex.weights.begin() + after.simplex.count);
        now.closest = point(after.p);
        break;
      case gjk::Phase::direction:
        now.direction = point(after.d, false);
        break;
      case gjk::Phase::support:
        now.support = after.support.pair;
        break;
      default:
        break;
    }
  }
  Answer answer;
  answer.distance = trace.result.distance;
  answer.overlap = trace.result.verdict != gjk::Verdict::separated;
  answer.x = point(trace.result.x, false);
  answer.y = point(trace.result.y, false);
  log.answer = answer;
  return log;
}

template <int D>
void expect_core_right(int count, int family_count, double most_units) {
  families::Source random(20100311);
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<Family>(i % family_count);
    const auto pair = random.pair<double, D>(family);
    const Judgement judgement =
        judge(log_of_core<D>(world<D>(pair.x, pair.x_pose), world<D>(pair.y, pair.y_pose)));
    // Weights of denormal numbers may be 0 / 0: exact arithmetic settles the core's answer.
    EXPECT_TRUE(family == Family::denormals ? !judgement.answer : judgement.right())
        << "pair " << i << ", " << families::kFamilyNames[static_cast<std::size_t>(family)] << ": "
        << description(judgement);
    EXPECT_LE(judgement.rounding, most_units) << i;
  }
}
TEST(Core, RunsInThePlaneAreRight) {
  expect_core_right<2>(cases(8800), families::kFamilyCount, kUnits);
}
TEST(Core, RunsInSpaceAreRight) {
  expect_core_right<3>(cases(5200), families::kSpaceFamilyCount, kUnits);
}

}  // namespace mistakes_test
}  // namespace gjkscope::judging
