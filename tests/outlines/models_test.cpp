// Outlines, closest segments, hierarchies.

#include <gtest/gtest.h>

#include "outlines/brute.hpp"
#include "outlines/lin_canny.hpp"
#include "outlines/pieces.hpp"
#include "outlines/sphere_tree.hpp"
#include "scenes.hpp"
#include "truth.hpp"

namespace models_test {

using namespace models;

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
      expect_same(answer, search<Box>(a, b, options).answer, what + " boxes");
      expect_same(answer, search<Circle>(a, b, options).answer, what + " circles");
      options.goal = Goal::collide;
      EXPECT_EQ(answer.overlap, search<Box>(a, b, options).answer.overlap) << what;
    }
  }
  EXPECT_LE(500, overlaps);
  EXPECT_LE(500, apart);
}

TEST(Models, ARememberedPairSavesVisits) {
  test::Scenes scenes(1);
  long cold_visits = 0;
  long warm_visits = 0;
  for (int i = 0; i < 20; ++i) {
    const Model a = model_of({scenes.comb(200)});
    std::vector<Outline> moved = {scenes.comb(200)};
    for (Point& p : moved[0].points) p += Point(0.3, 0.1 * (i + 1));
    const Model b = model_of(moved);
    const SearchResult cold = search<Box>(a, b);
    SearchOptions options;
    options.remembered = cold.segments;
    const SearchResult warm = search<Box>(a, b, options);
    expect_same(cold.answer, warm.answer, "warm");
    EXPECT_LE(warm.visits, cold.visits);
    cold_visits += cold.visits;
    warm_visits += warm.visits;
  }
  EXPECT_LT(warm_visits, cold_visits);
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
  EXPECT_EQ(Fault::several_outlines, check({bow, bow}, Needs::convex).fault);
  EXPECT_EQ(Fault::not_convex, check({bow}, Needs::convex).fault);
  const Outline pentagram{{{0, 10}, {-6, -8}, {10, 3}, {-10, 3}, {6, -8}}};
  EXPECT_EQ(Fault::not_convex, check({pentagram}, Needs::convex).fault);
}

TEST(SphereTree, AnswersWithinTheErrorThatIsAllowed) {
  test::Scenes scenes(7);
  long hits = 0;
  for (int i = 0; i < 600; ++i) {
    const std::string_view family = test::kSceneFamilies[i % test::kSceneFamilies.size()];
    const test::Scene scene = scenes.scene(family, 30);
    const Model a = model_of(scene.a);
    const Model b = model_of(scene.b);
    const Answer truth = brute(a, b).answer;
    const double radius = scenes.real(0.02, 2.0);
    const auto tree_a = sphere_tree(a, radius);
    const auto tree_b = sphere_tree(b, radius);
    const std::string what = std::string(family) + " " + std::to_string(i);
    const SearchResult exact = search<Circle>({a, b, tree_a, tree_b}, {.table = true});
    expect_same(truth, exact.answer, what);
    hits += exact.hits;
    const double e = scenes.real(0.0, 1.0);
    const SearchResult rough =
        search<Circle>({a, b, tree_a, tree_b}, {.relative_error = e, .table = true});
    EXPECT_EQ(truth.overlap, rough.answer.overlap) << what;
    EXPECT_LE(rough.answer.distance, (1.0 + e) * truth.distance * (1.0 + 0x1p-50)) << what;
  }
  EXPECT_LE(1000, hits);
}

TEST(LinCanny, FallsToTheClosestFeaturesFromAnyPair) {
  test::Scenes scenes(11);
  int overlaps = 0;
  int closest = 0;
  for (int i = 0; i < 3000; ++i) {
    const test::Scene scene = scenes.scene(i % 4 == 0 ? "needles" : "convex", 40);
    if (check(scene.a, Needs::convex).fault != Fault::none) continue;
    if (check(scene.b, Needs::convex).fault != Fault::none) continue;
    const Model a = model_of(scene.a);
    const Model b = model_of(scene.b);
    const WalkQuery query = walk_query(a, b);
    const RingFeature from_a{scenes.chance(0.5), scenes.among(0, query.a.size() - 1)};
    const RingFeature from_b{scenes.chance(0.5), scenes.among(0, query.b.size() - 1)};
    const Answer truth = brute(a, b).answer;
    const WalkResult walked = lin_canny(query, from_a, from_b);
    ASSERT_EQ(truth.overlap ? WalkStop::overlap : WalkStop::closest, walked.stop) << i;
    EXPECT_EQ(truth.distance, walked.answer.distance) << i;
    (truth.overlap ? overlaps : closest) += 1;
    std::optional<Nearest> last;
    for (const WalkStep& step : trace_walk(query, from_a, from_b).steps) {
      if (step.phase != WalkPhase::closest) continue;
      if (last) {
        EXPECT_TRUE(compare_distances(step.after.pair, *last) < 0) << i;
      }
      last = step.after.pair;
    }
  }
  EXPECT_LE(500, overlaps);
  EXPECT_LE(500, closest);
}

TEST(LinCanny, LeavesTheBackOfAVertexAtWhichTheOutlineGoesStraightOn) {
  const Model a =
      model_of({{{{-6, 14}, {-14, -1}, {-13, -9}, {-1, -8}, {11, -7}, {11, 5}, {-1, 15}}}});
  std::vector<Outline> moved = a.outlines;
  for (Point& p : moved[0].points) p += Point(3, -46);
  const Model b = model_of(moved);
  const WalkQuery query = walk_query(a, b);
  const double distance = brute(a, b).answer.distance;
  for (int i = 0; i < query.a.size(); ++i) {
    for (int j = 0; j < query.b.size(); ++j) {
      for (const bool vertex : {false, true}) {
        const WalkResult walked = lin_canny(query, {false, i}, {vertex, j});
        EXPECT_EQ(WalkStop::closest, walked.stop) << i << " " << j;
        EXPECT_EQ(distance, walked.answer.distance) << i << " " << j;
      }
    }
  }
}

TEST(LinCanny, StopsAtALocalMinimumOfAnOutlineThatIsNotConvex) {
  const Outline u{{{0, 0}, {6, 0}, {6, 6}, {5, 6}, {5, 1}, {1, 1}, {1, 6}, {0, 6}}};
  const Outline small{{{2.5, 3}, {3, 2.8}, {3, 3.2}}};
  const WalkQuery query = walk_query(model_of({u}), model_of({small}));
  EXPECT_FALSE(query.convex);
  int minima = 0;
  int found = 0;
  for (int i = 0; i < 8; ++i) {
    const WalkResult walked = lin_canny(query, {true, i}, {});
    minima += walked.stop == WalkStop::local_minimum;
    found += walked.stop == WalkStop::closest;
  }
  EXPECT_LT(0, minima);
  EXPECT_LT(0, found);
  EXPECT_EQ(WalkStop::refused, lin_canny(query.model_a, query.model_b).stop);
}

/// Twice the area within corners, exactly.
mpq_class double_area(const std::vector<Point>& points) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum +=
        test::cross(test::ExactPoint(points[i]), test::ExactPoint(points[(i + 1) % points.size()]));
  }
  return sum;
}

TEST(Pieces, AreConvexFillTheMatterAndAnswerAsBruteForceDoes) {
  test::Scenes scenes(5);
  int used = 0;
  int overlaps = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string_view family = test::kSceneFamilies[i % test::kSceneFamilies.size()];
    const test::Scene scene = scenes.scene(family, 40);
    if (check(scene.a, Needs::simple).fault != Fault::none) continue;
    if (check(scene.b, Needs::simple).fault != Fault::none) continue;
    ++used;
    const std::string what = std::string(family) + " " + std::to_string(i);
    const Model a = model_of(scene.a);
    const Model b = model_of(scene.b);
    const Pieces pieces_a = pieces_of(a);
    const Pieces pieces_b = pieces_of(b);
    mpq_class whole = 0;
    for (const Outline& outline : a.outlines) whole += double_area(outline.points);
    mpq_class sum = 0;
    for (const std::vector<int>& piece : pieces_a.pieces) {
      Outline outline;
      for (const int corner : piece) outline.points.push_back(pieces_a.points[corner]);
      EXPECT_TRUE(is_convex(outline)) << what;
      sum += double_area(outline.points);
    }
    EXPECT_EQ(abs(whole), sum) << what;
    const Answer truth = brute(a, b).answer;
    const Answer answer = pieces_distance(a, b, pieces_a, pieces_b).answer;
    EXPECT_EQ(truth.overlap, answer.overlap) << what;
    EXPECT_EQ(truth.distance, answer.distance) << what;
    overlaps += truth.overlap;
  }
  EXPECT_LE(800, used);
  EXPECT_LE(200, overlaps);
}

/// Corners at which the outline turns right.
int reflex_corners(const Outline& outline) {
  const Ring ring = ring_of(outline);
  const auto at = [&](int i) { return ring.points[static_cast<std::size_t>(i)]; };
  int out = 0;
  for (int i = 0; i < ring.size(); ++i)
    out += turn(at(ring.previous(i)), at(i), at(ring.next(i))) < 0;
  return out;
}

/// Puts a round cap on an outline, counter-clockwise: corners of a half ellipse that ends a little
/// inside of both ends, and whose top is at `up` from the middle between them.
void add_cap(Outline& outline, const Point& from, const Point& to, const Point& up) {
  constexpr int kCorners = 10;
  for (int i = 1; i < kCorners; ++i) {
    const double angle = std::numbers::pi * i / kCorners;
    const Point across = 0.5 * std::cos(angle) * (from - to);
    outline.points.push_back(0.5 * (from + to) + across + std::sin(angle) * up);
  }
}

/// Pieces of an outline whose optimum is known: k.
int pieces_within_four_times(const Outline& outline, int k) {
  const auto count = static_cast<int>(pieces_of(model_of({outline})).pieces.size());
  EXPECT_EQ(Fault::none, check({outline}, Needs::simple).fault) << k;
  EXPECT_LE(k, count);
  EXPECT_LE(count, 4 * k);
  // Without merging there would be more: so many triangles make up the outline.
  EXPECT_GT(static_cast<int>(outline.points.size()) - 2, 4 * k);
  return count;
}

TEST(Pieces, OfAConvexOutlineIsOne) {
  test::Scenes scenes(21);
  for (int n = 7; n < 60; ++n) EXPECT_EQ(1, pieces_within_four_times(scenes.star(n, 1.0), 1)) << n;
}

// Caps on the steps of a staircase with k steps. Optimum k: no two caps see each other's top, and a
// cut to the lower left from each of the k - 1 corners between them is enough.
TEST(Pieces, OfAStaircaseAreAtMostFourTimesTheOptimum) {
  for (int k = 1; k < 25; ++k) {
    Outline stairs{{{0, 0}, {k, 0}}};
    for (int i = 0; i < k; ++i) {
      add_cap(stairs, Point(k - i, i), Point(k - i - 1, i + 1), Point(0.9, 0.9));
      stairs.points.emplace_back(k - i - 1, i + 1);
    }
    pieces_within_four_times(stairs, k);
  }
}

// Round teeth on a bar. Optimum k, the number of teeth: no two see each other's top, and a cut down
// from each of the k - 1 corners between them is enough.
TEST(Pieces, OfACombAreAtMostFourTimesTheOptimum) {
  for (int k = 1; k < 25; ++k) {
    Outline comb{{{0, -1}, {k, -1}}};
    for (int i = k; i > 0; --i) {
      comb.points.emplace_back(i, 0);
      add_cap(comb, Point(i, 0), Point(i - 1, 0), Point(0, 3));
    }
    comb.points.emplace_back(0, 0);
    pieces_within_four_times(comb, k);
  }
}

// Beads on a string. Optimum k, the number of beads, with 2 (k - 1) reflex corners: no two beads
// see each other's top, and a cut across each neck, which ends at two reflex corners, is enough.
TEST(Pieces, OfBeadsAreAtMostFourTimesTheOptimum) {
  for (int k = 1; k < 25; ++k) {
    Outline beads;
    for (int i = 0; i < k; ++i) {
      beads.points.emplace_back(i, -0.2);
      add_cap(beads, Point(i, -0.2), Point(i + 1, -0.2), Point(0, -1));
    }
    beads.points.emplace_back(k, -0.2);
    for (int i = k; i > 0; --i) {
      beads.points.emplace_back(i, 0.2);
      add_cap(beads, Point(i, 0.2), Point(i - 1, 0.2), Point(0, 1));
    }
    beads.points.emplace_back(0, 0.2);
    EXPECT_EQ(2 * (k - 1), reflex_corners(beads));
    pieces_within_four_times(beads, k);
  }
}

// Hertel and Mehlhorn's proof: a diagonal stays for a reflex corner, and no corner keeps more than
// two, so r reflex corners leave at most 2 r + 1 pieces; a cut ends at no more than two of them, so
// the optimum has at least r / 2 + 1.
TEST(Pieces, AreAtMostTwoForEachReflexCornerAndOneMore) {
  test::Scenes scenes(22);
  int used = 0;
  int merged = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string_view family = test::kSceneFamilies[i % test::kSceneFamilies.size()];
    const std::vector<Outline> outlines = scenes.scene(family, 60).a;
    if (outlines.size() > 1 || check(outlines, Needs::simple).fault != Fault::none) continue;
    ++used;
    const auto count = static_cast<int>(pieces_of(model_of(outlines)).pieces.size());
    EXPECT_LE(count, 2 * reflex_corners(outlines[0]) + 1) << family << " " << i;
    merged += count < static_cast<int>(ring_of(outlines[0]).points.size()) - 2;
  }
  EXPECT_LE(700, used);
  EXPECT_LE(300, merged);
}

TEST(Pieces, AUIsThree) {
  const Outline u{{{0, 0}, {6, 0}, {6, 6}, {5, 6}, {5, 1}, {1, 1}, {1, 6}, {0, 6}}};
  EXPECT_EQ(3u, pieces_of(model_of({u})).pieces.size());
  EXPECT_EQ(3u, fewest_pieces(u).size());
  EXPECT_EQ((std::vector{4, 5}), corners_turning_in(u));
}

// Two of three corners that turn in share a cut, which the ears in their order miss.
TEST(Pieces, TheFewestCanBeFewer) {
  const Outline u{
      {{28, 16}, {18, 16}, {18, -10}, {-26, -10}, {-26, 20}, {-36, -22}, {20, -17}, {28, -18}}};
  EXPECT_EQ(4u, pieces_of(model_of({u})).pieces.size());
  EXPECT_EQ(3u, fewest_pieces(u).size());
  EXPECT_EQ(3u, corners_turning_in(u).size());
}

TEST(Pieces, TheFewestAreConvexAndMakeUpTheWhole) {
  test::Scenes scenes(27);
  int used = 0;
  int fewer = 0;
  for (int i = 0; i < 200; ++i) {
    const Outline outline = scenes.star(5 + i % 9, 0.4);
    if (check({outline}, Needs::simple).fault != Fault::none) continue;
    ++used;
    const auto fewest = fewest_pieces(outline);
    mpq_class sum = 0;
    for (const std::vector<int>& piece : fewest) {
      Outline part;
      for (const int corner : piece)
        part.points.push_back(outline.points[static_cast<std::size_t>(corner)]);
      EXPECT_TRUE(is_convex(part)) << i;
      sum += double_area(part.points);
    }
    EXPECT_EQ(abs(double_area(outline.points)), sum) << i;
    const std::size_t found = pieces_of(model_of({outline})).pieces.size();
    EXPECT_LE(fewest.size(), found) << i;
    EXPECT_LE(found, 4 * fewest.size()) << i;
    EXPECT_GE(fewest.size(), 1 + (corners_turning_in(outline).size() + 1) / 2) << i;
    fewer += fewest.size() < found ? 1 : 0;
  }
  EXPECT_LE(150, used);
  EXPECT_LE(1, fewer);
}

}  // namespace models_test
