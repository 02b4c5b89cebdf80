#include <fmt/format.h>

#include <algorithm>

#include "picture/captions/story.hpp"

namespace gjkscope::captions {
namespace {

using fmt::format;

std::string region_reason(const Story& story) {
  const gjk::Face face = story.state.region;
  const gjk::Simplex<double, 2>& simplex = story.state.simplex;
  const gjk::RegionTest<double>* won = nullptr;
  for (const auto& test : story.region_tests()) {
    if (test.holds) won = &test;
  }
  if (simplex.count == 1)
    return format("The simplex is the single point {0}, so {0} is its closest point to {1}.",
                  story.words.vertex(0), story.q);
  if (!won)
    return format("Rounding left every test false; the nearest candidate is the {}.",
                  story.words.kind_and_face(face));
  if (gjk::vertex_count(face) == 3)
    return format("{} lies inside {}: all three weights are positive.", story.q,
                  story.words.face(face));
  if (gjk::vertex_count(face) == 1) {
    const std::string vertex = story.words.face(face);
    if (simplex.count == 2) {
      const gjk::RegionTerm<double>& term = won->terms[0];
      return format("{} lies in the Voronoi region of {}: the weight of {} is {}, not positive.",
                    story.q, vertex, story.words.vertex(term.vertex), story.weight(term));
    }
    return format("{} lies in the Voronoi region of {}: seen from {}, it lies behind both edges.",
                  story.q, vertex, vertex);
  }
  if (simplex.count == 2)
    return format("{} lies in the Voronoi region of {}: both weights are positive.", story.q,
                  story.edge_name(face));
  for (const gjk::RegionTerm<double>& term : won->terms) {
    if (term.wants_positive) continue;
    return format(
        "{} lies in the region of {}: {} has weight {} in the triangle, and {} projects onto the "
        "edge.",
        story.q, story.edge_name(face), story.words.vertex(term.vertex), story.weight(term),
        story.q);
  }
  return {};
}

/// A lesson that shows the areas is told by them.
bool tells_areas(const Story& story) {
  if (story.state.simplex.count != 3 || story.run.lesson.granularity != Granularity::path)
    return false;
  const auto shows = [](const LessonView& view) {
    return std::find(view.effects.begin(), view.effects.end(), "barycentric-parts") !=
           view.effects.end();
  };
  return std::any_of(story.run.lesson.views.begin(), story.run.lesson.views.end(), shows);
}

void areas(const Story& story, FrameText& text) {
  const gjk::Barycentric<double, 2> coordinates =
      gjk::barycentric(story.state.simplex, story.state.simplex.all());
  std::string areas;
  std::string edges;
  std::string list;
  int negative = 0;
  for (int i = 0; i < 3; ++i) {
    const double weight = coordinates.numerator[i] / coordinates.denominator;
    list += format("{}{} = {}", i > 0 ? ", " : "", "uvw"[i], story.numbers.weight(weight));
    if (weight >= 0.0) continue;
    const std::string edge =
        story.words.face(static_cast<gjk::Face>(story.state.simplex.all() & ~gjk::face_of(i)));
    areas += (negative > 0 ? " and " : "") + story.q + edge;
    edges += (negative > 0 ? " and " : "") + edge;
    ++negative;
  }
  text.caption = negative == 0 ? format("All three areas are positive: {} lies inside.", story.q)
                               : format("The {} of {} {} negative: {} lies beyond {}.",
                                        negative == 1 ? "area" : "areas", areas,
                                        negative == 1 ? "is" : "are", story.q, edges);
  text.detail = format("{}: they add up to 1 wherever {} stands.", list, story.q);
}

/// What the sign of one coordinate says about where Q is.
std::string where(const Story& story, const gjk::RegionTerm<double>& term) {
  if (gjk::vertex_count(term.face) == 3) {
    return term.wants_positive ? format("{} lies beyond the edge opposite {}.", story.q,
                                        story.words.vertex(term.vertex))
                               : format("{} lies on the triangle's side of the edge opposite {}.",
                                        story.q, story.words.vertex(term.vertex));
  }
  const std::string edge = story.words.face(term.face);
  if (term.wants_positive)
    return format("Projected onto {}, {} falls beyond the end.", edge, story.q);
  const gjk::Face other = static_cast<gjk::Face>(term.face & ~gjk::face_of(term.vertex));
  return format("Projected onto {}, {} falls on {}'s side of {}.", edge, story.q,
                story.words.vertex(term.vertex), story.words.face(other));
}

}  // namespace

void closest(const Story& story, FrameText& text) {
  if (tells_areas(story)) return areas(story, text);
  text.caption = region_reason(story);
  if (gjk::vertex_count(story.state.region) == 3) {
    text.detail = story.run.point_query() ? format("So P = {}, and the distance is 0.", story.q)
                                          : "So P = O and the distance is 0: the shapes overlap.";
    return;
  }
  text.detail = format("So {}, at distance {} from {}.", story.p_is(), story.distance(), story.q);
}

void region_test(const Story& story, FrameText& text) {
  const gjk::Simplex<double, 2>& simplex = story.state.simplex;
  if (story.frame.detail < 0) {
    text.caption = format(
        "Which Voronoi region holds {}? First compute its barycentric coordinates.", story.q);
    if (simplex.count == 2) {
      text.detail =
          "u and v are fractions of the length of AB, signed. The tests come in order; the first "
          "that is true decides.";
    } else {
      text.detail =
          "u, v on each edge and u, v, w in the triangle. Vertex regions are tested first, then "
          "edges, then the interior.";
    }
    return;
  }
  const gjk::RegionTest<double>& test = story.region_tests()[story.frame.detail];
  if (test.holds) {
    text.caption = region_reason(story);
    text.detail =
        gjk::vertex_count(test.region) == 3
            ? "So P = " + story.q + ", and the distance is 0."
            : format("So {}, at distance {} from {}.", story.p_is(), story.distance(), story.q);
    return;
  }
  const std::vector<gjk::RegionTerm<double>> terms = story.words.terms(test);
  const auto failed =
      std::find_if(terms.begin(), terms.end(), [](const auto& term) { return !term.holds; });
  const std::string coordinate = story.words.coordinate(failed->face, failed->vertex);
  text.caption =
      format("Not region {}: {} = {} is {}positive.", story.words.face(test.region), coordinate,
             story.signed_weight(*failed), failed->wants_positive ? "not " : "");
  const gjk::RegionTest<double>& next = story.region_tests()[story.frame.detail + 1];
  text.detail =
      format("{} Next test: region {}.", where(story, *failed), story.words.face(next.region));
}

}  // namespace gjkscope::captions
