// Frames that ask: what they say, what they keep to themselves, and how the next frame answers.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "subjects/subjects.hpp"
#include "texts.hpp"

namespace gjkscope {
namespace question_test {

using Choices = std::vector<std::string>;

std::vector<FrameText> texts_of_frames(const Lesson& lesson) {
  const LessonRun run = run_lesson(lesson);
  return testing::texts_of(run);
}

/// The question frames of a lesson, each with the frame that answers.
struct Asked {
  FrameText question;
  FrameText answer;
};

std::vector<Asked> asked(const Lesson& lesson) {
  const std::vector<FrameText> texts = texts_of_frames(lesson);
  std::vector<Asked> out;
  for (std::size_t i = 0; i + 1 < texts.size(); ++i) {
    if (!texts[i].question) continue;
    const auto answer = std::find_if(texts.begin() + static_cast<std::ptrdiff_t>(i), texts.end(),
                                     [](const FrameText& text) { return !text.question; });
    out.push_back({texts[i], *answer});
  }
  return out;
}

Lesson asking(const std::string& id, std::vector<LessonQuestion> questions) {
  Lesson lesson = testing::shipped_lesson(id);
  lesson.questions = std::move(questions);
  return lesson;
}

TEST(QuestionFrames, OfThePentagon) {
  const std::vector<Asked> all = asked(testing::shipped_lesson("polygon-evolution"));
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].question.question->answer, "towards Q");
  EXPECT_EQ(all[1].question.caption, "Question: which vertex of ABCDE lies farthest along d?");
  EXPECT_EQ(all[1].question.question->choices, (Choices{"A", "B", "C", "D", "E"}));
  EXPECT_EQ(all[1].question.question->answer, "D");
  EXPECT_TRUE(all[1].answer.caption.starts_with("Answer: D lies farthest along d"));
  EXPECT_EQ(all[1].question.position, "iteration 2 · question");
  EXPECT_EQ(all[2].question.question->choices, (Choices{"none", "C", "D", "E", "two of them"}));
  EXPECT_EQ(all[2].question.question->answer, "E");
  EXPECT_EQ(all[3].question.caption, "Question: GJK stops here. Why?");
  EXPECT_EQ(all[3].question.question->choices,
            (Choices{"no vertex lies farther along d than P", "P has reached Q",
                     "all vertices of ABCDE have been in S"}));
  EXPECT_EQ(all[3].question.question->answer, "no vertex lies farther along d than P");
  EXPECT_NE(all[3].answer.detail.find("P is still 1.609 from Q. S has had 3 of 5 vertices"),
            std::string::npos)
      << all[3].answer.detail;
}

TEST(QuestionFrames, ADirectionLeadsFromPAlongD) {
  for (const std::string id : {"polygon-evolution", "polygons-gjk", "polygon-pseudocode"}) {
    const LessonRun run = run_lesson(asking(id, {{"direction", {}}}));
    const std::vector<FrameText> texts = testing::texts_of(run);
    int questions = 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (!texts[i].question) continue;
      ++questions;
      const FrameQuestion& asked = *texts[i].question;
      const Frame& frame = run.frames[i];
      const WideState& after =
          run.run(frame).trace.steps[static_cast<std::size_t>(frame.answering_step)].after;
      const Eigen::Vector2d difference = *asked.place - *asked.origin;
      EXPECT_NEAR(in_plane(after.d).normalized().dot(difference.normalized()), 1.0, 1e-12) << id;
      EXPECT_EQ(asked.choices.size(), 4u);
      // The choices lead to four sides.
      for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector2d to = in_plane(asked.spots[k]->to) - *asked.origin;
        EXPECT_EQ(to.dot(difference) > 0.5 * difference.squaredNorm(),
                  asked.choices[k] == asked.answer)
            << id;
        EXPECT_NEAR(to.norm(), difference.norm(), 1e-12);
      }
    }
    EXPECT_GE(questions, 2) << id;
  }
  EXPECT_TRUE(asked(asking("polyhedra-gjk", {{"direction", {}}})).empty());
}

/// The area of a triangle, negative if it is clockwise.
double area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
}

TEST(QuestionFrames, AWeightIsZeroOnTheEdgeOfTheOtherVertices) {
  const LessonRun run = run_lesson(asking("triangle-barycentric", {{"what-if", {}}}));
  const std::vector<FrameText> texts = testing::texts_of(run);
  int questions = 0;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!texts[i].question) continue;
    ++questions;
    const PositionedRun& at = run.run(run.frames[i]);
    const Eigen::Vector2d q = in_plane(at.x().world[0]);
    const std::vector<Eigen::Vector2d> t = in_plane(at.y().world);
    const std::map<double, std::string> opposite = {
        {area(q, t[1], t[2]), "BC"}, {area(q, t[2], t[0]), "CA"}, {area(q, t[0], t[1]), "AB"}};
    EXPECT_EQ(texts[i].question->answer, opposite.rbegin()->second) << i;
    EXPECT_EQ(texts[i].question->choices.size(), 3u);
    EXPECT_NE(texts[i + 1].detail.find("it is 0 on the line"), std::string::npos);
  }
  EXPECT_GT(questions, 5);
}

TEST(QuestionFrames, OneTurnsRightAtAnEdgeThatQLiesBeyond) {
  const LessonRun run = run_lesson(asking("triangle-barycentric", {{"turn", {}}}));
  const std::vector<FrameText> texts = testing::texts_of(run);
  std::map<std::string, int> answers;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!texts[i].question) continue;
    const PositionedRun& at = run.run(run.frames[i]);
    const Eigen::Vector2d q = in_plane(at.x().world[0]);
    const std::vector<Eigen::Vector2d> t = in_plane(at.y().world);
    const double least = std::min({area(q, t[1], t[2]), area(q, t[2], t[0]), area(q, t[0], t[1])});
    EXPECT_EQ(texts[i].question->answer,
              least < 0.0 ? "right: it is negative" : "left: it is positive");
    ++answers[texts[i].question->answer];
  }
  EXPECT_EQ(answers["right: it is negative"], 7);  // nothing asks of the first position, inside
}

TEST(QuestionFrames, OfAMoveAreAskedWhereItBegins) {
  const LessonRun run = run_lesson(asking("minkowski-translate", {{"slide", {}}, {"holds", {}}}));
  const std::vector<FrameText> texts = testing::texts_of(run);
  std::map<std::string, int> asked;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!texts[i].question) continue;
    const FrameQuestion& question = *texts[i].question;
    ++asked[question.ask];
    const PositionedRun& from = run.run(run.frames[i]);
    const PositionedRun& to = run.runs[static_cast<std::size_t>(run.frames[i].run) + 1];
    if (question.ask == "slide") {
      const Eigen::Vector3d by = to.y().placement.translate - from.y().placement.translate -
                                 to.x().placement.translate + from.x().placement.translate;
      EXPECT_LT((*question.place - *question.origin - in_plane(by)).norm(), 1e-14);
    } else {
      EXPECT_EQ(question.answer.starts_with("they will touch"), to.trace.result.distance == 0.0);
    }
  }
  EXPECT_EQ(asked["slide"], 6);  // once both move alike, and Z stays
  EXPECT_EQ(asked["holds"], 7);
}

TEST(QuestionFrames, RunsFromEachVertexEndAtTheSameP) {
  for (const std::string id : {"polygon-evolution", "simplex", "stop-repeated"}) {
    Lesson lesson = asking(id, {{"start", {}}});
    lesson.phases.clear();
    const std::vector<Asked> all = asked(lesson);
    ASSERT_EQ(all.size(), 1u) << id;
    EXPECT_EQ(all[0].question.question->answer, "at the same P") << id;
  }
}

TEST(QuestionFrames, WhyARunEndsHasOneTrueReasonAndTwoThatItRefutes) {
  const std::map<std::string, std::string> reasons = {
      {"stop-repeated", "no vertex lies farther along d than P"},
      {"stop-contained", "Q lies inside S"},
      {"stop-vertex", "P has reached Q"},
      {"stop-interior-edge", "P came no closer to Q"},
      {"polygons-gjk", "no vertex lies farther along d than P"}};
  for (const auto& [id, reason] : reasons) {
    const Asked why = asked(asking(id, {{"why", {}}})).back();
    EXPECT_EQ(why.question.question->answer, reason) << id;
    EXPECT_EQ(why.question.question->choices.size(), 3u) << id;
    EXPECT_FALSE(why.question.question->refuted.empty()) << id;
  }
  // A run that its cap ends has no reason to be asked for.
  Lesson capped = asking("polygons-gjk", {{"why", {}}});
  capped.options.iteration_cap = 1;
  EXPECT_TRUE(asked(capped).empty());
}

TEST(QuestionFrames, AnsweredByTheTestsBeforeTheSearch) {
  const auto last = [](const std::string& id) { return asked(asking(id, {{"stop", {}}})).back(); };
  const Asked contained = last("stop-contained");
  EXPECT_EQ(contained.question.question->answer, "Q inside S");
  EXPECT_EQ(contained.answer.phase, "stop");
  const Asked at_vertex = last("stop-vertex");
  EXPECT_EQ(at_vertex.question.question->answer, "d = 0");
  EXPECT_EQ(at_vertex.answer.phase, "direction");
  EXPECT_EQ(last("stop-edge-right").question.question->answer, "P no closer");
  EXPECT_EQ(last("collinear").question.question->answer, "V not in S, no farther");
}

TEST(QuestionFrames, OfPolygonsAskForBothVertices) {
  const std::vector<Asked> all = asked(asking("polygons-gjk", {{"support", 1}}));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].question.question->choices.size(), 20u);
  EXPECT_EQ(all[0].question.question->answer, "L−D");
  EXPECT_NE(all[0].question.detail.find("K  ·  L  ·  M  ·  N"), std::string::npos);
}

TEST(QuestionFrames, OfferTheRegionsNotRuledOutInAnOrderThatDoesNotGiveTheAnswerAway) {
  Lesson lesson = asking("triangle-ordered-test", {{"region", {}}});
  struct Case {
    Eigen::Vector2d q;
    std::string answer;
    Choices choices;
  };
  const std::vector<Case> cases = {
      {{1.0, 1.5}, "BC", {"ABC", "BC", "CA"}},
      {{-1.9, 0.9}, "CA", {"ABC", "CA"}},
      {{0.0, -1.8}, "AB", {"AB", "ABC", "BC", "CA"}},
      {{0.3, 2.4}, "C", {"AB", "ABC", "BC", "C", "CA"}},
  };
  for (const Case& one : cases) {
    lesson.x().vertices = {in_space(one.q)};
    const std::vector<Asked> all = asked(lesson);
    ASSERT_EQ(all.size(), 1u) << one.answer;
    EXPECT_EQ(all[0].question.question->choices, one.choices) << one.answer;
    EXPECT_EQ(all[0].question.question->answer, one.answer);
    EXPECT_TRUE(all[0].answer.caption.starts_with("Answer: " + one.answer + "."));
  }
}

TEST(QuestionFrames, OfARegionDrawOnlyRegionsThatAreRuledOut) {
  const LessonRun run = run_lesson(asking("triangle-ordered-test", {{"region", {}}}));
  EffectGraph effects(run);
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  const std::vector<FramePicture> frames = lesson_pictures(run, effects, fonts);
  const auto drawn = [&](std::size_t frame) {
    std::vector<int> regions;
    for (const Mark& mark : frames[frame].picture.marks) {
      const bool is_region = mark.subject.kind == Subject::Kind::region;
      if (is_region && mark.role != "region.hidden") regions.push_back(mark.subject.x);
    }
    std::sort(regions.begin(), regions.end());
    return regions;
  };
  const auto count = [&](std::size_t frame, const std::string& role) {
    return std::count_if(frames[frame].picture.marks.begin(), frames[frame].picture.marks.end(),
                         [&](const Mark& mark) { return mark.role == role; });
  };
  ASSERT_EQ(frames.size(), 7u);
  EXPECT_EQ(drawn(0), std::vector<int>{});
  EXPECT_EQ(count(0, "region.border"), 0);
  EXPECT_EQ(drawn(1), std::vector<int>{0b001});
  EXPECT_EQ(count(1, "region.border"), 2);
  const std::vector<int> ruled_out = {0b001, 0b010, 0b011, 0b100};
  for (const std::size_t frame : {4u, 5u}) {
    EXPECT_EQ(drawn(frame), ruled_out) << frame;
    EXPECT_EQ(count(frame, "region.label"), 4) << frame;
    EXPECT_EQ(count(frame, "region.active"), 0) << frame;
  }
  ASSERT_TRUE(frames[5].text.question);
  EXPECT_EQ(drawn(6).size(), 7u);
  EXPECT_EQ(count(6, "region.border"), 6);
  EXPECT_EQ(count(6, "region.active"), 1);
}

TEST(QuestionFrames, AskForNoSupportPointWhereTwoVerticesLieEquallyFar) {
  EXPECT_TRUE(asked(asking("stop-repeated", {{"support", {}}})).empty());
  EXPECT_TRUE(asked(asking("stop-edge-left", {{"support", {}}})).empty());
  const Lesson lesson = asking("polygons-gjk", {{"support", {}}});
  EXPECT_EQ(run_lesson(lesson).runs[0].trace.result.iterations, 4);
  EXPECT_EQ(asked(lesson).size(), 3u) << "in the last C and D lie equally far along −d";
}

TEST(QuestionFrames, TheAnswerIsAmongTheChoices) {
  for (const std::string id : {"polygon-evolution", "polygons-gjk", "polygon-pseudocode"}) {
    const std::vector<Asked> all =
        asked(asking(id, {{"support", {}}, {"region", {}}, {"dropped", {}}, {"stop", {}}}));
    EXPECT_GT(all.size(), 6u) << id;
    for (const Asked& one : all) {
      const FrameQuestion& question = *one.question.question;
      EXPECT_NE(std::find(question.choices.begin(), question.choices.end(), question.answer),
                question.choices.end())
          << id << ": " << one.question.caption << " " << question.answer;
      EXPECT_TRUE(one.answer.caption.starts_with("Answer")) << one.answer.caption;
    }
  }
}

TEST(QuestionFrames, DrawWhatTheLastFrameDrewAndNothingOfWhatComes) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygon-evolution"));
  EffectGraph effects(run);
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  const std::vector<FramePicture> frames = lesson_pictures(run, effects, fonts);
  const auto count = [](const FramePicture& frame, const std::string& role) {
    return std::count_if(frame.picture.marks.begin(), frame.picture.marks.end(),
                         [&](const Mark& mark) { return mark.role == role; });
  };
  int questions = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    if (!frames[i].text.question) continue;
    ++questions;
    EXPECT_EQ(count(frames[i], "timeline.ahead"), 0);
    EXPECT_EQ(count(frames[i], "caption"), 0);
    EXPECT_GE(count(frames[i], "caption.question"), 1);
    for (const char* role : {"simplex.edge", "simplex.vertex", "support", "direction", "closest"})
      EXPECT_EQ(count(frames[i], role), count(frames[i - 1], role)) << role;
  }
  EXPECT_EQ(questions, 4);
}

TEST(QuestionFrames, TheFramesBeforeThemDoNotTellWhatComesAfter) {
  const Fonts fonts(std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  for (const char* id : {"polygon-evolution", "polygons-gjk", "triangle-ordered-test"}) {
    const LessonRun run = run_lesson(testing::shipped_lesson(id));
    EffectGraph effects(run);
    const std::vector<FramePicture> frames = lesson_pictures(run, effects, fonts);
    int next = -1;
    for (int i = static_cast<int>(frames.size()) - 1; i >= 0; --i) {
      if (run.frames[static_cast<std::size_t>(i)].question >= 0) next = i;
      if (next < 0) continue;
      const FramePicture& frame = frames[static_cast<std::size_t>(i)];
      EXPECT_EQ(frame.text.position.find(" of "), std::string::npos) << frame.text.position;
      for (const Mark& mark : frame.picture.marks) {
        if (mark.subject.kind != Subject::Kind::frame) continue;
        EXPECT_EQ(mark.role == "timeline.hidden", mark.subject.x > next)
            << id << ", frame " << i + 1;
      }
    }
    EXPECT_GE(next, 0);
  }
}

TEST(QuestionFrames, LeftOutTheOthersSayWhatTheySaidBefore) {
  Lesson lesson = testing::shipped_lesson("polygons-gjk");
  lesson.questions.clear();
  for (const FrameText& text : texts_of_frames(lesson)) {
    EXPECT_FALSE(text.question);
    EXPECT_FALSE(text.caption.starts_with("Answer")) << text.caption;
  }
}

}  // namespace question_test
}  // namespace gjkscope
