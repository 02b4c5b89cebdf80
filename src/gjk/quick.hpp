#pragma once
// The ordinary query in the plane: the run that the phases make, kept in registers.
//
// The decisions are those of the phases, taken in the same order from the same operations, so the
// answer has the same bits; tests/gjk/quick_test.cpp holds what comes this way to the run of the
// phases. Missing is what ordinary queries do not need: a run that comes to such a place gives up,
// and the phases start over.
//
// What is read as a whole is written as a whole: a read that needs several writes waits until all
// of them have left the processor, and everything after it waits, too.

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
[[nodiscard]] inline Two smaller(const Two& a, const Two& b) { return -larger(-a, -b); }
[[nodiscard]] inline Two magnitudes(const Two& a) { return larger(a, -a); }
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
/// dot(a, b) and dot(c, d).
[[nodiscard]] inline Two dots(const Two& a, const Two& b, const Two& c, const Two& d) {
  const Two ab = a * b;
  const Two cd = c * d;
  return __builtin_shufflevector(ab, cd, 0, 2) + __builtin_shufflevector(ab, cd, 1, 3);
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

/// A VertexPair as one number.
using Pair = std::uint64_t;
[[nodiscard]] inline Pair pair_of(VertexPair indices) {
  return std::uint64_t{static_cast<std::uint32_t>(indices.x)} |
         std::uint64_t{static_cast<std::uint32_t>(indices.y)} << 32U;
}
[[nodiscard]] inline VertexPair indices(Pair pair) {
  return {static_cast<int>(pair & 0xffffffffU), static_cast<int>(pair >> 32U)};
}

/// A vertex of the simplex.
struct Corner {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  Two w;
  Pair pair;
};

/// Vectors of a shape's frame, as its pose turns them.
template <class S>
struct Turn {
  Two column[2];
  bool turned;

  Turn(const Pose<S, 2>& pose, bool is_turned)
      : column{two<S>(pose.rotation.col(0)), two<S>(pose.rotation.col(1))}, turned(is_turned) {}

  [[nodiscard]] Two operator()(const Two& a) const {
    if (!turned) return a;
    return column[0] * both(a[0]) + column[1] * both(a[1]);
  }
  /// Two vectors, coordinate by coordinate.
  [[nodiscard]] Flat<Two> operator()(const Flat<Two>& a) const {
    if (!turned) return a;
    return {both(column[0][0]) * a.x + both(column[1][0]) * a.y,
            both(column[0][1]) * a.x + both(column[1][1]) * a.y};
  }
  /// What a direction in the world looks like to the shape.
  [[nodiscard]] Two back(const Two& d) const {
    if (!turned) return d;
    return Two{column[0][0], column[1][0]} * both(d[0]) +
           Two{column[0][1], column[1][1]} * both(d[1]);
  }
};

/// Two small shapes. Their vertices, placed, stand coordinate by coordinate: those of X in the
/// first place, those of Y in the second, so that one scan goes through both.
template <class S>
struct SmallShapes {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  const Query<S, 2>& query;
  Two offset;
  bool same_frame;
  int count;  ///< Of the rows: 4 or all.
  Two x[Rows::kCount];
  Two y[Rows::kCount];

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): as above
  SmallShapes(const Query<S, 2>& asked, const Prepared<double, 2>& prepared)
      : query(asked), offset(two(prepared.offset)), same_frame(prepared.same_frame) {
    const Points<S, 2>& from = query.x.vertices;
    const Points<S, 2>& to = query.y.vertices;
    count = std::max(from.size(), to.size()) <= 4 ? 4 : Rows::kCount;
    const Turn<S> turn_x(query.x.pose, prepared.x_turned);
    const Turn<S> turn_y(query.y.pose, prepared.y_turned);
    const auto two_of = [](const Rows& rows, int i) {
      return Flat<Two>{two_at(rows.x + i), two_at(rows.y + i)};
    };
    for (int i = 0; i < count; i += 2) {
      const Flat<Two> of_x = turn_x(two_of(from.rows(), i));
      const Flat<Two> of_y = turn_y(two_of(to.rows(), i));
      x[i] = __builtin_shufflevector(of_x.x, of_y.x, 0, 2);
      x[i + 1] = __builtin_shufflevector(of_x.x, of_y.x, 1, 3);
      y[i] = __builtin_shufflevector(of_x.y, of_y.y, 0, 2);
      y[i + 1] = __builtin_shufflevector(of_x.y, of_y.y, 1, 3);
    }
  }

  [[nodiscard]] Corner corner(Pair pair) const {
    const auto [i, j] = indices(pair);
    if (same_frame) return {two(query.y.vertices[j]) - two(query.x.vertices[i]), pair};
    return {(Two{x[j][1], y[j][1]} - Two{x[i][0], y[i][0]}) + offset, pair};
  }

  /// How far vertices lie: of X along -d, of Y along d, where the direction is d with `sign`.
  struct Along {
    Two dx;
    Two dy;
    Two signs;
    Along(const Two& d, const Two& sign)
        : dx(both(d[0])), dy(both(d[1])), signs(with_sign(sign, Two{-0.0, 0.0})) {}
    [[nodiscard]] Two operator()(const Two& at_x, const Two& at_y) const {
      return with_sign(dx * at_x + dy * at_y, signs);
    }
  };

  /// As detail::farthest_pair, without a branch.
  [[nodiscard]] Pair farthest(const Two& d, const Two& sign) const {
    struct Leader {
      Two value;
      TwoMasks index;
    };
    const Along along(d, sign);
    const auto first_of = [](const Leader& a, const Leader& b) {
      return Leader{larger(a.value, b.value),
                    a.index ^ ((a.index ^ b.index) & (a.value < b.value))};
    };
    const auto of_four = [&](int i) {
      const auto vertex = [&](int k) { return Leader{along(x[k], y[k]), TwoMasks{k, k}}; };
      return first_of(first_of(vertex(i), vertex(i + 1)), first_of(vertex(i + 2), vertex(i + 3)));
    };
    Leader first = of_four(0);
    if (count > 4) first = first_of(first, of_four(4));
#ifdef __SSE2__
    return static_cast<Pair>(_mm_cvtsi128_si64(
        _mm_shuffle_epi32(std::bit_cast<__m128i>(first.index), _MM_SHUFFLE(3, 1, 2, 0))));
#else
    return pair_of({static_cast<int>(first.index[0]), static_cast<int>(first.index[1])});
#endif
  }

  /// As detail::count_as_far, for both shapes: the product; 3 of a shape stand for more, too.
  [[nodiscard]] int count_as_far(const Two& d, VertexPair a, VertexPair b, double error) const {
    const Along along(d, both(0.0));
    const auto at = [&](VertexPair pair) {
      return along(Two{x[pair.x][0], x[pair.y][1]}, Two{y[pair.x][0], y[pair.y][1]});
    };
    const Two nearer = smaller(at(a), at(b)) - both(error);
    unsigned less = 0;
    for (int i = 0; i < count; i += 2) {
      less |= static_cast<unsigned>(
                  bits(along(x[i], y[i]) < nearer, along(x[i + 1], y[i + 1]) < nearer))
              << 2U * static_cast<unsigned>(i);
    }
    const auto count_of = [&](unsigned places, const Points<S, 2>& vertices) {
      const unsigned first = places & ~less & ((1U << 2U * vertices.size()) - 1U);
      const unsigned second = first & (first - 1U);
      const unsigned third = second & (second - 1U);
      return static_cast<int>(first != 0) + static_cast<int>(second != 0) +
             static_cast<int>(third != 0);
    };
    return count_of(0x5555U, query.x.vertices) * count_of(0xaaaaU, query.y.vertices);
  }
};

/// Two shapes of any size.
template <class S>
struct AnyShapes {
  struct Body {
    const Points<S, 2>& points;
    Turn<S> turn;
    Two centre;
    bool centred;
    int count;

    Body(const Shape<S, 2>& shape, bool turned, const Vec<double, 2>& middle, bool is_centred)
        : points(shape.vertices),
          turn(shape.pose, turned),
          centre(two(middle)),
          centred(is_centred),
          count(static_cast<int>(shape.vertices.size())) {}

    [[nodiscard]] Two vertex(int i) const { return two(points[i]); }
    [[nodiscard]] Two from_centre(int i) const { return centred ? vertex(i) - centre : vertex(i); }
    [[nodiscard]] Two placed(int i) const { return turn(from_centre(i)); }

    /// Of a direction in the world, the first vertex that lies farthest along it.
    [[nodiscard]] int farthest(const Two& d) const {
      if (points.is_small()) {
        return quick::farthest(count, d, [&](int i) { return placed(i); });
      }
      return quick::farthest(count, turn.back(d), [&](int i) { return from_centre(i); });
    }
    [[nodiscard]] int count_as_far(const Two& d, int i, int j, double error) const {
      const Two to = points.is_small() ? d : turn.back(d);
      const auto along = [&](int k) {
        return dot(to, points.is_small() ? placed(k) : from_centre(k));
      };
      return detail::count_as_far<double>(count, along, i, j, error);
    }
  };

  Body x;
  Body y;
  Two offset;
  bool same_frame;

  AnyShapes(const Query<S, 2>& query, const Prepared<double, 2>& prepared)
      : x(query.x, prepared.x_turned, prepared.x_centre, prepared.centred),
        y(query.y, prepared.y_turned, prepared.y_centre, prepared.centred),
        offset(two(prepared.offset)),
        same_frame(prepared.same_frame) {}

  [[nodiscard]] Corner corner(Pair pair) const {
    const auto [i, j] = indices(pair);
    if (same_frame) return {y.vertex(j) - x.vertex(i), pair};
    return {(y.placed(j) - x.placed(i)) + offset, pair};
  }
  [[nodiscard]] Pair farthest(const Two& d, const Two& sign) const {
    const Two along = with_sign(d, sign);
    return pair_of({x.farthest(-along), y.farthest(along)});
  }
  [[nodiscard]] int count_as_far(const Two& d, VertexPair a, VertexPair b, double error) const {
    return x.count_as_far(-d, a.x, b.x, error) * y.count_as_far(d, a.y, b.y, error);
  }
};

/// Where a run ended: at a vertex, between two, or in a triangle.
struct Found {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  Corner corners[3];
  double weights[3];
  double least_area;  ///< Of the triangles that O makes with two vertices, doubled.
  int count;
  double plane_sq;  ///< See State.
  double plane_reach_sq;
  int iterations;
  StopReason stop;
};

/// The phases in their order, from the simplex of the first start. False where rounding leaves
/// something to be decided that ordinary queries do not come to.
template <class Shapes>
[[nodiscard, gnu::flatten]] inline bool walk(const Shapes& shapes, const Options& options,
                                             Found& found) {
  const Pair first = options.start_count == 0 ? shapes.farthest(shapes.offset, both(-0.0))
                                              : pair_of(options.start[0]);
  Corner a = shapes.corner(first);
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
    const Pair pair = shapes.farthest(d, side);
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
    const Corner c = shapes.corner(pair);
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
      found.corners[2].w = c.w;
      found.corners[2].pair = c.pair;
      found.weights[2] = of_c / sum;
      found.least_area = gjk::smaller(gjk::smaller(of_a, of_b), of_c);
      found.count = 3;
      return 0.0 < of_a && 0.0 < of_b;
    }
  }
}

/// What detail::bounds_outside asks.
template <class S, class Shapes>
struct Asked {
  const Found& simplex;
  const Shapes& shapes;
  const Query<S, 2>& query;
  const Prepared<double, 2>& prepared;

  [[nodiscard]] double corner_reach_sq(bool crossed) const {
    const auto& [x0, x1] = query.x.vertices.far_apart();
    const auto& [y0, y1] = query.y.vertices.far_apart();
    const Two a = shapes.corner(pair_of({x0, crossed ? y1 : y0})).w;
    const Two b = shapes.corner(pair_of({x1, crossed ? y0 : y1})).w;
    const Two both_sq = dots(a, a, b, b);
    return gjk::larger(both_sq[0], both_sq[1]);
  }
  [[nodiscard]] double careful_distance() const {
    return careful_distance_of(query, prepared, indices(simplex.corners[0].pair),
                               indices(simplex.corners[1].pair), simplex.count == 2);
  }
  [[nodiscard]] bool is_certainly_farthest(const Flat<double>& direction, double angle) const {
    const Two d{direction.x, direction.y};
    const bool on_edge = simplex.count == 2;
    const VertexPair first = indices(simplex.corners[0].pair);
    const VertexPair last = on_edge ? indices(simplex.corners[1].pair) : first;
    const double error = length(direction) * prepared.scan_error_within(angle);
    return shapes.count_as_far(d, first, last, error) == (on_edge ? 2 : 1);
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
    const auto signed_two = [](const Vec<S, 2>& a, double sign) { return both(sign) * two(a); };
    const auto add = [&](const Shape<S, 2>& shape, int vertex, bool turned, double sign) {
      const Two local = signed_two(shape.vertices[vertex], sign);
      if (!turned) return sum.add(local);
      for (int k = 0; k < 2; ++k) {
        sum.add_product(two<S>(shape.pose.rotation.col(k)), Two{local[k], local[k]});
      }
    };
    sum.add(two(query.y.pose.translation));
    sum.add(signed_two(query.x.pose.translation, -1.0));
    add(query.y, pair.y, prepared.y_turned, 1.0);
    add(query.x, pair.x, prepared.x_turned, -1.0);
    const DoubleWord<Two> out = sum.normalised();
    return {{out.hi[0], out.lo[0]}, {out.hi[1], out.lo[1]}};
  }
};

/// As detail::surely_inside, and what the phases ask of a triangle and its weights.
[[nodiscard]] inline bool is_surely_inside(const Found& simplex,
                                           const Prepared<double, 2>& prepared) {
  const auto norm_max = [](const Two& v) { return larger(v, swapped(v))[0]; };
  Two most{0.0, 0.0};
  Two p{0.0, 0.0};
  for (int i = 0; i < 3; ++i) {
    const Two& w = simplex.corners[i].w;
    most = larger(most, magnitudes(w));
    const Two part = both(simplex.weights[i]) * w;
    p = i == 0 ? part : p + part;
  }
  const double size = norm_max(most);
  return detail::volume_error(size, prepared) < simplex.least_area &&
         !(2.0 * ScalarTraits<double>::unit_roundoff() * size < norm_max(magnitudes(p)));
}

/// As detail::set_witness_points: put together from the vertex of the largest weight.
template <class S>
[[nodiscard]] Two witness(const Found& simplex, const Shape<S, 2>& shape, bool turned,
                          const Prepared<double, 2>& prepared, int VertexPair::*index) {
  const auto& weights = simplex.weights;
  const auto vertex = [&](int i) {
    return two(shape.vertices[indices(simplex.corners[i].pair).*index]);
  };
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
  if (turned && prepared.centred) {
    const Vec<double, 2> place =
        detail::careful_place<double>(shape.pose, Vec<double, 2>(from[0], from[1]),
                                      Vec<double, 2>(beyond[0], beyond[1]), prepared);
    return Two{place[0], place[1]};
  }
  return Turn<S>(shape.pose, turned)(from + beyond) + two(shape.pose.translation);
}

/// Fills in the answer. False when it is not proved, or came from a place that is not ordinary.
template <class Shapes, class S>
[[nodiscard, gnu::flatten]] inline bool distance_between(const Query<S, 2>& query,
                                                         const Options& options,
                                                         const Prepared<double, 2>& prepared,
                                                         Result<double, 2>& out) {
  const Shapes shapes(query, prepared);
  Found found;  // NOLINT(cppcoreguidelines-pro-type-member-init): as above
  if (!walk(shapes, options, found)) return false;
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
        simplex.count == 2, gjk::smaller(simplex.weights[0], simplex.weights[1]),
        found.plane_sq,     found.plane_reach_sq};
    const detail::Bounds<double> bounds = detail::bounds_outside(
        feature, prepared, Asked<S, Shapes>{simplex, shapes, query, prepared});
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
    out.simplex.vertices[i].pair = indices(simplex.corners[i].pair);
    out.simplex.weights[i] = simplex.weights[i];
  }
  const Two x = witness(simplex, query.x, prepared.x_turned, prepared, &VertexPair::x);
  const Two y = witness(simplex, query.y, prepared.y_turned, prepared, &VertexPair::y);
  out.x[0] = x[0];
  out.x[1] = x[1];
  out.y[0] = y[0];
  out.y[1] = y[1];
  return true;
}

template <class S>
[[nodiscard, gnu::noinline]] bool distance_of_large(const Query<S, 2>& query,
                                                    const Options& options,
                                                    const Prepared<double, 2>& prepared,
                                                    Result<double, 2>& out) {
  return distance_between<AnyShapes<S>>(query, options, prepared, out);
}
template <class S>
[[nodiscard, gnu::flatten]] inline bool distance(const Query<S, 2>& query, const Options& options,
                                                 const Prepared<double, 2>& prepared,
                                                 Result<double, 2>& out) {
  if (query.x.vertices.is_small() && query.y.vertices.is_small())
    return distance_between<SmallShapes<S>>(query, options, prepared, out);
  return distance_of_large(query, options, prepared, out);
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
