#pragma once
// Voronoi regions, and the region tests one by one: what the files of this folder define.

#include "picture/act.hpp"
#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

/// The number of region tests of a closest-point step that have been tried; 0: its numbers are
/// shown.
[[nodiscard]] std::optional<int> tried_tests(const LessonRun& run, const Frame& frame);

namespace acts {
extern const Act kTest;
}  // namespace acts

namespace blocks {

extern const Block kTests;
extern const Block kRegions;

/// `misleads`: a test that holds, and takes the wrong point.
enum class TestMark { untried, fails, holds, misleads };
/// At the left of the current row.
void test_mark(PanelBuilder& panel, TestMark mark);
/// One row of a chain of tests: mark, region, condition and numbers.
void test_row(PanelBuilder& panel, TestMark mark, bool current, const std::string& region,
              const std::string& condition, const std::string& values);

}  // namespace blocks

namespace layers {
extern const Layer kRegions;
}  // namespace layers

namespace captions {

void closest(const Story& story, FrameText& text);
void region_test(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kVoronoiRegions;
}  // namespace effect_infos

}  // namespace gjkscope
