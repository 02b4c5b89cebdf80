#pragma once
// One query in one, two and three dimensions, each in a view of its own.

#include "picture/block.hpp"
#include "picture/tour.hpp"
#include "run/effect_info.hpp"

/// GJK on a line, in a plane and in space, phase by phase.
namespace gjkscope::dimensions {
extern const Tour kTour;
extern const Block kBlock;
extern const EffectInfo kEffect;
}  // namespace gjkscope::dimensions

/// Barycentric weights as fractions of a length, an area and a volume.
namespace gjkscope::fractions {
extern const Tour kTour;
extern const Block kBlock;
extern const EffectInfo kEffect;
}  // namespace gjkscope::fractions
