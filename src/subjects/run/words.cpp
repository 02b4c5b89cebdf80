#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "lesson/names.hpp"
#include "outlines/polygon.hpp"
#include "picture/story.hpp"
#include "run/trail.hpp"
#include "subjects/run/other_normal.hpp"
#include "subjects/run/refuting.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/run/trail_words.hpp"
#include "subjects/scalars/subject.hpp"
#include "subjects/support/slab.hpp"
#include "subjects/support/subject.hpp"
#include "subjects/support/touched_points.hpp"
#include "subjects/weights/barycentric.hpp"

namespace gjkscope::captions {

void start(const Story& story, FrameText& text) {
  if (story.state.stop == gjk::StopReason::failed) {
    text.caption = fmt::format("GJK refuses this query: {}.", name_of(story.state.error));
    text.detail = "It gives no distance rather than a wrong one.";
    return;
  }
  const int count = story.state.simplex.count;
  if (const std::string moved = story.moved(); !moved.empty()) {
    text.caption = fmt::format("{} GJK starts anew with the {}.", moved, story.simplex_name());
  } else if (story.run.lesson.options.start.count == 0) {
    text.caption =
        fmt::format("Start with {}, the vertex farthest along the line between the centers.",
                    story.words.face(story.state.simplex.all()));
  } else if (count == 1) {
    text.caption =
        fmt::format("Start with {}. Any {} will do.", story.words.face(story.state.simplex.all()),
                    story.run.point_query() ? "vertex" : "difference");
  } else {
    text.caption = fmt::format("Start with the {} as the simplex S.", story.simplex_name());
  }
  text.detail =
      count == 1
          ? fmt::format(
                "The simplex S is this one point. First: which point of S is closest to {}?",
                story.q)
          : fmt::format("Any vertices will do. First: which point of S is closest to {}?", story.q);
}

void drop(const Story& story, FrameText& text) {
  const std::vector<WideVertex>& dropped = story.run.step(story.frame).record.dropped;
  const gjk::Phase next = story.trace.steps[story.frame.step + 1].phase;
  if (dropped.empty()) {
    if (story.state.simplex.count == 1) {
      text.caption = fmt::format("There is nothing to drop: S is the single vertex {}.",
                                 story.words.face(story.state.region));
    } else if (story.state.simplex.count > 2) {
      text.caption = fmt::format("S keeps all {} vertices: each has a positive weight.",
                                 story.state.simplex.count == 3 ? "three" : "four");
    } else {
      text.caption = "S keeps both vertices: each has a positive weight in P.";
    }
  } else {
    std::string names;
    for (const auto& vertex : dropped)
      names += (names.empty() ? "" : " and ") + story.run.pair_name(vertex.pair);
    const std::string feature = story.state.simplex.count == 1
                                    ? story.words.face(story.state.region)
                                    : story.edge_name(story.state.region);
    const std::string_view lies = story.state.simplex.count == 1 ? "is" : "lies on";
    text.caption = dropped.size() == 1
                       ? fmt::format("{0} is dropped: P {2} {1}, so the weight of {0} is 0.", names,
                                     feature, lies)
                       : fmt::format("{0} are dropped: P {2} {1}, so the weights of {0} are 0.",
                                     names, feature, lies);
  }
  if (next == gjk::Phase::stop) {
    text.detail =
        story.is_solid(story.state.simplex.all())
            ? fmt::format("P = {}: no point is closer. The search is over.", story.q)
        : story.knows.is_at_query && !dropped.empty()
            ? fmt::format("P = {}, as before {} was added. No point is closer than distance 0.",
                          story.q, story.run.pair_name(dropped[0].pair))
            : "P is no closer than in the last iteration. The search is over.";
  } else if (story.knows.is_at_query) {
    text.detail = fmt::format(
        "P = {} already, but GJK has not checked. Next: a search direction d.", story.q);
  } else {
    text.detail = fmt::format("Next: a search direction d, towards points closer to {}.", story.q);
  }
}

namespace {

/// "(L−D)", or a vertex of a point query: "B".
std::string factor(const Story& story, int i) {
  const std::string name = story.words.vertex(i);
  return story.run.point_query() ? name : fmt::format("({})", name);
}

void direction_in_space(const Story& story, const WideDirection& note, FrameText& text) {
  const std::string d = story.numbers.point(story.state.d);
  const std::string a = factor(story, 0);
  if (story.state.simplex.count == 2) {
    text.caption =
        fmt::format("d is perpendicular to {} and points to {}.", story.edge_words(), story.q);
    text.detail = fmt::format(
        "d = {} is cross(e, cross(e, {} − {})), where e = {} − {}: it needs neither P "
        "nor a division.",
        d, a, story.q, factor(story, 1), a);
    return;
  }
  const std::string face = story.words.kind_and_face(story.state.simplex.all());
  text.caption =
      note.sign_is_arbitrary
          ? fmt::format(
                "d is perpendicular to the {}. {} lies in its plane, so either sign will "
                "do.",
                face, story.q)
          : fmt::format("d is perpendicular to the {} and points to {}'s side.", face, story.q);
  text.detail = fmt::format(
      "d = {} is the normal cross({} − {}, {} − {}){}.", d, factor(story, 1), a, factor(story, 2),
      a, note.flipped ? fmt::format(", with the other sign: {}'s side is there", story.q) : "");
}

}  // namespace

void direction(const Story& story, FrameText& text) {
  const WideDirection& note = story.run.step(story.frame).record.direction;
  if (story.run.lesson.dimension == 3 && story.state.simplex.count > 1 &&
      story.state.d.norm() > 0.0)
    return direction_in_space(story, note, text);
  if (!(story.state.d.norm() > 0.0)) {
    text.caption = fmt::format("d = 0, because P = {}.", story.q);
    text.detail = "No direction is left to search in.";
  } else if (!note.from_normal) {
    text.caption =
        fmt::format("d points from P to {}. Next: which vertex lies farthest that way?", story.q);
    text.detail = fmt::format("d = {} − P = {}. The arrow shows its direction, not its length.",
                              story.q, story.numbers.point(story.state.d));
  } else {
    const auto vertex = [&](int i) {
      const std::string name = story.words.vertex(i);
      return story.run.point_query() ? name : fmt::format("({})", name);  // "(L−D)"
    };
    const std::string d = story.numbers.point(story.state.d);
    const std::string edge = fmt::format("{} − {}", vertex(1), vertex(0));
    if (note.sign_is_arbitrary) {
      text.caption =
          fmt::format("d is perpendicular to {}. {} lies on its line, so either sign will do.",
                      story.edge_words(), story.q);
    } else {
      text.caption = fmt::format("d is perpendicular to {} and points to {}'s side.",
                                 story.edge_words(), story.q);
    }
    const std::string turned = fmt::format("{} turned clockwise by 90°", edge);
    if (story.knows.is_at_query) {
      text.detail =
          fmt::format("{} − P = 0, but d = {} is {}. Thus the test d = 0 does not stop GJK.",
                      story.q, d, turned);
    } else if (note.flipped) {
      text.detail = fmt::format("{} is {}. Its dot product with {} − {} is negative, so d = {}.",
                                turned, story.numbers.point(note.normal), story.q, vertex(0), d);
    } else {
      text.detail = fmt::format("d = {} is {}. It needs neither P nor a division.", d, turned);
    }
  }
}

namespace {

/// "B, C and D" where several vertices of Y lie equally far along d, else nothing.
std::string tied(const Story& story, const std::vector<gjk::ScanEntry<double>>& scan,
                 double largest) {
  std::vector<std::string> names;
  for (const auto& entry : scan) {
    if (entry.value == largest) {
      names.push_back(story.run.lesson.y().vertex_names[entry.index]);
    }
  }
  return names.size() < 2 ? std::string() : and_list(std::move(names));
}

/// " D of X lies as far." where other vertices of a shape lie as far along its direction as the one
/// that was kept, else nothing.
std::string also_as_far(const LessonShape& shape, const std::vector<gjk::ScanEntry<double>>& scan,
                        int kept) {
  const auto of_kept = std::find_if(scan.begin(), scan.end(),
                                    [&](const auto& entry) { return entry.index == kept; });
  if (of_kept == scan.end()) return {};
  constexpr double kSame = 1e-12;  // of the value: far less than frames show
  std::vector<std::string> names;
  for (const auto& entry : scan) {
    if (entry.index != kept &&
        std::abs(entry.value - of_kept->value) <= kSame * std::abs(of_kept->value))
      names.push_back(shape.vertex_names[entry.index]);
  }
  if (names.empty()) return {};
  const bool is_one = names.size() == 1;
  return fmt::format(" In {}, {} lie{} as far as {}.", shape.name, and_list(std::move(names)),
                     is_one ? "s" : "", shape.vertex_names[kept]);
}

/// Says how a support point that is not in the simplex relates to it.
std::string news(const Story& story, const std::string& name) {
  const auto& steps = story.trace.steps;
  const auto is_it = [&](const auto& vertex) { return vertex.pair == story.state.support.pair; };
  const bool was_dropped =
      std::any_of(steps.begin(), steps.begin() + story.frame.step, [&](const auto& step) {
        return std::any_of(step.record.dropped.begin(), step.record.dropped.end(), is_it);
      });
  const auto next = static_cast<std::size_t>(story.frame.step) + 1;
  if (was_dropped && steps[next].after.stop == gjk::StopReason::no_progress) {
    return fmt::format(
        "{} is not in the simplex: it was dropped. But it lies no farther along d than {}.", name,
        story.edge_words());
  }
  return fmt::format("{} is {}. No point of {} lies beyond the dashed {}.", name,
                     was_dropped ? "no longer in the simplex" : "not in the simplex yet",
                     story.set_name(), story.plane());
}

/// "The distance is 1.2", or, where scalars are compared, "In float the distance is 1.2".
std::string distance_is(const Story& story, const std::string& distance) {
  return story.run.lesson.has_block(blocks::kScalars.name)
             ? fmt::format("In {} the distance is {}", name_of(story.run.lesson.scalar), distance)
             : "The distance is " + distance;
}

std::string zero_distance(const Story& story) {
  const gjk::Face all = story.state.simplex.all();
  const std::string answer = distance_is(story, "0");
  if (gjk::vertex_count(all) == 1)
    return fmt::format("{}: {} is the vertex {}.", answer, story.q, story.words.face(all));
  return fmt::format("{}: {} lies on {}.", answer, story.q, story.edge_name(all));
}

/// How the run ends: the distance, and between which features.
std::string outcome(const Story& story) {
  if (story.knows.is_at_query) return zero_distance(story);
  const std::string answer = distance_is(story, story.numbers(story.trace.result.distance));
  if (!story.run.point_query())
    return fmt::format("{}, between {}.", answer, story.closest_features());
  const gjk::Face all = story.state.simplex.all();
  return fmt::format("{}: P {} the {}.", answer, gjk::vertex_count(all) == 1 ? "is" : "lies on",
                     story.words.kind_and_face(all));
}

/// How much farther along d the support point lies than P: a length.
double farther_than_p(const Story& story) {
  const WideState& state = story.state;
  return state.d.dot(state.support.w - state.p) / state.d.norm();
}

/// Bounds the distance from below by the best support line so far, and from above by P.
std::string proved(const Story& story) {
  const BestSupport::Value& best = story.effects.get<BestSupport>(story.frame);
  const bool is_new = best && is_found_by(*best, story.state);
  return fmt::format("All of {} lies behind the {} {}, at least {} from {}. P is {} from {}.",
                     story.set_name(), is_new ? "dashed" : "thin", story.plane(),
                     story.numbers(story.run.bounds(story.frame).lower), story.q, story.distance(),
                     story.q);
}

/// Z, or the polygon of a point query: its hull where it is not convex, since GJK sees no more.
std::string convex_set(const Story& story) {
  const bool is_hull = story.run.point_query() && story.run.lesson.dimension == 2 &&
                       differs_from_hull(in_plane(story.run.lesson.y().vertices));
  return is_hull ? "the hull of " + story.set_name() : story.set_name();
}

}  // namespace

void support(const Story& story, FrameText& text) {
  const gjk::VertexPair pair = story.state.support.pair;
  const std::string name = story.run.pair_name(pair);
  if (story.run.point_query()) {
    const auto& scan = story.run.step(story.frame).record.scan_y;
    const auto farthest = std::find_if(scan.begin(), scan.end(),
                                       [&](const auto& entry) { return entry.index == pair.y; });
    const std::size_t count = story.run.lesson.y().vertices.size();
    const std::string all = tied(story, scan, farthest->value);
    text.caption =
        all.empty()
            ? fmt::format(
                  "{0} lies farthest along d: dot(d, {0}) = {1} is the {2}.", name,
                  story.numbers(farthest->value),
                  count == 2 ? "larger of the two" : fmt::format("largest of all {}", count))
            : fmt::format(
                  "{0} lie equally far along d: each dot product is {1}. GJK keeps {2}, the "
                  "first it saw.",
                  all, story.numbers(farthest->value), name);
  } else {
    text.caption = fmt::format(
        "{} lies farthest along d: {} is {}'s farthest vertex along d, {} is {}'s along −d.", name,
        story.run.lesson.y().vertex_names[pair.y], story.run.lesson.y().name,
        story.run.lesson.x().vertex_names[pair.x], story.run.lesson.x().name);
  }
  const bool known = has_pair(story.state.simplex, pair);
  text.detail =
      known ? fmt::format("{} is already in the simplex: no point of {} lies farther along d.",
                          name, story.set_name())
            : news(story, name);
  if (story.shows(OtherNormal::kName)) {
    if (const OtherNormal::Value& other = story.effects.get<OtherNormal>(story.frame)) {
      const std::string found = story.run.pair_name(other->support);
      text.detail = fmt::format("−d finds {}. {}", found,
                                known && other->in_simplex ? "Both are in the simplex."
                                : known || other->in_simplex
                                    ? fmt::format("{} is in the simplex now, {} is not.",
                                                  known ? name : found, known ? found : name)
                                    : "Neither is in the simplex now.");
    }
  }
  if (story.run.point_query()) return;
  const WideRecord& record = story.run.step(story.frame).record;
  text.detail += also_as_far(story.run.lesson.y(), record.scan_y, pair.y);
  text.detail += also_as_far(story.run.lesson.x(), record.scan_x, pair.x);
}

void stop(const Story& story, FrameText& text) {
  const auto& [lower, upper] = story.run.bounds(story.frame);
  const std::string bounds = fmt::format("The distance lies between {} and {}.",
                                         story.numbers(lower), story.numbers(upper));
  const std::string support = story.run.pair_name(story.state.support.pair);
  switch (story.state.stop) {
    case gjk::StopReason::running:
      text.caption = fmt::format("Go on: {} is not in the simplex, and lies {} beyond P along d.",
                                 support, story.numbers(farther_than_p(story)));
      text.detail =
          story.knows.is_at_query
              ? fmt::format("P = {} already, at distance 0, but no test of this step asks that.",
                            story.q)
          : lower > 0.0
              ? proved(story)
              : fmt::format("No {} found so far separates {} from {}. P is {} from {}.",
                            story.plane(), story.q, story.set_name(), story.distance(), story.q);
      return;
    case gjk::StopReason::repeated_support:
      text.caption =
          story.knows.is_at_query
              ? fmt::format(
                    "Stop: {} is already in the simplex, so no point of {} lies farther along d.",
                    support, story.set_name())
              : fmt::format(
                    "Stop: {} is already in the simplex, so no point of {} is closer to {}.",
                    support, convex_set(story), story.q);
      text.detail = outcome(story);
      if (lower > 0.0 && !refutes(story.run, story.frame)) {
        text.detail +=
            fmt::format(" All of {} lies behind the dashed {}.", story.set_name(), story.plane());
      }
      return;
    case gjk::StopReason::origin_inside:
      text.caption = fmt::format("Stop: {} lies inside the {}.", story.q, story.simplex_name());
      text.detail =
          story.run.point_query()
              ? fmt::format("Thus {} lies in {}: the distance is 0.", story.q, convex_set(story))
              : fmt::format("Thus {} and {} overlap: the distance is 0.", story.run.lesson.x().name,
                            story.run.lesson.y().name);
      return;
    case gjk::StopReason::zero_direction:
      text.caption = fmt::format("Stop: d = 0, because P = {}.", story.q);
      text.detail = zero_distance(story);
      return;
    case gjk::StopReason::not_nearer:
      text.caption = fmt::format("Stop: P is no closer to {} than in the last iteration.", story.q);
      text.detail = outcome(story);
      return;
    case gjk::StopReason::no_progress:
      text.caption = fmt::format("Stop: no point of {} lies farther along d than the simplex.",
                                 story.set_name());
      text.detail = outcome(story);
      return;
    case gjk::StopReason::within_tolerance:
      text.caption = "Stop: the bounds are as close as the lesson asks.";
      text.detail = bounds;
      return;
    case gjk::StopReason::iteration_cap:
      text.caption = fmt::format("Stop: GJK has used all {} iterations. P is not the answer yet.",
                                 story.state.iteration);
      text.detail = bounds;
      return;
    case gjk::StopReason::failed:
      text.caption = fmt::format("GJK refuses this query: {}.", name_of(story.state.error));
      return;
  }
}

void add(const Story& story, FrameText& text) {
  const int count = story.state.simplex.count;
  text.caption = fmt::format("{} joins the simplex, which is now the {}.",
                             story.words.vertex(count - 1), story.simplex_name());
  text.detail = fmt::format("Iteration {} asks again: which point of S is closest to {}?",
                            story.state.iteration, story.q);
}

namespace {

/// Why a run ended, after "because".
std::string why_ended(const Story& story) {
  switch (story.state.stop) {
    case gjk::StopReason::repeated_support:
      return fmt::format("{} was in S already", story.run.pair_name(story.state.support.pair));
    case gjk::StopReason::origin_inside:
      return fmt::format("{} lies inside the {}", story.q, story.simplex_name());
    case gjk::StopReason::zero_direction:
      return fmt::format("P = {}, so that d = 0", story.q);
    case gjk::StopReason::not_nearer:
      return "P came no closer than in the iteration before";
    case gjk::StopReason::no_progress:
      return fmt::format("no point of {} lies farther along d than S", story.set_name());
    case gjk::StopReason::within_tolerance:
      return "the bounds were as close as the lesson asks";
    default:
      return "it had no more iterations";
  }
}

}  // namespace

void trail(const Story& story, FrameText& text) {
  const int iterations = story.trace.result.iterations;
  const std::string in = story.run.lesson.has_block(blocks::kScalars.name)
                             ? fmt::format("In {} ", name_of(story.run.lesson.scalar))
                             : std::string();
  text.caption = fmt::format("{}GJK took {} iterations, and stopped because {}.", in, iterations,
                             why_ended(story));
  std::vector<double> lengths;
  for (const WideStep& step : story.trace.steps) {
    if (step.phase == gjk::Phase::closest) lengths.push_back(std::sqrt(step.after.p_sq));
  }
  const auto number = [&](double value) {
    std::string digits = story.numbers(value);
    return digits == story.numbers(0.0) ? std::string("0") : digits;
  };
  const std::string first = number(lengths.front());
  const std::string last = number(lengths.back());
  const bool is_nearer =
      std::adjacent_find(lengths.begin(), lengths.end(), std::less_equal<>()) == lengths.end();
  if (first == "0" && last == "0") {
    text.detail = fmt::format("P = {} all along.", story.q);
  } else if (is_nearer) {
    text.detail =
        fmt::format("Each iteration brings P closer to {}, from {} to {}.", story.q, first, last);
  } else {
    text.detail = fmt::format("P is {} from {} at first, and {} at last.", first, story.q, last);
  }
  const auto& [lower, upper] = story.run.bounds(story.frame);
  const std::string low = number(lower);
  const std::string high = number(upper);
  text.detail += low == high
                     ? fmt::format(" The distance is at most and at least {}: it is proved.", low)
                     : fmt::format(" The distance is proved to lie between {} and {}.", low, high);
  const int shown = static_cast<int>(kMostInTrail);
  if (iterations > shown)
    text.detail += fmt::format(" Iterations {} to {} are left out.", shown, iterations - 1);
}

namespace {

/// The words of a lesson that shows the slab: they say what each phase proves.
bool tells_slab(const Story& story) {
  const bool proves = story.knows.phase_is(gjk::Phase::closest) ||
                      story.knows.phase_is(gjk::Phase::support) ||
                      (story.knows.phase_is(gjk::Phase::stop) && story.knows.support);
  return proves && story.shows(Slab::kName);
}

}  // namespace

void step(const Story& story, FrameText& text) {
  if (tells_slab(story)) return slab(story, text);
  switch (story.run.step(story.frame).phase) {
    case gjk::Phase::closest:
      return story.knows.gradual ? region_test(story, text) : closest(story, text);
    case gjk::Phase::drop:
      return drop(story, text);
    case gjk::Phase::direction:
      return direction(story, text);
    case gjk::Phase::support:
      return support(story, text);
    case gjk::Phase::stop:
      stop(story, text);
      if (story.knows.has_ended && story.shows(TouchedPoints::kName)) touched_points(story, text);
      return;
    case gjk::Phase::add:
      return add(story, text);
  }
}

namespace {

/// u, v and w of the query point, signed, as long as the simplex is the one that they are about;
/// and the weights of P, none of them negative. Both in the order of "simplex".
void put_weights(const Story& story, FrameText& text) {
  const WideSimplex& simplex = story.state.simplex;
  const BarycentricWeights::Value& of_q = story.effects.get<BarycentricWeights>(story.frame);
  const std::vector<int> order = story.words.order(simplex.all());
  const bool measures = simplex.count > 1 && of_q.simplex.count == simplex.count &&
                        of_q.weights.size() == order.size();
  std::string of_p;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(order[i]);
    if (measures)
      text.values.emplace_back(std::string(1, "uvwt"[i]),
                               story.numbers.weight(of_q.weights[vertex]));
    of_p +=
        fmt::format("{}{} {}", of_p.empty() ? "" : ", ",
                    story.numbers.weight(simplex.weights[vertex]), story.words.vertex(order[i]));
  }
  text.values.emplace_back("weights", of_p);
}

}  // namespace

void run_values(const Story& story, FrameText& text) {
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  const WideResult& result = story.trace.result;
  const bool running = story.run.gjk_step(story.frame) >= 0;
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  const int iteration = story.frame.question >= 0 ? story.run.answering_iteration(story.frame)
                        : running                 ? story.run.step(story.frame).iteration
                                                  : 0;
  put("iteration", std::to_string(iteration));
  put("iterations", std::to_string(result.iterations));
  put("simplex", story.words.face(story.state.simplex.all()));
  if (story.run.point_query()) put("Q", story.numbers.point(story.positioned.x().world[0]));
  if (story.knows.closest_point) {
    put("region", story.words.face(story.state.region));
    put_weights(story, text);
    put("P", story.numbers.point(story.p_world()));
    put("distance", story.numbers(std::sqrt(story.state.p_sq)));
  }
  if (story.knows.direction) put("d", story.numbers.point(story.state.d));
  if (story.knows.support) put("support", story.run.pair_name(story.state.support.pair));
  if (running) {
    put("lower", story.numbers(story.run.bounds(story.frame).lower));
    put("upper", story.numbers(story.run.bounds(story.frame).upper));
  }
  if (story.knows.phase_is(gjk::Phase::stop) && story.knows.has_ended) {
    put("stop", std::string(name_of(story.state.stop)));
    if (result.settled) put("bounds by", "exact arithmetic");
  }
}

}  // namespace gjkscope::captions
