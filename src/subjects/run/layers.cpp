#include <fmt/format.h>

#include <algorithm>

#include "picture/solid.hpp"
#include "picture/words.hpp"
#include "run/questions.hpp"
#include "subjects/round_shapes/subject.hpp"
#include "subjects/run/history.hpp"
#include "subjects/run/other_normal.hpp"
#include "subjects/run/refuting.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/second_run/second_run.hpp"
#include "subjects/second_run/subject.hpp"
#include "subjects/space/region.hpp"
#include "subjects/support/slab.hpp"
#include "subjects/weights/barycentric.hpp"
#include "subjects/weights/projection.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope::layers {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace sizes;

std::string subscript(int number) {
  std::string out;
  for (const char digit : std::to_string(number))
    out += std::string("₀₁₂₃₄₅₆₇₈₉").substr(3 * (digit - '0'), 3);
  return out;
}

void dropped_vertex(SceneBuilder& scene, const WideVertex& vertex) {
  if (scene.shows_difference) {
    scene.disk("dropped", scene.at_difference(vertex.w), kRingRadius);
    if (!scene.run.point_query()) scene.pair_label(vertex, "dropped.label");
  }
}

/// True where no block of the panel says the weights that decide what is dropped.
bool hides_weights(const SceneBuilder& scene) {
  const Lesson& lesson = scene.run.lesson;
  return !lesson.has_block(blocks::kSimplex.name) && !lesson.has_block(blocks::kWeights.name) &&
         !lesson.has_block(blocks::kPseudocode.name) && !lesson.has_block(blocks::kTwoRuns.name);
}

/// The weight that a vertex has in P, on the side away from P.
void weight_label(SceneBuilder& scene, const WideVertex& vertex, const std::string& weight) {
  const Point at = scene.at_difference(vertex.w);
  scene.out.moving_labels.push_back(
      scene.label("weight:" + scene.run.pair_name(vertex.pair), weight, "weight.label",
                  type::kSmallVertex, at, kRingRadius, at - scene.at_difference(scene.state.p)));
}

}  // namespace

void search_direction(SceneBuilder& scene) {
  scene.search_arrow(scene.at_difference(scene.state.p), scene.state.d,
                     scene.arrow_length(scene.state.p), "d");
  if (!scene.map.is_of_space() || !scene.shows(SecondRun::kName)) return;
  // Its name stands on the side where the second run's arrow is not.
  const WideStep* beside =
      step_beside(scene.effects.get<SecondRun>(scene.frame), scene.run, scene.frame);
  std::vector<LabelRequest>& labels = scene.out.moving_labels;
  if (beside == nullptr || labels.empty() || labels.back().id != "arrow:d") return;
  const Point to_other = scene.middle_of_arrow(beside->after) - scene.middle_of_arrow(scene.state);
  if (labels.back().towards.dot(to_other) > 0.0) labels.back().towards = -labels.back().towards;
  labels.back().keeps_side = true;
}

void best_support_line(SceneBuilder& scene) {
  const BestSupport::Value& best = scene.effects.get<BestSupport>(scene.frame);
  if (!best) return;
  if (scene.knows.support && is_found_by(*best, scene.state)) return;
  scene.support_plane(best->support.w, best->normal, "support.best");
}

void history(SceneBuilder& scene) {
  for (const History::Entry& entry : scene.effects.get<History>(scene.frame)) {
    if (!scene.shows_difference) continue;
    std::vector<Point> points;
    for (int i = 0; i < entry.simplex.count; ++i)
      points.push_back(scene.at_difference(entry.simplex.vertices[i].w));
    if (points.size() > 1) {
      scene.add("history.simplex", Polyline{points, points.size() > 2});
      scene.outline(points);
    }
  }
}

void history_points(SceneBuilder& scene) {
  if (!scene.shows_difference) return;
  for (const History::Entry& entry : scene.effects.get<History>(scene.frame)) {
    const Point p = scene.at_difference(entry.p);
    scene.add("history.closest", Disk{p, 3.5});
    scene.out.obstacles.circles.push_back({p, 3.5});
    scene.out.moving_labels.push_back(scene.label(fmt::format("history:{}", entry.iteration),
                                                  fmt::format("P{}", subscript(entry.iteration)),
                                                  "history.label", type::kSmallVertex, p, 3.5));
  }
}

namespace {

/// In the world, the parts of both shapes whose differences are the feature that holds P.
void chords(SceneBuilder& scene, gjk::Face face) {
  const WideSimplex& simplex = scene.state.simplex;
  for (int i = 0; i < simplex.count; ++i) {
    for (int j = i + 1; j < simplex.count; ++j) {
      if (!gjk::contains(face, i) || !gjk::contains(face, j)) continue;
      const WideVertex& a = simplex.vertices[i];
      const WideVertex& b = simplex.vertices[j];
      if (a.pair.x != b.pair.x)
        scene.line("simplex.edge", scene.at(scene.vertex_of_x(a)), scene.at(scene.vertex_of_x(b)));
      if (a.pair.y != b.pair.y)
        scene.line("simplex.edge", scene.at(scene.vertex_of_y(a)), scene.at(scene.vertex_of_y(b)));
    }
  }
}

}  // namespace

namespace {

std::vector<Vector3d> corners_of(const SceneBuilder& scene, gjk::Face face) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < scene.state.simplex.count; ++i) {
    if (gjk::contains(face, i))
      corners.emplace_back(scene.state.simplex.vertices[i].w + scene.shift);
  }
  return corners;
}

void tetrahedron(SceneBuilder& scene) {
  const std::vector<Vector3d> corners = corners_of(scene, scene.state.simplex.all());
  draw_solid(scene, hull_in_space(corners), corners, "simplex.solid", {}, Stuff::core);
}

void edge(SceneBuilder& scene, const std::string& role, int i, int j) {
  const Point a = scene.vertex_at(i);
  const Point b = scene.vertex_at(j);
  if (!scene.map.is_of_space()) return scene.line(role, a, b);
  const WideSimplex& simplex = scene.state.simplex;
  scene.line_in_space(role, simplex.vertices[i].w + scene.shift,
                      simplex.vertices[j].w + scene.shift);
  scene.out.obstacles.segments.push_back({a, b});
}

}  // namespace

void simplex(SceneBuilder& scene) {
  const WideSimplex& simplex = scene.state.simplex;
  const gjk::Face face = shows_closest_point(scene) ? scene.state.region : gjk::Face{0};
  if (scene.shows_difference) {
    std::vector<Point> points;
    for (int i = 0; i < simplex.count; ++i) points.push_back(scene.vertex_at(i));
    const bool is_triangle = scene.shows_whole_simplex() && points.size() == 3;
    if (is_triangle && !scene.map.is_of_space()) scene.area("simplex.fill", points);
    if (is_triangle && scene.map.is_of_space())
      draw_face(scene, corners_of(scene, simplex.all()), "simplex.fill");
    if (scene.shows_whole_simplex() && points.size() == 4) tetrahedron(scene);
    // The triangle of a tetrahedron that holds P. The query point lies beyond it.
    if (scene.map.is_of_space() && points.size() > 3 && gjk::vertex_count(face) == 3 &&
        !scene.shows(FacesBefore::kName))
      draw_face(scene, corners_of(scene, face), "simplex.face");
    for (int i = 0; i < simplex.count; ++i) {
      for (int j = i + 1; j < simplex.count; ++j) {
        const bool holds_p =
            gjk::contains(face, i) && gjk::contains(face, j) && gjk::vertex_count(face) == 2;
        // The edges of a tetrahedron are drawn already, some of them dashed.
        if (holds_p || (scene.shows_whole_simplex() && simplex.count < 4))
          edge(scene, holds_p ? "simplex.feature" : "simplex.edge", i, j);
      }
    }
  } else {
    chords(scene, face);
  }
  for (int i = 0; i < simplex.count; ++i) {
    if (!scene.shows_whole_simplex() && !gjk::contains(face, i)) continue;
    scene.simplex_vertex(simplex.vertices[i], "simplex");
  }
  if (scene.knows.phase_is(gjk::Phase::drop)) {
    const auto& dropped = scene.run.step(scene.frame).record.dropped;
    for (const WideVertex& vertex : dropped) dropped_vertex(scene, vertex);
    if (!scene.shows_difference || !scene.run.point_query() || !hides_weights(scene)) return;
    for (const WideVertex& vertex : dropped) weight_label(scene, vertex, "0");
    const Numbers numbers(scene.run.lesson);
    for (int i = 0; i < simplex.count; ++i)
      weight_label(scene, simplex.vertices[i], numbers.weight(simplex.weights[i]));
  }
}

namespace {

/// From a closest point to the other; where the run has ended, the length is the answer.
void shortest_line(SceneBuilder& scene, const Point& from, const Point& to) {
  scene.line("closest.line", from, to);
  const double distance = scene.positioned.trace.result.distance;
  if (scene.knows.has_ended && distance > 0.0 && !shows_gap(scene))
    scene.length_label("distance", distance, from, to);
}

}  // namespace

void closest_line(SceneBuilder& scene) {
  if (shows_closest_point(scene) && !reaches_query(scene)) {
    shortest_line(scene, scene.at_difference(scene.state.p), scene.at_difference(Vector2d::Zero()));
  }
}

void closest_point(SceneBuilder& scene) {
  if (!shows_closest_point(scene)) return;
  const Point p = scene.at_difference(scene.state.p);
  scene.disk("closest", p, kClosestRadius);
  if (reaches_query(scene)) return;  // Q's label names both
  const bool is_g = scene.shows(Projection::kName) && gjk::vertex_count(scene.state.region) == 2;
  Point away = p - scene.at_difference(Vector2d::Zero());
  // At a vertex that has a name of its own, P is called from the side.
  if (!scene.run.point_query() && gjk::vertex_count(scene.state.region) == 1)
    away = Point(-away.y(), away.x());
  scene.out.moving_labels.push_back(scene.label("P", is_g ? "P = G" : "P", "closest.label",
                                                type::kVertex, p, kPointRadius, away));
}

void witness_points(SceneBuilder& scene) {
  if (!shows_closest_point(scene)) return;
  Vector3d x = Vector3d::Zero();
  Vector3d y = Vector3d::Zero();
  for (int i = 0; i < scene.state.simplex.count; ++i) {
    x += scene.state.simplex.weights[i] * scene.vertex_of_x(scene.state.simplex.vertices[i]);
    y += scene.state.simplex.weights[i] * scene.vertex_of_y(scene.state.simplex.vertices[i]);
  }
  shortest_line(scene, scene.at(x), scene.at(y));
  const auto name = [&](const char* text, const Point& point, const Point& other) {
    scene.disk("closest", point, kClosestRadius);
    scene.out.moving_labels.push_back(scene.label(std::string("witness:") + text, text,
                                                  "closest.label", type::kVertex, point,
                                                  kPointRadius, point - other));
  };
  if (reaches_query(scene)) return name("x = y", scene.at(y), scene.at(y));
  name("x", scene.at(x), scene.at(y));
  name("y", scene.at(y), scene.at(x));
}

void support_point(SceneBuilder& scene) {
  constexpr double kAroundVertex = 12.0;
  const WideVertex& support = scene.state.support;
  scene.simplex_vertex(support, "support");
  const auto within = [&](const Point& at, const Subject& subject) {
    scene.diamond("support.vertex", at, kAroundVertex, subject);
    scene.disk("simplex.vertex", at, kSimplexRadius, subject);
  };
  const auto shares = [&](int gjk::VertexPair::*vertex) {
    const auto& all = scene.state.simplex.vertices;
    return std::any_of(all.begin(), all.begin() + scene.state.simplex.count,
                       [&](const WideVertex& v) { return v.pair.*vertex == support.pair.*vertex; });
  };
  using Kind = Subject::Kind;
  if (!scene.shows_difference) {
    if (shares(&gjk::VertexPair::x))
      within(scene.at(scene.vertex_of_x(support)), {Kind::vertex_of_x, support.pair.x});
    if (shares(&gjk::VertexPair::y))
      within(scene.at(scene.vertex_of_y(support)), {Kind::vertex_of_y, -1, support.pair.y});
  } else if (has_pair(scene.state.simplex, support.pair)) {
    within(scene.at_difference(support.w), subject_of(scene.run, support.pair));
  }
}

void search(SceneBuilder& scene) {
  if (scene.knows.support) scene.support_plane(scene.state.support.w, scene.state.d);
  // A search that is over points nowhere.
  if (scene.knows.direction && !scene.knows.has_ended) search_direction(scene);
  if (scene.knows.support) support_point(scene);
}

namespace {

void other_normal(SceneBuilder& scene) {
  const OtherNormal::Value& other = scene.effects.get<OtherNormal>(scene.frame);
  if (!other || !scene.shows_difference || scene.knows.has_ended) return;
  const Point p = scene.at_difference(scene.state.p);
  const Point along = scene.map.direction(other->d);
  const Point tip = p + scene.arrow_length(scene.state.p) * along;
  scene.arrow("direction.other", p, tip);
  scene.out.moving_labels.push_back(scene.label("arrow:other", "−d", "direction.label",
                                                type::kVertex, 0.5 * (p + tip), 0.0,
                                                Point(along.y(), -along.x())));
  if (!scene.knows.support) return;
  const Vector3d w =
      scene.positioned.y().world[other->support.y] - scene.positioned.x().world[other->support.x];
  scene.support_plane(w, other->d, "support.plane.other");
  scene.diamond("support.other", scene.at_difference(w), kSupportRadius,
                subject_of(scene.run, other->support));
}

}  // namespace

const Layer kOtherNormal{.effect = OtherNormal::kName,
                         .on = Layer::On::every_view,
                         .order = Layer::kOfTour + 10,
                         .draw = other_normal};

namespace {

/// The way from Q along the edge that it lies farthest beyond, where its turn is asked for.
void turn(SceneBuilder& scene) {
  const bool is_asked = scene.frame.question >= 0
                            ? scene.run.asked(scene.frame).ask == asks::kTurn.name
                            : tells_answer(scene.run, scene.frame, asks::kTurn.name);
  if (!is_asked) return;
  const gjk::Barycentric<double, 2> weights =
      gjk::barycentric(in_plane(scene.positioned.trace.initial.simplex), gjk::Face{7});
  const auto least = std::min_element(weights.numerator.begin(), weights.numerator.end());
  const auto beyond = static_cast<int>(least - weights.numerator.begin());
  const Point a = scene.vertex_at((beyond + 1) % 3);
  scene.arrow("ghost.arrow", scene.at_difference(Vector2d::Zero()), a);
  scene.arrow("ghost.arrow", a, scene.vertex_at((beyond + 2) % 3));
}

}  // namespace

const Layer kTurn{.effect = {}, .on = Layer::On::world, .order = Layer::kOfTour + 11, .draw = turn};

namespace {

/// At each vertex how many iterations a run that starts there takes, where that was asked for.
void starts(SceneBuilder& scene) {
  if (scene.frame.question >= 0 || !tells_answer(scene.run, scene.frame, asks::kStart.name)) return;
  const std::vector<Vector3d>& vertices = scene.positioned.y().world;
  const Point middle = scene.at(middle_of(vertices));
  for (const RunFromVertex& each : runs_from_each_vertex(scene.run, scene.positioned)) {
    const Point at = scene.at(vertices[static_cast<std::size_t>(each.vertex)]);
    scene.out.moving_labels.push_back(scene.label(
        fmt::format("starts:{}", each.vertex), fmt::format("{} iterations", each.iterations),
        "weight.label", type::kSmallVertex, at, kSupportRadius, middle - at));
  }
}

}  // namespace

const Layer kStarts{
    .effect = {}, .on = Layer::On::world, .order = Layer::kOfTour + 12, .draw = starts};

namespace {

/// Arrows along d and −d on the shapes, for the question which vertices lie farthest along them.
void asked_directions(SceneBuilder& scene) {
  const Frame& frame = scene.frame;
  if (frame.question < 0 || frame.answering_step < 0) return;
  const LessonQuestion& question = scene.run.asked(frame);
  if (question.ask != asks::kSupport.name) return;
  const Vector3d& d = scene.positioned.trace.steps[frame.answering_step].after.d;
  scene.search_arrow(scene.at(middle_of(scene.positioned.y().world)), d, kPairArrow, "d");
  scene.search_arrow(scene.at(middle_of(scene.positioned.x().world)), -d, kPairArrow, "−d");
}

}  // namespace

void search_between_shapes(SceneBuilder& scene) {
  asked_directions(scene);
  if (!scene.knows.support || scene.knows.has_ended) return;
  scene.search_arrow(scene.at(scene.vertex_of_y(scene.state.support)), scene.state.d, kPairArrow,
                     "d");
  scene.search_arrow(scene.at(scene.vertex_of_x(scene.state.support)), -scene.state.d, kPairArrow,
                     "−d");
  support_point(scene);
}

bool reaches_query(const SceneBuilder& scene) {
  return shows_closest_point(scene) && scene.knows.is_at_query;
}

void stage_step(SceneBuilder& scene) {
  if (scene.shows_difference && !scene.shows(Slab::kName)) best_support_line(scene);
  if (scene.shows(History::kName)) history(scene);
  simplex(scene);
  if (scene.shows(History::kName)) history_points(scene);
  if (scene.shows_difference) {
    closest_line(scene);
    if (scene.shows(SecondRun::kName)) second_run(scene);
    search(scene);
    closest_point(scene);
  } else {
    search_between_shapes(scene);
    witness_points(scene);
  }
}

}  // namespace gjkscope::layers
