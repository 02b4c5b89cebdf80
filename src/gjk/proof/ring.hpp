#pragma once
// Support points of large convex polygons, found without looking at all vertices.

#include <span>

#include "gjk/vector.hpp"

namespace gjk {

/// Convex polygons of at least so many vertices are climbed, not scanned. core-compare in
/// tests/bench times both at 1,024 vertices.
inline constexpr std::size_t kRingFrom = 32;

namespace detail {

/// True when all turns go the same way beyond rounding, and the edges go round once. Needs two
/// points. A turn is left - right: edges round once each, products once, their difference once, by
/// 4 u (|left| + |right|) in all; twice as much is demanded.
template <class S>
[[nodiscard]] bool is_strictly_convex_ring(std::span<const Vec<S, 2>> points) {
  const auto goes_up = [](const Vec<S, 2>& edge) {
    return S(0) < edge[1] || (edge[1] == S(0) && S(0) < edge[0]);
  };
  const std::size_t count = points.size();
  std::size_t left_turns = 0;
  int crossings = 0;
  Vec<S, 2> before = points[count - 1] - points[count - 2];
  bool went_up = goes_up(before);
  Vec<S, 2> from = points[count - 1];
  for (const Vec<S, 2>& point : points) {
    const Vec<S, 2> edge = point - from;
    const S left = before[0] * edge[1];
    const S right = before[1] * edge[0];
    const S rounding =
        S(8) * ScalarTraits<S>::unit_roundoff() * (magnitude(left) + magnitude(right));
    if (!(rounding < magnitude(S(left - right))) || !(S(0) < rounding)) return false;
    const bool is_up = goes_up(edge);
    left_turns += right < left ? 1 : 0;
    crossings += is_up != went_up ? 1 : 0;
    before = edge;
    went_up = is_up;
    from = point;
  }
  return crossings == 2 && (left_turns == 0 || left_turns == count);
}

/// The farthest vertex so far; of equal ones the one of lowest index.
template <class R>
struct Farthest {
  int index = -1;
  R value = R(0);

  bool offer(int i, const R& offered) {
    const bool improves = index < 0 || value < offered || (value == offered && i < index);
    if (improves) *this = {i, offered};
    return improves;
  }
};

/// The vertex of a convex ring that lies farthest, of equal ones the first. Along a direction the
/// vertices rise to one summit and fall to one valley: from the best of some samples the search
/// goes both ways until the fall exceeds `rounding`, the error of a difference of two values: then
/// it has seen every vertex as high as that sample.
template <class R, class Along>
[[nodiscard, gnu::noinline]] int climb(int count, const Along& along, const R& rounding) {
  int stride = 1;
  while (stride * stride < count) stride *= 2;
  Farthest<R> farthest;
  for (int i = 0; i < count; i += stride) farthest.offer(i, along(i));
  const int summit = farthest.index;
  for (const int towards : {1, count - 1}) {
    for (int i = (summit + towards) % count; i != summit; i = (i + towards) % count) {
      const R value = along(i);
      farthest.offer(i, value);
      if (value < farthest.value - rounding) break;
    }
  }
  return farthest.index;
}

}  // namespace detail
}  // namespace gjk
