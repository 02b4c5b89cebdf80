#include "subjects/regions/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::regions{
    .tours = {&tours::kMaps, &tours::kOrders},
    .blocks = {&blocks::kSigns, &blocks::kOrders},
    .layers = {&layers::kRegions, &layers::kSigns, &layers::kMapDifference, &layers::kShortTest,
               &layers::kWrongPoint},
    .effects = {&effect_infos::kRegionOrders, &effect_infos::kSignMap,
                &effect_infos::kMapDifference},
};

}  // namespace gjkscope
