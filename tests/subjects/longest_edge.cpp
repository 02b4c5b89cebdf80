#include "subjects/subjects.hpp"

namespace gjkscope {
namespace {

struct LongestEdge {
  static constexpr std::string_view kName = "longest-edge";
  static constexpr std::string_view kNeeds = "";
  using Value = std::pair<Eigen::Vector3d, Eigen::Vector3d>;
  static EffectKey key(const LessonRun&, const Frame& frame) { return {frame.run, -1, -1}; }
  static Value compute(EffectGraph&, const LessonRun& run, const Frame& frame) {
    const std::vector<Eigen::Vector3d>& corners = run.run(frame).y().world;
    Value longest{corners[0], corners[0]};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Value edge{corners[i], corners[(i + 1) % corners.size()]};
      if (length(edge) > length(longest)) longest = edge;
    }
    return longest;
  }
  static double length(const Value& edge) { return (edge.second - edge.first).norm(); }
};

void draw(SceneBuilder& scene) {
  if (scene.shows_difference) return;
  const auto& [from, to] = scene.effects.get<LongestEdge>(scene.frame);
  scene.line("closest.line", scene.at(from), scene.at(to));
}

void write(PanelBuilder& panel) {
  const auto& edge = panel.effects.get<LongestEdge>(panel.frame);
  panel.heading("The longest edge of Y");
  panel.row("length", panel.numbers(LongestEdge::length(edge)));
}

const EffectInfo kInfo = effect_info<LongestEdge>("view", "the longest edge of Y");
const Layer kLayer{.effect = LongestEdge::kName, .order = 60, .draw = draw};
const Block kBlock{
    .name = "longest-edge", .meaning = "length of the longest edge of Y", .write = write};

}  // namespace

const SubjectParts subjects::longest_edge{
    .blocks = {&kBlock}, .layers = {&kLayer}, .effects = {&kInfo}};

}  // namespace gjkscope
