#include <fmt/format.h>

#include <array>

#include "run/questions.hpp"
#include "subjects/guess/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::vertex_pairs {
namespace {

using Eigen::Vector2d;
using namespace sizes;

enum class Part { all, nearest, closest, sampled };
constexpr int kParts = 4;
constexpr int kSamples = 10;  // of an edge

constexpr AskInfo kAskPair{"vertex-pair", "the two vertices that are nearest to each other"};
constexpr std::array kAsks = {kAskPair, asks::kClosestX, asks::kClosestY};

Part part(const LessonRun& run, const Frame& frame) { return *part_of<Part>(kTour, run, frame); }

void frames(LessonRun& run, int index) { guesses::add_part_frames(run, index, kParts); }

Tick tick(const LessonRun& run, const Frame& frame) {
  constexpr std::array<std::string_view, kParts> kLabels = {"all pairs", "nearest", "closest",
                                                            "samples"};
  const Part at = part(run, frame);
  return {.group = at < Part::closest ? "vertices" : "all points",
          .label = std::string(kLabels[static_cast<std::size_t>(at)])};
}

/// The nearest two of points of X and of Y.
struct NearestTwo {
  std::size_t x = 0;
  std::size_t y = 0;
  double distance = 0.0;
};

NearestTwo nearest_two(const std::vector<Vector2d>& x, const std::vector<Vector2d>& y) {
  NearestTwo best{0, 0, (y[0] - x[0]).norm()};
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double distance = (y[k] - x[i]).norm();
      if (distance < best.distance) best = {i, k, distance};
    }
  }
  return best;
}

std::vector<Vector2d> sampled(const std::vector<Vector2d>& outline) {
  std::vector<Vector2d> out;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& to = outline[(i + 1) % outline.size()];
    for (int k = 0; k < kSamples; ++k)
      out.push_back(outline[i] + static_cast<double>(k) / kSamples * (to - outline[i]));
  }
  return out;
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const Part at = part(run, frame);
  if (question.ask == kAskPair.name) {
    const bool are_apart = run.run(frame).trace.result.distance > 0.0;
    return at == Part::nearest && are_apart ? frame.step : -1;
  }
  return at == Part::closest && has_closest(run, frame, question.ask) ? frame.step : -1;
}

void question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  if (ask != kAskPair.name) return captions::closest_question(story, text);
  const Lesson& lesson = story.run.lesson;
  const NearestTwo two =
      nearest_two(in_plane(story.positioned.x().world), in_plane(story.positioned.y().world));
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  const auto both = [](const std::string& a, const std::string& b) { return a + " and " + b; };
  for (const std::string& y : lesson.y().vertex_names) {
    for (const std::string& x : lesson.x().vertex_names) asked.choices.push_back(both(y, x));
  }
  asked.pair = {{lesson.y().name, lesson.y().vertex_names},
                {lesson.x().name, lesson.x().vertex_names}};
  asked.answer = both(lesson.y().vertex_names[two.y], lesson.x().vertex_names[two.x]);
  text.caption =
      fmt::format("Question: which vertex of {} and which of {} are nearest to each other?",
                  lesson.y().name, lesson.x().name);
  text.detail =
      fmt::format("{}: {}      {}: {}", lesson.y().name, listed_choices(lesson.y().vertex_names),
                  lesson.x().name, listed_choices(lesson.x().vertex_names));
}

void words(const Story& story, FrameText& text) {
  if (guesses::overlap_words(story, text)) return;
  const Lesson& lesson = story.run.lesson;
  const std::vector<Vector2d> x = in_plane(story.positioned.x().world);
  const std::vector<Vector2d> y = in_plane(story.positioned.y().world);
  const NearestTwo two = nearest_two(x, y);
  const double distance = story.trace.result.distance;
  switch (part(story.run, story.frame)) {
    case Part::all:
      text.caption = fmt::format(
          "A first idea: measure each vertex of {} against each of {}. That is {} × {} "
          "= {} pairs.",
          lesson.x().name, lesson.y().name, x.size(), y.size(), x.size() * y.size());
      text.detail = "The shortest of these lines would be the distance. Is it?";
      return;
    case Part::nearest:
      text.caption =
          fmt::format("{} and {} are the nearest two vertices: {}.", lesson.y().vertex_names[two.y],
                      lesson.x().vertex_names[two.x], story.numbers(two.distance));
      text.detail = "But shapes are more than their vertices.";
      return;
    case Part::closest:
      text.caption = fmt::format("The closest points are only {} apart: {} less.",
                                 story.numbers(distance), story.numbers(two.distance - distance));
      text.detail =
          fmt::format("Closest: {} of {} and {} of {}.",
                      feature_name(story.run, story.trace.result.simplex, true), lesson.x().name,
                      feature_name(story.run, story.trace.result.simplex, false), lesson.y().name);
      return;
    case Part::sampled: {
      const std::vector<Vector2d> of_x = sampled(x);
      const std::vector<Vector2d> of_y = sampled(y);
      const NearestTwo best = nearest_two(of_x, of_y);
      text.caption =
          fmt::format("{} points on every edge: {} pairs, and the best is still {} too long.",
                      kSamples, grouped(static_cast<double>(of_x.size() * of_y.size())),
                      story.numbers(best.distance - distance));
      text.detail =
          "An edge never runs out of points: they cannot all be tried. A few comparisons "
          "must do.";
      return;
    }
  }
}

void stage(SceneBuilder& scene) {
  if (!(scene.positioned.trace.result.distance > 0.0)) return;
  const Part at = part(scene.run, scene.frame);
  const std::vector<Vector2d> x = in_plane(scene.positioned.x().world);
  const std::vector<Vector2d> y = in_plane(scene.positioned.y().world);
  const NearestTwo two = nearest_two(x, y);
  if (at == Part::all || at == Part::nearest) {
    for (const Vector2d& from : x) {
      for (const Vector2d& to : y) scene.line("pair.link", scene.at(from), scene.at(to));
    }
  }
  if (at == Part::sampled) {
    const std::vector<Vector2d> of_x = sampled(x);
    const std::vector<Vector2d> of_y = sampled(y);
    for (const auto* points : {&of_x, &of_y}) {
      for (const Vector2d& point : *points)
        scene.disk("guess.sample", scene.at(point), kCloudRadius);
    }
    const NearestTwo best = nearest_two(of_x, of_y);
    guesses::measured_line(scene, "guess.pair", "pair", of_x[best.x], of_y[best.y]);
  }
  if (at == Part::nearest || at == Part::closest)
    guesses::measured_line(scene, "guess.pair", "pair", x[two.x], y[two.y]);
  if (at < Part::closest) return;
  const Vector2d from = in_plane(scene.positioned.trace.result.x);
  const Vector2d to = in_plane(scene.positioned.trace.result.y);
  if (at == Part::closest) {
    guesses::measured_line(scene, "closest.line", "distance", from, to);
  } else {
    scene.line("closest.line", scene.at(from), scene.at(to));
  }
  for (const Vector2d& point : {from, to}) scene.disk("closest", scene.at(point), kClosestRadius);
}

}  // namespace

const Tour kTour{
    .name = "vertex-pairs",
    .meaning =
        "part of why vertices alone do not tell the distance: all pairs of them, the nearest, the "
        "closest points, points on every edge",
    .needs = {.most_vertices = 8, .why_no_until = "frames show how the run ends"},
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

}  // namespace gjkscope::vertex_pairs
