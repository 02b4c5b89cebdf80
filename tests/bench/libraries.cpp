#include "libraries.hpp"

#include <memory>

namespace bench {
namespace {

/// A pair whose shapes have been measured; poses are set query by query, as they are for all.
template <class S>
struct Prepared {
  families::Pair<S> pair;
  gjk::Query<S, 2> query;
};

/// `run(query)` answers in any scalar.
template <class S, class Run>
Contestant prepare_with(std::span<const Pair> pairs, Run run) {
  const auto prepared = std::make_shared<std::vector<Prepared<S>>>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Prepared<S>& out = (*prepared)[i];
    out.pair = families::converted<S>(pairs[i]);
    out.query = out.pair.query();
  }
  return contestant(
      pairs.size(),
      [=](std::size_t i) {
        auto& [pair, query] = (*prepared)[i];
        query.x.pose = pair.x_pose;
        query.y.pose = pair.y_pose;
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

/// The same pairs, as good as: no product of their coordinates is exact.
Contestant prepare_many_digits(std::span<const Pair> pairs) {
  std::vector<Pair> longer(pairs.begin(), pairs.end());
  for (Pair& pair : longer) {
    for (std::vector<Point>* shape : {&pair.x, &pair.y}) {
      for (Point& point : *shape) point *= 1.0 + 0x1p-30;
    }
  }
  return prepare_all<double, double>(longer);
}

Contestant prepare_setting_rotations(std::span<const Pair> pairs) {
  return prepare_with<double>(pairs, [](gjk::Query<double, 2>& query) {
    for (gjk::Shape<double, 2>* shape : {&query.x, &query.y}) {
      shape->pose.rotation = shape->pose.rotation.matrix();
    }
    return gjk::distance(query);
  });
}

Contestant prepare_uncertified(std::span<const Pair> pairs) {
  gjk::Options options;
  options.proof = gjk::Proof::bounds;
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

Library core_many_digits() {
  return {.name = "many digits",
          .how = "gjk::distance, coordinates of all digits",
          .in_double = true,
          .prepare = prepare_many_digits};
}

Library core_setting_rotations() {
  return {.name = "rotations set",
          .how = "gjk::distance, both rotations set anew",
          .in_double = true,
          .prepare = prepare_setting_rotations};
}

Library core_uncertified() {
  return {.name = "no proof",
          .how = "gjk::distance, Proof::bounds",
          .in_double = true,
          .prepare = prepare_uncertified};
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
