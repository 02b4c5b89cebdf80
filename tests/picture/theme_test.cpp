#include "picture/theme.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "temporary_folder.hpp"

namespace gjkscope {
namespace theme_test {

const std::filesystem::path kThemes =
    std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets" / "themes";

constexpr const char* kTextRoles[] = {"title",
                                      "prose",
                                      "position",
                                      "view-title",
                                      "caption",
                                      "caption.question",
                                      "detail",
                                      "heading",
                                      "body",
                                      "body.muted",
                                      "strong",
                                      "code",
                                      "code.current",
                                      "code.muted",
                                      "code.value",
                                      "pass",
                                      "fail",
                                      "untried",
                                      "shape.x.label",
                                      "shape.y.label",
                                      "query.label",
                                      "origin.label",
                                      "region.label",
                                      "simplex.label",
                                      "closest.label",
                                      "support.label",
                                      "hull.label",
                                      "direction.label",
                                      "cloud.label",
                                      "timeline.label",
                                      "timeline.label.current",
                                      "area.label",
                                      "dropped.label",
                                      "history.label",
                                      "projection.label",
                                      "unit-vector.label",
                                      "beam.label",
                                      "beam.missing.label",
                                      "wrong.label",
                                      "plot.band.label",
                                      "plot.first.label",
                                      "plot.second.label",
                                      "plot.third.label",
                                      "plot.fourth.label"};

constexpr const char* kOtherRoles[] = {"background",
                                       "card",
                                       "card.rule",
                                       "highlight",
                                       "shape.x",
                                       "shape.x.vertex",
                                       "shape.y",
                                       "shape.y.vertex",
                                       "query",
                                       "origin",
                                       "region.vertex",
                                       "region.edge",
                                       "region.interior",
                                       "region.active",
                                       "region.border",
                                       "simplex.edge",
                                       "simplex.fill",
                                       "simplex.vertex",
                                       "closest",
                                       "closest.line",
                                       "outline.line",
                                       "support",
                                       "support.plane",
                                       "support.best",
                                       "direction",
                                       "cloud.point",
                                       "cloud.current",
                                       "hull",
                                       "area.u",
                                       "history.simplex",
                                       "history.closest",
                                       "area.v",
                                       "area.w",
                                       "area.negative",
                                       "projection.axis",
                                       "projection.line",
                                       "projection.angle",
                                       "projection.point",
                                       "unit-vector",
                                       "beam",
                                       "beam.guide",
                                       "beam.ground",
                                       "beam.support",
                                       "beam.extension",
                                       "beam.mass.u",
                                       "beam.mass.v",
                                       "beam.missing",
                                       "sign.none",
                                       "sign.one",
                                       "sign.two",
                                       "sign.border",
                                       "map.difference",
                                       "wrong",
                                       "wrong.line",
                                       "wrong.error",
                                       "wrong.area",
                                       "path",
                                       "path.point",
                                       "dropped",
                                       "weight.track",
                                       "weight.bar",
                                       "weight.negative",
                                       "weight.axis",
                                       "bounds.track",
                                       "bounds.bar",
                                       "timeline.done",
                                       "timeline.ahead",
                                       "timeline.hidden.frame",
                                       "timeline.current",
                                       "slab",
                                       "chart.grid",
                                       "plot.axis",
                                       "plot.band",
                                       "plot.current",
                                       "plot.first",
                                       "plot.first.line",
                                       "plot.second",
                                       "plot.second.line",
                                       "plot.third",
                                       "plot.third.line",
                                       "plot.fourth",
                                       "plot.fourth.line"};

/// Relative luminance, WCAG 2.1.
double luminance(const Color& color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

double contrast(const Color& a, const Color& b) {
  const double light = std::max(luminance(a), luminance(b));
  const double dark = std::min(luminance(a), luminance(b));
  return (light + 0.05) / (dark + 0.05);
}

Color over(const Color& top, const Color& bottom) {
  const auto mix = [&](std::uint8_t t, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround((t * top.a + b * (255 - top.a)) / 255.0));
  };
  return {mix(top.r, bottom.r), mix(top.g, bottom.g), mix(top.b, bottom.b), 255};
}

/// A folder with one theme of the given text.
class ThemeFile : public ::testing::Test {
 protected:
  std::string error_of(const std::string& text) {
    const test::TemporaryFolder folder;
    static_cast<void>(folder.file("mine.toml", text));
    try {
      static_cast<void>(Theme::load(folder.path(), "mine"));
      return "no error";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }
  void expect_error(const std::string& text, const std::string& place, const std::string& what) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find("mine.toml:" + place + ": "), std::string::npos) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
  }
};

TEST(Theme, FourThemesAreShipped) {
  EXPECT_EQ(Theme::names(kThemes),
            (std::vector<std::string>{"dark", "high-contrast", "light", "print"}));
}

TEST(Theme, EveryThemeHasEveryRole) {
  for (const std::string& name : Theme::names(kThemes)) {
    const Theme theme = Theme::load(kThemes, name);
    for (const char* role : kTextRoles) {
      ASSERT_NO_THROW(static_cast<void>(theme.style(role))) << name << ": " << role;
      EXPECT_TRUE(theme.style(role).fill) << name << ": " << role << " is text without a colour";
    }
    for (const char* role : kOtherRoles) {
      EXPECT_NO_THROW(static_cast<void>(theme.style(role))) << name << ": " << role;
    }
  }
}

TEST(Theme, TextStandsOutFromPaperAndCards) {
  constexpr double kReadable = 4.5;  // WCAG 2.1, success criterion 1.4.3
  for (const std::string& name : Theme::names(kThemes)) {
    const Theme theme = Theme::load(kThemes, name);
    const Color card = *theme.style("card").fill;
    for (const char* role : kTextRoles) {
      const Color ink = *theme.style(role).fill;
      EXPECT_GE(contrast(ink, theme.background()), kReadable) << name << ": " << role;
      EXPECT_GE(contrast(ink, card), kReadable) << name << ": " << role;
    }
    if (const auto marked = theme.style("highlight").fill) {
      EXPECT_GE(contrast(*theme.style("code.current").fill, *marked), kReadable) << name;
    }
  }
}

TEST(Theme, PartsOfTheTimelineStandOutFromPaper) {
  constexpr double kSeen = 3.0;  // WCAG 2.1, success criterion 1.4.11
  for (const std::string& name : Theme::names(kThemes)) {
    const Theme theme = Theme::load(kThemes, name);
    for (const char* role : {"timeline.done", "timeline.current"})
      EXPECT_GE(contrast(*theme.style(role).fill, theme.background()), kSeen) << name << role;
    for (const char* role : {"timeline.ahead", "timeline.hidden.frame"}) {
      ASSERT_TRUE(theme.style(role).stroke) << name << role;
      EXPECT_GE(contrast(*theme.style(role).stroke, theme.background()), kSeen) << name << role;
    }
  }
}

TEST(Theme, LabelsOfRegionsAreReadableOnTheirRegions) {
  for (const std::string& name : Theme::names(kThemes)) {
    const Theme theme = Theme::load(kThemes, name);
    const Color card = *theme.style("card").fill;
    for (const char* role :
         {"region.vertex", "region.edge", "region.interior", "region.rejected", "region.testing"}) {
      const auto fill = theme.style(role).fill;
      if (!fill) continue;
      const Color ground = over(*fill, card);
      EXPECT_GE(contrast(*theme.style("region.label").fill, ground), 4.5) << name << ": " << role;
    }
  }
}

TEST(Theme, TheTwoShapesDifferInDashWhereColourMayBeLost) {
  for (const char* name : {"print", "high-contrast"}) {
    const Theme theme = Theme::load(kThemes, name);
    EXPECT_NE(theme.style("shape.x").dash, theme.style("shape.y").dash) << name;
  }
}

TEST(Theme, DenseLinesAreThinPaleAndSolid) {
  for (const std::string& name : Theme::names(kThemes)) {
    const Theme theme = Theme::load(kThemes, name);
    const Color card = *theme.style("card").fill;
    for (const std::string role : {"shape", "shape.x", "shape.y"}) {
      const Style& dense = theme.style(role + ".dense");
      EXPECT_LT(dense.width, theme.style(role).width) << name << ": " << role;
      EXPECT_LT(contrast(*dense.stroke, card), contrast(*theme.style(role).stroke, card))
          << name << ": " << role;
      EXPECT_GT(contrast(*dense.stroke, card), 1.5) << name << ": " << role;
      EXPECT_TRUE(dense.dash.empty()) << name << ": " << role;
    }
  }
}

TEST(Theme, PrintFillsNoAreas) {
  const Theme theme = Theme::load(kThemes, "print");
  for (const char* role : {"shape.x", "shape.y", "region.vertex", "region.edge", "region.interior",
                           "region.active", "simplex.fill", "hull", "area.u", "area.v", "area.w"}) {
    EXPECT_FALSE(theme.style(role).fill) << role;
  }
}

TEST(Theme, ARoleLooksLikeItsNearestAncestor) {
  const Theme theme = Theme::load(kThemes, "light");
  EXPECT_EQ(&theme.style("simplex.vertex.first.of.all"), &theme.style("simplex.vertex"));
  EXPECT_THROW(static_cast<void>(theme.style("nothing.like.it")), std::out_of_range);
}

TEST(Theme, AnUnknownThemeIsToldTheNamesThereAre) {
  try {
    static_cast<void>(Theme::load(kThemes, "sepia"));
    FAIL() << "there is no theme sepia";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("dark, high-contrast, light, print"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(ThemeFile, AWellFormedOneLoads) {
  EXPECT_EQ(
      error_of("[palette]\nink = \"#102030\"\n[roles]\n\"background\" = { fill = \"#FFFFFF80\" }\n"
               "\"a.b\" = { stroke = \"ink\", width = 2, dash = [0, 4] }\n"),
      "no error");
}

TEST_F(ThemeFile, MistakesAreLocated) {
  const std::string head = "[roles]\n\"background\" = { fill = \"#FFFFFF\" }\n";
  expect_error("[colours]\n", "1:2", "unknown key \"colours\"");
  expect_error(head + "\"a\" = { colour = \"#FFFFFF\" }\n", "3:9", "unknown key \"colour\"");
  expect_error(head + "\"a\" = { fill = \"pink\" }\n", "3:16", "no colour \"pink\"");
  expect_error(head + "\"a\" = { fill = \"#12345\" }\n", "3:16", "#rrggbb");
  expect_error(head + "\"a\" = { fill = \"#12345G\" }\n", "3:16", "#rrggbb");
  expect_error(head + "\"a\" = { fill = 3 }\n", "3:16", "expected a colour");
  expect_error(head + "\"a\" = { width = -1 }\n", "3:17", "expected a length");
  expect_error(head + "\"a\" = { dash = [3] }\n", "3:16", "even number");
  expect_error(head + "\"a\" = { dash = [3, 0] }\n", "3:20", "above 0");
  expect_error(head + "\"a\" = 7\n", "3:7", "expected a role's style");
  expect_error(head + "\"a\" = { fill = \n", "3:16", "expected value");
  expect_error("base = \"mine\"\n" + head, "1:8", "another theme");
  expect_error("[roles]\n", "1:1", "background");
}

TEST(Theme, IsReadFromTextsAsFromFiles) {
  const ThemeTexts texts = [](std::string_view name) -> std::optional<std::string> {
    if (name == "paper") return "[roles]\nbackground = { fill = \"#010203\" }\nink = { width = 3 }";
    if (name == "night") return "base = \"paper\"\n[roles]\nink = { width = 4 }";
    if (name == "lost") return "base = \"nowhere\"";
    if (name == "odd") return "[roles]\nbackground = { fill = \"blue\" }";
    return std::nullopt;
  };
  EXPECT_EQ(Theme::read(texts, "night").background().b, 3);
  EXPECT_EQ(Theme::read(texts, "night").style("ink.label").width, 4.0);
  const auto complaint = [&](std::string_view name) {
    try {
      (void)Theme::read(texts, name);
      return std::string("none");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(complaint("day"), "no theme \"day\"");
  EXPECT_EQ(complaint("lost"), "lost.toml:1:8: expected the name of another theme");
  EXPECT_EQ(complaint("odd").rfind("odd.toml:2:23: no colour \"blue\"", 0), 0u) << complaint("odd");
}

}  // namespace theme_test
}  // namespace gjkscope
