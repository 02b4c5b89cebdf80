#pragma once
// Pairs in space that meet, of every family.

#include "gjk/gjk.hpp"
#include "pairs.hpp"
#include "truth_in_space.hpp"

namespace test::space {

/// Families of space, and those that depths are asked of alone.
enum class DepthFamily : std::uint8_t {
  round = families::kSpaceFamilyCount,  ///< 9 to 20 vertices on a sphere or an ellipsoid.
  extreme,  ///< A pair of another family times 2^332 or 2^-332: about 1e100 or 1e-100.
  boxes,    ///< Boxes and prisms on a grid: inside of each other, overlapping, or with a face, an
            ///< edge or a vertex in common.
};
inline constexpr int kDepthFamilyCount = families::kSpaceFamilyCount + 3;
[[nodiscard]] inline std::string_view name_of(DepthFamily family) {
  if (family == DepthFamily::round) return "round";
  if (family == DepthFamily::extreme) return "extreme";
  if (family == DepthFamily::boxes) return "boxes";
  return families::kFamilyNames[static_cast<std::size_t>(family)];
}
inline constexpr auto kDenormals = static_cast<DepthFamily>(families::Family::denormals);

[[nodiscard]] inline std::vector<Eigen::Vector3d> round_shape(families::Source& source) {
  std::vector<Eigen::Vector3d> out;
  const Eigen::Vector3d squash(source.between(0.3, 1), source.between(0.3, 1), 1);
  const int count = source.among(9, 20);
  while (static_cast<int>(out.size()) < count) {
    const Eigen::Vector3d p(source.between(-1, 1), source.between(-1, 1), source.between(-1, 1));
    const double length_sq = gjk::dot(p, p);
    if (length_sq < 0.01 || length_sq > 1) continue;
    out.push_back((p / std::sqrt(length_sq)).cwiseProduct(squash));
  }
  return out;
}

/// A box, or a prism over a triangle or a hexagon, with corners on the grid.
[[nodiscard]] inline std::vector<Eigen::Vector3d> box_or_prism(families::Source& source) {
  const Eigen::Vector3d at(source.among(-2, 2), source.among(-2, 2), source.among(-2, 2));
  const Eigen::Vector3d size(source.among(1, 4), source.among(1, 4), source.among(1, 4));
  std::vector<std::array<int, 2>> base = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  if (source.with_chance(0.2)) base = {{0, 0}, {1, 0}, {0, 1}};
  if (source.with_chance(0.2)) base = {{1, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}, {0, 1}};
  const int up = source.among(0, 2);
  std::vector<Eigen::Vector3d> out;
  for (const std::array<int, 2>& corner : base) {
    for (const int height : {0, 1}) {
      Eigen::Vector3d p;
      p[up] = height;
      p[(up + 1) % 3] = corner[0];
      p[(up + 2) % 3] = corner[1];
      out.push_back(at + p.cwiseProduct(size));
    }
  }
  return out;
}

[[nodiscard]] inline Pair pair_of(families::Source& source, DepthFamily family,
                                  families::Representation representation) {
  const bool floats = representation == families::Representation::float_values;
  if (family == DepthFamily::round) {
    Pair pair{round_shape(source), round_shape(source)};
    const Eigen::Vector3d by(source.between(-1, 1), source.between(-1, 1), source.between(-1, 1));
    for (Eigen::Vector3d& p : pair.y) p += by;
    return floats ? families::rounded_to_floats(pair) : pair;
  }
  if (family == DepthFamily::boxes) {
    Pair pair{box_or_prism(source), box_or_prism(source)};
    if (floats) return pair;
    // A grid that is not of round numbers: the same corners round the same way.
    const Eigen::Vector3d step(source.between(0.5, 1), source.between(0.5, 1),
                               source.between(0.5, 1));
    for (std::vector<Eigen::Vector3d>* points : {&pair.x, &pair.y}) {
      for (Eigen::Vector3d& p : *points) p = p.cwiseProduct(step);
    }
    return pair;
  }
  return source.pair<double, 3>(static_cast<families::Family>(family), representation);
}

/// A pair of the family; one that is apart is made to meet.
[[nodiscard]] inline Pair meeting_pair(families::Source& source, DepthFamily family,
                                       families::Representation representation) {
  if (family == DepthFamily::extreme) {
    const int other = source.among(0, kDepthFamilyCount - 3);
    const auto of = other == static_cast<int>(kDenormals) ? DepthFamily::boxes
                                                          : static_cast<DepthFamily>(other);
    const Pair pair = meeting_pair(source, of, representation);
    return test::scaled(pair, source.with_chance(0.5) ? 332 : -332);
  }
  Pair pair = pair_of(source, family, representation);
  const double as_it_is = family == DepthFamily::boxes ? 0.8 : 0.25;
  if (source.with_chance(as_it_is) &&
      gjk::distance(pair.query()).verdict != gjk::Verdict::separated)
    return pair;
  make_meet(source, pair);
  return representation == families::Representation::float_values
             ? families::rounded_to_floats(pair)
             : pair;
}

/// Bars of the depth itself and of its bounds, in u times the scale; then as in the plane.
inline const Judgement kBars = {"", 4, 24, 8, 8};

}  // namespace test::space
