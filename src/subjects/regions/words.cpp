#include <fmt/format.h>

#include <algorithm>

#include "picture/story.hpp"
#include "subjects/regions/region_orders.hpp"
#include "subjects/regions/subject.hpp"
#include "subjects/regions/tour.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope::captions {
namespace {

std::string feature(const Story& story, gjk::Face face) {
  return gjk::vertex_count(face) == 3 ? "the interior" : story.words.kind_and_face(face);
}

/// Vertices of positive weight: what the signs alone would take for the closest feature.
gjk::Face by_signs(const Story& story) {
  const std::vector<double>& weights = story.effects.get<BarycentricWeights>(story.frame).weights;
  gjk::Face face = 0;
  for (int i = 0; i < static_cast<int>(weights.size()); ++i) {
    if (weights[i] > 0.0) face = static_cast<gjk::Face>(face | gjk::face_of(i));
  }
  return face;
}

/// "w = −0.2 alone is negative", "u = −0.1 and w = −0.2 are negative".
std::string negatives(const Story& story) {
  const std::vector<double>& weights = story.effects.get<BarycentricWeights>(story.frame).weights;
  std::string out;
  int count = 0;
  for (int i = 0; i < static_cast<int>(weights.size()); ++i) {
    if (weights[i] > 0.0) continue;
    out += fmt::format("{}{} = {}", count > 0 ? " and " : "", "uvw"[i],
                       story.numbers.weight(weights[i]));
    ++count;
  }
  return count == 0 ? "no coordinate is negative"
                    : out + (count == 1 ? " is negative" : " are negative");
}

std::string edge_opposite(const Story& story, int vertex) {
  return story.words.face(
      static_cast<gjk::Face>(story.state.simplex.all() & ~gjk::face_of(vertex)));
}

void negative(const Story& story, FrameText& text, int i) {
  const std::string edge = edge_opposite(story, i);
  text.caption = fmt::format("{} is negative in the whole half-plane beyond {}.", "uvw"[i], edge);
  text.detail = fmt::format(
      "{}The Voronoi region of {} is only the part of it that projects onto {}.",
      i == 0 ? "A half-plane is all of the plane on one side of a line. " : "", edge, edge);
}

}  // namespace

void maps(const Story& story, FrameText& text) {
  const std::string region = feature(story, story.state.region);
  switch (*map_stage(story.run, story.frame)) {
    case MapStage::voronoi:
      text.caption =
          fmt::format("Voronoi map: a point's region names its closest feature. For {} it is {}.",
                      story.q, region);
      text.detail =
          "The map has seven regions: three vertices, three edges, the interior. Next: the signs "
          "of u, v and w.";
      return;
    case MapStage::interior:
      text.caption = "Sign map: u, v and w are all positive inside the triangle.";
      text.detail =
          "The lines extend the edges: on each of them one of u, v and w is 0. Next: where is u "
          "negative?";
      return;
    case MapStage::negative_u:
      return negative(story, text, 0);
    case MapStage::negative_v:
      return negative(story, text, 1);
    case MapStage::negative_w:
      return negative(story, text, 2);
    case MapStage::signs:
      text.caption = fmt::format("The half-planes overlap: beyond {}, v and w are both negative.",
                                 story.words.vertex(0));
      text.detail =
          "Three lines make seven parts again. One is inside; each other one stands for the edge "
          "or vertex that it touches.";
      return;
    case MapStage::asked:  // has the words of its question
    case MapStage::blended:
      text.caption = "Both maps at once: they agree inside the triangle, but not outside.";
      text.detail =
          "Voronoi borders (dashed) are perpendicular to the edges; sign borders extend the edges.";
      return;
    case MapStage::difference: {
      const gjk::Face face = by_signs(story);
      const bool agree = face == story.state.region;
      text.caption =
          agree ? fmt::format("At {}, {}. The signs name {}, and it is the closest feature.",
                              story.q, negatives(story), region)
                : fmt::format("At {}, {}. The signs name {}, but {} is closest.", story.q,
                              negatives(story), feature(story, face), region);
      text.detail =
          "The maps disagree in the marked parts. The signs in the triangle do not find the "
          "region; "
          "with the signs on each edge they do.";
      return;
    }
  }
}

void orders(const Story& story, FrameText& text) {
  const RegionOrders::Value& chains = story.effects.get<RegionOrders>(story.frame);
  if (chains.empty()) return;
  const OrderStage stage = *order_stage(story.run, story.frame);
  if (stage == OrderStage::numbers && story.frame.run > 0) {
    text.caption = story.moved() + " The triangle stays, and so do the tests.";
    text.detail =
        fmt::format("Only the coordinates of {} are computed anew. Next: vertices first.", story.q);
    return;
  }
  if (stage == OrderStage::numbers) {
    text.caption = fmt::format(
        "The coordinates of {} come first. The order of the tests is ours to choose.", story.q);
    text.detail = fmt::format(
        "A short edge test asks for the sign of one area: for {}, {} ≤ 0. Next: vertices first.",
        story.words.face(0b011), story.words.coordinate(story.state.simplex.all(), 2));
    return;
  }
  const RegionOrders::Chain& chain = chains[static_cast<std::size_t>(stage) - 1];
  const std::string region = feature(story, chain.region);
  const bool is_edge = gjk::vertex_count(chain.region) == 2;
  const std::string distance = story.numbers(chain.p.norm());
  const std::string taken = story.words.face(chain.region);
  if (chain.error > 0.0) {
    text.caption = fmt::format(
        "{} the short test of {} is true in the shaded half-plane: P′ is wrong by |P′ − P| = {}.",
        chain.order == gjk::RegionOrder::edges_first ? "Edges first:"
                                                     : "No vertex test is true, then",
        taken, story.numbers(chain.error));
    const bool off = std::any_of(chain.weights.begin(), chain.weights.end(),
                                 [](double weight) { return weight < 0.0; });
    if (stage == OrderStage::vertices_first_short)
      text.detail = fmt::format("P lies on {}, which {} projects onto. ",
                                feature(story, story.state.region), story.q);
    text.detail += fmt::format(
        "{} Next: {}.",
        off ? fmt::format("P′, the projection of {} onto the line {}, is not on the edge.", story.q,
                          taken)
            : fmt::format("P′ is on the wrong edge: it is {} from {}, and P is {}.", distance,
                          story.q, story.distance()),
        stage == OrderStage::vertices_first_short ? "the same tests, edges first" : "whole tests");
  } else if (stage == OrderStage::vertices_first_short) {
    text.caption =
        fmt::format("Vertices first: the first true test is that of {}, and it is right.", region);
    text.detail =
        fmt::format("P′ = P, at distance {}. {} Next: the same tests, edges first.", distance,
                    is_edge ? "The vertices are ruled out, and here the short test is enough."
                            : "The edges are not tested.");
  } else if (stage == OrderStage::edges_first_short) {
    text.caption = fmt::format(
        "Edges first: the short test of {} is true in the shaded half-plane, and here it is right.",
        taken);
    text.detail =
        fmt::format("{} projects onto the edge itself, so P′ = P. Next: whole tests.", story.q);
  } else if (story.frame.run == 0) {
    text.caption = fmt::format(
        "A whole test also asks whether {} projects onto the edge. Edges first, whole tests still "
        "give {}.",
        story.q, region);
    text.detail = fmt::format(
        "P′ = P, at distance {}. No two of these six tests are true at once, so any order works. "
        "The interior has no test of its own.",
        distance);
  } else {
    const RegionOrders::Chain& shorter = chains[static_cast<std::size_t>(stage) - 2];
    text.caption = shorter.error > 0.0
                       ? fmt::format("Edges first, whole tests refuse {} and take {}.",
                                     feature(story, shorter.region), region)
                       : fmt::format("Edges first, whole tests take {}, too: {} projects onto it.",
                                     region, story.q);
    text.detail = fmt::format("P′ = P, at distance {}.", distance);
  }
}

}  // namespace gjkscope::captions
