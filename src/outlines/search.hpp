#pragma once
// The walk over pairs of nodes of two hierarchies (Larsen 1998, "Hierarchical Collision Detection",
// "Hierarchical Distance Computation").
//
//   start with the pair of the roots
//   loop
//     visit    take the pair that waits on top
//     bound    cut it off when its volumes lie too far apart: collide, when they do not meet;
//              distance, when they are farther apart than the candidate
//     leaf     two leaves: test or measure their segments
//     descend  else put the pairs with both children of one node on top
//   contain    nothing waits: no boundaries meet, but one model may lie in the other
//
// The candidate is the closest pair of segments by now. Volumes that are as far apart as the
// candidate, rounding included, are not cut off: so `distance` ends with the pair that brute force
// finds, whatever the volumes and the order.

#include <array>
#include <limits>
#include <set>
#include <utility>

#include "outlines/hierarchy.hpp"
#include "outlines/nearest.hpp"

namespace models {

/// The question to the hierarchies. A search ends when it finds two segments that meet.
enum class Goal : std::uint8_t { collide, distance };

struct SearchOptions {
  Goal goal = Goal::distance;
  /// Visit the pair of children with the nearer volumes first; else the left child.
  bool nearer_first = true;
  /// Take the larger of two volumes apart; else that of `a`, as Larsen's listing does.
  bool larger_first = true;
  /// A pair of segments (indices into Model::segments) whose distance is the first candidate, for
  /// example the answer of the frame before.
  std::optional<std::pair<int, int>> remembered = std::nullopt;
  /// Distance may come out at most this share too large.
  double relative_error = 0.0;
  /// Several leaves have the same segment: keep a table of pairs that were measured.
  bool table = false;
};

/// Models and their hierarchies, which the query borrows.
template <class Volume>
struct SearchQuery {
  const Model& a;
  const Model& b;
  const Hierarchy<Volume>& tree_a;
  const Hierarchy<Volume>& tree_b;
};

enum class SearchPhase : std::uint8_t { visit, bound, leaf, descend, contain };

enum class SearchStop : std::uint8_t {
  running,
  meet,       ///< Two segments meet.
  contained,  ///< One model lies in matter of the other.
  apart,      ///< Neither: the candidate is the closest pair. Of `collide` there may be none.
};

/// Two nodes, one of each tree.
struct NodePair {
  int a = 0;
  int b = 0;
  double bound = 0.0;  ///< Not more than the distance of their volumes.
  int from = -1;       ///< Number of the visit that put it here, from 0; of the roots -1.
};

struct SearchState {
  SearchPhase phase = SearchPhase::visit;  ///< To run next; when the run has ended, the last one.
  std::vector<NodePair> waiting;           ///< The last one is on top.
  NodePair pair;                           ///< The pair that is visited.
  std::optional<Nearest> candidate;        ///< The closest pair of segments by now.
  std::pair<int, int> candidate_segments;  ///< Within Model::segments.
  std::optional<Answer> inside;            ///< The answer when one model lies in the other.
  long visits = 0;                         ///< Pairs of nodes that were visited.
  long measured = 0;                       ///< Pairs of segments that were measured.
  long hits = 0;                           ///< Pairs of leaves whose segments were in the table.
  std::set<std::pair<int, int>> table;
  SearchStop stop = SearchStop::running;
};

/// Notes of one phase; the members of the other phases stay empty.
struct SearchRecord {
  static constexpr bool kOn = true;
  double limit = 0.0;  ///< bound: of the candidate; infinite where there is none.
  bool cut = false;    ///< bound
  std::pair<int, int> segments = {-1, -1};  ///< leaf: within Model::segments.
  bool hit = false;                         ///< leaf: the pair was in the table.
  std::optional<Nearest> measured;          ///< leaf, unless it was a hit.
  bool better = false;                      ///< leaf: it is the candidate now.
  bool takes_b_apart = false;               ///< descend: else a.
  std::array<NodePair, 2> children;         ///< descend: in the order of their visits.
};
struct NoSearchRecord {
  static constexpr bool kOn = false;
};

namespace detail {

template <class Volume>
[[nodiscard]] NodePair node_pair(const SearchQuery<Volume>& query, int a, int b, int from) {
  return {a, b, distance_below(query.tree_a.nodes[a].volume, query.tree_b.nodes[b].volume), from};
}

template <class Volume>
[[nodiscard]] Nearest measure(SearchState& state, const SearchQuery<Volume>& query,
                              std::pair<int, int> segments) {
  ++state.measured;
  return nearest(query.a.segments[segments.first], query.b.segments[segments.second]);
}

/// Says whether the pair is the candidate now.
inline bool offer(SearchState& state, const Nearest& pair, std::pair<int, int> segments) {
  if (state.candidate && !(pair < *state.candidate)) return false;
  state.candidate = pair;
  state.candidate_segments = segments;
  if (pair.meet) state.stop = SearchStop::meet;
  return true;
}

inline void visit(SearchState& state) {
  if (state.waiting.empty()) {
    state.phase = SearchPhase::contain;
    return;
  }
  state.pair = state.waiting.back();
  state.waiting.pop_back();
  ++state.visits;
  state.phase = SearchPhase::bound;
}

template <class Volume, class Rec>
void compare_bound(SearchState& state, const SearchQuery<Volume>& query,
                   const SearchOptions& options, Rec& record) {
  double limit = std::numeric_limits<double>::infinity();
  if (options.goal == Goal::collide) {
    limit = 0.0;
  } else if (state.candidate) {
    limit = state.candidate->high;
  }
  const bool cut = state.pair.bound * (1.0 + options.relative_error) > limit;
  if constexpr (Rec::kOn) {
    record.limit = limit;
    record.cut = cut;
  }
  const bool leaves =
      query.tree_a.nodes[state.pair.a].is_leaf() && query.tree_b.nodes[state.pair.b].is_leaf();
  state.phase = cut ? SearchPhase::visit : leaves ? SearchPhase::leaf : SearchPhase::descend;
}

template <class Volume, class Rec>
void measure_leaves(SearchState& state, const SearchQuery<Volume>& query,
                    const SearchOptions& options, Rec& record) {
  const auto segment = [](const Hierarchy<Volume>& tree, int leaf) {
    return tree.items[tree.nodes[leaf].first].segment;
  };
  const std::pair segments{segment(query.tree_a, state.pair.a),
                           segment(query.tree_b, state.pair.b)};
  const bool hit = options.table && !state.table.insert(segments).second;
  if constexpr (Rec::kOn) {
    record.segments = segments;
    record.hit = hit;
  }
  if (hit) {
    ++state.hits;
  } else {
    const Nearest pair = measure(state, query, segments);
    const bool better = offer(state, pair, segments);
    if constexpr (Rec::kOn) {
      record.measured = pair;
      record.better = better;
    }
  }
  if (state.stop == SearchStop::running) state.phase = SearchPhase::visit;
}

template <class Volume, class Rec>
void descend(SearchState& state, const SearchQuery<Volume>& query, const SearchOptions& options,
             Rec& record) {
  const Node<Volume>& a = query.tree_a.nodes[state.pair.a];
  const Node<Volume>& b = query.tree_b.nodes[state.pair.b];
  const bool takes_b_apart =
      a.is_leaf() || (options.larger_first && !b.is_leaf() && a.volume.size() < b.volume.size());
  const int from = static_cast<int>(state.visits - 1);
  std::array<NodePair, 2> children;
  if (takes_b_apart) {
    children = {node_pair(query, state.pair.a, b.left, from),
                node_pair(query, state.pair.a, b.right, from)};
  } else {
    children = {node_pair(query, a.left, state.pair.b, from),
                node_pair(query, a.right, state.pair.b, from)};
  }
  if (options.nearer_first && children[1].bound < children[0].bound) {
    std::swap(children[0], children[1]);
  }
  if constexpr (Rec::kOn) {
    record.takes_b_apart = takes_b_apart;
    record.children = children;
  }
  state.waiting.push_back(children[1]);
  state.waiting.push_back(children[0]);
  state.phase = SearchPhase::visit;
}

/// The winding number of the model around a point that lies on no outline, by the segments that the
/// ray to the right from there may meet. Where segments have several leaves, by all segments.
template <class Volume>
[[nodiscard]] int winding(const Point& point, const Model& model, const Hierarchy<Volume>& tree) {
  if (tree.items.size() != model.segments.size()) return models::winding(point, model);
  int around = 0;
  std::vector<int> waiting = {0};
  while (!waiting.empty()) {
    const Node<Volume>& node = tree.nodes[waiting.back()];
    waiting.pop_back();
    if (!ray_meets(point, node.volume)) continue;
    if (node.is_leaf()) {
      const Segment& segment = model.segments[tree.items[node.first].segment];
      if (model.outlines[segment.outline].closed) around += models::winding(point, segment);
    } else {
      waiting.push_back(node.left);
      waiting.push_back(node.right);
    }
  }
  return around;
}

template <class Volume>
void look_inside(SearchState& state, const SearchQuery<Volume>& query) {
  state.inside = contained(
      query.a, query.b, [&](const Point& p) { return winding(p, query.a, query.tree_a); },
      [&](const Point& p) { return winding(p, query.b, query.tree_b); });
  state.stop = state.inside ? SearchStop::contained : SearchStop::apart;
}

}  // namespace detail

/// The state before the first phase. A remembered pair is measured already.
template <class Volume>
[[nodiscard]] SearchState start(const SearchQuery<Volume>& query, const SearchOptions& options) {
  SearchState state;
  state.waiting.push_back(detail::node_pair(query, 0, 0, -1));
  if (!options.remembered) return state;
  detail::offer(state, detail::measure(state, query, *options.remembered), *options.remembered);
  if (options.table) state.table.insert(*options.remembered);
  return state;
}

/// Runs the phase `state.phase`. The run goes on while `state.stop` is SearchStop::running.
template <class Volume, class Rec>
void step(SearchState& state, const SearchQuery<Volume>& query, const SearchOptions& options,
          Rec& record) {
  switch (state.phase) {
    case SearchPhase::visit:
      return detail::visit(state);
    case SearchPhase::bound:
      return detail::compare_bound(state, query, options, record);
    case SearchPhase::leaf:
      return detail::measure_leaves(state, query, options, record);
    case SearchPhase::descend:
      return detail::descend(state, query, options, record);
    case SearchPhase::contain:
      return detail::look_inside(state, query);
  }
}

/// The end of a run. `answer.overlap` is exact, and so is `answer.distance` but for its rounding
/// and the relative error that was allowed; `collide` leaves the distance of models apart open (a
/// NaN).
struct SearchResult {
  Answer answer;
  SearchStop stop = SearchStop::running;
  std::pair<int, int> segments = {-1, -1};  ///< The segments of the answer, to be remembered.
  long visits = 0;
  long measured = 0;
  long hits = 0;
};

template <class Volume>
[[nodiscard]] SearchResult result_of(const SearchState& state, const SearchQuery<Volume>& query,
                                     const SearchOptions& options) {
  SearchResult out{{},           state.stop,     state.candidate_segments,
                   state.visits, state.measured, state.hits};
  const bool is_open = options.goal == Goal::collide && state.stop == SearchStop::apart;
  if (state.inside) {
    out.answer = *state.inside;
  } else if (is_open) {
    out.answer.distance = std::numeric_limits<double>::quiet_NaN();
  } else {
    out.answer = answer_of(*state.candidate, query.a, query.b);
  }
  return out;
}

/// Runs all phases, recording nothing.
template <class Volume>
[[nodiscard]] SearchResult search(const SearchQuery<Volume>& query,
                                  const SearchOptions& options = {}) {
  SearchState state = start(query, options);
  NoSearchRecord none;
  while (state.stop == SearchStop::running) step(state, query, options, none);
  return result_of(state, query, options);
}

/// The same of models, whose hierarchies are built first.
template <class Volume>
[[nodiscard]] SearchResult search(const Model& a, const Model& b,
                                  const SearchOptions& options = {}) {
  const Hierarchy<Volume> tree_a = build_hierarchy<Volume>(items_of(a));
  const Hierarchy<Volume> tree_b = build_hierarchy<Volume>(items_of(b));
  return search<Volume>(SearchQuery<Volume>{a, b, tree_a, tree_b}, options);
}

struct SearchStep {
  SearchPhase phase = SearchPhase::visit;
  SearchRecord record;
  SearchState after;
};
struct SearchTrace {
  SearchState start;
  std::vector<SearchStep> steps;
  SearchResult result;
};
/// Runs all phases and keeps every state.
template <class Volume>
[[nodiscard]] SearchTrace trace_search(const SearchQuery<Volume>& query,
                                       const SearchOptions& options = {}) {
  SearchState state = start(query, options);
  SearchTrace trace{state, {}, {}};
  while (state.stop == SearchStop::running) {
    SearchStep next{state.phase, {}, {}};
    step(state, query, options, next.record);
    next.after = state;
    trace.steps.push_back(std::move(next));
  }
  trace.result = result_of(state, query, options);
  return trace;
}

}  // namespace models
