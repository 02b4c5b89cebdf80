#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "picture/story.hpp"
#include "subjects/run/refuting.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/space/region.hpp"
#include "subjects/weights/barycentric.hpp"
#include "subjects/weights/projection.hpp"
#include "subjects/weights/subject.hpp"

namespace gjkscope::captions {
namespace {

/// True in lessons on the region tests. Elsewhere weights are those of P.
bool names_coordinates(const Story& story) {
  const Lesson& lesson = story.run.lesson;
  return story.run.point_query() &&
         (lesson.has_block(blocks::kTests.name) || lesson.has_block(blocks::kWeights.name));
}

/// The closest face of a simplex in space, by the weights that decide.
std::string region_in_space(const Story& story, const gjk::RegionTest<double>& won) {
  const gjk::Face face = story.state.region;
  const WideSimplex& simplex = story.state.simplex;
  const std::string name = story.words.kind_and_face(face);
  const int size = gjk::vertex_count(face);
  if (size == 1) {
    return fmt::format(
        "{0} lies in the Voronoi region of {1}: on the line of each edge at {1} it "
        "projects beyond {1}.",
        story.q, story.words.face(face));
  }
  if (face == simplex.all()) {
    if (size == 4)
      return fmt::format("{} lies inside the {}: all four weights are positive.", story.q, name);
    return size == 3
               ? fmt::format("{} projects into the {}: all three weights are positive.", story.q,
                             name)
               : fmt::format("{} projects between the ends of the {}: both weights are positive.",
                             story.q, name);
  }
  for (const gjk::RegionTerm<double>& term : won.terms) {
    if (term.wants_positive || gjk::vertex_count(term.face) != size + 1) continue;
    const std::string opposite = story.words.vertex(term.vertex);
    if (size == 3 && term.denominator == 0.0) {
      return fmt::format(
          "{} has volume 0, so it has no weights and no inside. {} is the first face that {} "
          "projects into.",
          story.words.face(simplex.all()), story.words.face(face), story.q);
    }
    if (size == 3 && term.numerator == 0.0) {
      return fmt::format(
          "{0} lies in the {1}: the weight of {2} is 0, so {0} is neither before nor behind its "
          "plane.",
          story.q, name, opposite);
    }
    if (size == 3) {
      return fmt::format(
          "{} lies beyond the {}, seen from {} (volume fraction {}), and projects "
          "into it.",
          story.q, name, opposite, story.signed_weight(term));
    }
    return fmt::format(
        "{} lies in the region of the {}: it projects between its ends, and outside of {}.",
        story.q, name, simplex.count == 3 ? "the triangle" : "both faces that meet there");
  }
  return {};
}

std::string region_reason(const Story& story) {
  const gjk::Face face = story.state.region;
  const WideSimplex& simplex = story.state.simplex;
  const gjk::RegionTest<double>* won = nullptr;
  for (const auto& test : story.knows.region_tests) {
    if (test.holds) won = &test;
  }
  if (simplex.count == 1)
    return fmt::format("S is the single point {0}, so P = {0}.", story.words.vertex(0));
  if (won && story.run.lesson.dimension == 3) return region_in_space(story, *won);
  if (!won)
    return fmt::format("Rounding makes every test false. The nearest candidate is the {}.",
                       story.words.kind_and_face(face));
  if (gjk::vertex_count(face) == 3)
    return fmt::format("{} lies inside {}: all three weights are positive.", story.q,
                       story.words.face(face));
  if (gjk::vertex_count(face) == 1) {
    const std::string vertex = story.words.face(face);
    if (simplex.count == 2) {
      const gjk::RegionTerm<double>& term = won->terms[0];
      return fmt::format(
          "{} lies in the Voronoi region of {}: the weight of {} is {}, not positive.", story.q,
          vertex, story.words.vertex(term.vertex), story.weight(term));
    }
    const std::vector<gjk::RegionTerm<double>> terms = story.words.terms(*won);
    return fmt::format(
        "{0} lies in the Voronoi region of {1}: on the lines of both edges at {1} it projects "
        "beyond "
        "{1} ({2} = {3}, {4} = {5}).",
        story.q, vertex, story.words.coordinate(terms[0].face, terms[0].vertex),
        story.weight(terms[0]), story.words.coordinate(terms[1].face, terms[1].vertex),
        story.weight(terms[1]));
  }
  if (simplex.count == 2)
    return fmt::format("{} projects between the ends of {}: both weights are positive.", story.q,
                       story.edge_name(face));
  for (const gjk::RegionTerm<double>& term : won->terms) {
    if (term.wants_positive) continue;
    if (term.denominator == 0.0) {
      return fmt::format(
          "{} lies in the region of {}: {} has area 0 and no area fractions, so no point lies "
          "inside. {} projects onto {}.",
          story.q, story.edge_name(face), story.words.face(simplex.all()), story.q,
          story.edge_name(face));
    }
    if (term.numerator == 0.0) {
      return fmt::format(
          "{} lies on {}: {} has weight 0 in the triangle, the other two are positive.", story.q,
          story.edge_name(face), story.words.vertex(term.vertex));
    }
    if (names_coordinates(story)) {
      const std::vector<int> ends = story.words.order(face);
      return fmt::format(
          "{0} lies in the region of {1}: it lies beyond {1}, since {2} = {3} < 0, and "
          "projects between {4} and {5}.",
          story.q, story.edge_name(face), story.words.coordinate(term.face, term.vertex),
          story.weight(term), story.words.vertex(ends[0]), story.words.vertex(ends[1]));
    }
    const std::vector<int> ends = story.words.order(face);
    return fmt::format(
        "{} lies beyond {}, seen from {} (area fraction {} < 0), and projects between {}.", story.q,
        story.edge_name(face), story.words.vertex(term.vertex), story.weight(term),
        story.run.point_query()
            ? fmt::format("{} and {}", story.words.vertex(ends[0]), story.words.vertex(ends[1]))
            : "its ends");
  }
  return {};
}

/// The words of a lesson that shows the areas.
bool tells_areas(const Story& story) {
  return story.state.simplex.count == 3 && story.run.tour->sweeps &&
         story.shows(BarycentricParts::kName);
}

/// The state that the position before found; none at the first position.
const WideState* last_found(const Story& story) {
  if (story.frame.run == 0) return nullptr;
  const auto& steps = story.run.runs[static_cast<std::size_t>(story.frame.run) - 1].trace.steps;
  return steps.empty() ? nullptr : &steps.front().after;
}

/// "The distance grows from 1.483 to 1.916."
std::string change_of_distance(const Story& story, const WideState& before) {
  const std::string was = story.numbers(std::sqrt(before.p_sq));
  if (was == story.distance()) return fmt::format("The distance is {} again.", was);
  return fmt::format("The distance {} from {} to {}.",
                     story.state.p_sq > before.p_sq ? "grows" : "shrinks", was, story.distance());
}

/// "QCA", "QCA and QAB": the parts whose weights have this sign.
std::string parts_of(const Story& story, const gjk::Barycentric<double, 2>& coordinates,
                     bool negative) {
  std::string out;
  for (int i = 0; i < 3; ++i) {
    if ((coordinates.numerator[i] < 0.0) != negative) continue;
    const gjk::Face rest = story.state.simplex.all() & ~gjk::face_of(i);
    out += (out.empty() ? "" : " and ") + story.q + story.words.face(rest);
  }
  return out;
}

/// One weight is negative, as it was at the position before: tells how it changes.
bool same_weight_is_negative(const Story& story, const gjk::Barycentric<double, 2>& now,
                             const std::string& sum, FrameText& text) {
  if (story.frame.run == 0) return false;
  const WideSimplex& last =
      story.run.runs[static_cast<std::size_t>(story.frame.run) - 1].trace.initial.simplex;
  if (last.count != 3) return false;
  const gjk::Barycentric<double, 2> before = gjk::barycentric(in_plane(last), last.all());
  int negative = -1;
  for (int i = 0; i < 3; ++i) {
    const bool is_negative = now.numerator[i] < 0.0;
    if (is_negative != (before.numerator[i] < 0.0) || (is_negative && negative >= 0)) return false;
    if (is_negative) negative = i;
  }
  if (negative < 0) return false;
  const double was = before.numerator[negative] / before.denominator;
  const double is = now.numerator[negative] / now.denominator;
  text.caption = fmt::format(
      "{} {} {}, still beyond it: {} {} from {} to {}.", story.q,
      is < was ? "moves away from" : "comes nearer to",
      story.words.face(static_cast<gjk::Face>(story.state.simplex.all() & ~gjk::face_of(negative))),
      "uvw"[negative], is < was ? "falls" : "rises", story.numbers.weight(was),
      story.numbers.weight(is));
  if (!refutes(story.run, story.frame))
    text.detail = fmt::format("The other two make up for it: {}.", sum);
  return true;
}

void areas(const Story& story, FrameText& text) {
  const gjk::Barycentric<double, 2> coordinates =
      gjk::barycentric(in_plane(story.state.simplex), story.state.simplex.all());
  const std::string whole = story.words.face(story.state.simplex.all());
  std::string negatives;
  std::string edges;
  std::string sum;
  int count = 0;
  std::vector<std::string> terms;
  for (int i = 0; i < 3; ++i) {
    const double weight = coordinates.numerator[i] / coordinates.denominator;
    const std::string number = story.numbers.weight(weight);
    terms.push_back(number);
    sum += sum.empty() ? number : weight < 0.0 ? " − " + fixed(-weight, 3) : " + " + number;
    if (weight >= 0.0) continue;
    const std::string edge =
        story.words.face(static_cast<gjk::Face>(story.state.simplex.all() & ~gjk::face_of(i)));
    negatives += fmt::format("{}{} = area({}{}) / area({}) = {}", count > 0 ? " and " : "",
                             "uvw"[i], story.q, edge, whole, number);
    edges += (count > 0 ? " and " : "") + edge;
    ++count;
  }
  sum += adds_up(terms, "1") ? " = 1" : " = 1 up to rounding";
  if (same_weight_is_negative(story, coordinates, sum, text)) return;
  if (count == 0) {
    text.caption = fmt::format("{} lies inside: all three areas are positive and together fill {}.",
                               story.q, whole);
    text.detail = fmt::format("u + v + w = {}.", sum);
    if (!refutes(story.run, story.frame))
      text.detail += fmt::format(" The areas are weights, too: uA + vB + wC = {}.", story.q);
    return;
  }
  text.caption = fmt::format("{} {} negative: {} lies beyond {}.", negatives,
                             count == 1 ? "is" : "are", story.q, edges);
  text.detail =
      fmt::format("{} {} negative: {} {} larger than {} by exactly that much.",
                  parts_of(story, coordinates, true), count == 1 ? "counts" : "count",
                  parts_of(story, coordinates, false), count == 1 ? "together are" : "is", whole);
  if (!refutes(story.run, story.frame)) text.detail += fmt::format(" Thus {}.", sum);
}

/// The words of a lesson that shows no weights: they name features, for weights may be new to
/// readers.
bool tells_features(const Story& story) {
  const Lesson& lesson = story.run.lesson;
  return story.state.simplex.count == 3 && story.run.tour->sweeps &&
         !lesson.has_block(blocks::kWeights.name);
}

/// The region of the next position; 0 after the last one.
gjk::Face next_region(const Story& story) {
  const auto next = static_cast<std::size_t>(story.frame.run) + 1;
  if (next >= story.run.runs.size() || story.run.runs[next].trace.steps.empty()) return 0;
  return story.run.runs[next].trace.steps.front().after.region;
}

/// "AB and CA": the edges of a triangle that end at a vertex.
std::string edges_at(const Story& story, gjk::Face vertex) {
  std::string out;
  for (const gjk::Face edge : {gjk::Face{0b011}, gjk::Face{0b110}, gjk::Face{0b101}}) {
    if ((edge & vertex) != 0) out += (out.empty() ? "" : " and ") + story.words.face(edge);
  }
  return out;
}

void features(const Story& story, FrameText& text) {
  const gjk::Face face = story.state.region;
  const std::string name = story.words.face(face);
  const int size = gjk::vertex_count(face);
  const WideState* before = last_found(story);
  if (before != nullptr && before->region == face && size < 3) {
    text.caption =
        size == 1
            ? fmt::format(
                  "{0} stays in region {1}: it still projects beyond {1}, so P = {1} stays.",
                  story.q, name)
            : fmt::format("{0} stays in region {1}: P slides along {1} with {0}.", story.q, name);
    text.detail = change_of_distance(story, *before);
  } else if (size == 1) {
    text.caption = fmt::format(
        "{0} lies in region {1}: its projections onto both edges at {1} fall beyond {1}.", story.q,
        name);
    text.detail = fmt::format(
        "Every other point of {} is farther, and every way inside crosses one of them. Thus P = "
        "{}, at distance {}.",
        edges_at(story, face), name, story.distance());
  } else if (size == 2) {
    const std::vector<int> ends = story.words.order(face);
    text.caption =
        fmt::format("{0} lies in region {1}: it lies beyond {1} and projects between {2} and {3}.",
                    story.q, name, story.words.vertex(ends[0]), story.words.vertex(ends[1]));
    text.detail = fmt::format(
        "The projection is the closest point P, at distance {}: the triangle lies behind {}.",
        story.distance(), name);
  } else {
    text.caption = fmt::format("{} lies inside {}: it is its own closest point, P = {}.", story.q,
                               name, story.q);
    text.detail = "The distance is 0.";
  }
  const gjk::Face next = next_region(story);
  if (next == 0 || next == face) return;
  text.detail += gjk::vertex_count(next) == 3
                     ? fmt::format(" Next, {} moves inside.", story.q)
                     : fmt::format(" Next: region {}.", story.words.face(next));
}

/// Tells what the sign of one coordinate says about the place of Q.
std::string where(const Story& story, const gjk::RegionTerm<double>& term) {
  if (gjk::vertex_count(term.face) == 4) {
    const std::string opposite =
        story.words.kind_and_face(static_cast<gjk::Face>(term.face & ~gjk::face_of(term.vertex)));
    return term.wants_positive
               ? fmt::format("{} lies beyond the {}.", story.q, opposite)
               : fmt::format("{} lies on the tetrahedron's side of the {}.", story.q, opposite);
  }
  if (gjk::vertex_count(term.face) == 3) {
    const std::string opposite =
        story.edge_name(static_cast<gjk::Face>(term.face & ~gjk::face_of(term.vertex)));
    return term.wants_positive
               ? fmt::format("{} lies beyond {}.", story.q, opposite)
               : fmt::format("{} lies on the triangle's side of {}.", story.q, opposite);
  }
  const std::string edge = story.words.face(term.face);
  if (term.wants_positive) return fmt::format("{} projects beyond an end of {}.", story.q, edge);
  const gjk::Face other = static_cast<gjk::Face>(term.face & ~gjk::face_of(term.vertex));
  return fmt::format("On the line {}, {} projects to {}'s side of {}.", edge, story.q,
                     story.words.vertex(term.vertex), story.words.face(other));
}

/// The words of a lesson that shows where Q falls on the line through AB.
void projection(const Story& story, FrameText& text) {
  const std::string a = story.words.vertex(0);
  const std::string b = story.words.vertex(1);
  const bool between = story.state.region == story.state.simplex.all();
  const bool before = story.state.region == 0b01;
  const std::string end = before ? a : b;
  const WideState* last = last_found(story);
  if (last != nullptr && last->region == story.state.region) {
    text.caption =
        between
            ? fmt::format("{0} stays in region {1}{2}: G moves along {1}{2}, and P with it.",
                          story.q, a, b)
            : fmt::format("{0} stays in region {1}: G moves, still beyond {1}, so P = {1} stays.",
                          story.q, end);
    text.detail = change_of_distance(story, *last);
  } else {
    text.caption =
        between
            ? fmt::format(
                  "{0} projects to G, between {1} and {2}: {0} lies in region {1}{2}, and P = G.",
                  story.q, a, b)
            : fmt::format("{0} projects to G, beyond {1}: {0} lies in region {1}, and P = {1}.",
                          story.q, end);
    text.detail = fmt::format(
        "The distance is {}: every other point of {}{} is farther from G and so, by Pythagoras, "
        "from {}.",
        story.distance(), a, b, story.q);
  }
  const gjk::Face next = next_region(story);
  if (next == 0 || next == story.state.region) return;
  const gjk::Face passed = between ? next : story.state.region;
  text.detail += fmt::format(" Next, G passes {}.", story.words.face(passed));
}

/// "u", "u and v": the weights of this sign.
std::string letters_of(const std::vector<double>& weights, bool negative) {
  std::vector<std::string> letters;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if ((weights[i] < 0.0) == negative) letters.emplace_back(1, "uvwt"[i]);
  }
  return letters.empty() ? std::string() : and_list(letters);
}

/// The words of a lesson that shows beyond which faces Q lies: they name the signs.
void volumes(const Story& story, FrameText& text) {
  const BarycentricWeights::Value& of_q = story.effects.get<BarycentricWeights>(story.frame);
  const FacesBefore::Value& faces = story.effects.get<FacesBefore>(story.frame);
  const std::string whole = story.words.face(of_q.simplex.all());
  if (faces.empty()) {
    text.caption = fmt::format("All four weights are positive: {} lies inside {}.", story.q, whole);
    text.detail = "The four tetrahedra fill the whole, and their fractions add up to 1.";
    return;
  }
  std::vector<std::string> names;
  for (const gjk::Face face : faces) names.push_back(story.words.face(face));
  const bool is_one = faces.size() == 1;
  text.caption =
      fmt::format("{} {} negative: {} lies beyond the {} {}.", letters_of(of_q.weights, true),
                  is_one ? "is" : "are", story.q, is_one ? "face" : "faces", and_list(names));
  for (std::string& name : names) name = story.q + name;
  text.detail = fmt::format(
      "The {} of {} {} as negative, so u, v, w and t still add up to 1. The closest point {} {}.",
      is_one ? "volume" : "volumes", and_list(names), is_one ? "counts" : "count",
      gjk::vertex_count(story.state.region) == 1 ? "is" : "lies on",
      story.words.kind_and_face(story.state.region));
}

}  // namespace

void closest(const Story& story, FrameText& text) {
  if (story.shows(FacesBefore::kName)) return volumes(story, text);
  if (tells_areas(story)) return areas(story, text);
  if (tells_features(story)) return features(story, text);
  if (story.shows(UnitVector::kName) && story.state.simplex.count == 2) return line(story, text);
  if (story.shows(Projection::kName) && story.state.simplex.count == 2 && story.run.point_query() &&
      story.run.tour->sweeps) {
    return projection(story, text);
  }
  text.caption = region_reason(story);
  if (story.is_solid(story.state.region)) {
    text.detail = story.run.point_query()
                      ? fmt::format("Thus P = {}, and the distance is 0.", story.q)
                      : "Thus P = O and the distance is 0: the shapes overlap.";
    return;
  }
  if (story.knows.is_at_query) {
    text.detail = fmt::format("Thus {}, which is {}: the distance is 0.", story.p_is(), story.q);
    return;
  }
  text.detail = story.state.simplex.count == 1
                    ? fmt::format("Its distance from {} is {}.", story.q, story.distance())
                    : fmt::format("Thus {}, at distance {} from {}.", story.p_is(),
                                  story.distance(), story.q);
}

void region_test(const Story& story, FrameText& text) {
  const WideSimplex& simplex = story.state.simplex;
  if (story.knows.tests_reached < 0) {
    const std::string moved = story.moved();
    text.caption =
        moved.empty()
            ? fmt::format(
                  "Which Voronoi region holds {}? First compute its barycentric coordinates.",
                  story.q)
            : fmt::format("{} Which region holds it now? Compute its coordinates anew.", moved);
    if (simplex.count == 2) {
      const gjk::Barycentric<double, 2> weights =
          gjk::barycentric(in_plane(simplex), simplex.all());
      text.detail = fmt::format(
          "u = {} and v = {} are signed fractions of the length of {}. The first true test "
          "decides.",
          story.numbers.weight(weights.numerator[0] / weights.denominator),
          story.numbers.weight(weights.numerator[1] / weights.denominator),
          story.words.face(simplex.all()));
    } else if (simplex.count == 4) {
      text.detail =
          "They say on which side of each vertex, edge and face it lies. Each region has 3 or 4 "
          "conditions on their signs; the first region all of whose conditions hold decides.";
    } else {
      const std::string edge = story.words.face(0b011);
      text.detail = fmt::format(
          "u{0} and v{0} are the weights of {1} and {2} on the line {0}, and so on; u{3}, v{3} and "
          "w{3} are those in the triangle.",
          edge, story.words.vertex(0), story.words.vertex(1), story.words.face(0b111));
    }
    return;
  }
  const gjk::RegionTest<double>& test = story.knows.region_tests[story.knows.tests_reached];
  if (test.holds) {
    text.caption = region_reason(story);
    text.detail = story.is_solid(test.region)
                      ? "Thus P = " + story.q + ", and the distance is 0."
                      : fmt::format("Thus {}, at distance {} from {}.", story.p_is(),
                                    story.distance(), story.q);
    return;
  }
  const std::vector<gjk::RegionTerm<double>> terms = story.words.terms(test);
  const auto failed =
      std::find_if(terms.begin(), terms.end(), [](const auto& term) { return !term.holds; });
  const std::string coordinate = story.words.coordinate(failed->face, failed->vertex);
  text.caption =
      fmt::format("Not region {}: {} = {} is {}positive.", story.words.face(test.region),
                  coordinate, story.signed_weight(*failed), failed->wants_positive ? "not " : "");
  const gjk::RegionTest<double>& next = story.knows.region_tests[story.knows.tests_reached + 1];
  const bool is_left = next.region == simplex.all();
  text.detail = fmt::format(
      "{} {} region {}.", where(story, *failed),
      is_left ? "No test is left but the else:" : "Next test:", story.words.face(next.region));
}

}  // namespace gjkscope::captions
