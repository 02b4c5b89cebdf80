#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "lesson/prose.hpp"
#include "subjects/feature_regions/shown.hpp"

namespace gjkscope::cells {
namespace {

using Phase = RegionsTrace::Phase;

constexpr std::string_view kNoNeighbour = "none: it is in the region";

/// Caption and detail, with placeholders.
using Words = std::pair<std::string_view, std::string_view>;

Words words_of_start(const Shown& shown) {
  if (shown.trace.pairs.empty())
    return {"A body is flat: its points lie in one plane.",
            "Regions are those of bodies that have a volume."};
  if (shown.is_query)
    return {"Which vertex, edge or face of {y} is closest to {q}?",
            "Each of these features owns the points of space that are closest to it: its Voronoi "
            "region."};
  if (shown.trace.steps() == 0)
    return {"{x} and {y} overlap: the distance is 0.",
            "Regions lie outside of the bodies, and tell nothing of points within."};
  return {"x is a point of {x}, y one of {y}. Is any other pair closer?",
          "There are too many to compare. Two tests tell: is x in the region of y's feature, and y "
          "in that of x's?"};
}

Words words_of_kind(Kind kind, bool is_one) {
  switch (kind) {
    case Kind::face:
      if (is_one)
        return {"The region of {f} is a prism that stands on the face.",
                "Each edge of the face has a plane, normal to the face. A point beyond it projects "
                "outside of the face."};
      return {"{count} faces have {count} prisms. Between two of them there is a gap.",
              "In the gap over an edge neither face is closest: the edge is."};
    case Kind::edge:
      if (is_one)
        return {"The region of {f} is a wedge between {n} planes.",
                "Two are sides of the prisms on its faces. Two stand at its ends, normal to it: a "
                "point beyond one projects outside of the edge."};
      return {"{count} edges have {count} wedges. They fill the gaps between prisms.",
              "There are still gaps at the vertices."};
    case Kind::vertex:
      if (is_one)
        return {"The region of {f} is a cone of {n} planes, one for each edge at the vertex.",
                "Each plane is normal to its edge. Beyond it the edge has a point that is closer "
                "than the vertex."};
      return {"{count} vertices have {count} cones. They fill what is left.",
              "A point in a cone is closer to the vertex than to any edge or face."};
  }
  return {};
}

Words words_of_region(const Shown& shown) {
  if (!shown.holds())
    return {
        "{p} is not in the region of {f}: it lies {depth} beyond the plane of {beyond}.",
        "Thus {beyond} has a point that is closer to {p} than {o} is. One plane refutes the pair."};
  if (shown.at().pair == 1 && shown.at().body == 1)
    return {
        "Another pair, that of a walk's end: x lies in the region of {f}, inside of all its "
        "planes.",
        "Thus y is the point of {b} that is closest to x. The neighbours of one feature were "
        "enough "
        "to tell."};
  return {"{p} lies in the region of {f}, inside of all its {n} planes.",
          "Thus {o} is the point of {b} that is closest to {p}. The neighbours of one feature were "
          "enough to tell."};
}

Words words_of(const Shown& shown) {
  if (shown.step < 0) return words_of_start(shown);
  switch (shown.at().phase) {
    case Phase::one:
    case Phase::kind:
      return words_of_kind(shown.at().kind, shown.is(Phase::one));
    case Phase::all:
      return {"{F} + {E} + {V} = {all} regions fill all space outside of {y}.",
              "F + E + V in general. Neighbours share a plane. All regions go on without end; they "
              "are drawn cut off."};
    case Phase::query:
      if (shown.feature_index() < 0)
        return {"{q} lies in {y}: no region outside holds it.", "The distance is 0."};
      return {
          "{q} lies in the region of {f}: it is inside of all {n} planes.",
          "Thus the closest point P lies on {f}, at distance {distance}. No other feature has to "
          "be asked."};
    case Phase::region:
      return words_of_region(shown);
    case Phase::plane:
      return {"Thus all of {b} lies beyond the plane through {o}, normal to the segment xy.",
              "If a point c of {b} lay before it, the segment from {o} to c would lie in {b}, too, "
              "and come closer to {p}."};
    case Phase::slab:
      if (shown.at().pair == 0)
        return {"The slab says the same: {inside} into it.",
                "It lies between the planes through x and y, normal to the segment between them. "
                "Were x and y closest, it would be empty."};
      return {"Both tests hold: the slab between the planes is empty, and {distance} wide.",
              "{x} lies behind one plane, {y} behind the other. Nothing of either lies between."};
    case Phase::pair:
      return {
          "Every other pair has to cross the slab, so it is at least {distance} apart. The first "
          "was {other} apart.",
          "Thus two local tests prove a global minimum, since both bodies are convex."};
  }
  return {};
}

}  // namespace

void words(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  const RegionsTrace& trace = shown.trace;
  std::map<std::string, std::string> values = {
      {"x", shown.lesson.x().name}, {"y", shown.lesson.y().name}, {"q", story.q}};
  if (!trace.pairs.empty()) {
    values["distance"] = story.numbers(shown.pair().distance());
    values["other"] = story.numbers(trace.pairs[0].distance());
  }
  for (int i = 0; i < kKinds; ++i)
    values[std::string(1, "FEV"[i])] = std::to_string(trace.count(static_cast<Kind>(i)));
  values["all"] = std::to_string(trace.features[1].size());
  if (shown.step >= 0) {
    const std::size_t body = shown.at().body;
    values["p"] = body == 1 ? "x" : "y";
    values["o"] = body == 1 ? "y" : "x";
    values["b"] = shown.lesson.bodies[body].name;
    values["count"] = std::to_string(trace.count(shown.at().kind));
    if (shown.feature_index() >= 0) {
      const Border& tightest = trace.border(shown.at());
      values["f"] = shown.name(shown.feature_index());
      values["n"] = std::to_string(trace.borders(shown.at()).size());
      values["beyond"] = shown.name(tightest.beyond);
      values["depth"] = story.numbers(-tightest.depth(trace.point(shown.at())));
    }
  }
  if (!trace.reaches.empty()) {
    std::vector<std::string> names;
    for (const auto& [body, vertex] : trace.reaches)
      names.push_back(shown.lesson.bodies[body].vertex_names[vertex]);
    values["inside"] = and_list(names) + (names.size() == 1 ? " reaches" : " reach");
  }
  const auto& [caption, detail] = words_of(shown);
  text.caption = expand(caption, values);
  text.detail = expand(detail, values);
}

namespace {

/// Vertices of a body, to be pointed at, and none of them.
void vertex_question(const Shown& shown, std::size_t body, std::optional<int> answer,
                     FrameQuestion& asked) {
  const LessonShape& shape = shown.lesson.bodies[body];
  for (std::size_t i = 0; i < shape.vertex_names.size(); ++i) {
    const Eigen::Vector3d& at = shown.vertex(body, static_cast<int>(i));
    asked.choices.push_back(shape.vertex_names[i]);
    asked.spots.emplace_back().emplace(ViewKind::world, at, at);
  }
  asked.choices.emplace_back("none");
  asked.spots.emplace_back();
  asked.answer = answer ? shape.vertex_names[*answer] : asked.choices.back();
}

void reach_question(const Shown& shown, FrameText& text) {
  const auto [body, vertex] = *shown.reaching_vertex();
  const RegionsTrace::Step& test = shown.trace.all[shown.step - 1];
  const std::string beyond = shown.trace.name(shown.lesson, body, shown.trace.border(test).beyond);
  const std::string_view own = body == 1 ? "y" : "x";
  const std::string_view other = body == 1 ? "x" : "y";
  vertex_question(shown, body, vertex, *text.question);
  text.question->refuted = fmt::format(
      "From {} towards {} in the slab the distance falls: so {} has to lie in another region.", own,
      text.question->answer, other);
  text.caption = fmt::format(
      "Question: {} lies beyond the plane of {}. Which vertex of {} lies between the planes, then?",
      other, beyond, shown.lesson.bodies[body].name);
}

void before_question(const Shown& shown, FrameText& text) {
  const std::size_t body = shown.at().body;
  const std::string_view own = body == 1 ? "y" : "x";
  vertex_question(shown, body, std::nullopt, *text.question);
  text.question->refuted =
      fmt::format("The feature of {} is convex, too, so all of it lies beyond.", own);
  text.caption = fmt::format(
      "Question: {} is the closest point of its feature. Which vertex of {} lies before the plane "
      "through {}? Point at it.",
      own, shown.lesson.bodies[body].name, own);
}

/// Counts of planes that might have to be tested.
void planes_question(const Shown& shown, const std::string& q, FrameText& text) {
  const std::vector<Feature>& features = shown.trace.features[1];
  std::size_t all = 0;
  for (const Feature& feature : features) all += feature.borders.size();
  FrameQuestion& asked = *text.question;
  const std::size_t own = shown.trace.borders(shown.at()).size();
  asked.choices = {std::to_string(own), std::to_string(features.size()), std::to_string(all)};
  asked.answer = asked.choices[0];
  asked.refuted = fmt::format(
      "{} are the planes of all regions, and {} the regions. Those of one feature depend on its "
      "neighbours alone: as many in a body of any size.",
      all, features.size());
  text.caption = fmt::format(
      "Question: {} is said to lie in the region of {}. How many planes have to be tested to "
      "confirm it?",
      q, shown.name(shown.feature_index()));
}

void again_question(const Shown& shown, const std::string& q, FrameText& text) {
  FrameQuestion& asked = *text.question;
  asked.choices = {"none", "those near " + q, "all"};
  asked.answer = asked.choices[0];
  asked.refuted = fmt::format(
      "Regions depend on {} alone: they are computed once, beforehand, and move with it.",
      shown.lesson.y().name);
  text.caption =
      fmt::format("Question: {} has moved. Which of the {} regions have to be computed again?", q,
                  shown.trace.features[1].size());
}

}  // namespace

void question(const Story& story, FrameText& text) {
  // In a point query the frame shows nothing of the step that answers.
  const Shown shown(story.run, {.run = story.frame.run, .step = story.frame.answering_step});
  const RegionsTrace::Step& at = shown.at();
  FrameQuestion& asked = text.question.emplace();
  asked.ask = story.run.asked(story.frame).ask;
  if (asked.ask == kAskReach.name) return reach_question(shown, text);
  if (asked.ask == kAskBefore.name) return before_question(shown, text);
  if (asked.ask == kAskPlanes.name) return planes_question(shown, story.q, text);
  if (asked.ask == kAskAgain.name) return again_question(shown, story.q, text);
  std::vector<int> choices;
  for (const Border& border : shown.trace.borders(at)) {
    if (border.beyond >= 0) choices.push_back(border.beyond);
  }
  if (shown.is_query) {
    asked.answer = shown.name(shown.feature_index());
    choices.push_back(shown.feature_index());
    text.caption = fmt::format("Question: in the region of which feature does {} lie?", story.q);
  } else {
    asked.answer = shown.holds() ? kNoNeighbour : shown.name(shown.trace.border(at).beyond);
    text.caption = fmt::format(
        "Question: is {} in the region of {}? If not, which neighbour's plane is it beyond?",
        at.body == 1 ? "x" : "y", shown.name(shown.feature_index()));
  }
  std::sort(choices.begin(), choices.end());
  for (const int choice : choices) asked.choices.push_back(shown.name(choice));
  if (!shown.is_query) asked.choices.emplace_back(kNoNeighbour);
}

void values(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  text.values = {{"x", shown.lesson.x().name},
                 {"y", shown.lesson.y().name},
                 {"regions", std::to_string(shown.trace.features[1].size())},
                 {"in slab", std::to_string(shown.trace.reaches.size())}};
}

}  // namespace gjkscope::cells
