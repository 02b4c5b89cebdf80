#include "picture/type.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include "base/file.hpp"

namespace gjkscope {
namespace {

constexpr std::array<const char*, kFaceCount> kFaceNames = {"regular", "medium", "semibold",
                                                            "bold",    "mono",   "mono_bold"};
constexpr char32_t kReplacement = 0xFFFD;

struct CharacterRange {
  char32_t first;
  char32_t last;
};

// Characters for lessons on distances, areas and bounds, in ascending order.
constexpr CharacterRange kCharacterRanges[] = {
    {0x0020, 0x007E},  // ASCII
    {0x00A0, 0x00FF},  // Latin-1
    {0x0391, 0x03A1},  // Greek capitals; there is no U+03A2
    {0x03A3, 0x03A9},  //
    {0x03B1, 0x03C9},  // Greek small letters
    {0x2010, 0x2016},  // Hyphens, dashes, the bars of a norm
    {0x2018, 0x201A},  // Quotation marks
    {0x201C, 0x201E},  //
    {0x2020, 0x2022},  // Daggers, bullet
    {0x2026, 0x2026},  // Ellipsis
    {0x2032, 0x2033},  // Primes
    {0x2070, 0x2071},  // Superscripts; ¹ ² ³ are Latin-1
    {0x2074, 0x208E},  // Superscripts and subscripts
    {0x2190, 0x2195},  // Arrows
    {0x21BA, 0x21BA},  // Back to the start
    {0x21D0, 0x21D4},  // Double arrows
    {0x2200, 0x2200},  // ∀
    {0x2202, 0x2203},  // ∂ ∃
    {0x2205, 0x2209},  // ∅ ∆ ∇ ∈ ∉
    {0x220F, 0x220F},  // ∏
    {0x2211, 0x2213},  // ∑ − ∓
    {0x2217, 0x221A},  // ∗ ∘ ∙ √
    {0x221D, 0x221E},  // ∝ ∞
    {0x2220, 0x2220},  // ∠
    {0x2227, 0x222A},  // ∧ ∨ ∩ ∪
    {0x2248, 0x2248},  // ≈
    {0x2260, 0x2261},  // ≠ ≡
    {0x2264, 0x2265},  // ≤ ≥
    {0x2282, 0x2282},  // ⊂
    {0x2286, 0x2286},  // ⊆
    {0x2295, 0x2296},  // ⊕ ⊖, Minkowski sum and difference
    {0x22A5, 0x22A5},  // ⊥
    {0x22C5, 0x22C5},  // ⋅
    {0x2308, 0x230B},  // Ceiling and floor
    {0x25A0, 0x25A1},  // ■ □
    {0x25B2, 0x25B3},  // ▲ △
    {0x25B6, 0x25B6},  // ▶
    {0x25B8, 0x25B8},  // ▸
    {0x25BC, 0x25BC},  // ▼
    {0x25C0, 0x25C0},  // ◀
    {0x25C6, 0x25C7},  // ◆ ◇
    {0x25CB, 0x25CB},  // ○
    {0x25CF, 0x25CF},  // ●
    {0x2605, 0x2605},  // ★
    {0x2713, 0x2713},  // ✓
    {0x2715, 0x2715},  // ✕
    {0x2717, 0x2717},  // ✗
    {0x27E8, 0x27E9},  // ⟨ ⟩
    {0xFFFD, 0xFFFD},  // In place of what is missing
};

std::runtime_error problem(const toml::source_region& source, std::string_view what) {
  return std::runtime_error(fmt::format("{}:{}:{}: {}", source.path ? *source.path : "fonts",
                                        source.begin.line, source.begin.column, what));
}

std::vector<std::string> string_list(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  const toml::array* array = node ? node->as_array() : nullptr;
  if (!array || array->empty()) {
    throw problem((node ? *node : table).source(),
                  fmt::format(R"(expected {} = ["..."], a list of at least one string)", key));
  }
  std::vector<std::string> list;
  for (const toml::node& element : *array) {
    const auto text = element.value<std::string>();
    if (!text) throw problem(element.source(), "expected a string");
    list.push_back(*text);
  }
  return list;
}

/// One font file, parsed.
struct FontFile {
  std::vector<unsigned char> bytes;
  stbtt_fontinfo info = {};
  double em = 1.0;      // Font units of an em.
  double height = 1.0;  // Ascent minus descent, in ems.

  [[nodiscard]] int glyph(char32_t character) const {
    return stbtt_FindGlyphIndex(&info, static_cast<int>(character));
  }
  [[nodiscard]] double advance(int glyph_index) const {
    int units = 0;
    stbtt_GetGlyphHMetrics(&info, glyph_index, &units, nullptr);
    return units / em;
  }
  [[nodiscard]] double top(int glyph_index) const {
    int left = 0, bottom = 0, right = 0, top = 0;
    stbtt_GetGlyphBox(&info, glyph_index, &left, &bottom, &right, &top);
    return top / em;
  }
};

/// Nothing when the bytes are no font.
std::optional<FontFile> parse(std::vector<unsigned char> bytes) {
  FontFile file;
  file.bytes = std::move(bytes);
  const int offset = file.bytes.empty() ? -1 : stbtt_GetFontOffsetForIndex(file.bytes.data(), 0);
  if (offset < 0 || !stbtt_InitFont(&file.info, file.bytes.data(), offset)) return std::nullopt;
  file.em = 1.0 / stbtt_ScaleForMappingEmToPixels(&file.info, 1.0f);
  file.height = 1.0 / (stbtt_ScaleForPixelHeight(&file.info, 1.0f) * file.em);
  return file;
}

std::vector<unsigned char> read_first(const std::vector<std::string>& candidates,
                                      std::string_view face,
                                      const std::vector<std::string>& packages) {
  constexpr std::size_t kMost = 100'000'000;
  std::string tried;
  for (const std::string& candidate : candidates) {
    const FileText file = read_file(candidate, kMost);
    if (file.text) {
      std::vector<unsigned char> bytes(file.text->begin(), file.text->end());
      if (parse(bytes)) return bytes;
    }
    tried += fmt::format("\n  {}: {}", candidate, file.text ? "is not a font" : file.problem);
  }
  throw std::runtime_error(
      fmt::format("no font file for the face \"{}\"; tried:{}\nDebian has it: apt-get install {}",
                  face, tried, fmt::join(packages, " ")));
}

}  // namespace

std::vector<TextStyle> type::all_styles() {
  return {kTitle,   kProse,  kPosition, kViewTitle, kVertex,  kSmallVertex, kRegion,
          kCaption, kDetail, kHeading,  kBody,      kStrong,  kCode,        kCodeBold,
          kText,    kName,   kNumber,   kTick,      kTickBold};
}

std::u32string code_points(std::string_view utf8) {
  std::u32string result;
  result.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[i]);
    const std::size_t length = lead < 0x80             ? 1
                               : (lead & 0xE0) == 0xC0 ? 2
                               : (lead & 0xF0) == 0xE0 ? 3
                               : (lead & 0xF8) == 0xF0 ? 4
                                                       : 0;
    char32_t character = length == 1   ? lead
                         : length == 2 ? lead & 0x1Fu
                         : length == 3 ? lead & 0x0Fu
                                       : lead & 0x07u;
    bool valid = length > 0 && i + length <= utf8.size();
    for (std::size_t k = 1; valid && k < length; ++k) {
      const auto next = static_cast<unsigned char>(utf8[i + k]);
      valid = (next & 0xC0) == 0x80;
      character = (character << 6) | (next & 0x3Fu);
    }
    constexpr char32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
    valid = valid && character >= kSmallest[length] && character <= 0x10FFFF &&
            !(character >= 0xD800 && character <= 0xDFFF);
    result.push_back(valid ? character : kReplacement);
    i += valid ? length : 1;
  }
  return result;
}

std::string utf8_of(char32_t character) {
  const auto tail = [&](int shift) {
    return static_cast<char>(0x80u | ((character >> shift) & 0x3Fu));
  };
  const auto head = [&](unsigned mark, int shift) {
    return static_cast<char>(mark | (character >> shift));
  };
  if (character < 0x80) return {static_cast<char>(character)};
  if (character < 0x800) return {head(0xC0, 6), tail(0)};
  if (character < 0x10000) return {head(0xE0, 12), tail(6), tail(0)};
  return {head(0xF0, 18), tail(12), tail(6), tail(0)};
}

struct Fonts::Loaded {
  struct FaceFiles {
    FontFile main;
    FontFile fallback;
    double cap_height = 0.0;                        // In ems,
    double digit = 0.0;                             // and the width of a figure.
    std::unordered_map<char32_t, double> advances;  // In ems, for Fonts::characters().
  };
  std::array<FaceFiles, kFaceCount> faces;

  [[nodiscard]] const FaceFiles& face(Face face) const {
    return faces[static_cast<std::size_t>(face)];
  }
};

namespace {

std::array<FaceBytes, kFaceCount> read_files(const std::filesystem::path& config) {
  toml::table table;
  try {
    table = toml::parse(read_whole(config), config.string());
  } catch (const toml::parse_error& error) {
    throw problem(error.source(), error.description());
  }
  std::array<FaceBytes, kFaceCount> files;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const toml::table* entry = table[kFaceNames[f]].as_table();
    if (!entry) {
      throw problem(table.source(), fmt::format("expected a table [{}]", kFaceNames[f]));
    }
    const std::vector<std::string> packages = string_list(*entry, "packages");
    files[f].main = read_first(string_list(*entry, "files"), kFaceNames[f], packages);
    files[f].fallback = read_first(string_list(*entry, "fallback"), kFaceNames[f], packages);
  }
  return files;
}

}  // namespace

Fonts::Fonts(const std::filesystem::path& config) : Fonts(read_files(config)) {}

Fonts::Fonts(std::array<FaceBytes, kFaceCount> files) : loaded_(std::make_unique<Loaded>()) {
  for (std::size_t f = 0; f < files.size(); ++f) {
    std::optional<FontFile> main = parse(std::move(files[f].main));
    std::optional<FontFile> fallback = parse(std::move(files[f].fallback));
    if (!main || !fallback)
      throw std::runtime_error(fmt::format("the face \"{}\" has no font", kFaceNames[f]));
    Loaded::FaceFiles& face = loaded_->faces[f];
    face.main = *std::move(main);
    face.fallback = *std::move(fallback);
    face.cap_height = face.main.top(face.main.glyph('H'));
    for (char32_t digit = '0'; digit <= '9'; ++digit) {
      face.digit = std::max(face.digit, face.main.advance(face.main.glyph(digit)));
    }
    const bool fixed = is_monospaced(static_cast<Face>(f));
    for (const char32_t c : characters()) {
      const int glyph = face.main.glyph(c);
      const bool tabular = fixed || (c >= '0' && c <= '9');
      face.advances[c] = tabular ? face.digit
                         : glyph ? face.main.advance(glyph)
                                 : face.fallback.advance(face.fallback.glyph(c));
    }
  }
}

Fonts::~Fonts() = default;

double Fonts::width(const TextStyle& style, std::string_view utf8) const {
  const TextStyle em{style.face, 1.0};
  double ems = 0.0;
  for (const char32_t c : code_points(utf8)) ems += advance(em, c);
  return ems * style.size;
}

double Fonts::advance(const TextStyle& style, char32_t character) const {
  const auto& advances = loaded_->face(style.face).advances;
  const auto found = advances.find(character);
  return (found != advances.end() ? found : advances.find(kReplacement))->second * style.size;
}

double Fonts::cap_height(const TextStyle& style) const {
  return loaded_->face(style.face).cap_height * style.size;
}

const std::vector<char32_t>& Fonts::characters() {
  static const std::vector<char32_t> all = [] {
    std::vector<char32_t> list;
    for (const CharacterRange& range : kCharacterRanges) {
      for (char32_t c = range.first; c <= range.last; ++c) list.push_back(c);
    }
    return list;
  }();
  return all;
}

char32_t Fonts::first_missing(std::string_view utf8) {
  for (const char32_t c : code_points(utf8)) {
    if (!std::binary_search(characters().begin(), characters().end(), c)) return c;
  }
  return 0;
}

const std::vector<unsigned char>& Fonts::file(Face face) const {
  return loaded_->face(face).main.bytes;
}
const std::vector<unsigned char>& Fonts::fallback_file(Face face) const {
  return loaded_->face(face).fallback.bytes;
}
double Fonts::height_in_em(Face face) const { return loaded_->face(face).main.height; }
double Fonts::fallback_height_in_em(Face face) const { return loaded_->face(face).fallback.height; }
double Fonts::digit_width_in_em(Face face) const { return loaded_->face(face).digit; }

bool Fonts::lacks(Face face, char32_t character) const {
  const Loaded::FaceFiles& files = loaded_->face(face);
  return !files.main.glyph(character) && !files.fallback.glyph(character);
}

std::array<FaceBytes, kFaceCount> faces_of(const Fonts& fonts) {
  std::array<FaceBytes, kFaceCount> faces;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto face = static_cast<Face>(f);
    faces[f] = {fonts.file(face), fonts.fallback_file(face)};
  }
  return faces;
}

}  // namespace gjkscope
