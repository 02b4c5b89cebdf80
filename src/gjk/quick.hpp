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
[[nodiscard]] inline Two smaller(const Two& a, const Two& b) {
#ifdef __SSE2__
  return _mm_min_pd(b, a);
#else
  return b < a ? b : a;
#endif
}
[[nodiscard]] inline Two magnitudes(const Two& a) {
  return std::bit_cast<Two>(std::bit_cast<TwoMasks>(a) & ~std::bit_cast<TwoMasks>(both(-0.0)));
}
/// Zeros with the sign of cross(a, b), which comes to both places at once and so sooner than that.
[[nodiscard]] inline Two signed_zeros_of_cross(const Two& a, const Two& b) {
  const Two crossed = both(a[0]) * both(b[1]) - both(a[1]) * both(b[0]);
  return std::bit_cast<Two>(std::bit_cast<TwoMasks>(crossed) & std::bit_cast<TwoMasks>(both(-0.0)));
}
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
    // No bit is set when coordinates overflowed to NaNs: any vertex does for what is given up.
    return i +
           __builtin_ctz(8U | static_cast<unsigned>(bits(left == both(most), right == both(most))));
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
  return std::min(index, last);
}

/// A VertexPair as one number.
using Pair = std::uint64_t;
[[nodiscard]] inline Pair pair_of(VertexPair indices) {
  return std::uint64_t{static_cast<std::uint32_t>(indices.x)} |
         std::uint64_t{static_cast<std::uint32_t>(indices.y)} << 32U;
}
[[nodiscard]] inline std::size_t index_x(Pair pair) { return pair & 0xffffffffU; }
[[nodiscard]] inline std::size_t index_y(Pair pair) { return pair >> 32U; }
[[nodiscard]] inline VertexPair indices(Pair pair) {
  return {static_cast<int>(index_x(pair)), static_cast<int>(index_y(pair))};
}

/// A vertex of the simplex.
struct Corner {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  Two w;
  Pair pair;
};
template <class Shapes>
[[nodiscard]] inline Corner corner(const Shapes& shapes, Pair pair) {
  return {shapes.vertex(index_x(pair), index_y(pair)), pair};
}

/// Vectors of a shape's frame, as its pose turns them.
template <class S>
struct Turn {
  Two column[2];
  bool turned;

  explicit Turn(const Rotation<S, 2>& rotation)
      : column{two<S>(rotation.col(0)), two<S>(rotation.col(1))}, turned(rotation.turns()) {}

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

/// Two small shapes, of at most kRows vertices each. Their vertices, placed, stand coordinate by
/// coordinate: those of X, turned round O, in the first place, those of Y in the second. So a
/// vertex of Z is a sum, and one scan goes through both shapes.
template <class S, int kRows>
struct SmallShapes {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  const Query<S, 2>& query;
  Two offset;
  bool same_frame;
  std::array<Two, kRows> x;
  std::array<Two, kRows> y;

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): as above
  SmallShapes(const Query<S, 2>& asked, const Prepared<double, 2>& prepared)
      : query(asked), offset(two(prepared.offset)), same_frame(prepared.same_frame) {
    const Turn<S> turn_x(query.x.pose.rotation);
    const Turn<S> turn_y(query.y.pose.rotation);
    const auto two_of = [](const Points<S, 2>& vertices, int i) {
      return Flat<Two>{two_at(vertices.rows().x + i), two_at(vertices.rows().y + i)};
    };
    for (int i = 0; i < kRows; i += 2) {
      const Flat<Two> of_x = -turn_x(two_of(query.x.vertices, i));
      const Flat<Two> of_y = turn_y(two_of(query.y.vertices, i));
      x[i] = __builtin_shufflevector(of_x.x, of_y.x, 0, 2);
      x[i + 1] = __builtin_shufflevector(of_x.x, of_y.x, 1, 3);
      y[i] = __builtin_shufflevector(of_x.y, of_y.y, 0, 2);
      y[i + 1] = __builtin_shufflevector(of_x.y, of_y.y, 1, 3);
    }
  }

  /// The vertex of Z from vertex i of X and vertex j of Y.
  [[nodiscard]] Two vertex(std::size_t i, std::size_t j) const {
    if (same_frame) return two(query.y.vertices[j]) - two(query.x.vertices[i]);
    return (Two{x[j][1], y[j][1]} + Two{x[i][0], y[i][0]}) + offset;
  }

  /// Of X and of Y, which row a scan chose: by index, and for few rows by how they compared, which
  /// leads to the row sooner.
  struct Choice {
    Pair pair;
    TwoMasks second;  ///< Of the first two rows.
    TwoMasks fourth;  ///< Of the next two.
    TwoMasks later;   ///< Of the next two, not of the first two.
  };
  [[nodiscard]] Corner corner(const Choice& choice) const {
    if (kRows == Rows::kCount || same_frame) return quick::corner(*this, choice.pair);
    const auto chosen = [&](const std::array<Two, kRows>& rows) {
      const Two of_first = choice.second ? rows[1] : rows[0];
      const Two of_next = choice.fourth ? rows[3] : rows[2];
      return choice.later ? of_next : of_first;
    };
    const Two at_x = chosen(x);
    const Two at_y = chosen(y);
    const Two of_x = __builtin_shufflevector(at_x, at_y, 0, 2);
    const Two of_y = __builtin_shufflevector(at_x, at_y, 1, 3);
    return {(of_y + of_x) + offset, choice.pair};
  }
  /// As detail::farthest_pair, without a branch: along -d.
  [[nodiscard]] Choice farthest_against(const Two& d) const {
    return lowest([along = Along(d), this](int i) { return along(x[i], y[i]); });
  }
  /// The support point along -d.
  [[nodiscard]] Corner support_against(const Two& d) const { return corner(farthest_against(d)); }
  /// The support point along perpendicular(edge), turned round by `sign`, which is known only when
  /// the scan has begun.
  [[nodiscard]] Corner support_across(const Two& edge, const Two& sign) const {
    const Two ex = both(edge[0]);
    const Two ey = both(edge[1]);
    return corner(lowest([&](int i) { return with_sign(ex * y[i] - ey * x[i], sign); }));
  }

  /// True when certainly no vertex of Z but a and b, which may be one, lies as far along d.
  [[nodiscard]] bool are_alone(const Two& d, VertexPair a, VertexPair b, double error) const {
    const Along along(d);
    const auto at = [&](VertexPair pair) {
      return along(Two{x[pair.x][0], x[pair.y][1]}, Two{y[pair.x][0], y[pair.y][1]});
    };
    const Two nearer = smaller(at(a), at(b)) - both(error);
    unsigned less = 0;  // two bits for each row: of X and of Y
    for (int i = 0; i < kRows; i += 2) {
      less |= static_cast<unsigned>(
                  bits(along(x[i], y[i]) < nearer, along(x[i + 1], y[i + 1]) < nearer))
              << 2U * static_cast<unsigned>(i);
    }
    const auto all_of = [](const Points<S, 2>& vertices) {
      return (1U << 2U * static_cast<unsigned>(vertices.size())) - 1U;
    };
    const auto bit = [](int row) { return 1U << 2U * static_cast<unsigned>(row); };
    const unsigned of_x = ~less & all_of(query.x.vertices) & 0x5555U;
    const unsigned of_y = ~less & all_of(query.y.vertices) & 0xaaaaU;
    const unsigned others = (of_x ^ (bit(a.x) | bit(b.x))) | (of_y ^ ((bit(a.y) | bit(b.y)) << 1U));
    // One comparison, for nobody foresees of which shape an edge is.
    return (others | (static_cast<unsigned>(a.x != b.x) & static_cast<unsigned>(a.y != b.y))) == 0;
  }

 private:
  /// How far vertices lie: of X along -d, of Y along d.
  struct Along {
    Two dx;
    Two dy;
    explicit Along(const Two& d) : dx(both(d[0])), dy(both(d[1])) {}
    [[nodiscard]] Two operator()(const Two& at_x, const Two& at_y) const {
      return dx * at_x + dy * at_y;
    }
  };
  /// Of some rows the one with the least value, and the first of equals.
  struct Lowest {
    Two value;
    TwoMasks index;
  };
  [[nodiscard]] static Lowest lower(const Lowest& a, const Lowest& b) {
    return {smaller(a.value, b.value), b.value < a.value ? b.index : a.index};
  }
  template <class Value>
  [[nodiscard]] static Choice lowest(const Value& value) {
    Choice choice;  // NOLINT(cppcoreguidelines-pro-type-member-init): all of it follows
    const auto of_two = [&](int i, TwoMasks& second) {
      const Two a = value(i);
      const Two b = value(i + 1);
      second = b < a;
      return Lowest{smaller(a, b), TwoMasks{i, i} - second};
    };
    const Lowest first = of_two(0, choice.second);
    const Lowest next = of_two(2, choice.fourth);
    choice.later = next.value < first.value;
    Lowest of_all = lower(first, next);
    if constexpr (kRows == Rows::kCount) {
      TwoMasks not_kept;
      of_all = lower(of_all, lower(of_two(4, not_kept), of_two(6, not_kept)));
    }
    choice.pair = pair_of(of_all.index);
    return choice;
  }
  [[nodiscard]] static Pair pair_of(const TwoMasks& index) {
#ifdef __SSE2__
    return static_cast<Pair>(_mm_cvtsi128_si64(
        _mm_shuffle_epi32(std::bit_cast<__m128i>(index), _MM_SHUFFLE(3, 1, 2, 0))));
#else
    return quick::pair_of({static_cast<int>(index[0]), static_cast<int>(index[1])});
#endif
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

    Body(const Shape<S, 2>& shape, const Vec<double, 2>& middle, bool is_centred)
        : points(shape.vertices),
          turn(shape.pose.rotation),
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
      : x(query.x, prepared.x_centre, prepared.centred),
        y(query.y, prepared.y_centre, prepared.centred),
        offset(two(prepared.offset)),
        same_frame(prepared.same_frame) {}

  [[nodiscard]] Two vertex(std::size_t i, std::size_t j) const {
    if (same_frame) return y.vertex(j) - x.vertex(i);
    return (y.placed(j) - x.placed(i)) + offset;
  }
  /// As those of SmallShapes.
  struct Choice {
    Pair pair;
  };
  [[nodiscard]] Corner corner(const Choice& choice) const {
    return quick::corner(*this, choice.pair);
  }
  [[nodiscard]] Choice farthest_against(const Two& d) const {
    return {pair_of({x.farthest(d), y.farthest(-d)})};
  }
  [[nodiscard]] Corner support_against(const Two& d) const { return corner(farthest_against(d)); }
  [[nodiscard]] Corner support_across(const Two& edge, const Two& sign) const {
    return support_against(with_sign(-perpendicular(edge), sign));
  }
  [[nodiscard]] bool are_alone(const Two& d, VertexPair a, VertexPair b, double error) const {
    return x.count_as_far(-d, a.x, b.x, error) * y.count_as_far(d, a.y, b.y, error) ==
           (a == b ? 1 : 2);
  }
};

/// The best support plane so far; see State.
struct Plane {
  double distance_sq = 0.0;
  double reach_sq = 0.0;

  /// The plane through w.
  void note(double offered_sq, const Two& w) {
    if (!(distance_sq < offered_sq)) return;
    distance_sq = offered_sq;
    reach_sq = dot(w, w);
  }
  /// The same, where dot(away, w) is `value`: `away` leads away from O, d_sq is dot(away, away).
  void note(double value, double d_sq, const Two& w) {
    const double above = 0.0 < value ? value : 0.0;
    note(above * (above / d_sq), w);
  }
};

/// Where a run ended: at a vertex, between two, or in a triangle.
template <int N>
struct Found {
  std::array<Corner, N> corners;
  std::array<double, N> weights;
  Plane plane;
  int iterations = 0;
  StopReason stop = StopReason::running;
  double least_area = 0.0;  ///< Of the triangles that O makes with two vertices, doubled.

  [[nodiscard]] VertexPair pair(int i) const { return indices(corners[i].pair); }
};

/// The vertex where the walk begins.
template <class Shapes>
[[nodiscard]] inline Corner start(const Shapes& shapes, const Options& options) {
  if (options.start_count == 0) return shapes.support_against(shapes.offset);
  return corner(shapes, pair_of(options.start[0]));
}

/// The phases in their order, from vertex `a`: `answer` of where they end, or false where rounding
/// leaves something to be decided that ordinary queries do not come to.
template <class Shapes, class Answer>
[[nodiscard, gnu::flatten]] inline bool walk(const Shapes& shapes, const Options& options, Corner a,
                                             const Answer& answer) {
  double best_sq = std::numeric_limits<double>::infinity();
  const auto comes_nearer = [&](double p_sq) {
    const bool nearer = 0.0 < p_sq && p_sq < best_sq;
    best_sq = p_sq;
    return nearer;
  };
  Plane plane;
  int iteration = 1;
  const auto at_vertex = [&](StopReason stop) {
    return answer(Found<1>{{a}, {1.0}, plane, iteration, stop});
  };
  for (;; ++iteration) {  // P is a.
    const double a_sq = dot(a.w, a.w);
    if (!comes_nearer(a_sq)) [[unlikely]]
      return false;
    const auto farthest = shapes.farthest_against(a.w);
    if (farthest.pair == a.pair) {
      plane.note(a_sq, a.w);
      return at_vertex(StopReason::repeated_support);
    }
    Corner b = shapes.corner(farthest);
    const double along_a = dot(a.w, b.w);
    plane.note(along_a, a_sq, b.w);
    if (!(along_a < a_sq)) return at_vertex(StopReason::no_progress);
    if (options.iteration_cap <= iteration) [[unlikely]]
      return false;
    const Two ab = b.w - a.w;
    const Two in_ab = dots(b.w, ab, -a.w, ab);
    if (!(0.0 < in_ab[0])) {
      a = b;
      continue;
    }
    if (!(0.0 < in_ab[1])) [[unlikely]]
      return false;
    for (++iteration;; ++iteration) {  // P is between a and b.
      const Two edge = b.w - a.w;
      const double a_cross_b = cross(a.w, b.w);
      const double d_sq = dot(edge, edge);
      // P is on the line of the edge, so p_sq is the square of the line's distance.
      if (!comes_nearer(a_cross_b * (a_cross_b / d_sq))) [[unlikely]]
        return false;
      const Two side = signed_zeros_of_cross(edge, a.w);
      const Corner c = shapes.support_across(edge, side);
      const Two away = with_sign(-perpendicular(edge), side);
      const double value = dot(away, c.w);
      plane.note(value, d_sq, c.w);
      const bool repeated = c.pair == b.pair || c.pair == a.pair;
      const auto is_no_farther = [&] {
        const Two before = dots(away, a.w, away, b.w);
        return !(value < before[0] && value < before[1]);
      };
      if (repeated || is_no_farther()) {
        const Two weights = dots(b.w, edge, -a.w, edge) / both(d_sq);
        return answer(Found<2>{{a, b},
                               {weights[0], weights[1]},
                               plane,
                               iteration,
                               repeated ? StopReason::repeated_support : StopReason::no_progress});
      }
      if (options.iteration_cap <= iteration) [[unlikely]]
        return false;
      // O is in the region of neither a nor b: they were kept by the cull before.
      const Two ac = c.w - a.w;
      const Two bc = c.w - b.w;
      const Two in_ac = dots(c.w, ac, -a.w, ac);
      const Two in_bc = dots(c.w, bc, -b.w, bc);
      const double volume = cross(edge, ac);
      if (volume == 0.0) [[unlikely]]
        return false;
      const double sign = gjk::sign_of(volume);
      // Areas of triangles that O makes with the other two vertices, doubled.
      const double of_a = sign * cross(b.w, c.w);
      const double of_b = sign * -cross(a.w, c.w);
      const double of_c = sign * a_cross_b;
      if (!(0.0 < in_ac[0]) && !(0.0 < in_bc[0])) {
        a = c;
        break;
      }
      if (!(0.0 < of_c)) continue;
      if (0.0 < in_bc[0] && 0.0 < in_bc[1] && !(0.0 < of_a)) {
        a = b;
        b = c;
      } else if (0.0 < in_ac[0] && 0.0 < in_ac[1] && !(0.0 < of_b)) {
        b = c;
      } else if (0.0 < of_a && 0.0 < of_b) {
        const double sum = of_a + of_b + of_c;
        return answer(Found<3>{{a, b, c},
                               {of_a / sum, of_b / sum, of_c / sum},
                               plane,
                               iteration + 1,
                               StopReason::origin_inside,
                               gjk::smaller(gjk::smaller(of_a, of_b), of_c)});
      } else {
        return false;
      }
    }
  }
}

/// What detail::bounds_outside asks.
template <class S, class Shapes, int N>
struct Asked {
  const Found<N>& simplex;
  const Shapes& shapes;
  const Query<S, 2>& query;
  const Prepared<double, 2>& prepared;

  [[nodiscard]] double corner_reach_sq() const {
    const auto& [x0, x1] = query.x.vertices.far_apart();
    const auto& [y0, y1] = query.y.vertices.far_apart();
    const auto reach_sq = [&](int i, int j) {
      const Two w = shapes.vertex(i, j);
      return dot(w, w);
    };
    return gjk::larger(gjk::larger(reach_sq(x0, y0), reach_sq(x1, y1)),
                       gjk::larger(reach_sq(x0, y1), reach_sq(x1, y0)));
  }
  [[nodiscard]] double careful_distance() const {
    return careful_distance_of(query, simplex.pair(0), simplex.pair(N - 1), N == 2);
  }
  [[nodiscard]] bool is_certainly_farthest(const Flat<double>& direction, double length,
                                           double angle) const {
    const Two d{direction.x, direction.y};
    const double error = length * prepared.scan_error_within(angle);
    return shapes.are_alone(d, simplex.pair(0), simplex.pair(N - 1), error);
  }

 private:
  [[nodiscard, gnu::noinline, gnu::flatten]] static double careful_distance_of(
      const Query<S, 2>& query, VertexPair a, VertexPair b, bool on_edge) {
    return have_few_digits(query) ? careful_distance_with<true>(query, a, b, on_edge)
                                  : careful_distance_with<false>(query, a, b, on_edge);
  }
  /// By what detail::careful_edge says, both coordinates at once. kFewDigits: products need no
  /// care.
  template <bool kFewDigits>
  [[nodiscard]] static double careful_distance_with(const Query<S, 2>& query, VertexPair a,
                                                    VertexPair b, bool on_edge) {
    using Sum = detail::CarefulSum<Two, double>;
    const auto length_of = [](const Two& v) {
      const double square = dot(v, v);
      if (ScalarTraits<double>::is_in_range(square)) [[likely]]
        return ScalarTraits<double>::root(square);
      return careful_length(Vec<double, 2>(v[0], v[1]));
    };
    const auto add = [](Sum& sum, const Shape<S, 2>& shape, int vertex, double sign) {
      const Two local = both(sign) * two(shape.vertices[vertex]);
      if (!shape.pose.rotation.turns()) return sum.add(local);
      for (int k = 0; k < 2; ++k) {
        const Two column = two<S>(shape.pose.rotation.col(k));
        if constexpr (kFewDigits) {
          sum.add(column * both(local[k]));
        } else {
          sum.add_product(column, both(local[k]));
        }
      }
    };
    const bool x_moves = a.y == b.y;
    const Shape<S, 2>& still = x_moves ? query.y : query.x;
    const Shape<S, 2>& moving = x_moves ? query.x : query.y;
    const double sign = x_moves ? -1.0 : 1.0;
    const int moving_a = x_moves ? a.x : a.y;
    const int moving_b = x_moves ? b.x : b.y;
    Sum from(two(query.y.pose.translation));
    from.add(both(-1.0) * two(query.x.pose.translation));
    add(from, still, x_moves ? a.y : a.x, -sign);
    add(from, moving, moving_a, sign);
    if (!on_edge) return length_of(normalised(from.sum()).hi);
    Sum way(both(0.0));
    // One comparison, for nobody foresees of which shape an edge is.
    if ((static_cast<unsigned>(a.x != b.x) & static_cast<unsigned>(a.y != b.y)) != 0)
        [[unlikely]] {  // `still` is X
      add(way, still, b.x, -sign);
      add(way, still, a.x, sign);
    }
    add(way, moving, moving_b, sign);
    add(way, moving, moving_a, -sign);
    const DoubleWord<Two> along = normalised(way.sum());
    return rounded_cross(from.sum(), along) / length_of(along.hi);
  }
  /// As detail::rounded_cross, both products at once.
  [[nodiscard]] static double rounded_cross(const DoubleWord<Two>& a, const DoubleWord<Two>& b) {
    const DoubleWord<Two> product = exact_product<Two, double>(a.hi, swapped(b.hi));
    const Two rest = product.lo + (a.hi * swapped(b.lo) + a.lo * swapped(b.hi));
    const DoubleWord<double> difference = exact_sum<double>(product.hi[0], -product.hi[1]);
    return difference.hi + (difference.lo + (rest[0] - rest[1]));
  }
  [[nodiscard]] static bool have_few_digits(const Query<S, 2>& query) {
    return std::is_same_v<S, float> ||
           (!detail::has_trait(query, Points<S, 2>::kManyDigits) &&
            query.x.pose.rotation.has_few_digits() && query.y.pose.rotation.has_few_digits());
  }
};

/// As detail::surely_inside, and what the phases ask of a triangle and its weights.
[[nodiscard]] inline bool is_surely_inside(const Found<3>& simplex,
                                           const Prepared<double, 2>& prepared) {
  const auto norm_max = [](const Two& v) { return larger(v, swapped(v))[0]; };
  const auto& [a, b, c] = simplex.corners;
  const auto& weights = simplex.weights;
  const double size = norm_max(larger(larger(magnitudes(a.w), magnitudes(b.w)), magnitudes(c.w)));
  const Two p = (both(weights[0]) * a.w + both(weights[1]) * b.w) + both(weights[2]) * c.w;
  return detail::volume_error(size, prepared) < simplex.least_area &&
         !(2.0 * ScalarTraits<double>::unit_roundoff() * size < norm_max(magnitudes(p)));
}

/// How witness points are put together, as detail::set_witness_points does: from the vertices of
/// the largest weight, and shares of the ways to the others.
template <int N>
struct Mixture {
  std::array<Pair, N> pairs;  ///< That of the largest weight first.
  std::array<double, N> shares;

  explicit Mixture(const Found<N>& found) {
    const auto& weights = found.weights;
    const auto& corners = found.corners;
    const auto start_at = [&](auto... order) {
      int k = 0;
      ((pairs[k] = corners[order].pair, shares[k] = weights[order], ++k), ...);
    };
    if constexpr (N == 1) {
      pairs[0] = corners[0].pair;
    } else if constexpr (N == 2) {
      const Pair swap = (corners[0].pair ^ corners[1].pair) & -Pair{weights[0] < weights[1]};
      pairs[0] = corners[0].pair ^ swap;
      pairs[1] = corners[1].pair ^ swap;
      shares[1] = gjk::smaller(weights[0], weights[1]);
    } else {
      if (std::max(weights[0], weights[1]) < weights[2]) {
        start_at(2, 0, 1);
      } else if (weights[0] < weights[1]) {
        start_at(1, 0, 2);
      } else {
        start_at(0, 1, 2);
      }
    }
  }
};

/// Of the vertices that `index` picks from a pair.
template <class S, int N, class Index>
[[nodiscard]] Two witness(const Mixture<N>& mixture, const Shape<S, 2>& shape,
                          const Prepared<double, 2>& prepared, const Index& index) {
  const auto vertex = [&](int i) { return two(shape.vertices[index(mixture.pairs[i])]); };
  const Two from = vertex(0);
  Two beyond{0.0, 0.0};
  for (int i = 1; i < N; ++i) {
    const Two part = (vertex(i) - from) * both(mixture.shares[i]);
    beyond = i == 1 ? part : beyond + part;
  }
  if (shape.pose.rotation.turns() && prepared.centred) {
    const Vec<double, 2> place =
        detail::careful_place<double>(shape.pose, Vec<double, 2>(from[0], from[1]),
                                      Vec<double, 2>(beyond[0], beyond[1]), prepared.exponent);
    return Two{place[0], place[1]};
  }
  const Two local = N == 1 ? from : from + beyond;
  return Turn<S>(shape.pose.rotation)(local) + two(shape.pose.translation);
}

/// Fills in the answer. False when it is not proved, or came from a place that is not ordinary.
template <class Shapes, class S>
[[nodiscard, gnu::flatten]] inline bool distance_between(const Query<S, 2>& query,
                                                         const Options& options,
                                                         Result<double, 2>& out) {
  Prepared<double, 2> prepared = detail::placed<double>(query, 0);
  const Shapes shapes(query, prepared);
  const Corner first = start(shapes, options);
  // Measured here, while the processor waits for the first vertex.
  detail::measure(query, prepared);
  if (!ScalarTraits<double>::is_in_range(prepared.reach)) [[unlikely]]
    return false;

  const auto fill = [&]<int N>(const Found<N>& found) {
    out.stop = found.stop;
    out.iterations = found.iterations;
    out.simplex.count = N;
    const auto keep = [&](int i) {
      out.simplex.vertices[i].w[0] = found.corners[i].w[0];
      out.simplex.vertices[i].w[1] = found.corners[i].w[1];
      out.simplex.vertices[i].pair = found.pair(i);
      out.simplex.weights[i] = found.weights[i];
    };
    keep(0);  // One by one: a loop would keep `found` in memory.
    if constexpr (N > 1) keep(1);
    if constexpr (N > 2) keep(2);
    const Mixture<N> mixture(found);
    Two x = witness(mixture, query.x, prepared, index_x);
    Two y = witness(mixture, query.y, prepared, index_y);
    if constexpr (N == 3) detail::join(x, y, out.simplex);
    out.x[0] = x[0];
    out.x[1] = x[1];
    out.y[0] = y[0];
    out.y[1] = y[1];
    return true;
  };
  const auto answer = [&]<int N>(const Found<N>& found) {
    if constexpr (N == 3) {
      if (!is_surely_inside(found, prepared)) [[unlikely]]
        return false;
      out.verdict = Verdict::overlapping;
      out.distance = 0.0;
      out.lower = 0.0;
      out.upper = 0.0;
    } else {
      const detail::Feature<double> feature{flat(found.corners[0].w),
                                            flat(found.corners[N - 1].w),
                                            N == 2,
                                            gjk::smaller(found.weights[0], found.weights[N - 1]),
                                            found.plane.distance_sq,
                                            found.plane.reach_sq};
      const detail::Bounds<double> bounds = detail::bounds_outside(
          feature, prepared, Asked<S, Shapes, N>{found, shapes, query, prepared});
      if (!(0.0 < bounds.lower) || !bounds.tight) [[unlikely]]
        return false;
      out.verdict = Verdict::separated;
      out.distance = bounds.distance;
      out.lower = bounds.lower;
      out.upper = bounds.upper;
      out.distance_sq = bounds.distance * bounds.distance;
    }
    return fill(found);
  };
  return walk(shapes, options, first, answer);
}

template <class S>
[[nodiscard, gnu::noinline]] bool distance_of_large(const Query<S, 2>& query,
                                                    const Options& options,
                                                    Result<double, 2>& out) {
  return distance_between<AnyShapes<S>>(query, options, out);
}

/// True when the query may go this way: nothing wrong with it, the default rules, and no shape so
/// large that climbing beats scanning.
template <class S>
[[nodiscard]] bool is_ordinary(const Query<S, 2>& query, const Options& options) {
  return detail::first_wrong(query, options) == Error::none &&
         !detail::has_trait(query, Points<S, 2>::kRing) && options.start_count <= 1 &&
         options.direction_rule == DirectionRule::perpendicular &&
         options.region_order == RegionOrder::vertices_first && options.stop_on_repeated_support &&
         options.stop_on_no_progress && options.tolerance == 0.0;
}

/// Fills in the answer of an ordinary query; else false.
template <class S>
[[nodiscard, gnu::flatten]] inline bool distance(const Query<S, 2>& query, const Options& options,
                                                 Result<double, 2>& out) {
  if (!is_ordinary(query, options)) [[unlikely]]
    return false;
  if (detail::has_trait(query, Points<S, 2>::kLarge)) return distance_of_large(query, options, out);
  if (detail::has_trait(query, Points<S, 2>::kMoreThanFour)) {
    return distance_between<SmallShapes<S, Rows::kCount>>(query, options, out);
  }
  return distance_between<SmallShapes<S, 4>>(query, options, out);
}

}  // namespace gjk::quick
