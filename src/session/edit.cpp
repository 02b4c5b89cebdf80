#include "session/edit.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "lesson/names.hpp"
#include "lesson/schema.hpp"
#include "outlines/polygon.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/second_run/second_run.hpp"
#include "subjects/second_run/subject.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::edit {
namespace {

using Eigen::Vector2d;

using Eigen::Vector3d;

/// A shape that is not turned keeps its digits.
Eigen::Matrix3d rotation(double degrees, const Vector3d& axis) {
  if (degrees == 0.0) return Eigen::Matrix3d::Identity();
  return turn_of({Vector3d::Zero(), degrees, axis});
}

LessonMotion* motion_of(Lesson& lesson, std::size_t body) {
  if (!lesson.path_of_shapes) return nullptr;
  LessonMotion& motion = lesson.path_of_shapes->motions[body];
  return motion.points.empty() ? nullptr : &motion;
}

/// The number of vertices of the outline that vertex `index` belongs to.
int& outline_of(LessonShape& shape, int index) {
  auto outline = shape.outlines.begin();
  for (; index >= *outline; ++outline) index -= *outline;
  return *outline;
}

/// The first simplex is that of the first vertices, or none, as the lesson had some or none.
void forget_start(Lesson& lesson) {
  lesson.options.start = {.count = std::min(lesson.options.start.count, 1)};
}

std::string free_name(const Lesson& lesson, std::size_t body) {
  const auto taken = [&](const std::string& name) {
    const auto has = [&](const LessonShape& shape) {
      return std::find(shape.vertex_names.begin(), shape.vertex_names.end(), name) !=
             shape.vertex_names.end();
    };
    return std::any_of(lesson.bodies.begin(), lesson.bodies.end(), has);
  };
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    std::string name(1, letter);
    // The names of the origin, the closest point and the query point.
    if (letter != 'O' && letter != 'P' && letter != 'Q' && !taken(name)) return name;
  }
  for (int i = 1;; ++i) {
    std::string name = fmt::format("{}{}", body == 0 ? "x" : "y", i);
    if (!taken(name)) return name;
  }
}

}  // namespace

Vector3d to_local(const Placement& placement, const Vector3d& world) {
  return rotation(-placement.rotate_degrees, placement.axis) * (world - placement.translate);
}

void put_vertex(Lesson& lesson, std::size_t body, int index, const Placement& placement,
                const Vector3d& world) {
  lesson.bodies[body].vertices[index] = to_local(placement, world);
}

void move_shape(Lesson& lesson, std::size_t body, const Vector3d& by) {
  if (LessonMotion* motion = motion_of(lesson, body)) {
    for (Vector3d& point : motion->points) point += by;
    return;
  }
  LessonShape& shape = lesson.bodies[body];
  // A shape at rest at its own origin stays there: its vertices are what the reader sees.
  if (shape.translate.isZero() && shape.rotate_degrees == 0.0) {
    for (Vector3d& vertex : shape.vertices) vertex += by;
  } else {
    shape.translate += by;
  }
}

void nudge(Lesson& lesson, std::size_t body, int index, const PositionedRun& now,
           const Vector3d& by) {
  const auto& world = now.bodies[body].world;
  if (index < 0 || world.size() == 1) return move_shape(lesson, body, by);
  put_vertex(lesson, body, index, now.bodies[body].placement, world[index] + by);
}

void turn_shape(Lesson& lesson, std::size_t body, double degrees) {
  LessonShape& shape = lesson.bodies[body];
  const Vector3d middle = middle_of(shape.vertices);
  const Vector3d stays = (rotation(shape.rotate_degrees, shape.axis) -
                          rotation(shape.rotate_degrees + degrees, shape.axis)) *
                         middle;
  shape.rotate_degrees = std::remainder(shape.rotate_degrees + degrees, 360.0);
  if (LessonMotion* motion = motion_of(lesson, body)) {
    for (double& turn : motion->turns) turn += degrees;
    for (Vector3d& point : motion->points) point += stays;
  } else {
    shape.translate += stays;
  }
}

int insert_vertex(Lesson& lesson, std::size_t body, int edge, const Placement& placement,
                  const Vector3d& world) {
  const std::string name = free_name(lesson, body);
  LessonShape& shape = lesson.bodies[body];
  const int index = edge + 1;
  if (!shape.outlines.empty()) ++outline_of(shape, edge);
  shape.vertices.insert(shape.vertices.begin() + index, to_local(placement, world));
  shape.vertex_names.insert(shape.vertex_names.begin() + index, name);
  for (gjk::VertexPair& pair : lesson.options.start.pairs) {
    int& named = body == 0 ? pair.x : pair.y;
    if (named >= index) ++named;
  }
  return index;
}

bool erase_vertex(Lesson& lesson, std::size_t body, int index) {
  LessonShape& shape = lesson.bodies[body];
  if (shape.vertices.size() < 2) return false;
  if (!shape.outlines.empty()) {
    int& count = outline_of(shape, index);
    if (count <= limits::kOutlineVertices) return false;
    --count;
  }
  shape.vertices.erase(shape.vertices.begin() + index);
  shape.vertex_names.erase(shape.vertex_names.begin() + index);
  bool forgotten = false;
  for (gjk::VertexPair& pair : lesson.options.start.pairs) {
    int& named = body == 0 ? pair.x : pair.y;
    forgotten = forgotten || named == index;
    if (named > index) --named;
  }
  if (forgotten) forget_start(lesson);
  lesson.expect.supports.reset();
  return true;
}

std::vector<Vector2d> regular_polygon(int corners) {
  std::vector<Vector2d> unit;
  for (int i = 0; i < corners; ++i) {
    const double angle = std::numbers::pi * ((2.0 * i - 1.0) / corners - 0.5);
    unit.emplace_back(std::cos(angle), std::sin(angle));
  }
  return unit;
}

void reshape(Lesson& lesson, std::size_t body, const std::vector<Vector2d>& unit) {
  const auto box_of = [&](std::size_t of) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& vertex : lesson.bodies[of].vertices) box.extend(vertex);
    return box;
  };
  const Vector3d center = box_of(body).center();
  double radius = 0.5 * box_of(body).sizes().maxCoeff();
  if (radius == 0.0) radius = 0.5 * box_of(1 - body).sizes().maxCoeff();
  if (radius == 0.0) radius = 1.0;
  // A polygon becomes a prism in space.
  const bool is_prism = lesson.dimension == 3 && unit.size() > 2;
  std::vector<Vector3d> corners;
  for (const double z : is_prism ? std::vector<double>{-1.0, 1.0} : std::vector<double>{0.0}) {
    for (const Vector2d& vertex : unit)
      corners.emplace_back(center + radius * Vector3d(vertex.x(), vertex.y(), z));
  }
  LessonShape& shape = lesson.bodies[body];
  shape.outlines.clear();
  shape.vertices = corners;
  if (shape.vertex_names.size() > corners.size()) shape.vertex_names.resize(corners.size());
  constexpr std::size_t kMostNamed = 99;  // names have up to three characters
  if (corners.size() > kMostNamed) {
    shape.vertex_names = numbered_names(body == 0 ? 'x' : 'y', corners.size());
  }
  while (shape.vertex_names.size() < corners.size())
    shape.vertex_names.push_back(free_name(lesson, body));
  const auto is_gone = [&](const gjk::VertexPair& pair) {
    return static_cast<std::size_t>(body == 0 ? pair.x : pair.y) >= corners.size();
  };
  const auto& pairs = lesson.options.start.pairs;
  if (std::any_of(pairs.begin(), pairs.end(), is_gone)) forget_start(lesson);
  lesson.expect.supports.reset();
}

void make_random_pair(Lesson& lesson, const PositionedRun& now, std::uint64_t seed) {
  constexpr int kSteps = 8;  // from the middle of a shape to its sides: numbers stay short
  std::mt19937_64 bits(seed);
  const auto among = [&](int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  };
  const auto place = [&] { return 1.0 / kSteps * among(-kSteps, kSteps); };
  const auto polygon = [&] {
    std::vector<Vector2d> unit;
    while (unit.size() < 3) {
      // As wide as can be, so that pairs made one after the other do not shrink.
      std::vector<Vector2d> points = {{-1.0, place()}, {1.0, place()}};
      for (int more = among(1, 6); more > 0; --more) points.emplace_back(place(), place());
      unit.clear();
      for (const int corner : convex_hull(points)) unit.push_back(points[corner]);
    }
    return unit;
  };
  Eigen::AlignedBox2d x;
  Eigen::AlignedBox2d y;
  for (const Vector2d& vertex : in_plane(now.x().world)) x.extend(vertex);
  for (const Vector2d& vertex : in_plane(now.y().world)) y.extend(vertex);
  const double reach = 0.5 * (x.sizes().maxCoeff() + y.sizes().maxCoeff());
  for (const std::size_t body : {0, 1}) reshape(lesson, body, polygon());
  constexpr double kFarthest = 1.5;
  const double across = kFarthest * place();
  const double up = kFarthest * place();
  move_shape(lesson, 1, in_space(Vector2d(x.center() + reach * Vector2d(across, up) - y.center())));
}

std::optional<NearestEdge> nearest_edge(const std::vector<Vector2d>& vertices,
                                        const std::vector<VertexRange>& outlines,
                                        const Vector2d& world) {
  if (vertices.size() < 2) return std::nullopt;
  NearestEdge nearest{0, HUGE_VAL};
  for (const VertexRange& outline : outlines) {
    const auto at = [&](int i) {
      const int index = outline.first + i % outline.count;
      return vertices[index];
    };
    for (int i = 0; i < outline.count; ++i) {
      const double distance = segment_distance(world, at(i), at(i + 1));
      if (distance < nearest.distance) nearest = {outline.first + i, distance};
    }
  }
  return nearest;
}

namespace {

/// In space a table or a path that a tour cannot do without, and the start that it needs, would be
/// gone.
bool shows_tour(const Lesson& lesson) {
  const TourNeeds& needs = vocabulary().tour(lesson.tour)->needs;
  const bool has_needs = !needs.required_tables().empty() || needs.start > 0;
  return is_shown_of(needs.shown_of, lesson.dimension) && (lesson.dimension == 2 || !has_needs);
}

/// Takes away what cannot be shown of shapes of the lesson's dimension.
void keep_what_is_shown(Lesson& lesson) {
  if (!shows_tour(lesson)) {
    lesson.tour = Lesson().tour;
    lesson.settings = {};
    lesson.phases.clear();
    lesson.until.reset();
  }
  const Term* listing = find_term(vocabulary().listings, lesson.listing);
  if (listing == nullptr || !is_shown_of(listing->shown_of, lesson.dimension))
    lesson.listing = listings::kGjk.name;
  lesson.panel = {std::string(blocks::kPseudocode.name), std::string(blocks::kSimplex.name),
                  std::string(blocks::kBounds.name)};
  std::erase_if(lesson.views, [](const LessonView& view) { return !shows_shapes(view.kind); });
  if (lesson.views.empty())
    lesson.views = {{ViewKind::world, "", {}, {}}, {ViewKind::difference, "", {}, {}}};
}

}  // namespace

template <int D>
Lesson with_shapes(Lesson lesson, const CaseIn<D>& shapes) {
  const Lesson plain = lesson_of(shapes, "", lesson.scalar);
  lesson.x() = plain.x();
  lesson.y() = plain.y();
  lesson.options.start = plain.options.start;
  lesson.path_of_shapes.reset();
  lesson.warm_start = false;
  lesson.questions.clear();
  lesson.opening.clear();
  lesson.next.clear();
  lesson.in_space.clear();
  lesson.expect = {};
  lesson.expect.stop =
      name_of(gjk::StopReason::repeated_support);  // saving writes what it comes to
  lesson.dimension = plain.dimension;
  if (D == 3 || !shows_tour(lesson)) keep_what_is_shown(lesson);
  for (LessonView& view : lesson.views) {
    std::erase_if(view.effects, [](const std::string& name) {
      return !is_shown_of(find_term(vocabulary().effects, name)->shown_of, D);
    });
  }
  std::erase_if(lesson.panel, [](const std::string& name) {
    return !is_shown_of(find_term(vocabulary().blocks, name)->shown_of, D);
  });
  const bool are_few = shapes.a.size() * shapes.b.size() <= kMostPairs;
  for (LessonView& view : lesson.views) {
    view.camera.reset();
    view.close_up.reset();
    view.eye.reset();
    if (are_few) continue;
    std::erase_if(view.effects, [](const std::string& name) {
      return find_term(vocabulary().effects, name)->pairs_vertices;
    });
  }
  return lesson;
}

template Lesson with_shapes(Lesson lesson, const CaseIn<2>& shapes);
template Lesson with_shapes(Lesson lesson, const CaseIn<3>& shapes);

Lesson with_shapes(Lesson lesson, const ReadCase& read) {
  return read.in_space ? with_shapes(std::move(lesson), *read.in_space)
                       : with_shapes(std::move(lesson), *read.value);
}

Lesson with_tour(Lesson lesson, const Algorithm& algorithm) {
  const std::span<const Tour* const> tours = registered_tours();
  const Tour& tour = **std::find_if(
      tours.begin(), tours.end(), [&](const Tour* each) { return each->algorithm == &algorithm; });
  lesson.tour = tour.name;
  lesson.panel = {std::string(blocks::kPseudocode.name)};
  for (const Block* block : registered_blocks()) {
    if (block->tour == lesson.tour && is_shown_of(block->shown_of, lesson.dimension))
      lesson.panel.emplace_back(block->name);
  }
  for (const Listing* listing : registered_listings()) {
    if (listing->tour == lesson.tour) lesson.listing = listing->name;
  }
  lesson.until.reset();
  lesson.phases.clear();
  lesson.questions.clear();
  lesson.expect.answers.clear();
  lesson.settings = {};
  for (LessonShape& shape : lesson.bodies) {
    if (!tour.needs.takes_radius) shape.radius = 0.0;
  }
  std::erase_if(lesson.views, [](const LessonView& view) { return !shows_shapes(view.kind); });
  if (lesson.views.empty())
    lesson.views = {{ViewKind::world, "", {}, {}}, {ViewKind::difference, "", {}, {}}};
  for (LessonView& view : lesson.views) {
    std::erase_if(view.effects, [](const std::string& name) {
      const Term* effect = find_term(vocabulary().effects, name);
      return effect == nullptr || !effect->tour.empty() || !effect->table.empty();
    });
  }
  return lesson;
}

Lesson with_second_run(Lesson lesson, std::optional<ScalarKind> beside) {
  const bool has_listing = lesson.has_block(blocks::kPseudocode.name);
  const std::string block(blocks::kTwoRuns.name);
  const std::string effect(SecondRun::kName);
  lesson.settings = {};
  if (beside) lesson.settings = TourSettings(LessonSecond{.scalar = beside});
  std::erase(lesson.panel, block);
  if (beside) lesson.panel = {block};
  if (beside && has_listing) lesson.panel.emplace(lesson.panel.begin(), blocks::kPseudocode.name);
  const bool of_point = lesson.x().vertices.size() == 1;
  for (LessonView& view : lesson.views) {
    std::erase(view.effects, effect);
    const bool shows_difference =
        view.kind == ViewKind::difference || (of_point && view.kind == ViewKind::world);
    if (beside && shows_difference) view.effects.push_back(effect);
  }
  return lesson;
}

}  // namespace gjkscope::edit
