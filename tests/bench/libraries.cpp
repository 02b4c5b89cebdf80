#include "libraries.hpp"

#include <memory>

namespace bench {
namespace {

/// A pair whose shapes have been measured; poses are set query by query, as they are for all.
template <class S>
struct Prepared {
  gjk::MeasuredShape<S, 2> x;
  gjk::MeasuredShape<S, 2> y;
  gjk::Pose<S, 2> x_pose;
  gjk::Pose<S, 2> y_pose;
  gjk::Query<S, 2> query = {};
};

/// `run(query)` answers in any scalar.
template <class S, class Run>
Contestant prepare_with(std::span<const Pair> pairs, Run run) {
  const auto prepared = std::make_shared<std::vector<Prepared<S>>>();
  prepared->reserve(pairs.size());  // queries view what stands here
  for (const Pair& given : pairs) {
    const families::Pair<S> pair = families::converted<S>(given);
    Prepared<S>& out = prepared->emplace_back(Prepared<S>{gjk::MeasuredShape<S, 2>(pair.x),
                                                          gjk::MeasuredShape<S, 2>(pair.y),
                                                          pair.x_pose, pair.y_pose});
    out.query = {{out.x, out.x_pose}, {out.y, out.y_pose}};
  }
  return contestant(
      pairs.size(),
      [=](std::size_t i) {
        auto& [x, y, x_pose, y_pose, query] = (*prepared)[i];
        query.x.pose = x_pose;
        query.y.pose = y_pose;
        return run(query);
      },
      [](const auto& result) {
        const bool answered =
            result.verdict != gjk::Verdict::undecided && result.verdict != gjk::Verdict::none;
        return answered ? static_cast<double>(result.distance) : kGaveUp;
      });
}

template <class S, class R>
Contestant prepare_all(std::span<const Pair> pairs) {
  return prepare_with<S>(pairs, [](const auto& query) { return gjk::distance<R>(query); });
}

template <gjk::Proof kProof>
Contestant prepare_proving(std::span<const Pair> pairs) {
  gjk::Options options;
  options.proof = kProof;
  return prepare_with<double>(pairs,
                              [=](const auto& query) { return gjk::distance(query, options); });
}

Contestant prepare_stepping(std::span<const Pair> pairs) {
  return prepare_with<double>(pairs, [](const auto& query) {
    const gjk::Options options;
    const auto prepared = gjk::prepare<double>(query, options);
    auto state = gjk::start(query, options, prepared);
    gjk::NoRecord none;
    while (state.stop == gjk::StopReason::running) {
      gjk::step(state, query, options, prepared, none);
    }
    return gjk::result(state, query, options, prepared);
  });
}

}  // namespace

Library core_double() {
  return {.name = "gjkscope",
          .how = "gjk::distance",
          .in_double = true,
          .prepare = prepare_all<double, double>};
}

Library core_float_in_double() {
  return {.name = "floats",
          .how = "gjk::distance of floats: computes in double",
          .in_double = true,
          .prepare = prepare_all<float, gjk::Default>};
}

Library core_float() {
  return {.name = "gjkscope in float",
          .how = "gjk::distance<float>: computes in float",
          .prepare = prepare_all<float, float>};
}

Library core_bounds() {
  return {.name = "bounds alone",
          .how = "gjk::distance, Proof::bounds",
          .in_double = true,
          .prepare = prepare_proving<gjk::Proof::bounds>};
}

Library core_no_proof() {
  return {.name = "no proof",
          .how = "gjk::distance, Proof::none",
          .in_double = true,
          .prepare = prepare_proving<gjk::Proof::none>};
}

Library core_stepping() {
  return {.name = "stepping",
          .how = "gjk::step until it stops, nothing recorded",
          .in_double = true,
          .prepare = prepare_stepping};
}

std::vector<Library> libraries() {
  return {
      core_double(), core_float(),
#ifdef GJKSCOPE_BOX2D_2
      box2d_2(),
#endif
#ifdef GJKSCOPE_BOX2D_3
      box2d_3(),
#endif
#ifdef GJKSCOPE_CCD
      libccd(),
#endif
#ifdef GJKSCOPE_FCL
      fcl_own(),     fcl_libccd(),
#endif
#ifdef GJKSCOPE_BULLET
      bullet(),
#endif
  };
}

}  // namespace bench
