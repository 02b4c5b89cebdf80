// `gjkscope judge`: what it prints of logs, and its exit codes.

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
  const auto wrong = nlohmann::json::parse(lines[1]);
  EXPECT_EQ(false, wrong["right"]);
  EXPECT_EQ("direction", wrong["wrong"]["part"]);
  EXPECT_EQ(1, wrong["wrong"]["iteration"]);
  EXPECT_EQ(2, wrong["wrong"]["line"]);
  EXPECT_EQ("answer", wrong["wrong_answer"]["part"]);
}

}  // namespace judge_command_test
}  // namespace gjkscope
