// Files of the window: who else writes them, what is kept, what is said while something is wrong.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "drawers/values.hpp"
#include "headless_app.hpp"
#include "lesson/case.hpp"
#include "lesson/load.hpp"
#include "outlines/polygon.hpp"
#include "run/trail.hpp"
#include "session/edit.hpp"
#include "subjects/subjects.hpp"
#include "temporary_folder.hpp"
#include "widgets.hpp"

namespace gjkscope {
namespace files_test {

namespace fs = std::filesystem;
using test::HeadlessApp;
using test::read_file;
using test::TemporaryFolder;

const fs::path kLessons = fs::path(GJKSCOPE_SOURCE_DIR) / "lessons";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(std::string::npos, at) << what;
  if (at != std::string::npos) text.replace(at, what.size(), by);
  return text;
}

/// A lesson file of an author, with comments.
std::string commented_lesson() {
  return "# A note of mine.\n" + replaced(read_file(kLessons / "polygons-gjk.toml"), "\n[query]\n",
                                          "\n# How it runs.\n[query]\n");
}

const Notice* notice(const std::vector<Notice>& all, const std::string& cause) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Notice& each) { return each.cause == cause; });
  return found == all.end() ? nullptr : &*found;
}
std::string said(HeadlessApp& window, const std::string& cause) {
  const std::vector<Notice> all = window.app().notices();
  const Notice* found = notice(all, cause);
  return found ? found->text : "";
}

void move(HeadlessApp& window, double by = 0.125) {
  Lesson lesson = window.session().lesson();
  lesson.y().vertices[0].x() += by;
  ASSERT_TRUE(window.app().edit("move", std::move(lesson)));
}

// Two editors on one file --------------------------------------------------------------------

struct Conflict : ::testing::Test {
  Conflict() : file(folder.file("mine.toml", commented_lesson())), window(file.string()) {
    move(window);
    mine = window.session().lesson();
    theirs = replaced(commented_lesson(), "\norder = ", "\norder = 7");
    (void)folder.file("mine.toml", theirs);
  }
  TemporaryFolder folder;
  fs::path file;
  HeadlessApp window;
  Lesson mine;
  std::string theirs;
};

TEST_F(Conflict, IsAskedUntilItIsAnsweredAndNothingIsWrittenBefore) {
  window.app().file_changed(file);
  EXPECT_EQ(mine, window.session().lesson()) << "nothing is replaced unasked";
  constexpr double kLong = 1000.0;
  window.frame(kLong);
  window.key("Escape");
  window.key("Right");
  EXPECT_NE(std::string::npos, said(window, "outside").find("mine.toml")) << "it stays";
  window.key("S", true);
  EXPECT_EQ(theirs, read_file(file));
  EXPECT_FALSE(fs::exists(file.string() + "~"));
  EXPECT_TRUE(window.session().is_unsaved());
}

TEST_F(Conflict, IsSeenBySavingThoughNobodyHasSaidThatTheFileChanged) {
  window.key("S", true);
  EXPECT_EQ(theirs, read_file(file));
  EXPECT_NE("", said(window, "outside"));
}

TEST_F(Conflict, MineStaysTheirsIsKeptBesideAndUndoLeadsToIt) {
  window.app().file_changed(file);
  ASSERT_TRUE(window.app().run_command("Keep mine"));
  EXPECT_EQ("", said(window, "outside"));
  EXPECT_EQ(mine.y(), window.session().lesson().y());
  EXPECT_TRUE(window.session().is_unsaved());
  window.key("S", true);
  EXPECT_EQ(theirs, read_file(file.string() + "~")) << window.app().message();
  const LoadedLesson saved = load_lesson(file, vocabulary());
  ASSERT_TRUE(saved.lesson);
  EXPECT_EQ(mine.y(), saved.lesson->y());
  window.key("Z", true);
  EXPECT_GE(window.session().lesson().order, 70) << "theirs";
  window.key("Z", true);
  EXPECT_EQ(mine.y(), window.session().lesson().y());
}

TEST_F(Conflict, TheirsIsTakenAndUndoLeadsToMine) {
  window.app().file_changed(file);
  ASSERT_TRUE(window.app().run_command("Take the file's"));
  EXPECT_GE(window.session().lesson().order, 70);
  EXPECT_FALSE(window.session().is_unsaved());
  window.key("Z", true);
  EXPECT_EQ(mine, window.session().lesson());
}

TEST_F(Conflict, IsOverWhenTheFileIsAsItWas) {
  window.app().file_changed(file);
  ASSERT_NE("", said(window, "outside"));
  (void)folder.file("mine.toml", commented_lesson());
  window.app().file_changed(file);
  EXPECT_EQ("", said(window, "outside"));
  window.key("S", true);
  EXPECT_FALSE(window.session().is_unsaved());
}

TEST_F(Conflict, IsSeenByWhoComesBackToTheLessonByUndo) {
  window.app().open_path(kLessons / "collinear.toml");
  window.settle();
  ASSERT_EQ("", said(window, "outside"));
  window.key("Z", true);
  ASSERT_EQ(file, window.session().file());
  EXPECT_NE("", said(window, "outside"));
}

TEST(Files, ACommentThatSomebodyElseWroteIsNoConflictAndSurvives) {
  const TemporaryFolder folder;
  const fs::path file = folder.file("mine.toml", commented_lesson());
  HeadlessApp window(file.string());
  move(window);
  (void)folder.file("mine.toml", commented_lesson() + "# The last line.\n");
  window.app().file_changed(file);
  EXPECT_EQ("", said(window, "outside"));
  window.key("S", true);
  EXPECT_NE(std::string::npos, read_file(file).find("# The last line.\n"));
}

// Saving ----------------------------------------------------------------------------------------

TEST(Files, SavingKeepsCommentsAndTheFileAsItWas) {
  const TemporaryFolder folder;
  const fs::path file = folder.file("mine.toml", commented_lesson());
  HeadlessApp window(file.string());
  move(window);
  window.key("S", true);
  const std::string saved = read_file(file);
  EXPECT_NE(std::string::npos, saved.find("# A note of mine.\n"));
  EXPECT_NE(std::string::npos, saved.find("\n# How it runs.\n[query]\n"));
  EXPECT_EQ(commented_lesson(), read_file(file.string() + "~"));
  move(window);
  window.key("S", true);
  EXPECT_EQ(commented_lesson(), read_file(file.string() + "~"))
      << "what this window wrote does not take its place";
}

TEST(Files, ALessonOfTheCourseIsNotOverwrittenUnasked) {
  const TemporaryFolder folder;
  const std::string text = read_file(kLessons / "simplex.toml");
  const fs::path copy = folder.file("simplex.toml", text);
  HeadlessApp window(copy.string());
  move(window);
  window.key("S", true);
  EXPECT_TRUE(window.app().has_dialog());
  EXPECT_EQ(text, read_file(copy));
  window.key("Enter");
  EXPECT_TRUE(window.app().has_dialog()) << "there is such a file";
  EXPECT_EQ(text, read_file(copy));
  window.key("Enter");
  EXPECT_NE(text, read_file(copy));
  EXPECT_EQ(text, read_file(copy.string() + "~"));
  HeadlessApp shipped("simplex");
  move(shipped);
  shipped.key("S", true);
  EXPECT_TRUE(shipped.app().has_dialog());
  EXPECT_EQ(text, read_file(kLessons / "simplex.toml"));
}

// Problems, while they last ----------------------------------------------------------------------

TEST(Files, ABrokenFileIsSaidWhileItIsBroken) {
  const TemporaryFolder folder;
  const std::string text = commented_lesson();
  const fs::path file = folder.file("mine.toml", text);
  HeadlessApp window(file.string());
  (void)folder.file("mine.toml", replaced(text, "chapter =", "chaptre ="));
  window.app().file_changed(file);
  window.key("Right");
  window.key("Escape");
  constexpr double kLong = 1000.0;
  window.frame(kLong);
  EXPECT_TRUE(said(window, "outside").starts_with("did you mean 'chapter'? mine.toml:"))
      << said(window, "outside");
  EXPECT_EQ(std::string::npos, said(window, "outside").find('\n'));
  // As it was: the text of the window.
  (void)folder.file("mine.toml", text);
  window.app().file_changed(file);
  EXPECT_EQ("", said(window, "outside"));
}

TEST(Files, ABrokenFileIsNotOverwrittenUnasked) {
  const TemporaryFolder folder;
  const fs::path file = folder.file("mine.toml", commented_lesson());
  HeadlessApp window(file.string());
  move(window);
  (void)folder.file("mine.toml", "title = ");
  window.key("S", true);
  EXPECT_EQ("title = ", read_file(file));
  window.app().run_command("Keep mine");
  window.key("S", true);
  EXPECT_EQ("title = ", read_file(file.string() + "~"));
  EXPECT_TRUE(load_lesson(file, vocabulary()).lesson);
}

TEST(Files, AFileThatIsGoneIsSaidAndSaveWritesItAnew) {
  const TemporaryFolder folder;
  const fs::path file = folder.file("mine.toml", commented_lesson());
  HeadlessApp window(file.string());
  fs::remove(file);
  window.app().file_changed(file);
  window.settle();
  EXPECT_EQ("", said(window, "gone")) << "an editor may be writing it";
  window.frame(1.0);
  window.settle();
  EXPECT_NE(std::string::npos, said(window, "gone").find("mine.toml"));
  EXPECT_TRUE(window.session().is_unsaved()) << "it is nowhere else";
  (void)folder.file("mine.toml", commented_lesson());
  window.app().file_changed(file);
  window.settle();
  EXPECT_EQ("", said(window, "gone"));
  EXPECT_FALSE(window.session().is_unsaved());
  fs::remove(file);
  window.app().file_changed(file);
  window.frame(1.0);
  window.frame(1.0);
  ASSERT_NE("", said(window, "gone"));
  window.key("S", true);
  EXPECT_EQ("", said(window, "gone"));
  EXPECT_TRUE(read_file(file).starts_with("# A note of mine.")) << "its comments, too";
}

TEST(Files, AnErrorIsOneLineThatGoesWithTheNextDeedOrIsClosed) {
  HeadlessApp window;
  window.app().paste = [] { return R"({"a": [[1e308,0],[-1e308,0]], "b": [[3, 1e308]]})"; };
  window.key("V", true);
  EXPECT_NE("", said(window, "deed"));
  EXPECT_EQ(std::string::npos, said(window, "deed").find('\n'));
  window.key("Right");
  EXPECT_EQ("", said(window, "deed"));
  window.key("V", true);
  window.key("Escape");
  EXPECT_EQ("", said(window, "deed"));
}

TEST(Files, ACharacterThatTheStageCannotDrawIsNamed) {
  HeadlessApp window;
  EXPECT_EQ("", said(window, "characters"));
  Lesson lesson = window.session().lesson();
  lesson.title = "Größe, 日本語";
  ASSERT_TRUE(window.app().edit("title", lesson));
  window.settle();
  EXPECT_NE(std::string::npos, said(window, "characters").find("'日' (in title)"))
      << said(window, "characters");
}

TEST(Files, NoticesHaveRoomOfTheirOwn) {
  HeadlessApp window;
  const double top = window.app().picture().area().min.y();
  window.app().say("this went wrong\nfor many reasons", true);
  window.settle();
  EXPECT_GT(window.app().picture().area().min.y(), top + 20.0);
  EXPECT_EQ("this went wrong", said(window, "deed"));
  window.key("Escape");
  EXPECT_EQ(top, window.app().picture().area().min.y());
}

// Cases ------------------------------------------------------------------------------------------

const std::string kCase = R"({
 "name": "two squares",
 "why": "apart by {a tenth}",
 "source": "my notes",
 "mine": 7,
 "a": [[0, 0], [1, 0], [1, 1], [0, 1]],
 "b": [[1.1, 0], [2, 0], [2, 1], [1.1, 1]],
 "expected_distance": 0.1,
 "expected_overlap": false
}
)";

TEST(Case, KeepsItsFileIsWatchedAndSavesToIt) {
  const TemporaryFolder folder;
  const fs::path file = folder.file("squares.json", kCase);
  HeadlessApp window(file.string());
  EXPECT_EQ(file, window.session().file());
  EXPECT_EQ(file, window.app().watched());
  EXPECT_FALSE(window.session().is_unsaved());
  (void)folder.file("squares.json", replaced(kCase, "[1.1, 0]", "[1.25, 0]"));
  window.app().file_changed(file);
  EXPECT_EQ(1.25, window.session().lesson().y().vertices[0].x());
  move(window, 0.25);
  EXPECT_TRUE(window.session().is_unsaved());
  window.key("S", true);
  EXPECT_FALSE(window.app().has_dialog());
  EXPECT_FALSE(window.session().is_unsaved());
  const nlohmann::json saved = nlohmann::json::parse(read_file(file));
  EXPECT_EQ(1.5, saved["b"][0][0]);
  EXPECT_EQ(7, saved["mine"]);
  EXPECT_EQ("my notes", saved["source"]);
  EXPECT_FALSE(saved.contains("expected_distance")) << "it was of other shapes";
  EXPECT_NE(std::string::npos, read_file(file.string() + "~").find("expected_distance"));
}

TEST(Case, ThatIsBrokenOrGoneOutsideKeepsItsNotesWhenItIsSaved) {
  const TemporaryFolder folder;
  const fs::path file = folder.file("squares.json", kCase);
  HeadlessApp window(file.string());
  (void)folder.file("squares.json", R"({"a": [[0, 0], [1)");
  window.app().file_changed(file);
  window.settle();
  ASSERT_NE("", said(window, "outside"));
  window.key("S", true);
  EXPECT_EQ(R"({"a": [[0, 0], [1)", read_file(file)) << "not unasked";
  ASSERT_TRUE(window.app().run_command("Keep mine"));
  move(window);
  window.key("S", true);
  EXPECT_EQ("my notes", nlohmann::json::parse(read_file(file))["source"]);
  EXPECT_EQ(R"({"a": [[0, 0], [1)", read_file(file.string() + "~"));
  (void)folder.file("squares.json", "{");
  window.app().file_changed(file);
  window.settle();
  fs::remove(file);
  window.app().file_changed(file);
  window.frame(1.0);
  window.frame(1.0);
  EXPECT_NE("", said(window, "gone"));
  EXPECT_EQ("", said(window, "outside")) << "one thing is wrong at a time";
  window.key("S", true);
  const std::string saved = read_file(file);
  EXPECT_EQ("my notes", nlohmann::json::parse(saved)["source"]);
  EXPECT_LT(std::count(saved.begin(), saved.end(), '\n'), 15) << "a key on each line";
}

TEST(Case, TheLegendHidesNothingOfTheShapes) {
  HeadlessApp window(
      (fs::path(GJKSCOPE_SOURCE_DIR) / "tests" / "hard-cases" / "box2d_115_t0.json").string());
  window.resize(1280.0, 800.0);
  window.app().show_drawer("Numerics");
  window.settle();
  int rows = 0;
  for (const Mark& box : window.session().picture().marks) {
    if (box.role != "legend.box") continue;
    ++rows;
    const Rect& rect = std::get<Box>(box.shape).rect;
    for (const Mark& mark : window.session().picture().marks) {
      const Polygon* polygon = std::get_if<Polygon>(&mark.shape);
      if (!polygon || !mark.role.starts_with("shape.")) continue;
      for (std::size_t i = 0; i < polygon->points.size(); ++i) {
        const Point& from = polygon->points[i];
        const Point& to = polygon->points[(i + 1) % polygon->points.size()];
        for (double share = 0.0; share <= 1.0; share += 1.0 / 512.0) {
          const Point at = from + share * (to - from);
          EXPECT_FALSE((at.array() > rect.min.array()).all() &&
                       (at.array() < rect.max.array()).all())
              << mark.role << " " << i;
        }
      }
    }
  }
  EXPECT_GT(rows, 1);
}

TEST(Case, SavedUnderAnotherNameIsSaved) {
  const TemporaryFolder folder;
  HeadlessApp window(folder.file("squares.json", kCase));
  move(window);
  const fs::path other = folder.path() / "other.json";
  window.app().save_to(other);
  EXPECT_FALSE(window.session().is_unsaved());
  EXPECT_EQ(other, window.session().file());
  // A lesson is more than its shapes.
  HeadlessApp lesson("simplex");
  move(lesson);
  lesson.app().save_to(folder.path() / "shapes.json");
  EXPECT_TRUE(lesson.session().is_unsaved());
  EXPECT_EQ(kLessons / "simplex.toml", lesson.session().file());
}

TEST(Case, OfAFileWithManyIsNotSavedOverThem) {
  const TemporaryFolder folder;
  const std::string two = kCase + kCase;
  const fs::path file = folder.file("two.json", two);
  HeadlessApp window(file.string());
  move(window);
  window.key("S", true);
  EXPECT_EQ(two, read_file(file));
  EXPECT_NE("", said(window, "deed"));
}

TEST(Case, ShowsWhyAndSourceAndComparesItsRun) {
  const TemporaryFolder folder;
  HeadlessApp window(folder.file("squares.json", kCase));
  const std::string& prose = window.session().text().prose;
  EXPECT_NE(std::string::npos, prose.find("apart by {a tenth}")) << prose;
  EXPECT_NE(std::string::npos, prose.find("my notes"));
  EXPECT_EQ("my notes", window.session().lesson().source);
  const double off = window.session().run().runs.front().trace.result.distance - 0.1;
  const std::string compared = window.app().compared_with_case();
  EXPECT_NE(std::string::npos, compared.find("apart; this run: the same")) << compared;
  EXPECT_NE(std::string::npos, compared.find(off == 0.0 ? "exactly that" : "off by")) << compared;
  move(window);
  EXPECT_EQ("", window.app().compared_with_case()) << "these shapes nobody expects anything of";
}

TEST(Case, InSpaceOpensAndIsSavedAsOne) {
  const TemporaryFolder folder;
  HeadlessApp window;
  window.app().open_path(fs::path(GJKSCOPE_SOURCE_DIR) / "tests" / "hard-cases" / "coal_49.json");
  EXPECT_EQ("coal_49", window.session().lesson().id) << window.app().message();
  EXPECT_EQ(3, window.session().lesson().dimension);
  const fs::path saved = folder.path() / "again.json";
  window.app().save_to(saved);
  const std::vector<ReadCase> read = parse_cases(read_file(saved), "again.json", 3);
  ASSERT_TRUE(read.front().in_space);
  EXPECT_EQ(window.session().lesson().x().vertices, read.front().in_space->a);
}

TEST(Case, WhatIsNoCaseIsSaidInPlainWords) {
  HeadlessApp window;
  std::string clipboard;
  window.app().paste = [&] { return clipboard; };
  for (const char* rubbish : {"hello world", "POLYGON ((30 10, 40 40))", "1 2 3", ""}) {
    clipboard = rubbish;
    window.key("V", true);
    EXPECT_NE("", said(window, "deed")) << rubbish;
    EXPECT_EQ(std::string::npos, window.app().message().find("syntax error")) << rubbish;
  }
  clipboard = read_file(kLessons / "collinear.toml");
  window.key("V", true);
  EXPECT_EQ("", said(window, "deed")) << "a lesson's text is a lesson";
  EXPECT_EQ(load_lesson(kLessons / "collinear.toml", vocabulary()).lesson->title,
            window.session().lesson().title);
}

TEST(Case, InAnotherFormSaysWhatWasUnderstood) {
  const TemporaryFolder folder;
  HeadlessApp window;
  window.app().paste = [] {
    return "POLYGON ((0 0, 9 0, 9 9, 0 9), (2 2, 7 2, 7 7, 2 7))\nb = [(20, 0), (21, 0)]";
  };
  window.key("V", true);
  EXPECT_EQ(
      "X has 1 outline and 1 hole of 8 vertices, Y 2 vertices, in the plane; the hull of X counts",
      window.app().message());
  EXPECT_EQ(4u, window.session().lesson().x().vertices.size());
  window.app().open_path(folder.file("two.txt", "0 0\n1 0\n\n3 4\n"));
  EXPECT_EQ("X has 2 vertices, Y 1, in the plane", window.app().message());
  EXPECT_TRUE(window.session().file().empty()) << "saving would not write this form";
}

TEST(Case, OfAnOutlineThatIsNotConvexSaysThatGjkSeesTheHull) {
  HeadlessApp window;
  window.app().open_path(fs::path(GJKSCOPE_SOURCE_DIR) / "tests" / "hard-cases" /
                         "dolfinx_quad_0.json");
  EXPECT_NE(std::string::npos,
            window.session().text().prose.find("GJK sees the hull of X and of Y."));
  const std::vector<Mark>& marks = window.session().picture().marks;
  const LessonPictures::ShownView world = window.session().views()[0];
  EXPECT_EQ(2, std::count_if(marks.begin(), marks.end(),
                             [&](const Mark& mark) {
                               const Polygon* hull = std::get_if<Polygon>(&mark.shape);
                               return mark.role == "hull" && hull &&
                                      hull->points[0].x() < world.card.max.x() &&
                                      hull->points[0].y() < world.card.max.y();
                             }))
      << "and the world shows both";
}

TEST(Case, OfMoreCornersThanNamesHaveCharactersForCanBeMade) {
  HeadlessApp window;
  for (const int corners : {99, 100, 200}) {
    Lesson lesson = window.session().lesson();
    edit::reshape(lesson, 0, edit::regular_polygon(corners));
    EXPECT_TRUE(window.app().edit("regular", std::move(lesson))) << window.app().message();
  }
}

std::string large_case(int vertices = 20'000) {
  std::string points;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2.0 * 3.141592653589793 * i / vertices;
    points += fmt::format("{}[{}, {}]", i > 0 ? ", " : "", std::cos(angle), std::sin(angle));
  }
  return fmt::format(R"({{"a": [{}], "b": [[5, 5], [6, 5]]}})", points);
}

TEST(Case, ThatIsLargeIsOpenedBesideTheWindow) {
  const TemporaryFolder folder;
  const fs::path file = folder.file("large.json", large_case());
  HeadlessApp window;
  window.app().beside = std::launch::deferred;
  window.app().open_path(file);
  window.frame();
  EXPECT_EQ("polygons-gjk", window.session().lesson().id);
  EXPECT_NE("", said(window, "opening"));
  EXPECT_TRUE(window.app().wakes_at());
  window.app().wait_beside();
  window.frame();
  EXPECT_EQ(20'000u, window.session().lesson().x().vertices.size());
  EXPECT_EQ(file, window.session().file());
  EXPECT_FALSE(window.session().is_unsaved());
  window.key("Z", true);
  EXPECT_EQ("polygons-gjk", window.session().lesson().id);
}

TEST(Case, ThatIsLargeNeedNotBeWaitedFor) {
  const TemporaryFolder folder;
  HeadlessApp window;
  window.app().beside = std::launch::deferred;
  window.app().open_path(folder.file("large.json", large_case()));
  ASSERT_TRUE(window.app().is_opening());
  window.key("Right");
  EXPECT_EQ(1, window.session().index());
  window.app().run_command("Cancel opening");
  EXPECT_FALSE(window.app().is_opening());
  window.app().wait_beside();
  window.frame();
  EXPECT_EQ("polygons-gjk", window.session().lesson().id);
}

/// A window with a large case that the hand has moved a vertex of Y in, and let go.
struct LargeDrag : ::testing::Test {
  LargeDrag() {
    window.app().open_path(folder.file("large.json", large_case()));
    window.app().wait_beside();
    window.settle();
    window.app().beside = std::launch::deferred;
    before = window.session().lesson();
    shown = unpointed();
    const Point of_y = window.at({Subject::Kind::vertex_of_y, -1, 0});
    window.drag(of_y, of_y - Point(40.0, 0.0));
  }
  /// Without names that are there for the hand.
  Picture unpointed() {
    window.session().point_at({});
    return window.session().picture();
  }
  TemporaryFolder folder;
  HeadlessApp window;
  Lesson before;
  Picture shown;
};

TEST_F(LargeDrag, SettlesBesideTheWindowAndSaysSo) {
  Session& session = window.session();
  ASSERT_TRUE(session.is_settling());
  EXPECT_NE("", said(window, "settling"));
  EXPECT_NE(before.y().vertices, session.lesson().y().vertices);
  EXPECT_TRUE(window.app().wakes_at());
  while (session.is_settling()) {
    window.app().wait_beside();
    window.frame();
  }
  EXPECT_EQ("", said(window, "settling"));
  EXPECT_EQ(session.lesson().y().vertices, session.run().lesson.y().vertices);
  EXPECT_EQ("move a vertex", session.undo_name());
  window.key("Z", true);
  EXPECT_EQ(before.y().vertices, session.lesson().y().vertices);
}

TEST_F(LargeDrag, IsCancelledAsIfItHadNotBeen) {
  Session& session = window.session();
  const std::string earlier = "open " + before.id;
  ASSERT_TRUE(session.is_settling());
  window.app().run_command("Cancel the change");
  EXPECT_FALSE(session.is_settling());
  EXPECT_EQ(before, session.lesson());
  EXPECT_EQ(earlier, session.undo_name());
  EXPECT_EQ(before.y().vertices, session.run().lesson.y().vertices);
  EXPECT_EQ(shown, unpointed());
  // The run that was being made for it is not shown.
  window.app().wait_beside();
  window.frame();
  EXPECT_EQ(before.y().vertices, session.run().lesson.y().vertices);
}

TEST_F(LargeDrag, GivesWayToAnyOtherChange) {
  Session& session = window.session();
  ASSERT_TRUE(session.is_settling());
  window.key("Z", true);
  EXPECT_FALSE(session.is_settling());
  EXPECT_EQ(before.y().vertices, session.run().lesson.y().vertices);
}

// Unsaved work -----------------------------------------------------------------------------------

/// Leaves a piece of work on each of these lessons.
void leave_work(const fs::path& state, const std::vector<std::string>& lessons) {
  for (const std::string& name : lessons) {
    HeadlessApp window(name, state);
    move(window);
  }
}

TEST(Unsaved, IsAListOfWhichEachPieceIsOpenedOrDiscarded) {
  const TemporaryFolder state;
  leave_work(state.path(), {"polygons-gjk", "polygons-witness", "simplex"});
  {
    HeadlessApp window("collinear", state.path());
    EXPECT_NE(std::string::npos, said(window, "left").find("3 pieces"));
    window.app().run_command("Open unsaved work");
    EXPECT_TRUE(window.app().has_dialog());
    window.settle();
    std::vector<App::LeftWork>& left = window.app().left_work();
    ASSERT_EQ(3u, left.size());
    EXPECT_GE(left[0].work.time, left[2].work.time);
    const auto of = [&](const std::string& name) {
      return static_cast<std::size_t>(
          std::find_if(left.begin(), left.end(),
                       [&](const App::LeftWork& each) { return each.work.file.stem() == name; }) -
          left.begin());
    };
    ASSERT_TRUE(window.app().open_left(of("simplex")));
    EXPECT_EQ("simplex", window.session().lesson().id);
    EXPECT_EQ(1u, window.session().all_unsaved().size());
    left[of("polygons-witness")].is_discarded = true;
    EXPECT_NE(std::string::npos, said(window, "left").find("of polygons-gjk"));
    left[of("polygons-witness")].is_discarded = false;
    left[of("polygons-gjk")].is_discarded = true;
  }
  HeadlessApp next("collinear", state.path());
  std::vector<std::string> names;
  for (const App::LeftWork& each : next.app().left_work())
    names.push_back(each.work.file.stem().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ((std::vector<std::string>{"polygons-witness", "simplex"}), names);
}

TEST(Unsaved, WhatIsDiscardedCanBePutBack) {
  const TemporaryFolder state;
  leave_work(state.path(), {"polygons-gjk"});
  HeadlessApp window("collinear", state.path());
  window.app().run_command("Discard unsaved work");
  EXPECT_EQ("", said(window, "left"));
  window.app().run_command("Put back discarded work");
  EXPECT_NE("", said(window, "left"));
  window.app().run_command("Open unsaved work");
  EXPECT_EQ("polygons-gjk", window.session().lesson().id);
}

TEST(Unsaved, WhereNothingCanBeKeptItIsSaidAndAskedBeforeWorkGoes) {
  const TemporaryFolder folder;
  const fs::path no_folder = fs::path(folder.file("file", "")) / "state";
  HeadlessApp window("polygons-gjk", no_folder);
  EXPECT_NE(std::string::npos, said(window, "not kept").find("save before you quit"));
  window.app().ask_to_quit();
  EXPECT_TRUE(window.app().wants_to_quit()) << "there is no work";
  HeadlessApp other("polygons-gjk", no_folder);
  move(other);
  other.key("Q", true);
  EXPECT_FALSE(other.app().wants_to_quit());
  EXPECT_TRUE(other.app().has_dialog());
  other.app().ask_to_quit();
  EXPECT_TRUE(other.app().wants_to_quit()) << "who asks again is answered";
}

TEST(Unsaved, WorkThatIsKeptGoesWithoutAQuestion) {
  const TemporaryFolder state;
  HeadlessApp window("polygons-gjk", state.path());
  move(window);
  window.key("Q", true);
  EXPECT_TRUE(window.app().wants_to_quit());
}

// Views ------------------------------------------------------------------------------------------

TEST(Views, ARandomPairIsInSight) {
  HeadlessApp window;
  for (int i = 0; i < 5; ++i) {
    window.app().run_command("Random pair");
    const LessonPictures::ShownView world = window.session().views().front();
    const PositionedRun& run = window.session().run().run(window.session().frame());
    for (const auto& body : run.bodies) {
      for (const Eigen::Vector2d& vertex : in_plane(body.world)) {
        const Eigen::Vector2d off =
            (vertex - in_plane(world.camera.center))
                .cwiseQuotient(world.camera.units_per_pixel(world.card.size().y()));
        EXPECT_LE(std::abs(off.x()), 0.5 * world.card.size().x());
        EXPECT_LE(std::abs(off.y()), 0.5 * world.card.size().y());
      }
    }
  }
}

TEST(Views, ADragInAZoomedDifferenceFollowsTheHand) {
  HeadlessApp window;
  Session& session = window.session();
  session.go_to(answering_index(session.run()));
  window.frame();
  const Subject z{Subject::Kind::difference};
  const Point at = window.at(z);
  window.move(at);
  for (int i = 0; i < 12; ++i) window.wheel(1.0);
  const LessonPictures::ShownView before = session.views()[1];
  const double y = session.lesson().y().vertices[0].x();
  constexpr double kBy = 24.0;  // pixels
  window.drag(at, at + Point(-kBy, 0.0));
  const LessonPictures::ShownView after = session.views()[1];
  EXPECT_EQ(before.camera.height, after.camera.height);
  EXPECT_EQ(before.camera.center, after.camera.center);
  const double zoom = window.app().layout(1440.0, 900.0);
  const double wanted = -kBy / zoom * before.camera.units_per_pixel(before.card.size().y()).x();
  EXPECT_NEAR(wanted, session.lesson().y().vertices[0].x() - y, 0.02 * std::abs(wanted));
}

TEST(Views, ValuesStandWhereTheStageHasThem) {
  HeadlessApp window("direction-half");
  window.key("End");
  const LessonRun& run = window.session().run();
  const Frame& frame = window.session().frame();
  const Eigen::Vector3d& q = run.run(frame).x().world[0];
  const auto value = [&](const std::string& name) -> std::string {
    for (const NamedValue& each : values_now(window.app())) {
      if (each.name == name) return each.text;
    }
    return "none";
  };
  const WideState& state = run.state(frame);
  EXPECT_EQ(number_text(state.p.x() + q.x(), false), value("P.x"));
  const std::string vertex = run.pair_name(state.simplex.vertices[0].pair);
  EXPECT_EQ(number_text(state.simplex.vertices[0].w.x() + q.x(), false), value(vertex + ".x"));
}

TEST(Views, DepthIsTitledAsWhatItIs) {
  HeadlessApp window;
  window.app().paste = [] {
    return R"({"a": [[0, 0], [2, 0], [0, 2]], "b": [[0.5, 0.5], [3, 1], [1, 3]]})";
  };
  window.key("V", true);
  const std::string before = window.session().lesson().title;
  window.key("End");
  show_depth(window.app());
  EXPECT_NE(before, window.session().lesson().title);
  EXPECT_EQ("depth", window.session().lesson().tour);
}

TEST(Views, ADentIsSaid) {
  HeadlessApp window;
  const Lesson& lesson = window.session().lesson();
  ASSERT_TRUE(is_convex(in_plane(lesson.x().vertices)));
  const Point from = window.at({Subject::Kind::vertex_of_x, 0});
  const Point opposite = window.at({Subject::Kind::vertex_of_x, 2});
  window.drag(from, from + 1.2 * (opposite - from));
  ASSERT_FALSE(is_convex(in_plane(window.session().lesson().x().vertices)));
  EXPECT_NE(std::string::npos, window.app().message().find("dent")) << window.app().message();
}

}  // namespace files_test
}  // namespace gjkscope
