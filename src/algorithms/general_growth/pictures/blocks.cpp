#include "picture/blocks/blocks.hpp"

#include "algorithms/general_growth/pictures/shown.hpp"

namespace gjkscope::costs {
namespace {

using namespace rows;

void costs(PanelBuilder& panel) {
  const Shown shown(panel.run, panel.frame);
  const general_growth::Sample& sample = shown.sample();
  panel.heading("n = " + grouped(sample.segments));
  const auto row = [&](const std::string& what, const std::string& value) {
    panel.write("body.muted", panel.left, what, type::kBody);
    panel.write("code.current", panel.right, value, type::kCode, Align::right);
    panel.y += kRow;
  };
  row("pairs of segments", grouped(sample.pairs()));
  row("convex pieces: runs of GJK", sample.pieces < 0.0 ? "not cut" : grouped(sample.pieces));
  row("trees of boxes", grouped(sample.boxes));
  row("trees of circles", grouped(sample.circles));
  row("boxes, from the last pair", grouped(sample.remembered));
  row("boxes, only collide?", grouped(sample.collide));
}

}  // namespace

const Block kCosts{.name = "costs",
                   .meaning = "pairs that each method visits at the frame's number of segments",
                   .write = costs,
                   .act = "general-growth"};

}  // namespace gjkscope::costs
