#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "command_line.hpp"

namespace gjkscope {
namespace study_test {

using test::read_file;
using test::run_program;
using test::TemporaryFolder;

TEST(StudyCommand, SaysWhatIsWrongWithItsOptions) {
  EXPECT_EQ(run_program("study").exit_code, 2);
  EXPECT_EQ(run_program("study acuracy").exit_code, 2);
  const auto seed = run_program("study accuracy --seed one");
  EXPECT_EQ(seed.exit_code, 2);
  EXPECT_NE(seed.err.find("--seed"), std::string::npos) << seed.err;
  const auto advice = run_program("study accuracy --advice numbers.csv");
  EXPECT_EQ(advice.exit_code, 2);
  EXPECT_NE(advice.err.find("--advice"), std::string::npos) << advice.err;
}

TEST(StudyCommand, SaysBeforehandThatItCannotWrite) {
  const TemporaryFolder folder;
  const std::string file = folder.file("taken", "");
  const auto ran = run_program("study accuracy --quick --out " + file);
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_NE(ran.err.find("cannot make the folder " + file), std::string::npos) << ran.err;
  EXPECT_TRUE(ran.out.empty());
}

TEST(StudyCommand, InterruptedWritesWhatItHas) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::string command = std::string("exec ") + GJKSCOPE_BINARY + " study accuracy --out " +
                              out + " >" + out + ".txt 2>" + out + ".err";
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(1);
  }
  // It tells its progress from the first measurement on.
  const auto begin = std::chrono::steady_clock::now();
  while (read_file(out + ".err").empty() &&
         std::chrono::steady_clock::now() - begin < std::chrono::minutes(1)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_NE(read_file(out + ".err").find("gjkscope: interrupted; "), std::string::npos);
  const auto json = nlohmann::json::parse(read_file(out + "/accuracy.json"));
  EXPECT_EQ(json["complete"], false);
  EXPECT_NE(read_file(out + "/accuracy.csv").find("# complete: 0\n"), std::string::npos);
  EXPECT_NE(read_file(out + "/accuracy.html").find("Interrupted"), std::string::npos);
}

TEST(StudyCommand, MeasuresTheLessonsThatAreNamed) {
  const TemporaryFolder folder;
  const std::string out = " --quick --out " + folder.path().string();
  std::string text = read_file(GJKSCOPE_SOURCE_DIR "/lessons/general-growth.toml");
  const std::size_t sizes = text.find("vertices = [10,");
  ASSERT_NE(sizes, std::string::npos);
  text.replace(sizes, text.find(']', sizes) - sizes, "vertices = [10, 400");
  const std::size_t times = text.find("[growth.times]");
  const std::size_t next = text.find("[[views]]");
  text.erase(times, next - times);
  const std::string small = folder.file("small.toml", text);
  const auto models = run_program("study models polygons-gjk " + small + out);
  EXPECT_EQ(models.exit_code, 0) << models.err;
  EXPECT_EQ(models.out.find("polygons-gjk"), std::string::npos) << "it measures no outlines";
  text.insert(times, read_file(folder.path() / "models.toml") + "\n");
  const auto timed = run_program("transcript --no-questions " + folder.file("timed.toml", text));
  EXPECT_EQ(timed.exit_code, 0) << timed.err;
  EXPECT_NE(timed.out.find("n = 400: all pairs take "), std::string::npos) << timed.out;
}

}  // namespace study_test
}  // namespace gjkscope
