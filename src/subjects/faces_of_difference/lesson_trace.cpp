#include "subjects/faces_of_difference/lesson_trace.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "run/fields.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;
using fields::Json;
using sums_in_space::Kind;
using Phase = FacesTrace::Phase;

constexpr std::array<std::string_view, 3> kPhases = {"one", "kind", "all"};
constexpr std::array<std::string_view, 5> kAnswers = {"faces", "of-y", "of-x", "of-edges",
                                                      "of-several"};
constexpr std::array<PlaceholderInfo, 2> kValues = {
    {{"faces", "faces of Z"}, {"support points", "support points that GJK asked for"}}};

/// The face of a kind that a picture shows best: seen by the eye of a view, and large.
int shown_of_kind(const FacesTrace& trace, Kind kind, const Lesson& lesson,
                  const PositionedRun& run) {
  Eye eye = eye_across(run.trace.result.y - run.trace.result.x);
  for (const LessonView& view : lesson.views) eye = view.eye.value_or(eye);
  const Vector3d towards = axes_of(eye).row(2);
  int best = -1;
  double most = 0.0;
  for (std::size_t i = 0; i < trace.faces.size(); ++i) {
    const sums_in_space::Face& face = trace.faces[i];
    if (face.kind() != kind) continue;
    double area = 0.0;  // as the eye sees it
    const auto corners = corners_of(face, run.x().world, run.y().world);
    const auto at = [&](std::size_t k) -> Vector3d {
      const auto& [x, y] = corners[k % corners.size()];
      return run.y().world[y] - run.x().world[x];
    };
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      area += towards.dot((at(k) - at(0)).cross(at(k + 1) - at(0)));
    area = face.normal.dot(towards) > 0.0 ? std::abs(area) : -1.0 / (1.0 + std::abs(area));
    if (best >= 0 && area <= most) continue;
    best = static_cast<int>(i);
    most = area;
  }
  return best;
}

std::shared_ptr<const AlgorithmTrace> find_faces(const Lesson& lesson, const PositionedRun& run,
                                                 const AlgorithmTrace*) {
  auto trace = std::make_shared<FacesTrace>();
  if (!why_not_drawn(run).empty()) return trace;
  trace->support_points = support_calls(run.trace);
  for (std::size_t body = 0; body < 2; ++body)
    trace->hulls[body] = exact_hull(run.bodies[body].world);
  trace->faces = sums_in_space::faces_of_difference(run.x().world, trace->hulls[0], run.y().world,
                                                    trace->hulls[1]);
  if (trace->faces.empty()) return trace;
  for (int i = 0; i < sums_in_space::kKinds; ++i) {
    const Kind kind = static_cast<Kind>(i);
    if (trace->count(kind) == 0) continue;
    trace->all.push_back({Phase::one, kind, shown_of_kind(*trace, kind, lesson, run)});
    if (trace->count(kind) > 1) trace->all.push_back({Phase::kind, kind, -1});
  }
  trace->all.push_back({});
  return trace;
}

}  // namespace

StepInfo FacesTrace::info(int step) const {
  const Step& at = all[step];
  const bool is_last = at.phase == Phase::all;
  const int number = is_last ? sums_in_space::kKinds : static_cast<int>(at.kind);
  return {number + 1, kPhases[static_cast<std::size_t>(at.phase)], is_last};
}

int FacesTrace::count(Kind kind) const {
  return static_cast<int>(
      std::count_if(faces.begin(), faces.end(),
                    [&](const sums_in_space::Face& face) { return face.kind() == kind; }));
}

double FacesTrace::answer(std::string_view name) const {
  if (name == "faces") return static_cast<double>(faces.size());
  const auto index = std::find(kAnswers.begin(), kAnswers.end(), name) - kAnswers.begin() - 1;
  return count(static_cast<Kind>(index));
}

Json FacesTrace::json(const Lesson& lesson, const PositionedRun&) const {
  Json out = {{"steps", Json::array()}};
  for (int i = 0; i < steps(); ++i) {
    const Step& at = all[i];
    Json step = {{"phase", info(i).phase}, {"iteration", info(i).iteration}};
    if (at.phase != Phase::all) step["kind"] = kAnswers[static_cast<std::size_t>(at.kind) + 1];
    if (at.phase == Phase::kind) step["count"] = count(at.kind);
    if (at.face >= 0) {
      const sums_in_space::Face& face = faces[at.face];
      step["y"] = part_name(lesson.y(), face.y);
      step["x"] = part_name(lesson.x(), face.x);
      step["normal"] = fields::point(face.normal);
    }
    out["steps"].push_back(std::move(step));
  }
  for (const std::string_view name : kAnswers)
    out[std::string(name)] = static_cast<int>(answer(name));
  out["support_points"] = support_points;
  return out;
}

std::string part_name(const LessonShape& shape, const std::vector<int>& vertices) {
  std::string names;
  for (const int vertex : vertices) names += shape.vertex_names[vertex];
  return fmt::format("{} {} of {}",
                     vertices.size() == 1   ? "vertex"
                     : vertices.size() == 2 ? "edge"
                                            : "face",
                     names, shape.name);
}

const Algorithm kFacesOfDifferenceAlgorithm{.name = "faces-of-the-difference",
                                            .phases = kPhases,
                                            .answers = kAnswers,
                                            .values = kValues,
                                            .run = find_faces};

}  // namespace gjkscope
