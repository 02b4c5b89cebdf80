#include "outlines/lin_canny.hpp"

#include "outlines/brute.hpp"

namespace models {
namespace {

const Point& at(const Ring& ring, int i) { return ring.points[i]; }

/// The feature as a segment, of no length for a vertex; outline and index as in the ring.
Segment segment_of(const Ring& ring, const RingFeature& f) {
  return {at(ring, f.index), at(ring, f.is_vertex ? f.index : ring.next(f.index)), 0, f.index};
}

void shrink(RingFeature& feature, Spot spot, const Ring& ring) {
  if (feature.is_vertex || spot == Spot::between) return;
  feature = {true, spot == Spot::end ? ring.next(feature.index) : feature.index};
}

void take_closest(WalkState& state, const WalkQuery& query) {
  state.pair = nearest(segment_of(query.a, state.a), segment_of(query.b, state.b));
  shrink(state.a, state.pair.on_a, query.a);
  shrink(state.b, state.pair.on_b, query.b);
  state.pair = nearest(segment_of(query.a, state.a), segment_of(query.b, state.b));
  state.phase = WalkPhase::regions;
  if (state.pair.meet) state.stop = WalkStop::overlap;
}

/// The sign of dot(edge from a to b, p - a), where p is the closest point of the other feature: a
/// vertex, or the foot of the vertex a on the other's edge. Seen from a the foot lies along the
/// edge's normal, on the side where the edge is.
int toward(const Point& a, const Point& b, const Ring& other, const RingFeature& feature) {
  const Point& q = at(other, feature.index);
  if (feature.is_vertex) return along(a, b, q);
  const Point& r = at(other, other.next(feature.index));
  // dot(b - a, left normal of qr) = cross(qr, b - a); where a lies right of qr, the foot is to the
  // left.
  const int side = turn(q, r, a);
  const int left = dot_sign({-r.y(), r.x()}, {-q.y(), q.x()}, b, a);
  return side < 0 ? left : -left;
}

/// The borders of the region of `own`, until one is crossed.
void look(WalkState& state, const WalkQuery& query, bool of_a, WalkStep& note) {
  const Ring& ring = of_a ? query.a : query.b;
  const Ring& other = of_a ? query.b : query.a;
  const RingFeature own = of_a ? state.a : state.b;
  const RingFeature theirs = of_a ? state.b : state.a;
  const auto test = [&](const RingFeature& neighbour, bool behind, bool crossed) {
    if (state.found.crossed) return;
    note.tests.push_back({of_a, neighbour, behind, crossed});
    if (crossed) state.found = note.tests.back();
  };
  if (own.is_vertex) {
    const int before = ring.previous(own.index);
    const int after = ring.next(own.index);
    const Point& v = at(ring, own.index);
    test({false, own.index}, false, toward(v, at(ring, after), other, theirs) > 0);
    test({false, before}, false, toward(v, at(ring, before), other, theirs) > 0);
    // At a straight vertex the borders leave what lies right behind the vertex, too.
    if (query.convex && turn(at(ring, before), v, at(ring, after)) == 0)
      test({false, own.index}, true, turn(v, at(ring, after), at(other, theirs.index)) > 0);
  } else if (query.convex && theirs.is_vertex) {
    const bool behind =
        turn(at(ring, own.index), at(ring, ring.next(own.index)), at(other, theirs.index)) > 0;
    test(own, true, behind);
  }
}

void look_at_regions(WalkState& state, const WalkQuery& query, WalkStep& note) {
  state.found = {};
  look(state, query, true, note);
  look(state, query, false, note);
  if (state.found.crossed) {
    state.phase = WalkPhase::swap;
    if (state.swaps >= query.pairs()) state.stop = WalkStop::pair_cap;
    return;
  }
  state.stop = WalkStop::closest;
  if (!query.convex) {
    const Answer truth = brute(query.model_a, query.model_b).answer;
    if (truth.overlap) {
      state.stop = WalkStop::overlap;
    } else if (truth.distance < gjkscope::root_nearest(distance_sq(state.pair))) {
      state.stop = WalkStop::local_minimum;
    }
  }
}

/// Replaces an edge that the other's vertex lies behind by the edge of the same outline that is
/// closest to that vertex. A vertex in front of no edge lies within the outline.
void leave_back(WalkState& state, const WalkQuery& query, WalkStep& note) {
  const bool of_a = state.found.of_a;
  const Ring& ring = of_a ? query.a : query.b;
  const Ring& other = of_a ? query.b : query.a;
  const RingFeature theirs = of_a ? state.b : state.a;
  const Segment vertex = segment_of(other, theirs);
  RingFeature& own = of_a ? state.a : state.b;
  bool inside = true;
  std::optional<Nearest> best;
  for (int i = 0; i < ring.size(); ++i) {
    ++note.asked;
    const Segment edge = segment_of(ring, {false, i});
    inside = inside && turn(edge.a, edge.b, vertex.a) >= 0;
    const Nearest pair = nearest(edge, vertex);
    if (best && !(pair < *best)) continue;
    best = pair;
    own = {false, i};
  }
  if (inside) state.stop = WalkStop::overlap;
}

void swap(WalkState& state, const WalkQuery& query, WalkStep& note) {
  ++state.swaps;
  state.phase = WalkPhase::closest;
  if (state.found.behind) {
    leave_back(state, query, note);
  } else {
    (state.found.of_a ? state.a : state.b) = state.found.neighbour;
  }
}

Feature feature_of(const Ring& ring, const RingFeature& f) {
  return {f.is_vertex, 0, f.is_vertex ? ring.index[f.index] : ring.segment(f.index)};
}

WalkResult result_of(const WalkState& state, const WalkQuery& query, int steps) {
  WalkResult out;
  out.stop = state.stop;
  out.a = state.a;
  out.b = state.b;
  out.steps = steps;
  const bool meets = state.pair.meet;
  if (state.stop == WalkStop::overlap && !meets) {
    // A vertex lies within the other outline.
    const bool of_a = state.found.of_a;
    const Point& p = of_a ? at(query.b, state.b.index) : at(query.a, state.a.index);
    out.answer = {0.0, true, p, p, {}, {}};
    (of_a ? out.answer.on_b : out.answer.on_a) =
        of_a ? feature_of(query.b, state.b) : feature_of(query.a, state.a);
    return out;
  }
  out.answer = answer_of(state.pair, query.model_a, query.model_b);
  out.answer.on_a = feature_of(query.a, state.a);
  out.answer.on_b = feature_of(query.b, state.b);
  return out;
}

}  // namespace

WalkQuery walk_query(const Model& a, const Model& b) {
  return {ring_of(a.outlines.front()), ring_of(b.outlines.front()), a, b,
          is_convex(a.outlines.front()) && is_convex(b.outlines.front())};
}

void step(WalkState& state, const WalkQuery& query, WalkStep& note) {
  switch (state.phase) {
    case WalkPhase::closest:
      return take_closest(state, query);
    case WalkPhase::regions:
      return look_at_regions(state, query, note);
    case WalkPhase::swap:
      return swap(state, query, note);
  }
}

WalkResult lin_canny(const WalkQuery& query, RingFeature a, RingFeature b) {
  WalkState state{WalkPhase::closest, a, b, {}, {}, 0, WalkStop::running};
  int steps = 0;
  while (state.stop == WalkStop::running) {
    WalkStep note;
    if (state.phase == WalkPhase::closest) ++steps;
    step(state, query, note);
  }
  return result_of(state, query, steps);
}

WalkResult lin_canny(const Model& a, const Model& b) {
  for (const Model* model : {&a, &b}) {
    const Flaw flaw = check(model->outlines, Needs::convex);
    if (flaw.fault == Fault::none) continue;
    WalkResult out;
    out.stop = WalkStop::refused;
    out.flaw = flaw;
    out.flaw_in_b = model == &b;
    return out;
  }
  return lin_canny(walk_query(a, b));
}

WalkTrace trace_walk(const WalkQuery& query, RingFeature a, RingFeature b) {
  WalkState state{WalkPhase::closest, a, b, {}, {}, 0, WalkStop::running};
  WalkTrace trace{state, {}, {}};
  int steps = 0;
  while (state.stop == WalkStop::running) {
    WalkStep next;
    next.phase = state.phase;
    if (state.phase == WalkPhase::closest) ++steps;
    step(state, query, next);
    next.after = state;
    trace.steps.push_back(std::move(next));
  }
  trace.result = result_of(state, query, steps);
  return trace;
}

}  // namespace models
