#pragma once
// Tasks of a chapter on paper, and on other pages their answers.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "export/sheet.hpp"
#include "practice/task.hpp"

namespace gjkscope {

struct WorkSheet {
  int chapter = 1;
  std::string title;  ///< The chapter's.
  std::uint64_t seed = 1;
  std::vector<practice::Task> tasks;
};
inline constexpr int kMostTasks = 60;

/// Six tasks a page, then as many pages with their answers.
[[nodiscard]] std::vector<Picture> work_sheet_pages(const WorkSheet& sheet, const Fonts& fonts,
                                                    Paper paper);

struct WorkSheetFile {
  std::filesystem::path file;        ///< A PDF.
  std::filesystem::path assets_dir;  ///< Holds fonts.toml, themes/ and chapters.
  std::string theme = "print";
  Paper paper = Paper::a4;
  bool force = false;  ///< Replace a file that was not exported.
};
/// Writes `count` tasks of a chapter that has practice. The same seed gives the same bytes. Throws
/// std::runtime_error as `refuse_foreign` does, and where the file cannot be written.
void write_work_sheet(int chapter, int count, std::uint64_t seed, const WorkSheetFile& options);

}  // namespace gjkscope
