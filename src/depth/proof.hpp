#pragma once
// Parts that proofs of both dimensions share: what is proved, and how far Z reaches along a
// direction, by which X can leave Y.

#include "gjk/proof/careful.hpp"
#include "gjk/support.hpp"

namespace depth::detail {

using gjk::Vec;

/// In the unit of the run.
template <class R, int D>
struct Proof {
  bool is_tight = false;  ///< Certain, and as close as rounding lets bounds be.
  R depth = R(0);
  R lower = R(0);
  R upper = R(0);
  Vec<R, D> direction = Vec<R, D>::Zero();
  gjk::Simplex<R, D> face;  ///< See Result::face.
};

/// How much farther than the nearest face Z may reach along its normal, in u times the size of Z,
/// before rounding must have kept it from growing: tests/depth demands depths within 4.
inline constexpr int kAllowedGap = 2;

/// How often `careful_reach` rounds at worst, and the bound made of it: in each choice of a vertex,
/// the product, three times in the direction, whose length is not quite 1 (in space four), and the
/// bound.
template <int D>
inline constexpr int kReachRoundings = D == 2 ? 7 : 8;

/// A vertex of Z with about twice the digits of R.
template <class R, class S, int D>
[[nodiscard]] Vec<gjk::DoubleWord<R>, D> careful_vertex(const gjk::Query<S, D>& query,
                                                        const gjk::Prepared<R, D>& prepared,
                                                        gjk::VertexPair pair) {
  gjk::Simplex<R, D> vertex;
  vertex.count = 1;
  vertex.vertices[0].pair = pair;
  return gjk::careful_simplex(vertex, query, prepared).vertices[0].w;
}

/// How far Z reaches along a direction of length 1: of the vertices among which rounding leaves the
/// choice open each is computed with about twice the digits, as those of `known` are.
template <class R, class S, int D>
[[nodiscard]] R careful_reach(const Vec<R, D>& direction,
                              const gjk::Simplex<gjk::DoubleWord<R>, D>& known,
                              const gjk::Query<S, D>& query, const gjk::Prepared<R, D>& prepared) {
  using Word = gjk::DoubleWord<R>;
  gjk::VertexPair best = gjk::farthest_pair(query, prepared, direction);
  const auto reach_of = [&](gjk::VertexPair pair) {
    const auto end = known.vertices.begin() + known.count;
    const auto found =
        std::find_if(known.vertices.begin(), end, [&](const auto& v) { return v.pair == pair; });
    const Vec<Word, D> w = found != end ? found->w : careful_vertex(query, prepared, pair);
    Word sum = Word{direction[0]} * w[0];
    for (int i = 1; i < D; ++i) sum = sum + Word{direction[i]} * w[i];
    return sum.hi;
  };
  R most = reach_of(best);
  const R error = prepared.scan_error_within(R(0));
  const auto improve = [&](int gjk::VertexPair::*index, const Vec<R, D>& d,
                           const gjk::Shape<S, D>& shape, const gjk::Body<R, D>& body) {
    const gjk::Along<R, S, D> along_d(d, shape, prepared, body);
    const int found = best.*index;
    const R as_far = along_d(found) - error;
    for (int i = 0; i < along_d.count(); ++i) {
      if (i == found || along_d(i) < as_far) continue;
      gjk::VertexPair other = best;
      other.*index = i;
      const R reach = reach_of(other);
      if (!(most < reach)) continue;
      most = reach;
      best = other;
    }
  };
  improve(&gjk::VertexPair::x, Vec<R, D>(-direction), query.x, prepared.x);
  improve(&gjk::VertexPair::y, direction, query.y, prepared.y);
  return most;
}

}  // namespace depth::detail
