#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lesson/prose.hpp"
#include "subjects/walk_in_space/growth.hpp"
#include "subjects/walk_in_space/shown.hpp"

namespace gjkscope::space_walks {
namespace {

using v_clip::Reason;

constexpr std::string_view kStay = "none: it is in the region";

/// Caption and detail, with placeholders.
using Words = std::pair<std::string_view, std::string_view>;

std::string_view why_next(Reason reason) {
  switch (reason) {
    case Reason::vertex_border:
      return "Beyond that plane the edge has points that are closer than its vertex, so the "
             "distance falls.";
    case Reason::edge_border:
      return "Beyond that plane the face has points that are closer than its edge, so the distance "
             "falls.";
    case Reason::clip_side:
      return "The edge comes nearer to the face, until it leaves it over this side.";
    case Reason::clip_end:
      return "The edge comes nearer to the face, until it ends.";
    default:
      return "The closest point lies there already: only the feature gets smaller.";
  }
}

Words words_of_step(const Shown& shown) {
  const SpaceWalk::Step& step = shown.step();
  if (step.reason == Reason::behind_face)
    return {"Point {p} lies behind {f}, but not behind all faces: {next} is next.",
            "The bodies may be apart. The segment from {p} towards the first face leaves through "
            "the next one."};
  if (step.reason == Reason::inside)
    return {"{g} lies behind all faces of {b}: the bodies overlap.", "The walk stops here."};
  if (step.reason >= Reason::meet)
    return {"{fx} and {fy} meet: the bodies overlap.", "The walk stops here."};
  if (!step.moves() && step.body == 0)
    return {
        "Point {p} lies in the region of {f}, inside of all its {n} planes.",
        "Thus no point of {b} is closer to {p} than {o} is. Next: is {o} in the region of {g}?"};
  if (!step.moves())
    return {"Point {p} lies in the region of {f}, too: no plane refutes the pair.",
            "Both tests hold, so the slab between x and y is empty: local verification."};
  constexpr double kSeen = 1e-9;
  if (shown.trace.beyond(step) > kSeen)
    return {
        "Point {p} lies {beyond} beyond the plane of {over}, outside of the region of {f}: {next} "
        "is "
        "next.",
        why_next(step.reason)};
  return {"Point {o} lies on the boundary of {f}, where it ends: {next} is next.",
          why_next(step.reason)};
}

Words words_of_path(const Story& story, const Shown& shown) {
  if (story.frame.run == 0)
    return {"The first walk starts at any pair: {pairs} to {fx} and {fy}, at distance {distance}.",
            "Nothing is remembered yet. GJK needs {warm}."};
  if (shown.trace.overlaps())
    return {"The bodies overlap: the walk ends at {fx} and {fy}.",
            "The walk looks at {pairs}, GJK needs {warm} from its last simplex, {cold} from one "
            "vertex of each."};
  return {shown.trace.pairs() == 1
              ? "{fx} and {fy} are still closest: one pair is enough. The distance is {distance}."
              : "The walk looks at {pairs}, from the last one to {fx} and {fy}, at distance "
                "{distance}.",
          "GJK needs {warm} from its last simplex, {cold} from one vertex of each."};
}

Words words_of(WalkGrowing growing) {
  switch (growing) {
    case WalkGrowing::beside_gjk:
      return {
          "With {few} vertices the walk looks at {few pairs} pairs a position, with {many} at "
          "{many pairs}. GJK needs {many warm} iterations warm, {many cold} cold.",
          "Averages over {positions} positions of two balls that pass each other: a move crosses "
          "more features where they are smaller. A pair costs a few tests, an iteration a scan of "
          "all vertices."};
    case WalkGrowing::coherent:
      return {
          "Where moves shrink as features do, {many small} pairs are enough at n = {many}: "
          "Larsen's "
          "O(1).",
          "The closest features stay, or their neighbours come next, for any n. The same move at "
          "each n crosses more and more features: {many pairs} pairs."};
    case WalkGrowing::cold:
      break;
  }
  return {
      "From the first vertices a walk looks at {many first} pairs at n = {many}: about as √n, less "
      "than Larsen's n.",
      "It crosses a surface of n features, about √n of them in a row. No pair comes twice, so n² "
      "is "
      "the most; a start from the last pair needs {many pairs}."};
}

Words words_of(const Story& story, const Shown& shown) {
  if (shown.trace.all.empty())
    return {"A body is flat: its points lie in one plane.",
            "This walk is shown on bodies that have a volume."};
  if (const auto growing = growth_of(story.run, story.frame)) return words_of(*growing);
  if (shown.is_path) return words_of_path(story, shown);
  if (shown.index < 0)
    return {"The walk starts at {fx} and {fy}.",
            "Any pair of features will do: a vertex, an edge or a face of each body. Next: the "
            "closest points x and y of the pair."};
  if (!shown.is_answer) return words_of_step(shown);
  return {shown.trace.overlaps() ? "{x} and {y} overlap: the distance is 0."
                                 : "The distance is {distance}, between {fx} and {fy}.",
          "The walk looked at {pairs} of features, and there are {all}."};
}

std::string counted(int count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

void words(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  std::map<std::string, std::string> values = {{"x", shown.lesson.x().name},
                                               {"y", shown.lesson.y().name}};
  if (!shown.trace.all.empty()) {
    const SpaceWalk::Step& step = shown.step();
    const std::array<std::string, 2> names = {shown.name(0, step.at[0]), shown.name(1, step.at[1])};
    std::vector<std::string> next;
    for (const std::size_t body : {0, 1})
      if (step.next[body] != step.at[body]) next.push_back(shown.short_name(body, step.next[body]));
    values["fx"] = names[0];
    values["fy"] = names[1];
    values["f"] = names[step.body];
    values["g"] = names[1 - step.body];
    values["b"] = shown.lesson.bodies[step.body].name;
    values["p"] = step.body == 0 ? "y" : "x";
    values["o"] = step.body == 0 ? "x" : "y";
    values["n"] = std::to_string(shown.trace.feature(step).borders.size());
    if (!next.empty()) values["next"] = and_list(next);
    if (step.border >= 0) {
      values["over"] = shown.short_name(step.body, shown.trace.border(step).beyond);
      values["beyond"] = story.numbers(shown.trace.beyond(step));
    }
    values["distance"] = story.numbers(shown.trace.answer("distance"));
    values["pairs"] = counted(shown.trace.pairs(), "pair");
    values["all"] =
        grouped(static_cast<long>(shown.trace.features[0].size() * shown.trace.features[1].size()));
    values["warm"] = counted(story.trace.result.iterations, "iteration");
    values["cold"] = std::to_string(shown.trace.cold);
  }
  if (growth_of(story.run, story.frame)) {
    const SpaceWalkGrowth::Value& samples = story.effects.get<SpaceWalkGrowth>(story.frame);
    values["few"] = std::to_string(samples.front().vertices);
    values["few pairs"] = fixed(samples.front().pairs, 1);
    values["many"] = grouped(samples.back().vertices);
    values["many pairs"] = fixed(samples.back().pairs, 1);
    values["many warm"] = fixed(samples.back().warm, 1);
    values["many cold"] = fixed(samples.back().cold, 1);
    values["many small"] = fixed(samples.back().small_moves, 1);
    values["many first"] = fixed(samples.back().first_pair, 1);
    values["positions"] = std::to_string(SpaceWalkGrowth::kPositions);
  }
  const auto& [caption, detail] = words_of(story, shown);
  text.caption = capitalized(expand(caption, values));
  text.detail = expand(detail, values);
}

namespace {

/// Offers a feature as a choice, to be pointed at; faces have their names (session/pointing.hpp).
void offer(const Story& story, const Shown& shown, std::size_t body, int feature,
           FrameQuestion& asked) {
  const std::string name = shown.name(body, feature);
  if (std::find(asked.choices.begin(), asked.choices.end(), name) != asked.choices.end()) return;
  asked.choices.push_back(name);
  const std::vector<int>& vertices = shown.trace.features[body][feature].vertices;
  const auto at = [&](int vertex) { return story.positioned.bodies[body].world[vertex]; };
  asked.spots.emplace_back();
  if (vertices.size() < 3)
    asked.spots.back().emplace(ViewKind::world, at(vertices.front()), at(vertices.back()));
}

}  // namespace

namespace {

void growth_question(const Story& story, WalkGrowing growing, FrameText& text) {
  const SpaceWalkGrowth::Value& samples = story.effects.get<SpaceWalkGrowth>(story.frame);
  const SpaceWalkGrowth::Sample& from = asked_from(samples);
  const double before = from.*counted_for(growing);
  const std::array<GrowthChoice, 3> choices = growth_choices_of(samples);
  ask_growth(story.run.asked(story.frame).ask, choices,
             samples.back().*counted_for(growing) / before, true, text);
  text.question->refuted =
      fmt::format("As √n would be {}, as n {}.", fixed(before * choices[1].ratio, 1),
                  grouped(std::round(before * choices[2].ratio)));
  text.caption =
      fmt::format("Question: {}. From n = {} to {}, how do the pairs grow? Point at a place.",
                  growing == WalkGrowing::cold ? "now each walk starts at the first vertices"
                                               : "now the moves are as small as the features",
                  grouped(from.vertices), grouped(samples.back().vertices));
}

}  // namespace

void question(const Story& story, FrameText& text) {
  if (const auto growing = growth_of(story.run, story.frame))
    return growth_question(story, *growing, text);
  const Shown shown(story.run, story.frame);
  const SpaceWalk& trace = shown.trace;
  FrameQuestion& asked = text.question.emplace();
  asked.ask = story.run.asked(story.frame).ask;
  if (asked.ask == kAskPairs.name) {
    asked.choices = {"one", "two", "three or more"};
    asked.answer = asked.choices[std::min(trace.pairs(), 3) - 1];
    text.caption = "Question: the bodies moved a little. How many pairs does the walk look at now?";
    return;
  }
  const SpaceWalk::Step& step = shown.step();
  const std::size_t body = shown.is_path ? 0 : step.body;
  const int from = step.at[body];
  const int to = shown.is_path ? trace.all.back().at[body] : step.next[body];
  if (shown.is_path) offer(story, shown, body, from, asked);
  for (const cells::Border& border : trace.features[body][from].borders)
    if (border.beyond >= 0) offer(story, shown, body, border.beyond, asked);
  if (shown.is_path || to != from) offer(story, shown, body, to, asked);
  if (!shown.is_path) {
    asked.choices.emplace_back(kStay);
    asked.spots.emplace_back();
  }
  asked.answer = to == from && !shown.is_path ? std::string(kStay) : shown.name(body, to);
  text.caption =
      shown.is_path
          ? fmt::format("Question: which feature of {} is closest to {} now? Point at it.",
                        shown.lesson.x().name, shown.lesson.y().name)
          : fmt::format(
                "Question: is {} in the region of {}? If not, which feature is next? Point "
                "at it.",
                body == 0 ? "y" : "x", shown.name(body, from));
}

void values(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  text.values = {{"x", shown.lesson.x().name}, {"y", shown.lesson.y().name}};
  if (shown.trace.all.empty()) return;
  const int pairs = shown.is_path ? shown.trace.pairs() : shown.index < 0 ? 0 : shown.step().number;
  text.values.emplace_back("pairs", std::to_string(pairs));
}

}  // namespace gjkscope::space_walks
