#include <fmt/format.h>

#include "subjects/hierarchy/shown.hpp"

namespace gjkscope::searches {
namespace {

using models::SearchPhase;
using models::SearchStop;

std::string counted(long count, std::string_view what) {
  return fmt::format("{} {}{}", count == 1 ? "one" : grouped(static_cast<double>(count)), what,
                     count == 1 ? "" : "s");
}

class Telling {
 public:
  Telling(const Story& story, FrameText& text)
      : story_(story), text_(text), shown_(shown_in<Shown>(story)) {}

  void tell() {
    if (shown_.is_refused()) return refused();
    if (shown_.is_answer) return answer();
    if (shown_.step == nullptr) return start();
    switch (shown_.step->phase) {
      case SearchPhase::visit:
        return visit();
      case SearchPhase::bound:
        cut();
        break;
      case SearchPhase::leaf:
        leaf();
        break;
      case SearchPhase::descend:
        descend();
        break;
      case SearchPhase::contain:
        return contain();
    }
    visits_before();
  }

 private:
  [[nodiscard]] const std::string& x() const { return shown_.name(true); }
  [[nodiscard]] const std::string& y() const { return shown_.name(false); }
  [[nodiscard]] std::string delta() const {
    return "δ = " + story_.numbers(shown_.state.candidate->high);
  }
  [[nodiscard]] std::string bound() const { return story_.numbers(shown_.state.pair.bound); }
  [[nodiscard]] long pairs_below() const {
    return static_cast<long>(shown_.node(true).count) * shown_.node(false).count;
  }

  /// Visits since the last frame that have none, because they ended as this one does.
  void visits_before() {
    if (shown_.search.trace.result.visits > kMostVisits) return;
    long trace = 0;
    for (const Frame& frame : story_.run.frames) {
      if (frame.run == story_.frame.run && frame.step < story_.frame.step)
        trace = Shown(story_.run, frame).state.visits;
    }
    const long along = shown_.state.visits - trace - 1;
    if (along == 1) text_.detail += " The visit before it ended the same way.";
    if (along > 1)
      text_.detail += fmt::format(" The {} visits before it ended the same way.", along);
  }

  void refused() {
    text_.caption = fmt::format("The search does not take {}.",
                                words_of(*shown_.search.refusal, shown_.lesson));
  }

  void start() {
    text_.caption = fmt::format(
        "Each shape has a tree of {}: the root holds all segments, a leaf one.", shown_.volumes());
    if (shown_.has_tiles())
      text_.caption =
          fmt::format("Small circles tile the segments. A tree bounds these {} and {} tiles.",
                      shown_.search.tree(true)[0].count, shown_.search.tree(false)[0].count);
    text_.detail = fmt::format("{} · {} = {} pairs of segments. The pair of the two roots waits. ",
                               shown_.search.x.segments.size(), shown_.search.y.segments.size(),
                               grouped(static_cast<double>(shown_.search.pairs())));
    if (shown_.search.options.remembered)
      text_.detail += fmt::format("The last pair gives a candidate at once: {}.", delta());
    else
      text_.detail += "Next: visit it.";
    const int most = most_in_heap(shown_);
    if (most > 0) text_.detail += fmt::format(" A triangle stands for up to {} segments.", most);
  }

  [[nodiscard]] std::string_view content() const { return shown_.has_tiles() ? "tile" : "segment"; }
  /// "a holds 6 segments of X, b one segment of Y."
  [[nodiscard]] std::string contents() const {
    return fmt::format("a holds {} of {}, b {} of {}. ",
                       counted(shown_.node(true).count, content()), x(),
                       counted(shown_.node(false).count, content()), y());
  }
  /// "Visit 3: boxes a and b"
  [[nodiscard]] std::string visited() const {
    return fmt::format("Visit {}: {} a and b", shown_.state.visits, shown_.volumes());
  }

  void visit() {
    text_.caption = fmt::format("Visit {}: the pair of {} a of {} and b of {}.",
                                shown_.state.visits, shown_.volumes(), x(), y());
    const std::optional<Halves> halves = shown_.halves();
    if (halves && asks_about_halves(shown_.lesson, shown_.state.visits))
      text_.caption = fmt::format("Visit {}: the {} half comes first. From here on it is {} {}.",
                                  shown_.state.visits, halves->is_left_first ? "left" : "right",
                                  shown_.volume(), halves->of_x ? "a" : "b");
    text_.detail = contents();
    if (!shown_.is_distance())
      text_.detail += fmt::format("Next: do the {} meet?", shown_.volumes());
    else if (!shown_.state.candidate)
      text_.detail += "No segments are measured yet, so nothing can be cut.";
    else
      text_.detail += fmt::format("The band around a is δ wide. Next: does b reach it?");
  }

  void cut() {
    const bool is_one = pairs_below() == 1;
    const std::string spared =
        is_one ? fmt::format("The pair of {}s is not tested.", content())
               : fmt::format("{} pairs of {}s are spared: {} in a times {} in b.",
                             grouped(static_cast<double>(pairs_below())), content(),
                             shown_.node(true).count, shown_.node(false).count);
    if (shown_.is_distance()) {
      text_.caption =
          fmt::format("{} are {} apart, farther than {}: cut.", visited(), bound(), delta());
      text_.detail = "No segment in a is closer to one in b than δ. " + spared;
    } else {
      text_.caption = fmt::format("{} are {} apart: cut.", visited(), bound());
      text_.detail = "No segment in a meets one in b. " + spared;
    }
  }

  void looked_up() {
    text_.caption =
        fmt::format("Visit {}: both are tiles. Their segments are in the table: look it up.",
                    shown_.state.visits);
    text_.detail = fmt::format("Other tiles of the same two segments came earlier. {} so far.",
                               capitalized(counted(shown_.state.hits, "hit")));
  }

  void leaf() {
    const models::SearchRecord& record = shown_.step->record;
    if (record.hit) return looked_up();
    const std::string length = story_.numbers(record.measured->high);
    if (record.measured->meet) {
      text_.caption = fmt::format("Visit {}: both are leaves, and their segments meet: stop.",
                                  shown_.state.visits);
      text_.detail = "The shapes overlap. What still waits does not matter.";
    } else if (!shown_.is_distance()) {
      text_.caption = fmt::format("Visit {}: both are leaves. Their segments do not meet.",
                                  shown_.state.visits);
      text_.detail =
          fmt::format("The {} meet, the segments do not: a {} is larger than its segment.",
                      shown_.volumes(), shown_.volume());
    } else if (record.better && shown_.is_tie()) {
      text_.caption = fmt::format("Visit {}: both are leaves. Their segments are {} apart, too.",
                                  shown_.state.visits, length);
      text_.detail =
          "They share the closest vertex. Among equally close pairs the first in the outlines is "
          "taken.";
    } else if (record.better) {
      text_.caption =
          fmt::format("Visit {}: both are leaves. Their segments are {} apart: that is δ now.",
                      shown_.state.visits, length);
      text_.detail = "They are the candidate. From now on pairs that are farther apart are cut.";
    } else {
      text_.caption =
          fmt::format("Visit {}: both are leaves. Their segments are {} apart, not less than {}.",
                      shown_.state.visits, length, delta());
      text_.detail = fmt::format(
          "The {} were near enough, the segments are not. The candidate stays.", shown_.volumes());
    }
  }

  void descend() {
    const bool takes_b = shown_.step->record.takes_b_apart;
    if (!shown_.is_distance()) {
      text_.caption = fmt::format("{} meet: descend.", visited());
    } else if (!shown_.state.candidate) {
      text_.caption =
          fmt::format("{} are {} apart, and δ is still ∞: descend.", visited(), bound());
    } else {
      text_.caption =
          fmt::format("{} are {} apart, not more than {}: descend.", visited(), bound(), delta());
    }
    text_.detail = contents() + fmt::format("Each half of {} waits with {}, the {} one first.",
                                            takes_b ? "b" : "a", takes_b ? "a" : "b",
                                            shown_.is_distance() ? "nearer" : "left");
  }

  void contain() {
    text_.caption = shown_.is_distance() ? "Nothing waits: no pair is nearer than the candidate."
                                         : "Nothing waits: no two segments meet.";
    text_.detail = shown_.state.inside ? "But one shape lies inside the other, so they overlap."
                                       : "One shape could still lie inside the other. A vertex of "
                                         "each is tested: neither does.";
  }

  void answer() {
    const models::SearchResult& result = shown_.search.trace.result;
    const std::string cost =
        fmt::format("{} and {} of {} pairs of segments", counted(result.visits, "visit"),
                    grouped(static_cast<double>(result.measured)),
                    grouped(static_cast<double>(shown_.search.pairs())));
    if (result.stop != SearchStop::apart) {
      text_.caption = fmt::format("{} and {} overlap: known after {}.", x(), y(), cost);
      if (result.stop == SearchStop::contained)
        text_.detail = "No segments meet: one shape lies inside the other.";
      return;
    }
    if (!shown_.is_distance()) {
      text_.caption = fmt::format("{} and {} do not meet: known after {}.", x(), y(), cost);
      text_.detail = "Each cut spared all pairs of segments below it.";
      return;
    }
    text_.caption =
        fmt::format("The distance is {}: {}.", story_.numbers(result.answer.distance), cost);
    if (shown_.has_tiles()) {
      text_.detail =
          fmt::format("{} {} looked up in place of being measured again.",
                      capitalized(counted(result.hits, "pair")), result.hits == 1 ? "was" : "were");
      return;
    }
    const models::SearchResult& other = shown_.search.left_first.result;
    text_.detail = fmt::format("With the left child always first: {} and {}.",
                               counted(other.visits, "visit"), counted(other.measured, "pair"));
  }

  const Story& story_;
  FrameText& text_;
  const Shown& shown_;
};

}  // namespace

void words(const Story& story, FrameText& text) { Telling(story, text).tell(); }

namespace {

void ask_about_halves(const Story& story, const Shown& shown, FrameText& text) {
  const Halves halves = *shown.halves();
  const std::string_view whole = halves.of_x ? "a" : "b";
  const std::string_view other = halves.of_x ? "b" : "a";
  FrameQuestion& asked = text.question.emplace();
  asked.ask = kAskHalf.name;
  for (const bool is_left : {true, false}) {
    asked.choices.push_back(fmt::format("{} half of {}", is_left ? "left" : "right", whole));
    const int node = halves.node(is_left);
    asked.subjects.push_back(
        {Subject::Kind::tree_node, halves.of_x ? node : -1, halves.of_x ? -1 : node});
  }
  const auto away = [&](double bound) {
    return bound > 0.0 ? fmt::format("is {} from {}", story.numbers(bound), other)
                       : fmt::format("meets {}", other);
  };
  asked.refuted = fmt::format("The left half {}, the right half {}.", away(halves.left.bound),
                              away(halves.right.bound));
  if (shown.is_distance()) {
    asked.answer = asked.choices[halves.is_left_first ? 0 : 1];
    text.caption = fmt::format(
        "Question: which half of {} is nearer to {}, so that it is visited first? Point at it.",
        whole, other);
    return;
  }
  asked.choices.insert(asked.choices.end(), {"both", "neither"});
  asked.subjects.resize(asked.choices.size());
  const bool cuts_left = halves.left.bound > 0.0;
  const bool cuts_right = halves.right.bound > 0.0;
  asked.answer = asked.choices[cuts_left ? (cuts_right ? 2 : 0) : cuts_right ? 1 : 3];
  text.caption = fmt::format(
      "Question: which half of {} does not meet {}, so that it is cut? Point at it.", whole, other);
}

}  // namespace

void question(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  if (story.run.asked(story.frame).ask == kAskHalf.name)
    return ask_about_halves(story, shown, text);
  const models::SearchRecord& record = shown.search.trace.steps[story.frame.answering_step].record;
  const bool is_distance = shown.is_distance();
  FrameQuestion& asked = text.question.emplace();
  if (story.run.asked(story.frame).ask == kAskTable.name) {
    asked.ask = kAskTable.name;
    asked.choices = {"measure their segments", "look it up in the table"};
    asked.answer = asked.choices[record.hit ? 1 : 0];
    text.caption = "Question: both are tiles. Measure their segments, or look it up?";
    return;
  }
  asked.ask = is_distance ? kAskWin.name : kAskDescend.name;
  asked.choices = is_distance ? std::vector<std::string>{"no", "yes: cut"}
                              : std::vector<std::string>{"descend", "cut"};
  asked.answer = asked.choices[record.cut ? 1 : 0];
  text.caption = is_distance
                     ? fmt::format("Question: are the {} a and b farther apart than δ = {}?",
                                   shown.volumes(), story.numbers(shown.state.candidate->high))
                     : fmt::format("Question: descend into the {}, or cut?", shown.volumes());
}

void values(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", shown.name(true));
  put("y", shown.name(false));
  if (shown.is_refused()) return;
  put("pairs", grouped(static_cast<double>(shown.search.pairs())));
  put("visits", grouped(static_cast<double>(shown.state.visits)));
  put("tests", grouped(static_cast<double>(shown.state.measured)));
  if (shown.has_tiles()) put("looked up", grouped(static_cast<double>(shown.state.hits)));
  if (shown.is_distance() && shown.state.candidate)
    put("candidate", story.numbers(shown.state.candidate->high));
  if (shown.is_answer && shown.is_distance())
    put("distance", story.numbers(shown.search.trace.result.answer.distance));
}

}  // namespace gjkscope::searches
