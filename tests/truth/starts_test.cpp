// A run that is given no start begins at the same pair of vertices in every scalar.

#include <gtest/gtest.h>

#include "exact_run.hpp"
#include "study/families.hpp"

namespace gjkscope::study {
namespace starts_test {

using families::Family;

/// The first pair of a run in R; nothing where R refuses the query.
template <class R, class S, int D>
std::optional<gjk::VertexPair> start_in(const gjk::Query<S, D>& query) {
  const gjk::Prepared<R, D> prepared = gjk::prepare<R>(query, {});
  if (prepared.error != gjk::Error::none) return std::nullopt;
  return gjk::start(query, {}, prepared).simplex.vertices[0].pair;
}

/// How many scalars answered, all alike.
template <int D>
int compare_starts(const families::Pair<double, D>& pair) {
  const auto in_double = start_in<double>(pair.query());
  if (!in_double) return 0;
  int answered = 0;
  const auto expect_same = [&](const char* scalar, std::optional<gjk::VertexPair> start) {
    if (!start) return;
    ++answered;
    EXPECT_TRUE(*start == *in_double) << scalar << " starts from " << start->x << ", " << start->y
                                      << ", double from " << in_double->x << ", " << in_double->y;
  };
  expect_same("half", start_in<Eigen::half>(pair.query()));
  expect_same("float", start_in<float>(pair.query()));
  expect_same("long double", start_in<long double>(pair.query()));
  expect_same("expansions", start_in<gjk::Expansion>(pair.query()));
  expect_same("rationals", start_in<Rational>(exact(pair).query()));
  return answered;
}

template <int D>
void compare_families(int families) {
  constexpr int kPairs = 40;
  families::Source random(32);
  for (int family = 0; family < families; ++family) {
    SCOPED_TRACE(families::kFamilyNames[static_cast<std::size_t>(family)]);
    int answered = 0;
    for (int i = 0; i < kPairs; ++i)
      answered += compare_starts(random.pair<double, D>(static_cast<Family>(family)));
    EXPECT_GE(answered, 2 * kPairs);
  }
}
TEST(Starts, AreTheSameInEveryScalarInTheFamiliesOfThePlane) {
  compare_families<2>(families::kFamilyCount);
}
TEST(Starts, AreTheSameInEveryScalarInTheFamiliesOfSpace) {
  compare_families<3>(families::kSpaceFamilyCount);
}

}  // namespace starts_test
}  // namespace gjkscope::study
