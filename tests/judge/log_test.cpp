// Logs as they are read: what C, Python and JavaScript write, and what is refused, and where.

#include "judge/log.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "base/file.hpp"
#include "judge/gjkscope_log.h"
#include "judge/judge.hpp"
#include "temporary_folder.hpp"

extern "C" void gjkscope_write_c99_log(FILE* file, double distance);

namespace gjkscope::judging {
namespace log_test {

namespace fs = std::filesystem;

/// The output of `write`.
template <class Write>
std::string written(const Write& write) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.path() / "log";
  std::FILE* out = std::fopen(file.c_str(), "w");
  write(out);
  std::fclose(out);
  return read_whole(file);
}

std::string problem_of(std::string_view text) {
  const ReadLog read = read_log(text, "log");
  EXPECT_EQ(read.log.has_value(), read.problems.empty());
  return read.problems.empty() ? "none" : to_string(read.problems.front());
}

const std::string kHead = R"({"gjk_log":1,"a":[[0,0],[1,0]],"b":[[3,1]]})"
                          "\n";

TEST(Header, WritesWhatIsReadBack) {
  const std::string text = written([](FILE* file) { gjkscope_write_c99_log(file, 2); });
  const ReadLog read = read_log(text, "log");
  ASSERT_TRUE(read.log) << to_string(read.problems) << text;
  EXPECT_EQ(read.log->dimension, 3);
  EXPECT_EQ(read.log->scalar, ScalarKind::single);
  EXPECT_FALSE(read.log->a_is_x);
  ASSERT_EQ(read.log->iterations.size(), 1u);
  EXPECT_EQ(read.log->iterations[0].simplex[1], (gjk::VertexPair{0, 1}));
  EXPECT_EQ(read.log->answer->distance, 2);
  const Judgement judgement = judge(*read.log);
  EXPECT_TRUE(judgement.right()) << (judgement.wrong ? judgement.wrong->what : "");
  const Judgement wrong =
      judge(*read_log(written([](FILE* file) { gjkscope_write_c99_log(file, 1.5); }), "log").log);
  ASSERT_TRUE(wrong.answer);
  EXPECT_EQ(wrong.answer->what, "the distance 1.5 is wrong by 0.5: the distance is 2");
}

TEST(Header, WritesAnyNumberAndFlushesLines) {
  const std::string text = written([](FILE* file) {
    gjkscope_log log;
    gjkscope_log_begin(&log, file, 2, GJKSCOPE_B_MINUS_A, "double");
    gjkscope_log_vertex(&log, "a", 0.1, -0.0, 0);
    gjkscope_log_vertex(&log, "b", 5e-324, 1.7976931348623157e308, 0);
    gjkscope_log_iteration(&log);
    gjkscope_log_vector(&log, "closest", std::numeric_limits<double>::quiet_NaN(),
                        -std::numeric_limits<double>::infinity(), 0);
    gjkscope_log_end(&log);
  });
  EXPECT_EQ(text,
            "{\"gjk_log\":1,\"difference\":\"b-a\",\"scalar\":\"double\","
            "\"a\":[[0.10000000000000001,-0]],"
            "\"b\":[[4.9406564584124654e-324,1.7976931348623157e+308]]}\n"
            "{\"closest\":[\"nan\",\"-inf\"]}\n");
  const ReadLog read = read_log(text, "log");
  ASSERT_TRUE(read.log) << to_string(read.problems);
  EXPECT_EQ(read.log->y[0], Point(5e-324, 1.7976931348623157e308, 0));
  EXPECT_FALSE(judge(*read.log).right());
}

TEST(Header, HasAtMost200Lines) {
  const std::string text = read_whole(fs::path(GJKSCOPE_SOURCE_DIR) / "src/judge/gjkscope_log.h");
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 200);
}

/// The code of docs/log-format.md in a language, and then `use`, run by `program`.
std::string printed(const std::string& language, const std::string& program,
                    const std::string& use) {
  const std::string page = read_whole(fs::path(GJKSCOPE_SOURCE_DIR) / "docs/log-format.md");
  const std::string open = "\n```" + language + "\n";
  const std::size_t begin = page.find(open) + open.size();
  const std::string code = page.substr(begin, page.find("```\n", begin) - begin);
  EXPECT_LE(std::count(code.begin(), code.end(), '\n'), 22) << language;
  const test::TemporaryFolder folder;
  const std::string script = folder.file("script", code + use);
  const fs::path out = folder.path() / "out";
  EXPECT_EQ(0, std::system(fmt::format("{} {} >{}", program, script, out.string()).c_str()));
  return read_whole(out);
}

void expect_right_then_not_finite(const std::string& text) {
  const ReadLog read = read_log(text, "log");
  ASSERT_TRUE(read.log) << to_string(read.problems) << text;
  EXPECT_EQ(read.log->x[1], Point(0.1, 1, 0));
  const Judgement judgement = judge(*read.log);
  ASSERT_TRUE(judgement.wrong) << text;
  EXPECT_EQ(judgement.wrong->iteration, 2) << judgement.wrong->what;
  EXPECT_EQ(judgement.wrong->part, Part::direction) << judgement.wrong->what;
  EXPECT_FALSE(judgement.answer);
}

TEST(Python, WritesALog) {
  expect_right_then_not_finite(printed("python", "python3", R"(
import sys
log = Log(sys.stdout, [[0, 0], [0.1, 1.0]], [(3, 0.5)])
log.iteration(simplex=[[0, 0]], closest=(3, 0.5), direction=[-3, -0.5], support=[1, 0])
log.iteration(simplex=[[0, 0], [1, 0]], direction=[float("nan"), -math.inf])
log.answer(distance=2.95 / math.sqrt(1.01), overlap=False)
)"));
}

TEST(JavaScript, WritesALog) {
  expect_right_then_not_finite(printed("js", "node", R"(
const log = new Log((text) => process.stdout.write(text), [[0, 0], [0.1, 1]], [new Float64Array([3, 0.5])]);
log.iteration({ simplex: [[0, 0]], closest: [3, 0.5], direction: [-3, -0.5], support: [1, 0] });
log.iteration({ simplex: [[0, 0], [1, 0]], direction: [NaN, -Infinity] });
log.answer({ distance: 2.95 / Math.sqrt(1.01), overlap: false });
)"));
}

TEST(Reading, ProblemsHaveTheirPlaceAndWhatWasExpected) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "log:1:1: there is no log; expected {\"gjk_log\":1"},
      {"\n\n", "log:2:1: there is no log"},
      {"hello\n", "log:1:1: this is not JSON"},
      {"[1]\n", "log:1:1: this line is [1]; expected one JSON object a line"},
      {"{\"a\":[[0,0]],\"b\":[[1,1]]}\n", "log:1:1: the first line has no 'gjk_log'"},
      {"{\"gjk_log\":2,\"a\":[[0,0]],\"b\":[[1,1]]}\n", "log:1:12: /gjk_log is 2"},
      {"{\"gjk_log\":1,\"a\":[[0,0]]}\n", "log:1:1: the first line has no 'b'"},
      {"{\"gjk_log\":1,\"a\":[],\"b\":[[1,1]]}\n", "log:1:18: /a is empty"},
      {"{\"gjk_log\":1,\"a\":[[0,0],[1]],\"b\":[[1,1]]}\n",
       "log:1:25: /a/1 is [1]; expected two numbers, [x, y]"},
      {"{\"gjk_log\":1,\"a\":[[0,\"nan\"]],\"b\":[[1,1]]}\n", "log:1:19: /a/0 is not finite"},
      {"{\"gjk_log\":1,\"a\":[[0,1e999]],\"b\":[[1,1]]}\n",
       "log:1:1: a number of this line is too"},
      {"{\"gjk_log\":1,\"scalr\":\"float\",\"a\":[[0,0]],\"b\":[[1,1]]}\n",
       "log:1:22: unknown key 'scalr'; expected one of"},
      {"{\"gjk_log\":1,\"difference\":\"x\",\"a\":[[0,0]],\"b\":[[1,1]]}\n",
       "log:1:27: /difference is \"x\"; expected \"b-a\" or \"a-b\""},
      {"{\"gjk_log\":1,\"scalar\":\"exact\",\"a\":[[0,0]],\"b\":[[1,1]]}\n",
       "log:1:23: /scalar is \"exact\""},
      {kHead + "{\"simplex\":[[0,1]]}\n",
       "log:2:13: /simplex/0 is [0,1]; expected [index in a, index in b], from 0 to 1 and to 0"},
      {kHead + "{\"simplex\":[[0,0],[-1,0]]}\n", "log:2:19: /simplex/1 is [-1,0]"},
      {kHead + "{\"support\":[0.5,0]}\n", "log:2:12: /support is [0.5,0]"},
      {kHead + "{\"support\":[99999999999999999999,0]}\n", "log:2:12: /support is"},
      {kHead + "{\"simplex\":[[0,0],[1,0]],\"weights\":[1]}\n",
       "log:2:36: /weights has 1 entries, /simplex has 2"},
      {kHead + "{\"closest\":[1,2,3]}\n", "log:2:12: /closest is [1,2,3]; expected two numbers"},
      {kHead + "{\"closest\":{}}\n", "log:2:12: /closest is an object"},
      {kHead + "{\"simplex\":[[0,0]]\n{}\n", "log:2:19: this is not JSON"},
      {kHead + "{\"answer\":{}}\n{}\n", "log:3:1: a line follows the answer"},
      {kHead + "{\"answer\":{\"distance\":\"far\"}}\n",
       "log:2:23: /answer/distance is \"far\"; expected a number"},
      {kHead + "{\"answer\":{\"overlap\":1}}\n", "log:2:22: /answer/overlap is 1"},
      {kHead + "{\"answer\":{\"depth\":[1]}}\n",
       "log:2:20: /answer/depth is [1]; expected a number"},
      {kHead + "{\"answer\":{\"translation\":[1,2,3]}}\n",
       "log:2:26: /answer/translation is [1,2,3]; expected two numbers, [x, y]"},
      {kHead + "\xff\xfe\n", "log:2:1: this is not JSON"},
  };
  for (const auto& [text, problem] : cases) {
    EXPECT_TRUE(problem_of(text).starts_with(problem)) << problem_of(text) << "\nfor " << text;
  }
}

TEST(Reading, ALastLineThatIsCutOffIsLeftOut) {
  const ReadLog read = read_log(kHead + "{\"simplex\":[[0,0]]}\n{\"simplex\":[[0,", "log");
  ASSERT_TRUE(read.log);
  EXPECT_EQ(read.log->iterations.size(), 1u);
  EXPECT_TRUE(read.log->cut_off);
  EXPECT_NE(problem_of(kHead.substr(0, 20)), "none");
}

TEST(Reading, WithoutShapesNothingElseIsRead) {
  const ReadLog read = read_log("{\"gjk_log\":1,\"a\":[[0,0]]}\n{\"simplex\":[[0,0]]}\n", "log");
  ASSERT_EQ(read.problems.size(), 1u);
  EXPECT_EQ(read.problems[0].what, "the first line has no 'b'");
}

TEST(Reading, HostileLinesAreRefusedSoon) {
  const auto begin = std::chrono::steady_clock::now();
  const std::string many(1000000, '[');
  EXPECT_EQ(problem_of(many + "\n").substr(0, 6), "log:1:");
  EXPECT_NE(problem_of(kHead + "{\"simplex\":" + many + std::string(1000000, ']') + "}\n"), "none");
  EXPECT_NE(problem_of(kHead + std::string(1000000, 'x') + "\n"), "none");
  EXPECT_NE(problem_of(kHead + "{\"" + std::string(1000000, 'k') + "\":1}\n"), "none");
  std::string lines = kHead;
  for (int i = 0; i < 100000; ++i) lines += "{\"x\":1}\n";
  EXPECT_EQ(read_log(lines, "log").problems.size(), 20u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(Reading, EveryCutOfALogIsReadOrRefused) {
  const std::string whole = written([](FILE* file) { gjkscope_write_c99_log(file, 2); });
  for (std::size_t i = 0; i <= whole.size(); ++i) {
    const ReadLog read = read_log(whole.substr(0, i), "log");
    EXPECT_EQ(read.log.has_value(), read.problems.empty()) << i;
    if (read.log) static_cast<void>(judge(*read.log));
  }
}

}  // namespace log_test
}  // namespace gjkscope::judging
