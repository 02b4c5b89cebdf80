// Outlines, closest segments, hierarchies.

#include <gtest/gtest.h>

#include "models/brute.hpp"
#include "models/search.hpp"
#include "scenes.hpp"
#include "truth.hpp"

namespace {

using namespace models;

template <class Volume>
SearchResult searched(const Model& a, const Model& b, const SearchOptions& options = {}) {
  const auto tree_a = build_hierarchy<Volume>(items_of(a));
  const auto tree_b = build_hierarchy<Volume>(items_of(b));
  return search<Volume>({a, b, tree_a, tree_b}, options);
}

void expect_same(const Answer& expected, const Answer& actual, const std::string& what) {
  EXPECT_EQ(expected.overlap, actual.overlap) << what;
  EXPECT_EQ(expected.distance, actual.distance) << what;
  if (expected.overlap) return;
  EXPECT_EQ(expected.a, actual.a) << what;
  EXPECT_EQ(expected.b, actual.b) << what;
  EXPECT_EQ(expected.on_a, actual.on_a) << what;
  EXPECT_EQ(expected.on_b, actual.on_b) << what;
}

TEST(Models, BruteForceIsExactAndHierarchiesAnswerTheSame) {
  test::Scenes scenes(2026);
  int overlaps = 0;
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string_view family = test::kSceneFamilies[i % test::kSceneFamilies.size()];
    const test::Scene scene = scenes.scene(family, 60);
    const Model a = model_of(scene.a);
    const Model b = model_of(scene.b);
    const std::string what = std::string(family) + " " + std::to_string(i);
    const test::Truth truth = test::truth_of(a, b);
    const Answer answer = brute(a, b).answer;
    ASSERT_EQ(truth.overlap, answer.overlap) << what;
    const double error = std::abs(answer.distance - std::sqrt(truth.distance_sq.get_d()));
    EXPECT_LE(error, 4 * 0x1p-53 * truth.scale) << what;
    (truth.overlap ? overlaps : apart) += 1;
    for (const bool nearer : {false, true}) {
      SearchOptions options;
      options.nearer_first = nearer;
      expect_same(answer, searched<Box>(a, b, options).answer, what + " boxes");
      expect_same(answer, searched<Circle>(a, b, options).answer, what + " circles");
      options.goal = Goal::collide;
      EXPECT_EQ(answer.overlap, searched<Box>(a, b, options).answer.overlap) << what;
    }
  }
  EXPECT_LE(500, overlaps);
  EXPECT_LE(500, apart);
}

TEST(Models, ARememberedPairSavesVisits) {
  test::Scenes scenes(1);
  const Model a = model_of({scenes.comb(200)});
  std::vector<Outline> moved = {scenes.comb(200)};
  for (Point& p : moved[0].points) p += Point(0.3, 5.0);
  const Model b = model_of(moved);
  const SearchResult cold = searched<Box>(a, b);
  SearchOptions options;
  options.remembered = cold.segments;
  const SearchResult warm = searched<Box>(a, b, options);
  expect_same(cold.answer, warm.answer, "warm");
  EXPECT_LT(warm.visits, cold.visits);
}

TEST(Models, ATraceEndsAsTheSearchDoes) {
  test::Scenes scenes(3);
  const test::Scene scene = scenes.scene("spirals", 24);
  const Model a = model_of(scene.a);
  const Model b = model_of(scene.b);
  const auto tree_a = build_hierarchy<Box>(items_of(a));
  const auto tree_b = build_hierarchy<Box>(items_of(b));
  const SearchQuery<Box> query{a, b, tree_a, tree_b};
  const SearchTrace trace = trace_search(query);
  expect_same(search(query).answer, trace.result.answer, "trace");
  EXPECT_EQ(SearchPhase::visit, trace.steps.front().phase);
  EXPECT_EQ(trace.result.stop, trace.steps.back().after.stop);
}

TEST(Models, AModelInAHoleIsApart) {
  const Outline outer{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  const Outline hole{{{2, 2}, {2, 8}, {8, 8}, {8, 2}}};
  const Outline small{{{4, 4}, {5, 4}, {5, 5}}};
  EXPECT_EQ(2.0, brute(model_of({outer, hole}), model_of({small})).answer.distance);
  EXPECT_TRUE(brute(model_of({outer}), model_of({small})).answer.overlap);
  EXPECT_TRUE(brute(model_of({small}), model_of({outer})).answer.overlap);
}

TEST(Models, FlawsAreNamedAndLocated) {
  const Outline square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  const Outline bow{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}};
  const Outline chain{{{0, 0}, {1, 0}}, false};
  const Outline inner{{{1, 1}, {2, 1}, {4, 2}}};
  EXPECT_EQ(Fault::no_outline, check({}, Needs::segments).fault);
  EXPECT_EQ(Fault::too_few_points, check({square, {{{1, 1}}}}, Needs::segments).fault);
  EXPECT_EQ(1, check({square, {{{1, 1}}}}, Needs::segments).outline);
  EXPECT_EQ(Fault::not_finite, check({{{{0, 0}, {NAN, 1}}}}, Needs::segments).fault);
  EXPECT_EQ(Fault::none, check({bow, chain}, Needs::segments).fault);
  EXPECT_EQ(Fault::open_chain, check({square, chain}, Needs::simple).fault);
  const Flaw crossing = check({bow}, Needs::simple);
  EXPECT_EQ(Fault::not_simple, crossing.fault);
  EXPECT_EQ(0, crossing.index);
  EXPECT_EQ(2, crossing.other_index);
  EXPECT_EQ(Fault::outlines_meet, check({square, inner}, Needs::simple).fault);
  EXPECT_EQ(Fault::none, check({square}, Needs::convex).fault);
  EXPECT_EQ(Fault::not_convex, check({bow}, Needs::convex).fault);
  const Outline pentagram{{{0, 10}, {-6, -8}, {10, 3}, {-10, 3}, {6, -8}}};
  EXPECT_EQ(Fault::not_convex, check({pentagram}, Needs::convex).fault);
}

}  // namespace
