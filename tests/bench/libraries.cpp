#include "libraries.hpp"

#include <memory>

namespace bench {
namespace {

template <class S>
std::vector<gjk::Vec<S, 2>> cast(const std::vector<Point>& points) {
  std::vector<gjk::Vec<S, 2>> out;
  for (const Point& point : points) out.push_back(point.cast<S>());
  return out;
}

template <class S>
gjk::Pose<S, 2> cast(const gjk::Pose<double, 2>& pose) {
  return {pose.rotation.cast<S>(), pose.translation.cast<S>()};
}

template <class S>
Contestant prepare_all(std::span<const Pair> pairs) {
  struct Prepared {
    std::vector<gjk::Vec<S, 2>> x;
    std::vector<gjk::Vec<S, 2>> y;
    gjk::Pose<S, 2> x_pose;
    gjk::Pose<S, 2> y_pose;
  };
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair& pair : pairs) {
    prepared->push_back(
        {cast<S>(pair.x), cast<S>(pair.y), cast<S>(pair.x_pose), cast<S>(pair.y_pose)});
  }
  return contestant(
      pairs.size(),
      [prepared](std::size_t i) {
        const Prepared& pair = (*prepared)[i];
        return gjk::distance<S, 2>({{pair.x, pair.x_pose}, {pair.y, pair.y_pose}});
      },
      [](const auto& result) {
        const bool decided =
            result.verdict != gjk::Verdict::undecided && result.verdict != gjk::Verdict::none;
        return decided ? static_cast<double>(result.distance) : kGaveUp;
      });
}

}  // namespace

Library core_double() {
  return {.name = "gjkscope double",
          .how = "gjk::distance",
          .in_double = true,
          .prepare = prepare_all<double>};
}

Library core_float() {
  return {.name = "gjkscope float", .how = "gjk::distance in float", .prepare = prepare_all<float>};
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
