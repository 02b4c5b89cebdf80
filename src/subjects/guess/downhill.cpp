// A walk over an outline to the point closest to Q, downhill: straight towards Q while the shape
// allows, else along the edge. In a shape that is not convex it gets stuck; in its hull it cannot.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "outlines/polygon.hpp"
#include "run/questions.hpp"
#include "subjects/guess/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::downhill {
namespace {

using Eigen::Vector2d;
using namespace sizes;

/// The turns of the walk; the first is its start.
struct Stop {
  Vector2d at = Vector2d::Zero();
  int edge = -1;  ///< The edge that it came along; -1: straight.
};

constexpr int kMostStops = 12;
constexpr double kStep = 1e-6;  // of the way to Q: far more than rounding, and nothing to see

/// The point where the straight way to q leaves the shape; nothing where it leaves at once.
std::optional<Vector2d> straight(const std::vector<Vector2d>& outline, const Vector2d& from,
                                 const Vector2d& q) {
  if (!is_inside(outline, from + kStep * (q - from))) return std::nullopt;
  double first = 1.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d edge = outline[(i + 1) % outline.size()] - outline[i];
    const Vector2d difference = q - from;
    const double area = difference.x() * edge.y() - difference.y() * edge.x();
    if (area == 0.0) continue;
    const Vector2d to = outline[i] - from;
    const double along_ray = (to.x() * edge.y() - to.y() * edge.x()) / area;
    const double along_edge = (to.x() * difference.y() - to.y() * difference.x()) / area;
    if (along_ray > kStep && along_ray < first && along_edge >= 0.0 && along_edge <= 1.0)
      first = along_ray;
  }
  return from + first * (q - from);
}

std::vector<Stop> walk(const std::vector<Vector2d>& outline, const Vector2d& start,
                       const Vector2d& q) {
  std::vector<Stop> stops = {{start}};
  while (static_cast<int>(stops.size()) < kMostStops) {
    const Vector2d at = stops.back().at;
    if (at == q) break;
    if (const std::optional<Vector2d> out = straight(outline, at, q)) {
      stops.push_back({*out});
      continue;
    }
    Stop best{at};
    for (int i = 0; i < static_cast<int>(outline.size()); ++i) {
      const Vector2d& a = outline[i];
      const Vector2d& b = outline[static_cast<std::size_t>(i + 1) % outline.size()];
      if (segment_distance(at, a, b) > kStep) continue;
      const Vector2d down = closest_on_segment(q, a, b);
      if ((down - q).norm() < (best.at - q).norm() - kStep) best = {down, i};
    }
    if (best.edge < 0) break;
    stops.push_back(best);
  }
  return stops;
}

struct Walks {
  std::vector<Vector2d> outline;
  std::vector<Vector2d> hull;
  std::vector<Stop> on_outline;
  std::vector<Stop> on_hull;
  Vector2d q = Vector2d::Zero();
  Vector2d closest = Vector2d::Zero();  ///< A point of the outline.
  int feature = 0;                      ///< Holds it: a vertex, or, counted on, an edge.
};

Walks walks_of(const LessonRun& run, const Frame& frame) {
  Walks out;
  const PositionedRun& positioned = run.run(frame);
  out.q = in_plane(positioned.x().world.front());
  out.outline = in_plane(positioned.y().world);
  for (const int i : convex_hull(out.outline)) out.hull.push_back(out.outline[i]);
  out.on_outline = walk(out.outline, out.outline.front(), out.q);
  out.on_hull = walk(out.hull, out.outline.front(), out.q);
  const int count = static_cast<int>(out.outline.size());
  double least = (out.outline[0] - out.q).norm();
  out.closest = out.outline[0];
  for (int i = 0; i < count; ++i) {
    const Vector2d& a = out.outline[i];
    const Vector2d& b = out.outline[static_cast<std::size_t>(i + 1) % out.outline.size()];
    const Vector2d at = closest_on_segment(out.q, a, b);
    if ((at - out.q).norm() > least) continue;
    least = (at - out.q).norm();
    out.closest = at;
    out.feature = at == a ? i : at == b ? (i + 1) % count : count + i;
  }
  return out;
}

/// The frames: stops of the walk on the outline, then its closest point, then stops on the
/// hull.
struct Shown {
  Shown(const LessonRun& run, const Frame& frame) : value(walks_of(run, frame)) {
    const int part = *part_of<int>(kTour, run, frame);
    const int stops = static_cast<int>(value.on_outline.size());
    stop = std::min(part, stops - 1);
    tells = part >= stops;
    if (part > stops) hull_stop = part - stops;
  }
  Walks value;
  int stop = 0;        ///< The last on the outline.
  bool tells = false;  ///< The closest point is shown.
  int hull_stop = 0;   ///< The last on the hull; 0: no hull yet.
  [[nodiscard]] bool is_stuck() const {
    return stop + 1 == static_cast<int>(value.on_outline.size());
  }
};

void frames(LessonRun& run, int index) {
  const Walks value = walks_of(run, {.run = index});
  guesses::add_part_frames(
      run, index, static_cast<int>(value.on_outline.size() + 1 + value.on_hull.size() - 1));
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const Shown shown(run, frame);
  if (shown.hull_stop > 0)
    return {.group = "hull", .label = fmt::format("step {}", shown.hull_stop)};
  if (shown.tells) return {.group = "outline", .label = "closest", .event = true};
  return {.group = "outline",
          .label = shown.stop == 0 ? "start" : fmt::format("step {}", shown.stop)};
}

constexpr AskInfo kAskWay{"way", "which way the walk goes on", "of step"};
constexpr std::array kAsks = {kAskWay, asks::kClosest};

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Shown shown(run, frame);
  if (shown.hull_stop > 0) return -1;
  if (question.ask == asks::kClosest.name) return shown.tells ? frame.step : -1;
  const bool slides = !shown.tells && shown.value.on_outline[shown.stop].edge >= 0;
  return slides && question.at.value_or(shown.stop) == shown.stop ? frame.step : -1;
}

std::string edge_name(const LessonRun& run, int edge) {
  const std::vector<std::string>& names = run.lesson.y().vertex_names;
  return names[edge] + names[static_cast<std::size_t>(edge + 1) % names.size()];
}

void question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  const LessonShape& y = story.run.lesson.y();
  const Shown shown(story.run, story.frame);
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  if (ask == kAskWay.name) {
    const Stop& next = shown.value.on_outline[shown.stop + 1];
    const Vector2d& at = shown.value.on_outline[shown.stop].at;
    const auto from = static_cast<std::size_t>(next.edge);
    const std::size_t to = (from + 1) % y.vertex_names.size();
    const Vector2d along = shown.value.outline[to] - shown.value.outline[from];
    asked.choices = {y.vertex_names[from], y.vertex_names[to]};
    asked.answer = asked.choices[(next.at - at).dot(along) < 0.0 ? 0 : 1];
    text.caption = fmt::format("Question: towards which end of {} does the walk get closer to {}?",
                               edge_name(story.run, next.edge), story.q);
    return;
  }
  const int count = static_cast<int>(y.vertex_names.size());
  asked.choices = y.vertex_names;
  for (int i = 0; i < count; ++i) asked.choices.push_back(edge_name(story.run, i));
  asked.answer = asked.choices[shown.value.feature];
  asked.place = shown.value.closest;
  text.caption = fmt::format(
      "Question: the walk has stopped. Which point of {} is closest to {}? Point at it.", y.name,
      story.q);
}

void words(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  const Walks& value = shown.value;
  const std::string& y = story.run.lesson.y().name;
  const bool on_hull = shown.hull_stop > 0;
  const std::vector<Stop>& stops = on_hull ? value.on_hull : value.on_outline;
  const int stop = on_hull ? shown.hull_stop : shown.stop;
  const auto away = [&](const Vector2d& at) { return story.numbers((at - value.q).norm()); };
  const std::string now = away(stops[stop].at);
  if (shown.tells && !on_hull) {
    text.caption = fmt::format("The closest point is only {} from {}. The walk is stuck at {}.",
                               away(value.closest), story.q, away(value.on_outline.back().at));
    text.detail = fmt::format(
        "A shape is convex if it holds the straight way between any two of its points. This one "
        "does not: the dashed way leaves it, and the outline first leads away from {}.",
        story.q);
    return;
  }
  if (stop == 0) {
    text.caption = fmt::format("Walk in {} from {} to the point closest to {}, without a map.", y,
                               story.run.lesson.y().vertex_names.front(), story.q);
    text.detail = fmt::format(
        "Go straight towards {0} as far as {1} reaches, then along the edge while the way to {0} "
        "gets shorter.",
        story.q, y);
    return;
  }
  const std::string was = away(stops[static_cast<std::size_t>(stop) - 1].at);
  const int edge = stops[stop].edge;
  const bool ends = stop + 1 == static_cast<int>(stops.size());
  if (on_hull && ends) {
    text.caption =
        fmt::format("On the hull the walk ends at the closest point, {} from {}.", now, story.q);
    text.detail = fmt::format(
        "A convex shape holds the straight way from any start to the closest point, and along it "
        "the distance to {} always falls.",
        story.q);
    return;
  }
  text.caption = fmt::format("{}: the distance to {} falls from {} to {}.",
                             edge < 0  ? fmt::format("Straight towards {}", story.q)
                             : on_hull ? std::string("Along the edge")
                                       : "Along " + edge_name(story.run, edge),
                             story.q, was, now);
  if (on_hull) {
    text.detail =
        "The convex hull is the smallest convex shape around the same points. It has no dent: here "
        "the walk starts again.";
  } else if (ends) {
    text.detail =
        fmt::format("Both ways along the edge lead away from {}: the walk stops.", story.q);
  } else {
    text.detail = fmt::format("Here {} ends. The walk goes on along its outline.", y);
  }
}

void stage(SceneBuilder& scene) {
  const Shown shown(scene.run, scene.frame);
  const Walks& value = shown.value;
  const bool on_hull = shown.hull_stop > 0;
  if (on_hull) {
    scene.area("hull.outline", scene.mapped(value.hull));
    scene.outline(scene.mapped(value.hull));
  }
  const std::vector<Stop>& stops = on_hull ? value.on_hull : value.on_outline;
  const int last = on_hull ? shown.hull_stop : shown.stop;
  for (int i = 0; i < last; ++i) {
    const auto from = static_cast<std::size_t>(i);
    scene.arrow("guess.walk", scene.at(stops[from].at), scene.at(stops[from + 1].at));
  }
  const Vector2d& at = stops[last].at;
  guesses::measured_line(scene, "closest.line", "way", at, value.q);
  scene.disk("path.now", scene.at(at), kSimplexRadius);
  if (!shown.tells || on_hull) return;
  scene.line("guess.way.straight", scene.at(at), scene.at(value.closest));
  guesses::measured_line(scene, "closest.line", "closest", value.closest, value.q);
  scene.disk("closest", scene.at(value.closest), kClosestRadius);
}

}  // namespace

const Tour kTour{
    .name = "downhill",
    .meaning =
        "step of a walk in Y, straight towards Q and along edges, then of the same in its hull; "
        "for a point query",
    .needs = {.path = PathUse::refused,
              .start = 1,
              .most_vertices = 24,
              .why_no_until = "frames go through a walk"},
    .add_frames = frames,
    .asks = kAsks,
    .answering_step = answering_step,
    .algorithm = &kGjkAlgorithm,
    .knows = guesses::knows_nothing,
    .position = position_in_lesson,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = question,
    .values = guesses::values,
};

}  // namespace gjkscope::downhill
