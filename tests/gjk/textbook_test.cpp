// The textbook's page and the core on a million pairs: where they part, and why.

#include "textbook.hpp"

#include "check.hpp"
#include "study/families.hpp"

namespace textbook_test {

using families::Family;
using families::kFamilyCount;
using families::kFamilyNames;
using families::Representation;
using gjk::Verdict;

constexpr std::uint64_t kSeed = 20100311;

/// How the two answers differ. A length may differ by 16 u times the largest |y - x|.
enum Parting {
  kAlike,
  kOverlapOnly,  ///< The textbook finds O inside a triangle, the core, which asks exactly, beside
                 ///< Z: differences y - x, and the signs of a thin triangle's areas, are rounded.
  kGapOnly,      ///< The textbook finds a distance, the core finds that the shapes meet.
  kFarOff,       ///< Both find a distance: products of the smallest numbers are 0 in the textbook,
                 ///< and the core measures in a unit of its own.
  kPartings
};

textbook::Polygon world(const std::vector<gjk::Vec<double, 2>>& shape,
                        const gjk::Pose<double, 2>& pose) {
  textbook::Polygon out;
  for (const auto& vertex : shape) out.push_back(pose.rotated(vertex) + pose.translation);
  return out;
}

Parting parting_of(const textbook::Polygon& x, const textbook::Polygon& y) {
  const textbook::Output out = textbook::gjk({x, y});
  const bool is_inside = out.simplex.size() == 3;
  const double distance = out.distance;
  double size = 0;
  for (const textbook::Point& a : x) {
    for (const textbook::Point& b : y) size = std::max(size, (b - a).norm());
  }
  const gjk::Result<double, 2> core = gjk::distance(gjk::Query<double, 2>{{x}, {y}});
  const bool meets = core.verdict != Verdict::separated;
  const bool is_near = std::abs(distance - core.distance) <= 16 * 0x1p-53 * size;
  if (is_near && (meets || !is_inside)) return kAlike;
  if (is_inside != meets) return meets ? kGapOnly : kOverlapOnly;
  return kFarOff;
}

TEST(textbook, "the textbook's page and the core part where rounding decides, and nowhere else") {
  std::array<std::array<long, kPartings>, kFamilyCount> counts = {};
  families::Source random(kSeed);
  for (int i = 0; i < check::cases(1000000); ++i) {
    const auto family = static_cast<std::size_t>(i % kFamilyCount);
    const auto pair =
        random.pair<double>(static_cast<Family>(family), i % (2 * kFamilyCount) < kFamilyCount
                                                             ? Representation::float_values
                                                             : Representation::full_doubles);
    ++counts[family][parting_of(world(pair.x, pair.x_pose), world(pair.y, pair.y_pose))];
  }
  std::printf("  %-16s %9s %13s %9s %8s\n", "family", "alike", "overlap only", "gap only",
              "far off");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto& of = counts[i];
    std::printf("  %-16s %9ld %13ld %9ld %8ld\n", kFamilyNames[i].data(), of[kAlike],
                of[kOverlapOnly], of[kGapOnly], of[kFarOff]);
    const auto family = static_cast<Family>(i);
    const check::Context context("family", kFamilyNames[i]);
    if (family != Family::grazing) CHECK_EQ(0L, of[kOverlapOnly]);
    CHECK_EQ(0L, of[kGapOnly]);
    if (family != Family::denormals) CHECK_EQ(0L, of[kFarOff]);
  }
}

}  // namespace textbook_test
