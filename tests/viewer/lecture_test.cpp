// A lesson as it is given: its questions, the answers, and what a lecture adds to the window.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "headless_app.hpp"
#include "lesson/load.hpp"
#include "picture/words.hpp"
#include "run/run.hpp"
#include "session/edit.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace lecture_test {

using nlohmann::json;
using test::HeadlessApp;
using Kind = Subject::Kind;

/// At the next question of this kind, questions before it untold.
void go_to_question(HeadlessApp& window, const std::string& ask) {
  Session& session = window.session();
  for (int i = 0; i < 60 && !(session.question() && session.question()->ask == ask); ++i)
    window.key("PageDown");
  ASSERT_TRUE(session.question() && session.question()->ask == ask) << ask;
}

/// The state that the window reports.
json state(HeadlessApp& window) { return json::parse(window.app().state_json()); }

gjk::VertexPair asked_pair(Session& session) {
  const auto step = static_cast<std::size_t>(session.frame().answering_step);
  return session.run().run(session.frame()).trace.steps[step].after.support.pair;
}

TEST(Lecture, AClickerShowsTheFramesOfTheExport) {
  for (const char* id : {"polygon-evolution", "polygons-gjk", "simplex"}) {
    HeadlessApp window(id);
    Session& session = window.session();
    window.key("PageDown");
    const LessonRun exported = run_lesson(session.lesson());
    ASSERT_EQ(static_cast<int>(exported.frames.size()), session.frame_count()) << id;
    const auto asks = [](const Frame& frame) { return frame.question >= 0; };
    const auto expected = std::count_if(exported.frames.begin(), exported.frames.end(), asks);
    EXPECT_GT(expected, 0) << id;
    std::ptrdiff_t questions = 0;
    for (int i = 0; i < session.frame_count(); ++i) {
      EXPECT_EQ(exported.frames[static_cast<std::size_t>(i)].question,
                session.run().frames[static_cast<std::size_t>(i)].question)
          << id << " " << i;
    }
    for (int i = 0; i < 60; ++i) {
      questions += session.question() ? 1 : 0;
      window.key("PageDown");
    }
    EXPECT_EQ(expected, questions) << id;
    EXPECT_EQ(session.frame_count() - 1, session.index()) << "and comes to the end";
  }
}

TEST(Lecture, TheArrowsShowNoQuestionBeforeAClickerOrALectureDoes) {
  HeadlessApp window("polygon-evolution");
  const int plain = window.session().frame_count();
  for (int i = 0; i < plain; ++i) {
    EXPECT_FALSE(window.session().question());
    window.key("Right");
  }
  window.key("F5");
  EXPECT_EQ(plain + 4, window.session().frame_count());
  window.key("Escape");
  window.key("P");
  window.key("P");
  EXPECT_EQ(plain, window.session().frame_count()) << "who closes Predict is asked nothing";
}

TEST(Lecture, APairIsTwoShortChoices) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "support");
  const FrameQuestion question = *session.question();
  ASSERT_EQ(2u, question.pair.size());
  EXPECT_EQ(question.pair[0].vertices, window.app().asking().choices());
  window.key("2");
  EXPECT_TRUE(session.answers().empty()) << "half of an answer";
  EXPECT_EQ(question.pair[1].vertices, window.app().asking().choices());
  window.key("3");
  ASSERT_EQ(1u, session.answers().size());
  EXPECT_EQ(fmt::format("{}−{}", question.pair[0].vertices[1], question.pair[1].vertices[2]),
            session.answers().back().chosen);
}

TEST(Lecture, EscapeTakesHalfOfAnAnswerBack) {
  HeadlessApp window;
  window.key("P");
  go_to_question(window, "support");
  const auto first = window.app().asking().choices();
  window.key("1");
  EXPECT_NE(first, window.app().asking().choices());
  window.key("Escape");
  EXPECT_EQ(first, window.app().asking().choices());
}

/// At a question of a dozen choices and more: which edge of a round polygon that grows.
void go_to_many_choices(HeadlessApp& window) {
  Session& session = window.session();
  Lesson lesson = session.lesson();
  for (const std::size_t body : {0, 1}) edit::reshape(lesson, body, edit::regular_polygon(60));
  ASSERT_TRUE(window.app().edit("round", std::move(lesson)));
  session.set_predicting(true);
  for (int i = 0; i < session.frame_count(); ++i) {
    session.go_to(i);
    if (session.question() && session.question()->pair.empty() &&
        session.question()->choices.size() >= 12)
      break;
  }
  window.settle();
  ASSERT_TRUE(session.question() && session.question()->choices.size() >= 12);
}

TEST(Lecture, NumbersAboveNineAreTyped) {
  HeadlessApp window("penetration-identical");
  Session& session = window.session();
  go_to_many_choices(window);
  const std::vector<std::string> choices = session.question()->choices;
  window.key("1");
  EXPECT_TRUE(session.answers().empty()) << "10 to 19 begin so, too";
  window.key("2");
  ASSERT_EQ(1u, session.answers().size());
  EXPECT_EQ(choices[11], session.answers().back().chosen);
}

TEST(Lecture, EnterOrAShortWhileMakesADigitANumber) {
  for (const bool waits : {false, true}) {
    HeadlessApp window("penetration-identical");
    Session& session = window.session();
    go_to_many_choices(window);
    const std::vector<std::string> choices = session.question()->choices;
    window.key("1");
    EXPECT_TRUE(session.answers().empty());
    if (waits) {
      EXPECT_TRUE(window.app().wakes_at());
      for (int i = 0; i < 10; ++i) window.frame(0.2);
    } else {
      window.key("Enter");
    }
    ASSERT_EQ(1u, session.answers().size());
    EXPECT_EQ(choices[0], session.answers().back().chosen);
  }
}

Point on_page(const Session& session, std::size_t view, const Eigen::Vector2d& at) {
  const LessonPictures::ShownView shown = session.views()[view];
  return StageMap(shown.card, shown.camera)(at);
}

TEST(Lecture, ARegionIsClickedWhereItIs) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "region");
  const auto& simplex = session.run().state(session.frame()).simplex;
  ASSERT_EQ(2, simplex.count);
  const LessonPictures::ShownView view = session.views()[1];
  ASSERT_EQ(ViewKind::difference, view.kind);
  const SimplexWords words(session.run(), simplex);
  const Eigen::Vector2d a = in_plane(simplex.vertices[0].w);
  const Eigen::Vector2d b = in_plane(simplex.vertices[1].w);
  const auto click = [&](const Eigen::Vector2d& at) {
    const std::size_t before = session.answers().size();
    const bool taken = window.app().asking().click({}, on_page(session, 1, at));
    EXPECT_TRUE(taken);
    EXPECT_EQ(before + 1, session.answers().size());
    if (session.answers().size() == before) return std::string();
    const std::string chosen = session.answers().back().chosen;
    session.forget_answers();
    window.key("Home");
    go_to_question(window, "region");
    return chosen;
  };
  const Eigen::Vector2d across(b.y() - a.y(), a.x() - b.x());
  EXPECT_EQ(words.face(simplex.all()), click(0.5 * (a + b))) << "the middle of the segment";
  EXPECT_EQ(words.face(simplex.all()), click(0.5 * (a + b) + 0.4 * across)) << "beside it";
  EXPECT_EQ(words.face(gjk::face_of(0)), click(a + 0.15 * (a - b))) << "beyond its first end";
  EXPECT_EQ(words.face(gjk::face_of(1)), click(b + 0.15 * (b - a))) << "beyond its last end";
}

TEST(Lecture, APlaceIsPointedAtAndTheAnswerSaysHowFarOffThatWas) {
  HeadlessApp window("guess");
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "closest-y");
  const FrameQuestion question = *session.question();
  ASSERT_TRUE(question.place.has_value());
  EXPECT_FALSE(window.app().asking().click(
      {}, on_page(session, 0, *question.place + Eigen::Vector2d(1.0, 0.0))))
      << "inside of the shape, far from its outline";
  ASSERT_TRUE(window.app().asking().click(
      {}, on_page(session, 0, *question.place + Eigen::Vector2d(0.0, 0.25))));
  ASSERT_EQ(1u, session.answers().size());
  EXPECT_EQ(question.answer, session.answers().back().chosen);
  EXPECT_NE(std::string::npos, session.shown_text().caption.find("You pointed 0.250 away."))
      << session.shown_text().caption;
  window.frame(0.1);
}

TEST(Lecture, ARegionAtANewPlaceOfQIsClickedWhereItIs) {
  HeadlessApp window("segment-regions");
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "region");
  const FrameQuestion question = *session.question();
  const Eigen::Vector2d q = in_plane(session.run().run(session.frame()).x().world.front());
  ASSERT_TRUE(window.app().asking().click({}, on_page(session, 0, q)));
  EXPECT_EQ(question.answer, session.answers().back().chosen) << "Q lies in its own region";
}

TEST(Lecture, ARealClickOnTheSegmentAnswers) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "region");
  const auto& simplex = session.run().state(session.frame()).simplex;
  const Subject ends[] = {
      {Kind::difference_vertex, simplex.vertices[0].pair.x, simplex.vertices[0].pair.y},
      {Kind::difference_vertex, simplex.vertices[1].pair.x, simplex.vertices[1].pair.y}};
  window.click(0.5 * (window.at(ends[0]) + window.at(ends[1])));
  ASSERT_EQ(1u, session.answers().size());
  EXPECT_EQ("region", session.answers().back().ask);
}

TEST(Lecture, ADragIsNoAnswer) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "support");
  const Point at = window.at({Kind::vertex_of_y, -1, 0});
  window.drag(at, at + Point(20.0, 10.0));
  EXPECT_TRUE(session.answers().empty());
  EXPECT_TRUE(session.is_unsaved());
}

TEST(Lecture, TheVerdictAndItsReasonComeBeforeTheNextQuestion) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "support");
  const int asked_at = session.index();
  const FrameQuestion question = *session.question();
  ASSERT_TRUE(session.texts()[static_cast<std::size_t>(asked_at) + 1].question)
      << "two questions in a row";
  const auto wrong = std::find_if(question.choices.begin(), question.choices.end(),
                                  [&](const std::string& c) { return c != question.answer; });
  window.app().asking().choose(*wrong);
  window.settle();
  EXPECT_EQ(asked_at, session.index()) << "the second question waits";
  EXPECT_FALSE(session.question()) << "and the first is answered";
  const FrameText text = session.shown_text();
  ASSERT_TRUE(text.is_right);
  EXPECT_FALSE(*text.is_right);
  EXPECT_NE(std::string::npos, text.caption.find(question.answer)) << text.caption;
  EXPECT_NE(std::string::npos, text.caption.find(*wrong)) << text.caption;
  EXPECT_NE(std::string::npos, text.detail.find("farthest along d")) << text.detail;
  const auto& marks = session.picture().marks;
  EXPECT_TRUE(std::any_of(marks.begin(), marks.end(), [](const Mark& mark) {
    return mark.role == "caption.wrong";
  })) << "on the stage";
  EXPECT_TRUE(window.app().picture().hand().selected == Subject{}) << "nothing stays ringed";
  // Nothing of it goes by itself.
  for (int i = 0; i < 20; ++i) window.frame(1.0);
  EXPECT_EQ(asked_at, session.index());
  EXPECT_TRUE(session.shown_text().is_right.has_value());
  window.key("Right");
  EXPECT_EQ(asked_at + 1, session.index());
  ASSERT_TRUE(session.question());
  EXPECT_EQ("stop", session.question()->ask);
}

TEST(Lecture, AQuestionAnsweredOnceCountsOnce) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "support");
  window.app().asking().choose(session.question()->choices.front());
  const int at = session.index();
  window.key("Left");
  window.key("Right");
  EXPECT_EQ(at, session.index());
  EXPECT_FALSE(session.question());
  window.key("1");
  window.key("1");
  EXPECT_EQ(1u, session.answers().size());
}

TEST(Lecture, TheScoreIsOfTheLessonThatIsOpen) {
  HeadlessApp window;
  window.key("P");
  go_to_question(window, "support");
  window.app().asking().choose(window.session().question()->choices.front());
  EXPECT_EQ(1, window.session().score().second);
  window.app().open_path(window.app().share() / "lessons" / "polygon-evolution.toml");
  EXPECT_EQ(0, window.session().score().second);
  EXPECT_FALSE(window.session().shown_text().is_right) << "no verdict of another lesson";
}

TEST(Lecture, TheListingStopsAtAnOpenQuestion) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "support");
  const int at = session.index();
  window.click(window.at({Kind::phase, static_cast<int>(gjk::Phase::stop)}));
  EXPECT_EQ(at, session.index()) << "an open question is not run over";
  window.key("Home");
  window.click(window.at({Kind::phase, static_cast<int>(gjk::Phase::stop)}));
  EXPECT_TRUE(session.question()) << "on the way the first open question comes";
}

TEST(Lecture, TheDirectionsStandAtTheShapesWhileTheirVerticesAreAsked) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("P");
  go_to_question(window, "support");
  const auto arrows = [&] {
    const std::vector<Mark>& marks = session.picture().marks;
    return std::count_if(marks.begin(), marks.end(), [](const Mark& mark) {
      return std::holds_alternative<Arrow>(mark.shape) && mark.role == "direction";
    });
  };
  EXPECT_EQ(3, arrows()) << "d in the difference, d at Y, −d at X";
  const gjk::VertexPair pair = asked_pair(session);
  EXPECT_GE(pair.x, 0);
}

TEST(Lecture, TheRingShowsThatThePointerMovedAndFades) {
  HeadlessApp window;
  window.move({415.0, 450.0});
  window.key("F5");
  window.resize(1024.0, 768.0);
  window.resize(1920.0, 1080.0);
  const Presenter& presenter = window.app().presenter();
  EXPECT_EQ(0.0, presenter.pointer_opacity(window.app().now())) << "nobody moved it";
  EXPECT_FALSE(window.app().shows_pointer());
  EXPECT_TRUE(window.app().picture().hovered() == Subject{}) << "nor does it light anything up";
  for (int i = 0; i < 40; ++i) window.frame();
  window.move({500.0, 500.0});
  window.move({510.0, 500.0});
  EXPECT_EQ(1.0, presenter.pointer_opacity(window.app().now()));
  EXPECT_TRUE(window.app().wakes_at()) << "or it would not fade";
  for (int i = 0; i < 100; ++i) window.frame(0.1);
  EXPECT_EQ(0.0, presenter.pointer_opacity(window.app().now()));
}

TEST(Lecture, BAndAPeriodBlankTheScreenAndAnyKeyLightsIt) {
  HeadlessApp window;
  window.key("B");
  EXPECT_EQ(false, state(window)["black"]) << "in no lecture";
  window.key("F5", false, true);
  EXPECT_EQ(true, state(window)["presenting"]);
  for (const char* key : {"B", "."}) {
    window.key(key);
    EXPECT_EQ(true, state(window)["black"]) << key;
    const int index = window.session().index();
    window.key("PageDown");
    EXPECT_EQ(false, state(window)["black"]);
    EXPECT_EQ(index, window.session().index());
  }
}

TEST(Lecture, PageDownAtTheEndGoesOnToTheNextLesson) {
  HeadlessApp window("simplex");
  const std::string first = window.session().lesson().id;
  for (int i = 0; i < 60; ++i) window.key("PageDown");
  EXPECT_EQ(first, window.session().lesson().id) << "in no lecture";
  window.key("F5");
  window.key("PageDown");
  EXPECT_NE(first, window.session().lesson().id);
  EXPECT_EQ(0, window.session().index());
  window.key("PageUp");
  EXPECT_EQ(first, window.session().lesson().id);
  EXPECT_EQ(window.session().frame_count() - 1, window.session().index());
}

TEST(Lecture, AClickerIsNotHeldUpByAQuestionThatNobodyAnswers) {
  HeadlessApp window;
  window.key("P");
  window.key("F5");
  for (int i = 0; i < 80; ++i) window.key("Right");
  EXPECT_EQ(window.session().frame_count() - 1, window.session().index());
}

}  // namespace lecture_test
}  // namespace gjkscope
