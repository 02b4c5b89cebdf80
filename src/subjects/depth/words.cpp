#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "run/questions.hpp"
#include "subjects/depth/shown.hpp"

namespace gjkscope::depths {
namespace {

using depth::Phase;
using depth::StopReason;

constexpr double kRounding = 1e-12;  // relative: far less than frames show

/// The words that depend on the dimension.
struct Nouns {
  std::string_view polytope;
  std::string_view facet;
  std::string_view corner;
};

/// One frame's words: those that are alike in the plane and in space.
template <class S>
class TellingOf {
 public:
  TellingOf(const Story& story, FrameText& text, const Nouns& nouns)
      : story_(story),
        text_(text),
        run_(story.run),
        shown_(shown_in<S>(story)),
        state_(shown_.state),
        nouns_(nouns) {}

 protected:
  [[nodiscard]] const std::string& x() const { return run_.lesson.x().name; }
  [[nodiscard]] const std::string& y() const { return run_.lesson.y().name; }
  [[nodiscard]] std::string number(double value) const { return story_.numbers(value); }
  [[nodiscard]] std::string support_name() const { return run_.pair_name(state_.support.pair); }

  void apart() {
    text_.caption = fmt::format("{} and {} do not overlap: they are {} apart and have no depth.",
                                x(), y(), number(story_.trace.result.distance));
    text_.detail = fmt::format("O lies outside Z, so no {} in Z holds it. Nothing needs to move.",
                               nouns_.polytope);
  }

  /// GJK's end.
  void start() {
    const WideSimplex& simplex = story_.trace.result.simplex;
    const SimplexWords words(run_, simplex);
    text_.caption = fmt::format(
        "{} and {} share points: GJK ends with O {} the {}. How deep do they overlap?", x(), y(),
        simplex.count == 1                             ? "at"
        : simplex.count <= (is_in_space(run_) ? 3 : 2) ? "on"
                                                       : "in",
        words.kind_and_face(simplex.all()));
  }

  /// `is_zero`: for a length.
  void support(const auto& is_zero) {
    const double reach = shown_.reach();
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

  /// Tells the phase that is over. `own`: this, with the words that differ.
  void phase(auto& own) {
    switch (shown_.step->phase) {
      case Phase::nearest:
        return own.nearest();
      case Phase::support:
        return support([&](double length) { return own.is_zero(length); });
      case Phase::stop:
        return shown_.has_stopped() ? stop() : own.go_on();
      case Phase::expand:
        return own.expand();
    }
  }

  /// The run has ended.
  void stop() {
    switch (state_.stop) {
      case StopReason::repeated_support:
        text_.caption = fmt::format("Stop: {} is {} of this {}, so no point of Z lies beyond it.",
                                    support_name(), nouns_.corner, nouns_.facet);
        break;
      case StopReason::no_progress:
        text_.caption = fmt::format(
            "Stop: {} lies no farther along n than the {}, so no point of Z lies beyond it.",
            support_name(), nouns_.facet);
        break;
      default:
        text_.caption = "Stop: the search has used all its iterations. The bounds still hold.";
        text_.detail = fmt::format("The depth lies between {} and {}.", number(shown_.result.lower),
                                   number(shown_.result.upper));
        return;
    }
    text_.detail = fmt::format(
        "The {0} is part of Z's boundary, and no other {0} is nearer to O. The depth is {1}.",
        nouns_.facet, number(shown_.result.depth));
  }

  void answer() {
    const DepthResult& result = shown_.result;
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
        "The point {} of {} then meets {} of {}. No shorter move parts them: no {} of Z is nearer "
        "to O.",
        story_.numbers.point(result.x), x(), story_.numbers.point(result.y), y(), nouns_.facet);
  }

  const Story& story_;
  FrameText& text_;
  const LessonRun& run_;
  const S& shown_;
  const decltype(S::state)& state_;
  Nouns nouns_;
};

class Telling : TellingOf<Shown> {
  friend class TellingOf<Shown>;

 public:
  Telling(const Story& story, FrameText& text)
      : TellingOf(story, text, {"polygon", "edge", "an end"}) {}

  void tell() {
    if (state_.polygon.count == 0) return apart();
    if (shown_.is_answer) return answer();
    if (shown_.step == nullptr) {
      start();
      text_.detail =
          "The depth is the distance from O to the boundary of Z. The search starts with this "
          "simplex, "
          "a polygon in Z.";
      return;
    }
    phase(*this);
  }

 private:
  /// True for a length that is 0 but for rounding.
  [[nodiscard]] bool is_zero(double length) const {
    double size = 0.0;
    for (const auto& corner : state_.polygon.corners) size = std::max(size, corner.point.w.norm());
    return std::abs(length) <= kRounding * size;
  }

  /// The polygon is a single point, which counts as its nearest edge.
  [[nodiscard]] bool is_point() const { return state_.edge.from == state_.edge.to; }

  void nearest() {
    const std::string name = edge_name(run_, state_, state_.edge);
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

  void go_on() {
    const double beyond = shown_.beyond(state_.polygon.at(state_.edge.from));
    text_.caption =
        is_point()
            ? fmt::format("{} lies {} beyond the point: Z is more than this point.", support_name(),
                          number(beyond))
            : fmt::format("{} lies {} beyond the edge: the edge is not part of Z's boundary.",
                          support_name(), number(beyond));
    text_.detail = fmt::format("Go on: {} becomes a corner of the polygon.", support_name());
  }

  void expand() {
    const auto name = [&](int corner) {
      return run_.pair_name(state_.polygon.corners[corner].point.pair);
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
};

class TellingInSpace : TellingOf<ShownInSpace> {
  friend class TellingOf<ShownInSpace>;

 public:
  TellingInSpace(const Story& story, FrameText& text)
      : TellingOf(story, text, {"polytope", "face", "a corner"}) {}

  void tell() {
    if (shown_.polytope().faces.empty()) return apart();
    if (shown_.is_answer) return answer();
    if (shown_.step == nullptr) return first_polytope();
    phase(*this);
  }

 private:
  [[nodiscard]] bool is_zero(double length) const {
    double size = 0.0;
    for (const WideVertex& corner : shown_.polytope().corners)
      size = std::max(size, corner.w.norm());
    return std::abs(length) <= kRounding * size;
  }
  [[nodiscard]] std::string face() const { return face_name(shown_.trace, state_.face); }

  void first_polytope() {
    start();
    const std::vector<WideVertex>& corners = shown_.polytope().corners;
    const int count = story_.trace.result.simplex.count;
    if (count == 4) {
      text_.detail =
          "The depth is the distance from O to the boundary of Z. The search starts with this "
          "tetrahedron, a polytope in Z.";
    } else if (count == 3) {
      text_.detail =
          "A triangle has no inside. It counts as a flat polytope of two faces, back to back, and "
          "O is on both.";
    } else {
      std::vector<std::string> more;
      for (std::size_t i = static_cast<std::size_t>(count); i < corners.size(); ++i)
        more.push_back(run_.pair_name(corners[i].pair));
      text_.detail = fmt::format(
          "{} {} it a triangle: a flat polytope of two faces, back to back, and O is on both.",
          and_list(more), more.size() == 1 ? "makes" : "make");
    }
  }

  void nearest() {
    const double distance_sq = shown_.face(state_.face).distance_sq;
    if (distance_sq < 0.0) {
      text_.caption =
          fmt::format("O lies beyond the face {}: the polytope does not hold O yet.", face());
      text_.detail = "Next: how far does Z reach along its normal n?";
      return;
    }
    if (is_zero(std::sqrt(distance_sq))) {
      text_.caption = fmt::format("O lies on the face {}: its distance is 0.", face());
      text_.detail =
          "This proves no depth yet. Next: does Z reach beyond the face, along its normal n?";
      return;
    }
    text_.caption = fmt::format("The face {} is nearest to O, at distance {}.", face(),
                                number(std::sqrt(distance_sq)));
    text_.detail = fmt::format(
        "The polytope lies in Z, so the boundary of Z is no nearer: depth ≥ {}. Next: how far does "
        "Z reach along the normal n?",
        number(shown_.step->bounds.lower));
  }

  void go_on() {
    std::vector<int> seen = std::next(shown_.step)->record.outgrown;
    std::sort(seen.begin(), seen.end());
    const std::size_t ring = std::next(shown_.step)->record.added.size();
    text_.caption = fmt::format(
        "Go on: {} lies {} beyond the face, so the face is not on Z's boundary.", support_name(),
        number(shown_.beyond(shown_.polytope().at(shown_.face(state_.face), 0))));
    std::vector<std::string> names;
    for (const int each : seen) names.push_back(face_name(shown_.trace, each));
    text_.detail =
        seen.size() == 1
            ? fmt::format("{} is the only face visible from {}. Its {} edges are the horizon.",
                          names[0], support_name(), ring)
            : fmt::format(
                  "Visible from {} are {} faces: {}. The {} edges around them are the horizon.",
                  support_name(), seen.size(), and_list(names), ring);
  }

  void expand() {
    const std::size_t ring = shown_.step->record.added.size();
    const std::size_t gone = shown_.step->record.outgrown.size();
    text_.caption = fmt::format("{} joined to the {} edges of the horizon gives {} new faces.",
                                support_name(), ring, ring);
    text_.detail = fmt::format(
        "They take the place of the {}. The polytope now has {} faces. Next: which is nearest to "
        "O?",
        gone == 1 ? "visible face" : fmt::format("{} visible faces", gone), shown_.faces().size());
  }
};

/// Names of all vertices of Y and of X, and of their differences: for the next support point.
void support_question(const Story& story, const gjk::VertexPair& pair, FrameText& text) {
  const LessonShape& x = story.run.lesson.x();
  const LessonShape& y = story.run.lesson.y();
  FrameQuestion& asked = *text.question;
  asked.pair = {{y.name, y.vertex_names}, {x.name, x.vertex_names}};
  for (const std::string& of_y : y.vertex_names) {
    for (const std::string& of_x : x.vertex_names)
      asked.choices.push_back(fmt::format("{}−{}", of_y, of_x));
  }
  asked.answer = story.run.pair_name(pair);
  text.caption = fmt::format(
      "Question: which vertex of {} lies farthest along n, and which vertex of {} along −n?",
      y.name, x.name);
  text.detail = fmt::format("{}: {}      {}: {}", y.name, listed_choices(y.vertex_names), x.name,
                            listed_choices(x.vertex_names));
}

void facet_question(const LessonRun& run, const Shown& shown, FrameText& text) {
  FrameQuestion& asked = *text.question;
  for (const depth::Edge<double>& edge : shown.step->record.edges)
    asked.choices.push_back(ends(run, shown.state, edge));
  // The order of the polygon starts at its newest corner.
  std::sort(asked.choices.begin(), asked.choices.end());
  asked.answer = ends(run, shown.state, shown.state.edge);
  text.caption = "Question: which edge of the polygon is nearest to O?";
}

/// The nearest face, or another one that is visible.
void facet_question(const LessonRun& run, const ShownInSpace& shown, FrameText& text) {
  FrameQuestion& asked = *text.question;
  const bool of_nearest = asked.ask == kAskFace.name;
  const auto name = [&](int face) { return face_name(shown.trace, face); };
  for (const int face : shown.faces()) {
    if (!of_nearest && face == shown.state.face) continue;
    asked.choices.push_back(name(face));
    asked.spots.emplace_back(spot_of_triangle(ViewKind::difference, shown.corners(face)));
    if (of_nearest ? face == shown.state.face : shown.is_visible(face)) asked.answer = name(face);
  }
  text.caption =
      of_nearest ? "Question: which face of the polytope is nearest to O? Point at it."
                 : fmt::format("Question: {} sees {}. Which other face does it see? Point at it.",
                               run.pair_name(shown.state.support.pair), name(shown.state.face));
}

template <class S>
void question_of(const Story& story, FrameText& text) {
  Frame answering = story.frame;
  answering.step = story.frame.answering_step;
  const S shown(story.run, answering);
  const std::string& ask = story.run.asked(story.frame).ask;
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  if (ask == asks::kSupport.name) return support_question(story, shown.state.support.pair, text);
  if (ask != kAskBeyond.name) return facet_question(story.run, shown, text);
  asked.choices = {"yes", "no"};
  const bool goes_on = std::next(shown.step)->after.stop == StopReason::running;
  asked.answer = asked.choices[goes_on ? 0 : 1];
  text.caption = fmt::format("Question: does any point of Z lie beyond this {}, along n?",
                             std::is_same_v<S, Shown> ? "edge" : "face");
}

void put_nearest(const Story& story, const Shown& shown, FrameText& text) {
  text.values.emplace_back("edge", ends(story.run, shown.state, shown.state.edge));
}
void put_nearest(const Story&, const ShownInSpace& shown, FrameText& text) {
  text.values.emplace_back("face", face_name(shown.trace, shown.state.face));
}

template <class S>
void values_of(const Story& story, FrameText& text) {
  const S& shown = shown_in<S>(story);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  put("iteration", std::to_string(shown.step != nullptr ? shown.step->iteration : 0));
  put("iterations", std::to_string(shown.result.iterations));
  if (shown.knows_nearest()) {
    put_nearest(story, shown, text);
    put("n", story.numbers.point(shown.state.n));
  }
  if (shown.knows_support()) put("support", story.run.pair_name(shown.state.support.pair));
  if (shown.step != nullptr) {
    put("lower", story.numbers(shown.step->bounds.lower));
    if (shown.step->bounds.upper >= 0.0) put("upper", story.numbers(shown.step->bounds.upper));
  }
  if (!shown.is_answer) return;
  put("depth", story.numbers(shown.result.depth));
  put("t", story.numbers.point(shown.result.translation));
}

}  // namespace

void words(const Story& story, FrameText& text) {
  is_in_space(story.run) ? TellingInSpace(story, text).tell() : Telling(story, text).tell();
}

void question(const Story& story, FrameText& text) {
  is_in_space(story.run) ? question_of<ShownInSpace>(story, text) : question_of<Shown>(story, text);
}

void values(const Story& story, FrameText& text) {
  is_in_space(story.run) ? values_of<ShownInSpace>(story, text) : values_of<Shown>(story, text);
}

}  // namespace gjkscope::depths
