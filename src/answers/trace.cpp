#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "answers/answers.hpp"
#include "run/trace_json.hpp"
#include "run/trace_text.hpp"
#include "subjects/hierarchy/table.hpp"
#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

void append(Printed& all, Printed more) {
  all.out.insert(all.out.end(), more.out.begin(), more.out.end());
  all.err += more.err;
}

/// The trace of a lesson that shows the method.
Printed print_trace(const ReadCase& read, ModelMethod method, bool json) {
  Lesson lesson = lesson_of(*read.outlines, read.name);
  lesson.tour = method == ModelMethod::pieces      ? "convex-pieces"
                : method == ModelMethod::lin_canny ? "lin-canny"
                                                   : "hierarchy-distance";
  if (method == ModelMethod::circles)
    lesson.settings = TourSettings(LessonTrees{VolumeKind::circles});
  const LessonRun run = run_lesson(std::move(lesson));
  Printed printed = print_trace(traced(run), json);
  if (!std::isfinite(run.algorithm_traces[0]->answer("distance")))
    printed.err +=
        fmt::format("{}: the query is refused: {}\n", read.name, name_of(gjk::Error::overflow));
  return printed;
}

}  // namespace

models::Needs needs_of_trace(ModelMethod method) {
  return std::max(needs_of(method), models::Needs::closed);
}

Printed print_trace(const Traced& traced, bool json) {
  Printed printed{{json ? trace_json(traced) : trace_text(traced)}, {}};
  for (const PositionedRun& run : traced.runs) {
    const gjk::Error error = run.trace.result.error;
    if (error != gjk::Error::none)
      printed.err += fmt::format("{}: the query is refused: {}\n", traced.id, name_of(error));
  }
  return printed;
}

Printed print_traces(const std::vector<ReadCase>& cases, const CaseOptions& options, bool json) {
  Printed printed;
  for (const ReadCase& read : cases) {
    for (const Problem& problem : read.problems) printed.err += to_string(problem) + '\n';
    if (read.value)
      append(printed, print_trace(traced(*read.value, read.name, options.scalar), json));
    if (read.in_space)
      append(printed, print_trace(traced(*read.in_space, read.name, options.scalar), json));
    if (read.outlines) append(printed, print_trace(read, options.method, json));
  }
  return printed;
}

}  // namespace gjkscope
