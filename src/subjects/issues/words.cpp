#include <fmt/format.h>

#include "picture/story.hpp"
#include "run/questions.hpp"
#include "subjects/issues/numerical_issue.hpp"
#include "subjects/issues/subject.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/shape_hull/shape_hull.hpp"

namespace gjkscope::captions {
namespace {

using IssueKind = NumericalIssue::Kind;

/// "E, F and G"
std::string named(const Story& story, const std::vector<int>& vertices) {
  std::vector<std::string> names;
  for (const int i : vertices) names.push_back(story.run.lesson.y().vertex_names[i]);
  return and_list(std::move(names));
}

/// Why the run ended: what the panel's short words mean.
std::string why(const Story& story) {
  const std::string support = story.run.pair_name(story.state.support.pair);
  switch (story.state.stop) {
    case gjk::StopReason::repeated_support:
      return fmt::format("{} is in S already", support);
    case gjk::StopReason::not_nearer:
      return "P came no closer";
    case gjk::StopReason::no_progress:
      return fmt::format("{} lies no farther along d than S", support);
    default:
      return stop_test(story.run, story.frame);
  }
}

}  // namespace

void issue(const Story& story, FrameText& text) {
  const NumericalIssue::Value& issue = story.effects.get<NumericalIssue>(story.frame);
  const std::string& q = story.q;
  const WideSimplex& simplex = story.trace.result.simplex;
  const std::string feature = SimplexWords(story.run, simplex).face(simplex.all());
  switch (issue.kind) {
    case IssueKind::direction:
      text.caption =
          fmt::format("{} lies beyond the edge {}. d must be perpendicular to it.", q, feature);
      text.detail =
          fmt::format("d = {0} − P seems right. But P is rounded, so {0} − P is, too.", q);
      return;
    case IssueKind::repeated:
      text.caption =
          fmt::format("{} lies beyond the vertex {}. When has GJK found it?", q, feature);
      text.detail = "Without a test it would search in the same direction for ever.";
      return;
    case IssueKind::contained:
      text.caption = fmt::format("{} lies inside the polygon.", q);
      text.detail = fmt::format("Then P will be {0}, and {0} − P points nowhere.", q);
      return;
    case IssueKind::vertex:
      text.caption = fmt::format("{} is the vertex {}.", q, feature);
      text.detail = fmt::format("Then P will be {0}, and {0} − P is 0.", q);
      return;
    case IssueKind::edge:
      text.caption = fmt::format("{} lies on the edge {}.", q, feature);
      text.detail = fmt::format(
          "P will be {}. The edge has two normals, and no side of it is the right one.", q);
      return;
    case IssueKind::interior:
      text.caption = fmt::format("{} lies on the segment {}, inside the polygon.", q, feature);
      text.detail =
          fmt::format("P will be {} again. Both normals of the segment find something new.", q);
      return;
    case IssueKind::notch: {
      const auto& inside = story.effects.get<ShapeHull>(story.frame).y.inside;
      text.caption = fmt::format("The polygon is not convex at {}, and {} lies in that notch.",
                                 story.run.lesson.y().vertex_names[inside[0]], q);
      text.detail = fmt::format("{} is outside of the polygon, but inside its hull.", q);
      return;
    }
    case IssueKind::collinear:
      text.caption = fmt::format("{} lies beyond {}, three vertices on one line.", q,
                                 named(story, issue.support));
      text.detail = "Their triangle has area 0, so it has no barycentric coordinates.";
      return;
  }
}

void issue_solved(const Story& story, FrameText& text) {
  const NumericalIssue::Value& issue = story.effects.get<NumericalIssue>(story.frame);
  const std::string& q = story.q;
  const std::string support = story.run.pair_name(story.state.support.pair);
  switch (issue.kind) {
    case IssueKind::direction: {
      const std::string edge = story.words.vertex(1) + " − " + story.words.vertex(0);
      text.caption = fmt::format(
          "dot({} − P, {}) = {}, not 0. GJK takes d = cross({}, z): the dot product is 0.", q, edge,
          story.numbers(issue.dot_with_edge), edge);
      text.detail =
          "z is the normal of the plane. A slightly wrong d can find a wrong support point.";
      return;
    }
    case IssueKind::repeated:
      text.caption =
          fmt::format("Case 1: the support point {} is in S already. GJK stops.", support);
      text.detail =
          fmt::format("No point of the polygon lies farther along d, so none is closer to {}.", q);
      return;
    case IssueKind::contained:
      text.caption =
          fmt::format("Case 2: {} lies in the triangle {}. GJK stops without a direction.", q,
                      story.words.face(story.state.simplex.all()));
      text.detail = "All three vertices have positive weights. The distance is 0.";
      return;
    case IssueKind::vertex:
      text.caption = fmt::format("Case 3a: P = {}, so d = 0. GJK tests for that, and stops.", q);
      text.detail = "Without the test every vertex would be farthest along d.";
      return;
    case IssueKind::edge:
      text.caption =
          fmt::format("Case 3b: either normal of the edge will do. GJK stops: {}.", why(story));
      text.detail = "Outwards V is in S already. Inwards V is new, but P comes no closer.";
      return;
    case IssueKind::interior:
      text.caption =
          fmt::format("Case 4: P stays where it was, whatever GJK adds. It stops: {}.", why(story));
      text.detail = fmt::format("GJK compares |{} − P| with that of the iteration before.", q);
      return;
    case IssueKind::notch:
      text.caption =
          fmt::format("GJK says that the distance is 0. The polygon is {} away.",
                      story.numbers(story.effects.get<ShapeHull>(story.frame).outline_distance));
      text.detail = "GJK answers for the convex hull. Cut such a polygon into convex pieces first.";
      return;
    case IssueKind::collinear:
      text.caption = fmt::format("{} are equally far along d: each may be the support point.",
                                 named(story, issue.support));
      text.detail = fmt::format("Whichever it is, GJK stops ({}), and P is right.", why(story));
      return;
  }
}

void issue_question(const Story& story, FrameText& text) {
  if (story.run.asked(story.frame).ask == asks::kClosestY.name)
    return closest_question(story, text);
  const int last = last_step(story.run.lesson, story.trace);
  text.question = FrameQuestion{"stop", stop_tests(story.run),
                                stop_test(story.run, {.run = story.frame.run, .step = last})};
  text.caption = fmt::format(
      "Question: which test will stop GJK, with {} there? V is the support point, "
      "S the simplex.",
      story.q);
}

}  // namespace gjkscope::captions
