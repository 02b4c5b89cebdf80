// History, the place in the run, and predict mode.

#include "session/session.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "fonts.hpp"
#include "lesson/schema.hpp"
#include "lessons.hpp"
#include "run/effect_info.hpp"
#include "run/questions.hpp"
#include "run/trail.hpp"
#include "session/edit.hpp"
#include "subjects/growth/growth.hpp"
#include "subjects/growth/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace session_test {

using Eigen::Vector2d;
using std::size_t;
using testing::fonts;
using testing::shipped_lesson;

/// An edit of the lesson that is shown.
bool change(Session& session, const std::string& name, const std::function<void(Lesson&)>& edit) {
  Lesson lesson = session.lesson();
  edit(lesson);
  return session.edit(name, std::move(lesson));
}

void move_y(Session& session, double by) {
  EXPECT_TRUE(change(session, "move", [&](Lesson& lesson) {
    edit::move_shape(lesson, 1, {by, 0.0, 0.0});
  }));
}

/// How often each effect was computed for what is shown.
std::vector<long> effect_runs(Session& session) {
  std::vector<long> runs;
  for (const EffectInfo* effect : registered_effects())
    runs.push_back(session.effects().count(effect->name).runs);
  return runs;
}

TEST(Session, UndoAndRedoGiveBackEveryLesson) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), "file.toml"));
  std::vector<Lesson> states = {session.lesson()};
  for (int i = 0; i < 5; ++i) {
    move_y(session, 0.25);
    states.push_back(session.lesson());
  }
  for (int i = 4; i >= 0; --i) {
    EXPECT_EQ("move", session.undo_name());
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(states[static_cast<std::size_t>(i)], session.lesson());
  }
  EXPECT_FALSE(session.undo());
  for (std::size_t i = 1; i <= 5; ++i) {
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(states[i], session.lesson());
  }
  EXPECT_FALSE(session.redo());
  EXPECT_TRUE(session.undo());
  move_y(session, 1.0);
  EXPECT_EQ("", session.redo_name()) << "a change forgets what was undone";
}

TEST(Session, ADragIsOneEntry) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  const Lesson before = session.lesson();
  session.begin_drag("drag");
  for (int i = 0; i < 20; ++i)
    session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {0.01, 0.0, 0.0}); });
  session.end_drag();
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(before, session.lesson());
  EXPECT_FALSE(session.undo());
}

/// X is larger than a lesson file may say.
Lesson large_lesson() {
  Lesson lesson = shipped_lesson("polygons-gjk");
  constexpr int kVertices = limits::kVertices + 1;
  lesson.x().vertices.clear();
  lesson.x().vertex_names.clear();
  for (int i = 0; i < kVertices; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kVertices;
    lesson.x().vertices.emplace_back(std::cos(turn), std::sin(turn), 0.0);
    lesson.x().vertex_names.push_back(std::to_string(i));
  }
  return lesson;
}

void drag_y(Session& session, double by) {
  session.begin_drag("drag");
  session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {by, 0.0, 0.0}); });
}

TEST(Session, ADragBesideComesToWhatOneThatIsWaitedForComesTo) {
  Session waiting(fonts());
  Session session(fonts());
  session.work_beside();
  for (Session* each : {&waiting, &session}) {
    ASSERT_TRUE(each->open(large_lesson(), {}));
    each->go_to(3);
    (void)each->picture();
    drag_y(*each, 0.25);
  }
  EXPECT_NE(session.run().lesson.y().vertices, session.lesson().y().vertices);
  const auto first = session.work();
  EXPECT_FALSE(session.work()) << "one after the other";
  for (Session* each : {&waiting, &session})
    each->drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {0.25, 0.0, 0.0}); });
  session.take_work(first());
  EXPECT_NE(session.run().lesson.y().vertices, session.lesson().y().vertices);
  session.take_work(session.work()());
  EXPECT_EQ(session.run().lesson.y().vertices, session.lesson().y().vertices);
  EXPECT_EQ(waiting.picture(), session.picture());
  EXPECT_FALSE(session.work());

  for (Session* each : {&waiting, &session}) each->end_drag();
  EXPECT_TRUE(session.is_settling());
  session.take_work(session.work()());
  EXPECT_FALSE(session.is_settling());
  EXPECT_EQ(waiting.index(), session.index());
  for (const int step : {3, 5, 0}) {
    for (Session* each : {&waiting, &session}) each->go_to(step);
    EXPECT_EQ(waiting.picture(), session.picture()) << step;
  }
  EXPECT_FALSE(waiting.is_settling());
}

TEST(Session, ADragBesideIsCancelledAtOnce) {
  Session session(fonts());
  session.work_beside();
  ASSERT_TRUE(session.open(large_lesson(), {}));
  session.go_to(3);
  const Lesson before = session.lesson();
  const Picture shown = session.picture();
  drag_y(session, 0.25);
  session.take_work(session.work()());
  session.end_drag();
  const auto work = session.work();
  session.cancel_drag();
  EXPECT_FALSE(session.is_settling());
  EXPECT_EQ(before, session.lesson());
  EXPECT_EQ("", session.undo_name());
  EXPECT_EQ(3, session.index());
  EXPECT_EQ(shown, session.picture());
  session.take_work(work());
  EXPECT_EQ(shown, session.picture()) << "nobody waits for it any more";
  // Nor does a drag after it take it for its own.
  drag_y(session, 0.5);
  const auto old = session.work();
  session.cancel_drag();
  drag_y(session, 1.0);
  session.take_work(old());
  EXPECT_EQ(before.y().vertices, session.run().lesson.y().vertices);
}

TEST(Session, ADragBesideThatCannotBeShownHasNotBeen) {
  Session session(fonts());
  session.work_beside();
  ASSERT_TRUE(session.open(large_lesson(), {}));
  const Lesson before = session.lesson();
  session.begin_drag("drag");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  session.drag([&](Lesson& lesson) { lesson.y().vertices[0].x() = nan; });
  session.end_drag();
  session.take_work(session.work()());
  EXPECT_FALSE(session.is_settling());
  EXPECT_NE("", session.problem());
  EXPECT_EQ(before, session.lesson());
  drag_y(session, 0.25);
  session.end_drag();
  EXPECT_TRUE(session.undo()) << "what is asked for meanwhile is waited for";
  EXPECT_FALSE(session.is_settling());
  EXPECT_EQ(before, session.lesson());
  EXPECT_EQ(before.y().vertices, session.run().lesson.y().vertices);
}

TEST(Session, TheRunFollowsADragToTheBit) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  session.begin_drag("drag");
  for (int i = 0; i < 10; ++i) {
    session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {-0.1, 0.03, 0.0}); });
    const LessonRun fresh = run_lesson(session.lesson());
    EXPECT_EQ(fresh.runs[0].trace.result.distance, session.run().runs[0].trace.result.distance);
  }
  session.end_drag();
}

TEST(Session, AfterAnEditTheSamePhaseAndIterationStay) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  for (int i = 0; i < session.frame_count(); ++i) {
    session.go_to(i);
    const std::string before = session.text().phase;
    const int iteration = session.text().iteration;
    move_y(session, 1e-3);
    EXPECT_EQ(before, session.text().phase);
    EXPECT_EQ(iteration, session.text().iteration);
  }
  session.go_to(session.frame_count() - 1);
  // Far apart along x two iterations do: the place is the last one there is.
  move_y(session, 100.0);
  EXPECT_LT(session.index(), session.frame_count());
}

TEST(Session, AfterAnEditTheSamePhaseAndIterationOfAnyAlgorithmStay) {
  for (const char* id : {"penetration-depth", "penetration-nested"}) {
    Session session(fonts());
    ASSERT_TRUE(session.open(shipped_lesson(id), {}));
    const auto where = [&] { return std::pair(session.text().iteration, session.text().phase); };
    const auto iterations_of_gjk = [&] {
      return session.run().run(session.frame()).trace.result.iterations;
    };
    const int before = iterations_of_gjk();
    int kept_though_gjk_took_longer = 0;
    for (int edit = 0; edit < 961; ++edit) {
      const Vector2d by(0.2 * (edit % 31 - 15), 0.2 * (edit / 31 - 15));
      session.go_to(session.frame_count() / 2);
      const auto was = where();
      ASSERT_TRUE(change(session, "move",
                         [&](Lesson& lesson) { edit::move_shape(lesson, 1, in_space(by)); }));
      const auto now = where();
      bool is_there = false;
      for (int i = 0; i < session.frame_count(); ++i) {
        session.go_to(i);
        is_there |= where() == was;
      }
      if (is_there) {
        EXPECT_EQ(now, was) << id << ", moved by " << by.transpose();
        kept_though_gjk_took_longer += iterations_of_gjk() > before;
      }
      session.undo();
    }
    EXPECT_GT(kept_though_gjk_took_longer, 0) << id;
  }
}

TEST(Session, StepsByIterationStandAtTheFirstFrameOfEach) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  std::vector<int> forth = {session.index()};
  while (session.step_iteration(1)) forth.push_back(session.index());
  for (std::size_t i = 1; i + 1 < forth.size(); ++i) {
    session.go_to(forth[i]);
    EXPECT_EQ("closest", session.text().phase);
    EXPECT_EQ(static_cast<int>(i), session.text().iteration);
  }
  session.go_to(forth.back());
  std::vector<int> back;
  while (session.step_iteration(-1)) back.push_back(session.index());
  EXPECT_EQ(0, back.back());
}

TEST(Session, GoesToTheNextRunOfAPhaseAndFromTheStartAgain) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  std::vector<int> iterations;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(session.go_to_next("support"));
    EXPECT_EQ("support", session.text().phase);
    iterations.push_back(session.text().iteration);
  }
  EXPECT_EQ((std::vector<int>{1, 2, 3, 4, 1}), iterations);
}

TEST(Session, ARunThatCannotBeShownLeavesAllAsItWas) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  const Lesson before = session.lesson();
  const auto break_it = [](Lesson& lesson) {
    lesson.y().vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
  };
  EXPECT_FALSE(change(session, "break", break_it));
  EXPECT_NE("", session.problem());
  EXPECT_EQ(before, session.lesson());
  EXPECT_EQ("", session.undo_name());
  session.begin_drag("break");
  session.drag(break_it);
  EXPECT_NE("", session.problem());
  EXPECT_FALSE(session.picture().marks.empty());
  session.end_drag();
  EXPECT_EQ(before, session.lesson());
  Lesson broken = before;
  break_it(broken);
  EXPECT_FALSE(session.reload(broken));
  EXPECT_FALSE(session.open(broken, {}));
  EXPECT_EQ(before, session.lesson());
}

TEST(Session, ReloadKeepsThePlaceAndCanBeUndone) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), "a.toml"));
  session.go_to(9);
  const Lesson before = session.lesson();
  Lesson other = before;
  other.title = "Other";
  ASSERT_TRUE(session.reload(other));
  EXPECT_EQ(9, session.index());
  EXPECT_FALSE(session.is_unsaved());
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(before, session.lesson());
  EXPECT_TRUE(session.is_unsaved());
}

TEST(Session, WhatTheFileHoldsIsSavedHoweverOneCameThere) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), "a.toml"));
  move_y(session, 0.25);
  EXPECT_TRUE(session.is_unsaved());
  ASSERT_TRUE(session.undo());
  EXPECT_FALSE(session.is_unsaved());
  ASSERT_TRUE(session.redo());
  EXPECT_TRUE(session.is_unsaved());
  const Lesson moved = session.lesson();
  session.mark_saved("a.toml", moved);
  EXPECT_FALSE(session.is_unsaved());
  ASSERT_TRUE(session.undo());
  EXPECT_TRUE(session.is_unsaved()) << "the file holds what was moved";
  ASSERT_TRUE(session.revert());
  EXPECT_EQ(moved, session.lesson());
  EXPECT_FALSE(session.is_unsaved());
  EXPECT_TRUE(session.all_unsaved().empty());
  EXPECT_EQ("revert", session.undo_name());
}

TEST(Session, WhatHasNoFileIsNotSavedAndCannotBeReverted) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}, true));
  EXPECT_TRUE(session.is_unsaved());
  EXPECT_FALSE(session.revert());
}

TEST(Session, WhatALessonFileCouldNotSayIsRefusedInTheLoadersWords) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  EXPECT_FALSE(change(session, "cap", [](Lesson& lesson) { lesson.options.iteration_cap = -1; }));
  EXPECT_NE(std::string::npos, session.problem().find("cap")) << session.problem();
}

TEST(Session, PanningZoomingFittingAndResizingRunNothing) {
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    Session session(fonts());
    ASSERT_TRUE(session.open(lesson, {}));
    session.go_to(session.frame_count() - 1);
    (void)session.picture();
    const std::vector<long> before = effect_runs(session);
    const LessonRun* const run = &session.run();
    for (std::size_t view = 0; view < session.views().size(); ++view) {
      Camera camera = session.views()[view].camera;
      camera.center += Eigen::Vector3d(0.25, -0.5, 0.0);
      camera.height *= 1.5;
      session.set_camera(view, camera);
      (void)session.picture();
    }
    session.set_page(page_of(1920, 1200));
    (void)session.picture();
    session.fit();
    (void)session.picture();
    EXPECT_EQ(run, &session.run()) << lesson.id;
    EXPECT_EQ(before, effect_runs(session)) << lesson.id;
  }
}

TEST(Session, AnotherLessonTakesNothingAway) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), "a.toml"));
  EXPECT_EQ("", session.undo_name());
  const Lesson first = session.lesson();
  ASSERT_TRUE(change(session, "move", [](Lesson& lesson) { lesson.x().vertices[0].x() -= 1.0; }));
  const Lesson edited = session.lesson();
  session.go_to(9);
  ASSERT_TRUE(session.open(shipped_lesson("segment-regions"), "b.toml"));
  EXPECT_FALSE(session.is_unsaved());
  ASSERT_EQ(1u, session.all_unsaved().size());
  EXPECT_EQ(edited, session.all_unsaved()[0].lesson);
  EXPECT_EQ("a.toml", session.all_unsaved()[0].file);
  session.go_to(3);

  ASSERT_TRUE(session.undo());
  EXPECT_EQ(edited, session.lesson());
  EXPECT_EQ("a.toml", session.file());
  EXPECT_EQ(9, session.index());
  EXPECT_TRUE(session.is_unsaved());
  ASSERT_TRUE(session.redo());
  EXPECT_EQ("segment-regions", session.lesson().id);
  EXPECT_EQ("b.toml", session.file());
  EXPECT_EQ(3, session.index());
  EXPECT_FALSE(session.is_unsaved());
  ASSERT_TRUE(session.undo());
  session.mark_saved("c.toml", session.lesson());
  ASSERT_TRUE(session.redo());
  EXPECT_TRUE(session.all_unsaved().empty());
  ASSERT_TRUE(session.undo());
  EXPECT_EQ("c.toml", session.file());
  ASSERT_TRUE(session.undo());
  EXPECT_EQ(first, session.lesson());
}

TEST(Session, EveryLessonThatIsNotSavedIsTold) {
  Session session(fonts());
  const auto move = [](Lesson& lesson) { lesson.y().vertices[0].x() -= 0.125; };
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), "a.toml"));
  ASSERT_TRUE(change(session, "move", move));
  ASSERT_TRUE(session.open(shipped_lesson("segment-regions"), "b.toml"));
  ASSERT_TRUE(change(session, "move", move));
  const auto files = [&] {
    std::vector<std::string> out;
    for (const Session::Unsaved& each : session.all_unsaved()) out.push_back(each.file.string());
    return out;
  };
  EXPECT_EQ((std::vector<std::string>{"a.toml", "b.toml"}), files());
  ASSERT_TRUE(session.undo());
  ASSERT_TRUE(session.undo());
  EXPECT_EQ((std::vector<std::string>{"b.toml", "a.toml"}), files()) << "redo leads to b.toml";
  ASSERT_TRUE(session.redo());
  ASSERT_TRUE(session.redo());
  EXPECT_EQ((std::vector<std::string>{"a.toml", "b.toml"}), files());
  session.mark_saved("b.toml", session.lesson());
  EXPECT_EQ((std::vector<std::string>{"a.toml"}), files());
}

TEST(Session, PredictModeAsksBeforeItTellsAndGradesFromTheTrace) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  session.set_predicting(true);
  int asked = 0;
  for (int guard = 0; guard < 500; ++guard) {
    if (const FrameQuestion* question = session.question()) {
      // Always the first choice: right as often as it is the answer.
      const std::string chosen = question->choices.front();
      const std::string answer = question->answer;
      EXPECT_NE(question->choices.end(),
                std::find(question->choices.begin(), question->choices.end(), answer));
      session.answer(chosen);
      ++asked;
      EXPECT_EQ(answer, session.answers().back().right);
      EXPECT_EQ(chosen == answer, session.answers().back().is_right());
      EXPECT_TRUE(session.text().caption.starts_with("Answer") || session.question());
    } else if (!session.step(1)) {
      break;
    }
  }
  EXPECT_EQ(asked, static_cast<int>(session.answers().size()));
  EXPECT_GT(asked, 8);
  EXPECT_GT(session.right_answers(), 0);
  EXPECT_LT(session.right_answers(), asked);
  const nlohmann::json log = nlohmann::json::parse(session.answers_json());
  EXPECT_EQ(asked, log["asked"]);
  EXPECT_EQ(session.right_answers(), log["right"]);
  EXPECT_EQ(static_cast<std::size_t>(asked), log["answers"].size());
  session.set_predicting(false);
  for (const Frame& frame : session.run().frames) EXPECT_LT(frame.question, 0);
}

TEST(Session, WhoPointsAtAPlaceIsToldHowFarOffItWas) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("guess"), {}));
  session.set_asking(true);
  session.go_to(1);
  ASSERT_NE(nullptr, session.question());
  const FrameQuestion asked = *session.question();
  ASSERT_TRUE(asked.place.has_value());
  session.grade(asked.answer, *asked.place + Eigen::Vector2d(0.3, 0.4));
  EXPECT_EQ(2, session.index());
  const std::string caption = session.shown_text().caption;
  EXPECT_TRUE(caption.starts_with("Right: C. You pointed 0.500 away. x is the point")) << caption;
  session.forget_answers();
  session.go_to(1);
  session.grade("A");
  EXPECT_TRUE(session.shown_text().caption.starts_with("Not so: C, not A. "))
      << session.shown_text().caption;
}

TEST(Session, HowFarAnAnswerIsOffIsDrawn) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("guess"), {}));
  session.set_asking(true);
  const auto length_of_way = [&]() -> std::optional<double> {
    const Picture& picture = session.picture();
    for (const Mark& mark : picture.marks) {
      if (mark.role != "verdict.way") continue;
      const auto& ends = std::get<Polyline>(mark.shape).points;
      const auto views = session.views();
      return (ends.back() - ends.front()).norm() /
             StageMap(views.front().card, views.front().camera).scale();
    }
    return std::nullopt;
  };
  EXPECT_FALSE(length_of_way());
  session.go_to(1);
  const FrameQuestion asked = *session.question();
  session.grade(asked.answer, *asked.place + Eigen::Vector2d(0.3, 0.4));
  ASSERT_TRUE(length_of_way());
  EXPECT_NEAR(0.5, *length_of_way(), 1e-9);
  session.go_to(0);
  EXPECT_FALSE(length_of_way());
  session.forget_answers();
  session.go_to(1);
  session.grade("A");
  EXPECT_FALSE(length_of_way());
  const auto ring = [&](const std::string& role) {
    for (const Mark& mark : session.picture().marks) {
      const Disk* disk = mark.role == role ? std::get_if<Disk>(&mark.shape) : nullptr;
      if (disk) return disk->center;
    }
    return Point(Point::Zero());
  };
  const StageMap map(session.views().front().card, session.views().front().camera);
  EXPECT_LT((ring("verdict.right") - map(*asked.place)).norm(), 1e-9);
  const auto at =
      std::find(asked.choices.begin(), asked.choices.end(), "A") - asked.choices.begin();
  EXPECT_LT((ring("verdict.wrong") - map(asked.spots[static_cast<std::size_t>(at)]->from)).norm(),
            1e-9);
}

TEST(Session, AVerdictOnTheStopReadsAsASentence) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  session.set_predicting(true);
  int goes_on = 0;
  int stops = 0;
  for (int i = 0; i < session.frame_count(); ++i) {
    session.go_to(i);
    const FrameQuestion* question = session.question();
    if (!question || question->ask != "stop") continue;
    const bool is_no = question->answer == "no";
    (is_no ? goes_on : stops) += 1;
    const std::string stop = "GJK stops, " + question->answer + ".";
    session.grade(is_no ? "d = 0" : "no");
    const std::string caption = session.shown_text().caption;
    EXPECT_NE(std::string::npos, caption.find(is_no ? "No: GJK goes on." : "Yes: " + stop))
        << caption;
    session.forget_answers();
    session.go_to(i);
    session.grade(is_no ? "no" : question->answer);
    const std::string right = session.shown_text().caption;
    EXPECT_NE(std::string::npos, right.find(is_no ? "Right: GJK goes on." : "Right: " + stop))
        << right;
    session.forget_answers();
  }
  EXPECT_GT(goes_on, 0);
  EXPECT_GT(stops, 0);
}

TEST(Session, WhoAsksToBeAskedInTheMiddleIsToldNothing) {
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    Session session(fonts());
    ASSERT_TRUE(session.open(lesson, {}));
    const int count = session.frame_count();
    for (const int at : {count / 3, count / 2, count - 1}) {
      session.set_predicting(false);
      session.go_to(at);
      session.set_predicting(true);
      EXPECT_FALSE(session.text().caption.starts_with("Answer")) << lesson.id << ", step " << at;
    }
  }
}

TEST(Session, AQuestionForTwoVerticesOffersThemApart) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  session.set_predicting(true);
  while (session.question() == nullptr || session.question()->ask != asks::kSupport.name)
    ASSERT_TRUE(session.step(1));
  const FrameQuestion& asked = *session.question();
  ASSERT_EQ(2u, asked.pair.size());
  EXPECT_EQ("Y", asked.pair[0].shape);
  EXPECT_EQ("X", asked.pair[1].shape);
  std::vector<std::string> joined;
  for (const std::string& y : asked.pair[0].vertices) {
    for (const std::string& x : asked.pair[1].vertices) joined.push_back(y + "−" + x);
  }
  EXPECT_EQ(asked.choices, joined);
}

TEST(Session, UndoBringsTheViewsOfThenBack) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  move_y(session, 0.25);  // holds the cameras
  const auto cameras = [&] {
    std::vector<double> list;
    for (const LessonPictures::ShownView& view : session.views()) {
      for (const double value :
           {view.camera.height, view.camera.center.x(), view.camera.center.y()})
        list.push_back(value);
    }
    return list;
  };
  const std::vector<double> before = cameras();
  move_y(session, 40.0);
  session.fit();
  const std::vector<double> far = cameras();
  EXPECT_NE(before, far);
  EXPECT_TRUE(session.undo(Session::Cameras::as_then));
  EXPECT_EQ(before, cameras());
  EXPECT_TRUE(session.redo(Session::Cameras::as_then));
  EXPECT_EQ(far, cameras());
  session.set_camera(0, Camera{{1.0, -2.0, 0.0}, 5.0});
  const std::vector<double> by_hand = cameras();
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(by_hand[0], cameras()[0]) << "a camera set by hand stays";
}

TEST(Session, AHistoryIsRestoredInAnotherSession) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  std::map<long, Lesson> kept = {{session.lesson_id(), session.lesson()}};
  for (int i = 0; i < 4; ++i) {
    move_y(session, 0.25);
    kept.emplace(session.lesson_id(), session.lesson());
  }
  EXPECT_EQ(5u, kept.size()) << "each lesson has a number of its own";
  session.undo();
  session.undo();
  EXPECT_EQ(session.lesson(), kept.at(session.lesson_id()));
  const auto with_lessons = [&](const std::vector<Session::Kept>& list) {
    std::vector<Session::KeptLesson> out;
    for (const Session::Kept& each : list) out.push_back({each, kept.at(each.id)});
    return out;
  };
  Session other(fonts());
  ASSERT_TRUE(other.open(shipped_lesson("polygons-gjk"), {}));
  ASSERT_TRUE(other.restore(with_lessons(session.past()),
                            {{session.lesson_id(), ""}, session.lesson()},
                            with_lessons(session.future())));
  for (const bool back : {false, true}) {
    for (;;) {
      EXPECT_EQ(session.lesson(), other.lesson());
      EXPECT_EQ(session.lesson_id(), other.lesson_id());
      EXPECT_EQ(session.undo_name(), other.undo_name());
      EXPECT_EQ(session.redo_name(), other.redo_name());
      const bool more = back ? session.undo() : session.redo();
      EXPECT_EQ(more, back ? other.undo() : other.redo());
      if (!more) break;
    }
  }
  move_y(other, 1.0);
  EXPECT_FALSE(kept.contains(other.lesson_id())) << "a number is never given twice";
}

TEST(Session, AnyLessonOpensInPredictMode) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  session.set_predicting(true);
  for (const Lesson& lesson : testing::lessons_for_long_tests())
    EXPECT_TRUE(session.open(lesson, {})) << lesson.id;
}

TEST(Session, ACameraIsSeenAsItWasSetOnAnyPage) {
  for (const auto& [width, height] : {std::pair(1280, 720), {720, 1280}, {2560, 1080}}) {
    Session session(fonts());
    ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
    session.set_page(page_of(width, height));
    session.set_camera(0, Camera{{1.0, -2.0, 0.0}, 5.0});
    EXPECT_NEAR(5.0, session.views()[0].camera.height, 1e-9);
    EXPECT_EQ(Eigen::Vector3d(1.0, -2.0, 0.0), session.views()[0].camera.center);
    // Looking elsewhere does not change the shapes that are saved.
    EXPECT_FALSE(session.is_unsaved());
  }
}

TEST(Session, WhatWasInSightStaysInSightOnAnotherPage) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  // Beside a drawer cards are wide; they become narrow when it is closed.
  const std::vector<Page> pages = {{760.0, 900.0, 1.0}, {1160.0, 760.0, 1.0}, {760.0, 900.0, 1.0}};
  session.set_page(pages.front());
  session.begin_drag("drag");
  session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {0.25, 0.25, 0.0}); });
  session.end_drag();
  const std::vector<LessonPictures::ShownView> before = session.views();
  for (const Page& page : pages) {
    session.set_page(page);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const LessonPictures::ShownView now = session.views()[i];
      const auto half = [](const LessonPictures::ShownView& view) {
        return Vector2d(
            0.5 * view.camera.units_per_pixel(view.card.size().y()).cwiseProduct(view.card.size()));
      };
      EXPECT_GE(half(now).x(), half(before[i]).x() * (1.0 - 1e-9));
      EXPECT_GE(half(now).y(), half(before[i]).y() * (1.0 - 1e-9));
      EXPECT_EQ(now.camera.center, before[i].camera.center);
    }
  }
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(session.views()[i].camera.height, before[i].camera.height, 1e-9) << "and back";
}

TEST(Session, TheLegendStaysWhileShapesAreDragged) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  const auto legend = [&] {
    std::vector<std::string> out;
    for (const Mark& mark : session.picture().marks) {
      if (mark.role == "legend") out.push_back(std::get<Text>(mark.shape).text);
    }
    return out;
  };
  session.set_page({1000.0, 900.0, 1.0});
  session.go_to(answering_index(session.run()));
  const std::vector<std::string> before = legend();
  ASSERT_GE(before.size(), 2u);
  session.begin_drag("drag");
  for (int i = 0; i < 2; ++i) {
    session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {0.01, 0.0, 0.0}); });
    EXPECT_EQ(before, legend());
  }
  session.end_drag();
  EXPECT_EQ(before, legend());
}

TEST(Session, CardsKeepTheirPlaceUnderAHand) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  session.set_page({1280.0, 900.0, 1.0});
  int would_move = 0;
  for (const Vector2d& by : {Vector2d(0.0, 1.0), Vector2d(1.0, 0.0)}) {
    session.fit();
    const std::vector<LessonPictures::ShownView> before = session.views();
    session.begin_drag("drag");
    for (int i = 0; i < 40; ++i) {
      session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, in_space(by)); });
      for (std::size_t k = 0; k < before.size(); ++k)
        ASSERT_EQ(before[k].card, session.views()[k].card) << i;
    }
    session.end_drag();
    session.fit();
    would_move += before[0].card == session.views()[0].card ? 0 : 1;
    session.undo();
  }
  EXPECT_GT(would_move, 0) << "what was dragged would stand elsewhere";
}

TEST(Session, ViewsStandStillWhileShapesMove) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  const Camera before = session.views()[1].camera;
  session.begin_drag("drag");
  session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {0.25, 0.25, 0.0}); });
  EXPECT_NEAR(before.height, session.views()[1].camera.height, 1e-9);
  EXPECT_LT((before.center - session.views()[1].camera.center).norm(), 1e-9);
  session.end_drag();
  session.fit();
  EXPECT_GT((before.center - session.views()[1].camera.center).norm(), 0.05);
}

TEST(Session, TheDifferenceStaysInSightWhileShapesAreDragged) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  session.begin_drag("drag");
  for (int i = 0; i < 40; ++i) {
    session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {0.5, -0.25, 0.0}); });
    const LessonPictures::ShownView view = session.views()[1];
    const PositionedRun& run = session.run().run(session.frame());
    for (const Vector2d& y : in_plane(run.y().world)) {
      for (const Vector2d& x : in_plane(run.x().world)) {
        const Vector2d off =
            (y - x - in_plane(view.camera.center)) * (view.card.size().y() / view.camera.height);
        EXPECT_LE(std::abs(off.x()), 0.5 * view.card.size().x());
        EXPECT_LE(std::abs(off.y()), 0.5 * view.card.size().y());
      }
    }
  }
  session.end_drag();
}

TEST(Session, ADragKeepsTheZoomThatSomebodyChose) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  Camera near = session.views()[1].camera;
  near.height *= 1e-3;
  session.set_camera(1, near);
  for (const std::optional<size_t>& held : {std::optional<size_t>(), std::optional<size_t>(1)}) {
    session.begin_drag("drag", held);
    for (int i = 0; i < 10; ++i) {
      session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {0.5, -0.25, 0.0}); });
      EXPECT_EQ(near.height, session.views()[1].camera.height);
      EXPECT_EQ(near.center, session.views()[1].camera.center);
    }
    session.end_drag();
    EXPECT_EQ(near.height, session.views()[1].camera.height);
  }
}

TEST(Session, TheViewUnderAHandStandsStillUntilItIsLetGo) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  const Camera before = session.views()[1].camera;
  session.begin_drag("drag", 1);
  for (int i = 0; i < 40; ++i) {
    session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {0.5, -0.25, 0.0}); });
    EXPECT_LT((before.center - session.views()[1].camera.center).norm(), 1e-9);
  }
  session.end_drag();
  EXPECT_GT((before.center - session.views()[1].camera.center).norm(), 0.05)
      << "what would be out of sight is fitted";
}

TEST(Session, WhoStandsAtTheLastFrameStaysThere) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  session.go_to(session.frame_count() - 1);
  session.begin_drag("drag");
  std::set<int> counts;
  for (int i = 0; i < 40; ++i) {
    session.drag([&](Lesson& lesson) { edit::move_shape(lesson, 1, {-0.1, 0.02, 0.0}); });
    EXPECT_EQ(session.frame_count() - 1, session.index());
    counts.insert(session.frame_count());
  }
  session.end_drag();
  EXPECT_GT(counts.size(), 2u) << "runs of different lengths";
}

/// Lessons of algorithms on outlines, which a drag can make cross themselves.
std::vector<Lesson> lessons_of_outlines() {
  std::vector<Lesson> out;
  for (Lesson& lesson : testing::shipped_lessons()) {
    const Tour* tour = vocabulary().tour(lesson.tour);
    if (tour->algorithm->takes_outlines && !lesson.settings.as<LessonGrowth>())
      out.push_back(std::move(lesson));
  }
  return out;
}

TEST(Session, ACornerOfAnOutlineMayBeDraggedAnywhere) {
  std::set<std::string> refusing;
  for (const Lesson& lesson : lessons_of_outlines()) {
    SCOPED_TRACE(lesson.id);
    Session session(fonts());
    ASSERT_TRUE(session.open(lesson, {}));
    for (const size_t body : {0, 1}) {
      session.begin_drag("drag");
      // Across its own outline, onto another corner, far away.
      for (const Vector2d& to :
           {Vector2d(0.0, 0.0), Vector2d(-5.0, 3.0), Vector2d(5.0, -3.0),
            Vector2d(in_plane(lesson.bodies[body].vertices[1])), Vector2d(1e6, 1.0)}) {
        session.drag([&](Lesson& edited) {
          edit::put_vertex(edited, body, 0, session.run().runs[0].bodies[body].placement,
                           in_space(to));
        });
        EXPECT_EQ("", session.problem());
        for (const int place : {0, session.frame_count() / 2, session.frame_count() - 1}) {
          session.go_to(place);
          EXPECT_FALSE(session.picture().marks.empty());
          EXPECT_FALSE(session.text().caption.empty());
        }
        if (session.frame_count() == 1) refusing.insert(session.text().caption);
      }
      session.end_drag();
      EXPECT_TRUE(session.undo());
      EXPECT_EQ(lesson, session.lesson());
    }
  }
  for (const char* words : {"not simple", "not convex"}) {
    EXPECT_TRUE(std::any_of(refusing.begin(), refusing.end(), [&](const std::string& caption) {
      return caption.find(words) != std::string::npos;
    })) << words;
  }
}

TEST(Session, WhatDependsOnNoShapeIsMeasuredOnce) {
  Lesson lesson = shipped_lesson("lazy-hull");
  lesson.settings.edit<LessonGrowth>().vertices = {3, 5};
  Session session(fonts());
  ASSERT_TRUE(session.open(lesson, {}));
  const auto runs = [&] { return session.effects().count(Growth::kName).runs; };
  EXPECT_EQ(runs(), 1);
  move_y(session, 0.25);
  EXPECT_EQ(runs(), 0);
  EXPECT_TRUE(change(session, "rule", [](Lesson& edited) {
    edited.options.direction_rule = gjk::DirectionRule::towards_origin;
  }));
  EXPECT_EQ(runs(), 1);
}

TEST(Session, TheSamePicturesAsTheExports) {
  const Lesson lesson = shipped_lesson("polygons-gjk");
  Session session(fonts());
  ASSERT_TRUE(session.open(lesson, {}));
  Lesson plain = lesson;
  plain.questions.clear();
  const LessonRun run = run_lesson(plain);
  EffectGraph effects(run);
  const std::vector<FramePicture> frames = lesson_pictures(run, effects, fonts());
  ASSERT_EQ(static_cast<int>(frames.size()), session.frame_count());
  for (int i = 0; i < session.frame_count(); ++i) {
    session.go_to(i);
    const Picture& shown = session.picture();
    const Picture& exported = frames[static_cast<std::size_t>(i)].picture;
    ASSERT_EQ(exported.marks.size(), shown.marks.size()) << "frame " << i;
    for (std::size_t k = 0; k < shown.marks.size(); ++k)
      EXPECT_EQ(exported.marks[k].role, shown.marks[k].role);
    EXPECT_EQ(frames[static_cast<std::size_t>(i)].text.caption, session.text().caption);
  }
}

/// Two regular polygons of `count` vertices each, 8 apart.
Case two_of(int count) {
  Case shapes;
  for (int i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / count;
    shapes.a.emplace_back(3.0 * std::cos(turn), 3.0 * std::sin(turn));
    shapes.b.emplace_back(8.0 + 3.0 * std::cos(turn), 3.0 * std::sin(turn));
  }
  return shapes;
}

TEST(ManyVertices, TheOutlineOfTheDifferenceStaysWhereItsPointsAreTooMany) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  ASSERT_TRUE(session.edit("case", edit::with_shapes(session.lesson(), two_of(2000))));
  const std::vector<std::string>& effects = session.lesson().views.at(1).effects;
  EXPECT_EQ(std::count(effects.begin(), effects.end(), "minkowski-hull"), 1);
  EXPECT_EQ(std::count(effects.begin(), effects.end(), "minkowski-cloud"), 0);
  const Picture& picture = session.picture();
  EXPECT_TRUE(std::any_of(picture.marks.begin(), picture.marks.end(),
                          [](const Mark& mark) { return mark.role == "hull.ghost"; }));
}

TEST(ManyVertices, TheOneThatTheHandComesNearIsNamed) {
  using Kind = Subject::Kind;
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  ASSERT_TRUE(session.edit("case", edit::with_shapes(session.lesson(), two_of(1000))));
  session.fit();
  const auto has = [&](const std::string& name) {
    const std::vector<Mark>& marks = session.picture().marks;
    return std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) {
      const Text* text = std::get_if<Text>(&mark.shape);
      return text != nullptr && text->text == name;
    });
  };
  const LessonPictures::ShownView world = session.views()[0];
  const StageMap map(world.card, world.camera);
  const Point at = map(session.run().runs[0].x().world[313]);
  const Subject near = session.vertex_near(at + Point(0.3, 0.2), 24.0);
  EXPECT_EQ(near.kind, Kind::vertex_of_x);
  EXPECT_NEAR(near.x, 313, 1);
  EXPECT_EQ(session.vertex_near(world.card.min + Point(3.0, 3.0), 24.0), Subject{});
  const std::string name = session.lesson().x().vertex_names[static_cast<size_t>(near.x)];
  ASSERT_FALSE(has(name));
  session.point_at({near});
  EXPECT_TRUE(has(name));
  session.step(1);
  EXPECT_TRUE(has(name)) << "in each frame";
  session.point_at({});
  EXPECT_FALSE(has(name));
  // A difference is chosen by its two vertices, too.
  session.point_at({{Kind::difference_vertex, 313, 500}});
  const Lesson& lesson = session.lesson();
  EXPECT_TRUE(has(lesson.x().vertex_names[313]));
  EXPECT_TRUE(has(lesson.y().vertex_names[500]));
  EXPECT_TRUE(has(lesson.y().vertex_names[500] + "−" + lesson.x().vertex_names[313]));
}

/// An enlarged part has room for disks and for other names.
TEST(ManyVertices, AViewThatComesNearNamesWhatIsInSight) {
  Session session(fonts());
  ASSERT_TRUE(session.open(shipped_lesson("polygons-gjk"), {}));
  ASSERT_TRUE(session.edit("case", edit::with_shapes(session.lesson(), two_of(1000))));
  session.fit();
  const auto disks = [&] {
    size_t count = 0;
    for (const Mark& mark : session.picture().marks) count += mark.role == "shape.x.vertex" ? 1 : 0;
    return count;
  };
  EXPECT_LE(disks(), 24u);
  Camera camera = session.views()[0].camera;
  camera.center = session.run().runs[0].x().world[250];
  camera.height /= 12.0;
  session.set_camera(0, camera);
  EXPECT_GT(disks(), 30u);
  EXPECT_LT(disks(), 300u);
  size_t names = 0;
  for (const Mark& mark : session.picture().marks) names += mark.role == "shape.x.label" ? 1 : 0;
  EXPECT_GE(names, 6u);
  EXPECT_LE(names, 30u);
}

}  // namespace session_test
}  // namespace gjkscope
