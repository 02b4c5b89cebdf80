// `gjkscope judge`: what it prints of logs, and its exit codes.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "command_line.hpp"

namespace gjkscope {
namespace judge_command_test {

using test::Ran;
using test::run_program;

const std::string kHead = "{\"gjk_log\":1,\"a\":[[0,0],[1,0]],\"b\":[[3,0]]}\n";
const std::string kRight =
    kHead + "{\"simplex\":[[1,0]],\"direction\":[-2,0]}\n{\"answer\":{\"distance\":2}}\n";
const std::string kWrong =
    kHead + "{\"simplex\":[[1,0]],\"direction\":[2,0]}\n{\"answer\":{\"distance\":3}}\n";

TEST(JudgeCommand, ReadsStandardInputAndExitsByTheVerdict) {
  const Ran right = run_program("judge -", kRight);
  EXPECT_EQ(kDone, right.exit_code) << right.err;
  EXPECT_EQ("<stdin>: right: 1 iteration, distance 2\n", right.out);
  const std::string deep = R"({"gjk_log":1,"a":[[0,0],[4,0],[0,4]],"b":[[1,0.5]]})"
                           "\n";
  EXPECT_EQ("<stdin>: right: 0 iterations, distance 0, depth 0.5\n",
            run_program("judge -", deep + R"({"answer":{"depth":0.5}})").out);
  EXPECT_EQ("<stdin>:2: wrong: answer: the depth 2 is wrong by 1.5: the depth is 0.5\n",
            run_program("judge -", deep + R"({"answer":{"depth":2}})").out);
  const Ran wrong = run_program("judge -", kWrong);
  EXPECT_EQ(kProblem, wrong.exit_code) << wrong.err;
  EXPECT_EQ(
      "<stdin>:2: wrong: direction of iteration 1: d = (2, 0) does not lead from P = (2, 0) to O: "
      "dot(d, O - P) is -4; the support point becomes b0 - a0 instead of b0 - a1, which lies 1 "
      "farther towards O\n"
      "<stdin>:3: wrong: answer: the distance 3 is wrong by 1: the distance is 2\n",
      wrong.out);
  const Ran bad = run_program("judge -", kHead + "{\"simplex\":[[9,0]]}\n");
  EXPECT_EQ(kCannot, bad.exit_code);
  EXPECT_TRUE(bad.out.empty());
  EXPECT_EQ(
      "<stdin>:2:13: /simplex/0 is [9,0]; expected [index in a, index in b], from 0 to 1 and to "
      "0\n",
      bad.err);
}

TEST(JudgeCommand, JudgesEachFileAndPrintsJson) {
  const test::TemporaryFolder folder;
  const Ran ran =
      run_program("judge --json " + folder.file("right", kRight) + " " +
                  folder.file("wrong", kWrong) + " " + (folder.path() / "missing").string());
  EXPECT_EQ(kCannot, ran.exit_code);
  EXPECT_NE(std::string::npos, ran.err.find("missing"));
  const std::vector<std::string> lines = test::lines_of(ran.out);
  ASSERT_EQ(2u, lines.size());
  const auto right = nlohmann::json::parse(lines[0]);
  EXPECT_EQ(true, right["right"]);
  EXPECT_EQ(nullptr, right["wrong"]);
  EXPECT_EQ(2, right["distance"]);
  EXPECT_FALSE(right.contains("depth"));
  const auto wrong = nlohmann::json::parse(lines[1]);
  EXPECT_EQ(false, wrong["right"]);
  EXPECT_EQ("direction", wrong["wrong"]["part"]);
  EXPECT_EQ(1, wrong["wrong"]["iteration"]);
  EXPECT_EQ(2, wrong["wrong"]["line"]);
  EXPECT_EQ("answer", wrong["wrong_answer"]["part"]);
}

/// Other commands take a log as a lesson of two runs.
TEST(JudgeCommand, ALogIsALessonToCheckAndToTell) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("run.jsonl", kWrong);
  const Ran check = run_program("check " + file);
  EXPECT_EQ(kDone, check.exit_code) << check.out << check.err;
  const Ran words = run_program("transcript " + file);
  EXPECT_EQ(kDone, words.exit_code) << words.err;
  EXPECT_NE(std::string::npos, words.out.find("The logged run answers 3.000")) << words.out;
  EXPECT_NE(std::string::npos, words.out.find("does not lead from P = (2, 0) to O")) << words.out;
  const Ran bad =
      run_program("check " + folder.file("bad.jsonl", kHead + "{\"simplex\":[[9,0]]}\n"));
  EXPECT_EQ(kProblem, bad.exit_code);
  EXPECT_NE(std::string::npos, bad.out.find("bad.jsonl:2:13")) << bad.out;
}

TEST(JudgeCommand, PrintsWhatTheDocumentShows) {
  const std::string page = test::read_file(GJKSCOPE_SOURCE_DIR "/docs/log-format.md");
  std::string log;
  std::string expected;
  for (const std::string& line : test::lines_of(page)) {
    if (line.starts_with("    {")) log += line.substr(4) + "\n";
    if (line.starts_with("    run.jsonl:")) expected += line.substr(4) + "\n";
  }
  const test::TemporaryFolder folder;
  const std::string file = folder.file("run.jsonl", log);
  std::string printed = run_program("judge " + file).out;
  for (std::size_t at = 0; (at = printed.find(file)) != std::string::npos;)
    printed.replace(at, file.size(), "run.jsonl");
  EXPECT_EQ(expected, printed);
}

/// The rows of the table that a program gets, and what else is printed.
Ran tried(const test::TemporaryFolder& folder, const std::string& script,
          const std::string& options = "--family random --family grid --dimension 2 --pairs 100") {
  return run_program("judge --program 'sh " + folder.file("script", script) + "' " + options);
}
bool says(const Ran& ran, const std::string& part) {
  return ran.out.find(part) != std::string::npos;
}

TEST(JudgeProgram, OurOwnProgramFailsNowhere) {
  const Ran ran = run_program("judge --program '" GJKSCOPE_BINARY " solve -' --pairs 40");
  EXPECT_EQ(kDone, ran.exit_code) << ran.out;
  const std::vector<std::string> lines = test::lines_of(ran.out);
  EXPECT_EQ(2u + 22 + 26, lines.size());
  for (std::size_t i = 2; i < lines.size(); ++i)
    EXPECT_NE(std::string::npos, lines[i].find("| 40 | . |")) << lines[i];
}

TEST(JudgeProgram, ProgramsStandSideBySide) {
  const test::TemporaryFolder folder;
  const std::string zero = folder.file("zero", "while read -r line; do echo 0; done\n");
  const std::string programs =
      "judge --program '" GJKSCOPE_BINARY " solve -' --program 'sh " + zero + "'";
  const Ran ran = run_program(programs + " --family gap --family grid --dimension 2 --pairs 20");
  EXPECT_EQ(kProblem, ran.exit_code) << ran.err;
  EXPECT_TRUE(says(ran, "| gjkscope solve - | sh ")) << ran.out;
  EXPECT_TRUE(says(ran, "| gap | 2 | 20 | . | 20 i |")) << ran.out;
  EXPECT_EQ(kUsage, run_program(programs + " --out x").exit_code);
}

TEST(JudgeProgram, AFamilyOfSpaceAloneIsNoneOfThePlane) {
  const Ran ran = run_program("judge --program cat --family flat --dimension 2");
  EXPECT_EQ(kCannot, ran.exit_code);
  EXPECT_NE(std::string::npos, ran.err.find("no family that was named has pairs of dimension 2"))
      << ran.err;
}

TEST(JudgeProgram, AFloatIsHeldToFloats) {
  const std::string options = " --family random --dimension 2 --pairs 100";
  const std::string program = "judge --program '" GJKSCOPE_BINARY " solve - --scalar float'";
  EXPECT_EQ(kDone, run_program(program + options + " --float").exit_code);
  EXPECT_EQ(kProblem, run_program(program + options).exit_code);
}

TEST(JudgeProgram, FailuresAreCountedAndNamed) {
  const test::TemporaryFolder folder;
  const auto answering = [](const std::string& line) {
    return "while read -r line; do echo '" + line + "'; done\n";
  };
  for (const auto& [line, row] :
       std::vector<std::pair<std::string, std::string>>{{R"({"distance":NaN})", "100 n |"},
                                                        {R"({"distance":null})", "100 n |"},
                                                        {R"({"distance":"inf"})", "100 n |"},
                                                        {R"({"error":"no"})", "100 g |"},
                                                        {"hello", "100 x |"},
                                                        {"[]", "100 x |"},
                                                        {R"({"distance":[1]})", "100 x |"},
                                                        {R"({"distance":0})", " i |"},
                                                        {R"({"overlap":true})", " i |"},
                                                        {R"({"overlap":false})", " m |"},
                                                        {"1e3", " r |"}}) {
    const Ran ran = tried(folder, answering(line));
    EXPECT_EQ(kProblem, ran.exit_code) << line;
    EXPECT_TRUE(says(ran, row)) << line << '\n' << ran.out;
  }
}

TEST(JudgeProgram, DepthsAndTranslationsAreHeldToTheTruth) {
  const test::TemporaryFolder folder;
  const auto answering = [](const std::string& change) {
    return GJKSCOPE_BINARY " solve - | sed -E '" + change + "'\n";
  };
  for (const int dimension : {2, 3}) {
    // Beside another program no failing case is made smaller, which would take long.
    const std::string options =
        fmt::format("--program '{} solve -' --family random --dimension {} --pairs 60 --json",
                    GJKSCOPE_BINARY, dimension);
    for (const auto& [change, is_wrong] : std::vector<std::pair<std::string, bool>>{
             {R"(s/"depth":[^,]*/"depth":0.25/)", true},
             {R"(s/"depth":[^,]*/"depth":[1]/)", true},
             {R"(s/"depth":[^,]*/"depth":null/)", false},
             {R"(s/"translation":\[([^],]*),([^],]*)/"translation":[\2,\1/)", true},
             {R"(s/"translation":\[/"translation":[1e3,/)", true},
             {R"(s/"overlap":false/"overlap":false,"depth":1/)", true},
             {R"(s/"overlap":false/"overlap":false,"depth":-1,"translation":[1]/)", false}}) {
      SCOPED_TRACE(change + std::to_string(dimension));
      const Ran ran = tried(folder, answering(change), options);
      EXPECT_EQ(is_wrong ? kProblem : kDone, ran.exit_code) << ran.err;
      const std::vector<std::string> lines = test::lines_of(ran.out);
      ASSERT_EQ(2u, lines.size());
      const auto faults = nlohmann::json::parse(lines[0])["faults"];
      for (const auto& [name, count] : faults.items())
        EXPECT_EQ(name == "depth" && is_wrong, count > 0) << name << ran.out;
    }
  }
  const std::string wrong = answering(R"(s/"depth":[^,]*/"depth":0.25/)");
  const std::string options = "--family identical --pairs 3 --dimension ";
  const Ran ran = tried(folder, wrong, options + "3");
  EXPECT_TRUE(says(ran, "| 3 d |")) << ran.out;
  EXPECT_TRUE(says(ran, "identical: depth\n  the depth is ")) << ran.out;
  const auto row = nlohmann::json::parse(tried(folder, wrong, options + "2 --json").out);
  EXPECT_EQ("depth", row["smallest"]["fault"]);
  EXPECT_NE(0.25, row["smallest"]["depth"].get<double>());
}

TEST(JudgeProgram, ACrashAndSilenceCostTheirCaseOnly) {
  const test::TemporaryFolder folder;
  // Answers with the true program, but crashes or sleeps at some cases.
  const std::string begin = "while read -r line; do n=$((n + 1))\n";
  const std::string end = "printf '%s\\n' \"$line\" | " GJKSCOPE_BINARY " solve -; done\n";
  const std::string marked = R"(case "$line" in *'"a":[[0.5'*) )";
  const std::string options =
      "--family random --dimension 2 --pairs 60 --patience 0.5 --json --seed 4";
  for (const auto& [deed, fault] :
       {std::pair{"kill -9 $$", "crashed"}, std::pair{"sleep 60", "silent"}}) {
    const Ran ran = tried(folder, begin + marked + deed + ";; esac\n" + end, options);
    EXPECT_EQ(kProblem, ran.exit_code) << ran.err;
    const auto row = nlohmann::json::parse(ran.out);
    const int faults = row["faults"][fault].get<int>();
    EXPECT_GE(faults, 1) << ran.out;
    EXPECT_EQ(fault, row["smallest"]["fault"]) << ran.out;
    for (const auto& [name, count] : row["faults"].items())
      EXPECT_TRUE(name == fault || count == 0) << ran.out;
    EXPECT_TRUE(faults == 10 || row["asked"] == 60) << ran.out;
  }
}

TEST(JudgeProgram, AProgramThatAnswersNothingIsGivenUp) {
  const test::TemporaryFolder folder;
  for (const char* script : {"exit 3\n", "exec no-such-program\n", "sleep 60\n", "cat >&2\n"}) {
    const Ran ran = tried(folder, script, "--patience 0.2 --pairs 20");
    EXPECT_EQ(kCannot, ran.exit_code) << script;
    EXPECT_NE(std::string::npos, ran.err.find("the program answers nothing")) << ran.err;
  }
  const Ran endless = run_program(
      "judge --program 'cat /dev/zero' --family random --dimension 2 --pairs 3 --patience 5");
  EXPECT_EQ(kProblem, endless.exit_code);
  EXPECT_TRUE(says(endless, "3 x")) << endless.out;
}

/// The code of docs/judge-program.md in a language, with a distance of points.
TEST(JudgeProgram, TheProgramsOfTheDocumentAnswer) {
  const std::string page = test::read_file(GJKSCOPE_SOURCE_DIR "/docs/judge-program.md");
  const auto code = [&](const std::string& language) {
    const std::string open = "\n```" + language + "\n";
    const std::size_t begin = page.find(open) + open.size();
    return page.substr(begin, page.find("```\n", begin) - begin);
  };
  const std::string python =
      "def distance(a, b):\n    return min(((x[0]-y[0])**2 + (x[1]-y[1])**2)**0.5 for x in a for y "
      "in b)\n";
  const std::string js =
      "const distance = (a, b) => Math.min(...a.flatMap((x) => b.map((y) => Math.hypot(x[0] - "
      "y[0], x[1] - "
      "y[1]))));\n";
  const test::TemporaryFolder folder;
  for (const auto& [program, text] :
       {std::pair{"python3 ", python + code("python")}, std::pair{"node ", js + code("js")}}) {
    const Ran ran =
        run_program("judge --program '" + (program + folder.file("script.cjs", text)) +
                    "' --family random --family identical --dimension 2 --pairs 50 --json");
    const std::vector<std::string> lines = test::lines_of(ran.out);
    ASSERT_EQ(2u, lines.size()) << ran.err;
    const auto random = nlohmann::json::parse(lines[0]);
    EXPECT_EQ(0, random["faults"]["nonsense"]);
    EXPECT_EQ(50, random["asked"]);
    EXPECT_EQ(0, nlohmann::json::parse(lines[1])["faults"]["missed"]);
  }
}

TEST(JudgeProgram, TheSmallestFailingCaseIsReducedAndWritten) {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "failing").string();
  const Ran ran = tried(folder, "while read -r line; do echo '{\"distance\":1}'; done\n",
                        "--family clouds --pairs 50 --out " + out);
  EXPECT_EQ(kProblem, ran.exit_code);
  const auto found = nlohmann::json::parse(test::read_file(out + "/clouds-2d.json"));
  EXPECT_EQ(1u, found["a"].size());
  EXPECT_EQ(1u, found["b"].size());
  EXPECT_NE(std::string::npos, found["why"].get<std::string>().find("answers {\"distance\":1}"));
  const Ran checked = run_program("check " + out + "/clouds-2d.json " + out + "/clouds-2d.toml " +
                                  out + "/clouds-3d.json");
  EXPECT_EQ(kDone, checked.exit_code) << checked.out << checked.err;
}

}  // namespace judge_command_test
}  // namespace gjkscope
