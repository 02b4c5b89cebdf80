#include "libraries.hpp"

#include <memory>

#include "gjk/gjk.hpp"

namespace bench {
namespace {

/// A pair whose shapes have been measured; poses are set query by query, as they are for all.
template <class S, int D>
struct Prepared {
  gjk::MeasuredShape<S, D> x;
  gjk::MeasuredShape<S, D> y;
  gjk::Pose<S, D> x_pose;
  gjk::Pose<S, D> y_pose;
  gjk::Query<S, D> query = {};
};

/// `run(query)` answers in any scalar.
template <class S, int D, class Run>
Contestant prepare_with(std::span<const Pair<D>> pairs, Run run) {
  const auto prepared = std::make_shared<std::vector<Prepared<S, D>>>();
  prepared->reserve(pairs.size());  // queries view what stands here
  for (const Pair<D>& given : pairs) {
    const families::Pair<S, D> pair = families::converted<S>(given);
    Prepared<S, D>& out = prepared->emplace_back(Prepared<S, D>{gjk::MeasuredShape<S, D>(pair.x),
                                                                gjk::MeasuredShape<S, D>(pair.y),
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

template <class S, class R, int D>
Contestant prepare_all(std::span<const Pair<D>> pairs) {
  return prepare_with<S>(pairs, [](const auto& query) { return gjk::distance<R>(query); });
}

template <gjk::Proof kProof, int D>
Contestant prepare_proving(std::span<const Pair<D>> pairs) {
  gjk::Options options;
  options.proof = kProof;
  return prepare_with<double>(pairs,
                              [=](const auto& query) { return gjk::distance(query, options); });
}

/// Ranges of points, which each query measures anew.
template <int D>
Contestant prepare_plain(std::span<const Pair<D>> pairs) {
  const auto given = std::make_shared<std::vector<Pair<D>>>(pairs.begin(), pairs.end());
  return contestant(
      pairs.size(),
      [=](std::size_t i) {
        const Pair<D>& pair = (*given)[i];
        return gjk::distance(gjk::Query<double, D>{{pair.x, pair.x_pose}, {pair.y, pair.y_pose}});
      },
      [](const auto& result) { return result.distance; });
}

template <int D>
Contestant prepare_stepping(std::span<const Pair<D>> pairs) {
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

/// In the plane z = 0.
[[maybe_unused]] std::vector<Point<3>> flat(const std::vector<Point<2>>& points) {
  std::vector<Point<3>> out;
  for (const Point<2>& p : points) out.emplace_back(p[0], p[1], 0.0);
  return out;
}
[[maybe_unused]] gjk::Pose<double, 3> flat(const gjk::Pose<double, 2>& pose) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = pose.rotation.matrix();
  return {turn, {pose.translation[0], pose.translation[1], 0.0}};
}

/// Asks a library of space about flat shapes, where D is 2.
template <int D>
[[maybe_unused]] Library<D> in_dimension(Library<3> library) {
  if constexpr (D == 3) {
    return library;
  } else {
    const auto prepare = [of_space = library.prepare](std::span<const Pair<2>> pairs) {
      std::vector<Pair<3>> out;
      for (const Pair<2>& pair : pairs) {
        out.push_back({flat(pair.x), flat(pair.y), flat(pair.x_pose), flat(pair.y_pose)});
      }
      return of_space(out);
    };
    return {.name = library.name,
            .how = "flat shapes in space: " + library.how,
            .in_double = library.in_double,
            .prepare = prepare};
  }
}

}  // namespace

template <int D>
Library<D> core_double() {
  return {.name = "gjkscope",
          .how = "gjk::distance",
          .in_double = true,
          .prepare = prepare_all<double, double, D>};
}

template <int D>
Library<D> core_float_in_double() {
  return {.name = "floats",
          .how = "gjk::distance of floats: computes in double",
          .in_double = true,
          .prepare = prepare_all<float, gjk::Default, D>};
}

template <int D>
Library<D> core_float() {
  return {.name = "gjkscope in float",
          .how = "gjk::distance<float>: computes in float",
          .prepare = prepare_all<float, float, D>};
}

template <int D>
Library<D> core_bounds() {
  return {.name = "bounds alone",
          .how = "gjk::distance, Proof::bounds",
          .in_double = true,
          .prepare = prepare_proving<gjk::Proof::bounds, D>};
}

template <int D>
Library<D> core_no_proof() {
  return {.name = "gjkscope (no proof)",
          .how = "gjk::distance, Proof::none",
          .in_double = true,
          .prepare = prepare_proving<gjk::Proof::none, D>};
}

template <int D>
Library<D> core_stepping() {
  return {.name = "stepping",
          .how = "gjk::step until it stops, nothing recorded",
          .in_double = true,
          .prepare = prepare_stepping<D>};
}

template <int D>
Library<D> core_plain() {
  return {.name = "plain ranges",
          .how = "gjk::distance of ranges of points, measured in each query",
          .in_double = true,
          .prepare = prepare_plain<D>};
}

template <int D>
std::vector<Library<D>> peers(Peers which) {
  std::vector<Library<D>> out;
#ifdef GJKSCOPE_BOX2D_2
  if constexpr (D == 2) out.push_back(box2d_2());
#endif
#ifdef GJKSCOPE_BOX2D_3
  if constexpr (D == 2) out.push_back(box2d_3());
#endif
  if (D == 2 && which == Peers::native) return out;
#ifdef GJKSCOPE_CCD
  out.push_back(libccd<D>());
#endif
#ifdef GJKSCOPE_FCL
  out.push_back(in_dimension<D>(fcl_own()));
  out.push_back(in_dimension<D>(fcl_libccd()));
#endif
#ifdef GJKSCOPE_BULLET
  out.push_back(in_dimension<D>(bullet()));
#endif
#ifdef GJKSCOPE_OPENGJK
  out.push_back(in_dimension<D>(opengjk()));
#endif
  return out;
}

template Library<2> core_double();
template Library<3> core_double();
template Library<2> core_float_in_double();
template Library<3> core_float_in_double();
template Library<2> core_float();
template Library<3> core_float();
template Library<2> core_bounds();
template Library<3> core_bounds();
template Library<2> core_no_proof();
template Library<3> core_no_proof();
template Library<2> core_stepping();
template Library<3> core_stepping();
template Library<2> core_plain();
template Library<3> core_plain();
template std::vector<Library<2>> peers(Peers);
template std::vector<Library<3>> peers(Peers);

}  // namespace bench
