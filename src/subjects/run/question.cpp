#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "gjk/regions.hpp"
#include "outlines/minkowski.hpp"
#include "outlines/polygon.hpp"
#include "outlines/polyhedron.hpp"
#include "picture/story.hpp"
#include "run/questions.hpp"
#include "subjects/run/direction_rules.hpp"
#include "subjects/run/refuting.hpp"
#include "subjects/run/subject.hpp"
#include "subjects/weights/projection.hpp"

namespace gjkscope::captions {
namespace {

/// Vertices of a large shape to choose from: this many, evenly spaced, and the right one.
constexpr int kMostVertices = 8;

std::vector<std::string> some_vertices(const LessonShape& shape, int right) {
  const int count = static_cast<int>(shape.vertex_names.size());
  const int stride = (count + kMostVertices - 1) / kMostVertices;
  std::vector<std::string> names;
  for (int i = right % stride; i < count; i += stride) names.push_back(shape.vertex_names[i]);
  return names;
}

/// One question, as a frame puts it.
class Asking {
 public:
  Asking(const Story& story, FrameText& text)
      : story_(story),
        text_(text),
        run_(story.run),
        step_(story.trace.steps[story.frame.answering_step]),
        before_(state_before(story.trace, story.frame.answering_step)),
        words_(run_, before_.simplex),
        asked_(*text.question) {}

  void support() {
    const gjk::VertexPair pair = step_.after.support.pair;
    const LessonShape& x = run_.lesson.x();
    const LessonShape& y = run_.lesson.y();
    asked_.choices = some_vertices(y, pair.y);
    asked_.answer = run_.pair_name(pair);
    const std::string d =
        story_.knows.direction ? "d" : "d = " + story_.numbers.point(step_.after.d);
    if (run_.point_query()) {
      text_.caption =
          fmt::format("Question: which vertex of {} lies farthest along {}?", story_.set_name(), d);
      return;
    }
    const std::vector<std::string> of_x = some_vertices(x, pair.x);
    text_.caption = fmt::format(
        "Question: which vertex of {} lies farthest along {}, and which vertex of {} along −d?",
        y.name, d, x.name);
    text_.detail = fmt::format("{}: {}      {}: {}", y.name, listed_choices(asked_.choices), x.name,
                               listed_choices(of_x));
    std::vector<std::string> pairs;
    for (const std::string& of_y : asked_.choices) {
      for (const std::string& name : of_x) pairs.push_back(fmt::format("{}−{}", of_y, name));
    }
    asked_.pair = {{y.name, std::move(asked_.choices)}, {x.name, of_x}};
    asked_.choices = std::move(pairs);
  }

  void region() {
    const gjk::FaceList order =
        gjk::tested_faces(before_.simplex.count, run_.lesson.options.region_order);
    // Those that the frame does not rule out.
    const bool gradual = story_.knows.gradual;
    for (int i = gradual ? story_.knows.tests_reached + 1 : 0; i < order.count; ++i)
      asked_.choices.push_back(words_.face(order[i]));
    // In the order of the tests the first one left would be the answer.
    if (gradual || run_.tour->asking != nullptr)
      std::sort(asked_.choices.begin(), asked_.choices.end());
    asked_.answer = words_.face(step_.after.region);
    text_.caption = fmt::format(
        "Question: which Voronoi region of {} holds {}?",
        run_.point_query() ? words_.face(before_.simplex.all()) : "the simplex", story_.q);
  }

  void dropped() {
    const auto& dropped = next_step().record.dropped;
    asked_.choices = {"none"};
    for (int i = 0; i < before_.simplex.count; ++i) asked_.choices.push_back(words_.vertex(i));
    // The order in which they joined would tell the oldest.
    std::sort(asked_.choices.begin() + 1, asked_.choices.end());
    if (before_.simplex.count > 2) asked_.choices.emplace_back("two of them");
    asked_.answer = dropped.empty()       ? "none"
                    : dropped.size() == 1 ? run_.pair_name(dropped[0].pair)
                                          : "two of them";
    text_.caption =
        fmt::format("Question: which vertex of the {} has no weight in P, so that GJK drops it?",
                    before_.simplex.count == 2   ? "segment"
                    : before_.simplex.count == 3 ? "triangle"
                                                 : "tetrahedron");
  }

  void stop() {
    asked_.choices = stop_tests(run_);
    asked_.choices.insert(asked_.choices.begin(), "no");
    asked_.answer =
        stop_test(run_, {.run = story_.frame.run, .step = story_.frame.answering_step + 1});
    if (std::find(asked_.choices.begin(), asked_.choices.end(), asked_.answer) ==
        asked_.choices.end())
      asked_.choices.push_back(asked_.answer);
    text_.caption =
        "Question: will GJK stop in this iteration, and by which test? V is the support point.";
  }

  void why() {
    const WideState& end = step_.after;
    const std::string& q = story_.q;
    asked_.answer = true_reason(end.stop);
    // Reasons that students give, and what the run says against them.
    std::vector<std::pair<std::string, std::string>> wrong;
    if (end.p_sq > 0.0)
      wrong.emplace_back(
          fmt::format("P has reached {}", q),
          fmt::format("P is still {} from {}.", story_.numbers(std::sqrt(end.p_sq)), q));
    const std::string which =
        run_.point_query() ? "vertices of " + story_.set_name() : std::string("differences y − x");
    const std::size_t all = run_.lesson.x().vertices.size() * run_.lesson.y().vertices.size();
    if (const std::size_t tried = vertices_of_run(); tried < all)
      wrong.emplace_back(fmt::format("all {} have been in S", which),
                         fmt::format("S has had {} of {} {}.", tried, all, which));
    if (end.simplex.count > 1)
      wrong.emplace_back("P is a vertex of S",
                         fmt::format("P has weight on {} vertices.", end.simplex.count));
    if (end.stop != gjk::StopReason::origin_inside)
      wrong.emplace_back(
          fmt::format("{} lies inside S", q),
          fmt::format("S has too few vertices for an inside: {}.", end.simplex.count));
    constexpr std::size_t kWrong = 2;
    wrong.resize(std::min(wrong.size(), kWrong));
    for (const auto& [reason, fact] : wrong) {
      asked_.choices.push_back(reason);
      asked_.refuted += (asked_.refuted.empty() ? "" : " ") + fact;
    }
    const auto place = static_cast<std::ptrdiff_t>(step_.iteration) %
                       static_cast<std::ptrdiff_t>(asked_.choices.size() + 1);
    asked_.choices.insert(asked_.choices.begin() + place, asked_.answer);
    text_.caption = "Question: GJK stops here. Why?";
  }

  void closest() {
    const gjk::FaceList faces =
        gjk::tested_faces(before_.simplex.count, gjk::RegionOrder::vertices_first);
    for (int i = 0; i < faces.count; ++i) add_face(faces[i]);
    asked_.answer = words_.face(step_.after.region);
    asked_.place = world(in_plane(step_.after.p));
    text_.caption = fmt::format("Question: where is P, the point of {} closest to {}? Point at it.",
                                words_.face(before_.simplex.all()), story_.q);
  }

  void sign() {
    const WideSimplex& simplex = before_.simplex;
    if (run_.lesson.dimension == 3) return sign_in_space(simplex);
    const gjk::Barycentric<double, 2> weights = gjk::barycentric(in_plane(simplex), simplex.all());
    constexpr std::array<std::string_view, 3> kLetters = {"u", "v", "w"};
    asked_.choices = {"none"};
    asked_.spots = {std::nullopt};
    int negative = 0;
    asked_.answer = "none";
    for (int i = 0; i < simplex.count; ++i) {
      const int a = (i + 1) % simplex.count;
      const int b = simplex.count == 2 ? a : (i + 2) % simplex.count;
      asked_.choices.emplace_back(kLetters[i]);
      asked_.spots.push_back(Spot{ViewKind::world, at_vertex(a), at_vertex(b)});
      if (weights.numerator[i] < 0.0 && ++negative == 1) asked_.answer = asked_.choices.back();
    }
    if (simplex.count == 3) {
      asked_.choices.emplace_back("two of them");
      asked_.spots.emplace_back();
    }
    if (negative > 1) asked_.answer = asked_.choices.back();
    text_.caption =
        simplex.count == 2
            ? fmt::format(
                  "Question: is u, the weight of {}, or v, that of {}, negative? Point at the end "
                  "that {} lies beyond.",
                  words_.vertex(0), words_.vertex(1), story_.q)
            : fmt::format(
                  "Question: which of u, v and w is negative? Point at the edge that {} lies "
                  "beyond.",
                  story_.q);
  }

  /// The faces of a tetrahedron, each opposite to the vertex of a weight.
  void sign_in_space(const WideSimplex& simplex) {
    const gjk::Barycentric<double, 3> weights = gjk::barycentric(simplex, simplex.all());
    const auto at = [&](int i) { return story_.positioned.y().world[simplex.vertices[i].pair.y]; };
    asked_.choices = {"none"};
    asked_.spots = {std::nullopt};
    int negative = 0;
    for (int left_out = simplex.count - 1; left_out >= 0; --left_out) {
      const auto face = static_cast<gjk::Face>(simplex.all() & ~(1u << left_out));
      std::array<Eigen::Vector3d, 3> corners;
      for (int i = 0, k = 0; i < simplex.count; ++i)
        if (i != left_out) corners[k++] = at(i);
      asked_.choices.push_back(words_.face(face));
      asked_.spots.emplace_back(spot_of_triangle(ViewKind::world, corners));
      if (!(weights.numerator[left_out] < 0.0)) continue;
      asked_.answer = asked_.choices.back();
      ++negative;
    }
    asked_.choices.emplace_back("several");
    asked_.spots.emplace_back();
    if (negative != 1) asked_.answer = negative == 0 ? "none" : "several";
    text_.caption = fmt::format(
        "Question: which face of {} does {} lie beyond, so that the weight of the vertex opposite "
        "to it is negative? Point at it.",
        words_.face(simplex.all()), story_.q);
  }

  void foot() {
    const Eigen::Vector2d a = at_vertex(0);
    const Eigen::Vector2d b = at_vertex(1);
    const std::string name_a = words_.vertex(0);
    const std::string name_b = words_.vertex(1);
    const double v = (q() - a).dot(b - a) / (b - a).squaredNorm();
    asked_.choices = {"beyond " + name_a, fmt::format("between {} and {}", name_a, name_b),
                      "beyond " + name_b};
    asked_.spots = {Spot{ViewKind::world, 2.0 * a - b, a}, Spot{ViewKind::world, a, b},
                    Spot{ViewKind::world, b, 2.0 * b - a}};
    asked_.answer = asked_.choices[v < 0.0 ? 0 : v > 1.0 ? 2 : 1];
    asked_.place = a + v * (b - a);
    text_.caption =
        fmt::format("Question: where is G, the point of the line {}{} closest to {}? Point at it.",
                    name_a, name_b, story_.q);
  }

  void what_if() {
    const WideSimplex& simplex = before_.simplex;
    const gjk::Barycentric<double, 2> weights = gjk::barycentric(in_plane(simplex), simplex.all());
    int lost = 0;
    for (int i = 1; i < simplex.count; ++i) {
      if (weights.numerator[i] > weights.numerator[lost]) lost = i;
    }
    const char letter = "uvw"[lost];
    const std::string name = words_.vertex(lost);
    for (int i = 0; i < simplex.count; ++i) {
      const auto rest = static_cast<gjk::Face>(simplex.all() & ~gjk::face_of(i));
      add_face(rest);
      if (i == lost) asked_.answer = asked_.choices.back();
    }
    const std::string rest = asked_.answer;
    asked_.refuted =
        simplex.count == 2
            ? fmt::format("{} is the share of {} between G and {}: it is 0 where G is {}.", letter,
                          words_.face(simplex.all()), rest, rest)
            : fmt::format("{} is the area {}{} in shares of the whole: it is 0 on the line {}.",
                          letter, story_.q, rest, rest);
    text_.caption = fmt::format(
        "Question: what if {} moved until {}, the weight of {}, is 0? Point at the {} it could "
        "then stand {}.",
        story_.q, letter, name, simplex.count == 2 ? "vertex" : "edge",
        simplex.count == 2 ? "at" : "on");
  }

  void direction() {
    const bool in_world = run_.point_query();
    const ViewKind view = in_world ? ViewKind::world : ViewKind::difference;
    const auto shown = [&](const Eigen::Vector2d& w) { return in_world ? world(w) : w; };
    const Eigen::Vector2d from = shown(in_plane(before_.p));
    const Eigen::Vector2d edge = in_plane(step_.after.d).normalized() * std::sqrt(step_.after.p_sq);
    const Eigen::Vector2d left(-edge.y(), edge.x());
    const auto add = [&](std::string choice, const Eigen::Vector2d& to) {
      asked_.choices.push_back(std::move(choice));
      asked_.spots.push_back(Spot{view, from, Eigen::Vector2d(from + to)});
    };
    add("away from " + story_.q, -edge);
    add(fmt::format("sideways, with {} on the left", story_.q), -left);
    add(fmt::format("sideways, with {} on the right", story_.q), left);
    add("towards " + story_.q, edge);
    asked_.answer = asked_.choices.back();
    asked_.origin = from;
    asked_.place = from + edge;
    text_.caption =
        "Question: which way does d lead, along which GJK looks for a vertex? Drag it from P.";
  }

  /// Each way as its lesson computes it: a right angle has the dot product 0.
  void right_angle() {
    const DirectionRules::Value& rules = story_.effects.get<DirectionRules>(
        {.run = story_.frame.run, .step = story_.frame.answering_step});
    const std::string edge = words_.vertex(1) + " − " + words_.vertex(0);
    int exact = 0;
    for (const DirectionRules::Built& built : rules) {
      const bool towards = built.rule == gjk::DirectionRule::towards_origin;
      asked_.choices.push_back(towards ? story_.q + " − P" : fmt::format("cross({}, z)", edge));
      if (built.dot_with_edge != 0.0) continue;
      asked_.answer = asked_.choices.back();
      ++exact;
    }
    asked_.choices.insert(asked_.choices.end(), {"both", "neither"});
    if (exact != 1) asked_.answer = exact == 0 ? "neither" : "both";
    text_.caption = fmt::format(
        "Question: d shall make a right angle with {}. Which of these does so exactly, as a "
        "program computes it?",
        words_.face(before_.simplex.all()));
    asked_.refuted = fmt::format(
        "u and v in P = u{} + v{} are quotients, which round; cross({}, z) needs no division.",
        words_.vertex(0), words_.vertex(1), edge);
  }

  void normals() {
    const std::string edge = words_.face(before_.simplex.all());
    asked_.choices = {"one to the closest P, one farther away", "both to the same P",
                      "nowhere: d = 0"};
    asked_.answer = asked_.choices[1];
    text_.caption = fmt::format(
        "Question: {} lies on {}, whose normals point to both sides. Where do they lead GJK?",
        story_.q, edge);
    asked_.refuted = fmt::format(
        "P = {} has distance 0: whatever a normal finds, no P is closer, and none that is farther "
        "is taken.",
        story_.q);
  }

  void may_be() {
    const std::vector<std::string>& names = run_.lesson.y().vertex_names;
    const std::string four = names[0] + names[1] + names[2] + names[3];
    asked_.choices = {
        four, fmt::format("{}{}{}", names[1], names[2], story_.q), names[0] + names[2] + names[3],
        fmt::format("{}{} and the middle of {}{}", names[0], names[1], names[2], names[3])};
    asked_.answer = asked_.choices[2];
    text_.caption = fmt::format(
        "Question: S will change. Which of these could it be: a simplex inscribed in {}?",
        story_.set_name());
    asked_.refuted = fmt::format(
        "{} has four vertices, which no simplex of the plane has; {} and the middle of an edge are "
        "no vertices of {}.",
        four, story_.q, story_.set_name());
  }

  void index() {
    const WideSimplex& simplex = step_.after.simplex;
    const int joins = simplex.vertices[static_cast<std::size_t>(simplex.count) - 1].pair.y;
    const std::vector<std::string>& names = run_.lesson.y().vertex_names;
    for (int i = 0; i < static_cast<int>(names.size()); ++i)
      asked_.choices.push_back(std::to_string(i));
    asked_.answer = asked_.choices[static_cast<std::size_t>(joins)];
    text_.caption = fmt::format(
        "Question: {} joins S as a new SimplexVertex. Which index does it keep, so that it can be "
        "found in {} again?",
        names[static_cast<std::size_t>(joins)], story_.set_name());
    asked_.refuted = "Indices count the polygon's vertices in their order:";
    for (int i = 0; i <= joins; ++i)
      asked_.refuted +=
          fmt::format("{} {} {}", i == 0 ? "" : ",", names[static_cast<std::size_t>(i)], i);
    asked_.refuted += ".";
  }

  void start() {
    const PositionedRun& positioned = run_.run(story_.frame);
    const WideResult& here = positioned.trace.result;
    std::vector<std::string> counts;
    bool all_same = true;
    for (const auto& [vertex, iterations, p] : runs_from_each_vertex(run_, positioned)) {
      constexpr double kSame = 1e-9;  // of the distance: far less than frames show
      all_same =
          all_same && gjk::length(Eigen::Vector3d(p - (here.y - here.x))) <= kSame * here.distance;
      counts.push_back(fmt::format("{} from {}", iterations, run_.pair_name({0, vertex})));
    }
    asked_.choices = {"at a P nearer to the vertex it starts at", "at the same P",
                      "at another P, or never"};
    asked_.answer = asked_.choices[all_same ? 1 : 2];
    text_.caption = fmt::format(
        "Question: this run started at {}. Where does it end if it starts at another vertex?",
        SimplexWords(run_, story_.trace.initial.simplex).face(story_.trace.initial.simplex.all()));
    asked_.refuted =
        fmt::format("The way differs, the end does not: iterations are {}.", and_list(counts));
  }

  void reach() {
    const std::string a = words_.vertex(0);
    const std::string b = words_.vertex(1);
    const UnitVector::Value& built = story_.effects.get<UnitVector>(
        {.run = story_.frame.run, .step = story_.frame.answering_step});
    const Eigen::Vector2d edge = at_vertex(1) - q();
    const double along = built->of_q.to_b;
    asked_.choices = {fmt::format("|{} − {}|, its whole length", b, story_.q),
                      fmt::format("as far as {} − G, with G the foot of {}", b, story_.q),
                      fmt::format("|{} − G|, as far as the line {}{} is", story_.q, a, b)};
    asked_.answer = asked_.choices[1];
    text_.caption = fmt::format(
        "Question: the arrow from {0} to {1} reaches dot({1} − {0}, n) along n. How far is that?",
        story_.q, b);
    asked_.refuted = fmt::format("|{0} − {1}| is {2}, and |{1} − G| is {3}.", b, story_.q,
                                 story_.numbers(gjk::length(edge)),
                                 story_.numbers(std::sqrt(gjk::dot(edge, edge) - along * along)));
  }

  void turn() {
    const gjk::Barycentric<double, 2> weights =
        gjk::barycentric(in_plane(before_.simplex), before_.simplex.all());
    const int beyond = least_weight(weights);
    const std::string a = words_.vertex((beyond + 1) % 3);
    const std::string b = words_.vertex((beyond + 2) % 3);
    const auto cross = [](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
      return from.x() * to.y() - from.y() * to.x();
    };
    const double of_q = cross(at_vertex((beyond + 1) % 3) - q(), at_vertex((beyond + 2) % 3) - q());
    const double of_all = cross(at_vertex(1) - at_vertex(0), at_vertex(2) - at_vertex(0));
    asked_.choices = {"left: it is positive", "right: it is negative"};
    asked_.answer = asked_.choices[of_q < 0.0 ? 1 : 0];
    text_.caption = fmt::format(
        "Question: go from {0} to {1}, then to {2}. Do you turn left or right at {1}, and so which "
        "sign has cross({1} − {0}, {2} − {0})?",
        story_.q, a, b);
    asked_.refuted = fmt::format("The cross product is {}; from {} over {} to {} one turns {}.",
                                 story_.numbers(of_q), words_.vertex(0), words_.vertex(1),
                                 words_.vertex(2), of_all < 0.0 ? "right" : "left");
  }

  /// The weights, and twice two of them exchanged: the sum is 1 each time.
  void solution() {
    const gjk::Barycentric<double, 2> weights =
        gjk::barycentric(in_plane(before_.simplex), before_.simplex.all());
    Eigen::Vector3d right;
    for (int i = 0; i < 3; ++i) right[i] = weights.numerator[i] / weights.denominator;
    const std::array<Eigen::Vector3d, 3> choices = {
        Eigen::Vector3d(right[1], right[0], right[2]), right, {right[2], right[1], right[0]}};
    std::array<std::string, 3> rows;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d& each = choices[k];
      asked_.choices.push_back(fmt::format("{}, {}, {}", story_.numbers.weight(each[0]),
                                           story_.numbers.weight(each[1]),
                                           story_.numbers.weight(each[2])));
      double sum = 0.0;
      for (int i = 0; i < 3; ++i) sum += each[i] * at_vertex(i).x();
      rows[k] = fixed(sum, 2);
    }
    asked_.answer = asked_.choices[1];
    std::string terms;
    std::string given;
    for (int i = 0; i < 3; ++i) {
      const std::string x = fixed(at_vertex(i).x(), 2);
      terms += fmt::format("{}{}·{}",
                           i == 0           ? right[i] < 0.0 ? "−" : ""
                           : right[i] < 0.0 ? " − "
                                            : " + ",
                           story_.numbers.weight(std::abs(right[i])),
                           at_vertex(i).x() < 0.0 ? "(" + x + ")" : x);
      given += fmt::format("{} {}, ", words_.vertex(i), x);
    }
    text_.caption =
        fmt::format("Question: which u, v, w solve u{0} + v{1} + w{2} = {3} and u + v + w = 1?",
                    words_.vertex(0), words_.vertex(1), words_.vertex(2), story_.q);
    text_.detail = fmt::format("In x: {}{} {}. {}", given, story_.q, fixed(q().x(), 2),
                               listed_choices(asked_.choices));
    asked_.refuted =
        fmt::format("In x: {} = {}. The others give {} and {}.", terms, rows[1], rows[0], rows[2]);
  }

 private:
  [[nodiscard]] static int least_weight(const gjk::Barycentric<double, 2>& weights) {
    return static_cast<int>(std::min_element(weights.numerator.begin(), weights.numerator.end()) -
                            weights.numerator.begin());
  }
  [[nodiscard]] std::string true_reason(gjk::StopReason stop) const {
    using Stop = gjk::StopReason;
    return stop == Stop::origin_inside    ? fmt::format("{} lies inside S", story_.q)
           : stop == Stop::zero_direction ? fmt::format("P has reached {}", story_.q)
           : stop == Stop::not_nearer     ? fmt::format("P came no closer to {}", story_.q)
                                          : "no vertex lies farther along d than P";
  }
  /// How many vertices have been in the simplex.
  [[nodiscard]] std::size_t vertices_of_run() const {
    std::set<std::pair<int, int>> pairs;
    const auto add = [&](const WideSimplex& simplex) {
      for (int i = 0; i < simplex.count; ++i)
        pairs.emplace(simplex.vertices[i].pair.x, simplex.vertices[i].pair.y);
    };
    add(story_.trace.initial.simplex);
    for (const WideStep& step : story_.trace.steps) add(step.after.simplex);
    return pairs.size();
  }
  [[nodiscard]] Eigen::Vector2d q() const {
    return in_plane(run_.run(story_.frame).x().world.front());
  }
  /// For a point query.
  [[nodiscard]] Eigen::Vector2d world(const Eigen::Vector2d& difference) const {
    return difference + q();
  }
  [[nodiscard]] Eigen::Vector2d at_vertex(int i) const {
    return world(in_plane(before_.simplex.vertices[i].w));
  }
  void add_face(gjk::Face face) {
    std::vector<Eigen::Vector2d> ends;
    for (int i = 0; i < before_.simplex.count; ++i) {
      if (gjk::contains(face, i)) ends.push_back(at_vertex(i));
    }
    asked_.choices.push_back(words_.face(face));
    asked_.spots.push_back(ends.size() > 2
                               ? std::nullopt
                               : std::optional(Spot{ViewKind::world, ends.front(), ends.back()}));
  }

  /// The step after the one that answers: what is asked for may happen there.
  [[nodiscard]] const WideStep& next_step() const {
    return story_.trace.steps[static_cast<std::size_t>(story_.frame.answering_step) + 1];
  }

  const Story& story_;
  FrameText& text_;
  const LessonRun& run_;
  const WideStep& step_;
  const WideState& before_;
  SimplexWords words_;
  FrameQuestion& asked_;
};

}  // namespace

void question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  text.question = FrameQuestion{ask, {}, {}};
  Asking asking(story, text);
  if (ask == asks::kSupport.name) asking.support();
  if (ask == asks::kRegion.name) asking.region();
  if (ask == asks::kDropped.name) asking.dropped();
  if (ask == asks::kStop.name) asking.stop();
  if (ask == asks::kWhy.name) asking.why();
  if (ask == asks::kClosest.name) asking.closest();
  if (ask == asks::kSign.name) asking.sign();
  if (ask == asks::kFoot.name) asking.foot();
  if (ask == asks::kWhatIf.name) asking.what_if();
  if (ask == asks::kDirection.name) asking.direction();
  if (ask == asks::kRightAngle.name) asking.right_angle();
  if (ask == asks::kNormals.name) asking.normals();
  if (ask == asks::kMayBe.name) asking.may_be();
  if (ask == asks::kIndex.name) asking.index();
  if (ask == asks::kStart.name) asking.start();
  if (ask == asks::kReach.name) asking.reach();
  if (ask == asks::kTurn.name) asking.turn();
  if (ask == asks::kSolution.name) asking.solution();
}

void closest_question(const Story& story, FrameText& text) {
  const std::string& ask = story.run.asked(story.frame).ask;
  const bool of_x = ask == asks::kClosestX.name;
  const LessonShape& shape = of_x ? story.run.lesson.x() : story.run.lesson.y();
  const LessonShape& other = of_x ? story.run.lesson.y() : story.run.lesson.x();
  const std::vector<Eigen::Vector3d>& points =
      of_x ? story.positioned.x().world : story.positioned.y().world;
  const WideResult& result = story.trace.result;
  const auto is_closest = [&](int vertex) {
    return std::any_of(
        result.simplex.vertices.begin(), result.simplex.vertices.begin() + result.simplex.count,
        [&](const WideVertex& each) { return (of_x ? each.pair.x : each.pair.y) == vertex; });
  };
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  const auto add = [&](int from, int to) {
    const std::string& first = shape.vertex_names[from];
    asked.choices.push_back(from == to ? first : first + shape.vertex_names[to]);
    asked.spots.push_back(Spot{ViewKind::world, points[from], points[to]});
    if (is_closest(from) && is_closest(to)) asked.answer = asked.choices.back();
  };
  if (story.run.lesson.dimension == 3) {
    const Polyhedron hull = hull_in_space(points);
    for (const int vertex : hull.vertices) add(vertex, vertex);
    for (const Polyhedron::Edge& edge : hull.edges)
      add(std::min(edge.from, edge.to), std::max(edge.from, edge.to));
    text.caption =
        fmt::format("Question: which vertex or edge of {} is closest to {}? Point at it.",
                    shape.name, other.name);
    return;
  }
  const std::vector<int> hull = convex_hull(in_plane(points));
  for (const int vertex : hull) add(vertex, vertex);
  for (std::size_t i = 0; i < (hull.size() > 2 ? hull.size() : hull.size() - 1); ++i)
    add(std::min(hull[i], hull[(i + 1) % hull.size()]),
        std::max(hull[i], hull[(i + 1) % hull.size()]));
  const Eigen::Vector2d edge =
      in_plane(of_x ? result.y : result.x) - in_plane(of_x ? result.x : result.y);
  asked.place = in_plane(of_x ? result.x : result.y) + shape.radius * edge.normalized();
  text.caption = fmt::format("Question: which point of {} is closest to {}? Point at it.",
                             shape.name, other.name);
}

void closest_of_difference_question(const Story& story, FrameText& text) {
  const std::vector<CloudPoint> corners =
      minkowski_hull(in_plane(story.positioned.x().world), in_plane(story.positioned.y().world));
  const Eigen::Vector2d p = in_plane(story.trace.result.y) - in_plane(story.trace.result.x);
  const bool at_corner = story.trace.result.simplex.count == 1;
  // The obstacle that X has grown stands in the world: Z, moved to where X stands.
  const std::string& ask = story.run.asked(story.frame).ask;
  const bool is_grown = ask == asks::kMeets.name;
  const Eigen::Vector2d shift = is_grown ? in_plane(story.positioned.x().placement.translate)
                                         : Eigen::Vector2d(Eigen::Vector2d::Zero());
  FrameQuestion& asked = text.question.emplace(FrameQuestion{ask, {}, {}});
  double least = std::numeric_limits<double>::infinity();
  const auto add = [&](const CloudPoint& from, const CloudPoint& to, bool is_corner) {
    const std::string name = story.run.pair_name(from.pair);
    asked.choices.push_back(is_corner ? name : name + " to " + story.run.pair_name(to.pair));
    asked.spots.push_back(Spot{is_grown ? ViewKind::world : ViewKind::difference,
                               Eigen::Vector2d(from.z + shift), Eigen::Vector2d(to.z + shift)});
    const Eigen::Vector2d edge = to.z - from.z;
    const double along =
        is_corner ? 0.0 : std::clamp((p - from.z).dot(edge) / edge.dot(edge), 0.0, 1.0);
    const Eigen::Vector2d off = from.z + along * edge - p;
    if (is_corner != at_corner || !(off.dot(off) < least)) return;
    least = off.dot(off);
    asked.answer = asked.choices.back();
  };
  for (const CloudPoint& corner : corners) add(corner, corner, true);
  for (std::size_t i = 0; i < corners.size(); ++i)
    add(corners[i], corners[(i + 1) % corners.size()], false);
  asked.choices.emplace_back("a point inside");
  asked.spots.emplace_back();
  asked.refuted = fmt::format("From a point inside one could go on towards {}, and come closer.",
                              is_grown ? "p" : "O");
  asked.place = p + shift;
  text.caption = is_grown
                     ? fmt::format(
                           "Question: p moves with the {0}. What is the nearest place for p at "
                           "which the {0} touches the {1}? Point at it.",
                           story.run.lesson.x().name, story.run.lesson.y().name)
                     : "Question: which point of Z is closest to O? Point at it.";
}

void overlap_question(const Story& story, FrameText& text) {
  const std::string& x = story.run.lesson.x().name;
  const std::string& y = story.run.lesson.y().name;
  FrameQuestion& asked =
      text.question.emplace(FrameQuestion{std::string(asks::kOriginIn.name), {}, {}});
  asked.choices = {fmt::format("O lies in Z: {} and {} share a point", x, y),
                   fmt::format("O lies outside Z: {} and {} are apart", x, y)};
  asked.answer = asked.choices[story.trace.result.distance > 0.0 ? 1 : 0];
  text.caption = fmt::format("Question: look at Z and O alone. Do {} and {} share a point?", x, y);
}

}  // namespace gjkscope::captions

namespace gjkscope {

std::vector<RunFromVertex> runs_from_each_vertex(const LessonRun& run,
                                                 const PositionedRun& positioned) {
  std::vector<RunFromVertex> out;
  for (int i = 0; i < static_cast<int>(positioned.y().world.size()); ++i) {
    gjk::Options options = run.lesson.options;
    options.start = {{{{0, i}}}, 1};
    const WideResult result = run_again(positioned, options, run.lesson.scalar).trace.result;
    out.push_back({i, result.iterations, result.y - result.x});
  }
  return out;
}

bool tells_answer(const LessonRun& run, const Frame& frame, std::string_view ask) {
  return std::any_of(run.frames.begin(), run.frames.end(), [&](const Frame& other) {
    return other.question >= 0 && other.run == frame.run && other.answering_step == frame.step &&
           run.asked(other).ask == ask;
  });
}

bool refutes(const LessonRun& run, const Frame& frame) {
  constexpr std::array kRefuting = {asks::kWhy, asks::kWhatIf, asks::kStart, asks::kTurn,
                                    asks::kSolution};
  return std::any_of(kRefuting.begin(), kRefuting.end(),
                     [&](const AskInfo& ask) { return tells_answer(run, frame, ask.name); });
}

}  // namespace gjkscope
