#include "study/family.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gjkscope::study {
namespace {

struct Kind {
  families::Family family;
  const char* name;
  const char* about;
};
constexpr Kind kKinds[] = {
    {families::Family::random, "random",
     "polygons of 3 to 8 vertices, apart, close or overlapping"},
    {families::Family::needle, "needles", "triangles 1e-10 to 1e-4 of their length wide"},
    {families::Family::offset, "far from the origin", "vertices 1e3 to 1e12 from the origin"},
    {families::Family::parallel, "nearly parallel", "facing edges parallel up to 1e-10 to 1e-3"},
    {families::Family::touching, "touching", "sharing boundary points exactly"},
    {families::Family::gap, "close", "1e-12 to 1e-3 apart"},
    {families::Family::tiny, "tiny", "of size 1e-4, 1e-6 or 1e-30"},
    {families::Family::ratio, "mixed scale", "one shape 1e4 or 1e8 times the other, close to it"},
    {families::Family::grid, "integer grid", "small integers: ties, touching, collinear points"},
};

/// Larger polygons come in smaller numbers.
int pairs_of_size(const Sizes& sizes, int vertices) {
  return std::clamp(2048 / vertices, 4, std::max(4, sizes.pairs / 8));
}

/// Y passes X, turning: as many moments as pairs are asked for, in runs of kMoments.
std::vector<DoublePair> motion(families::Source& source, int count) {
  constexpr int kMoments = 32;
  constexpr double kTurn = 0x1p-6;  // half of the tangent of the turn from moment to moment, about
  const Eigen::Vector2d turn((1 - kTurn * kTurn) / (1 + kTurn * kTurn),
                             2 * kTurn / (1 + kTurn * kTurn));
  std::vector<DoublePair> pairs;
  while (static_cast<int>(pairs.size()) < count) {
    DoublePair pair = source.polygons(8);
    const Eigen::Vector2d step{source.between(-0.05, 0.05), source.between(-0.05, 0.05)};
    for (int i = 0; i < kMoments && static_cast<int>(pairs.size()) < count; ++i) {
      pairs.push_back(pair);
      for (Eigen::Vector2d& p : pair.y) {
        p = Eigen::Vector2d(p[0] * turn[0] - p[1] * turn[1], p[0] * turn[1] + p[1] * turn[0]) +
            step;
      }
    }
  }
  return pairs;
}

}  // namespace

std::vector<Family> families_of(std::uint64_t seed, const Sizes& sizes,
                                std::span<const Case> reported) {
  std::vector<Family> out;
  for (const Kind& kind : kKinds) {
    families::Source source(seed);
    Family family{kind.name, kind.about, {}};
    while (static_cast<int>(family.pairs.size()) < sizes.pairs) {
      family.pairs.push_back(source.pair<double>(kind.family));
    }
    out.push_back(std::move(family));
  }
  if (!reported.empty()) {
    Family family{"reported cases", "cases that were reported to libraries as failures", {}};
    for (const Case& each : reported) family.pairs.push_back({each.a, each.b, {}, {}});
    out.push_back(std::move(family));
  }
  families::Source source(seed);
  out.push_back({"in motion", "one octagon passes and turns beside another, moment by moment",
                 motion(source, sizes.pairs), 0, true});
  for (const int vertices : {3, 4, 16, 64, 256, 1024}) {
    if (vertices > sizes.most_vertices) break;
    Family family{fmt::format("{} vertices", vertices),
                  fmt::format("two polygons of {} vertices", vertices),
                  {},
                  vertices};
    for (int i = pairs_of_size(sizes, vertices); i > 0; --i) {
      family.pairs.push_back(source.polygons(vertices));
    }
    out.push_back(std::move(family));
  }
  return out;
}

}  // namespace gjkscope::study
