#include "picture/words.hpp"
#include "subjects/lengths/subject.hpp"
#include "subjects/lin_canny/shown.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::walks {
namespace {

using Eigen::Vector2d;
using models::RingFeature;
using models::WalkPhase;
using namespace sizes;

/// The borders of the feature's region, with ticks on its side. A fill would cover the other shape
/// as if they overlapped. A region that was left is hatched; the border that was crossed stands
/// out.
void region(SceneBuilder& scene, const Shown& shown, bool of_x) {
  const bool looked = shown.is(WalkPhase::regions);
  const models::RegionTest& found = shown.state.found;
  const bool left = looked && found.crossed && found.of_a == of_x;
  const std::vector<Border> all = shown.borders(of_x);
  if (left) {
    std::vector<Vector2d> seen = scene.map.visible();
    for (const Border& border : all) seen = clip(seen, border.line);
    std::vector<Point> area;
    for (const Vector2d& point : seen) area.push_back(scene.at(point));
    if (area.size() > 2) scene.hatched("region.hatch", area);
  }
  const std::string role = of_x ? "walk.region.x" : "walk.region.y";
  const double reach = (scene.map.visible()[2] - scene.map.visible()[0]).norm();
  for (const Border& border : all) {
    if (border.neighbour == shown.feature(of_x)) continue;  // the edge itself
    const HalfPlane& line = border.line;
    Vector2d out(line.normal.y(), -line.normal.x());
    const bool inside = std::any_of(all.begin(), all.end(), [&](const Border& other) {
      return other.line.normal.dot(out) > 1e-9 * other.line.normal.norm() * out.norm();
    });
    if (inside) out = -out;
    const bool is_crossed = left && border.neighbour == found.neighbour;
    const Point from = scene.at(line.point);
    const Point to = scene.at(line.point + reach * out.normalized());
    scene.line(is_crossed ? "sign.border" : role, from, to);
    layers::ticks(scene, role + ".tick", from, to, scene.map.direction(-line.normal));
  }
}

void feature(SceneBuilder& scene, const Shown& shown, bool of_x) {
  const models::Ring& ring = shown.ring(of_x);
  const RingFeature& at = shown.feature(of_x);
  const auto corner = [&](int i) { return scene.at(ring.points[i]); };
  if (at.is_vertex) return scene.disk("feature.vertex", corner(at.index), kSimplexRadius);
  scene.line("feature.edge", corner(at.index), corner(ring.next(at.index)));
}

/// The place of a feature among all of its ring: vertex A, edge AB, vertex B, ...
int place_of(const RingFeature& feature) { return 2 * feature.index + (feature.is_vertex ? 0 : 1); }

/// "A", "AB"
std::string letters_of(const Shown& shown, bool of_x, int place) {
  const std::string name = shown.name(of_x, {place % 2 == 0, place / 2});
  const std::size_t from = name.find(' ') + 1;
  return name.substr(from, name.find(' ', from) - from);
}

}  // namespace

/// A column for each feature of X, a row for each of Y; the walk goes from cell to cell.
bool fill(SceneBuilder& scene, const Fonts&) {
  if (!shows_pairs(scene.run, scene.frame) || scene.view.kind != ViewKind::world) return false;
  const Shown& shown = shown_in<Shown>(scene);
  constexpr double kLetters = 44.0;
  constexpr double kTitle = 74.0;
  constexpr double kMargin = 16.0;
  constexpr double kNumber = 44.0;  // the room that a distance needs
  constexpr double kRow = 18.0;     // that of a name
  const Rect& card = scene.map.area();
  const Rect grid{card.min + Point(kLetters, kTitle), card.max - Point(kMargin, kMargin)};
  const int columns = shown.features(true);
  const int rows = shown.features(false);
  const Point cell(grid.size().x() / columns, grid.size().y() / rows);
  const auto middle = [&](double column, double row) -> Point {
    return grid.min + Point((column + 0.5) * cell.x(), (row + 0.5) * cell.y());
  };
  for (int i = 0; i <= columns; ++i) {
    const double x = grid.min.x() + i * cell.x();
    scene.add(i == 0 ? "plot.axis" : "chart.grid",
              Polyline{{{x, grid.min.y()}, {x, grid.max.y()}}});
    // In narrow columns vertices alone have names.
    if (i < columns && (i % 2 == 0 || cell.x() > kNumber))
      scene.add("plot.third.label", Text{{middle(i, 0).x(), grid.min.y() - 10.0},
                                         letters_of(shown, true, i),
                                         type::kName,
                                         Align::center});
  }
  for (int i = 0; i <= rows; ++i) {
    const double y = grid.min.y() + i * cell.y();
    scene.add(i == 0 ? "plot.axis" : "chart.grid",
              Polyline{{{grid.min.x(), y}, {grid.max.x(), y}}});
    if (i < rows && (i % 2 == 0 || cell.y() > kRow))
      scene.add("plot.fourth.label", Text{{grid.min.x() - 10.0, middle(0, i).y() + 6.0},
                                          letters_of(shown, false, i),
                                          type::kName,
                                          Align::right});
  }
  Polyline path;
  const std::vector<models::WalkState> pairs = shown.pairs();
  for (const models::WalkState& pair : pairs)
    path.points.push_back(middle(place_of(pair.a), place_of(pair.b)));
  const std::vector<Point> cells = path.points;
  scene.add("plot.first.line", std::move(path));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const models::Answer closest =
        models::answer_of(pairs[i].pair, shown.walk.query->model_a, shown.walk.query->model_b);
    const Point half = 0.5 * cell - Point(2.0, 2.0);
    scene.add("plot.current", Box{{cells[i] - half, cells[i] + half}, 4.0});
    if (cell.x() < kNumber) continue;
    scene.add("plot.first.label", Text{cells[i] + Point(0.0, 6.0), fixed(closest.distance, 2),
                                       type::kText, Align::center});
  }
  return true;
}

void stage(SceneBuilder& scene) {
  const Shown& shown = shown_in<Shown>(scene);
  if (!shown.walk.query) return;
  const bool shows_regions = !shown.is_answer && shown.state.stop != models::WalkStop::overlap;
  for (const bool of_x : {true, false}) {
    if (shows_regions) region(scene, shown, of_x);
  }
  for (const bool of_x : {true, false}) feature(scene, shown, of_x);
  if (!shown.knows_pair()) return;
  if (shown.is_answer && shown.walk.truth) {
    const Point of_x = scene.at(shown.walk.truth->a);
    const Point of_y = scene.at(shown.walk.truth->b);
    scene.line("gap.exact", of_x, of_y);
    for (const Point& point : {of_x, of_y}) scene.disk("closest", point, kClosestRadius);
    scene.length_label("truth", shown.walk.truth->distance, of_x, of_y);
  }
  const models::Answer closest = shown.closest();
  const Point x = scene.at(closest.a);
  const Point y = scene.at(closest.b);
  scene.line("closest.line", x, y);
  const auto name = [&](const char* letter, const Point& point, const Point& other) {
    scene.disk("closest", point, kClosestRadius);
    scene.out.moving_labels.push_back(scene.label(std::string("closest:") + letter, letter,
                                                  "closest.label", type::kVertex, point,
                                                  kPointRadius, point - other));
  };
  if ((y - x).norm() < 1.0) {
    name("x = y", y, y);
  } else {
    name("x", x, y);
    name("y", y, x);
  }
  scene.length_label("distance", closest.distance, x, y);
}

}  // namespace gjkscope::walks
