#pragma once
// Sixteen pairs in lockstep: the memory layout of a group, and the loop over it for AVX2. See
// batch.hpp for what it is good for and what it guarantees.

#include <array>
#include <cstdint>
#include <limits>

#include "gjk/gjk.hpp"

#if (defined(__x86_64__) || defined(__i386__)) && defined(__GNUC__)
#define GJKSCOPE_HAS_LANES 1
#include <immintrin.h>
#else
#define GJKSCOPE_HAS_LANES 0
#endif

namespace gjk {

/// The answer to one pair of a batch: the members of `Result`, in float.
struct BatchResult {
  Vec<float, 2> x = Vec<float, 2>::Zero();  ///< Witness point on X, world coordinates.
  Vec<float, 2> y = Vec<float, 2>::Zero();  ///< Witness point on Y.
  float distance = ScalarTraits<float>::no_length();
  float lower = ScalarTraits<float>::no_length();  ///< lower <= exact distance <= upper
  float upper = ScalarTraits<float>::no_length();
  Verdict verdict = Verdict::none;
  Error error = Error::none;
  std::uint8_t iterations = 0;  ///< In lanes, the rounds that all go and those in double.
  bool from_scalar = false;     ///< The lanes could not prove an answer; `gjk::distance` gave it.
};

namespace detail {

inline constexpr int kRegisterLanes = 8;
/// Two registers, so that one computes while the other waits for a result.
inline constexpr int kLaneCount = 2 * kRegisterLanes;

/// One number of each pair.
struct alignas(32) PerLane {
  std::array<float, kLaneCount> lane = {};
};

/// Sixteen pairs. Vertices lie outside, as x, y of vertex 0, x, y of vertex 1 ...; where a shape
/// has fewer there are NaNs, which no comparison takes. They are relative to the shape's centre,
/// exactly (see `centre_of`).
struct BatchGroup {
  std::array<PerLane, 4> x_rotation = {};  ///< Row by row.
  std::array<PerLane, 4> y_rotation = {};
  std::array<PerLane, 2> x_translation = {};
  std::array<PerLane, 2> y_translation = {};
  std::array<PerLane, 2> x_centre = {};
  std::array<PerLane, 2> y_centre = {};
  PerLane reach;          ///< Bounds |x| + |y|, over the turned vertices, in the largest-coordinate
                          ///< norm; NaN bars the lane.
  bool centred = false;   ///< Some centre is not 0.
  bool x_turned = false;  ///< Some rotation of X is not the identity.
  int x_count = 0;        ///< Of the largest shape.
  int y_count = 0;
  int block = 0;  ///< Their common divisor, 3 or 4.
  int rounds = 0;
  int pair_count = 0;
  /// Which pair each lane holds; lanes without one name that of lane 0, whose answer is written
  /// last.
  std::array<int, kLaneCount> pairs = {};
  std::size_t first_x = 0;  ///< Where the vertices start.
  std::size_t first_y = 0;
};

// What may be rounding, u being the unit roundoff of float or double. All that enters a lane is
// bounded by its scale (`Half`). A coordinate of a vertex of Z errs by 5 u scale: the offset is
// rounded, and then comes a difference or, where X is turned, two, and two sums.

/// Along d, in float: d is rounded, turned and multiplied, which makes 5 u reach |d|_1 for each of
/// two vertices of a shape, and one of them is moved by what this allows.
inline constexpr float kFloatNoise = 12.0f;
/// Twice the area of a triangle with O: u scale^2 times 20 for its vertices, 4 for their difference
/// and 2 for the products.
inline constexpr float kAreaNoise = 28.0f;
/// Along d, in double: u scale |d| times 8.5 for a support plane and twice 9.5 for the height of a
/// segment, so that also what is proved by their being close is close enough.
inline constexpr double kLengthNoise = 28.0;
/// What the bounds may lie apart, relative to the distance: 2^-25, half an ulp of a float.
inline constexpr double kWidth = 0x1p-25;
/// Distances, relative to the scale, whose error in double, 11 u scale, is less than that.
inline constexpr float kLeastGap = 12.0f * 0x1p-28f;
/// How far apart, relative to the scale, a lane's witness points may be where shapes overlap.
inline constexpr float kTear = 0x1p-23f;
/// Scales whose squares float can hold, those of small areas times the unit roundoff. Beyond, all
/// is done in double.
inline constexpr float kLeastScale = 0x1p-62f;
inline constexpr float kLargestScale = 0x1p62f;
inline constexpr int kDoubleCap = 7;  ///< Enough for 16 vertices from any start.

#if GJKSCOPE_HAS_LANES

[[nodiscard]] inline bool has_lanes() {
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
}

namespace lanes {

#define GJKSCOPE_TARGET "avx2,fma"
#define GJKSCOPE_LANES __attribute__((target(GJKSCOPE_TARGET), always_inline)) inline

/// Eight floats; as a mask, all bits of a lane or none.
struct Floats {
  __m256 v;
};
GJKSCOPE_LANES Floats operator+(Floats a, Floats b) { return {_mm256_add_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats operator-(Floats a, Floats b) { return {_mm256_sub_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats operator*(Floats a, Floats b) { return {_mm256_mul_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats operator/(Floats a, Floats b) { return {_mm256_div_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats operator&(Floats a, Floats b) { return {_mm256_and_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats operator|(Floats a, Floats b) { return {_mm256_or_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats operator<(Floats a, Floats b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)};
}
GJKSCOPE_LANES Floats operator==(Floats a, Floats b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_EQ_OQ)};
}
GJKSCOPE_LANES Floats and_not(Floats a, Floats b) { return {_mm256_andnot_ps(b.v, a.v)}; }
GJKSCOPE_LANES Floats min(Floats a, Floats b) { return {_mm256_min_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats max(Floats a, Floats b) { return {_mm256_max_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats times_plus(Floats a, Floats b, Floats c) {
  return {_mm256_fmadd_ps(a.v, b.v, c.v)};
}
GJKSCOPE_LANES Floats times_minus(Floats a, Floats b, Floats c) {
  return {_mm256_fmsub_ps(a.v, b.v, c.v)};
}
GJKSCOPE_LANES Floats minus_times(Floats c, Floats a, Floats b) {
  return {_mm256_fnmadd_ps(a.v, b.v, c.v)};
}
GJKSCOPE_LANES Floats select(Floats mask, Floats yes, Floats no) {
  return {_mm256_blendv_ps(no.v, yes.v, mask.v)};
}
GJKSCOPE_LANES int bits(Floats mask) { return _mm256_movemask_ps(mask.v); }
GJKSCOPE_LANES Floats fill(float a, Floats) { return {_mm256_set1_ps(a)}; }
GJKSCOPE_LANES Floats load(const float* a, Floats) { return {_mm256_load_ps(a)}; }

/// Eight doubles.
struct Doubles {
  __m256d low, high;
};
GJKSCOPE_LANES Doubles operator+(Doubles a, Doubles b) {
  return {_mm256_add_pd(a.low, b.low), _mm256_add_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles operator-(Doubles a, Doubles b) {
  return {_mm256_sub_pd(a.low, b.low), _mm256_sub_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles operator*(Doubles a, Doubles b) {
  return {_mm256_mul_pd(a.low, b.low), _mm256_mul_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles operator/(Doubles a, Doubles b) {
  return {_mm256_div_pd(a.low, b.low), _mm256_div_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles operator&(Doubles a, Doubles b) {
  return {_mm256_and_pd(a.low, b.low), _mm256_and_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles operator|(Doubles a, Doubles b) {
  return {_mm256_or_pd(a.low, b.low), _mm256_or_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles operator==(Doubles a, Doubles b) {
  return {_mm256_cmp_pd(a.low, b.low, _CMP_EQ_OQ), _mm256_cmp_pd(a.high, b.high, _CMP_EQ_OQ)};
}
GJKSCOPE_LANES Doubles operator<(Doubles a, Doubles b) {
  return {_mm256_cmp_pd(a.low, b.low, _CMP_LT_OQ), _mm256_cmp_pd(a.high, b.high, _CMP_LT_OQ)};
}
GJKSCOPE_LANES Doubles and_not(Doubles a, Doubles b) {
  return {_mm256_andnot_pd(b.low, a.low), _mm256_andnot_pd(b.high, a.high)};
}
GJKSCOPE_LANES Doubles min(Doubles a, Doubles b) {
  return {_mm256_min_pd(a.low, b.low), _mm256_min_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles max(Doubles a, Doubles b) {
  return {_mm256_max_pd(a.low, b.low), _mm256_max_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles times_plus(Doubles a, Doubles b, Doubles c) {
  return {_mm256_fmadd_pd(a.low, b.low, c.low), _mm256_fmadd_pd(a.high, b.high, c.high)};
}
GJKSCOPE_LANES Doubles times_minus(Doubles a, Doubles b, Doubles c) {
  return {_mm256_fmsub_pd(a.low, b.low, c.low), _mm256_fmsub_pd(a.high, b.high, c.high)};
}
GJKSCOPE_LANES Doubles minus_times(Doubles c, Doubles a, Doubles b) {
  return {_mm256_fnmadd_pd(a.low, b.low, c.low), _mm256_fnmadd_pd(a.high, b.high, c.high)};
}
GJKSCOPE_LANES Doubles select(Doubles mask, Doubles yes, Doubles no) {
  return {_mm256_blendv_pd(no.low, yes.low, mask.low),
          _mm256_blendv_pd(no.high, yes.high, mask.high)};
}
GJKSCOPE_LANES Doubles sqrt(Doubles a) { return {_mm256_sqrt_pd(a.low), _mm256_sqrt_pd(a.high)}; }
GJKSCOPE_LANES Doubles fill(double a, Doubles) { return {_mm256_set1_pd(a), _mm256_set1_pd(a)}; }
GJKSCOPE_LANES Doubles load(const float* a, Doubles) {
  return {_mm256_cvtps_pd(_mm_load_ps(a)), _mm256_cvtps_pd(_mm_load_ps(a + 4))};
}

GJKSCOPE_LANES Doubles widen(Floats a) {
  return {_mm256_cvtps_pd(_mm256_castps256_ps128(a.v)),
          _mm256_cvtps_pd(_mm256_extractf128_ps(a.v, 1))};
}
GJKSCOPE_LANES Floats narrow(Doubles a) {
  return {_mm256_insertf128_ps(_mm256_castps128_ps256(_mm256_cvtpd_ps(a.low)),
                               _mm256_cvtpd_ps(a.high), 1)};
}
GJKSCOPE_LANES Doubles widen_mask(Floats mask) {
  const __m256i bits_of = _mm256_castps_si256(mask.v);
  return {_mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm256_castsi256_si128(bits_of))),
          _mm256_castsi256_pd(_mm256_cvtepi32_epi64(_mm256_extracti128_si256(bits_of, 1)))};
}
GJKSCOPE_LANES Floats narrow_mask(Doubles mask) {
  const __m256 mixed =
      _mm256_shuffle_ps(_mm256_castpd_ps(mask.low), _mm256_castpd_ps(mask.high), 0x88);
  return {_mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(mixed), 0xd8))};
}

/// All lanes of a group.
struct Group {
  Floats low, high;
};
GJKSCOPE_LANES Group operator-(Group a, Group b) { return {a.low - b.low, a.high - b.high}; }
GJKSCOPE_LANES Group operator*(Group a, Group b) { return {a.low * b.low, a.high * b.high}; }
GJKSCOPE_LANES Group operator&(Group a, Group b) { return {a.low & b.low, a.high & b.high}; }
GJKSCOPE_LANES Group operator|(Group a, Group b) { return {a.low | b.low, a.high | b.high}; }
GJKSCOPE_LANES Group operator<(Group a, Group b) { return {a.low < b.low, a.high < b.high}; }
GJKSCOPE_LANES Group and_not(Group a, Group b) {
  return {and_not(a.low, b.low), and_not(a.high, b.high)};
}
GJKSCOPE_LANES Group min(Group a, Group b) { return {min(a.low, b.low), min(a.high, b.high)}; }
GJKSCOPE_LANES Group max(Group a, Group b) { return {max(a.low, b.low), max(a.high, b.high)}; }
GJKSCOPE_LANES Group times_plus(Group a, Group b, Group c) {
  return {times_plus(a.low, b.low, c.low), times_plus(a.high, b.high, c.high)};
}
GJKSCOPE_LANES Group times_minus(Group a, Group b, Group c) {
  return {times_minus(a.low, b.low, c.low), times_minus(a.high, b.high, c.high)};
}
GJKSCOPE_LANES Group minus_times(Group c, Group a, Group b) {
  return {minus_times(c.low, a.low, b.low), minus_times(c.high, a.high, b.high)};
}
GJKSCOPE_LANES Group select(Group mask, Group yes, Group no) {
  return {select(mask.low, yes.low, no.low), select(mask.high, yes.high, no.high)};
}
GJKSCOPE_LANES Group fill(float a, Group) { return {fill(a, Floats{}), fill(a, Floats{})}; }
GJKSCOPE_LANES Group load(const float* a, Group) {
  return {load(a, Floats{}), load(a + kRegisterLanes, Floats{})};
}

template <class F>
GJKSCOPE_LANES F all(F) {
  return fill(0.0f, F{}) < fill(1.0f, F{});
}
GJKSCOPE_LANES Doubles negative(Doubles a) { return fill(0.0, Doubles{}) - a; }
GJKSCOPE_LANES Floats magnitude(Floats a) { return and_not(a, fill(-0.0f, Floats{})); }

/// A vector of each pair.
template <class F>
struct Plane {
  F x, y;
};
template <class F>
GJKSCOPE_LANES Plane<F> operator+(Plane<F> a, Plane<F> b) {
  return {a.x + b.x, a.y + b.y};
}
template <class F>
GJKSCOPE_LANES Plane<F> operator-(Plane<F> a, Plane<F> b) {
  return {a.x - b.x, a.y - b.y};
}
template <class F>
GJKSCOPE_LANES F dot(Plane<F> a, Plane<F> b) {
  return times_plus(a.x, b.x, a.y * b.y);
}
template <class F>
GJKSCOPE_LANES F cross(Plane<F> a, Plane<F> b) {
  return times_minus(a.x, b.y, a.y * b.x);
}
template <class F>
GJKSCOPE_LANES Plane<F> select(F mask, Plane<F> yes, Plane<F> no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
}
template <class F>
GJKSCOPE_LANES Plane<F> load(const std::array<PerLane, 2>& a, int first, F kind) {
  return {load(&a[0].lane[first], kind), load(&a[1].lane[first], kind)};
}
GJKSCOPE_LANES Plane<Floats> narrow(Plane<Doubles> a) { return {narrow(a.x), narrow(a.y)}; }
GJKSCOPE_LANES Plane<Doubles> widen(Plane<Floats> a) { return {widen(a.x), widen(a.y)}; }

template <class F>
struct Turn {
  Plane<F> row_0, row_1;
};
template <class F>
GJKSCOPE_LANES Turn<F> load_turn(const std::array<PerLane, 4>& a, int first, F kind) {
  return {{load(&a[0].lane[first], kind), load(&a[1].lane[first], kind)},
          {load(&a[2].lane[first], kind), load(&a[3].lane[first], kind)}};
}
template <class F>
GJKSCOPE_LANES Plane<F> turned_plus(const Turn<F>& turn, Plane<F> local, Plane<F> offset) {
  return {times_plus(turn.row_0.x, local.x, times_plus(turn.row_0.y, local.y, offset.x)),
          times_plus(turn.row_1.x, local.x, times_plus(turn.row_1.y, local.y, offset.y))};
}
template <class F>
GJKSCOPE_LANES Plane<F> minus_turned(Plane<F> offset, const Turn<F>& turn, Plane<F> local) {
  return {minus_times(minus_times(offset.x, turn.row_0.y, local.y), turn.row_0.x, local.x),
          minus_times(minus_times(offset.y, turn.row_1.y, local.y), turn.row_1.x, local.x)};
}
template <class F>
GJKSCOPE_LANES Plane<F> turned_back(const Turn<F>& turn, Plane<F> world) {
  return {times_plus(turn.row_0.x, world.x, turn.row_1.x * world.y),
          times_plus(turn.row_0.y, world.x, turn.row_1.y * world.y)};
}

/// A vertex of Z with the two vertices that made it, in their shapes' frames.
template <class F>
struct Point {
  Plane<F> w, x, y;
};
template <class F>
GJKSCOPE_LANES Point<F> select(F mask, const Point<F>& yes, const Point<F>& no) {
  return {select(mask, yes.w, no.w), select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
}

/// Floats from a vertex to the next.
inline constexpr int kVertexStride = 2 * kLaneCount;
template <class F>
GJKSCOPE_LANES Plane<F> vertex(const float* vertices, int i) {
  const float* const x = vertices + i * kVertexStride;
  return {load(x, F{}), load(x + kLaneCount, F{})};
}

/// What one kind of number needs to know of a group.
template <class F>
struct Frame {
  const float* x;  ///< Vertices.
  const float* y;
  int x_count, y_count;
  Turn<F> x_turn, y_turn;
  Plane<F> offset;  ///< From the centre of X to that of Y.
};
/// Of the lanes from `first` on.
template <class F>
GJKSCOPE_LANES Frame<F> make_frame(const BatchGroup& group, const PerLane* vertices, int first,
                                   Plane<F> offset) {
  return {&vertices[group.first_x].lane[first],
          &vertices[group.first_y].lane[first],
          group.x_count,
          group.y_count,
          load_turn(group.x_rotation, first, F{}),
          load_turn(group.y_rotation, first, F{}),
          offset};
}

/// How a group is to be read, known to the compiler.
template <bool kXTurned_, int kBlock_>
struct Layout {
  static constexpr bool kXTurned = kXTurned_;  ///< Rotations of X are not all the identity.
  static constexpr int kBlock = kBlock_;       ///< Vertex counts are multiples of it.
};

/// The end of a shape that is looked for along a direction.
struct Most {
  template <class F>
  GJKSCOPE_LANES static F is_beyond(F value, F best) {
    return best < value;
  }
  template <class F>
  GJKSCOPE_LANES static F of(F value, F best) {
    return max(value, best);
  }
};
struct Least {
  template <class F>
  GJKSCOPE_LANES static F is_beyond(F value, F best) {
    return value < best;
  }
  template <class F>
  GJKSCOPE_LANES static F of(F value, F best) {
    return min(value, best);
  }
};

/// The slides' scan, which carries the vertex along instead of its index: nothing to gather later.
/// `count` is a multiple of kBlock, whose loop the compiler unrolls.
template <class F>
struct Best {
  Plane<F> vertex;
  F value;
};
template <class End, class F>
GJKSCOPE_LANES void scan(Best<F>& best, Plane<F> candidate, Plane<F> along) {
  const F value = dot(along, candidate);
  best.vertex = select(End::is_beyond(value, best.value), candidate, best.vertex);
  best.value = End::of(value, best.value);
}
template <class End, int kBlock, class F>
GJKSCOPE_LANES Plane<F> extreme(const float* vertices, int count, Plane<F> along) {
  Best<F> best;  // NOLINT(cppcoreguidelines-pro-type-member-init): all of it follows
  best.vertex = vertex<F>(vertices, 0);
  best.value = dot(along, best.vertex);
  for (int i = 1; i < kBlock; ++i) scan<End>(best, vertex<F>(vertices, i), along);
  for (int block = kBlock; block < count; block += kBlock) {
    vertices += kBlock * kVertexStride;
    for (int i = 0; i < kBlock; ++i) scan<End>(best, vertex<F>(vertices, i), along);
  }
  return best.vertex;
}
template <class End, int kBlock, class F>
GJKSCOPE_LANES F extreme_value(const float* vertices, int count, Plane<F> along) {
  F best = dot(along, vertex<F>(vertices, 0));
  for (int i = 1; i < kBlock; ++i) best = End::of(dot(along, vertex<F>(vertices, i)), best);
  for (int block = kBlock; block < count; block += kBlock) {
    vertices += kBlock * kVertexStride;
    for (int i = 0; i < kBlock; ++i) best = End::of(dot(along, vertex<F>(vertices, i)), best);
  }
  return best;
}
/// Subtracts 1 for every vertex that lies beyond `level`.
template <class End, int kBlock>
GJKSCOPE_LANES __m256i count_down(const float* vertices, int count, Plane<Floats> along,
                                  Floats level, __m256i total) {
  for (int block = 0; block < count; block += kBlock) {
    for (int i = 0; i < kBlock; ++i) {
      const Floats value = dot(along, vertex<Floats>(vertices, i));
      total = _mm256_add_epi32(total, _mm256_castps_si256(End::is_beyond(value, level).v));
    }
    vertices += kBlock * kVertexStride;
  }
  return total;
}

template <class L, class F>
GJKSCOPE_LANES Plane<F> difference(const Frame<F>& frame, Plane<F> x, Plane<F> y) {
  if constexpr (L::kXTurned) {
    return turned_plus(frame.y_turn, y, minus_turned(frame.offset, frame.x_turn, x));
  } else {
    return turned_plus(frame.y_turn, y, frame.offset - x);
  }
}
/// A direction in the frame of X.
template <class L, class F>
GJKSCOPE_LANES Plane<F> seen_from_x(const Frame<F>& frame, Plane<F> direction) {
  if constexpr (L::kXTurned) return turned_back(frame.x_turn, direction);
  return direction;
}
/// The vertex of Z that reaches least far along `away`, which leads from O away.
template <class L, class F>
GJKSCOPE_LANES Point<F> support(const Frame<F>& frame, Plane<F> away) {
  const Plane<F> away_x = seen_from_x<L>(frame, away);
  const Plane<F> away_y = turned_back(frame.y_turn, away);
  const Plane<F> x = extreme<Most, L::kBlock>(frame.x, frame.x_count, away_x);
  const Plane<F> y = extreme<Least, L::kBlock>(frame.y, frame.y_count, away_y);
  return {difference<L>(frame, x, y), x, y};
}

/// How far it reaches.
template <class L, class F>
GJKSCOPE_LANES F support_value(const Frame<F>& frame, Plane<F> away) {
  const Plane<F> away_x = seen_from_x<L>(frame, away);
  const Plane<F> away_y = turned_back(frame.y_turn, away);
  const F x = extreme_value<Most, L::kBlock>(frame.x, frame.x_count, away_x);
  const F y = extreme_value<Least, L::kBlock>(frame.y, frame.y_count, away_y);
  return (y - x) + dot(away, frame.offset);
}

/// Where O lies with respect to the triangle ABC, C being the newest vertex: in the region of AC,
/// of CB, inside, or else in that of C. Regions without C are out of the question: C lies nearer to
/// O than AB along the search direction. O lies to the left of AB, so turn_a > 0 where O lies to
/// the left of CA, and turn_b > 0 where it lies to the left of BC.
template <class F>
struct Regions {
  F ac, cb, inside;
  F turn_a, turn_b;  ///< Twice the areas OCA and OBC.
};
template <class F>
GJKSCOPE_LANES Regions<F> regions(Plane<F> c, Plane<F> ca, Plane<F> cb) {
  const F zero = fill(0.0f, F{});
  Regions<F> out;  // NOLINT(cppcoreguidelines-pro-type-member-init): all of it follows
  out.turn_a = cross(c, ca);
  out.turn_b = cross(cb, c);
  const F left_a = zero < out.turn_a;
  const F left_b = zero < out.turn_b;
  out.inside = left_a & left_b;
  out.ac = and_not(dot(c, ca) < zero, left_a);
  out.cb = and_not(and_not(dot(c, cb) < zero, left_b), out.ac);
  return out;
}

/// The centre of Y seen from that of X. Shapes far from their own origin make it a small difference
/// of large numbers, hence the error-free sums (Knuth's TwoSum); products of floats are exact.
GJKSCOPE_LANES void add(Doubles& sum, Doubles& error, Doubles term) {
  const Doubles total = sum + term;
  const Doubles part = total - sum;
  error = error + ((sum - (total - part)) + (term - part));
  sum = total;
}
GJKSCOPE_LANES Plane<Doubles> centre_offset(const BatchGroup& group, int first) {
  const Plane<Doubles> x = load(group.x_translation, first, Doubles{});
  const Plane<Doubles> y = load(group.y_translation, first, Doubles{});
  if (!group.centred) return y - x;
  const Turn<Doubles> x_turn = load_turn(group.x_rotation, first, Doubles{});
  const Turn<Doubles> y_turn = load_turn(group.y_rotation, first, Doubles{});
  const Plane<Doubles> x_centre = load(group.x_centre, first, Doubles{});
  const Plane<Doubles> y_centre = load(group.y_centre, first, Doubles{});
  Plane<Doubles> sum = y;
  Plane<Doubles> error = {fill(0.0, Doubles{}), fill(0.0, Doubles{})};
  add(sum.x, error.x, negative(x.x));
  add(sum.x, error.x, y_turn.row_0.x * y_centre.x);
  add(sum.x, error.x, y_turn.row_0.y * y_centre.y);
  add(sum.x, error.x, negative(x_turn.row_0.x * x_centre.x));
  add(sum.x, error.x, negative(x_turn.row_0.y * x_centre.y));
  add(sum.y, error.y, negative(x.y));
  add(sum.y, error.y, y_turn.row_1.x * y_centre.x);
  add(sum.y, error.y, y_turn.row_1.y * y_centre.y);
  add(sum.y, error.y, negative(x_turn.row_1.x * x_centre.x));
  add(sum.y, error.y, negative(x_turn.row_1.y * x_centre.y));
  return sum + error;
}

template <class F>
GJKSCOPE_LANES Plane<F> combine(F u, Plane<F> a, F v, Plane<F> b, F w, Plane<F> c) {
  return {times_plus(u, a.x, times_plus(v, b.x, w * c.x)),
          times_plus(u, a.y, times_plus(v, b.y, w * c.y))};
}
/// Lanes where the triangle ABC holds O beyond rounding, for the unit roundoff of F, and is not so
/// thin that rounding tears the witness points apart. There, A and B become the witness.
template <class F>
GJKSCOPE_LANES F overlap(F inside, F unit_roundoff, F scale, const Regions<F>& found, Point<F>& a,
                         Point<F>& b, const Point<F>& c) {
  const F zero = fill(0.0f, F{});
  const F area_noise = fill(kAreaNoise, F{}) * unit_roundoff * scale * scale;
  const F tear = fill(kTear, F{}) * scale;
  const F turn_c = cross(a.w, b.w);
  const F unit = fill(1.0f, F{}) / (found.turn_a + found.turn_b + turn_c);
  const F u = found.turn_b * unit;
  const F v = found.turn_a * unit;
  const F w = turn_c * unit;
  const Plane<F> torn = combine(u, a.w, v, b.w, w, c.w);
  const F sure = inside & (area_noise < found.turn_a) & (area_noise < found.turn_b) &
                 (area_noise < turn_c) & (max(torn.x, zero - torn.x) < tear) &
                 (max(torn.y, zero - torn.y) < tear);
  a.x = select(sure, combine(u, a.x, v, b.x, w, c.x), a.x);
  a.y = select(sure, combine(u, a.y, v, b.y, w, c.y), a.y);
  b.x = select(sure, a.x, b.x);
  b.y = select(sure, a.y, b.y);
  return sure;
}

/// The point of a simplex nearest to O, and how near.
struct Foot {
  Plane<Doubles> away;  ///< From O to there; not of unit length.
  Doubles height;       ///< distance |away|
  Doubles length;       ///< |away|
  Doubles distance;
  Doubles weight;  ///< Of B.
  Doubles within;  ///< Strictly between A and B.
};
/// Of A in the lanes `vertex`, where B is the same; elsewhere of the line AB, O to the left of it.
GJKSCOPE_LANES Foot find_foot(Doubles vertex, Plane<Doubles> a, Plane<Doubles> b) {
  using F = Doubles;
  Foot foot;  // NOLINT(cppcoreguidelines-pro-type-member-init): all of it follows
  const F left = a.x - b.x;
  const F up = b.y - a.y;
  foot.away = select(vertex, a, Plane<F>{up, left});
  foot.height = dot(foot.away, a);
  const F square = dot(foot.away, foot.away);
  foot.length = sqrt(square);
  const F reciprocal = fill(1.0, F{}) / foot.length;
  foot.distance = foot.height * reciprocal;
  const F along = times_minus(a.x, left, a.y * up);
  foot.within = (fill(0.0, F{}) < along) & (along < square);
  foot.weight = along * (reciprocal * reciprocal);
  return foot;
}

template <class F>
GJKSCOPE_LANES F equal(Plane<F> a, Plane<F> b) {
  return (a.x == b.x) & (a.y == b.y);
}

/// Lanes where it is so clear that rounding in float cannot matter: no vertex comes as near as
/// those that made the foot, which are two, or three for an edge. Then all of Z lies beyond the
/// foot. Parallel edges do not pass.
template <class L>
GJKSCOPE_LANES Floats proven_by_count(const Frame<Floats>& frame, const Foot& foot, Floats vertex,
                                      const Point<Floats>& a, const Point<Floats>& b, Floats reach,
                                      Floats scale) {
  const Plane<Floats> away = narrow(foot.away);
  const Plane<Floats> away_x = seen_from_x<L>(frame, away);
  const Plane<Floats> away_y = turned_back(frame.y_turn, away);
  const Floats noise = times_plus(reach * fill(kFloatNoise * 0x1p-24f, Floats{}),
                                  magnitude(away.x) + magnitude(away.y),
                                  fill(std::numeric_limits<float>::min(), Floats{}));
  const Floats x_level = dot(away_x, a.x) - noise;
  const Floats y_level = dot(away_y, a.y) + noise;
  __m256i rest = _mm256_add_epi32(_mm256_set1_epi32(3), _mm256_castps_si256(vertex.v));
  rest = count_down<Most, L::kBlock>(frame.x, frame.x_count, away_x, x_level, rest);
  rest = count_down<Least, L::kBlock>(frame.y, frame.y_count, away_y, y_level, rest);
  const Floats only_foot = {_mm256_castsi256_ps(_mm256_cmpeq_epi32(rest, _mm256_setzero_si256()))};
  return only_foot & (equal(a.x, b.x) | equal(a.y, b.y)) & (vertex | narrow_mask(foot.within)) &
         (scale * fill(kLeastGap, Floats{}) < narrow(foot.distance));
}

/// What eight lanes come to: witness points are (1 - weight) a + weight b.
struct Ends {
  Point<Floats> a, b;  ///< Without w.
  Floats weight, distance;
  Floats proven, overlapping;
  __m256i iterations;
};
GJKSCOPE_LANES void put(Ends& ends, Doubles lanes, const Point<Doubles>& a, const Point<Doubles>& b,
                        Doubles weight, Doubles distance, int iterations) {
  const Floats mask = narrow_mask(lanes);
  ends.a.x = select(mask, narrow(a.x), ends.a.x);
  ends.a.y = select(mask, narrow(a.y), ends.a.y);
  ends.b.x = select(mask, narrow(b.x), ends.b.x);
  ends.b.y = select(mask, narrow(b.y), ends.b.y);
  ends.weight = select(mask, narrow(weight), ends.weight);
  ends.distance = select(mask, narrow(distance), ends.distance);
  ends.proven = ends.proven | mask;
  ends.iterations = _mm256_blendv_epi8(ends.iterations, _mm256_set1_epi32(iterations),
                                       _mm256_castps_si256(mask.v));
}

template <class L>
GJKSCOPE_LANES Point<Doubles> widen(const Frame<Doubles>& frame, const Point<Floats>& a) {
  const Plane<Doubles> x = widen(a.x);
  const Plane<Doubles> y = widen(a.y);
  return {difference<L>(frame, x, y), x, y};
}

/// Turns AB such that O lies to the left of it, or puts the nearer end in place of both where no
/// point between them is nearer. Returns the lanes where both are the same.
GJKSCOPE_LANES Doubles settle(Point<Doubles>& a, Point<Doubles>& b) {
  using F = Doubles;
  const F same = equal(a.w, b.w);
  const Foot foot = find_foot(same, a.w, b.w);
  const F zero = fill(0.0, F{});
  const F one_end = and_not(all(F{}), foot.within);
  const F at_b = one_end & (zero < foot.weight);
  const F right = foot.within & (foot.height < zero);
  if (bits(narrow_mask(and_not(one_end | right, same))) != 0) {
    const Point<F> old_a = a;
    a = select(at_b | right, b, a);
    b = select(and_not(one_end, at_b) | right, old_a, b);
  }
  return one_end;
}

/// Where the float run ends: O lies nearest to AB, or, for all that float can see, inside ABC with
/// C the support along `away`.
template <class F>
struct Segment {
  Point<F> a, b;
  Plane<F> away;
  F inside;
};
template <class L, class F>
GJKSCOPE_LANES Segment<F> run(const Frame<F>& frame, int rounds) {
  Point<F> a = support<L>(frame, frame.offset);
  Point<F> b = a;
  Plane<F> away = a.w;
  F inside = fill(0.0f, F{});
  for (int round = 0; round < rounds; ++round) {
    const Point<F> c = support<L>(frame, away);
    const Regions<F> found = regions(c.w, a.w - c.w, b.w - c.w);
    a = select(found.ac | found.inside, a, c);
    b = select(found.cb | found.inside, b, c);
    away = select(found.ac | found.cb | found.inside, Plane<F>{b.w.y - a.w.y, a.w.x - b.w.x}, c.w);
    inside = found.inside;
  }
  return {a, b, away, inside};
}

/// Rows to columns.
GJKSCOPE_LANES void transpose(__m256 (&r)[8]) {
  __m256 s[8];
  for (const int i : {0, 2, 4, 6}) {
    s[i] = _mm256_unpacklo_ps(r[i], r[i + 1]);
    s[i + 1] = _mm256_unpackhi_ps(r[i], r[i + 1]);
  }
  __m256 t[8];
  for (const int i : {0, 4}) {
    t[i] = _mm256_shuffle_ps(s[i], s[i + 2], 0x44);
    t[i + 1] = _mm256_shuffle_ps(s[i], s[i + 2], 0xee);
    t[i + 2] = _mm256_shuffle_ps(s[i + 1], s[i + 3], 0x44);
    t[i + 3] = _mm256_shuffle_ps(s[i + 1], s[i + 3], 0xee);
  }
  for (const int i : {0, 1, 2, 3}) {
    r[i] = _mm256_permute2f128_ps(t[i], t[i + 4], 0x20);
    r[i + 4] = _mm256_permute2f128_ps(t[i], t[i + 4], 0x31);
  }
}

static_assert(sizeof(BatchResult) == kRegisterLanes * sizeof(float) &&
              offsetof(BatchResult, verdict) == 28 && offsetof(BatchResult, iterations) == 30);
/// Where `iterations` begins in the word that `verdict` begins.
inline constexpr int kIterationsBit = 16;

/// The answers of the lanes from `first` on.
template <class L>
GJKSCOPE_LANES void write(const BatchGroup& group, const Frame<Floats>& frame, int first,
                          const Ends& ends, BatchResult* results) {
  using F = Floats;
  const auto between = [&](Plane<F> a, Plane<F> b) __attribute__((target(GJKSCOPE_TARGET))) {
    return Plane<F>{times_plus(ends.weight, b.x - a.x, a.x),
                    times_plus(ends.weight, b.y - a.y, a.y)};
  };
  Plane<F> x = between(ends.a.x, ends.b.x);
  Plane<F> y = between(ends.a.y, ends.b.y);
  if (group.centred) {
    x = x + load(group.x_centre, first, F{});
    y = y + load(group.y_centre, first, F{});
  }
  const Plane<F> x_translation = load(group.x_translation, first, F{});
  x = L::kXTurned ? turned_plus(frame.x_turn, x, x_translation) : x + x_translation;
  y = turned_plus(frame.y_turn, y, load(group.y_translation, first, F{}));

  // The neighbours of a positive float are one away when read as an integer.
  const __m256i one =
      _mm256_srli_epi32(_mm256_castps_si256((fill(0.0f, F{}) < ends.distance).v), 31);
  const __m256i distance = _mm256_castps_si256(ends.distance.v);
  const __m256i verdict =
      _mm256_and_si256(_mm256_castps_si256(ends.overlapping.v),
                       _mm256_set1_epi32(static_cast<int>(Verdict::overlapping)));
  const __m256i iterations = _mm256_slli_epi32(ends.iterations, kIterationsBit);
  __m256 rows[kRegisterLanes] = {x.x.v,
                                 x.y.v,
                                 y.x.v,
                                 y.y.v,
                                 ends.distance.v,
                                 _mm256_castsi256_ps(_mm256_sub_epi32(distance, one)),
                                 _mm256_castsi256_ps(_mm256_add_epi32(distance, one)),
                                 _mm256_castsi256_ps(_mm256_or_si256(verdict, iterations))};
  transpose(rows);
  for (int i = kRegisterLanes - 1; i >= 0; --i) {
    _mm256_storeu_ps(reinterpret_cast<float*>(&results[group.pairs[first + i]]), rows[i]);
  }
}

/// The lanes from `first` on, before the float run.
struct Half {
  Plane<Doubles> offset;
  Floats reach, scale;
  Floats wanted;    ///< That are not barred.
  Floats in_float;  ///< Whose scale float can square.
};
GJKSCOPE_LANES Half look_at(const BatchGroup& group, int first) {
  using F = Floats;
  Half half;  // NOLINT(cppcoreguidelines-pro-type-member-init): all of it follows
  half.offset = centre_offset(group, first);
  half.reach = load(&group.reach.lane[first], F{});
  const Plane<F> offset = narrow(half.offset);
  half.scale = half.reach + max(magnitude(offset.x), magnitude(offset.y)) * fill(1.000001f, F{});
  half.wanted = half.scale == half.scale;
  half.in_float = (fill(kLeastScale, F{}) < half.scale) & (half.scale < fill(kLargestScale, F{}));
  return half;
}
/// The offset that the float run sees: NaN, which no comparison takes, in lanes that it is not for.
/// They end where they begin, without the time that denormals take.
GJKSCOPE_LANES Plane<Floats> float_offset(const Half& half) {
  const Plane<Floats> offset = narrow(half.offset);
  const Floats others = and_not(all(Floats{}), half.in_float);
  return {offset.x | others, offset.y | others};
}

/// GJK in double for the lanes `lanes`, from the segments that the float run ended with, and then
/// the answers of all. Few groups need it.
template <class L>
__attribute__((target(GJKSCOPE_TARGET), noinline)) int refine(const BatchGroup& group,
                                                              const PerLane* vertices, int first,
                                                              Floats lanes, const Ends& start,
                                                              BatchResult* results) {
  using F = Doubles;
  const Half half = look_at(group, first);
  const Frame<F> frame = make_frame(group, vertices, first, half.offset);
  const F scale = widen(half.scale);
  Ends ends = start;
  const F zero = fill(0.0, F{});
  const F least = fill(static_cast<double>(std::numeric_limits<float>::denorm_min()), F{});
  F open = widen_mask(lanes);
  Point<F> a = widen<L>(frame, ends.a);
  Point<F> b = widen<L>(frame, ends.b);
  F vertex = settle(a, b);
  for (int iteration = 1; iteration <= kDoubleCap; ++iteration) {
    // The segment bounds the distance from above, the support plane from below: height and plane,
    // divided by |away|.
    const Foot foot = find_foot(vertex, a.w, b.w);
    const F plane = support_value<L>(frame, foot.away);
    const F rounding = scale * fill(kLengthNoise * 0x1p-53, F{}) * foot.length;
    const F proven = open & (vertex | foot.within) & (least < foot.distance) &
                     (foot.height * fill(1.0 - kWidth, F{}) + rounding < plane);
    put(ends, proven, a, b, foot.weight, foot.distance, group.rounds + iteration);
    open = and_not(open, proven);
    if (bits(narrow_mask(open)) == 0) break;

    const Point<F> c = support<L>(frame, foot.away);
    const Regions<F> found = regions(c.w, a.w - c.w, b.w - c.w);
    const F sure = overlap(open & found.inside, fill(0x1p-53, F{}), scale, found, a, b, c);
    put(ends, sure, a, b, zero, zero, group.rounds + iteration);
    ends.overlapping = ends.overlapping | narrow_mask(sure);
    open = and_not(open, sure);
    a = select(found.ac | found.inside, a, c);
    b = select(found.cb | found.inside, b, c);
    vertex = and_not(all(F{}), found.ac | found.cb | found.inside);
  }
  write<L>(group, make_frame(group, vertices, first, narrow(half.offset)), first, ends, results);
  return bits(ends.proven);
}

/// Proves what the float run of the lanes from `first` on has found, and writes it. Returns the
/// lanes where that succeeded.
template <class L>
GJKSCOPE_LANES int finish(const BatchGroup& group, const PerLane* vertices, int first,
                          const Half& half, Segment<Floats> at, BatchResult* results) {
  using F = Floats;
  const F zero = fill(0.0f, F{});
  const F scale = half.scale;
  const Frame<F> frame = make_frame(group, vertices, first, float_offset(half));

  F overlapping = zero;
  if (bits(at.inside) != 0) {
    const Point<F> c = support<L>(frame, at.away);
    const Regions<F> found = regions(c.w, at.a.w - c.w, at.b.w - c.w);
    overlapping = overlap(at.inside, fill(0x1p-24f, F{}), scale, found, at.a, at.b, c);
  }

  Ends ends = {at.a, at.b, zero, zero, overlapping, overlapping, _mm256_set1_epi32(group.rounds)};
  const F rest = and_not(half.wanted, overlapping);
  if (bits(rest) != 0) {
    const Frame<Doubles> exact = make_frame(group, vertices, first, half.offset);
    const F vertex = equal(at.a.w, at.b.w);
    const Foot foot =
        find_foot(widen_mask(vertex), widen<L>(exact, at.a).w, widen<L>(exact, at.b).w);
    const F proven = rest & half.in_float &
                     proven_by_count<L>(frame, foot, vertex, at.a, at.b, half.reach, scale);
    ends.weight = proven & narrow(foot.weight);
    ends.distance = proven & narrow(foot.distance);
    ends.proven = overlapping | proven;
    const F unproven = and_not(rest, proven);
    if (bits(unproven) != 0) {
      const Ends start = ends;
      return refine<L>(group, vertices, first, unproven, start, results);
    }
  }
  write<L>(group, frame, first, ends, results);
  return bits(ends.proven);
}

GJKSCOPE_LANES Plane<Floats> low(Plane<Group> a) { return {a.x.low, a.y.low}; }
GJKSCOPE_LANES Plane<Floats> high(Plane<Group> a) { return {a.x.high, a.y.high}; }
GJKSCOPE_LANES Point<Floats> low(const Point<Group>& a) { return {low(a.w), low(a.x), low(a.y)}; }
GJKSCOPE_LANES Point<Floats> high(const Point<Group>& a) {
  return {high(a.w), high(a.x), high(a.y)};
}

template <class L>
__attribute__((target(GJKSCOPE_TARGET))) inline int solve(const BatchGroup& group,
                                                          const PerLane* vertices,
                                                          BatchResult* results) {
  const Half low_half = look_at(group, 0);
  const Half high_half = look_at(group, kRegisterLanes);
  const Plane<Floats> low_offset = float_offset(low_half);
  const Plane<Floats> high_offset = float_offset(high_half);
  const Frame<Group> frame =
      make_frame(group, vertices, 0,
                 Plane<Group>{{low_offset.x, high_offset.x}, {low_offset.y, high_offset.y}});
  const Segment<Group> at = run<L>(frame, group.rounds);
  const int in_high = finish<L>(group, vertices, kRegisterLanes, high_half,
                                {high(at.a), high(at.b), high(at.away), at.inside.high}, results);
  const int in_low = finish<L>(group, vertices, 0, low_half,
                               {low(at.a), low(at.b), low(at.away), at.inside.low}, results);
  return in_low | in_high << kRegisterLanes;
}

#undef GJKSCOPE_TARGET
#undef GJKSCOPE_LANES

}  // namespace lanes

/// Answers the pairs of a group that the lanes can prove, and says which: bit i for lane i.
[[nodiscard]] inline int solve_group(const BatchGroup& group, const PerLane* vertices,
                                     BatchResult* results) {
  using lanes::Layout;
  if (group.block == 3) {
    return group.x_turned ? lanes::solve<Layout<true, 3>>(group, vertices, results)
                          : lanes::solve<Layout<false, 3>>(group, vertices, results);
  }
  return group.x_turned ? lanes::solve<Layout<true, 4>>(group, vertices, results)
                        : lanes::solve<Layout<false, 4>>(group, vertices, results);
}

#else

[[nodiscard]] inline bool has_lanes() { return false; }
[[nodiscard]] inline int solve_group(const BatchGroup&, const PerLane*, BatchResult*) { return 0; }

#endif

}  // namespace detail
}  // namespace gjk
