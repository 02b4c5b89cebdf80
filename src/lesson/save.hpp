#pragma once
// Writes a lesson as the text of a lesson file.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/file.hpp"
#include "lesson/lesson.hpp"
#include "lesson/vocabulary.hpp"

namespace gjkscope {

/// The lesson in the layout of lessons/: keys in the order of the schema, none that has the value
/// it would have without. For every lesson that was loaded, parse_lesson gives it back, to the bit,
/// and its text is the same again.
///
/// Leaves out all that a file cannot say: `id` and `path`, which are the file's, `options.proof`,
/// and what the lesson does not have: a required key is missing then, and loading says which.
/// Texts must be UTF-8, numbers finite, and the vertices of `options.start` there.
[[nodiscard]] std::string lesson_toml(const Lesson& lesson);

/// `original`, the text of a lesson file, changed so that it says `lesson`: comments, layout and
/// spellings of what stays are kept. Nothing where `original` is no lesson file, or is laid out so
/// that this cannot be done; lesson_toml(lesson) says it then. Both leave out the same.
/// `file` is where the text stands, and `read` gives files that it names.
[[nodiscard]] std::optional<std::string> lesson_toml_kept(std::string_view original,
                                                          const Lesson& lesson,
                                                          const std::filesystem::path& file,
                                                          const Vocabulary& vocabulary,
                                                          const FileReader& read = read_file);

/// The same lesson, with the absolute path of the file that its table names: it can be written
/// anywhere.
[[nodiscard]] Lesson with_absolute_file(Lesson lesson);

}  // namespace gjkscope
