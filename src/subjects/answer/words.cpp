#include <fmt/format.h>

#include <algorithm>

#include "outlines/polygon.hpp"
#include "picture/story.hpp"
#include "run/questions.hpp"
#include "subjects/answer/cold_start.hpp"
#include "subjects/answer/subject.hpp"
#include "subjects/answer/tour.hpp"
#include "subjects/motion/motion.hpp"
#include "subjects/round_shapes/round_shapes.hpp"
#include "subjects/run/subject.hpp"

namespace gjkscope::captions {

using Eigen::Vector2d;

namespace {

/// Tells where P lies on Z.
std::string place_of_p(const Story& story) {
  const WideSimplex& simplex = story.trace.result.simplex;
  const SimplexWords words(story.run, simplex);
  return simplex.count == 1 ? fmt::format("is {}", words.vertex(0))
                            : "lies on the " + words.kind_and_face(simplex.all());
}

void overlap(const Story& story, FrameText& text) {
  const Lesson& lesson = story.run.lesson;
  text.caption = fmt::format("{} and {} overlap: they share a point x = y, so y − x = O lies in Z.",
                             lesson.x().name, lesson.y().name);
  const WideSimplex& simplex = story.trace.result.simplex;
  const SimplexWords words(story.run, simplex);
  text.detail = fmt::format("O lies {} the {}: the distance is 0 in both views.",
                            simplex.count == 1   ? "at"
                            : simplex.count == 2 ? "on"
                                                 : "in",
                            words.kind_and_face(simplex.all()));
}

void warm_start(const Story& story, FrameText& text) {
  const WideResult& result = story.trace.result;
  const std::string starts =
      SimplexWords(story.run, story.trace.initial.simplex).face(story.trace.initial.simplex.all());
  const std::string count =
      fmt::format("{} iteration{}", result.iterations, result.iterations == 1 ? "" : "s");
  const WideSimplex& start = story.trace.initial.simplex;
  const auto in_start = [&](const WideVertex& vertex) {
    return std::any_of(start.vertices.begin(), start.vertices.begin() + start.count,
                       [&](const auto& other) { return other.pair == vertex.pair; });
  };
  const bool is_same =
      start.count == result.simplex.count &&
      std::all_of(result.simplex.vertices.begin(),
                  result.simplex.vertices.begin() + result.simplex.count, in_start);
  if (story.frame.run == 0) {
    text.caption = fmt::format("No run came before this one: it starts cold from {} and takes {}.",
                               starts, count);
  } else if (is_same) {
    text.caption = fmt::format(
        "Start from {}, where the last run ended. P is still on that simplex: {} confirms it.",
        starts, count);
  } else if (result.iterations == 1) {
    text.caption = fmt::format(
        "Start from {}, where the last run ended. The new P lies in that simplex: {} finds "
        "it.",
        starts, count);
  } else {
    text.caption = fmt::format(
        "Start from {}, where the last run ended. P is no longer on that simplex; finding it takes "
        "{}.",
        starts, count);
  }
  text.detail = result.distance > 0.0
                    ? fmt::format("Closest: {}, {} apart.", story.closest_features(),
                                  story.numbers(result.distance))
                    : fmt::format("{} and {} overlap: O lies in Z.", story.run.lesson.x().name,
                                  story.run.lesson.y().name);
  if (!story.run.lesson.has_block(blocks::kStarts.name)) return;
  const auto cold = [&](int run) { return story.effects.get<ColdStart>({.run = run}).iterations; };
  const int last = static_cast<int>(story.run.runs.size()) - 1;
  if (story.frame.run < last) {
    if (story.frame.run > 0)
      text.detail += fmt::format(" A cold start takes {}.", cold(story.frame.run));
    return;
  }
  int cold_sum = 0;
  int warm_sum = 0;
  for (int i = 0; i <= last; ++i) {
    cold_sum += cold(i);
    warm_sum += story.run.runs[i].trace.result.iterations;
  }
  text.detail += fmt::format(" All {} runs take {} iterations; cold starts would take {}.",
                             last + 1, warm_sum, cold_sum);
}

/// By what Z slides to a position: not where a shape turns.
Vector2d slide_of_move(const Story& story, int run) {
  const LastPosition::Value& last = story.effects.get<LastPosition>({.run = run});
  return last->turned ? Vector2d(Vector2d::Zero()) : Vector2d(last->y_by - last->x_by);
}

/// How the shapes, and with them Z, moved since the last position.
std::string moves(const Story& story) {
  const Lesson& lesson = story.run.lesson;
  const PositionedRun& last = story.run.runs[story.frame.run - 1];
  const Eigen::Vector3d x_by =
      story.positioned.x().placement.translate - last.x().placement.translate;
  const Eigen::Vector3d y_by =
      story.positioned.y().placement.translate - last.y().placement.translate;
  const std::string z_by = story.numbers.point(y_by - x_by);
  if (x_by == y_by) {
    return fmt::format("Both moved by {}: Z and everything in it stay where they were.",
                       story.numbers.point(x_by));
  }
  if (y_by.norm() == 0.0) {
    return fmt::format("The {} moved by {}, so Z slides by {}, the opposite way.", lesson.x().name,
                       story.numbers.point(x_by), z_by);
  }
  if (x_by.norm() == 0.0) {
    return fmt::format("The {} moved by {}, and Z slides with it by {}.", lesson.y().name,
                       story.numbers.point(y_by), z_by);
  }
  return fmt::format("Z slides by {}: the move of the {} minus that of the {}.", z_by,
                     lesson.y().name, lesson.x().name);
}

void slide(const Story& story, FrameText& text) {
  const Lesson& lesson = story.run.lesson;
  const double distance = story.trace.result.distance;
  const std::string change =
      story.frame.run > 0
          ? moves(story)
          : fmt::format("Z = {} − {}. Drawn around the {}, it is the {} grown by the {}.",
                        lesson.y().name, lesson.x().name, lesson.y().name, lesson.y().name,
                        lesson.x().name);
  const bool slides = story.frame.run > 0 && slide_of_move(story, story.frame.run).norm() > 0.0;
  if (distance > 0.0) {
    text.caption = change;
    text.detail =
        fmt::format("{} times the same distance, {}: {} to {}, p to the grown {}, O to Z{}.",
                    slides ? "Four" : "Three", story.numbers(distance), lesson.x().name,
                    lesson.y().name, lesson.y().name, slides ? ", s − t to the dashed Z" : "");
  } else if (story.trace.result.verdict == gjk::Verdict::touching) {
    text.caption = fmt::format(
        "The {} touches the {}: p lies on the boundary of the grown {}, O on that of Z.",
        lesson.x().name, lesson.y().name, lesson.y().name);
    text.detail = change + (slides ? " s − t lies on the boundary of the dashed Z."
                                   : " All three distances are 0.");
  } else {
    text.caption = fmt::format("The {} and the {} overlap: p lies inside the grown {}, O inside Z.",
                               lesson.x().name, lesson.y().name, lesson.y().name);
    text.detail =
        change + (slides ? " s − t lies inside the dashed Z." : " All three distances are 0.");
  }
}

/// "the robot will move by s = (0.75, 1.25)"
std::string coming_moves(const Story& story, const LastPosition::Positions& next) {
  std::string out;
  const auto add = [&](const std::string& name, std::string_view letter,
                       const Eigen::Vector2d& by) {
    if (by.norm() == 0.0) return;
    out += fmt::format("{}the {} {}by {} = {}", out.empty() ? "" : ", ", name,
                       out.empty() ? "will move " : "", letter, story.numbers.point(by));
  };
  add(story.run.lesson.x().name, "s", next.x_by);
  add(story.run.lesson.y().name, "t", next.y_by);
  return out;
}

/// "0.317 L + 0.683 K"
std::string weighted(const Story& story, const std::vector<std::string>& names) {
  const WideSimplex& simplex = story.trace.result.simplex;
  if (simplex.count == 1) return names[0];
  std::string out;
  for (const int i : SimplexWords(story.run, simplex).order(simplex.all())) {
    if (!out.empty()) out += " + ";
    out += story.numbers.weight(simplex.weights[i]) + " " + names[i];
  }
  return out;
}

bool x_has_moved(const Story& story) {
  if (story.frame.run == 0) return false;
  const PositionedRun& last = story.run.runs[story.frame.run - 1];
  return story.positioned.x().placement.translate != last.x().placement.translate;
}

/// A point of one shape, from the weights of P.
void carried_back(const Story& story, bool of_x, FrameText& text) {
  const WideResult& result = story.trace.result;
  const LessonShape& shape = of_x ? story.run.lesson.x() : story.run.lesson.y();
  std::vector<std::string> names;
  for (int i = 0; i < result.simplex.count; ++i) {
    const gjk::VertexPair pair = result.simplex.vertices[i].pair;
    names.push_back(shape.vertex_names[of_x ? pair.x : pair.y]);
  }
  const std::string letter = of_x ? "x" : "y";
  const bool one_vertex =
      std::all_of(names.begin(), names.end(), [&](const auto& name) { return name == names[0]; });
  text.caption = fmt::format("The same weights on the vertices of {} give {} = {}.", shape.name,
                             letter, weighted(story, names));
  const std::string point = story.numbers.point(of_x ? result.x : result.y);
  if (!one_vertex) {
    text.detail =
        fmt::format("{} = {} is the point of {} closest to {}.", letter, point, shape.name,
                    of_x ? story.run.lesson.y().name : story.run.lesson.x().name);
  } else if (names.size() == 1) {
    text.detail =
        fmt::format("P is a single difference, so {} is {} itself: {}.", letter, names[0], point);
  } else {
    text.detail =
        fmt::format("{} differences come from {}, so {} is {} itself: {}.",
                    names.size() == 2 ? "Both" : "All three", names[0], letter, names[0], point);
  }
}

}  // namespace

void slide_question(const Story& story, FrameText& text) {
  const LastPosition::Value& next = story.effects.get<LastPosition>({.run = story.frame.run + 1});
  const Vector2d by = slide_of_move(story, story.frame.run + 1);
  const Vector2d left(-by.y(), by.x());
  const Vector2d from = centroid(next->z);
  std::vector<Vector2d> shifts = {by, -by, left, -left};
  std::sort(shifts.begin(), shifts.end(),
            [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x(); });
  FrameQuestion& asked =
      text.question.emplace(FrameQuestion{std::string(asks::kSlide.name), {}, {}});
  for (const Vector2d& shift : shifts) {
    asked.choices.push_back("by " + story.numbers.point(shift));
    asked.spots.push_back(Spot{ViewKind::difference, from, Vector2d(from + shift)});
    if (shift == by) asked.answer = asked.choices.back();
  }
  asked.origin = from;
  asked.place = from + by;
  text.caption = fmt::format("Question: {}. Which way will Z slide? Drag it from the middle of Z.",
                             coming_moves(story, *next));
  asked.refuted = fmt::format("Each y − x changes by {} = {}.",
                              next->x_by.norm() == 0.0   ? "t"
                              : next->y_by.norm() == 0.0 ? "−s"
                                                         : "t − s",
                              story.numbers.point(by));
}

void holds_question(const Story& story, FrameText& text) {
  const LastPosition::Value& next = story.effects.get<LastPosition>({.run = story.frame.run + 1});
  const WideResult& result = story.run.runs[story.frame.run + 1].trace.result;
  FrameQuestion& asked =
      text.question.emplace(FrameQuestion{std::string(asks::kHolds.name), {}, {}});
  asked.choices = {"they will be apart: s − t is outside of Z",
                   "they will touch: s − t is on its boundary",
                   "they will overlap: s − t is inside"};
  asked.answer = asked.choices[result.distance > 0.0                      ? 0
                               : result.verdict == gjk::Verdict::touching ? 1
                                                                          : 2];
  text.caption =
      fmt::format("Question: {}, so s − t = {}, which is marked. Will they meet?",
                  coming_moves(story, *next), story.numbers.point(next->x_by - next->y_by));
}

void answer(const Story& story, FrameText& text) {
  if (story.run.lesson.warm_start) return warm_start(story, text);
  if (story.shows(LastPosition::kName)) return slide(story, text);
  if (!(story.trace.result.distance > 0.0)) return overlap(story, text);
  const bool is_round = RoundShapes::of(story.effects, story.run, story.frame) != nullptr;
  const std::string moved = story.moved();
  text.caption = fmt::format("{}{}{}{} and {} are {} apart, and O is as far from Z{}.", moved,
                             moved.empty() ? "" : " ", is_round ? "Without their radii, " : "",
                             story.run.lesson.x().name, story.run.lesson.y().name,
                             story.numbers(story.trace.result.distance),
                             moved.empty() ? ": P is the arrow y − x, drawn from O" : "");
  text.detail = fmt::format("Closest: {}, so P {}.", story.closest_features(), place_of_p(story));
}

void witness(const Story& story, FrameText& text) {
  const WideResult& result = story.trace.result;
  const SimplexWords words(story.run, result.simplex);
  std::vector<std::string> of_z;
  for (int i = 0; i < result.simplex.count; ++i) {
    of_z.push_back(result.simplex.count == 1 ? words.vertex(i)
                                             : fmt::format("({})", words.vertex(i)));
  }
  switch (*witness_part(story.run, story.frame)) {
    case WitnessPart::p:
      text.caption = fmt::format(
          "{}P = {} is the point of Z closest to O.",
          x_has_moved(story) ? story.run.lesson.x().name + " has moved. " : std::string(),
          weighted(story, of_z));
      text.detail =
          "Each difference remembers its two vertices. Put the weights on those: first on Y's, "
          "then "
          "on X's.";
      return;
    case WitnessPart::on_y:
      return carried_back(story, false, text);
    case WitnessPart::on_x:
      return carried_back(story, true, text);
    case WitnessPart::distance:
      if (!(result.distance > 0.0)) return overlap(story, text);
      text.caption =
          fmt::format("y − x = {} − {} = {} = P, so |y − x| = |P| = {}.",
                      story.numbers.point(result.y), story.numbers.point(result.x),
                      story.numbers.point(result.y - result.x), story.numbers(result.distance));
      text.detail = fmt::format("Closest: {}, as the two letters of each difference say.",
                                story.closest_features());
  }
}

}  // namespace gjkscope::captions
