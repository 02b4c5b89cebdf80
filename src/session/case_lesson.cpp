#include "session/case_lesson.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "outlines/polygon.hpp"
#include "picture/words.hpp"
#include "session/edit.hpp"
#include "session/session.hpp"
#include "subjects/shape_hull/shape_hull.hpp"

namespace gjkscope {
namespace case_lessons {
namespace {

/// Text as prose that stands for itself.
std::string as_prose(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '{' || c == '}') out += c;
  }
  return out;
}

/// A sentence, with a full stop where it has none.
std::string sentence(std::string text) {
  if (!text.empty() && std::string_view(".!?").find(text.back()) == std::string_view::npos)
    text += '.';
  return text;
}

/// True if the vertices in their order are no convex outline; GJK sees their hull.
bool shows_another_outline(const LessonShape& shape) {
  return shape.vertices.size() > 3 && !is_convex(in_plane(shape.vertices));
}

/// Draws the hulls of shapes that have another outline, and says which.
std::string show_hulls(Lesson& lesson) {
  std::string names;
  for (const LessonShape& shape : lesson.bodies) {
    if (!shows_another_outline(shape)) continue;
    names += (names.empty() ? "" : " and of ") + shape.name;
    for (LessonView& view : lesson.views) {
      if (view.kind == ViewKind::world && !view.calls_for(ShapeHull::kName))
        view.effects.emplace_back(ShapeHull::kName);
    }
  }
  return names.empty() ? "" : fmt::format(" GJK sees the hull of {}.", names);
}

}  // namespace
}  // namespace case_lessons

Lesson case_lesson(Lesson example, const ReadCase& read, const std::string& name) {
  using namespace case_lessons;
  Lesson lesson = edit::with_shapes(std::move(example), read);
  lesson.id = name;
  lesson.path.clear();
  lesson.title = name;
  lesson.options = {};
  lesson.source = read.notes.source;
  lesson.prose = as_prose(sentence(read.notes.why.empty() ? "Shapes of a case" : read.notes.why));
  if (!lesson.source.empty()) lesson.prose += as_prose(" Source: " + sentence(lesson.source));
  if (!read.in_space) lesson.prose += show_hulls(lesson);
  const std::size_t pairs = lesson.x().vertices.size() * lesson.y().vertices.size();
  if (pairs > edit::kMostPairs) {
    lesson.prose +=
        fmt::format(" Z has {} differences: of its outline only what the run finds is drawn.",
                    grouped(static_cast<double>(pairs)));
  }
  return lesson;
}

std::vector<Problem> why_case_is_not_said(const Lesson& lesson, const ReadCase& read,
                                          const std::string& file) {
  std::vector<Problem> problems = why_not_said(lesson);
  for (Problem& problem : problems) {
    problem.file = file;
    problem.line = read.place.line;
    problem.column = read.place.column;
  }
  return problems;
}

}  // namespace gjkscope
