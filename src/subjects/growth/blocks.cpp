#include <algorithm>

#include "subjects/growth/growth.hpp"
#include "subjects/growth/plots.hpp"
#include "subjects/growth/subject.hpp"

namespace gjkscope::blocks {

namespace {

void growth(PanelBuilder& panel) {
  constexpr double kHeight = 272.0;
  panel.heading("Differences and vertices per run, as n grows");
  const double top = panel.y - 20.0;
  const Rect area{{panel.left, top}, {panel.right, top + kHeight}};
  const Plot plot = points_plot(panel.run, panel.effects, panel.frame);
  for (Mark& mark : plot_marks(plot, panel.fonts, area)) panel.marks.push_back(std::move(mark));
  panel.y = area.max.y() + rows::kRow;
}

}  // namespace

const Block kGrowth{
    .name = "growth",
    .meaning =
        "as the polygons of [growth] grow: points of Z and those computed, vertices looked at",
    .write = growth,
    .tour = "growth"};

void growth_counters(PanelBuilder& panel) {
  const Growth::Value& measured = panel.effects.get<Growth>(panel.frame);
  const auto index = static_cast<std::size_t>(*shown_size(panel.run, panel.frame));
  const Growth::Sample& sample = measured[std::min(index, measured.size() - 1)];
  const auto row = [&](const std::string& name, const std::string& value) {
    panel.write("heading", panel.left, name, type::kHeading);
    panel.write("code.current", panel.right, value, type::kCodeBold, Align::right);
    panel.y += rows::kRow;
  };
  if (is_slow(panel.run, panel.frame)) {
    const Slowest both = slowest(panel.effects, panel.frame);
    row("n", std::to_string(both.built.vertices));
    row("Iterations of the worst random run", std::to_string(both.random.most_iterations));
    if (panel.frame.question < 0)
      row("Iterations, built to be slow", std::to_string(both.built.iterations));
    return;
  }
  row("n · n differences", grouped(1.0 * sample.vertices * sample.vertices));
  row("Computed, on average", fixed(sample.touched_points, 1));
  row("Support calls, on average", fixed(sample.support_calls, 1));
}

}  // namespace gjkscope::blocks
