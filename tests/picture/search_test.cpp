// Frames of the search over two trees, and of all methods side by side: what they say is what the
// trace found, and the trace is right.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "outlines/brute.hpp"
#include "subjects/hierarchy/lesson_trace.hpp"
#include "subjects/hierarchy/shown.hpp"
#include "subjects/methods/closest_pairs.hpp"
#include "subjects/methods/lesson_trace.hpp"
#include "texts.hpp"

namespace gjkscope {
namespace search_test {

using searches::NodeState;
using searches::Shown;

const std::vector<std::string> kLessons = {"hierarchy-collide", "hierarchy-distance",
                                           "hierarchy-circles", "hierarchy-large",
                                           "hierarchy-orders"};

void expect_truth(const TracedSearch& search) {
  const models::Answer truth = models::brute(search.x, search.y).answer;
  EXPECT_EQ(search.trace.result.answer.overlap, truth.overlap);
  if (search.options.goal != models::Goal::distance) return;
  EXPECT_EQ(search.trace.result.answer.distance, truth.distance);
  EXPECT_EQ(search.left_first.result.answer.distance, truth.distance);
}

TEST(SearchFrames, TheAnswerIsThatOfAllPairs) {
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    expect_truth(*search_trace(run_lesson(testing::shipped_lesson(id)), 0));
  }
}

TEST(SearchFrames, AVertexThatIsMovedBuildsTheTreesAnew) {
  for (const std::string id : {"hierarchy-collide", "hierarchy-distance", "hierarchy-circles"}) {
    SCOPED_TRACE(id);
    Lesson lesson = testing::shipped_lesson(id);
    const LessonRun before = run_lesson(lesson);
    lesson.y().vertices[4] = {-2.0, 0.1, 0.0};
    const LessonRun after = run_lesson(lesson);
    const TracedSearch& search = *search_trace(after, 0);
    expect_truth(search);
    EXPECT_TRUE(search.trace.result.answer.overlap ||
                search.trace.result.visits != search_trace(before, 0)->trace.result.visits);
    const auto reaches = [](const Volume& volume) {
      const models::Box* box = std::get_if<models::Box>(&volume);
      if (box != nullptr) return box->low.x() <= -2.0 && box->high.x() >= -2.0;
      const models::Circle& circle = std::get<models::Circle>(volume);
      return circle.center.x() - circle.radius <= -2.0;
    };
    EXPECT_FALSE(reaches(search_trace(before, 0)->tree_y[0].volume));
    EXPECT_TRUE(reaches(search.tree_y[0].volume));
  }
}

TEST(SearchFrames, NodesAreAsTheirPairs) {
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    std::set<NodeState> seen;
    for (const Frame& frame : run.frames) {
      const Shown shown(run, frame);
      for (const bool of_x : {true, false}) {
        const std::vector<NodeState> states = shown.node_states(of_x);
        std::set<int> waiting;
        for (const models::NodePair& pair : shown.state.waiting)
          waiting.insert(of_x ? pair.a : pair.b);
        for (int i = 0; i < static_cast<int>(states.size()); ++i) {
          seen.insert(states[static_cast<std::size_t>(i)]);
          const bool is_current = shown.has_pair() && shown.node_index(of_x) == i;
          if (!is_current) {
            EXPECT_EQ(states[static_cast<std::size_t>(i)] == NodeState::waiting,
                      waiting.contains(i));
          }
          // A node never reached lies below one that was cut or measured, or is to come.
          const int parent = shown.search.tree(of_x)[static_cast<std::size_t>(i)].parent;
          if (states[static_cast<std::size_t>(i)] == NodeState::off && parent >= 0) {
            EXPECT_NE(states[static_cast<std::size_t>(parent)], NodeState::waiting);
          }
        }
        if (shown.is_answer && shown.state.stop == models::SearchStop::apart) {
          EXPECT_EQ(std::count(states.begin(), states.end(), NodeState::ahead), 0);
        }
      }
    }
    EXPECT_TRUE(seen.contains(NodeState::cut));
    EXPECT_TRUE(seen.contains(NodeState::off));
  }
}

TEST(SearchFrames, ANodeOfTheTreeIsLinkedToItsVolumeOnTheStage) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  const LessonRun run = run_lesson(testing::shipped_lesson("hierarchy-distance"));
  const TracedSearch& search = *search_trace(run, 0);
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts);
  const Picture picture = pictures.picture(3);
  for (const bool of_x : {true, false}) {
    for (int i = 0; i < static_cast<int>(search.tree(of_x).size()); ++i) {
      const Subject subject =
          of_x ? Subject{Subject::Kind::tree_node, i} : Subject{Subject::Kind::tree_node, -1, i};
      std::set<int> views;
      for (const Mark& mark : picture.marks) {
        if (mark.subject == subject) views.insert(mark.clip);
      }
      EXPECT_EQ(views, (std::set<int>{0, 1}));
    }
  }
}

TEST(SearchFrames, AskOnlyWhatAVisitAnswers) {
  int asked = 0;
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    const std::vector<FrameText> texts = testing::texts_of(run);
    EXPECT_EQ(texts.front().phase, "start");
    EXPECT_EQ(texts.back().phase, "answer");
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (!texts[i].question ||
          (texts[i].question->ask != "descend" && texts[i].question->ask != "win"))
        continue;
      ++asked;
      const bool is_cut = texts[i + 1].caption.ends_with("cut.");
      EXPECT_EQ(texts[i].question->answer.ends_with("cut"), is_cut) << texts[i + 1].caption;
    }
  }
  EXPECT_EQ(asked, 7);
}

/// The search says so of both halves when it visits them, however long after the question.
TEST(SearchFrames, AskAboutHalvesWhatTheirVisitsSay) {
  std::set<std::string> answers;
  for (const std::string& id : kLessons) {
    SCOPED_TRACE(id);
    Lesson lesson = testing::shipped_lesson(id);
    if (id == "hierarchy-orders") continue;
    lesson.questions = {{"half", {}}};
    const LessonRun run = run_lesson(lesson);
    const std::vector<FrameText> texts = testing::texts_of(run);
    int asked = 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (!texts[i].question) continue;
      ++asked;
      const Shown shown(run, run.frames[i]);
      const bool of_x = !shown.step->record.takes_b_apart;
      std::vector<int> visited;
      std::vector<int> cut;
      const int visit = static_cast<int>(shown.state.visits) - 1;
      for (const models::SearchStep& step : shown.search.trace.steps) {
        if (step.phase != models::SearchPhase::bound || step.after.pair.from != visit) continue;
        visited.push_back(of_x ? step.after.pair.a : step.after.pair.b);
        if (step.record.cut) cut.push_back(visited.back());
      }
      const auto side = [&](int node) {
        return fmt::format("{} half of {}", node == shown.node(of_x).left ? "left" : "right",
                           of_x ? "a" : "b");
      };
      const std::string expected = shown.is_distance() ? side(visited.front())
                                   : cut.empty()       ? "neither"
                                   : cut.size() == 2   ? "both"
                                                       : side(cut.front());
      EXPECT_EQ(texts[i].question->answer, expected) << texts[i].caption;
      answers.insert(expected);
      EXPECT_TRUE(texts[i + 1].detail.ends_with(texts[i].question->refuted));
    }
    EXPECT_GT(asked, 3);
  }
  EXPECT_GE(answers.size(), 5u);
}

/// The answers of questions besides visits, by the search itself.
TEST(SearchFrames, AskBeforeTheFirstVisitAndAfterTheLast) {
  std::map<std::string, std::string> answers;
  for (const std::string id : {"hierarchy-collide", "hierarchy-distance", "sphere-tree"}) {
    for (const FrameText& text : testing::texts_of(run_lesson(testing::shipped_lesson(id)))) {
      if (text.question) answers[text.question->ask] = text.question->answer;
    }
  }
  EXPECT_EQ(answers["cut-to-pieces"], "star");
  EXPECT_EQ(answers["all-pairs"], "120");
  EXPECT_EQ(answers["node"], "level 2");
  EXPECT_EQ(answers["tiles"], std::to_string(static_cast<int>(std::ceil(3.4 / 0.8))));
  EXPECT_EQ(answers["split"], "the level line");
  const LessonRun boxes = run_lesson(testing::shipped_lesson("hierarchy-distance"));
  const TracedSearch& search = *search_trace(boxes, 0);
  models::SearchOptions collide;
  collide.goal = models::Goal::collide;
  EXPECT_EQ(answers["wider"],
            std::to_string(models::search<models::Box>(search.x, search.y, collide).visits));
  const LessonRun run = run_lesson(testing::shipped_lesson("sphere-tree"));
  const TracedSearch& tiled = *search_trace(run, 0);
  EXPECT_LT(tiled.trace.result.measured, tiled.tile_sizes.back().result.measured);
  EXPECT_EQ(answers["tile-size"], "more");
  EXPECT_LT(tiled.of_circles.visits, std::min(tiled.of_boxes.visits, tiled.trace.result.visits));
  EXPECT_EQ(answers["volume"], "circles of segments");
  for (const TileSize& size : tiled.tile_sizes) {
    EXPECT_EQ(size.result.answer.distance, tiled.trace.result.answer.distance) << size.radius;
    if (size.radius == 0.4) {
      EXPECT_EQ(size.result.visits, tiled.trace.result.visits);
    }
  }
}

TEST(SearchFrames, CountTheOperationsOfTwoTests) {
  const models::Box a{{0, 0}, {1, 1}};
  EXPECT_EQ(searches::tests_of(a, {{2, 0}, {3, 1}}).meet, 1);
  EXPECT_EQ(searches::tests_of(a, {{-2, 0}, {-1, 1}}).meet, 2);
  EXPECT_EQ(searches::tests_of(a, {{0, -2}, {1, -1}}).meet, 4);
  EXPECT_EQ(searches::tests_of(a, {{0.5, 0.5}, {3, 3}}).meet, 4);
  // Each axis takes two differences and two maxima; two squares, a sum, a root.
  EXPECT_EQ(searches::tests_of(a, {{2, 2}, {3, 3}}).distance, 12);
}

TEST(ClosestPairs, JumpWhereNoNeighbourIsClosest) {
  const LessonRun run = run_lesson(testing::shipped_lesson("closest-jumps"));
  int jumps = 0;
  for (int i = 1; i < static_cast<int>(run.runs.size()); ++i) {
    const models::Answer& last = all_pairs_trace(run, i - 1).closest;
    const models::Answer& now = all_pairs_trace(run, i).closest;
    const double step = 2.0 / static_cast<double>(run.runs.size() - 1);
    EXPECT_LE(std::abs(now.distance - last.distance), step + 1e-12) << "it is continuous";
    const double difference = (now.a - last.a).norm();
    EXPECT_EQ(difference > 5.0 * step, !(now.on_a == last.on_a)) << i;
    jumps += now.on_a == last.on_a ? 0 : 1;
  }
  EXPECT_EQ(jumps, 2);
  for (const FrameText& text : testing::texts_of(run)) {
    if (text.question && text.question->ask == "look-at") {
      EXPECT_EQ(text.question->answer, "all of X");
    }
    if (text.question && text.question->ask == "closest-x") {
      EXPECT_EQ(text.question->answer, "EF");
    }
  }
}

TEST(SearchFrames, ThePairThatComesNextIsThatOfTheNextVisit) {
  Lesson lesson = testing::shipped_lesson("hierarchy-orders");
  lesson.questions = {{"next-pair", {}}};
  const LessonRun run = run_lesson(lesson);
  const std::vector<FrameText> texts = testing::texts_of(run);
  int asked = 0;
  std::map<std::string, int> answers;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!texts[i].question) continue;
    ++asked;
    const FrameQuestion& question = *texts[i].question;
    ++answers[question.answer == question.choices.back() ? "last" : question.answer];
    const models::NodePair& next = Shown(run, run.frames[i + 1]).state.pair;
    const auto at = std::find(question.choices.begin(), question.choices.end(), question.answer);
    EXPECT_EQ(question.subjects[static_cast<std::size_t>(at - question.choices.begin())],
              (Subject{Subject::Kind::tree_node, next.a, next.b}));
    EXPECT_GT(question.choices.size(), 1u);
  }
  EXPECT_GT(asked, 10);
  for (const auto& [answer, times] : answers)
    EXPECT_LT(2 * times, asked) << answer << ": a number must not give the answer away";
}

TEST(SearchFrames, AShapeWithoutSegmentsIsRefused) {
  Lesson lesson = testing::shipped_lesson("hierarchy-distance");
  lesson.questions.clear();
  lesson.opening.clear();
  lesson.x().vertices.resize(1);
  lesson.x().vertex_names.resize(1);
  const LessonRun run = run_lesson(lesson);
  ASSERT_EQ(run.frames.size(), 1u);
  EXPECT_EQ(testing::texts_of(run).front().caption, "The search does not take U: too few points.");
}

TEST(MethodsFrames, AllMethodsAgreeAndMemoryDoesNotHurt) {
  const LessonRun run = run_lesson(testing::shipped_lesson("methods-motion"));
  std::array<long, kMethods.size()> sums = {};
  for (int i = 0; i < static_cast<int>(run.runs.size()); ++i) {
    const MethodsTrace& trace = *methods_trace(run, i);
    const OutlinesOfRun outlines = outlines_of(run.lesson, run.runs[static_cast<std::size_t>(i)]);
    const double truth = models::brute(outlines.x, outlines.y).answer.distance;
    for (std::size_t m = 0; m < kMethods.size(); ++m) {
      EXPECT_NEAR(trace.distances[m], truth, 1e-14 * 8.0) << name_of(kMethods[m]);
      sums[m] += trace.steps[m];
    }
  }
  const auto sum = [&](Method method) { return sums[static_cast<std::size_t>(method)]; };
  EXPECT_LT(sum(Method::gjk_warm), sum(Method::gjk_cold));
  EXPECT_LE(sum(Method::tree_pair), sum(Method::tree_cold));
  EXPECT_LT(sum(Method::tree_front), sum(Method::tree_pair));
}

TEST(MethodsFrames, AgreeWhereShapesPassThroughEachOther) {
  Lesson lesson = testing::shipped_lesson("methods-motion");
  lesson.path_of_shapes->y().points = {{3.4, -2.6, 0}, {-1.0, -0.4, 0}, {1.2, 3.6, 0}};
  const LessonRun run = run_lesson(lesson);
  int overlaps = 0;
  for (int i = 0; i < static_cast<int>(run.runs.size()); ++i) {
    const MethodsTrace& trace = *methods_trace(run, i);
    overlaps += trace.answer.overlap ? 1 : 0;
    for (const double distance : trace.distances) EXPECT_NEAR(distance, trace.distances[0], 1e-13);
  }
  EXPECT_GT(overlaps, 2);
  EXPECT_LT(overlaps, static_cast<int>(run.runs.size()));
}

TEST(MethodsFrames, SayWhichShapeTheyDoNotTake) {
  Lesson lesson = testing::shipped_lesson("methods-motion");
  lesson.y().vertices[0] = {0.0, 0.0, 0.0};
  const LessonRun run = run_lesson(lesson);
  EXPECT_EQ(testing::texts_of(run).front().caption, "Not all methods take Y: not convex.");
}

}  // namespace search_test
}  // namespace gjkscope
