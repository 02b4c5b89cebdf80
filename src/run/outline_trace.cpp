#include "run/outline_trace.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gjkscope {
namespace {

using fields::Json;

models::Model model_of(const LessonShape& shape, const std::vector<Eigen::Vector2d>& world) {
  std::vector<models::Outline> outlines;
  for (const auto& [first, count] : shape.ranges())
    outlines.push_back({{world.begin() + first, world.begin() + first + count}});
  return models::model_of(std::move(outlines));
}

std::string words(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

std::string value_text(ScalarKind scalar, const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_array()) {
    std::vector<std::string> parts;
    for (const Json& part : value) parts.push_back(value_text(scalar, part));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  if (!value.is_object()) return value.dump();
  if (value.contains("hex"))  // a number, as fields::number writes it
    return value["value"].is_null() ? value["hex"].get<std::string>()
                                    : fields::number_text(scalar, value["value"]);
  std::vector<std::string> parts;
  for (const auto& [key, part] : value.items())
    parts.push_back(words(key) + " " + value_text(scalar, part));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

OutlinesOfRun outlines_of(const Lesson& lesson, const PositionedRun& run) {
  return {model_of(lesson.x(), in_plane(run.x().world)),
          model_of(lesson.y(), in_plane(run.y().world))};
}

std::optional<Refusal> refusal_of(const OutlinesOfRun& outlines, models::Needs needs) {
  for (const models::Model* model : {&outlines.x, &outlines.y}) {
    const models::Flaw flaw = models::check(model->outlines, needs);
    if (flaw.fault != models::Fault::none) return Refusal{flaw, model == &outlines.y};
  }
  return std::nullopt;
}

std::string words_of(const Refusal& refusal, const Lesson& lesson) {
  return fmt::format("{}: {}", (refusal.of_y ? lesson.y() : lesson.x()).name,
                     models::name_of(refusal.flaw.fault));
}

Json OutlineTrace::json(const Lesson& lesson, const PositionedRun&) const {
  if (refusal) return {{"refused", words_of(*refusal, lesson)}};
  Json out = {{"steps", Json::array()}};
  for (int i = 0; i < steps(); ++i) {
    Json step = {{"phase", info(i).phase}, {"iteration", info(i).iteration}};
    step.update(step_json(lesson, i));
    out["steps"].push_back(std::move(step));
  }
  out.update(result_json(lesson));
  return out;
}

std::string OutlineTrace::text(const Lesson& lesson, const PositionedRun&) const {
  if (refusal)
    return fmt::format("\n{}\n", name_) + fields::line("refused", words_of(*refusal, lesson));
  std::string out;
  int iteration = 0;
  for (int i = 0; i < steps(); ++i) {
    const StepInfo at = info(i);
    if (i == 0 || at.iteration != iteration)
      out += fmt::format("\n{}, iteration {}\n", name_, at.iteration);
    iteration = at.iteration;
    out += fields::line(at.phase, value_text(lesson.scalar, step_json(lesson, i)));
  }
  out += fmt::format("\n{}, result\n", name_);
  const Json result = result_json(lesson);
  for (const auto& [key, value] : result.items())
    out += fields::line(words(key), value_text(lesson.scalar, value));
  return out;
}

}  // namespace gjkscope
