#pragma once
// The ordinary query in the plane: the run that the phases make, kept in registers.
//
// The decisions are those of the phases, taken in the same order from the same operations, so the
// answer has the same bits; tests/gjk/quick_test.cpp holds what comes this way to the run of the
// phases. Missing is what ordinary queries do not need: a run that comes to such a place gives up,
// and the phases start over.

#include <bit>

#include "gjk/certificate.hpp"
#include "gjk/stop.hpp"

namespace gjk::quick {

[[nodiscard]] inline Two both(double a) { return Two{a, a}; }
[[nodiscard]] inline Two swapped(const Two& a) { return __builtin_shufflevector(a, a, 1, 0); }
[[nodiscard]] inline Two larger(const Two& a, const Two& b) {
#ifdef __SSE2__
  return _mm_max_pd(b, a);
#else
  return a < b ? b : a;
#endif
}
/// Zeros with the sign of a.
[[nodiscard]] inline Two sign_of(double a) { return both(std::copysign(0.0, a)); }
/// a, turned round where `sign`, made of zeros, has one.
[[nodiscard]] inline Two with_sign(const Two& a, const Two& sign) {
  return std::bit_cast<Two>(std::bit_cast<TwoMasks>(a) ^ std::bit_cast<TwoMasks>(sign));
}
[[nodiscard]] inline double dot(const Two& a, const Two& b) {
  const Two products = a * b;
  return products[0] + products[1];
}
[[nodiscard]] inline double cross(const Two& a, const Two& b) {
  const Two products = a * swapped(b);
  return products[0] - products[1];
}
/// As gjk::perpendicular.
[[nodiscard]] inline Two perpendicular(const Two& a) { return Two{a[1], -a[0]}; }
[[nodiscard]] inline Flat<double> flat(const Two& a) { return {a[0], a[1]}; }

/// Bits 2 and 3 are those of `second`: set where a comparison holds.
[[nodiscard]] inline int bits(const TwoMasks& first, const TwoMasks& second) {
#ifdef __SSE2__
  return _mm_movemask_ps(
      _mm_shuffle_ps(_mm_castsi128_ps(first), _mm_castsi128_ps(second), _MM_SHUFFLE(2, 0, 2, 0)));
#else
  return static_cast<int>((first[0] & 1) | (first[1] & 2) | (second[0] & 4) | (second[1] & 8));
#endif
}

[[nodiscard]] inline int bits(const TwoMasks& masks) {
#ifdef __SSE2__
  return _mm_movemask_pd(_mm_castsi128_pd(masks));
#else
  return static_cast<int>((masks[0] & 1) | (masks[1] & 2));
#endif
}

/// As detail::scan, four vertices at a time: the first of those that lie farthest along d. Without
/// a branch, for nobody foresees how vertices compare. Vertices may be looked at again.
template <class VertexAt>
[[nodiscard]] inline int farthest(int count, const Two& d, const VertexAt& vertex) {
  double most = 0.0;
  const auto first_of = [&](int i, int j, int k, int l) {
    const auto along = [&](const Two& a, const Two& b) {
      return Two{d[0], d[0]} * Two{a[0], b[0]} + Two{d[1], d[1]} * Two{a[1], b[1]};
    };
    const Two left = along(vertex(i), vertex(j));
    const Two right = along(vertex(k), vertex(l));
    const Two most_of = larger(left, right);
    most = most_of[0] < most_of[1] ? most_of[1] : most_of[0];
    return i + __builtin_ctz(bits(left == both(most), right == both(most)));
  };
  const int last = count - 1;
  int index = first_of(0, std::min(1, last), std::min(2, last), std::min(3, last));
  for (int next = 4; next < count; next += 4) {
    const int i = std::min(next, count - 4);
    const double before = most;
    const int offered = first_of(i, i + 1, i + 2, i + 3);
    index = detail::chosen(before < most, offered, index);
    most = before < most ? most : before;
  }
  return index;
}

/// By which of four numbers are less than which others, the first that none exceeds. Bits from the
/// lowest: first < third, second < fourth, first < fourth, second < third, first < second,
/// third < fourth.
inline constexpr std::array<std::uint8_t, 64> kFirstOfMost = [] {
  constexpr std::array<unsigned, 6> kExceeded = {0, 1, 0, 1, 0, 2};
  std::array<std::uint8_t, 64> out{};
  for (unsigned less = 0; less < out.size(); ++less) {
    unsigned exceeded = 0;
    for (unsigned bit = 0; bit < kExceeded.size(); ++bit) {
      if ((less >> bit & 1U) != 0) exceeded |= 1U << kExceeded[bit];
    }
    out[less] = static_cast<std::uint8_t>(std::countr_one(exceeded));
  }
  return out;
}();

/// Four vertices of `rows` along d, from vertex i on.
struct FourAlong {
  Two left;
  Two right;
  FourAlong(const Rows& rows, int i, const Two& dx, const Two& dy, const Two& sign)
      : left(with_sign(dx * two_at(rows.x + i) + dy * two_at(rows.y + i), sign)),
        right(with_sign(dx * two_at(rows.x + i + 2) + dy * two_at(rows.y + i + 2), sign)) {}
  [[nodiscard]] Two most() const { return larger(left, right); }
  [[nodiscard]] int equal_to(const Two& value) const { return bits(left == value, right == value); }
  [[nodiscard]] int less_than(const Two& value) const { return bits(left < value, right < value); }
};

/// The same, where the vertices stand in rows.
[[nodiscard]] inline int farthest(int count, const Two& d, const Two& sign, const Rows& rows) {
  const Two dx = both(d[0]);
  const Two dy = both(d[1]);
  const FourAlong four(rows, 0, dx, dy, sign);
  if (count <= 4) {
    // All comparisons at once, rather than the largest first and then where it is: a run waits for
    // each of its scans.
    const Two firsts{four.left[0], four.right[0]};
    const Two seconds{four.left[1], four.right[1]};
    return kFirstOfMost[bits(four.left < four.right, four.left < swapped(four.right)) |
                        bits(firsts < seconds) << 4];
  }
  Two most = four.most();
  const FourAlong next(rows, 4, dx, dy, sign);
  most = larger(most, next.most());
  most = larger(most, swapped(most));
  return __builtin_ctz(four.equal_to(most) | next.equal_to(most) << 4);
}

/// A shape, its vertices seen from its centre.
template <class S>
struct Body {
  const Points<S, 2>& points;
  Two column[2];  ///< Of the rotation.
  Two centre;
  int count;
  bool turned;
  bool centred;
  bool small;
  const Rows* rows;  ///< Of a small shape, as its pose turns them.

  Body(const Shape<S, 2>& shape, bool is_turned, bool is_centred, const Vec<double, 2>& middle,
       Rows& turned_rows)
      : points(shape.vertices),
        column{two(shape.pose.rotation.col(0)), two(shape.pose.rotation.col(1))},
        centre{middle[0], middle[1]},
        count(static_cast<int>(shape.vertices.size())),
        turned(is_turned),
        centred(is_centred),
        small(points.is_small()),
        rows(&points.rows()) {
    if (!small || !turned) return;
    rows = &turned_rows;
    for (int i = 0; i < (count <= 4 ? 4 : Rows::kCount); i += 2) {
      const Two x_row = two_at(points.rows().x + i);
      const Two y_row = two_at(points.rows().y + i);
      const auto turn = [&](double* to, int axis) {
        const Two turned_row = both(column[0][axis]) * x_row + both(column[1][axis]) * y_row;
        to[i] = turned_row[0];
        to[i + 1] = turned_row[1];
      };
      turn(turned_rows.x, 0);
      turn(turned_rows.y, 1);
    }
  }

  [[nodiscard]] static Two two(const Vec<S, 2>& a) {
    return Two{static_cast<double>(a[0]), static_cast<double>(a[1])};
  }
  [[nodiscard]] Two vertex(int i) const { return two(points[i]); }
  [[nodiscard]] Two from_centre(int i) const { return centred ? vertex(i) - centre : vertex(i); }
  [[nodiscard]] Two rotated(const Two& a) const {
    if (!turned) return a;
    return column[0] * both(a[0]) + column[1] * both(a[1]);
  }
  [[nodiscard]] Two placed(int i) const {
    if (small) return Two{rows->x[i], rows->y[i]};
    return rotated(from_centre(i));
  }

  /// Coordinate by coordinate, vertices i and j as Bodies::corner takes them.
  [[nodiscard]] Flat<Two> places(int i, int j, bool same_frame) const {
    if (small && !(same_frame && centred))
      return {Two{rows->x[i], rows->x[j]}, Two{rows->y[i], rows->y[j]}};
    const Two a = same_frame ? vertex(i) : placed(i);
    const Two b = same_frame ? vertex(j) : placed(j);
    return {Two{a[0], b[0]}, Two{a[1], b[1]}};
  }

  /// Of a direction in the world, the first vertex that lies farthest along it.
  [[nodiscard]] int farthest(const Two& d, const Two& sign) const {
    if (small) return quick::farthest(count, d, sign, *rows);
    return quick::farthest(count, with_sign(to_local(d), sign),
                           [&](int i) { return from_centre(i); });
  }
  /// As detail::count_as_far; 3 stands for more, too.
  [[nodiscard]] int count_as_far(const Two& d, int i, int j, double error) const {
    if (!small) {
      const Two local = to_local(d);
      return detail::count_as_far<double>(
          count, [&](int k) { return dot(local, from_centre(k)); }, i, j, error);
    }
    const Two nearer = both(std::min(dot(d, placed(i)), dot(d, placed(j))) - error);
    const Two dx = both(d[0]);
    const Two dy = both(d[1]);
    int less = FourAlong(*rows, 0, dx, dy, both(0.0)).less_than(nearer);
    if (count > 4) less |= FourAlong(*rows, 4, dx, dy, both(0.0)).less_than(nearer) << 4;
    const unsigned all = (1U << count) - 1U;
    const unsigned first = all & ~static_cast<unsigned>(less);
    const unsigned second = first & (first - 1U);
    const unsigned third = second & (second - 1U);
    return static_cast<int>(first != 0) + static_cast<int>(second != 0) +
           static_cast<int>(third != 0);
  }

 private:
  [[nodiscard]] Two to_local(const Two& d) const {
    if (!turned) return d;
    return Two{column[0][0], column[1][0]} * both(d[0]) +
           Two{column[0][1], column[1][1]} * both(d[1]);
  }
};

/// A vertex of the simplex.
struct Corner {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  Two w;
  VertexPair pair;
};

/// Both, and the offset between their centres.
template <class S>
struct Bodies {
  Body<S> x;
  Body<S> y;
  Two offset;
  bool same_frame;

  Bodies(const Query<S, 2>& query, const Prepared<double, 2>& prepared, std::array<Rows, 2>& rows)
      : x(query.x, prepared.x_turned, prepared.centred, prepared.x_centre, rows[0]),
        y(query.y, prepared.y_turned, prepared.centred, prepared.y_centre, rows[1]),
        offset{prepared.offset[0], prepared.offset[1]},
        same_frame(prepared.same_frame) {}

  [[nodiscard]] VertexPair farthest(const Two& d, const Two& sign) const {
    return {x.farthest(d, -sign), y.farthest(d, sign)};
  }
  [[nodiscard]] Corner corner(VertexPair pair) const {
    if (same_frame) return {y.vertex(pair.y) - x.vertex(pair.x), pair};
    return {(y.placed(pair.y) - x.placed(pair.x)) + offset, pair};
  }
};

/// Where a run ended: at a vertex, between two, or in a triangle.
struct Found {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  Corner corners[3];
  double weights[3];
  int count;
  double plane_sq;  ///< See State.
  double plane_reach_sq;
  int iterations;
  StopReason stop;
};

/// The phases in their order, from the simplex of the first start. False where rounding leaves
/// something to be decided that ordinary queries do not come to.
template <class S>
[[nodiscard, gnu::flatten]] inline bool walk(const Bodies<S>& bodies, const Options& options,
                                             Found& found) {
  const VertexPair first =
      options.start_count == 0 ? bodies.farthest(bodies.offset, both(-0.0)) : options.start[0];
  Corner a = bodies.corner(first);
  Corner b = a;
  bool on_edge = false;  // else P is a
  Two weights{1.0, 0.0};
  double plane_sq = 0.0;
  double plane_reach_sq = 0.0;
  double best_sq = std::numeric_limits<double>::infinity();
  int iteration = 1;
  const auto end = [&](StopReason reason) {
    if (on_edge && reason != StopReason::origin_inside) {
      const Two edge = b.w - a.w;
      weights = Two{dot(b.w, edge), -dot(a.w, edge)} / both(dot(edge, edge));
    }
    found.corners[0] = a;
    found.corners[1] = b;
    found.weights[0] = weights[0];
    found.weights[1] = weights[1];
    found.count = on_edge ? 2 : 1;
    found.plane_sq = plane_sq;
    found.plane_reach_sq = plane_reach_sq;
    found.iterations = iteration;
    found.stop = reason;
    return true;
  };
  for (;; ++iteration) {
    // Direction, before its sign: d or -d. P is on the line of an edge, so p_sq is the square of
    // the line's distance.
    Two d = a.w;
    Two side = both(-0.0);
    double d_sq = dot(d, d);
    double p_sq = d_sq;
    if (on_edge) {
      const Two edge = b.w - a.w;
      const double a_cross_b = cross(a.w, b.w);
      d = perpendicular(edge);
      side = sign_of(0.0 - dot(d, a.w));
      d_sq = dot(edge, edge);
      p_sq = a_cross_b * (a_cross_b / d_sq);
    }
    if (!(0.0 < p_sq && p_sq < best_sq)) return false;
    best_sq = p_sq;

    // Support and stop. A vertex that is in the simplex already need not be put together again.
    const VertexPair pair = bodies.farthest(d, side);
    d = with_sign(d, side);
    const auto note_plane = [&](const Two& w) {
      const double value = dot(d, w);
      const double below = value < 0.0 ? value : 0.0;
      const double distance_sq = below * (below / d_sq);
      if (plane_sq < distance_sq) {
        plane_sq = distance_sq;
        plane_reach_sq = dot(w, w);
      }
      return value;
    };
    const bool is_b = pair == b.pair;
    if (is_b || pair == a.pair) {
      note_plane(is_b ? b.w : a.w);
      return end(StopReason::repeated_support);
    }
    const Corner c = bodies.corner(pair);
    const double value = note_plane(c.w);
    const double along_a = dot(d, a.w);
    const double along_b = dot(d, b.w);
    if (!((along_a < along_b ? along_b : along_a) < value)) return end(StopReason::no_progress);
    if (options.iteration_cap <= iteration) return false;

    // Closest and cull.
    const Two ac = c.w - a.w;
    const bool a_in_ac = 0.0 < dot(c.w, ac);
    const bool c_in_ac = 0.0 < -dot(a.w, ac);
    if (!on_edge) {
      on_edge = a_in_ac && c_in_ac;
      if (!a_in_ac) a = c;
      b = c;
      if (!on_edge) b = a;
      continue;
    }
    // O is in the region of neither a nor b: they were kept by the cull before.
    const Two bc = c.w - b.w;
    const bool b_in_bc = 0.0 < dot(c.w, bc);
    const bool c_in_bc = 0.0 < -dot(b.w, bc);
    const double volume = cross(b.w - a.w, ac);
    if (volume == 0.0) return false;
    const double sign = std::copysign(1.0, volume);
    const double of_a = sign * cross(b.w, c.w);
    const double of_b = sign * -cross(a.w, c.w);
    const double of_c = sign * cross(a.w, b.w);
    if (!a_in_ac && !b_in_bc) {
      a = c;
      b = c;
      on_edge = false;
      weights = Two{1.0, 0.0};
    } else if (!(0.0 < of_c)) {
      continue;
    } else if (b_in_bc && c_in_bc && !(0.0 < of_a)) {
      a = b;
      b = c;
    } else if (a_in_ac && c_in_ac && !(0.0 < of_b)) {
      b = c;
    } else {
      const double sum = of_a + of_b + of_c;
      weights = Two{of_a, of_b} / both(sum);
      ++iteration;
      static_cast<void>(end(StopReason::origin_inside));
      found.corners[2] = c;
      found.weights[2] = of_c / sum;
      found.count = 3;
      return 0.0 < of_a && 0.0 < of_b;
    }
  }
}

/// What detail::bounds_outside asks.
template <class S>
struct Asked {
  const Found& simplex;
  const Bodies<S>& bodies;
  const Query<S, 2>& query;
  const Prepared<double, 2>& prepared;

  [[nodiscard]] double corner_reach_sq() const {
    const auto& [x0, x1] = query.x.vertices.far_apart();
    const auto& [y0, y1] = query.y.vertices.far_apart();
    const Flat<Two> from = bodies.x.places(x0, x1, bodies.same_frame);
    const Flat<Two> to = bodies.y.places(y0, y1, bodies.same_frame);
    const Two offset = bodies.same_frame ? Two{0.0, 0.0} : bodies.offset;
    const auto lengths_sq = [&](const Flat<Two>& start) {
      const Two x = (to.x - start.x) + both(offset[0]);
      const Two y = (to.y - start.y) + both(offset[1]);
      return x * x + y * y;
    };
    const Two most = larger(lengths_sq(from), lengths_sq({swapped(from.x), swapped(from.y)}));
    return gjk::larger(most[0], most[1]);
  }
  [[nodiscard]] double careful_distance() const {
    return careful_distance_of(query, prepared, simplex.corners[0].pair, simplex.corners[1].pair,
                               simplex.count == 2);
  }
  [[nodiscard]] bool is_certainly_farthest(const Flat<double>& direction, double angle) const {
    const Two d{direction.x, direction.y};
    const bool on_edge = simplex.count == 2;
    const VertexPair first = simplex.corners[0].pair;
    const VertexPair last = on_edge ? simplex.corners[1].pair : first;
    const double error = length(direction) * prepared.scan_error_within(angle);
    return bodies.x.count_as_far(-d, first.x, last.x, error) *
               bodies.y.count_as_far(d, first.y, last.y, error) ==
           (on_edge ? 2 : 1);
  }

 private:
  [[nodiscard, gnu::noinline, gnu::flatten]] static double careful_distance_of(
      const Query<S, 2>& query, const Prepared<double, 2>& prepared, VertexPair a, VertexPair b,
      bool on_edge) {
    const Flat<DoubleWord<double>> at_a = careful_vertex(query, prepared, a);
    return detail::careful_distance<double>(
        at_a, on_edge ? careful_vertex(query, prepared, b) : at_a, on_edge);
  }
  /// As detail::careful_vertex, both coordinates at once.
  [[nodiscard]] static Flat<DoubleWord<double>> careful_vertex(const Query<S, 2>& query,
                                                               const Prepared<double, 2>& prepared,
                                                               VertexPair pair) {
    detail::CarefulSum<Two, double> sum;
    const auto pair_of = [](const Vec<S, 2>& a, double sign) {
      return Two{sign * static_cast<double>(a[0]), sign * static_cast<double>(a[1])};
    };
    const auto add = [&](const Shape<S, 2>& shape, int vertex, bool turned, double sign) {
      const Two local = pair_of(shape.vertices[vertex], sign);
      if (!turned) return sum.add(local);
      for (int k = 0; k < 2; ++k) {
        sum.add_product(pair_of(shape.pose.rotation.col(k), 1.0), Two{local[k], local[k]});
      }
    };
    sum.add(pair_of(query.y.pose.translation, 1.0));
    sum.add(pair_of(query.x.pose.translation, -1.0));
    add(query.y, pair.y, prepared.y_turned, 1.0);
    add(query.x, pair.x, prepared.x_turned, -1.0);
    const DoubleWord<Two> out = sum.normalised();
    return {{out.hi[0], out.lo[0]}, {out.hi[1], out.lo[1]}};
  }
};

/// As detail::surely_inside, and what the phases ask of a triangle and its weights.
[[nodiscard]] inline bool is_surely_inside(const Found& simplex,
                                           const Prepared<double, 2>& prepared) {
  const Flat<double> a = flat(simplex.corners[0].w);
  const Flat<double> b = flat(simplex.corners[1].w);
  const Flat<double> c = flat(simplex.corners[2].w);
  const auto& [weight_a, weight_b, weight_c] = simplex.weights;
  const auto norm_max = [](const Flat<double>& v) {
    return std::max(std::abs(v.x), std::abs(v.y));
  };
  const double size = std::max(std::max(norm_max(a), norm_max(b)), norm_max(c));
  const double error = detail::volume_error(size, prepared);
  const double least =
      std::min(std::min(std::abs(cross(b, c)), std::abs(cross(a, c))), std::abs(cross(a, b)));
  const Flat<double> p{weight_a * a.x + weight_b * b.x + weight_c * c.x,
                       weight_a * a.y + weight_b * b.y + weight_c * c.y};
  return error < least && !(2.0 * ScalarTraits<double>::unit_roundoff() * size < norm_max(p));
}

/// As detail::set_witness_points: put together from the vertex of the largest weight.
template <class S>
[[nodiscard]] Two witness(const Found& simplex, const Body<S>& body, const Pose<S, 2>& pose,
                          const Prepared<double, 2>& prepared, int VertexPair::*index) {
  const auto& weights = simplex.weights;
  const auto vertex = [&](int i) { return body.vertex(simplex.corners[i].pair.*index); };
  Two from = vertex(0);
  Two beyond{0.0, 0.0};
  if (simplex.count == 2) {
    const Two b = vertex(1);
    const bool from_b = weights[0] < weights[1];
    const double weight = (from_b ? weights[0] : weights[1]) / (weights[0] + weights[1]);
    beyond = (from_b ? from - b : b - from) * both(weight);
    if (from_b) from = b;
  } else if (simplex.count == 3) {
    const double sum = weights[0] + weights[1] + weights[2];
    const auto start_at = [&](int base, int p, int q) {
      from = vertex(base);
      beyond =
          (vertex(p) - from) * both(weights[p] / sum) + (vertex(q) - from) * both(weights[q] / sum);
    };
    if (std::max(weights[0], weights[1]) < weights[2]) {
      start_at(2, 0, 1);
    } else if (weights[0] < weights[1]) {
      start_at(1, 0, 2);
    } else {
      start_at(0, 1, 2);
    }
  }
  if (body.turned && body.centred) {
    const Vec<double, 2> place = detail::careful_place<double>(
        pose, Vec<double, 2>(from[0], from[1]), Vec<double, 2>(beyond[0], beyond[1]), prepared);
    return Two{place[0], place[1]};
  }
  return body.rotated(from + beyond) + Body<S>::two(pose.translation);
}

/// Fills in the answer. False when it is not proved, or came from a place that is not ordinary.
template <class S>
[[nodiscard, gnu::flatten]] bool distance(const Query<S, 2>& query, const Options& options,
                                          const Prepared<double, 2>& prepared,
                                          Result<double, 2>& out) {
  std::array<Rows, 2> turned_rows;  // NOLINT(cppcoreguidelines-pro-type-member-init): as above
  const Bodies<S> bodies(query, prepared, turned_rows);
  Found found;
  if (!walk(bodies, options, found)) return false;
  const Found& simplex = found;
  if (simplex.count == 3) {
    if (!is_surely_inside(simplex, prepared)) return false;
    out.verdict = Verdict::overlapping;
    out.distance = 0.0;
    out.lower = 0.0;
    out.upper = 0.0;
  } else {
    const auto& [a, b, c] = simplex.corners;
    const detail::Feature<double> feature{
        flat(a.w),          flat(b.w),
        simplex.count == 2, std::min(simplex.weights[0], simplex.weights[1]),
        found.plane_sq,     found.plane_reach_sq};
    const detail::Bounds<double> bounds =
        detail::bounds_outside(feature, prepared, Asked<S>{simplex, bodies, query, prepared});
    if (!(0.0 < bounds.lower) || !bounds.tight) return false;
    out.verdict = Verdict::separated;
    out.distance = bounds.distance;
    out.lower = bounds.lower;
    out.upper = bounds.upper;
    out.distance_sq = bounds.distance * bounds.distance;
  }
  out.stop = found.stop;
  out.iterations = found.iterations;
  out.simplex.count = simplex.count;
  for (int i = 0; i < simplex.count; ++i) {
    out.simplex.vertices[i].w[0] = simplex.corners[i].w[0];
    out.simplex.vertices[i].w[1] = simplex.corners[i].w[1];
    out.simplex.vertices[i].pair = simplex.corners[i].pair;
    out.simplex.weights[i] = simplex.weights[i];
  }
  const Two x = witness(simplex, bodies.x, query.x.pose, prepared, &VertexPair::x);
  const Two y = witness(simplex, bodies.y, query.y.pose, prepared, &VertexPair::y);
  out.x[0] = x[0];
  out.x[1] = x[1];
  out.y[0] = y[0];
  out.y[1] = y[1];
  return true;
}

/// True when the query may go this way: the default rules, and no shape so large that climbing
/// beats scanning.
template <class S>
[[nodiscard]] bool is_ordinary(const Query<S, 2>& query, const Options& options,
                               const Prepared<double, 2>& prepared) {
  return prepared.error == Error::none && prepared.exponent == 0 && options.start_count <= 1 &&
         options.direction_rule == DirectionRule::perpendicular &&
         options.region_order == RegionOrder::vertices_first && options.stop_on_repeated_support &&
         options.stop_on_no_progress && options.tolerance == 0.0 && !query.x.vertices.is_ring() &&
         !query.y.vertices.is_ring();
}

}  // namespace gjk::quick
