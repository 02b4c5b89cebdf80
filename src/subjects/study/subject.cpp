#include "subjects/study/subject.hpp"

#include "subjects/subjects.hpp"

namespace gjkscope {

const SubjectParts subjects::study{
    .tours = {&tours::kStudy},
    .blocks = {&blocks::kStudy},
    .effects = {&effect_infos::kRoundedPair},
};

}  // namespace gjkscope
