#include "frames/spots.hpp"

#include <algorithm>

#include "run/questions.hpp"

namespace gjkscope {
namespace {

using Eigen::Vector3d;

constexpr std::string_view kMinus = "−";

std::optional<Vector3d> vertex_of(const LessonRun& run, const Frame& frame, std::size_t body,
                                  std::string_view name) {
  const std::vector<std::string>& names = run.lesson.bodies[body].vertex_names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return run.run(frame).bodies[body].world[found - names.begin()];
}

/// A difference of two vertices, in the difference.
std::optional<Vector3d> difference_of(const LessonRun& run, const Frame& frame,
                                      std::string_view name) {
  const std::size_t minus = name.find(kMinus);
  if (minus == std::string_view::npos) return std::nullopt;
  const auto y = vertex_of(run, frame, 1, name.substr(0, minus));
  const auto x = vertex_of(run, frame, 0, name.substr(minus + kMinus.size()));
  return x && y ? std::optional<Vector3d>(*y - *x) : std::nullopt;
}

std::optional<Spot> spot_of(const LessonRun& run, const Frame& frame, std::string_view choice) {
  if (const std::size_t to = choice.find(" to "); to != std::string_view::npos) {
    const auto a = difference_of(run, frame, choice.substr(0, to));
    const auto b = difference_of(run, frame, choice.substr(to + 4));
    return a && b ? std::optional(Spot{ViewKind::difference, *a, *b}) : std::nullopt;
  }
  if (const auto at = difference_of(run, frame, choice))
    return Spot{ViewKind::difference, *at, *at};
  for (const std::string_view kind : {"vertex ", "edge "}) {
    if (choice.starts_with(kind)) choice.remove_prefix(kind.size());
  }
  for (std::size_t body = 0; body < run.lesson.bodies.size(); ++body) {
    std::string_view name = choice;
    const std::string of = " of " + run.lesson.bodies[body].name;
    if (name.ends_with(of)) name.remove_suffix(of.size());
    if (const auto at = vertex_of(run, frame, body, name)) return Spot{ViewKind::world, *at, *at};
    for (std::size_t i = 1; i < name.size(); ++i) {
      const auto a = vertex_of(run, frame, body, name.substr(0, i));
      const auto b = vertex_of(run, frame, body, name.substr(i));
      if (a && b) return Spot{ViewKind::world, *a, *b};
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::optional<Spot>> spots_of(const LessonRun& run, const Frame& frame,
                                          const std::vector<std::string>& choices) {
  std::vector<std::optional<Spot>> spots;
  for (const std::string& choice : choices) spots.push_back(spot_of(run, frame, choice));
  return spots;
}

bool is_answered_in_drawing(const FrameQuestion& question) {
  return question.ask == asks::kRegion.name || question.place || !question.pair.empty() ||
         std::count_if(question.spots.begin(), question.spots.end(),
                       [](const auto& spot) { return spot.has_value(); }) > 1 ||
         std::count_if(question.subjects.begin(), question.subjects.end(),
                       [](const Subject& each) { return each.kind != Subject::Kind::none; }) > 1;
}

}  // namespace gjkscope
