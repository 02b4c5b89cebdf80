#pragma once
// The GJK distance algorithm: a loop over phases (Catto 2010, slide "GJK algorithm"; Gilbert,
// Johnson, Keerthi 1988).
//
//   pick an initial simplex S
//   loop
//     closest    compute the closest point P on S
//     cull       drop the vertices that do not contribute to P
//     direction  build d, pointing from P to O
//     support    find the support point of Z = Y - X in direction d
//     stop       decide whether the answer is found
//     add        add the support point to S
//
// `step` runs one phase, `distance` all of them, `trace` all of them while keeping every state. All
// three call the same functions, which decide from the state alone: recording cannot change a
// decision.

#include <algorithm>

#include "gjk/closest_point.hpp"
#include "gjk/direction.hpp"
#include "gjk/stop.hpp"
#include "gjk/support.hpp"

namespace gjk {

/// What the run came to. `separated` is proved. Distance 0 is proved when `upper` is 0, too; else
/// it is what was computed, and `upper` says by how much rounding may deceive.
enum class Verdict : std::uint8_t {
  separated,    ///< A plane separates the shapes: lower > 0.
  touching,     ///< Distance 0, and the run met a plane through O that has all of Z on one side.
  overlapping,  ///< Distance 0, and the run met no such plane (it does not search for one).
  undecided,    ///< lower = 0 < distance: rounding, or the iteration cap, leaves the question open.
  none,         ///< The query was refused.
};

/// The answer, with its certificate: lower <= exact distance <= upper, rounding included.
template <class S, int D>
struct Result {
  using Real = typename ScalarTraits<S>::Real;
  Error error = Error::none;
  StopReason stop = StopReason::running;
  Verdict verdict = Verdict::none;
  Real distance = ScalarTraits<S>::no_length();
  Real lower = ScalarTraits<S>::no_length();
  Real upper = ScalarTraits<S>::no_length();
  S distance_sq = S(0);
  Vec<S, D> x = Vec<S, D>::Zero();  ///< Witness point on X, world coordinates.
  Vec<S, D> y = Vec<S, D>::Zero();  ///< Witness point on Y.
  int iterations = 0;
  Simplex<S, D> simplex;  ///< The simplex whose weights made the witness points; its pairs
                          ///< warm-start the next query.
};

/// One phase that ran: what it left, and what it noted.
template <class S, int D>
struct Step {
  Phase phase = Phase::closest;
  int iteration = 1;
  State<S, D> after;
  Record<S, D> record;
};

/// A whole run. `steps` is complete for every outcome and empty only when the query was refused at
/// once.
template <class S, int D>
struct Trace {
  State<S, D> initial;
  std::vector<Step<S, D>> steps;
  Result<S, D> result;
};

namespace detail {

template <class S, int D>
[[nodiscard]] bool is_finite(const Shape<S, D>& shape) {
  for (const Vec<S, D>& vertex : shape.vertices) {
    if (!gjk::is_finite(vertex)) return false;
  }
  for (int i = 0; i < D; ++i) {
    if (!gjk::is_finite<S, D>(shape.pose.rotation.col(i))) return false;
  }
  return gjk::is_finite(shape.pose.translation);
}

/// A bound on the magnitudes of the coordinates of the shape, turned as its pose turns it, not yet
/// moved.
template <class S, int D>
[[nodiscard]] S extent(const Shape<S, D>& shape) {
  S largest(0);
  for (const Vec<S, D>& vertex : shape.vertices) {
    const S size = norm_max(vertex);
    if (largest < size) largest = size;
  }
  S turn(0);
  for (int i = 0; i < D; ++i) {
    const S row = norm_1<S, D>(shape.pose.rotation.row(i).transpose());
    if (turn < row) turn = row;
  }
  return largest * turn;
}

[[nodiscard]] inline bool bad_start(const Options& options, int x_count, int y_count,
                                    int dimension) {
  if (options.start_rule != StartRule::given) return false;
  if (options.start_count < 1 || options.start_count > dimension + 1) return true;
  return std::any_of(options.start.begin(), options.start.begin() + options.start_count,
                     [&](const VertexPair& pair) {
                       return pair.x < 0 || pair.x >= x_count || pair.y < 0 || pair.y >= y_count;
                     });
}

template <class S, int D>
[[nodiscard]] Vec<S, D> centre(const Shape<S, D>& shape) {
  Vec<S, D> sum = Vec<S, D>::Zero();
  for (const Vec<S, D>& vertex : shape.vertices) sum = sum + vertex;
  return shape.pose.rotated(sum / S(static_cast<int>(shape.vertices.size()))) +
         shape.pose.translation;
}

/// True when every weight of the full simplex around O is positive beyond doubt: a determinant of
/// coordinates below 2 * scale errs by less than 4 D D! (2 scale)^D u.
template <class S, int D>
[[nodiscard]] bool surely_inside(const Simplex<S, D>& simplex, const Prepared<S>& prepared) {
  const Barycentric<S, D> coordinates = barycentric(simplex, simplex.all());
  S error = S(4 * D) * ScalarTraits<S>::unit_roundoff();
  for (int i = 1; i <= D; ++i) error = error * S(2 * i) * prepared.scale;
  error = error + S(kRoundings<D>) * ScalarTraits<S>::smallest();
  for (int i = 0; i <= D; ++i) {
    if (!(error < coordinates.numerator[i])) return false;
  }
  return true;
}

}  // namespace detail

/// Checks the query and measures it. Refuses what cannot be answered with a number one may trust.
template <class S, int D>
[[nodiscard]] Prepared<S> prepare(const Query<S, D>& query, const Options& options) {
  const auto refuse = [](Error error) { return Prepared<S>{S(0), error}; };
  if (query.x.vertices.empty()) return refuse(Error::x_has_no_vertices);
  if (query.y.vertices.empty()) return refuse(Error::y_has_no_vertices);
  if (!detail::is_finite(query.x)) return refuse(Error::x_not_finite);
  if (!detail::is_finite(query.y)) return refuse(Error::y_not_finite);
  if (options.iteration_cap < 1 || !(options.tolerance >= 0.0 && options.tolerance < 1.0))
    return refuse(Error::bad_options);
  if (detail::bad_start(options, static_cast<int>(query.x.vertices.size()),
                        static_cast<int>(query.y.vertices.size()), D)) {
    return refuse(Error::bad_start);
  }
  const Vec<S, D> offset = query.y.pose.translation - query.x.pose.translation;
  const S scale = detail::extent(query.x) + detail::extent(query.y) + norm_max(offset);
  // World coordinates of the witness points, and sums of 2 D products of coordinate differences,
  // must be finite.
  const S world = scale + norm_max(query.x.pose.translation) + norm_max(query.y.pose.translation);
  const S products = S(8 * D) * scale * scale;
  if (!ScalarTraits<S>::is_finite(world) || !ScalarTraits<S>::is_finite(products))
    return refuse(Error::overflow);
  if (S(0) < scale && ScalarTraits<S>::loses_products(scale)) return refuse(Error::underflow);
  return {scale, Error::none};
}

/// The state before the first phase.
template <class S, int D>
[[nodiscard]] State<S, D> start(const Query<S, D>& query, const Options& options,
                                const Prepared<S>& prepared) {
  State<S, D> state;
  state.error = prepared.error;
  if (prepared.error != Error::none) {
    state.stop = StopReason::failed;
    state.phase = Phase::stop;
    return state;
  }
  if (options.start_rule == StartRule::centre_to_centre) {
    state.d = detail::centre(query.x) - detail::centre(query.y);
    NoRecord none;
    detail::find_support(state, query, prepared, none);
    state.simplex.vertices[state.simplex.count++] = state.support;
    const Error error = state.error;
    const SupportPoint<S, D> first = state.support;
    state = State<S, D>{};
    state.error = error;
    state.simplex.vertices[0] = first;
    state.simplex.count = 1;
    if (error != Error::none) state.stop = StopReason::failed;
  } else {
    for (int i = 0; i < options.start_count; ++i) {
      state.simplex.vertices[i] = detail::support_point(query, options.start[i]);
    }
    state.simplex.count = options.start_count;
  }
  state.region = state.simplex.all();
  return state;
}

/// Runs the phase `state.phase`. The run goes on while `state.stop` is StopReason::running.
template <class S, int D, class Rec>
void step(State<S, D>& state, const Query<S, D>& query, const Options& options,
          const Prepared<S>& prepared, Rec& record) {
  switch (state.phase) {
    case Phase::closest:
      detail::find_closest_point(state, options, record);
      break;
    case Phase::cull:
      detail::cull(state, options, record);
      break;
    case Phase::direction:
      detail::build_direction(state, options, record);
      break;
    case Phase::support:
      detail::find_support(state, query, prepared, record);
      break;
    case Phase::stop:
      detail::run_stop_tests(state, options, record);
      break;
    case Phase::add:
      detail::add_support(state);
      break;
  }
  if (state.error != Error::none) state.stop = StopReason::failed;
}

/// Reads the answer from a state; before the run has ended, the best answer so far.
template <class S, int D>
[[nodiscard]] Result<S, D> result(const State<S, D>& state, const Prepared<S>& prepared) {
  using Traits = ScalarTraits<S>;
  Result<S, D> out;
  out.error = state.error;
  out.stop = state.stop;
  out.iterations = state.iteration;
  if (state.error != Error::none || state.best.count == 0) {
    out.iterations = 0;
    return out;
  }
  out.simplex = state.best;
  for (int i = 0; i < out.simplex.count; ++i) {
    const SupportPoint<S, D>& vertex = out.simplex.vertices[i];
    for (int k = 0; k < D; ++k) {
      out.x[k] = out.x[k] + S(out.simplex.weights[i] * vertex.x[k]);
      out.y[k] = out.y[k] + S(out.simplex.weights[i] * vertex.y[k]);
    }
  }
  out.distance_sq = state.best_sq;
  const S rounding = S(detail::kRoundings<D>) * Traits::unit_roundoff() * prepared.scale;
  const bool inside = state.best.count == D + 1 && detail::surely_inside(state.best, prepared);
  out.upper = inside ? Traits::root(S(0))
                     : Traits::root_above(state.best_sq) + Traits::root(rounding * rounding);
  out.lower = Traits::root_below(state.plane_distance_sq);
  out.distance = std::max(out.lower, Traits::root(state.best_sq));
  if (S(0) < state.plane_distance_sq) {
    out.verdict = Verdict::separated;
  } else if (state.best_sq == S(0)) {
    const bool boundary = state.touches_plane && state.best.count <= D;
    out.verdict = boundary ? Verdict::touching : Verdict::overlapping;
  } else {
    out.verdict = Verdict::undecided;
  }
  return out;
}

/// Distance between two convex shapes. Does not allocate.
template <class S, int D>
[[nodiscard]] Result<S, D> distance(const Query<S, D>& query, const Options& options = {}) {
  const Prepared<S> prepared = prepare(query, options);
  State<S, D> state = start(query, options, prepared);
  NoRecord none;
  while (state.stop == StopReason::running) step(state, query, options, prepared, none);
  return result(state, prepared);
}

/// The same run, every phase recorded.
template <class S, int D>
[[nodiscard]] Trace<S, D> trace(const Query<S, D>& query, const Options& options = {}) {
  const Prepared<S> prepared = prepare(query, options);
  Trace<S, D> out;
  State<S, D> state = start(query, options, prepared);
  out.initial = state;
  while (state.stop == StopReason::running) {
    Step<S, D> next;
    next.phase = state.phase;
    next.iteration = state.iteration;
    step(state, query, options, prepared, next.record);
    next.after = state;
    out.steps.push_back(std::move(next));
  }
  out.result = result(state, prepared);
  return out;
}

}  // namespace gjk
