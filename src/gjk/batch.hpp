#pragma once
// Many queries of float shapes in the plane at once.
//
// Eight pairs share a register of AVX2 and walk through GJK in lockstep, a lane for each pair; two
// such registers take turns, so that one computes while the other waits. The run has two parts:
//
//   1. GJK in float: all shapes relative to their own centres, so that a common offset costs no
//      digits; regions by signs, directions without division, as in the scalar code. All lanes go
//      as many rounds as shapes of their size need.
//   2. The segment that a lane ended with, in double. Vertices are floats, so differences and
//      products of them are exact or nearly so. The segment bounds the distance from above, its
//      support plane from below, provided that no other vertex comes near that plane. Where float
//      is not enough to see that, GJK goes on in double, until both bounds agree to half an ulp of
//      a float.
//
// What the lanes cannot prove (touching shapes, gaps below 1e-7 of the scale), or may not even try
// (more than kMaxLaneVertices vertices, coordinates that may overflow, bad input), is handed to
// `gjk::distance`. So a batch answers every query as the scalar code does:
//
//   - the verdict is that of `gjk::distance`, and where the lanes gave it, it is proved;
//   - `distance` is less than one ulp from the exact distance;
//   - lower <= exact distance <= upper; where the lanes gave them, they are the two floats next to
//     `distance`, or all three are 0.
//
// AVX2 and FMA are looked for at run time. Without them, or on other compilers than GCC and clang
// for x86, `gjk::distance` answers all pairs.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "gjk/batch_lanes.hpp"

namespace gjk {

/// Shapes with more vertices are left to the scalar code.
inline constexpr int kMaxLaneVertices = 16;

enum class Instructions : std::uint8_t {
  best,   ///< AVX2 and FMA where the machine has them.
  plain,  ///< `gjk::distance` for each pair.
};

/// A set of pairs whose vertices are packed once and whose poses may change.
///
///   gjk::Batch batch;
///   for (...) batch.add({{x_vertices}, {y_vertices}});
///   for each frame:
///     for (...) batch.move(i, x_pose, y_pose);
///     batch.distance(results);
class Batch {
 public:
  /// Copies the vertices. Returns the index of the pair: 0, 1, 2 ...
  int add(const Query<float, 2>& query) {
    const int pair = size();
    int x_class = size_class(query.x.vertices);
    int y_class = size_class(query.y.vertices);
    if (x_class == kNoClass || y_class == kNoClass) {
      places_.push_back({-1, static_cast<int>(odd_.size())});
      odd_.push_back({pair,
                      {query.x.vertices.begin(), query.x.vertices.end()},
                      {query.y.vertices.begin(), query.y.vertices.end()},
                      query.x.pose,
                      query.y.pose});
      return pair;
    }
    // Blocks of 3 vertices serve groups of triangles and less, blocks of 4 all others.
    if (x_class != y_class) {
      x_class = std::max(x_class, 1);
      y_class = std::max(y_class, 1);
    }
    int& open = open_groups_[x_class * kClassCount + y_class];
    if (open < 0) {
      open = static_cast<int>(groups_.size());
      Packed& packed = groups_.emplace_back();
      packed.group.first_x = vertices_.size();
      packed.group.first_y = packed.group.first_x + 2 * kClassSizes[x_class];
      vertices_.resize(packed.group.first_y + 2 * kClassSizes[y_class]);
      packed.group.x_count = kClassSizes[x_class];
      packed.group.y_count = kClassSizes[y_class];
      packed.group.block = x_class == 0 ? 3 : 4;
      packed.group.rounds = kRounds[std::max(x_class, y_class)];
    }
    const int index = open;
    Packed& packed = groups_[index];
    detail::BatchGroup& group = packed.group;
    const int lane = group.pair_count++;
    if (group.pair_count == detail::kLaneCount) open = -1;
    if (lane == 0) {
      group.pairs.fill(pair);
      group.reach.lane.fill(std::numeric_limits<float>::quiet_NaN());
    }
    group.pairs[lane] = pair;
    places_.push_back({index, lane});
    packed.x_sizes[lane] = static_cast<std::uint8_t>(query.x.vertices.size());
    packed.y_sizes[lane] = static_cast<std::uint8_t>(query.y.vertices.size());
    packed.x_farthest[lane] = farthest(query.x.vertices);
    packed.y_farthest[lane] = farthest(query.y.vertices);
    packed.x_radius[lane] =
        pack(query.x.vertices, lane, kClassSizes[x_class], group.first_x, group.x_centre);
    packed.y_radius[lane] =
        pack(query.y.vertices, lane, kClassSizes[y_class], group.first_y, group.y_centre);
    for (int i = 0; i < 2; ++i) {
      group.centred = group.centred || group.x_centre[i].lane[lane] != 0.0f ||
                      group.y_centre[i].lane[lane] != 0.0f;
    }
    move(pair, query.x.pose, query.y.pose);
    return pair;
  }

  [[nodiscard]] int size() const { return static_cast<int>(places_.size()); }

  /// New poses for a pair. Costs a few dozen stores; vertices stay where they are.
  void move(int pair, const Pose<float, 2>& x, const Pose<float, 2>& y) {
    assert(0 <= pair && pair < size());
    const Place place = places_[pair];
    if (place.group < 0) {
      odd_[place.lane].x_pose = x;
      odd_[place.lane].y_pose = y;
      return;
    }
    Packed& packed = groups_[place.group];
    detail::BatchGroup& group = packed.group;
    const int lane = place.lane;
    for (int i = 0; i < 4; ++i) {
      group.x_rotation[i].lane[lane] = x.rotation(i / 2, i % 2);
      group.y_rotation[i].lane[lane] = y.rotation(i / 2, i % 2);
    }
    for (int i = 0; i < 2; ++i) {
      group.x_translation[i].lane[lane] = x.translation[i];
      group.y_translation[i].lane[lane] = y.translation[i];
    }
    group.x_turned = group.x_turned || x.rotation.turns();
    const float x_stretch = stretch(x, packed.x_farthest[lane]);
    const float y_stretch = stretch(y, packed.y_farthest[lane]);
    group.reach.lane[lane] =
        (packed.x_radius[lane] * x_stretch + packed.y_radius[lane] * y_stretch) * 1.000001f +
        8 * std::numeric_limits<float>::denorm_min();
  }

  /// The answers, by index of the pair. `results` has room for `size()` of them. Returns how many
  /// were handed to the scalar code.
  int distance(std::span<BatchResult> results,
               Instructions instructions = Instructions::best) const {
    assert(static_cast<int>(results.size()) >= size());
    const bool use_lanes = instructions == Instructions::best && detail::has_lanes();
    int handed_over = 0;
    for (const Packed& packed : groups_) {
      const int answered =
          use_lanes ? detail::solve_group(packed.group, vertices_.data(), results.data()) : 0;
      const int all = (1 << packed.group.pair_count) - 1;
      if ((answered & all) == all) continue;
      for (int lane = 0; lane < packed.group.pair_count; ++lane) {
        if (((answered >> lane) & 1) != 0) continue;
        results[packed.group.pairs[lane]] = scalar_answer(packed, lane);
        ++handed_over;
      }
    }
    for (const Odd& odd : odd_) {
      results[odd.pair] =
          rounded(gjk::distance(Query<float, 2>{{odd.x, odd.x_pose}, {odd.y, odd.y_pose}}));
      ++handed_over;
    }
    return handed_over;
  }

 private:
  using Vertices = std::span<const Vec<float, 2>>;

  struct Place {
    int group;  ///< -1: not in the lanes.
    int lane;   ///< Or index into odd_.
  };
  struct Packed {
    detail::BatchGroup group;
    std::array<std::uint8_t, detail::kLaneCount> x_sizes = {};
    std::array<std::uint8_t, detail::kLaneCount> y_sizes = {};
    std::array<float, detail::kLaneCount> x_farthest = {};  ///< `farthest` of its vertices
    std::array<float, detail::kLaneCount> y_farthest = {};
    std::array<float, detail::kLaneCount> x_radius = {};
    std::array<float, detail::kLaneCount> y_radius = {};
  };
  struct Odd {
    int pair = 0;
    std::vector<Vec<float, 2>> x;
    std::vector<Vec<float, 2>> y;
    Pose<float, 2> x_pose;
    Pose<float, 2> y_pose;
  };

  /// Shapes share groups with shapes of about their size: each costs its group's largest.
  static constexpr std::array<int, 5> kClassSizes = {3, 4, 8, 12, kMaxLaneVertices};
  static constexpr std::array<int, 5> kRounds = {3, 3, 4, 5, 5};
  static constexpr int kClassCount = static_cast<int>(kClassSizes.size());
  static constexpr int kNoClass = -1;
  [[nodiscard]] static int size_class(const Points<float, 2>& vertices) {
    if (vertices.empty() || !vertices.is_finite()) return kNoClass;
    for (int i = 0; i < kClassCount; ++i) {
      if (vertices.size() <= static_cast<std::size_t>(kClassSizes[i])) return i;
    }
    return kNoClass;
  }

  /// A number that can be subtracted from all the coordinates exactly (Sterbenz: neither is more
  /// than twice the other). Where there is none, the coordinates are about as large as the shape
  /// anyway, and it is 0.
  [[nodiscard]] static float centre_of(const Points<float, 2>& vertices, int axis) {
    const float low = vertices.low()[axis];
    const float high = vertices.high()[axis];
    const bool exact = (low > 0.0f && high <= 2.0f * low) || (high < 0.0f && low >= 2.0f * high);
    return exact ? low + (high - low) / 2.0f : 0.0f;
  }

  /// Returns the largest coordinate relative to the centre, and no less than 2^-46 of the centre: a
  /// sum of centres errs by 2^-100 of them, which so is nothing beside what else is rounded.
  float pack(const Points<float, 2>& vertices, int lane, int room, std::size_t first,
             std::array<detail::PerLane, 2>& centre) {
    float radius = 0.0f;
    for (int axis = 0; axis < 2; ++axis) {
      const float middle = centre_of(vertices, axis);
      centre[axis].lane[lane] = middle;
      for (int i = 0; i < room; ++i) {
        const bool exists = i < static_cast<int>(vertices.size());
        const float coordinate =
            exists ? vertices[i][axis] - middle : std::numeric_limits<float>::quiet_NaN();
        vertices_[first + 2 * i + axis].lane[lane] = coordinate;
        if (exists) radius = std::max(radius, std::abs(coordinate));
      }
      radius = std::max(radius, 0x1p-46f * std::abs(middle));
    }
    return radius;
  }

  /// The largest coordinate.
  [[nodiscard]] static float farthest(const Points<float, 2>& vertices) {
    return std::max(norm_max(vertices.low()), norm_max(vertices.high()));
  }

  /// How much the pose can enlarge the largest coordinate; NaN when it is not finite, or when a
  /// coordinate may overflow on its way to the world, or a difference of two.
  [[nodiscard]] static float stretch(const Pose<float, 2>& pose, float farthest) {
    constexpr float kLargest = 0x1p125f;
    const float most = std::max(norm_1<float, 2>(pose.rotation.matrix().row(0).transpose()),
                                norm_1<float, 2>(pose.rotation.matrix().row(1).transpose()));
    const bool holds = detail::is_finite(pose) && farthest < kLargest &&
                       farthest * most + norm_max(pose.translation) < kLargest;
    return holds ? most : std::numeric_limits<float>::quiet_NaN();
  }

  [[nodiscard]] BatchResult scalar_answer(const Packed& packed, int lane) const {
    const detail::BatchGroup& group = packed.group;
    std::array<Vec<float, 2>, kMaxLaneVertices> x;
    std::array<Vec<float, 2>, kMaxLaneVertices> y;
    const auto unpack = [&](auto& out, int count, std::size_t first, const auto& centre) {
      for (int i = 0; i < count; ++i) {
        for (int axis = 0; axis < 2; ++axis) {
          out[i][axis] = vertices_[first + 2 * i + axis].lane[lane] + centre[axis].lane[lane];
        }
      }
      return Vertices(out.data(), count);
    };
    const auto pose = [&](const auto& rotation, const auto& translation) {
      Pose<float, 2> out;
      Eigen::Matrix2f matrix;
      for (int i = 0; i < 4; ++i) matrix(i / 2, i % 2) = rotation[i].lane[lane];
      out.rotation = matrix;
      for (int i = 0; i < 2; ++i) out.translation[i] = translation[i].lane[lane];
      return out;
    };
    return rounded(gjk::distance(
        Query<float, 2>{{unpack(x, packed.x_sizes[lane], group.first_x, group.x_centre),
                         pose(group.x_rotation, group.x_translation)},
                        {unpack(y, packed.y_sizes[lane], group.first_y, group.y_centre),
                         pose(group.y_rotation, group.y_translation)}}));
  }

  [[nodiscard]] static BatchResult rounded(const Result<double, 2>& result) {
    BatchResult out;
    out.error = result.error;
    out.verdict = result.verdict;
    out.iterations = static_cast<std::uint8_t>(std::min(result.iterations, 255));
    out.from_scalar = true;
    if (result.error != Error::none) return out;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    out.x = result.x.cast<float>();
    out.y = result.y.cast<float>();
    out.distance = static_cast<float>(result.distance);
    out.lower = static_cast<float>(result.lower);
    out.upper = static_cast<float>(result.upper);
    if (static_cast<double>(out.lower) > result.lower) out.lower = std::nextafter(out.lower, 0.0f);
    if (static_cast<double>(out.upper) < result.upper) {
      out.upper = std::nextafter(out.upper, kInfinity);
    }
    return out;
  }

  std::vector<Packed> groups_;
  std::vector<detail::PerLane> vertices_;
  std::vector<Odd> odd_;
  std::vector<Place> places_;
  /// The group of each pair of classes that has lanes left, or -1.
  std::vector<int> open_groups_ = std::vector<int>(std::size_t{kClassCount} * kClassCount, -1);
};

}  // namespace gjk
