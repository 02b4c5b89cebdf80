#include "paint/canvas.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "frames/frame.hpp"
#include "lessons.hpp"
#include "paint/cut.hpp"
#include "paint/imgui_painter.hpp"
#include "sample_picture.hpp"
#include "temporary_folder.hpp"

namespace gjkscope {
namespace canvas_test {

const std::filesystem::path kAssets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";

const Fonts& fonts() {
  static const Fonts all(kAssets / "fonts.toml");
  return all;
}

constexpr Color kWhite{255, 255, 255, 255};
constexpr Color kInk{10, 20, 200, 255};
constexpr Color kFill{0, 160, 80, 255};

/// Plain styles in colours that occur nowhere else.
Theme test_theme() {
  const test::TemporaryFolder folder;
  static_cast<void>(folder.file("test.toml", R"(
[roles]
"background" = { fill = "#FFFFFF" }
"fill" = { fill = "#00A050" }
"outlined" = { fill = "#00A050", stroke = "#0A14C8", width = 4 }
"line" = { stroke = "#0A14C8", width = 4 }
"dashed" = { stroke = "#0A14C8", width = 4, dash = [10, 10] }
"dotted" = { stroke = "#0A14C8", width = 4, dash = [0, 10] }
"glass" = { stroke = "#0A14C880", width = 4 }
"hairline" = { stroke = "#0A14C8", width = 1 }
"text" = { fill = "#0A14C8" }
"nothing" = {}
)"));
  return Theme::load(folder.path(), "test");
}

constexpr int kWidth = 160;
constexpr int kHeight = 100;

CanvasOptions of_size(int width, int height, Renderer renderer = Renderer::cairo) {
  CanvasOptions options;
  options.width = width;
  options.height = height;
  options.renderer = renderer;
  return options;
}

/// By cairo, and by OpenGL.
class Painted : public ::testing::TestWithParam<Renderer> {
 protected:
  static void TearDownTestSuite() { canvases_.clear(); }
  static Canvas& canvas() {
    std::unique_ptr<Canvas>& own = canvases_[GetParam()];
    if (!own) {
      own = std::make_unique<Canvas>(fonts(), test_theme(), of_size(kWidth, kHeight, GetParam()));
    }
    return *own;
  }

  static Image paint(const std::vector<Mark>& marks, std::vector<Rect> clips = {},
                     double clip_corner = 0.0) {
    Picture picture;
    picture.width = kWidth;
    picture.height = kHeight;
    picture.clips = std::move(clips);
    picture.clip_corner = clip_corner;
    picture.marks = marks;
    return canvas().paint(picture);
  }

 private:
  static std::map<Renderer, std::unique_ptr<Canvas>> canvases_;
};
std::map<Renderer, std::unique_ptr<Canvas>> Painted::canvases_;

INSTANTIATE_TEST_SUITE_P(Renderers, Painted, ::testing::Values(Renderer::cairo, Renderer::osmesa),
                         [](const auto& renderer) {
                           return renderer.param == Renderer::cairo ? "Cairo" : "OpenGl";
                         });

Color pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.pixels[4 * (static_cast<std::size_t>(y) * image.width + x)];
  return {p[0], p[1], p[2], p[3]};
}

::testing::AssertionResult is(const Image& image, int x, int y, const Color& expected,
                              int tolerance = 2) {
  const Color got = pixel(image, x, y);
  const int difference = std::max(
      {std::abs(got.r - expected.r), std::abs(got.g - expected.g), std::abs(got.b - expected.b)});
  if (difference <= tolerance && got.a == 255) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "pixel (" << x << ", " << y << ") is " << int{got.r} << " " << int{got.g} << " "
         << int{got.b} << " " << int{got.a} << ", expected " << int{expected.r} << " "
         << int{expected.g} << " " << int{expected.b} << " within " << tolerance;
}

/// Sum of darkness: 255 for a black pixel. Tells how much of the paper a mark covers.
double ink(const Image& image, int channel, const Rect& where) {
  double sum = 0.0;
  for (int y = static_cast<int>(where.min.y()); y < where.max.y(); ++y) {
    for (int x = static_cast<int>(where.min.x()); x < where.max.x(); ++x) {
      sum += 255 - image.pixels[4 * (static_cast<std::size_t>(y) * image.width + x) + channel];
    }
  }
  return sum;
}
const Rect kAll{{0, 0}, {kWidth, kHeight}};
/// The red of kInk and kFill differs from white by that much.
constexpr double kInkRed = 245.0;
constexpr double kFillRed = 255.0;

TEST_P(Painted, AnAsymmetricImageIsTheRightWayUp) {
  const Image image = paint({{"fill", Box{{{4, 2}, {24, 12}}, 0}, -1}});
  EXPECT_EQ(image.width, kWidth);
  EXPECT_EQ(image.height, kHeight);
  EXPECT_TRUE(is(image, 5, 3, kFill));
  EXPECT_TRUE(is(image, 23, 11, kFill));
  EXPECT_TRUE(is(image, kWidth - 6, 3, kWhite));
  EXPECT_TRUE(is(image, 5, kHeight - 4, kWhite));
  EXPECT_TRUE(is(image, kWidth - 6, kHeight - 4, kWhite));
}

TEST_P(Painted, BoxOnWholePixelsIsCrisp) {
  const Image image = paint({{"outlined", Box{{{20, 20}, {60, 50}}, 0}, -1}});
  EXPECT_TRUE(is(image, 19, 35, kWhite));
  EXPECT_TRUE(is(image, 20, 35, kInk));
  EXPECT_TRUE(is(image, 23, 35, kInk));
  EXPECT_TRUE(is(image, 24, 35, kFill));
  EXPECT_TRUE(is(image, 59, 35, kInk));
  EXPECT_TRUE(is(image, 60, 35, kWhite));
  EXPECT_TRUE(is(image, 40, 20, kInk));
  EXPECT_TRUE(is(image, 40, 50, kWhite));
}

TEST_P(Painted, RoundedBoxLeavesItsCornersFree) {
  const Image image = paint({{"fill", Box{{{20, 20}, {80, 60}}, 12}, -1}});
  EXPECT_TRUE(is(image, 21, 21, kWhite));
  EXPECT_TRUE(is(image, 78, 58, kWhite));
  EXPECT_TRUE(is(image, 50, 21, kFill));
  EXPECT_TRUE(is(image, 21, 40, kFill));
}

TEST_P(Painted, PolygonOfEitherTurnIsTheSame) {
  const std::vector<Point> points = {{20, 20}, {120, 30}, {60, 90}};
  const Image one = paint({{"outlined", Polygon{points}, -1}});
  const Image other = paint({{"outlined", Polygon{{points.rbegin(), points.rend()}}, -1}});
  EXPECT_TRUE(is(one, 65, 45, kFill));
  EXPECT_TRUE(is(one, 70, 25, kInk));
  EXPECT_TRUE(is(one, 110, 70, kWhite));
  const double area = 0.5 * (100 * 70 - 40 * 10);
  EXPECT_NEAR(ink(paint({{"fill", Polygon{points}, -1}}), 0, kAll), area * kFillRed,
              0.01 * area * kFillRed);
  EXPECT_NEAR(ink(one, 0, kAll), ink(other, 0, kAll), 0.002 * ink(one, 0, kAll));
}

TEST_P(Painted, PolylineCoversItsLengthTimesItsWidthAndRoundEnds) {
  const Image image = paint({{"line", Polyline{{{20, 50}, {120, 50}}, false}, -1}});
  EXPECT_TRUE(is(image, 70, 48, kInk));
  EXPECT_TRUE(is(image, 70, 51, kInk));
  EXPECT_TRUE(is(image, 70, 47, kWhite));
  EXPECT_TRUE(is(image, 70, 52, kWhite));
  EXPECT_TRUE(is(image, 19, 50, kInk, 40));
  EXPECT_NEAR(ink(image, 0, kAll), (400 + 4 * std::acos(-1.0)) * kInkRed, 0.02 * 400 * kInkRed);
}

TEST_P(Painted, ASharpTurnHasARoundJointAndNoSpike) {
  const Image image = paint({{"line", Polyline{{{20, 40}, {120, 45}, {20, 50}}, false}, -1}});
  EXPECT_TRUE(is(image, 120, 45, kInk));
  EXPECT_TRUE(is(image, 124, 45, kWhite));
  EXPECT_EQ(ink(image, 0, {{124, 0}, {kWidth, kHeight}}), 0.0);
}

TEST_P(Painted, ClosedPolylineReturns) {
  const std::vector<Point> points = {{20, 20}, {120, 20}, {120, 80}};
  const Image open = paint({{"line", Polyline{points, false}, -1}});
  const Image closed = paint({{"line", Polyline{points, true}, -1}});
  EXPECT_TRUE(is(open, 70, 50, kWhite));
  EXPECT_TRUE(is(closed, 70, 50, kInk));
}

TEST_P(Painted, DashesComeAndGoAndRoundTheCorner) {
  const Image image = paint({{"dashed", Polyline{{{20, 30}, {120, 30}}, false}, -1}});
  for (int k = 0; k < 5; ++k) {
    EXPECT_TRUE(is(image, 25 + 20 * k, 30, kInk)) << k;
    EXPECT_TRUE(is(image, 35 + 20 * k, 30, kWhite)) << k;
  }
  const Image corner = paint({{"dashed", Polyline{{{20, 30}, {45, 30}, {45, 90}}, false}, -1}});
  EXPECT_TRUE(is(corner, 44, 31, kInk));
  EXPECT_TRUE(is(corner, 44, 34, kInk));
  EXPECT_TRUE(is(corner, 44, 40, kWhite));
}

TEST_P(Painted, ADashOfNoLengthIsADot) {
  const Image image = paint({{"dotted", Polyline{{{20, 30}, {60, 30}}, false}, -1}});
  const double dot = 4 * std::acos(-1.0) * kInkRed;
  EXPECT_NEAR(ink(image, 0, {{25, 20}, {35, 40}}), dot, 0.1 * dot);
  EXPECT_TRUE(is(image, 25, 30, kWhite));
}

TEST_P(Painted, TranslucentLinesAreEven) {
  const Image image =
      paint({{"glass", Polyline{{{20, 20}, {60, 20}, {60, 60}, {90, 60}}, false}, -1}});
  const Color half = pixel(image, 40, 20);
  EXPECT_TRUE(is(image, 60, 40, half));
  EXPECT_TRUE(is(image, 60, 20, half, 6)) << "the joint is painted once";
}

TEST_P(Painted, HairlinesAlongAnAxisAreCrispWhereverTheyLie) {
  for (const double y : {30.0, 30.25, 30.5, 30.75}) {
    const Image image = paint({{"hairline", Polyline{{{20, y}, {120, y}}, false}, -1}});
    const int row = is(image, 70, 30, kInk) ? 30 : 29 + static_cast<int>(y > 30.5) * 2;
    EXPECT_TRUE(is(image, 70, row, kInk)) << y;
    EXPECT_TRUE(is(image, 70, row - 1, kWhite)) << y;
    EXPECT_TRUE(is(image, 70, row + 1, kWhite)) << y;
  }
}

TEST_P(Painted, ArrowHeadIsTheSameWhateverTheLengthAndEndsAtItsTip) {
  const Image longer = paint({{"line", Arrow{{10, 50}, {130, 50}}, -1}});
  const Image shorter = paint({{"line", Arrow{{90, 50}, {130, 50}}, -1}});
  const Rect head{{114, 30}, {kWidth, 70}};
  EXPECT_NEAR(ink(longer, 0, head), ink(shorter, 0, head), 1.0);
  EXPECT_EQ(ink(longer, 0, {{131, 0}, {kWidth, kHeight}}), 0.0);
  EXPECT_TRUE(is(longer, 127, 50, kInk, 60));
  EXPECT_TRUE(is(longer, 60, 50, kInk));
  EXPECT_GT(ink(longer, 0, {{110, 30}, {120, 47}}), 0.0) << "the head is wider than the shaft";
}

TEST_P(Painted, AnArrowWithoutLengthIsNothing) {
  const Image image =
      paint({{"line", Arrow{{50, 50}, {50, 50}}, -1}, {"fill", Disk{{10, 10}, 4}, -1}});
  EXPECT_EQ(ink(image, 0, {{30, 30}, {70, 70}}), 0.0);
}

TEST_P(Painted, DiskHasTheAreaOfACircle) {
  for (const double radius : {2.0, 5.0, 30.0}) {
    const Image image = paint({{"fill", Disk{{60.3, 49.6}, radius}, -1}});
    const double area = std::acos(-1.0) * radius * radius * kFillRed;
    EXPECT_NEAR(ink(image, 0, kAll), area, 0.04 * area) << radius;
  }
  const Image ring = paint({{"outlined", Disk{{60, 50}, 20}, -1}});
  EXPECT_TRUE(is(ring, 60, 50, kFill));
  EXPECT_TRUE(is(ring, 80, 50, kInk));
  EXPECT_TRUE(is(ring, 60, 30, kInk));
  EXPECT_TRUE(is(ring, 83, 50, kWhite));
}

TEST_P(Painted, CrossIsUpright) {
  const Image image = paint({{"line", Cross{{60, 50}, 20}, -1}});
  EXPECT_TRUE(is(image, 45, 50, kInk));
  EXPECT_TRUE(is(image, 75, 50, kInk));
  EXPECT_TRUE(is(image, 60, 35, kInk));
  EXPECT_TRUE(is(image, 60, 65, kInk));
  EXPECT_TRUE(is(image, 50, 40, kWhite));
}

TEST_P(Painted, TextStandsOnItsBaseLine) {
  const Image image = paint({{"text", Text{{20, 60}, "HHH", type::kTitle, Align::left}, -1}});
  const double cap = fonts().cap_height(type::kTitle);
  EXPECT_EQ(ink(image, 0, {{0, 61}, {kWidth, kHeight}}), 0.0) << "nothing below the base line";
  EXPECT_GT(ink(image, 0, {{0, 58}, {kWidth, 60}}), 1000.0) << "feet on the base line";
  EXPECT_EQ(ink(image, 0, {{0, 0}, {kWidth, std::floor(60 - cap) - 1}}), 0.0);
}

TEST_P(Painted, TextIsAlignedByItsWidth) {
  const std::string word = "weights";
  const double width = fonts().width(type::kCaption, word);
  for (const auto& [align, left] : {std::pair{Align::left, 80.0},
                                    {Align::center, 80.0 - width / 2},
                                    {Align::right, 80.0 - width}}) {
    const Image image = paint({{"text", Text{{80, 50}, word, type::kCaption, align}, -1}});
    EXPECT_EQ(ink(image, 0, {{0, 0}, {std::floor(left) - 1, kHeight}}), 0.0);
    EXPECT_EQ(ink(image, 0, {{std::ceil(left + width) + 1, 0}, {kWidth, kHeight}}), 0.0);
    EXPECT_GT(ink(image, 0, {{left, 0}, {left + 12, kHeight}}), 1000.0);
    EXPECT_GT(ink(image, 0, {{left + width - 8, 0}, {left + width, kHeight}}), 1000.0);
  }
}

TEST_P(Painted, ClipCutsOff) {
  const Image image = paint({{"fill", Disk{{50, 50}, 40}, 0}}, {Rect{{30, 40}, {60, 60}}});
  EXPECT_TRUE(is(image, 31, 41, kFill));
  EXPECT_TRUE(is(image, 59, 59, kFill));
  EXPECT_EQ(ink(image, 0, {{0, 0}, {kWidth, 40}}), 0.0);
  EXPECT_EQ(ink(image, 0, {{60, 0}, {kWidth, kHeight}}), 0.0);
  EXPECT_EQ(ink(image, 0, {{0, 60}, {kWidth, kHeight}}), 0.0);
}

TEST_P(Painted, PolygonsEndAtTheRoundCornersOfTheClip) {
  const std::vector<Point> everything = {{-50, -50}, {300, -50}, {300, 300}, {-50, 300}};
  const Image image = paint({{"fill", Polygon{everything}, 0}}, {Rect{{20, 20}, {120, 80}}}, 15.0);
  EXPECT_TRUE(is(image, 21, 21, kWhite));
  EXPECT_TRUE(is(image, 118, 78, kWhite));
  EXPECT_TRUE(is(image, 70, 21, kFill));
  EXPECT_TRUE(is(image, 22, 50, kFill));
}

TEST_P(Painted, MarksAreInTheOrderOfThePicture) {
  const Image image = paint(
      {{"fill", Box{{{20, 20}, {60, 60}}, 0}, -1}, {"text", Box{{{40, 20}, {80, 60}}, 0}, -1}});
  EXPECT_TRUE(is(image, 30, 40, kFill));
  EXPECT_TRUE(is(image, 50, 40, kInk));
}

TEST_P(Painted, DegenerateMarksAreHarmless) {
  const Point p(50, 50);
  const Image image = paint({{"outlined", Polygon{{}}, -1},
                             {"outlined", Polygon{{p}}, -1},
                             {"outlined", Polygon{{p, p, p}}, -1},
                             {"outlined", Polygon{{p, {60, 50}}}, -1},
                             {"dashed", Polyline{{p, p}, true}, -1},
                             {"line", Polyline{{}, false}, -1},
                             {"fill", Disk{p, 0.0}, -1},
                             {"outlined", Box{{{60, 60}, {60, 60}}, 9}, -1},
                             {"text", Text{p, "", type::kBody, Align::right}, -1},
                             {"fill", Disk{{10, 10}, 4}, -1}});
  EXPECT_TRUE(is(image, 10, 10, kFill));
}

TEST_P(Painted, MoreMarksThanOneDrawListCanHold) {
  std::vector<Mark> marks;
  for (int i = 0; i < 6000; ++i) marks.push_back({"fill", Disk{{20, 20}, 6}, -1});
  marks.push_back({"text", Disk{{100, 60}, 6}, -1});
  const Image image = paint(marks);
  EXPECT_TRUE(is(image, 20, 20, kFill));
  EXPECT_TRUE(is(image, 100, 60, kInk));
}

TEST_P(Painted, AnEmptyImageIsAnError) {
  EXPECT_THROW(static_cast<void>(paint({{"nothing", Disk{{50, 50}, 9}, -1}})), std::runtime_error);
  EXPECT_THROW(static_cast<void>(paint({{"fill", Disk{{500, 500}, 9}, -1}})), std::runtime_error);
  EXPECT_NO_THROW(static_cast<void>(paint({})));
}

TEST_P(Painted, SamePictureSamePixels) {
  const std::vector<Mark> marks = {{"outlined", Disk{{60, 50}, 20}, -1},
                                   {"text", Text{{20, 40}, "‖P‖ ≤ 1", type::kBody}, -1}};
  EXPECT_EQ(paint(marks).pixels, paint(marks).pixels);
}

TEST_P(Painted, ImagesAreUsedAgainWithoutATrace) {
  Picture first;
  first.width = kWidth;
  first.height = kHeight;
  first.marks = {{"fill", Box{{{0, 0}, {100, 100}}, 0}, -1}};
  Picture second = first;
  second.marks = {{"text", Disk{{120, 50}, 9}, -1}};
  Image image;
  canvas().paint(first, image);
  canvas().paint(second, image);
  EXPECT_EQ(image.pixels, canvas().paint(second).pixels);
}

TEST_P(Painted, UnknownRolesAreErrors) {
  EXPECT_THROW(static_cast<void>(paint({{"no.such", Disk{{50, 50}, 9}, -1}})), std::out_of_range);
}

TEST_P(Painted, SaysWhatItCannotDo) {
  for (const auto& [width, height] : {std::pair(0, 10), std::pair(100000, 10)}) {
    EXPECT_THROW(Canvas(fonts(), test_theme(), of_size(width, height, GetParam())),
                 std::runtime_error);
  }
}

/// Cairo's numbers end at 8 million pixels.
TEST_P(Painted, WhatIsFarAwayIsCutWhereItDoesNotShow) {
  for (const double far : {1e5, 1e7, 1e12}) {
    SCOPED_TRACE(far);
    const Image half =
        paint({{"fill", Polygon{{{80, -far}, {far, -far}, {far, far}, {80, far}}}, -1},
               {"line", Polyline{{{-far, 20}, {60, 20}, {60, far}}, false}, -1}});
    EXPECT_TRUE(is(half, 79, 50, kWhite));
    EXPECT_TRUE(is(half, 81, 50, kFill));
    EXPECT_TRUE(is(half, 5, 20, kInk));
    EXPECT_TRUE(is(half, 60, 95, kInk));
    EXPECT_TRUE(is(half, 5, 50, kWhite));
    const Image dashed = paint({{"dashed", Polyline{{{20, 30}, {20 + far, 30}}, false}, -1},
                                {"line", Polyline{{{-far, far}, {far, far}}, false}, -1}});
    for (int k = 0; k < 5; ++k) {
      EXPECT_TRUE(is(dashed, 25 + 20 * k, 30, kInk)) << k;
      EXPECT_TRUE(is(dashed, 35 + 20 * k, 30, kWhite)) << k;
    }
    // A draw list has no room for larger circles.
    const double radius = std::min(far, GetParam() == Renderer::cairo ? 1e7 : 1e6);
    const Image circle = paint({{"fill", Disk{{80 + radius, 50}, radius}, -1}});
    EXPECT_TRUE(is(circle, 78, 50, kWhite));
    EXPECT_TRUE(is(circle, 82, 50, kFill));
  }
}

TEST(VisiblePart, IsNothingOfALineThatPassesByOrHasNoLength) {
  const Rect bounds{{0, 0}, {100, 50}};
  EXPECT_TRUE(visible_part({-1e9, 20}, {1e9, 20}, bounds, 0.0));
  EXPECT_FALSE(visible_part({-1e9, 900}, {1e9, 900}, bounds, 0.0));
  EXPECT_FALSE(visible_part({60, 20}, {60, 20}, bounds, 0.0));
}

TEST(Canvas, TextStylesThatNoAtlasHasAreErrorsByOpenGl) {
  Picture picture;
  picture.marks = {{"text", Text{{20, 40}, "a", TextStyle{Face::mono, 55}}, -1}};
  Canvas canvas(fonts(), test_theme(), of_size(kWidth, kHeight, Renderer::osmesa));
  EXPECT_THROW(static_cast<void>(canvas.paint(picture)), std::out_of_range);
}

TEST(Canvas, BandsOfATallImageMeetWithoutASeam) {
  constexpr int kPeriod = 8;
  constexpr int kTall = 4000;
  Picture picture;
  picture.width = 1280;
  picture.height = kTall;
  for (int y = 0; y < kTall; y += kPeriod) {
    const double top = y;
    picture.marks.push_back({"fill", Box{{{100, top + 2}, {400, top + 5}}, 0}, -1});
    picture.marks.push_back({"line", Polyline{{{500, top}, {900, top + kPeriod}}, false}, -1});
    picture.marks.push_back({"text", Text{{1000, top + 6}, "gjk", type::kDetail}, -1});
  }
  const Image image =
      Canvas(fonts(), test_theme(), of_size(1280, kTall, Renderer::osmesa)).paint(picture);
  // Coordinates round a little differently from period to period, in one band, too.
  constexpr int kRounding = 8;
  const std::ptrdiff_t length = std::ptrdiff_t{4} * image.width * kPeriod;
  const auto second = image.pixels.begin() + length;
  for (int y = 2 * kPeriod; y < kTall - kPeriod; y += kPeriod) {
    const auto period = image.pixels.begin() + length * (y / kPeriod);
    for (std::ptrdiff_t i = 0; i < length; ++i) {
      ASSERT_NEAR(period[i], second[i], kRounding) << "from row " << y;
    }
  }
}

/// A channel is off by one step of 255 at most, in one pixel of 10,000 at most.
void expect_same(const Image& a, const Image& b) {
  ASSERT_EQ(a.pixels.size(), b.pixels.size());
  std::size_t others = 0;
  int most = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const int off = std::abs(int{a.pixels[i]} - int{b.pixels[i]});
    most = std::max(most, off);
    others += off > 0 ? 1 : 0;
  }
  EXPECT_LE(most, 1);
  EXPECT_LE(others, a.pixels.size() / 4 / 10000);
}

/// Letters and edges by other rules: less than a step of 255, on the whole.
void expect_alike(const Image& a, const Image& b) {
  ASSERT_EQ(a.pixels.size(), b.pixels.size());
  double off = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    off += std::abs(int{a.pixels[i]} - int{b.pixels[i]});
  }
  EXPECT_LT(off / static_cast<double>(a.pixels.size()), 0.5);
}

TEST(Canvas, AllRenderersDrawTheSamePicture) {
  const LessonRun run = run_lesson(testing::shipped_lesson("polygons-gjk"));
  EffectGraph effects(run);
  LessonPictures pictures(run, effects, fonts());
  for (const Picture& picture : {sample::picture(), pictures.picture(6), pictures.picture(18)}) {
    CanvasOptions options = of_size(1280, 720);
    std::vector<Image> images;
    for (const bool transparent : {false, true}) {
      for (const Renderer renderer : {Renderer::osmesa, Renderer::egl, Renderer::cairo}) {
        options.renderer = renderer;
        options.transparent = transparent;
        Canvas canvas(fonts(), Theme::load(kAssets / "themes", "light"), options);
        images.push_back(canvas.paint(picture));
      }
    }
    expect_same(images[0], images[1]);
    expect_alike(images[0], images[2]);
    expect_same(images[3], images[4]);
    expect_alike(images[3], images[5]);
    EXPECT_NE(images[0].pixels, images[3].pixels) << "one is transparent";
  }
}

TEST(Canvas, OnesOfSeveralThreadsAndOfAllRenderersDoNotMindEachOther) {
  const Theme theme = Theme::load(kAssets / "themes", "light");
  const Picture picture = sample::picture();
  CanvasOptions options = of_size(640, 360);
  options.zoom = 0.5;
  constexpr std::array kRenderers = {Renderer::cairo, Renderer::osmesa, Renderer::egl};
  std::array<Image, 3> expected;
  for (std::size_t i = 0; i < kRenderers.size(); ++i) {
    options.renderer = kRenderers[i];
    expected[i] = Canvas(fonts(), theme, options).paint(picture);
  }
  std::vector<std::thread> threads;
  std::array<int, 6> others = {};
  for (std::size_t i = 0; i < others.size(); ++i) {
    threads.emplace_back([&, i, mine = options]() mutable {
      mine.renderer = kRenderers[i % 3];
      for (int k = 0; k < 3; ++k) {
        Canvas canvas(fonts(), theme, mine);
        for (int n = 0; n < 3; ++n) {
          others[i] += canvas.paint(picture).pixels != expected[i % 3].pixels;
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(others, (std::array<int, 6>{}));
}

TEST(Renderer, HasAName) {
  EXPECT_EQ(renderer_of("cairo"), Renderer::cairo);
  EXPECT_EQ(renderer_of("egl"), Renderer::egl);
  EXPECT_EQ(renderer_of("osmesa"), Renderer::osmesa);
  EXPECT_FALSE(renderer_of("vulkan"));
}

TEST(Canvas, AFrameInEveryTheme) {
  const Picture picture = sample::picture();
  for (const std::string& name : Theme::names(kAssets / "themes")) {
    Canvas canvas(fonts(), Theme::load(kAssets / "themes", name), of_size(1280, 720));
    const Image image = canvas.paint(picture);
    EXPECT_EQ(image.pixels.size(), 4u * 1280u * 720u) << name;
  }
}

TEST(AtlasFonts, WidthsAreThoseOfTheFontFiles) {
  ImGuiContext* const context = ImGui::CreateContext();
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  constexpr double kScale = 2.0;
  const AtlasFonts in_atlas(atlas, fonts(), kScale);
  ASSERT_TRUE(atlas.Build());
  for (const TextStyle& style : type::all_styles()) {
    for (const std::string text :
         {"K − C lies farthest towards O", "0.1234567890", "‖P‖² ≤ ε · Δ₁₂ → ∞ ✓ ✗ ▸ ⊖"}) {
      const auto& [font, density] = in_atlas.font(style);
      const double drawn =
          density * font->CalcTextSizeA(font->FontSize, 1e9f, 0.0f, text.c_str()).x / kScale;
      const double width = fonts().width(style, text);
      EXPECT_NEAR(drawn, width, 0.01 * width) << text << " at size " << style.size;
    }
    for (const char32_t c : Fonts::characters()) {
      EXPECT_NE(in_atlas.font(style).font->FindGlyphNoFallback(static_cast<ImWchar>(c)), nullptr)
          << std::hex << static_cast<std::uint32_t>(c);
    }
  }
  ImGui::DestroyContext(context);
}

Image shrink(const Image& large, int factor) {
  Image small{large.width / factor, large.height / factor, {}};
  small.pixels.resize(std::size_t{4} * static_cast<std::size_t>(small.width * small.height));
  shrink_into(small, 0, large, factor);
  return small;
}

TEST(Shrink, AveragesSquaresAndRoundsToNearest) {
  const Image two{2, 2, {0, 10, 255, 255, 1, 10, 255, 255, 0, 11, 255, 255, 0, 11, 254, 255}};
  const Image one = shrink(two, 2);
  EXPECT_EQ(one.width, 1);
  EXPECT_EQ(one.height, 1);
  EXPECT_EQ(one.pixels, (std::vector<std::uint8_t>{0, 11, 255, 255}));

  Image nine{3, 3, std::vector<std::uint8_t>(36, 0)};
  for (int i = 0; i < 9; ++i) nine.pixels[4 * i] = static_cast<std::uint8_t>(10 * i);
  nine.pixels[4 * 8] = 84;
  EXPECT_EQ(shrink(nine, 3).pixels, (std::vector<std::uint8_t>{40, 0, 0, 0}));

  EXPECT_EQ(shrink(two, 1).pixels, two.pixels);
}

TEST(Shrink, KeepsPlaces) {
  Image large{64, 32, std::vector<std::uint8_t>(64 * 32 * 4, 0)};
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 64; ++x) {
      large.pixels[4 * (64 * y + x)] = static_cast<std::uint8_t>(x / 4);
      large.pixels[4 * (64 * y + x) + 1] = static_cast<std::uint8_t>(y / 4);
    }
  }
  for (const int factor : {2, 4}) {
    const Image small = shrink(large, factor);
    for (int y = 0; y < small.height; ++y) {
      for (int x = 0; x < small.width; ++x) {
        EXPECT_EQ(small.pixels[4 * (small.width * y + x)], x * factor / 4);
        EXPECT_EQ(small.pixels[4 * (small.width * y + x) + 1], y * factor / 4);
      }
    }
  }
}

}  // namespace canvas_test
}  // namespace gjkscope
