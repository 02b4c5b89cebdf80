#include "subjects/study/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::study{
    .acts = {&acts::kStudy},
    .blocks = {&blocks::kStudy},
    .effects = {&effect_infos::kRoundedPair},
};

}  // namespace gjkscope
