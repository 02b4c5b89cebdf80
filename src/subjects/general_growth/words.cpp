#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/decimal.hpp"
#include "subjects/general_growth/shown.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope::costs {
namespace {

using general_growth::Sample;

/// In Larsen's words, nearly.
std::string_view said(Claim claim) {
  switch (claim) {
    case Claim::brute_force:
      return "hierarchies find the least faster than all pairs";
    case Claim::wider_search:
      return "distance needs a wider search than collision";
    case Claim::coherence:
      return "coherence is not yet exploited";
  }
  return "";
}

std::string verdict(const Shown& shown) {
  return shown.trace.agrees(shown.claim()) ? "It agrees." : "It does not agree here.";
}

void claim(const Shown& shown, FrameText& text) {
  const Sample& last = shown.trace.samples.back();
  const std::optional<GrowthTimes>& times = shown.trace.times;
  const std::string n = grouped(last.segments);
  switch (shown.claim()) {
    case Claim::brute_force:
      text.caption = fmt::format("Larsen: {}. {}", said(shown.claim()), verdict(shown));
      text.detail =
          fmt::format("With n = {} there are {} pairs of segments. Trees of boxes visit {}{}.", n,
                      grouped(last.pairs()), grouped(last.boxes),
                      times ? fmt::format(", in {} in place of {}", time_text(times->boxes.back()),
                                          time_text(times->pairs.back()))
                            : "");
      break;
    case Claim::wider_search:
      text.caption = fmt::format("Larsen: {}. {}", said(shown.claim()), verdict(shown));
      text.detail = fmt::format(
          "With n = {} distance visits {} pairs of nodes, collision {}: it may stop at a gap, "
          "and distance must go on to leaves.",
          n, grouped(last.boxes), grouped(last.collide));
      if (times)
        text.detail += fmt::format(
            " A pair takes {} and {}: both searches here compute how far boxes are apart.",
            time_text(times->boxes.back() / last.boxes),
            time_text(times->collide.back() / last.collide));
      break;
    case Claim::coherence:
      text.caption = fmt::format("Larsen: {}. That was 1998; here it is.", said(shown.claim()));
      text.detail = fmt::format(
          "A start from the last position's closest pair costs {} % of the visits. Pairs almost as "
          "close must still be ruled out.",
          fixed(100.0 * last.remembered / last.boxes, 0));
      break;
  }
}

/// "30", the first number of segments from which on building two trees and asking them once is
/// faster than all pairs.
std::string repays_from(const Shown& shown) {
  const GrowthTimes& times = *shown.trace.times;
  std::size_t first = times.pairs.size();
  while (first > 0 && times.build[first - 1] + times.boxes[first - 1] < times.pairs[first - 1])
    --first;
  return first == times.pairs.size() ? "" : grouped(shown.trace.samples[first].segments);
}

void times(const Shown& shown, FrameText& text) {
  const GrowthTimes& times = *shown.trace.times;
  text.caption = fmt::format("n = {}: all pairs take {}, trees of boxes {}.",
                             grouped(shown.trace.samples.back().segments),
                             time_text(times.pairs.back()), time_text(times.boxes.back()));
  const std::string from = repays_from(shown);
  text.detail =
      fmt::format("Building both takes {}{}. Measured on {}.", time_text(times.build.back()),
                  from.empty() ? "" : fmt::format(": from n = {} on one distance repays it", from),
                  times.machine);
}

/// "3.3 times, as n"
std::string words_of(const GrowthChoice& choice) {
  if (choice.ratio == 1.0) return choice.name;
  return fmt::format("{} times, {}", fixed(choice.ratio, choice.ratio < 10.0 ? 1 : 0), choice.name);
}

}  // namespace

std::array<GrowthChoice, 3> growth_choices(const Sample& before, const Sample& sample) {
  const double segments = 1.0 * sample.segments / before.segments;
  return {{{"hardly", 1.0}, {"as n", segments}, {"as all pairs", segments * segments}}};
}

void words(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const Sample& sample = shown.sample();
  if (shown.over == 0) {
    text.caption = "What does the distance of two outlines cost, if they are not convex?";
    text.detail =
        "Each outline has n segments. Counted are pairs: of segments, of convex pieces, of nodes "
        "of two trees.";
  } else if (shown.is(GrowthPhase::size)) {
    text.caption =
        fmt::format("n = {}: {} pairs of segments. Trees of boxes visit {} pairs of boxes.",
                    grouped(sample.segments), grouped(sample.pairs()), grouped(sample.boxes));
    text.detail = fmt::format("Trees of circles visit {}. ", grouped(sample.circles));
    const Sample* last = shown.size() == 0 ? nullptr : &shown.trace.samples[shown.size() - 1];
    if (sample.pieces >= 0.0) {
      text.detail +=
          fmt::format("Convex pieces: pairs that need a run of GJK: {}.", grouped(sample.pieces));
    } else if (last == nullptr || last->pieces >= 0.0) {
      text.detail +=
          fmt::format("Cutting takes n · n steps, so it ends at n = {}.", general_growth::kMostCut);
    } else {
      text.detail += fmt::format(
          "Since n = {}, pairs of segments grew {} times, and visits of boxes {} times.",
          grouped(last->segments), grouped(sample.pairs() / last->pairs()),
          fixed(sample.boxes / last->boxes, 2));
    }
  } else if (shown.is(GrowthPhase::time)) {
    times(shown, text);
  } else if (shown.is(GrowthPhase::claim)) {
    claim(shown, text);
  } else {
    const Sample& first = shown.trace.samples.front();
    text.caption =
        fmt::format("From n = {} to {} pairs grow {}, visits {}.", grouped(first.segments),
                    grouped(sample.segments), grouped(sample.pairs() / first.pairs()) + " times",
                    grouped(sample.boxes / first.boxes) + " times");
    text.detail =
        "Both axes are logarithmic: a straight line is a power of n, and a flatter one a smaller "
        "power.";
  }
}

void question(const Story& story, FrameText& text) {
  const Shown before(story.run, story.frame);
  FrameQuestion& asked = text.question.emplace();
  asked.ask = story.run.asked(story.frame).ask;
  const auto answer = static_cast<std::size_t>(story.frame.answering_step);
  if (asked.ask == kAskVisits.name) {
    const Sample& sample = before.trace.samples[answer];
    const Sample& last = before.trace.samples[answer - 1];
    std::array<GrowthChoice, 3> choices = growth_choices(last, sample);
    for (GrowthChoice& choice : choices) choice.name = words_of(choice);
    ask_growth(kAskVisits.name, choices, sample.boxes / last.boxes, true, text);
    text.caption = fmt::format(
        "Question: from n = {} to {}, how do the visits of trees of boxes grow? Point at a place.",
        grouped(last.segments), grouped(sample.segments));
  } else if (asked.ask == kAskMethod.name) {
    const GrowthTimes& times = *before.trace.times;
    const std::array<std::pair<std::string_view, double>, 3> methods = {
        {{"all pairs of segments", times.pairs.back()},
         {"trees of boxes", times.boxes.back()},
         {"trees of circles", times.circles.back()}}};
    const auto fastest =
        std::min_element(methods.begin(), methods.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    for (const auto& method : methods) asked.choices.emplace_back(method.first);
    asked.choices.emplace_back("convex pieces");
    asked.answer = std::string(fastest->first);
    asked.refuted = fmt::format("Circles take {}, and convex pieces end at n = {}.",
                                time_text(times.circles.back()), general_growth::kMostCut);
    text.caption = fmt::format(
        "Question: n = {}, and the outlines are not convex. Which method is the fastest for one "
        "distance?",
        grouped(before.trace.samples.back().segments));
  } else {
    const auto claim =
        static_cast<Claim>(static_cast<int>(answer) - (before.trace.steps() - kClaims));
    asked.choices = {"yes", "no"};
    asked.answer = asked.choices[before.trace.agrees(claim) ? 0 : 1];
    text.caption =
        fmt::format("Question: Larsen says in 1998 that {}. Does it agree with what was measured?",
                    said(claim));
  }
}

void values(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  text.values.emplace_back("x", story.run.lesson.x().name);
  text.values.emplace_back("y", story.run.lesson.y().name);
  text.values.emplace_back("n", grouped(shown.sample().segments));
}

}  // namespace gjkscope::costs
