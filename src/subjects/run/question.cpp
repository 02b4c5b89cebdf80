#include <fmt/format.h>

#include <algorithm>

#include "picture/story.hpp"
#include "run/questions.hpp"
#include "subjects/difference/subject.hpp"
#include "subjects/run/subject.hpp"

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
      asked_.choices.push_back(words_.face(order.faces[i]));
    // In the order of the tests the first one left would be the answer.
    if (gradual) std::sort(asked_.choices.begin(), asked_.choices.end());
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
        fmt::format("Question: which vertex of the {} can P do without, so that GJK drops it?",
                    gjk::vertex_count(before_.simplex.all()) == 2 ? "segment" : "triangle");
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

 private:
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
  const std::string& ask =
      story.run.lesson.questions[static_cast<std::size_t>(story.frame.question)].ask;
  text.question = FrameQuestion{ask, {}, {}};
  Asking asking(story, text);
  if (ask == asks::kSupport.name) asking.support();
  if (ask == asks::kRegion.name) asking.region();
  if (ask == asks::kDropped.name) asking.dropped();
  if (ask == asks::kStop.name) asking.stop();
}

}  // namespace gjkscope::captions
