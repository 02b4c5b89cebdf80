#include <fmt/format.h>

#include "algorithms/general_growth/pictures/shown.hpp"

namespace gjkscope::costs {
namespace {

using fmt::format;
using general_growth::Sample;

void claim(const Shown& shown, FrameText& text) {
  const Sample& last = shown.told.samples.back();
  const std::string n = grouped(last.segments);
  switch (shown.claim()) {
    case Claim::brute_force:
      text.caption =
          "Larsen: looking at all pairs is expensive, hierarchies find the least faster. True.";
      text.detail = format(
          "With n = {} there are {} pairs of segments. Trees of boxes visit {} pairs of nodes.", n,
          grouped(last.pairs()), grouped(last.boxes));
      break;
    case Claim::wider_search:
      text.caption = "Larsen: distance needs a wider search than collision. True.";
      text.detail = format(
          "With n = {} distance visits {} pairs of nodes, collision {}: it may stop at a gap, "
          "and distance must go on to leaves.",
          n, grouped(last.boxes), grouped(last.collide));
      break;
    case Claim::coherence:
      text.caption = "Larsen: coherence is not yet exploited. Here it is.";
      text.detail = format(
          "A start from the last position's closest pair costs {} % of the visits. Pairs almost as "
          "close must still be ruled out.",
          fixed(100.0 * last.remembered / last.boxes, 0));
      break;
    case Claim::spheres:
      text.caption = "Larsen: Quinlan's trees of spheres are the fastest. That was 1998.";
      text.detail = format(
          "Here circles visit {} pairs, boxes {}. Larsen's own swept spheres (PQP, 2000) bound "
          "flat "
          "parts more closely still.",
          grouped(last.circles), grouped(last.boxes));
      break;
  }
}

}  // namespace

void words(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  const Sample& sample = shown.sample();
  if (shown.over == 0) {
    text.caption = "What does the distance of two outlines cost, if they are not convex?";
    text.detail =
        "Each outline has n segments. Counted are pairs: of segments, of convex pieces, of nodes "
        "of two trees.";
  } else if (shown.is_size()) {
    text.caption = format("n = {}: of {} pairs, trees of boxes visit {}.", grouped(sample.segments),
                          grouped(sample.pairs()), grouped(sample.boxes));
    text.detail =
        sample.pieces >= 0.0
            ? format(
                  "Trees of circles visit {}. Cut into convex pieces, {} pairs need a run of GJK.",
                  grouped(sample.circles), grouped(sample.pieces))
            : format("Trees of circles visit {}. Cutting takes n · n steps, so it ends at n = {}.",
                     grouped(sample.circles), general_growth::kMostCut);
  } else if (shown.is_claim()) {
    claim(shown, text);
  } else {
    const Sample& first = shown.told.samples.front();
    text.caption =
        format("From n = {} to {} pairs grow {}, visits {}.", grouped(first.segments),
               grouped(sample.segments), grouped(sample.pairs() / first.pairs()) + " times",
               grouped(sample.boxes / first.boxes) + " times");
    text.detail =
        "Both axes are logarithmic: a straight line is a power of n, and a flatter one a smaller "
        "power.";
  }
}

void values(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  text.values.emplace_back("x", story.run.lesson.x().name);
  text.values.emplace_back("y", story.run.lesson.y().name);
  text.values.emplace_back("n", grouped(shown.sample().segments));
}

}  // namespace gjkscope::costs
