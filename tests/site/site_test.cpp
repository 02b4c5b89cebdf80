// Pages as files. tests/web tests what they do in a browser.
#include "site/site.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <libdeflate.h>

#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/sha256.hpp"
#include "lesson/load.hpp"
#include "lessons.hpp"
#include "site/still.hpp"
#include "subjects/subjects.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace site_test {

namespace fs = std::filesystem;

/// The text of a file that a page holds deflated, in base64.
std::string unpacked(const std::string& base64) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char digit : base64) {
    if (digit == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(kDigits.find(digit));
    held += 6;
    if (held >= 8) bytes += static_cast<char>(bits >> (held -= 8));
  }
  std::string text(1 << 21, '\0');
  std::size_t size = 0;
  libdeflate_decompressor* const decompressor = libdeflate_alloc_decompressor();
  EXPECT_EQ(libdeflate_deflate_decompress(decompressor, bytes.data(), bytes.size(), text.data(),
                                          text.size(), &size),
            LIBDEFLATE_SUCCESS);
  libdeflate_free_decompressor(decompressor);
  text.resize(size);
  return text;
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
    const auto files = export_site({lesson}, {out_, share_});
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
      return {unpacked(data["files"][file.filename().string()].get<std::string>()), {}};
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
  ASSERT_EQ(files.size(), 6u + 5u + 4u + 1u) << "pages, what they share, cards, a service worker";
  for (const fs::path& file : files) EXPECT_TRUE(is_exported(file)) << file;
  EXPECT_NE(read_whole(out_ / "about.html").find("#define GJKSCOPE_B_MINUS_A &quot;b-a&quot;"),
            std::string::npos);
  const std::string index = read_whole(out_ / "index.html");
  for (const char* link : {"segment-closest.html", "stop-vertex.html", "playground.html",
                           "practice.html", "about.html"})
    EXPECT_GE(count(index, "href=\"" + std::string(link) + "\""), 1u) << link;
  EXPECT_NE(
      read_whole(out_ / "segment-closest.html").find("class=\"next\" href=\"stop-vertex.html\""),
      std::string::npos);
}

TEST_F(Site, PagesOfASiteShareWhatTheyHaveInCommon) {
  const std::vector<Lesson> lessons = {testing::shipped_lesson("segment-closest"),
                                       testing::shipped_lesson("stop-vertex")};
  (void)export_site(lessons, {out_, share_, true});
  const std::string page = read_whole(out_ / "stop-vertex.html");
  EXPECT_EQ(count(page, "aGk="), 0u) << "the program";
  EXPECT_EQ(count(read_whole(out_ / "shared" / "program.js"), "textContent = \"aGk=\";"), 1u);
  EXPECT_EQ(count(page, "@font-face"), 0u);
  EXPECT_LT(page.size(), 90000u);
  const std::string worker = read_whole(out_ / "service-worker.js");
  for (const char* file :
       {"index.html", "playground.html", "practice.html", "about.html", "segment-closest.html",
        "stop-vertex.html", "shared/style.css?", "shared/head.js?", "shared/page.js?",
        "shared/program.js?", "cards/stop-vertex.svg?", "cards/stop-vertex-dark.svg?"})
    EXPECT_GE(count(worker, fmt::format("\"{}", file)), 1u) << file;
  // Other content has other addresses, and is another version.
  std::ofstream(share_ / "web" / "gjkscope.wasm.gz") << "ho";
  (void)export_site(lessons, {out_, share_, true});
  const auto address = [](const std::string& text) {
    const std::size_t at = text.find("shared/program.js?");
    return text.substr(at, text.find('"', at) - at);
  };
  EXPECT_NE(address(read_whole(out_ / "stop-vertex.html")), address(page));
  EXPECT_NE(read_whole(out_ / "service-worker.js"), worker);
}

TEST_F(Site, WithSingleEachPageOfASiteIsOneFile) {
  const auto files =
      export_site({testing::shipped_lesson("stop-vertex")}, {out_, share_, true, true});
  EXPECT_EQ(files.size(), 5u);
  EXPECT_EQ(std::distance(fs::directory_iterator(out_), {}), 5);
  for (const fs::path& file : files) {
    const std::string text = read_whole(file);
    EXPECT_EQ(count(text, "shared/"), 0u) << file;
    EXPECT_EQ(count(text, "cards/"), 0u) << file;
    EXPECT_EQ(count(text, "<script src"), 0u) << file;
  }
}

TEST_F(Site, AContentPolicyNamesEachScriptThatAPageHolds) {
  for (const bool single : {false, true}) {
    const auto files =
        export_site({testing::shipped_lesson("stop-vertex")}, {out_, share_, true, single, true});
    for (const fs::path& file : files) {
      if (file.extension() != ".html") continue;
      const std::string text = read_whole(file);
      const std::size_t begin = text.find("script-src");
      const std::string sources = text.substr(begin, text.find(';', begin) - begin);
      EXPECT_EQ(count(sources, "unsafe-inline"), 0u) << file;
      EXPECT_EQ(count(sources, "'self'"), single ? 0u : 1u) << file;
      EXPECT_EQ(count(sources, "'sha256-"), count(text, "<script>")) << file;
    }
  }
}

TEST(Sha256, IsAsTheStandardHasIt) {
  const auto hex = [](std::string_view text) {
    std::string out;
    for (const int byte : sha256(text)) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      out += {kDigits[static_cast<std::size_t>(byte / 16)],
              kDigits[static_cast<std::size_t>(byte % 16)]};
    }
    return out;
  };
  EXPECT_EQ(hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hex(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Still, IsTheSamePictureInFewerBytes) {
  EXPECT_EQ(still("<svg role=\"img\">\n"
                  "<path d=\"M1 2L3.04 2.5L-0.5 2.46Z\" fill=\"none\" data-mark=\"a\"/>\n"
                  "<path d=\"M1 2L3.04 2.5L-0.5 2.46Z\" fill=\"#000000\" data-of=\"X\"/>\n"
                  "<circle cx=\"1\" cy=\"2\" r=\"3\" fill=\"#ffffff\" data-of=\"x 0\"/>\n"
                  "<circle cx=\"4\" cy=\"2\" r=\"3\" fill=\"#ffffff\" data-of=\"z 0 0\"/>\n"
                  "<text x=\"1\" y=\"2\" fill=\"#ffffff\">a b=\"c\"</text>\n"
                  "</svg>\n"),
            "<svg role=\"img\">\n"
            "<path d=\"M1 2l2 .5-3.5 0z\" fill=\"#000000\"/>\n"
            "<g fill=\"#ffffff\">\n"
            "<circle cx=\"1\" cy=\"2\" r=\"3\" data-of=\"x 0\"/>\n"
            "<circle cx=\"4\" cy=\"2\" r=\"3\"/>\n"
            "<text x=\"1\" y=\"2\">a b=\"c\"</text>\n"
            "</g>\n"
            "</svg>\n");
  EXPECT_EQ(still(""), "");
}

TEST_F(Site, APageOfSomebodyElseIsReplacedOnlyByForce) {
  const Lesson lesson = testing::shipped_lesson("stop-vertex");
  (void)page(lesson);
  (void)page(lesson);
  const fs::path file = out_ / "stop-vertex.html";
  std::ofstream(file) << "<p>My notes";
  EXPECT_THROW((void)page(lesson), std::runtime_error);
  EXPECT_EQ(read_whole(file), "<p>My notes");
  (void)export_site({lesson}, {out_, share_, false, false, true});
  EXPECT_NE(read_whole(file), "<p>My notes");
}

TEST_F(Site, NothingIsWrittenWhereAnyPageIsSomebodyElses) {
  const std::vector<Lesson> lessons = {testing::shipped_lesson("segment-closest"),
                                       testing::shipped_lesson("stop-vertex")};
  fs::create_directories(out_);
  for (const fs::path name :
       {"stop-vertex.html", "playground.html", "practice.html", "index.html", "about.html",
        "service-worker.js", "shared/style.css", "shared/program.js", "cards/stop-vertex.svg",
        "cards/stop-vertex-dark.svg"}) {
    SCOPED_TRACE(name);
    fs::create_directories((out_ / name).parent_path());
    std::ofstream(out_ / name) << "<p>My notes";
    EXPECT_THROW((void)export_site(lessons, {out_, share_, true}), std::runtime_error);
    EXPECT_EQ(read_whole(out_ / name), "<p>My notes");
    EXPECT_EQ(std::distance(fs::directory_iterator(out_), {}), 1);
    fs::remove_all(out_ / *name.begin());
  }
}

TEST_F(Site, OnePageMayHaveANameOfItsOwn) {
  const auto files = export_site({testing::shipped_lesson("stop-vertex")},
                                 {out_, share_, false, false, false, "monday.html"});
  EXPECT_EQ(files, std::vector<fs::path>{out_ / "monday.html"});
  EXPECT_NE(read_whole(out_ / "monday.html").find("stop-vertex"), std::string::npos);
}

TEST_F(Site, APackageHoldsAllThatItNamesAndNothingThatAStrictPolicyRefuses) {
  fs::create_symlink(fs::path(GJKSCOPE_SOURCE_DIR) / "LICENSE", share_ / "LICENSE");
  const std::vector<Lesson> lessons = {testing::shipped_lesson("stop-vertex")};
  const SiteOptions options{.out_dir = out_, .share = share_, .package = true};
  const auto files = export_site(lessons, options);
  std::map<std::string, std::string> texts;
  for (const fs::path& file : files)
    texts[file.lexically_relative(out_).generic_string()] = read_whole(file);
  const auto package = nlohmann::json::parse(texts.at("package.json"));
  EXPECT_EQ(package["files"].size() + 1, files.size());
  for (const auto& file : package["files"])
    EXPECT_TRUE(texts.contains(file.get<std::string>())) << file;
  EXPECT_EQ(texts.at("gjkscope.wasm.gz"), "hi");
  const std::string& text = texts.at("pages/stop-vertex.html");
  for (const char* refused : {"<script>", "<style", " style=\"", " onload=", "{{"})
    EXPECT_EQ(count(text, refused), 0u) << refused;
  (void)export_site(lessons, options);
  for (const auto& [file, before] : texts) EXPECT_EQ(read_whole(out_ / file), before) << file;
}

TEST_F(Site, APackageReplacesNothingOfSomebodyElse) {
  fs::create_directories(out_);
  const SiteOptions options{.out_dir = out_, .share = share_, .package = true};
  for (const char* name : {"package.json", "LICENSE", "index.js"}) {
    const fs::path file = out_ / name;
    std::ofstream(file) << "mine";
    EXPECT_THROW((void)export_site({}, options), std::runtime_error);
    EXPECT_EQ(read_whole(file), "mine");
    fs::remove(file);
  }
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
