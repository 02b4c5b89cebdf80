// The window's content, driven by input, without a window.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <thread>

#include "base/file.hpp"
#include "command_line.hpp"
#include "drawers/effects.hpp"
#include "fonts.hpp"
#include "frames/frame.hpp"
#include "golden/pixels.hpp"
#include "headless_app.hpp"
#include "lesson/case.hpp"
#include "lesson/load.hpp"
#include "lessons.hpp"
#include "picture/theme.hpp"
#include "run/trail.hpp"
#include "session/hit.hpp"
#include "study/configuration.hpp"
#include "subjects/course_map/tiles.hpp"
#include "subjects/second_run/table.hpp"
#include "subjects/study/table.hpp"
#include "subjects/study/tour.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace app_test {

namespace fs = std::filesystem;
using test::HeadlessApp;
using test::TemporaryFolder;
using Kind = Subject::Kind;

const Subject kK{Kind::vertex_of_y, -1, 0};

TEST(App, OpensOnTwoPolygonsAtTheStartOfTheirRun) {
  HeadlessApp window;
  EXPECT_EQ("polygons-gjk", window.session().lesson().id);
  EXPECT_EQ(0, window.session().index());
  EXPECT_FALSE(window.session().is_unsaved());
  const int before = window.session().index();
  for (int i = 0; i < 50; ++i) window.frame(1.0);
  EXPECT_EQ(before, window.session().index());
  window.make_thumbnails();
  EXPECT_FALSE(window.app().wakes_at()) << "nothing happens by itself";
}

TEST(App, EachLessonHasASmallPictureWithoutWords) {
  HeadlessApp window;
  for (const ListedLesson& listed : window.app().lessons()) {
    const Lesson lesson = *load_lesson(listed.file, vocabulary()).lesson;
    const Picture picture = thumbnail(lesson, window.app().fonts());
    EXPECT_EQ(thumbnails::kWidth, picture.width);
    EXPECT_GT(picture.marks.size(), 3u) << listed.id;
    for (const Mark& mark : picture.marks)
      EXPECT_FALSE(std::holds_alternative<Text>(mark.shape)) << listed.id << " " << mark.role;
  }
}

TEST(App, ASmallPictureIsMadeAnewWhenItsFileHasChanged) {
  const Fonts fonts(fs::path(GJKSCOPE_SOURCE_DIR) / "assets" / "fonts.toml");
  Thumbnails thumbnails(fonts);
  const TemporaryFolder folder;
  const fs::path file = folder.file("a.toml", "not a lesson");
  const auto made = [&] {
    while (thumbnails.of(file) == nullptr) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      thumbnails.tick();
    }
    return thumbnails.of(file)->marks.size();
  };
  EXPECT_EQ(0u, made());
  const fs::path shipped = fs::path(GJKSCOPE_SOURCE_DIR) / "lessons" / "stop-vertex.toml";
  (void)folder.file("a.toml", test::read_file(shipped));
  EXPECT_EQ(0u, made()) << "nobody has said that the file has changed";
  thumbnails.forget(file);
  EXPECT_GT(made(), 3u);
  fs::remove(file);
  thumbnails.forget(file);
  EXPECT_EQ(0u, made()) << "and without it the window goes on";
}

TEST(App, StepsByKeys) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("Home");
  EXPECT_EQ(0, session.index());
  window.key("Right");
  EXPECT_EQ(1, session.index());
  window.key("PageDown");
  EXPECT_EQ(2, session.index());
  window.key("Left");
  EXPECT_EQ(1, session.index());
  window.key("Right", false, true);
  EXPECT_EQ(2, session.text().iteration);
  window.key("End");
  EXPECT_EQ(session.frame_count() - 1, session.index());
}

TEST(App, RunsUntilSomethingHappens) {
  HeadlessApp window;
  Session& session = window.session();
  const auto until = [&](const char* what) {
    const int before = session.index();
    EXPECT_TRUE(window.app().run_command(what));
    window.settle();
    return session.index() > before;
  };
  const auto pairs = [&] {
    const auto& simplex = session.run().state(session.frame()).simplex;
    std::set<std::string> names;
    for (int i = 0; i < simplex.count; ++i)
      names.insert(session.run().pair_name(simplex.vertices[i].pair));
    return names;
  };
  std::vector<std::set<std::string>> seen = {pairs()};
  while (until("Run until the simplex changes")) {
    EXPECT_NE(seen.back(), pairs());
    seen.push_back(pairs());
  }
  EXPECT_EQ(seen.back(), pairs()) << "there is no change after the last";
  EXPECT_GT(seen.size(), 4u);
  window.key("Home");
  ASSERT_TRUE(until("Run until a vertex is dropped"));
  EXPECT_FALSE(session.run().step(session.frame()).record.dropped.empty());
  ASSERT_TRUE(until("Run until the run ends"));
  EXPECT_EQ(answering_index(session.run()), session.index());
}

TEST(App, TheTableOfStepsGoesWhereOneStands) {
  HeadlessApp window;
  window.resize(1920.0, 1080.0);  // where all columns have room
  window.app().show_drawer("Steps");
  window.key("Home");
  const auto scrolled = [] {
    for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
      if (each->WasActive && std::string(each->Name).find("##steps") != std::string::npos)
        return each->Scroll.y;
    }
    ADD_FAILURE() << "there is no table";
    return 0.0f;
  };
  EXPECT_EQ(0.0f, scrolled());
  window.resize(1920.0, 400.0);
  window.key("End");
  EXPECT_GT(scrolled(), 0.0f);
  window.key("Home");
  EXPECT_EQ(0.0f, scrolled());
}

TEST(App, TheTableOfStepsLeadsToThem) {
  HeadlessApp window;
  window.resize(1920.0, 1080.0);  // where all columns have room
  window.app().show_drawer("Steps");
  window.settle();
  window.key("Right");
  window.key("Right");
  const Rect& area = window.app().picture().area();
  // The rows stand below three buttons and the head of the table.
  std::set<int> reached;
  for (double y = area.min.y(); y < area.max.y(); y += 6.0) {
    window.click({area.max.x() + 60.0, y});
    reached.insert(window.session().index());
  }
  EXPECT_GT(reached.size(), 15u);
}

TEST(App, PlaysAndStopsAtTheEnd) {
  HeadlessApp window;
  window.key("Home");
  window.key("Space");
  EXPECT_TRUE(window.app().wakes_at());
  for (int i = 0; i < 200; ++i) window.frame(1.0);
  EXPECT_EQ(window.session().frame_count() - 1, window.session().index());
  EXPECT_FALSE(window.app().wakes_at());
}

TEST(App, AStepMovesAndComesToRest) {
  HeadlessApp window;
  window.key("Home");
  for (int i = 0; i < 20; ++i) window.frame();
  EXPECT_FALSE(window.app().picture().is_moving());
  window.key("Right");
  EXPECT_TRUE(window.app().picture().is_moving());
  EXPECT_TRUE(window.app().wakes_at()) << "or the window would sleep on the way";
  for (int i = 0; i < 20; ++i) window.frame();
  EXPECT_FALSE(window.app().picture().is_moving());
  EXPECT_TRUE(window.app().run_command("Motion between steps, or none"));
  window.key("Right");
  EXPECT_FALSE(window.app().picture().is_moving());
}

TEST(App, AVertexFollowsTheHandAndTheRunFollowsTheVertex) {
  HeadlessApp window;
  Session& session = window.session();
  const auto before = session.lesson().y().vertices;
  const double distance = session.run().runs[0].trace.result.distance;
  const Point from = window.at(kK);
  window.drag(from, from + Point(60, -40));
  const auto after = session.lesson().y().vertices;
  EXPECT_GT((after[0] - before[0]).norm(), 0.1);
  for (std::size_t i = 1; i < after.size(); ++i) EXPECT_EQ(before[i], after[i]);
  EXPECT_LT((window.at(kK) - from - Point(60, -40)).norm(), 1.5);
  EXPECT_NE(distance, session.run().runs[0].trace.result.distance);
  window.key("Z", true);
  EXPECT_EQ(before, session.lesson().y().vertices);
  window.key("Y", true);
  EXPECT_EQ(after, session.lesson().y().vertices);
}

TEST(App, AHandIsHeldToRoundNumbersByGAndByShift) {
  HeadlessApp window;
  Session& session = window.session();
  const auto is_round = [&] {
    const double step = window.app().picture().grid(0).x();
    const Eigen::Vector3d& at = session.lesson().y().vertices[0];
    return at.x() == std::round(at.x() / step) / std::round(1.0 / step) &&
           at.y() == std::round(at.y() / step) / std::round(1.0 / step);
  };
  const auto drag = [&] {
    const Point at = window.at(kK);
    window.drag(at, at + Point(31.3, 17.7));
  };
  EXPECT_EQ(Eigen::Vector2d::Zero(), window.app().picture().grid(0));
  window.key("G");
  ASSERT_GT(window.app().picture().grid(0).x(), 0.0);
  ASSERT_LT(window.app().picture().grid(0).x(), 1.0);
  drag();
  EXPECT_TRUE(is_round()) << session.lesson().y().vertices[0];
  ImGui::GetIO().KeyShift = true;
  drag();
  ImGui::GetIO().KeyShift = false;
  EXPECT_FALSE(is_round()) << "Shift lets go";
  window.key("G");
  ImGui::GetIO().KeyShift = true;
  drag();
  EXPECT_TRUE(is_round()) << "and Shift holds";
  ImGui::GetIO().KeyShift = false;
}

TEST(App, TheGridIsPartOfThePictureAndOfTheHistory) {
  HeadlessApp window;
  const auto lines = [&] {
    const std::vector<Mark>& marks = window.session().picture().marks;
    return std::count_if(marks.begin(), marks.end(), [](const Mark& mark) {
      return mark.role == "grid.line" || mark.role == "grid.axis";
    });
  };
  EXPECT_EQ(0, lines());
  window.key("G", false, true);
  EXPECT_GT(lines(), 10);
  window.key("G", false, true);
  EXPECT_EQ(0, lines());
  EXPECT_EQ("grid and axes", window.session().undo_name());
}

TEST(App, PinnedValuesStayInSight) {
  HeadlessApp window;
  for (int i = 0; i < 3; ++i) window.key("Right");
  const auto pinned = [&] {
    return nlohmann::json::parse(window.app().state_json())["pinned"].get<std::string>();
  };
  window.key("/");
  window.type("value upper bound");
  window.key("Enter");
  const std::string before = pinned();
  EXPECT_TRUE(before.starts_with("upper bound = ")) << before;
  window.key("End");
  EXPECT_TRUE(pinned().starts_with("upper bound = ")) << pinned();
  EXPECT_NE(before, pinned());
  window.key("Home");
  EXPECT_EQ("upper bound = –", pinned()) << "there is none yet";
  window.app().pinned.clear();
  EXPECT_EQ("", pinned());
}

TEST(App, TwoRunsStandOnTheStage) {
  HeadlessApp window;
  Session& session = window.session();
  const std::string kBoth = "Second run on the stage, or none";
  const auto has_marks_of_second = [&] {
    for (int i = 0; i < session.frame_count(); ++i) {
      session.go_to(i);
      const std::vector<Mark>& marks = session.picture().marks;
      if (std::any_of(marks.begin(), marks.end(),
                      [](const Mark& mark) { return mark.role.starts_with("second."); }))
        return true;
    }
    return false;
  };
  EXPECT_FALSE(has_marks_of_second());
  const std::string hint = window.app().message();
  window.app().run_command(kBoth);
  EXPECT_EQ(ScalarKind::exact, second_of(session.lesson())->scalar);
  EXPECT_TRUE(session.lesson().has_block("two-runs"));
  EXPECT_TRUE(has_marks_of_second());
  window.app().run_command(kBoth);
  EXPECT_FALSE(second_of(session.lesson()));
  EXPECT_FALSE(has_marks_of_second());
  EXPECT_EQ(hint, window.app().message()) << "both were lessons";
}

TEST(App, ALessonWithATableOfItsOwnTakesNoSecondRun) {
  HeadlessApp window("lazy-hull");
  const Lesson before = window.session().lesson();
  const std::string kBoth = "Second run on the stage, or none";
  window.app().run_command(kBoth);
  EXPECT_EQ(before, window.session().lesson());
}

TEST(App, EachEffectThatItOffersIsTakenByTheLesson) {
  int offered = 0;
  for (const Lesson& lesson : testing::shipped_lessons()) {
    if (lesson.settings.file) continue;  // the file is looked for in the lesson's folder
    for (const EffectInfo* info : offered_effects(lesson)) {
      Lesson with = lesson;
      for (LessonView& view : with.views) {
        if (shows_shapes(view.kind) && !view.calls_for(info->name))
          view.effects.emplace_back(info->name);
      }
      EXPECT_TRUE(why_not_said(with).empty()) << lesson.id << to_string(why_not_said(with));
      ++offered;
    }
  }
  EXPECT_GT(offered, 100);
}

TEST(App, AShapeAndTheDifferenceMoveAsAWhole) {
  HeadlessApp window;
  Session& session = window.session();
  const auto y = session.lesson().y().vertices;
  const Point inside = window.at({Kind::shape_y});
  window.drag(inside, inside + Point(30, 10));
  const Eigen::Vector3d by = session.lesson().y().vertices[0] - y[0];
  EXPECT_GT(by.norm(), 0.05);
  for (std::size_t i = 0; i < y.size(); ++i)
    EXPECT_LT((session.lesson().y().vertices[i] - y[i] - by).norm(), 1e-12);
  const auto then = session.lesson().y().vertices;
  const Point z = window.at({Kind::difference});
  window.drag(z, z + Point(0, 40));
  EXPECT_LT(session.lesson().y().vertices[0].y(), then[0].y());
}

TEST(App, TheHandleOfASelectedShapeTurnsIt) {
  HeadlessApp window;
  window.click(window.at({Kind::shape_y}));
  EXPECT_EQ(0.0, window.session().lesson().y().rotate_degrees);
  PictureView& picture = window.app().picture();
  const std::optional<Point> handle = picture.hand().handle();
  ASSERT_TRUE(handle);
  const Point at = picture.area().min + window.session().page().zoom * *handle;
  window.drag(at, at + Point(60, 30));
  EXPECT_LT(window.session().lesson().y().rotate_degrees, -5.0);
}

TEST(App, VerticesAreAddedAndDeleted) {
  HeadlessApp window;
  Session& session = window.session();
  const Point a = window.at({Kind::vertex_of_y, -1, 1});
  const Point b = window.at({Kind::vertex_of_y, -1, 2});
  window.click(0.5 * (a + b), 2);
  ASSERT_EQ(5u, session.lesson().y().vertices.size());
  window.key("Delete");
  EXPECT_EQ(4u, session.lesson().y().vertices.size());
  window.key("Z", true);
  EXPECT_EQ(5u, session.lesson().y().vertices.size());
}

TEST(App, WhatIsSelectedAndWasUndoneIsNotMoved) {
  HeadlessApp window;
  const Point a = window.at({Kind::vertex_of_y, -1, 3});
  const Point b = window.at({Kind::vertex_of_y, -1, 0});
  window.click(0.5 * (a + b), 2);
  ASSERT_EQ(5u, window.session().lesson().y().vertices.size());
  window.key("Z", true);
  const Lesson before = window.session().lesson();
  window.key("Right", true);
  window.key("Delete");
  EXPECT_EQ(before, window.session().lesson());
}

TEST(App, ShapesAreMadeByNameAndByTheListOfCommands) {
  HeadlessApp window;
  Session& session = window.session();
  const auto count = [&](int body) {
    return session.lesson().bodies[static_cast<std::size_t>(body)].vertices.size();
  };
  for (const auto& [command, vertices] : {std::pair("Y becomes a point", 1u),
                                          {"Y becomes a segment", 2u},
                                          {"Y becomes a box", 4u},
                                          {"Y becomes a regular polygon", 6u}}) {
    EXPECT_TRUE(window.app().run_command(command));
    window.settle();
    EXPECT_EQ(vertices, count(1)) << command;
    EXPECT_EQ(command, session.undo_name());
  }
  window.key("/");
  window.type("x polygon of 9");
  window.key("Enter");
  EXPECT_EQ(9u, count(0));
  const Lesson before = session.lesson();
  window.key("/");
  window.type("random pair");
  window.key("Enter");
  EXPECT_NE(before, session.lesson());
  window.key("Z", true);
  EXPECT_EQ(before, session.lesson());
}

TEST(App, ButtonsOfTheDrawerMakeShapes) {
  HeadlessApp window;
  window.app().show_drawer("Shapes");
  window.settle();
  // Whatever stands where: points, segments, boxes, polygons and pairs come of clicks.
  std::set<std::string> done;
  const Rect& area = window.app().picture().area();
  for (double y = area.min.y() + 60.0; y < area.min.y() + 240.0; y += 16.0) {
    for (double x = 30.0; x < 300.0; x += 15.0) {
      window.click({area.max.x() + x, y});
      if (const std::string name = window.session().undo_name(); !name.empty()) done.insert(name);
      window.key("Escape");
      while (window.session().undo()) continue;
      window.settle();
    }
  }
  for (const char* name : {"X becomes a point", "X becomes a segment", "X becomes a box",
                           "X becomes a regular polygon", "radius of X", "random pair"})
    EXPECT_TRUE(done.contains(name)) << name;
}

TEST(App, AListedLessonIsTheSameHoweverItIsNamed) {
  HeadlessApp window;
  const fs::path lessons = window.app().share() / "lessons";
  window.app().open_path(lessons / ".." / "lessons" / "collinear.toml");
  EXPECT_EQ(window.session().lesson().path, (lessons / "collinear.toml").string());
}

TEST(App, AWarmStartIsOffered) {
  HeadlessApp of_one_position;
  const std::string kWarm = "Warm start along the path, or none";
  of_one_position.app().run_command(kWarm);
  EXPECT_FALSE(of_one_position.session().lesson().warm_start);
  HeadlessApp window("segment-regions");
  window.app().run_command(kWarm);
  EXPECT_TRUE(window.session().lesson().warm_start);
  window.key("Z", true);
  EXPECT_FALSE(window.session().lesson().warm_start);
}

TEST(App, TheTimelineAndThePseudocodeLeadToTheirSteps) {
  HeadlessApp window;
  window.click(window.at({Kind::frame, 7}));
  EXPECT_EQ(7, window.session().index());
  const Point from = window.at({Kind::frame, 3});
  const Point to = window.at({Kind::frame, 12});
  window.drag(from, to);
  EXPECT_EQ(12, window.session().index());
  window.click(window.at({Kind::phase, static_cast<int>(gjk::Phase::support)}));
  EXPECT_EQ("support", window.session().text().phase);
}

TEST(App, ThePointedDifferenceIsLinkedToItsVertices) {
  HeadlessApp window;
  window.move(window.at({Kind::difference_vertex, 0, 0}));
  EXPECT_TRUE(is_linked(window.app().picture().hovered(), kK));
  EXPECT_TRUE(is_linked(window.app().picture().hovered(), {Kind::vertex_of_x, 0}));
}

TEST(App, APointedTermIsExplained) {
  HeadlessApp window("polygon-evolution");
  const auto shown = [] {
    const ImGuiWindow* words = ImGui::FindWindowByName("##Tooltip_00");
    return words != nullptr && words->Active && !words->Hidden;
  };
  const std::vector<TermSpot> spots =
      term_spots(window.session().picture(), window.app().fonts(), window.app().terms());
  const auto simplex = std::find_if(spots.begin(), spots.end(), [](const TermSpot& spot) {
    return spot.term->name == "simplex";
  });
  ASSERT_NE(simplex, spots.end());
  window.move(window.app().picture().to_pixel(simplex->box.center()));
  window.settle();
  EXPECT_TRUE(shown());
  window.move(window.app().picture().to_pixel(simplex->box.min - Point(12.0, 12.0)));
  window.settle();
  EXPECT_FALSE(shown());
}

TEST(App, TheWheelZoomsAboutThePointer) {
  HeadlessApp window;
  const Point at = window.at(kK);
  window.move(at);
  const double before = window.session().views()[0].camera.height;
  window.wheel(1.0);
  EXPECT_LT(window.session().views()[0].camera.height, before);
  EXPECT_LT((window.at(kK) - at).norm(), 0.5);
  window.key("F");
  EXPECT_FALSE(window.session().is_unsaved());
}

TEST(App, APredictionIsClickedOnTheStage) {
  HeadlessApp window;
  Session& session = window.session();
  window.key("Home");
  window.key("P");
  for (int i = 0; i < 40 && !(session.question() && session.question()->ask == "support"); ++i) {
    if (session.question()) {
      window.key("1");
    } else {
      window.key("Right");
    }
  }
  ASSERT_TRUE(session.question());
  const int asked = static_cast<int>(session.answers().size());
  window.key("Right");
  ASSERT_TRUE(session.question()) << "an open question is not stepped over";
  const gjk::VertexPair pair =
      session.run()
          .run(session.frame())
          .trace.steps[static_cast<std::size_t>(session.frame().answering_step)]
          .after.support.pair;
  window.click(window.at({Kind::difference_vertex, pair.x, pair.y}));
  ASSERT_EQ(asked + 1, static_cast<int>(session.answers().size()));
  EXPECT_TRUE(session.answers().back().is_right());
}

/// In predict mode, at a question of this kind.
void go_to_question(HeadlessApp& window, const std::string& ask) {
  Session& session = window.session();
  window.key("Home");
  window.key("P");
  for (int i = 0; i < 40 && !(session.question() && session.question()->ask == ask); ++i)
    window.key("PageDown");
  ASSERT_TRUE(session.question() && session.question()->ask == ask);
}

TEST(App, PracticeGoesOnWithAnotherTaskOnceOneIsAnswered) {
  HeadlessApp window;
  Session& session = window.session();
  ASSERT_TRUE(window.app().run_command("Practise chapter 1"));
  window.settle();
  for (int i = 0; i < 3; ++i) {
    const Lesson lesson = session.lesson();
    EXPECT_EQ("practice", lesson.id);
    EXPECT_FALSE(session.is_unsaved());
    ASSERT_TRUE(session.question());
    window.key("W");
    EXPECT_TRUE(lesson == session.lesson()) << "an open question is not passed over";
    window.key("1");
    EXPECT_EQ(nullptr, session.question());
    EXPECT_EQ(i + 1, static_cast<int>(session.answers().size()));
    window.key("W");
    EXPECT_FALSE(lesson == session.lesson());
  }
}

TEST(App, TilesOfTheMapOpenChapters) {
  HeadlessApp window("polygons-gjk");
  window.key("M");
  window.frame();
  ASSERT_EQ("course-map", window.session().lesson().id);
  window.session().go_to(window.session().frame_count() - 1);
  window.frame();
  const std::vector<Rect> tiles = tiles_of_map(window.session().picture());
  ASSERT_GT(tiles.size(), 6u);
  window.click(window.app().picture().to_pixel(tiles[2].center()));
  window.settle();
  EXPECT_EQ(3, window.session().lesson().chapter);
}

TEST(App, PracticeGoesOnWhereItWasLeft) {
  const TemporaryFolder state;
  Lesson left;
  {
    HeadlessApp window("polygons-gjk", state.path());
    ASSERT_TRUE(window.app().run_command("Practise chapter 2"));
    window.key("1");
    window.key("W");
    window.frame();
    left = window.session().lesson();
  }
  HeadlessApp again("polygons-gjk", state.path());
  ASSERT_TRUE(again.app().run_command("Practise chapter 2"));
  EXPECT_TRUE(left == again.session().lesson());
}

TEST(App, APairIsPredictedByItsTwoVertices) {
  HeadlessApp window;
  Session& session = window.session();
  go_to_question(window, "support");
  const gjk::VertexPair pair =
      session.run()
          .run(session.frame())
          .trace.steps[static_cast<std::size_t>(session.frame().answering_step)]
          .after.support.pair;
  window.click(window.at({Kind::vertex_of_y, -1, pair.y}));
  EXPECT_TRUE(session.answers().empty());
  window.click(window.at({Kind::vertex_of_x, pair.x}));
  ASSERT_EQ(1u, session.answers().size());
  EXPECT_TRUE(session.answers().back().is_right());
}

TEST(App, AnyChoiceIsChosenByKeyboard) {
  HeadlessApp window;
  Session& session = window.session();
  go_to_question(window, "support");
  const std::vector<VertexChoice> pair = session.question()->pair;
  for (int i = 0; i < 3; ++i) window.key("Down");
  window.key("Enter");
  window.key("Up");
  window.key("Enter");
  ASSERT_EQ(1u, session.answers().size());
  EXPECT_EQ(fmt::format("{}−{}", pair[0].vertices[3], pair[1].vertices.back()),
            session.answers().back().chosen);
}

TEST(App, CopiesAndPastesTheShapesAsACase) {
  HeadlessApp window;
  std::string clipboard;
  window.app().copy = [&](const std::string& text) { clipboard = text; };
  window.app().paste = [&] { return clipboard; };
  const auto y = window.session().lesson().y().vertices;
  window.key("C", true);
  const auto cases = parse_cases(clipboard, "clipboard");
  ASSERT_TRUE(cases.front().value);
  window.key("V", true);
  EXPECT_EQ(y, window.session().lesson().y().vertices);
  clipboard = "{\"a\": [[0,0]], \"b\": [[1,]]}";
  window.key("V", true);
  EXPECT_NE("", window.app().message());
  EXPECT_EQ(y, window.session().lesson().y().vertices);
}

TEST(App, ALogOpensBesideTheRunOfGjk) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "run.jsonl";
  write_whole(file, std::string_view(R"({"gjk_log":1,"a":[[0,0],[1,0]],"b":[[3,0],[4,2]]}
{"simplex":[[1,0]],"closest":[2,0],"direction":[2,0],"support":[0,1]}
{"answer":{"distance":3}}
)"));
  HeadlessApp window("polygons-gjk");
  window.app().open_path(file);
  window.frame();
  EXPECT_EQ("", window.app().message());
  EXPECT_EQ("two-runs", window.session().lesson().tour);
  EXPECT_TRUE(window.session().file().empty()) << "a log is not saved over";
  EXPECT_NE(std::string::npos, window.session().text().caption.find("The logged run answers 3"));
  write_whole(file, std::string_view("{\"gjk_log\":1,\"a\":[[0,0]]}\n"));
  window.app().open_path(file);
  window.frame();
  EXPECT_NE(std::string::npos, window.app().message().find("run.jsonl:1:"))
      << window.app().message();
}

TEST(App, UnsavedWorkIsOfferedAndTheNamedLessonOpensAsItIs) {
  const TemporaryFolder folder;
  std::vector<Eigen::Vector3d> edited;
  {
    HeadlessApp window("polygons-gjk", folder.path());
    const Point from = window.at(kK);
    window.drag(from, from + Point(50, 0));
    edited = window.session().lesson().y().vertices;
    for (int i = 0; i < 3; ++i) window.frame(1.0);
  }
  {
    HeadlessApp again("stop-vertex", folder.path());
    EXPECT_EQ("stop-vertex", again.session().lesson().id);
    EXPECT_FALSE(again.session().is_unsaved());
    EXPECT_TRUE(again.app().run_command("Quit"));
  }
  HeadlessApp again("stop-vertex", folder.path());
  again.app().run_command("Open unsaved work");
  EXPECT_EQ("polygons-gjk", again.session().lesson().id);
  EXPECT_EQ(edited, again.session().lesson().y().vertices);
  EXPECT_TRUE(again.session().is_unsaved());
  again.key("R", true);
  EXPECT_NE(edited, again.session().lesson().y().vertices);
  EXPECT_FALSE(again.session().is_unsaved()) << "reverted to what the file holds";
  HeadlessApp other("stop-vertex", folder.path());
  other.app().run_command("Open unsaved work");
  EXPECT_EQ("stop-vertex", other.session().lesson().id) << "taken by the other window";
}

TEST(App, DiscardedWorkIsGone) {
  const TemporaryFolder folder;
  {
    HeadlessApp window("polygons-gjk", folder.path());
    const Point from = window.at(kK);
    window.drag(from, from + Point(50, 0));
  }
  {
    HeadlessApp again("", folder.path());
    again.app().run_command("Discard unsaved work");
  }
  HeadlessApp last("stop-vertex", folder.path());
  last.app().run_command("Open unsaved work");
  EXPECT_EQ("stop-vertex", last.session().lesson().id);
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    files += entry.path().extension() == ".toml" ? 1 : 0;
  EXPECT_EQ(0u, files);
}

TEST(App, LessonsThatWereSteppedToTheirEndAreCounted) {
  const TemporaryFolder state;
  {
    HeadlessApp window("polygons-gjk", state.path());
    EXPECT_EQ(0, window.app().progress().done);
    EXPECT_EQ(static_cast<int>(window.app().lessons().size()), window.app().progress().of);
    window.key("End");
    EXPECT_EQ(1, window.app().progress().done);
  }
  HeadlessApp again("stop-vertex", state.path());
  EXPECT_EQ(1, again.app().progress().done);
  int of = 0;
  for (int chapter = 0; chapter < 100; ++chapter) of += again.app().progress(chapter).of;
  EXPECT_EQ(again.app().progress().of, of);
}

/// Whether the command with this name has something to do.
bool can(HeadlessApp& window, std::string_view name) {
  const auto& all = window.app().commands();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Command& command) { return command.name == name; });
  return found != all.end() && found->is_enabled();
}

TEST(App, GoesOnWhereTheWindowWasLeftAndForgetsWhenAsked) {
  const TemporaryFolder state;
  constexpr const char* kContinue = "Continue where the window was left";
  {
    HeadlessApp window("triangle-ordered-test", state.path());
    EXPECT_FALSE(can(window, kContinue));
    for (int i = 0; i < 3; ++i) window.key("Right");
  }
  {
    HeadlessApp again("stop-vertex", state.path());
    EXPECT_TRUE(again.app().run_command(kContinue));
    EXPECT_EQ("triangle-ordered-test", again.session().lesson().id);
    EXPECT_EQ(3, again.session().index());
    EXPECT_FALSE(can(again, kContinue));
    EXPECT_TRUE(again.app().run_command("Forget what was done"));
    again.frame();
    EXPECT_FALSE(can(again, "Forget what was done"));
  }
  HeadlessApp last("stop-vertex", state.path());
  EXPECT_FALSE(can(last, kContinue));
}

TEST(App, AQuestionThatWasAnsweredWrongIsAskedAgain) {
  const TemporaryFolder state;
  constexpr const char* kRepeat = "Repeat a question that was answered wrong";
  int asked = -1;
  std::string right;
  {
    HeadlessApp window("polygons-gjk", state.path());
    Session& session = window.session();
    EXPECT_FALSE(can(window, kRepeat));
    session.set_predicting(true);
    while (session.question() == nullptr) session.step(1);
    asked = session.index();
    right = session.question()->answer;
    const auto& choices = session.question()->choices;
    session.answer(*std::find_if(choices.begin(), choices.end(),
                                 [&](const std::string& choice) { return choice != right; }));
    window.frame();
  }
  HeadlessApp again("stop-vertex", state.path());
  EXPECT_TRUE(again.app().run_command(kRepeat));
  EXPECT_EQ("polygons-gjk", again.session().lesson().id);
  EXPECT_EQ(asked, again.session().index());
  ASSERT_NE(nullptr, again.session().question());
  again.session().answer(right);
  again.frame();
  EXPECT_FALSE(can(again, kRepeat));
}

TEST(App, DamagedMemoryIsLeftOut) {
  const Memory memory =
      memory_of({"finished", "stopped polygons-gjk", "stopped simplex -2", "", "wrong simplex 1",
                 "nothing", "finished simplex", "practised", "practised 3 7 101", "practised 4"});
  EXPECT_EQ((Memory{{"simplex"}, {}, {}, {{3, {7, {true, false, true}}}}}), memory);
  EXPECT_EQ(memory, memory_of(memory_lines(memory)));
}

TEST(App, RecentFilesAreThereAfterAnotherStart) {
  const TemporaryFolder folder;
  const fs::path lessons = fs::path(GJKSCOPE_SOURCE_DIR) / "lessons";
  for (const char* id : {"stop-vertex", "collinear", "polygons-gjk"})
    HeadlessApp(id, folder.path());
  HeadlessApp window("segment-regions", folder.path());
  const std::vector<std::string> expected = {
      (lessons / "segment-regions.toml").string(), (lessons / "polygons-gjk.toml").string(),
      (lessons / "collinear.toml").string(), (lessons / "stop-vertex.toml").string()};
  EXPECT_EQ(expected, window.app().recent());
}

TEST(App, WhatWasPastedIsKeptAndSoIsWorkOnALessonThatWasLeft) {
  const TemporaryFolder folder;
  const auto kept = [&] {
    std::string text;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      if (entry.path().filename().string().starts_with("unsaved-"))
        text += test::read_file(entry.path());
    }
    return text;
  };
  {
    HeadlessApp window("polygons-gjk", folder.path());
    window.app().paste = [] { return R"({"a": [[0, 0.125]], "b": [[7, 0]]})"; };
    window.key("V", true);
    for (int i = 0; i < 3; ++i) window.frame(1.0);
    EXPECT_NE(std::string::npos, kept().find("0.125"));
    window.app().open_path(fs::path(GJKSCOPE_SOURCE_DIR) / "lessons" / "collinear.toml");
    EXPECT_FALSE(window.session().is_unsaved());
  }
  EXPECT_NE(std::string::npos, kept().find("0.125"));
}

TEST(App, WorkIsKeptWhileTheWindowLives) {
  const TemporaryFolder folder;
  HeadlessApp window("polygons-gjk", folder.path());
  constexpr double kMessagesAreGone = 10.0;
  window.frame(kMessagesAreGone);
  Lesson lesson = window.session().lesson();
  lesson.title = "Not saved";
  ASSERT_TRUE(window.app().edit("title", lesson));
  constexpr int kMost = 6000;
  for (int i = 0; i < kMost && window.app().wakes_at(); ++i) {
    usleep(1'000);
    window.frame(1.0);
  }
  ASSERT_FALSE(window.app().wakes_at()) << "it comes to rest";
  std::string kept;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (entry.path().extension() == ".toml") kept += test::read_file(entry.path());
  }
  EXPECT_NE(std::string::npos, kept.find("Not saved"));
}

TEST(App, AllWorkThatWasNotSavedIsThereAgain) {
  const TemporaryFolder folder;
  std::vector<Lesson> edited;
  {
    HeadlessApp window("polygons-gjk", folder.path());
    const auto edit = [&] {
      Lesson lesson = window.session().lesson();
      lesson.y().vertices[0].x() -= 0.125;
      EXPECT_TRUE(window.app().edit("move", lesson));
      edited.push_back(std::move(lesson));
    };
    edit();
    window.app().open_path(fs::path(GJKSCOPE_SOURCE_DIR) / "lessons" / "polygons-witness.toml");
    edit();
  }
  HeadlessApp again("", folder.path());
  while (!again.app().left_work().empty())
    ASSERT_TRUE(again.app().open_left(again.app().left_work().size() - 1));
  EXPECT_EQ(2u, again.session().all_unsaved().size());
  if (again.session().lesson().id != edited[1].id) std::swap(edited[0], edited[1]);
  EXPECT_EQ(edited[1].y().vertices, again.session().lesson().y().vertices);
  while (again.session().lesson().id == edited[1].id) again.key("Z", true);
  EXPECT_EQ(edited[0].y().vertices, again.session().lesson().y().vertices);
}

TEST(App, CopiesTheFrameAsSvgTextAndInWords) {
  HeadlessApp window;
  std::string clipboard;
  window.app().copy = [&](const std::string& text) { clipboard = text; };
  window.key("Right");
  window.key("C", true, true);
  EXPECT_TRUE(clipboard.starts_with("<svg")) << clipboard.substr(0, 40);
  EXPECT_NE(std::string::npos, clipboard.find(window.session().lesson().title));
  window.app().run_command("Copy the frame in words");
  EXPECT_EQ(alternative_text(window.session().text()), clipboard);
}

TEST(App, TheListingIsCodeByAKeyAndIsCopiedWhole) {
  HeadlessApp window("polygons-gjk");
  std::string clipboard;
  window.app().copy = [&](const std::string& text) { clipboard = text; };
  const auto current = [&] {
    std::string out;
    for (const Mark& mark : window.session().picture().marks) {
      const Text* text = std::get_if<Text>(&mark.shape);
      if (text && mark.role == "code.current") out += text->text;
    }
    return out;
  };
  EXPECT_TRUE(current().starts_with("S ←")) << current();
  for (const auto& [line, name] :
       {std::pair("Simplex s =", "textbook.hpp"), {"s = [SimplexVertex(", "textbook.py"}}) {
    window.key("C");
    EXPECT_TRUE(current().starts_with(line)) << current();
    window.app().run_command("Copy the code of the listing");
    const auto file = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "tests" / "gjk" / name;
    EXPECT_EQ(read_whole(file), clipboard);
  }
  window.key("C");
  EXPECT_TRUE(current().starts_with("S ←")) << current();
}

/// Frames until the export that was begun has ended.
void end_export(HeadlessApp& window) {
  constexpr int kMost = 6000;
  for (int i = 0; i < kMost && window.app().is_exporting(); ++i) {
    EXPECT_TRUE(window.app().wakes_at());
    usleep(10'000);
    window.frame();
  }
  EXPECT_FALSE(window.app().is_exporting());
}

TEST(App, ExportsBesideTheWindowInTheSizeThemeAndFormatAsked) {
  const TemporaryFolder folder;
  HeadlessApp window;
  window.key("Right");
  ExportOptions options;
  options.out_dir = folder.path();
  options.theme = "dark";
  options.width = 640;
  options.height = 480;
  const int index = window.session().index();
  window.app().export_frames(options, false);
  EXPECT_TRUE(window.app().is_exporting());
  window.key("Right");
  EXPECT_EQ(index + 1, window.session().index()) << "the window goes on";
  window.key("E", true);
  EXPECT_FALSE(window.app().has_dialog()) << "one export at a time";
  end_export(window);
  EXPECT_EQ(0u, window.app().message().find("1 frame in ")) << window.app().message();
  const Image image = golden::decoded(test::read_file(folder.path() / "polygons-gjk-0002.png"));
  ASSERT_EQ(640, image.width);
  EXPECT_EQ(480, image.height);
  const Color paper =
      Theme::load(fs::path(GJKSCOPE_SOURCE_DIR) / "assets" / "themes", "dark").background();
  EXPECT_EQ(paper.r, image.pixels[0]);
  EXPECT_EQ(paper.b, image.pixels[2]);
  options.format = Format::svg;
  window.app().export_frames(options, true);
  end_export(window);
  EXPECT_TRUE(test::read_file(folder.path() / "polygons-gjk-0003.svg").starts_with("<svg"));
  EXPECT_FALSE(fs::exists(folder.path() / "index.html")) << "that is for images";
}

TEST(App, ALongExportSaysHowFarItIsAndCanBeGivenUp) {
  const TemporaryFolder folder;
  HeadlessApp window;
  ExportOptions options;
  options.out_dir = folder.path();
  options.width = 3840;
  options.height = 2160;
  options.jobs = 1;
  window.app().export_frames(options, true);
  const auto message = [&] {
    for (const Notice& each : window.app().notices()) {
      if (each.cause == "exporting") return each.text;
    }
    return std::string();
  };
  constexpr int kMost = 6000;
  for (int i = 0; i < kMost && window.app().exported().first < 2; ++i) {
    usleep(10'000);
    window.frame();
  }
  window.frame(1.0);
  EXPECT_NE(std::string::npos, message().find(" of 23 frames")) << message();
  EXPECT_NE(std::string::npos, message().find(folder.path().string())) << message();
  window.app().ask_to_quit();
  EXPECT_FALSE(window.app().wants_to_quit()) << "it is said that an export is going on";
  ASSERT_TRUE(window.app().run_command("Cancel the export"));
  end_export(window);
  EXPECT_TRUE(message().empty());
  EXPECT_LT(window.app().exported().first, 22);
  EXPECT_TRUE(fs::exists(folder.path() / "polygons-gjk-0001.png")) << "what was done stays";
  EXPECT_FALSE(fs::exists(folder.path() / "polygons-gjk-0022.png"));
  window.app().ask_to_quit();
  EXPECT_TRUE(window.app().wants_to_quit());
}

TEST(App, AFilmThatIsGivenUpLeavesNothing) {
  const TemporaryFolder folder;
  HeadlessApp window;
  ExportOptions options;
  options.out_dir = folder.path();
  options.format = Format::webm;
  options.width = 1920;
  options.height = 1080;
  window.app().export_frames(options, true);
  while (window.app().is_exporting() && fs::is_empty(folder.path())) {
    usleep(10'000);
    window.frame();
  }
  ASSERT_TRUE(window.app().run_command("Cancel the export"));
  end_export(window);
  EXPECT_TRUE(fs::is_empty(folder.path())) << window.app().message();
}

TEST(App, HowFramesWereExportedIsRemembered) {
  const TemporaryFolder folder;
  {
    HeadlessApp window("polygons-gjk", folder.path());
    ExportOptions options;
    options.out_dir = folder.path() / "talk";
    options.theme = "print";
    options.format = Format::svg;
    options.width = 1920;
    options.height = 1080;
    window.app().last_export = options;
  }
  HeadlessApp again("polygons-gjk", folder.path());
  ASSERT_TRUE(again.app().last_export);
  EXPECT_EQ(folder.path() / "talk", again.app().last_export->out_dir);
  EXPECT_EQ("print", again.app().last_export->theme);
  EXPECT_EQ(Format::svg, again.app().last_export->format);
  EXPECT_EQ(1920, again.app().last_export->width);
}

TEST(App, AnEffectThatChangesNothingIsNotCalledFor) {
  HeadlessApp window;
  Session& session = window.session();
  EffectTrial trial(session.run(), session.effects(), testing::fonts());
  const auto frames = [&](std::size_t view, const char* effect) {
    const auto changed = trial.frames_changed_by(view, effect);
    EXPECT_TRUE(changed) << effect;
    return changed ? std::count(changed->begin(), changed->end(), true) : -1;
  };
  EXPECT_EQ(0, frames(0, "minkowski-cloud")) << "the world has none";
  EXPECT_EQ(session.frame_count(), frames(1, "minkowski-cloud"));
  EXPECT_GT(frames(1, "history"), 0);
  EXPECT_LT(frames(1, "history"), session.frame_count()) << "at the start there is none";
  toggle_effect(window.app(), 0, "minkowski-cloud");
  EXPECT_FALSE(session.is_unsaved());
  EXPECT_NE(std::string::npos, window.app().message().find("minkowski-cloud"));
  // Off and on again is as before, whatever the order in the file.
  const std::string first = session.lesson().views[1].effects.front();
  toggle_effect(window.app(), 1, first);
  EXPECT_TRUE(session.is_unsaved());
  toggle_effect(window.app(), 1, first);
  EXPECT_FALSE(session.is_unsaved());
}

TEST(App, EffectsSayWhichChangeNothing) {
  HeadlessApp window;
  window.app().show_drawer("Effects");
  constexpr int kMost = 3000;
  for (int i = 0; i < kMost && window.app().wakes_at(); ++i) {
    usleep(10'000);
    window.frame();
  }
  EXPECT_FALSE(window.app().wakes_at()) << "known, and at rest";
}

TEST(App, AnExportThatFailsSaysWhy) {
  const TemporaryFolder folder;
  HeadlessApp window;
  ExportOptions options;
  options.out_dir = folder.path();
  options.format = Format::svg;
  options.width = 1;
  window.app().export_frames(options, false);
  end_export(window);
  EXPECT_NE(std::string::npos, window.app().message().find("too small")) << window.app().message();
}

TEST(App, TheExportDialogWritesTheFrameThatIsShown) {
  const TemporaryFolder folder;
  HeadlessApp window;
  window.key("E", true);
  ASSERT_TRUE(window.app().has_dialog());
  window.type(folder.path().string());
  window.key("Enter");
  EXPECT_FALSE(window.app().has_dialog());
  end_export(window);
  EXPECT_TRUE(test::read_file(folder.path() / "polygons-gjk-0001.png").starts_with("\x89PNG"))
      << window.app().message();
}

TEST(App, SaveAsAsksBeforeItOverwritesAndKeepsWhatWasThere) {
  const TemporaryFolder folder;
  const std::string file = folder.file("mine.toml", "precious");
  HeadlessApp window;
  const auto save_as = [&] {
    window.key("S", true, true);
    window.type(file);
    window.key("Enter");
  };
  save_as();
  EXPECT_TRUE(window.app().has_dialog());
  EXPECT_EQ("precious", test::read_file(file));
  window.key("Escape");
  EXPECT_FALSE(window.app().has_dialog());
  save_as();
  window.key("Enter");
  EXPECT_FALSE(window.app().has_dialog());
  EXPECT_EQ("precious", test::read_file(file + "~")) << window.app().message();
  EXPECT_EQ(file, window.session().file());
  EXPECT_FALSE(window.session().is_unsaved());
  fs::remove(file + "~");
  window.key("S", true);
  EXPECT_FALSE(fs::exists(file + "~")) << "its own file is saved without a question";
}

TEST(App, ADialogOpenedAgainStartsAnew) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "mine.toml";
  HeadlessApp window;
  window.app().save_to(file);
  fs::remove(file);
  window.key("S", true, true);
  window.type("/nowhere/at/all.toml");
  window.key("Escape");
  window.key("S", true, true);
  window.key("Enter");
  EXPECT_TRUE(fs::exists(file)) << window.app().message();
}

TEST(App, WhatWasSavedIsNotReadAgain) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "mine.toml";
  HeadlessApp window;
  const Point from = window.at(kK);
  window.drag(from, from + Point(50, 0));
  window.wheel(1.0);
  window.app().save_to(file);
  const std::string undo = window.session().undo_name();
  window.app().file_changed(file);
  EXPECT_EQ(undo, window.session().undo_name());
  EXPECT_FALSE(window.session().is_unsaved());
}

TEST(App, AMessageGoesAfterAWhileAndAnErrorWhenItWasRead) {
  HeadlessApp window;
  window.frame(100.0);  // after a long rest the time is not that of the last frame
  window.app().say("done");
  window.frame(100.0);
  EXPECT_EQ("done", window.app().message());
  for (int i = 0; i < 5; ++i) window.frame(1.0);
  EXPECT_EQ("", window.app().message());
  window.app().say("cannot", true);
  for (int i = 0; i < 50; ++i) window.frame(1.0);
  EXPECT_EQ("cannot", window.app().message());
  EXPECT_FALSE(window.app().wakes_at());
  window.key("Escape");
  EXPECT_EQ("", window.app().message());
}

TEST(App, AnyVertexOfTheOpeningLessonCanBeDeleted) {
  for (int vertex = 0; vertex < 5; ++vertex) {
    HeadlessApp window;
    window.click(window.at({Kind::vertex_of_x, vertex}));
    window.key("Delete");
    EXPECT_EQ(4u, window.session().lesson().x().vertices.size()) << window.app().message();
  }
}

TEST(App, BetweenFramesOfTheTimelineTheNearestIsTaken) {
  HeadlessApp window;
  const Point a = window.at({Kind::frame, 5});
  const Point b = window.at({Kind::frame, 6});
  const Point gap = 0.5 * (a + b);
  window.move(gap);
  ASSERT_NE(Kind::frame, window.app().picture().hovered().kind) << "there is a gap";
  window.drag(gap, window.at({Kind::frame, 12}));
  EXPECT_EQ(12, window.session().index());
}

TEST(App, ARevertIsAnEntryOfTheHistory) {
  HeadlessApp window;
  const Lesson saved = window.session().lesson();
  const Point from = window.at(kK);
  window.drag(from, from + Point(50, 0));
  const Lesson moved = window.session().lesson();
  window.key("R", true);
  EXPECT_EQ(saved, window.session().lesson());
  window.key("Z", true);
  EXPECT_EQ(moved, window.session().lesson());
}

TEST(App, KeysGoToPanelsOrAreCommandsButNeverBoth) {
  HeadlessApp window;
  window.key("S");
  window.key("Tab");
  EXPECT_EQ(Kind::vertex_of_x, window.app().picture().hand().selected.kind);
  EXPECT_FALSE(window.app().panels_have_keys());
  window.key("F6");
  EXPECT_TRUE(window.app().panels_have_keys());
  const int index = window.session().index();
  window.key("Right");
  EXPECT_EQ(index, window.session().index()) << "goes to the panel";
  window.key("Escape");
  window.key("Right");
  EXPECT_EQ(index + 1, window.session().index());
}

TEST(App, UndoTakesWhatIsHeldOutOfTheHand) {
  HeadlessApp window("segment-regions");
  window.app().open_path(fs::path(GJKSCOPE_SOURCE_DIR) / "lessons" / "polygons-gjk.toml");
  window.settle();
  const Point held = window.at({Kind::vertex_of_y, -1, 0});
  window.move(held);
  window.button(true);
  window.key("Z", true);
  EXPECT_EQ("segment-regions", window.session().lesson().id);
  const Lesson before = window.session().lesson();
  window.move(held + Point(30, 30));
  window.button(false);
  EXPECT_EQ(before, window.session().lesson());
}

TEST(App, AFileThatChangesIsReadAgainAndABrokenOneIsSaidWithItsPlace) {
  const TemporaryFolder folder;
  const std::string text =
      test::read_file(fs::path(GJKSCOPE_SOURCE_DIR) / "lessons" / "polygons-gjk.toml");
  const std::string file = folder.file("mine.toml", text);
  HeadlessApp window(file);
  window.key("End");
  const int index = window.session().index();
  (void)folder.file("mine.toml", text + "\nnonsense = 1\n");
  window.app().file_changed(file);
  ASSERT_FALSE(window.app().notices().empty());
  EXPECT_NE(std::string::npos, window.app().notices().front().text.find("mine.toml:"));
  EXPECT_EQ(index, window.session().index());
  std::string other = text;
  other.replace(other.find("Polygon to polygon"), 18, "Changed just nowXX");
  (void)folder.file("mine.toml", other);
  window.app().file_changed(file);
  EXPECT_TRUE(window.session().lesson().title.starts_with("Changed just now"));
  EXPECT_EQ(index, window.session().index());
}

/// GJKSCOPE_RELOADS asks for another number of reloads.
int reload_count() {
  const char* asked = std::getenv("GJKSCOPE_RELOADS");
  return asked ? std::atoi(asked) : 700;
}

TEST(App, ReloadsDoNotGrowTheMemory) {
  const TemporaryFolder folder;
  const std::string text =
      test::read_file(fs::path(GJKSCOPE_SOURCE_DIR) / "lessons" / "stop-vertex.toml");
  const std::string file = folder.file("mine.toml", text);
  HeadlessApp window(file);
  const auto reload = [&](int i) {
    std::string changed = text;
    changed[changed.find("title = \"") + 9] = static_cast<char>('A' + i % 26);
    (void)folder.file("mine.toml", changed);
    window.app().file_changed(file);
  };
  constexpr int kUntilFull = 520;  // entries of the history, and some more
  int i = 0;
  while (i < kUntilFull) reload(i++);
  const std::size_t full = mallinfo2().uordblks;
  while (i < reload_count()) reload(i++);
  constexpr std::size_t kSlack = 65536;  // bytes
  EXPECT_LE(mallinfo2().uordblks, full + kSlack);
  // The history is the only thing that remembers, and it has an end.
  int entries = 0;
  while (window.session().undo()) ++entries;
  EXPECT_LE(entries, 500);
  EXPECT_GE(entries, 400);
}

TEST(App, SavesALessonThatGivesTheSameRun) {
  const TemporaryFolder folder;
  HeadlessApp window;
  const Point from = window.at(kK);
  window.drag(from, from + Point(37, 21));
  const std::string file = (folder.path() / "saved.toml").string();
  window.app().save_to(file);
  EXPECT_FALSE(window.session().is_unsaved());
  const auto loaded = load_lesson(file, vocabulary());
  ASSERT_TRUE(loaded.lesson);
  EXPECT_EQ(window.session().lesson().y().vertices, loaded.lesson->y().vertices);
}

TEST(App, AFileIsKeptBesideTheSavedOne) {
  const TemporaryFolder folder;
  const std::string text = "# A note of mine.\n" + test::read_file(fs::path(GJKSCOPE_SOURCE_DIR) /
                                                                   "lessons" / "stop-vertex.toml");
  const std::string file = folder.file("mine.toml", text);
  HeadlessApp window(file);
  window.app().save_to(file);
  EXPECT_EQ(test::read_file(file + "~"), text);
  EXPECT_NE(std::string::npos, window.app().message().find("mine.toml~"));
  window.app().save_to(file);
  EXPECT_EQ(test::read_file(file + "~"), text)
      << "the second save replaces what the first one wrote";
}

TEST(App, ANameThatIsNothingIsSaid) {
  EXPECT_THROW(HeadlessApp("no-such-lesson"), std::runtime_error);
  try {
    const HeadlessApp window("polygns-gjk");
    FAIL() << "there is no such lesson";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("did you mean 'polygons-gjk'?"))
        << error.what();
  }
  EXPECT_THROW(HeadlessApp("/no/such/file.toml"), std::runtime_error);
}

TEST(App, EveryLessonOpensAndEveryFrameDraws) {
  for (const Lesson& lesson : testing::lessons_for_long_tests()) {
    HeadlessApp window(lesson.id);
    while (window.session().step(1)) window.frame();
    window.key("F5");
    window.key("Escape");
    EXPECT_FALSE(window.app().wants_to_quit());
  }
}

TEST(App, AWindowOfAnySizeDraws) {
  HeadlessApp window;
  for (const auto& [width, height] :
       {std::pair(1.0, 1.0), {1.0, 900.0}, {3000.0, 2.0}, {300.0, 300.0}, {2560.0, 1440.0}}) {
    window.resize(width, height);
    window.key("Right");
  }
}

TEST(App, ADenseScreenShowsTheSameInMorePixels) {
  const Subject vertex{Kind::vertex_of_x, 0};
  HeadlessApp window;
  window.resize(1280.0, 800.0);
  const Point before = window.at(vertex);
  window.resize(2560.0, 1600.0, 2.0);
  EXPECT_LT((window.at(vertex) - 2.0 * before).norm(), 0.01 * before.norm());
}

/// A case of a triangle and a polygon of `count` vertices.
std::string case_of_many(int count) {
  std::string json = R"({"a": [[-3, 0], [-2, 0], [-2, 1]], "b": [)";
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    json += fmt::format("{}[{}, {}]", i ? ", " : "", std::cos(angle), std::sin(angle));
  }
  return json + "]}";
}

TEST(App, APolygonOfManyVerticesIsDrawnAndDragged) {
  const TemporaryFolder folder;
  HeadlessApp window(folder.file("many.json", case_of_many(100'000)));
  const Point from = window.at({Kind::vertex_of_x, 0});
  window.drag(from, from + Point(20, 0));
  EXPECT_GT(window.session().lesson().x().vertices[0].x(), -3.0);
}

TEST(App, AnExactRunOfManyVerticesDoesNotHoldUpTheWindow) {
  const TemporaryFolder folder;
  HeadlessApp window(folder.file("many.json", case_of_many(100'000)));
  constexpr double kMessagesAreGone = 10.0;
  window.frame(kMessagesAreGone);
  ASSERT_FALSE(window.app().wakes_at());
  window.app().show_drawer("Numerics");
  window.frame();
  EXPECT_TRUE(window.app().wakes_at()) << "it looks whether the run has ended";
  window.key("Right");
  EXPECT_EQ(1, window.session().index()) << "and goes on";
  constexpr int kMost = 6000;
  for (int i = 0; i < kMost && window.app().wakes_at(); ++i) {
    usleep(10'000);
    window.frame();
  }
  EXPECT_FALSE(window.app().wakes_at());
}

TEST(Study, ADotOpensItsWorstRunAndBReturns) {
  HeadlessApp window("accuracy-cost");
  Session& session = window.session();
  const LessonStudy study = *session.lesson().settings.as<LessonStudy>();
  const std::vector<StudyDot> family = of_family(study.dots(), study.family);
  const int all = session.frame_count() - 2;  // the frame that shows all dots
  session.go_to(all);
  window.settle();
  // A dot that no other covers, and that is not the default.
  std::optional<Subject> dot;
  for (int i = static_cast<int>(family.size()) - 1; i > 0 && !dot; --i) {
    const Subject candidate{Kind::study_dot, i};
    if (!window.app().picture().pixel_of(candidate)) continue;
    window.move(window.at(candidate));
    if (window.app().picture().hovered() == candidate) dot = candidate;
  }
  ASSERT_TRUE(dot);
  const StudyDot& wanted = family[static_cast<std::size_t>(dot->x)];
  window.click(window.at(*dot));
  EXPECT_EQ(session.lesson().title, wanted.configuration + ": worst of nearly parallel");
  const study::Configuration configuration = *study::configuration_named(wanted.configuration);
  gjk::Options options = configuration.options;
  options.start.count = configuration.start == study::Start::first_vertices ? 1 : 0;
  EXPECT_TRUE(session.lesson().options == options);
  EXPECT_EQ(session.lesson().x().vertices, in_space(wanted.x));
  EXPECT_GT(session.frame_count(), 3) << "it can be stepped";
  EXPECT_TRUE(session.lesson().path.empty()) << "no lesson of the list is open";
  window.key("B");
  EXPECT_EQ(session.lesson().id, "accuracy-cost");
  EXPECT_EQ(session.index(), all);
  EXPECT_FALSE(session.is_unsaved());
  window.key("B");
  EXPECT_EQ(window.app().message(), "there is no study to go back to");
}

TEST(Study, EnterOpensTheRunOfTheConfigurationThatTheFrameIntroduces) {
  HeadlessApp window("accuracy-cost");
  Session& session = window.session();
  window.key("Enter");
  EXPECT_EQ(session.lesson().id, "accuracy-cost") << "the first frame introduces none";
  const std::vector<StudyMark> marks = session.lesson().settings.as<LessonStudy>()->marks;
  int opened = 0;
  for (int i = 0; i < session.frame_count(); ++i) {
    const StudyFrame shown =
        *study_frame(session.run(), session.run().frames[static_cast<std::size_t>(i)]);
    if (shown.stage != StudyStage::mark) continue;
    session.go_to(i);
    window.settle();
    window.key("Enter");
    EXPECT_EQ(session.lesson().title,
              marks[static_cast<std::size_t>(shown.marks - 1)].configuration +
                  ": worst of nearly parallel");
    window.key("B");
    EXPECT_EQ(session.index(), i);
    ++opened;
  }
  EXPECT_GE(opened, 6);
}

/// Each configuration of the shipped results can be stepped.
TEST(Study, EveryDotOpens) {
  HeadlessApp window("accuracy-cost");
  window.session().go_to(window.session().frame_count() - 2);
  window.settle();
  const std::vector<StudyDot> family =
      of_family(window.session().lesson().settings.as<LessonStudy>()->dots(), "nearly parallel");
  std::set<std::string> titles;
  for (std::size_t i = 0; i < family.size(); ++i) {
    if (!family[i].error) continue;
    window.click(window.at({Kind::study_dot, static_cast<int>(i)}));
    // Dots lie on each other: the one on top opens.
    EXPECT_NE(window.session().lesson().title.find(": worst of nearly parallel"), std::string::npos)
        << window.app().message();
    titles.insert(window.session().lesson().title);
    window.key("B");
  }
  EXPECT_GE(titles.size(), 20u);
}

TEST(Study, TheDrawerChoosesTheFamilyAndUndoTakesItBack) {
  HeadlessApp window("accuracy-cost");
  window.key("A");
  window.settle();
  Lesson lesson = window.session().lesson();
  lesson.settings.edit<LessonStudy>().family = "random";
  EXPECT_TRUE(window.app().edit("family", std::move(lesson)));
  window.settle();
  EXPECT_EQ(window.session().lesson().settings.as<LessonStudy>()->family, "random");
  window.key("Z", true);
  EXPECT_EQ(window.session().lesson().settings.as<LessonStudy>()->family, "nearly parallel");
}

TEST(Study, ResultsOpenInTheirLessonAndCanBeSavedAnywhere) {
  const TemporaryFolder folder;
  const fs::path results = folder.path() / "accuracy.json";
  fs::copy_file(fs::path(GJKSCOPE_SOURCE_DIR) / "lessons" / "accuracy-cost.json", results);
  HeadlessApp window(results.string());
  ASSERT_TRUE(window.session().lesson().settings.as<LessonStudy>());
  EXPECT_FALSE(window.session().lesson().settings.as<LessonStudy>()->marks.empty());
  fs::create_directories(folder.path() / "elsewhere");
  const fs::path saved = folder.path() / "elsewhere" / "mine.toml";
  window.app().save_to(saved);
  const LoadedLesson read = load_lesson(saved, vocabulary());
  ASSERT_TRUE(read.lesson) << to_string(read.problems.at(0));
  EXPECT_EQ(read.lesson->settings.as<LessonStudy>()->dots(),
            window.session().lesson().settings.as<LessonStudy>()->dots());

  std::ofstream(results) << R"({"machine": {"processor": "abacus"}, "rows": [{"family": 3}]})";
  window.app().open_path(results);
  EXPECT_NE(window.app().message().find("row 1: "), std::string::npos) << window.app().message();
  EXPECT_TRUE(window.session().lesson().settings.as<LessonStudy>()) << "what was open stays";
}

}  // namespace app_test
}  // namespace gjkscope
