#pragma once
// Reads a lesson file. Nothing is half-loaded: the lesson is there only when the file has no
// problem at all.

#include <filesystem>
#include <optional>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/problem.hpp"

namespace gjkscope {

struct LoadedLesson {
  std::optional<Lesson> lesson;
  std::vector<Problem>
      problems;  ///< All of the file, in order of line; empty exactly when `lesson` is there.
};

/// Reads and validates; does not run the lesson (see lesson/run.hpp for the expected outcome).
[[nodiscard]] LoadedLesson load_lesson(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in problems and gives the lesson's id.
[[nodiscard]] LoadedLesson parse_lesson(std::string_view text, const std::filesystem::path& name);

/// Where each top-level or dotted key of a lesson file stands ("expect.distance" -> line, column);
/// for problems found only after loading. Unknown keys give 1, 1.
struct Place {
  int line = 1;
  int column = 1;
};
[[nodiscard]] Place place_of(const std::filesystem::path& file, std::string_view dotted_key);

/// Lesson files of a folder in teaching order (chapter, order, id), each with its loading result.
[[nodiscard]] std::vector<LoadedLesson> load_lessons(const std::filesystem::path& folder);

}  // namespace gjkscope
