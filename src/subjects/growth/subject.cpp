#include "subjects/growth/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::growth{
    .tours = {&tours::kGrowth},
    .blocks = {&blocks::kGrowth},
    .effects = {&effect_infos::kGrowth, &effect_infos::kSlowGrowth},
};

}  // namespace gjkscope
