#include "picture/panel.hpp"

#include "picture/blocks/blocks.hpp"

namespace gjkscope {
namespace {

void write_block(PanelBuilder& panel, PanelBlock kind) {
  switch (kind) {
    case PanelBlock::pseudocode:
      return blocks::pseudocode(panel);
    case PanelBlock::tests:
      return blocks::tests(panel);
    case PanelBlock::regions:
      return blocks::regions(panel);
    case PanelBlock::weights:
      return blocks::weights(panel);
    case PanelBlock::linear_system:
      return blocks::linear_system(panel);
    case PanelBlock::simplex:
      return blocks::simplex(panel);
    case PanelBlock::scan:
      return blocks::scan(panel);
    case PanelBlock::bounds:
      return blocks::bounds(panel);
    case PanelBlock::pairs:
      return blocks::pairs(panel);
    case PanelBlock::direction_rules:
      return blocks::direction_rules(panel);
    case PanelBlock::witness:
      return blocks::witness(panel);
    case PanelBlock::counters:
      return blocks::counters(panel);
    case PanelBlock::starts:
      return blocks::starts(panel);
    case PanelBlock::growth:
      return blocks::growth(panel);
    case PanelBlock::bound_steps:
      return blocks::bound_steps(panel);
    case PanelBlock::unit_vector:
      return blocks::unit_vector(panel);
    case PanelBlock::areas:
      return blocks::areas(panel);
    case PanelBlock::balance:
      return blocks::balance(panel);
    case PanelBlock::signs:
      return blocks::signs(panel);
    case PanelBlock::orders:
      return blocks::orders(panel);
    case PanelBlock::stop_tests:
      return blocks::stop_tests(panel);
    case PanelBlock::two_runs:
      return blocks::two_runs(panel);
    case PanelBlock::study:
      return blocks::study(panel);
  }
}

}  // namespace

std::vector<Mark> panel_marks(const LessonRun& run, EffectGraph& effects, const Frame& frame,
                              const Fonts& fonts, const Rect& card) {
  PanelBuilder panel(run, effects, frame, fonts, card);
  bool first = true;
  for (const PanelBlock kind : run.lesson.panel) {
    if (!first) panel.rule();
    first = false;
    write_block(panel, kind);
  }
  return std::move(panel.marks);
}

}  // namespace gjkscope
