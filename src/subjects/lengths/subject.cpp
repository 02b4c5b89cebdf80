#include "subjects/lengths/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::lengths{
    .layers = {&layers::kSupportAxis, &layers::kClosestCircle, &layers::kTestedFeet},
    .effects = {&effect_infos::kSupportAxis, &effect_infos::kClosestCircle,
                &effect_infos::kTestedFeet},
};

}  // namespace gjkscope
