#include <fmt/format.h>

#include <algorithm>

#include "subjects/lin_canny/shown.hpp"

namespace gjkscope::walks {
namespace {

using models::WalkPhase;
using models::WalkStop;

class Telling {
 public:
  Telling(const Story& story, FrameText& text)
      : story_(story), text_(text), shown_(shown_in<Shown>(story)) {}

  void tell() {
    if (!shown_.walk.query) return refused();
    if (shows_pairs(story_.run, story_.frame)) return pairs();
    if (shown_.is_answer) return answer();
    if (shown_.step == nullptr) return start();
    switch (shown_.step->phase) {
      case WalkPhase::closest:
        return closest();
      case WalkPhase::regions:
        return regions();
      case WalkPhase::swap:
        return swap();
    }
  }

 private:
  [[nodiscard]] const std::string& x() const { return shown_.lesson.x().name; }
  [[nodiscard]] const std::string& y() const { return shown_.lesson.y().name; }
  [[nodiscard]] std::string distance() const { return story_.numbers(shown_.closest().distance); }
  [[nodiscard]] const std::string& point_of(bool of_x) const { return of_x ? x() : y(); }
  /// Before the step that the frame shows.
  [[nodiscard]] const models::WalkState& before() const {
    const auto& steps = shown_.walk.trace.steps;
    return shown_.step == &steps.front() ? shown_.walk.trace.start : (shown_.step - 1)->after;
  }

  void refused() {
    text_.caption = fmt::format("The walk does not take {}: {}.",
                                shown_.walk.trace.result.flaw_in_b ? y() : x(),
                                models::name_of(shown_.walk.trace.result.flaw.fault));
    text_.detail = "It needs one closed outline of each shape, which does not meet itself.";
  }

  void start() {
    text_.caption =
        fmt::format("The walk starts at {} and {}.", shown_.name(true), shown_.name(false));
    text_.detail =
        "A feature is a vertex or an edge. Any pair of features will do: a near pair ends sooner. "
        "Next: their closest points.";
    if (story_.frame.run == 0) return;
    text_.caption.back() = ',';
    text_.caption += " where the last walk ended.";
    text_.detail = "Next: their closest points.";
    if (const std::string moved = story_.moved(); !moved.empty())
      text_.detail = moved + " If that is little, the walk ends near there. " + text_.detail;
  }

  void closest() {
    if (shown_.state.stop == WalkStop::overlap) {
      text_.caption = fmt::format("{} and {} meet: the shapes overlap.",
                                  capitalized(shown_.name(true)), shown_.name(false));
      text_.detail = "The walk stops here. It cannot say how deep the shapes overlap.";
      return;
    }
    text_.caption = fmt::format("The closest points of {} and {} are {} apart.", shown_.name(true),
                                shown_.name(false), distance());
    for (const bool of_x : {true, false}) {
      const models::RingFeature& was = of_x ? before().a : before().b;
      if (was.is_vertex == shown_.feature(of_x).is_vertex) continue;
      text_.detail += fmt::format("The closest point of {} is its end: {} takes over. ",
                                  shown_.name(of_x, was), shown_.name(of_x));
    }
    text_.detail += "Next: does each point lie in the other feature's Voronoi region?";
  }

  void regions() {
    const models::RegionTest& found = shown_.state.found;
    if (found.crossed && found.behind) {
      text_.caption = fmt::format("The closest point on {} lies behind {}.", point_of(!found.of_a),
                                  shown_.name(found.of_a));
      text_.detail =
          "Behind an edge there is no Voronoi region. Next: look at all edges for the nearest one.";
      return;
    }
    if (found.crossed) {
      text_.caption = fmt::format("The closest point on {} lies outside the region of {}.",
                                  point_of(!found.of_a), shown_.name(found.of_a));
      text_.detail =
          fmt::format("It lies beyond the border to {}, which is closer to it. {}Next: go there.",
                      shown_.name(found.of_a, found.neighbour),
                      crosses_another() ? "The first of two crossed borders counts. " : "");
      return;
    }
    text_.caption = "Each closest point lies in the Voronoi region of the other feature.";
    if (shown_.state.stop == WalkStop::local_minimum) {
      text_.detail =
          "No neighbour is closer. But another pair is: the walk has stopped in a local minimum.";
    } else if (shown_.state.stop == WalkStop::overlap) {
      text_.detail =
          "No neighbour is closer. But the shapes overlap elsewhere, and the walk cannot see it.";
    } else if (story_.frame.run == 0) {
      text_.detail =
          "Then the slab between them is empty, so no other two points are closer: stop.";
    } else {
      text_.detail = fmt::format(
          "The slab between them is empty and {} wide, so the walk stops: it measured {} pair{}.",
          distance(), shown_.walk.trace.result.steps,
          shown_.walk.trace.result.steps == 1 ? "" : "s");
    }
  }

  /// Besides the border that was found.
  [[nodiscard]] bool crosses_another() const {
    const models::RegionTest& found = shown_.state.found;
    const models::Answer pair = shown_.closest();
    const std::vector<Border> all = shown_.borders(found.of_a);
    return std::any_of(all.begin(), all.end(), [&](const Border& border) {
      return border.neighbour != found.neighbour && border.beyond(found.of_a ? pair.b : pair.a) > 0;
    });
  }

  void swap() {
    const bool of_x = shown_.state.found.of_a;
    if (shown_.state.stop == WalkStop::overlap) {
      text_.caption = fmt::format("{} lies in {}: the shapes overlap.",
                                  capitalized(shown_.name(!of_x)), point_of(of_x));
      text_.detail = "It lies behind each edge. The walk stops here: it cannot say how deep.";
      return;
    }
    text_.caption = fmt::format("{} takes the place of {}.", capitalized(shown_.name(of_x)),
                                shown_.name(of_x, of_x ? before().a : before().b));
    const bool overlap = shown_.walk.trace.result.stop == WalkStop::overlap;
    text_.detail =
        shown_.step->asked > 0
            ? fmt::format("It is the nearest of {} edges. Next: the closest points again.",
                          shown_.step->asked)
        : overlap || shown_.state.swaps > 1
            ? "Next: the closest points again."
            : "Each swap lowers the distance, so no pair comes twice. Next: the closest points "
              "again.";
  }

  /// All pairs, of which the walk took a few.
  void pairs() {
    const std::vector<models::WalkState> pairs = shown_.pairs();
    text_.caption =
        fmt::format("The walk looked at {} of {} · {} pairs: each is closer than the last.",
                    pairs.size(), shown_.features(true), shown_.features(false));
    text_.detail = "No pair comes twice, so all of them are the most: O(n²), says Larsen.";
  }

  void answer() {
    const models::WalkResult& result = shown_.walk.trace.result;
    const bool tells_of_all = story_.run.frames.back().part >= 0;
    text_.detail = fmt::format(
        "The walk measured {} pairs of features.",
        tells_of_all ? std::to_string(result.steps)
                     : fmt::format("{} of {}", result.steps, shown_.walk.query->pairs()));
    if (result.stop == WalkStop::overlap) {
      text_.caption = fmt::format("{} and {} overlap: the distance is 0.", x(), y());
    } else if (result.stop == WalkStop::local_minimum) {
      text_.caption = fmt::format("The walk says {}, but {} and {} are only {} apart.",
                                  story_.numbers(result.answer.distance), x(), y(),
                                  story_.numbers(shown_.walk.truth->distance));
      text_.detail +=
          " It compares neighbours only, so it is stuck: all pairs, or pieces that are convex, "
          "give the "
          "true distance.";
    } else {
      text_.caption = fmt::format("The distance is {}, between {} and {}.",
                                  story_.numbers(result.answer.distance), shown_.name(true),
                                  shown_.name(false));
    }
  }

  const Story& story_;
  FrameText& text_;
  const Shown& shown_;
};

}  // namespace

void words(const Story& story, FrameText& text) { Telling(story, text).tell(); }

namespace {

void most_question(const Shown& shown, FrameText& text) {
  const int of_x = shown.features(true);
  const int of_y = shown.features(false);
  FrameQuestion& asked = *text.question;
  asked.choices = {fmt::format("{} + {}", of_x, of_y), fmt::format("{} · {}", of_x, of_y),
                   "no limit"};
  asked.answer = asked.choices[1];
  const std::vector<models::WalkState> pairs = shown.pairs();
  const auto count = [&](const models::WalkState& one) {
    return std::count_if(pairs.begin(), pairs.end(),
                         [&](const models::WalkState& other) { return other.b == one.b; });
  };
  const auto most = std::max_element(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
    return count(a) < count(b);
  });
  asked.refuted = fmt::format("One feature may come often: {} in {} pairs.",
                              shown.name(false, most->b), count(*most));
  text.caption = fmt::format(
      "Question: {} has {} vertices and edges, {} has {}. How many pairs can a walk look at, at "
      "most?",
      shown.lesson.x().name, of_x, shown.lesson.y().name, of_y);
}

}  // namespace

void question(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  FrameQuestion& asked =
      text.question.emplace(FrameQuestion{story.run.asked(story.frame).ask, {}, {}});
  if (asked.ask == kAskMost.name) return most_question(shown, text);
  const models::WalkStep& step = shown.walk.trace.steps[story.frame.answering_step];
  for (const bool of_x : {true, false}) {
    const models::Ring& ring = shown.ring(of_x);
    const models::RingFeature& at = of_x ? step.after.a : step.after.b;
    const std::array<int, 2> beside = at.is_vertex ? std::array{at.index, ring.previous(at.index)}
                                                   : std::array{at.index, ring.next(at.index)};
    for (const int index : beside)
      asked.choices.push_back(shown.name(of_x, {!at.is_vertex, index}));
  }
  asked.choices.emplace_back("none: stop");
  const models::RegionTest& found = step.after.found;
  asked.answer = found.crossed ? shown.name(found.of_a, found.neighbour) : asked.choices.back();
  text.caption =
      "Question: where does the walk go now? The first border in the list that is crossed counts.";
}

void values(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  if (!shown.walk.query) return;
  put("swaps", std::to_string(shown.state.swaps));
  put("feature of x", shown.name(true));
  put("feature of y", shown.name(false));
  if (shown.knows_pair()) put("distance of features", story.numbers(shown.closest().distance));
  if (shown.is_answer) put("distance", story.numbers(shown.walk.trace.result.answer.distance));
}

}  // namespace gjkscope::walks
