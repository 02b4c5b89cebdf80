#include "picture/blocks/blocks.hpp"

#include "algorithms/general_growth/pictures/shown.hpp"

namespace gjkscope::costs {
namespace {

void costs(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const general_growth::Sample& sample = shown.sample();
  panel.heading("n = " + grouped(sample.segments));
  panel.row("pairs of segments", grouped(sample.pairs()));
  panel.row("convex pieces: runs of GJK", sample.pieces < 0.0 ? "not cut" : grouped(sample.pieces));
  panel.row("trees of boxes", grouped(sample.boxes));
  panel.row("trees of circles", grouped(sample.circles));
  panel.row("boxes, from the last pair", grouped(sample.remembered));
  panel.row("boxes, only collide?", grouped(sample.collide));
}

}  // namespace

const Block kCosts{.name = "costs",
                   .meaning = "pairs that each method visits at the frame's number of segments",
                   .write = costs,
                   .act = "general-growth"};

}  // namespace gjkscope::costs
