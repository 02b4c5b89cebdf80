#include "subjects/weights/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::weights{
    .blocks = {&blocks::kWeights, &blocks::kLinearSystem, &blocks::kUnitVector, &blocks::kAreas},
    .layers = {&layers::kProjection, &layers::kUnitVector, &layers::kParts},
    .effects = {&effect_infos::kBarycentricWeights, &effect_infos::kBarycentricParts,
                &effect_infos::kProjection, &effect_infos::kUnitVector},
};

}  // namespace gjkscope
