#include "subjects/difference/tour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "outlines/minkowski.hpp"
#include "outlines/polygon.hpp"
#include "run/questions.hpp"
#include "subjects/difference/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::tours {
namespace {

constexpr int kMostVertices = 8;

/// In the order of Frame::part.
std::vector<BuildFrame> build_frames(const Lesson& lesson) {
  using enum BuildPart;
  const int per_x = static_cast<int>(lesson.y().vertices.size());
  const int all = per_x * static_cast<int>(lesson.x().vertices.size());
  std::vector<BuildFrame> frames = {{start, 0}, {pair, 1}};
  for (int made = per_x; made <= all; made += per_x) frames.push_back({copy, made});
  for (const BuildPart part : {mirror, slide, hull, edges, any, shortest})
    frames.push_back({part, all});
  return frames;
}

void pairs_frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[index].trace);
  const int count = static_cast<int>(build_frames(run.lesson).size());
  for (int i = 0; i < count; ++i) run.frames.push_back({.run = index, .step = last, .part = i});
}

std::string pairs_position(const LessonRun& run, int index) {
  return position_in_lesson(run, index);
}

Tick pairs_tick(const LessonRun& run, const Frame& frame) {
  using enum BuildPart;
  const auto [part, made] = *build_frame(run, frame);
  const std::string& x = run.lesson.x().name;
  const std::string& y = run.lesson.y().name;
  const int per_x = static_cast<int>(run.lesson.y().vertices.size());
  switch (part) {
    case start:
      return {.group = "start"};
    case pair:
      return {.group = "differences", .label = run.pair_name({0, 0})};
    case copy:
      return {.group = "differences",
              .label = fmt::format("{} − {}", y, run.lesson.x().vertex_names[(made - 1) / per_x])};
    case mirror:
      return {.group = fmt::format("{} + (−{})", y, x), .label = "−" + x};
    case slide:
      return {.group = fmt::format("{} + (−{})", y, x), .label = "at " + y};
    case hull:
      return {.group = "Z", .label = "hull", .event = true};
    case edges:
      return {.group = "Z", .label = "edges"};
    case any:
      return {.group = "distance", .label = "y − x"};
    case shortest:
      return {.group = "distance", .label = "shortest", .event = true};
  }
  return {};
}

constexpr AskInfo kAskInside{"inside", "a difference that is no vertex of Z"};
constexpr std::array kPairsAsks = {kAskPlace, kAskInside, asks::kClosestX, asks::kClosestY};

/// The hull of all differences, and the difference deepest inside: -1 where none is inside.
struct Inside {
  std::vector<CloudPoint> cloud;
  std::vector<int> hull;
  int deepest = -1;
};

Inside inside_of(const PositionedRun& run) {
  Inside out;
  out.cloud = minkowski_cloud(in_plane(run.x().world), in_plane(run.y().world));
  std::vector<Eigen::Vector2d> points;
  for (const CloudPoint& each : out.cloud) points.push_back(each.z);
  out.hull = convex_hull(points);
  double most = 0.01 * (points[out.hull.back()] - points[out.hull.front()]).norm();
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < out.hull.size(); ++k) {
      const Eigen::Vector2d& to = points[out.hull[(k + 1) % out.hull.size()]];
      depth = std::min(depth, segment_distance(points[i], points[out.hull[k]], to));
    }
    if (depth <= most) continue;
    most = depth;
    out.deepest = i;
  }
  return out;
}

int pairs_answer(const LessonRun& run, const Frame&, const Frame& frame,
                 const LessonQuestion& question) {
  if (frame.step < 0 || !is_at(frame, question)) return -1;
  const auto [part, made] = *build_frame(run, frame);
  if (question.ask == kAskPlace.name) {
    const int per_x = static_cast<int>(run.lesson.y().vertices.size());
    const bool is_second = part == BuildPart::copy && made == 2 * per_x;
    return is_second && per_x > 2 && run.lesson.x().vertices.size() > 2 ? frame.step : -1;
  }
  const bool answers = question.ask == kAskInside.name
                           ? part == BuildPart::hull && inside_of(run.run(frame)).deepest >= 0
                           : part == BuildPart::shortest && has_closest(run, frame, question.ask);
  return answers ? frame.step : -1;
}

void place_question(const Story& story, FrameText& text) {
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskPlace.name), {}, {}});
  const gjk::VertexPair right = kAskedDifference;
  std::vector<std::string> others;
  for (const gjk::VertexPair pair : places_to_choose(story.run)) {
    asked.choices.push_back(fmt::format("place {}", asked.choices.size() + 1));
    const Eigen::Vector3d at =
        story.positioned.y().world[pair.y] - story.positioned.x().world[pair.x];
    asked.spots.push_back(Spot{ViewKind::difference, at, at});
    if (pair == right)
      asked.answer = asked.choices.back();
    else
      others.push_back(story.run.pair_name(pair));
  }
  text.caption = fmt::format(
      "Question: {} is the arrow from {} to {}, moved so that it starts at O. Where does it end? "
      "Point at it.",
      story.run.pair_name(right), story.run.lesson.x().vertex_names[right.x],
      story.run.lesson.y().vertex_names[right.y]);
  asked.refuted = fmt::format("The other places were {}.", and_list(others));
}

void pairs_question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  if (ask == kAskPlace.name) return place_question(story, text);
  if (ask != kAskInside.name) return captions::closest_question(story, text);
  const Inside inside = inside_of(story.positioned);
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  asked.answer = story.run.pair_name(inside.cloud[inside.deepest].pair);
  asked.choices = {asked.answer};
  constexpr std::size_t kVertices = 3;
  for (std::size_t k = 0; k < kVertices; ++k) {
    asked.choices.push_back(
        story.run.pair_name(inside.cloud[inside.hull[k * inside.hull.size() / kVertices]].pair));
  }
  std::sort(asked.choices.begin(), asked.choices.end());
  text.caption = "Question: Z will be the hull of these points. Which of them is no vertex of Z?";
}

}  // namespace

const Tour kPairs{
    .name = "pairs",
    .meaning =
        "part of how Y − X is built: a first difference, Y less each vertex of X, "
        "−X at each vertex of Y, the hull, its edges, the shortest difference; at "
        "most 8 vertices in each shape",
    .needs = {.most_vertices = kMostVertices},
    .add_frames = pairs_frames,
    .asks = kPairsAsks,
    .answering_step = pairs_answer,
    .algorithm = &kGjkAlgorithm,
    .position = pairs_position,
    .tick = pairs_tick,
    .words = captions::pairs,
    .stage = layers::building,
    .question = pairs_question,
};

}  // namespace gjkscope::tours

namespace gjkscope {

std::optional<BuildFrame> build_frame(const LessonRun& run, const Frame& frame) {
  const auto index = part_of<std::size_t>(tours::kPairs, run, frame);
  return index ? std::optional(tours::build_frames(run.lesson)[*index]) : std::nullopt;
}

std::vector<gjk::VertexPair> places_to_choose(const LessonRun& run) {
  const int last_x = static_cast<int>(run.lesson.x().vertices.size()) - 1;
  return {{1, 0}, {last_x, 2}, kAskedDifference, {1, 1}};
}

}  // namespace gjkscope
