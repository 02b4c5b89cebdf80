#include "export/export.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "base/html.hpp"
#include "export/contact_sheet.hpp"
#include "export/record.hpp"
#include "lesson/load.hpp"
#include "subjects/subjects.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace export_test {

namespace fs = std::filesystem;

const fs::path kSource = GJKSCOPE_SOURCE_DIR;

Lesson lesson(const std::string& id) {
  LoadedLesson loaded = load_lesson(kSource / "lessons" / (id + ".toml"), vocabulary());
  if (!loaded.lesson) throw std::runtime_error(to_string(loaded.problems.front()));
  return *loaded.lesson;
}

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Name and bytes of every file of a folder.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files[entry.path().filename().string()] = read(entry.path());
  }
  return files;
}

class Export : public ::testing::Test {
 protected:
  /// Small frames: the tests are about files.
  ExportOptions options(const std::string& name = "out") const {
    ExportOptions options;
    options.out_dir = folder_ / name;
    options.assets_dir = kSource / "assets";
    options.width = 640;
    options.height = 360;
    options.jobs = 2;
    return options;
  }
  std::string error_of(const ExportOptions& options) const {
    try {
      static_cast<void>(export_lessons({lesson("segment-closest")}, options));
      return "no error";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  test::TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
};

TEST_F(Export, WritesNumberedFramesAndASidecarThatDescribesThem) {
  const ExportResult result = export_lessons({lesson("segment-closest")}, options());
  ASSERT_GT(result.frames, 1);
  EXPECT_EQ(result.files.size(), static_cast<std::size_t>(result.frames) + 1);
  EXPECT_EQ(result.files.front().filename(), "segment-closest-0001.png");
  EXPECT_EQ(result.files.back().filename(), "segment-closest.json");
  EXPECT_EQ(result.signal, 0);

  const auto files = contents(folder_ / "out");
  EXPECT_EQ(files.size(), result.files.size()) << "nothing else is left in the folder";
  const auto json = nlohmann::json::parse(files.at("segment-closest.json"));
  EXPECT_EQ(json["version"], 2);
  EXPECT_EQ(json["lesson"], "segment-closest");
  EXPECT_EQ(json["theme"], "light");
  EXPECT_EQ(json["width"], 640);
  EXPECT_EQ(json["height"], 360);
  ASSERT_EQ(json["frames"].size(), static_cast<std::size_t>(result.frames));
  for (const auto& frame : json["frames"]) {
    const std::string name = frame["file"];
    EXPECT_EQ(files.at(name).substr(0, 8), "\x89PNG\r\n\x1a\n") << name;
    EXPECT_FALSE(frame["caption"].get<std::string>().empty()) << name;
    EXPECT_TRUE(frame["values"].is_object()) << name;
    EXPECT_TRUE(frame["iteration"].is_number_integer()) << name;
    EXPECT_TRUE(frame["phase"].is_string()) << name;
  }
}

TEST_F(Export, BytesDoNotDependOnThreadsOrOnEarlierRuns) {
  const std::vector<Lesson> lessons = {lesson("segment-closest"), lesson("triangle-ordered-test")};
  ExportOptions one = options("one");
  one.jobs = 1;
  one.index = true;
  ExportOptions four = options("four");
  four.jobs = 4;
  four.index = true;
  static_cast<void>(export_lessons(lessons, one));
  static_cast<void>(export_lessons(lessons, four));
  const auto expected = contents(one.out_dir);
  EXPECT_EQ(contents(four.out_dir), expected);
  static_cast<void>(export_lessons(lessons, four));
  EXPECT_EQ(contents(four.out_dir), expected);
}

TEST_F(Export, ARangeOfStepsGivesTheFramesOfAWholeExport) {
  static_cast<void>(export_lessons({lesson("segment-closest")}, options("all")));
  ExportOptions some = options("some");
  some.first_step = 2;
  some.last_step = 3;
  const ExportResult result = export_lessons({lesson("segment-closest")}, some);
  EXPECT_EQ(result.frames, 2);
  const auto all = contents(folder_ / "all");
  const auto files = contents(some.out_dir);
  EXPECT_EQ(files.at("segment-closest-0002.png"), all.at("segment-closest-0002.png"));
  EXPECT_EQ(files.at("segment-closest-0003.png"), all.at("segment-closest-0003.png"));
  EXPECT_EQ(files.size(), 3u);
  EXPECT_EQ(nlohmann::json::parse(files.at("segment-closest.json"))["frames"][0]["step"], 2);
}

TEST_F(Export, FramesOfALongerPastAreRemovedAndNoOthers) {
  fs::create_directories(options().out_dir);
  for (const char* name :
       {"segment-closest-0999.png", "segment-closest-12345.png", "segment-closest-notes.png",
        "segment-closest-0999.png.bak", "other-0999.png"}) {
    std::ofstream(options().out_dir / name) << signature();
  }
  ExportOptions some = options();
  some.last_step = 1;
  static_cast<void>(export_lessons({lesson("segment-closest")}, some));
  EXPECT_TRUE(fs::exists(some.out_dir / "segment-closest-0999.png")) << "only some were asked for";
  static_cast<void>(export_lessons({lesson("segment-closest")}, options()));
  EXPECT_FALSE(fs::exists(some.out_dir / "segment-closest-0999.png"));
  EXPECT_FALSE(fs::exists(some.out_dir / "segment-closest-12345.png"));
  EXPECT_TRUE(fs::exists(some.out_dir / "segment-closest-notes.png"));
  EXPECT_TRUE(fs::exists(some.out_dir / "segment-closest-0999.png.bak"));
  EXPECT_TRUE(fs::exists(some.out_dir / "other-0999.png"));
}

TEST_F(Export, LeftoversOfTheDeadAreRemovedNotThoseOfTheLiving) {
  fs::create_directories(options().out_dir);
  // Process ids of Linux end at 2^22; process 1 always lives.
  const fs::path dead = options().out_dir / ".gjkscope-4999999-a-0001.png.part";
  const fs::path living = options().out_dir / ".gjkscope-1-a-0001.png.part";
  const fs::path foreign = options().out_dir / ".gjkscope-notes.part";
  for (const fs::path& path : {dead, living, foreign}) std::ofstream(path) << "half";
  static_cast<void>(export_lessons({}, options()));
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(living));
  EXPECT_TRUE(fs::exists(foreign));
}

TEST_F(Export, AnInterruptLeavesWholeFilesOnly) {
  const std::vector<Lesson> lessons(3, lesson("polygons-gjk"));
  const ExportOptions reference = options("reference");
  static_cast<void>(export_lessons({lessons.front()}, reference));
  const auto whole = contents(reference.out_dir);

  const ExportOptions cut = options("cut");
  std::thread interrupter([&] {
    while (!fs::exists(cut.out_dir / "polygons-gjk-0003.png")) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ::kill(::getpid(), SIGTERM);
  });
  const ExportResult result = export_lessons(lessons, cut);
  interrupter.join();
  EXPECT_EQ(result.signal, SIGTERM);
  EXPECT_GE(result.frames, 3);
  for (const auto& [name, bytes] : contents(cut.out_dir)) {
    ASSERT_TRUE(whole.contains(name)) << name << " should not be there";
    EXPECT_EQ(bytes, whole.at(name)) << name;
  }
}

TEST_F(Export, AFullDiskIsAnErrorThatNamesTheFileAndLeavesNoPart) {
  for (const Format format : {Format::png, Format::svg, Format::pdf, Format::tex, Format::gif,
                              Format::apng, Format::mp4, Format::webm}) {
    SCOPED_TRACE(name_of(format));
    ExportOptions full = options(std::string(name_of(format)));
    full.format = format;
    full.seconds = 0.1;
    static_cast<void>(export_lessons({}, full));
    rlimit before = {};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit tight{2048, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &tight);
    const std::string error = error_of(full);
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_NE(error.find("cannot write "), std::string::npos) << error;
    EXPECT_NE(error.find("segment-closest"), std::string::npos) << error;
    for (const auto& [name, bytes] : contents(full.out_dir)) ADD_FAILURE() << name << " is left";
  }
}

TEST_F(Export, AFolderThatCannotBeMadeIsAnErrorThatNamesIt) {
  std::ofstream(folder_ / "file") << "in the way";
  ExportOptions blocked = options();
  blocked.out_dir = folder_ / "file";
  EXPECT_NE(error_of(blocked).find((folder_ / "file").string()), std::string::npos);
  blocked.out_dir = folder_ / "file" / "below";
  EXPECT_NE(error_of(blocked).find((folder_ / "file" / "below").string()), std::string::npos);
}

TEST_F(Export, WhatThereIsNotIsAnError) {
  ExportOptions wrong = options();
  wrong.theme = "sepia";
  EXPECT_NE(error_of(wrong).find("dark, high-contrast, light, print"), std::string::npos);
  wrong = options();
  wrong.format = Format::gif;
  wrong.transparent = true;
  EXPECT_NE(error_of(wrong).find("gif cannot be transparent"), std::string::npos);
  wrong = options();
  wrong.format = Format::pdf;
  wrong.caption = CaptionPlace::file;
  EXPECT_NE(error_of(wrong).find("not of pdf"), std::string::npos);
  wrong = options();
  wrong.width = 100;
  EXPECT_NE(error_of(wrong).find("160x90"), std::string::npos);
  wrong = options();
  wrong.first_step = 500;
  EXPECT_NE(error_of(wrong).find("segment-closest has steps 1.."), std::string::npos);
  wrong = options();
  wrong.first_step = 3;
  wrong.last_step = 2;
  EXPECT_NE(error_of(wrong).find("asked for 3..2"), std::string::npos);
}

TEST_F(Export, WhatIsUpToDateStaysAndWhatIsStaleNever) {
  const ExportOptions plain = options();
  const ExportResult first = export_lessons({lesson("segment-closest")}, plain);
  EXPECT_EQ(first.kept, 0);
  const auto expected = contents(plain.out_dir);
  EXPECT_EQ(export_lessons({lesson("segment-closest")}, plain).kept, first.frames);
  EXPECT_EQ(contents(plain.out_dir), expected);

  // One frame is gone, one is cut short, one is another step's.
  fs::remove(plain.out_dir / "segment-closest-0001.png");
  std::ofstream(plain.out_dir / "segment-closest-0002.png") << signature();
  fs::copy_file(plain.out_dir / "segment-closest-0004.png",
                plain.out_dir / "segment-closest-0003.png", fs::copy_options::overwrite_existing);
  EXPECT_EQ(export_lessons({lesson("segment-closest")}, plain).kept, first.frames - 3);
  EXPECT_EQ(contents(plain.out_dir), expected);

  ExportOptions dark = plain;
  dark.theme = "dark";
  EXPECT_EQ(export_lessons({lesson("segment-closest")}, dark).kept, 0);
  EXPECT_EQ(export_lessons({lesson("segment-closest")}, plain).kept, 0);
  ExportOptions small = plain;
  small.width = 320;
  small.height = 180;
  EXPECT_EQ(export_lessons({lesson("segment-closest")}, small).kept, 0);
  Lesson changed = lesson("segment-closest");
  changed.y().vertices.front().x() += 0x1p-40;
  static_cast<void>(export_lessons({lesson("segment-closest")}, plain));
  EXPECT_EQ(export_lessons({changed}, plain).kept, 0);
}

TEST_F(Export, WhatWasNotExportedIsReplacedOnlyByForce) {
  ExportOptions careful = options();
  fs::create_directories(careful.out_dir);
  const fs::path mine = careful.out_dir / "segment-closest-0002.png";
  std::ofstream(mine) << "a photograph";
  EXPECT_NE(error_of(careful).find(mine.string() + " is there"), std::string::npos);
  EXPECT_EQ(read(mine), "a photograph");
  EXPECT_EQ(contents(careful.out_dir).size(), 1u) << "nothing is drawn before that is known";
  careful.force = true;
  EXPECT_EQ(error_of(careful), "no error");
  EXPECT_EQ(read(mine).substr(1, 3), "PNG");
}

TEST_F(Export, NoFileThatGoesWithFramesReplacesAnother) {
  ExportOptions careful = options();
  careful.caption = CaptionPlace::file;
  careful.index = true;
  fs::create_directories(careful.out_dir);
  for (const char* name : {"segment-closest-0002.txt", "segment-closest.json", "index.html"}) {
    const fs::path mine = careful.out_dir / name;
    std::ofstream(mine) << "notes";
    EXPECT_NE(error_of(careful).find(mine.string() + " is there"), std::string::npos);
    EXPECT_EQ(contents(careful.out_dir), (std::map<std::string, std::string>{{name, "notes"}}));
    fs::remove(mine);
  }
  EXPECT_EQ(error_of(careful), "no error");
  EXPECT_EQ(error_of(careful), "no error") << "what was exported is replaced";

  ExportOptions slides = options("slides");
  slides.format = Format::tex;
  fs::create_directories(slides.out_dir);
  std::ofstream(slides.out_dir / "segment-closest-pages.pdf") << "a paper";
  EXPECT_NE(error_of(slides).find("segment-closest-pages.pdf is there"), std::string::npos);
  EXPECT_EQ(contents(slides.out_dir).size(), 1u);
}

TEST_F(Export, APictureOnTheWayIsKeptOnlyInItsOwnPlace) {
  ExportOptions moving = options();
  moving.format = Format::svg;
  moving.fps = 10;
  moving.last_step = 3;
  static_cast<void>(export_lessons({lesson("polygons-gjk")}, moving));
  const auto expected = contents(moving.out_dir);
  fs::copy_file(moving.out_dir / "polygons-gjk-0002-01.svg",
                moving.out_dir / "polygons-gjk-0002-02.svg", fs::copy_options::overwrite_existing);
  static_cast<void>(export_lessons({lesson("polygons-gjk")}, moving));
  EXPECT_EQ(contents(moving.out_dir), expected);
}

TEST_F(Export, EveryFormatHasTheSameBytesEachTimeAndARecordThatLeadsBack) {
  const std::vector<std::pair<Format, int>> formats = {
      {Format::png, 0},  {Format::svg, 0},  {Format::pdf, 0},  {Format::tex, 0},
      {Format::gif, 0},  {Format::apng, 0}, {Format::png, 10}, {Format::svg, 10},
      {Format::gif, 10}, {Format::apng, 10}};
  for (const auto& [format, fps] : formats) {
    const std::string name = std::string(name_of(format)) + std::to_string(fps);
    SCOPED_TRACE(name);
    ExportOptions one = options(name + "-1");
    one.format = format;
    one.fps = fps;
    one.jobs = 1;
    one.width = 320;
    one.height = 180;
    ExportOptions two = one;
    two.out_dir = folder_ / (name + "-2");
    two.jobs = 3;
    const ExportResult result = export_lessons({lesson("segment-closest")}, one);
    static_cast<void>(export_lessons({lesson("segment-closest")}, two));
    EXPECT_EQ(contents(one.out_dir), contents(two.out_dir));
    EXPECT_EQ(export_lessons({lesson("segment-closest")}, one).kept, result.frames);

    const std::string bytes = read(result.files.front());
    const auto record =
        find_record({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    ASSERT_TRUE(record);
    EXPECT_EQ(record->lesson, "segment-closest");
    EXPECT_EQ(record->frames.size(),
              has_file_per_frame(format) ? 1u : static_cast<std::size_t>(result.frames));
    const LoadedLesson again =
        parse_lesson(record->toml, kSource / "lessons/segment-closest.toml", vocabulary());
    ASSERT_TRUE(again.lesson);
    EXPECT_EQ(again.lesson->y(), lesson("segment-closest").y());
  }
}

TEST_F(Export, WhatLeadsToAFrameComesBeforeItAndNothingIsLeftOfOthers) {
  ExportOptions moving = options();
  moving.format = Format::svg;
  moving.last_step = 3;
  const auto names = [&](int fps) {
    moving.fps = fps;
    static_cast<void>(export_lessons({lesson("polygons-gjk")}, moving));
    std::vector<std::string> out;
    for (const auto& [name, bytes] : contents(moving.out_dir)) out.push_back(name);
    return out;
  };
  const std::vector<std::string> still = names(0);
  EXPECT_EQ(still.size(), 4u);
  const std::vector<std::string> at_ten = names(10);
  EXPECT_EQ(at_ten,
            (std::vector<std::string>{"polygons-gjk-0001.svg", "polygons-gjk-0002-01.svg",
                                      "polygons-gjk-0002-02.svg", "polygons-gjk-0002.svg",
                                      "polygons-gjk-0003-01.svg", "polygons-gjk-0003-02.svg",
                                      "polygons-gjk-0003.svg", "polygons-gjk.json"}));
  moving.last_step.reset();
  const std::size_t all = names(10).size();
  EXPECT_GT(all, at_ten.size());
  EXPECT_LT(names(7).size(), all);
  EXPECT_LT(names(0).size(), all / 2);
  moving.format = Format::pdf;
  moving.fps = 10;
  EXPECT_EQ(error_of(moving), "png, svg and films can move; pdf cannot");
}

TEST_F(Export, AFilmOfSpaceTurns) {
  ExportOptions turning = options();
  turning.format = Format::apng;
  turning.width = 320;
  turning.height = 180;
  turning.seconds = 1.0;
  turning.fps = 5;
  turning.last_step = 2;
  const auto images = [&] {
    const ExportResult result = export_lessons({lesson("polyhedra-witness")}, turning);
    const std::string bytes = read(result.files.front());
    const std::size_t count = bytes.find("acTL") + 7;  // the last byte of a number of four
    return static_cast<int>(static_cast<unsigned char>(bytes.at(count)));
  };
  const int still = images();
  turning.turn = 90.0;
  // One second of the first frame, two of the last, and the way between them.
  EXPECT_EQ(images(), 5 + 2 + 10);
  EXPECT_LT(still, 5);
  EXPECT_EQ(error_of(turning), "segment-closest: its shapes are in the plane, which does not turn");
  turning.format = Format::png;
  EXPECT_EQ(error_of(turning), "films can turn; png cannot");
}

TEST_F(Export, AStepInWhichNothingMovesIsDrawnOnce) {
  ExportOptions moving = options();
  moving.format = Format::svg;
  moving.fps = 10;
  static_cast<void>(export_lessons({lesson("polygon-pseudocode")}, moving));
  const auto files = contents(moving.out_dir);
  EXPECT_TRUE(files.contains("polygon-pseudocode-0008-01.svg"));
  EXPECT_FALSE(files.contains("polygon-pseudocode-0009-01.svg")) << "only the words change";
  EXPECT_TRUE(files.contains("polygon-pseudocode-0009.svg"));
}

TEST_F(Export, TheContactSheetShowsEveryFrameWithItsWords) {
  ExportOptions with_index = options();
  with_index.index = true;
  const ExportResult result = export_lessons({lesson("segment-closest")}, with_index);
  EXPECT_EQ(result.files.back().filename(), "index.html");
  const std::string html = read(with_index.out_dir / "index.html");
  const auto json = nlohmann::json::parse(read(with_index.out_dir / "segment-closest.json"));
  for (const auto& frame : json["frames"]) {
    EXPECT_NE(html.find("<img src=\"" + frame["file"].get<std::string>() + "\""),
              std::string::npos);
    EXPECT_NE(html.find(escape_html(frame["caption"].get<std::string>())), std::string::npos);
  }
  EXPECT_EQ(html.find("<!-- lessons -->"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos) << "it works offline";
}

TEST_F(Export, TheContactSheetHasTheMapOfTheCourseWithLinksToItsChapters) {
  ExportOptions with_index = options();
  with_index.index = true;
  with_index.format = Format::png;
  static_cast<void>(export_lessons(
      {lesson("course-map"), lesson("segment-closest"), lesson("polygons-gjk")}, with_index));
  const std::string html = read(with_index.out_dir / "index.html");
  const std::size_t map = html.find("<div class=\"map\">");
  ASSERT_NE(map, std::string::npos);
  const std::string links = html.substr(map, html.find("</div>", map) - map);
  // Chapters 1 and 4 have lessons here.
  EXPECT_NE(links.find("<a href=\"#segment-closest\" aria-label=\"Chapter 1\""), std::string::npos);
  EXPECT_NE(links.find("<a href=\"#polygons-gjk\" aria-label=\"Chapter 4\""), std::string::npos);
  EXPECT_EQ(links.find("Chapter 2"), std::string::npos) << "no lesson of it was exported";
}

TEST_F(Export, BelowStagesStandsACaptionWhereItIsAskedFor) {
  ExportOptions slide = options();
  slide.format = Format::svg;
  slide.stage_only = true;
  slide.last_step = 3;
  const auto written = [&](CaptionPlace place) {
    slide.caption = place;
    static_cast<void>(export_lessons({lesson("polygons-gjk")}, slide));
    return read(slide.out_dir / "polygons-gjk-0003.svg");
  };
  const std::string bare = written(CaptionPlace::none);
  EXPECT_EQ(bare.find("data-mark=\"caption\""), std::string::npos);
  EXPECT_NE(bare.find("height=\"719\" rx=\"9.5\""), std::string::npos) << "from edge to edge";
  const std::string text = written(CaptionPlace::below);
  EXPECT_NE(text.find("data-mark=\"caption\""), std::string::npos);
  EXPECT_EQ(text.find("data-mark=\"title\""), std::string::npos);
  EXPECT_EQ(text.find("height=\"719\" rx=\"9.5\""), std::string::npos) << "there is a strip";
}

TEST(ContactSheet, WordsAreText) {
  ExportedLesson lesson;
  lesson.id = "a";
  lesson.title = "<script>alert('1')</script> & \"quotes\"";
  lesson.frames = {{1, "a-0001.png", {}}};
  lesson.frames.front().text.caption = "u < v \"and\" <b>";
  const std::string html = contact_sheet({lesson}, "<!-- contents --><!-- lessons -->");
  EXPECT_EQ(html.find("<script>"), std::string::npos);
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt; &amp; &quot;quotes&quot;"),
            std::string::npos);
  EXPECT_NE(html.find("alt=\"u &lt; v &quot;and&quot; &lt;b&gt;\""), std::string::npos);
}

TEST(ExportResult, SummaryIsJson) {
  ExportResult result;
  result.files = {"out/a-0001.png", "out/a.json"};
  result.frames = 1;
  result.seconds = 0.5;
  const auto json = nlohmann::json::parse(to_json(result));
  EXPECT_EQ(json["frames"], 1);
  EXPECT_EQ(json["frames_per_second"], 2.0);
  EXPECT_EQ(json["files"].size(), 2u);
}

}  // namespace export_test
}  // namespace gjkscope
