#pragma once
// The ordinary query in the plane: the run that the phases make, kept in registers.
//
// The decisions are those of the phases, taken in the same order from the same operations, so the
// answer has the same bits; tests/truth/properties_test.cpp holds `distance`, which comes this way,
// to `trace`, which does not. Missing is what ordinary queries do not need: a run that comes to
// such a place gives up, and the phases start over.

#include "gjk/certificate.hpp"
#include "gjk/stop.hpp"

namespace gjk::quick {

/// Two numbers side by side, for processors that compute with both at once.
using Two [[gnu::vector_size(16)]] = double;
using TwoMasks [[gnu::vector_size(16)]] = long long;

/// Bit i is set when the comparison that made the masks holds for number i.
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
[[nodiscard]] inline int farthest(int count, const Flat<double>& d, const VertexAt& vertex) {
  double most = 0.0;
  const auto first_of = [&](int i, int j, int k, int l) {
    const auto along = [&](const Flat<double>& a, const Flat<double>& b) {
      return Two{d.x, d.x} * Two{a.x, b.x} + Two{d.y, d.y} * Two{a.y, b.y};
    };
    const Two left = along(vertex(i), vertex(j));
    const Two right = along(vertex(k), vertex(l));
    const Two larger = left < right ? right : left;
    most = larger[0] < larger[1] ? larger[1] : larger[0];
    const Two all = {most, most};
    return i + __builtin_ctz(bits(left == all) | bits(right == all) << 2);
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

/// A shape, its vertices seen from its centre.
template <class S>
struct Body {
  const Vec<S, 2>* vertices;
  const S* rotation;  ///< Column by column.
  Flat<double> centre;
  int count;
  bool turned;
  bool centred;

  Body(const Shape<S, 2>& shape, bool is_turned, bool is_centred, const Vec<double, 2>& middle)
      : vertices(&shape.vertices[0]),
        rotation(shape.pose.rotation.data()),
        centre(flat(middle)),
        count(static_cast<int>(shape.vertices.size())),
        turned(is_turned),
        centred(is_centred) {}

  [[nodiscard]] Flat<double> vertex(int i) const {
    return {static_cast<double>(vertices[i][0]), static_cast<double>(vertices[i][1])};
  }
  [[nodiscard]] Flat<double> from_centre(int i) const {
    return centred ? vertex(i) - centre : vertex(i);
  }
  [[nodiscard]] Flat<double> rotated(const Flat<double>& a) const {
    if (!turned) return a;
    return {rotation[0] * a.x + rotation[2] * a.y, rotation[1] * a.x + rotation[3] * a.y};
  }
  [[nodiscard]] Flat<double> placed(int i) const { return rotated(from_centre(i)); }

  /// Of a direction in the world, the first vertex that lies farthest along it.
  [[nodiscard]] int farthest(const Flat<double>& d) const {
    const Flat<double> local = to_local(d);
    if (centred) return quick::farthest(count, local, [&](int i) { return vertex(i) - centre; });
    return quick::farthest(count, local, [&](int i) { return vertex(i); });
  }
  [[nodiscard]] int count_as_far(const Flat<double>& d, int i, int j, double error) const {
    const Flat<double> local = to_local(d);
    return detail::count_as_far<double>(
        count, [&](int k) { return dot(local, from_centre(k)); }, i, j, error);
  }

 private:
  [[nodiscard]] Flat<double> to_local(const Flat<double>& d) const {
    if (!turned) return d;
    return {rotation[0] * d.x + rotation[1] * d.y, rotation[2] * d.x + rotation[3] * d.y};
  }
};

/// A vertex of the simplex.
struct Corner {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  Flat<double> w;
  VertexPair pair;
};

/// Both, and the offset between their centres.
template <class S>
struct Bodies {
  Body<S> x;
  Body<S> y;
  Flat<double> offset;

  Bodies(const Query<S, 2>& query, const Prepared<double, 2>& prepared)
      : x(query.x, prepared.x_turned, prepared.centred, prepared.x_centre),
        y(query.y, prepared.y_turned, prepared.centred, prepared.y_centre),
        offset(flat(prepared.offset)) {}

  [[nodiscard]] VertexPair farthest(const Flat<double>& d) const {
    return {x.farthest(-d), y.farthest(d)};
  }
  [[nodiscard]] Corner corner(VertexPair pair) const {
    return {(y.placed(pair.y) - x.placed(pair.x)) + offset, pair};
  }
};

/// Where a run ended: at vertex a, between a and b, or in the triangle.
struct Found {  // NOLINT(cppcoreguidelines-pro-type-member-init): zeros take time
  Corner a;
  Corner b;
  Corner c;
  int count;
  double weight_a;
  double weight_b;
  double weight_c;
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
      options.start_count == 0 ? bodies.farthest(-bodies.offset) : options.start[0];
  Corner a = bodies.corner(first);
  Corner b = a;
  bool on_edge = false;  // else P is a
  double weight_a = 1.0;
  double weight_b = 0.0;
  double plane_sq = 0.0;
  double plane_reach_sq = 0.0;
  double best_sq = std::numeric_limits<double>::infinity();
  int iteration = 1;
  const auto end = [&](StopReason reason) {
    found.a = a;
    found.b = b;
    found.c = b;
    found.count = on_edge ? 2 : 1;
    found.weight_a = weight_a;
    found.weight_b = weight_b;
    found.weight_c = 0.0;
    found.plane_sq = plane_sq;
    found.plane_reach_sq = plane_reach_sq;
    found.iterations = iteration;
    found.stop = reason;
    return true;
  };
  for (;; ++iteration) {
    // Direction.
    Flat<double> p = a.w;
    Flat<double> d = -a.w;
    if (on_edge) {
      const Flat<double> edge = b.w - a.w;
      const double edge_sq = dot(edge, edge);
      weight_a = dot(b.w, edge) / edge_sq;
      weight_b = -dot(a.w, edge) / edge_sq;
      p = {weight_a * a.w.x + weight_b * b.w.x, weight_a * a.w.y + weight_b * b.w.y};
      const Flat<double> normal{edge.y, -edge.x};
      const double side = std::copysign(1.0, 0.0 - dot(normal, a.w));
      d = {side * normal.x, side * normal.y};
      if (cross(a.w, b.w) == 0.0) return false;
    }
    const double p_sq = dot(p, p);
    const double d_sq = dot(d, d);
    if (!(p_sq < best_sq) || d_sq == 0.0) return false;
    best_sq = p_sq;

    // Support and stop. A vertex that is in the simplex already need not be put together again.
    const VertexPair pair = bodies.farthest(d);
    const auto note_plane = [&](const Flat<double>& w) {
      const double value = dot(d, w);
      const double below = value < 0.0 ? value : 0.0;
      const double distance_sq = below * (below / d_sq);
      if (plane_sq < distance_sq) {
        plane_sq = distance_sq;
        plane_reach_sq = dot(w, w);
      }
      return value;
    };
    if (pair == a.pair) {
      note_plane(a.w);
      return end(StopReason::repeated_support);
    }
    if (pair == b.pair) {
      note_plane(b.w);
      return end(StopReason::repeated_support);
    }
    const Corner c = bodies.corner(pair);
    const double value = note_plane(c.w);
    const double along_a = dot(d, a.w);
    const double along_b = dot(d, b.w);
    if (!((along_a < along_b ? along_b : along_a) < value)) return end(StopReason::no_progress);
    if (options.iteration_cap <= iteration) return false;

    // Closest and cull.
    const Flat<double> ac = c.w - a.w;
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
    const Flat<double> bc = c.w - b.w;
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
      weight_a = 1.0;
      weight_b = 0.0;
    } else if (!(0.0 < of_c)) {
      continue;
    } else if (b_in_bc && c_in_bc && !(0.0 < of_a)) {
      a = b;
      b = c;
    } else if (a_in_ac && c_in_ac && !(0.0 < of_b)) {
      b = c;
    } else {
      const double sum = of_a + of_b + of_c;
      weight_a = of_a / sum;
      weight_b = of_b / sum;
      ++iteration;
      static_cast<void>(end(StopReason::origin_inside));
      found.c = c;
      found.count = 3;
      found.weight_c = of_c / sum;
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
    const Flat<double> from = bodies.x.placed(x0);
    const Flat<double> from_other = bodies.x.placed(x1);
    const Flat<double> to = bodies.y.placed(y0);
    const Flat<double> to_other = bodies.y.placed(y1);
    const auto length_sq = [&](const Flat<double>& difference) {
      const Flat<double> w = difference + bodies.offset;
      return dot(w, w);
    };
    return larger(larger(length_sq(to - from), length_sq(to - from_other)),
                  larger(length_sq(to_other - from), length_sq(to_other - from_other)));
  }
  [[nodiscard]] double careful_distance() const {
    return careful_distance_of(query, prepared, simplex.a.pair, simplex.b.pair, simplex.count == 2);
  }
  [[nodiscard]] bool is_certainly_farthest(const Flat<double>& d, double angle) const {
    const bool on_edge = simplex.count == 2;
    const VertexPair first = simplex.a.pair;
    const VertexPair last = on_edge ? simplex.b.pair : first;
    const double error = length(d) * prepared.scan_error_within(angle);
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
    const auto both = [](const Vec<S, 2>& a, double sign) {
      return Two{sign * static_cast<double>(a[0]), sign * static_cast<double>(a[1])};
    };
    const auto add = [&](const Shape<S, 2>& shape, int vertex, bool turned, double sign) {
      const Two local = both(shape.vertices[vertex], sign);
      if (!turned) return sum.add(local);
      for (int k = 0; k < 2; ++k) {
        sum.add_product(both(shape.pose.rotation.col(k), 1.0), Two{local[k], local[k]});
      }
    };
    sum.add(both(query.y.pose.translation, 1.0));
    sum.add(both(query.x.pose.translation, -1.0));
    add(query.y, pair.y, prepared.y_turned, 1.0);
    add(query.x, pair.x, prepared.x_turned, -1.0);
    const DoubleWord<Two> out = sum.normalised();
    return {{out.hi[0], out.lo[0]}, {out.hi[1], out.lo[1]}};
  }
};

/// As detail::surely_inside, and what the phases ask of a triangle and its weights.
[[nodiscard]] inline bool is_surely_inside(const Found& simplex,
                                           const Prepared<double, 2>& prepared) {
  const Flat<double>& a = simplex.a.w;
  const Flat<double>& b = simplex.b.w;
  const Flat<double>& c = simplex.c.w;
  const auto norm_max = [](const Flat<double>& v) {
    return std::max(std::abs(v.x), std::abs(v.y));
  };
  const double size = std::max(std::max(norm_max(a), norm_max(b)), norm_max(c));
  const double error = detail::volume_error(size, prepared);
  const double least =
      std::min(std::min(std::abs(cross(b, c)), std::abs(cross(a, c))), std::abs(cross(a, b)));
  const Flat<double> p{simplex.weight_a * a.x + simplex.weight_b * b.x + simplex.weight_c * c.x,
                       simplex.weight_a * a.y + simplex.weight_b * b.y + simplex.weight_c * c.y};
  return error < least && !(2.0 * ScalarTraits<double>::unit_roundoff() * size < norm_max(p));
}

/// As detail::set_witness_points: put together from the vertex of the largest weight.
template <class S>
[[nodiscard]] Flat<double> witness(const Found& simplex, const Body<S>& body,
                                   const Pose<S, 2>& pose, const Prepared<double, 2>& prepared,
                                   int VertexPair::*index) {
  const double weight_a = simplex.weight_a;
  const double weight_b = simplex.weight_b;
  const double weight_c = simplex.weight_c;
  Flat<double> from = body.vertex(simplex.a.pair.*index);
  Flat<double> beyond{0.0, 0.0};
  if (simplex.count == 2) {
    const Flat<double> b = body.vertex(simplex.b.pair.*index);
    const bool from_b = weight_a < weight_b;
    const double weight = (from_b ? weight_a : weight_b) / (weight_a + weight_b);
    const Flat<double> edge = from_b ? from - b : b - from;
    if (from_b) from = b;
    beyond = {edge.x * weight, edge.y * weight};
  } else if (simplex.count == 3) {
    const Flat<double> a = from;
    const Flat<double> b = body.vertex(simplex.b.pair.*index);
    const Flat<double> c = body.vertex(simplex.c.pair.*index);
    const double sum = weight_a + weight_b + weight_c;
    const auto start_at = [&](const Flat<double>& base, const Flat<double>& p, double p_weight,
                              const Flat<double>& q, double q_weight) {
      const Flat<double> to_p = p - base;
      const Flat<double> to_q = q - base;
      const double s = p_weight / sum;
      const double t = q_weight / sum;
      from = base;
      beyond = {to_p.x * s + to_q.x * t, to_p.y * s + to_q.y * t};
    };
    if (std::max(weight_a, weight_b) < weight_c) {
      start_at(c, a, weight_a, b, weight_b);
    } else if (weight_a < weight_b) {
      start_at(b, a, weight_a, c, weight_c);
    } else {
      start_at(a, b, weight_b, c, weight_c);
    }
  }
  if (body.turned && body.centred) {
    return flat(detail::careful_place<double>(pose, Vec<double, 2>(from.x, from.y),
                                              Vec<double, 2>(beyond.x, beyond.y), prepared));
  }
  const Flat<double> world = body.rotated({from.x + beyond.x, from.y + beyond.y});
  return {world.x + static_cast<double>(pose.translation[0]),
          world.y + static_cast<double>(pose.translation[1])};
}

/// Fills in the answer. False when it is not proved, or came from a place that is not ordinary.
template <class S>
[[nodiscard, gnu::flatten]] bool distance(const Query<S, 2>& query, const Options& options,
                                          const Prepared<double, 2>& prepared,
                                          Result<double, 2>& out) {
  const Bodies<S> bodies(query, prepared);
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
    const detail::Feature<double> feature{
        simplex.a.w,        simplex.b.w,
        simplex.count == 2, std::min(simplex.weight_a, simplex.weight_b),
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
  const auto set = [&](int i, const Corner& corner, double weight) {
    out.simplex.vertices[i].w[0] = corner.w.x;
    out.simplex.vertices[i].w[1] = corner.w.y;
    out.simplex.vertices[i].pair = corner.pair;
    out.simplex.weights[i] = weight;
  };
  set(0, simplex.a, simplex.weight_a);
  if (simplex.count > 1) set(1, simplex.b, simplex.weight_b);
  if (simplex.count > 2) set(2, simplex.c, simplex.weight_c);
  const Flat<double> x = witness(simplex, bodies.x, query.x.pose, prepared, &VertexPair::x);
  const Flat<double> y = witness(simplex, bodies.y, query.y.pose, prepared, &VertexPair::y);
  out.x[0] = x.x;
  out.x[1] = x.y;
  out.y[0] = y.x;
  out.y[1] = y.y;
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
         options.stop_on_no_progress && options.tolerance == 0.0 && !prepared.same_frame &&
         !query.x.vertices.is_ring() && !query.y.vertices.is_ring();
}

}  // namespace gjk::quick
