#include "session/pointing.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "outlines/polygon.hpp"
#include "picture/words.hpp"
#include "run/questions.hpp"
#include "session/hit.hpp"
#include "subjects/run/voronoi.hpp"
#include "subjects/space/solids.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Kind = Subject::Kind;

constexpr double kReach = 9.0;  // frame pixels around a vertex or an edge

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The choice of the spot that is nearest to a place of the page; empty where none is near.
std::string nearest_spot(const FrameQuestion& question, const LessonPictures::ShownView& shown,
                         const Point& page) {
  constexpr double kByEye = 24.0;  // a place is pointed at by eye
  const StageMap map(shown.card, shown.camera);
  double nearest = question.place ? kByEye : kReach;
  std::string chosen;
  for (std::size_t i = 0; i < question.spots.size(); ++i) {
    const std::optional<Spot>& spot = question.spots[i];
    if (!spot || spot->view != shown.kind) continue;
    const bool is_point = spot->from == spot->to;
    const double from_middle = segment_distance(page, map(spot->from), map(spot->to));
    double away = from_middle - spot->reach * map.scale();
    // A vertex goes before its edges.
    if (is_point && away < kReach) away = 0.0;
    if (!is_point || spot->reach > 0.0) away = std::max(away, 0.0) + 1.0;
    // If several are meant, the one whose middle is nearest counts.
    constexpr double kLess = 1e-3;  // than what tells vertices from edges
    away += kLess * from_middle;
    if (away >= nearest) continue;
    nearest = away;
    chosen = question.choices[i];
  }
  return chosen;
}

/// The vertex, edge or face of a simplex in space under a place of the page: of two faces the one
/// in front. None of them: 0.
gjk::Face face_in_space_at(const std::vector<Vector3d>& simplex, const StageMap& map,
                           const Point& page) {
  const int count = static_cast<int>(simplex.size());
  const auto at = [&](int i) { return map(simplex[i]); };
  gjk::Face found = 0;
  double nearest = kReach;
  for (int i = 0; i < count; ++i) {
    const double away = (page - at(i)).norm();
    if (away < nearest) {
      nearest = away;
      found = gjk::face_of(i);
    }
  }
  if (found != 0) return found;
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      const double away = segment_distance(page, at(i), at(j));
      if (away >= nearest) continue;
      nearest = away;
      found = static_cast<gjk::Face>(gjk::face_of(i) | gjk::face_of(j));
    }
  }
  if (found != 0) return found;
  std::optional<double> depth;
  for (int left_out = count == 4 ? 0 : 3; left_out < 4 && count > 2; ++left_out) {
    std::vector<Vector3d> corners;
    gjk::Face face = 0;
    for (int i = 0; i < count; ++i) {
      if (i == left_out) continue;
      corners.push_back(simplex[i]);
      face = static_cast<gjk::Face>(face | gjk::face_of(i));
    }
    const Point a = map(corners[0]);
    const Eigen::Matrix2d edges{{map(corners[1]).x() - a.x(), map(corners[2]).x() - a.x()},
                                {map(corners[1]).y() - a.y(), map(corners[2]).y() - a.y()}};
    const Vector2d shares = edges.inverse() * (page - a);
    if (!(shares.minCoeff() >= 0.0) || !(shares.sum() <= 1.0)) continue;
    const Vector3d point = corners[0] + shares.x() * (corners[1] - corners[0]) +
                           shares.y() * (corners[2] - corners[0]);
    const double towards_eye = map.towards_eye(point);
    if (depth && towards_eye <= *depth) continue;
    depth = towards_eye;
    found = face;
  }
  return found;
}

/// The choice of the region of the simplex, or in space of its feature.
std::string region_at(Session& session, const Hand& hand, std::size_t view, const Point& page) {
  const LessonPictures::ShownView shown = session.views()[view];
  const LessonRun& run = session.run();
  if (!shows_shapes(shown.kind)) return {};
  if (shown.kind == ViewKind::world && !run.point_query()) return {};
  const Frame& frame = session.frame();
  // In the world the polygon of a point query stands where it is.
  Vector3d shift = Vector3d::Zero();
  if (shown.kind == ViewKind::world) shift = run.run(frame).x().world.front();
  const WideSimplex& simplex = run.state(frame).simplex;
  const bool in_space = run.lesson.dimension == 3;
  std::vector<Vector3d> points;
  for (int i = 0; i < simplex.count; ++i)
    points.emplace_back(in_space ? Vector3d(simplex.vertices[i].w + shift) : simplex.vertices[i].w);
  const double reach = kReach * shown.camera.height / shown.card.size().y();
  const gjk::Face face =
      in_space ? face_in_space_at(points, StageMap(shown.card, shown.camera), page)
               : face_at(in_plane(points), session.effects().get<VoronoiRegions>(frame),
                         in_plane(hand.to_view(view, page)) - in_plane(shift), reach);
  return face == 0 ? std::string() : SimplexWords(run, simplex).face(face);
}

/// The choice that names the face under a place of the page, "face ABC" or "face ABC of Y".
std::string face_choice_at(Session& session, const LessonPictures::ShownView& shown,
                           const Point& page) {
  const LessonRun& run = session.run();
  if (run.lesson.dimension != 3 || shown.kind != ViewKind::world) return {};
  const StageMap map(shown.card, shown.camera);
  const ShapeSolids::Value& hulls = session.effects().get<ShapeSolids>(session.frame());
  for (std::size_t body = 0; body < hulls.size(); ++body) {
    for (const Polyhedron::Face& face : hulls[body].faces) {
      std::string name = "face ";
      std::vector<Vector2d> corners;
      for (const int vertex : face.vertices) {
        const auto i = static_cast<std::size_t>(vertex);
        name += run.lesson.bodies[body].vertex_names[i];
        corners.push_back(map(run.run(session.frame()).bodies[body].world[i]));
      }
      if (map.towards_eye(face.normal) <= 0.0 || !is_inside(corners, page)) continue;
      for (const std::string& choice : {name, name + " of " + run.lesson.bodies[body].name}) {
        if (holds(session.question()->choices, choice)) return choice;
      }
    }
  }
  return {};
}

/// The choice whose mark, a point or an area, lies under a place of the page: of several the one
/// whose middle is nearest.
std::string marked_choice(Session& session, const FrameQuestion& question, const Point& page) {
  const Picture& picture = session.picture();
  std::string chosen;
  double nearest = HUGE_VAL;
  for (const Mark& mark : picture.marks) {
    const auto found = std::find(question.subjects.begin(), question.subjects.end(), mark.subject);
    if (mark.subject.kind == Kind::none || found == question.subjects.end()) continue;
    if (mark.clip >= 0 && !is_in(picture.clips[mark.clip], page)) continue;
    const std::optional<MarkPlace> place = place_of(mark);
    if (!place) continue;
    const double away = (page - place->middle).norm();
    bool is_on = away <= kReach || is_inside(place->corners, page);
    for (std::size_t i = 0; i < place->corners.size(); ++i) {
      const Point& next = place->corners[(i + 1) % place->corners.size()];
      is_on = is_on || segment_distance(page, place->corners[i], next) <= kReach;
    }
    if (!is_on || away >= nearest) continue;
    nearest = away;
    chosen = question.choices[found - question.subjects.begin()];
  }
  return chosen;
}

/// The choice whose direction is nearest to that of a place in the view.
std::string nearest_direction(const FrameQuestion& question, const Vector2d& place) {
  double most = -HUGE_VAL;
  std::string chosen;
  for (std::size_t i = 0; i < question.spots.size(); ++i) {
    const double along =
        in_plane(question.spots[i]->to - question.spots[i]->from).dot(place - *question.origin);
    if (along > most) chosen = question.choices[i];
    most = std::max(most, along);
  }
  return chosen;
}

}  // namespace

std::optional<Point> origin_on_page(const Session& session) {
  const FrameQuestion* question = session.question();
  if (question == nullptr || !question->origin) return std::nullopt;
  for (const LessonPictures::ShownView& shown : session.views()) {
    if (shown.kind == question->spots.front()->view)
      return StageMap(shown.card, shown.camera)(*question->origin);
  }
  return std::nullopt;
}

std::optional<MarkPlace> place_of(const Mark& mark) {
  if (const Disk* disk = std::get_if<Disk>(&mark.shape)) return MarkPlace{disk->center, {}};
  if (const Polygon* polygon = std::get_if<Polygon>(&mark.shape)) {
    const Point middle = centroid(polygon->points);
    const bool is_point =
        std::all_of(polygon->points.begin(), polygon->points.end(),
                    [&](const Point& corner) { return (corner - middle).norm() <= 2.0 * kReach; });
    return MarkPlace{middle, is_point ? std::vector<Point>() : polygon->points};
  }
  return std::nullopt;
}

std::string name_of(const LessonRun& run, const Subject& subject) {
  if (subject.kind == Kind::difference_vertex) return run.pair_name({subject.x, subject.y});
  if (!is_vertex(subject)) return {};
  const LessonShape& shape = run.lesson.bodies[body_of(subject)];
  return shape.vertex_names[index_of(subject)];
}

std::optional<PointedChoice> pointed_choice(Session& session, const Hand& hand,
                                            const Subject& subject, const Point& page) {
  const FrameQuestion* question = session.question();
  const std::optional<std::size_t> view = hand.view_at(page);
  if (!question || !view) return std::nullopt;
  const LessonPictures::ShownView shown = session.views()[*view];
  if (question->origin) {
    if (shown.kind != question->spots.front()->view) return std::nullopt;
    // A click at P itself has no direction.
    if ((page - *origin_on_page(session)).norm() < kReach) return std::nullopt;
    const Vector2d place = in_plane(hand.to_view(*view, page));
    return PointedChoice{nearest_direction(*question, place), {}, place};
  }
  const std::string spot =
      shows_shapes(shown.kind) ? nearest_spot(*question, shown, page) : std::string();
  const auto with_place = [&](std::string choice) {
    PointedChoice out{std::move(choice)};
    if (question->place) out.place = in_plane(hand.to_view(*view, page));
    return out;
  };
  if (question->place && !spot.empty()) return with_place(spot);
  const std::string name = name_of(session.run(), subject);
  if (holds(question->choices, name)) return PointedChoice{name};
  if (question->ask == asks::kRegion.name) {
    const std::string region = region_at(session, hand, *view, page);
    if (holds(question->choices, region)) return PointedChoice{region};
    return std::nullopt;
  }
  if (!spot.empty()) return with_place(spot);
  if (std::string marked = marked_choice(session, *question, page); !marked.empty())
    return PointedChoice{std::move(marked)};
  if (std::string face = face_choice_at(session, shown, page); !face.empty())
    return PointedChoice{std::move(face)};
  if (question->pair.empty() || !is_vertex(subject)) return std::nullopt;
  return PointedChoice{name, subject.kind == Kind::vertex_of_y ? 0U : 1U};
}

}  // namespace gjkscope
