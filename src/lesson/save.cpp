#include "lesson/save.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "lesson/keys.hpp"
#include "lesson/load.hpp"
#include "lesson/names.hpp"
#include "lesson/settings_kind.hpp"
#include "lesson/toml_patch.hpp"

namespace gjkscope {
std::string lesson_toml(const Lesson& lesson) {
  const int dimension = lesson.dimension;
  TomlText out;
  out.lines(written_keys(lesson, head_keys));
  for (std::size_t i = 0; i < lesson.bodies.size(); ++i) {
    LessonShape fresh;
    fresh.name = kBodyKeys[i];
    fresh.vertex_names = default_vertex_names(lesson.bodies[i], kBodyKeys[i]);
    out.table(fmt::format("[shapes.{}]", kBodyKeys[i]));
    out.lines(written_keys(lesson.bodies[i], shape_keys, dimension, fresh));
  }
  out.table("[query]");
  out.lines(written_keys(lesson, query_keys));
  out.table("[steps]");
  out.lines(written_keys(lesson, steps_keys));
  if (const std::optional<LessonPath>& path = lesson.path_of_shapes) {
    out.table("[path]");
    out.lines(written_keys(*path, path_keys, dimension));
    out.table("[path.Y]");
    out.lines(written_keys(path->y(), y_path_keys, dimension));
  }
  if (const SettingsKind* kind = lesson.settings.kind()) kind->write(lesson.settings, out);
  for (const LessonView& view : lesson.views) {
    out.table("[[views]]");
    out.key("show", as_text(view.kind == ViewKind::plot ? lesson.tour : name_of(view.kind)));
    out.lines(written_keys(view, view_keys, dimension));
  }
  out.table("[panel]");
  out.lines(written_keys(lesson, panel_keys));
  for (const LessonQuestion& question : lesson.questions) {
    out.table("[[questions]]");
    out.lines(written_keys(question, question_keys));
  }
  out.table("[expect]");
  out.lines(written_keys(lesson.expect, expect_keys));
  out.write_header();
  return out.take();
}

std::optional<std::string> lesson_toml_kept(std::string_view original, const Lesson& lesson,
                                            const std::filesystem::path& file,
                                            const Vocabulary& vocabulary, const FileReader& read) {
  const LoadedLesson before = parse_lesson(original, file, vocabulary, read);
  if (!before.lesson) return std::nullopt;
  const std::string wanted = lesson_toml(lesson);
  std::string patched = patched_toml(original, lesson_toml(*before.lesson), wanted);
  const LoadedLesson after = parse_lesson(patched, file, vocabulary, read);
  const LoadedLesson meant = parse_lesson(wanted, file, vocabulary, read);
  if (!after.lesson || !meant.lesson || lesson_toml(*after.lesson) != lesson_toml(*meant.lesson))
    return std::nullopt;
  return patched;
}

Lesson with_absolute_file(Lesson lesson) {
  if (std::optional<NamedFile>& file = lesson.settings.file) {
    const std::filesystem::path folder = std::filesystem::path(lesson.path).parent_path();
    file->path = std::filesystem::absolute(folder / file->path).string();
  }
  return lesson;
}

}  // namespace gjkscope
