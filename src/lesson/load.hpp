#pragma once
// Reads a lesson file. Nothing is half-loaded: the lesson is there only when the file has no
// problem at all.
//
// Tours, blocks, listings and effects are registered above this folder (subjects/subjects.hpp), so
// the vocabulary of all that a file may name is handed in.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.hpp"
#include "lesson/lesson.hpp"
#include "lesson/problem.hpp"
#include "lesson/vocabulary.hpp"

namespace gjkscope {

struct LoadedLesson {
  std::optional<Lesson> lesson;
  std::vector<Problem>
      problems;  ///< All of the file, in order of place; empty exactly when `lesson` is there.
};

/// Reads and validates; does not run the lesson (see run/run.hpp for the expected outcome). A
/// file that is not TOML has one problem, its first syntax error.
[[nodiscard]] LoadedLesson load_lesson(const std::filesystem::path& file,
                                       const Vocabulary& vocabulary);

/// The same from text; `name` stands for the file in problems and gives the lesson's id. `read`
/// reads the file that its table names, if any.
[[nodiscard]] LoadedLesson parse_lesson(std::string_view text, const std::filesystem::path& name,
                                        const Vocabulary& vocabulary,
                                        const FileReader& read = read_file);

/// The place of a key in a lesson file; for problems found only after loading. Keys are dotted,
/// entries of lists are numbered from 0: "expect.distance", "views.1.title", "shapes.X.names.2". If
/// the file has no such key: its nearest parent that is there, at last 1, 1.
[[nodiscard]] Place place_of_key(const std::filesystem::path& file, std::string_view dotted_key);

/// Lesson files (*.toml) of a folder in teaching order (chapter, order, id), then those that have
/// problems, by name.
[[nodiscard]] std::vector<LoadedLesson> load_lessons(const std::filesystem::path& folder,
                                                     const Vocabulary& vocabulary);

/// Names for the vertices of shape "X" or "Y" when a file does not name them: a single one is
/// called like the shape, others x1, x2, ... or y1, y2, ...
[[nodiscard]] std::vector<std::string> default_vertex_names(const LessonShape& shape,
                                                            std::string_view key);

/// A text that frames show, and its key for `place_of_key`. The loader cannot know which characters
/// the fonts can draw (picture/type.hpp, Fonts::first_missing): whoever knows both checks these.
struct LessonText {
  std::string key;
  std::string text;
};
[[nodiscard]] std::vector<LessonText> texts_of(const Lesson& lesson);

}  // namespace gjkscope
