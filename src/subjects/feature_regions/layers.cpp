#include <algorithm>

#include "picture/solid.hpp"
#include "subjects/feature_regions/drawing.hpp"
#include "subjects/feature_regions/shown.hpp"

namespace gjkscope::cells {
namespace {

using Eigen::Vector3d;
using namespace sizes;
using Phase = RegionsTrace::Phase;

/// Regions that face the eye lie before their bodies, all others behind them.
void regions(SceneBuilder& scene, bool in_front) {
  std::vector<std::pair<double, const FeatureRegions::Region*>> drawn;
  for (const FeatureRegions::Region& region : scene.effects.get<FeatureRegions>(scene.frame)) {
    if ((scene.map.towards_eye(region.feature->outwards) > 0.0) == in_front)
      drawn.emplace_back(scene.map.towards_eye(middle_of(region.solid.points)), &region);
  }
  std::sort(drawn.begin(), drawn.end());
  constexpr std::array<const char*, kKinds> kRoles = {"cell.face", "cell.edge", "cell.vertex"};
  for (const auto& each : drawn) {
    const FeatureRegions::Region& region = *each.second;
    const std::size_t kind = static_cast<std::size_t>(region.feature->kind());
    const char* of_body = region.body == 0 ? "cell.x" : "cell.y";
    draw_solid(scene, region.solid.hull, region.solid.points,
               scene.run.point_query() ? kRoles[kind] : of_body);
  }
}

void step_of_pair(SceneBuilder& scene, const Shown& shown) {
  const auto& [phase, of_pair, body, kind, feature] = shown.at();
  if (phase == Phase::region) {
    if (!shown.asks && !shown.holds()) {
      const Border& border = shown.trace.border(shown.at());
      draw_refuting_plane(scene, border, shown.pair().points[body], shown.trace.point(shown.at()));
      draw_neighbour(scene, body, shown.feature(border.beyond));
    }
    return draw_feature(scene, body, shown.feature(shown.feature_index()));
  }
  const std::array<Vector3d, 2>& ends = shown.pair().points;
  const Vector3d normal = unit(ends[1] - ends[0]);
  for (const std::size_t end : {0, 1}) {
    if (phase != Phase::plane || end == body)
      draw_plane(scene, ends[end], normal, scene.plane_half_width(), "slab.plane");
  }
  if (phase == Phase::pair) draw_pair(scene, shown.trace.pairs[0].points, "cell.other", {});
  if (phase != Phase::slab || of_pair > 0 || shown.asks) return;
  for (const auto& [of, vertex] : shown.trace.reaches)
    scene.diamond("slab.vertex", scene.at(shown.vertex(of, vertex)), kSupportRadius);
}

/// The regions that a step shows.
FeatureRegions::Value regions_of(const Shown& shown) {
  FeatureRegions::Value out;
  if (shown.step < 0) return out;
  const RegionsTrace::Step& at = shown.at();
  const bool is_both = at.phase == Phase::slab && at.pair == 1;
  if (at.phase == Phase::pair || (at.phase == Phase::slab && !is_both)) return out;
  for (const std::size_t body : {0, 1}) {
    for (const Feature& feature : shown.trace.features[body]) {
      const int index = static_cast<int>(&feature - shown.trace.features[body].data());
      const bool is_shown = at.phase == Phase::all    ? true
                            : at.phase == Phase::kind ? feature.kind() == at.kind
                            : is_both                 ? index == shown.pair().features[body]
                                      : body == at.body && index == shown.feature_index();
      if (is_shown) out.push_back({&feature, body, {}});
    }
  }
  return out;
}

}  // namespace

EffectKey FeatureRegions::key(const LessonRun& run, const Frame& frame) {
  return {frame.run, Shown(run, frame).step, -1};
}

FeatureRegions::Value FeatureRegions::compute(EffectGraph&, const LessonRun& run,
                                              const Frame& frame) {
  const Shown shown(run, frame);
  Value out = regions_of(shown);
  for (Region& region : out) {
    const std::vector<Vector3d>& points = shown.bodies[region.body].world;
    // Beyond the point that is asked about.
    constexpr double kOfBody = 0.35;
    constexpr double kOfDistance = 1.15;
    const bool has_point = !shown.is_query || shown.is(Phase::query);
    const double reach = std::max(shown.is_query ? kOfBody * radius_of(points) : 0.0,
                                  has_point ? kOfDistance * shown.pair().distance() : 0.0);
    region.solid = region_of(*region.feature, shown.trace.features[region.body], points, reach);
  }
  std::erase_if(out, [](const Region& region) { return region.solid.points.empty(); });
  return out;
}

const Layer kBehind{.effect = FeatureRegions::kName,
                    .on = Layer::On::world,
                    .order = 50,
                    .draw = [](SceneBuilder& scene) {
                      if (scene.run.tour->algorithm == &kFeatureRegionsAlgorithm)
                        regions(scene, false);
                    }};

void stage(SceneBuilder& scene) {
  const Shown shown(scene.run, scene.frame);
  if (scene.view.kind != ViewKind::world || shown.trace.pairs.empty()) return;
  if (scene.shows(FeatureRegions::kName)) regions(scene, true);
  if (!shown.is_query) {
    if (shown.step >= 0) step_of_pair(scene, shown);
    return draw_pair(scene, shown.pair().points, "closest.line", {"x", "y"});
  }
  if (shown.step < 0 || shown.feature_index() < 0) return;
  if (shown.is(Phase::one) || shown.is(Phase::query))
    draw_feature(scene, 1, shown.feature(shown.feature_index()));
  for (const Border& border : shown.trace.borders(shown.at())) {
    if (shown.is(Phase::one) && border.beyond >= 0)
      draw_neighbour(scene, 1, shown.feature(border.beyond));
  }
  if (shown.is(Phase::query)) draw_pair(scene, shown.pair().points, "closest.line", {"", "P"});
}

}  // namespace gjkscope::cells
