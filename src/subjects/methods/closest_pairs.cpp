#include "subjects/methods/closest_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "gjk/vector.hpp"
#include "run/fields.hpp"
#include "run/questions.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope {
namespace {

using fields::Json;

constexpr std::array<std::string_view, 1> kPairPhases = {"position"};
constexpr std::array<std::string_view, 1> kPairAnswers = {"distance"};
constexpr std::array<PlaceholderInfo, 1> kPairValues = {
    {{"distance", "distance of the outlines at this position"}}};

Json feature_json(const models::Feature& feature) {
  return {{"is", feature.is_vertex ? "vertex" : "edge"}, {"index", feature.index}};
}

std::shared_ptr<const AlgorithmTrace> run_all_pairs(const Lesson& lesson, const PositionedRun& run,
                                                    const AlgorithmTrace*) {
  OutlinesOfRun outlines = outlines_of(lesson, run);
  std::optional<Refusal> refused = refusal_of(outlines, models::Needs::segments);
  return std::make_shared<const AllPairsTrace>(refused, std::move(outlines));
}

}  // namespace

AllPairsTrace::AllPairsTrace(std::optional<Refusal> refused, OutlinesOfRun outlines)
    : OutlineTrace(refused), models(std::move(outlines)) {
  if (!refusal) closest = models::brute(models.x, models.y).answer;
}

StepInfo AllPairsTrace::info(int) const { return {1, kPairPhases[0]}; }

double AllPairsTrace::answer(std::string_view) const {
  return refusal ? std::numeric_limits<double>::quiet_NaN() : closest.distance;
}

Json AllPairsTrace::step_json(const Lesson&, int) const {
  return {{"x", feature_json(closest.on_a)}, {"y", feature_json(closest.on_b)}};
}

Json AllPairsTrace::result_json(const Lesson&) const {
  return {{"distance", fields::number(closest.distance)},
          {"overlap", closest.overlap},
          {"closest_x", fields::point(closest.a)},
          {"closest_y", fields::point(closest.b)}};
}

const Algorithm kAllPairsAlgorithm{.name = "all-pairs",
                                   .phases = kPairPhases,
                                   .answers = kPairAnswers,
                                   .values = kPairValues,
                                   .run = run_all_pairs,
                                   .takes_outlines = true};

}  // namespace gjkscope

namespace gjkscope::jumps {
namespace {

using Eigen::Vector2d;
using models::Feature;

constexpr AskInfo kAskLook{
    "look-at", "which features of X have to be looked at for the closest one", "at position"};
constexpr std::array kAsks = {asks::kClosestX, kAskLook};

/// A frame at a new position that shows nothing of its answer.
bool asks_first(const Frame& frame) { return frame.step < 0; }

/// The trace before that of `frame` on the path; none at the first.
const AllPairsTrace* last_of(const LessonRun& run, const Frame& frame) {
  return frame.run == 0 ? nullptr : &all_pairs_trace(run, frame.run - 1);
}

std::string name_of(const LessonShape& shape, const Feature& feature) {
  const auto name = [&](int i) {
    return shape.vertex_names[static_cast<std::size_t>(i) % shape.vertex_names.size()];
  };
  return feature.is_vertex ? name(feature.index) : name(feature.index) + name(feature.index + 1);
}

std::string words_of(const LessonShape& shape, const Feature& feature) {
  return (feature.is_vertex ? "vertex " : "edge ") + name_of(shape, feature);
}

/// Whether two features of an outline of `count` vertices are an edge and an
/// end of it.
bool are_neighbours(const Feature& a, const Feature& b, int count) {
  if (a.is_vertex == b.is_vertex) return false;
  const Feature& vertex = a.is_vertex ? a : b;
  const Feature& edge = a.is_vertex ? b : a;
  return vertex.index == edge.index || vertex.index == (edge.index + 1) % count;
}

double moved(const Vector2d& from, const Vector2d& to) {
  const Vector2d moved = to - from;
  return gjk::length(moved);
}

/// How far Y has moved since the last position.
double move_of_y(const LessonRun& run, int index) {
  return moved(in_plane(run.runs[index - 1].y().world.front()),
               in_plane(run.runs[index].y().world.front()));
}
double move_of_x_point(const LessonRun& run, int index) {
  return moved(all_pairs_trace(run, index - 1).closest.a, all_pairs_trace(run, index).closest.a);
}

void add_frames(LessonRun& run, int index) {
  run.frames.push_back({.run = index, .step = all_pairs_trace(run, index).steps() - 1});
}

int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  const bool is_open =
      frame.run > 0 && !asks_first(frame) && all_pairs_trace(run, frame.run).closest.distance > 0.0;
  return is_open && is_at(frame, question) ? 0 : -1;
}

Frame asking(const LessonRun&, const Frame& frame) { return {.run = frame.run}; }

Tick tick(const LessonRun&, const Frame& frame) {
  return {.group = "position", .label = std::to_string(frame.run + 1)};
}

void words(const Story& story, FrameText& text) {
  const LessonRun& run = story.run;
  const AllPairsTrace& now = all_pairs_trace(run, story.frame.run);
  const LessonShape& x = run.lesson.x();
  if (now.refusal) {
    text.caption = fmt::format("All pairs do not take {}.", words_of(*now.refusal, run.lesson));
    return;
  }
  const AllPairsTrace* last = last_of(run, story.frame);
  const std::string distance = story.numbers(now.closest.distance);
  if (last == nullptr) {
    text.caption =
        fmt::format("{} and {} are {} apart: x lies on {} of {}.", x.name, run.lesson.y().name,
                    distance, words_of(x, now.closest.on_a), x.name);
    text.detail = fmt::format("All {} pairs of edges are measured. Next: Y moves on.",
                              now.models.x.segments.size() * now.models.y.segments.size());
    return;
  }
  const std::string of_y = story.numbers(move_of_y(run, story.frame.run));
  const std::string of_x = story.numbers(move_of_x_point(run, story.frame.run));
  const std::string change = fmt::format("The distance went from {} to {}.",
                                         story.numbers(last->closest.distance), distance);
  if (last->closest.on_a == now.closest.on_a) {
    text.caption = fmt::format("{} moves by {}, and x by {}: it stays on {}.", run.lesson.y().name,
                               of_y, of_x, words_of(x, now.closest.on_a));
    text.detail = change;
    return;
  }
  const bool are_near =
      are_neighbours(last->closest.on_a, now.closest.on_a, static_cast<int>(x.vertices.size()));
  text.caption = fmt::format("{} moves by {}, and x {} by {}: from {} to {}.", run.lesson.y().name,
                             of_y, are_near ? "goes on" : "jumps", of_x,
                             words_of(x, last->closest.on_a), words_of(x, now.closest.on_a));
  text.detail = change + (are_near ? ""
                                   : fmt::format(" x passes no point between {} and {}.",
                                                 name_of(x, last->closest.on_a),
                                                 name_of(x, now.closest.on_a)));
}

void ask_for_closest(const Story& story, FrameText& text, FrameQuestion& asked) {
  const LessonShape& x = story.run.lesson.x();
  const std::vector<Vector2d> points = in_plane(story.positioned.x().world);
  const models::Answer& closest = all_pairs_trace(story.run, story.frame.run).closest;
  const int count = static_cast<int>(points.size());
  for (const bool is_vertex : {true, false}) {
    for (int i = 0; i < count; ++i) {
      const Feature feature{is_vertex, 0, i};
      asked.choices.push_back(name_of(x, feature));
      asked.spots.emplace_back(
          Spot(ViewKind::world, points[static_cast<std::size_t>(i)],
               points[static_cast<std::size_t>(is_vertex ? i : (i + 1) % count)]));
      if (feature == closest.on_a) asked.answer = asked.choices.back();
    }
  }
  asked.place = closest.a;
  text.caption = fmt::format(
      "Question: {} has moved by {}, and the dashed line was the shortest. Which point of {} is "
      "closest now? Point at it.",
      story.run.lesson.y().name, story.numbers(move_of_y(story.run, story.frame.run)), x.name);
}

/// The answer of the last closest feature, by itself and with its
/// neighbours.
void ask_where_to_look(const Story& story, FrameText& text, FrameQuestion& asked) {
  const LessonShape& x = story.run.lesson.x();
  const AllPairsTrace& now = all_pairs_trace(story.run, story.frame.run);
  const Feature& last = last_of(story.run, story.frame)->closest.on_a;
  const Feature& found = now.closest.on_a;
  const std::string name = name_of(x, last);
  asked.choices = {name + " alone",
                   name + (last.is_vertex ? " and its two edges" : " and its two ends"),
                   "all of " + x.name};
  const int count = static_cast<int>(x.vertices.size());
  asked.answer = asked.choices[found == last ? 0 : are_neighbours(found, last, count) ? 1 : 2];
  // The neighbours of an edge are its ends, so the edge holds them.
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < now.models.x.segments.size(); ++i) {
    const int edge = static_cast<int>(i);
    const bool is_near =
        last.is_vertex ? are_neighbours(last, {false, 0, edge}, count) : edge == last.index;
    if (!is_near) continue;
    for (const models::Segment& other : now.models.y.segments)
      least = std::min(least, models::nearest(now.models.x.segments[i], other).high);
  }
  asked.refuted =
      fmt::format("On {} nothing is closer than {}.", asked.choices[1], story.numbers(least));
  text.caption = fmt::format(
      "Question: {} held the closest point. {} has moved by {}: which features of {} have to be "
      "looked at?",
      name, story.run.lesson.y().name, story.numbers(move_of_y(story.run, story.frame.run)),
      x.name);
}

void question(const Story& story, FrameText& text) {
  FrameQuestion& asked = text.question.emplace();
  asked.ask = story.run.asked(story.frame).ask;
  asked.ask == kAskLook.name ? ask_where_to_look(story, text, asked)
                             : ask_for_closest(story, text, asked);
}

void values(const Story& story, FrameText& text) {
  const AllPairsTrace& now = all_pairs_trace(story.run, story.frame.run);
  text.values.emplace_back("x", story.run.lesson.x().name);
  text.values.emplace_back("y", story.run.lesson.y().name);
  if (now.refusal || asks_first(story.frame)) return;
  text.values.emplace_back("distance", story.numbers(now.closest.distance));
}

void pair(SceneBuilder& scene, const std::string& role, const models::Answer& closest) {
  const Point x = scene.at(closest.a);
  const Point y = scene.at(closest.b);
  scene.line(role, x, y);
  for (const Point& point : {x, y}) scene.disk("closest", point, sizes::kClosestRadius);
}

void stage(SceneBuilder& scene) {
  const AllPairsTrace& now = all_pairs_trace(scene.run, scene.frame.run);
  if (now.refusal) return;
  const AllPairsTrace* last = last_of(scene.run, scene.frame);
  if (last != nullptr) {
    const std::vector<Vector2d> points =
        in_plane(scene.run.runs[static_cast<std::size_t>(scene.frame.run) - 1].y().world);
    scene.add("ghost", Polyline{scene.mapped(points), true});
    pair(scene, "ghost", last->closest);
  }
  if (asks_first(scene.frame)) return;
  pair(scene, "closest.line", now.closest);
  const Point x = scene.at(now.closest.a);
  const Point y = scene.at(now.closest.b);
  scene.out.moving_labels.push_back(
      scene.label("closest:x", "x", "closest.label", type::kVertex, x, sizes::kPointRadius, x - y));
  scene.length_label("distance", now.closest.distance, x, y);
  if (last == nullptr || last->closest.on_a == now.closest.on_a) return;
  scene.arrow("ghost.arrow", scene.at(last->closest.a), x);
}

/// The distance, and how far its ends go, position by position.
bool fill(SceneBuilder& scene, const Fonts& fonts) {
  if (scene.view.kind != ViewKind::plot) return false;
  const int positions = static_cast<int>(scene.run.runs.size());
  if (all_pairs_trace(scene.run, scene.frame.run).refusal) return true;
  Plot plot;
  plot.x = {1.0, std::max(2.0, static_cast<double>(positions)), false, "position"};
  PlotSeries distance{PlotStyle::first, "distance", {}};
  PlotSeries jump{PlotStyle::second, "move of x", {}, PlotJoin::none};
  PlotSeries step{PlotStyle::limit, "move of Y", {}, PlotJoin::lines, false};
  double most = 0.0;
  for (int i = 0; i < positions; ++i) {
    const double at = i + 1.0;
    const AllPairsTrace& each = all_pairs_trace(scene.run, i);
    most = std::max({most, each.closest.distance, i > 0 ? move_of_x_point(scene.run, i) : 0.0});
    if (i > scene.frame.run) continue;
    if (i > 0) step.points.emplace_back(at, move_of_y(scene.run, i));
    if (i == scene.frame.run && asks_first(scene.frame)) continue;
    distance.points.emplace_back(at, each.closest.distance);
    if (i > 0) jump.points.emplace_back(at, move_of_x_point(scene.run, i));
  }
  plot.y = {0.0, std::ceil(most), false, "length"};
  plot.series = {std::move(distance), std::move(jump), std::move(step)};
  plot.current = scene.frame.run + 1.0;
  layers::add_plot(scene, plot, fonts);
  return true;
}

void closest_block(PanelBuilder& panel) {
  const AllPairsTrace& now = all_pairs_trace(panel.run, panel.frame.run);
  panel.heading("From the last position to this one");
  const bool is_known = !now.refusal && !asks_first(panel.frame);
  const auto row = [&](const std::string& what, bool is_shown, double value) {
    panel.row(what, is_shown ? panel.numbers(value) : "–");
  };
  const bool has_last = panel.frame.run > 0;
  row("Y has moved by", has_last, has_last ? move_of_y(panel.run, panel.frame.run) : 0.0);
  row("x has moved by", has_last && is_known,
      has_last ? move_of_x_point(panel.run, panel.frame.run) : 0.0);
  row("the distance was", has_last,
      has_last ? last_of(panel.run, panel.frame)->closest.distance : 0.0);
  row("the distance is", is_known, now.closest.distance);
}

}  // namespace

const Block kMoves{.name = "moves",
                   .meaning = "how far Y and the closest point of X have moved, and the distance",
                   .write = closest_block,
                   .tour = "closest-pairs"};

const Tour kTour{
    .name = "closest-pairs",
    .meaning = "position on the path: the closest points of two outlines, by all pairs",
    .needs = {.why_no_until = "frames show how the path ends"},
    .add_frames = add_frames,
    .sweeps = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .asking = asking,
    .algorithm = &kAllPairsAlgorithm,
    .position = position_on_path,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
    .fill = fill,
    .plot_title = [](const LessonRun&) { return std::string("Moves and distance"); },
};

}  // namespace gjkscope::jumps
