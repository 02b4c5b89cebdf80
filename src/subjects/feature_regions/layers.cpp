#include <algorithm>

#include "picture/solid.hpp"
#include "subjects/feature_regions/shown.hpp"
#include "subjects/space/solids.hpp"

namespace gjkscope::cells {
namespace {

using Eigen::Vector3d;
using namespace sizes;
using Phase = RegionsTrace::Phase;

Vector3d mean_of(const std::vector<Vector3d>& points) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

/// Regions that face the eye lie before their bodies, all others behind them.
void regions(SceneBuilder& scene, bool in_front) {
  std::vector<std::pair<double, const FeatureRegions::Region*>> drawn;
  for (const FeatureRegions::Region& region : scene.effects.get<FeatureRegions>(scene.frame)) {
    if ((scene.map.towards_eye(region.feature->outwards) > 0.0) == in_front)
      drawn.emplace_back(scene.map.towards_eye(mean_of(region.solid.points)), &region);
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

/// A feature, or a neighbour of one; dashed where its body is before it.
void mark(SceneBuilder& scene, const Shown& shown, int index, bool is_beside) {
  const std::size_t body = shown.at().body;
  const Feature& feature = shown.told.features[body][static_cast<std::size_t>(index)];
  const std::vector<Vector3d>& world = shown.bodies[body].world;
  const SolidBody solid{scene.effects.get<ShapeSolids>(scene.frame)[body], world};
  const Vector3d& from = shown.vertex(body, feature.vertices.front());
  const Vector3d& to = shown.vertex(body, feature.vertices.back());
  const bool is_hidden = feature.kind() == Kind::face
                             ? scene.map.towards_eye(feature.outwards) <= 0.0
                             : part_behind(scene.map, solid, from, to).has_value();
  const std::string hidden = is_hidden ? ".hidden" : "";
  std::vector<Point> at;
  for (const int vertex : feature.vertices) at.push_back(scene.at(shown.vertex(body, vertex)));
  if (feature.kind() == Kind::vertex)
    return scene.disk((is_beside ? "cell.beside" : "feature.vertex") + hidden, at[0],
                      is_beside ? kSimplexRadius : kSupportRadius);
  if (feature.kind() == Kind::edge)
    return scene.line((is_beside ? "cell.beside" : "feature.edge") + hidden, at[0], at[1]);
  if (!is_beside) scene.area("cell.mark" + hidden, at);
}

/// The points of a pair, those that have a name, and the way between them.
void pair(SceneBuilder& scene, const RegionsTrace::Pair& of, const std::string& role,
          const std::array<std::string, 2>& names) {
  const std::array<Point, 2> at = {scene.at(of.points[0]), scene.at(of.points[1])};
  scene.line(role, at[0], at[1]);
  for (const std::size_t end : {0, 1}) {
    if (names[end].empty()) continue;
    scene.disk("slab.point", at[end], kClosestRadius);
    scene.out.moving_labels.push_back(scene.label("point:" + names[end], names[end],
                                                  "closest.label", type::kVertex, at[end],
                                                  kClosestRadius, at[end] - at[1 - end]));
  }
}

/// The plane that refutes, from the feature to below or above the point.
void refuting_plane(SceneBuilder& scene, const Shown& shown) {
  const Border& border = shown.told.border(shown.at());
  const Vector3d& point = shown.told.point(shown.at());
  const Vector3d foot = point - border.depth(point) * border.inside.normal;
  const Vector3d middle = 0.5 * (foot + shown.pair().points[shown.at().body]);
  draw_plane(scene, middle, border.inside.normal, (foot - middle).norm(), "cell.out");
  mark(scene, shown, border.beyond, true);
}

void step_of_pair(SceneBuilder& scene, const Shown& shown) {
  const auto& [phase, of_pair, body, kind, feature] = shown.at();
  if (phase == Phase::region) {
    if (!shown.asks && !shown.holds()) refuting_plane(scene, shown);
    return mark(scene, shown, shown.feature_index(), false);
  }
  const std::array<Vector3d, 2>& ends = shown.pair().points;
  const Vector3d normal = (ends[1] - ends[0]).normalized();
  for (const std::size_t end : {0, 1}) {
    if (phase != Phase::plane || end == body)
      draw_plane(scene, ends[end], normal, scene.plane_half_width(), "slab.plane");
  }
  if (phase == Phase::pair) pair(scene, shown.told.pairs[0], "cell.other", {});
  if (phase != Phase::slab || of_pair > 0) return;
  for (const auto& [of, vertex] : shown.told.reaches)
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
    for (const Feature& feature : shown.told.features[body]) {
      const int index = static_cast<int>(&feature - shown.told.features[body].data());
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
    const Vector3d middle = mean_of(points);
    double radius = 0.0;
    for (const Vector3d& point : points) radius = std::max(radius, (point - middle).norm());
    // Beyond the point that is asked about.
    constexpr double kOfBody = 0.35;
    constexpr double kOfDistance = 1.15;
    const bool has_point = !shown.is_query || shown.is(Phase::query);
    const double reach = std::max(shown.is_query ? kOfBody * radius : 0.0,
                                  has_point ? kOfDistance * shown.pair().distance() : 0.0);
    std::vector<HalfSpace> spaces;
    for (const Border& border : region.feature->borders) spaces.push_back(border.inside);
    for (const Feature& face : shown.told.features[region.body]) {
      if (face.kind() != Kind::face) break;
      const HalfSpace& outside = face.borders.back().inside;
      spaces.push_back({-outside.normal, -outside.offset - reach});
    }
    // A box cut along its faces has its corners within this radius.
    region.solid = cut_off(std::move(spaces), middle, radius + 1.75 * reach);
  }
  std::erase_if(out, [](const Region& region) { return region.solid.points.empty(); });
  return out;
}

const Layer kBehind{.effect = FeatureRegions::kName,
                    .on = Layer::On::world,
                    .order = 50,
                    .draw = [](SceneBuilder& scene) {
                      if (scene.run.act->algorithm == &kFeatureRegionsAlgorithm)
                        regions(scene, false);
                    }};

void stage(SceneBuilder& scene) {
  const Shown shown(scene.run, scene.frame);
  if (scene.view.kind != ViewKind::world || shown.told.pairs.empty()) return;
  if (scene.shows(FeatureRegions::kName)) regions(scene, true);
  if (!shown.is_query) {
    if (shown.step >= 0) step_of_pair(scene, shown);
    return pair(scene, shown.pair(), "closest.line", {"x", "y"});
  }
  if (shown.step < 0 || shown.feature_index() < 0) return;
  if (shown.is(Phase::one) || shown.is(Phase::query))
    mark(scene, shown, shown.feature_index(), false);
  for (const Border& border : shown.told.borders(shown.at())) {
    if (shown.is(Phase::one) && border.beyond >= 0) mark(scene, shown, border.beyond, true);
  }
  if (shown.is(Phase::query)) pair(scene, shown.pair(), "closest.line", {"", "P"});
}

}  // namespace gjkscope::cells
