#pragma once
// Pairs that meet, of every family, and what is asked of their depths.

#include "depth/instances.hpp"
#include "truth.hpp"

namespace test {

/// Families of the plane, and two that depths are asked of alone.
enum class DepthFamily : std::uint8_t {
  round = families::kFamilyCount,  ///< Polygons of 16 to 40 vertices on ellipses.
  extreme,  ///< A pair of another family times 2^498 or 2^-498: about 1e150 or 1e-150.
};
inline constexpr int kDepthFamilyCount = families::kFamilyCount + 2;
[[nodiscard]] inline std::string_view name_of(DepthFamily family) {
  if (family == DepthFamily::round) return "round";
  if (family == DepthFamily::extreme) return "extreme";
  return families::kFamilyNames[static_cast<std::size_t>(family)];
}

/// The last of all families; it knows no other size.
inline constexpr auto kDenormals = static_cast<DepthFamily>(families::Family::denormals);

/// The pair times 2^exponent; as it is where a coordinate would come near the ends of the range.
template <int D>
[[nodiscard]] families::Pair<double, D> scaled(const families::Pair<double, D>& pair,
                                               int exponent) {
  using Point = gjk::Vec<double, D>;
  families::Pair<double, D> out = pair;
  bool has_room = true;
  const auto scale = [&](Point& v) {
    for (int i = 0; i < D; ++i) {
      v[i] = std::ldexp(v[i], exponent);
      has_room = has_room && (v[i] == 0 || (1e-200 < std::abs(v[i]) && std::abs(v[i]) < 1e200));
    }
  };
  for (std::vector<Point>* points : {&out.x, &out.y}) {
    for (Point& p : *points) scale(p);
  }
  scale(out.x_pose.translation);
  scale(out.y_pose.translation);
  return has_room ? out : pair;
}

[[nodiscard]] inline Pair pair_of(families::Source& source, DepthFamily family,
                                  families::Representation representation) {
  if (family == DepthFamily::round) {
    const Pair pair = source.polygons(source.among(16, 40));
    return representation == families::Representation::float_values
               ? families::rounded_to_floats(pair)
               : pair;
  }
  return source.pair<double>(static_cast<families::Family>(family), representation);
}

/// Moves Y so that the shapes meet: in a common vertex (but for rounding), somewhat deeper than
/// that, or with their means in one place.
template <int D>
void make_meet(families::Source& source, families::Pair<double, D>& pair) {
  using Point = gjk::Vec<double, D>;
  const auto one_of = [&](const std::vector<Point>& points, const gjk::Pose<double, D>& pose) {
    const int i = source.among(0, static_cast<int>(points.size()) - 1);
    return Point(pose.rotated(points[static_cast<std::size_t>(i)]) + pose.translation);
  };
  const auto mean_of = [](const std::vector<Point>& points, const gjk::Pose<double, D>& pose) {
    Point sum = Point::Zero();
    for (const Point& p : points) sum += p / static_cast<double>(points.size());
    return Point(pose.rotated(sum) + pose.translation);
  };
  const Point between_means = mean_of(pair.x, pair.x_pose) - mean_of(pair.y, pair.y_pose);
  Point by = between_means;
  if (source.with_chance(0.7)) {
    by = one_of(pair.x, pair.x_pose) - one_of(pair.y, pair.y_pose);
    const double deeper = source.with_chance(0.5) ? source.magnitude(1e-12, 0.5) : 0.0;
    by += (between_means - by) * deeper;
  }
  if (pair.x_pose.rotation.turns() || pair.y_pose.rotation.turns()) {
    pair.y_pose.translation += by;
  } else {
    for (Point& p : pair.y) p += by;
  }
}

/// A pair of the family; one that is apart is made to meet.
[[nodiscard]] inline Pair meeting_pair(families::Source& source, DepthFamily family,
                                       families::Representation representation) {
  if (family == DepthFamily::extreme) {
    const auto of = static_cast<DepthFamily>(source.among(0, static_cast<int>(kDenormals) - 1));
    const Pair pair = meeting_pair(source, of, representation);
    return scaled(pair, source.with_chance(0.5) ? 498 : -498);
  }
  Pair pair = pair_of(source, family, representation);
  const bool as_it_is = source.with_chance(0.25);
  if (as_it_is && gjk::distance(pair.query()).verdict != gjk::Verdict::separated) return pair;
  make_meet(source, pair);
  return representation == families::Representation::float_values
             ? families::rounded_to_floats(pair)
             : pair;
}

/// The most that lengths may be off, in u * scale.
inline const Judgement kBars = {"", 4, 16, 8, 8};

/// The bar or claim that is broken, or "".
template <class R, int D>
[[nodiscard]] std::string broken_bar(const depth::Result<R, D>& result, const Judgement& found,
                                     const Judgement& bars) {
  if (!found.broken.empty()) return found.broken;
  if (result.stop == depth::StopReason::iteration_cap) return "iteration cap";
  if (!(found.error <= bars.error)) return "error";
  if (!(found.width <= bars.width)) return "width";
  if (!(found.touch <= bars.touch)) return "touch";
  if (!(found.contact <= bars.contact)) return "contact";
  return "";
}

/// A power of two times the pair has the same depth, times that power, to the bit. Holds where
/// nothing becomes denormal.
template <int D>
[[nodiscard]] bool keeps_bits_when_scaled(const families::Pair<double, D>& pair,
                                          const depth::Result<double, D>& result, int exponent) {
  if (result.error != gjk::Error::none || !(1e-150 < result.depth)) return true;
  const auto larger = scaled(pair, exponent);
  if (larger.x == pair.x && larger.y == pair.y) return true;
  const auto other = depth::penetration<double>(larger.query());
  const auto as_before = [&](double a) { return std::ldexp(a, exponent); };
  return other.depth == as_before(result.depth) && other.lower == as_before(result.lower) &&
         other.upper == as_before(result.upper) && other.direction == result.direction &&
         other.settled == result.settled && other.iterations == result.iterations;
}

}  // namespace test
