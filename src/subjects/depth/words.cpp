#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "lesson/names.hpp"
#include "subjects/depth/shown.hpp"

namespace gjkscope::depths {
namespace {

using depth::Phase;
using depth::StopReason;

constexpr double kRounding = 1e-12;  // relative: far less than frames show

/// One frame's words.
class Telling {
 public:
  Telling(const Story& story, FrameText& text)
      : story_(story),
        text_(text),
        run_(story.run),
        shown_(shown_in<Shown>(story)),
        state_(shown_.state) {}

  void tell() {
    if (state_.polygon.count == 0) return apart();
    if (shown_.is_answer) return answer();
    if (shown_.step == nullptr) return start();
    switch (shown_.step->phase) {
      case Phase::nearest:
        return nearest();
      case Phase::support:
        return support();
      case Phase::stop:
        return stop();
      case Phase::expand:
        return expand();
    }
  }

 private:
  [[nodiscard]] const std::string& x() const { return run_.lesson.x().name; }
  [[nodiscard]] const std::string& y() const { return run_.lesson.y().name; }
  [[nodiscard]] std::string number(double value) const { return story_.numbers(value); }
  [[nodiscard]] std::string edge() const { return edge_name(run_, state_, state_.edge); }
  /// True for a length that is 0 but for rounding.
  [[nodiscard]] bool is_zero(double length) const {
    double size = 0.0;
    for (const auto& corner : state_.polygon.corners) size = std::max(size, corner.point.w.norm());
    return std::abs(length) <= kRounding * size;
  }
  [[nodiscard]] std::string support_name() const { return run_.pair_name(state_.support.pair); }

  void apart() {
    text_.caption = fmt::format("{} and {} do not overlap: they are {} apart and have no depth.",
                                x(), y(), number(story_.trace.result.distance));
    text_.detail = "O lies outside Z, so no polygon in Z holds it. Nothing needs to move.";
  }

  void start() {
    const WideSimplex& simplex = story_.trace.result.simplex;
    const SimplexWords words(run_, simplex);
    text_.caption = fmt::format(
        "{} and {} share points: GJK ends with O {} the {}. How deep do they overlap?", x(), y(),
        simplex.count == 1   ? "at"
        : simplex.count == 2 ? "on"
                             : "in",
        words.kind_and_face(simplex.all()));
    text_.detail =
        "The depth is the distance from O to the boundary of Z. The search starts with this "
        "simplex, "
        "a polygon in Z.";
  }

  /// The polygon is a single point, which counts as its nearest edge.
  [[nodiscard]] bool is_point() const { return state_.edge.from == state_.edge.to; }

  void nearest() {
    const std::string name = edge();
    if (!(state_.edge.distance_sq > 0.0)) {
      text_.caption = fmt::format("O lies on {}: its distance is 0.", name);
      text_.detail = is_point()
                         ? "A point has no normal, so n is any direction. Next: does Z reach "
                           "beyond the point along n?"
                         : "This proves no depth yet. Next: does Z reach beyond the edge, along "
                           "its normal n?";
      return;
    }
    text_.caption = fmt::format("{}{} is nearest to O, at distance {}.",
                                static_cast<char>(std::toupper(name[0])), name.substr(1),
                                number(std::sqrt(state_.edge.distance_sq)));
    text_.detail = fmt::format(
        "The polygon lies in Z, so the boundary of Z is no nearer: depth ≥ {}. Next: how far does "
        "Z "
        "reach along the normal n?",
        number(shown_.step->bounds.lower));
  }

  void support() {
    const double reach = state_.n.dot(state_.support.w) / state_.n.norm();
    const double upper = shown_.step->bounds.upper;
    if (is_zero(reach)) {
      text_.caption =
          fmt::format("{} lies farthest along n, but no farther than O.", support_name());
      text_.detail =
          fmt::format("No point of Z lies beyond O in this direction: {} need not move.", x());
      return;
    }
    text_.caption = fmt::format("{} lies farthest along n: Z reaches {} from O in this direction.",
                                support_name(), number(reach));
    text_.detail = upper < reach * (1.0 - kRounding)
                       ? fmt::format(
                             "Moving {} that far along n parts the shapes, but a shorter move is "
                             "known: depth ≤ {}.",
                             x(), number(upper))
                       : fmt::format("Moving {} that far along n parts it from {}: depth ≤ {}.",
                                     x(), y(), number(upper));
  }

  void stop() {
    const double beyond =
        state_.n.dot(state_.support.w - state_.polygon.at(state_.edge.from)) / state_.n.norm();
    switch (state_.stop) {
      case StopReason::running:
        text_.caption =
            is_point()
                ? fmt::format("{} lies {} beyond the point: Z is more than this point.",
                              support_name(), number(beyond))
                : fmt::format("{} lies {} beyond the edge: the edge is not part of Z's boundary.",
                              support_name(), number(beyond));
        text_.detail = fmt::format("Go on: {} becomes a corner of the polygon.", support_name());
        return;
      case StopReason::repeated_support:
        text_.caption = fmt::format(
            "Stop: {} is an end of this edge, so no point of Z lies beyond it.", support_name());
        break;
      case StopReason::no_progress:
        text_.caption = fmt::format(
            "Stop: {} lies no farther along n than the edge, so no point of Z lies beyond it.",
            support_name());
        break;
      default:
        text_.caption = "Stop: the search has used all its iterations. The bounds still hold.";
        text_.detail =
            fmt::format("The depth lies between {} and {}.", number(shown_.trace.result.lower),
                        number(shown_.trace.result.upper));
        return;
    }
    text_.detail = fmt::format(
        "The edge is part of Z's boundary, and no other edge is nearer to O. The depth is {}.",
        number(shown_.trace.result.depth));
  }

  void expand() {
    const auto name = [&](int corner) {
      return run_.pair_name(state_.polygon.corners[static_cast<std::size_t>(corner)].point.pair);
    };
    const int count = state_.polygon.count;
    if (count == 2) {
      text_.caption = fmt::format(
          "{} joins the point: the polygon is a segment, seen from its "
          "two sides as two edges.",
          support_name());
      text_.detail = "Next: which edge is nearest to O now?";
      return;
    }
    text_.caption =
        fmt::format("{} goes between the ends of the edge. The polygon now has {} edges.",
                    support_name(), count);
    const std::vector<int>& outgrown = shown_.step->record.outgrown;
    if (outgrown.empty()) {
      text_.detail = "Two new edges replace the old one. Next: which edge is nearest to O now?";
      return;
    }
    std::vector<std::string> names;
    for (const int corner : outgrown) names.push_back(name(corner));
    text_.detail = fmt::format("{} {} of the larger polygon: dropped.", fmt::join(names, " and "),
                               names.size() == 1 ? "is no corner" : "are no corners");
  }

  void answer() {
    const depth::Result<double>& result = shown_.trace.result;
    if (!(result.depth > 0.0)) {
      text_.caption =
          fmt::format("The depth is 0: {} and {} only touch. Nothing needs to move.", x(), y());
      text_.detail =
          fmt::format("They touch at {}. Along {}, no point of Z lies beyond O.",
                      story_.numbers.point(result.x), story_.numbers.point(result.direction));
      return;
    }
    text_.caption =
        fmt::format("The depth is {}. Moved by t = {}, {} just touches {}.", number(result.depth),
                    story_.numbers.point(result.translation), x(), y());
    text_.detail = fmt::format(
        "The point {} of {} then meets {} of {}. No shorter move parts them: no edge of Z is "
        "nearer "
        "to O.",
        story_.numbers.point(result.x), x(), story_.numbers.point(result.y), y());
  }

  const Story& story_;
  FrameText& text_;
  const LessonRun& run_;
  const Shown& shown_;
  const depth::State<double>& state_;
};

}  // namespace

void words(const Story& story, FrameText& text) { Telling(story, text).tell(); }

void question(const Story& story, FrameText& text) {
  const DepthTrace& trace = *depth_trace(story.run, story.frame.run);
  const depth::Step<double>& step =
      trace.steps[static_cast<std::size_t>(story.frame.answering_step)];
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskEdge.name), {}, {}});
  for (const depth::Edge<double>& edge : step.record.edges)
    asked.choices.push_back(ends(story.run, step.after, edge));
  // The order of the polygon starts at its newest corner.
  std::sort(asked.choices.begin(), asked.choices.end());
  asked.answer = ends(story.run, step.after, step.after.edge);
  text.caption = "Question: which edge of the polygon is nearest to O?";
}

void values(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  const depth::State<double>& state = shown.state;
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  put("iteration", std::to_string(shown.step != nullptr ? shown.step->iteration : 0));
  put("iterations", std::to_string(shown.trace.result.iterations));
  if (shown.knows_edge()) put("edge", ends(story.run, state, state.edge));
  if (shown.knows_edge()) put("n", story.numbers.point(state.n));
  if (shown.knows_support()) put("support", story.run.pair_name(state.support.pair));
  if (shown.step != nullptr) {
    put("lower", story.numbers(shown.step->bounds.lower));
    if (shown.step->bounds.upper >= 0.0) put("upper", story.numbers(shown.step->bounds.upper));
  }
  if (!shown.is_answer) return;
  put("depth", story.numbers(shown.trace.result.depth));
  put("t", story.numbers.point(shown.trace.result.translation));
}

}  // namespace gjkscope::depths
