// Exported files as other programs read them. Each of these is in scripts/packages.txt.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "export/export.hpp"
#include "lesson/load.hpp"
#include "subjects/subjects.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace readers_test {

namespace fs = std::filesystem;

const fs::path kSource = GJKSCOPE_SOURCE_DIR;

/// The output of a command; fails when the command does.
std::string said(const std::string& command) {
  std::FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::string out;
  std::array<char, 4096> buffer = {};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    out.append(buffer.data(), count);
  EXPECT_EQ(::pclose(pipe), 0) << command << "\n" << out;
  return out;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Readers : public ::testing::Test {
 protected:
  std::string exported(Format format, int handout = 0) {
    LoadedLesson loaded = load_lesson(kSource / "lessons" / "segment-closest.toml", vocabulary());
    ExportOptions options;
    options.out_dir = temporary_.path();
    options.assets_dir = kSource / "assets";
    options.format = format;
    options.width = 640;
    options.height = 360;
    options.handout = handout;
    options.seconds = 0.2;
    const ExportResult result = export_lessons({*loaded.lesson}, options);
    frames_ = result.frames;
    return fmt::format("'{}'", result.files.front().string());
  }
  test::TemporaryFolder temporary_;
  int frames_ = 0;
};

TEST_F(Readers, Pngcheck) {
  const std::string printed = said("pngcheck -t " + exported(Format::png));
  EXPECT_TRUE(has(printed, "OK: ")) << printed;
  EXPECT_TRUE(has(printed, "Made by gjkscope")) << printed;
}

TEST_F(Readers, RsvgConvert) {
  const std::string svg = exported(Format::svg);
  const std::string png = fmt::format("'{}'", (temporary_.path() / "of.png").string());
  said("rsvg-convert " + svg + " -o " + png);
  EXPECT_TRUE(has(said("pngcheck " + png), "OK: "));
}

TEST_F(Readers, Poppler) {
  const std::string pdf = exported(Format::pdf);
  const std::string printed = said("pdfinfo " + pdf);
  EXPECT_TRUE(has(printed, fmt::format("Pages:           {}", frames_))) << printed;
  EXPECT_TRUE(has(printed, "Tagged:          yes")) << printed;
  const std::string structure = said("pdfinfo -struct " + pdf);
  EXPECT_EQ(std::count(structure.begin(), structure.end(), '\n'), frames_ + 1) << structure;
  EXPECT_TRUE(has(said("pdftotext -f 1 -l 1 " + pdf + " -"), "Point to segment: the algorithm"));
  const std::string fonts = said("pdffonts " + pdf);
  EXPECT_TRUE(has(fonts, "+Inter-")) << fonts;
  EXPECT_FALSE(has(fonts, " no ")) << "all embedded, all subsets, all with Unicode\n" << fonts;
}

TEST_F(Readers, PopplerOnAHandout) {
  const std::string pdf = exported(Format::pdf, 4);
  EXPECT_TRUE(has(said("pdfinfo " + pdf), fmt::format("Pages:           {}", (frames_ + 3) / 4)));
  EXPECT_TRUE(has(said("pdfinfo -struct " + pdf), "  Caption\n"));
}

TEST_F(Readers, PopplerFindsABookmarkForEachStep) {
  for (const int a_page : {1, 4}) {
    const std::string pdf = exported(Format::pdf, a_page == 1 ? 0 : a_page);
    const std::string printed = said("pdftohtml -q -i -xml -stdout " + pdf);
    for (int step = 1; step <= frames_; ++step) {
      const int page = (step - 1) / a_page + 1;
      EXPECT_TRUE(has(printed, fmt::format("<item page=\"{}\">{}. ", page, step))) << printed;
    }
  }
}

TEST_F(Readers, Gifsicle) {
  const std::string printed = said("gifsicle --info " + exported(Format::gif));
  EXPECT_TRUE(has(printed, "logical screen 640x360")) << printed;
  EXPECT_TRUE(has(printed, "loop forever")) << printed;
  EXPECT_TRUE(has(printed, "delay 0.40s")) << "the last is held\n" << printed;
}

TEST_F(Readers, Ffprobe) {
  for (const Format format : {Format::apng, Format::mp4, Format::webm}) {
    const std::string printed = said(
        "ffprobe -v error -count_frames -show_entries "
        "stream=codec_name,width,height,nb_read_frames -of csv " +
        exported(format));
    EXPECT_TRUE(has(printed, "640,360")) << printed;
    // A fifth of a second each, at 25 images a second, and the last twice.
    if (format == Format::apng) continue;
    EXPECT_TRUE(has(printed, std::to_string(5 * (frames_ + 1)))) << printed;
  }
}

}  // namespace readers_test
}  // namespace gjkscope
