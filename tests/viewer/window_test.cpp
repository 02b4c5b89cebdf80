// The program in a real window, on a display of its own (Xvfb), driven by SDL events.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "golden/pixels.hpp"

namespace gjkscope {
namespace window_test {

namespace fs = std::filesystem;
using nlohmann::json;
using test::read_file;
using test::TemporaryFolder;

struct Ran {
  int exit_code = 0;
  std::string err;
};

/// `display`: on a display of its own, else without any. `more`: environment variables.
Ran run_viewer(const TemporaryFolder& folder, const std::string& arguments, bool display = true,
               const std::string& more = "") {
  const std::string err = (folder.path() / "err").string();
  // Drivers and D-Bus keep memory that no suppression can name, since they are unloaded by then;
  // leaks of the window's content are found by the tests without a window.
  const std::string environment =
      "env -u DISPLAY -u WAYLAND_DISPLAY ASAN_OPTIONS=detect_leaks=0 XDG_STATE_HOME=" +
      folder.path().string() + " " + more + " ";
  const std::string on = display ? GJKSCOPE_ON_DISPLAY " " : "";
  // A window that should not have opened would wait for ever.
  const std::string command = environment + "timeout 300 " + on + GJKSCOPE_VIEWER + " " +
                              arguments + " >/dev/null 2>" + err;
  const int status = std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe)
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_file(err)};
}

/// Plays a script and gives the states that it wrote.
class Played {
 public:
  explicit Played(const std::string& script, const std::string& arguments = "") {
    std::string lines = script;
    for (std::size_t at = lines.find("$DIR"); at != std::string::npos; at = lines.find("$DIR"))
      lines.replace(at, 4, folder_.path().string());
    ran = run_viewer(folder_,
                     arguments + " --size 1280x800 --script " + folder_.file("script", lines));
  }
  [[nodiscard]] json state(const std::string& name) const {
    return json::parse(read_file(folder_.path() / name));
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    return read_file(folder_.path() / name);
  }
  Ran ran;

 private:
  TemporaryFolder folder_;
};

TEST(RealWindow, EventsStepDragUndoAndPredict) {
  const Played played(R"(state $DIR/start
key Right
key Right
state $DIR/stepped
drag y:0 y:0+40,-30
state $DIR/dragged
key Ctrl+Z
state $DIR/undone
click frame:5
state $DIR/scrubbed
click phase:stop
state $DIR/stop
key Home
key P
key Right
key Right
key Right
key Right
state $DIR/asked
key 1
key 1
state $DIR/answered
key F5
state $DIR/presenting
screenshot $DIR/shot.png
key Escape
state $DIR/left
resize 1 1
resize 900 700
state $DIR/resized
)");
  ASSERT_EQ(0, played.ran.exit_code) << played.ran.err;
  const int start = played.state("start")["frame"];
  EXPECT_EQ(start + 2, played.state("stepped")["frame"]);
  EXPECT_NE(played.state("start")["y"], played.state("dragged")["y"]);
  EXPECT_EQ(played.state("start")["x"], played.state("dragged")["x"]);
  EXPECT_EQ(true, played.state("dragged")["unsaved"]);
  EXPECT_NE(played.state("start")["distance"], played.state("dragged")["distance"]);
  EXPECT_EQ(played.state("start")["y"], played.state("undone")["y"]);
  EXPECT_EQ(5, played.state("scrubbed")["frame"]);
  EXPECT_EQ("stop", played.state("stop")["phase"]);
  EXPECT_EQ(true, played.state("asked")["question"]);
  EXPECT_EQ(1, played.state("answered")["asked"]);
  EXPECT_EQ(true, played.state("presenting")["presenting"]);
  EXPECT_EQ(false, played.state("left")["presenting"]);
  EXPECT_TRUE(played.text("shot.png").starts_with("\x89PNG"));
  EXPECT_GT(played.text("shot.png").size(), 20000u) << "an empty window";
}

TEST(RealWindow, SavesExportsAndOpens) {
  const Played played(R"(drag shape-y shape-y+20,15
key Ctrl+Shift+S
key Ctrl+A
type $DIR/mine.toml
key Return
state $DIR/saved
key Ctrl+E
key Ctrl+A
type $DIR/frames
click 480 238
state $DIR/exported
)");
  ASSERT_EQ(0, played.ran.exit_code) << played.ran.err;
  EXPECT_EQ(false, played.state("saved")["unsaved"]);
  EXPECT_NE("", played.text("mine.toml"));
}

TEST(RealWindow, WithoutADisplayItNamesTheCommandThatNeedsNone) {
  const TemporaryFolder folder;
  const Ran ran = run_viewer(folder, "", false);
  EXPECT_EQ(2, ran.exit_code);
  EXPECT_NE(std::string::npos, ran.err.find("gjkscope export")) << ran.err;
  EXPECT_NE(std::string::npos, ran.err.find("DISPLAY is not set")) << ran.err;
  const Ran other = run_viewer(folder, "", false, "DISPLAY=:1234");
  EXPECT_EQ(2, other.exit_code);
  EXPECT_NE(std::string::npos, other.err.find("DISPLAY is ':1234', which does not answer"))
      << other.err;
}

TEST(RealWindow, WithoutOpenGlItSaysSoInOneSentence) {
  const TemporaryFolder folder;
  const Ran ran = run_viewer(folder, "", true, "LIBGL_ALWAYS_INDIRECT=1");
  EXPECT_EQ(2, ran.exit_code);
  EXPECT_NE(std::string::npos, ran.err.find("there is no OpenGL 3")) << ran.err;
}

TEST(RealWindow, WithADrawerOpenTabAndDeleteMeanTheStage) {
  const Played played(
      "key S\nkey Tab\nkey Delete\nstate $DIR/deleted\nkey Ctrl+Z\nstate $DIR/undone\n");
  ASSERT_EQ(0, played.ran.exit_code) << played.ran.err;
  EXPECT_EQ("Shapes", played.state("deleted")["drawer"]);
  EXPECT_EQ(played.state("undone")["x"].size() - 1, played.state("deleted")["x"].size());
  EXPECT_EQ(played.state("undone")["y"], played.state("deleted")["y"]);
}

TEST(RealWindow, EnterOpensTheWorstRun) {
  const Played played("click frame:7\nkey Return\nstate $DIR/opened\n", "accuracy-cost");
  ASSERT_EQ(0, played.ran.exit_code) << played.ran.err;
  EXPECT_EQ("worst-run", played.state("opened")["lesson"]);
}

TEST(RealWindow, ASizeIsWrittenAsItIsSaid) {
  const TemporaryFolder folder;
  EXPECT_EQ(
      0, run_viewer(folder, "--size 800x600 --screenshot " + (folder.path() / "shot.png").string())
             .exit_code);
  for (const char* wrong : {"800x", "1024,768", "800"}) {
    const Ran refused = run_viewer(folder, fmt::format("--size {}", wrong));
    EXPECT_EQ(2, refused.exit_code) << wrong;
    EXPECT_NE(std::string::npos, refused.err.find(wrong)) << refused.err;
    EXPECT_NE(std::string::npos, refused.err.find("1440x900")) << refused.err;
  }
}

TEST(RealWindow, IsAsReadmeShowsIt) {
  const TemporaryFolder folder;
  const fs::path docs = fs::path(GJKSCOPE_SOURCE_DIR) / "docs";
  const fs::path shot = folder.path() / "shot.png";
  const std::string arguments = "--no-state --size 1440x900 --script " +
                                (docs / "window.script").string() + " --screenshot " +
                                shot.string();
  ASSERT_EQ(0, run_viewer(folder, arguments).exit_code);
  EXPECT_TRUE(golden::looks_like(read_file(docs / "window.png"), golden::decoded(read_file(shot))))
      << "If that is meant, look at the window, and take its picture anew: "
         "docs/window.script says how";
}

TEST(RealWindow, LooksAsItWasLookedAt) {
  const fs::path looks = fs::path(GJKSCOPE_SOURCE_DIR) / "tests" / "golden" / "window";
  std::string script = read_file(looks / "looks.script");
  const std::string verb = "\nscreenshot ";
  for (std::size_t at = script.find(verb); at != std::string::npos; at = script.find(verb, at + 1))
    script.insert(at + verb.size(), "$DIR/");
  const Played played(script, "--no-state");
  ASSERT_EQ(0, played.ran.exit_code) << played.ran.err;
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(looks)) {
    if (entry.path().extension() != ".png") continue;
    ++count;
    EXPECT_TRUE(golden::looks_like(read_file(entry.path()),
                                   golden::decoded(played.text(entry.path().filename().string()))))
        << entry.path().filename()
        << ": if that is meant, look at the window, and take its pictures anew: "
           "looks.script says how";
  }
  EXPECT_EQ(12, count);
}

TEST(RealWindow, WhatCannotBeShownIsSaidWithItsPlace) {
  const TemporaryFolder folder;
  const Ran broken = run_viewer(folder, folder.file("broken.toml", "title = 3\n"));
  EXPECT_EQ(1, broken.exit_code);
  EXPECT_NE(std::string::npos, broken.err.find("broken.toml:1:")) << broken.err;
  const Ran bad_case = run_viewer(folder, folder.file("bad.json", R"({"a": [[0]], "b": []})"));
  EXPECT_EQ(1, bad_case.exit_code);
  EXPECT_NE(std::string::npos, bad_case.err.find("bad.json:1:")) << bad_case.err;
  const Ran unknown = run_viewer(folder, "no-such-lesson");
  EXPECT_EQ(1, unknown.exit_code);
  EXPECT_EQ(2, run_viewer(folder, "--no-such-option").exit_code);
}

TEST(RealWindow, AScriptThatCannotBePlayedNamesItsLine) {
  const Played played("key Right\nclick z:99,99\n");
  EXPECT_EQ(3, played.ran.exit_code);
  EXPECT_NE(std::string::npos, played.ran.err.find("script:2:")) << played.ran.err;
}

}  // namespace window_test
}  // namespace gjkscope
