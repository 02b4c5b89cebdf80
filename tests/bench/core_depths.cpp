// Compiled here, with this target's flags, not taken from gjkscope::depth.

#include <memory>

#include "depth/depth.hpp"
#include "depths.hpp"

namespace bench {
namespace {

struct Prepared {
  gjk::MeasuredShape<double, 3> x;
  gjk::MeasuredShape<double, 3> y;
  gjk::Pose<double, 3> x_pose;
  gjk::Pose<double, 3> y_pose;
};

template <gjk::Proof kProof>
std::function<Depth(std::size_t)> prepare(std::span<const Pair<3>> pairs) {
  const auto prepared = std::make_shared<std::vector<Prepared>>();
  for (const Pair<3>& pair : pairs) {
    prepared->push_back({gjk::MeasuredShape<double, 3>(pair.x),
                         gjk::MeasuredShape<double, 3>(pair.y), pair.x_pose, pair.y_pose});
  }
  gjk::Options options;
  options.proof = kProof;
  return [=](std::size_t i) {
    const Prepared& pair = (*prepared)[i];
    const gjk::Query<double, 3> query = {{pair.x, pair.x_pose}, {pair.y, pair.y_pose}};
    const auto result = depth::penetration<double>(query, options);
    const bool overlaps = result.error == gjk::Error::none && result.depth == result.depth;
    return Depth{overlaps, result.depth, result.translation};
  };
}

}  // namespace

std::vector<DepthLibrary> core_depths() {
  return {
      {"gjkscope", "depth::penetration, with bounds that are proved", true,
       prepare<gjk::Proof::exact>},
      {"gjkscope (no proof)", "depth::penetration, Proof::none", true, prepare<gjk::Proof::none>}};
}

}  // namespace bench
