#include <Eigen/Geometry>

#include "subjects/convex_pieces/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::parts {
namespace {

using Eigen::Vector2d;
using namespace sizes;

template <class Corners>
std::vector<Point> points_of(const SceneBuilder& scene, const models::Pieces& pieces,
                             const Corners& corners) {
  std::vector<Point> points;
  for (const int corner : corners) points.push_back(scene.at(pieces.points[corner]));
  return points;
}

void triangles(SceneBuilder& scene, const Shown& shown, bool of_x) {
  const models::Pieces& pieces = shown.trace.of(of_x);
  const int over = shown.over(PiecesPhase::triangle, of_x);
  for (int i = 0; i < over; ++i) {
    const bool is_current = shown.step->of_x == of_x && i == shown.step->index;
    const std::vector<Point> points = points_of(scene, pieces, pieces.triangles[i]);
    scene.area(is_current ? "simplex" : "piece", points);
    scene.outline(points);
  }
}

void diagonals(SceneBuilder& scene, const Shown& shown, bool of_x) {
  const models::Pieces& pieces = shown.trace.of(of_x);
  const int over = shown.over(PiecesPhase::merge, of_x);
  for (int i = 0; i < static_cast<int>(pieces.merges.size()); ++i) {
    const models::Merge& merge = pieces.merges[i];
    const bool is_current =
        shown.is(PiecesPhase::merge) && shown.step->of_x == of_x && i == shown.step->index;
    const bool is_gone = merge.merged && i < over;
    if (is_gone && !is_current) continue;
    const std::vector<Point> ends = points_of(scene, pieces, std::array{merge.from, merge.to});
    scene.line(is_gone    ? "piece.gone"
               : i < over ? "piece.diagonal"
                          : "piece.untried",
               ends[0], ends[1]);
    if (is_current)
      for (const Point& end : ends) scene.disk("cloud.current", end, kSimplexRadius);
  }
}

/// The cuts into the fewest pieces, and the corners that make them needed.
void fewest(SceneBuilder& scene, const Shown& shown) {
  const bool of_x = shown.step->of_x;
  const models::Pieces& pieces = shown.trace.of(of_x);
  const int count = static_cast<int>(pieces.points.size());
  for (const std::vector<int>& piece : shown.trace.fewest_of(of_x)) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const int from = piece[i];
      const int to = piece[(i + 1) % piece.size()];
      // Both pieces beside a cut have it, one in each direction.
      const bool is_cut = from < to && to - from != 1 && to - from != count - 1;
      if (!is_cut) continue;
      const std::vector<Point> ends = points_of(scene, pieces, std::array{from, to});
      scene.line("piece.fewest", ends[0], ends[1]);
    }
  }
  for (const Point& corner : points_of(scene, pieces, shown.trace.turning_in[of_x ? 0 : 1]))
    scene.disk("piece.turning-in", corner, kSimplexRadius);
}

void pair_line(SceneBuilder& scene, const std::string& role, const std::string& id,
               const models::PieceRun& run) {
  const Point x = scene.at(run.x);
  const Point y = scene.at(run.y);
  scene.line(role, x, y);
  for (const Point& point : {x, y}) scene.disk("closest", point, kClosestRadius);
  scene.length_label(id, run.distance, x, y);
}

void box(SceneBuilder& scene, const std::vector<Vector2d>& points) {
  Eigen::AlignedBox2d around;
  for (const Vector2d& point : points) around.extend(point);
  const Vector2d low = around.min();
  const Vector2d high = around.max();
  scene.add("piece.box", Polyline{{scene.at(low), scene.at(Vector2d(high.x(), low.y())),
                                   scene.at(high), scene.at(Vector2d(low.x(), high.y()))},
                                  true});
}

void pair(SceneBuilder& scene, const Shown& shown) {
  const models::PieceRun& run = shown.run();
  for (const bool of_x : {true, false}) {
    const models::Pieces& pieces = shown.trace.of(of_x);
    const auto& corners = pieces.pieces[of_x ? run.a : run.b];
    scene.area("simplex", points_of(scene, pieces, corners));
    std::vector<Vector2d> world;
    for (const int corner : corners) world.push_back(pieces.points[corner]);
    if (run.skipped) box(scene, world);
  }
  const models::PieceRun* least = shown.least();
  if (least != nullptr && least != &run) pair_line(scene, "closest.line", "least", *least);
  if (!run.skipped) pair_line(scene, "gap.exact", "run", run);
}

}  // namespace

void stage(SceneBuilder& scene) {
  const Shown& shown = shown_in<Shown>(scene);
  if (shown.trace.refusal || shown.step == nullptr) return;
  if (shown.is(PiecesPhase::triangle)) {
    for (const bool of_x : {true, false}) triangles(scene, shown, of_x);
    return;
  }
  if (shown.is(PiecesPhase::pair)) pair(scene, shown);
  for (const bool of_x : {true, false}) diagonals(scene, shown, of_x);
  if (shown.is(PiecesPhase::fewest)) fewest(scene, shown);
  if (shown.is_answer && shown.least() != nullptr)
    pair_line(scene, "closest.line", "least", *shown.least());
}

}  // namespace gjkscope::parts
