#include "picture/type.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "temporary_folder.hpp"

namespace gjkscope {
namespace type_test {

const std::filesystem::path kAssets = std::filesystem::path(GJKSCOPE_SOURCE_DIR) / "assets";
constexpr Face kFaces[] = {Face::regular, Face::medium, Face::semibold,
                           Face::bold,    Face::mono,   Face::mono_bold};

const Fonts& fonts() {
  static const Fonts all(kAssets / "fonts.toml");
  return all;
}

/// The error that a configuration leads to.
std::string error_of(const std::string& name, const std::string& text) {
  const test::TemporaryFolder folder;
  try {
    const Fonts loaded(folder.file(name, text));
    return "no error";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Fonts, EveryFaceHasEveryCharacter) {
  for (const Face face : kFaces) {
    for (const char32_t c : Fonts::characters()) {
      EXPECT_FALSE(fonts().lacks(face, c)) << "face " << static_cast<int>(face) << " lacks U+"
                                           << std::hex << static_cast<std::uint32_t>(c);
    }
  }
}

TEST(Fonts, CharactersAscendAndHoldWhatLessonsWrite) {
  const auto& all = Fonts::characters();
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LT(all[i - 1], all[i]);
  EXPECT_EQ(Fonts::first_missing("‖P − Q‖² ≤ ε·Δ, u₁ + v₂ = 1 … “x” → y ↔ z, ✓ ✗ • ▸ ∈ ∞ √Σ ≈ ≠ ≥ "
                                 "← ↑ ↓ – — × ° ½ Grüße, naïve, αβγδλμπ ⊥ ⊕ ⊖"),
            char32_t{0});
  EXPECT_EQ(Fonts::first_missing("a漢b"), U'漢');
}

TEST(Fonts, FiguresAreTabularInEveryFace) {
  for (const Face face : kFaces) {
    const TextStyle style{face, 100};
    for (const char* digit : {"1", "2", "3", "4", "5", "6", "7", "8", "9"}) {
      EXPECT_DOUBLE_EQ(fonts().width(style, digit), fonts().width(style, "0")) << digit;
    }
  }
}

TEST(Fonts, MonospacedFacesAreMonospacedInTheirFallbackToo) {
  for (const Face face : {Face::mono, Face::mono_bold}) {
    const TextStyle style{face, 14};
    for (const char* text : {"i", "W", "←", "‖", "₂", "⁻", "✓", "✗", "−", "∈"}) {
      EXPECT_DOUBLE_EQ(fonts().width(style, text), fonts().width(style, "0")) << text;
    }
  }
}

TEST(Fonts, WidthIsProportionalToTheEmSize) {
  const char* text = "P lies on CD, its weight is 0";
  const double one = fonts().width({Face::regular, 10}, text);
  EXPECT_GT(one, 100.0);
  EXPECT_LT(one, 200.0);
  EXPECT_NEAR(fonts().width({Face::regular, 20}, text), 2.0 * one, 1e-9);
}

TEST(Fonts, CapitalsStandAboutSevenTenthsOfAnEm) {
  for (const Face face : kFaces) {
    EXPECT_NEAR(fonts().cap_height({face, 100}), 73.0, 5.0);
  }
}

TEST(Fonts, WhatIsMissingIsAsWideAsItsReplacement) {
  const TextStyle style{Face::regular, 14};
  EXPECT_DOUBLE_EQ(fonts().width(style, "漢"), fonts().width(style, "\xEF\xBF\xBD"));
}

TEST(Fonts, AMissingFileNamesWhatWasTriedAndThePackage) {
  const std::string error = error_of("missing.toml",
                                     "[regular]\n"
                                     "files = [\"/nowhere/A.otf\", \"/nowhere/B.ttf\"]\n"
                                     "fallback = [\"/nowhere/C.ttf\"]\n"
                                     "packages = [\"fonts-somewhere\"]\n");
  EXPECT_NE(error.find("/nowhere/A.otf: there is no such file"), std::string::npos) << error;
  EXPECT_NE(error.find("/nowhere/B.ttf: there is no such file"), std::string::npos) << error;
  EXPECT_NE(error.find("apt-get install fonts-somewhere"), std::string::npos) << error;
}

TEST(Fonts, AMalformedConfigurationIsALocatedError) {
  EXPECT_NE(error_of("broken.toml", "[regular\n").find("broken.toml:1:"), std::string::npos);
  EXPECT_NE(
      error_of("shape.toml", "[regular]\npackages = [\"p\"]\nfiles = 3\n").find("shape.toml:3:"),
      std::string::npos);
}

TEST(Fonts, FromBytesMeasureAsFromFiles) {
  const Fonts loaded(faces_of(fonts()));
  for (const Face face : kFaces) {
    const TextStyle style{face, 17.0};
    EXPECT_EQ(loaded.width(style, "|P|² ≤ 0.25 ⟨A, B⟩"),
              fonts().width(style, "|P|² ≤ 0.25 ⟨A, B⟩"));
    EXPECT_EQ(loaded.cap_height(style), fonts().cap_height(style));
  }
}

TEST(Fonts, BytesThatAreNoFontNameTheirFace) {
  std::array<FaceBytes, kFaceCount> faces = faces_of(fonts());
  faces[static_cast<std::size_t>(Face::mono)].fallback = {'n', 'o'};
  try {
    const Fonts loaded(std::move(faces));
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "the face \"mono\" has no font");
  }
}

TEST(CodePoints, DecodesOneToFourBytes) {
  EXPECT_EQ(code_points("aé≤𝛼"), U"aé≤𝛼");
  EXPECT_EQ(code_points(""), U"");
}

TEST(CodePoints, EachByteThatIsNotUtf8GivesOneReplacement) {
  EXPECT_EQ(code_points("a\xFFz"), U"a\uFFFDz");
  EXPECT_EQ(code_points("\xE2\x89"), U"\uFFFD\uFFFD");            // Cut off
  EXPECT_EQ(code_points("\xC0\x80"), U"\uFFFD\uFFFD");            // Longer than needed
  EXPECT_EQ(code_points("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD");  // A surrogate
}

TEST(TypeScale, AllStylesHoldsTheNamedOnes) {
  const auto all = type::all_styles();
  for (const TextStyle& style : {type::kTitle, type::kCaption, type::kCode, type::kTickBold}) {
    EXPECT_NE(std::find(all.begin(), all.end(), style), all.end());
  }
}

}  // namespace type_test
}  // namespace gjkscope
