// Pages as files. What they do in a browser is told by tests/web.
#include "site/site.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "lesson/load.hpp"
#include "lessons.hpp"
#include "subjects/subjects.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace site_test {

namespace fs = std::filesystem;

std::string read_whole(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

/// A share folder whose program for browsers is two bytes.
class Site : public ::testing::Test {
 protected:
  Site() {
    fs::create_directories(share_ / "web");
    for (const char* folder : {"assets", "src"})
      fs::create_symlink(fs::path(GJKSCOPE_SOURCE_DIR) / folder, share_ / folder);
    std::ofstream(share_ / "web" / "gjkscope.wasm.gz") << "hi";
    std::ofstream(share_ / "web" / "fonts.css") << "@font-face { }";
  }
  std::string page(const Lesson& lesson) {
    const auto files = export_site({lesson}, {out_, share_, false});
    return read_whole(files.at(0));
  }

  test::TemporaryFolder folder_;
  fs::path share_ = folder_.path() / "share";
  fs::path out_ = folder_.path() / "out";
};

TEST_F(Site, APageHoldsTheFirstFrameAndAllWords) {
  Lesson lesson = testing::shipped_lesson("polygons-gjk");
  const std::string text = page(lesson);
  lesson.questions.clear();
  EXPECT_EQ(count(text, "<li><a href=\"#step="), run_lesson(lesson).frames.size());
  EXPECT_EQ(count(text, "<svg "), 4u) << "stage and panel, in two sizes";
  EXPECT_NE(text.find(">aGk=</script>"), std::string::npos) << "the program, in base64";
  EXPECT_EQ(text.find("{{"), std::string::npos);
  for (const char* fetched : {"<script src", "<img ", "@import", "url(http"})
    EXPECT_EQ(count(text, fetched), 0u) << fetched;
  EXPECT_EQ(count(text, "<link rel=\"icon\" href=\"data:,\">"), 1u) << "no icon is asked for";
  EXPECT_EQ(count(text, "<link "), 1u);
  EXPECT_EQ(page(testing::shipped_lesson("polygons-gjk")), text) << "same lesson, same bytes";
}

TEST_F(Site, APageHoldsItsLessonWhole) {
  for (const char* id : {"polygons-motion", "accuracy-cost"}) {
    const Lesson lesson = testing::shipped_lesson(id);
    const std::string text = page(lesson);
    const std::string begin = "id=\"data\">";
    const std::size_t at = text.find(begin) + begin.size();
    const auto data = nlohmann::json::parse(text.substr(at, text.find("</script>", at) - at));
    const FileReader read = [&](const fs::path& file, std::size_t) -> FileText {
      return {data["files"][file.filename().string()].get<std::string>(), {}};
    };
    LoadedLesson loaded =
        parse_lesson(data["lesson"].get<std::string>(), lesson.id + ".toml", vocabulary(), read);
    ASSERT_TRUE(loaded.lesson) << id;
    loaded.lesson->path = lesson.path;
    EXPECT_EQ(*loaded.lesson, lesson) << id;
  }
}

TEST_F(Site, WhatALessonSaysIsTextAndNeverAnElement) {
  Lesson lesson = testing::shipped_lesson("stop-vertex");
  lesson.title = "</script><script>alert(1)</script>{{wasm}}";
  const std::string text = page(lesson);
  EXPECT_EQ(text.find("<script>alert"), std::string::npos);
  EXPECT_NE(text.find("<h1>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;{{wasm}}</h1>"),
            std::string::npos);
}

TEST_F(Site, AnIndexLinksAllPages) {
  const std::vector<Lesson> lessons = {testing::shipped_lesson("segment-closest"),
                                       testing::shipped_lesson("stop-vertex")};
  const auto files = export_site(lessons, {out_, share_, true});
  ASSERT_EQ(files.size(), 5u);
  EXPECT_NE(read_whole(out_ / "about.html").find("#define GJKSCOPE_B_MINUS_A &quot;b-a&quot;"),
            std::string::npos);
  const std::string index = read_whole(out_ / "index.html");
  for (const char* link :
       {"segment-closest.html", "stop-vertex.html", "playground.html", "about.html"})
    EXPECT_GE(count(index, "href=\"" + std::string(link) + "\""), 1u) << link;
  EXPECT_NE(
      read_whole(out_ / "segment-closest.html").find("class=\"next\" href=\"stop-vertex.html\""),
      std::string::npos);
}

TEST_F(Site, APageOfSomebodyElseIsReplacedOnlyByForce) {
  const Lesson lesson = testing::shipped_lesson("stop-vertex");
  (void)page(lesson);
  (void)page(lesson);
  const fs::path file = out_ / "stop-vertex.html";
  std::ofstream(file) << "<p>My notes";
  EXPECT_THROW((void)page(lesson), std::runtime_error);
  EXPECT_EQ(read_whole(file), "<p>My notes");
  (void)export_site({lesson}, {out_, share_, false, true});
  EXPECT_NE(read_whole(file), "<p>My notes");
}

TEST_F(Site, NothingIsWrittenWhereAnyPageIsSomebodyElses) {
  const std::vector<Lesson> lessons = {testing::shipped_lesson("segment-closest"),
                                       testing::shipped_lesson("stop-vertex")};
  fs::create_directories(out_);
  for (const char* name : {"stop-vertex.html", "playground.html", "index.html", "about.html"}) {
    SCOPED_TRACE(name);
    std::ofstream(out_ / name) << "<p>My notes";
    EXPECT_THROW((void)export_site(lessons, {out_, share_, true}), std::runtime_error);
    EXPECT_EQ(read_whole(out_ / name), "<p>My notes");
    EXPECT_EQ(std::distance(fs::directory_iterator(out_), {}), 1);
    fs::remove(out_ / name);
  }
}

TEST_F(Site, OnePageMayHaveANameOfItsOwn) {
  const auto files = export_site({testing::shipped_lesson("stop-vertex")},
                                 {out_, share_, false, false, "monday.html"});
  EXPECT_EQ(files, std::vector<fs::path>{out_ / "monday.html"});
  EXPECT_NE(read_whole(out_ / "monday.html").find("stop-vertex"), std::string::npos);
}

TEST_F(Site, WithoutTheProgramForBrowsersItSaysHowToBuildIt) {
  fs::remove(share_ / "web" / "fonts.css");
  try {
    (void)export_site({testing::shipped_lesson("stop-vertex")}, {out_, share_, false});
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("cmake --build --preset wasm"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(out_)) << "nothing is left behind";
}

}  // namespace site_test
}  // namespace gjkscope
