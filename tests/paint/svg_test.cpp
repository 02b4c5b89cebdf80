#include "paint/svg.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sample_picture.hpp"

namespace gjkscope {
namespace svg_test {

const std::filesystem::path kAssets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";

const Fonts& fonts() {
  static const Fonts all(kAssets / "fonts.toml");
  return all;
}

std::string svg_of(const Picture& picture) {
  return to_svg(picture, fonts(), Theme::load(kAssets / "themes", "light"), "a title");
}

Picture one(std::string role, decltype(Mark::shape) shape) {
  Picture picture{100, 50, {}, 0.0, {}};
  picture.marks.push_back({std::move(role), std::move(shape)});
  return picture;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(Svg, IsAsLargeAsItIsAskedToBeAndLaidOutAsItWas) {
  const std::string svg = to_svg(one("closest", Disk{{10.0, 10.0}, 2.0}), fonts(),
                                 Theme::load(kAssets / "themes", "light"), "", "", false, 1.5);
  EXPECT_NE(std::string::npos, svg.find(R"(width="150" height="75" viewBox="0 0 100 50")"))
      << svg.substr(0, 200);
}

TEST(Svg, HoldsEveryTextAndEveryShapeOfAFrame) {
  const Picture picture = sample::picture();
  const std::string svg = svg_of(picture);
  std::size_t texts = 0;
  std::size_t disks = 0;
  std::size_t boxes = 0;
  for (const Mark& mark : picture.marks) {
    texts += std::holds_alternative<Text>(mark.shape) ? 1 : 0;
    disks += std::holds_alternative<Disk>(mark.shape) ? 1 : 0;
    boxes += std::holds_alternative<Box>(mark.shape) ? 1 : 0;
  }
  EXPECT_EQ(count(svg, "<text "), texts);
  EXPECT_EQ(count(svg, "<circle "), disks);
  EXPECT_EQ(count(svg, "<rect "), boxes + picture.clips.size() + 1);
  EXPECT_EQ(count(svg, "<clipPath "), picture.clips.size());
  EXPECT_EQ(count(svg, "nan"), 0u);
  EXPECT_NE(svg.find("<title>a title</title>"), std::string::npos);
  EXPECT_EQ(svg_of(picture), svg);
}

TEST(Svg, TextsAreAsWideAsTheyWereLaidOut) {
  const Text text{{60, 20}, "a < b & c", type::kBody, Align::right};
  const double width = fonts().width(type::kBody, text.text);
  const std::string svg = svg_of(one("title", text));
  EXPECT_NE(svg.find(">a &lt; b &amp; c</text>"), std::string::npos) << svg;
  EXPECT_NE(
      svg.find(fmt::format("<text x=\"{:.2f}\" y=\"20\" textLength=\"{:.2f}\"", 60 - width, width)),
      std::string::npos)
      << svg;
}

TEST(Svg, OpenLinesAreNotFilled) {
  const Polyline line{{{1, 2}, {3, 4.125}, {5, 6}}, false};
  const std::string svg = svg_of(one("card.rule", line));
  EXPECT_NE(svg.find("d=\"M1 2L3 4.12L5 6\" fill=\"none\" stroke=\"#e7e4dc\""), std::string::npos)
      << svg;
}

TEST(Svg, ArrowsHaveAShaftOnlyWhereThereIsRoom) {
  EXPECT_EQ(count(svg_of(one("direction", Arrow{{0, 0}, {90, 0}})), "<path "), 2u);
  EXPECT_EQ(count(svg_of(one("direction", Arrow{{0, 0}, {2, 0}})), "<path "), 1u);
  EXPECT_EQ(count(svg_of(one("direction", Arrow{{1, 1}, {1, 1}})), "<path "), 0u);
}

TEST(Svg, SaysOfEachMarkWhatItIsAndWhatItStandsFor) {
  Picture picture = one("cloud.point", Disk{{10, 10}, 3});
  picture.marks.front().subject = {Subject::Kind::difference_vertex, 2, 0};
  EXPECT_NE(svg_of(picture).find("data-mark=\"cloud.point\" data-of=\"z 2 0\"/>"),
            std::string::npos);
  picture.marks.front().subject = {};
  EXPECT_NE(svg_of(picture).find("data-mark=\"cloud.point\"/>"), std::string::npos);
}

}  // namespace svg_test
}  // namespace gjkscope
