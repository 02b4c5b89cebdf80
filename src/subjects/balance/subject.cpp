#include "subjects/balance/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::balance{
    .tours = {&tours::kTime},
    .blocks = {&blocks::kBalance},
    .layers = {&layers::kBalance},
    .effects = {&effect_infos::kBalance},
};

}  // namespace gjkscope
