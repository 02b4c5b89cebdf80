#pragma once
// A chapter on one page: its rule, its terms, a whole run at a glance, and what goes wrong.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "export/format.hpp"
#include "lesson/lesson.hpp"
#include "lesson/terms.hpp"
#include "picture/picture.hpp"
#include "picture/type.hpp"

namespace gjkscope {

/// The words of a chapter in assets/sheets.toml.
struct SheetWords {
  std::vector<std::string> rule;      ///< Three sentences.
  std::vector<std::string> pitfalls;  ///< The troubles that readers meet.
  std::string trail;                  ///< Id of the lesson whose run of GJK is shown whole, if any.
  std::vector<std::pair<std::string, int>> figures;  ///< Ids of lessons, and a frame of each.
};
/// By chapter. Throws std::runtime_error, with the place, where the text is not of this form;
/// `name` stands for the file.
[[nodiscard]] std::map<int, SheetWords> parse_sheets(std::string_view text, std::string_view name);

enum class Paper { a4, letter };
/// By its name.
[[nodiscard]] std::optional<Paper> paper_of(std::string_view name);
/// Width and height of a sheet in frame pixels, of which an inch has kSheetDpi.
[[nodiscard]] std::array<int, 2> sheet_size(Paper paper);
inline constexpr double kSheetDpi = 150.0;

struct SheetContent {
  int chapter = 0;
  std::string title;
  SheetWords words;
  std::vector<CourseTerm> terms;  ///< All of the course.
  std::vector<Lesson> lessons;    ///< All of the course, in order.
};
/// Throws std::runtime_error when a lesson that the words name is not there, or not all fits.
[[nodiscard]] Picture sheet_picture(const SheetContent& content, const Fonts& fonts, Paper paper);

struct SheetFile {
  std::filesystem::path file;
  Format format = Format::pdf;       ///< pdf, svg or png.
  std::filesystem::path assets_dir;  ///< Holds fonts.toml, themes/, terms, chapters and sheets.
  std::string theme = "print";
  Paper paper = Paper::a4;
  bool force = false;  ///< Replace a file that was not exported.
};
/// Writes the sheet of a chapter. The same lessons and words give the same bytes. Throws
/// std::runtime_error when there is no such chapter, and as sheet_picture and `refuse_foreign` do.
void write_sheet(int chapter, std::vector<Lesson> lessons, const SheetFile& options);

}  // namespace gjkscope
