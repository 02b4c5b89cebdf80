#include "subjects/regions/region_orders.hpp"

#include "gjk/regions.hpp"
#include "run/scalar.hpp"
#include "run/widen.hpp"
#include "subjects/regions/subject.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;

template <class S>
using Coordinates = std::array<gjk::Barycentric<S, 2>, 8>;  // by face

/// The conditions on one face: none on the whole triangle, which is what the others leave.
template <class S>
gjk::RegionTest<double> test_of(gjk::Face face, bool whole, const Coordinates<S>& coordinates) {
  gjk::RegionTest<double> test{face, {}, true};
  const int size = gjk::vertex_count(face);
  const auto ask = [&](gjk::Face of, int vertex, bool wants_positive) {
    const S numerator = coordinates[of].numerator[vertex];
    const bool holds = (S(0) < numerator) == wants_positive;
    test.terms.push_back({of, vertex, wants_positive, widened(numerator),
                          widened(coordinates[of].denominator), holds});
    test.holds = test.holds && holds;
  };
  for (int i = 0; i < 3; ++i) {
    if (!gjk::contains(face, i)) ask(static_cast<gjk::Face>(face | gjk::face_of(i)), i, false);
  }
  for (int i = 0; i < 3 && whole && size == 2; ++i) {
    if (gjk::contains(face, i)) ask(face, i, true);
  }
  return test;
}

template <class S>
RegionOrders::Chain chain_of(gjk::RegionOrder order, bool whole, const Coordinates<S>& coordinates,
                             const WideState& state) {
  RegionOrders::Chain chain;
  chain.order = order;
  chain.whole = whole;
  for (const gjk::Face face : gjk::tested_faces(3, order)) {
    if (chain.region != 0) break;
    chain.tests.push_back(test_of(face, whole, coordinates));
    if (chain.tests.back().holds) chain.region = face;
  }
  const gjk::Barycentric<S, 2>& taken = coordinates[chain.region];
  for (int i = 0; i < 3; ++i) {
    if (!gjk::contains(chain.region, i)) continue;
    chain.weights[i] = gjk::vertex_count(chain.region) == 1
                           ? 1.0
                           : widened(S(taken.numerator[i] / taken.denominator));
    chain.p += chain.weights[i] * state.simplex.vertices[i].w;
  }
  if (chain.region == state.region) chain.p = state.p;
  chain.error = (chain.p - state.p).norm();
  return chain;
}

}  // namespace

EffectKey RegionOrders::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, run.gjk_step(frame), -1};
}

RegionOrders::Value RegionOrders::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  const WideState& state = run.state(frame);
  Value chains;
  if (state.simplex.count != 3) return chains;
  with_scalar(run.lesson.scalar, [&]<class S>(std::type_identity<S>) {
    const gjk::Simplex<S, 2> simplex =
        narrowed_simplex<S, 2>(state.simplex, run.run(frame).exponent);
    Coordinates<S> coordinates;
    for (gjk::Face face = 1; face <= simplex.all(); ++face) {
      coordinates[face] = gjk::barycentric(simplex, face);
      if (gjk::vertex_count(face) > 1 && !(S(0) < coordinates[face].denominator)) return;
    }
    using enum gjk::RegionOrder;
    for (const auto& [order, whole] :
         {std::pair(vertices_first, false), {edges_first, false}, {edges_first, true}}) {
      chains.push_back(chain_of(order, whole, coordinates, state));
    }
  });
  return chains;
}

const EffectInfo effect_infos::kRegionOrders =
    effect_info<RegionOrders>("view", "the point that region tests in a wrong order take for P");

}  // namespace gjkscope
