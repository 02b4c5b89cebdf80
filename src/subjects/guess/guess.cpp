#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "outlines/polygon.hpp"
#include "run/questions.hpp"
#include "subjects/guess/subject.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/slab_proof/shown.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::guesses {

using Eigen::Vector2d;
using namespace sizes;

void measured_line(SceneBuilder& scene, const std::string& role, const std::string& id,
                   const Vector2d& from, const Vector2d& to) {
  scene.line(role, scene.at(from), scene.at(to));
  scene.length_label(id, (to - from).norm(), scene.at(from), scene.at(to));
}

void add_part_frames(LessonRun& run, int index, int count) {
  const int last = last_step(run.lesson, run.runs[index].trace);
  for (int i = 0; i < count; ++i) run.frames.push_back({.run = index, .step = last, .part = i});
}

void knows_nothing(const Frame&, KnownFacts& facts) { facts = {}; }

bool overlap_words(const Story& story, FrameText& text) {
  if (story.trace.result.distance > 0.0) return false;
  text.caption = fmt::format("{} and {} overlap: the distance is 0.", story.run.lesson.x().name,
                             story.run.lesson.y().name);
  return true;
}

void values(const Story& story, FrameText& text) {
  text.values.emplace_back("x", story.run.lesson.x().name);
  text.values.emplace_back("y", story.run.lesson.y().name);
}

namespace {

enum class Part { pose, on_x, on_y, vertices, slab };
constexpr int kParts = 5;
constexpr std::array<std::string_view, kParts> kTicks = {"two shapes", "x", "y", "vertices",
                                                         "slab"};

Part part(const LessonRun& run, const Frame& frame) { return *part_of<Part>(kGuess, run, frame); }

void frames(LessonRun& run, int index) { add_part_frames(run, index, kParts); }

Tick tick(const LessonRun& run, const Frame& frame) {
  const auto at = static_cast<std::size_t>(part(run, frame));
  return {.group = at == 0  ? "start"
                   : at < 3 ? "closest points"
                            : "why",
          .label = std::string(kTicks[at])};
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Part answers = question.ask == asks::kClosestX.name ? Part::on_x : Part::on_y;
  return part(run, frame) == answers && has_closest(run, frame, question.ask) ? frame.step : -1;
}

/// The vertex nearest to a point of the outline, and how far it is from there.
std::pair<std::string, double> nearest_vertex(const LessonShape& shape,
                                              const std::vector<Eigen::Vector3d>& world,
                                              const Eigen::Vector3d& point) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < world.size(); ++i) {
    if ((world[i] - point).norm() < (world[best] - point).norm()) best = i;
  }
  return {shape.vertex_names[best], (world[best] - point).norm()};
}

std::string whereabouts(const Story& story, bool of_x) {
  const LessonShape& shape = of_x ? story.run.lesson.x() : story.run.lesson.y();
  const WideResult& result = story.trace.result;
  const auto [vertex, away] =
      nearest_vertex(shape, of_x ? story.positioned.x().world : story.positioned.y().world,
                     of_x ? result.x : result.y);
  const std::string name = of_x ? "x" : "y";
  if (away == 0.0) return fmt::format("{} is the vertex {}.", name, vertex);
  return fmt::format("{} lies on {}, {} from {}, the nearest vertex.", name,
                     feature_name(story.run, result.simplex, of_x), story.numbers(away), vertex);
}

void words(const Story& story, FrameText& text) {
  if (overlap_words(story, text)) return;
  const std::string& x = story.run.lesson.x().name;
  const std::string& y = story.run.lesson.y().name;
  const std::string distance = story.numbers(story.trace.result.distance);
  switch (part(story.run, story.frame)) {
    case Part::pose:
      text.caption = fmt::format("How far apart are {} and {}?", x, y);
      text.detail = fmt::format(
          "Many ways lead from a point of {} to a point of {}. The shortest joins the closest "
          "points; its length is the distance.",
          x, y);
      return;
    case Part::on_x:
      text.caption = fmt::format("x is the point of {} closest to {}.", x, y);
      text.detail = whereabouts(story, true);
      return;
    case Part::on_y:
      text.caption =
          fmt::format("y is the point of {} closest to {}. The distance is {}.", y, x, distance);
      text.detail = whereabouts(story, false);
      return;
    case Part::vertices:
      text.caption =
          fmt::format("From each vertex the way to the other shape is {} or more.", distance);
      text.detail =
          "Ways are drawn from the two nearest vertices of each shape. Whoever guesses a longer "
          "way is wrong by its extra length.";
      return;
    case Part::slab:
      text.caption = fmt::format(
          "No two points are closer. A slab is the strip between two parallel lines: "
          "no point of {} or {} lies in this one.",
          x, y);
      text.detail = fmt::format(
          "Both its sides are perpendicular to the segment xy. Every way from {} to {} has to "
          "cross it, and it is {} wide.",
          x, y, distance);
      return;
  }
}

/// From the two vertices that are nearest to the other shape.
void lines_from_vertices(SceneBuilder& scene, const std::vector<Vector2d>& from,
                         const std::vector<Vector2d>& to, const std::string& id) {
  std::vector<std::pair<Vector2d, Vector2d>> lines;
  for (const Vector2d& vertex : from) {
    Vector2d best = to.front();
    for (std::size_t k = 0; k < to.size(); ++k) {
      const Vector2d at = closest_on_segment(vertex, to[k], to[(k + 1) % to.size()]);
      if ((at - vertex).norm() < (best - vertex).norm()) best = at;
    }
    lines.emplace_back(vertex, best);
  }
  std::sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
    return (a.second - a.first).norm() < (b.second - b.first).norm();
  });
  for (std::size_t i = 0; i < std::min<std::size_t>(2, lines.size()); ++i)
    measured_line(scene, "guess.way", fmt::format("{}{}", id, i), lines[i].first, lines[i].second);
}

void stage(SceneBuilder& scene) {
  if (!(scene.positioned.trace.result.distance > 0.0)) return;
  const Part at = part(scene.run, scene.frame);
  const Vector2d x = in_plane(scene.positioned.trace.result.x);
  const Vector2d y = in_plane(scene.positioned.trace.result.y);
  if (at == Part::vertices) {
    const std::vector<Vector2d> of_x = in_plane(scene.positioned.x().world);
    const std::vector<Vector2d> of_y = in_plane(scene.positioned.y().world);
    lines_from_vertices(scene, of_x, of_y, "x");
    lines_from_vertices(scene, of_y, of_x, "y");
  }
  if (at == Part::slab) slabs::strip(scene, x, y);
  if (at == Part::on_y || at == Part::slab) measured_line(scene, "closest.line", "distance", x, y);
  const auto point = [&](const Vector2d& place, const Vector2d& other, const std::string& name) {
    scene.disk("closest", scene.at(place), kClosestRadius);
    scene.out.moving_labels.push_back(scene.label("point:" + name, name, "closest.label",
                                                  type::kVertex, scene.at(place), kClosestRadius,
                                                  scene.at(place) - scene.at(other)));
  };
  if (at >= Part::on_x) point(x, y, "x");
  if (at >= Part::on_y) point(y, x, "y");
}

}  // namespace

const Tour kGuess{
    .name = "guess",
    .meaning =
        "part of a first look at two shapes that are apart: the question, the closest points, the "
        "ways from vertices, the slab",
    .needs = {.most_vertices = 8, .why_no_until = "frames show how the run ends"},
    .add_frames = frames,
    .asks = asks::kOfAnswers,
    .answering_step = answering_step,
    .algorithm = &kGjkAlgorithm,
    .knows = knows_nothing,
    .position = position_in_lesson,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = captions::closest_question,
    .values = values,
};

}  // namespace gjkscope::guesses

namespace gjkscope {

const SubjectParts subjects::guess{
    .tours = {&guesses::kGuess, &vertex_pairs::kTour, &downhill::kTour},
    .legend = {{"guess.way", "shortest way from a vertex"},
               {"guess.way.straight", "straight way to the closest point"},
               {"pair.link", "a pair of vertices"},
               {"path.now", "where the walk is"},
               {"guess.sample", "a point that is tried"},
               {"guess.pair", "nearest of those that are tried"},
               {"guess.walk", "the walk"},
               {"hull.outline", "convex hull"},
               {"slab.side", "side of the slab"}},
};

}  // namespace gjkscope
