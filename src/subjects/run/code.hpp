#pragma once
// Listings that are code: a page of a file that compiles or runs (tests/gjk/textbook.hpp and
// textbook.py), the line that a step stands for, and its variables. They are named like the listing
// in pseudocode, with the ending of a file: gjk, gjk.cpp, gjk.py.

#include <string>
#include <string_view>
#include <vector>

#include "lesson/names.hpp"
#include "picture/block.hpp"

namespace gjkscope {

enum class Language : std::uint8_t { pseudocode, cpp, python };
template <>
struct Named<Language> {
  static constexpr std::array<std::pair<std::string_view, Language>, 3> kTable = {
      {{"pseudocode", Language::pseudocode}, {"cpp", Language::cpp}, {"python", Language::python}}};
};

namespace code {

/// A whole file; that of C++ for pseudocode.
struct Page {
  std::string_view name;
  std::string_view text;
};
[[nodiscard]] Page page(Language language);

/// The language of a listing, by its name.
[[nodiscard]] Language language_of(std::string_view listing);
/// The name of the same listing in another language; nothing where it has no code.
[[nodiscard]] std::optional<std::string> in_language(std::string_view listing, Language language);
/// That of a lesson's listing; nothing in space either, for the pages are of the plane.
[[nodiscard]] std::optional<std::string> in_language(const Lesson& lesson, Language language);

/// The beginnings of the lines that steps stand for. The page has each once, after its indent.
[[nodiscard]] std::vector<std::string_view> marked_lines(Language language);

/// Some lines around the one of the frame's step, then the variables that it sees.
void write(PanelBuilder& panel);

}  // namespace code

namespace listings {
extern const Listing kSegmentCpp;
extern const Listing kSegmentPython;
extern const Listing kTriangleCpp;
extern const Listing kTrianglePython;
extern const Listing kStructuresCpp;
extern const Listing kStructuresPython;
extern const Listing kSupportCpp;
extern const Listing kSupportPython;
extern const Listing kGjkPointCpp;
extern const Listing kGjkPointPython;
extern const Listing kGjkCpp;
extern const Listing kGjkPython;
}  // namespace listings

}  // namespace gjkscope
