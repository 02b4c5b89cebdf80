#include <fmt/format.h>

#include <map>

#include "picture/words.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/answer/tour.hpp"
#include "subjects/motion/motion.hpp"
#include "subjects/round_shapes/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector3d;

/// How much of the answer a frame shows.
WitnessPart shown(const SceneBuilder& scene) {
  return witness_part(scene.run, scene.frame).value_or(WitnessPart::distance);
}

/// Weights are the question, and there is more than one.
bool shows_weights(const SceneBuilder& scene) {
  return witness_part(scene.run, scene.frame) && scene.positioned.trace.result.simplex.count > 1;
}

/// The simplex of the result in the difference, and P on it.
void closest_feature(SceneBuilder& scene) {
  const WideSimplex& simplex = scene.positioned.trace.result.simplex;
  std::vector<Point> points;
  for (int i = 0; i < simplex.count; ++i)
    points.push_back(scene.at_difference(simplex.vertices[i].w));
  if (points.size() == 3) scene.area("simplex.fill", points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j)
      scene.line(points.size() == 2 ? "simplex.feature" : "simplex.edge", points[i], points[j]);
  }
  for (int i = 0; i < simplex.count; ++i) scene.simplex_vertex(simplex.vertices[i], "simplex");
}

/// Labels of vertices with the weights that they carry: a vertex of several differences has
/// several.
void weights_at(SceneBuilder& scene, const std::map<int, std::string>& weights,
                const std::vector<Vector3d>& vertices, const std::string& shape) {
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& vertex : vertices) middle += vertex / static_cast<double>(vertices.size());
  for (const auto& [index, text] : weights) {
    const Point point = scene.at(vertices[index]);
    const Point inwards = scene.at(middle) - point;
    scene.out.moving_labels.push_back(scene.label(fmt::format("weight:{}{}", shape, index), text,
                                                  "weight.label", type::kSmallVertex, point,
                                                  sizes::kSimplexRadius, inwards));
  }
}

/// The part of a shape whose weights make a witness point: its vertices, joined.
void carried_back(SceneBuilder& scene, bool is_x) {
  const WideResult& result = scene.positioned.trace.result;
  const std::vector<Vector3d>& vertices =
      is_x ? scene.positioned.x().world : scene.positioned.y().world;
  std::map<int, std::string> weights;
  for (int i = 0; i < result.simplex.count; ++i) {
    const gjk::VertexPair pair = result.simplex.vertices[i].pair;
    std::string& text = weights[is_x ? pair.x : pair.y];
    if (!text.empty()) text += " + ";
    text += Numbers(scene.run.lesson).weight(result.simplex.weights[i]);
  }
  for (auto i = weights.begin(); i != weights.end(); ++i) {
    for (auto j = std::next(i); j != weights.end(); ++j)
      scene.line("simplex.feature", scene.at(vertices[i->first]), scene.at(vertices[j->first]));
  }
  for (const auto& [index, text] : weights)
    scene.disk("simplex.vertex", scene.at(vertices[index]), sizes::kSimplexRadius);
  if (shows_weights(scene)) weights_at(scene, weights, vertices, is_x ? "x" : "y");
}

void witness_point(SceneBuilder& scene, const Vector3d& point, const Vector3d& other,
                   const std::string& name) {
  scene.disk("closest", scene.at(point), sizes::kClosestRadius);
  scene.out.moving_labels.push_back(scene.label("witness:" + name, name, "closest.label",
                                                type::kVertex, scene.at(point), sizes::kPointRadius,
                                                scene.at(point) - scene.at(other)));
}

/// The shortest way, and, once that is the question, how long it is.
void gap_line(SceneBuilder& scene, const Point& from, const Point& to) {
  scene.line("closest.line", from, to);
  if (shown(scene) < WitnessPart::distance || shows_gap(scene)) return;
  scene.length_label("distance", scene.positioned.trace.result.distance, from, to);
}

}  // namespace

void answer(SceneBuilder& scene) {
  const WideResult& result = scene.positioned.trace.result;
  if (result.simplex.count == 0 || scene.frame.step < 0) return;
  const WitnessPart reached = shown(scene);
  const bool meet = result.distance == 0.0;
  if (scene.shows_difference) {
    closest_feature(scene);
    const Vector3d p = result.y - result.x;
    if (!meet) gap_line(scene, scene.at_difference(p), scene.at_difference(Vector3d::Zero()));
    scene.disk("closest", scene.at_difference(p), sizes::kClosestRadius);
    if (!meet) {
      scene.out.moving_labels.push_back(scene.label(
          "P", "P", "closest.label", type::kVertex, scene.at_difference(p), sizes::kPointRadius,
          scene.at_difference(p) - scene.at_difference(Vector3d::Zero())));
    }
    if (shows_weights(scene)) {
      for (int i = 0; i < result.simplex.count; ++i) {
        const Point point = scene.at_difference(result.simplex.vertices[i].w);
        scene.out.moving_labels.push_back(scene.label(
            fmt::format("weight:{}", i),
            Numbers(scene.run.lesson).weight(result.simplex.weights[i]), "weight.label",
            type::kSmallVertex, point, sizes::kSimplexRadius, point - scene.at_difference(p)));
      }
    }
    return;
  }
  if (reached >= WitnessPart::on_x && !scene.shows(GrownObstacle::kName)) {
    for (int i = 0; i < result.simplex.count; ++i) {
      const WideVertex& vertex = result.simplex.vertices[i];
      scene.link(scene.vertex_of_x(vertex), scene.vertex_of_y(vertex));
    }
  }
  if (reached >= WitnessPart::distance && !meet)
    gap_line(scene, scene.at(result.x), scene.at(result.y));
  if (reached >= WitnessPart::on_y) carried_back(scene, false);
  if (reached >= WitnessPart::on_x) carried_back(scene, true);
  if (scene.shows(GrownObstacle::kName)) {  // which names points of its own
    for (const Vector3d& point : {result.x, result.y})
      scene.disk("closest", scene.at(point), sizes::kClosestRadius);
    return;
  }
  if (reached >= WitnessPart::on_x && meet)
    return witness_point(scene, result.x, result.x, "x = y");
  if (reached >= WitnessPart::on_y) witness_point(scene, result.y, result.x, "y");
  if (reached >= WitnessPart::on_x) witness_point(scene, result.x, result.y, "x");
}

}  // namespace gjkscope::layers
