// The program as a whole: its help, its exit codes, and what it does when things go wrong.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/commands.hpp"
#include "command_line.hpp"

namespace gjkscope {
namespace program_test {

using nlohmann::json;
using test::Ran;
using test::run_program;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Program, HelpNamesEveryCommandAndEveryExitCode) {
  const Ran ran = run_program("--help");
  EXPECT_EQ(kDone, ran.exit_code);
  EXPECT_TRUE(ran.err.empty());
  for (const char* word : {"lessons", "export", "trace", "solve", "judge", "check", "transcript",
                           "explain", "--version", "Exit codes", "Examples", "GJKSCOPE_SHARE"}) {
    EXPECT_TRUE(holds(ran.out, word)) << word;
  }
  for (const char* command :
       {"lessons", "export", "trace", "solve", "judge", "check", "transcript", "explain"}) {
    const Ran help = run_program(std::string(command) + " --help");
    EXPECT_EQ(kDone, help.exit_code);
    EXPECT_TRUE(holds(help.out, "Examples")) << command;
  }
}

TEST(Program, HasAVersion) {
  const Ran ran = run_program("--version");
  EXPECT_EQ(kDone, ran.exit_code);
  EXPECT_EQ(0u, ran.out.rfind("gjkscope ", 0));
}

TEST(Program, AMistakenCommandLineIsToldOnStderr) {
  for (const char* arguments :
       {"", "lesons", "solve", "solve --scalar quad x.json", "export --all", "export --out x",
        "export --out x --size 12by8 --all", "export --out x --steps 5..2 --all",
        "export --out x --format bmp --all", "export --all polygons-gjk --out x",
        "export --all --out x.html", "export polygons-gjk --index --out x.html", "--nonsense",
        "transcript", "transcript --all polygons-gjk", "transcript polygons-gjk no-such-lesson",
        "trace no-such-lesson", "explain no-such-lesson", "export --out x no-such-lesson"}) {
    SCOPED_TRACE(arguments);
    const Ran ran = run_program(arguments);
    EXPECT_EQ(kUsage, ran.exit_code) << ran.err;
    EXPECT_TRUE(ran.out.empty()) << ran.out;
    EXPECT_FALSE(ran.err.empty());
  }
}

TEST(Program, NamesTheNearestCommandAndLesson) {
  EXPECT_TRUE(holds(run_program("lesons").err, "`gjkscope lessons`"));
  EXPECT_TRUE(holds(run_program("trace polygns-gjk").err, "'polygons-gjk'"));
}

TEST(Program, WhatCannotBeReadIsNamed) {
  for (const char* arguments : {"solve /nowhere/case.json", "trace /nowhere/case.json",
                                "trace ./nowhere.toml", "check ./nowhere.toml"}) {
    SCOPED_TRACE(arguments);
    const Ran ran = run_program(arguments);
    EXPECT_EQ(kCannot, ran.exit_code);
    EXPECT_TRUE(holds(ran.err, "nowhere"));
  }
}

TEST(Program, ListsLessons) {
  const Ran ran = run_program("lessons --json");
  EXPECT_EQ(kDone, ran.exit_code) << ran.err;
  const json list = json::parse(ran.out);
  ASSERT_GE(list.size(), 10u);
  for (const json& lesson : list) {
    EXPECT_TRUE(lesson["id"].is_string());
    EXPECT_TRUE(lesson["title"].is_string());
    EXPECT_GE(lesson["chapter"].get<int>(), 0);
    EXPECT_GE(lesson["steps"].get<int>(), 1);
  }
  EXPECT_TRUE(holds(run_program("lessons").out, list[0]["id"].get<std::string>()));
}

TEST(Program, EveryShippedLessonPassesItsCheckAndCanBeTraced) {
  const Ran check = run_program("check " GJKSCOPE_SOURCE_DIR "/lessons/*.toml");
  EXPECT_EQ(kDone, check.exit_code) << check.out << check.err;
  EXPECT_TRUE(check.out.empty());
  for (const json& lesson : json::parse(run_program("lessons --json").out)) {
    const std::string id = lesson["id"].get<std::string>();
    SCOPED_TRACE(id);
    const Ran traced = run_program("trace " + id + " --json");
    EXPECT_EQ(kDone, traced.exit_code) << traced.err;
    EXPECT_EQ(lesson["id"], json::parse(traced.out)["lesson"]);
  }
}

TEST(Program, CheckPrintsPlacesAndEndsWithOne) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("bad.toml", "tilte = \"x\"\nchapter = \"one\"\n");
  const Ran ran = run_program("check " + file);
  EXPECT_EQ(kProblem, ran.exit_code);
  EXPECT_TRUE(holds(ran.out, "bad.toml:1:"));
  EXPECT_TRUE(holds(ran.out, "title"));
  EXPECT_TRUE(holds(ran.out, "bad.toml:2:"));
}

TEST(Program, CheckReadsOutlines) {
  const test::TemporaryFolder folder;
  const std::string good =
      R"({"outlines_a":[[[0,0],[4,4],[4,0],[0,4]],{"open":[[9,9],[8,7]]}],"outlines_b":[[[6,1],[9,1]]]})";
  const Ran done = run_program("check " + folder.file("good.json", good));
  EXPECT_EQ(kDone, done.exit_code) << done.out;
  EXPECT_TRUE(done.out.empty());
  const Ran few = run_program("check " + folder.file("few.json",
                                                     "{\"outlines_a\":[[[0,0],[1,0]],\n[[2,2]]],"
                                                     "\"outlines_b\":[[[6,1],[9,1]]]}"));
  EXPECT_EQ(kProblem, few.exit_code);
  EXPECT_TRUE(holds(few.out, "few.json:2:1: /outlines_a/1: too few points")) << few.out;
  const Ran far = run_program(
      "check " +
      folder.file(
          "far.json",
          R"({"outlines_a":[[[-1.7e308,0],[-1.6e308,0]]],"outlines_b":[[[1.7e308,0],[1.6e308,0]]]})"));
  EXPECT_EQ(kProblem, far.exit_code);
  EXPECT_TRUE(holds(far.out, "refused: overflow")) << far.out;
}

TEST(Program, CheckComparesWithWhatTheLessonExpects) {
  const test::TemporaryFolder folder;
  std::string text = test::read_file(GJKSCOPE_SOURCE_DIR "/lessons/polygon-evolution.toml");
  const std::size_t at = text.find("distance");
  ASSERT_NE(std::string::npos, at);
  const std::size_t end = text.find('\n', text.find("distance = "));
  ASSERT_NE(std::string::npos, end);
  text.replace(text.find("distance = "), end - text.find("distance = "), "distance = 123.5");
  const Ran ran = run_program("check " + folder.file("wrong.toml", text));
  EXPECT_EQ(kProblem, ran.exit_code);
  EXPECT_TRUE(holds(ran.out, "123.5")) << ran.out;
}

TEST(Program, ExplainTellsWhichEffectsRan) {
  const Ran ran = run_program("explain minkowski-build --json");
  ASSERT_EQ(kDone, ran.exit_code) << ran.err;
  const json explained = json::parse(ran.out);
  bool called = false;
  bool left_out = false;
  for (const json& effect : explained["effects"]) {
    EXPECT_EQ(effect["called"].get<bool>(), effect["runs"].get<long>() > 0);
    called = called || effect["called"].get<bool>();
    left_out = left_out || !effect["called"].get<bool>();
  }
  EXPECT_TRUE(called);
  EXPECT_TRUE(left_out);
  EXPECT_TRUE(holds(run_program("explain minkowski-build").out, "minkowski-cloud"));
}

TEST(Program, ReadsStandardInputAndAnswersInOrder) {
  const Ran ran = run_program("solve - --json",
                              "{\"a\":[[0,0]],\"b\":[[3,4]]}\n{\"a\":[[0,0]],\"b\":[[6,8]]}\n");
  EXPECT_EQ(kDone, ran.exit_code);
  const auto lines = test::lines_of(ran.out);
  ASSERT_EQ(2u, lines.size());
  EXPECT_EQ(5.0, json::parse(lines[0])["distance"].get<double>());
  EXPECT_EQ(10.0, json::parse(lines[1])["distance"].get<double>());
  EXPECT_EQ(kProblem, run_program("solve -").exit_code);
}

TEST(Program, AClosedPipeOrAFullDiskIsNotACrash) {
  // The reader goes away at once; the program ends by SIGPIPE, silently, as others do.
  const Ran piped = run_program("trace polygons-gjk --json | head -c 10");
  EXPECT_EQ(0, piped.exit_code);
  EXPECT_TRUE(piped.err.empty()) << piped.err;
  const Ran full = run_program("lessons", "", "/dev/full");
  EXPECT_EQ(kCannot, full.exit_code);
  EXPECT_TRUE(holds(full.err, "cannot be written"));
}

TEST(Program, TheShareFolderCanBeGiven) {
  const test::TemporaryFolder empty;
  setenv("GJKSCOPE_SHARE", empty.path().c_str(), 1);
  const Ran ran = run_program("lessons");
  unsetenv("GJKSCOPE_SHARE");
  EXPECT_EQ(kCannot, ran.exit_code);
  EXPECT_TRUE(holds(ran.err, empty.path().string()));
}

TEST(Program, PracticeMakesTheSameSheetOfTheSameSeed) {
  const test::TemporaryFolder folder;
  const auto made = [&](const std::string& seed) {
    const std::string file = (folder.path() / ("sheet-" + seed + ".pdf")).string();
    const Ran ran = run_program("practice --chapter 3 --tasks 3 --seed " + seed + " --out " + file);
    EXPECT_EQ(kDone, ran.exit_code) << ran.err;
    EXPECT_EQ(file + "\n", ran.out);
    return test::read_file(file);
  };
  const std::string first = made("7");
  EXPECT_TRUE(first == made("7"));
  EXPECT_FALSE(first == made("8"));
}

TEST(Program, PracticeSaysWhatItCannotMake) {
  const test::TemporaryFolder folder;
  const std::string out = " --out " + folder.path().string();
  const auto refused = [&](const std::string& arguments, int code, const std::string& words) {
    const Ran ran = run_program("practice " + arguments);
    EXPECT_EQ(code, ran.exit_code) << arguments;
    EXPECT_EQ("", ran.out);
    EXPECT_TRUE(holds(ran.err, words)) << ran.err;
  };
  refused("--chapter 6" + out + "/s.pdf", kUsage,
          "chapter 6 has no practice; 1, 2, 3, 4, 5, 9 have");
  refused("--chapter 3 --tasks 0" + out + "/s.pdf", kUsage, "--tasks");
  refused("--chapter 3 --tasks 61" + out + "/s.pdf", kUsage, "--tasks");
  refused("--chapter 3 --seed x" + out + "/s.pdf", kUsage, "--seed");
  refused("--chapter 3 --paper a5" + out + "/s.pdf", kUsage, "a4, letter");
  refused("--chapter 3" + out + "/s.png", kUsage, "s.png is no .pdf");
  refused("--tasks 3" + out + "/s.pdf", kUsage, "--chapter is required");
  refused("--chapter 3 --tasks 1 --out /proc/s.pdf", kCannot, "/proc/s.pdf");
  const std::string mine = folder.file("mine.pdf", "notes");
  refused("--chapter 3 --tasks 1 --out " + mine, kCannot, "--force");
  EXPECT_EQ("notes", test::read_file(mine));
}

/// The offers of a shell for the word that follows `words`.
std::set<std::string> offered(const std::string& shell, const std::string& words) {
  const test::TemporaryFolder folder;
  const std::string file = std::string(GJKSCOPE_SOURCE_DIR) + "/packaging/completions/";
  const std::map<std::string, std::string> scripts = {
      {"bash", "source " + file + "gjkscope.bash; COMP_WORDS=(" + words +
                   "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _gjkscope;"
                   " printf '%s\\n' \"${COMPREPLY[@]}\""},
      {"zsh", "words=(" + words +
                  "); CURRENT=$#words; compadd() { shift; print -l -- $@ }; _files() { };"
                  " source " +
                  file + "_gjkscope"},
      {"fish", "source " + file + "gjkscope.fish; complete -C '" + words + "'"}};
  const std::string script = folder.file("script", scripts.at(shell) + "\n");
  const std::string out = (folder.path() / "out").string();
  const std::string bin = std::filesystem::path(GJKSCOPE_BINARY).parent_path().string();
  const std::string command = "HOME=" + folder.path().string() + " PATH=" + bin + ":$PATH " +
                              shell + " " + script + " >" + out;
  EXPECT_EQ(0, std::system(command.c_str())) << command;
  const auto lines = test::lines_of(test::read_file(out));
  return {lines.begin(), lines.end()};
}

std::set<std::string> options_in(const std::string& help) {
  std::set<std::string> options;
  for (const std::string& line : test::lines_of(help)) {
    const std::size_t at = line.find("--");
    if (!line.starts_with("  -") || at == std::string::npos) continue;
    options.insert(line.substr(at, line.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at) - at));
  }
  return options;
}

class Completion : public ::testing::TestWithParam<const char*> {};

TEST_P(Completion, OffersEveryOptionThatHelpLists) {
  for (const std::string command :
       {"lessons", "export", "open", "trace", "solve", "judge", "check", "transcript", "explain",
        "practice", "study accuracy", "study models"}) {
    const std::set<std::string> listed = options_in(run_program(command + " --help").out);
    EXPECT_TRUE(listed.contains("--help"));
    EXPECT_EQ(listed, offered(GetParam(), "gjkscope " + command + " --")) << command;
  }
  EXPECT_TRUE(offered(GetParam(), "gjkscope export --").contains("--fps"));
}

TEST_P(Completion, OffersCommandsValuesAndLessons) {
  const auto offers = [](const std::string& words, const std::string& word) {
    return offered(GetParam(), words).contains(word);
  };
  const std::string none = std::string(GetParam()) == "fish" ? "" : "''";
  EXPECT_TRUE(offers("gjkscope " + none, "transcript"));
  EXPECT_TRUE(offers("gjkscope study " + none, "accuracy"));
  EXPECT_EQ(offered(GetParam(), "gjkscope export --renderer " + none),
            (std::set<std::string>{"cairo", "osmesa", "egl"}));
  EXPECT_TRUE(offers("gjkscope export --format " + none, "webm"));
  EXPECT_TRUE(offers("gjkscope solve --scalar " + none, "half"));
  EXPECT_TRUE(offers("gjkscope export --all " + none, "polygons-gjk"));
}

INSTANTIATE_TEST_SUITE_P(Shells, Completion, ::testing::Values("bash", "zsh", "fish"),
                         [](const auto& shell) { return std::string(shell.param); });

std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    files[entry.path().filename().string()] = test::read_file(entry.path());
  }
  return files;
}

TEST(Program, AnExportThatIsKilledLeavesWholeFilesAndIsTakenUpAgain) {
  const test::TemporaryFolder folder;
  const std::string arguments = "export segment-closest polygons-gjk --size 320x180 --out ";
  const auto whole = folder.path() / "whole";
  EXPECT_EQ(kDone, run_program(arguments + whole.string()).exit_code);
  const auto expected = files_of(whole);
  ASSERT_GT(expected.size(), 20u);
  int killed = 0;
  for (std::size_t count = 1; count + 5 < expected.size(); count += 5) {
    const std::string cut = (folder.path() / std::to_string(count)).string();
    // Killed when there are so many files; the next are being written then.
    const std::string script = folder.file(
        "script", "( while [ $(ls " + cut + " 2>/dev/null | wc -l) -lt " + std::to_string(count) +
                      " ]; do sleep 0.005; done; kill -9 $$ ) &\nexec " + GJKSCOPE_BINARY + " " +
                      arguments + cut + "\n");
    killed += std::system(("sh " + script + " >/dev/null 2>&1").c_str()) != 0 ? 1 : 0;
    for (const auto& [name, bytes] : files_of(cut)) {
      if (name.starts_with(".gjkscope-")) continue;
      EXPECT_EQ(bytes, expected.at(name)) << name;
    }
    EXPECT_EQ(kDone, run_program(arguments + cut).exit_code);
    EXPECT_EQ(files_of(cut), expected);
  }
  EXPECT_GT(killed, 2);
}

TEST(Program, ExportsEachCaseOfAFileAsALesson) {
  const test::TemporaryFolder folder;
  const std::string cases = folder.file("mine.json",
                                        R"({"why": "A point apart", "a": [[0, 0]], "b": [[3, 4]]}
{"name": "in space", "dimension": 3, "a": [[0, 0, 0]], "b": [[1, 2, 2], [3, 2, 2]]})");
  const auto out = folder.path() / "out";
  EXPECT_EQ(kDone,
            run_program("export " + cases + " --size 320x180 --out " + out.string()).exit_code);
  EXPECT_TRUE(std::filesystem::exists(out / "mine-0001.png"));
  EXPECT_TRUE(std::filesystem::exists(out / "mine-2-0001.png"));
  const Ran words = run_program("transcript " + cases);
  EXPECT_TRUE(holds(words.out, "A point apart.")) << words.out;
  EXPECT_TRUE(holds(words.out, "in space")) << words.out;

  const std::string huge = folder.file("huge.json", R"({"a": [[1e300, 0]], "b": [[3, 4]]})");
  const Ran refused = run_program("export " + huge + " --out " + (folder.path() / "no").string());
  EXPECT_EQ(kProblem, refused.exit_code);
  EXPECT_TRUE(holds(refused.err, huge + ":1:")) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "no"));
}

TEST(Program, RefusesOptionsThatAFormatDoesNotTake) {
  const test::TemporaryFolder folder;
  const std::string out = "export segment-closest --out " + (folder.path() / "out").string();
  for (const char* rest :
       {" --format html --theme dark", " --format html --steps 1..2", " --handout 4",
        " --format gif --dpi 200", " --format svg --scale 2", " --format pdf --fps 10",
        " --format gif --transparent", " --format svg --renderer egl", " --seconds 1"}) {
    const Ran ran = run_program(out + rest);
    EXPECT_EQ(kUsage, ran.exit_code) << rest;
    EXPECT_TRUE(holds(ran.err, "goes with")) << rest << ran.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
  const Ran ran = run_program("export segment-closest --handout 4 --out a.gif");
  EXPECT_EQ(ran.err, "gjkscope export: --handout goes with pdf, not with gif\n");
}

TEST(Program, DrawsWithoutOpenGlAndSaysWhenItIsAskedFor) {
  const test::TemporaryFolder folder;
  // Libraries of these names that are none come first.
  for (const char* name : {"libOSMesa.so.8", "libEGL.so.1"}) (void)folder.file(name, "");
  setenv("LD_LIBRARY_PATH", folder.path().c_str(), 1);
  const std::string out = " --size 320x180 --out " + (folder.path() / "out").string();
  for (const char* format : {"png", "svg", "pdf", "gif"}) {
    const Ran ran = run_program("export segment-closest --format " + std::string(format) + out);
    EXPECT_EQ(kDone, ran.exit_code) << format << ran.err;
  }
  const Ran osmesa = run_program("export segment-closest --renderer osmesa" + out);
  const Ran egl = run_program("export segment-closest --renderer egl" + out);
  unsetenv("LD_LIBRARY_PATH");
  EXPECT_EQ(kCannot, osmesa.exit_code);
  EXPECT_EQ(kCannot, egl.exit_code);
  for (const char* words : {"libOSMesa.so.8", "apt-get install libosmesa6"}) {
    EXPECT_TRUE(holds(osmesa.err, words)) << osmesa.err;
  }
  for (const char* words : {"libEGL.so.1", "apt-get install libegl1 libgl1-mesa-dri"}) {
    EXPECT_TRUE(holds(egl.err, words)) << egl.err;
  }
}

TEST(Arguments, SizesAndRanges) {
  EXPECT_EQ((std::pair{1280, 720}), parse_size("1280x720"));
  for (const char* bad :
       {"", "x", "1280", "1280x", "x720", "0x720", "-1x5", "1280X720", "1280x720x3"}) {
    EXPECT_FALSE(parse_size(bad)) << bad;
  }
  EXPECT_EQ(3, parse_steps("3..7")->first);
  EXPECT_EQ(7, parse_steps("3..7")->last);
  EXPECT_EQ(std::nullopt, parse_steps("3..")->last);
  EXPECT_EQ(std::nullopt, parse_steps("..7")->first);
  EXPECT_EQ(4, parse_steps("4")->first);
  EXPECT_EQ(4, parse_steps("4")->last);
  for (const char* bad : {"", "..", "7..3", "0..3", "a..b", "1..2..3", "-1..3"}) {
    EXPECT_FALSE(parse_steps(bad)) << bad;
  }
}

}  // namespace program_test
}  // namespace gjkscope
