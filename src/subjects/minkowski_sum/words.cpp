#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "subjects/minkowski_sum/shown.hpp"

namespace gjkscope::sums {
namespace {

using minkowski_sum::OriginSide;
using minkowski_sum::Phase;
using minkowski_sum::Source;

void refused(const Shown& shown, FrameText& text) {
  text.caption =
      fmt::format("The merge does not take {}.", words_of(*shown.trace.refusal, shown.lesson));
  text.detail = "It needs two convex polygons.";
}

void edge(const Shown& shown, FrameText& text) {
  const minkowski_sum::Corner& from = shown.step->before.at;
  const Source source = shown.step->source;
  if (source == Source::both) {
    text.caption = fmt::format("Parallel {} make one edge, to {}.", shown.edge(from, source),
                               shown.corner(shown.step->after.at));
    text.detail = "Both turn by the same angle, so both walks go on.";
    return;
  }
  const Source other = source == Source::y ? Source::x : Source::y;
  text.caption =
      fmt::format("{} comes next: it leads to {}.", capitalized(shown.edge(from, source)),
                  shown.corner(shown.step->after.at));
  const bool other_is_left = other == Source::y
                                 ? shown.step->before.edges_of_y < shown.merge.y.size()
                                 : shown.step->before.edges_of_x < shown.merge.x.size();
  text.detail =
      other_is_left
          ? fmt::format("It turns less to the left than {}, which waits.", shown.edge(from, other))
          : fmt::format("All edges of {} are taken.",
                        other == Source::y ? shown.lesson.y().name : "−" + shown.lesson.x().name);
}

void inside(const Shown& shown, FrameText& text) {
  const std::string& x = shown.lesson.x().name;
  const std::string& y = shown.lesson.y().name;
  switch (shown.merge.origin) {
    case OriginSide::inside:
      text.caption = fmt::format("O lies on the inner side of each edge: {} and {} overlap.", x, y);
      text.detail = fmt::format(
          "A point of {} and a point of {} have the difference O: they are one point.", x, y);
      break;
    case OriginSide::on_edge:
      text.caption = fmt::format("O lies on an edge: {} and {} touch.", x, y);
      text.detail = "Their distance is 0, and no point lies inside of both.";
      break;
    case OriginSide::outside:
      text.caption = fmt::format("O lies outside: {} and {} are apart.", x, y);
      text.detail = fmt::format("It lies beyond the {}, so {} and {} have no point in common.",
                                shown.edge(shown.merge.corners[shown.merge.separating],
                                           shown.merge.edges[shown.merge.separating]),
                                x, y);
      break;
  }
}

}  // namespace

void words(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const int sums = static_cast<int>(shown.merge.corners.size());
  if (shown.trace.refusal) return refused(shown, text);
  if (shown.step == nullptr) {
    text.caption = fmt::format("{1} − {0} is the sum of {1} and −{0}.", shown.lesson.x().name,
                               shown.lesson.y().name);
    text.detail =
        "−X is X turned by half a circle about O. A sum of two convex polygons has the edges of "
        "both.";
  } else if (shown.is_answer) {
    text.caption = fmt::format("{} differences make the outline. There are {}.", sums,
                               shown.merge.x.size() * shown.merge.y.size());
    text.detail =
        "In the plane each edge is taken once: the work grows like m + n. For polyhedra it may "
        "grow like n², or like n⁶ where they are not convex.";
  } else if (shown.step->phase == Phase::lowest) {
    text.caption = fmt::format("{} is the lowest corner.", shown.corner(shown.step->after.at));
    text.detail =
        "It is the lowest vertex of Y plus the lowest vertex of −X: one arrow after the other. "
        "Both "
        "walks go counter-clockwise from here.";
  } else if (shown.step->phase == Phase::edge) {
    edge(shown, text);
  } else {
    inside(shown, text);
  }
}

namespace {

void lowest_question(const Shown& shown, FrameText& text) {
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskLowest.name), {}, {}});
  for (const Eigen::Vector2d& place : lowest_places(shown)) {
    asked.choices.push_back(fmt::format("place {}", asked.choices.size() + 1));
    asked.spots.emplace_back(Spot(ViewKind::difference, place, place));
  }
  asked.answer = asked.choices[kRightPlace];
  text.caption = fmt::format(
      "Question: the sum of {} and −{} holds each point of one plus each of the other. Where is "
      "its lowest corner? Point at it.",
      shown.lesson.y().name, shown.lesson.x().name);
  asked.refuted = fmt::format(
      "Places 1 and 4 are the lowest vertices of {0} and −{1} alone; place 3 is their difference.",
      shown.lesson.y().name, shown.lesson.x().name);
}

}  // namespace

void question(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  if (story.run.asked(story.frame).ask == kAskLowest.name) return lowest_question(shown, text);
  const minkowski_sum::Step& step = shown.merge.steps[story.frame.answering_step];
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskEdge.name), {}, {}});
  const minkowski_sum::Corner& at = step.before.at;
  const Eigen::Vector2d from = shown.merge.at(at);
  const std::vector<LessonView>& views = shown.lesson.views;
  const bool shows_difference = std::any_of(views.begin(), views.end(), [](const LessonView& view) {
    return view.kind == ViewKind::difference;
  });
  for (const Source source : {Source::y, Source::x}) {
    asked.choices.push_back(shown.edge(at, source));
    if (shows_difference) {
      asked.spots.emplace_back(
          Spot(ViewKind::difference, from, Eigen::Vector2d(from + edge_of(shown, at, source))));
      continue;
    }
    const models::Ring& ring = source == Source::y ? shown.merge.y : shown.merge.x;
    const int begin = source == Source::y ? at.y : at.x;
    asked.spots.emplace_back(Spot(ViewKind::world, ring.points[static_cast<std::size_t>(begin)],
                                  ring.points[static_cast<std::size_t>(ring.next(begin))]));
  }
  asked.choices.emplace_back("both: they are parallel");
  asked.spots.emplace_back();
  asked.answer = asked.choices[static_cast<std::size_t>(step.source)];
  text.caption = "Question: two edges can follow. Which comes next? Point at it.";
}

void values(const Story& story, FrameText& text) {
  const Shown& shown = shown_in<Shown>(story);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  if (shown.step == nullptr) return;
  put("corner", shown.corner(shown.step->after.at));
  put("edges of y", std::to_string(shown.step->after.edges_of_y));
  put("edges of x", std::to_string(shown.step->after.edges_of_x));
}

}  // namespace gjkscope::sums
