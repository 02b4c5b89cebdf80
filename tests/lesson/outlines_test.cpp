// Lessons of an algorithm that does not follow GJK: outlines, what a file may expect, no run of
// GJK.

#include <gtest/gtest.h>

#include "frames/frame.hpp"
#include "lesson/load.hpp"
#include "lesson/save.hpp"
#include "lessons.hpp"
#include "run/trace_json.hpp"
#include "run/trace_text.hpp"
#include "subjects/hierarchy/table.hpp"
#include "subjects/subjects.hpp"
#include "texts.hpp"

namespace gjkscope {
namespace outlines_test {

const std::string kSquareWithHole =
    "vertices = [[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [1, 3], [3, 3], [3, 1]]\n";

std::string lesson_text(const std::string& x, const std::string& tour = "lin-canny",
                        const std::string& expect = "answer = { distance = 1.0 }") {
  return "title = \"T\"\nchapter = 1\norder = 1\nprose = \"P\"\n[shapes.X]\n" + x +
         "[shapes.Y]\nvertices = [[5, 0], [6, 0], [6, 1]]\n[steps]\ntour = \"" + tour +
         "\"\n[[views]]\nshow = \"world\"\n[expect]\n" + expect + "\n";
}

LoadedLesson load(const std::string& text) { return parse_lesson(text, "x.toml", vocabulary()); }

/// The one problem of a text.
std::string problem(const std::string& text) {
  const LoadedLesson loaded = load(text);
  EXPECT_EQ(loaded.problems.size(), 1u) << text;
  return loaded.problems.empty() ? "" : to_string(loaded.problems.front());
}

TEST(Outlines, AreVerticesOneAfterTheOther) {
  const LoadedLesson loaded = load(lesson_text(kSquareWithHole + "outlines = [4, 4]\n"));
  ASSERT_TRUE(loaded.lesson);
  const std::vector<VertexRange> ranges = loaded.lesson->x().ranges();
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[1].first, 4);
  EXPECT_EQ(ranges[1].count, 4);
  EXPECT_EQ(loaded.lesson->y().ranges().size(), 1u);
  const LoadedLesson again = load(lesson_toml(*loaded.lesson));
  ASSERT_TRUE(again.lesson);
  EXPECT_EQ(again.lesson->x(), loaded.lesson->x());
}

TEST(Outlines, AreRefusedWhereTheyDoNotAddUpOrGjkRuns) {
  EXPECT_EQ(problem(lesson_text(kSquareWithHole + "outlines = [4, 3]\n")),
            "x.toml:7:12: the outlines have 7 vertices in all; expected 8, as many as there are in "
            "'vertices'");
  EXPECT_EQ(problem(lesson_text(kSquareWithHole + "outlines = [4, 4]\n", "phase",
                                "stop = \"repeated-support\"")),
            "x.toml:7:12: 'outlines' with tour 'phase'; expected no 'outlines': GJK asks "
            "about the hull of the vertices");
}

TEST(Outlines, AFileExpectsWhatItsAlgorithmComesTo) {
  const std::string x = "vertices = [[0, 0], [4, 0], [4, 4], [0, 4]]\n";
  EXPECT_TRUE(load(lesson_text(x)).lesson);
  EXPECT_EQ(problem(lesson_text(x, "lin-canny", "distance = 1.0")),
            "x.toml:14:12: 'distance' with tour 'lin-canny'; expected 'answer': GJK is not run");
  const LoadedLesson stops = load(lesson_text(x, "lin-canny", "stop = \"local-minimum\""));
  ASSERT_TRUE(stops.lesson);
  EXPECT_EQ(load(lesson_toml(*stops.lesson)).lesson->expect, stops.lesson->expect);
  const std::vector<Problem> differ = check_expectation(run_lesson(*stops.lesson));
  ASSERT_EQ(differ.size(), 1u);
  EXPECT_EQ(differ[0].what, "stop: 'closest'");
  EXPECT_EQ(differ[0].expected, "'local-minimum'");
  EXPECT_EQ(problem(lesson_text(x, "slab-proof", "stop = \"empty slab\"")),
            "x.toml:14:8: unknown stop reason 'empty slab'; expected one of: empty-slab, overlap, "
            "iteration-cap; did you mean 'empty-slab'?");
  EXPECT_EQ(problem(lesson_text(x, "minkowski-sum", "stop = \"repeated-support\"")),
            "x.toml:14:8: 'stop' with tour 'minkowski-sum'; expected 'answer': GJK is not run");
  EXPECT_EQ(problem(lesson_text(x, "phase", "distance = 1.0")).substr(0, 33),
            "x.toml:13:1: missing key 'stop'; ");
}

TEST(Outlines, NoRunOfGjkIsMadeForAnAlgorithmThatDoesNotFollowIt) {
  const LessonRun run =
      run_lesson(*load(lesson_text("vertices = [[0, 0], [4, 0], [4, 4], [0, 4]]\n")).lesson);
  EXPECT_TRUE(run.runs[0].trace.is_empty());
  EXPECT_TRUE(run.runs.front().trace.steps.empty());
  EXPECT_EQ(run.runs.front().x().world.size(), 4u);
  EXPECT_TRUE(check_expectation(run).empty());
  const std::string json = trace_json(traced(run));
  EXPECT_NE(json.find("\"lin-canny\""), std::string::npos);
  EXPECT_EQ(json.find("\"result\""), std::string::npos);
  EXPECT_EQ(trace_text(traced(run)).find("no result"), std::string::npos);
}

TEST(Outlines, TheWalkSaysWhyItDoesNotTakeAHole) {
  const LessonRun run =
      run_lesson(*load(lesson_text(kSquareWithHole + "outlines = [4, 4]\n")).lesson);
  ASSERT_EQ(run.frames.size(), 1u);
  const std::vector<FrameText> texts = testing::texts_of(run);
  EXPECT_EQ(texts.front().caption, "The walk does not take X: more than one outline.");
  EXPECT_EQ(check_expectation(run).size(), 1u);
}

TEST(Volumes, AreChosenWhereTreesAreBuilt) {
  const auto with_volumes = [](const std::string& volumes, const std::string& tour) {
    return lesson_text("vertices = [[0, 0], [4, 0], [4, 4], [0, 4]]\n", tour) +
           "[trees]\nvolumes = \"" + volumes + "\"\n";
  };
  const LoadedLesson loaded = load(with_volumes("circles", "hierarchy-distance"));
  ASSERT_TRUE(loaded.lesson);
  EXPECT_EQ(trees_of(*loaded.lesson).volumes, VolumeKind::circles);
  EXPECT_EQ(*load(lesson_toml(*loaded.lesson)).lesson, *loaded.lesson);
  const LoadedLesson without =
      load(lesson_text("vertices = [[0, 0], [4, 0], [4, 4], [0, 4]]\n", "hierarchy-distance"));
  EXPECT_EQ(trees_of(*without.lesson).volumes, VolumeKind::boxes);
  EXPECT_EQ(lesson_toml(*without.lesson).find("[trees]"), std::string::npos);
  EXPECT_EQ(problem(with_volumes("balls", "hierarchy-distance")),
            "x.toml:16:11: unknown volume 'balls'; expected one of: boxes, circles, tiles");
  EXPECT_EQ(problem(with_volumes("circles", "lin-canny")),
            "x.toml:15:1: a table [trees] without tour 'hierarchy-collide' or "
            "'hierarchy-distance' or 'hierarchy-orders'; expected tour = "
            "\"hierarchy-collide\" or \"hierarchy-distance\" or \"hierarchy-orders\" in [steps]");
  LoadedLesson tiles = load(with_volumes("tiles", "hierarchy-orders") + "tile = 0.25\n");
  ASSERT_TRUE(tiles.lesson);
  EXPECT_EQ(trees_of(*tiles.lesson), (LessonTrees{VolumeKind::tiles, 0.25}));
  EXPECT_EQ(*load(lesson_toml(*tiles.lesson)).lesson, *tiles.lesson);
  tiles.lesson->settings = TourSettings(LessonTrees{});
  EXPECT_EQ(*load(lesson_toml(*tiles.lesson)).lesson, *tiles.lesson) << "an empty table stays";
  EXPECT_EQ(problem(with_volumes("circles", "hierarchy-distance") + "tile = 0.25\n"),
            "x.toml:17:8: 'tile' without tiles; expected volumes = \"tiles\"");
}

}  // namespace outlines_test
}  // namespace gjkscope
