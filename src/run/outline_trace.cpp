#include "run/outline_trace.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace gjkscope {
namespace {

using fields::Json;

models::Model model_of(const LessonShape& shape, const std::vector<Eigen::Vector2d>& world) {
  std::vector<models::Outline> outlines;
  for (const auto& [first, count] : shape.ranges())
    outlines.push_back({{world.begin() + first, world.begin() + first + count}});
  return models::model_of(std::move(outlines));
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

}  // namespace gjkscope
