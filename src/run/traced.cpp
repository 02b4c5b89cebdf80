#include "run/traced.hpp"

#include <fmt/format.h>

#include "run/fields.hpp"

namespace gjkscope {
namespace {

TracedShape traced(const LessonShape& shape) {
  return {shape.name,     shape.vertex_names,
          shape.vertices, {shape.translate, shape.rotate_degrees, shape.axis},
          shape.outlines, shape.radius};
}

std::string moved(const Lesson& lesson, const LessonShape& shape, const LessonMotion& motion,
                  const Placement& placement) {
  if (motion.points.empty()) return {};
  std::string out =
      fmt::format(", {} moved by {}", shape.name,
                  fields::point_text(lesson.scalar, placement.translate.head(lesson.dimension)));
  if (!motion.turns.empty()) {
    out += fmt::format(" and turned by {} degrees",
                       fields::number_text(lesson.scalar, placement.rotate_degrees));
  }
  return out;
}

std::vector<std::string> headings(const LessonRun& run) {
  std::vector<std::string> out;
  if (run.runs.size() == 1) return out;
  const Lesson& lesson = run.lesson;
  const LessonPath& path = *lesson.path_of_shapes;
  for (const PositionedRun& one : run.runs) {
    out.push_back(fmt::format("run {} of {}{}{}{}", out.size() + 1, run.runs.size(),
                              path.seconds ? fmt::format(", t = {} s", one.time) : std::string(),
                              moved(lesson, lesson.x(), path.x(), one.x().placement),
                              moved(lesson, lesson.y(), path.y(), one.y().placement)));
  }
  return out;
}

}  // namespace

Traced traced(const LessonRun& run) {
  const Lesson& lesson = run.lesson;
  return {lesson.id,      lesson.title,       lesson.scalar,
          lesson.options, traced(lesson.x()), traced(lesson.y()),
          run.runs,       headings(run),      &run};
}

template <int D>
Traced traced(const CaseIn<D>& shapes, std::string_view name, ScalarKind scalar) {
  const std::string id(name);
  return {id,
          id,
          scalar,
          {},
          {"X", numbered_names('x', shapes.a.size()), in_space(shapes.a), {}},
          {"Y", numbered_names('y', shapes.b.size()), in_space(shapes.b), {}},
          {run_case(shapes, scalar)},
          {}};
}
template Traced traced(const CaseIn<2>& shapes, std::string_view name, ScalarKind scalar);
template Traced traced(const CaseIn<3>& shapes, std::string_view name, ScalarKind scalar);

}  // namespace gjkscope
