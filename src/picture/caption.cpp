#include "picture/caption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "picture/words.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector2d;
using fmt::format;

/// Writes the two sentences of one frame.
class Writer {
 public:
  Writer(const LessonRun& run, const Frame& frame)
      : run_(run),
        frame_(frame),
        positioned_(run.run(frame)),
        trace_(positioned_.trace),
        state_(run.state(frame)),
        numbers_(run.lesson),
        words_(run, state_.simplex),
        q_(query_name(run)) {}

  void write(FrameText& text) {
    if (run_.lesson.granularity == Granularity::pairs) return pairs(text);
    if (frame_.step < 0) return start(text);
    switch (run_.step(frame_).phase) {
      case gjk::Phase::closest:
        return run_.lesson.granularity == Granularity::test ? region_test(text) : closest(text);
      case gjk::Phase::cull:
        return cull(text);
      case gjk::Phase::direction:
        return direction(text);
      case gjk::Phase::support:
        return support(text);
      case gjk::Phase::stop:
        return stop(text);
      case gjk::Phase::add:
        return add(text);
    }
  }

  /// The values a lesson's prose can name and the sidecar file lists, in reading order.
  std::vector<std::pair<std::string, std::string>> values() const {
    std::vector<std::pair<std::string, std::string>> out;
    const auto put = [&](std::string name, std::string value) {
      out.emplace_back(std::move(name), std::move(value));
    };
    const gjk::Result<double, 2>& result = trace_.result;
    const bool running = frame_.step >= 0;
    put("x", run_.lesson.x.name);
    put("y", run_.lesson.y.name);
    put("iteration", std::to_string(running ? run_.step(frame_).iteration : 0));
    put("iterations", std::to_string(result.iterations));
    put("simplex", words_.face(state_.simplex.all()));
    if (run_.point_query()) put("Q", numbers_.point(positioned_.x_world[0]));
    if (knows_p()) {
      put("region", words_.face(state_.region));
      constexpr std::array<std::string_view, 3> kLetters = {"u", "v", "w"};
      for (int i = 0; i < state_.simplex.count; ++i)
        put(std::string(kLetters[i]), numbers_.weight(state_.simplex.weights[i]));
      put("P", numbers_.point(p_world()));
      put("distance", numbers_(std::sqrt(state_.p_sq)));
    }
    if (knows_direction()) put("d", numbers_.point(state_.d));
    if (knows_support()) put("support", run_.pair_name(state_.support.pair));
    if (running) {
      put("lower", numbers_(run_.bounds(frame_).lower));
      put("upper", numbers_(run_.bounds(frame_).upper));
    }
    if (running && run_.step(frame_).phase == gjk::Phase::stop && ended()) {
      put("stop", std::string(name_of(state_.stop)));
    }
    return out;
  }

 private:
  bool phase_is(gjk::Phase phase) const {
    return frame_.step >= 0 && run_.step(frame_).phase == phase;
  }
  bool ended() const { return state_.stop != gjk::StopReason::running; }
  bool knows_p() const {
    if (frame_.step < 0 || phase_is(gjk::Phase::add)) return false;
    if (run_.lesson.granularity != Granularity::test) return true;
    return frame_.detail >= 0 && region_tests()[frame_.detail].holds;
  }
  bool knows_direction() const { return phase_is(gjk::Phase::direction) || knows_support(); }
  bool knows_support() const {
    if (phase_is(gjk::Phase::support)) return true;
    return phase_is(gjk::Phase::stop) && trace_.steps[frame_.step - 1].phase == gjk::Phase::support;
  }
  const std::vector<gjk::RegionTest<double>>& region_tests() const {
    return run_.step(frame_).record.region_tests;
  }

  Vector2d p_world() const {
    return run_.point_query() ? Vector2d(state_.p + positioned_.x_world[0]) : state_.p;
  }
  std::string distance() const { return numbers_(std::sqrt(state_.p_sq)); }
  std::string set_name() const { return run_.point_query() ? run_.lesson.y.name : "Z"; }
  std::string simplex_name() const { return words_.kind_and_face(state_.simplex.all()); }
  std::string p_is() const {
    if (gjk::vertex_count(state_.region) == 3) return "P = " + q_;
    return "P = " + words_.combination(state_.region, numbers_);
  }

  void start(FrameText& text) const {
    if (state_.stop == gjk::StopReason::failed) {
      text.caption = format("The run is refused: {}.", name_of(state_.error));
      text.detail = "No distance is better than a wrong one.";
      return;
    }
    const int count = state_.simplex.count;
    if (run_.lesson.options.start_rule == gjk::StartRule::centre_to_centre) {
      text.caption =
          format("Start with {}: the vertex farthest along the line between the centres.",
                 words_.face(state_.simplex.all()));
    } else if (count == 1) {
      text.caption =
          format("Start with {}: any vertex will do.", words_.face(state_.simplex.all()));
    } else {
      text.caption = format("Start with the {}.", simplex_name());
    }
    text.detail =
        count == 1
            ? "The simplex is this one point. First question: which of its points is closest to " +
                  q_ + "?"
            : format("First question: which of its points is closest to {}?", q_);
  }

  std::string region_reason() const {
    const gjk::Face face = state_.region;
    const gjk::Simplex<double, 2>& simplex = state_.simplex;
    const gjk::RegionTest<double>* won = nullptr;
    for (const auto& test : region_tests()) {
      if (test.holds) won = &test;
    }
    if (simplex.count == 1)
      return format("The simplex is the single point {0}, so {0} is its closest point to {1}.",
                    words_.vertex(0), q_);
    if (!won)
      return format("Rounding left every test false; the nearest candidate is the {}.",
                    words_.kind_and_face(face));
    if (gjk::vertex_count(face) == 3)
      return format("{} lies inside {}: all three weights are positive.", q_, words_.face(face));
    if (gjk::vertex_count(face) == 1) {
      const std::string vertex = words_.face(face);
      if (simplex.count == 2) {
        const gjk::RegionTerm<double>& term = won->terms[0];
        return format("{} lies in the Voronoi region of {}: the weight of {} is {}, not positive.",
                      q_, vertex, words_.vertex(term.vertex), signed_weight(term));
      }
      return format("{} lies in the Voronoi region of {}: seen from {}, it lies behind both edges.",
                    q_, vertex, vertex);
    }
    if (simplex.count == 2)
      return format("{} lies in the Voronoi region of {}: both weights are positive.", q_,
                    edge_name(face));
    for (const gjk::RegionTerm<double>& term : won->terms) {
      if (term.wants_positive) continue;
      return format(
          "{} lies in the region of {}: {} has weight {} in the triangle, and {} projects onto the "
          "edge.",
          q_, edge_name(face), words_.vertex(term.vertex), signed_weight(term), q_);
    }
    return {};
  }

  std::string edge_name(gjk::Face face) const {
    return run_.point_query() ? words_.face(face) : "the " + words_.kind_and_face(face);
  }

  std::string signed_weight(const gjk::RegionTerm<double>& term) const {
    return numbers_.weight(term.denominator > 0.0 ? term.numerator / term.denominator : 0.0);
  }

  /// A lesson that shows the areas is told by them.
  bool tells_areas() const {
    if (state_.simplex.count != 3 || run_.lesson.granularity != Granularity::path) return false;
    const auto shows = [](const LessonView& view) {
      return std::find(view.effects.begin(), view.effects.end(), "barycentric-parts") !=
             view.effects.end();
    };
    return std::any_of(run_.lesson.views.begin(), run_.lesson.views.end(), shows);
  }

  void areas(FrameText& text) const {
    const gjk::Barycentric<double, 2> coordinates =
        gjk::barycentric(state_.simplex, state_.simplex.all());
    std::string areas;
    std::string edges;
    std::string list;
    int negative = 0;
    for (int i = 0; i < 3; ++i) {
      const double weight = coordinates.numerator[i] / coordinates.denominator;
      list += format("{}{} = {}", i > 0 ? ", " : "", "uvw"[i], numbers_.weight(weight));
      if (weight >= 0.0) continue;
      const std::string edge =
          words_.face(static_cast<gjk::Face>(state_.simplex.all() & ~gjk::face_of(i)));
      areas += (negative > 0 ? " and " : "") + q_ + edge;
      edges += (negative > 0 ? " and " : "") + edge;
      ++negative;
    }
    text.caption = negative == 0 ? format("All three areas are positive: {} lies inside.", q_)
                                 : format("The {} of {} {} negative: {} lies beyond {}.",
                                          negative == 1 ? "area" : "areas", areas,
                                          negative == 1 ? "is" : "are", q_, edges);
    text.detail = format("{}: they add up to 1 wherever {} stands.", list, q_);
  }

  void closest(FrameText& text) const {
    if (tells_areas()) return areas(text);
    text.caption = region_reason();
    if (gjk::vertex_count(state_.region) == 3) {
      text.detail = run_.point_query() ? format("So P = {}, and the distance is 0.", q_)
                                       : "So P = O and the distance is 0: the shapes overlap.";
      return;
    }
    text.detail = format("So {}, at distance {} from {}.", p_is(), distance(), q_);
  }

  void region_test(FrameText& text) const {
    const gjk::Simplex<double, 2>& simplex = state_.simplex;
    if (frame_.detail < 0) {
      text.caption =
          format("Which Voronoi region holds {}? First compute its barycentric coordinates.", q_);
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
    const gjk::RegionTest<double>& test = region_tests()[frame_.detail];
    if (test.holds) {
      text.caption = region_reason();
      text.detail = gjk::vertex_count(test.region) == 3
                        ? "So P = " + q_ + ", and the distance is 0."
                        : format("So {}, at distance {} from {}.", p_is(), distance(), q_);
      return;
    }
    const std::vector<gjk::RegionTerm<double>> terms = words_.terms(test);
    const auto failed =
        std::find_if(terms.begin(), terms.end(), [](const auto& term) { return !term.holds; });
    const std::string coordinate = words_.coordinate(failed->face, failed->vertex);
    text.caption =
        format("Not region {}: {} = {} is {}positive.", words_.face(test.region), coordinate,
               signed_fixed_weight(*failed), failed->wants_positive ? "not " : "");
    const gjk::RegionTest<double>& next = region_tests()[frame_.detail + 1];
    text.detail = format("{} Next test: region {}.", where(*failed), words_.face(next.region));
  }

  /// What the sign of one coordinate says about where Q is.
  std::string where(const gjk::RegionTerm<double>& term) const {
    if (gjk::vertex_count(term.face) == 3) {
      return term.wants_positive
                 ? format("{} lies beyond the edge opposite {}.", q_, words_.vertex(term.vertex))
                 : format("{} lies on the triangle's side of the edge opposite {}.", q_,
                          words_.vertex(term.vertex));
    }
    const std::string edge = words_.face(term.face);
    if (term.wants_positive) return format("Projected onto {}, {} falls beyond the end.", edge, q_);
    const gjk::Face other = static_cast<gjk::Face>(term.face & ~gjk::face_of(term.vertex));
    return format("Projected onto {}, {} falls on {}'s side of {}.", edge, q_,
                  words_.vertex(term.vertex), words_.face(other));
  }

  std::string signed_fixed_weight(const gjk::RegionTerm<double>& term) const {
    const double value = term.denominator > 0.0 ? term.numerator / term.denominator : 0.0;
    return run_.lesson.scalar == ScalarKind::double_ ? signed_fixed(value, 3)
                                                     : numbers_.weight(value);
  }

  void cull(FrameText& text) const {
    const std::vector<gjk::SupportPoint<double, 2>>& dropped = run_.step(frame_).record.dropped;
    const gjk::Phase next = trace_.steps[frame_.step + 1].phase;
    if (dropped.empty()) {
      if (state_.simplex.count == 1) {
        text.caption =
            format("Nothing to drop: the simplex is {} alone.", words_.face(state_.region));
      } else if (state_.simplex.count == 3) {
        text.caption = "Nothing is dropped: all three vertices have weight.";
      } else {
        text.caption = "Nothing is dropped: both vertices have weight in P.";
      }
    } else {
      std::string names;
      for (const auto& vertex : dropped)
        names += (names.empty() ? "" : " and ") + run_.pair_name(vertex.pair);
      text.caption =
          format("{} {} dropped: P lies on {}, so {} weight is 0.", names,
                 dropped.size() == 1 ? "is" : "are",
                 state_.simplex.count == 1 ? words_.face(state_.region) : edge_name(state_.region),
                 dropped.size() == 1 ? "its" : "their");
    }
    if (next == gjk::Phase::stop) {
      text.detail =
          state_.simplex.count == 3
              ? format(
                    "A triangle that contains {} cannot get closer: nothing is left to search for.",
                    q_)
              : "P came no nearer than before: nothing is left to search for.";
    } else {
      text.detail = format("Next: a direction d in which to look for a point closer to {}.", q_);
    }
  }

  void direction(FrameText& text) const {
    const gjk::DirectionNote<double, 2>& note = run_.step(frame_).record.direction;
    const std::string simplex = words_.face(state_.simplex.all());
    if (!(state_.d.norm() > 0.0)) {
      text.caption = format("d = 0: P is {} itself.", q_);
      text.detail = "There is no direction left to search in.";
    } else if (!note.from_normal) {
      text.caption =
          format("d points from P to {}: look for a vertex that lies farther that way.", q_);
      text.detail = format("d = {} − P = {}.", q_, numbers_.point(state_.d));
    } else {
      text.caption =
          note.sign_is_arbitrary
              ? format("d is perpendicular to {}; {} lies on its line, so either sign would do.",
                       edge_words(), q_)
              : format("d is perpendicular to {} and points to {}'s side.", edge_words(), q_);
      text.detail = format(
          "d = {} comes from the edge alone, without a division{}.", numbers_.point(state_.d),
          note.flipped ? format("; its sign was flipped, because dot(d, {} − {}) was negative", q_,
                                words_.vertex(0))
                       : "");
    }
  }

  std::string edge_words() const { return edge_name(state_.simplex.all()); }

  void support(FrameText& text) const {
    const gjk::VertexPair pair = state_.support.pair;
    const std::string name = run_.pair_name(pair);
    if (run_.point_query()) {
      const auto& scan = run_.step(frame_).record.scan_y;
      const auto farthest = std::find_if(scan.begin(), scan.end(),
                                         [&](const auto& entry) { return entry.index == pair.y; });
      const std::size_t count = run_.lesson.y.vertices.size();
      text.caption = format("{0} lies farthest along d: dot(d, {0}) = {1} is the {2}.", name,
                            numbers_(farthest->value),
                            count == 2 ? "larger of the two" : format("largest of all {}", count));
    } else {
      text.caption =
          format("{} lies farthest along d: {} is the support point of {}, {} that of {} along −d.",
                 name, run_.lesson.y.vertex_names[pair.y], run_.lesson.y.name,
                 run_.lesson.x.vertex_names[pair.x], run_.lesson.x.name);
    }
    const bool known = std::any_of(state_.simplex.vertices.begin(),
                                   state_.simplex.vertices.begin() + state_.simplex.count,
                                   [&](const auto& vertex) { return vertex.pair == pair; });
    text.detail =
        known ? format("It is in the simplex already: nothing of {} lies farther that way.",
                       set_name())
              : format("It is not in the simplex yet. Nothing of {} lies beyond the dashed line.",
                       set_name());
  }

  void stop(FrameText& text) const {
    const auto& [lower, upper] = run_.bounds(frame_);
    const std::string bounds =
        format("The distance lies between {} and {}.", numbers_(lower), numbers_(upper));
    const std::string support = run_.pair_name(state_.support.pair);
    const std::string final_distance =
        format("The distance is {}.", numbers_(trace_.result.distance));
    switch (state_.stop) {
      case gjk::StopReason::running:
        text.caption = format("Go on: {} is new, and lies farther along d than P does.", support);
        text.detail = lower > 0.0
                          ? bounds
                          : format("No line separates {} from {} yet, but P is at distance {}.", q_,
                                   set_name(), distance());
        return;
      case gjk::StopReason::repeated_support:
        text.caption =
            format("Stop: {} is in the simplex already, so nothing of {} lies closer to {}.",
                   support, set_name(), q_);
        text.detail = final_distance;
        if (lower > 0.0) {
          text.detail += format(
              " The dashed line proves it: it has all of {} on one side and {} on the other.",
              set_name(), q_);
        }
        return;
      case gjk::StopReason::origin_inside:
        text.caption =
            format("Stop: {} lies inside the triangle {}.", q_, words_.face(state_.simplex.all()));
        text.detail = "The distance is 0: the shapes overlap.";
        return;
      case gjk::StopReason::zero_direction:
        text.caption = format("Stop: d = 0, because P is {}.", q_);
        text.detail = "The distance is 0.";
        return;
      case gjk::StopReason::no_progress:
        text.caption =
            trace_.steps[frame_.step - 1].phase == gjk::Phase::cull
                ? format("Stop: P came no nearer to {} than it was an iteration ago.", q_)
                : format("Stop: nothing of {} lies farther along d than the simplex does.",
                         set_name());
        text.detail = final_distance;
        return;
      case gjk::StopReason::within_tolerance:
        text.caption = "Stop: the bounds are as close as was asked for.";
        text.detail = bounds;
        return;
      case gjk::StopReason::iteration_cap:
        text.caption =
            format("Stop: {} iterations are all that was allowed. This is no answer yet.",
                   state_.iteration);
        text.detail = bounds;
        return;
      case gjk::StopReason::failed:
        text.caption = format("The run is refused: {}.", name_of(state_.error));
        return;
    }
  }

  void add(FrameText& text) const {
    const int count = state_.simplex.count;
    text.caption = format("{} joins the simplex, which is now the {}.", words_.vertex(count - 1),
                          simplex_name());
    text.detail = format("Iteration {} asks again: which of its points is closest to {}?",
                         state_.iteration, q_);
  }

  void pairs(FrameText& text) const {
    const int per_x = static_cast<int>(positioned_.y_world.size());
    const int all = static_cast<int>(positioned_.x_world.size()) * per_x;
    const std::string& x = run_.lesson.x.name;
    const std::string& y = run_.lesson.y.name;
    if (frame_.detail == 0) {
      text.caption =
          format("Subtract every vertex of {} from every vertex of {}: {} × {} = {} differences.",
                 x, y, per_x, all / per_x, all);
      text.detail =
          "Each difference is a point of the right-hand view: the arrow from the vertex of X to "
          "the vertex of Y, moved to O.";
    } else if (frame_.detail <= all) {
      const gjk::VertexPair pair{(frame_.detail - 1) / per_x, (frame_.detail - 1) % per_x};
      const Vector2d a = positioned_.x_world[pair.x];
      const Vector2d b = positioned_.y_world[pair.y];
      text.caption = format("{} = {} − {} = {}.", run_.pair_name(pair), numbers_.point(b),
                            numbers_.point(a), numbers_.point(b - a));
      text.detail = format("Point {} of {}: the arrow from {} to {}, moved so that it starts at O.",
                           frame_.detail, all, run_.lesson.x.vertex_names[pair.x],
                           run_.lesson.y.vertex_names[pair.y]);
    } else {
      text.caption =
          format("The hull of the {} points is the Minkowski difference Z = {} − {}.", all, y, x);
      text.detail =
          trace_.result.distance > 0.0
              ? format("O lies outside, at distance {}: exactly the distance between {} and {}.",
                       numbers_(trace_.result.distance), x, y)
              : format("O lies inside: {} and {} overlap.", x, y);
    }
  }

  const LessonRun& run_;
  const Frame& frame_;
  const PositionedRun& positioned_;
  const WideTrace& trace_;
  const gjk::State<double, 2>& state_;
  Numbers numbers_;
  SimplexWords words_;
  std::string q_;
};

}  // namespace

FrameText frame_text(const LessonRun& run, const Frame& frame) {
  FrameText text;
  Writer writer(run, frame);
  writer.write(text);
  text.values = writer.values();
  text.phase = frame.step < 0 ? "start" : std::string(name_of(run.step(frame).phase));
  text.iteration = frame.step < 0 ? 0 : run.step(frame).iteration;
  text.prose = expand(run.lesson.prose,
                      std::map<std::string, std::string>(text.values.begin(), text.values.end()));
  return text;
}

}  // namespace gjkscope
