#include "effects/registry.hpp"

#include "effects/balance.hpp"
#include "effects/barycentric.hpp"
#include "effects/cold_start.hpp"
#include "effects/direction_rules.hpp"
#include "effects/facts.hpp"
#include "effects/growth.hpp"
#include "effects/history.hpp"
#include "effects/minkowski.hpp"
#include "effects/motion.hpp"
#include "effects/projection.hpp"
#include "effects/region_orders.hpp"
#include "effects/rounded_pair.hpp"
#include "effects/second_run.hpp"
#include "effects/shape_hull.hpp"
#include "effects/sign_map.hpp"
#include "effects/slab.hpp"
#include "effects/touched_points.hpp"
#include "effects/voronoi.hpp"

namespace gjkscope {
namespace {

template <class E>
EffectInfo info(std::string_view used_by, std::string_view summary, std::string_view act = {},
                bool second_run = false) {
  return {E::kName, E::kNeeds, summary, used_by, act, second_run};
}

}  // namespace

const std::vector<EffectInfo>& registered_effects() {
  static const std::vector<EffectInfo> effects = {
      info<FrameFacts>("frame", "what is known when a frame is shown"),
      info<VoronoiRegions>("view", "Voronoi regions of the current simplex"),
      info<BarycentricWeights>("panel", "barycentric coordinates of the query point, signed"),
      info<BarycentricParts>("view", "the lengths or areas that the coordinates measure"),
      info<Projection>("view",
                       "the line through a segment, and the point G = uA + vB where Q falls on it"),
      info<UnitVector>("view", "n = (B - A) / length, drawn from A"),
      info<Balance>("view",
                    "a beam with masses u and v, swinging on its support; needs granularity `time`",
                    "time"),
      info<SignMap>("view", "where u, v and w are negative"),
      info<MapDifference>("view",
                          "where the signs and the Voronoi regions name different features"),
      info<RegionOrders>("view", "the point that region tests in a wrong order take for P"),
      info<MinkowskiCloud>("view", "every difference y - x"),
      info<MinkowskiHull>("view", "convex hull of the differences"),
      info<TouchedPoints>("view", "the differences that the run has computed so far"),
      info<LastPosition>("view", "where everything was a position ago, and how far it went"),
      info<GrownObstacle>("view", "Y grown by X, and X as a point against it"),
      info<BestSupport>("frame", "the support line that proves most of the distance"),
      info<Slab>("view", "the widest strip proved empty between X and Y"),
      info<ColdStart>("panel", "the same run without the warm start"),
      info<Growth>("panel", "runs on random polygons, with more and more vertices"),
      info<RoundedPair>("panel", "the same query as floats and doubles keep it, and exactly"),
      info<History>("view", "simplices and closest points of earlier iterations"),
      info<DirectionRules>("panel", "both ways to build the search direction"),
      info<SecondRun>("view", "the same query in another scalar: its closest point and search", {},
                      true),
      info<ShapeHull>("view", "convex hulls of shapes that are not convex"),
  };
  return effects;
}

}  // namespace gjkscope
