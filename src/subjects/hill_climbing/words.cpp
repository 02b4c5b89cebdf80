#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "subjects/hill_climbing/growth.hpp"
#include "subjects/hill_climbing/shown.hpp"

namespace gjkscope::climbs {
namespace {

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void start(const Shown& shown, FrameText& text) {
  const Lesson& lesson = shown.lesson;
  if (shown.trace.steps() == 0) {
    text.caption = "GJK asks for no support point, so there is no walk.";
    text.detail = "It ends at the simplex that it starts with, or both shapes are points.";
    return;
  }
  const Climb& first = shown.trace.climbs.front();
  const LessonShape& shape = lesson.bodies[first.of_x ? 0 : 1];
  text.caption = fmt::format("GJK needs support points of {}. A scan looks at all {} vertices.",
                             shape.name, shape.vertices.size());
  text.detail = fmt::format(
      "A walk looks at neighbours only: the other ends of a vertex's edges, which are stored. It "
      "starts at {}.",
      shape.vertex_names[first.walk.looks.front().at]);
}

/// Whether one neighbour lies farther by so little that rounding of d can make it.
bool is_rounding(const Shown& shown, int a, int b) {
  constexpr double kRounding = 1e-12;
  const Eigen::Vector3d& d = shown.climb().walk.d;
  const double size = d.norm() * std::max(shown.at(a).norm(), shown.at(b).norm());
  return std::abs(shown.product(a) - shown.product(b)) <= kRounding * size;
}

void move(const Story& story, const Shown& shown, FrameText& text) {
  const climbing::Look& look = shown.look();
  const std::string& now = shown.name(look.at);
  const std::string& next = shown.name(look.next);
  if (is_rounding(shown, look.at, look.next)) {
    text.caption = fmt::format("{} and {} lie equally far along {}, but for rounding: go to {}.",
                               now, next, shown.d(), next);
    text.detail = fmt::format(
        "{} is normal to a part of {} that has both, so each of them is a support point. Walk and "
        "scan may name different ones.",
        shown.d(), shown.shape().name);
    return;
  }
  text.caption = fmt::format(
      "{} lies farthest along {} of the neighbours of {}, and farther than {}: go to {}.", next,
      shown.d(), now, now, next);
  text.detail = fmt::format("{} · {} = {} is more than {} · {} = {}.", shown.d(), next,
                            story.numbers(shown.product(look.next)), shown.d(), now,
                            story.numbers(shown.product(look.at)));
  const std::size_t known = shown.neighbours().size() - look.new_neighbours.size();
  if (shown.is_first() && shown.step > 0) {
    text.detail += fmt::format(" This walk starts where the last one ended, at {}.", now);
  } else if (known > 0) {
    text.detail += fmt::format(" {} of its {} were met before, and need no new dot product.", known,
                               counted(shown.neighbours().size(), "neighbour"));
  }
}

void stop(const Shown& shown, FrameText& text) {
  const climbing::Look& look = shown.look();
  const std::string& now = shown.name(look.at);
  const std::size_t all = shown.bodies[shown.body()].world.size();
  text.caption = fmt::format("No neighbour of {} lies farther along {}: {} is the support point.",
                             now, shown.d(), now);
  std::vector<std::string> ties;
  for (const int end : shown.neighbours()) {
    if (climbing::farther(shown.climb().walk.d, shown.at(look.at), shown.at(end)) == 0)
      ties.push_back(shown.name(end));
  }
  if (!ties.empty()) {
    text.detail = fmt::format("{} {} exactly as far: any of them will do, and the walk ends. ",
                              and_list(ties), ties.size() == 1 ? "lies" : "lie");
  } else {
    text.detail = fmt::format(
        "{} is convex: all of it lies within the cone of these edges, and none of them leads "
        "beyond the plane. ",
        shown.shape().name);
  }
  text.detail += fmt::format("{} instead of {}.", counted(shown.products(), "dot product"), all);
}

void answer(const Shown& shown, FrameText& text) {
  const ClimbTrace& trace = shown.trace;
  text.caption =
      fmt::format("{} computed {}, scans {}.", capitalized(counted(trace.climbs.size(), "walk")),
                  counted(trace.walked(trace.steps()), "dot product"), trace.scanned);
  const int first = trace.climbs.front().walk.products();
  const int last = trace.climbs.back().walk.products();
  text.detail = first > last
                    ? fmt::format(
                          "The first walk took {}, the last {}: it starts where the walk before "
                          "ended, close to its goal.",
                          first, last)
                    : "Each walk starts where the one before ended, seldom far from its goal.";
}

void growth(const Story& story, FrameText& text) {
  const ClimbGrowth::Sample& last = story.effects.get<ClimbGrowth>(story.frame).back();
  text.caption = fmt::format(
      "With {} vertices a scan computes {} dot products, a walk from any vertex {}, one from the "
      "last support point {}.",
      grouped(last.vertices), grouped(last.vertices), fixed(last.first, 0), fixed(last.later, 0));
  text.detail = fmt::format(
      "Averages of {} runs for each n, on random points on a sphere. Dot products are counted "
      "and not timed; neighbours are made beforehand.",
      ClimbGrowth::kRuns);
}

void needs(const Story& story, FrameText& text) {
  const ClimbGrowth::Sample& last = story.effects.get<ClimbGrowth>(story.frame).back();
  text.caption = fmt::format(
      "A walk has its price: neighbours must be stored, and a far start is a long way: {} moves "
      "with {} vertices, growing like √n.",
      fixed(last.first_moves, 0), grouped(last.vertices));
  text.detail =
      "Neighbours must be true vertices. At a point inside of a face all can lie equally far "
      "though "
      "d leads into the body: a walk would stop too early.";
}

}  // namespace

void words(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  if (const std::optional<After> after = after_of(story.run, story.frame))
    return *after == After::growth ? growth(story, text) : needs(story, text);
  if (shown.step < 0) return start(shown, text);
  if (shown.is_answer) return answer(shown, text);
  shown.look().next >= 0 ? move(story, shown, text) : stop(shown, text);
}

void question(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  FrameQuestion& asked = text.question.emplace(FrameQuestion{std::string(kAskClimb.name), {}, {}});
  for (const int end : shown.neighbours()) asked.choices.push_back(shown.name(end));
  std::sort(asked.choices.begin(), asked.choices.end());
  asked.answer = shown.name(shown.look().next);
  text.caption = fmt::format(
      "Question: the walk is at {}. Which of its neighbours does it go to next? Point at it.",
      shown.name(shown.look().at));
}

void values(const Story& story, FrameText& text) {
  const Shown shown(story.run, story.frame);
  const auto put = [&](std::string name, std::string value) {
    text.values.emplace_back(std::move(name), std::move(value));
  };
  put("x", story.run.lesson.x().name);
  put("y", story.run.lesson.y().name);
  if (shown.trace.steps() == 0 || shown.step < 0) return;
  int scanned = 0;
  const int climbs = shown.trace.all[shown.step].climb + 1;
  for (int i = 0; i < climbs; ++i) {
    const Climb& each = shown.trace.climbs[i];
    scanned += static_cast<int>(shown.bodies[each.of_x ? 0 : 1].world.size());
  }
  put("at", shown.name(shown.look().at));
  put("walked", std::to_string(shown.trace.walked(shown.over())));
  put("scanned", std::to_string(scanned));
}

}  // namespace gjkscope::climbs
