// Barycentric weights of one point on a line, in a plane and in space: fractions of a length, an
// area and a volume.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "picture/solid.hpp"
#include "run/questions.hpp"
#include "subjects/dimensions/runs.hpp"
#include "subjects/dimensions/subject.hpp"
#include "subjects/guess/subject.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope::fractions {
namespace {

using Eigen::Vector3d;

constexpr int kVertices = 4;
constexpr std::array<std::string_view, 3> kMeasures = {"length", "area", "volume"};

// ---- the stage ----

/// The simplex with the marked vertex moved to G, the point with the weights: its share.
void draw_fraction(SceneBuilder& scene) {
  const BarycentricWeights::Value& value = scene.effects.get<BarycentricWeights>(scene.frame);
  if (scene.frame.part < 0 || value.weights.empty()) return;
  const WideSimplex& simplex = value.simplex;
  Vector3d g = Vector3d::Zero();
  for (int i = 0; i < simplex.count; ++i) g += value.weights[i] * simplex.vertices[i].w;
  if (simplex.count < kVertices) {
    scene.add("fraction.foot",
              Polyline{{scene.at_difference(Vector3d::Zero()), scene.at_difference(g)}});
  }
  const int marked = scene.frame.part;
  if (marked < simplex.count) {
    const double weight = value.weights[marked];
    const std::string role = weight < 0.0 ? "fraction.negative" : "fraction";
    std::vector<Vector3d> corners = {g + scene.shift};
    for (int i = 0; i < simplex.count; ++i) {
      if (i != marked) corners.emplace_back(simplex.vertices[i].w + scene.shift);
    }
    draw_solid(scene, hull_in_space(corners), corners, role, {}, Stuff::core);
    const Point at = scene.at_difference(simplex.vertices[marked].w);
    scene.disk("fraction.vertex", at, sizes::kRingRadius);
  }
  if (simplex.count == kVertices) return;
  const Point foot = scene.at_difference(g);
  scene.disk("fraction.point", foot, sizes::kClosestRadius);
  scene.out.moving_labels.push_back(scene.label("G", "G", "closest.label", type::kVertex, foot,
                                                sizes::kPointRadius,
                                                foot - scene.at_difference(Vector3d::Zero())));
}

/// That of the runs of the first two and three vertices, which no lesson can name.
const Tour& tour_of_first_vertices() {
  static const Tour tour{
      .name = "fractions",
      .meaning = "",
      .add_frames = [](LessonRun&, int) {},
      .algorithm = &kGjkAlgorithm,
      .knows = guesses::knows_nothing,
      .stage = draw_fraction,
  };
  return tour;
}

FrameInView in_view(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                    std::size_t view) {
  return in_view_of(effects.get<FirstVertices>(frame), run, effects, frame, view);
}

/// The weights in the first two, the first three and all vertices.
std::vector<BarycentricWeights::Value> all_weights(EffectGraph& effects, const Frame& frame) {
  std::vector<BarycentricWeights::Value> out;
  for (const LesserRun& each : effects.get<FirstVertices>(frame))
    out.push_back(each.effects->get<BarycentricWeights>(frame));
  out.push_back(effects.get<BarycentricWeights>(frame));
  return out;
}

// ---- frames and the question ----

void frames(LessonRun& run, int index) {
  const int last = last_step(run.lesson, run.runs[index].trace);
  const int step = std::min(0, last);
  if (index == 0) run.frames.push_back({.run = index});
  for (int part = 0; step == 0 && part < kVertices; ++part)
    run.frames.push_back({.run = index, .step = step, .part = part});
}

Tick tick(const LessonRun& run, const Frame& frame) {
  const WideSimplex& simplex = run.runs.front().trace.initial.simplex;
  return {.group = fmt::format("position {}", frame.run + 1),
          .label = frame.part < 0 || frame.part >= simplex.count
                       ? std::string("Q")
                       : run.pair_name(simplex.vertices[frame.part].pair)};
}

constexpr AskInfo kAskSign{"weight-sign", "the sign of the first vertex's weight in space",
                           "at position"};
constexpr std::array kAsks = {kAskSign};

int answering_step(const LessonRun&, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  return frame.part == 0 && is_at(frame, question) ? frame.step : -1;
}

/// At the new place, before anything is known of it.
Frame asking(const LessonRun&, const Frame& frame) { return {.run = frame.run}; }

void question(const Story& story, FrameText& text) {
  const Frame answering{.run = story.frame.run, .step = story.frame.answering_step, .part = 0};
  const BarycentricWeights::Value& value = story.effects.get<BarycentricWeights>(answering);
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskSign.name), {}, {}});
  asked.choices = {"positive", "0", "negative"};
  const double weight = value.weights.empty() ? 0.0 : value.weights.front();
  asked.answer = asked.choices[weight > 0.0 ? 0 : weight < 0.0 ? 2 : 1];
  const std::string name = story.run.pair_name(value.simplex.vertices[0].pair);
  text.caption = fmt::format(
      "Question: is the weight of {} in the tetrahedron positive, 0 or negative?", name);
}

// ---- the words ----

/// "KLM", all vertices but `left_out`.
std::string names(const LessonRun& run, const WideSimplex& simplex, int left_out = -1) {
  std::string out;
  for (int i = 0; i < simplex.count; ++i) {
    if (i != left_out) out += run.pair_name(simplex.vertices[i].pair);
  }
  return out;
}

void start(const Story& story, FrameText& text) {
  const std::vector<BarycentricWeights::Value> all = all_weights(story.effects, story.frame);
  text.caption =
      fmt::format("One point {}, seen from a segment, a triangle and a tetrahedron.", story.q);
  text.detail =
      fmt::format("G is the point closest to {} on the line {}, and in the plane {}.", story.q,
                  names(story.run, all[0].simplex), names(story.run, all[1].simplex));
}

void words(const Story& story, FrameText& text) {
  const LessonRun& run = story.run;
  const std::vector<BarycentricWeights::Value> all = all_weights(story.effects, story.frame);
  const WideSimplex& whole = all.back().simplex;
  const int marked = story.frame.part;
  const std::string name = run.pair_name(whole.vertices[marked].pair);
  std::vector<std::string> each;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& [simplex, weights] = all[k];
    if (marked >= simplex.count) continue;
    const std::string point = k + 1 == all.size() ? story.q : "G";
    each.push_back(weights.empty()
                       ? fmt::format("no {}", kMeasures[k])
                       : fmt::format("{}{} / {} = {}", point, names(run, simplex, marked),
                                     names(run, simplex), story.numbers.weight(weights[marked])));
  }
  text.caption = fmt::format("The weight of {} is the part opposite to it: {}.", name,
                             and_list(std::move(each)));
  const std::vector<double>& weights = all.back().weights;
  const double weight = weights.empty() ? 0.0 : weights[marked];
  const std::string face = names(run, whole, marked);
  text.detail =
      weight < 0.0
          ? fmt::format("In space it is negative: {} lies beyond the face {}.", story.q, face)
      : weight > 0.0 ? fmt::format("In space it is positive: {} and {} lie on one side of {}.",
                                   story.q, name, face)
                     : fmt::format("In space it is 0: {} lies in the plane of {}.", story.q, face);
}

void values(const Story& story, FrameText& text) {
  text.values.emplace_back("Q", story.numbers.point(story.positioned.x().world[0]));
  const BarycentricWeights::Value& value = story.effects.get<BarycentricWeights>(story.frame);
  if (story.frame.part < 0) return;
  for (std::size_t i = 0; i < value.weights.size(); ++i)
    text.values.emplace_back(std::string(1, "uvwt"[i]), story.numbers.weight(value.weights[i]));
}

// ---- the panel ----

void fractions(PanelBuilder& panel) {
  const std::vector<BarycentricWeights::Value> all = all_weights(panel.effects, panel.frame);
  const bool known = panel.frame.question < 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& [simplex, weights] = all[k];
    panel.heading(fmt::format("Fractions of {} {}", kMeasures[k], names(panel.run, simplex)));
    for (int i = 0; i < simplex.count; ++i) {
      const bool is_known = known && !weights.empty();
      const double weight = is_known ? weights[i] : 0.0;
      if (known && i == panel.frame.part) panel.highlight();
      panel.write("body", panel.left + 8.0, panel.run.pair_name(simplex.vertices[i].pair),
                  type::kBody);
      panel.write(weight < 0.0 ? "fail" : "code", panel.right,
                  is_known ? panel.numbers.weight(weight) : "–", type::kCode, Align::right);
      panel.y += rows::kTightRow;
    }
    panel.y += 6.0;
  }
}

}  // namespace

const Tour kTour{
    .name = "fractions",
    .meaning =
        "vertex of a tetrahedron, at each position of X: its weight in the first two, three "
        "and four vertices, one view each",
    .needs = {.path = PathUse::needed,
              .start = kVertices,
              .shown_of = ShownOf::space,
              .why_no_until = "frames show the first step alone"},
    .add_frames = frames,
    .sweeps = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .asking = asking,
    .algorithm = &kGjkAlgorithm,
    .knows = guesses::knows_nothing,
    .position = position_on_path,
    .tick = tick,
    .start = start,
    .words = words,
    .stage = draw_fraction,
    .question = question,
    .values = values,
    .in_view = in_view,
};

const Block kBlock{.name = "fractions",
                   .meaning =
                       "in space: weights as fractions of a length, an area "
                       "and a volume",
                   .write = fractions,
                   .tour = kTour.name,
                   .shown_of = ShownOf::space};

const EffectInfo kEffect = shown_of(
    ShownOf::space, effect_info<FirstVertices>(
                        "frame", "the weights in the first two and three vertices", kTour.name));

}  // namespace gjkscope::fractions

namespace gjkscope {

FirstVertices::Value FirstVertices::compute(EffectGraph& graph, const LessonRun& run,
                                            const Frame&) {
  Value out;
  const gjk::WarmStart& start = run.lesson.options.start;
  for (int count = 2; count < start.count; ++count) {
    Lesson less = run.lesson;
    less.questions.clear();
    LessonShape& shape = less.y();
    shape.vertices.clear();
    shape.vertex_names.clear();
    less.options.start.count = count;
    for (int i = 0; i < count; ++i) {
      const auto vertex = static_cast<std::size_t>(start.pairs[i].y);
      shape.vertices.push_back(run.lesson.y().vertices[vertex]);
      shape.vertex_names.push_back(run.lesson.y().vertex_names[vertex]);
      less.options.start.pairs[i] = {.x = 0, .y = i};
    }
    out.emplace_back(std::move(less), fractions::tour_of_first_vertices(), graph);
  }
  return out;
}

}  // namespace gjkscope
