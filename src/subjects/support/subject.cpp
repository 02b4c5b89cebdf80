#include "subjects/support/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::support{
    .layers = {&layers::kTouchedPoints, &layers::kSlab},
    .effects = {&effect_infos::kBestSupport, &effect_infos::kSlab, &effect_infos::kTouchedPoints},
};

}  // namespace gjkscope
