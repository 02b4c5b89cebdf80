#include <fmt/format.h>

#include <algorithm>

#include "subjects/faces_of_difference/growth.hpp"
#include "subjects/faces_of_difference/shown.hpp"

namespace gjkscope::zfaces {
namespace {

using sums_in_space::Face;
using sums_in_space::Kind;
using Phase = FacesTrace::Phase;

void start(const Shown& shown, FrameText& text) {
  const std::string& x = shown.lesson.x().name;
  const std::string& y = shown.lesson.y().name;
  if (shown.trace.steps() == 0) {
    const bool is_x = shown.trace.hulls[0].faces.empty();
    text.caption = fmt::format("{} is flat: its points lie in one plane.", is_x ? x : y);
    text.detail = "The three kinds of faces are those of two bodies that both have a volume.";
    return;
  }
  text.caption =
      fmt::format("Z = {1} − {0} is a polyhedron, too: how do its faces come about?", x, y);
  text.detail = fmt::format(
      "A face is where Z reaches farthest along its normal n. There {1} reaches farthest along n, "
      "and {0} along −n.",
      x, y);
}

void one(const Shown& shown, FrameText& text) {
  const Face& face = *shown.face();
  const std::string y = shown.of_y(face);
  const std::string x = shown.of_x(face);
  const std::string& name_x = shown.lesson.x().name;
  const std::string& name_y = shown.lesson.y().name;
  switch (face.kind()) {
    case Kind::of_y:
      text.caption = fmt::format("The marked face is {}, moved: {} is subtracted from it.", y, x);
      text.detail = fmt::format(
          "Along its normal n, {} reaches farthest in the whole face; along −n, {} reaches "
          "farthest "
          "in one vertex.",
          name_y, name_x);
      return;
    case Kind::of_x:
      text.caption =
          fmt::format("The marked face is {}, mirrored and moved: it is subtracted from {}.", x, y);
      text.detail = fmt::format(
          "Its normal n is opposite to that of the face of {}. Along n, {} reaches farthest in one "
          "vertex.",
          name_x, name_y);
      return;
    case Kind::of_edges:
      text.caption = fmt::format("The marked face is a parallelogram: {}, less {}.", y, x);
      text.detail = fmt::format(
          "Its normal n is normal to both edges. No face of {} or {} has it, so a hull of moved "
          "faces would miss this one.",
          name_y, name_x);
      return;
    case Kind::of_several:
      text.caption =
          fmt::format("The marked face has more than one source: {} and {} are parallel.", y, x);
      text.detail = "Each alone would make a face in this plane: together they make one.";
      return;
  }
}

void kind(const Shown& shown, FrameText& text) {
  const Kind of = shown.at().kind;
  const int count = shown.trace.count(of);
  const std::string& x = shown.lesson.x().name;
  const std::string& y = shown.lesson.y().name;
  switch (of) {
    case Kind::of_y:
    case Kind::of_x: {
      const bool of_y = of == Kind::of_y;
      const auto faces = shown.trace.hulls[of_y ? 1 : 0].faces.size();
      text.caption =
          fmt::format("{} faces of Z are faces of {}{}{}", count, of_y ? "" : "−", of_y ? y : x,
                      static_cast<std::size_t>(count) == faces
                          ? ": each is there once."
                          : fmt::format(" alone, of {} that it has.", faces));
      text.detail = fmt::format("Different vertices of {} move them.", of_y ? x : y);
      return;
    }
    case Kind::of_edges:
      text.caption = fmt::format(
          "{} faces of Z are parallelograms, some of them behind. There are {} pairs of edges.",
          count, shown.trace.hulls[1].edges.size() * shown.trace.hulls[0].edges.size());
      text.detail = fmt::format(
          "A pair makes one if planes along both edges touch {} and {} in these edges alone, from "
          "opposite sides.",
          y, x);
      return;
    case Kind::of_several:
      text.caption = fmt::format("{} faces of Z have more than one source.", count);
      text.detail = "Parallel faces and edges are rare in general position, and common in boxes.";
      return;
  }
}

void all(const Shown& shown, FrameText& text) {
  const FacesTrace& trace = shown.trace;
  std::string sum;
  for (int i = 0; i < sums_in_space::kKinds; ++i) {
    const int count = trace.count(static_cast<Kind>(i));
    if (i == 3 && count == 0) continue;
    sum += fmt::format("{}{}", sum.empty() ? "" : " + ", count);
  }
  text.caption = fmt::format("Z has {} = {} faces.", sum, trace.faces.size());
  text.detail =
      "There are no others. In the plane each edge comes once: m + n in all. In space pairs of "
      "edges "
      "come on top: O(n²), says Larsen.";
}

void answer(const Story& story, const Shown& shown, FrameText& text) {
  text.caption =
      fmt::format("GJK does not build these {} faces. It asks for {} support points of Z.",
                  shown.trace.faces.size(), shown.trace.support_points);
  if (story.trace.result.stop == gjk::StopReason::repeated_support)
    text.caption += " The last one is there already, so GJK stops.";
  text.detail = fmt::format(
      "Each is one vertex of {} less one of {}: neither faces nor edges are needed, nor who is "
      "whose neighbour.",
      shown.lesson.y().name, shown.lesson.x().name);
}

void growth(const Story& story, Growing growing, FrameText& text) {
  const FaceGrowth::Sample& last = story.effects.get<FaceGrowth>(story.frame).back();
  switch (growing) {
    case Growing::faces:
      text.caption = fmt::format(
          "With {} vertices each, Z has {} faces for points on spheres, and {} for flat lenses "
          "that cross.",
          last.vertices, grouped(last.of_spheres), grouped(last.of_lenses));
      text.detail = fmt::format(
          "The first grow about like n, the second like n²/2. GJK asks for {} and {} support "
          "points. Counted for one pair of bodies for each n.",
          last.asked_of_spheres, last.asked_of_lenses);
      return;
    case Growing::depth:
      text.caption = fmt::format(
          "Where two spheres of {} vertices overlap, their depth takes {} support points; their "
          "distance apart took {}.",
          last.vertices, last.asked_for_depth, last.asked_of_spheres);
      text.detail =
          "Any face around O may be the nearest, so Z's boundary must be found on all sides: "
          "Larsen "
          "knows no better way. A distance needs one side.";
      return;
    case Growing::general:
      text.caption =
          "Bodies that are not convex: Z can have about n⁶ corners. Larsen knows no faster way.";
      text.detail =
          "n parts each have n · n differences. Any three of their faces may meet in a corner: "
          "(n²)³ = n⁶. Convex bodies have n² at most.";
      return;
  }
}

void growth_question(const Story& story, Growing growing, FrameText& text) {
  const FaceGrowth::Value& samples = story.effects.get<FaceGrowth>(story.frame);
  const FaceGrowth::Sample& last = samples.back();
  const GrowthQuestion question = question_of(growing, samples);
  ask_growth(story.run.asked(story.frame).ask, question.choices,
             question.measured / question.before, true, text);
  const auto at = [&](std::size_t choice) {
    return grouped(question.before * question.choices[choice].ratio);
  };
  switch (growing) {
    case Growing::faces:
      text.question->refuted = fmt::format("As n would be {}, as n² {}.", at(1), at(2));
      text.caption = fmt::format(
          "Question: from n = {} to {}, how do the faces of Z grow for the lenses, most of them of "
          "pairs of edges? Point at a place.",
          asked_from(samples).vertices, last.vertices);
      return;
    case Growing::depth:
      text.caption = fmt::format(
          "Question: where the spheres overlap, how many support points does their depth take at "
          "n = {}? Point at a place.",
          last.vertices);
      return;
    case Growing::general:
      text.caption =
          "Question: n parts of Y less n of X, of which any three faces may meet. As which power "
          "do the corners of Z grow?";
      return;
  }
}

}  // namespace

void words(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  if (const auto growing = growth_of(story.run, story.frame)) return growth(story, *growing, text);
  if (shown.step < 0) return start(shown, text);
  if (shown.is_answer) return answer(story, shown, text);
  switch (shown.at().phase) {
    case Phase::one:
      return one(shown, text);
    case Phase::kind:
      return kind(shown, text);
    case Phase::all:
      return all(shown, text);
  }
}

void question(const Story& story, FrameText& text) {
  if (const auto growing = growth_of(story.run, story.frame))
    return growth_question(story, *growing, text);
  const Shown shown(story.run, story.frame);
  const Face& face = *shown.face();
  const std::string& x = shown.lesson.x().name;
  const std::string& y = shown.lesson.y().name;
  if (shown.asks_source) {
    text.question = FrameQuestion{
        std::string(kAskSource.name),
        {fmt::format("a face of {}", y), fmt::format("a face of −{}", x), "an edge of each"},
        {}};
    text.question->answer = text.question->choices[static_cast<std::size_t>(face.kind())];
    text.caption = "Question: what does the marked face of Z come from?";
    return;
  }
  const bool of_y = face.kind() == Kind::of_y;
  const LessonShape& other = of_y ? shown.lesson.x() : shown.lesson.y();
  const Polyhedron& hull = shown.trace.hulls[of_y ? 0 : 1];
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskMover.name), {}, {}});
  for (const int vertex : hull.vertices) asked.choices.push_back(other.vertex_names[vertex]);
  asked.answer = other.vertex_names[of_y ? face.x[0] : face.y[0]];
  text.caption =
      of_y ? fmt::format(
                 "Question: {} makes the marked face. Which vertex of {} is subtracted from it?",
                 shown.of_y(face), x)
           : fmt::format(
                 "Question: {} makes the marked face. From which vertex of {} is it subtracted?",
                 shown.of_x(face), y);
}

void values(const Story& story, FrameText& text) {
  const FacesTrace& trace = Shown(story.run, story.frame).trace;
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  put("faces", std::to_string(trace.faces.size()));
  put("support points", std::to_string(trace.support_points));
}

}  // namespace gjkscope::zfaces
