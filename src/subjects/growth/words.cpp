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

}  // namespace

void growth(const Story& story, FrameText& text) {
  const Growth::Value& measured = story.effects.get<Growth>(story.frame);
  const auto index = static_cast<std::size_t>(*shown_size(story.run, story.frame));
  if (index < measured.size()) return size(measured[index], text);
  outcome(measured, story.run.lesson.table.as<LessonGrowth>()->tolerance, text);
}

void growth_question(const Story& story, FrameText& text) {
  const LessonGrowth& growth = *story.run.lesson.table.as<LessonGrowth>();
  const Growth::Value& measured = story.effects.get<Growth>(story.frame);
  const int size = *shown_size(story.run, story.frame) + 1;
  const double before = measured[size - 1].iterations;
  const std::array<WayToGrow, 3> ways = ways_to_grow(growth, size);
  const auto off = [&](const WayToGrow& way) {
    return std::abs(std::log(measured[size].iterations / before / way.ratio));
  };
  FrameQuestion& asked = text.question.emplace();
  asked.ask = kAskIterations.name;
  for (const WayToGrow& way : ways) {
    asked.subjects.push_back({Subject::Kind::study_dot, static_cast<int>(asked.choices.size())});
    asked.choices.push_back(way.name);
  }
  asked.answer = std::min_element(ways.begin(), ways.end(), [&](const auto& a, const auto& b) {
                   return off(a) < off(b);
                 })->name;
  asked.refuted = fmt::format("Twice as many would be {}, as n {}.",
                              fixed(before * ways[1].ratio, 1), fixed(before * ways[2].ratio, 1));
  text.caption =
      fmt::format("Question: from n = {} to {}, how do the iterations grow? Point at a place.",
                  grouped(measured[size - 1].vertices), grouped(measured[size].vertices));
}

}  // namespace gjkscope::captions
