#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "command_line.hpp"

namespace gjkscope {
namespace transcript_test {

using nlohmann::json;
using test::run_program;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Transcript, HasTitleSourceProseAndTheWordsOfEachFrame) {
  const test::Ran ran = run_program("transcript segment-closest");
  ASSERT_EQ(kDone, ran.exit_code) << ran.err;
  const std::vector<std::string> lines = test::lines_of(ran.out);
  ASSERT_GE(lines.size(), 6u);
  EXPECT_TRUE(holds(lines[0], "segment")) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("Chapter 1, Catto 2010")) << lines[1];
  EXPECT_TRUE(lines[2].empty());
  EXPECT_FALSE(lines[3].empty());
  EXPECT_TRUE(lines[5].starts_with("1. ")) << lines[5];
}

TEST(Transcript, SaysWhatTheSidecarGivesAsAlternativeText) {
  const test::TemporaryFolder folder;
  const std::string out = folder.path().string();
  ASSERT_EQ(kDone,
            run_program("export polygon-pseudocode --size 320x180 --json --out " + out).exit_code);
  const json sidecar = json::parse(test::read_file(folder.path() / "polygon-pseudocode.json"));
  const std::string text = run_program("transcript polygon-pseudocode").out;
  ASSERT_GT(sidecar["frames"].size(), 3u);
  std::size_t at = 0;
  for (const json& frame : sidecar["frames"]) {
    const std::string alt = frame["alt"].get<std::string>();
    EXPECT_EQ(0u, alt.rfind(frame["caption"].get<std::string>(), 0));
    for (const std::string& part : {fmt::format("{}. ", frame["step"].get<int>()),
                                    frame["position"].get<std::string>(), alt}) {
      at = text.find(part, at);
      ASSERT_NE(std::string::npos, at) << part;
    }
    EXPECT_TRUE(holds(text, frame["prose"].get<std::string>()));
  }
}

TEST(Transcript, OfAllLessonsHoldsEachInTheOrderOfTheChapters) {
  const std::string text = run_program("transcript --all").out;
  std::size_t at = 0;
  for (const json& lesson : json::parse(run_program("lessons --json").out)) {
    at = text.find(lesson["title"].get<std::string>() + "\nChapter ", at);
    ASSERT_NE(std::string::npos, at) << lesson["id"];
  }
}

TEST(Transcript, MarkdownHasHeadingsAndNothingElseToInterpret) {
  const test::TemporaryFolder folder;
  std::string text = test::read_file(GJKSCOPE_SOURCE_DIR "/lessons/polygon-evolution.toml");
  const std::string title = "Point to polygon: the simplex evolves";
  text.replace(text.find(title), title.size(), "A <b>*bold*</b> [title]");
  const test::Ran ran = run_program("transcript --markdown " + folder.file("marked-up.toml", text));
  ASSERT_EQ(kDone, ran.exit_code) << ran.err;
  EXPECT_TRUE(ran.out.starts_with("# A \\<b\\>\\*bold\\*\\</b\\> \\[title\\]\n\nChapter 3"))
      << ran.out.substr(0, 100);
  EXPECT_TRUE(holds(ran.out, "\n1. **start"));
}

TEST(Questions, HaveFramesOfTheirOwnThatCanBeLeftOut) {
  const test::TemporaryFolder folder;
  const auto exported = [&](const std::string& options) {
    EXPECT_EQ(kDone, run_program("export triangle-ordered-test --size 160x90 --index --json " +
                                 options + " --out " + folder.path().string())
                         .exit_code);
    return json::parse(test::read_file(folder.path() / "triangle-ordered-test.json"));
  };
  const json asking = exported("");
  const std::string sheet = test::read_file(folder.path() / "index.html");
  const json telling = exported("--no-questions");
  EXPECT_EQ(asking["steps"].get<int>(), telling["steps"].get<int>() + 2);
  std::vector<json> answers;
  std::vector<std::pair<std::string, std::string>> questions;
  for (const json& frame : asking["frames"]) {
    if (!frame.contains("question")) {
      answers.push_back(frame);
      continue;
    }
    EXPECT_EQ(frame["phase"], "question");
    questions.emplace_back(frame["question"]["ask"], frame["question"]["answer"]);
    EXPECT_FALSE(holds(frame["alt"].get<std::string>(), "Answer"));
    EXPECT_TRUE(holds(sheet, frame["file"].get<std::string>()));
  }
  EXPECT_EQ(questions, (std::vector<std::pair<std::string, std::string>>{{"test", "false"},
                                                                         {"region", "BC"}}));
  EXPECT_TRUE(holds(sheet, " class=\"question\""));
  ASSERT_EQ(answers.size(), telling["frames"].size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(telling["frames"][i]["step"].get<std::size_t>(), i + 1);
    EXPECT_EQ(telling["frames"][i]["detail"], answers[i]["detail"]);
    EXPECT_FALSE(telling["frames"][i].contains("question"));
  }
  EXPECT_TRUE(holds(run_program("transcript triangle-ordered-test").out, "Question: "));
  EXPECT_FALSE(
      holds(run_program("transcript triangle-ordered-test --no-questions").out, "Question: "));
}

TEST(Export, ListingsAreCodeWhereTheyHaveSome) {
  const test::TemporaryFolder folder;
  const auto listing_of = [&](const std::string& lesson, const std::string& options) {
    const std::string file = (folder.path() / (lesson + ".svg")).string();
    EXPECT_EQ(kDone,
              run_program(fmt::format("export {} --steps 1 --out {} {}", lesson, file, options))
                  .exit_code);
    const std::string toml = json::parse(run_program("open --json " + file).out)["toml"];
    const std::size_t begin = toml.find("listing = ");
    return toml.substr(begin, toml.find('\n', begin) - begin);
  };
  EXPECT_EQ("listing = \"segment\"", listing_of("segment-closest", ""));
  EXPECT_EQ("listing = \"segment.cpp\"", listing_of("segment-closest", "--listing cpp"));
  EXPECT_EQ("listing = \"segment.py\"", listing_of("segment-closest", "--listing python"));
  EXPECT_EQ("listing = \"slab-proof\"", listing_of("slab-proof", "--listing python"));
  const test::Ran java = run_program("export segment-closest --listing java --out out");
  EXPECT_EQ(kUsage, java.exit_code);
  EXPECT_TRUE(holds(java.err, "pseudocode, cpp, python")) << java.err;
}

}  // namespace transcript_test
}  // namespace gjkscope
