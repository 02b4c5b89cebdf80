#pragma once
// Voronoi regions, the other map of the plane around a triangle, and the order of region tests:
// what the files of this folder define.

#include "picture/block.hpp"
#include "picture/layer.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

namespace gjkscope {

namespace tours {
extern const Tour kMaps;
extern const Tour kOrders;
}  // namespace tours

namespace blocks {
extern const Block kSigns;
extern const Block kOrders;
}  // namespace blocks

namespace layers {
extern const Layer kRegions;
extern const Layer kSigns;
extern const Layer kMapDifference;
extern const Layer kShortTest;
extern const Layer kWrongPoint;
}  // namespace layers

namespace captions {

void maps(const Story& story, FrameText& text);
void orders(const Story& story, FrameText& text);

}  // namespace captions

namespace effect_infos {
extern const EffectInfo kRegionOrders;
extern const EffectInfo kSignMap;
extern const EffectInfo kMapDifference;
}  // namespace effect_infos

}  // namespace gjkscope
