#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "run/questions.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/methods/closest_pairs.hpp"
#include "subjects/methods/lesson_trace.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::methods {
namespace {

const MethodsTrace& trace_at(const LessonRun& run, const Frame& frame) {
  return *methods_trace(run, frame.run);
}

/// True for a frame at a new position that shows no numbers yet.
bool asks_first(const Frame& frame) { return frame.step < 0; }
/// The frame after all positions, which sums up.
bool is_sum(const Frame& frame) { return frame.step > 0; }

/// The number of positions whose counts a frame shows.
int positions_shown(const Frame& frame) { return frame.run + (asks_first(frame) ? 0 : 1); }

/// The sum over them.
long total(const LessonRun& run, const Frame& frame, Method method) {
  long sum = 0;
  for (int i = 0; i < positions_shown(frame); ++i) sum += methods_trace(run, i)->at(method);
  return sum;
}

std::string pairs(long count) { return fmt::format("{} pair{}", count, count == 1 ? "" : "s"); }
std::string iterations(long count) {
  return fmt::format("{} iteration{}", count, count == 1 ? "" : "s");
}

void add_frames(LessonRun& run, int index) {
  const bool is_refused = methods_trace(run, index)->is_refused();
  run.frames.push_back({.run = index, .step = is_refused ? -1 : 0});
  const bool is_last = index + 1 == static_cast<int>(run.runs.size());
  if (is_last && !is_refused) run.frames.push_back({.run = index, .step = 1});
}

std::string position(const LessonRun& run, int index) {
  return is_sum(run.frames[index]) ? "all positions" : position_on_path(run, index);
}

Tick tick(const LessonRun&, const Frame& frame) {
  if (is_sum(frame)) return {.group = "outcome", .label = "all", .event = true};
  return {.group = "position", .label = std::to_string(frame.run + 1)};
}

void words(const Story& story, FrameText& text) {
  const MethodsTrace& at = trace_at(story.run, story.frame);
  const Lesson& lesson = story.run.lesson;
  if (at.is_refused()) {
    text.caption = fmt::format("Not all methods take {}.", words_of(*at.refusal, lesson));
    text.detail = "Lin-Canny needs convex outlines, and GJK takes hulls.";
    return;
  }
  const auto sum = [&](Method method) { return total(story.run, story.frame, method); };
  if (is_sum(story.frame)) {
    text.caption =
        fmt::format("Memory saves GJK {} of {} iterations, and the trees {} of {} pairs of boxes.",
                    sum(Method::gjk_cold) - sum(Method::gjk_warm), sum(Method::gjk_cold),
                    sum(Method::tree_cold) - sum(Method::tree_front), sum(Method::tree_cold));
    text.detail = fmt::format(
        "The last pair alone saves {}: nearer first finds a small δ at once. What helps is to "
        "start where the last search ended: at its front, as FCL calls it.",
        sum(Method::tree_cold) - sum(Method::tree_pair));
    return;
  }
  if (story.frame.run == 0) {
    text.caption = fmt::format("Nothing is known yet: all methods start anew. All say {}.",
                               story.numbers(at.answer.distance));
    text.detail =
        fmt::format("GJK needs {}, Lin-Canny looks at {} of features, the trees at {} of boxes.",
                    iterations(at.at(Method::gjk_cold)), pairs(at.at(Method::lin_canny)),
                    pairs(at.at(Method::tree_cold)));
    return;
  }
  const models::Answer& last = methods_trace(story.run, story.frame.run - 1)->answer;
  const bool is_same = last.on_a == at.answer.on_a && last.on_b == at.answer.on_b;
  text.caption = fmt::format(
      "The distance is {}, between {}: with what they know GJK needs {}, Lin-Canny {}.",
      story.numbers(at.answer.distance), is_same ? "the same features as before" : "new features",
      iterations(at.at(Method::gjk_warm)), pairs(at.at(Method::lin_canny)));
  text.detail = fmt::format(
      "From the last front the trees visit {}, from the roots {}. From scratch GJK needs {}.",
      pairs(at.at(Method::tree_front)), at.at(Method::tree_cold),
      iterations(at.at(Method::gjk_cold)));
}

constexpr AskInfo kAskFront{
    "front", "whether a search from the last front visits fewer pairs than one from the roots",
    "at position"};
constexpr AskInfo kAskMemory{"memory", "which method saves the largest share of its steps",
                             "at position"};
constexpr AskInfo kAskNeedsZ{"needs-z", "which method computes points of Z", "at position"};
constexpr std::array kAsks = {kAskFront, kAskMemory, kAskNeedsZ, asks::kClosestX};

/// A position answers, from the second on, or the sum.
int answering_step(const LessonRun& run, const Frame&, const Frame& frame,
                   const LessonQuestion& question) {
  if (trace_at(run, frame).is_refused()) return -1;
  if (question.ask == kAskMemory.name) return is_sum(frame) && !question.at ? 0 : -1;
  const bool is_open = question.ask == kAskFront.name ? frame.run > 0
                       : question.ask == kAskNeedsZ.name
                           ? true
                           : trace_at(run, frame).answer.distance > 0.0;
  return !is_sum(frame) && is_open && is_at(frame, question) ? 0 : -1;
}

Frame asking(const LessonRun&, const Frame& frame) {
  return {.run = frame.run, .step = is_sum(frame) ? 0 : -1};
}

void ask_about_front(const MethodsTrace& at, FrameText& text, FrameQuestion& asked) {
  const long front = at.at(Method::tree_front);
  const long roots = at.at(Method::tree_cold);
  asked.choices = {"fewer", "as many", "more"};
  asked.answer = asked.choices[front < roots ? 0 : front == roots ? 1 : 2];
  text.caption =
      "Question: here, does a search from the last front visit fewer pairs than one from the "
      "roots?";
}

void ask_about_memory(const Story& story, FrameText& text, FrameQuestion& asked) {
  constexpr std::array<std::pair<Method, Method>, 3> kPairs = {
      {{Method::gjk_warm, Method::gjk_cold},
       {Method::tree_pair, Method::tree_cold},
       {Method::tree_front, Method::tree_cold}}};
  double least = 2.0;
  for (const auto& [warm, cold] : kPairs) {
    const double share = static_cast<double>(total(story.run, story.frame, warm)) /
                         static_cast<double>(total(story.run, story.frame, cold));
    asked.choices.emplace_back(name_of(warm));
    if (share < least) asked.answer = asked.choices.back();
    least = std::min(least, share);
  }
  text.caption = "Question: whose memory saves the largest share of its steps?";
}

/// A vertex of X, or the edge between two.
struct ChoiceOfX {
  int from;
  int to;
  bool is_closest;
};

/// Some vertices and edges of X in a row, the closest among them: its place differs.
std::vector<ChoiceOfX> choices_of_x(const LessonRun& run, const Frame& frame) {
  const models::Feature& closest = trace_at(run, frame).answer.on_a;
  const int count = static_cast<int>(run.lesson.x().vertices.size());
  const int choices = std::min(7, 2 * count);
  // Feature 2i is vertex i, 2i + 1 the edge after it.
  const int right = 2 * closest.index + (closest.is_vertex ? 0 : 1);
  const int first = right - frame.run % choices;
  std::vector<ChoiceOfX> out;
  for (int i = first; i < first + choices; ++i) {
    const int feature = (i + 2 * count) % (2 * count);
    out.push_back({feature / 2, (feature / 2 + feature % 2) % count, i == right});
  }
  return out;
}

void ask_for_closest(const Story& story, FrameText& text, FrameQuestion& asked) {
  const std::vector<Eigen::Vector2d> points = in_plane(story.positioned.x().world);
  const std::vector<std::string>& names = story.run.lesson.x().vertex_names;
  for (const ChoiceOfX& choice : choices_of_x(story.run, story.frame)) {
    const auto from = static_cast<std::size_t>(choice.from);
    const auto to = static_cast<std::size_t>(choice.to);
    asked.choices.push_back(from == to ? names[from] : names[from] + names[to]);
    asked.spots.emplace_back(Spot(ViewKind::world, points[from], points[to]));
    if (choice.is_closest) asked.answer = asked.choices.back();
  }
  asked.place = trace_at(story.run, story.frame).answer.a;
  text.caption = fmt::format(
      "Question: both have moved on. Which point of {} is closest to {} here? Point at it.",
      story.run.lesson.x().name, story.run.lesson.y().name);
}

void question(const Story& story, FrameText& text) {
  FrameQuestion& asked = text.question.emplace();
  asked.ask = story.run.asked(story.frame).ask;
  if (asked.ask == kAskNeedsZ.name) {
    asked.choices = {"GJK", "Lin-Canny", "the trees", "all of them"};
    asked.answer = asked.choices.front();
    asked.refuted =
        "Lin-Canny asks for regions of features, trees for distances of boxes: both do without Z.";
    text.caption = "Question: which of these methods computes points of Z, the difference Y − X?";
  } else if (asked.ask == kAskFront.name) {
    ask_about_front(trace_at(story.run, story.frame), text, asked);
  } else if (asked.ask != kAskMemory.name) {
    ask_for_closest(story, text, asked);
  } else {
    ask_about_memory(story, text, asked);
  }
}

void values(const Story& story, FrameText& text) {
  const MethodsTrace& at = trace_at(story.run, story.frame);
  text.values.emplace_back("x", story.run.lesson.x().name);
  text.values.emplace_back("y", story.run.lesson.y().name);
  if (at.is_refused() || asks_first(story.frame)) return;
  text.values.emplace_back("distance", story.numbers(at.answer.distance));
  for (const Method method : kMethods)
    text.values.emplace_back(name_of(method), fmt::format("{} {}", at.at(method), unit_of(method)));
}

/// The vertices of X that a question chooses from have names, with its answer, too.
void name_choices(SceneBuilder& scene) {
  const bool is_asked = scene.run.lesson.asks(asks::kClosestX.name, scene.frame.run + 1);
  if (!is_asked || is_sum(scene.frame)) return;
  for (const ChoiceOfX& choice : choices_of_x(scene.run, scene.frame)) {
    if (choice.from == choice.to)
      layers::vertex_name(scene, {Subject::Kind::vertex_of_x, choice.from}, true);
  }
}

void stage(SceneBuilder& scene) {
  const MethodsTrace& at = trace_at(scene.run, scene.frame);
  if (at.is_refused()) return;
  name_choices(scene);
  if (asks_first(scene.frame)) return;
  const Point x = scene.at(at.answer.a);
  const Point y = scene.at(at.answer.b);
  scene.line("closest.line", x, y);
  for (const Point& point : {x, y}) scene.disk("closest", point, sizes::kClosestRadius);
  scene.length_label("distance", at.answer.distance, x, y);
}

/// Plots the counts of each method, position by position.
bool fill(SceneBuilder& scene, const Fonts& fonts) {
  if (scene.view.kind != ViewKind::plot) return false;
  if (trace_at(scene.run, scene.frame).is_refused()) return true;
  constexpr std::array<PlotStyle, kMethods.size()> kStyles = {PlotStyle::limit,  PlotStyle::second,
                                                              PlotStyle::first,  PlotStyle::other,
                                                              PlotStyle::fourth, PlotStyle::third};
  const int positions = static_cast<int>(scene.run.runs.size());
  Plot plot;
  plot.x = {1.0, std::max(2.0, static_cast<double>(positions)), false, "position"};
  double most = 10.0;
  for (const Method method : kMethods) {
    PlotSeries series{kStyles[static_cast<std::size_t>(method)], std::string(name_of(method)), {}};
    series.has_symbols = series.style != PlotStyle::limit;
    for (int i = 0; i < positions; ++i) {
      const MethodsTrace& each = *methods_trace(scene.run, i);
      const double count = static_cast<double>(std::max(each.at(method), 1L));
      most = std::max(most, count);
      if (i < positions_shown(scene.frame)) series.points.emplace_back(i + 1.0, count);
    }
    plot.series.push_back(std::move(series));
  }
  plot.y = {1.0, std::pow(10.0, std::ceil(std::log10(most))), true, "steps"};
  if (!is_sum(scene.frame)) plot.current = scene.frame.run + 1.0;
  layers::add_plot(scene, plot, fonts);
  return true;
}

std::string plot_title(const LessonRun&) { return "Steps of each method"; }

void counters(PanelBuilder& panel) {
  const MethodsTrace& at = trace_at(panel.run, panel.frame);
  const double now = panel.right - 64.0;
  panel.write("heading", panel.left, "Steps", type::kHeading);
  panel.write("heading", now, "now", type::kHeading, Align::right);
  panel.write("heading", panel.right, "in all", type::kHeading, Align::right);
  panel.y += rows::kRow + 2.0;
  if (at.is_refused()) return;
  for (const Method method : kMethods) {
    panel.write("strong", panel.left, std::string(name_of(method)), type::kStrong);
    panel.write("code.current", now, std::to_string(at.at(method)), type::kCode, Align::right);
    panel.write("code.current", panel.right, std::to_string(total(panel.run, panel.frame, method)),
                type::kCode, Align::right);
    panel.y += rows::kTightRow;
    panel.write("body.muted", panel.left, std::string(unit_of(method)), type::kBody);
    panel.y += rows::kRow + 6.0;
  }
  const auto segments = [&](std::size_t body) {
    return static_cast<long>(panel.run.lesson.bodies[body].vertices.size());
  };
  panel.write("body.muted", panel.left, "pairs of segments there are", type::kBody);
  panel.write("code.current", panel.right, std::to_string(segments(0) * segments(1)), type::kCode,
              Align::right);
  panel.y += rows::kRow;
}

const Block kCounters{.name = "methods",
                      .meaning = "steps of each method at this position, and by now",
                      .write = counters,
                      .tour = "methods"};

const Tour kTour{
    .name = "methods",
    .meaning = "position of two convex shapes, at which all methods are asked; then the sum",
    .needs = {.why_no_until = "frames show how all methods end"},
    .add_frames = add_frames,
    .sweeps = true,
    .asks = kAsks,
    .answering_step = answering_step,
    .asking = asking,
    .algorithm = &kMethodsAlgorithm,
    .position = position,
    .tick = tick,
    .words = words,
    .stage = stage,
    .question = question,
    .values = values,
    .fill = fill,
    .plot_title = plot_title,
};

}  // namespace
}  // namespace gjkscope::methods

namespace gjkscope {

const SubjectParts subjects::methods{
    .tours = {&gjkscope::methods::kTour, &jumps::kTour},
    .blocks = {&gjkscope::methods::kCounters, &jumps::kMoves},
    .legend = {{"ghost", "last position: Y, and the shortest way"}, {"ghost.arrow", "x jumps"}},
};

}  // namespace gjkscope
