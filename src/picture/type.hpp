#pragma once
// Type: which faces and sizes there are, and how wide a text will be. No GL; widths come from the
// font files.

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gjkscope {

enum class Face { regular, medium, semibold, bold, mono, mono_bold };
inline constexpr int kFaceCount = 6;

struct TextStyle {
  Face face = Face::regular;
  double size = 16.0;  ///< Em size in frame pixels.
  friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

/// The type scale of a frame. Nothing is smaller than 16 pixels: the last row reads it, too.
namespace type {
inline constexpr TextStyle kTitle{Face::bold, 24};
inline constexpr TextStyle kProse{Face::regular, 16};
inline constexpr TextStyle kPosition{Face::medium, 16};
inline constexpr TextStyle kViewTitle{Face::semibold, 16};
inline constexpr TextStyle kVertex{Face::semibold, 17};
inline constexpr TextStyle kSmallVertex{Face::semibold, 16};
inline constexpr TextStyle kRegion{Face::semibold, 16};
inline constexpr TextStyle kCaption{Face::medium, 20};
inline constexpr TextStyle kDetail{Face::regular, 19};
inline constexpr TextStyle kHeading{Face::semibold, 16};
inline constexpr TextStyle kBody{Face::regular, 16};
inline constexpr TextStyle kStrong{Face::semibold, 16};
inline constexpr TextStyle kCode{Face::mono, 16};
inline constexpr TextStyle kCodeBold{Face::mono_bold, 16};
inline constexpr TextStyle kText{Face::regular, 16};
inline constexpr TextStyle kName{Face::semibold, 16};
inline constexpr TextStyle kNumber{Face::mono, 16};
inline constexpr TextStyle kTick{Face::regular, 16};
inline constexpr TextStyle kTickBold{Face::semibold, 16};
/// Every style above: what a painter prepares.
[[nodiscard]] std::vector<TextStyle> all_styles();
}  // namespace type

[[nodiscard]] constexpr bool is_monospaced(Face face) {
  return face == Face::mono || face == Face::mono_bold;
}

/// The characters of a text. What is not UTF-8 gives U+FFFD, one for each byte.
[[nodiscard]] std::u32string code_points(std::string_view utf8);
/// A character as UTF-8.
[[nodiscard]] std::string utf8_of(char32_t character);

/// The bytes of a face's font file, and of the one that draws what the first lacks.
struct FaceBytes {
  std::vector<unsigned char> main;
  std::vector<unsigned char> fallback;
};

/// The font files of the six faces.
class Fonts {
 public:
  /// In the order of Face. Throws std::runtime_error naming the face whose bytes are no font.
  explicit Fonts(std::array<FaceBytes, kFaceCount> files);
  /// Reads `config` (assets/fonts.toml). Throws std::runtime_error naming the missing file and the
  /// Debian package that has it.
  explicit Fonts(const std::filesystem::path& config);
  ~Fonts();
  Fonts(const Fonts&) = delete;
  Fonts& operator=(const Fonts&) = delete;

  /// Width in frame pixels, kerning left out (painters leave it out, too). Figures are tabular:
  /// each is as wide as the widest, in every face.
  [[nodiscard]] double width(const TextStyle& style, std::string_view utf8) const;
  /// The width of one character.
  [[nodiscard]] double advance(const TextStyle& style, char32_t character) const;
  /// Height of a capital letter above the base line.
  [[nodiscard]] double cap_height(const TextStyle& style) const;

  /// The characters that every face can draw, in ascending order: those that a painter prepares. A
  /// test checks each face.
  [[nodiscard]] static const std::vector<char32_t>& characters();
  /// The first character of a text that is not among them, or 0.
  [[nodiscard]] static char32_t first_missing(std::string_view utf8);

  /// The bytes of a face's font file, and of the one that draws what the first lacks.
  [[nodiscard]] const std::vector<unsigned char>& file(Face face) const;
  [[nodiscard]] const std::vector<unsigned char>& fallback_file(Face face) const;
  /// From ascent to descent, in ems: the unit in which Dear ImGui wants the size of a font.
  [[nodiscard]] double height_in_em(Face face) const;
  [[nodiscard]] double fallback_height_in_em(Face face) const;
  /// Width of every figure, and in the two monospaced faces of every character, in ems.
  [[nodiscard]] double digit_width_in_em(Face face) const;
  /// Whether neither the face nor its fallback has a glyph for `character`.
  [[nodiscard]] bool lacks(Face face, char32_t character) const;

 private:
  struct Loaded;
  std::unique_ptr<Loaded> loaded_;
};

/// The bytes of all faces, in the order of Face.
[[nodiscard]] std::array<FaceBytes, kFaceCount> faces_of(const Fonts& fonts);

}  // namespace gjkscope
