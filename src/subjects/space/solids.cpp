#include "subjects/space/solids.hpp"

#include <algorithm>

#include "gjk/vector.hpp"
#include "subjects/space/subject.hpp"

namespace gjkscope {

using Eigen::Vector3d;

namespace {

/// A body whose support points are found by walks from vertex to vertex.
class Walked {
 public:
  explicit Walked(const SolidOf& solid)
      : points_(solid.points), neighbours_(neighbours_of(solid.hull, solid.points.size())) {}

  [[nodiscard]] int support(const Vector3d& d, int from) const {
    for (bool goes = true; goes;) {
      goes = false;
      const int at = from;
      for (const int next : neighbours_[at]) {
        if (!(along(d, from, next) > 0.0)) continue;
        from = next;
        goes = true;
      }
    }
    return from;
  }

  /// The support points of all directions from d to e, from that of d on.
  [[nodiscard]] std::vector<int> supports(const Vector3d& d, const Vector3d& e, int from) const {
    std::vector<int> out = {from};
    while (out.size() < points_.size()) {
      int nearest = -1;
      double least = 2.0;
      for (const int next : neighbours_[from]) {
        const double at_end = along(e, from, next);
        if (!(at_end > 0.0)) continue;
        const double behind = std::max(0.0, -along(d, from, next));
        const double share = behind / (behind + at_end);
        if (share >= least) continue;
        least = share;
        nearest = next;
      }
      if (nearest < 0) break;
      out.push_back(from = nearest);
    }
    return out;
  }

 private:
  /// How much farther `b` lies along d than `a`. Each point has one number, rounded or not, so a
  /// walk to ever larger ones ends.
  [[nodiscard]] double along(const Vector3d& d, int a, int b) const {
    return gjk::dot(d, points_[b]) - gjk::dot(d, points_[a]);
  }

  const std::vector<Vector3d>& points_;
  std::vector<std::vector<int>> neighbours_;
};

}  // namespace

std::vector<gjk::VertexPair> pairs_of_hull(const SolidOf& x, const SolidOf& y) {
  std::vector<gjk::VertexPair> out;
  const Walked of_x(x);
  const Walked of_y(y);
  std::vector<int> supports;  // of Y, for each face of X
  int at = y.hull.vertices.front();
  for (const Polyhedron::Face& face : x.hull.faces) {
    supports.push_back(at = of_y.support(-face.normal, at));
    for (const int vertex : face.vertices) out.push_back({vertex, at});
  }
  at = x.hull.vertices.front();
  for (const Polyhedron::Face& face : y.hull.faces) {
    at = of_x.support(-face.normal, at);
    for (const int vertex : face.vertices) out.push_back({at, vertex});
  }
  for (const Polyhedron::Edge& edge : x.hull.edges) {
    const auto left = static_cast<std::size_t>(edge.left);
    const auto right = static_cast<std::size_t>(edge.right);
    for (const int vertex :
         of_y.supports(-x.hull.faces[left].normal, -x.hull.faces[right].normal, supports[left])) {
      out.push_back({edge.from, vertex});
      out.push_back({edge.to, vertex});
    }
  }
  const auto key = [](const gjk::VertexPair& pair) { return std::pair(pair.x, pair.y); };
  std::sort(out.begin(), out.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

EffectKey ShapeSolids::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

ShapeSolids::Value ShapeSolids::compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
  Value out;
  for (const Body& body : run.run(frame).bodies) out.push_back(hull_in_space(body.world));
  return out;
}

EffectKey DifferenceSolid::key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }

DifferenceSolid::Value DifferenceSolid::compute(EffectGraph& graph, const LessonRun& run,
                                                const Frame& frame) {
  const ShapeSolids::Value& solids = graph.get<ShapeSolids>(frame);
  const PositionedRun& positioned = run.run(frame);
  const std::vector<Vector3d>& of_x = positioned.x().world;
  const std::vector<Vector3d>& of_y = positioned.y().world;
  constexpr std::size_t kManyPairs = 100000;
  const bool has_faces = !solids[0].faces.empty() && !solids[1].faces.empty();
  Value out;
  if (has_faces && solids[0].vertices.size() * solids[1].vertices.size() > kManyPairs) {
    out.pairs = pairs_of_hull({solids[0], of_x}, {solids[1], of_y});
  } else {
    for (const int x : solids[0].vertices) {
      for (const int y : solids[1].vertices) out.pairs.push_back({x, y});
    }
  }
  for (const gjk::VertexPair& pair : out.pairs) {
    out.points.emplace_back(of_y[pair.y] - of_x[pair.x]);
  }
  out.hull = hull_in_space(out.points);
  return out;
}

const EffectInfo effect_infos::kShapeSolids =
    effect_info<ShapeSolids>("frame", "the hulls of X and Y in space");

const EffectInfo effect_infos::kDifferenceSolid =
    effect_info<DifferenceSolid>("frame", "the hull of the differences in space");

}  // namespace gjkscope
