#include "practice/task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "frames/frame.hpp"
#include "gjk/simplex.hpp"
#include "lesson/names.hpp"
#include "picture/words.hpp"
#include "run/questions.hpp"
#include "run/trail.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope::practice {
namespace {

using Eigen::Vector3d;
using gjk::Phase;

// Which tasks are of a kind. Vertices of a point query have names of one letter.

template <std::size_t kLetters>
bool has_letters(const LessonRun&, const std::string& answer) {
  return answer.size() == kLetters;
}
bool is_any(const LessonRun&, const std::string&) { return true; }
bool is_pair(const LessonRun&, const std::string& answer) {
  return answer.find(", ") == std::string::npos;
}
bool is_pair_edge(const LessonRun&, const std::string& answer) {
  return std::count(answer.begin(), answer.end(), ',') == 1;
}
bool goes_on(const LessonRun&, const std::string& answer) { return answer == "no"; }
bool is_repeated(const LessonRun&, const std::string& answer) { return answer == "V in S"; }
bool is_inside(const LessonRun&, const std::string& answer) { return answer == "Q inside S"; }
bool is_zero(const LessonRun&, const std::string& answer) { return answer == "d = 0"; }
bool is_two(const LessonRun&, const std::string& answer) { return answer == "two of them"; }

const WideTrace& trace_of(const LessonRun& run) { return run.runs.front().trace; }

int negative_weights(const LessonRun& run) {
  const gjk::Simplex<double, 2> simplex = in_plane(trace_of(run).initial.simplex);
  const gjk::Barycentric<double, 2> all = gjk::barycentric(simplex, simplex.all());
  return static_cast<int>(std::count_if(all.numerator.begin(), all.numerator.end(),
                                        [](double numerator) { return numerator < 0.0; }));
}
bool is_vertex_by_one_sign(const LessonRun& run, const std::string& answer) {
  return answer.size() == 1 && negative_weights(run) == 1;
}
bool is_edge_by_two_signs(const LessonRun& run, const std::string& answer) {
  return answer.size() == 2 && negative_weights(run) == 2;
}
template <int kVertices>
bool is_support_from(const LessonRun& run, const std::string&) {
  for (const WideStep& step : trace_of(run).steps)
    if (step.phase == Phase::support) return step.after.simplex.count == kVertices;
  return false;
}
template <int kIterations>
bool is_run_of(const LessonRun& run, const std::string&) {
  const WideTrace& trace = trace_of(run);
  return trace.result.distance > 0.0 && trace.steps.back().iteration == kIterations;
}
bool is_overlap(const LessonRun& run, const std::string&) {
  return trace_of(run).result.stop == gjk::StopReason::origin_inside &&
         trace_of(run).steps.back().iteration > 2;
}
bool is_touching(const LessonRun& run, const std::string&) {
  return trace_of(run).result.stop == gjk::StopReason::zero_direction;
}
bool is_of_y(const LessonRun&, const std::string& answer) { return answer.ends_with(" of Y"); }
bool is_of_x(const LessonRun&, const std::string& answer) { return answer.ends_with(" of −X"); }
bool is_both(const LessonRun&, const std::string& answer) { return answer.starts_with("both"); }

// Names that stand in folders of subjects.
constexpr std::string_view kNextEdge = "next-edge";
constexpr std::string_view kNearestEdge = "edge";
constexpr std::string_view kSum = "minkowski-sum";

constexpr std::string_view kRegion = asks::kRegion.name;
constexpr std::string_view kSupport = asks::kSupport.name;
constexpr std::string_view kDropped = asks::kDropped.name;
constexpr std::string_view kStop = asks::kStop.name;
constexpr std::string_view kClosest = asks::kClosestX.name;

// Kinds that differ from a choice in a run of GJK, seen in the world.

constexpr Kind weighed(Kind kind) {
  kind.on_paper = OnPaper::weights;
  return kind;
}
constexpr Kind whole_run(Kind kind) {
  kind.on_paper = OnPaper::run;
  return kind;
}
constexpr Kind tie(Kind kind) {
  kind.is_tie = true;
  return kind;
}
constexpr Kind in_difference(Kind kind) {
  kind.view = ViewKind::difference;
  return kind;
}
constexpr Kind of_tour(std::string_view tour, int at, Kind kind) {
  kind.tour = tour;
  kind.at = at;
  return kind;
}

/// By chapter.
constexpr std::array kKinds = {
    Kind{1, "region of a vertex", draw_segment, 2, kRegion, has_letters<1>},
    Kind{1, "region of the edge", draw_segment, 2, kRegion, has_letters<2>},
    Kind{1, "Q on the line through A and B", draw_on_line, 2, kRegion, is_any},
    tie({1, "border of two regions", draw_above_end, 2, kRegion, has_letters<1>}),
    weighed({1, "weights", draw_segment, 2, kRegion, has_letters<2>}),

    Kind{2, "region of a vertex", draw_triangle, 3, kRegion, has_letters<1>},
    Kind{2, "region of an edge", draw_triangle, 3, kRegion, has_letters<2>},
    Kind{2, "inside", draw_triangle, 3, kRegion, has_letters<3>},
    Kind{2, "one negative weight, yet a vertex", draw_triangle, 3, kRegion, is_vertex_by_one_sign},
    Kind{2, "two negative weights, yet an edge", draw_triangle, 3, kRegion, is_edge_by_two_signs},
    tie({2, "border of two regions", draw_triangle_border, 3, kRegion, has_letters<1>}),
    weighed({2, "weights on an edge", draw_triangle, 3, kRegion, has_letters<2>}),
    weighed({2, "weights inside", draw_triangle, 3, kRegion, has_letters<3>}),

    Kind{3, "support point from a vertex", draw_polygon, 1, kSupport, is_support_from<1>},
    Kind{3, "support point from an edge", draw_polygon, 2, kSupport, is_support_from<2>},
    Kind{3, "one vertex dropped", draw_polygon, 3, kDropped, has_letters<1>},
    Kind{3, "two vertices dropped", draw_polygon, 3, kDropped, is_two},
    Kind{3, "the run goes on", draw_polygon, 2, kStop, goes_on},
    Kind{3, "stop: support point repeated", draw_polygon, 2, kStop, is_repeated},
    Kind{3, "stop: Q inside", draw_polygon, 3, kStop, is_inside},
    tie({3, "stop: Q at a vertex", draw_at_vertex, 2, kStop, is_zero}),
    whole_run({3, "a run of 2 iterations", draw_polygon, 1, kSupport, is_run_of<2>}),
    whole_run({3, "a run of 3 iterations", draw_polygon, 1, kSupport, is_run_of<3>}),

    Kind{4, "support point of the difference", draw_pair, 1, kSupport, is_any},
    in_difference({4, "region of a difference", draw_pair, 3, kRegion, is_pair}),
    in_difference({4, "region of an edge of differences", draw_pair, 3, kRegion, is_pair_edge}),
    of_tour("guess", 1, {4, "a vertex of X is closest", draw_pair, 1, kClosest, has_letters<1>}),
    of_tour("guess", 1, {4, "an edge of X is closest", draw_pair, 1, kClosest, has_letters<2>}),
    whole_run({4, "a run of 2 iterations", draw_pair, 1, kSupport, is_run_of<2>}),
    whole_run({4, "a run of 3 iterations", draw_pair, 1, kSupport, is_run_of<3>}),
    whole_run({4, "shapes that overlap", draw_pair, 1, kSupport, is_overlap}),
    tie(whole_run(
        {4, "shapes with a vertex in one place", draw_touching, 1, kSupport, is_touching})),

    of_tour(kSum, 2, {5, "an edge of Y comes next", draw_pair, 0, kNextEdge, is_of_y}),
    of_tour(kSum, 2, {5, "an edge of −X comes next", draw_pair, 0, kNextEdge, is_of_x}),
    tie(of_tour(kSum, 2, {5, "parallel edges", draw_parallel, 0, kNextEdge, is_both})),
    in_difference(
        of_tour("depth", 1, {5, "nearest edge at first", draw_pair, 1, kNearestEdge, is_any})),
    in_difference(
        of_tour("depth", 2, {5, "nearest edge after a step", draw_pair, 1, kNearestEdge, is_any})),

    Kind{9, "region of a vertex", draw_tetrahedron, 4, kRegion, has_letters<1>},
    Kind{9, "region of an edge", draw_tetrahedron, 4, kRegion, has_letters<2>},
    Kind{9, "region of a face", draw_tetrahedron, 4, kRegion, has_letters<3>},
    Kind{9, "inside", draw_tetrahedron, 4, kRegion, has_letters<4>},
    tie({9, "Q on a face", draw_on_face, 4, kRegion, has_letters<3>}),
    Kind{9, "support point from a vertex", draw_polyhedron, 1, kSupport, is_support_from<1>},
    Kind{9, "support point from an edge", draw_polyhedron, 2, kSupport, is_support_from<2>},
    Kind{9, "support point from a face", draw_polyhedron, 3, kSupport, is_support_from<3>},
};

/// The phase whose step tells what a kind asks for.
Phase answering_phase(const Kind& kind) {
  if (kind.ask == kStop) return Phase::stop;
  if (kind.ask == kSupport) return Phase::support;
  return kind.ask == kDropped ? Phase::drop : Phase::closest;
}

/// A lesson of a kind without shapes.
Lesson frame_of(const Kind& kind) {
  Lesson lesson;
  lesson.id = "practice";
  lesson.title = "Practice";
  lesson.chapter = kind.chapter;
  lesson.prose =
      kind.ask == kNextEdge
          ? "The outline of Y − X goes counter-clockwise from its lowest corner. One edge is "
            "there, and the bold edges can follow."
          : "All that is asked for follows from the coordinates.";
  lesson.dimension =
      kind.draw == draw_tetrahedron || kind.draw == draw_on_face || kind.draw == draw_polyhedron
          ? 3
          : 2;
  lesson.tour = kind.tour;
  if (kind.tour == "phase" && kind.on_paper != OnPaper::run) lesson.until = answering_phase(kind);
  LessonView view{.kind = kind.view, .title = {}, .camera = {}};
  if (lesson.dimension == 3) {
    view.eye = Eye{.azimuth = 24.0, .elevation = 24.0};
  } else {
    view.effects = {"grid"};
  }
  lesson.views = {std::move(view)};
  const bool is_run = kind.on_paper == OnPaper::run;
  lesson.questions.push_back(
      {std::string(kind.ask), is_run ? std::nullopt : std::optional(kind.at)});
  if (is_run) lesson.questions.push_back({std::string(kStop), std::nullopt});
  return lesson;
}

/// Pairs of vertices for the first simplex, each once: all vertices of a simplex in order, of other
/// shapes random ones.
void draw_start(Draws& draws, const Kind& kind, Lesson& lesson) {
  gjk::WarmStart& start = lesson.options.start;
  start = {.count = kind.start};
  const int of_x = static_cast<int>(lesson.x().vertices.size());
  const int of_y = static_cast<int>(lesson.y().vertices.size());
  for (int i = 0; i < kind.start; ++i) {
    gjk::VertexPair& pair = start.pairs[i];
    if (of_x == 1 && of_y == kind.start) {
      pair = {0, i};
      continue;
    }
    const auto is_there = [&] {
      return std::find(start.pairs.begin(), start.pairs.begin() + i, pair) !=
             start.pairs.begin() + i;
    };
    do {
      pair.x = draws.among(0, of_x - 1);
      pair.y = draws.among(0, of_y - 1);
    } while (is_there());
  }
}

/// A frame that asks, and the first after it that tells.
struct Asked {
  std::size_t asking = 0;
  std::size_t telling = 0;
};

/// Nothing where no frame asks.
std::optional<Asked> asked_in(const std::vector<Frame>& frames) {
  const auto asks = [](const Frame& frame) { return frame.question >= 0; };
  const auto asking = std::find_if(frames.begin(), frames.end(), asks);
  const auto telling = std::find_if_not(asking, frames.end(), asks);
  if (telling == frames.end()) return std::nullopt;
  return Asked{static_cast<std::size_t>(asking - frames.begin()),
               static_cast<std::size_t>(telling - frames.begin())};
}

/// The support points that a run found, but for a last one that it had already, and why it ended:
/// "C, D; then V in S".
std::string answer_of_run(const LessonRun& run) {
  std::string found;
  for (const WideStep& step : trace_of(run).steps) {
    if (step.phase != Phase::support || has_pair(step.after.simplex, step.after.support.pair))
      continue;
    found += (found.empty() ? "" : ", ") + run.pair_name(step.after.support.pair);
  }
  const Frame last{.step = static_cast<int>(trace_of(run).steps.size()) - 1};
  return fmt::format("{}; then {}", found.empty() ? "none" : found, stop_test(run, last));
}

/// The answer to what a task asks, then what there is to choose from; nothing where it asks
/// nothing.
using Decision = std::vector<std::string>;

Decision decision(const Kind& kind, LessonRun run) {
  if (!why_not_drawn(run.runs.front()).empty()) return {};
  if (kind.on_paper == OnPaper::run) return {answer_of_run(run)};
  const std::optional<Asked> asked = asked_in(run.frames);
  if (!asked) return {};
  run.frames.resize(asked->asking + 1);  // Words of later frames would only take time.
  EffectGraph effects(run);
  const FrameText text = lesson_texts(run, effects).back();
  Decision out = {text.question->answer};
  out.insert(out.end(), text.question->choices.begin(), text.question->choices.end());
  return out;
}

double size_of(const Lesson& lesson) {
  double size = 0.0;
  for (const LessonShape& shape : lesson.bodies) {
    for (const Vector3d& a : shape.vertices)
      for (const Vector3d& b : shape.vertices) size = std::max(size, (a - b).norm());
  }
  return size;
}

/// Arrows of one length along the axes, both ways, and to the corners of a square or a cube. Their
/// hull holds the disk or ball of radius 1. In the plane it is an octagon, 1 / cos(π/8) long. In
/// space a face has the corners (1, 0, 0), (1, 1, 1) / √3 and (1, 1, -1) / √3, so its plane is x +
/// (√3 - 1) y = 1.
std::vector<Vector3d> directions(int dimension) {
  const double length =
      std::sqrt(dimension == 2 ? 4.0 - 2.0 * std::sqrt(2.0) : 5.0 - 2.0 * std::sqrt(3.0));
  std::vector<Vector3d> out;
  for (const double x : {1.0, -1.0}) {
    for (int axis = 0; axis < dimension; ++axis) out.emplace_back(x * Vector3d::Unit(axis));
    for (const double y : {1.0, -1.0}) {
      out.emplace_back(x, y, dimension == 2 ? 0.0 : 1.0);
      if (dimension == 3) out.emplace_back(x, y, -1.0);
    }
  }
  for (Vector3d& direction : out) direction = length * direction.normalized();
  return out;
}

/// Whether the decision is the same wherever any one point is moved to within the margin. Tried in
/// all `ways`: where the places that give one answer are convex, as regions are, that says it of
/// all of them. A tie may fall to two sides; of a run that ends with one, the support points are
/// the same.
bool is_far_from_ties(const Kind& kind, const Lesson& lesson, const Decision& found) {
  std::set<Decision> sides = {found};
  const auto is_same = [&](const Decision& other) {
    if (!kind.is_tie) return other == found;
    if (kind.on_paper == OnPaper::run)
      return other.front().starts_with(found.front().substr(0, found.front().find(';')));
    sides.insert(other);
    return kind.ask != kRegion || sides.size() <= 2;
  };
  const double reach = margin_of(kind, lesson.dimension) * size_of(lesson);
  Lesson moved = lesson;
  for (LessonShape& shape : moved.bodies) {
    for (Vector3d& vertex : shape.vertices) {
      const Vector3d before = vertex;
      for (const Vector3d& direction : directions(lesson.dimension)) {
        vertex = before + reach * direction;
        if (!is_same(decision(kind, run_lesson(moved)))) return false;
      }
      vertex = before;
    }
  }
  return true;
}

/// A step is anybody's choice: P = O inside of an edge or a face, so that d may be either normal;
/// or in a whole run two new support points lie equally far along d, as they do wherever the
/// vertices stand that an edge of differences has from one shape.
bool has_choices(const Kind& kind, const LessonRun& run) {
  const WideTrace& trace = trace_of(run);
  for (int i = 0; i < static_cast<int>(trace.steps.size()); ++i) {
    const WideStep& step = trace.steps[i];
    const WideSimplex& simplex = step.after.simplex;
    if (step.phase == Phase::direction && simplex.count > 1 && step.after.p_sq == 0.0) return true;
    if (step.phase == Phase::support && kind.on_paper == OnPaper::run &&
        !has_pair(simplex, step.after.support.pair) && !is_open(run, trace, kSupport, i))
      return true;
  }
  return false;
}

bool is_far_away(const Vector3d& point) {
  return std::abs(point.x()) > 12.0 || std::abs(point.y()) > 7.0;  // in a picture twice as wide
}

/// A reader of the picture tells the points apart, unless two in one place are what the kind is
/// about.
bool is_clear(const Kind& kind, const Lesson& lesson) {
  const bool is_about_one_place = kind.draw == draw_touching || kind.draw == draw_at_vertex;
  const double least = is_about_one_place ? 0.0 : 0.9;
  std::vector<Vector3d> all;
  for (const LessonShape& shape : lesson.bodies)
    all.insert(all.end(), shape.vertices.begin(), shape.vertices.end());
  if (std::any_of(all.begin(), all.end(), is_far_away)) return false;
  if (const std::optional<Eye>& eye = lesson.views.front().eye) {
    for (Vector3d& point : all) point = in_space(in_plane(axes_of(*eye) * point));
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((all[i] - all[j]).norm() < least) return false;
  return true;
}

/// "(−3, 0.25)"
std::string place(const Vector3d& point, int dimension) {
  std::string out = "(";
  for (int axis = 0; axis < dimension; ++axis)
    out += (axis > 0 ? ", " : "") + significant(point[axis], 6);
  return out + ")";
}

std::vector<std::string> given_in(const Kind& kind, const LessonRun& run, const Frame& asking) {
  const Lesson& lesson = run.lesson;
  const bool is_query = run.point_query();
  std::vector<std::string> given;
  for (const std::size_t body : {is_query ? 1U : 0U, is_query ? 0U : 1U}) {
    const LessonShape& shape = lesson.bodies[body];
    for (std::size_t i = 0; i < shape.vertices.size(); ++i)
      given.push_back(shape.vertex_names[i] + " " + place(shape.vertices[i], lesson.dimension));
  }
  const bool is_simplex = is_query && kind.start == static_cast<int>(lesson.y().vertices.size());
  if (kind.tour != "phase" || is_simplex) return given;
  const WideTrace& trace = trace_of(run);
  const bool is_from_start = kind.on_paper == OnPaper::run || kind.ask == kStop;
  const WideState& before =
      is_from_start ? trace.initial : state_before(trace, asking.answering_step);
  std::string simplex;
  for (int i = 0; i < before.simplex.count; ++i)
    simplex += (i > 0 ? ", " : "") + run.pair_name(before.simplex.vertices[i].pair);
  given.push_back(fmt::format("S = {{{}}}", simplex));
  if (kind.ask == kSupport && !is_from_start)
    given.push_back("d = " + place(before.d, lesson.dimension));
  return given;
}

/// "3/13"; "0" and "1" have no denominator.
std::string fraction(double numerator, double denominator) {
  const auto n = std::llround(numerator);
  const auto d = std::llround(denominator);
  const auto common = std::gcd(n, d);
  return d == common ? fmt::format("{}", n / d) : fmt::format("{}/{}", n / common, d / common);
}

/// The weights of P as "A 3/13, B 10/13", from whole coordinates.
std::string weights_of(const LessonRun& run) {
  const gjk::Simplex<double, 2> simplex = in_plane(trace_of(run).initial.simplex);
  const gjk::Barycentric<double, 2> found =
      gjk::barycentric(simplex, trace_of(run).steps.front().after.region);
  std::string out;
  for (int i = 0; i < simplex.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    out += fmt::format("{}{} {}", i > 0 ? ", " : "", run.pair_name(simplex.vertices[at].pair),
                       fraction(found.numerator[at], found.denominator));
  }
  return out;
}

/// "Question: which point? Point at it." as paper asks it.
std::string on_paper(std::string caption) {
  constexpr std::string_view kBefore = "Question: ";
  constexpr std::string_view kAfter = " Point at it.";
  if (caption.ends_with(kAfter)) caption.resize(caption.size() - kAfter.size());
  return capitalized(caption.substr(caption.starts_with(kBefore) ? kBefore.size() : 0));
}

Task task_of(const Kind& kind, const LessonRun& run) {
  const Asked asked = *asked_in(run.frames);
  EffectGraph effects(run);
  const std::vector<FrameText> texts = lesson_texts(run, effects);
  const FrameText& asking = texts[asked.asking];
  Task task;
  task.kind = &kind;
  task.lesson = run.lesson;
  if (!trace_of(run).is_empty())
    task.lesson.expect.stop = name_of(trace_of(run).result.stop);  // which a file has to say
  task.asking = static_cast<int>(asked.asking);
  task.telling = static_cast<int>(asked.telling);
  task.given = given_in(kind, run, run.frames[asked.asking]);
  task.question = on_paper(asking.caption);
  task.choices = asking.question->choices;
  task.answer = asking.question->answer;
  task.reason = asking.question->reason;
  const std::string& y = run.lesson.y().name;
  if (kind.on_paper == OnPaper::weights) {
    task.question = fmt::format(
        "P is the point of {} closest to Q. Which weights do its vertices have in P? Fractions "
        "will do.",
        y);
    task.choices.clear();
    task.answer = weights_of(run);
  } else if (kind.on_paper == OnPaper::run) {
    task.question = fmt::format(
        "Go through GJK from S, step by step. Which support points does it find, and which test "
        "ends the run: V in S, {} inside S or d = 0?",
        run.point_query() ? "Q" : "O");
    task.asking = 0;
    task.telling = answering_index(run);
    task.choices.clear();
    task.answer = answer_of_run(run);
    const auto telling = static_cast<std::size_t>(task.telling);
    const FrameText& last = texts[telling - 1];
    task.reason = last.question ? last.question->reason : texts[telling].caption;
  } else if (kind.ask == kNextEdge) {
    task.question = task.lesson.prose + " Which edge comes next?";
  } else if (kind.ask == kStop) {
    task.asking = 0;  // Later frames show whether P = Q.
  } else if (!asking.question->pair.empty()) {
    task.choices.clear();
  }
  if (kind.ask == kRegion) {
    std::sort(task.choices.begin(), task.choices.end(), [](const auto& a, const auto& b) {
      return std::pair(a.size(), a) < std::pair(b.size(), b);
    });
    if (kind.is_tie) {
      task.question += " A border belongs to the smaller feature.";
      task.reason = "Q lies on a border.";
    }
  }
  return task;
}

}  // namespace

std::span<const Kind> kinds_of(int chapter) {
  const auto is_own = [&](const Kind& kind) { return kind.chapter == chapter; };
  const auto begin = std::find_if(kKinds.begin(), kKinds.end(), is_own);
  return {begin, std::find_if_not(begin, kKinds.end(), is_own)};
}

const std::vector<int>& chapters_with_practice() {
  static const std::vector<int> chapters = [] {
    std::vector<int> out;
    for (const Kind& kind : kKinds)
      if (out.empty() || out.back() != kind.chapter) out.push_back(kind.chapter);
    return out;
  }();
  return chapters;
}

double margin_of(const Kind& kind, int dimension) {
  // A run makes many decisions, and a simplex of space has little room between its faces.
  if (kind.on_paper == OnPaper::run) return 0.03;
  return dimension == 3 ? 0.05 : 0.1;
}

Task make_task(const Kind& kind, std::uint64_t seed) {
  constexpr int kTries = 1'000'000;
  Draws draws(seed);
  for (int i = 0; i < kTries; ++i) {
    Lesson lesson = frame_of(kind);
    kind.draw(draws, lesson);
    draw_start(draws, kind, lesson);
    if (!is_clear(kind, lesson)) continue;
    Lesson trial = lesson;
    trial.options.proof = gjk::Proof::none;  // which decides nothing, and takes most of the time
    const LessonRun run = run_lesson(trial);
    const Decision found = decision(kind, run);
    if (found.empty() || !kind.wanted(run, found.front())) continue;
    if (kind.ask != kRegion && has_choices(kind, run)) continue;
    if (!is_far_from_ties(kind, trial, found)) continue;
    return task_of(kind, run_lesson(lesson));
  }
  throw std::runtime_error(
      fmt::format("no shapes for '{}' are found from the seed {}", kind.name, seed));
}

std::vector<Task> make_tasks(int chapter, int count, std::uint64_t seed) {
  const std::span<const Kind> kinds = kinds_of(chapter);
  Draws draws(seed);
  std::vector<const Kind*> order;
  std::vector<Task> tasks;
  for (int i = 0; i < count; ++i) {
    if (order.empty()) {
      for (const Kind& kind : kinds) order.push_back(&kind);
    }
    const auto at = draws.among(0, static_cast<int>(order.size()) - 1);
    tasks.push_back(make_task(*order[at], draws.next()));
    order.erase(order.begin() + at);
  }
  return tasks;
}

}  // namespace gjkscope::practice
