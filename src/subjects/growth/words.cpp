#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture/story.hpp"
#include "subjects/growth/growth.hpp"
#include "subjects/growth/plots.hpp"
#include "subjects/growth/subject.hpp"
#include "subjects/growth/table.hpp"

namespace gjkscope::captions {
namespace {

using Sample = Growth::Sample;

double all_differences(const Sample& sample) { return 1.0 * sample.vertices * sample.vertices; }

std::string larsen() { return fmt::format("{} to {}", Growth::kLarsenLeast, Growth::kLarsenMost); }

/// Iterations that ten times as many vertices add, from one size to another.
double each_tenfold(const Sample& from, const Sample& to) {
  return (to.iterations - from.iterations) /
         std::log10(static_cast<double>(to.vertices) / from.vertices);
}

void size(const Sample& sample, FrameText& text) {
  const std::string iterations = fixed(sample.iterations, 1);
  const std::string calls = fixed(sample.support_calls, 1);
  text.caption =
      fmt::format("n = {}: {} iterations on average, {} in the worst run; {} {} of Larsen.",
                  grouped(sample.vertices), iterations, sample.most_iterations,
                  sample.iterations > Growth::kLarsenMost    ? "more than the"
                  : sample.iterations < Growth::kLarsenLeast ? "fewer than the"
                                                             : "within the",
                  larsen());
  text.detail = fmt::format("GJK computes {} of the {} differences{}. ",
                            fixed(sample.touched_points, 1), grouped(all_differences(sample)),
                            calls == iterations ? "" : fmt::format(" in {} support calls", calls));
  text.detail += sample.is_climbed
                     ? fmt::format("Climbing looks at {} vertices, scanning at {}.",
                                   grouped(sample.seen_vertices), grouped(sample.scanned_vertices))
                     : fmt::format("Each support call scans every vertex: {} in all.",
                                   grouped(sample.seen_vertices));
}

/// The first size that takes more than Larsen's iterations; the end when there is none.
Growth::Value::const_iterator first_above(const Growth::Value& measured) {
  return std::find_if(measured.begin(), measured.end(),
                      [](const Sample& sample) { return sample.iterations > Growth::kLarsenMost; });
}

void outcome(const Growth::Value& measured, double tolerance, FrameText& text) {
  const Sample& first = measured.front();
  const Sample& last = measured.back();
  const auto above = first_above(measured);
  text.caption = fmt::format(
      "From {} iterations on average at n = {} to {} at n = {}: {}.", fixed(first.iterations, 1),
      grouped(first.vertices), fixed(last.iterations, 1), grouped(last.vertices),
      above == measured.begin()
          ? fmt::format("more than Larsen's {}", larsen())
          : fmt::format("no more than Larsen's {} {}", Growth::kLarsenMost,
                        above == measured.end()
                            ? "at any n"
                            : fmt::format("up to n = {}", grouped((above - 1)->vertices))));
  if (above != measured.end()) {
    const Sample& from = above == measured.begin() ? *above : *(above - 1);
    if (&from != &last) {
      text.detail = fmt::format("Beyond, ten times as many vertices add about {}. ",
                                fixed(each_tenfold(from, last), 1));
    }
  }
  const auto [least, most] = std::minmax_element(
      measured.begin(), measured.end(),
      [](const auto& a, const auto& b) { return a.within_tolerance < b.within_tolerance; });
  text.detail += fmt::format(
      "For {:g} %, {} to {} are enough at every n. Larsen's numbers are for polyhedra.",
      100.0 * tolerance, fixed(least->within_tolerance, 1), fixed(most->within_tolerance, 1));
}

/// Polygons that are built to be slow.
void slow(const Slowest& slowest, FrameText& text) {
  text.caption =
      fmt::format("A polygon can be built so that GJK needs n iterations: {} with {} vertices.",
                  slowest.built.iterations, slowest.built.vertices);
  text.detail = fmt::format(
      "X is a point. Each support point is only the next vertex, in turn on either side of P. "
      "Random runs take {} at most, of {}.",
      slowest.random.most_iterations, slowest.random.runs);
}

void slow_question(const Slowest& slowest, FrameText& text) {
  const std::array<GrowthChoice, 3> choices = slow_choices(slowest);
  const double least = slowest.random.most_iterations;
  ask_growth(kAskSlowest.name, choices, slowest.built.iterations / least, true, text);
  text.caption = fmt::format(
      "Question: the worst random run with n = {} needs {} iterations. A polygon is built to be "
      "slow: how many, then? Point at a place.",
      slowest.built.vertices, slowest.random.most_iterations);
}

/// One for each vertex, or one for each difference.
void dots_question(const Story& story, FrameText& text) {
  const PositionedRun& run = story.run.run(story.frame);
  const std::size_t x = run.x().world.size();
  const std::size_t y = run.y().world.size();
  text.question = FrameQuestion{std::string(kAskDots.name),
                                {fmt::format("{} + {}", y, x), fmt::format("{} · {}", y, x), "1"},
                                {}};
  text.question->answer = text.question->choices[0];
  text.question->refuted = fmt::format(
      "One for each vertex of both: O(n + n). {} · {} would be one for each difference.", y, x);
  text.caption = fmt::format(
      "Question: Z is the hull of {} differences. How many dot products find the one farthest "
      "along d?",
      y * x);
}

}  // namespace

void growth(const Story& story, FrameText& text) {
  const Growth::Value& measured = story.effects.get<Growth>(story.frame);
  const auto index = static_cast<std::size_t>(*shown_size(story.run, story.frame));
  if (index < measured.size()) return size(measured[index], text);
  if (is_slow(story.run, story.frame)) return slow(slowest(story.effects, story.frame), text);
  outcome(measured, story.run.lesson.settings.as<LessonGrowth>()->tolerance, text);
}

void growth_question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  if (ask == kAskDots.name) return dots_question(story, text);
  if (ask == kAskSlowest.name) return slow_question(slowest(story.effects, story.frame), text);
  const LessonGrowth& growth = *story.run.lesson.settings.as<LessonGrowth>();
  const Growth::Value& measured = story.effects.get<Growth>(story.frame);
  const int size = *shown_size(story.run, story.frame) + 1;
  const Sample& from = measured[size - 1];
  const Sample& to = measured[size];
  const std::array<GrowthChoice, 3> choices = growth_choices(growth, size, ask);
  const std::string sizes =
      fmt::format("from n = {} to {}", grouped(from.vertices), grouped(to.vertices));
  if (ask == kAskIterations.name) {
    ask_growth(ask, choices, to.iterations / from.iterations, true, text);
    text.question->refuted =
        fmt::format("Twice as many would be {}, like n {}.", fixed(from.iterations * 2.0, 1),
                    fixed(from.iterations * choices[2].ratio, 1));
    text.caption =
        fmt::format("Question: {}, how do the iterations grow? Point at a place.", sizes);
  } else if (ask == kAskScanned.name) {
    ask_growth(ask, choices, to.scanned_vertices / from.scanned_vertices, false, text);
    text.question->refuted =
        fmt::format("A call scans n + n vertices, and calls grow from {} to {} only.",
                    fixed(from.support_calls, 1), fixed(to.support_calls, 1));
    text.caption = fmt::format(
        "Question: each support call scans all vertices. {}, how do the scanned vertices of a run "
        "grow?",
        capitalized(sizes));
  } else {
    ask_growth(ask, choices, 1.0 * to.vertices / from.vertices, false, text);
    text.question->refuted = fmt::format(
        "Each edge of Z is one of X or of Y, {} at most: a scan of a known outline is O(n), too.",
        grouped(2.0 * to.vertices));
    text.caption = fmt::format(
        "Question: if the outline of Z is known, one scan of its edges finds P. {}, how does this "
        "scan grow?",
        capitalized(sizes));
  }
}

}  // namespace gjkscope::captions
