#include "subjects/round_shapes/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::round_shapes{
    .layers = {&layers::kSkins, &layers::kRadii, &layers::kGap},
    .effects = {&effect_infos::kRoundShapes},
    .adds = captions::round_shapes,
};

}  // namespace gjkscope
