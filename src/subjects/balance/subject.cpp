#include "subjects/balance/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::balance{
    .acts = {&acts::kTime},
    .blocks = {&blocks::kBalance},
    .layers = {&layers::kBalance},
    .effects = {&effect_infos::kBalance},
};

}  // namespace gjkscope
