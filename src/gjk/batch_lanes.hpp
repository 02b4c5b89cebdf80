#pragma once
// Eight pairs in lockstep: the memory layout of a group, and the loop over it for AVX2. See
// batch.hpp for what it is good for and what it guarantees.

#include <array>
#include <cstdint>

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
  std::uint8_t iterations = 0;
  bool from_scalar = false;  ///< The lanes could not prove an answer; `gjk::distance` gave it.
};

namespace detail {

inline constexpr int kLaneCount = 8;

/// One number of each pair.
struct alignas(32) Eight {
  std::array<float, kLaneCount> lane = {};
};

/// Eight pairs. Vertices lie outside, as x, y of vertex 0, x, y of vertex 1 ...; where a shape has
/// fewer there are NaNs, which no comparison takes. They are relative to the shape's centre,
/// exactly (see `centre_of`).
struct BatchGroup {
  std::array<Eight, 4> x_rotation = {};  ///< Row by row.
  std::array<Eight, 4> y_rotation = {};
  std::array<Eight, 2> x_translation = {};
  std::array<Eight, 2> y_translation = {};
  std::array<Eight, 2> x_centre = {};
  std::array<Eight, 2> y_centre = {};
  Eight reach;            ///< Bounds |x| + |y|, over the turned vertices, in the largest-coordinate
                          ///< norm; NaN bars the lane.
  bool centred = false;   ///< Some centre is not 0.
  bool x_turned = false;  ///< Some rotation of X is not the identity.
  int x_count = 0;        ///< Of the largest shape.
  int y_count = 0;
  int block = 0;  ///< Their common divisor, 3 or 4.
  int rounds = 0;
  int pair_count = 0;
  std::array<int, kLaneCount> pairs = {};  ///< Which pair each lane holds.
  std::size_t first_x = 0;                 ///< Where the vertices start.
  std::size_t first_y = 0;
};

/// Progress of the float run that may be rounding: kFloatNoise u scale |d|_1.
inline constexpr float kFloatNoise = 16.0f;
/// Areas of the float run that may be rounding: kFloatAreaNoise u scale^2.
inline constexpr float kFloatAreaNoise = 64.0f;
/// The same in double: a difference w = y - x errs by 4 roundings ...
inline constexpr double kLengthNoise = 24.0;
inline constexpr double kAreaNoise = 64.0;
/// What the bounds may lie apart, relative to the distance: 2^-25, half an ulp of a float.
inline constexpr double kWidth = 0x1p-25;
inline constexpr float kLeastGap = 0x1p-23f;
/// Scales whose squares, times the unit roundoff, float can hold.
inline constexpr float kLeastScale = 0x1p-32f;
inline constexpr float kLargestScale = 0x1p60f;
inline constexpr int kDoubleCap = 6;

#if GJKSCOPE_HAS_LANES

[[nodiscard]] inline bool has_lanes() { return __builtin_cpu_supports("avx2") != 0; }

namespace lanes {

#define GJKSCOPE_LANES __attribute__((target("avx2"), always_inline)) inline

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
GJKSCOPE_LANES Floats operator^(Floats a, Floats b) { return {_mm256_xor_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats operator<(Floats a, Floats b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)};
}
GJKSCOPE_LANES Floats operator==(Floats a, Floats b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_EQ_OQ)};
}
GJKSCOPE_LANES Floats and_not(Floats a, Floats b) { return {_mm256_andnot_ps(b.v, a.v)}; }
GJKSCOPE_LANES Floats max(Floats a, Floats b) { return {_mm256_max_ps(a.v, b.v)}; }
GJKSCOPE_LANES Floats select(Floats mask, Floats yes, Floats no) {
  return {_mm256_blendv_ps(no.v, yes.v, mask.v)};
}
GJKSCOPE_LANES int bits(Floats mask) { return _mm256_movemask_ps(mask.v); }
GJKSCOPE_LANES Floats fill(float a, Floats) { return {_mm256_set1_ps(a)}; }
GJKSCOPE_LANES Floats load(const Eight& a, Floats) { return {_mm256_load_ps(a.lane.data())}; }

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
GJKSCOPE_LANES Doubles operator^(Doubles a, Doubles b) {
  return {_mm256_xor_pd(a.low, b.low), _mm256_xor_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles operator<(Doubles a, Doubles b) {
  return {_mm256_cmp_pd(a.low, b.low, _CMP_LT_OQ), _mm256_cmp_pd(a.high, b.high, _CMP_LT_OQ)};
}
GJKSCOPE_LANES Doubles and_not(Doubles a, Doubles b) {
  return {_mm256_andnot_pd(b.low, a.low), _mm256_andnot_pd(b.high, a.high)};
}
GJKSCOPE_LANES Doubles max(Doubles a, Doubles b) {
  return {_mm256_max_pd(a.low, b.low), _mm256_max_pd(a.high, b.high)};
}
GJKSCOPE_LANES Doubles select(Doubles mask, Doubles yes, Doubles no) {
  return {_mm256_blendv_pd(no.low, yes.low, mask.low),
          _mm256_blendv_pd(no.high, yes.high, mask.high)};
}
GJKSCOPE_LANES Doubles sqrt(Doubles a) { return {_mm256_sqrt_pd(a.low), _mm256_sqrt_pd(a.high)}; }
GJKSCOPE_LANES Doubles fill(double a, Doubles) { return {_mm256_set1_pd(a), _mm256_set1_pd(a)}; }
GJKSCOPE_LANES Doubles load(const Eight& a, Doubles) {
  return {_mm256_cvtps_pd(_mm_load_ps(a.lane.data())),
          _mm256_cvtps_pd(_mm_load_ps(a.lane.data() + 4))};
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

template <class F>
GJKSCOPE_LANES F all(F) {
  return fill(0.0f, F{}) < fill(1.0f, F{});
}
template <class F>
GJKSCOPE_LANES F negative(F a) {
  return a ^ fill(-0.0f, F{});
}
template <class F>
GJKSCOPE_LANES F magnitude(F a) {
  return and_not(a, fill(-0.0f, F{}));
}

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
GJKSCOPE_LANES Plane<F> operator*(F a, Plane<F> b) {
  return {a * b.x, a * b.y};
}
template <class F>
GJKSCOPE_LANES Plane<F> negative(Plane<F> a) {
  return {negative(a.x), negative(a.y)};
}
template <class F>
GJKSCOPE_LANES F dot(Plane<F> a, Plane<F> b) {
  return a.x * b.x + a.y * b.y;
}
template <class F>
GJKSCOPE_LANES F cross(Plane<F> a, Plane<F> b) {
  return a.x * b.y - a.y * b.x;
}
template <class F>
GJKSCOPE_LANES Plane<F> select(F mask, Plane<F> yes, Plane<F> no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
}
template <class F>
GJKSCOPE_LANES Plane<F> load(const std::array<Eight, 2>& a, F kind) {
  return {load(a[0], kind), load(a[1], kind)};
}

template <class F>
struct Turn {
  Plane<F> row_0, row_1;
};
template <class F>
GJKSCOPE_LANES Turn<F> load_turn(const std::array<Eight, 4>& a, F kind) {
  return {{load(a[0], kind), load(a[1], kind)}, {load(a[2], kind), load(a[3], kind)}};
}
template <bool kTurned, class F>
GJKSCOPE_LANES Plane<F> turned(const Turn<F>& turn, Plane<F> local) {
  if constexpr (!kTurned) return local;
  return {dot(turn.row_0, local), dot(turn.row_1, local)};
}
template <bool kTurned, class F>
GJKSCOPE_LANES Plane<F> turned_back(const Turn<F>& turn, Plane<F> world) {
  if constexpr (!kTurned) return world;
  return {turn.row_0.x * world.x + turn.row_1.x * world.y,
          turn.row_0.y * world.x + turn.row_1.y * world.y};
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

/// What one kind of number needs to know of a group.
template <class F>
struct Frame {
  const BatchGroup* group;
  const Eight* x;
  const Eight* y;
  Turn<F> x_turn, y_turn;
  Plane<F> offset;  ///< From the centre of X to that of Y.
};

template <class F>
GJKSCOPE_LANES Plane<F> vertex(const Eight* vertices, int i) {
  return {load(vertices[2 * i], F{}), load(vertices[2 * i + 1], F{})};
}

/// The slides' scan, which carries the vertex along instead of its index: nothing to gather later.
/// `count` is a multiple of kBlock, whose loop the compiler unrolls.
template <class F>
struct Best {
  Plane<F> vertex;
  F value;
};
template <class F>
GJKSCOPE_LANES void scan(Best<F>& best, const Eight* vertices, int i, Plane<F> d) {
  const Plane<F> candidate = vertex<F>(vertices, i);
  const F value = dot(d, candidate);
  best.vertex = select(best.value < value, candidate, best.vertex);
  best.value = max(value, best.value);
}
template <int kBlock, class F>
GJKSCOPE_LANES Plane<F> farthest(const Eight* vertices, int count, Plane<F> d) {
  Best<F> best;  // NOLINT(cppcoreguidelines-pro-type-member-init): all of it follows
  best.vertex = vertex<F>(vertices, 0);
  best.value = dot(d, best.vertex);
  for (int i = 1; i < kBlock; ++i) scan(best, vertices, i, d);
  for (int block = kBlock; block < count; block += kBlock) {
    for (int i = 0; i < kBlock; ++i) scan(best, vertices + 2 * block, i, d);
  }
  return best.vertex;
}
template <int kBlock, class F>
GJKSCOPE_LANES F farthest_value(const Eight* vertices, int count, Plane<F> d) {
  F best = dot(d, vertex<F>(vertices, 0));
  for (int i = 1; i < kBlock; ++i) best = max(dot(d, vertex<F>(vertices, i)), best);
  for (int block = kBlock; block < count; block += kBlock) {
    for (int i = 0; i < kBlock; ++i) best = max(dot(d, vertex<F>(vertices + 2 * block, i)), best);
  }
  return best;
}
/// Adds the vertices that lie beyond `level` along d.
template <int kBlock>
GJKSCOPE_LANES __m256i count_beyond(const Eight* vertices, int count, Plane<Floats> d, Floats level,
                                    __m256i total) {
  for (int i = 0; i < kBlock; ++i) {
    const Floats beyond = level < dot(d, vertex<Floats>(vertices, i));
    total = _mm256_sub_epi32(total, _mm256_castps_si256(beyond.v));
  }
  for (int block = kBlock; block < count; block += kBlock) {
    for (int i = 0; i < kBlock; ++i) {
      const Floats beyond = level < dot(d, vertex<Floats>(vertices + 2 * block, i));
      total = _mm256_sub_epi32(total, _mm256_castps_si256(beyond.v));
    }
  }
  return total;
}

/// How a group is to be read, known to the compiler.
template <bool kXTurned_, int kBlock_>
struct Layout {
  static constexpr bool kXTurned = kXTurned_;  ///< Rotations of X are not all the identity.
  static constexpr int kBlock = kBlock_;       ///< Vertex counts are multiples of it.
};

template <class L, class F>
GJKSCOPE_LANES Plane<F> difference(const Frame<F>& frame, Plane<F> x, Plane<F> y) {
  return turned<true>(frame.y_turn, y) - turned<L::kXTurned>(frame.x_turn, x) + frame.offset;
}
template <class L, class F>
GJKSCOPE_LANES Point<F> support(const Frame<F>& frame, Plane<F> d) {
  const Plane<F> d_x = turned_back<L::kXTurned>(frame.x_turn, negative(d));
  const Plane<F> d_y = turned_back<true>(frame.y_turn, d);
  const Plane<F> x = farthest<L::kBlock>(frame.x, frame.group->x_count, d_x);
  const Plane<F> y = farthest<L::kBlock>(frame.y, frame.group->y_count, d_y);
  return {difference<L>(frame, x, y), x, y};
}
/// max of dot(d, z) over Z.
template <class L, class F>
GJKSCOPE_LANES F support_value(const Frame<F>& frame, Plane<F> d) {
  const Plane<F> d_x = turned_back<L::kXTurned>(frame.x_turn, negative(d));
  const Plane<F> d_y = turned_back<true>(frame.y_turn, d);
  const F x = farthest_value<L::kBlock>(frame.x, frame.group->x_count, d_x);
  const F y = farthest_value<L::kBlock>(frame.y, frame.group->y_count, d_y);
  return (x + y) + dot(d, frame.offset);
}

/// Where O lies with respect to the triangle ABC, C being the newest vertex: in the region of AC,
/// of CB, inside, or else in that of C. Regions without C are out of the question: C lies nearer to
/// O than AB along d. O lies to the left of AB, so turn_a > 0 where O lies to the left of CA, and
/// turn_b > 0 where it lies to the left of BC.
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

template <class F>
GJKSCOPE_LANES Plane<F> left_normal(Plane<F> a) {
  return {negative(a.y), a.x};
}

/// The centre of Y seen from that of X. Shapes far from their own origin make it a small difference
/// of large numbers, hence the error-free sums (Knuth's TwoSum); products of floats are exact.
GJKSCOPE_LANES void add(Doubles& sum, Doubles& error, Doubles term) {
  const Doubles total = sum + term;
  const Doubles part = total - sum;
  error = error + ((sum - (total - part)) + (term - part));
  sum = total;
}
GJKSCOPE_LANES Plane<Doubles> centre_offset(const BatchGroup& group) {
  const Plane<Doubles> x = load(group.x_translation, Doubles{});
  const Plane<Doubles> y = load(group.y_translation, Doubles{});
  if (!group.centred) return y - x;
  const Turn<Doubles> x_turn = load_turn(group.x_rotation, Doubles{});
  const Turn<Doubles> y_turn = load_turn(group.y_rotation, Doubles{});
  const Plane<Doubles> x_centre = load(group.x_centre, Doubles{});
  const Plane<Doubles> y_centre = load(group.y_centre, Doubles{});
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

/// Lanes where the triangle ABC holds O beyond rounding (`area_noise`), and is not so thin that
/// rounding tears the witness points apart (`length_noise`). There, A and B become the witness.
template <class F>
GJKSCOPE_LANES F overlap(F inside, F area_noise, F length_noise, const Regions<F>& found,
                         Point<F>& a, Point<F>& b, const Point<F>& c) {
  const F turn_c = cross(a.w, b.w);
  const F unit = fill(1.0f, F{}) / (found.turn_a + found.turn_b + turn_c);
  const F u = found.turn_b * unit;
  const F v = found.turn_a * unit;
  const F w = turn_c * unit;
  const Plane<F> torn = u * a.w + v * b.w + w * c.w;
  const F sure = inside & (area_noise < found.turn_a) & (area_noise < found.turn_b) &
                 (area_noise < turn_c) & (magnitude(torn.x) < length_noise) &
                 (magnitude(torn.y) < length_noise);
  a.x = select(sure, u * a.x + v * b.x + w * c.x, a.x);
  a.y = select(sure, u * a.y + v * b.y + w * c.y, a.y);
  b.x = select(sure, a.x, b.x);
  b.y = select(sure, a.y, b.y);
  return sure;
}

/// The point of the segment AB nearest to O.
struct Foot {
  Doubles on_edge;  ///< Strictly between A and B.
  Doubles at_b;
  Doubles right;     ///< O lies to the right of AB.
  Plane<Doubles> d;  ///< From there to O; not of unit length.
  Doubles height;    ///< distance |d|
  Doubles length;    ///< |d|
  Doubles distance;
  Doubles weight;  ///< Of B.
};
GJKSCOPE_LANES Foot find_foot(Plane<Doubles> a, Plane<Doubles> b) {
  using F = Doubles;
  const F zero = fill(0.0, F{});
  const F one = fill(1.0, F{});
  Foot foot;  // NOLINT(cppcoreguidelines-pro-type-member-init): all of it follows
  const Plane<F> edge = b - a;
  const F along = negative(dot(a, edge));
  const F beyond_a = zero < along;
  const F before_b = zero < dot(b, edge);
  foot.on_edge = beyond_a & before_b;
  foot.at_b = and_not(beyond_a, before_b);
  const Plane<F> end = select(foot.at_b, b, a);
  foot.d = select(foot.on_edge, left_normal(edge), negative(end));
  const F signed_height = negative(dot(foot.d, end));
  const F sign = signed_height & fill(-0.0, F{});
  foot.right = signed_height < zero;
  foot.d = {foot.d.x ^ sign, foot.d.y ^ sign};
  foot.height = signed_height ^ sign;
  foot.length = sqrt(dot(foot.d, foot.d));
  const F reciprocal = one / foot.length;
  foot.distance = foot.height * reciprocal;
  foot.weight = select(foot.on_edge, along * (reciprocal * reciprocal), foot.at_b & one);
  return foot;
}

/// Lanes where the support plane at the foot proves the distance: height / |d| bounds it from
/// above, plane / |d| from below.
template <class L>
GJKSCOPE_LANES Doubles proven_by_plane(const Frame<Doubles>& frame, const Foot& foot,
                                       Doubles scale) {
  const Doubles plane = negative(support_value<L>(frame, foot.d));
  const Doubles rounding = scale * fill(kLengthNoise * 0x1p-53, Doubles{}) * foot.length;
  return foot.height * fill(1.0 - kWidth, Doubles{}) + rounding < plane;
}

template <class F>
GJKSCOPE_LANES F equal(Plane<F> a, Plane<F> b) {
  return (a.x == b.x) & (a.y == b.y);
}

/// The same in float, where it is so clear that rounding cannot matter: no vertex reaches as far
/// along d as those that made the foot, which are two, or three for an edge. Then all of Z lies
/// beyond the foot. Parallel edges do not pass.
template <class L>
GJKSCOPE_LANES Floats proven_by_count(const Frame<Floats>& frame, const Foot& foot,
                                      const Point<Floats>& a, const Point<Floats>& b, Floats reach,
                                      Floats scale) {
  const Floats on_edge = narrow_mask(foot.on_edge);
  const Floats same_x = equal(a.x, b.x);
  const Floats same_y = equal(a.y, b.y);
  const Plane<Floats> d = {narrow(foot.d.x), narrow(foot.d.y)};
  const Plane<Floats> d_x = turned_back<L::kXTurned>(frame.x_turn, negative(d));
  const Plane<Floats> d_y = turned_back<true>(frame.y_turn, d);
  const Floats noise =
      reach * fill(kFloatNoise * 0x1p-24f, Floats{}) * (magnitude(d.x) + magnitude(d.y));
  const Floats x_level = dot(d_x, a.x) - noise;
  const Floats y_level = dot(d_y, a.y) - noise;
  __m256i count = _mm256_castps_si256(on_edge.v);
  count = count_beyond<L::kBlock>(frame.x, frame.group->x_count, d_x, x_level, count);
  count = count_beyond<L::kBlock>(frame.y, frame.group->y_count, d_y, y_level, count);
  const Floats only_foot = {_mm256_castsi256_ps(_mm256_cmpeq_epi32(count, _mm256_set1_epi32(2)))};
  return only_foot & select(on_edge, same_x | same_y, same_x & same_y) &
         (scale * fill(kLeastGap, Floats{}) < narrow(foot.distance));
}

/// What the lanes come to: witness points are (1 - weight) a + weight b.
struct Ends {
  Point<Floats> a, b;  ///< Without w.
  Floats weight, distance;
  Floats proven, overlapping;
};
GJKSCOPE_LANES void put(Plane<Floats>& whole, Floats mask, Plane<Doubles> value) {
  whole = select(mask, Plane<Floats>{narrow(value.x), narrow(value.y)}, whole);
}
GJKSCOPE_LANES void put(Ends& ends, Doubles lanes, const Point<Doubles>& a, const Point<Doubles>& b,
                        Doubles weight, Doubles distance) {
  const Floats mask = narrow_mask(lanes);
  put(ends.a.x, mask, a.x);
  put(ends.a.y, mask, a.y);
  put(ends.b.x, mask, b.x);
  put(ends.b.y, mask, b.y);
  ends.weight = select(mask, narrow(weight), ends.weight);
  ends.distance = select(mask, narrow(distance), ends.distance);
  ends.proven = ends.proven | mask;
}

template <class L>
GJKSCOPE_LANES Point<Doubles> widen(const Frame<Doubles>& frame, const Point<Floats>& a) {
  const Plane<Doubles> x = {widen(a.x.x), widen(a.x.y)};
  const Plane<Doubles> y = {widen(a.y.x), widen(a.y.y)};
  return {difference<L>(frame, x, y), x, y};
}

/// GJK in double for the lanes `open`, from the segments that the float run ended with. Few groups
/// need it.
template <class L>
__attribute__((target("avx2"), noinline)) void refine(const Frame<Doubles>& frame, Floats lanes,
                                                      Floats scale_of, Ends& ends) {
  using F = Doubles;
  const F zero = fill(0.0, F{});
  const F scale = widen(scale_of);
  const F area_noise = fill(kAreaNoise * 0x1p-53, F{}) * scale * scale;
  const F length_noise = fill(0x1p-24, F{}) * scale;
  F open = widen_mask(lanes);
  Point<F> a = widen<L>(frame, ends.a);
  Point<F> b = widen<L>(frame, ends.b);
  for (int iteration = 0; iteration < kDoubleCap; ++iteration) {
    const Foot foot = find_foot(a.w, b.w);
    const F proven = open & proven_by_plane<L>(frame, foot, scale);
    put(ends, proven, a, b, foot.weight, foot.distance);
    open = and_not(open, proven);
    if (bits(narrow_mask(open)) == 0) return;

    // O to the left of AB, and both the same vertex where the foot is one.
    const Point<F> start = select(foot.on_edge & foot.right, b, a);
    const Point<F> end = select(foot.right, a, b);
    const F at_a = and_not(and_not(all(F{}), foot.on_edge), foot.at_b);
    a = select(foot.at_b, b, start);
    b = select(at_a, a, select(foot.on_edge, end, b));

    const Point<F> c = support<L>(frame, foot.d);
    const Regions<F> found = regions(c.w, a.w - c.w, b.w - c.w);
    const F sure = overlap(open & found.inside, area_noise, length_noise, found, a, b, c);
    put(ends, sure, a, b, zero, zero);
    ends.overlapping = ends.overlapping | narrow_mask(sure);
    open = and_not(open, sure);
    a = select(found.ac | found.inside, a, c);
    b = select(found.cb | found.inside, b, c);
  }
}

/// Rows to columns.
GJKSCOPE_LANES void transpose(__m256 (&r)[8]) {
  __m256 s[8];
  for (int i = 0; i < 8; i += 2) {
    s[i] = _mm256_unpacklo_ps(r[i], r[i + 1]);
    s[i + 1] = _mm256_unpackhi_ps(r[i], r[i + 1]);
  }
  __m256 t[8];
  for (int i = 0; i < 8; i += 4) {
    t[i] = _mm256_shuffle_ps(s[i], s[i + 2], 0x44);
    t[i + 1] = _mm256_shuffle_ps(s[i], s[i + 2], 0xee);
    t[i + 2] = _mm256_shuffle_ps(s[i + 1], s[i + 3], 0x44);
    t[i + 3] = _mm256_shuffle_ps(s[i + 1], s[i + 3], 0xee);
  }
  for (int i = 0; i < 4; ++i) {
    r[i] = _mm256_permute2f128_ps(t[i], t[i + 4], 0x20);
    r[i + 4] = _mm256_permute2f128_ps(t[i], t[i + 4], 0x31);
  }
}

static_assert(sizeof(BatchResult) == sizeof(Eight) && offsetof(BatchResult, verdict) == 28 &&
              offsetof(BatchResult, iterations) == 30);

template <class F>
GJKSCOPE_LANES Frame<F> make_frame(const BatchGroup& group, const Eight* vertices,
                                   Plane<F> offset) {
  return {&group,
          vertices + group.first_x,
          vertices + group.first_y,
          load_turn(group.x_rotation, F{}),
          load_turn(group.y_rotation, F{}),
          offset};
}

template <class L>
__attribute__((target("avx2"))) inline int solve(const BatchGroup& group, const Eight* vertices,
                                                 BatchResult* results) {
  using F = Floats;
  const F zero = fill(0.0f, F{});
  const Plane<Doubles> offset = centre_offset(group);
  const Frame<F> frame = make_frame<F>(group, vertices, {narrow(offset.x), narrow(offset.y)});
  const F reach = load(group.reach, F{});
  const F scale =
      reach + max(magnitude(frame.offset.x), magnitude(frame.offset.y)) * fill(1.000001f, F{});
  const F wanted = (fill(kLeastScale, F{}) < scale) & (scale < fill(kLargestScale, F{}));

  Point<F> a = support<L>(frame, negative(frame.offset));
  Point<F> b = a;
  Plane<F> d = negative(a.w);
  const int rounds = group.rounds;
  F inside = zero;
  for (int round = 0; round < rounds; ++round) {
    const Point<F> c = support<L>(frame, d);
    const Regions<F> found = regions(c.w, a.w - c.w, b.w - c.w);
    a = select(found.ac | found.inside, a, c);
    b = select(found.cb | found.inside, b, c);
    d = select(found.ac | found.cb | found.inside, left_normal(b.w - a.w), negative(c.w));
    inside = found.inside;
  }
  F overlapping = zero;
  if (bits(inside & wanted) != 0) {
    const Point<F> c = support<L>(frame, d);
    const Regions<F> found = regions(c.w, a.w - c.w, b.w - c.w);
    overlapping = overlap(inside & wanted, fill(kFloatAreaNoise * 0x1p-24f, F{}) * scale * scale,
                          fill(2 * 0x1p-24f, F{}) * scale, found, a, b, c);
  }

  Ends ends = {a, b, zero, zero, overlapping, overlapping};
  const F rest = and_not(wanted, overlapping);
  if (bits(rest) != 0) {
    const Frame<Doubles> exact = make_frame<Doubles>(group, vertices, offset);
    const Foot foot = find_foot(widen<L>(exact, a).w, widen<L>(exact, b).w);
    const F proven = rest & proven_by_count<L>(frame, foot, a, b, reach, scale);
    ends.weight = proven & narrow(foot.weight);
    ends.distance = proven & narrow(foot.distance);
    ends.proven = overlapping | proven;
    const F unproven = and_not(rest, proven);
    if (bits(unproven) != 0) refine<L>(exact, unproven, scale, ends);
  }

  Plane<F> x = ends.a.x + ends.weight * (ends.b.x - ends.a.x);
  Plane<F> y = ends.a.y + ends.weight * (ends.b.y - ends.a.y);
  if (group.centred) {
    x = x + load(group.x_centre, F{});
    y = y + load(group.y_centre, F{});
  }
  x = turned<L::kXTurned>(frame.x_turn, x) + load(group.x_translation, F{});
  y = turned<true>(frame.y_turn, y) + load(group.y_translation, F{});

  // The neighbours of a positive float are one away when read as an integer.
  const __m256i one = _mm256_srli_epi32(_mm256_castps_si256((zero < ends.distance).v), 31);
  const __m256i distance = _mm256_castps_si256(ends.distance.v);
  const __m256i verdict =
      _mm256_and_si256(_mm256_castps_si256(ends.overlapping.v),
                       _mm256_set1_epi32(static_cast<int>(Verdict::overlapping)));
  __m256 rows[8] = {x.x.v,
                    x.y.v,
                    y.x.v,
                    y.y.v,
                    ends.distance.v,
                    _mm256_castsi256_ps(_mm256_sub_epi32(distance, one)),
                    _mm256_castsi256_ps(_mm256_add_epi32(distance, one)),
                    _mm256_castsi256_ps(verdict)};
  transpose(rows);
  for (int i = 0; i < kLaneCount; ++i) {
    if (i < group.pair_count) {
      _mm256_storeu_ps(reinterpret_cast<float*>(&results[group.pairs[i]]), rows[i]);
    }
  }
  return bits(ends.proven);
}

#undef GJKSCOPE_LANES

}  // namespace lanes

/// Answers the pairs of a group that the lanes can prove, and says which: bit i for lane i.
[[nodiscard]] inline int solve_group(const BatchGroup& group, const Eight* vertices,
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
[[nodiscard]] inline int solve_group(const BatchGroup&, const Eight*, BatchResult*) { return 0; }

#endif

}  // namespace detail
}  // namespace gjk
